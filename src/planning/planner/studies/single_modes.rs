//! RCP against each mode alone.

use super::Setting;
use super::found::Found;
use crate::motion::outside::outside;
use crate::planner::Planned;
use crate::planner::hover::ACCEPTED;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::Hint;
use crate::planner::working_set::WorkingSet;
use crate::solve::Effort;
use rayon::prelude::*;

impl Setting<'_> {
    /// Each mode's own shortest time, in parallel; results in the order of the modes.
    ///
    /// No set imposed here is wider than the healthy one, so no time is shorter than RIP's; a mode in whose set RIP's
    /// plan stays has that plan.
    pub(super) fn singles_own(&self, rip: &Found, hint: Hint) -> Vec<Found> {
        let work = |(name, set): (&String, &PlanningSet)| {
            if rip.planned().is_some_and(|plan| self.is_inside(plan, set)) {
                self.ended(1);
                return Found {
                    result: rip.result.clone(),
                    working_set: WorkingSet::default(),
                    effort: Effort::default(),
                };
            }
            let working_set = rip.working_set.translated(&self.sets.rip, set);
            let initial_guesses = rip.planned().into_iter().chain(&hint.initial_guesses).cloned().collect();
            let hint = Hint { initial_guesses, larger: rip.time(), ..hint.clone() };
            let found = self.search(&format!("RCP {name}"), set, hint, working_set);
            self.ended(1);
            found
        };
        self.sets.names.par_iter().zip(self.sets.singles.par_iter()).map(work).collect()
    }

    /// Whether a plan of RIP stays inside a smaller set too. False with rotors that lag, whose commands would have to
    /// as well.
    pub(super) fn is_inside(&self, plan: &Planned, set: &PlanningSet) -> bool {
        let found = || outside(&plan.trajectory(), &self.model().vehicle, &self.model().environment(), &set.rows);
        self.model().thrust_lag().is_none() && found().max_violation <= ACCEPTED
    }

    /// A plan against one mode that also stays inside another mode's set, and is shorter than its own, becomes that
    /// mode's too.
    pub(super) fn share(&self, singles: &mut [Found]) {
        // With rotors that lag it is not enough that the wrench stays inside.
        if self.model().thrust_lag().is_some() {
            return;
        }
        let plans: Vec<Planned> = singles.iter().filter_map(Found::planned).cloned().collect();
        for (found, set) in singles.iter_mut().zip(&self.sets.singles) {
            let own = found.time().unwrap_or(f64::INFINITY);
            let stays_inside = |plan: &&Planned| {
                let trajectory = plan.trajectory();
                let out = outside(&trajectory, &self.model().vehicle, &self.model().environment(), &set.rows);
                out.max_violation <= ACCEPTED
            };
            let shorter = plans.iter().filter(|plan| plan.grid.total < own).filter(stays_inside);
            if let Some(plan) = shorter.min_by(|a, b| a.grid.total.total_cmp(&b.grid.total)) {
                *found = found.clone().or_shorter(plan);
            }
        }
    }
}
