//! The second pass over a plan: at its durations, comfort beside least snap.

use super::*;
use crate::planner::comfort::Comfort;

impl ScpPlanner<'_, '_> {
    /// A plan at the durations of another that is nearer to the lines of its legs and turns less; `None` where none was
    /// found.
    pub fn more_comfortable(&mut self, planned: &Planned) -> Option<Planned> {
        let mut best = None;
        for _ in 0..self.settings.comfort.passes {
            let Some(found) = self.once_more_comfortable(best.as_ref().unwrap_or(planned)) else { break };
            best = Some(found);
        }
        best
    }

    fn once_more_comfortable(&mut self, planned: &Planned) -> Option<Planned> {
        let iterate = self.iterate_of(planned);
        let settings = self.settings.comfort;
        let form = self.transcription(&iterate.grid, &[]);
        let none = Comfort { distance: 0.0, yaw: 0.0, yaw_rate: 0.0 };
        let snap = self.cost(&iterate);
        // Each mean square counts as much as the whole cost (48) where it is that of its unit, and at most
        // `settings.most` times as much: where little is free, steps could not gain.
        let weight = |unit: f64, only: Comfort| {
            let here = form.comfort_of(&only, &iterate.states).max(f64::MIN_POSITIVE);
            (snap / (iterate.grid.total * unit * unit)).min(settings.most * snap / here)
        };
        let comfort = Comfort {
            distance: weight(settings.distance, Comfort { distance: 1.0, ..none }),
            yaw: weight(settings.yaw, Comfort { yaw: 1.0, ..none }),
            yaw_rate: weight(settings.yaw_rate, Comfort { yaw_rate: 1.0, ..none }),
        };
        self.comfort = Some(comfort);
        let before = self.cost(&iterate);
        let found = self.restored_plan(iterate, planned.grid.total, self.settings.cost.close, &mut BTreeSet::new());
        self.comfort = None;
        let found = found.filter(|found| found.objective < (1.0 - settings.least_gain) * before)?;
        let objective = self.cost(&self.iterate_of(&found));
        Some(Planned { objective, ..found })
    }
}
