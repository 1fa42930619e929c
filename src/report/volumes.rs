//! The smallest distance of the vehicle from the boundary of each volume.

use super::table::Table;
use crate::model::{Limit, Problem, Volume};
use crate::motion::checks::{past, peak};
use crate::motion::{NodeState, X, Y, Z};
use crate::number::{fixed, significant};
use crate::planner::studies::MissionPlan;
use serde::Serialize;

/// A volume and how near the plan comes to its boundary.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VolumeRecord {
    pub name: String,
    /// `keep_in` or `keep_out`.
    pub side: &'static str,
    /// Smallest distance between the boundary and the sphere of the vehicle's size about the centre of gravity, m; negative if
    /// it crosses the boundary.
    pub distance_m: f64,
    /// The `clearance` of the spec, m.
    pub required_m: f64,
    /// When it is smallest, s,
    pub at_s: f64,
    /// and where the centre of gravity is then, m.
    pub position_m: [f64; 3],
}

/// The record of each volume, in the order of the spec.
pub fn records(problem: Problem, solved: &MissionPlan) -> Vec<VolumeRecord> {
    let trajectory = &solved.trajectory;
    let environment = problem.model().environment();
    let record = |volume: &Volume| {
        let limits: Vec<&Limit> = problem
            .mission()
            .limits
            .iter()
            .filter(|limit| limit.volume.is_some() && limit.is_general() && limit.span == volume.span)
            .collect();
        let violation = |state: &NodeState| {
            limits.iter().map(|limit| past(limit, state, &environment)).fold(f64::NEG_INFINITY, f64::max)
        };
        let nearest = peak(trajectory, violation);
        let state = trajectory.at(nearest.at);
        VolumeRecord {
            name: volume.name.clone(),
            side: volume.side.keyword(),
            distance_m: volume.clearance - nearest.value,
            required_m: volume.clearance,
            at_s: nearest.at,
            position_m: [state[X][0], state[Y][0], state[Z][0]],
        }
    };
    problem.mission().volumes.iter().map(record).collect()
}

/// Terminal text: a table of the volumes; empty without volumes.
pub fn text(problem: Problem, solved: &MissionPlan) -> String {
    let records = records(problem, solved);
    if records.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["volume", "distance", "required", "at", "position"]);
    for record in &records {
        let [x, y, z] = record.position_m.map(|x| fixed(x, 2));
        table.row(vec![
            format!("{} {}", record.side, record.name),
            format!("{} m", significant(record.distance_m, 3)),
            format!("{} m", significant(record.required_m, 3)),
            format!("{} s", fixed(record.at_s, 2)),
            format!("[{x}, {y}, {z}] m"),
        ]);
    }
    format!(
        "\n  Smallest distance of the vehicle ({} m about its centre of gravity) from the boundary of each volume\n{}",
        significant(problem.model().vehicle.radius(), 3),
        table.render(2)
    )
}
