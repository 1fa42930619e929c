//! Certificates: what a sceptic needs to check a plan, or that there is none, without the planner. Here are the JSON
//! records, whose schema is `docs/schema/certificate.schema.json`; [`plan`] and [`infeasible`] write them from results,
//! `crate::verify` decides them. [`between`] asks it for what reports say of a plan.

pub mod between;
pub mod infeasible;
pub mod plan;

use crate::model::{Mission, MissionTime, Model};
use crate::planner::compare::{Comparison, Ending};
use serde::{Deserialize, Serialize};

/// A certificate file may have at most this many bytes.
pub const MAX_BYTES: usize = 64 << 20;

/// The version of the records.
pub const SCHEMA: u32 = 1;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a certificate")]
pub struct Certificate {
    pub schema: u32,
    /// Over all files of the spec and its overrides, as in reports.
    pub spec_sha256: String,
    pub model: DynamicModel,
    pub claim: Claim,
}

/// Which equations turn a motion into a wrench.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DynamicModel {
    /// Linear about hover: (44), (45) and (19) to (22).
    Hover,
    /// Differential flatness of (3) to (9), no small angles.
    Exact,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Claim {
    Plan(PlanClaim),
    Infeasible(InfeasibleClaim),
}

/// A motion, and what is claimed of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanClaim {
    pub motion: MotionRecord,
    /// The pieces of the motion join within this: |gap of the i-th derivative| h^i, h the piece's duration; m and rad.
    pub joins_within: f64,
    /// No waypoint is missed by more than its tolerance and this, m.
    pub position_excess_m: f64,
    /// No yaw is missed by more than its tolerance and this, rad.
    pub yaw_excess_rad: f64,
    /// One for each limit of the mission, in the order written.
    pub limits: Vec<LimitClaim>,
    /// The modes whose sets hold the wrench: all that the planner is to stand.
    pub sets: Vec<SetClaim>,
    /// The facets that were imposed.
    pub facets: Vec<FacetClaim>,
}

/// Node times and derivatives at the nodes. Inputs (the highest derivative of each axis) are linear between nodes; a
/// piece starts from the derivatives at its left node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionRecord {
    pub times_s: Vec<f64>,
    /// Up to the fourth derivative, SI.
    pub x: Vec<[f64; 5]>,
    pub y: Vec<[f64; 5]>,
    /// Up to the second derivative in the hover model, up to the fourth in the exact one.
    pub z: Vec<Vec<f64>>,
    /// Up to the second derivative.
    pub yaw: Vec<[f64; 3]>,
    /// The node at which each waypoint is reached.
    pub waypoint_nodes: Vec<usize>,
}

/// When a bound holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// At both ends of every piece.
    Nodes,
    /// At so many evenly spaced points of every piece beside its ends.
    Grid(usize),
    EveryInstant,
}

/// A quantity exceeds what it may be by at most `excess` (negative: it keeps clear by so much) wherever `scope` says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bound {
    pub scope: Scope,
    pub excess: f64,
}

/// A limit of the mission. The excess is in the limit's SI unit; of tilt it is |(x'', y'')| cos L - (z'' + g) sin L
/// over g.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LimitClaim {
    /// What is limited, in words.
    pub limit: String,
    /// SI
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub bounds: Vec<Bound>,
}

/// The wrench, and what rotors that lag are commanded, stay inside a mode's set, shrunk by the reserve. The excess is the largest over all planes that bound
/// the set, as a share of the healthy set's width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetClaim {
    /// `healthy`, or a fault mode's name.
    pub mode: String,
    /// Of the wrench.
    pub bounds: Vec<Bound>,
    /// Of what the rotors are commanded, where they lag: w + tau w'.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub commands: Vec<Bound>,
}

