//! Certificates: what a sceptic needs to check a plan, or that there is none, without the planner. Here are the JSON
//! records alone, whose schema is `docs/schema/certificate.schema.json`; `crate::certify` writes them, `crate::verify`
//! decides them.
//!
//! A certificate carries only a witness: a motion, or multipliers. What has to hold of it follows from the spec, and the
//! checker works that out itself.

mod bounded;

use bounded::{at_most, numbers, rotors};
use serde::{Deserialize, Serialize};

/// A certificate file may have at most this many bytes.
pub const MAX_BYTES: usize = 64 << 20;

/// A motion has at most this many nodes: the most samples that a spec may ask for, and a piece for each leg and hold of the
/// longest mission.
pub const MAX_NODES: usize = crate::model::MAX_SAMPLES + 2 * crate::model::MAX_WAYPOINTS + 1;

/// Facets of one certificate.
pub const MAX_FACETS: usize = 50_000;

/// Multipliers of one certificate.
pub const MAX_MULTIPLIERS: usize = 1_000_000;

/// Motions that RSP selects facets by: one for each round.
pub const MAX_SELECTIONS: usize = crate::model::MAX_ROUNDS;

/// The version of the records.
pub const SCHEMA: u32 = 2;

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
    /// The motion is a plan of the spec.
    Plan(PlanClaim),
    /// The spec has no plan on its grid of nodes.
    Infeasible(InfeasibleClaim),
    /// The spec has no plan, for a waypoint is due before any motion within the limits can be there.
    TooEarly(TooEarlyClaim),
}

/// A motion that is a plan of the spec.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanClaim {
    pub motion: MotionRecord,
    /// Of RSP: the plans it selects facets by, the RIP plan first, then one for each further round.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_SELECTIONS, _, _>")]
    pub selected_by: Vec<MotionRecord>,
    /// No motion that keeps the spec's limits at every instant takes less, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least_time_s: Option<f64>,
}

/// A waypoint is due before any motion that keeps the spec's limits at every instant can be there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TooEarlyClaim {
    /// From 1.
    pub waypoint: usize,
    /// No motion reaches it sooner, s.
    pub soonest_s: f64,
}

/// Node times and derivatives at the nodes. Inputs (the highest derivative of each axis) are linear between nodes; a
/// piece starts from the derivatives at its left node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionRecord {
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub times_s: Vec<f64>,
    /// Up to the fourth derivative, SI.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub x: Vec<[f64; 5]>,
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub y: Vec<[f64; 5]>,
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub z: Vec<Vertical>,
    /// Up to the second derivative.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub yaw: Vec<[f64; 3]>,
    /// The node at which each waypoint is reached.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub waypoint_nodes: Vec<usize>,
}

/// z and its derivatives at a node, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "three derivatives of z in the hover model or five in the exact one")]
pub enum Vertical {
    /// Up to the second derivative.
    Hover([f64; 3]),
    /// Up to the fourth.
    Exact([f64; 5]),
}

impl Vertical {
    pub fn derivatives(&self) -> &[f64] {
        match self {
            Vertical::Hover(z) => z,
            Vertical::Exact(z) => z,
        }
    }
}

impl MotionRecord {
    pub fn nodes(&self) -> usize {
        self.times_s.len()
    }
}

/// There is no motion whose inputs are linear between the nodes of the spec's grid and that keeps every row: with these
/// multipliers the rows add up to a contradiction. Holds are left out: nothing changes in them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InfeasibleClaim {
    /// Of RSP: the plans it selects facets by, as for [`PlanClaim`].
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_SELECTIONS, _, _>")]
    pub selected_by: Vec<MotionRecord>,
    #[serde(deserialize_with = "at_most::<MAX_FACETS, _, _>")]
    pub facets: Vec<FacetRecord>,
    /// In the exact model: facets whose normals, weighed, add up to the axis of T, so that their offsets bound the
    /// thrust.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_FACETS, _, _>")]
    pub thrust: Vec<FacetWeight>,
    #[serde(deserialize_with = "at_most::<MAX_MULTIPLIERS, _, _>")]
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
    #[serde(deserialize_with = "numbers")]
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
    /// The same of what rotors that lag are commanded there; `interval`, beside the node, chooses which slopes of the
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
    /// A bound on a norm; `interval` chooses which z''' of a jerk is meant.
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
    #[serde(deserialize_with = "rotors")]
    pub rotors: Vec<usize>,
    /// Of length 1 in N and N m.
    pub normal: [f64; 4],
    /// The largest `normal . w` over the set, before the reserve.
    pub offset: f64,
}
