//! Completion and hover of families and ranges of fault modes.

use super::asking::{hovers, labels, offers};
use super::client::SPEC;

#[test]
fn families_and_ranges_of_modes_are_offered_and_explained() {
    let of = |against: &str| offers(&SPEC.replace("[worn, weak1]", against));
    let alone = of("|");
    assert!(labels(&alone[0]).contains(&"weak") && labels(&alone[0]).contains(&"all"), "{alone:?}");
    let listed = of("[weak, |]");
    assert!(!labels(&listed[0]).contains(&"weak") && labels(&listed[0]).contains(&"worn"), "{listed:?}");
    for range in ["weak4 .. |", "[worn, weak4 .. |]", "weak4 .. we|"] {
        assert_eq!(labels(&of(range)[0]), ["weak5", "weak6"], "{range}");
    }
    // A strike is of one mode.
    let strike = offers(&format!("{SPEC}simulate {{ fault | }}\n"));
    assert!(labels(&strike[0]).contains(&"weak1") && !labels(&strike[0]).contains(&"weak"), "{strike:?}");
    let shown = hovers(&SPEC.replace("[worn, weak1]", "[we|ak, weak2 .. w|eak3]"));
    assert!(shown[0].contains("fault modes **weak**") && shown[0].contains("6 modes: weak1, weak2"), "{}", shown[0]);
    assert!(shown[1].contains("fault mode **weak3**") && shown[1].contains("rotor 3 reduced to 90 %"), "{}", shown[1]);
}
