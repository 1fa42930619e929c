//! Warns of fault modes that `against` lists more than once.

use super::choose::Runs;
use crate::diagnostic::Diagnostic;
use crate::model::FaultMode;
use crate::read::context::Context;
use crate::read::edits;
use crate::syntax::ast::Expr;

const LISTED_TWICE: &str = "mavc::plan::listed_twice";

/// An element and its modes.
type Listed<'a> = (&'a Expr, &'a Runs);

/// Warns of every element that could be removed, and of ranges that overlap. `read` has the modes of each element.
pub(super) fn warn(cx: &mut Context, modes: &[FaultMode], elements: &[Expr], read: &[Option<Runs>]) {
    let listed: Vec<Listed> = elements.iter().zip(read).filter_map(|(e, runs)| Some((e, runs.as_ref()?))).collect();
    let mut counts = counts(modes.len(), &listed);
    if counts.iter().all(|count| *count < 2) {
        return;
    }
    let mut found = Vec::new();
    let kept = surplus(cx, &listed, &mut counts, &mut found);
    overlaps(cx, modes, &kept, &mut counts, &mut found);
    found.sort_by_key(|warning| warning.span);
    found.into_iter().for_each(|warning| cx.report(warning));
}

/// For each mode, how many elements include it.
fn counts(modes: usize, listed: &[Listed]) -> Vec<i64> {
    // Counts differences at the ends of runs and sums them, so that long runs cost no more than short ones.
    let mut counts = vec![0; modes + 1];
    for run in listed.iter().flat_map(|(_, runs)| runs.iter()) {
        counts[run.start] += 1;
        counts[run.end] -= 1;
    }
    let mut sum = 0;
    counts.iter_mut().for_each(|count| {
        sum += *count;
        *count = sum;
    });
    counts
}

/// Warns of elements whose modes are all included in others, and returns the rest. Shorter elements are reported first
/// (`W1` beside `W`), and among equal ones the later.
fn surplus<'a>(
    cx: &Context,
    listed: &[Listed<'a>],
    counts: &mut [i64],
    found: &mut Vec<Diagnostic>,
) -> Vec<Listed<'a>> {
    let length = |runs: &Runs| runs.iter().map(ExactSizeIterator::len).sum::<usize>();
    let mut order: Vec<usize> = (0..listed.len()).collect();
    order.sort_by_key(|&place| (length(listed[place].1), std::cmp::Reverse(place)));
    let mut is_kept = vec![true; listed.len()];
    for place in order {
        let (element, runs) = listed[place];
        if runs.iter().cloned().flatten().any(|mode| counts[mode] < 2) {
            continue;
        }
        is_kept[place] = false;
        runs.iter().cloned().flatten().for_each(|mode| counts[mode] -= 1);
        let message = format!("`{}` is listed twice", cx.sources.snippet(element.span));
        let warning = Diagnostic::warning(LISTED_TWICE, element.span, message);
        let again = edits::element(cx.sources.get(element.span.file), element.span);
        found.push(warning.here("already listed").help("remove it").fix(again, ""));
    }
    listed.iter().zip(is_kept).filter(|(_, kept)| *kept).map(|(listed, _)| *listed).collect()
}

/// Warns of ranges that overlap but do not include each other.
fn overlaps(cx: &Context, modes: &[FaultMode], kept: &[Listed], counts: &mut [i64], found: &mut Vec<Diagnostic>) {
    for (element, runs) in kept.iter().rev() {
        let twice: Vec<usize> = runs.iter().cloned().flatten().filter(|&mode| counts[mode] > 1).collect();
        let Some(&first) = twice.first() else { continue };
        twice.iter().for_each(|&mode| counts[mode] -= 1);
        let (name, written) = (&modes[first].name, cx.sources.snippet(element.span));
        let message = match twice.len() {
            1 => format!("`{name}` in `{written}` is listed twice"),
            n => format!("{n} fault modes in `{written}` are listed twice, the first is `{name}`"),
        };
        let warning = Diagnostic::warning(LISTED_TWICE, element.span, message);
        found.push(warning.here("overlaps another range").help("shorten one of the two"));
    }
}
