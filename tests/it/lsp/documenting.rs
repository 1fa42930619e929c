//! Every word that the compiler knows is described in the language reference, which is what editors show.

use mavc::diagnostic::Diagnostic;
use mavc::language::Takes;
use mavc::lsp::{field_documentation, field_unit};
use mavc::read::vocabulary::{clauses, fields, words};
use mavc::syntax::Place;

const PLACES: [Place; 16] = [
    Place::Top,
    Place::Vehicle,
    Place::Rotor,
    Place::Parts,
    Place::Part,
    Place::Mode,
    Place::Every,
    Place::Curve,
    Place::Limits,
    Place::LandingSite,
    Place::KeepOff,
    Place::AfterFaultLimits,
    Place::Plan,
    Place::Recovery,
    Place::Simulate,
    Place::Campaign,
];

const STATEMENTS: [(Place, &str); 4] =
    [(Place::Rotors, "rotor"), (Place::Mission, "waypoint"), (Place::Mission, "start"), (Place::Simulate, "fault")];

fn known() -> Vec<(Place, &'static str)> {
    let of_blocks = PLACES.iter().flat_map(|place| fields(*place).into_iter().map(|name| (*place, name)));
    let of_statements =
        STATEMENTS.iter().flat_map(|(place, opener)| clauses(*place, opener).into_iter().map(|w| (*place, w)));
    of_blocks.chain(of_statements).collect()
}

#[test]
fn every_field_and_clause_is_described() {
    let all = known();
    assert!(all.len() > 100, "{}", all.len());
    for (place, name) in all {
        let entry = field_documentation(place, name).unwrap_or_else(|| panic!("{name} of {place:?}"));
        assert!(entry.doc.len() > 8, "{name} of {place:?}: {}", entry.doc);
        let is_fragment = ["or:", "or ", "see "].iter().any(|lead| entry.doc.starts_with(lead));
        assert!(!is_fragment, "{name} of {place:?}: {}", entry.doc);
    }
}

/// A spec with one field or clause set.
fn with(place: Place, name: &str, value: &str) -> Option<String> {
    let statement = format!("{name} = {value}");
    let vehicle = |fields: &str, rotor: &str| format!("vehicle v {{\n{fields}\nrotor {{ {rotor} }}\n}}\n");
    Some(match place {
        Place::Top => statement,
        Place::Vehicle => vehicle(&statement, ""),
        Place::Rotor => vehicle("", &statement),
        Place::Parts => vehicle(&format!("parts {{ {statement} }}"), ""),
        Place::Part => vehicle(&format!("parts {{ part p {{ {statement} }} }}"), ""),
        Place::Rotors => {
            let rotor = match name {
                "at" => format!("rotor at {value} spin P"),
                "spin" => format!("rotor at [1, 0, 0] m spin {value}"),
                _ => format!("rotor at [1, 0, 0] m spin P {name} {value}"),
            };
            format!("vehicle v {{ rotors {{ {rotor}{} }} }}", "; rotor at [0, 1, 0] m spin N".repeat(3))
        }
        Place::Mode => format!("faults {{ mode m {{ rotor 1 lost; {statement} }} }}"),
        Place::Every => format!("faults {{ every 1 rotor lost as m {{ {statement} }} }}"),
        Place::Mission => format!("mission m {{ waypoint {name} {value} }}"),
        Place::Curve => format!("mission m {{ curve s in 0 .. 1, points = 2 {{ {statement} }} }}"),
        Place::Limits => format!("mission m {{ limits {{ {name} <= {value} }} }}"),
        Place::LandingSite => format!("mission m {{ landing_site l {{ {statement} }} }}"),
        Place::KeepOff => {
            let shape = match name {
                "shape" => "",
                "from" | "to" | "turn" => "shape = box; ",
                "corners" => "shape = polygon; ",
                _ => "shape = cylinder; ",
            };
            format!("mission m {{ keep_off k {{ {shape}{statement} }} }}")
        }
        Place::AfterFaultLimits => format!("mission m {{ after_fault_limits {{ {name} <= {value} }} }}"),
        Place::Plan => format!("plan {{ {statement} }}"),
        Place::Recovery => format!("plan {{ recovery {{ {statement} }} }}"),
        Place::Simulate => format!("simulate {{ {statement} }}"),
        Place::Campaign => format!("campaign {{ {statement} }}"),
        _ => return None,
    })
}

fn diagnostics(text: &str) -> Vec<Diagnostic> {
    mavc::compile(text).diagnostics
}

/// Whether the compiler finds fault with the kind of what a field is given.
fn objects(text: &str) -> bool {
    let about = ["mavc::unit::mismatch", "mavc::unit::missing", "mavc::unit::kind"];
    diagnostics(text).iter().any(|d| about.contains(&d.code))
}

#[test]
fn the_units_described_are_those_that_the_compiler_takes() {
    let mut looked_at = 0;
    for (place, name) in known() {
        let entry = field_documentation(place, name).unwrap();
        let Some(unit) = field_unit(entry) else { continue };
        // The clauses of `fault` and a table's own kinds of value are looked at below.
        if place == Place::Simulate && matches!(name, "at" | "until") {
            continue;
        }
        let list = matches!(name, "inertia" | "wind" | "at" | "from" | "to" | "centre" | "centre_of_gravity")
            || (place, name) == (Place::Part, "size");
        let value = |unit: &str| if list { format!("[1, 1, 1] {unit}") } else { format!("1 {unit}") };
        let right = with(place, name, &value(unit)).unwrap();
        assert!(!objects(&right), "`{unit}` for {name}: {:?}\n{right}", diagnostics(&right));
        let wrong = with(place, name, &value("W*kg")).unwrap();
        assert!(objects(&wrong), "any unit for {name}\n{wrong}");
        looked_at += 1;
    }
    assert!(looked_at > 50, "{looked_at}");
}

#[test]
fn the_words_offered_are_those_that_the_compiler_takes() {
    let mut looked_at = 0;
    for (place, name) in known() {
        for word in words(place, name) {
            let is_list = matches!(field_documentation(place, name).unwrap().takes, Takes::NameList(_));
            let text = with(place, name, &if is_list { format!("[{word}]") } else { word.to_string() }).unwrap();
            let odd = diagnostics(&text)
                .into_iter()
                .find(|d| d.message.contains(&format!("`{name}`")) && d.severity.name() == "error");
            assert!(odd.is_none(), "{word} for {name}: {odd:?}");
            looked_at += 1;
        }
        // All the words that an error lists are offered.
        if words(place, name).is_empty() {
            continue;
        }
        let text = with(place, name, "something_else").unwrap();
        for diagnostic in diagnostics(&text).iter().filter(|d| d.message.contains("is one of")) {
            let quoted = diagnostic.message.split('`').skip(1).step_by(2);
            let mut listed: Vec<&str> = quoted.filter(|word| *word != name && *word != "something_else").collect();
            let mut offered = words(place, name).to_vec();
            offered.sort_unstable();
            listed.sort_unstable();
            assert_eq!(offered, listed, "{name} of {place:?}");
        }
    }
    assert!(looked_at > 25, "{looked_at}");
}
