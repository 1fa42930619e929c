//! The smallest distance of the vehicle from the boundary of each volume, along a plan and in a simulated flight.

use crate::model::{Limit, Mission, Model, Problem, Volume};
use crate::motion::checks::{peak, violation};
use crate::motion::{NodeState, X, Y, Z};
use crate::number::{fixed, significant};
use crate::planner::studies::MissionPlan;
use crate::text_table::Table;
use serde::Serialize;

/// A volume and how near the vehicle comes to its boundary.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct VolumeRecord {
    /// Its name.
    pub name: String,
    /// On which side of it the vehicle stays.
    #[cfg_attr(test, schemars(extend("enum" = ["keep_in", "keep_out"])))]
    pub side: &'static str,
    /// Smallest distance of the vehicle, a sphere of its size about the centre of gravity, from the boundary, m;
    /// negative if it crosses it.
    pub distance_m: f64,
    /// The clearance that the spec requires, m.
    pub required_m: f64,
    /// When the distance is smallest, s.
    pub at_s: f64,
    /// The position of the centre of gravity then, m.
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
            limits.iter().map(|limit| violation(limit, state, &environment)).fold(f64::NEG_INFINITY, f64::max)
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

/// The smallest distances of a simulated flight, from the positions at which its controller acts.
#[derive(Debug, Clone)]
pub struct Nearest {
    volumes: Vec<(Volume, Vec<Limit>)>,
    records: Vec<VolumeRecord>,
}

impl Nearest {
    /// For a flight of this model; without volumes it records nothing.
    pub fn new(model: &Model) -> Self {
        let of_mission = |mission: &Mission| {
            let limits_of = |volume: &Volume| {
                let own = mission.limits.iter().filter(|limit| limit.volume.is_some() && limit.span == volume.span);
                (volume.clone(), own.cloned().collect())
            };
            mission.volumes.iter().map(limits_of).collect()
        };
        let volumes: Vec<(Volume, Vec<Limit>)> = model.mission.as_ref().map_or(Vec::new(), of_mission);
        let empty = |(volume, _): &(Volume, Vec<Limit>)| VolumeRecord {
            name: volume.name.clone(),
            side: volume.side.keyword(),
            distance_m: f64::INFINITY,
            required_m: volume.clearance,
            at_s: 0.0,
            position_m: [0.0; 3],
        };
        Nearest { records: volumes.iter().map(empty).collect(), volumes }
    }

    /// Whether there are no volumes.
    pub fn is_empty(&self) -> bool {
        self.volumes.is_empty()
    }

    /// Takes the position (m) at an instant (s).
    pub fn add(&mut self, time: f64, position: [f64; 3]) {
        for ((volume, limits), record) in self.volumes.iter().zip(&mut self.records) {
            let violation =
                limits.iter().filter_map(|limit| limit.violation_at(position)).fold(f64::NEG_INFINITY, f64::max);
            let distance_m = volume.clearance - violation;
            if distance_m < record.distance_m {
                *record = VolumeRecord { distance_m, at_s: time, position_m: position, ..record.clone() };
            }
        }
    }

    /// The records, in the order of the spec; none of a flight without positions.
    pub fn records(self) -> Vec<VolumeRecord> {
        self.records.into_iter().filter(|record| record.distance_m.is_finite()).collect()
    }
}

/// Terminal text: a table of the volumes; empty without volumes.
pub fn text(problem: Problem, solved: &MissionPlan) -> String {
    table(&records(problem, solved), problem.model(), "")
}

/// The table of a plan or, with ` in the flight`, of a flight.
pub fn table(records: &[VolumeRecord], model: &Model, of: &str) -> String {
    if records.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["volume", "distance", "required", "at", "position"]);
    for record in records {
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
        "\n  Smallest distance{of} of the vehicle ({} m about its centre of gravity) from the boundary of each \
         volume\n{}",
        significant(model.vehicle.radius(), 3),
        table.render(2)
    )
}
