//! Pieces that join. Programs hold the dynamics to the solver's tolerance, and on fine grids over long flights the gaps that
//! this leaves carry the motion away from its nodes when it is integrated from the start. Here inputs are changed by as little
//! as makes the pieces meet.

use super::Trajectory;
use crate::motion::NodeState;
use nalgebra::{DMatrix, DVector};

/// What the gaps of a trajectory may move its end by, m and rad, before it is mended: a tenth of what the checker lets be
/// (`verify::joints`).
const MOVED: f64 = 1e-4;

/// Pieces that are mended together: enough for a small change of the inputs, few enough for a well-conditioned system.
const PIECES: usize = 64;

/// Fewer pieces leave the inputs no room.
const FEWEST: usize = 8;

/// The state of a chain of `N` integrators (derivatives 0 to N - 1) after `h` seconds, its input linear from `u` to `v`.
fn after(state: &[f64], [u, v]: [f64; 2], h: f64) -> Vec<f64> {
    let order = state.len();
    let mut all = state.to_vec();
    all.extend([u, (v - u) / h]);
    let late = |i: usize| (i..all.len()).rev().fold(0.0, |sum, j| all[j] + sum * h / (j + 1 - i) as f64);
    (0..order).map(late).collect()
}

impl Trajectory {
    /// The trajectory with pieces that join, or itself where they do well enough.
    pub fn joined(self) -> Self {
        let orders = self.model.orders();
        let mut mended = self;
        for (axis, &order) in orders.iter().enumerate() {
            if mended.moved(axis, order) > MOVED {
                mended.mend(axis, order);
            }
        }
        mended
    }

    /// What the gaps of an axis together may move its value by at the end: `verify::joints`, in plain arithmetic.
    fn moved(&self, axis: usize, order: usize) -> f64 {
        let mut moved = vec![0.0; order];
        for k in 0..self.intervals() {
            let h = self.times[k + 1] - self.times[k];
            let end = after(&self.nodes[k][axis][..order], self.inputs(k, axis, order), h);
            moved = after_gap(&moved, h);
            for (i, sum) in moved.iter_mut().enumerate() {
                *sum += (end[i] - self.nodes[k + 1][axis][i]).abs();
            }
        }
        moved[0]
    }

    fn inputs(&self, k: usize, axis: usize, order: usize) -> [f64; 2] {
        [self.nodes[k][axis][order], self.nodes[k + 1][axis][order]]
    }

    fn mend(&mut self, axis: usize, order: usize) {
        let mut first = 0;
        while first < self.intervals() {
            // A hold ends at a node that is not a waypoint's, and rests as well.
            let rests = |n: usize| self.nodes[n][axis][1..=order].iter().all(|&d| d == 0.0);
            let ends_here = |&n: &usize| self.waypoint_nodes.contains(&n) || rests(n);
            let next = (first + 1..self.intervals()).find(ends_here).unwrap_or(self.intervals());
            // Parts of one size, so that none is too short.
            let parts = (next - first).div_ceil(PIECES);
            let last = first + (next - first).div_ceil(parts);
            if last - first >= FEWEST {
                self.mend_part(axis, order, first, last);
            }
            first = last;
        }
    }

    /// Makes the pieces from node `first` to node `last` meet, whose states stay.
    fn mend_part(&mut self, axis: usize, order: usize, first: usize, last: usize) {
        let states: Vec<NodeState> = self.nodes[first..=last].to_vec();
        let times: Vec<f64> = self.times[first..=last].to_vec();
        let carried: Vec<f64> = states.iter().map(|s| s[axis][order]).collect();
        if states.iter().all(|s| s[axis][1..=order].iter().all(|&d| d == 0.0)) {
            return;
        }
        let whole = times[times.len() - 1] - times[0];
        // Changes that vanish at both ends: s (1 - s) s^n.
        let change = |n: usize, k: usize| {
            let s = (times[k] - times[0]) / whole;
            s * (1.0 - s) * s.powi(n as i32)
        };
        let run = |start: &[f64], inputs: &dyn Fn(usize) -> f64| -> Vec<Vec<f64>> {
            let mut chain = vec![start.to_vec()];
            for k in 0..times.len() - 1 {
                chain.push(after(&chain[k], [inputs(k), inputs(k + 1)], times[k + 1] - times[k]));
            }
            chain
        };
        let start = states[0][axis][..order].to_vec();
        // Derivative i in units of whole^-i, so that all equations are of one size.
        let scale = |i: usize| whole.powi(i as i32);
        let rest = vec![0.0; order];
        let response = DMatrix::from_fn(order, order, |i, n| {
            run(&rest, &|k| change(n, k)).last().map_or(0.0, |end| end[i] * scale(i))
        });
        let Some(inverse) = response.lu().try_inverse() else { return };
        let mut weights = DVector::zeros(order);
        // The second time takes what rounding left of the first.
        for _ in 0..2 {
            let changed = |k: usize| carried[k] + (0..order).map(|n| weights[n] * change(n, k)).sum::<f64>();
            let chain = run(&start, &changed);
            let end = &chain[chain.len() - 1];
            let target = &states[states.len() - 1][axis];
            let missed = DVector::from_fn(order, |i, _| (target[i] - end[i]) * scale(i));
            weights += &inverse * missed;
        }
        let changed = |k: usize| carried[k] + (0..order).map(|n| weights[n] * change(n, k)).sum::<f64>();
        for (k, state) in run(&start, &changed).into_iter().enumerate() {
            let node = &mut self.nodes[first + k][axis];
            if k + 1 < times.len() {
                node[..order].copy_from_slice(&state);
            }
            if k > 0 && k + 1 < times.len() {
                node[order] = changed(k);
            }
        }
    }
}

/// What gaps have grown into after another `h` seconds.
fn after_gap(moved: &[f64], h: f64) -> Vec<f64> {
    after(moved, [0.0; 2], h)
}
