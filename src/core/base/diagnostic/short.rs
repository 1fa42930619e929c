//! Diagnostics for editors and `grep`: one line each.

use super::Diagnostic;
use crate::source::{SourceMap, visible};
use std::fmt::Write;

/// Renders each as `file:line:column: error[code]: message` and a newline.
pub fn render_short(diagnostics: &[Diagnostic], sources: &SourceMap) -> String {
    let mut text = String::new();
    for d in diagnostics {
        let source = sources.get(d.span.file);
        let place = source.place(d.span.start as usize);
        let (severity, message) = (d.severity.name(), d.message.replace('\n', " "));
        let (name, message) = (visible::line(&source.name), visible::line(&message));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name}:{}:{}: {severity}[{}]: {message}", place.line, place.column, d.code);
    }
    text
}
