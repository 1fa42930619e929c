//! The feasibility phase (restoration) at fixed durations: steps that minimise the violation until the iterate is
//! feasible.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{ProximalWeight, ScpPlanner, Weights};
use crate::planner::transcription::{Row, RowAt};
use std::collections::{BTreeMap, BTreeSet};

impl ScpPlanner<'_, '_> {
    /// The feasibility phase: steps that minimise the violation, until the iterate is feasible at every instant. `None`
    /// if it does not converge, which proves nothing.
    pub(super) fn restore_feasibility(
        &mut self,
        iterate: Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        self.restore_feasibility_within(iterate, self.settings.feasibility.max_predicted, working_set)
    }

    /// The same, ended if the linear model predicts more violation than `max_predicted`.
    pub(super) fn restore_feasibility_within(
        &mut self,
        mut iterate: Iterate,
        max_predicted: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (settings, proximal_settings) = (self.settings.feasibility, self.settings.proximal);
        let durations = self.fixed_durations();
        let mut proximal = ProximalWeight { weight: settings.proximal_weight };
        let mut violation = self.largest_violation_with(&iterate, working_set);
        // A nearly feasible iterate needs no very different inputs.
        let input_weight = if violation < settings.nearly_feasible { self.input_weight } else { 0.0 };
        let mut weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight };
        let mut history = Vec::new();
        let mut predicted: Vec<f64> = Vec::new();
        let mut rejected = 0;
        self.forget_multipliers();
        while violation > 0.0 {
            history.push(violation);
            let is_slow = violation > settings.nearly_feasible
                && history.len() > settings.patience
                && violation > settings.required_fall * history[history.len() - 1 - settings.patience];
            if history.len() > settings.max_steps || is_slow || proximal.is_exhausted(&proximal_settings) {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, working_set)?;
            predicted.push(stepped.sigma);
            let (unavoidable, steady) = (settings.unavoidable, settings.steady_ratio);
            let is_unavoidable =
                matches!(predicted[..], [.., before, _, last] if last > f64::max(unavoidable, steady * before));
            if stepped.sigma > max_predicted || is_unavoidable {
                if weights.input_weight == 0.0 {
                    return None;
                }
                // Where most inputs are small any change is a large share of them: this planner goes on without the
                // weight.
                (self.input_weight, weights.input_weight) = (0.0, 0.0);
                predicted.clear();
                history.clear();
                continue;
            }
            // If only a share of this step is taken, the next subproblem still needs the rows that the full step
            // violates.
            let whole = iterate.with_states(stepped.states.clone());
            working_set.extend(self.rows_violated_most(&whole));
            violation = self.largest_violation_with(&iterate, working_set);
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.largest_violation_with(&reached, working_set);
                let enough = now <= violation - settings.sufficient_decrease * share * (violation - stepped.sigma);
                if enough || share < 2.0 * settings.min_share {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.increased(&proximal_settings);
            }
            if now < violation {
                (iterate, violation) = (reached, now);
            } else {
                // No share of the step lowers the violation: the subproblem lacked rows, and gets those that the step
                // violates. Where these are more than it had, the step was much too long: it gets those near by, and
                // the next step is shorter.
                let violated: BTreeSet<RowAt> = &self.rows_at_nodes(&whole, 0.0) | &self.rows_between(&whole);
                if violated.len() > working_set.len() {
                    working_set.extend(self.rows_at_nodes(&reached, 0.0));
                    working_set.extend(self.rows_between(&reached));
                    proximal.weight *= settings.proximal_increase_after_rejection;
                } else {
                    working_set.extend(violated);
                }
                history.pop();
                rejected += 1;
                if rejected > settings.max_rejected {
                    return None;
                }
            }
        }
        // If only a share of a step or no step was taken, gaps remain at waypoints where durations have changed.
        if !iterate.is_joined(self.settings.subproblem.joined_within) {
            let joined = self.joined(&iterate, working_set)?;
            return self.restore_feasibility_within(joined, max_predicted, working_set);
        }
        self.prune(&iterate, working_set);
        Some(iterate)
    }

    /// Drops the rows with more slack at an iterate than `SubproblemSettings::slack_of_working_set`.
    fn prune(&self, iterate: &Iterate, working_set: &mut BTreeSet<RowAt>) {
        let form = self.transcription(&iterate.grid, &[]);
        let mut known = BTreeMap::new();
        working_set.retain(|r| {
            let state = iterate.at(r.instant);
            let violation = match r.row {
                Row::Facet(facet) => {
                    self.violation_of_facet(facet, self.wrench_at_instant(iterate, r.instant, &mut known))
                }
                Row::Limit(limit) => match &self.mission().limits[limit] {
                    limit if form.covers(limit, r.instant) => form.violation_of(limit, &state, 0.0),
                    _ => f64::NEG_INFINITY,
                },
                Row::Upright => form.violation_upright(&state),
                Row::Command { facet, slope } => self.command_violation_of(iterate, facet, (r.instant, slope)),
            };
            violation > -self.settings.subproblem.slack_of_working_set
        });
    }
}