/// There is no motion whose inputs are linear between these nodes and that keeps every row: with these multipliers the
/// rows add up to a contradiction. Holds are left out: nothing changes in them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InfeasibleClaim {
    pub times_s: Vec<f64>,
    pub waypoint_nodes: Vec<usize>,
    pub facets: Vec<FacetRecord>,
    /// In the exact model: facets whose normals, weighed, add up to the axis of T, so that their offsets bound the
    /// thrust.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub thrust: Vec<FacetWeight>,
    pub multipliers: Vec<Multiplier>,
}

/// A facet of `facets` and its weight, 0 or more; in widths of the healthy set along the facet's normal, N.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FacetWeight {
    pub facet: usize,
    pub weight: f64,
}

/// A row, and its multiplier in SI: one number, or one for each part of a second-order cone. Those of the dynamics are
/// not listed; they follow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Multiplier {
    pub row: RowRecord,
    pub z: Vec<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    Upper,
    Lower,
}

/// Which row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RowRecord {
    /// A derivative that is zero at rest; axes count x, y, z, yaw from 0.
    Rest {
        node: usize,
        axis: usize,
        derivative: usize,
    },
    /// `facets[facet]` at a node.
    Facet {
        facet: usize,
        node: usize,
    },
    /// The same of what rotors that lag are commanded there; `interval`, beside the node, tells which slopes of the
    /// inputs are meant.
    Commands {
        facet: usize,
        node: usize,
        interval: usize,
    },
    /// A bound on one coordinate or rate.
    Limit {
        limit: usize,
        node: usize,
        side: Side,
    },
    /// A bound on a norm; `interval` tells which z''' of a jerk is meant.
    LimitNorm {
        limit: usize,
        node: usize,
        interval: usize,
    },
    /// m |(x'', y'', z'' + g)| is at most the thrust that `thrust` shows to be the largest.
    Thrust {
        node: usize,
    },
    Waypoint {
        waypoint: usize,
    },
    WaypointYaw {
        waypoint: usize,
        side: Side,
    },
}

/// A facet of a mode's set, by rotors and the side it is on. Where the spec has intervals it is the row that holds for all
/// values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FacetRecord {
    pub mode: String,
    /// Three rotors, from 1, whose wrenches span it; with the pseudo-inverse the one rotor at a bound.
    pub rotors: Vec<usize>,
    /// Of length 1 in N and N m.
    pub normal: [f64; 4],
    /// The largest `normal . w` over the set, before the reserve.
    pub offset: f64,
}

/// How the planned wrench keeps to a facet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FacetClaim {
    pub facet: FacetRecord,
    /// Of the wrench, the reserve taken off; shares of the healthy set's width.
    pub bounds: Vec<Bound>,
    /// The same of what the rotors are commanded, where they lag.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub commands: Vec<Bound>,
}

/// The certificate of the last run's outcome. It is checked before it is given: what is written is accepted.
///
/// # Errors
/// Why there is none.
pub fn of(
    model: &Model,
    mission: &Mission,
    comparison: &Comparison,
    spec_sha256: String,
) -> Result<Certificate, String> {
    match comparison.runs.last().map(|run| (run, &run.ending)) {
        Some((run, Ending::Solved(solved))) => {
            let certificate = plan::certificate(model, mission, run, solved, spec_sha256)?;
            match crate::verify::decide(&certificate, model) {
                Ok(_) => Ok(certificate),
                Err(rejection) => Err(format!("{}: {}", rejection.claim, rejection.detail)),
            }
        }
        Some((run, Ending::Infeasible { at, .. })) if has_one_time(model, mission) => {
            infeasible::certificate(model, mission, run, *at, spec_sha256)
        }
        Some((_, Ending::Infeasible { .. })) => Err("no plan at many times is more than a certificate says".into()),
        _ => Err("there is no verdict".into()),
    }
}

/// Whether the spec leaves one mission time only, so that having no plan then is having none.
fn has_one_time(model: &Model, mission: &Mission) -> bool {
    matches!(model.plan.time, MissionTime::Fixed(_)) || mission.waypoints.last().is_some_and(|w| w.time.is_some())
}

impl MotionRecord {
    pub fn nodes(&self) -> usize {
        self.times_s.len()
    }
}
