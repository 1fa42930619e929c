//! Diagnostics as the protocol has them.

use super::documents::range;
use super::workspace::{Spec, Workspace};
use crate::diagnostic::{Diagnostic, Severity};
use gen_lsp_types as lsp;
use gen_lsp_types::{DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag};

/// Codes of what is unused: editors show it faded.
const UNNECESSARY: [&str; 3] = ["mavc::name::unused", "mavc::fault::unused", "mavc::syntax::dangling_doc"];

/// The diagnostic with headline, label and help as its message; labels elsewhere become related places.
pub fn diagnostic(workspace: &Workspace, spec: &Spec, reported: &Diagnostic) -> lsp::Diagnostic {
    let source = spec.source(reported.span.file);
    let related = reported.labels.iter().filter_map(|label| {
        let location = workspace.location(spec, label.span)?;
        Some(DiagnosticRelatedInformation { location, message: label.message.clone() })
    });
    lsp::Diagnostic {
        range: range(source, reported.span.start as usize, reported.span.end as usize),
        severity: Some(match reported.severity {
            Severity::Error => DiagnosticSeverity::Error,
            Severity::Warning => DiagnosticSeverity::Warning,
            Severity::Advice => DiagnosticSeverity::Information,
        }),
        code: Some(reported.code.to_string().into()),
        source: Some("mavc".into()),
        message: message(reported).into(),
        tags: UNNECESSARY.contains(&reported.code).then(|| vec![DiagnosticTag::Unnecessary]),
        related_information: Some(related.collect()).filter(|r: &Vec<_>| !r.is_empty()),
        ..lsp::Diagnostic::default()
    }
}

fn message(reported: &Diagnostic) -> String {
    let mut text = reported.message.clone();
    if !reported.label.is_empty() {
        text.push_str(&format!("\n{}", reported.label));
    }
    if let Some(help) = &reported.help {
        text.push_str(&format!("\nhelp: {help}"));
    }
    text
}
