//! How long a mission is committed to each mode, by what it does after a fault.

use super::Setting;
use crate::admissible::without_yaw::planned::Provision;
use crate::model::AfterFault;
use crate::motion::Trajectory;
use crate::motion::outside::{Outside, violation_intervals};
use crate::planner::selection::PlanningSet;
use crate::planner::stop::Stops;
use rayon::prelude::*;
use std::sync::PoisonError;

impl Setting<'_> {
    /// The last time, s, at which a fault of each mode would still meet a violation: if the mission goes on after the
    /// fault, the last instant outside the mode's set; if it holds, the last one from which no stop inside the set was
    /// found; if it is caught and landed, all of the mission. In the order of `against`.
    pub(super) fn committed(&self, trajectory: &Trajectory, outside: &[Outside]) -> Vec<f64> {
        let against = self.model().plan.against.par_iter().zip(&self.sets.modes).zip(outside);
        against
            .zip(&self.sets.provisions)
            .map(|(((&mode, set), out), provision)| match self.model().after_fault(mode) {
                // No row says anything of such a fault.
                _ if *provision == Provision::Capture => trajectory.duration(),
                AfterFault::Hold | AfterFault::Land | AfterFault::Recovery => self.without_stop(trajectory, set),
                AfterFault::Continue => out.committed(),
            })
            .collect()
    }

    /// The last instant from which no stop was found, s; 0 where there is none.
    ///
    /// Searched from the end backwards, to the first node without a stop. While the plan stays inside the set, it can
    /// be flown on until a stop begins, so stops are sought only at nodes after which the plan leaves the set.
    fn without_stop(&self, trajectory: &Trajectory, set: &PlanningSet) -> f64 {
        let model = self.model();
        let mut stops = Stops::new(self.problem, &self.sets.healthy, set, trajectory.model);
        let mut sought = |node: usize| stops.find(&trajectory.nodes[node]).is_some();
        let last = trajectory.intervals();
        let mut committed = 0.0;
        // A mission that ends at rest has stopped there.
        if !self.mission().end_at_rest && !sought(last) {
            committed = trajectory.duration();
        } else {
            for node in (0..last).rev() {
                let (outside, _) =
                    violation_intervals(trajectory, &model.vehicle, &model.environment(), &set.rows, node);
                let left = outside.iter().map(|s| s.to).max_by(f64::total_cmp);
                if let Some(left) = left.filter(|_| !sought(node)) {
                    committed = left;
                    break;
                }
            }
        }
        *self.stopping.lock().unwrap_or_else(PoisonError::into_inner) += stops.effort();
        committed
    }
}
