//! Steps to an iterate that branches off after a fault and stays inside the set: short attempts, because risk figures
//! need dozens of them, and recovery hundreds.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{ALL_AXES, ProximalWeight, ScpPlanner, Weights};
use crate::motion::NodeState;
use crate::motion::time_grid::TimeGrid;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::branch::Ending;
use std::collections::BTreeSet;

/// States count as equal within this, as a share of their size (at least 1, in SI units): the solver leaves less.
const BEGINS_WITHIN: f64 = 1e-5;

impl ScpPlanner<'_, '_> {
    /// The branch `HoverPlanner::branch` over a time grid; `None` where the steps find none.
    pub fn branch(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        let smooth = self.minimum_snap(grid)?;
        let violation = self.largest_violation(&smooth);
        self.branch_by_steps(smooth, violation)
    }

    /// A branch over a time grid that begins near the straight line between two places, m, or near a way around the
    /// volumes between them.
    pub fn branch_along(&mut self, grid: &TimeGrid, from: [f64; 3], to: [f64; 3]) -> Option<Iterate> {
        let Some(way) = self.way_between(grid, from, to) else { return self.branch(grid) };
        let around = self.minimum_snap_about(grid, Some(&way), None)?;
        let violation = self.largest_violation(&around);
        self.branch_by_steps(around, violation)
    }

    /// A branch with a known one from another state as the initial guess.
    pub fn branch_about(&mut self, other: Iterate) -> Option<Iterate> {
        self.branch_by_steps(other, f64::INFINITY)
    }

    /// With an infinite `violation` the iterate is not one of this mission, and the first step is taken whole. So is
    /// one from an iterate that violates nothing but begins in another state: minimum-snap motions over long legs do,
    /// because they are solved in another time.
    fn branch_by_steps(&mut self, mut iterate: Iterate, mut violation: f64) -> Option<Iterate> {
        let (settings, margin) = (self.settings.stops, self.settings.tightening.margin);
        let proximal_settings = self.settings.proximal;
        let durations = self.fixed_durations();
        let linear = matches!(self.wrench, WrenchModel::HoverAt(_));
        let mut proximal = ProximalWeight {
            weight: if linear { settings.proximal_weight_if_linear } else { settings.proximal_weight },
        };
        let weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight: 0.0 };
        let mut working_set = BTreeSet::new();
        let mut history: Vec<f64> = Vec::new();
        self.multipliers.clear();
        if violation <= 0.0 && !self.keeps_its_ends(&iterate) {
            violation = f64::INFINITY;
        }
        while violation > 0.0 {
            history.push(violation);
            let is_slow = !linear
                && history.len() > settings.patience
                && violation > settings.required_fall * history[history.len() - 1 - settings.patience];
            if history.len() > settings.max_steps || is_slow || proximal.is_exhausted(&proximal_settings) {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, &mut working_set)?;
            if linear && stepped.sigma > 2.0 * margin {
                return None; // this program is not an approximation, and no row that it lacks would help
            }
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.largest_violation(&reached);
                let enough = now <= violation - settings.sufficient_decrease * share * (violation - stepped.sigma);
                if share == 1.0 && !enough {
                    // A rejected step would otherwise be proposed again.
                    working_set.extend(self.rows_between(&reached));
                }
                if linear || violation.is_infinite() || enough || share < 2.0 * settings.min_share {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.increased(&proximal_settings);
            }
            if linear || now < violation {
                (iterate, violation) = (reached, now);
            }
            if violation <= 0.0 && !self.keeps_its_ends(&iterate) {
                violation = f64::INFINITY;
            }
        }
        Some(iterate)
    }

    /// Whether an iterate begins with the position and the velocity of its branch, and ends with those that the branch
    /// joins.
    fn keeps_its_ends(&self, iterate: &Iterate) -> bool {
        let (Some(branch), [first, .., last]) = (&self.hover.branch, &iterate.states[..]) else { return true };
        let is_near = |due: &NodeState, there: &NodeState| {
            ALL_AXES
                .into_iter()
                .flat_map(|axis| [0, 1].map(|order| (due[axis][order], there[axis][order])))
                .all(|(due, there)| (there - due).abs() <= BEGINS_WITHIN * due.abs().max(1.0))
        };
        let ends = match &branch.to {
            Ending::Rest => true,
            Ending::Joins(state) => is_near(state, last),
        };
        ends && is_near(&branch.from, first)
    }
}
