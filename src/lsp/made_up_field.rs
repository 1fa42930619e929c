//! What a field needs beside its row in the table: nothing. The row `MADE_UP` exists in these tests alone, and every
//! list that follows from the table has it.

use super::completion::offers;
use super::{documentation, hover, workspace};
use crate::language::table::rotor;
use crate::language::{Group, Place, clauses, is_clause, markdown, sweepable, word_list};
use crate::pipeline::{Sweep, analyze};
use std::io;
use std::path::Path;

const NAME: &str = rotor::MADE_UP.name;

const SPEC: &str = "vehicle v {
    layout = \"PNPN\"; arm = 0.2 m; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
    rotor { max_thrust = 6 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s
    }
}
";

/// The labels of what is offered at the `|` in a text.
fn offered(text: &str) -> Vec<String> {
    let at = text.find('|').unwrap();
    let text = text.replacen('|', "", 1);
    let nothing = |_: &Path| Err(io::Error::from(io::ErrorKind::NotFound));
    let spec = workspace::Spec::read("spec.mav", &text, &nothing);
    let file = spec.file("spec.mav").unwrap();
    offers(&spec, file, at).0.into_iter().map(|offer| offer.label).collect()
}

/// The messages and helps for [`SPEC`] with another text in place of the speed of its rotors.
fn reported(instead: &str) -> String {
    let error = crate::compile(&SPEC.replace("max_speed = 800 rad/s", instead)).into_result().unwrap_err();
    error.to_string()
}

#[test]
fn completion_and_hover_know_it_and_what_it_excludes() {
    let with = |field: &str| offered(&format!("vehicle v {{\n rotor {{\n {field}\n |\n }}\n}}\n"));
    assert!(with("max_speed = 1 rad/s").iter().any(|label| label == NAME));
    assert!(!with("time_constant = 20 ms").iter().any(|label| label == NAME), "one excludes the other");
    assert!(!with("made_up = 20 ms").iter().any(|label| label == "time_constant"), "in both directions");
    assert!(with("made_up = 20 |").iter().any(|label| label == "ms"));
    let clauses =
        |before: &str| offered(&format!("vehicle v {{\n rotors {{\n rotor at [0, 1, 0] m {before} |\n }}\n}}\n"));
    assert!(clauses("spin P").iter().any(|label| label == NAME));
    assert!(!clauses("time_constant 20 ms").iter().any(|label| label == NAME));
    assert!(hover::described(documentation::field(Place::Rotor, NAME).unwrap()).contains(rotor::MADE_UP.doc));
}

#[test]
fn lists_of_words_and_the_reference_have_it() {
    for list in ["clauses", "clauses with a value"] {
        assert!(word_list(list).unwrap().contains(&NAME), "{list}");
    }
    assert!(clauses().any(|word| word == NAME) && is_clause(NAME));
    assert!(markdown(Group::Rotor).contains(&format!("| `{NAME}` |")));
}

#[test]
fn sweeps_and_overrides_accept_it() {
    let path = format!("vehicle.rotor.{NAME}");
    assert!(sweepable().any(|sweepable| sweepable == path));
    let spec = crate::compile(SPEC).into_result().unwrap();
    assert!(spec.set(&format!("{path}=20ms")).is_ok());
    assert!(Sweep::run(&format!("rotor.{NAME}=1..2ms"), &spec, &analyze(&spec)).is_ok());
}

#[test]
fn mistakes_are_recognised_by_it() {
    let text = reported("max_speed = 800 rad/s; made_up = 1 s; time_constant = 1 s");
    assert!(text.contains("`made_up` and `time_constant` cannot both be given"), "{text}");
    let text = reported("max_speed = 800 rad/s; mad_up = 1 s");
    assert!(text.contains("did you mean `made_up`?"), "{text}");
    let text = reported("max_speed = 800 rad/s }\n rotors { rotor at [0, 1, 0] m spin P blades 3");
    assert!(text.contains("`made_up`"), "{text}");
    let placed = SPEC.replace("max_thrust = 6 N", "max_thrust = 6 s");
    let text = crate::compile(&placed).into_result().unwrap_err().to_string();
    assert!(text.contains("a time is given by `made_up`"), "{text}");
}
