//! What is wrong with a statement that cannot be read, in its author's terms.
//!
//! [`explain`] first looks for mistakes that people often make (`habit`: words and marks of other languages, blanks in
//! units, misspelt words). Any other mistake is explained by what was expected and what was found.

mod block;
mod habit;
mod separator;

pub(super) use block::{check_head, misplaced, rotors_without_s, unknown_block};
pub(super) use separator::separations;

use super::cut;
use super::scan::{self, is_name};
use crate::diagnostic::Diagnostic;
use crate::language::Place;
use crate::source::{FileId, Span};

/// What could follow where a statement fails, in the order of the message.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Expected {
    Equals,
    Relation,
    Name,
    Text,
    Value,
    Word(&'static str),
    Effect,
    Clause,
    Unit,
    Operator,
    Comma,
    Closing(char),
    End,
}

/// Where a statement fails (bytes from its start) and what could follow there, sorted.
pub(super) struct Failure {
    pub at: usize,
    pub expected: Vec<Expected>,
}

impl Failure {
    fn expects(&self, expected: Expected) -> bool {
        self.expected.contains(&expected)
    }
}

/// A statement that cannot be read.
pub(super) struct Broken<'a> {
    pub file: FileId,
    /// The statement, or its head where it has a body.
    pub text: &'a str,
    /// Where it starts in the file.
    pub start: usize,
    pub place: Place,
    pub has_body: bool,
    /// The blanks before the `{` that is the next thing in the file, if it is one.
    pub brace_below: Option<&'a str>,
}

impl Broken<'_> {
    fn span(&self, from: usize, to: usize) -> Span {
        Span::new(self.file, self.start + from, self.start + to)
    }

    /// The statement's first word; empty where it begins with something else.
    fn word(&self) -> &str {
        scan::name(self.text)
    }

    /// What is at `at`: a word, a number, a text, or a run of marks that looks like one operator.
    fn found(&self, at: usize) -> &str {
        let rest = &self.text[at.min(self.text.len())..];
        let Some(first) = rest.chars().next() else {
            return "";
        };
        match first {
            c if is_name(c) => token(self.text, at, |c| is_name(c) || c == '.').trim_end_matches('.'),
            '"' => rest[1..].find('"').map_or("\"", |i| &rest[..i + 2]),
            c if "=<>:!&|".contains(c) => token(self.text, at, |c| "=<>:!&|".contains(c)),
            '.' if rest.starts_with("..") => "..",
            '+' | '-' | '*' | '/' if rest[1..].starts_with('=') => &rest[..2],
            c => &rest[..c.len_utf8()],
        }
    }

    /// The last word, text or mark before `at`, and where it starts.
    fn before(&self, at: usize) -> (usize, &str) {
        let text = self.text[..at].trim_end();
        if text.ends_with("..") {
            return (text.len() - 2, "..");
        }
        if let Some(quote) = text.strip_suffix('"').and_then(|t| t.rfind('"')) {
            return (quote, &text[quote..]);
        }
        let word =
            text.rfind(|c: char| !is_name(c)).map_or(0, |i| i + text[i..].chars().next().map_or(1, char::len_utf8));
        // A number is one word, decimal point and all.
        let whole = text[..word].strip_suffix('.').map(|t| t.trim_end_matches(|c: char| c.is_ascii_digit()).len());
        let is_fraction = text[word..].starts_with(|c: char| c.is_ascii_digit());
        let word = whole.filter(|&w| is_fraction && w + 1 < word).unwrap_or(word);
        let start = if word < text.len() { word } else { text.char_indices().next_back().map_or(0, |(i, _)| i) };
        (start, &text[start..])
    }

    /// The word to blame and where it starts: what is found where the statement fails, or the word before that was read
    /// as the unit of a number that takes none.
    fn culprit(&self, failure: &Failure) -> (usize, &str) {
        let (start, before) = self.before(failure.at);
        let takes_no_unit = failure.expects(Expected::Effect) || failure.expects(Expected::Word("rotors"));
        let is_word = before.starts_with(|c: char| c.is_ascii_alphabetic());
        let follows_number = self.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || c == ']');
        match takes_no_unit && is_word && follows_number && !matches!(before, "rotor" | "rotors") {
            true => (start, before),
            false => (failure.at, self.found(failure.at)),
        }
    }
}

