//! Trajectories: piecewise polynomials with exact evaluation, the planned wrench, and when it leaves a set.

pub mod checks;
pub mod hover_map;
mod joined;
pub mod nearness;
pub mod outside;
pub mod risk;
pub mod time_grid;
pub mod wrench_model;

use crate::actuation::Wrench;
use crate::model::Vehicle;
use wrench_model::WrenchModel;

/// Axes of the plan in the order of its variables.
pub const X: usize = 0;
pub const Y: usize = 1;
pub const Z: usize = 2;
pub const YAW: usize = 3;

/// Derivatives of each axis at a node: `[axis][order]`, SI units.
pub type NodeState = [[f64; 5]; 4];

/// Derivatives `[axis][order]` with the slope of each axis's input above the input, SI units.
pub type CommandState = [[f64; 6]; 4];

/// A state within the interval of length `h` s between two nodes, with the slopes there; `orders` as in
/// [`crate::motion::wrench_model::WrenchModel::orders`].
pub fn with_slopes(state: &NodeState, [left, right]: [&NodeState; 2], h: f64, orders: [usize; 4]) -> CommandState {
    std::array::from_fn(|axis| {
        let r = orders[axis];
        let mut derivatives = [0.0; 6];
        derivatives[..=r].copy_from_slice(&state[axis][..=r]);
        derivatives[r + 1] = (right[axis][r] - left[axis][r]) / h;
        derivatives
    })
}

/// A plan as polynomials between nodes: an axis whose input is its r-th derivative is of degree r + 1, for inputs are
/// piecewise linear. See [`WrenchModel::orders`].
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Node times, s, ascending; at least two.
    pub times: Vec<f64>,
    /// Derivatives at each node, SI units.
    pub nodes: Vec<NodeState>,
    /// Node of each waypoint of the mission.
    pub waypoint_nodes: Vec<usize>,
    /// What the plan takes for the wrench of its motion.
    pub model: WrenchModel,
}

impl Trajectory {
    /// Whether two trajectories agree up to solver accuracy: the same node times, and positions and yaw within 1e-5 m and rad
    /// at every node.
    pub fn is_same_motion(&self, other: &Trajectory) -> bool {
        const PLACE: f64 = 1e-5;
        let is_near = |p: &NodeState, q: &NodeState| [X, Y, Z, YAW].iter().all(|&i| (p[i][0] - q[i][0]).abs() <= PLACE);
        self.times == other.times && self.nodes.iter().zip(&other.nodes).all(|(p, q)| is_near(p, q))
    }

    /// s
    pub fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// Whether it ends at rest, up to the solver's tolerance.
    pub fn ends_at_rest(&self) -> bool {
        self.nodes.last().is_none_or(|end| end.iter().all(|axis| axis[1].abs() < 1e-3))
    }

    pub fn intervals(&self) -> usize {
        self.times.len() - 1
    }

    /// The interval that holds t; at a node the one to its right, at the end the last.
    pub fn interval_at(&self, t: f64) -> usize {
        self.times.partition_point(|&s| s <= t).clamp(1, self.intervals()) - 1
    }

    /// All derivatives at `t` seconds into interval `k`: right limits at the interval's start. See [`between`].
    pub fn within(&self, k: usize, t: f64) -> NodeState {
        between(&self.nodes[k], &self.nodes[k + 1], self.times[k + 1] - self.times[k], t, self.model)
    }

    /// All derivatives at time t (clamped to the flight).
    pub fn at(&self, t: f64) -> NodeState {
        let k = self.interval_at(t);
        self.within(k, (t - self.times[k]).clamp(0.0, self.times[k + 1] - self.times[k]))
    }

    /// The planning model's wrench for a state of this trajectory.
    pub fn wrench(&self, vehicle: &Vehicle, gravity: f64, state: &NodeState) -> Wrench {
        self.model.wrench(vehicle, gravity, state)
    }

    /// The lead wrench w + tau w' of rotors that lag by `tau` s, for a state in interval `k`, with the slopes there; N and N m.
    pub fn commanded(&self, vehicle: &Vehicle, gravity: f64, tau: f64, k: usize, state: &NodeState) -> Wrench {
        let ends = [&self.nodes[k], &self.nodes[k + 1]];
        let sloped = with_slopes(state, ends, self.times[k + 1] - self.times[k], self.model.orders());
        self.model.commanded(vehicle, gravity, tau, &sloped)
    }

    /// The wrench at every node.
    pub fn node_wrenches(&self, vehicle: &Vehicle, gravity: f64) -> Vec<Wrench> {
        self.nodes.iter().map(|s| self.wrench(vehicle, gravity, s)).collect()
    }
}

/// All derivatives `t` seconds after a node, with the next one `h` seconds after it.
///
/// Orders above the input's: the input's slope is constant over the interval, what is above is zero.
pub fn between(left: &NodeState, right: &NodeState, h: f64, t: f64, model: WrenchModel) -> NodeState {
    let mut state = NodeState::default();
    let orders = model.orders();
    // t^n / n!
    let mut powers = [1.0; 6];
    for n in 1..powers.len() {
        powers[n] = powers[n - 1] * t / n as f64;
    }
    for axis in [X, Y, Z, YAW] {
        let r = orders[axis];
        let slope = (right[axis][r] - left[axis][r]) / h;
        // d_i(t) = sum_{j >= i} d_j t^(j-i) / (j-i)!
        for (i, derivative) in state[axis].iter_mut().enumerate().take(r + 1) {
            let known: f64 = left[axis][i..=r].iter().zip(&powers).map(|(d, power)| d * power).sum();
            *derivative = known + slope * powers[r + 1 - i];
        }
        if r < 4 {
            state[axis][r + 1] = slope;
        }
    }
    state
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
