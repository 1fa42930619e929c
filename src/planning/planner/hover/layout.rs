//! A mission laid out in time.

use crate::model::Model;
use crate::motion::time_grid::TimeGrid;
use crate::planner::commands::CommandMaps;
use crate::planner::yaw::YawPlan;

/// The time grid and the planned yaw of a mission over one mission time: what does not depend on the set.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    pub grid: TimeGrid,
    /// The time grid without holds, on which programs are built.
    pub flown: TimeGrid,
    /// At the nodes of `flown`.
    pub yaw: YawPlan,
}

impl Layout {
    /// The commanded wrench at both ends of every interval flown, if the spec's rotors lag.
    pub fn commands(&self, model: &Model) -> Option<CommandMaps> {
        let tau = model.thrust_lag()?;
        Some(self.yaw.commands(&model.vehicle, model.gravity, &self.flown, tau))
    }
}
