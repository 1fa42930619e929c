//! Positions, ranges and lists of names with other marks around them or between them, or without marks.

use super::wording::unexpected;
use super::{Broken, Expected, Failure, is_name};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, is_clause};
use crate::syntax::cut;

/// `start at (0, 0, 2) m`
pub(super) fn position_in_parentheses(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if statement.found(failure.at) != "," || !failure.expects(Expected::Closing(')')) {
        return None;
    }
    // No bracket between the parenthesis and the comma, or the comma would belong to another bracket.
    let open =
        statement.text[..failure.at].rfind(['(', ')', '[', ']']).filter(|&i| statement.text[i..].starts_with('('))?;
    let diagnostic = unexpected(statement, open, open + 1, "a list takes `[ ]`, not `( )`");
    let diagnostic = diagnostic.here("opens an expression, which has no commas");
    let diagnostic = diagnostic.help("write `[x, y, z]` and the unit after it");
    let inside = &statement.text[open + 1..];
    Some(match inside.find(['(', ')', '[', ']']).filter(|&i| inside[i..].starts_with(')')) {
        Some(length) => {
            let span = statement.span(open, open + length + 2);
            diagnostic.fix(span, format!("[{}]", &inside[..length]))
        }
        None => diagnostic,
    })
}

/// `waypoint at 0, 8, 5 m`
pub(super) fn position_without_brackets(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !matches!(statement.word(), "waypoint" | "start") || statement.found(failure.at) != "," {
        return None;
    }
    let at = statement.text[..failure.at].rfind(" at ").map(|at| at + " at ".len())?;
    let rest = &statement.text[at..];
    // The clauses that follow are no coordinates.
    let words = rest.split([' ', '\t']).map(|word| (word.as_ptr() as usize - rest.as_ptr() as usize, word));
    let clause = words.filter(|(_, word)| is_clause(word)).map(|(start, _)| start).next();
    let written = rest[..clause.unwrap_or(rest.len())].trim_end();
    let parts: Vec<&str> = written.split(',').map(str::trim).collect();
    let [x, y, z] = parts[..] else { return None };
    if parts.iter().any(|part| part.is_empty() || part.contains(['[', ']', '(', ')'])) {
        return None;
    }
    // A unit after the last applies to all where the others have none.
    let (z, unit) = match z.split_once([' ', '\t']).filter(|_| !x.contains(' ') && !y.contains(' ')) {
        Some((z, unit)) => (z, unit.trim_start()),
        None => (z, "m"),
    };
    let fixed = format!("[{x}, {y}, {z}] {unit}");
    let span = statement.span(at, at + written.len());
    let error = Diagnostic::error("mavc::syntax::unexpected", span, "a position is a list in `[ ]`");
    Some(error.here("three values without brackets").help(format!("write `at {}`", cut(&fixed))).fix(span, fixed))
}

/// `altitude in (1, 30) m`
pub(super) fn range_in_parentheses(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (name, range) = statement.text.split_once(" in ").filter(|_| statement.place == Place::Limits)?;
    let at = statement.text.len() - range.trim_start().len();
    let (ends, unit) = range.trim_start().strip_prefix('(')?.split_once(')')?;
    let (low, high) = ends.split_once(',')?;
    if statement.found(failure.at) != "," || high.contains(',') || !name.chars().all(is_name) {
        return None;
    }
    let fixed = format!("{} .. {}{}", low.trim(), high.trim(), unit.trim_end());
    let end = statement.text.trim_end().len();
    let error = Diagnostic::error(
        "mavc::syntax::range",
        statement.span(at, end),
        "a range is written with `..`, not with a comma in `( )`",
    );
    Some(
        error
            .here("not a range")
            .help(format!("write `{name} in {}`", cut(&fixed)))
            .fix(statement.span(at, end), fixed),
    )
}

/// `against = [M1 worn]`: modes and planners have no units, so a name after a name is another one.
pub(super) fn listed_names(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (field, list) = statement.text.split_once('=')?;
    if !matches!(field.trim(), "against" | "planners") || !failure.expects(Expected::Operator) {
        return None;
    }
    let start = statement.text.len() - list.trim_start().len();
    let inside = list.trim().strip_prefix('[')?.strip_suffix(']')?;
    let names: Vec<&str> = inside.split([',', ' ', '\t', '\n']).filter(|name| !name.is_empty()).collect();
    if !names.iter().all(|name| name.chars().all(is_name)) {
        return None;
    }
    let found = statement.found(failure.at);
    // `W1 to W4` is a range.
    let fixed = format!("[{}]", names.join(", ")).replace(", to, ", " .. ");
    if fixed.contains("..") {
        let span = statement.span(failure.at, failure.at + found.len());
        let error = Diagnostic::error("mavc::syntax::range", span, "a range is written with `..`, not `to`")
            .here("expected `..`");
        let whole = statement.span(start, statement.text.trim_end().len());
        return Some(error.help(format!("write `{}`", cut(&fixed))).fix(whole, fixed));
    }
    Some(
        unexpected(statement, failure.at, failure.at + found.len(), "a comma is missing between two elements")
            .here("expected `,` before this")
            .help(format!("write `{}`", cut(&fixed)))
            .fix(statement.span(start, statement.text.trim_end().len()), fixed),
    )
}
