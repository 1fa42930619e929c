//! Hover, completion, hints, tokens and the outline.

use super::client::{Client, SPEC, marked};
use serde_json::{Value, json};

const URI: &str = "untitled:spec";

/// The Markdown shown at each place marked.
pub(super) fn hovers(text: &str) -> Vec<String> {
    let (text, places) = marked(text);
    let mut client = Client::start();
    client.open(URI, &text);
    let hover = |client: &mut Client, place: &Value| {
        let params = json!({ "textDocument": { "uri": URI }, "position": place });
        let shown = client.ask("textDocument/hover", params).unwrap();
        shown["contents"]["value"].as_str().unwrap_or("nothing").to_string()
    };
    let shown = places.iter().map(|place| hover(&mut client, place)).collect();
    client.stop();
    shown
}

#[test]
fn fields_show_what_they_are_their_unit_and_their_value() {
    let shown =
        hovers(&SPEC.replace("max_speed  ", "ma|x_speed  ").replace("tilt <=", "ti|lt <=").replace("time ", "ti|me "));
    assert!(shown[0].contains("in rad/s") && shown[0].contains("`8500 rpm` = **890.118 rad/s**"), "{}", shown[0]);
    assert!(
        shown[1].contains("in deg") && shown[1].contains("angle between the thrust and the vertical"),
        "{}",
        shown[1]
    );
    assert!(shown[1].contains("`20 deg` = **0.349066 rad**"), "{}", shown[1]);
    assert!(shown[2].contains("time of the whole mission") && shown[2].contains("`20 s`"), "{}", shown[2]);
}

#[test]
fn names_units_and_functions_show_what_they_stand_for() {
    let spec =
        SPEC.replace("let top = 2 * 4 m", "let top = m|ax(2 * 4 m, 8 f|t) * g|0 / g0").replace("3 m, top", "3 m, t|op");
    let shown = hovers(&spec.replace("every 1", "ev|ery 1").replace("mode worn", "mo|de worn"));
    assert!(shown[0].contains("a mode for each choice of k rotors"), "{}", shown[0]);
    assert!(shown[1].contains("one fault mode"), "{}", shown[1]);
    assert!(shown[2].contains("the largest of two or more values of one dimension"), "{}", shown[2]);
    assert!(shown[3].contains("`1 ft` = 0.3048 m, a length"), "{}", shown[3]);
    assert!(shown[4].contains("9.81 m/s^2"), "{}", shown[4]);
    assert!(shown[5].contains("As high as the mast.") && shown[5].contains("= **8 m**"), "{}", shown[5]);
}

#[test]
fn a_vehicle_shows_its_thrust_to_weight_and_hover_speed() {
    let shown = hovers(&SPEC.replace("vehicle quad", "vehicle qu|ad"));
    // Six rotors of 9 N lift 54 N; 1.6 kg weigh 15.696 N.
    assert!(shown[0].contains("A quadcopter that carries a camera."), "{}", shown[0]);
    assert!(shown[0].contains("thrust to weight **3.44**"), "{}", shown[0]);
    // Each gives a sixth of the weight, at the root of its share of full thrust: 890.118 sqrt(2.616 / 9).
    assert!(shown[0].contains("hover speed **479.9 rad/s (4583 rpm)**"), "{}", shown[0]);
}

#[test]
fn a_fault_mode_shows_its_verdict_and_margin() {
    let spec = SPEC.replace("every 1 rotor reduced to 90 % as weak", "every 1 rotor lost as we|ak");
    let shown = hovers(&spec.replace("mode worn", "mode wo|rn").replace("weak1]", "we|ak1]"));
    let (every, worn, weak1) = (&shown[0], &shown[1], &shown[2]);
    assert!(
        worn.contains("rotor 2 reduced to 80 %") && worn.contains("**full control** (controllable, hover inside)"),
        "{worn}"
    );
    assert!(worn.contains("“worn bearing”") && worn.contains("margin **0.") && worn.contains("hovers up to"), "{worn}");
    assert!(weak1.contains("rotor 1 lost"), "{weak1}");
    // A known result: a ring PNPNPN that has lost a rotor hovers, but with nothing to spare.
    assert!(
        weak1.contains("**flies on, heading not held** (controllable, hover on the edge)")
            && weak1.contains("margin **0**"),
        "{weak1}"
    );
    assert_eq!(every.matches("| flies on, heading not held | 0 |").count(), 6, "{every}");
    assert!(every.contains("weak1, weak2"), "{every}");
}

