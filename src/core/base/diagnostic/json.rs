//! Diagnostics for programs: one JSON object per line. Lines and columns count from 1, columns in Unicode scalars.

use super::Diagnostic;
use crate::source::{SourceMap, Span, visible};
use serde::Serialize;

/// One such object per line for each problem found.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Record<'a> {
    /// The problem's code; `mavc explain CODE` describes it.
    #[cfg_attr(test, schemars(regex(pattern = "^mavc::[a-z0-9_]+(::[a-z0-9_]+)*$")))]
    code: &'a str,
    /// How serious it is.
    #[cfg_attr(test, schemars(extend("enum" = super::Severity::ALL.map(super::Severity::name))))]
    severity: &'a str,
    /// The headline.
    #[cfg_attr(test, schemars(length(min = 1)))]
    message: &'a str,
    #[serde(flatten)]
    place: JsonPlace<'a>,
    /// Related places, the problem's own first if it has a message.
    labels: Vec<Label<'a>>,
    /// How to fix it.
    help: Option<&'a str>,
    /// Replacements, each of which fixes the problem by itself.
    fixes: Vec<Fix<'a>>,
}

/// A replacement.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Fix<'a> {
    /// The replacement text; empty to delete.
    text: &'a str,
    #[serde(flatten)]
    place: JsonPlace<'a>,
}

/// A related place.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Label<'a> {
    /// The message at this place.
    message: &'a str,
    #[serde(flatten)]
    place: JsonPlace<'a>,
}

/// A place in a file.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct JsonPlace<'a> {
    /// The file's name as given.
    file: &'a str,
    /// First line, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    line: usize,
    /// Column of its start in Unicode scalars, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    column: usize,
    /// Last line, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    end_line: usize,
    /// Column just after the end, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
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

fn place(span: Span, sources: &SourceMap) -> JsonPlace<'_> {
    let source = sources.get(span.file);
    let (start, end) = (source.place(span.start as usize), source.place(span.end as usize));
    JsonPlace { file: &source.name, line: start.line, column: start.column, end_line: end.line, end_column: end.column }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::schemas::check;

    #[test]
    fn the_schema_is_current() {
        check::<Record>("check", "mavc check --format json");
    }
}
