//! What the rows of a set depend on along a trajectory.

use super::{NodeState, Trajectory};
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::Turning;
use crate::model::{Environment, Vehicle};
use crate::motion::wrench_model::WrenchModel;

/// What rows depend on at an instant.
pub(super) struct Felt {
    /// The wrench in each of the extreme winds.
    pub(super) wrenches: Vec<Wrench>,
    /// If there are rows of cores.
    pub(super) turning: Option<Turning>,
}

impl Felt {
    /// The largest violation of a row.
    pub(super) fn worst(&self, row: &SetRow) -> f64 {
        row.worst(&self.wrenches) + row.of_core(self.turning.as_ref())
    }
}

/// A trajectory in its environment, against the rows of one set.
pub(super) struct Flown<'a> {
    pub(super) trajectory: &'a Trajectory,
    vehicle: &'a Vehicle,
    corners: Vec<Environment>,
    /// Whether some rows are of cores.
    turns: bool,
}

impl<'a> Flown<'a> {
    pub(super) fn new(
        trajectory: &'a Trajectory,
        vehicle: &'a Vehicle,
        environment: &Environment,
        rows: &[SetRow],
    ) -> Self {
        let turns = rows.iter().any(|row| row.core.is_some());
        Flown { trajectory, vehicle, corners: environment.corners(), turns }
    }

    pub(super) fn at(&self, state: &NodeState) -> Felt {
        let Flown { trajectory, vehicle, corners, turns } = self;
        let wrenches = trajectory.wrenches(vehicle, corners, state);
        let turning = turns.then(|| trajectory.model.turning(vehicle, &corners[0], state));
        Felt { wrenches, turning }
    }

    /// Whether no row is linear between nodes.
    pub(super) fn is_curved(&self) -> bool {
        self.turns || !matches!(self.trajectory.model, WrenchModel::HoverAt(_))
    }
}
