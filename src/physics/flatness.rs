//! The exact wrench of a motion by (3) to (9), without small angles: position and yaw are flat outputs of a multirotor
//! (D. Mellinger, V. Kumar, *Minimum snap trajectory generation and control for quadrotors*, ICRA 2011), so thrust,
//! attitude, body rates and torques are functions of their derivatives. See `docs/method/exact-model.md`, (60) to (67),
//! and for the commanded wrench of lagging rotors `docs/method/rotor-lag.md`, (84).
//!
//! With a = (x'', y'', z'' + g), rotated by -psi about the vertical into (f, l, v), that is, forward, left and up:
//!
//! ```text
//! T = m |a|     theta = atan2(f, v)     phi = atan2(-l, k)     k = sqrt(f^2 + v^2)     ZYX angles, third column of (4)
//! p = phi' - psi' sin theta
//! q = theta' cos phi + psi' sin phi cos theta
//! r = psi' cos phi cos theta - theta' sin phi
//! tau = J w' + w x J w     w = (p, q, r)
//! ```
//!
//! The formulas hold for every attitude except phi = +-90 degrees (k = 0), where ZYX angles are not defined, and in
//! free fall (|a| = 0), where the thrust has no direction. There the wrench is not finite.

mod gradient;
mod intermediates;
mod jet;
pub mod rotor_drag;

use crate::actuation::Wrench;
use crate::model::Vehicle;
use intermediates::Intermediates;
use nalgebra::{Const, SMatrix, SVector};
use num_dual::{Dual, Dual2SVec64, DualNum, jacobian};

/// Number of derivatives that the wrench depends on.
pub const INPUTS: usize = 12;

/// The derivatives that the wrench depends on, in SI units and in this order: x'', y'', z'', x''', y''', z''', x'''',
/// y'''', z'''', psi, psi', psi''.
pub type FlatState = SVector<f64, INPUTS>;

