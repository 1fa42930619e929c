//! The exact wrench of a motion with a drag for each axis of the body: (90a) to (90d) of `docs/method/air.md`,
//! after M. Faessler, A. Franchi, D. Scaramuzza, *Differential flatness of quadrotor dynamics subject to rotor drag for
//! accurate tracking of high-speed trajectories*, IEEE RA-L 3:2 (2018), arXiv 1712.02402.
//!
//! With the drag rates k_x, k_y, k_z along the axes of the body and the velocity u = p' - w through the air, the
//! vectors
//!
//! ```text
//! alpha = p'' + g e_z + k_x u     beta = p'' + g e_z + k_y u     gamma = p'' + g e_z + k_z u
//! ```
//!
//! are turned by -psi about the vertical into (forward, left, up). The ZYX angles and the thrust over mass are
//!
//! ```text
//! theta = atan2(alpha_f, alpha_u)     pi = sin theta beta_f + cos theta beta_u     phi = atan2(-beta_l, pi)
//! c = b_3.gamma     b_3 = (sin theta cos phi, -sin phi, cos theta cos phi)
//! ```
//!
//! Body rates and torques follow from the angles as without drag. All of these are series in time (`Jet`), so that no
//! derivative has an explicit formula.

use super::jet::Jet;
use crate::actuation::Wrench;
use crate::model::{Environment, Vehicle};
use nalgebra::{Matrix3, SMatrix, SVector};
use num_dual::{DualNum, jacobian};

/// Number of derivatives that the wrench depends on.
pub const INPUTS: usize = 15;

/// The derivatives that the wrench depends on, in SI units and in this order: x', y', z', the second, third and fourth
/// derivatives likewise, psi, psi', psi''.
pub type State = SVector<f64, INPUTS>;

/// Number of derivatives that the commanded wrench depends on.
pub const COMMAND_INPUTS: usize = 19;

/// The derivatives that the commanded wrench depends on: a [`State`], then x''''', y''''', z''''', psi'''; SI units.
pub type CommandState = SVector<f64, COMMAND_INPUTS>;

/// The wrench, [T, tau_x, tau_y, tau_z] in N and N m.
pub fn wrench(vehicle: &Vehicle, environment: &Environment, state: &State) -> Wrench {
    wrench_of(vehicle, environment, state)
}

/// The wrench and its derivatives with respect to the state (4 x 15), by forward-mode differentiation.
pub fn wrench_and_jacobian(
    vehicle: &Vehicle,
    environment: &Environment,
    state: &State,
) -> (Wrench, SMatrix<f64, 4, INPUTS>) {
    jacobian(|s| wrench_of(vehicle, environment, &s), state)
}

/// The commanded wrench (84), c = w + tau w', of rotors with a first-order lag of time constant `tau` (s); N and N m.
pub fn commanded(vehicle: &Vehicle, environment: &Environment, tau: f64, state: &CommandState) -> Wrench {
    commanded_of(vehicle, environment, tau, state)
}

/// The commanded wrench and its derivatives with respect to the state (4 x 19), by forward-mode differentiation.
pub fn commanded_and_jacobian(
    vehicle: &Vehicle,
    environment: &Environment,
    tau: f64,
    state: &CommandState,
) -> (Wrench, SMatrix<f64, 4, COMMAND_INPUTS>) {
    jacobian(|s| commanded_of(vehicle, environment, tau, &s), state)
}

/// Attitude and thrust for a velocity (m/s), an acceleration (m/s^2) and a yaw (rad).
pub fn attitude(environment: &Environment, velocity: [f64; 3], acceleration: [f64; 3], psi: f64) -> Attitude {
    let motion = std::array::from_fn(|axis| [velocity[axis], acceleration[axis]]);
    let angles = Angles::<f64, 1>::of(environment, motion, Jet([psi]));
    let g = environment.gravity;
    let value = |j: Jet<f64, 1>| j.0[0];
    let thrust = value(angles.thrust());
    let Angles { alpha, beta, pitch, roll, .. } = angles;
    let [alpha, beta] = [alpha, beta].map(|v| v.map(value));
    Attitude {
        thrust,
        roll: value(roll.sin).atan2(value(roll.cos)),
        pitch: value(pitch.sin).atan2(value(pitch.cos)),
        lift: alpha[2].min(beta[2]) / g,
        product: (alpha[0] * beta[0] + alpha[2] * beta[2]) / (g * g),
    }
}

