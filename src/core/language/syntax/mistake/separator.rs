//! Statements on one line without `;` between them: `mass = 1 kg  arm = 0.2 m`.

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, is_clause};
use crate::syntax::cut;

/// Most statements separated on one line.
const MAX_SEPARATIONS: usize = 64;

/// The places in a line where a statement plainly ends and another begins. `failure` reads a statement alone by the
/// rule it was probably meant to follow; `None` where nothing is wrong with it.
pub(in crate::language::syntax) fn separations(
    line: &Broken,
    failure: impl Fn(&str, bool) -> Option<Failure>,
) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut from = 0;
    while found.len() < MAX_SEPARATIONS {
        let text = &line.text[from..];
        let rest = Broken { text, start: line.start + from, ..*line };
        let Some(fails) = failure(text, line.has_body) else { break };
        let Some((at, next)) = split(&rest, &fails, &failure) else { break };
        found.push(error(&rest, at, next));
        from += next;
    }
    found
}

/// Where the `;` goes, and where the next statement begins, if one does where this one fails.
fn split(
    statement: &Broken,
    fails: &Failure,
    failure: &impl Fn(&str, bool) -> Option<Failure>,
) -> Option<(usize, usize)> {
    // A statement with a body is explained by its head.
    if Place::of_head(statement.word()).is_some_and(|block| !matches!(block, Place::Rotor | Place::Rotors)) {
        return None;
    }
    let text = statement.text;
    let found = statement.found(fails.at);
    // `within = 10 cm` after a waypoint is a clause with a mark too many.
    if found == "=" && fails.expects(Expected::Value) && is_clause(statement.before(fails.at).1) {
        return None;
    }
    // There are no fields among rotors: `tilt = 15 deg` after one is meant as a clause.
    let behind = text[fails.at..].strip_prefix(found).unwrap_or("").trim_start();
    if statement.place == Place::Rotors && statement.word() == "rotor" && behind.starts_with('=') {
        return None;
    }
    if found == "," {
        let next = fails.at + 1 + blanks(&text[fails.at + 1..]);
        let whole = fails.expects(Expected::End) && failure(&text[..fails.at], false).is_none();
        return (whole && begins(statement, next)).then_some((fails.at, next));
    }
    // After a value any word looks like its unit, so the statement may begin a word before the place where it fails.
    let (before, word) = statement.before(fails.at);
    let is_long = word.len() > 3 || matches!(word, "x" | "y" | "z" | "arm" | "yaw" | "use" | "let");
    let starts = [(fails.at, !found.is_empty()), (before, is_long)];
    starts.into_iter().filter(|(_, fits)| *fits).find_map(|(next, _)| {
        let head = text[..next].trim_end_matches([' ', '\t']);
        // `where` awaits a condition, though it would do as a name.
        let apart = head.len() < next && !head.is_empty() && !head.ends_with("where");
        let whole = || failure(head, false).is_none();
        (apart && begins(statement, next) && whole()).then_some((head.len(), next))
    })
}

/// Whether the text at `at` can only begin a statement here: `name =`, or a keyword of this place.
fn begins(statement: &Broken, at: usize) -> bool {
    let word = token(statement.text, at, is_name);
    if !word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        return false;
    }
    let rest = statement.text[at + word.len()..].trim_start_matches([' ', '\t']);
    let place = statement.place;
    let in_limits = place.has_limits() && (rest.starts_with("in ") || rest.starts_with(['<', '>']));
    let opens = place.openers().contains(&word) && !rest.starts_with(['+', '-', '*', '/', '^', ')', ',']);
    let is_field = rest.starts_with('=') && !["==", "=>", "=<"].iter().any(|mark| rest.starts_with(mark));
    is_field || in_limits || opens && (!rest.is_empty() || statement.has_body)
}

fn error(statement: &Broken, at: usize, next: usize) -> Diagnostic {
    let word = token(statement.text, next, is_name);
    let code = "mavc::syntax::separator";
    let diagnostic = match statement.text[at..].starts_with(',') {
        true => Diagnostic::error(code, statement.span(at, at + 1), "statements are not separated by commas")
            .here("another statement follows")
            .fix(statement.span(at, at + 1), ";"),
        false => {
            let span = statement.span(next, next + word.len());
            Diagnostic::error(code, span, "two statements need a new line or `;` between them")
                .here(format!("`{}` begins a statement of its own", cut(word)))
                .fix(statement.span(at, at), ";")
        }
    };
    diagnostic.help(format!("write `;` before `{}`, or begin a new line", cut(word)))
}

fn blanks(text: &str) -> usize {
    text.len() - text.trim_start_matches([' ', '\t']).len()
}
