//! The exact wrench of a motion, (3) to (9), without small angles: position and yaw are flat outputs of a multirotor
//! (Mellinger and Kumar, ICRA 2011), so thrust, attitude, body rates and torques follow from their derivatives.
//!
//! With a = (x'', y'', z'' + g), turned back by psi about the vertical into (f, l, v), forward, left, up:
//!
//! T = m |a|, theta = atan2(f, v), phi = atan2(-l, k), k = sqrt(f^2 + v^2)   (ZYX angles, third column of (4)),
//! p = phi' - psi' sin theta,
//! q = theta' cos phi + psi' sin phi cos theta,
//! r = psi' cos phi cos theta - theta' sin phi,
//! tau = J w' + w x J w, w = (p, q, r).
//!
//! The formulas hold for every attitude but phi = +-90 degrees (k = 0) and free fall (|a| = 0), where ZYX angles or
//! the thrust's direction are not defined; there the wrench is not finite.

mod gradient;
mod intermediates;

use crate::actuation::Wrench;
use crate::model::Vehicle;
use intermediates::Intermediates;
use nalgebra::{SMatrix, SVector};
use num_dual::{Dual, DualNum, jacobian};

/// Derivatives that the wrench depends on, in the order of [`FlatState`].
pub const INPUTS: usize = 12;

/// (x'', y'', z'', x''', y''', z''', x'''', y'''', z'''', psi, psi', psi''), SI units.
pub type FlatState = SVector<f64, INPUTS>;

/// [T, tau_x, tau_y, tau_z] in N and N m.
pub fn wrench(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> Wrench {
    Intermediates::new(gravity, state).wrench(vehicle)
}

/// The wrench and its derivatives with respect to the flat state, 4 x 12, by forward-mode differentiation.
pub fn wrench_and_jacobian(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> (Wrench, SMatrix<f64, 4, INPUTS>) {
    jacobian(|s| Intermediates::new(gravity, &s).wrench(vehicle), state)
}

/// Second derivatives of n.w with respect to the flat state, 12 x 12: forward-mode derivatives of its gradient, 13
/// numbers in each operation instead of the 157 of forward mode twice.
pub fn curvature(vehicle: &Vehicle, gravity: f64, state: &FlatState, n: &Wrench) -> SMatrix<f64, INPUTS, INPUTS> {
    jacobian(|s| Intermediates::new(gravity, &s).gradient(vehicle, n), state).1
}

/// Derivatives that the lead wrench depends on, in the order of [`CommandFlatState`].
pub const COMMAND_INPUTS: usize = 16;

/// A [`FlatState`], then (x''''', y''''', z''''', psi'''), SI units.
pub type CommandFlatState = SVector<f64, COMMAND_INPUTS>;

/// Where the time derivative of each entry of a flat state stands in a [`CommandFlatState`].
const RATES: [usize; INPUTS] = [3, 4, 5, 6, 7, 8, 12, 13, 14, 10, 11, 15];

/// The lead wrench c = w + tau w' of rotors that lag by `tau` s, N and N m.
pub fn commanded(vehicle: &Vehicle, gravity: f64, tau: f64, state: &CommandFlatState) -> Wrench {
    commanded_of(vehicle, gravity, tau, state)
}

/// The lead wrench and its derivatives, 4 x 16.
pub fn commanded_and_jacobian(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &CommandFlatState,
) -> (Wrench, SMatrix<f64, 4, COMMAND_INPUTS>) {
    jacobian(|s| commanded_of(vehicle, gravity, tau, &s), state)
}

/// Second derivatives of n.c, 16 x 16.
pub fn commanded_curvature(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &CommandFlatState,
    n: &Wrench,
) -> SMatrix<f64, COMMAND_INPUTS, COMMAND_INPUTS> {
    // Of n.c = n.w(s) + tau G(s).s', G the gradient of n.w: first derivatives in s with s' as it is, then those in s'.
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

/// A state that moves: s + epsilon s', epsilon^2 = 0.
fn moving<D: DualNum<Primitive = f64> + Copy>(state: &SVector<D, COMMAND_INPUTS>) -> SVector<Dual<D>, INPUTS> {
    SVector::from_fn(|i, _| Dual::new(state[i], state[RATES[i]]))
}

/// w and w' = J(s) s' at once.
fn commanded_of<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &SVector<D, COMMAND_INPUTS>,
) -> SVector<D, 4> {
    Intermediates::new(gravity, &moving(state)).wrench(vehicle).map(|w| w.re + w.eps * D::from(tau))
}
