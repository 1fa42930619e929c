//! Records of ways out after faults.

use super::bounded::at_most;
use super::{MAX_NODES, MotionRecord};
use serde::{Deserialize, Serialize};

/// Most branches of one certificate.
pub const MAX_BRANCHES: usize = 100_000;

/// Most families of one certificate.
pub const MAX_FAMILIES: usize = 100_000;

/// Most nodes of a branch.
pub const MAX_BRANCH_NODES: usize = 1_000;

const _: () = assert!(MAX_BRANCH_NODES < MAX_NODES);

/// Ways out after faults, from the instant at which a fault becomes known.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RecoveryClaim {
    /// Motions that begin at 0 s, when a fault becomes known. Their waypoint nodes divide them into parts; a landing
    /// descends in its last part.
    #[serde(deserialize_with = "at_most::<MAX_BRANCHES, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_BRANCHES)))]
    pub branches: Vec<MotionRecord>,
    /// Families of motions between branches. Those of one mode follow each other in time and do not overlap; those of
    /// the same instants follow each other in their delays, and take in all delays of the spec.
    #[serde(deserialize_with = "at_most::<MAX_FAMILIES, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_FAMILIES)))]
    pub families: Vec<FamilyRecord>,
}

/// A motion for each instant of a fault, each delay until it is known, and each state near the one that is expected
/// then.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FamilyRecord {
    /// Name of the fault mode.
    pub mode: String,
    /// The first instant of the fault, s since the start of the plan.
    pub from_s: f64,
    /// The last instant of the fault, s since the start of the plan.
    pub to_s: f64,
    /// The shortest and the longest delay until the fault is known, s.
    pub delays_s: [f64; 2],
    /// Where the motions lead.
    pub way: WayRecord,
    /// The branches, from 0, after a fault at `from_s` and at `to_s` with the shortest delay, and at these instants
    /// with the longest. They have the same node times.
    pub corners: [usize; 4],
    /// How far the state may be from the expected one: that of the plan at that instant, plus the blend of how far the
    /// branches begin from the plan.
    pub tolerance: StateTolerance,
}

/// Where a motion leads.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum WayRecord {
    /// Back to the plan, and along it to its end.
    Continue,
    /// Down at the landing site of this name.
    LandAt(String),
    /// Down outside all areas to keep off.
    LandHere,
}

/// How far the state of a vehicle may be from the expected one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct StateTolerance {
    /// Position, m.
    pub position_m: f64,
    /// Velocity, m/s.
    pub velocity_m_s: f64,
    /// Direction of the thrust, rad.
    pub tilt_rad: f64,
    /// Rate of change of that direction, rad/s.
    pub turning_rad_s: f64,
    /// Yaw, rad.
    pub yaw_rad: f64,
    /// Rate of change of the yaw, rad/s.
    pub yaw_rate_rad_s: f64,
}

impl StateTolerance {
    /// The larger of each.
    pub fn largest(&self, other: &StateTolerance) -> StateTolerance {
        StateTolerance {
            position_m: self.position_m.max(other.position_m),
            velocity_m_s: self.velocity_m_s.max(other.velocity_m_s),
            tilt_rad: self.tilt_rad.max(other.tilt_rad),
            turning_rad_s: self.turning_rad_s.max(other.turning_rad_s),
            yaw_rad: self.yaw_rad.max(other.yaw_rad),
            yaw_rate_rad_s: self.yaw_rate_rad_s.max(other.yaw_rate_rad_s),
        }
    }
}
