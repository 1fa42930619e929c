//! How much of the solver's work a search may take. Work is counted, not timed, so that results depend neither on the
//! machine nor on what else it does.

use super::ScpPlanner;
use crate::model::SearchEffort;

impl ScpPlanner<'_, '_> {
    /// The work of a search at the spec's effort.
    fn budget(&self) -> f64 {
        let settings = self.settings.budget;
        match self.model().plan.effort {
            SearchEffort::Quick => settings.quick,
            SearchEffort::Normal => settings.normal,
            SearchEffort::Thorough => settings.thorough,
        }
    }

    /// Reports that a mission time, s, is tried.
    pub(super) fn begins_trial(&mut self, time: f64) {
        self.hover.trial.budget_left = Some((1.0 - self.hover.effort.work as f64 / self.budget()).max(0.0));
        self.hover.begins_trial(time);
    }

    /// Whether a search has taken more than this share of its budget. Once what it has is enough
    /// ([`crate::cancel::is_enough`]), it gets as much as a quick search has after its coarse grid: a plan on the full
    /// grid has to be made of what it has.
    pub(super) fn has_spent(&self, share: f64) -> bool {
        let (settings, work) = (self.settings.budget, self.hover.effort.work);
        if work as f64 > share * self.budget() {
            return true;
        }
        if !crate::cancel::is_enough() {
            return false;
        }
        let enough_at = self.enough_at.get().unwrap_or(work);
        self.enough_at.set(Some(enough_at));
        (work - enough_at) as f64 >= (share - settings.until_coarse_grid) * settings.quick
    }

    /// Whether the rest of the budget is needed to finish a plan on the full grid.
    pub(super) fn has_to_finish(&self) -> bool {
        let settings = self.settings.budget;
        let step = self.work_by_interval * self.model().plan.samples as f64;
        self.hover.effort.work as f64 + settings.finishing_steps * step > settings.at_most * self.budget()
    }

    /// The number of waypoints with a hold.
    pub(super) fn holds(&self) -> usize {
        self.mission().waypoints.iter().filter(|w| w.hold > 0.0).count()
    }

    /// The share of the budget at which steps to shorter times end on a grid: finer grids come after it, and the cost
    /// phase of the plan.
    pub(super) fn share_until(&self, intervals: usize) -> f64 {
        let settings = self.settings.budget;
        let samples = intervals + self.holds();
        match self.medium_grid() {
            _ if samples >= self.model().plan.samples => settings.until_full_grid,
            Some(medium) if samples >= medium => settings.until_medium_grid,
            _ => settings.until_coarse_grid,
        }
    }
}
