//! Taking off and landing: a mission begins at its `start` and ends at its last waypoint.

use super::{Broken, Failure, is_name, token};
use crate::diagnostic::Diagnostic;
use crate::language::Place;
use crate::source::Span;
use crate::syntax::cut;

const LANDINGS: [&str; 2] = ["land", "touchdown"];
const TAKEOFFS: [&str; 3] = ["takeoff", "take_off", "liftoff"];

/// Whether a word begins a statement of missions in other languages.
pub(in crate::language::syntax) fn is_foreign(word: &str) -> bool {
    LANDINGS.contains(&word) || TAKEOFFS.contains(&word)
}

/// `land`, `land at [6, 4, 0] m`
pub(super) fn landing(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let rest = statement_of(statement, &LANDINGS)?;
    let error = unknown(statement).here("a mission ends at its last waypoint");
    Some(match token(rest, 0, is_name) {
        _ if rest.is_empty() => error.help("remove it").fix(line(statement), ""),
        "at" => error.help("write `waypoint`").fix(first_word(statement), "waypoint"),
        _ => error.help("write it like `waypoint at [6, 4, 1] m`"),
    })
}

/// `takeoff`, `takeoff 2 m`, `takeoff to 2 m`
pub(super) fn takeoff(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let rest = statement_of(statement, &TAKEOFFS)?;
    let error = unknown(statement);
    if token(rest, 0, is_name) == "at" {
        return Some(error.here("did you mean `start`?").help("write `start`").fix(first_word(statement), "start"));
    }
    let error = error.here("a mission begins at its `start`");
    let [before, behind] = statement.around;
    if token(behind.trim_start(), 0, is_name) == "start" {
        return Some(error.help("remove it").fix(line(statement), ""));
    }
    let is_first = before.trim_end().ends_with('{');
    Some(match height(rest).filter(|_| is_first) {
        Some((number, unit)) => {
            let fixed = format!("start at [0, 0, {number}] {unit}");
            let whole = statement.span(0, statement.text.len());
            error.help(format!("write `{}`", cut(&fixed))).fix(whole, fixed)
        }
        None => error.help("write where it begins, as in `start at [0, 0, 2] m`"),
    })
}

/// What follows the first word, where it is one of `words` in a mission.
fn statement_of<'a>(statement: &'a Broken, words: &[&str]) -> Option<&'a str> {
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    let fits = statement.place == Place::Mission && !statement.has_body && words.contains(&word);
    (fits && !rest.starts_with(['=', ':'])).then_some(rest)
}

fn unknown(statement: &Broken) -> Diagnostic {
    let message = format!("no statement of a `mission` begins with `{}`", cut(statement.word()));
    Diagnostic::error("mavc::syntax::unknown_statement", first_word(statement), message)
}

fn first_word(statement: &Broken) -> Span {
    statement.span(0, statement.word().len())
}

/// The statement, with its line if it is alone on it.
fn line(statement: &Broken) -> Span {
    let span = statement.span(0, statement.text.len());
    let [before, behind] = statement.around;
    match before.trim_end_matches([' ', '\t']).strip_suffix('\n') {
        Some(above) if behind.starts_with('\n') => Span { start: above.len() as u32, ..span },
        _ => span,
    }
}

/// `2 m`, `to 2 m`
fn height(text: &str) -> Option<(&str, &str)> {
    let text = text.strip_prefix("to ").unwrap_or(text).trim();
    let number = token(text, 0, |c| c.is_ascii_digit() || c == '.');
    let unit = text[number.len()..].trim_start();
    let is_unit = !unit.is_empty() && unit.chars().all(|c| c.is_ascii_alphabetic());
    (number.parse::<f64>().is_ok() && number.ends_with(|c: char| c.is_ascii_digit()) && is_unit)
        .then_some((number, unit))
}
