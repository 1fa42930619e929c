//! The controllers, which compute a wrench from the measured state and the reference (`docs/flight.md`, section 2).

use super::body::{Body, Frame};
use super::heading::wrapped;
use super::reference::Reference;
use crate::actuation::Wrench;
use crate::model::{Controller, Gains};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector2, Vector3};

/// The largest acceleration that feedback on position and velocity demands, as a share of gravity, or of the planned
/// force over mass where that is less: it turns the thrust by at most 30 degrees. A vehicle far from its reference
/// shall return without turning over, and one whose plan hardly needs thrust shall not.
const MOST_FEEDBACK: f64 = 0.5;

/// The wrench (N and N m, body frame) that a controller demands. `measured` is the body as measured by the sensors, and
/// `force` the present thrust over the mass, m/s^2, as modelled.
pub fn control(
    controller: Controller,
    frame: &Frame,
    gains: &Gains,
    measured: &Body,
    force: f64,
    reference: &Reference,
) -> Wrench {
    match controller {
        Controller::Pd => pd(frame, gains, measured, reference),
        Controller::Geometric => geometric(frame, gains, measured, force, reference),
    }
}

/// The paper's PD law, (21) to (28), linear about hover at the reference yaw.
///
/// All errors are e = reference - measured. The angles phi, theta, psi are ZYX; c and s are the cosine and sine of the
/// reference yaw.
fn pd(frame: &Frame, gains: &Gains, measured: &Body, reference: &Reference) -> Wrench {
    let g = frame.gravity;
    let [phi, theta, psi] = measured.angles();
    let [p, q, r] = measured.rates.into();
    let (s, c) = reference.yaw[0].sin_cos();
    let xy = |v: &Vector3<f64>| Vector2::new(v.x, v.y);
    let e = reference.position - measured.position;
    let e1 = reference.velocity - measured.velocity;
    // (19) and its derivative with (16): the present x'' and x'''.
    let now = |theta: f64, phi: f64| Vector2::new(c * theta + s * phi, s * theta - c * phi) * g;
    let (a, j) = (now(theta, phi), now(q, p));
    let e2 = xy(&reference.acceleration) - a;
    let e3 = xy(&reference.jerk) - j;
    // (25) and (28).
    let (kd, kp) = (gains.velocity, gains.position);
    let x2 = xy(&reference.acceleration) + xy(&e1) * kd + xy(&e) * kp;
    let x3 = xy(&reference.jerk) + e2 * kd + xy(&e1) * kp;
    let x4 = xy(&reference.snap) + e3 * kd + e2 * kp;
    // (26) and (27).
    let roll_pitch = |x: Vector2<f64>| Vector2::new(s * x.x - c * x.y, c * x.x + s * x.y) / g;
    let (angle, rate, acceleration) = (roll_pitch(x2), roll_pitch(x3), roll_pitch(x4));
    // (21)
    let thrust = frame.mass * (g + reference.acceleration.z + gains.climb * e1.z + gains.altitude * e.z);
    // (23)
    let wanted = Vector3::new(acceleration.x, acceleration.y, reference.yaw[2]);
    let error = Vector3::new(angle.x - phi, angle.y - theta, wrapped(reference.yaw[0] - psi));
    let error_rate = Vector3::new(rate.x - p, rate.y - q, reference.yaw[1] - r);
    let kp = Vector3::new(gains.attitude, gains.attitude, gains.yaw);
    let kd = Vector3::new(gains.attitude_rate, gains.attitude_rate, gains.yaw_rate);
    let torque = frame.inertia.component_mul(&(wanted + kd.component_mul(&error_rate) + kp.component_mul(&error)));
    Wrench::new(thrust, torque.x, torque.y, torque.z)
}

