//! What a pilot expects beside least snap: legs flown near their straight lines, and a yaw that turns no more than the
//! waypoints ask.

use crate::model::{Heading, Mission};
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::transcription::Transcription;
use crate::qp::build::{Affine, Builder};

/// The weights of squares that are added to the cost (48), each integrated over the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comfort {
    /// Of the distance from the leg's line, per m^2 s.
    pub distance: f64,
    /// Of the difference from the yaw of a leg between two equal yaws, per rad^2 s.
    pub yaw: f64,
    /// Of the yaw rate, s/rad^2.
    pub yaw_rate: f64,
}

/// One square at one node: the sum of factors times derivatives, and of a constant.
struct Square {
    node: usize,
    /// Axis, order and factor.
    terms: Vec<(usize, usize, f64)>,
    constant: f64,
    weight: f64,
}

/// The yaw that a leg keeps: that of both its waypoints, rad.
pub fn kept_yaw(mission: &Mission, leg: usize) -> Option<f64> {
    let (from, to) = (&mission.waypoints[leg], &mission.waypoints[leg + 1]);
    let is_given = from.heading == Heading::Given && to.heading == Heading::Given;
    (is_given && from.yaw == to.yaw).then_some(to.yaw)
}

/// The direction of a leg, a unit vector; zero for a leg without length, whose line is a point.
pub fn direction(mission: &Mission, leg: usize) -> [f64; 3] {
    let (from, to) = (mission.waypoints[leg].position, mission.waypoints[leg + 1].position);
    let apart: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let length = apart.iter().map(|d| d * d).sum::<f64>().sqrt();
    if length > 0.0 { apart.map(|d| d / length) } else { apart }
}

impl Transcription<'_> {
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
