//! Trajectories: piecewise polynomials with exact evaluation, the planned wrench, and when it leaves a set.

pub mod checks;
pub mod outside;

use crate::actuation::Wrench;
use crate::model::Vehicle;
use crate::planner::hover_model::{ORDER, WrenchMap, X, Y, YAW, YawState, Z};
use crate::planner::rows::Planned;
use crate::planner::transcribe::NodeState;
use crate::planner::yaw::YawPlan;

/// A plan as polynomials between nodes: degree 5 in x and y, 3 in z and yaw (inputs are piecewise linear).
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Node times, s, ascending; at least two.
    pub times: Vec<f64>,
    /// Derivatives at each node, SI units.
    pub nodes: Vec<NodeState>,
    /// Node of each waypoint of the mission.
    pub waypoint_nodes: Vec<usize>,
    /// The yaw at which the planning model is linearised, where yaw was planned with the rest; `None` where the
    /// model follows the planned yaw.
    pub linearised_at: Option<f64>,
}

impl Trajectory {
    pub fn of(planned: &Planned) -> Self {
        Trajectory {
            times: planned.layout.profile.node_times.clone(),
            nodes: planned.states.clone(),
            waypoint_nodes: planned.layout.profile.waypoint_nodes.clone(),
            linearised_at: match planned.layout.yaw {
                YawPlan::Free { psi } => Some(psi),
                YawPlan::Frozen(_) => None,
            },
        }
    }

    /// s
    pub fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    pub fn intervals(&self) -> usize {
        self.times.len() - 1
    }

    /// The interval that holds t; at a node the one to its right, at the end the last.
    pub fn interval_at(&self, t: f64) -> usize {
        self.times.partition_point(|&s| s <= t).clamp(1, self.intervals()) - 1
    }

    /// All derivatives at `t` seconds into interval `k`: right limits at the interval's start.
    ///
    /// Orders above the input's: the input's slope is constant over the interval, what is above is zero.
    pub fn within(&self, k: usize, t: f64) -> NodeState {
        let (left, right) = (&self.nodes[k], &self.nodes[k + 1]);
        let h = self.times[k + 1] - self.times[k];
        let mut state = NodeState::default();
        for axis in [X, Y, Z, YAW] {
            let r = ORDER[axis];
            let slope = (right[axis][r] - left[axis][r]) / h;
            // d_i(t) = sum_{j >= i} d_j t^(j-i) / (j-i)! by Horner.
            for (i, derivative) in state[axis].iter_mut().enumerate().take(r + 1) {
                let highest = slope / factorial(r + 1 - i);
                *derivative = (i..=r).rev().fold(highest, |value, j| value * t + left[axis][j] / factorial(j - i));
            }
            if r < 4 {
                state[axis][r + 1] = slope;
            }
        }
        state
    }

    /// All derivatives at time t (clamped to the flight).
    pub fn at(&self, t: f64) -> NodeState {
        let k = self.interval_at(t);
        self.within(k, (t - self.times[k]).clamp(0.0, self.times[k + 1] - self.times[k]))
    }

    /// The planning model's wrench for a state of this trajectory.
    pub fn wrench(&self, vehicle: &Vehicle, gravity: f64, state: &NodeState) -> Wrench {
        let map = match self.linearised_at {
            Some(psi) => WrenchMap::with_free_yaw(vehicle, gravity, psi),
            None => {
                let [psi, rate, acceleration, ..] = state[YAW];
                WrenchMap::new(vehicle, gravity, YawState { psi, rate, acceleration })
            }
        };
        map.at(state)
    }

    /// The wrench at every node.
    pub fn node_wrenches(&self, vehicle: &Vehicle, gravity: f64) -> Vec<Wrench> {
        self.nodes.iter().map(|s| self.wrench(vehicle, gravity, s)).collect()
    }
}

fn factorial(n: usize) -> f64 {
    [1.0, 1.0, 2.0, 6.0, 24.0, 120.0][n]
}

/// Exact ZYX roll and pitch (rad) of the thrust direction (x'', y'', z'' + g) at yaw psi.
///
/// The third column of (4), turned back by psi, is (sin theta cos phi, -sin phi, cos theta cos phi).
pub fn roll_pitch(state: &NodeState, gravity: f64) -> (f64, f64) {
    let (s, c) = state[YAW][0].sin_cos();
    let (ax, ay, az) = (state[X][2], state[Y][2], state[Z][2] + gravity);
    let (forward, left) = (c * ax + s * ay, -s * ax + c * ay);
    ((-left).atan2(forward.hypot(az)), forward.atan2(az))
}

/// Angle between the thrust direction and the vertical, rad; over pi/2 where the thrust would point down.
pub fn tilt(state: &NodeState, gravity: f64) -> f64 {
    state[X][2].hypot(state[Y][2]).atan2(state[Z][2] + gravity)
}