/// The thrust and the attitude that a motion needs; see [`attitude`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    /// The thrust over mass c, m/s^2.
    pub thrust: f64,
    /// ZYX angles, rad.
    pub roll: f64,
    /// rad
    pub pitch: f64,
    /// The smaller of alpha_u/g and beta_u/g.
    pub lift: f64,
    /// `(alpha_f beta_f + alpha_u beta_u)/g^2`: the body's z axis points up where it and `lift` are positive.
    pub product: f64,
}

/// The thrust over mass as a vector of the world, c b_3, and its first two time derivatives (m/s^2 and per second), for
/// the derivatives of orders 1 to 4 of the position and 0 to 2 of yaw.
pub fn thrust_vector(environment: &Environment, motion: [[f64; 3]; 4], yaw: [f64; 3]) -> [[f64; 3]; 3] {
    let of_axis = std::array::from_fn(|axis| motion.map(|order| order[axis]));
    let psi = Jet::of_derivatives(yaw);
    let angles = Angles::<f64, 3>::of(environment, of_axis, psi);
    let (s, c) = psi.sin_cos();
    let (thrust, [f, l, u]) = (angles.thrust(), angles.up());
    let vector = [c * f - s * l, s * f + c * l, u].map(|part| thrust * part);
    // c_n = d_n / n!
    let derivative = |n: usize| vector.map(|part| [1.0, 1.0, 2.0][n] * part.0[n]);
    [derivative(0), derivative(1), derivative(2)]
}

/// The attitude R, whose columns are the axes of the body, and its rate of change for a velocity (m/s), an acceleration
/// (m/s^2), a jerk (m/s^3), a yaw (rad) and a yaw rate (rad/s).
pub fn rotation(environment: &Environment, motion: [[f64; 3]; 3], yaw: [f64; 2]) -> [Matrix3<f64>; 2] {
    let of_axis = std::array::from_fn(|axis| motion.map(|order| order[axis]));
    let psi = Jet::of_derivatives(yaw);
    let angles = Angles::<f64, 2>::of(environment, of_axis, psi);
    let Angles { pitch, roll, .. } = &angles;
    let (s, c) = psi.sin_cos();
    // Columns in the frame that turns with the yaw.
    let columns = [
        [pitch.cos, Jet::constant(0.0), -pitch.sin],
        [roll.sin * pitch.sin, roll.cos, roll.sin * pitch.cos],
        angles.up(),
    ];
    let world = columns.map(|[f, l, u]| [c * f - s * l, s * f + c * l, u]);
    [0, 1].map(|n| Matrix3::from_fn(|row, column| world[column][row].0[n]))
}