#[test]
fn with_errors_a_hover_says_what_is_known_all_the_same() {
    let spec =
        SPEC.replace("= 20 s", "= 20 kg").replace("vehicle quad", "vehicle qu|ad").replace("mode worn", "mode wo|rn");
    let shown = hovers(&spec);
    assert!(shown[0].contains("thrust to weight **3.44**"), "{}", shown[0]);
    assert!(shown[1].contains("once the spec has no errors"), "{}", shown[1]);
}

/// The labels offered at each place marked, and what they put in.
pub(super) fn offers(text: &str) -> Vec<Vec<(String, String)>> {
    let (text, places) = marked(text);
    let mut client = Client::start();
    client.open(URI, &text);
    let mut ask = |place: &Value| {
        let params = json!({ "textDocument": { "uri": URI }, "position": place });
        let items = client.ask("textDocument/completion", params).unwrap();
        let mut items = items.as_array().unwrap().clone();
        items.sort_by_key(|item| item["sortText"].as_str().unwrap().to_string());
        let pair = |i: &Value| {
            (i["label"].as_str().unwrap().to_string(), i["textEdit"]["newText"].as_str().unwrap().to_string())
        };
        items.iter().map(pair).collect::<Vec<_>>()
    };
    let all = places.iter().map(&mut ask).collect();
    client.stop();
    all
}

pub(super) fn labels(offers: &[(String, String)]) -> Vec<&str> {
    offers.iter().map(|offer| offer.0.as_str()).collect()
}

#[test]
fn in_a_block_the_fields_that_it_lacks_are_offered() {
    let all = offers(
        "vehicle a {\n    mass = 1 kg\n    |\n    arm = 2 m\n    rotor {\n        max_|\n    }\n}\n|\nplan {}\n",
    );
    let vehicle = labels(&all[0]);
    assert_eq!(vehicle[0], "inertia", "what is needed comes first: {vehicle:?}");
    assert!(vehicle.contains(&"layout") && !vehicle.contains(&"mass") && !vehicle.contains(&"arm"), "{vehicle:?}");
    assert!(!vehicle.contains(&"rotor") && vehicle.contains(&"rotors"), "{vehicle:?}");
    assert!(labels(&all[1]).contains(&"max_thrust") && labels(&all[1]).contains(&"max_speed"), "{:?}", all[1]);
    let top = labels(&all[2]);
    assert!(top.contains(&"faults") && top.contains(&"mission") && top.contains(&"use"), "{top:?}");
    assert!(!top.contains(&"plan"), "a spec has one plan: {top:?}");
}

