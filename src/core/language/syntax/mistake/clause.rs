//! Words that do not begin a clause, in `rotor at [0.2, 0.15, 0] m  spin P`, `start` and `waypoint`.

use super::{Broken, Expected, Failure, cut};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::table::waypoint;
use crate::language::{Group, Place, clauses};

/// Words for an axis that is not upright.
const TILTED: [&str; 13] = [
    "tilt",
    "tilted",
    "tilting",
    "cant",
    "canted",
    "angle",
    "axis",
    "axes",
    "normal",
    "direction",
    "orientation",
    "roll",
    "pitch",
];

/// Other words for a clause, and the clause.
const OTHER_WORDS: [(&str, &str); 11] = [
    ("position", "at"),
    ("pos", "at"),
    ("turns", "spin"),
    ("rotation", "spin"),
    ("thrust", "max_thrust"),
    ("torque", "torque_per_thrust"),
    ("drag", "drag_coefficient"),
    ("speed", "max_speed"),
    ("max_rpm", "max_speed"),
    ("rpm", "max_speed"),
    ("inertia", "rotor_inertia"),
];

/// A word that begins no clause: `rotor at [..] m  spin P tilt 15 deg`, `rotor at [..] m  spin P  blades 3`.
pub(super) fn of_rotor(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let is_word = found.starts_with(|c: char| c.is_ascii_alphabetic());
    let is_rotor = statement.word() == "rotor" && !statement.has_body && statement.place == Place::Rotors;
    if !is_rotor || !is_word || !failure.expects(Expected::Clause) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let error =
        |message: String| Diagnostic::error("mavc::syntax::unexpected", span, message).here("not a clause of a rotor");
    if TILTED.contains(&found) {
        let message = format!("a rotor has no `{found}`: the axes of all rotors are parallel to the body's z axis");
        return Some(error(message).help("remove it: rotors with tilted axes cannot be described yet"));
    }
    let message = format!("a rotor has no `{}`", cut(found));
    if let Some((_, clause)) = OTHER_WORDS.iter().find(|(word, _)| *word == found) {
        return Some(error(message).help(format!("did you mean `{clause}`?")).fix(span, *clause));
    }
    // Nearly right words are reported as misspelt.
    let is_near = nearest(found, Group::PlacedRotor.names()).is_some();
    (!is_near).then(|| error(message).help(format!("its clauses are {}", listed(Group::PlacedRotor))))
}

/// "`at`, `spin` and `time_constant`"
fn listed(group: Group) -> String {
    let form = |word| if word == waypoint::ARRIVE.name { "`arrive from`".into() } else { format!("`{word}`") };
    let quoted: Vec<String> = group.names().map(form).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

/// `waypoint at [..] m speed 3 m/s`
pub(super) fn of_waypoint(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    if !matches!(statement.word(), "waypoint" | "start") {
        return None;
    }
    let (from, before) = statement.before(failure.at);
    let is_value = found.starts_with(|c: char| c.is_ascii_digit());
    if let ("straight" | "vertical" | "stop", true) = (before, is_value) {
        let message = format!("`{before}` takes no value");
        let error = Diagnostic::error(
            "mavc::syntax::unexpected",
            statement.span(failure.at, failure.at + found.len()),
            message,
        );
        let error = error.here("a value");
        return Some(match before {
            "stop" => error.help("write `hold 3 s` on the next line to stay there"),
            _ => error
                .help("write `corridor` for a radius of its own")
                .fix(statement.span(from, from + before.len()), "corridor"),
        });
    }
    let is_word = found.starts_with(|c: char| c.is_ascii_alphabetic());
    if !failure.expects(Expected::Clause) || !is_word || nearest(found, clauses()).is_some() {
        return None;
    }
    let follows_value = failure.expects(Expected::End);
    let own = listed(Group::Waypoint);
    let diagnostic = super::wording::unexpected(
        statement,
        failure.at,
        failure.at + found.len(),
        format!("a waypoint has no `{}`", cut(found)),
    );
    let help = match found {
        "speed" | "velocity" | "altitude" | "tilt" => {
            "limits of the leg that arrives go between braces at the end, as in `{ speed <= 3 m/s }`; those of the \
             whole mission \
             into `limits { .. }`"
                .to_string()
        }
        "heading" | "course" | "bearing" => {
            "write it as `yaw`, counter-clockwise from east: a compass heading h is `yaw 90 deg - h`".to_string()
        }
        "hold" | "wait" | "for" => format!("clauses are {own}; `hold 3 s` is a statement on the next line"),
        _ => format!("clauses are {own}"),
    };
    follows_value.then(|| diagnostic.here("not a clause of a waypoint").help(help))
}
