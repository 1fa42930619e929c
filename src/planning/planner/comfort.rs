//! What a pilot expects beside least snap: legs flown near their straight lines, and a yaw that turns no more than the
//! waypoints ask.

use crate::model::volume::passage;
use crate::model::{Heading, Mission, Waypoint};
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::transcription::{Transcription, UNBOUNDED};
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use std::ops::Range;

/// The weights of squares that are added to the cost (48), each integrated over the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comfort {
    /// Of the distance from the leg's line, per m^2 s.
    pub distance: f64,
    /// Of the difference from the yaw of a leg between two equal yaws, per rad^2 s.
    pub yaw: f64,
    /// Of the yaw rate, s/rad^2.
    pub yaw_rate: f64,
    /// Whether steps keep the heights of legs, as far as they have no volume in the way.
    pub keeps_heights: bool,
}

/// How far above and below both its waypoints steps let a leg pass at its nodes, m. Chosen by hand, below
/// [`PLANS_WITHIN`].
const STEPS_WITHIN: f64 = 0.4;
/// How far above and below them a plan may pass at its nodes and still keep the heights of its legs, m. Chosen by hand.
const PLANS_WITHIN: f64 = 0.5;

/// One square at one node: the sum of factors times derivatives, and of a constant.
struct Square {
    node: usize,
    /// Axis, order and factor.
    terms: Vec<(usize, usize, f64)>,
    constant: f64,
    weight: f64,
}

/// The yaw that a leg keeps: that of both its waypoints, rad.
fn kept_yaw(mission: &Mission, leg: usize) -> Option<f64> {
    let (from, to) = (&mission.waypoints[leg], &mission.waypoints[leg + 1]);
    (are_given(from, to) && from.yaw == to.yaw).then_some(to.yaw)
}

/// Whether both yaws are angles that the spec gives.
fn are_given(from: &Waypoint, to: &Waypoint) -> bool {
    from.heading == Heading::Given && to.heading == Heading::Given
}

/// The direction of a leg, a unit vector; zero for a leg without length, whose line is a point.
fn direction(mission: &Mission, leg: usize) -> [f64; 3] {
    let (from, to) = (mission.waypoints[leg].position, mission.waypoints[leg + 1].position);
    let apart: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let length = apart.iter().map(|d| d * d).sum::<f64>().sqrt();
    if length > 0.0 { apart.map(|d| d / length) } else { apart }
}

impl Transcription<'_> {
    /// Rows at the nodes of legs between two given yaws: the yaw stays between both, to within the larger tolerance of
    /// the two waypoints. The spec does not require this, so no proof has these rows.
    pub(super) fn turns_no_further(&self, builder: &mut Builder) {
        for segment in &self.grid.segments {
            let (from, to) = (&self.mission.waypoints[segment.from], &self.mission.waypoints[segment.from + 1]);
            let within = from.yaw_within.max(to.yaw_within);
            if !are_given(from, to) || within >= UNBOUNDED || !self.plans(YAW) {
                continue;
            }
            for node in segment.first_node + 1..segment.first_node + segment.intervals {
                let origin = RowOrigin::WaypointYaw { waypoint: segment.from + 1 };
                let yaw = self.at_node(node, YAW, 0);
                builder.nonnegative(yaw.clone().plus_constant(within - from.yaw.min(to.yaw)), origin);
                builder.nonnegative(yaw.times(-1.0).plus_constant(within + from.yaw.max(to.yaw)), origin);
            }
        }
    }

    /// The nodes inside each leg that no volume obstructs, with the heights of its lower and its higher waypoint, m.
    fn heights(&self) -> impl Iterator<Item = (Range<usize>, f64, f64)> {
        self.grid.segments.iter().filter_map(|segment| {
            let ends = &self.mission.waypoints[segment.from..=segment.from + 1];
            let (from, to) = (ends[0].position[Z], ends[1].position[Z]);
            let nodes = segment.first_node + 1..segment.first_node + segment.intervals;
            passage::is_open(&self.mission.limits, ends).then(|| (nodes, from.min(to), from.max(to)))
        })
    }

    /// Rows at the nodes of legs: the height stays between those of both waypoints, to within [`STEPS_WITHIN`]. The
    /// spec does not require this, so no proof has these rows.
    pub(super) fn keeps_heights(&self, builder: &mut Builder) {
        let leg = |node: usize| self.leg_of(node * self.parts);
        for (nodes, low, high) in self.heights() {
            for node in nodes {
                let (z, origin) = (self.at_node(node, Z, 0), RowOrigin::Waypoint { waypoint: leg(node) + 1 });
                builder.nonnegative(z.clone().plus_constant(STEPS_WITHIN - low), origin);
                builder.nonnegative(z.times(-1.0).plus_constant(STEPS_WITHIN + high), origin);
            }
        }
    }

    /// Whether states at the nodes keep these heights.
    pub(super) fn are_heights_kept(&self, states: &[NodeState]) -> bool {
        self.heights().all(|(nodes, low, high)| {
            states[nodes].iter().all(|state| (low - PLANS_WITHIN..=high + PLANS_WITHIN).contains(&state[Z][0]))
        })
    }

    /// The squares at the nodes, each weighted by the time around its node.
    fn squares(&self, comfort: &Comfort) -> Vec<Square> {
        let mut all = Vec::new();
        let steps: Vec<f64> = self.grid.steps().collect();
        for segment in &self.grid.segments {
            let leg = segment.from;
            let (from, along) = (self.mission.waypoints[leg].position, direction(self.mission, leg));
            let follows = self.mission.waypoints[leg + 1].heading != Heading::Given;
            for node in segment.first_node + 1..segment.first_node + segment.intervals {
                let around = 0.5 * (steps[node - 1] + steps[node]);
                for axis in [X, Y, Z] {
                    // (I - d d^T) (p - a)
                    let factor = |other: usize| f64::from(u8::from(axis == other)) - along[axis] * along[other];
                    let terms: Vec<(usize, usize, f64)> = [X, Y, Z].map(|other| (other, 0, factor(other))).to_vec();
                    let constant = -[X, Y, Z].iter().map(|&other| factor(other) * from[other]).sum::<f64>();
                    all.push(Square { node, terms, constant, weight: comfort.distance * around });
                }
                if let Some(yaw) = kept_yaw(self.mission, leg) {
                    all.push(Square { node, terms: vec![(YAW, 0, 1.0)], constant: -yaw, weight: comfort.yaw * around });
                }
                if !follows {
                    let weight = comfort.yaw_rate * around;
                    all.push(Square { node, terms: vec![(YAW, 1, 1.0)], constant: 0.0, weight });
                }
            }
        }
        all
    }

    /// Adds these squares times `factor` to a program.
    pub(super) fn add_comfort(&self, builder: &mut Builder, comfort: &Comfort, factor: f64) {
        for Square { node, terms, constant, weight } in self.squares(comfort) {
            let mut value = Affine::constant(constant);
            for (axis, order, share) in terms.into_iter().filter(|(.., share)| *share != 0.0) {
                value.add(&self.at_node(node, axis, order), share);
            }
            builder.inner_product(&value, &value, factor * weight);
        }
    }

    /// The sum of these squares for the derivatives at every node.
    pub(super) fn comfort_of(&self, comfort: &Comfort, states: &[NodeState]) -> f64 {
        let value = |s: &Square| {
            let sum: f64 = s.terms.iter().map(|&(axis, order, share)| share * states[s.node][axis][order]).sum();
            s.weight * (sum + s.constant).powi(2)
        };
        self.squares(comfort).iter().map(value).sum()
    }
}
