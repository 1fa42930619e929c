//! The cost phase at fixed durations: steps that minimise the cost (48), judged by a merit function with an exact
//! penalty.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{ProximalWeight, ScpPlanner, Weights, settings};
use crate::planner::transcription::RowAt;
use settings::StoppingRule;
use std::collections::BTreeSet;

/// The state of a cost phase.
struct CostPhase {
    /// Steps that it may still take.
    left: usize,
    proximal: ProximalWeight,
    weights: Weights,
}

impl ScpPlanner<'_, '_> {
    /// The cost phase. The iterate given and the one returned are feasible at every instant; iterates in between are
    /// judged by the merit function: the relative cost, with a penalty on the violation.
    pub(super) fn minimise_cost(
        &mut self,
        iterate: Iterate,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let settings = self.settings.cost;
        let (objective, penalty) = (Objective::Cost, settings.penalty);
        let weights = Weights { objective, penalty, cost_weight: 1.0, input_weight: 0.0 };
        let mut phase = CostPhase {
            left: rule.max_steps,
            proximal: ProximalWeight { weight: self.proximal_weight_of_cost_phase },
            weights,
        };
        let mut best = (self.cost(&iterate), iterate);
        loop {
            let outside = self.lower_merit(&mut best, &mut phase, rule.min_gain, working_set);
            self.proximal_weight_of_cost_phase = phase.proximal.weight.min(settings.max_initial_proximal_weight);
            // If the last iterate is infeasible, the nearest feasible one may well be the best, or lead to it.
            let mut known = working_set.clone();
            let Some(inside) = outside.and_then(|outside| self.restore_feasibility(outside, &mut known)) else {
                return best.1;
            };
            let (cost, was) = (self.cost(&inside), best.0);
            if cost < was {
                *working_set = known;
                best = (cost, inside);
            }
            if phase.left == 0 || cost > (1.0 - rule.min_gain) * was {
                return best.1;
            }
            let most = settings.max_proximal_weight_after_restoration;
            phase.proximal.weight = phase.proximal.weight.min(most);
        }
    }

    /// The steps of [`Self::minimise_cost`] from `best`, which is feasible and is replaced by the cheapest feasible
    /// iterate on the way. Returns the last iterate if it is infeasible and cheaper.
    fn lower_merit(
        &mut self,
        best: &mut (f64, Iterate),
        CostPhase { left, proximal, weights }: &mut CostPhase,
        min_gain: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (settings, proximal_settings) = (self.settings.cost, self.settings.proximal);
        let durations = self.fixed_durations();
        let (mut at, mut violation) = (best.1.clone(), 0.0);
        let budget = self.settings.budget;
        let share_of_budget = if self.comfort.is_some() { budget.of_comfort } else { budget.until_cost };
        while *left > 0 && !self.has_spent(share_of_budget) {
            *left -= 1;
            let here = self.cost(&at);
            let Some(stepped) = self.step(&at, &durations, *proximal, *weights, working_set) else { break };
            // A sigma below the margin of the tightening is feasible.
            let sigma = stepped.sigma - self.settings.tightening.margin;
            // The cost outweighs the penalty: the penalty is raised and the subproblem solved again.
            if sigma > 0.0 && weights.penalty < settings.max_penalty {
                weights.penalty *= settings.penalty_growth;
                continue;
            }
            let penalty = weights.penalty;
            let merit = |cost: f64, violation: f64| cost / here + penalty * f64::max(violation, 0.0);
            let was = merit(here, violation);
            let towards = |s: &Self, working_set: &BTreeSet<RowAt>, share: f64| {
                let reached = at.with_states(at.towards(&stepped.states, share));
                (s.cost(&reached), s.largest_violation_with(&reached, working_set), reached)
            };
            let expected = was - merit(self.cost(&at.with_states(stepped.states.clone())), sigma);
            if expected <= 0.0 && sigma <= 0.0 {
                break; // the linear model predicts no gain
            }
            let mut share = 1.0;
            let (mut cost, mut now, mut reached) = towards(self, working_set, share);
            while was - merit(cost, now) < settings.sufficient_gain * share * expected && share > settings.min_share {
                share *= 0.5;
                (cost, now, reached) = towards(self, working_set, share);
            }
            let gained = was - merit(cost, now);
            if now <= 0.0 && cost < best.0 {
                *best = (cost, reached.clone());
            }
            working_set.extend(self.rows_between(&reached));
            *proximal = match share {
                1.0 if expected > 0.0 => proximal.after(gained, expected, &proximal_settings),
                _ => proximal.after_share(share, &proximal_settings),
            };
            if gained > 0.0 {
                // Evaluated again, at the instants that the working set has now.
                at = reached;
                violation = self.largest_violation_with(&at, working_set);
            }
            if expected < min_gain && sigma <= 0.0 || proximal.is_exhausted(&proximal_settings) {
                break;
            }
        }
        (violation > 0.0 && self.cost(&at) < best.0).then_some(at)
    }

    /// The cost (48) of an iterate.
    pub(super) fn cost(&self, iterate: &Iterate) -> f64 {
        self.transcription(&iterate.grid, &[]).cost_of(&iterate.states)
    }
}
