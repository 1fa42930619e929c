//! When the planned wrench leaves a set, to the instant.

use super::Trajectory;
use crate::actuation::Wrench;
use crate::admissible::row::{SetRow, VIOLATED};
use crate::model::Vehicle;
use crate::motion::wrench_model::WrenchModel;

/// How a trajectory stands to one set.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outside {
    /// Indices of rows violated at some node.
    pub facets: Vec<usize>,
    /// Indices of rows violated at some instant: these, and those violated only between nodes.
    pub violated: Vec<usize>,
    /// (row, node) pairs violated.
    pub rows: usize,
    /// Nodes with a violated row.
    pub positions: usize,
    /// Largest excess over all rows, in widths of the healthy set: at the nodes and, where the wrench bends between
    /// them, about the largest of sixteen points an interval; negative where all stays inside.
    pub max_violation: f64,
    /// Seconds outside.
    pub seconds: f64,
    /// The last instant outside, s; `None` where there is none.
    pub last: Option<f64>,
}

/// Intervals over which the wrench bends are cut into this many parts when looking for crossings.
pub const PARTS: usize = 16;

/// Holds the trajectory against rows. A row is violated where its excess is over [`VIOLATED`].
///
/// With yaw linearised the wrench is linear over each interval, so crossing times follow in closed form; where
/// the model follows the yaw they are bisected to rounding.
pub fn outside(trajectory: &Trajectory, vehicle: &Vehicle, gravity: f64, rows: &[SetRow]) -> Outside {
    let wrenches = trajectory.node_wrenches(vehicle, gravity);
    let mut found = Outside { max_violation: f64::NEG_INFINITY, ..Outside::default() };
    let mut violated = vec![false; rows.len()];
    for w in &wrenches {
        let mut any = false;
        for (i, row) in rows.iter().enumerate() {
            let excess = row.violation(w);
            found.max_violation = found.max_violation.max(excess);
            if excess > VIOLATED {
                any = true;
                violated[i] = true;
                found.rows += 1;
            }
        }
        found.positions += usize::from(any);
    }
    found.facets = (0..rows.len()).filter(|&i| violated[i]).collect();
    let mut highest: Option<Seen> = None;
    for k in 0..trajectory.intervals() {
        let (intervals, worst) = violation_intervals(trajectory, vehicle, gravity, rows, k);
        highest = highest.into_iter().chain(worst).max_by(|a, b| a.excess.total_cmp(&b.excess));
        intervals.iter().for_each(|interval| violated[interval.row] = true);
        for (a, b) in merged(intervals.into_iter().map(|s| (s.from, s.to)).collect()) {
            found.seconds += b - a;
            found.last = Some(b);
        }
    }
    if let Some(seen) = highest {
        found.max_violation = found.max_violation.max(refined(trajectory, vehicle, gravity, rows, seen));
    }
    found.violated = (0..rows.len()).filter(|&i| violated[i]).collect();
    found
}

/// The excess over a row at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    pub row: usize,
    pub excess: f64,
    /// s since the start
    pub at: f64,
    /// How far apart the instants looked at are, s.
    pub apart: f64,
}

/// Golden-section steps by which the peak about a sample is found: to 1e-6 of the distance of samples.
const REFINEMENTS: usize = 30;

/// The largest excess over a row about the sample at which it is largest.
fn refined(trajectory: &Trajectory, vehicle: &Vehicle, gravity: f64, rows: &[SetRow], seen: Seen) -> f64 {
    if matches!(trajectory.model, WrenchModel::HoverAt(_)) {
        // Linear between samples.
        return seen.excess;
    }
    let at = |t: f64| rows[seen.row].violation(&trajectory.wrench(vehicle, gravity, &trajectory.at(t)));
    let (mut low, mut high) = ((seen.at - seen.apart).max(0.0), (seen.at + seen.apart).min(trajectory.duration()));
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut best = seen.excess;
    for _ in 0..REFINEMENTS {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        let (left, right) = (at(a), at(b));
        best = best.max(left).max(right);
        if left < right { low = a } else { high = b }
    }
    best
}

/// A time during which a row is violated within one interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViolationInterval {
    pub row: usize,
    /// s since the start
    pub from: f64,
    pub to: f64,
}

/// What is violated in interval `k`, and the largest excess seen there; see [`outside`].
pub fn violation_intervals(
    trajectory: &Trajectory,
    vehicle: &Vehicle,
    gravity: f64,
    rows: &[SetRow],
    k: usize,
) -> (Vec<ViolationInterval>, Option<Seen>) {
    let begin = trajectory.times[k];
    let h = trajectory.times[k + 1] - begin;
    let curved = !matches!(trajectory.model, WrenchModel::HoverAt(_));
    let parts = if curved { PARTS } else { 1 };
    let at = |t: f64| trajectory.wrench(vehicle, gravity, &trajectory.within(k, t));
    let at_node = |node: usize| trajectory.wrench(vehicle, gravity, &trajectory.nodes[node]);
    let mut found = Vec::new();
    let mut worst: Option<Seen> = None;
    let apart = h / parts as f64;
    let mut left = (0.0, at_node(k));
    for p in 1..=parts {
        let t = h * p as f64 / parts as f64;
        let right = (t, if p == parts { at_node(k + 1) } else { at(t) });
        for (i, row) in rows.iter().enumerate() {
            let excess = row.violation(&right.1);
            if worst.is_none_or(|seen| excess > seen.excess) {
                worst = Some(Seen { row: i, excess, at: begin + t, apart });
            }
            let at = curved.then_some(&at as &dyn Fn(f64) -> Wrench);
            // A plane can be left on either side.
            let sides: &[f64] = if row.equality { &[1.0, -1.0] } else { &[1.0] };
            let spans_of = |&side| {
                let over = |w: &Wrench| side * (row.normal.dot(w) - row.offset) - VIOLATED;
                let (from, to) = span_outside(over, left, right, at)?;
                Some(ViolationInterval { row: i, from: begin + from, to: begin + to })
            };
            found.extend(sides.iter().filter_map(spans_of));
        }
        left = right;
    }
    (found, worst)
}

/// The part of [left, right] in which `over` is positive; at most one crossing is looked for.
fn span_outside(
    over: impl Fn(&Wrench) -> f64,
    left: (f64, Wrench),
    right: (f64, Wrench),
    curved: Option<&dyn Fn(f64) -> Wrench>,
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

/// The point where `holds` turns from true to false.
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

/// Union of intervals, ascending.
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
