//! Units of time that scale the derivatives at the nodes, so that the program's variables are of similar size.

use crate::motion::time_grid::TimeGrid;

/// Steps per unit of scaled time. Chosen by hand.
const TAU_STEPS: f64 = 4.0;

/// Steps that differ by no more than this factor have one unit of time (on the paper's missions the solver takes up to
/// 1.3 times the iterations with one at each node).
const EVEN: f64 = 2.0;

/// Unit of time for a grid as a whole, s: [`TAU_STEPS`] mean steps.
pub(super) fn mean_unit(grid: &TimeGrid) -> f64 {
    TAU_STEPS * grid.total / grid.intervals() as f64
}

/// Unit of time at each node, s: [`mean_unit`], or [`TAU_STEPS`] times the mean of the adjacent steps where steps
/// differ by more than [`EVEN`].
pub(super) fn units_of_time(grid: &TimeGrid) -> Vec<f64> {
    let times = &grid.node_times;
    let (shortest, longest) = grid.steps().fold((f64::INFINITY, 0.0), |(s, l), step| (step.min(s), step.max(l)));
    let beside = |node: usize| {
        let (before, after) = (node.saturating_sub(1), (node + 1).min(times.len() - 1));
        (times[after] - times[before]) / (after - before) as f64
    };
    let is_even = longest <= EVEN * shortest;
    let unit = |node| if is_even { mean_unit(grid) } else { TAU_STEPS * beside(node) };
    (0..times.len()).map(unit).collect()
}
