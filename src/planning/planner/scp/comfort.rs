//! The second pass over a plan: at its durations, comfort beside least snap.

use super::*;
use crate::planner::comfort::Comfort;

impl ScpPlanner<'_, '_> {
    /// A plan at the durations of another that is nearer to the lines of its legs and turns less; `None` where none was
    /// found.
    pub fn more_comfortable(&mut self, planned: &Planned) -> Option<Planned> {
        let iterate = self.iterate_of(planned);
        let settings = self.settings.comfort;
        // Each mean square counts as much as the whole cost (48) where it is that of its unit.
        let unit = |size: f64| self.cost(&iterate) / (iterate.grid.total * size * size);
        let comfort =
            Comfort { distance: unit(settings.distance), yaw: unit(settings.yaw), yaw_rate: unit(settings.yaw_rate) };
        self.comfort = Some(comfort);
        let found = self.restored_plan(iterate, planned.grid.total, self.settings.cost.close, &mut BTreeSet::new());
        self.comfort = None;
        let found = found?;
        let objective = self.cost(&self.iterate_of(&found));
        Some(Planned { objective, ..found })
    }
}
