//! When the planned wrench is outside a set, to the instant: `docs/method/planners.md`, "Violation" and "Outside".

use super::Trajectory;
use super::felt::{Felt, Flown};
use crate::actuation::Wrench;
use crate::admissible::row::{SetRow, VIOLATED, largest};
use crate::model::{Environment, Vehicle};

/// The violations of one set by a trajectory. A row is violated where its violation exceeds [`VIOLATED`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outside {
    /// Indices of the rows violated at some node, ascending.
    pub facets: Vec<usize>,
    /// Indices of the rows violated at some instant, ascending: `facets`, and the rows violated only between nodes.
    pub violated: Vec<usize>,
    /// Number of pairs (row, node) with a violation.
    pub rows: usize,
    /// Number of nodes with a violated row.
    pub positions: usize,
    /// The largest violation of all rows, in widths of the healthy set; negative if every row holds. If the wrench is
    /// not linear between nodes, the violation is also evaluated at 16 points an interval and refined around the
    /// largest.
    pub max_violation: f64,
    /// How long at least one row is violated, s.
    pub seconds: f64,
    /// The end of the last violation, s; `None` without one.
    pub last: Option<f64>,
    /// When the violation is largest, or the margin least, to the nearest sample, s; `None` without rows.
    pub worst_at: Option<f64>,
}

/// If the wrench is not linear between nodes, each interval is divided into this many parts to find where a violation
/// begins and ends.
pub const PARTS: usize = 16;

/// The violations of `rows` by a trajectory, in the worst of the possible winds.
///
/// With one yaw throughout the wrench is linear on each interval, and the instants at which a violation begins and ends
/// follow in closed form. Otherwise they are bisected on each of [`PARTS`] parts of an interval, so that a violation
/// within one part may be missed.
pub fn outside(trajectory: &Trajectory, vehicle: &Vehicle, environment: &Environment, rows: &[SetRow]) -> Outside {
    let flown = Flown::new(trajectory, vehicle, environment, rows);
    let mut found = Outside { max_violation: f64::NEG_INFINITY, ..Outside::default() };
    let mut violated = vec![false; rows.len()];
    for (node, time) in trajectory.nodes.iter().zip(&trajectory.times) {
        let felt = flown.at(node);
        let mut any = false;
        for (i, row) in rows.iter().enumerate() {
            let violation = felt.worst(row);
            if violation > found.max_violation {
                (found.max_violation, found.worst_at) = (violation, Some(*time));
            }
            if violation > VIOLATED {
                any = true;
                violated[i] = true;
                found.rows += 1;
            }
        }
        found.positions += usize::from(any);
    }
    found.facets = (0..rows.len()).filter(|&i| violated[i]).collect();
    let mut highest: Option<Sample> = None;
    for k in 0..trajectory.intervals() {
        let (intervals, worst) = violations_within(&flown, rows, k);
        highest = highest.into_iter().chain(worst).max_by(|a, b| a.violation.total_cmp(&b.violation));
        intervals.iter().for_each(|interval| violated[interval.row] = true);
        for (a, b) in merged(intervals.into_iter().map(|s| (s.from, s.to)).collect()) {
            found.seconds += b - a;
            found.last = Some(b);
        }
    }
    if let Some(sample) = highest {
        if sample.violation > found.max_violation {
            found.worst_at = Some(sample.at);
        }
        found.max_violation = found.max_violation.max(refined(&flown, &rows[sample.row], sample));
    }
    found.violated = (0..rows.len()).filter(|&i| violated[i]).collect();
    found
}

/// The violation of a row at a sampled instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sample {
    /// Index of the row.
    pub(crate) row: usize,
    /// In widths of the healthy set.
    pub(crate) violation: f64,
    /// s since the start.
    pub(crate) at: f64,
    /// Distance of neighbouring samples, s.
    pub(crate) apart: f64,
}

/// Golden-section steps by which the peak near a sample is found, to 1e-6 of the distance of samples.
const REFINEMENTS: usize = 30;

