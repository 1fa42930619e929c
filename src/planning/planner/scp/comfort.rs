//! The second pass over a plan: at its durations, comfort beside least snap.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{ProximalWeight, ScpPlanner, Weights};
use crate::planner::Planned;
use crate::planner::comfort::Comfort;
use std::collections::BTreeSet;

impl ScpPlanner<'_, '_> {
    /// A plan at the durations of another that is nearer to the lines of its legs and turns less; `None` where none was
    /// found. At a mission time that `is_given`, it also keeps the heights of its legs where such a plan is found.
    pub fn more_comfortable(&mut self, planned: &Planned, is_given: bool) -> Option<Planned> {
        let mut best = None;
        for _ in 0..self.settings.comfort.passes {
            let Some(found) = self.once_more_comfortable(best.as_ref().unwrap_or(planned)) else { break };
            best = Some(found);
        }
        let level = is_given.then(|| self.within_heights(best.as_ref().unwrap_or(planned))).flatten();
        level.or(best)
    }

    fn once_more_comfortable(&mut self, planned: &Planned) -> Option<Planned> {
        let iterate = self.iterate_of(planned);
        self.comfort = Some(self.comfort_about(&iterate));
        let before = self.cost(&iterate);
        let found = self.restored_plan(iterate, planned.grid.total, self.settings.cost.close, &mut BTreeSet::new());
        self.comfort = None;
        let found = found.filter(|found| found.objective < (1.0 - self.settings.comfort.least_gain) * before)?;
        Some(self.with_its_own_cost(found))
    }

    /// The weights of comfort for an iterate: each mean square counts as much as the whole cost (48) where it is that
    /// of its unit, and at most `ComfortSettings::most` times as much: where little is free, steps could
    /// not gain.
    fn comfort_about(&self, iterate: &Iterate) -> Comfort {
        let settings = self.settings.comfort;
        let form = self.transcription(&iterate.grid, &[]);
        let none = Comfort { distance: 0.0, yaw: 0.0, yaw_rate: 0.0, keeps_heights: false };
        let snap = self.cost(iterate);
        let weight = |unit: f64, only: Comfort| {
            let here = form.comfort_of(&only, &iterate.states).max(f64::MIN_POSITIVE);
            (snap / (iterate.grid.total * unit * unit)).min(settings.most * snap / here)
        };
        Comfort {
            distance: weight(settings.distance, Comfort { distance: 1.0, ..none }),
            yaw: weight(settings.yaw, Comfort { yaw: 1.0, ..none }),
            yaw_rate: weight(settings.yaw_rate, Comfort { yaw_rate: 1.0, ..none }),
            keeps_heights: false,
        }
    }

    /// The plan of least cost and comfort within the heights of its legs, at the durations of another that leaves them;
    /// `None` if that does not, or if none was found.
    fn within_heights(&mut self, planned: &Planned) -> Option<Planned> {
        let iterate = self.iterate_of(planned);
        if self.transcription(&iterate.grid, &[]).are_heights_kept(&iterate.states) {
            return None;
        }
        self.comfort = Some(Comfort { keeps_heights: true, ..self.comfort_about(&iterate) });
        let (settings, durations) = (self.settings, self.fixed_durations());
        let weights = Weights {
            objective: Objective::Violation,
            penalty: 1.0,
            cost_weight: 0.0,
            input_weight: self.input_weight,
        };
        let proximal = ProximalWeight { weight: settings.feasibility.proximal_weight };
        let mut working_set = BTreeSet::new();
        // Every step keeps the heights, so that after one full step all iterates do, whatever share of a step is taken.
        let stepped = self.step(&iterate, &durations, proximal, weights, &mut working_set);
        let found = stepped.and_then(|stepped| {
            let level = iterate.with_states(stepped.states);
            self.restored_plan(level, planned.grid.total, settings.cost.close, &mut working_set)
        });
        self.comfort = None;
        let found = self.with_its_own_cost(found?);
        let iterate = self.iterate_of(&found);
        self.transcription(&iterate.grid, &[]).are_heights_kept(&iterate.states).then_some(found)
    }

    /// A plan of a second pass with its cost (48) alone.
    fn with_its_own_cost(&self, planned: Planned) -> Planned {
        Planned { objective: self.cost(&self.iterate_of(&planned)), ..planned }
    }
}
