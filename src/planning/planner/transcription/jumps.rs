//! The jumps (72) of derivatives at waypoints whose legs may change their durations by different shares.

use super::{Form, Transcription};
use crate::motion::{X, Y, YAW, Z};
use crate::planner::spline::{JumpAt, NodeSpline};
use crate::qp::build::Affine;
use std::sync::Arc;

impl Transcription<'_> {
    /// This transcription in the coefficients of splines made before ([`super::splines`]), of this time grid, and of
    /// jumps of one size for each change of a duration. `None` if the grid has too few steps for a jump.
    pub(in crate::planning::planner) fn in_these(self, splines: Arc<[NodeSpline; 2]>) -> Option<Self> {
        let times = &self.grid.node_times;
        let jump_at = |&node: &usize| {
            let of_axis = |axis: usize| {
                let sizes: Vec<f64> =
                    (0..=self.orders[axis]).map(|order| self.size_of_jump(node, axis, order)).collect();
                JumpAt::new(times, node, &sizes)
            };
            Some((node, [of_axis(X)?, of_axis(Y)?, of_axis(Z)?, of_axis(YAW)?]))
        };
        let jumping = self.grid.waypoint_nodes.iter().filter(|&&node| self.legs_of_jump(node).is_some());
        let jumps: Option<Vec<_>> = jumping.map(jump_at).collect();
        jumps.map(|jumps| Transcription { form: Form::Splines(splines, jumps), ..self })
    }

    /// The derivative at the beginning of an interval: that at its first node, and beyond a waypoint the jump there.
    pub(in crate::planning::planner) fn at_beginning(&self, interval: usize, axis: usize, order: usize) -> Affine {
        let mut derivative = self.at_node(interval, axis, order);
        derivative.add(&self.jump(interval, axis, order), 1.0);
        derivative
    }

    /// The jump (72) of a derivative at a waypoint, later side minus earlier side, where the legs there may change
    /// their durations by different shares: in the new time both share one trajectory,
    /// `D (1 - m epsilon) = D' (1 - m epsilon')` to first order.
    pub(in crate::planning::planner) fn jump(&self, node: usize, axis: usize, order: usize) -> Affine {
        match self.size_of_jump(node, axis, order) {
            0.0 => Affine::default(),
            size => self.changes_of_jump(node).times(size),
        }
    }

    /// The jump (72) of a derivative for one unit of [`Self::changes_of_jump`]; 0 where there is none.
    fn size_of_jump(&self, node: usize, axis: usize, order: usize) -> f64 {
        match self.states {
            Some(states) if self.legs_of_jump(node).is_some() => order as f64 * states[node][axis][order],
            _ => 0.0,
        }
    }

    /// `epsilon' - epsilon` of the legs after and before a node.
    pub(super) fn changes_of_jump(&self, node: usize) -> Affine {
        let Some((before, after)) = self.legs_of_jump(node) else { return Affine::default() };
        let mut changes = self.duration_change(after);
        changes.add(&self.duration_change(before), -1.0);
        changes
    }

    /// The legs before and after a node, where their durations may change by different shares.
    fn legs_of_jump(&self, node: usize) -> Option<(usize, usize)> {
        if self.durations.is_empty() || node == 0 || node + 1 == self.nodes() {
            return None;
        }
        let (before, after) = (self.leg_of(node * self.parts), self.leg_of(node * self.parts + 1));
        (self.durations[before] != self.durations[after]).then_some((before, after))
    }
}
