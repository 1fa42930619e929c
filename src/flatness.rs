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

use crate::actuation::Wrench;
use crate::model::Vehicle;
use nalgebra::{SMatrix, SVector};
use num_dual::{Dual, DualNum, hessian, jacobian};

/// Derivatives that the wrench depends on, in the order of [`FlatState`].
pub const INPUTS: usize = 12;

/// (x'', y'', z'', x''', y''', z''', x'''', y'''', z'''', psi, psi', psi''), SI units.
pub type FlatState = SVector<f64, INPUTS>;

/// [T, tau_x, tau_y, tau_z] in N and N m.
pub fn wrench(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> Wrench {
    of(vehicle, gravity, state)
}

/// The wrench and its derivatives with respect to the flat state, 4 x 12, by forward-mode differentiation.
pub fn wrench_and_jacobian(vehicle: &Vehicle, gravity: f64, state: &FlatState) -> (Wrench, SMatrix<f64, 4, INPUTS>) {
    jacobian(|s| of(vehicle, gravity, &s), state)
}

/// Second derivatives of n.w with respect to the flat state, 12 x 12.
pub fn curvature(vehicle: &Vehicle, gravity: f64, state: &FlatState, n: &Wrench) -> SMatrix<f64, INPUTS, INPUTS> {
    let along = |s: SVector<_, INPUTS>| {
        let w = of(vehicle, gravity, &s);
        w[0] * n[0] + w[1] * n[1] + w[2] * n[2] + w[3] * n[3]
    };
    hessian(along, state).2
}

/// Derivatives that the lead wrench depends on, in the order of [`LeadFlatState`].
pub const LEAD_INPUTS: usize = 16;

/// A [`FlatState`], then (x''''', y''''', z''''', psi'''), SI units.
pub type LeadFlatState = SVector<f64, LEAD_INPUTS>;

/// Where the time derivative of each entry of a flat state stands in a [`LeadFlatState`].
const RATES: [usize; INPUTS] = [3, 4, 5, 6, 7, 8, 12, 13, 14, 10, 11, 15];

/// The lead wrench c = w + tau w' of rotors that lag by `tau` s, N and N m.
pub fn lead(vehicle: &Vehicle, gravity: f64, tau: f64, state: &LeadFlatState) -> Wrench {
    leading(vehicle, gravity, tau, state)
}

/// The lead wrench and its derivatives, 4 x 16.
pub fn lead_and_jacobian(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &LeadFlatState,
) -> (Wrench, SMatrix<f64, 4, LEAD_INPUTS>) {
    jacobian(|s| leading(vehicle, gravity, tau, &s), state)
}

/// Second derivatives of n.c, 16 x 16.
pub fn lead_curvature(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &LeadFlatState,
    n: &Wrench,
) -> SMatrix<f64, LEAD_INPUTS, LEAD_INPUTS> {
    let along = |s: SVector<_, LEAD_INPUTS>| {
        let c = leading(vehicle, gravity, tau, &s);
        c[0] * n[0] + c[1] * n[1] + c[2] * n[2] + c[3] * n[3]
    };
    hessian(along, state).2
}

/// w and w' = J(s) s' at once: the wrench of s + epsilon s', epsilon^2 = 0.
fn leading<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    gravity: f64,
    tau: f64,
    state: &SVector<D, LEAD_INPUTS>,
) -> SVector<D, 4> {
    let moving = SVector::<Dual<D>, INPUTS>::from_fn(|i, _| Dual::new(state[i], state[RATES[i]]));
    of(vehicle, gravity, &moving).map(|w| w.re + w.eps * D::from(tau))
}

/// Sine, cosine and the first two time derivatives of an angle.
struct Angles<D> {
    sin: D,
    cos: D,
    rate: D,
    acceleration: D,
}

fn of<D: DualNum<Primitive = f64> + Copy>(
    vehicle: &Vehicle,
    gravity: f64,
    state: &SVector<D, INPUTS>,
) -> SVector<D, 4> {
    let [x2, y2, z2, x3, y3, z3, x4, y4, z4, psi, psi1, psi2]: [D; INPUTS] = (*state).into();
    let (s, c) = psi.sin_cos();
    let two = D::from(2.0);
    // a, a', a'' in the frame that turns with psi; a turning frame adds psi' terms.
    let forward = |x: D, y: D| c * x + s * y;
    let left = |x: D, y: D| c * y - s * x;
    let (f, l, v) = (forward(x2, y2), left(x2, y2), z2 + D::from(gravity));
    let (f3, l3) = (forward(x3, y3), left(x3, y3));
    let (f1, l1, v1) = (f3 + psi1 * l, l3 - psi1 * f, z3);
    let f_2 = forward(x4, y4) + two * psi1 * l3 + psi2 * l - psi1 * psi1 * f;
    let l_2 = left(x4, y4) - two * psi1 * f3 - psi2 * f - psi1 * psi1 * l;
    let v_2 = z4;

    // h = f^2 + v^2 = k^2, n^2 = |a|^2.
    let h = f * f + v * v;
    let h1 = two * (f * f1 + v * v1);
    let h2 = two * (f1 * f1 + f * f_2 + v1 * v1 + v * v_2);
    let k = h.sqrt();
    let k1 = h1 / (two * k);
    let k2 = (h2 / two - k1 * k1) / k;
    let nn = h + l * l;
    let nn1 = h1 + two * l * l1;
    let n = nn.sqrt();

    // theta = atan2(f, v): theta' = (f' v - f v') / h.
    let pitch_rate = (f1 * v - f * v1) / h;
    let pitch = Angles {
        sin: f / k,
        cos: v / k,
        rate: pitch_rate,
        acceleration: (f_2 * v - f * v_2) / h - pitch_rate * h1 / h,
    };
    // phi = atan2(-l, k): phi' = (l k' - l' k) / n^2.
    let roll_rate = (l * k1 - l1 * k) / nn;
    let roll = Angles {
        sin: -l / n,
        cos: k / n,
        rate: roll_rate,
        acceleration: (l * k2 - l_2 * k) / nn - roll_rate * nn1 / nn,
    };
    let (sin_phi, cos_phi, sin_theta, cos_theta) = (roll.sin, roll.cos, pitch.sin, pitch.cos);

    let p = roll.rate - psi1 * sin_theta;
    let q = pitch.rate * cos_phi + psi1 * sin_phi * cos_theta;
    let r = psi1 * cos_phi * cos_theta - pitch.rate * sin_phi;
    let p1 = roll.acceleration - psi2 * sin_theta - psi1 * cos_theta * pitch.rate;
    let q1 = pitch.acceleration * cos_phi - pitch.rate * roll.rate * sin_phi
        + psi2 * sin_phi * cos_theta
        + psi1 * (cos_phi * roll.rate * cos_theta - sin_phi * sin_theta * pitch.rate);
    let r1 = psi2 * cos_phi * cos_theta
        - psi1 * (sin_phi * roll.rate * cos_theta + cos_phi * sin_theta * pitch.rate)
        - pitch.acceleration * sin_phi
        - pitch.rate * roll.rate * cos_phi;

    let [ixx, iyy, izz] = vehicle.inertia.map(D::from);
    SVector::from([
        n * D::from(vehicle.mass),
        ixx * p1 + (izz - iyy) * q * r,
        iyy * q1 + (ixx - izz) * r * p,
        izz * r1 + (iyy - ixx) * p * q,
    ])
}
