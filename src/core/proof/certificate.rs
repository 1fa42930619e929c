//! Records of certificates, with which a plan or its absence can be checked without the planner. The JSON schema is
//! `docs/schema/certificate.schema.json`; `crate::certify` writes certificates, `crate::verify` decides them.
//!
//! A certificate contains only a witness: a motion or multipliers. The conditions that the witness must satisfy follow
//! from the spec, and the checker derives them itself.

mod bounded;
mod recovery;

use bounded::{at_most, numbers, rotors};
use serde::{Deserialize, Serialize};

pub use recovery::{FamilyRecord, MAX_BRANCH_NODES, RecoveryClaim, StateTolerance, WayRecord};

/// Largest certificate file, bytes.
pub const MAX_BYTES: usize = 64 << 20;

/// Most nodes of a motion: the most samples that a spec may request, and a piece for each leg and hold of the longest
/// mission.
pub const MAX_NODES: usize = crate::model::MAX_SAMPLES + 2 * crate::model::MAX_WAYPOINTS + 1;

/// Most facets of one certificate.
pub const MAX_FACETS: usize = 50_000;

/// Most multipliers of one certificate.
pub const MAX_MULTIPLIERS: usize = 1_000_000;

/// Most motions from which RSP selects facets: one per round.
pub const MAX_SELECTIONS: usize = crate::model::MAX_ROUNDS;

/// Most modes for which a plan gives up yaw.
pub const MAX_FREED: usize = 10_000;

/// Most records of weights, and most weights of one.
pub const MAX_WEIGHTS: usize = crate::model::MAX_WAYPOINTS;

/// The version of the records.
pub const SCHEMA: u32 = 2;

/// A certificate of one spec.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a certificate")]
pub struct Certificate {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    pub schema: u32,
    /// SHA-256 over all files of the spec and its overrides, as in reports.
    #[cfg_attr(test, schemars(regex(pattern = "^[0-9a-f]{64}$")))]
    pub spec_sha256: String,
    /// The equations that give the wrench of the motion.
    pub model: DynamicModel,
    /// With `require capture_height`: the height above the ground that the plan keeps, m. It comes from simulated
    /// flights, so the checker cannot decide it and calls it a claim. Omitted without the statement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub capture_height_m: Option<f64>,
    /// What is proved.
    pub claim: Claim,
}

/// The equations that give the wrench of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum DynamicModel {
    /// Linear about hover: (44), (45) and (19) to (22).
    Hover,
    /// Differential flatness of (3) to (9), no small angles.
    Exact,
}

/// The statement that a certificate proves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Claim {
    /// The motion is a plan of the spec.
    Plan(PlanClaim),
    /// The spec has no plan on its grid of nodes.
    Infeasible(InfeasibleClaim),
    /// The spec has no plan, because a waypoint is due before any motion within limits and thrust can reach it.
    TooEarly(TooEarlyClaim),
}

/// A motion that is a plan of the spec.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PlanClaim {
    /// The plan.
    pub motion: MotionRecord,
    /// RSP: the plans from which it selects facets, the RIP plan first, then one per further round.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_SELECTIONS, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_SELECTIONS)))]
    pub selected_by: Vec<MotionRecord>,
    /// The modes for which the plan gives up yaw.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_FREED, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_FREED)))]
    pub without_yaw: Vec<SpinRecord>,
    /// Lower bound on the time of every motion that satisfies the spec's limits at every instant, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub least_time_s: Option<f64>,
    /// Weights that show it.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_WEIGHTS, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_WEIGHTS)))]
    pub weights: Vec<WeightsRecord>,
    /// Ways out after faults, with `--recovery`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recovery: Option<RecoveryClaim>,
}

/// A mode for which the plan gives up yaw.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SpinRecord {
    /// Name of the fault mode.
    pub mode: String,
    /// A range of rates of the body about its thrust, rad/s, that it cannot leave; it contains 0.
    pub spin_rad_s: [f64; 2],
    /// The largest rate at which the direction of the thrust turns, rad/s. Required where the moments of inertia
    /// about x and y differ, because turning then accelerates the spin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub turning_rad_s: Option<f64>,
}

/// A waypoint is due before any motion that satisfies the spec's limits at every instant can reach it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TooEarlyClaim {
    /// Number of the waypoint, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub waypoint: usize,
    /// Lower bound on the time at which a motion that satisfies the limits reaches it, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub soonest_s: f64,
    /// Weights that show it.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_WEIGHTS, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_WEIGHTS)))]
    pub weights: Vec<WeightsRecord>,
}

/// Weights on the acceleration from one rest to the next, from which a lower bound on the time follows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WeightsRecord {
    /// Numbers of waypoints, from 1, in order; the first and the last at rest.
    #[serde(deserialize_with = "at_most::<MAX_WEIGHTS, _, _>")]
    #[cfg_attr(test, schemars(length(min = 2, max = MAX_WEIGHTS)))]
    pub waypoints: Vec<usize>,
    /// The horizontal weights at these waypoints.
    #[serde(deserialize_with = "at_most::<MAX_WEIGHTS, _, _>")]
    #[cfg_attr(test, schemars(length(min = 2, max = MAX_WEIGHTS)))]
    pub weights: Vec<[f64; 2]>,
    /// The weight on the vertical thrust.
    pub vertical: f64,
    /// s^2/m
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub price_s2_per_m: f64,
}

