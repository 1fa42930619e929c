//! Shorter mission times: steps with the durations of legs as variables, judged by a merit function of the time and the
//! violation.
//!
//! Iterates need not be feasible: each step shortens the mission and removes most of the violation that the last one
//! left, so that no step is restored by itself (an exact penalty method: Nocedal and Wright, *Numerical Optimization*,
//! section 18.5). The weight of the violation in the merit function follows the multipliers, so that it is large enough
//! for a minimum at a feasible iterate, and rarely much larger.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{Durations, ProximalWeight, ScpPlanner, Weights, settings};
use crate::planner::transcription::RowAt;
use settings::DurationSettings;
use std::collections::BTreeSet;

/// How far steps may go. With the next weight of the cost they begin where they ended with the last.
#[derive(Debug, Clone, Copy)]
struct Pace {
    /// Largest relative change of a duration.
    radius: f64,
    proximal: ProximalWeight,
}

impl Pace {
    /// After a step of which `share` was taken, with this ratio of actual to predicted gain.
    fn after(self, share: f64, ratio: f64, settings: &DurationSettings) -> Pace {
        let weight = self.proximal.weight;
        let (radius, weight) = match share {
            1.0 if ratio > settings.good_ratio => {
                let less = settings.proximal_decrease * weight;
                ((settings.radius_growth * self.radius).min(settings.max_radius), less.max(settings.proximal_weight))
            }
            1.0 => (self.radius, weight),
            // A share that is no smaller than the line search allows may not even have gained.
            _ if share <= settings.min_share => (share * self.radius, settings.proximal_increase * weight / share),
            _ => (share.sqrt() * self.radius, settings.proximal_increase * weight / share),
        };
        Pace { radius, proximal: ProximalWeight { weight } }
    }
}

/// A sequence of steps.
struct Shortening {
    at: Iterate,
    /// The shortest feasible iterate on the way.
    best: Option<Iterate>,
    pace: Pace,
    /// Steps that it may still take.
    left: usize,
    /// The mission is not shortened below this flight, s.
    target: f64,
    /// Whether the linear model has ceased to remove the violation.
    is_hopeless: bool,
}

impl Shortening {
    /// Keeps the iterate, which has no violation, if it is the shortest so far.
    fn keep(&mut self) {
        if self.best.as_ref().is_none_or(|best| self.at.grid.total < best.grid.total) {
            self.best = Some(self.at.clone());
        }
    }
}

impl ScpPlanner<'_, '_> {
    /// How the durations of legs change: each by itself where the planner chooses the waypoint times, else all alike.
    pub(super) fn durations_to_shorten(&self, radius: f64) -> Durations {
        let range = (-radius, radius);
        match self.chooses_times() {
            true => {
                let spans = self.spans();
                Durations { legs: self.changing(&spans), range, spans }
            }
            false => Durations { legs: vec![Some(0); self.mission().legs.len()], range, spans: Vec::new() },
        }
    }

    /// Shortens an iterate, feasible or not, to `target` s of flight or until steps gain little, with each relative
    /// weight of the cost in turn and a first `radius`. The result is feasible and on the same grid, and not longer
    /// than the iterate if that is feasible; `None` if no feasible iterate is reached.
    pub(super) fn shorten(
        &mut self,
        iterate: Iterate,
        cost_weights: &[f64],
        radius: f64,
        target: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let settings = self.settings.durations;
        let pace = Pace { radius, proximal: ProximalWeight { weight: settings.proximal_weight } };
        let mut steps =
            Shortening { at: iterate, best: None, pace, left: settings.max_steps, target, is_hopeless: false };
        self.forget_multipliers();
        for &weight in cost_weights {
            self.shorten_with(&mut steps, weight, working_set);
            if steps.is_hopeless {
                return steps.best;
            }
        }
        self.restored_if_shorter(steps, working_set)
    }

    /// The last iterate of a sequence of steps if it can be restored, at its own time, the target or a little later,
    /// and is shorter than the best; else the best.
    fn restored_if_shorter(&mut self, steps: Shortening, working_set: &mut BTreeSet<RowAt>) -> Option<Iterate> {
        let Shortening { at, best, target, .. } = steps;
        let max_predicted = self.settings.feasibility.max_predicted_after_change;
        for factor in self.settings.grids.slowdowns {
            let later = self.lasting(&at, (factor * at.grid.total).max(target));
            if best.as_ref().is_some_and(|best| later.grid.total >= best.grid.total) {
                break;
            }
            let (mut known, time) = (working_set.clone(), later.grid.total + self.held());
            let restored = self.restore_feasibility_within(later, max_predicted, &mut known);
            self.hover.trial.note(time, restored.is_some());
            if restored.is_some() {
                *working_set = known;
                return restored;
            }
        }
        best
    }

