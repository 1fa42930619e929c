//! Closing the gaps between the pieces of a trajectory.
//!
//! Programs satisfy the dynamics only to the solver's tolerance. On fine grids over long flights the remaining gaps add
//! up, and a motion that is integrated from the start drifts away from its nodes. This module changes the inputs
//! slightly so that the pieces meet.

use super::Trajectory;
use crate::motion::NodeState;
use nalgebra::{DMatrix, DVector};

/// The drift at the end, m and rad, above which gaps are closed: a tenth of what the checker accepts
/// (`verify::joints`).
const MOST_DRIFT: f64 = 1e-4;

/// Number of pieces whose gaps are closed together: enough for a small change of the inputs, few enough for a
/// well-conditioned system.
const PIECES: usize = 64;

/// Parts with fewer pieces are left as they are, because their inputs would have to change too much.
const FEWEST: usize = 8;

/// The state of a chain of integrators (derivatives 0 to n - 1) after `h` seconds with an input that is linear from `u`
/// to `v`.
fn after(state: &[f64], [u, v]: [f64; 2], h: f64) -> Vec<f64> {
    let order = state.len();
    let mut all = state.to_vec();
    all.extend([u, (v - u) / h]);
    let late = |i: usize| (i..all.len()).rev().fold(0.0, |sum, j| all[j] + sum * h / (j + 1 - i) as f64);
    (0..order).map(late).collect()
}

impl Trajectory {
    /// The trajectory with its gaps closed on every axis whose drift exceeds 1e-4 m or rad.
    pub fn joined(self) -> Self {
        let orders = self.model.orders();
        let mut joined = self;
        for (axis, &order) in orders.iter().enumerate() {
            if joined.drift(axis, order) > MOST_DRIFT {
                joined.close_gaps(axis, order);
            }
        }
        joined
    }

    /// A bound on how far all gaps of an axis together move its value at the end: `verify::joints` in floating-point
    /// arithmetic.
    fn drift(&self, axis: usize, order: usize) -> f64 {
        let mut drift = vec![0.0; order];
        for k in 0..self.intervals() {
            let h = self.times[k + 1] - self.times[k];
            let end = after(&self.nodes[k][axis][..order], self.inputs(k, axis, order), h);
            drift = after(&drift, [0.0; 2], h);
            for (i, sum) in drift.iter_mut().enumerate() {
                *sum += (end[i] - self.nodes[k + 1][axis][i]).abs();
            }
        }
        drift[0]
    }

    /// The input of an axis at both ends of interval `k`.
    fn inputs(&self, k: usize, axis: usize, order: usize) -> [f64; 2] {
        [self.nodes[k][axis][order], self.nodes[k + 1][axis][order]]
    }

    /// Closes the gaps of an axis part by part, between waypoints, rests and every [`PIECES`] pieces.
    fn close_gaps(&mut self, axis: usize, order: usize) {
        let mut first = 0;
        while first < self.intervals() {
            // The end of a hold is not the node of a waypoint, but the vehicle rests there too.
            let rests = |n: usize| self.nodes[n][axis][1..=order].iter().all(|&d| d == 0.0);
            let ends_here = |&n: &usize| self.waypoint_nodes.contains(&n) || rests(n);
            let next = (first + 1..self.intervals()).find(ends_here).unwrap_or(self.intervals());
            // Parts of similar size, so that none is too short.
            let parts = (next - first).div_ceil(PIECES);
            let last = first + (next - first).div_ceil(parts);
            if last - first >= FEWEST {
                self.close_gaps_between(axis, order, first, last);
            }
            first = last;
        }
    }

    /// Makes the pieces from node `first` to node `last` meet. The states of these two nodes do not change.
    fn close_gaps_between(&mut self, axis: usize, order: usize, first: usize, last: usize) {
        let states: Vec<NodeState> = self.nodes[first..=last].to_vec();
        let times: Vec<f64> = self.times[first..=last].to_vec();
        let carried: Vec<f64> = states.iter().map(|s| s[axis][order]).collect();
        if states.iter().all(|s| s[axis][1..=order].iter().all(|&d| d == 0.0)) {
            return;
        }
        let whole = times[times.len() - 1] - times[0];
        // The inputs change by a combination of s (1 - s) s^n, n < order, which vanish at both ends.
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
        // Derivative i is scaled by whole^i, so that all equations are of similar size.
        let scale = |i: usize| whole.powi(i as i32);
        let rest = vec![0.0; order];
        let response = DMatrix::from_fn(order, order, |i, n| {
            run(&rest, &|k| change(n, k)).last().map_or(0.0, |end| end[i] * scale(i))
        });
        let Some(inverse) = response.lu().try_inverse() else { return };
        let mut weights = DVector::zeros(order);
        // The second iteration removes the rounding error of the first.
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