/// The force over mass (m/s^2, world frame) that the geometric controllers demand, with its first two time derivatives:
/// F/m of [`geometric`].
///
/// The derivatives use the errors of acceleration and jerk, which follow from the present thrust over mass `force`
/// (m/s^2) and the measured rates. Feedback on position and velocity is limited to half of g and of the planned force
/// over mass.
pub(super) fn demanded_force(
    frame: &Frame,
    gains: &Gains,
    measured: &Body,
    force: f64,
    reference: &Reference,
) -> [Vector3<f64>; 3] {
    let kx = Vector3::new(gains.position, gains.position, gains.altitude);
    let kv = Vector3::new(gains.velocity, gains.velocity, gains.climb);
    let rotation = measured.rotation().to_rotation_matrix();
    let r: &Matrix3<f64> = rotation.matrix();
    let up: Vector3<f64> = r.column(2).into();
    let e3 = Vector3::z();
    let w = measured.rates;
    // The present x'' from the thrust and its direction: (7) without drag.
    let acceleration = up * force - e3 * frame.gravity;
    let e = [
        reference.position - measured.position,
        reference.velocity - measured.velocity,
        reference.acceleration - acceleration,
    ];
    let feedback = |e: &Vector3<f64>, rate: &Vector3<f64>| kx.component_mul(e) + kv.component_mul(rate);
    let planned = reference.acceleration + e3 * frame.gravity;
    let most = MOST_FEEDBACK * planned.norm().min(frame.gravity);
    let asked = feedback(&e[0], &e[1]);
    let is_far = asked.norm() > most;
    let back = if is_far { asked * (most / asked.norm()) } else { asked };
    let back1 = if is_far { Vector3::zeros() } else { feedback(&e[1], &e[2]) };
    let f = planned + back;
    let f1 = reference.jerk + back1;
    // The present x''': the direction turns with the body, and the thrust m F . R e_3 changes as well.
    let turning = r * w.cross(&e3);
    let jerk = turning * force + up * (f1.dot(&up) + f.dot(&turning));
    let back2 = if is_far { Vector3::zeros() } else { feedback(&e[2], &(reference.jerk - jerk)) };
    [f, f1, reference.snap + back2]
}

/// Geometric tracking control on SE(3): T. Lee, M. Leok, N. H. McClamroch, *Geometric tracking control of a quadrotor
/// UAV on SE(3)*, CDC 2010, equations (12), (15) and (16), with z up:
///
/// ```text
/// F/m = -k_x e_x - k_v e_v + g e_3 + x_d''     b_3d = F/|F|     T = F . R e_3
/// e_R = (R_d' R - R' R_d)^vee / 2              e_w = w - R' R_d w_d
/// M = -J (k_R e_R + k_w e_w) + w x J w - J (w^ R' R_d w_d - R' R_d w_d')
/// ```
///
/// where R' is a transpose and w_d' a time derivative ([`demanded_force`] has F).
fn geometric(frame: &Frame, gains: &Gains, measured: &Body, force: f64, reference: &Reference) -> Wrench {
    let [f, f1, f2] = demanded_force(frame, gains, measured, force, reference);
    let rotation = measured.rotation().to_rotation_matrix();
    let r: &Matrix3<f64> = rotation.matrix();
    let up: Vector3<f64> = r.column(2).into();
    let w = measured.rates;
    let thrust = frame.mass * f.dot(&up);
    // A demanded force near zero has no meaningful direction, so the vehicle keeps its attitude.
    let small = f.norm() < 0.05 * frame.gravity;
    let b3 = if small { [up, Vector3::zeros(), Vector3::zeros()] } else { direction([f, f1, f2]) };
    let (rd, wd, wd1) = frame_of(b3, reference.yaw);
    let turn = r.transpose() * rd;
    let vee = |m: &Matrix3<f64>| Vector3::new(m[(2, 1)], m[(0, 2)], m[(1, 0)]);
    let e_r = vee(&(turn.transpose() - turn)) * 0.5;
    let e_w = w - turn * wd;
    let k_r = Vector3::new(gains.attitude, gains.attitude, gains.yaw);
    let k_w = Vector3::new(gains.attitude_rate, gains.attitude_rate, gains.yaw_rate);
    let ahead = turn * wd1 - w.cross(&(turn * wd));
    let wanted = ahead - k_r.component_mul(&e_r) - k_w.component_mul(&e_w);
    let momentum = frame.inertia.component_mul(&w);
    let torque = frame.inertia.component_mul(&wanted) + w.cross(&momentum);
    Wrench::new(thrust, torque.x, torque.y, torque.z)
}

