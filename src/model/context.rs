//! What elaboration carries along: the diagnostics found so far, the `let`s, and how much work is left.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use super::allow::Allowed;
use super::blame::Suspect;
use super::expression::Value;
use super::mend;
use super::understanding::Reading;
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::{SourceMap, Span};
use crate::syntax::ast::{Block, Field, FieldValue, Name};
use crate::unit::{GRAVITY, Quantity};

/// Steps of evaluation one spec may take; a guard against hostile input.
pub(super) const MAX_STEPS: u32 = 20_000_000;
/// How deep expressions may stand inside each other, through `let`s too.
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
    /// A file could not be brought in: what seems to be missing may stand there.
    pub incomplete: bool,
    /// There are fault modes whose names nobody knows, for what makes them has an error.
    pub modes_unnamed: bool,
    /// Every word of the statements that could not be read.
    lost_words: BTreeSet<Cow<'a, str>>,
    /// Warnings that are not to be shown.
    pub(super) allowed: Allowed,
    /// Diagnostics past the limit.
    pub dropped: usize,
    /// Those past the limit that are about blocks which are not used.
    pub dropped_softly: usize,
    /// Some error was made a warning, for its block is not used.
    pub softened: bool,
    /// What was read where, for whoever shows the spec.
    pub readings: Vec<Reading>,
    pub(super) lets: BTreeMap<&'a str, Let<'a>>,
    /// Of what is wrong with uses of a `let`, by its name and what is due: the first of `diagnostics` to say so.
    pub(super) accused: BTreeMap<(&'a str, String), usize>,
    /// Uses of a `let` that may be wrong where the `let` is right.
    pub(super) suspects: Vec<Suspect<'a>>,
    /// The curve parameter and its value.
    pub(super) parameter: Option<(&'a str, Quantity)>,
    /// Whether the parameter, a plain number, is an angle in radians.
    pub(super) parameter_turns: bool,
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

/// How far a `let` has come; `Done(None)` is one whose error has been reported.
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
            lets: BTreeMap::new(),
            accused: BTreeMap::new(),
            suspects: Vec::new(),
            parameter: None,
            parameter_turns: false,
            unit_due: None,
            depth: 0,
            steps: 0,
        }
    }

    /// Keeps a diagnostic unless `allow` silences it; past [`MAX_DIAGNOSTICS`] it is only counted.
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

    /// Whether further diagnostics are only counted: what they would say need not be found out.
    pub fn is_full(&self) -> bool {
        self.diagnostics.len() >= MAX_DIAGNOSTICS
    }

    /// Whether `name` may be declared in a place that could not be read.
    pub fn may_exist(&self, name: &str) -> bool {
        self.incomplete || self.lost_words.contains(name)
    }

    /// Holds back what would be said of `name` as one that nothing declares: its declaration has an error.
    pub fn lose(&mut self, name: impl Into<Cow<'a, str>>) {
        self.lost_words.insert(name.into());
    }

    /// Takes up every `let`; a second one of a name, or a name of the language, is an error.
    pub fn declare(&mut self, fields: impl Iterator<Item = &'a Field>) {
        for field in fields {
            let name = &field.name;
            if CONSTANTS.contains(&name.value.as_str()) || FUNCTIONS.contains(&name.value.as_str()) {
                let message = format!("`{}` belongs to the language and cannot be a `let`", name.value);
                self.report(
                    Diagnostic::error("mavc::name::reserved", name.span, message)
                        .here("reserved")
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

    /// Evaluates every `let`, so that mistakes in unused ones are found too.
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
                    Diagnostic::error("mavc::name::cycle", span, format!("`{name}` is defined by itself"))
                        .here("following this value leads back here")
                        .help("give one `let` of the circle a value that needs none of the others"),
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
                // A cycle found on the way has settled this one already.
                let value = if matches!(entry.state, State::Busy) { value } else { None };
                entry.state = State::Done(value.clone());
                value
            }
        }
    }

    /// Warns of every `let` that nothing has asked for.
    pub fn warn_unused(&mut self) {
        let unused: Vec<&Field> = self.lets.values().filter(|l| !l.used).map(|l| l.field).collect();
        for Field { name, doc, span, .. } in unused {
            let message = format!("`{}` is never used", name.value);
            let warning = Diagnostic::warning("mavc::name::unused", name.span, message).here("nothing refers to it");
            let warning = warning.help("use it or take it out");
            // A comment that describes it would describe what follows.
            self.report(match doc {
                None => warning.fix(mend::removal(self.sources.get(span.file), *span), ""),
                Some(_) => warning,
            });
        }
    }

    /// The error of a second block of which there is one, with what makes one of the two where that is plain.
    pub fn joined(&self, error: Diagnostic, first: &Block, second: &Block) -> Diagnostic {
        let junction = mend::junction(self.sources.get(first.span.file), first, second);
        match junction.filter(|_| first.span.file == second.span.file) {
            Some((span, text)) => error.help("join them: one pair of braces for both").fix(span, text),
            None => error.help("move what only this one says into the first, and take this one out"),
        }
    }

    /// Says that `name` is not known, unless it may stand where the text could not be read.
    pub fn unknown(&mut self, what: &str, name: &str, span: Span, known: &[&str]) {
        self.unknown_among(what, name, span, known, |_| true);
    }

    /// As [`Context::unknown`], where only some of the known names may be the one that was meant.
    pub fn unknown_among(&mut self, what: &str, name: &str, span: Span, known: &[&str], open: impl Fn(&str) -> bool) {
        if self.may_exist(name) {
            return;
        }
        // Looking for near names takes time, and nobody reads hundreds of errors.
        let known = if self.is_full() { &[] } else { known };
        let mut error = Diagnostic::error("mavc::name::unknown", span, format!("no {what} is called `{name}`"))
            .here("not declared");
        if let Some(near) = nearest(name, known.iter().copied().filter(|k| open(k))) {
            error = error.help(format!("did you mean `{near}`?")).fix(span, near);
        } else if what == "`let`" {
            error = error.help(format!("declare it outside all blocks: `let {name} = ...`"));
        } else if !known.is_empty() {
            error = error.help(format!("name one that there is: {}", in_runs(known)));
        } else if what == "fault mode" {
            error = error.help(format!("declare it in `faults`, as in `mode {name} {{ rotor 1 lost }}`"));
        }
        self.report(error);
    }
}

/// `name` is declared twice.
pub(super) fn duplicate(what: &str, name: &Name, first: Span) -> Diagnostic {
    let message = format!("a second {what} is called `{}`", name.value);
    Diagnostic::error("mavc::name::duplicate", name.span, message)
        .here("declared again")
        .also(first, "first declared here")
        .help("give one of them another name, or take one out")
}

/// `where` in a field other than `against`.
pub(super) fn no_filter(span: Span) -> Diagnostic {
    Diagnostic::error("mavc::plan::choice", span, "`where` stands only in `against`")
        .here("not a filter")
        .help("write a value in its place")
}

/// `a`, `b` and `c`, each in backquotes.
pub(super) fn listed(words: &[&str]) -> String {
    joined(&words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>())
}

/// As [`listed`], where names that differ in their numbers alone are told by the first and the last, and not too many.
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
