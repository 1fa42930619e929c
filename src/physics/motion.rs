//! Trajectories as piecewise polynomials, the wrench that a motion needs, and when this wrench leaves a set.

pub mod checks;
mod felt;
pub mod hover_map;
mod joined;
pub mod nearness;
pub mod outside;
pub mod risk;
pub mod shape;
pub mod time_grid;
pub mod turning;
pub mod winds;
pub mod wrench_model;

use crate::actuation::Wrench;
use crate::flatness::rotor_drag::{self, Attitude};
use crate::model::{Environment, Vehicle};
use winds::OverWinds;
use wrench_model::WrenchModel;

/// Index of the axis x (east, m) in a [`NodeState`].
pub const X: usize = 0;
/// Index of the axis y (north, m).
pub const Y: usize = 1;
/// Index of the axis z (up, m).
pub const Z: usize = 2;
/// Index of yaw (rad, counter-clockwise seen from above).
pub const YAW: usize = 3;

/// The time derivatives of orders 0 to 4 of each axis at an instant, `[axis][order]`: x, y, z in m/s^order, yaw in
/// rad/s^order.
pub type NodeState = [[f64; 5]; 4];

/// A [`NodeState`] with one more entry for the slope of each axis's input, which comes after the input. The slope
/// is needed for the commanded wrench of lagging rotors.
pub type CommandState = [[f64; 6]; 4];

/// Adds the slopes of the inputs to a state within the interval of length `h` (s) between two nodes. `orders` is
/// [`WrenchModel::orders`].
pub fn with_slopes(state: &NodeState, [left, right]: [&NodeState; 2], h: f64, orders: [usize; 4]) -> CommandState {
    std::array::from_fn(|axis| {
        let r = orders[axis];
        let mut derivatives = [0.0; 6];
        derivatives[..=r].copy_from_slice(&state[axis][..=r]);
        derivatives[r + 1] = (right[axis][r] - left[axis][r]) / h;
        derivatives
    })
}

/// A trajectory as one polynomial for each axis and interval between nodes.
///
/// The input of an axis is its r-th derivative, with r from [`WrenchModel::orders`], and is linear between nodes
/// (first-order hold). The axis is therefore a polynomial of degree r + 1 on each interval
/// (`docs/method/hover-model.md`).
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Node times, s, ascending; at least two.
    pub times: Vec<f64>,
    /// State at each node; as many as `times`.
    pub nodes: Vec<NodeState>,
    /// The node at which each waypoint of the mission is reached, ascending.
    pub waypoint_nodes: Vec<usize>,
    /// The model by which the wrench follows from the motion.
    pub model: WrenchModel,
}

impl Trajectory {
    /// Whether two trajectories agree up to solver accuracy: equal node times, and positions within 1e-5 m and yaw
    /// within 1e-5 rad at every node.
    pub(crate) fn is_same_motion(&self, other: &Trajectory) -> bool {
        const PLACE: f64 = 1e-5;
        let is_near = |p: &NodeState, q: &NodeState| [X, Y, Z, YAW].iter().all(|&i| (p[i][0] - q[i][0]).abs() <= PLACE);
        self.times == other.times && self.nodes.iter().zip(&other.nodes).all(|(p, q)| is_near(p, q))
    }

    /// Each node with its time, s. A node holds position (m) and yaw (rad) and their derivatives in SI units:
    /// `node[axis][order]`, with the axes [`X`], [`Y`], [`Z`] and [`YAW`].
    pub fn rows(&self) -> impl Iterator<Item = (f64, &NodeState)> {
        self.times.iter().copied().zip(&self.nodes)
    }

    /// The time of the last node, s.
    pub fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// Whether all velocities at the end are below 1e-3 m/s (rad/s), so that the trajectory ends at rest up to the
    /// solver's tolerance.
    pub(crate) fn ends_at_rest(&self) -> bool {
        self.nodes.last().is_none_or(|end| end.iter().all(|axis| axis[1].abs() < 1e-3))
    }

    /// The number of intervals between nodes.
    pub fn intervals(&self) -> usize {
        self.times.len() - 1
    }

    /// The interval that contains time t (s). At a node it is the interval after it, at the end the last one.
    fn interval_at(&self, t: f64) -> usize {
        self.times.partition_point(|&s| s <= t).clamp(1, self.intervals()) - 1
    }

    /// The state `t` seconds after the start of interval `k`. Derivatives that jump at a node take the values of this
    /// interval. See [`state_between`].
    ///
    /// # Panics
    /// If there is no interval `k`.
    pub fn within(&self, k: usize, t: f64) -> NodeState {
        state_between(&self.nodes[k], &self.nodes[k + 1], self.times[k + 1] - self.times[k], t, self.model)
    }

    /// The state at time t (s), clamped to the duration.
    pub fn at(&self, t: f64) -> NodeState {
        let k = self.interval_at(t);
        self.within(k, (t - self.times[k]).clamp(0.0, self.times[k + 1] - self.times[k]))
    }

    /// The part of this trajectory that begins at `from` s and takes `duration` s, as one from 0 s on; at rest after
    /// the end of the whole.
    pub fn part(&self, from: f64, duration: f64) -> Trajectory {
        let inner = self.times.iter().zip(&self.nodes).filter(|(t, _)| (from < **t) & (**t < from + duration));
        let (mut times, mut nodes) = (vec![0.0], vec![self.at(from)]);
        for (time, node) in inner {
            times.push(time - from);
            nodes.push(*node);
        }
        if from + duration < self.duration() {
            times.push(duration);
            nodes.push(self.at(from + duration));
        } else if times.len() == 1 {
            times.push(duration);
            nodes.push(nodes[0].map(|axis| [axis[0], 0.0, 0.0, 0.0, 0.0]));
            nodes[0] = nodes[1];
        }
        Trajectory { waypoint_nodes: vec![0, times.len() - 1], times, nodes, model: self.model }
    }

