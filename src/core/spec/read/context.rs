//! The state of elaboration: the diagnostics found so far, the `let`s, and the remaining evaluation budget.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use super::allow::Allowed;
use super::edits;
use super::expression::Value;
use super::understanding::{FromTable, Reading};
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::{SourceMap, Span};
use crate::syntax::ast::{Block, Field, FieldValue, Name};
use crate::unit::{GRAVITY, Quantity};

/// Evaluation steps one spec may take; a guard against hostile input.
pub(super) const MAX_STEPS: u32 = 20_000_000;
/// How deep expressions may be nested, counted through `let`s.
pub(super) const MAX_EVALUATION_DEPTH: u32 = 600;

/// Diagnostics shown for one spec.
pub(super) const MAX_DIAGNOSTICS: usize = 500;

pub(super) const FUNCTIONS: [&str; 11] =
    ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "abs", "min", "max"];
pub(super) const CONSTANTS: [&str; 2] = ["pi", "g0"];

pub(super) struct Context<'a> {
    pub sources: &'a SourceMap,
    pub diagnostics: Vec<Diagnostic>,
    /// g, m/s^2.
    pub gravity: f64,
    /// Some file could not be loaded: what seems to be missing may be declared there.
    pub incomplete: bool,
    /// Some fault modes have unknown names, because the statement that declares them has an error.
    pub modes_unnamed: bool,
    /// Every word of the statements that could not be parsed.
    lost_words: BTreeSet<Cow<'a, str>>,
    /// Warnings that `allow` suppresses.
    pub(super) allowed: Allowed,
    /// Diagnostics past the limit.
    pub dropped: usize,
    /// Those past the limit that concern blocks which this command does not use.
    pub dropped_softly: usize,
    /// Some error was downgraded to a warning, because its block is not used.
    pub softened: bool,
    /// The values read so far with their places, for editors.
    pub readings: Vec<Reading>,
    /// The numbers of the thrust tables read so far, for editors.
    pub from_tables: Vec<FromTable>,
    pub(super) lets: BTreeMap<&'a str, Let<'a>>,
    /// The index in `diagnostics` of the first report of a wrong use of a `let`, by its name and what was expected.
    pub(super) accused: BTreeMap<(&'a str, String), usize>,
    /// The parameter of the curve being evaluated, and its value.
    pub(super) parameter: Option<(&'a str, Quantity)>,
    /// The unit that the number being read takes, by where its own stands.
    pub(super) unit_due: Option<(Span, &'static str)>,
    pub(super) depth: u32,
    pub(super) steps: u32,
}

pub(super) struct Let<'a> {
    pub field: &'a Field,
    pub state: State,
    pub used: bool,
}

/// The evaluation state of a `let`; `Done(None)` means that its error has been reported.
#[derive(Clone)]
pub(super) enum State {
    Waiting,
    Busy,
    Done(Option<Value>),
}

impl<'a> Context<'a> {
    pub fn new(sources: &'a SourceMap, incomplete: bool, broken: &[Span]) -> Self {
        let between = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        let words = broken.iter().flat_map(|&span| sources.snippet(span).split(between));
        Context {
            sources,
            diagnostics: Vec::new(),
            gravity: GRAVITY,
            incomplete,
            modes_unnamed: false,
            lost_words: words.map(Cow::Borrowed).collect(),
            allowed: Allowed::default(),
            dropped: 0,
            dropped_softly: 0,
            softened: false,
            readings: Vec::new(),
            from_tables: Vec::new(),
            lets: BTreeMap::new(),
            accused: BTreeMap::new(),
            parameter: None,
            unit_due: None,
            depth: 0,
            steps: 0,
        }
    }

    /// Adds a diagnostic unless `allow` suppresses it; beyond [`MAX_DIAGNOSTICS`] it is only counted.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        if self.allowed.silences(&diagnostic) {
            return;
        }
        if self.is_full() {
            self.dropped += 1;
        } else {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Whether further diagnostics are only counted, so that their texts need not be computed.
    pub fn is_full(&self) -> bool {
        self.diagnostics.len() >= MAX_DIAGNOSTICS
    }

    /// Whether `name` may be declared in a place that could not be parsed.
    pub fn may_exist(&self, name: &str) -> bool {
        self.incomplete || self.lost_words.contains(name)
    }

    /// Suppresses "unknown name" errors for `name`, whose declaration has an error.
    pub fn lose(&mut self, name: impl Into<Cow<'a, str>>) {
        self.lost_words.insert(name.into());
    }

    /// Registers every `let`. A second `let` of the same name and a built-in name are errors.
    pub fn declare(&mut self, fields: impl Iterator<Item = &'a Field>) {
        for field in fields {
            let name = &field.name;
            if CONSTANTS.contains(&name.value.as_str()) || FUNCTIONS.contains(&name.value.as_str()) {
                let message = format!("`{}` is a built-in name and cannot be redefined by `let`", name.value);
                self.report(
                    Diagnostic::error("mavc::name::reserved", name.span, message)
                        .here("reserved name")
                        .help(format!("choose another name, such as `my_{}`", name.value)),
                );
            } else if let Some(first) = self.lets.get(name.value.as_str()) {
                let first = first.field.name.span;
                self.report(duplicate("`let`", name, first));
            } else {
                self.lets.insert(&name.value, Let { field, state: State::Waiting, used: false });
            }
        }
    }

    /// Evaluates every `let`, so that errors in unused ones are found too.
    pub fn settle(&mut self) {
        let names: Vec<&'a str> = self.lets.keys().copied().collect();
        for name in names {
            self.settle_let(name);
        }
    }

    /// The value of a declared `let`, evaluated on first use; `None` where it has an error.
    pub(super) fn settle_let(&mut self, name: &'a str) -> Option<Value> {
        let entry = self.lets.get_mut(name)?;
        match entry.state.clone() {
            State::Done(value) => value,
            State::Busy => {
                entry.state = State::Done(None);
                let span = entry.field.name.span;
                self.report(
                    Diagnostic::error("mavc::name::cycle", span, format!("`{name}` is defined in terms of itself"))
                        .here("its value depends on itself")
                        .help("give one `let` of the cycle a value that does not depend on the others"),
                );
                None
            }
            State::Waiting => {
                entry.state = State::Busy;
                let field = entry.field;
                let value = match &field.value {
                    FieldValue::Expr(expr) => self.evaluate(expr),
                    FieldValue::Where { field, .. } => {
                        self.report(no_filter(field.span));
                        None
                    }
                };
                if let (FieldValue::Expr(expr), Some(value)) = (&field.value, &value) {
                    self.note_value(expr.span, value);
                }
                let entry = self.lets.get_mut(name)?;
                // A cycle found during evaluation has settled this `let` already.
                let value = if matches!(entry.state, State::Busy) { value } else { None };
                entry.state = State::Done(value.clone());
                value
            }
        }
    }

    /// Warns of every `let` that was never evaluated for a use.
    pub fn warn_unused(&mut self) {
        let unused: Vec<&Field> = self.lets.values().filter(|l| !l.used).map(|l| l.field).collect();
        for Field { name, doc, span, .. } in unused {
            let message = format!("`{}` is never used", name.value);
            let warning = Diagnostic::warning("mavc::name::unused", name.span, message).here("nothing refers to it");
            let warning = warning.help("use it or remove it");
            // Its doc comment would then describe the next statement, so there is no fix for one that has a comment.
            self.report(match doc {
                None => warning.fix(edits::removal(self.sources.get(span.file), *span), ""),
                Some(_) => warning,
            });
        }
    }

    /// Reports an unknown `name`, unless it may be declared where the text could not be parsed.
    pub fn unknown(&mut self, what: &str, name: &str, span: Span, known: &[&str]) {
        self.unknown_among(what, name, span, known, |_| true);
    }

    /// Reports an unknown `name`, unless it may be declared where the text could not be parsed; suggests only those
    /// `known` names for which `open` holds.
    pub fn unknown_among(&mut self, what: &str, name: &str, span: Span, known: &[&str], open: impl Fn(&str) -> bool) {
        if self.may_exist(name) {
            return;
        }
        // The search for similar names takes time, and nobody reads hundreds of errors.
        let known = if self.is_full() { &[] } else { known };
        let message =
            if what == "`let`" { format!("unknown name `{name}`") } else { format!("unknown {what} `{name}`") };
        let mut error = Diagnostic::error("mavc::name::unknown", span, message).here("not declared");
        if let Some(near) = nearest(name, known.iter().copied().filter(|k| open(k))) {
            error = error.help(format!("did you mean `{near}`?")).fix(span, near);
        } else if what == "`let`" {
            error = error.help(format!("declare it outside all blocks: `let {name} = ...`"));
        } else if !known.is_empty() {
            error = error.help(format!("use a declared name: {}", in_runs(known)));
        } else if what == "landing site" {
            let form = format!("landing_site {name} {{ at = [12, -8, 0] m; radius = 2 m }}");
            error = error.help(format!("declare it in the mission, as in `{form}`"));
        } else if what == "fault mode" {
            error = error.help(format!("declare it in `faults`, as in `mode {name} {{ rotor 1 lost }}`"));
        }
        self.report(error);
    }
}

/// `name` is declared twice.
pub(super) fn duplicate(what: &str, name: &Name, first: Span) -> Diagnostic {
    let message = match what {
        "`let`" => format!("the name `{}` is declared twice", name.value),
        _ => format!("{what} `{}` is declared twice", name.value),
    };
    Diagnostic::error("mavc::name::duplicate", name.span, message)
        .here("declared again")
        .also(first, "first declared here")
        .help("rename one of them, or remove one")
}

/// `where` in a field other than `against`.
pub(super) fn no_filter(span: Span) -> Diagnostic {
    Diagnostic::error("mavc::plan::choice", span, "`where` is allowed only in `against`")
        .here("this field takes no condition")
        .help("write a value instead")
}

/// "`a`, `b` or `c`": the words that a field accepts.
pub(super) fn either(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|w| format!("`{w}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

/// The error for the second block of a kind of which only one is allowed, as `message` says.
pub(super) fn second_block(message: String, second: &Block, first: &Block) -> Diagnostic {
    Diagnostic::error("mavc::name::duplicate", second.keyword.span, message)
        .here("second block")
        .also(first.keyword.span, "first block")
        .help("move its contents into the first block, then remove this one")
}

/// `a`, `b` and `c`, each in backquotes.
pub(super) fn listed(words: &[&str]) -> String {
    joined(&words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>())
}

/// Names in backquotes; a run of names that differ only in their numbers is given by its first and last, and a list of
/// more than twelve is cut short.
fn in_runs(names: &[&str]) -> String {
    const SHOWN: usize = 12;
    let runs = names.chunk_by(|a, b| without_digits(a) == without_digits(b));
    let mut words: Vec<String> = Vec::new();
    for run in runs {
        match run {
            [first, _, .., last] => words.push(format!("`{first}` to `{last}`")),
            few => words.extend(few.iter().map(|name| format!("`{name}`"))),
        }
    }
    if words.len() > SHOWN {
        let more = words.split_off(SHOWN - 1).len();
        words.push(format!("{more} more"));
    }
    joined(&words)
}

pub(super) fn without_digits(name: &str) -> String {
    name.chars().filter(|c| !c.is_ascii_digit()).collect()
}

/// "a, b and c"
fn joined(words: &[String]) -> String {
    match words.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => words.concat(),
    }
}