/// The wrench (67), [T, tau_x, tau_y, tau_z] in N and N m. `gravity` is in m/s^2.
pub fn wrench(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> Wrench {
    Intermediates::new(gravity, state).wrench(vehicle)
}

/// The wrench and its derivatives with respect to the flat state (4 x 12), by forward-mode differentiation.
pub fn wrench_and_jacobian(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> (Wrench, SMatrix<f64, 4, INPUTS>) {
    jacobian(|s| Intermediates::new(gravity, &s).wrench(vehicle), state)
}

/// T (N), `s x s''` and s' across the direction s of the thrust, in body axes, and the rate of the body about s: what a
/// motion takes whatever the heading, since another heading turns both pairs alike.
///
/// ```text
/// (99)  s' = (q, -p)     s x s'' = (p' - q r, q' + p r)
/// ```
fn turning_of<D: DualNum<Primitive = f64> + Copy>(
    mass: f64,
    gravity: f64,
    state: &SVector<D, INPUTS>,
) -> SVector<D, 6> {
    let Intermediates { n, rates: [p, q, r], accelerations: [p1, q1, _], .. } = Intermediates::new(gravity, state);
    SVector::from([n * D::from(mass), p1 - q * r, q1 + p * r, q, -p, r])
}

/// T, `s x s''` and s' across the thrust, and the rate about it (99): N, 1/s^2, 1/s, rad/s.
pub fn turning(mass: f64, gravity: f64, state: &FlatState) -> SVector<f64, 6> {
    turning_of(mass, gravity, state)
}

/// The turning of the thrust (6) and its derivatives with respect to the flat state (6 x 12).
pub fn turning_and_jacobian(mass: f64, gravity: f64, state: &FlatState) -> (SVector<f64, 6>, SMatrix<f64, 6, INPUTS>) {
    jacobian(|s| turning_of(mass, gravity, &s), state)
}

/// The second derivatives of n.w with respect to the flat state (12 x 12), by forward-mode differentiation of the
/// reverse-mode gradient. Each operation then carries 13 numbers instead of the 157 of forward mode applied twice.
pub fn curvature(vehicle: &Vehicle, gravity: f64, state: &FlatState, n: &Wrench) -> SMatrix<f64, INPUTS, INPUTS> {
    jacobian(|s| Intermediates::new(gravity, &s).gradient(vehicle, n), state).1
}

/// Number of derivatives that the commanded wrench depends on.
pub const COMMAND_INPUTS: usize = 16;

/// The derivatives that the commanded wrench depends on: a [`FlatState`], then x''''', y''''', z''''', psi''', in SI
/// units.
pub type CommandFlatState = SVector<f64, COMMAND_INPUTS>;

/// The index in a [`CommandFlatState`] of the time derivative of each entry of a flat state.
const RATES: [usize; INPUTS] = [3, 4, 5, 6, 7, 8, 12, 13, 14, 10, 11, 15];

/// The commanded wrench (84), c = w + tau w', of rotors with a first-order lag of time constant `tau` (s); N and N m.
pub fn commanded(vehicle: &Vehicle, gravity: f64, tau: f64, state: &CommandFlatState) -> Wrench {
    commanded_of(vehicle, gravity, tau, state)
}

/// The commanded wrench and its derivatives with respect to the state (4 x 16), by forward-mode differentiation.
pub fn commanded_and_jacobian(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &CommandFlatState,
) -> (Wrench, SMatrix<f64, 4, COMMAND_INPUTS>) {
    jacobian(|s| commanded_of(vehicle, gravity, tau, &s), state)
}

/// The second derivatives of n.c with respect to the state (16 x 16).
pub fn commanded_curvature(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &CommandFlatState,
    n: &Wrench,
) -> SMatrix<f64, COMMAND_INPUTS, COMMAND_INPUTS> {
    // n.c = n.w(s) + tau g(s).s' with the gradient g of n.w. Its gradient in s with s' fixed is g + tau g', in s' it is
    // tau g.
    let gradient = |s: SVector<_, COMMAND_INPUTS>| {
        let along = Intermediates::new(gravity, &moving(&s)).gradient(vehicle, n);
        let mut sum = SVector::<_, COMMAND_INPUTS>::zeros();
        for (i, g) in along.iter().enumerate() {
            sum[i] += g.re + g.eps * tau;
            sum[RATES[i]] += g.re * tau;
        }
        sum
    };
    jacobian(gradient, state).1
}

/// The dual number s + epsilon s', epsilon^2 = 0, of a state and its time derivative.
fn moving<D: DualNum<Primitive = f64> + Copy>(state: &SVector<D, COMMAND_INPUTS>) -> SVector<Dual<D>, INPUTS> {
    SVector::from_fn(|i, _| Dual::new(state[i], state[RATES[i]]))
}

/// (84) on dual numbers, whose real part is w and whose dual part is w' = (dw/ds) s'.
fn commanded_of<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &SVector<D, COMMAND_INPUTS>,
) -> SVector<D, 4> {
    Intermediates::new(gravity, &moving(state)).wrench(vehicle).map(|w| w.re + w.eps * D::from(tau))
}

/// The indices i <= j of the axes of [`ByAcceleration::curvatures`].
pub const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// First and second derivatives of a wrench with respect to x'', y'' and z'', with all other derivatives fixed.
#[derive(Debug, Clone, PartialEq)]
pub struct ByAcceleration {
    /// By x'', y'', z''.
    pub slopes: [SVector<f64, 4>; 3],
    /// By each of [`PAIRS`].
    pub curvatures: [SVector<f64, 4>; 6],
}

/// Derivatives of the wrench with respect to the acceleration.
pub fn wrench_by_acceleration(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> ByAcceleration {
    by_acceleration(Intermediates::new(gravity, &accelerating(state)).wrench(vehicle))
}

/// Derivatives of the commanded wrench (84) with respect to the acceleration.
pub fn commanded_by_acceleration(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &CommandFlatState,
) -> ByAcceleration {
    by_acceleration(commanded_of(vehicle, gravity, tau, &accelerating(state)))
}

/// A state whose first three entries, x'', y'' and z'', are the variables.
fn accelerating<const N: usize>(state: &SVector<f64, N>) -> SVector<Dual2SVec64<3>, N> {
    SVector::from_fn(|i, _| {
        let value = Dual2SVec64::from_re(state[i]);
        if i < 3 { value.derivative(i) } else { value }
    })
}

fn by_acceleration(wrench: SVector<Dual2SVec64<3>, 4>) -> ByAcceleration {
    let slopes = wrench.map(|w| w.v1.unwrap_generic(Const::<1>, Const::<3>));
    let curvatures = wrench.map(|w| w.v2.unwrap_generic(Const::<3>, Const::<3>));
    ByAcceleration {
        slopes: std::array::from_fn(|i| SVector::from_fn(|row, _| slopes[row][i])),
        curvatures: PAIRS.map(|at| SVector::from_fn(|row, _| curvatures[row][at])),
    }
}
