//! What a field needs beside its row in the table: nothing. The row `MADE_UP` exists in these tests alone, and every
//! list that follows from the table has it. The language server has all rows of the table: `lsp/every_row.rs` of mavc.

use super::table::rotor;
use super::{Group, clauses, is_clause, markdown, sweepable, word_list};
use crate::spec::{Compiled, Compiler};

const NAME: &str = rotor::MADE_UP.name;

const SPEC: &str = "vehicle v {
    layout = \"PNPN\"; arm = 0.2 m; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
    rotor { max_thrust = 6 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s
    }
}
";

fn compiled(text: &str) -> Compiled {
    Compiler::new().text("spec.mav", text.as_bytes())
}

/// The messages and helps for [`SPEC`] with another text in place of the speed of its rotors.
fn reported(instead: &str) -> String {
    compiled(&SPEC.replace("max_speed = 800 rad/s", instead)).into_result().unwrap_err().to_string()
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
    assert!(compiled(SPEC).into_result().unwrap().set(&format!("{path}=20ms")).is_ok());
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
    let text = compiled(&placed).into_result().unwrap_err().to_string();
    assert!(text.contains("a time is given by `made_up`"), "{text}");
}
