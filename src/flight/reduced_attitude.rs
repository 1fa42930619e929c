//! Control with yaw given up: the direction of the thrust alone is controlled, while the body turns about it as the rotors
//! that are left make it turn (`docs/flight.md`, section 2, "Without yaw").
//!
//! Relaxing the attitude of a vehicle with lost rotors in this way is due to M. W. Mueller and R. D'Andrea (ICRA 2014, doi
//! 10.1109/ICRA.2014.6906588); their patent US 9,856,016 covers such flight controllers.

use super::allocate::{Allocator, Belief};
use super::body::{Body, Frame};
use super::control::{demanded_force, direction};
use super::reference::Reference;
use crate::actuation::Wrench;
use crate::model::Gains;
use nalgebra::Vector3;

/// Hover keeps all axes if thrust and torques can still change by this share of their largest values in both directions.
const KEPT: f64 = 0.01;

/// At most this share of a wrench may be missing.
const REACHED: f64 = 1e-3;

/// Whether a vehicle that believes these capacities has no control of yaw left about hover, so that yaw is given up. `hover` is in N
/// and N m.
pub fn gives_up_yaw(allocator: &Allocator, hover: &Wrench, belief: &Belief) -> bool {
    let both_ways = |axis: usize| {
        [KEPT, -KEPT].into_iter().any(|share| {
            let mut wrench = *hover;
            wrench[axis] += share * allocator.extent()[axis];
            allocator.missing_all(&wrench, belief) > REACHED
        })
    };
    (1..4).any(both_ways)
}

/// The wrench (N and N m, body frame) for the direction of the thrust. With the demanded force over mass F, its direction n_d and the
/// body's z axis s in the world frame,
///
/// ```text
/// alpha = n_d x n_d'' + k_R angle(s, n_d) (s x n_d)/|s x n_d| + k_w (n_d x n_d' - s x s')    across s, in body axes (a_x, a_y, .)
/// p'    = a_x + r q                      q'    = a_y - r p
/// tau_x = Jx p' + (Jz - Jy) q r + h q    tau_y = Jy q' + (Jx - Jz) r p - h p    T = m F . s
/// ```
///
/// h is the momentum of the rotors about z, N m s. A torque that is fixed in space turns at -r in the body, faster than lagging
/// rotors follow, so it is commanded ahead by their time constant `lag` (s): `tau + lag (r tau_y, -r tau_x)`. The yaw torque slows the spin
/// with the gain of the yaw rate, as far as rotors are left for it.
pub fn control(
    frame: &Frame,
    gains: &Gains,
    measured: &Body,
    force: f64,
    reference: &Reference,
    lag: f64,
    momentum: f64,
) -> Wrench {
    let demanded = demanded_force(frame, gains, measured, force, reference);
    let s = measured.up();
    let thrust = frame.mass * demanded[0].dot(&s);
    let small = demanded[0].norm() < 0.05 * frame.gravity;
    let [n, n1, n2] = if small { [s, Vector3::zeros(), Vector3::zeros()] } else { direction(demanded) };
    let [p, q, r] = measured.rates.into();
    let rotation = measured.rotation();
    let turning = rotation * Vector3::new(p, q, 0.0);
    let axis = s.cross(&n);
    let angle = axis.norm().atan2(s.dot(&n));
    // Exactly upside down every axis across s will do.
    let towards = if axis.norm() > 1e-9 { axis.normalize() * angle } else { rotation * Vector3::x() * angle };
    let alpha = n.cross(&n2) + towards * gains.attitude + (n.cross(&n1) - turning) * gains.attitude_rate;
    let alpha = rotation.inverse() * alpha;
    let [jx, jy, jz] = frame.inertia.into();
    let (p1, q1) = (alpha.x + r * q, alpha.y - r * p);
    let tau_x = jx * p1 + (jz - jy) * q * r + momentum * q;
    let tau_y = jy * q1 + (jx - jz) * r * p - momentum * p;
    Wrench::new(thrust, tau_x + lag * r * tau_y, tau_y - lag * r * tau_x, -gains.yaw_rate * jz * r)
}