    /// The wrench (N and N m) that a state of this trajectory needs, by the trajectory's model.
    pub fn wrench(&self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> Wrench {
        self.model.wrench(vehicle, environment, state)
    }

    /// The commanded wrench `w + tau w'` (N and N m) for a state within interval `k`, for rotors with a first-order lag
    /// of time constant `tau` (s): (81) of `docs/method/rotor-lag.md`.
    ///
    /// # Panics
    /// If there is no interval `k`.
    pub fn commanded(
        &self,
        vehicle: &Vehicle,
        environment: &Environment,
        tau: f64,
        k: usize,
        state: &NodeState,
    ) -> Wrench {
        self.model.commanded(vehicle, environment, tau, &self.sloped(k, state))
    }

    /// The wrench of a state in every wind of an interval.
    pub(crate) fn in_every_wind(&self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> OverWinds {
        OverWinds::of_wrench(self.model, vehicle, environment, state)
    }

    /// The commanded wrench `w + tau w'` (N and N m) of a state within interval `k`, in every wind of an interval.
    ///
    /// # Panics
    /// If there is no interval `k`.
    pub(crate) fn commanded_in_every_wind(
        &self,
        vehicle: &Vehicle,
        environment: &Environment,
        tau: f64,
        k: usize,
        state: &NodeState,
    ) -> OverWinds {
        OverWinds::of_commands(self.model, vehicle, environment, tau, &self.sloped(k, state))
    }

    /// A state within interval `k` with the slopes of the inputs there.
    fn sloped(&self, k: usize, state: &NodeState) -> CommandState {
        let ends = [&self.nodes[k], &self.nodes[k + 1]];
        with_slopes(state, ends, self.times[k + 1] - self.times[k], self.model.orders())
    }

    /// The wrench at every node, N and N m.
    pub fn node_wrenches(&self, vehicle: &Vehicle, environment: &Environment) -> Vec<Wrench> {
        self.nodes.iter().map(|s| self.wrench(vehicle, environment, s)).collect()
    }

    /// The wrench of a state in each of some environments, such as [`Environment::corners`], N and N m.
    pub(crate) fn wrenches(&self, vehicle: &Vehicle, environments: &[Environment], state: &NodeState) -> Vec<Wrench> {
        environments.iter().map(|environment| self.wrench(vehicle, environment, state)).collect()
    }
}

/// The state `t` seconds after the node `left`, on the interval of length `h` (s) to the node `right`.
///
/// With the order r of the input and its constant slope, derivative i is `sum_{j=i}^{r} d_j t^(j-i)/(j-i)!` plus the
/// slope times `t^(r+1-i)/(r+1-i)!`. Derivative r + 1 is the slope itself, and higher ones are zero.
pub fn state_between(left: &NodeState, right: &NodeState, h: f64, t: f64, model: WrenchModel) -> NodeState {
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

/// The state with its accelerations, jerks and snaps replaced by `c - g e_z`, `c'` and `c''`, where the thrust over
/// mass is `c = a + g e_z + drag/m (v - wind)`: (90) of `docs/method/air.md`. Without drag the state itself.
///
/// With a drag for each axis of the body, it is that of [`Environment::turning_rate`]: where it is the same along x and
/// y, c has the direction of the thrust, but not its size.
pub fn in_air<const N: usize>(state: &[[f64; N]; 4], environment: &Environment) -> [[f64; N]; 4] {
    if !environment.has_drag() {
        return *state;
    }
    let mut felt = *state;
    for axis in [X, Y, Z] {
        for order in 2..N {
            let wind = if order == 2 { environment.wind[axis] } else { 0.0 };
            felt[axis][order] += environment.turning_rate() * (state[axis][order - 1] - wind);
        }
    }
    felt
}

/// The ZYX roll and pitch (rad) for which the thrust points along (x'', y'', z'' + g), with drag in addition, at the
/// state's yaw: (64).
///
/// The third column of (4), rotated by -psi about the vertical, is (sin theta cos phi, -sin phi, cos theta cos phi).
pub fn roll_pitch(state: &NodeState, environment: &Environment) -> (f64, f64) {
    if !environment.turns_alike() {
        let Attitude { roll, pitch, .. } = attitude(state, environment);
        return (roll, pitch);
    }
    let (s, c) = state[YAW][0].sin_cos();
    let state = in_air(state, environment);
    let (ax, ay, az) = (state[X][2], state[Y][2], state[Z][2] + environment.gravity);
    let (forward, left) = (c * ax + s * ay, -s * ax + c * ay);
    ((-left).atan2(forward.hypot(az)), forward.atan2(az))
}

/// The attitude with a drag for each axis of the body.
pub(crate) fn attitude(state: &NodeState, environment: &Environment) -> Attitude {
    let order = |order: usize| [X, Y, Z].map(|axis| state[axis][order]);
    rotor_drag::attitude(environment, order(1), order(2), state[YAW][0])
}

/// The angle between the thrust direction and the vertical, rad; above pi/2 if the thrust points down.
pub fn tilt(state: &NodeState, environment: &Environment) -> f64 {
    if !environment.turns_alike() {
        let Attitude { roll, pitch, .. } = attitude(state, environment);
        return (roll.cos() * pitch.cos()).clamp(-1.0, 1.0).acos();
    }
    let state = in_air(state, environment);
    state[X][2].hypot(state[Y][2]).atan2(state[Z][2] + environment.gravity)
}
