//! The pages of the codes and the language reference hold specs that do what the text says.

use super::{QUAD, check};
use mavc::diagnostic::{Severity, codes};

/// Every fenced block of `text`: its info string and what it holds.
fn fences(text: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some((_, after)) = rest.split_once("\n```") {
        let (info, body) = after.split_once('\n').unwrap_or((after, ""));
        let (body, after) = body.split_once("\n```").unwrap_or((body, ""));
        found.push((info, body));
        rest = after;
    }
    found
}

/// The codes of a spec, to which the quadcopter is added where it shows no vehicle.
fn codes_of(text: &str) -> Vec<&'static str> {
    let vehicle = if text.contains("vehicle") { "" } else { QUAD };
    let diagnostics = check(&format!("{text}\n{vehicle}")).1;
    // An unused `let` is the price of a short example.
    let unused = |code: &str| code == "mavc::name::unused" && text.starts_with("let");
    diagnostics.iter().map(|d| d.code).filter(|code| !unused(code)).collect()
}

#[test]
fn examples_give_the_code_they_stand_under_and_mended_they_give_none() {
    let mut examples = 0;
    for page in codes::all() {
        for (info, text) in fences(page.page) {
            match info {
                "mav wrong" if page.code == "mavc::name::unused" => {
                    assert_eq!(check(&format!("{text}\n{QUAD}")).1[0].code, page.code);
                }
                "mav wrong" => {
                    let found = codes_of(text);
                    assert!(!found.is_empty() && found.iter().all(|c| *c == page.code), "{}: {found:?}", page.code);
                }
                "mav" => assert_eq!(codes_of(text), Vec::<&str>::new(), "the mended example of {}", page.code),
                _ => continue,
            }
            examples += 1;
        }
    }
    assert!(examples >= 140, "only {examples} examples");
}

#[test]
fn specs_in_the_language_reference_compile() {
    let book = include_str!("../../../docs/language.md");
    let mut whole = 0;
    for (info, text) in fences(book) {
        if info.starts_with("mav") && info != "mav" && info != "mav,fragment" {
            panic!("unknown kind of example: {info}");
        }
        if info == "mav" {
            let (model, diagnostics) = check(text);
            assert_eq!(diagnostics, vec![], "{text}");
            assert!(model.is_some());
            whole += 1;
        }
        if info == "mav,fragment" {
            let diagnostics = fragment(text);
            assert!(diagnostics.is_empty(), "{text}\n{diagnostics:#?}");
        }
    }
    assert!(whole >= 2);
}

/// Errors of a piece of a spec, in the block it belongs to: named by a comment in its first line.
fn fragment(text: &str) -> Vec<String> {
    let hop = "mission hop {\n start at [0, 0, 2] m\n waypoint at [30, 0, 5] m\n}\n";
    let first = text.lines().next().unwrap_or("");
    let spec = if first.contains("in a vehicle") {
        let rotor = "rotor { max_thrust = 480 gf; torque_per_thrust = 1.3 cm; max_speed = 19000 rpm }\n";
        let rotor = if text.contains("rotor") { "" } else { rotor };
        format!(
            "vehicle quad {{\n layout = \"PNPN\"\n arm = 11 cm\n mass = 620 g\n inertia = [2, 2, 4] g*m^2\n{rotor}{text}\n}}\n"
        )
    } else if first.contains("in a mission") {
        format!("{QUAD}mission hop {{\n start at [0, 0, 2] m\n{text}\n waypoint at [30, 0, 5] m\n}}\n")
    } else if first.contains("in limits") {
        format!("{QUAD}mission hop {{\n start at [0, 0, 2] m\n waypoint at [3, 0, 5] m\n limits {{\n{text}\n}}\n}}\n")
    } else if first.contains("in faults") {
        format!("{QUAD}faults {{\n{text}\n}}\n")
    } else if first.contains("in plan") {
        let (quad, hop) = if text.contains("capture_height") {
            let of_mission = " ground = 0 m\n limits { speed <= 8 m/s }\n start";
            (QUAD.replace("max_speed", "time_constant = 20 ms; max_speed"), hop.replace(" start", of_mission))
        } else {
            (QUAD.into(), hop.into())
        };
        format!(
            "{quad}faults {{ every 1 rotor lost as M {{ severity = 9; occurrence = 4; detection = 4 }} }}\n\
             faults {{ every 1 rotor reduced to 60 % as W; every 2 rotors lost as L; mode worn {{ rotor 1 reduced to 80 % }} }}\n\
             {hop}plan {{\n{text}\n}}\n"
        )
    } else if first.contains("in simulate") || first.contains("in campaign") {
        let block = if first.contains("in simulate") { "simulate" } else { "campaign" };
        format!("{QUAD}faults {{ every 1 rotor lost as M }}\n{hop}{block} {{\n{text}\n}}\n")
    } else {
        format!("{QUAD}{text}\n")
    };
    let diagnostics = check(&spec).1;
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
    errors.map(|d| format!("{}: {}", d.code, d.message)).collect()
}
