//! Mistakes about `fault M1_6 at 5 s until 9 s` in `simulate`.

use super::{Broken, Expected, Failure, cut, is_name};
use crate::diagnostic::{Diagnostic, nearest};

const LIKE: &str = "write it like `fault M1 at 5 s`";

pub(super) fn recognise(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if statement.word() != "fault" || statement.has_body {
        return None;
    }
    let (_, before) = statement.before(failure.at);
    if before == "fault" {
        return mode(statement, failure);
    }
    let clauses = statement.text[..failure.at].split(|c: char| !is_name(c)).any(|word| matches!(word, "at" | "until"));
    if failure.expects(Expected::Clause) && !clauses { instant(statement, failure) } else { clause(statement, failure) }
}

fn error(statement: &Broken, from: usize, length: usize, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("mavc::syntax::unexpected", statement.span(from, from + length), message)
}

/// What follows `fault` is not a name: nothing, `at 5 s`, `"M1"`, `[M1, M2]`, `1`.
fn mode(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (at, found) = (failure.at, statement.found(failure.at));
    Some(match found.chars().next() {
        None => error(statement, 0, "fault".len(), "`fault` names no fault mode")
            .here("the name of a fault mode must follow")
            .help(LIKE),
        Some('"') => {
            let name = found.trim_matches('"');
            let diagnostic = error(statement, at, found.len(), "a fault mode is named without quotes").here("a text");
            match !name.is_empty() && name.chars().all(is_name) {
                true => {
                    diagnostic.help(format!("write `{}`", cut(name))).fix(statement.span(at, at + found.len()), name)
                }
                false => diagnostic.help(LIKE),
            }
        }
        Some('[') => error(statement, at, 1, "`fault` names one mode, not a list")
            .here("opens a list")
            .help("write a `fault` for each, or declare a mode in which all of them fail"),
        Some(c) if c.is_ascii_digit() => error(statement, at, found.len(), "`fault` names a fault mode, not a rotor")
            .here("not a name")
            .help("declare a mode in `faults`, as in `mode M1 { rotor 1 lost }`, and name it here"),
        Some(c) if is_name(c) => error(statement, at, found.len(), "`fault` names no fault mode")
            .here("expected the name of a fault mode before this")
            .help(LIKE),
        Some(_) => return None,
    })
}

/// No time follows the mode: `fault M1`, `fault M1 5 s`, `fault M1 after 5 s`, `fault M1, M2 at 5 s`,
/// `fault rotor 1 lost`.
fn instant(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (at, found) = (failure.at, statement.found(failure.at));
    let (start, name) = statement.before(at);
    if matches!(name, "rotor" | "rotors") {
        return Some(
            error(statement, start, name.len(), "`fault` names a fault mode, not a rotor")
                .here("no fault mode")
                .help("declare a mode in `faults`, as in `mode M1 { rotor 1 lost }`, and name it here"),
        );
    }
    if found.is_empty() {
        let message = format!("`fault {}` has no time", cut(name));
        let diagnostic = error(statement, start, name.len(), message).here("`at` and a time must follow");
        let end = start + name.len();
        let diagnostic = diagnostic.help(format!("write `fault {} at 5 s`", cut(name)));
        return Some(diagnostic.fix(statement.span(end, end), " at 5 s"));
    }
    if matches!(found, "," | "and" | "&" | "&&" | "+") {
        return Some(
            error(statement, at, found.len(), "`fault` names one mode")
                .here("does not join modes")
                .help("write a `fault` for each, or declare a mode in which all of them fail"),
        );
    }
    if matches!(found, "after" | "from" | "when" | "on" | "in" | "time" | "@" | "=" | ":") {
        return Some(instead(statement, at, found, "at", "the time of a fault is written with `at`"));
    }
    if found.starts_with(|c: char| c.is_ascii_digit() || c == '(') {
        return Some(
            error(statement, at, found.len(), "a fault's time has no `at` before it")
                .here("expected `at` before this")
                .help("write `at` before the time")
                .fix(statement.span(at, at), "at "),
        );
    }
    None
}

/// After a clause: `fault M1 at 5 s to 9 s`, `fault M1 at 5 s for 4 s`, `fault M1 at 5 s severity 3`.
fn clause(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (at, found) = (failure.at, statement.found(failure.at));
    if !failure.expects(Expected::Clause) {
        return None;
    }
    if matches!(found, "to" | "till" | "til" | "through" | "recovers") {
        return Some(instead(statement, at, found, "until", "the end of a fault is written with `until`"));
    }
    if matches!(found, "for" | "lasting" | "during") {
        return Some(
            error(statement, at, found.len(), format!("a fault has no `{found}`"))
                .here("not a clause of a fault")
                .help("write when it ends, not how long it lasts, as in `at 5 s until 9 s`"),
        );
    }
    let is_word = found.starts_with(|c: char| c.is_ascii_alphabetic());
    (is_word && nearest(found, ["at", "until"]).is_none()).then(|| {
        error(statement, at, found.len(), format!("a fault has no `{}`", cut(found)))
            .here("not a clause of a fault")
            .help("clauses are `at`, when it strikes, and `until`, when it ends")
    })
}

/// `found` in place of `ours`.
fn instead(statement: &Broken, at: usize, found: &str, ours: &str, message: &str) -> Diagnostic {
    error(statement, at, found.len(), message)
        .here(format!("expected `{ours}`"))
        .help(format!("write `{ours}`"))
        .fix(statement.span(at, at + found.len()), ours)
}