/// The state of a body that follows a reference exactly, with the attitude and rates that the geometric controller
/// demands. Flights start in it.
pub fn start(frame: &Frame, reference: &Reference) -> Body {
    let f = reference.acceleration + Vector3::z() * frame.gravity;
    let small = f.norm() < 0.05 * frame.gravity;
    let b3 = match small {
        true => [Vector3::z(), Vector3::zeros(), Vector3::zeros()],
        false => direction([f, reference.jerk, reference.snap]),
    };
    let (rd, wd, _) = frame_of(b3, reference.yaw);
    let attitude = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rd)).into_inner();
    Body { position: reference.position, velocity: reference.velocity, attitude, rates: wd }
}

/// v/|v| and its first two time derivatives, from v and its first two.
pub(super) fn direction([v, v1, v2]: [Vector3<f64>; 3]) -> [Vector3<f64>; 3] {
    let n = v.norm();
    let u = v / n;
    let n1 = u.dot(&v1);
    let u1 = (v1 - u * n1) / n;
    let n2 = u1.dot(&v1) + u.dot(&v2);
    let u2 = (v2 - u * n2 - u1 * (2.0 * n1)) / n;
    [u, u1, u2]
}

/// The frame R_d with third axis b3 and first axis along psi seen from above, as for the ZYX angles of (4), and its
/// body rates w_d with their time derivative w_d'. b3 and psi are given with their first two time derivatives.
///
/// ```text
/// R_d w_d^ = R_d'     R_d (w_d'^ + w_d^ w_d^) = R_d''     where primes are time derivatives
/// ```
fn frame_of(b3: [Vector3<f64>; 3], [psi, rate, acceleration]: [f64; 3]) -> (Matrix3<f64>, Vector3<f64>, Vector3<f64>) {
    let (s, c) = psi.sin_cos();
    let heading = Vector3::new(c, s, 0.0);
    let left = Vector3::new(-s, c, 0.0);
    let c2 = [left, -heading * rate, -heading * acceleration - left * (rate * rate)];
    let product = |a: &[Vector3<f64>; 3], b: &[Vector3<f64>; 3]| {
        [
            a[0].cross(&b[0]),
            a[1].cross(&b[0]) + a[0].cross(&b[1]),
            a[2].cross(&b[0]) + a[1].cross(&b[1]) * 2.0 + a[0].cross(&b[2]),
        ]
    };
    let ahead = product(&c2, &b3);
    // The thrust points to the left or right of psi, so the nose is not determined; any direction across the thrust
    // will do.
    let b1 = match ahead[0].norm() < 1e-6 {
        true => [heading, Vector3::zeros(), Vector3::zeros()],
        false => direction(ahead),
    };
    let b2 = product(&b3, &b1);
    let matrix = |k: usize| Matrix3::from_columns(&[b1[k], b2[k], b3[k]]);
    let rd = matrix(0);
    let vee =
        |m: &Matrix3<f64>| Vector3::new(m[(2, 1)] - m[(1, 2)], m[(0, 2)] - m[(2, 0)], m[(1, 0)] - m[(0, 1)]) * 0.5;
    let wd = vee(&(rd.transpose() * matrix(1)));
    // The symmetric part w_d^ w_d^ cancels in the difference.
    let wd1 = vee(&(rd.transpose() * matrix(2)));
    (rd, wd, wd1)
}
