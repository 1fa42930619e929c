//! A yaw that follows from the motion, in the initial guess: the steps take its direction anew from each iterate.

use super::ScpPlanner;
use super::iterate::Iterate;
use crate::model::Limit;
use crate::model::{Heading, LimitKind};
use crate::motion::time_grid::TimeGrid;
use crate::motion::{NodeState, X, Y, YAW};
use crate::planner::limits::covers;
use std::f64::consts::TAU;

/// How often the yaw of the initial guess is solved for about the path that came of it. Chosen by hand.
const ROUNDS: usize = 2;

impl ScpPlanner<'_, '_> {
    /// An initial guess whose yaw follows from its own path where the mission requires it; unchanged if it requires
    /// none or if no such guess was found.
    pub(super) fn headed(&mut self, grid: &TimeGrid, mut iterate: Iterate) -> Iterate {
        if !self.mission().limits.iter().any(|limit| limit.kind.is_heading()) {
            return iterate;
        }
        for _ in 0..ROUNDS {
            let about = iterate.with_states(self.with_continuous_yaw(&iterate));
            let positions = self.positions(&about);
            match self.minimum_snap_about(grid, positions.as_deref(), Some(&about)) {
                Some(next) => iterate = next,
                None => break,
            }
        }
        iterate
    }

    /// The states with the yaw that they have to follow, continued from node to node by the shorter way.
    fn with_continuous_yaw(&self, iterate: &Iterate) -> Vec<NodeState> {
        let mission = self.mission();
        let limits: Vec<&Limit> = mission.limits.iter().filter(|limit| limit.kind.is_heading()).collect();
        let mut last = mission.waypoints[0].yaw;
        let mut states = iterate.states.clone();
        for (node, state) in states.iter_mut().enumerate() {
            let holds = |limit: &&&Limit| covers(limit, &iterate.grid.waypoint_nodes, 1, node);
            let targets = limits.iter().filter(holds).filter_map(|limit| match limit.kind {
                LimitKind::Heading(target) => Some(target),
                _ => None,
            });
            let [position, velocity] = [0, 1].map(|order| [X, Y].map(|axis| state[axis][order]));
            if let Some([x, y]) = targets.into_iter().find_map(|target| target.direction(position, velocity)) {
                let turn = y.atan2(x) - last;
                last += turn - TAU * (turn / TAU).round();
                state[YAW][0] = last;
            } else if let Some(waypoint) = iterate.grid.waypoint_nodes.iter().position(|&n| n == node)
                && matches!(mission.waypoints[waypoint].heading, Heading::Given | Heading::Free)
            {
                // Where a yaw follows from a motion that rests here, the guess has none to continue from.
                last = state[YAW][0];
            }
        }
        states
    }
}