/// One error for the statement.
pub(super) fn explain(statement: &Broken, failure: &Failure) -> Diagnostic {
    block::headless(statement)
        .or_else(|| habit::recognise(statement, failure))
        .unwrap_or_else(|| general(statement, failure))
}

/// By what was expected and what was found.
fn general(statement: &Broken, failure: &Failure) -> Diagnostic {
    let (start, found) = statement.culprit(failure);
    let (_, before) = statement.before(start);
    let after = if before.is_empty() { String::new() } else { format!(" after `{}`", cut(before)) };
    let mut due = failure.expected.clone();
    // Of all blocks only a mode has a title.
    due.retain(|e| !(statement.has_body && statement.word() != "mode" && *e == Expected::Text));
    let wanted = list(&due, statement.has_body);
    if found.is_empty() {
        let at = statement.text.len();
        let value_only = failure.expects(Expected::Value);
        let (code, wanted) = match value_only {
            true => ("mavc::syntax::missing_value", "a value".to_string()),
            false => ("mavc::syntax::unexpected", wanted),
        };
        // The end of a line is marked under its last character.
        let from = statement.text.char_indices().next_back().map_or(0, |(i, _)| i);
        let diagnostic = Diagnostic::error(code, statement.span(from, at), format!("{wanted} is missing{after}"))
            .here(format!("{wanted} must follow"));
        let diagnostic = match failure.expected.as_slice() {
            [Expected::Word("as")] if statement.word() == "every" => diagnostic.fix(statement.span(at, at), " as M"),
            _ => diagnostic,
        };
        return with_form(diagnostic, statement);
    }
    let span = statement.span(start, start + found.len());
    let message = format!("expected {wanted}{after}, found `{}`", cut(found));
    let only_end = failure.expected.iter().all(|e| matches!(e, Expected::End | Expected::Operator | Expected::Unit));
    let diagnostic = Diagnostic::error("mavc::syntax::unexpected", span, message).here("this does not fit here");
    let is_field = form(statement.word(), statement.place).is_none();
    if only_end && is_field && !statement.has_body && found.starts_with(|c: char| is_name(c) || "\",".contains(c)) {
        return diagnostic.help("a line holds one statement: begin a new line, or write `;` between two");
    }
    let diagnostic = with_form(diagnostic, statement);
    match (statement.word(), before) {
        ("end", "end") if found == "at" || found.starts_with('[') => {
            let at = if found == "at" { "" } else { " at" };
            diagnostic
                .help("write `waypoint` for `end`: a mission ends at its last waypoint")
                .fix(statement.span(0, "end".len()), format!("waypoint{at}"))
        }
        (_, "reduced") if found == "by" => {
            diagnostic.help("write the share that remains: a tenth lost is `reduced to 90 %`")
        }
        _ => diagnostic,
    }
}

fn with_form(diagnostic: Diagnostic, statement: &Broken) -> Diagnostic {
    let form = match form(statement.word(), statement.place) {
        Some(FAULT) if statement.text.contains("reduced") => Some("rotor 3 reduced to 60 %"),
        Some(FAULT) if statement.text.contains("stuck") => Some("rotor 2 stuck at 50 %"),
        form => form,
    };
    match form {
        Some(form) => diagnostic.help(format!("write it like `{form}`")),
        None if diagnostic.code == "mavc::syntax::missing_value" => {
            diagnostic.help("write the value, or remove the rest")
        }
        None => diagnostic,
    }
}

const FAULT: &str = "rotors [1, 6] lost";