#[test]
fn a_battery_is_completed_and_explained() {
    let all = offers(
        "vehicle a {\n mass = 1 kg\n battery {\n capacity = 5 |\n hover|\n keep = 20 |\n }\n |\n}\nvehicle b {\n bat|\n}\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert_eq!(of(0)[0], "A*h");
    assert!(of(0).contains(&"mA*h") && !of(0).contains(&"A"), "{:?}", of(0));
    assert!(
        of(1).contains(&"hover_power") && of(1).contains(&"voltage") && !of(1).contains(&"capacity"),
        "{:?}",
        of(1)
    );
    assert_eq!(of(2)[0], "%");
    // A vehicle has one battery.
    assert!(!of(3).contains(&"battery") && of(3).contains(&"rotor"), "{:?}", of(3));
    assert!(of(4).contains(&"battery"), "{:?}", of(4));
    let battery = "    battery { capa|city = 5 A*h; voltage = 22.2 V; hover_power = 200 W; ke|ep = 40 % }\n    rotor";
    let shown = hovers(&SPEC.replacen("    rotor", battery, 1).replace("vehicle quad", "vehicle qu|ad"));
    // 111 W*h, of which 60 % at 200 W.
    assert!(shown[0].contains("hovers for **20 min** until 40 % of the charge is left"), "{}", shown[0]);
    assert!(shown[1].contains("the charge that the full battery gives"), "{}", shown[1]);
    assert!(shown[2].contains("default: 20 %"), "{}", shown[2]);
}

#[test]
fn clauses_of_legs_are_offered() {
    let all = offers(
        "mission m {\n start at [0, 0, 2] m\n waypoint a at [1, 2, 3] m |\n waypoint at [1, 2, 5] m vertical |\n \
         waypoint at [2, 2, 5] m arrive |\n waypoint at [3, 2, 5] m yaw |\n waypoint at [4, 2, 5] m yaw towards |\n \
         waypoint at [5, 2, 5] m yaw free |\n waypoint at [6, 2, 5] m stop { | }\n waypoint at [7, 2, 5] m corridor 2 |\n}\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert!(["straight", "corridor", "arrive", "stop", "yaw"].iter().all(|word| of(0).contains(word)), "{:?}", of(0));
    assert!(all[0].contains(&("arrive".into(), "arrive from ".into())), "{:?}", all[0]);
    assert!(of(1).contains(&"stop") && !of(1).contains(&"vertical"), "{:?}", of(1));
    assert_eq!(of(2), ["from"]);
    assert!(["towards", "along path", "free"].iter().all(|word| of(3).contains(word)), "{:?}", of(3));
    assert!(of(4).contains(&"a") && !of(4).contains(&"free"), "{:?}", of(4));
    assert!(of(5).contains(&"within") && !of(5).contains(&"yaw"), "{:?}", of(5));
    assert!(of(6).contains(&"speed") && of(6).contains(&"tilt") && !of(6).contains(&"at"), "{:?}", of(6));
    assert!(of(7).contains(&"m") && !of(7).contains(&"s"), "{:?}", of(7));
}

#[test]
fn a_waypoint_to_which_the_yaw_points_is_a_reference() {
    let shown = hovers(
        "mission m {\n start at [0, 0, 2] m  ya|w towards mas|t\n /// The mast.\n waypoint mast at [9, 0, 2] m\n}\n",
    );
    assert!(shown[0].contains("towards") && shown[1].contains("The mast."), "{shown:?}");
}

#[test]
fn behind_a_number_units_of_the_right_dimension_are_offered() {
    let all = offers(
        "vehicle a {\n mass = 1.8 |\n rotor {\n max_speed = 8500 r|\n }\n}\nmission m {\n waypoint at [1, 2, 3] |\n \
         limits { speed <= 5 | }\n}\nplan { time = 20 |; reserve = 10 | }\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert_eq!(of(0)[0], "kg");
    assert!(of(0).contains(&"g") && of(0).contains(&"lb") && !of(0).contains(&"m"), "{:?}", of(0));
    assert!(of(1).contains(&"rpm") && of(1).contains(&"rad/s") && !of(1).contains(&"rad"), "{:?}", of(1));
    assert!(of(2).contains(&"m") && of(2).contains(&"cm") && of(2).contains(&"yaw"), "{:?}", of(2));
    assert!(of(3).contains(&"m/s") && of(3).contains(&"km/h") && !of(3).contains(&"s"), "{:?}", of(3));
    assert!(of(4).contains(&"s") && !of(4).contains(&"kg"), "{:?}", of(4));
    assert_eq!(of(5)[0], "%");
}

#[test]
fn modes_words_functions_and_names_are_offered_where_they_may_stand() {
    let spec = SPEC
        .replace("[worn, weak1]", "[worn, |")
        .replace("    time    = 20 s\n", "    planner = |\n    time = 2*|\n    vehicle = |\n");
    let all = offers(&spec);
    let of = |k: usize| labels(&all[k]);
    assert!(of(0).contains(&"weak3") && !of(0).contains(&"worn") && !of(0).contains(&"sin"), "{:?}", of(0));
    assert_eq!(of(1), ["rcp", "rip", "rsp"]);
    assert!(of(2).contains(&"top") && of(2).contains(&"sqrt") && of(2).contains(&"g0"), "{:?}", of(2));
    assert_eq!(of(3), ["quad"]);
    let all = offers(
        "faults {\n mode a { rotor 1 | }\n every 2 |\n every 2 rotors lost |\n}\nmission m {\n waypoint b |\n hold 3 |\n start |\n \
         curve s in 0 .. 4, points = 9 { x = | }\n}\nsimulate { fault | }\nplan { against = where | }\n// no|\nuse \"a|\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert_eq!(of(0), ["lost", "reduced to", "stuck at"]);
    assert_eq!(of(1), ["rotor", "rotors"]);
    assert_eq!(of(2), ["as"]);
    assert!(of(3).contains(&"at") && of(3).contains(&"within"), "{:?}", of(3));
    assert!(of(4).contains(&"s") && !of(4).contains(&"m"), "{:?}", of(4));
    assert!(of(5).contains(&"moving") && of(5).contains(&"at"), "{:?}", of(5));
    assert!(of(6).contains(&"s") && of(6).contains(&"cos"), "the parameter: {:?}", of(6));
    assert!(of(7).contains(&"a"), "{:?}", of(7));
    assert!(of(8).contains(&"rpn") && of(8).contains(&"rate"), "{:?}", of(8));
    assert!(all[9].is_empty() && all[10].is_empty());
}

#[test]
fn ways_out_and_landing_sites_are_offered_and_explained() {
    let all = offers(
        "faults { mode a { rotor 1 lost; recovery = [continue, | ] } }\nmission m {\n ground = 0 m\n /// by the gate\n \
         landing_site pad { at = [4, -8, 0] m; radius = 2 | }\n landing_site roof { | }\n keep_off street { | }\n \
         after_fault_limits { | }\n |\n}\nplan {\n recovery { order = [pad, |]; detection = 20 |; | }\n require |\n |\n}\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert_eq!(of(0), ["land_at_sites", "land_here", "pad", "roof"]);
    assert!(of(1).contains(&"m") && !of(1).contains(&"s"), "{:?}", of(1));
    assert_eq!(of(2), ["at", "radius"]);
    assert!(of(3).contains(&"corners") && !of(3).contains(&"height"), "{:?}", of(3));
    assert!(of(4).contains(&"tilt") && !of(4).contains(&"altitude"), "{:?}", of(4));
    assert!(of(5).contains(&"landing_site") && of(5).contains(&"buffer") && !of(5).contains(&"after_fault_limits"));
    assert_eq!(of(6), ["continue", "land_at_sites", "land_here", "roof"]);
    assert!(of(7).contains(&"ms") && !of(7).contains(&"m"), "{:?}", of(7));
    assert!(of(8).contains(&"within") && !of(8).contains(&"order"), "{:?}", of(8));
    assert!(of(9).contains(&"uncovered <="), "{:?}", of(9));
    assert!(of(10).contains(&"samples") && !of(10).contains(&"recovery"), "{:?}", of(10));
}

#[test]
fn comments_are_offered_nothing() {
    let all = offers(
        "// A |\n/// A |\nvehicle a {\n    // the |\n    mass = 1 kg // all |\n}\nplan { against = [M1, // x |\n] }\n// b\n|",
    );
    let (last, comments) = all.split_last().unwrap();
    assert!(comments.iter().all(Vec::is_empty), "{comments:?}");
    assert_eq!(labels(last)[0], "vehicle", "behind a comment's line something may be written");
}

#[test]
fn a_list_is_offered_what_it_does_not_have() {
    let spec = SPEC.replace("[worn, weak1]", "[worn, |, weak1]").replace("    time ", "    planner = |\n    time ");
    let all = offers(&spec);
    let inside = labels(&all[0]);
    assert!(inside.contains(&"weak2") && !inside.contains(&"worn") && !inside.contains(&"weak1"), "{inside:?}");
    assert!(!inside.contains(&"all"), "{inside:?}");
    let whole =
        labels(&offers(&SPEC.replace("[worn, weak1]", "|"))[0]).iter().map(ToString::to_string).collect::<Vec<_>>();
    assert!(whole.contains(&"all".to_string()) && whole.contains(&"where".to_string()), "{whole:?}");
    let planners = offers("campaign { planners = [rip, |] }\n");
    assert_eq!(labels(&planners[0]), ["rcp", "rsp"]);
    let all = offers("allow = [inertia, |]\n");
    let warnings = labels(&all[0]);
    assert!(warnings.contains(&"tip_speed") && !warnings.contains(&"inertia"), "{warnings:?}");
}

#[test]
fn shares_plain_numbers_and_longer_units_are_distinguished() {
    let all = offers(
        "faults {\n mode a { rotor 1 reduced to 60 |; severity = 7 | }\n every 1 rotor stuck at 5 |\n}\nlet v = 3 m/|\n\
         mission m {\n limits { speed <= 3 m/|; acceleration <= 2 m/s^| }\n}\nplan { samples = 40 |; against = where rate > 2 1/| }\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert_eq!(of(0), ["%"]);
    assert!(of(1).is_empty(), "{:?}", of(1));
    assert_eq!(of(2), ["%"]);
    assert!(of(3).contains(&"m/s") && !of(3).contains(&"sin"), "{:?}", of(3));
    assert!(of(4).contains(&"m/s") && !of(4).contains(&"m"), "{:?}", of(4));
    assert!(of(5).contains(&"m/s^2") && !of(5).contains(&"m/s"), "{:?}", of(5));
    assert!(of(6).is_empty(), "{:?}", of(6));
    assert!(of(7).contains(&"1/h") && !of(7).contains(&"sin"), "{:?}", of(7));
}

#[test]
fn what_is_needed_comes_first() {
    let all = offers("|vehicle a {\n |\n rotor {\n max_thrust = 1 N\n |\n }\n}\nvehicle b {\n |\n}\n");
    assert_eq!(labels(&all[0])[..3], ["vehicle", "faults", "mission"]);
    let vehicle = labels(&all[1]);
    assert_eq!(vehicle[..4], ["arm", "inertia", "layout", "mass"]);
    let rotor = labels(&all[2]);
    assert!(!rotor.contains(&"thrust_coefficient") && !rotor.contains(&"max_thrust"), "{rotor:?}");
    assert!(rotor[..3].contains(&"max_speed"), "{rotor:?}");
    let other = labels(&all[3]);
    assert_eq!(other[..5], ["arm", "inertia", "layout", "mass", "rotor"]);
}

#[test]
fn what_another_field_or_clause_excludes_is_not_offered() {
    let all = offers(
        "vehicle a {\n rotor {\n min_speed = 1 rad/s\n |\n }\n rotors {\n \
         rotor at [0, 1, 0] m spin P min_thrust 2 % |\n }\n |\n}\n\
         mission m {\n air {\n altitude = 5 m\n |\n }\n waypoint at [1, 0, 1] m stop vertical |\n}\n",
    );
    let of = |k: usize| labels(&all[k]);
    assert!(!of(0).contains(&"min_thrust") && of(0).contains(&"max_thrust"), "{:?}", of(0));
    assert!(!of(1).contains(&"min_speed") && of(1).contains(&"max_speed"), "{:?}", of(1));
    assert!(!of(2).contains(&"arm") && !of(2).contains(&"layout") && of(2).contains(&"mass"), "{:?}", of(2));
    assert!(!of(3).contains(&"density") && of(3).contains(&"gusts"), "{:?}", of(3));
    assert!(!of(4).contains(&"pass") && !of(4).contains(&"corridor") && of(4).contains(&"arrive"), "{:?}", of(4));
}

#[test]
fn editors_that_know_snippets_get_the_cursor_inside_the_braces() {
    for (knows, wanted) in [(true, "rotor {\n\t$0\n}"), (false, "rotor {\n}")] {
        let item = json!({ "completionItem": { "snippetSupport": knows } });
        let mut client = Client::start_with(json!({ "capabilities": { "textDocument": { "completion": item } } }));
        client.open(URI, "vehicle a {\n \n}\n");
        let params = json!({ "textDocument": { "uri": URI }, "position": { "line": 1, "character": 1 } });
        let items = client.ask("textDocument/completion", params).unwrap();
        let rotor = items.as_array().unwrap().iter().find(|i| i["label"] == "rotor").unwrap();
        assert_eq!(rotor["textEdit"]["newText"], wanted);
        assert_eq!(rotor["insertTextFormat"], if knows { json!(2) } else { Value::Null });
        client.stop();
    }
}

#[test]
fn paths_are_offered_from_their_folder() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    std::fs::create_dir(path.join("parts")).unwrap();
    for name in ["root.mav", "quad.mav", "points.csv", "notes.md", ".hidden.mav", "parts/hexa.mav"] {
        std::fs::write(path.join(name), "").unwrap();
    }
    let text = "use \"|\"\nuse \"parts/h|\"\nmission m {\n waypoints from \"|\n}\nplan { vehicle = \"|\" }\n\
                vehicle v {\n rotor { table = \"|\" }\n}\n";
    let (text, places) = marked(text);
    let uri = super::client::uri_of(&path.join("root.mav"));
    let mut client = Client::start();
    client.open(&uri, &text);
    let mut of = |place: &Value| {
        let params = json!({ "textDocument": { "uri": uri }, "position": place });
        let items = client.ask("textDocument/completion", params).unwrap();
        let mut items: Vec<String> =
            items.as_array().unwrap().iter().map(|i| i["textEdit"]["newText"].as_str().unwrap().to_string()).collect();
        items.sort();
        items
    };
    assert_eq!(of(&places[0]), ["parts/", "quad.mav"]);
    assert_eq!(of(&places[1]), ["hexa.mav"]);
    assert_eq!(of(&places[2]), ["parts/", "points.csv"]);
    assert!(of(&places[3]).is_empty());
    assert_eq!(of(&places[4]), ["parts/", "points.csv"]);
    client.stop();
}

#[test]
fn words_and_waypoints_have_a_hover_and_units_of_si_no_tautology() {
    let spec = SPEC
        .replace("    time ", "    planner = rs|p\n    time ")
        .replace("weak1]", "wea|k1]")
        .replace("1.6 kg", "1.6 k|g")
        .replace("tilt <= 20 deg", "tilt <= 20 deg; altitud|e in 1 m .. 20 m")
        .replace("waypoint mast", "waypoint ma|st");
    let shown = hovers(&spec);
    assert!(shown[0].contains("`1.6 kg`") && shown[0].contains("`kg`, a mass, as in SI"), "{}", shown[0]);
    assert!(!shown[0].contains('='), "{}", shown[0]);
    assert!(shown[1].starts_with("waypoint **mast**") && shown[1].contains("**[12, 3, 8] m**"), "{}", shown[1]);
    assert!(shown[2].contains("`1 m .. 20 m`") && !shown[2].contains("1 .. 20"), "{}", shown[2]);
    assert!(shown[4].contains("a value of `planner`, the default") && shown[4].contains("`rip` plan"), "{}", shown[4]);
    assert!(shown[3].starts_with("fault mode **weak1**"), "{}", shown[3]);
}

#[test]
fn the_rate_of_a_mode_shows_its_interval() {
    let spec = SPEC.replace("rate = 1e-4 1/h", "ra|te = 1e-4 1/h +- 50 %");
    assert!(spec.contains('|'));
    let shown = hovers(&spec);
    assert!(shown[0].contains("in 1/h") && shown[0].contains("an interval such as `1e-5 1/h +- 50 %`"), "{}", shown[0]);
    // 0.5e-4 and 1.5e-4 over 3600 s.
    assert!(shown[0].contains("`1e-4 1/h +- 50 %` = **1.38889e-8 .. 4.16667e-8 1/s**"), "{}", shown[0]);
}

#[test]
fn a_path_shows_what_its_file_declares() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    std::fs::write(path.join("quad.mav"), SPEC).unwrap();
    let uri = super::client::uri_of(&path.join("root.mav"));
    let mut client = Client::start();
    client.open(&uri, "use \"quad.mav\"\n");
    let params = json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": 8 } });
    let shown = client.ask("textDocument/hover", params).unwrap();
    let text = shown["contents"]["value"].as_str().unwrap();
    assert!(text.contains("vehicle `quad`") && text.contains("fault mode `worn`"), "{text}");
    client.stop();
}

#[test]
fn hints_count_modes_and_give_values_in_si() {
    let mut client = Client::start();
    client.open(URI, &SPEC.replace("[worn, weak1]", "all"));
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let params = |range: &Value| json!({ "textDocument": { "uri": URI }, "range": range });
    let hints = client.ask("textDocument/inlayHint", params(&whole)).unwrap();
    let label = |text: &str| {
        let (line, column) = SPEC.lines().enumerate().find_map(|(k, l)| Some((k, l.find(text)? + text.len()))).unwrap();
        let at = json!({ "line": line, "character": column });
        hints.as_array().unwrap().iter().find(|h| h["position"] == at).map_or("", |h| h["label"].as_str().unwrap())
    };
    assert_eq!(label("8500 rpm"), "= 890.118 rad/s");
    assert_eq!(label("25 cm"), "= 0.25 m");
    assert_eq!(label("as weak"), "6 modes: weak1 ... weak6");
    assert_eq!(label("1e-4 1/h"), "= 2.77778e-8 1/s");
    assert_eq!(label("20 deg"), "= 0.349066 rad");
    assert_eq!(label("[12 m, 3 m, top]"), "= [12, 3, 8] m");
    assert_eq!(label("1.6 kg"), "", "what is SI already is not said again");
    assert!(hints.as_array().unwrap().iter().any(|h| h["label"] == "7 modes"), "{hints}");
    let first_lines = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 4, "character": 0 } });
    let few = client.ask("textDocument/inlayHint", params(&first_lines)).unwrap();
    assert_eq!(few.as_array().unwrap().len(), 1, "{few}");
    client.stop();
}

#[test]
fn tokens_say_what_every_word_is() {
    let text = "/// α😀\nlet a = 2 m // b\nvehicle v { mass = a*sin(1)\n<= +- mode ???\n";
    let mut client = Client::start();
    client.open(URI, text);
    let legend = client.capabilities["semanticTokensProvider"]["legend"]["tokenTypes"].clone();
    let params = json!({ "textDocument": { "uri": URI } });
    let tokens = client.ask("textDocument/semanticTokens/full", params).unwrap();
    let numbers: Vec<u64> = tokens["data"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
    let (mut line, mut column) = (0, 0);
    let mut found = Vec::new();
    for token in numbers.chunks(5) {
        column = if token[0] > 0 { token[1] } else { column + token[1] };
        line += token[0];
        let units: Vec<u16> = text.lines().nth(line as usize).unwrap().encode_utf16().collect();
        let word = String::from_utf16(&units[column as usize..(column + token[2]) as usize]).unwrap();
        found.push(format!("{word}:{}", legend[token[3] as usize].as_str().unwrap()));
    }
    assert_eq!(
        found,
        [
            "/// α😀:comment",
            "let:keyword",
            "a:variable",
            "=:operator",
            "2:number",
            "m:type",
            "// b:comment",
            "vehicle:keyword",
            "v:class",
            "mass:property",
            "=:operator",
            "a:variable",
            "*:operator",
            "sin:function",
            "1:number",
            "<=:operator",
            "+-:operator",
            "mode:keyword",
        ]
    );
    client.stop();
}

#[test]
fn the_outline_and_the_folds_follow_the_blocks() {
    let mut client = Client::start();
    client.open(URI, SPEC);
    let params = json!({ "textDocument": { "uri": URI } });
    let symbols = client.ask("textDocument/documentSymbol", params.clone()).unwrap();
    let names: Vec<&str> = symbols.as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["quad", "faults", "top", "survey", "plan"]);
    let faults: Vec<&str> =
        symbols[1]["children"].as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(faults, ["weak", "worn"]);
    let folds = client.ask("textDocument/foldingRange", params.clone()).unwrap();
    let lines: Vec<(u64, u64)> = folds
        .as_array()
        .unwrap()
        .iter()
        .map(|f| (f["startLine"].as_u64().unwrap(), f["endLine"].as_u64().unwrap()))
        .collect();
    // vehicle, rotor, faults, mission, plan: the closing brace stays in sight.
    assert_eq!(lines, [(1, 10), (6, 9), (13, 15), (21, 24), (27, 29)]);
    // A text that cannot be read folds too.
    client.replace(URI, 2, "// a\n// b\nvehicle ( {\n x\n y\n}\n");
    let folds = client.ask("textDocument/foldingRange", params).unwrap();
    assert_eq!(folds[0]["kind"], "comment");
    assert_eq!((&folds[1]["startLine"], &folds[1]["endLine"]), (&json!(2), &json!(4)));
    client.stop();
}

#[test]
fn formatting_gives_the_layout_of_fmt_and_nothing_where_there_is_none() {
    let mut client = Client::start();
    let text = SPEC.replace("    mass    =", "  mass=").replace("let top = 2 * 4 m", "let top   =   2*4 m");
    client.open(URI, &text);
    let params = json!({ "textDocument": { "uri": URI }, "options": { "tabSize": 4, "insertSpaces": true } });
    let edits = client.ask("textDocument/formatting", params.clone()).unwrap();
    let source = mavc::source::Source::new("", text.clone());
    let at = |end: &str| {
        let number = |of: &str| edits[0]["range"][end][of].as_u64().unwrap() as u32;
        source.offset_utf16(number("line"), number("character"))
    };
    let mut formatted = text.clone();
    formatted.replace_range(at("start")..at("end"), edits[0]["newText"].as_str().unwrap());
    let wanted = mavc::format::format(mavc::source::FileId(0), &source).value.unwrap();
    assert_eq!(formatted, wanted);
    assert_ne!(text, wanted);
    client.replace(URI, 2, &wanted);
    assert_eq!(client.ask("textDocument/formatting", params.clone()).unwrap(), json!([]));
    client.replace(URI, 3, &text.replace("}", ")"));
    assert_eq!(client.ask("textDocument/formatting", params).unwrap(), Value::Null);
    client.stop();
}

/// A thrust table shows what it gives, on the field and on its path; what the spec writes itself is marked.
#[test]
fn a_table_shows_the_numbers_that_it_gives() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    std::fs::write(path.join("motor.csv"), "Thrust,Torque,RPM\nN,N*m,1/min\n2,0.03,3000\n4,0.06,4500\n").unwrap();
    std::fs::write(path.join("wrong.csv"), "Thrust\n1\n").unwrap();
    let text = "vehicle v {\n layout = \"PNPN\"; arm = 20 cm; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2\n \
                rotor { ta|ble = \"mot|or.csv\"; max_speed = 470 rad/s }\n}\n\
                vehicle w {\n rotor { table = \"wr|ong.csv\" }\n}\n";
    let (text, places) = marked(text);
    let uri = super::client::uri_of(&path.join("root.mav"));
    let mut client = Client::start();
    client.open(&uri, &text);
    let shown: Vec<Value> = places
        .iter()
        .map(|place| {
            let params = json!({ "textDocument": { "uri": uri }, "position": place });
            client.ask("textDocument/hover", params).unwrap()
        })
        .collect();
    for shown in &shown[..2] {
        let shown = shown["contents"]["value"].as_str().unwrap();
        assert!(shown.contains("`max_thrust` = **4 N**"), "{shown}");
        assert!(shown.contains("`torque_per_thrust` = **0.015 m**") && shown.contains("least squares"), "{shown}");
        assert!(
            shown.contains("`max_speed` = **471.2 rad/s**") && shown.contains("the spec writes its own"),
            "{shown}"
        );
    }
    assert!(!shown[2].to_string().contains("max_thrust"), "{}", shown[2]);
    client.stop();
}