/// The largest violation of the sample's row between the neighbouring samples.
fn refined(flown: &Flown, row: &SetRow, sample: Sample) -> f64 {
    if !flown.is_curved() {
        // The wrench is linear between samples.
        return sample.violation;
    }
    let trajectory = flown.trajectory;
    let at = |t: f64| flown.at(&trajectory.at(t)).worst(row);
    let (mut low, mut high) =
        ((sample.at - sample.apart).max(0.0), (sample.at + sample.apart).min(trajectory.duration()));
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut best = sample.violation;
    for _ in 0..REFINEMENTS {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        let (left, right) = (at(a), at(b));
        best = best.max(left).max(right);
        if left < right { low = a } else { high = b }
    }
    best
}

/// A time during which a row is violated, within one interval between nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ViolationInterval {
    /// Index of the row.
    pub(crate) row: usize,
    /// Beginning of the violation, s since the start.
    pub(crate) from: f64,
    /// End of the violation, s since the start.
    pub(crate) to: f64,
}

/// The violations within interval `k` between nodes, and the sample with the largest violation; see [`outside`].
///
/// # Panics
/// If there is no interval `k`.
pub(crate) fn violation_intervals(
    trajectory: &Trajectory,
    vehicle: &Vehicle,
    environment: &Environment,
    rows: &[SetRow],
    k: usize,
) -> (Vec<ViolationInterval>, Option<Sample>) {
    violations_within(&Flown::new(trajectory, vehicle, environment, rows), rows, k)
}

fn violations_within(flown: &Flown, rows: &[SetRow], k: usize) -> (Vec<ViolationInterval>, Option<Sample>) {
    let trajectory = flown.trajectory;
    let begin = trajectory.times[k];
    let h = trajectory.times[k + 1] - begin;
    let curved = flown.is_curved();
    let parts = if curved { PARTS } else { 1 };
    let at = |t: f64| flown.at(&trajectory.within(k, t));
    let at_node = |node: usize| flown.at(&trajectory.nodes[node]);
    let mut found = Vec::new();
    let mut worst: Option<Sample> = None;
    let apart = h / parts as f64;
    let mut left = (0.0, at_node(k));
    for p in 1..=parts {
        let t = h * p as f64 / parts as f64;
        let right = (t, if p == parts { at_node(k + 1) } else { at(t) });
        for (i, row) in rows.iter().enumerate() {
            let violation = right.1.worst(row);
            if worst.is_none_or(|sample| violation > sample.violation) {
                worst = Some(Sample { row: i, violation, at: begin + t, apart });
            }
            let at = curved.then_some(&at as &dyn Fn(f64) -> Felt);
            // The plane of an equality can be left on either side.
            let sides: &[f64] = if row.equality { &[1.0, -1.0] } else { &[1.0] };
            let spans_of = |&side| {
                let one = |w: &Wrench| side * (row.normal.dot(w) - row.offset) - VIOLATED;
                let over = |felt: &Felt| largest(felt.wrenches.iter().map(one)) + row.of_core(felt.turning.as_ref());
                let (from, to) = span_outside(over, &left, &right, at)?;
                Some(ViolationInterval { row: i, from: begin + from, to: begin + to })
            };
            found.extend(sides.iter().filter_map(spans_of));
        }
        left = right;
    }
    (found, worst)
}

/// The part of [left, right] in which `over` is positive, assuming at most one change of sign. `curved` evaluates the
/// rows' arguments if they are not linear in between.
fn span_outside(
    over: impl Fn(&Felt) -> f64,
    left: &(f64, Felt),
    right: &(f64, Felt),
    curved: Option<&dyn Fn(f64) -> Felt>,
) -> Option<(f64, f64)> {
    let (a, b) = (over(&left.1), over(&right.1));
    match (a > 0.0, b > 0.0) {
        (false, false) => None,
        (true, true) => Some((left.0, right.0)),
        (out_first, _) => {
            let t = match curved {
                None => left.0 + (right.0 - left.0) * a / (a - b),
                Some(at) => bisect(left.0, right.0, |t| (over(&at(t)) > 0.0) == out_first),
            };
            Some(if out_first { (left.0, t) } else { (t, right.0) })
        }
    }
}

/// The point at which `holds` changes from true to false, by bisection.
fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The union of intervals, ascending.
fn merged(mut spans: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut union: Vec<(f64, f64)> = Vec::new();
    for (a, b) in spans {
        match union.last_mut() {
            Some(last) if a <= last.1 => last.1 = last.1.max(b),
            _ => union.push((a, b)),
        }
    }
    union
}
