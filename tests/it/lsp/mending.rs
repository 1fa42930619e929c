//! Quick fixes: what they write, and that it removes the diagnostic.

use super::client::{Client, SPEC};
use mavc::source::Source;
use serde_json::{Value, json};

const URI: &str = "untitled:spec";

/// The text after the one fix that the whole text is offered for `code`, and the fix's title.
fn mended(text: &str, code: &str) -> (String, String) {
    let mut client = Client::start();
    client.open(URI, text);
    let told = client.wait(URI, Some(1), |told| told.iter().any(|d| d["code"] == code));
    let range = told.iter().find(|d| d["code"] == code).unwrap()["range"].clone();
    let params = json!({ "textDocument": { "uri": URI }, "range": range, "context": { "diagnostics": [] } });
    let actions = client.ask("textDocument/codeAction", params).unwrap();
    let action = actions.as_array().unwrap().iter().find(|a| a["diagnostics"][0]["code"] == code);
    let action = action.unwrap_or_else(|| panic!("{code} has no fix in\n{text}\n{actions}")).clone();
    assert_eq!(action["kind"], "quickfix");
    client.stop();
    let edit = &action["edit"]["changes"][URI][0];
    let source = Source::new("", text);
    let at = |end: &str| {
        let number = |of: &str| edit["range"][end][of].as_u64().unwrap() as u32;
        source.offset_utf16(number("line"), number("character"))
    };
    let mut text = text.to_string();
    text.replace_range(at("start")..at("end"), edit["newText"].as_str().unwrap());
    (text, action["title"].as_str().unwrap().to_string())
}

/// Codes of the errors that are left.
fn errors(text: &str) -> Vec<Value> {
    let mut client = Client::start();
    client.open(URI, text);
    let told = client.next(URI);
    client.stop();
    told.iter()
        .filter(|d| d["severity"] == 1 && d["code"] != "mavc::analysis::cannot_hover")
        .map(|d| d["code"].clone())
        .collect()
}

#[test]
fn every_clear_mistake_has_a_fix_that_works() {
    let cases = [
        ("1.6 kg", "1.6", "mavc::unit::missing", "Write `1.6 kg`"),
        ("8500 rpm", "8500 RPM", "mavc::unit::unknown", "Write `rpm`"),
        ("max_speed", "max_sped", "mavc::name::unknown_field", "Write `max_speed`"),
        ("[worn,", "[wron,", "mavc::name::unknown", "Write `worn`"),
        (
            "    mass    = 1.6 kg\n",
            "",
            "mavc::name::missing_field",
            "Add `mass = 1.8 kg`, with the values of your vehicle",
        ),
        ("    arm     = 25 cm\n", "", "mavc::name::missing_field", "Add `arm = 0.2 m`"),
        ("    arm     = 25 cm\n", "    arm     = 25 cm\n    arm = 20 cm\n", "mavc::name::duplicate", "Remove one"),
        ("tilt <= 20 deg", "tlit <= 20 deg", "mavc::name::unknown_field", "Write `tilt`"),
        ("mission survey", "mision survey", "mavc::syntax::unknown_statement", "Write `mission`"),
        ("tilt <= 20 deg", "tilt <= 20 deg; tilt <= 9 deg", "mavc::name::duplicate", "Remove one of the two"),
        ("    time ", "    against = all\n    time ", "mavc::name::duplicate", "Remove one"),
        ("/// As high", "let spare = 3 m\n/// As high", "mavc::name::unused", "Take out `let spare = 3 m`"),
        ("20 s", "-20 s", "mavc::plan::time", "Remove the minus sign: write `20 s`"),
    ];
    for (right, wrong, code, title) in cases {
        let broken = SPEC.replacen(right, wrong, 1);
        assert_ne!(broken, SPEC, "{right}");
        let (text, shown) = mended(&broken, code);
        assert_eq!(shown, title, "{code}");
        let left = errors(&text);
        // A vehicle of one's own takes any mass and arm; the example's do as well.
        assert!(left.is_empty(), "{code} leaves {left:?} in\n{text}");
    }
}

/// The first quick fix of a text at its first error.
fn first_fix(text: &str) -> Value {
    let mut client = Client::start();
    client.open(URI, text);
    let range = client.wait(URI, Some(1), |told| !told.is_empty())[0]["range"].clone();
    let params = json!({ "textDocument": { "uri": URI }, "range": range, "context": { "diagnostics": [] } });
    let actions = client.ask("textDocument/codeAction", params).unwrap();
    client.stop();
    actions[0].clone()
}

#[test]
fn an_invented_value_is_not_preferred() {
    assert_eq!(first_fix(&SPEC.replace("    arm     = 25 cm\n", ""))["isPreferred"], false);
    assert_eq!(first_fix(&SPEC.replace("1.6 kg", "1.6"))["isPreferred"], false);
    assert_eq!(first_fix(&SPEC.replace("arm     =", "arm     :"))["isPreferred"], true);
}

#[test]
fn titles_say_what_is_done_and_signs_stand_apart() {
    let product = first_fix(&SPEC.replace("kg*m^2", "kg m^2"));
    let (title, text) = (&product["title"], &product["edit"]["changes"][URI][0]["newText"]);
    assert_eq!(*title, format!("Write `{}`", text.as_str().unwrap()));
    let sign = first_fix(&SPEC.replace("mass    = 1.6", "mass: 1.6"));
    assert_eq!(sign["edit"]["changes"][URI][0]["newText"], " =");
}

#[test]
fn a_fix_is_offered_where_its_diagnostic_stands_and_nowhere_else() {
    let mut client = Client::start();
    client.open(URI, &SPEC.replace("1.6 kg", "1.6"));
    let ask = |client: &mut Client, line: u32, only: Value| {
        let at = json!({ "line": line, "character": 14 });
        let context = json!({ "diagnostics": [], "only": only });
        let params = json!({ "textDocument": { "uri": URI }, "range": { "start": at, "end": at }, "context": context });
        client.ask("textDocument/codeAction", params).unwrap().as_array().map_or(0, Vec::len)
    };
    assert_eq!(ask(&mut client, 4, json!(["quickfix"])), 1);
    assert_eq!(ask(&mut client, 4, json!(["refactor"])), 0);
    assert_eq!(ask(&mut client, 2, json!(["quickfix"])), 0);
    client.stop();
}
