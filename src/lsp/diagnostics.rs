//! Diagnostics as the protocol has them.

use super::documents::range;
use super::workspace::{Spec, Workspace};
use crate::diagnostic::{Diagnostic, Severity};
use gen_lsp_types as lsp;
use gen_lsp_types::{DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag};

/// Codes of what is unused: editors show it faded.
const UNNECESSARY: [&str; 3] = ["mavc::name::unused", "mavc::fault::unused", "mavc::syntax::dangling_doc"];

/// The diagnostic with headline, label and help as its message; labels elsewhere become related places.
pub fn diagnostic(workspace: &Workspace, spec: &Spec, told: &Diagnostic) -> lsp::Diagnostic {
    let source = spec.source(told.span.file);
    let related = told.labels.iter().filter_map(|label| {
        let location = workspace.location(spec, label.span)?;
        Some(DiagnosticRelatedInformation { location, message: label.message.clone() })
    });
    lsp::Diagnostic {
        range: range(source, told.span.start as usize, told.span.end as usize),
        severity: Some(match told.severity {
            Severity::Error => DiagnosticSeverity::Error,
            Severity::Warning => DiagnosticSeverity::Warning,
            Severity::Advice => DiagnosticSeverity::Information,
        }),
        code: Some(told.code.to_string().into()),
        source: Some("mavc".into()),
        message: message(told).into(),
        tags: UNNECESSARY.contains(&told.code).then(|| vec![DiagnosticTag::Unnecessary]),
        related_information: Some(related.collect()).filter(|r: &Vec<_>| !r.is_empty()),
        ..lsp::Diagnostic::default()
    }
}

fn message(told: &Diagnostic) -> String {
    let mut text = told.message.clone();
    if !told.label.is_empty() {
        text.push_str(&format!("\n{}", told.label));
    }
    if let Some(help) = &told.help {
        text.push_str(&format!("\nhelp: {help}"));
    }
    text
}
