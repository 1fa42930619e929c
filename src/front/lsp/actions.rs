//! Quick fixes: every diagnostic that knows a replacement offers it.

use super::diagnostics::diagnostic;
use super::documents::{offsets, range};
use super::workspace::{Spec, Workspace};
use crate::diagnostic::Diagnostic;
use gen_lsp_types::{CodeAction, CodeActionKind, CodeActionResponse, Range, TextEdit, WorkspaceEdit};
use std::collections::HashMap;
use url::Url;

/// Makes an edit of what changes in each text, as the editor can take it.
pub type Edit<'a> = dyn Fn(HashMap<Url, Vec<TextEdit>>) -> WorkspaceEdit + 'a;

/// The fixes of those diagnostics in `reported` that a range of one file touches.
pub fn fixes(
    workspace: &Workspace,
    spec: &Spec,
    name: &str,
    asked: Range,
    reported: &[Diagnostic],
    edit: &Edit,
) -> Vec<CodeActionResponse> {
    let Some(file) = spec.file(name) else { return Vec::new() };
    let (start, end) = offsets(spec.source(file), asked);
    let touched = reported.iter().filter(|d| {
        // A missing field is reported at the head of its block; the cursor may be anywhere in the block.
        let near =
            |span: crate::source::Span| span.file == file && (span.start as usize) <= end && start <= span.end as usize;
        near(d.span) || d.fix.as_ref().is_some_and(|fix| near(fix.span))
    });
    touched.filter_map(|d| fix(workspace, spec, d, edit)).map(CodeActionResponse::CodeAction).collect()
}

fn fix(workspace: &Workspace, spec: &Spec, reported: &Diagnostic, edit: &Edit) -> Option<CodeAction> {
    let fix = reported.fix.as_ref()?;
    let source = spec.source(fix.span.file);
    let (start, end) = (fix.span.start as usize, fix.span.end as usize);
    // `mass: 1` becomes `mass = 1`, as everybody writes it.
    let is_glued = fix.text == "=" && spec.snippet(fix.span) == ":" && !source.text[..start].ends_with([' ', '\t']);
    let new_text = if is_glued { " =".to_string() } else { fix.text.clone() };
    let change = TextEdit { range: range(source, start, end), new_text };
    let changes = HashMap::from([(workspace.uri(&source.name)?, vec![change])]);
    Some(CodeAction {
        title: title(reported, &fix.text, spec.snippet(fix.span)),
        kind: Some(CodeActionKind::QuickFix),
        diagnostics: Some(vec![diagnostic(workspace, spec, reported)]),
        // The value of a field that is missing is only an example, and a missing unit one of several: to be looked at
        // before they are taken.
        is_preferred: Some(!matches!(reported.code, "mavc::name::missing_field" | "mavc::unit::missing")),
        edit: Some(edit(changes)),
        ..CodeAction::default()
    })
}

/// The help, where it is an instruction; otherwise what the replacement does.
fn title(reported: &Diagnostic, text: &str, replaced: &str) -> String {
    let (text, replaced) = (text.trim(), replaced.trim());
    let is_order = |help: &&str| {
        ["write ", "add ", "take ", "put ", "remove ", "merge "].iter().any(|word| help.starts_with(word))
    };
    // The replacement may be one of several that the help names; `...` is not a text to write.
    let is_one = |help: &&str| help.matches('`').count() <= 2 && !help.contains("...");
    match reported.help.as_deref().and_then(|help| help.lines().next()).filter(is_order).filter(is_one) {
        Some(help) => {
            let mut letters = help.chars();
            let first = letters.next().map(|c| c.to_ascii_uppercase());
            first.into_iter().chain(letters).collect()
        }
        None if text.is_empty() => format!("Take out `{replaced}`"),
        None if replaced.is_empty() => format!("Put in `{text}`"),
        None => format!("Write `{text}`"),
    }
}
