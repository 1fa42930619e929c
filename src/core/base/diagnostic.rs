//! Diagnostics about a spec: a message that is complete by itself, a place, labels, and one action that fixes the
//! problem.
//!
//! Stages up to the model return [`Checked`]: a value if one could be built, and all diagnostics.

pub mod codes;
mod excerpt;
mod json;
mod nearest;
mod terminal;

pub use json::to_json_line;
pub use nearest::{nearest, nearest_by_words};
pub use terminal::{render_human, render_linked, render_short};

use crate::source::{FileId, Span};

/// How serious a diagnostic is, the most serious first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// There is no model.
    Error,
    /// There is a model, which is probably not as intended.
    Warning,
    /// The spec is valid but could be clearer.
    Advice,
}

impl Severity {
    pub const ALL: [Severity; 3] = [Severity::Error, Severity::Warning, Severity::Advice];

    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Advice => "advice",
        }
    }
}

/// A further place that helps to understand the problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    pub span: Span,
    pub message: String,
}

/// An edit that fixes the spec: replace `span` by `text`.
#[derive(Debug, Clone, PartialEq)]
pub struct Fix {
    pub span: Span,
    pub text: String,
}

/// One problem in a spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// A stable code such as `mavc::unit::mismatch`, which `mavc explain` describes.
    pub code: &'static str,
    pub severity: Severity,
    /// What is wrong, in one sentence that is complete by itself.
    pub message: String,
    /// The place of the problem.
    pub span: Span,
    /// What is wrong at `span`; may be empty.
    pub label: String,
    /// Further places.
    pub labels: Vec<Label>,
    /// One action that fixes the problem.
    pub help: Option<String>,
    /// The edit for that action, if it can be made without asking the author.
    pub fix: Option<Fix>,
}

impl Diagnostic {
    pub fn new(severity: Severity, code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Diagnostic {
            code,
            severity,
            message: message.into(),
            span,
            label: String::new(),
            labels: Vec::new(),
            help: None,
            fix: None,
        }
    }

    pub fn error(code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, span, message)
    }

    pub fn warning(code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, span, message)
    }

    pub fn advice(code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Advice, code, span, message)
    }

    /// Sets the label at the place of the problem.
    pub fn here(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Adds a label at another place.
    pub fn also(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: message.into() });
        self
    }

    /// Sets the action that fixes the problem.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Sets the edit that fixes the problem.
    pub fn fix(mut self, span: Span, text: impl Into<String>) -> Self {
        self.fix = Some(Fix { span, text: text.into() });
        self
    }
}

/// The result of a stage: a value if one could be built, and all diagnostics.
#[derive(Debug, Clone)]
pub struct Checked<T> {
    pub value: Option<T>,
    pub diagnostics: Vec<Diagnostic>,
}

impl<T> Checked<T> {
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }
}

/// Sorts diagnostics in the order in which they are shown, by file, place and severity, and removes exact repetitions.
pub fn sort(diagnostics: &mut Vec<Diagnostic>) {
    fn key(d: &Diagnostic) -> (FileId, u32, Severity, u32, &str, &str) {
        (d.span.file, d.span.start, d.severity, d.span.end, d.code, &d.message)
    }
    diagnostics.sort_by(|a, b| key(a).cmp(&key(b)));
    diagnostics.dedup();
}
