//! Diagnostics for programs: one JSON object per line. Lines and columns count from 1, columns in Unicode scalars.

use super::Diagnostic;
use crate::source::{SourceMap, Span, visible};
use serde::Serialize;

#[derive(Serialize)]
struct Record<'a> {
    code: &'a str,
    severity: &'a str,
    message: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
    labels: Vec<Label<'a>>,
    help: Option<&'a str>,
    /// Edits, each of which fixes the problem by itself.
    fixes: Vec<Fix<'a>>,
}

#[derive(Serialize)]
struct Fix<'a> {
    text: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
}

#[derive(Serialize)]
struct Label<'a> {
    message: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
}

#[derive(Serialize)]
struct Place<'a> {
    file: &'a str,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
}

/// The diagnostic as one line of JSON, without a trailing newline. The label at its own place is the first label.
pub fn to_json_line(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let own = (!diagnostic.label.is_empty()).then_some((diagnostic.label.as_str(), diagnostic.span));
    let others = diagnostic.labels.iter().map(|l| (l.message.as_str(), l.span));
    let labels = own.into_iter().chain(others);
    let record = Record {
        code: diagnostic.code,
        severity: diagnostic.severity.name(),
        message: &diagnostic.message,
        place: place(diagnostic.span, sources),
        labels: labels.map(|(message, span)| Label { message, place: place(span, sources) }).collect(),
        help: diagnostic.help.as_deref(),
        fixes: diagnostic.fix.iter().map(|f| Fix { text: &f.text, place: place(f.span, sources) }).collect(),
    };
    visible::json(serde_json::to_string(&record).expect("texts and numbers always serialise"))
}

fn place(span: Span, sources: &SourceMap) -> Place<'_> {
    let source = sources.get(span.file);
    let (start, end) = (source.place(span.start as usize), source.place(span.end as usize));
    Place { file: &source.name, line: start.line, column: start.column, end_line: end.line, end_column: end.column }
}
