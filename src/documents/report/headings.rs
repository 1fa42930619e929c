//! How far a yaw that follows from the motion is off its direction.

use crate::model::{Limit, Part, Problem};
use crate::motion::NodeState;
use crate::motion::checks::{heading_error, leg_intervals, peak_of};
use crate::number::{fixed, significant};
use crate::planner::studies::MissionPlan;
use crate::text_table::Table;
use serde::Serialize;

/// A leg or a waypoint where the yaw follows a direction.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct HeadingRecord {
    /// The leg or the waypoint, in words: `yaw on the leg to waypoint 3`.
    pub name: String,
    /// The largest error that the spec allows, rad.
    pub tolerance_rad: f64,
    /// The largest error at the nodes, where it is bounded, rad; null if nothing is required at any.
    pub at_nodes_rad: Option<f64>,
    /// The largest error at and between the nodes, rad; null if nothing is required at any.
    pub largest_rad: Option<f64>,
    /// When it is attained, s.
    pub at_s: f64,
}

/// The record of each leg and waypoint, in the order of flight.
pub fn records(problem: Problem, solved: &MissionPlan) -> Vec<HeadingRecord> {
    let (mission, trajectory) = (problem.mission(), &solved.trajectory);
    let of_yaw = mission.limits.iter().filter(|limit| limit.kind.is_heading());
    let record = |limit: &Limit| {
        let on = limit.leg.as_deref()?;
        let leg = leg_intervals(trajectory, mission, on.leg);
        let nodes = match on.part {
            Part::Start => leg.start..=leg.start,
            Part::End => leg.end..=leg.end,
            Part::Whole => leg.start..=leg.end,
        };
        let error = |state: &NodeState| heading_error(limit, state).map_or(-1.0, f64::abs);
        let required = |value: f64| (value >= 0.0).then_some(value);
        let at_nodes = nodes.map(|node| error(&trajectory.nodes[node])).fold(-1.0, f64::max);
        let largest = peak_of(limit, mission, trajectory, error);
        Some(HeadingRecord {
            name: limit.name().to_string(),
            tolerance_rad: limit.upper.unwrap_or(0.0),
            at_nodes_rad: required(at_nodes),
            largest_rad: required(largest.value.max(at_nodes)),
            at_s: largest.at,
        })
    };
    of_yaw.filter_map(record).collect()
}

/// Terminal text: a table; empty where the yaw follows nothing.
pub fn text(problem: Problem, solved: &MissionPlan) -> String {
    let records = records(problem, solved);
    if records.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["yaw", "allowed", "at nodes", "largest", "at"]);
    let angle = |error: Option<f64>| {
        error.map_or("not required".into(), |error| format!("{} deg", significant(error.to_degrees(), 3)))
    };
    for record in &records {
        table.row(vec![
            record.name.trim_start_matches("yaw ").to_string(),
            angle(Some(record.tolerance_rad)),
            angle(record.at_nodes_rad),
            angle(record.largest_rad),
            format!("{} s", fixed(record.at_s, 2)),
        ]);
    }
    format!("\n  How far the yaw is off the direction that it follows, which is required at nodes\n{}", table.render(2))
}