/// Node times and derivatives at the nodes. Inputs (the highest derivative of each axis) are linear between nodes; a
/// piece starts from the derivatives at its left node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MotionRecord {
    /// Node times, increasing from 0, s.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub times_s: Vec<f64>,
    /// x and its derivatives up to the fourth at each node, SI.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub x: Vec<[f64; 5]>,
    /// y and its derivatives up to the fourth at each node, SI.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub y: Vec<[f64; 5]>,
    /// z and its derivatives at each node, SI.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub z: Vec<Vertical>,
    /// Yaw and its derivatives up to the second at each node, rad, rad/s and rad/s^2.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub yaw: Vec<[f64; 3]>,
    /// The node at which each waypoint is reached.
    #[serde(deserialize_with = "at_most::<MAX_NODES, _, _>")]
    pub waypoint_nodes: Vec<usize>,
}

/// z and its derivatives at a node, SI: up to the second in the hover model, up to the fourth in the exact one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(untagged, expecting = "three derivatives of z in the hover model or five in the exact one")]
pub enum Vertical {
    /// Up to the second derivative.
    Hover([f64; 3]),
    /// Up to the fourth.
    Exact([f64; 5]),
}

impl Vertical {
    /// z and its derivatives, in order.
    pub fn derivatives(&self) -> &[f64] {
        match self {
            Vertical::Hover(z) => z,
            Vertical::Exact(z) => z,
        }
    }
}

impl MotionRecord {
    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.times_s.len()
    }
}

/// No motion with inputs that are linear between the nodes of the spec's grid satisfies every row: with these
/// multipliers the rows add up to a contradiction. The grid omits holds, because nothing changes in them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct InfeasibleClaim {
    /// RSP: the plans from which it selects facets, the RIP plan first, then one per further round.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_SELECTIONS, _, _>")]
    #[cfg_attr(test, schemars(length(max = MAX_SELECTIONS)))]
    pub selected_by: Vec<MotionRecord>,
    /// The facets that rows and weights refer to by their index, from 0.
    #[serde(deserialize_with = "at_most::<MAX_FACETS, _, _>")]
    pub facets: Vec<FacetRecord>,
    /// In the exact model: facets whose weighted normals add up to the axis of T, so that their offsets bound the
    /// thrust.
    #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "at_most::<MAX_FACETS, _, _>")]
    pub thrust: Vec<FacetWeight>,
    /// The rows and their multipliers.
    #[serde(deserialize_with = "at_most::<MAX_MULTIPLIERS, _, _>")]
    pub multipliers: Vec<Multiplier>,
}

/// A facet and its weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FacetWeight {
    /// Index into `facets`.
    pub facet: usize,
    /// Its weight, in widths of the healthy set along the facet's normal, N.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub weight: f64,
}

/// A row and its multiplier. The multipliers of the dynamics are not listed, because they follow from these.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Multiplier {
    /// The row of the program.
    pub row: RowRecord,
    /// SI; one number, or one for each part of a second-order cone.
    #[serde(deserialize_with = "numbers")]
    #[cfg_attr(test, schemars(length(min = 1, max = 4)))]
    pub z: Vec<f64>,
}

/// A side of a bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Side {
    Upper,
    Lower,
}

/// A row of the program. Nodes, intervals, limits and waypoints are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RowRecord {
    /// A derivative that is zero at rest.
    Rest {
        /// Node of the grid.
        node: usize,
        /// 0 x, 1 y, 2 z, 3 yaw.
        #[cfg_attr(test, schemars(range(max = 3)))]
        axis: usize,
        /// Order of the derivative.
        #[cfg_attr(test, schemars(range(min = 1, max = 4)))]
        derivative: usize,
    },
    /// A facet at a node.
    Facet {
        /// Index into `facets`.
        facet: usize,
        /// Node of the grid.
        node: usize,
    },
    /// A row of the planning set for the commanded wrench of lagging rotors.
    Commands {
        /// Index into `facets`.
        facet: usize,
        /// Node of the grid.
        node: usize,
        /// An interval adjacent to the node, which selects the slopes of the inputs.
        interval: usize,
    },
    /// A bound on one coordinate or rate.
    Limit {
        /// Limit of the mission, in the order written.
        limit: usize,
        /// Node of the grid.
        node: usize,
        /// The upper or the lower bound.
        side: Side,
    },
    /// A bound on a norm.
    LimitNorm {
        /// Limit of the mission, in the order written.
        limit: usize,
        /// Node of the grid.
        node: usize,
        /// For a jerk: the interval, adjacent to the node, whose z''' is used.
        interval: usize,
    },
    /// m |(x'', y'', z'' + g)| is at most the largest thrust, which `thrust` proves.
    Thrust {
        /// Node of the grid.
        node: usize,
    },
    /// The position tolerance of a waypoint.
    Waypoint {
        /// Waypoint of the mission.
        waypoint: usize,
    },
    /// The yaw tolerance of a waypoint.
    WaypointYaw {
        /// Waypoint of the mission.
        waypoint: usize,
        /// The upper or the lower bound.
        side: Side,
    },
}

/// A facet of a mode's set, named by rotors and by its side. If the spec has intervals, it is the row that is valid for
/// all values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FacetRecord {
    /// `healthy`, or the name of a fault mode.
    pub mode: String,
    /// Three rotors, from 1, whose wrenches span it; with the pseudo-inverse the one rotor at a bound.
    #[serde(deserialize_with = "rotors")]
    #[cfg_attr(test, schemars(length(min = 1, max = 3), inner(range(min = 1))))]
    pub rotors: Vec<usize>,
    /// T, tau_x, tau_y, tau_z; of length 1 in N and N m.
    pub normal: [f64; 4],
    /// The largest `normal . w` over the set, before the reserve.
    pub offset: f64,
}