/// An example of the statement that begins with `word`.
fn form(word: &str, place: Place) -> Option<&'static str> {
    Some(match word {
        "use" => "use \"vehicles/octo.mav\"",
        "let" => "let a = 4 m",
        "vehicle" => "vehicle octo { .. }",
        "mission" => "mission survey { .. }",
        "faults" => "faults { .. }",
        "plan" => "plan { .. }",
        "simulate" => "simulate { .. }",
        "campaign" => "campaign { .. }",
        "fault" => "fault M1 at 5 s",
        "every" => "every 1 rotor lost as M",
        "mode" => "mode M1_6 \"left and right-rear\" { rotors [1, 6] lost }",
        "curve" => "curve s in 0 .. 2*pi, points = 21 { .. }",
        "start" => "start at [0, 0, 2] m  yaw 90 deg",
        "end" => "end moving",
        "waypoint" => "waypoint tower at [12, 3, 18] m  within 10 cm",
        "waypoints" => "waypoints from \"survey.csv\"",
        "hold" => "hold 4 s",
        "require" => "require risk <= 1e-6",
        "part" => "part battery { mass = 1.1 kg; at = [0, 0, -3] cm }",
        "landing_site" => "landing_site pad { at = [12, -8, 0] m; radius = 2 m }",
        "keep_off" => "keep_off street { shape = box; from = [0, 0] m; to = [40, 6] m }",
        "after_fault_limits" => "after_fault_limits { tilt <= 45 deg }",
        "recovery" if matches!(place, Place::Mode | Place::Every) => "recovery = [continue, land_here]",
        "recovery" => "recovery { within = 20 s }",
        "rotor" if matches!(place, Place::Rotors | Place::Vehicle) => "rotor at [0.2, 0.15, 0] m  spin P",
        "rotor" | "rotors" => FAULT,
        _ if place.has_limits() => "speed <= 8 m/s` or `altitude in 1 m .. 30 m",
        _ => return None,
    })
}

/// "`=`, a name or the end of the statement".
fn list(expected: &[Expected], has_body: bool) -> String {
    // That a value may also be a text, or continue, is mentioned only where nothing else is expected.
    let due = |e: &Expected| {
        matches!(e, Expected::Word(_) | Expected::Effect | Expected::Clause | Expected::Comma | Expected::Closing(_))
    };
    let more_is_due = expected.iter().any(due);
    let mut words: Vec<String> = expected
        .iter()
        .filter(|e| !(matches!(e, Expected::Text) && expected.contains(&Expected::Value)))
        .filter(|e| !(matches!(e, Expected::Unit | Expected::Operator) && more_is_due))
        .flat_map(|e| phrases(e, has_body))
        .collect();
    words.dedup();
    match words.split_last() {
        None => "something else".to_string(),
        Some((last, [])) => last.to_string(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
    }
}

/// The words for one expectation.
fn phrases(expected: &Expected, has_body: bool) -> Vec<String> {
    let words: &[&str] = match expected {
        Expected::Word(word) => return vec![format!("`{word}`")],
        Expected::Closing(bracket) => return vec![format!("`{bracket}`")],
        Expected::Equals => &["`=`"],
        Expected::Relation => &["`<=`", "`>=`"],
        Expected::Name => &["a name"],
        Expected::Text => &["a text in double quotes"],
        Expected::Value => &["a value"],
        Expected::Effect => &["`lost`", "`reduced to`", "`stuck at`"],
        Expected::Clause => &["a clause"],
        Expected::Unit => &["a unit"],
        Expected::Operator => &["an operator"],
        Expected::Comma => &["`,`"],
        Expected::End if has_body => &["`{`"],
        Expected::End => &["the end of the statement"],
    };
    words.iter().map(ToString::to_string).collect()
}

/// The run of accepted characters that starts at `at`.
fn token(text: &str, at: usize, accept: impl Fn(char) -> bool) -> &str {
    scan::run(&text[at..], accept)
}