    /// The steps with one weight of the cost.
    fn shorten_with(&mut self, steps: &mut Shortening, cost_weight: f64, working_set: &mut BTreeSet<RowAt>) {
        let settings = self.settings.durations;
        let (penalty, input_weight) = (settings.penalty, settings.input_weight);
        let weights = Weights { objective: Objective::Time, penalty, cost_weight, input_weight };
        let share_of_budget = self.share_until(steps.at.grid.intervals());
        let mut violation = self.largest_violation_with(&steps.at, working_set);
        let (mut slow, mut hopeless, mut was_repeated, mut saves, mut price) = (0, 0, false, false, 0.0_f64);
        steps.pace.radius = steps.pace.radius.max(settings.least_first_radius);
        // Short steps that still save time may become longer again.
        while (steps.pace.radius >= settings.min_radius || saves)
            && steps.left > 0
            && !self.has_spent(share_of_budget)
            && !self.has_to_finish()
        {
            if violation <= 0.0 {
                steps.keep();
                self.hover.trial.note(steps.at.grid.total + self.held(), true);
                if steps.at.grid.total <= steps.target {
                    return;
                }
            }
            steps.left -= 1;
            self.begins_trial(steps.at.grid.total + self.held());
            let durations = self.durations_to_shorten(steps.pace.radius);
            let stepped = self.step(&steps.at, &durations, steps.pace.proximal, weights, working_set);
            let Some(stepped) = stepped else {
                steps.pace = steps.pace.after(settings.min_share, 0.0, &settings);
                continue;
            };
            let at = &steps.at;
            let reached = |share: f64| {
                let changes: Vec<f64> = stepped.changes.iter().map(|change| share * change).collect();
                at.stepped(&at.towards(&stepped.states, share), &changes)
            };
            let whole = reached(1.0);
            let known = working_set.len();
            working_set.extend(self.rows_violated_most(&whole));
            let has_new_rows = working_set.len() > known;
            violation = self.largest_violation_with(at, working_set);
            price = (settings.price_decay * price).max(stepped.price);
            let weight = (settings.price_factor * price).max(settings.least_price);
            let target = steps.target;
            let merit = |total: f64, violation: f64| total.max(target) / at.grid.total + weight * violation.max(0.0);
            let was = merit(at.grid.total, violation);
            let expected = was - merit(whole.grid.total, stepped.sigma - self.settings.tightening.margin);
            let taken = |share: f64, planner: &Self, working_set: &BTreeSet<RowAt>| {
                let next = reached(share);
                let left = planner.largest_violation_with(&next, working_set);
                (was - merit(next.grid.total, left), left, next)
            };
            let mut share = 1.0;
            let (mut gained, mut left, mut next) = taken(share, self, working_set);
            while gained < settings.sufficient_gain * share * expected && share > settings.min_share {
                share *= 0.5;
                (gained, left, next) = taken(share, self, working_set);
            }
            if share < 1.0 && has_new_rows && !was_repeated {
                // The subproblem lacked rows that its step violates: it is solved once more with those of the share.
                working_set.extend(self.rows_at_nodes(&next, 0.0));
                working_set.extend(self.rows_between(&next));
                was_repeated = true;
                continue;
            }
            was_repeated = false;
            let is_hopeless = stepped.price > 0.9 * settings.penalty
                && left > self.settings.feasibility.nearly_feasible
                && left > 0.5 * violation;
            hopeless = if is_hopeless { hopeless + 1 } else { 0 };
            let saved = 1.0 - whole.grid.total.max(target) / at.grid.total;
            let is_slow = saved < settings.min_gain && violation < self.settings.feasibility.nearly_feasible;
            slow = if is_slow { slow + 1 } else { 0 };
            steps.is_hopeless = hopeless > settings.most_hopeless;
            if steps.is_hopeless || expected <= 0.0 && violation <= 0.0 {
                return;
            }
            steps.pace = steps.pace.after(share, gained / expected, &settings);
            saves = gained > 0.0 && next.grid.total < (1.0 - settings.min_gain) * steps.at.grid.total;
            if gained > 0.0 {
                (steps.at, violation) = (next, left);
                working_set.extend(self.rows_between(&steps.at));
            }
            if slow > settings.most_slow {
                break;
            }
        }
        if violation <= 0.0 {
            steps.keep();
        }
    }
}
