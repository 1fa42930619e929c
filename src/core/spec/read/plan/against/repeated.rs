//! Warns of fault modes that `against` lists more than once.

use super::choose::Runs;
use crate::diagnostic::Diagnostic;
use crate::read::context::Context;
use crate::read::edits;
use crate::syntax::ast::Expr;
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Warns of every element all of whose modes are in longer elements or in earlier ones. `read` has the modes of each
/// element.
pub(super) fn warn(cx: &mut Context, elements: &[Expr], read: &[Option<Runs>]) {
    let mut all: Vec<(&Expr, &Runs)> =
        elements.iter().zip(read).filter_map(|(e, runs)| Some((e, runs.as_ref()?))).collect();
    all.sort_by_key(|(_, runs)| Reverse(runs.iter().map(ExactSizeIterator::len).sum::<usize>()));
    let mut listed = BTreeSet::new();
    for (element, runs) in all {
        if runs.iter().cloned().flatten().filter(|mode| listed.insert(*mode)).count() == 0 {
            let message = format!("`{}` is listed twice", cx.sources.snippet(element.span));
            let warning = Diagnostic::warning("mavc::plan::listed_twice", element.span, message);
            let again = edits::element(cx.sources.get(element.span.file), element.span);
            cx.report(warning.here("already listed").help("remove it").fix(again, ""));
        }
    }
}
