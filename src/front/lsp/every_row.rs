//! Completion and hover have every row of the table of the language.

use super::completion::offers;
use super::{documentation, hover, workspace};
use crate::language::{Entry, Group, Place};
use std::io;
use std::path::Path;

/// The blocks with fields of their own, each with a text in which `|` stands among its fields.
const BLOCKS: [(Place, &str); 19] = [
    (Place::Vehicle, "vehicle v { | }"),
    (Place::Rotor, "vehicle v { rotor { | } }"),
    (Place::Battery, "vehicle v { battery { | } }"),
    (Place::Parts, "vehicle v { parts { | } }"),
    (Place::Part, "vehicle v { parts { part p { | } } }"),
    (Place::Mode, "faults { mode m { | } }"),
    (Place::Mission, "mission m { | }"),
    (Place::Curve, "mission m { curve 0..1 { | } }"),
    (Place::Limits, "mission m { limits { | } }"),
    (Place::KeepIn, "mission m { keep_in k { | } }"),
    (Place::Air, "mission m { air { | } }"),
    (Place::LandingSite, "mission m { landing_site l { | } }"),
    (Place::KeepOff, "mission m { keep_off k { | } }"),
    (Place::AfterFaultLimits, "mission m { after_fault_limits { | } }"),
    (Place::Plan, "plan { | }"),
    (Place::Requirement, "plan { require capture_height { | } }"),
    (Place::Recovery, "plan { recovery { | } }"),
    (Place::Simulate, "simulate { | }"),
    (Place::Campaign, "campaign { | }"),
];

/// The labels of what is offered at the `|` in a text.
fn offered(text: &str) -> Vec<String> {
    let at = text.find('|').unwrap();
    let text = text.replacen('|', "", 1);
    let nothing = |_: &Path| Err(io::Error::from(io::ErrorKind::NotFound));
    let spec = workspace::Spec::read("spec.mav", &text, &nothing);
    let file = spec.file("spec.mav").unwrap();
    offers(&spec, file, at).0.into_iter().map(|offer| offer.label).collect()
}

/// The fields of the block in `text` that are offered while `given` is there.
fn beside(text: &str, given: &Entry) -> Vec<String> {
    offered(&text.replacen('|', &format!("\n{} = \n |\n", given.name), 1))
}

#[test]
fn completion_has_every_field_but_those_that_another_excludes() {
    for (place, text) in BLOCKS {
        let group = Group::of_block(place);
        let all = offered(&text.replacen('|', "\n |\n", 1));
        for entry in group.entries() {
            assert!(all.iter().any(|label| label == entry.name), "{text}: {}", entry.name);
            let others = beside(text, entry);
            for other in group.entries().iter().filter(|other| other.name != entry.name) {
                let is_offered = others.iter().any(|label| label == other.name);
                let is_excluded = group.rivals(entry.name).any(|rival| rival == other.name);
                assert_eq!(is_offered, !is_excluded, "{text}: {} beside {}", other.name, entry.name);
            }
        }
    }
}

#[test]
fn completion_has_the_clauses_of_rotors() {
    let after = |text: &str| offered(&format!("vehicle v {{\n rotors {{\n rotor at [0, 1, 0] m {text} |\n }}\n}}\n"));
    let offered = after("spin P");
    // A table of a motor is one of all rotors of a vehicle.
    for clause in Group::Rotor.names().filter(|&name| name != "table") {
        assert!(offered.iter().any(|label| label == clause), "{clause}: {offered:?}");
    }
    assert!(!after("max_thrust 6 N").iter().any(|label| label == "thrust_coefficient"), "one excludes the other");
}

#[test]
fn units_are_offered_after_a_number() {
    assert!(offered("vehicle v {\n rotor {\n time_constant = 20 |\n }\n}\n").iter().any(|label| label == "ms"));
}

#[test]
fn hover_describes_every_row() {
    for (place, _) in BLOCKS {
        for entry in Group::within(place).iter().flat_map(|group| group.entries()) {
            let described = hover::described(documentation::field(place, entry.name).unwrap());
            assert!(described.contains(&documentation::line(entry)), "{place:?} {}", entry.name);
        }
    }
}
