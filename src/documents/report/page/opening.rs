//! The instant and set with which a page opens: the worst ones of the run shown first.

use super::content::{DIVERGED, LOST, RunContent};
use super::sets::SetContent;
use serde::Serialize;

/// Margins that differ by less than this, in percent of the healthy set's width, count as equal.
const ALIKE: f64 = 1e-3;

/// The instant and the set that a page shows before the reader selects others.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Opening {
    /// Index into the page's sets.
    pub set: usize,
    /// s
    pub t: f64,
}

/// For a plan: the instant and mode of the smallest margin, the first of several equal ones. For a flight: its loss or
/// otherwise the largest position error, and the fault in force then. The start and the first mode if neither is known.
pub fn opening(run: Option<&RunContent>, sets: &[SetContent]) -> Opening {
    let first = Opening { set: sets.len().saturating_sub(1).min(1), t: 0.0 };
    let Some(run) = run else { return first };
    smallest_margin(run, sets).or_else(|| farthest(run, sets, first.set)).unwrap_or(first)
}

/// Over all sets that plans are measured against.
fn smallest_margin(run: &RunContent, sets: &[SetContent]) -> Option<Opening> {
    let times = run.columns.get("t")?;
    let of_set = |set: usize| {
        let margins = run.columns.get(&format!("margin_{set}"))?;
        let (k, margin) = margins.iter().copied().enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some((Opening { set, t: *times.get(k)? }, margin))
    };
    let all: Vec<(Opening, f64)> = (0..sets.len()).filter_map(of_set).collect();
    let least = all.iter().map(|(_, margin)| *margin).min_by(f64::total_cmp)?;
    all.into_iter().find(|(_, margin)| *margin <= least + ALIKE).map(|(opening, _)| opening)
}

/// For a flight.
fn farthest(run: &RunContent, sets: &[SetContent], otherwise: usize) -> Option<Opening> {
    let (times, errors) = (run.columns.get("t")?, run.columns.get("error")?);
    let lost = run.marks.iter().find(|mark| mark.label == LOST || mark.label == DIVERGED).map(|mark| mark.t);
    // The first of several equal ones.
    let farthest = (0..errors.len()).reduce(|best, k| if errors[k] > errors[best] { k } else { best })?;
    let t = lost.or_else(|| times.get(farthest).copied())?;
    let phase = run.phases.iter().rev().find(|phase| phase.from <= t)?;
    // `M3 undetected`, `M3, M5 detected`: the first mode among the sets.
    let struck = phase.label.split(", ").filter_map(|fault| fault.split(' ').next());
    let set = struck.filter_map(|mode| sets.iter().position(|set| set.name == mode)).next();
    Some(Opening { set: set.unwrap_or(otherwise), t })
}