/// Sine, cosine and rate of an angle as series in time.
struct Angle<D, const N: usize> {
    sin: Jet<D, N>,
    cos: Jet<D, N>,
    rate: Jet<D, N>,
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Angle<D, N> {
    /// atan2(y, x), whose rate is `(y' x - y x') / (x^2 + y^2)`.
    fn atan2(y: Jet<D, N>, x: Jet<D, N>) -> Self {
        let square = x * x + y * y;
        let length = square.sqrt();
        Angle { sin: y.over(length), cos: x.over(length), rate: (y.rate() * x - y * x.rate()).over(square) }
    }
}

/// The vectors (90a) in the frame that turns with the yaw, and the angles (90d).
struct Angles<D, const N: usize> {
    alpha: [Jet<D, N>; 3],
    beta: [Jet<D, N>; 3],
    gamma: [Jet<D, N>; 3],
    pitch: Angle<D, N>,
    roll: Angle<D, N>,
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Angles<D, N> {
    /// `motion` holds for each of x, y, z the derivatives of orders 1 to N + 1.
    fn of<const M: usize>(environment: &Environment, motion: [[D; M]; 3], psi: Jet<D, N>) -> Self {
        let orders = |axis: usize, from: usize| {
            Jet::of_derivatives(std::array::from_fn(|n| {
                motion[axis].get(from - 1 + n).copied().unwrap_or(D::from(f64::NAN))
            }))
        };
        let air: [Jet<D, N>; 3] = std::array::from_fn(|axis| orders(axis, 1) - Jet::constant(environment.wind[axis]));
        let gravity = [0.0, 0.0, environment.gravity];
        let (s, c) = psi.sin_cos();
        let felt = |rate: f64| {
            let [x, y, z]: [Jet<D, N>; 3] =
                std::array::from_fn(|axis| orders(axis, 2) + Jet::constant(gravity[axis]) + air[axis].times(rate));
            [c * x + s * y, c * y - s * x, z]
        };
        // (90a)
        let [alpha, beta, gamma] = environment.drag_rates.map(felt);
        // (90d)
        let pitch = Angle::atan2(alpha[0], alpha[2]);
        let up = pitch.sin * beta[0] + pitch.cos * beta[2];
        let roll = Angle::atan2(-beta[1], up);
        Angles { alpha, beta, gamma, pitch, roll }
    }

    /// The body's z axis b_3 in the frame that turns with the yaw.
    fn up(&self) -> [Jet<D, N>; 3] {
        let Angles { pitch, roll, .. } = self;
        [pitch.sin * roll.cos, -roll.sin, pitch.cos * roll.cos]
    }

    /// (90c): the thrust over mass, b_3.gamma.
    fn thrust(&self) -> Jet<D, N> {
        let (up, gamma) = (self.up(), self.gamma);
        up[0] * gamma[0] + up[1] * gamma[1] + up[2] * gamma[2]
    }
}

/// The wrench as a series, of which N - 2 coefficients are known. `motion` holds for each of x, y, z the derivatives of
/// orders 1 to N + 1; psi has N.
fn series<D: DualNum<Primitive = f64> + Copy, const N: usize, const M: usize>(
    vehicle: &Vehicle,
    environment: &Environment,
    motion: [[D; M]; 3],
    psi: [D; N],
) -> [Jet<D, N>; 4] {
    let psi = Jet::of_derivatives(psi);
    let angles = Angles::of(environment, motion, psi);
    let c = angles.thrust();
    let Angles { pitch, roll, .. } = angles;
    // (65)
    let turn = psi.rate();
    let rates = [
        roll.rate - turn * pitch.sin,
        pitch.rate * roll.cos + turn * roll.sin * pitch.cos,
        turn * roll.cos * pitch.cos - pitch.rate * roll.sin,
    ];
    // (67)
    let inertia = vehicle.inertia;
    let torque = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        rates[i].rate().times(inertia[i]) + (rates[j] * rates[k]).times(inertia[k] - inertia[j])
    };
    [c.times(vehicle.mass), torque(0), torque(1), torque(2)]
}

fn wrench_of<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    environment: &Environment,
    s: &SVector<D, INPUTS>,
) -> SVector<D, 4> {
    let motion = std::array::from_fn(|axis| std::array::from_fn::<D, 4, _>(|n| s[3 * n + axis]));
    let parts = series::<D, 3, 4>(vehicle, environment, motion, [s[12], s[13], s[14]]);
    SVector::from(parts.map(|part| part.0[0]))
}

fn commanded_of<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    environment: &Environment,
    tau: f64,
    s: &SVector<D, COMMAND_INPUTS>,
) -> SVector<D, 4> {
    let of_axis = |axis: usize| [s[axis], s[3 + axis], s[6 + axis], s[9 + axis], s[15 + axis]];
    let parts = series::<D, 4, 5>(vehicle, environment, [0, 1, 2].map(of_axis), [s[12], s[13], s[14], s[18]]);
    SVector::from(parts.map(|part| part.0[0] + part.0[1] * D::from(tau)))
}
