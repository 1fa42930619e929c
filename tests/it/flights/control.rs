//! Controllers against a second writing of the paper's law, against differential flatness, and in closed loop.

use super::{moving, turned};
use crate::vehicles::octocopter;
use mavc::actuation::Wrench;
use mavc::flatness::{self, FlatState};
use mavc::flight::body::{Body, Frame};
use mavc::flight::control::{control, start};
use mavc::flight::reference::Reference;
use mavc::model::{Controller, Gains};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const G: f64 = 9.81;

fn frame() -> Frame {
    Frame { inertia: Vector3::new(0.03, 0.045, 0.07), ..Frame::of(&octocopter("PPNNPPNN")) }
}

/// All different, so that none can stand for another.
fn gains() -> Gains {
    Gains {
        position: 4.1,
        velocity: 3.3,
        altitude: 6.2,
        climb: 4.4,
        attitude: 97.0,
        attitude_rate: 15.0,
        yaw: 5.1,
        yaw_rate: 3.7,
    }
}

/// The k-th derivative of amplitude sin(w t + phase).
fn wave(amplitude: f64, w: f64, phase: f64, t: f64, k: i32) -> f64 {
    amplitude * w.powi(k) * (w * t + phase + f64::from(k) * std::f64::consts::FRAC_PI_2).sin()
}

/// A curve of Lissajous with a turning nose; tilts to some 40 degrees.
fn lissajous(t: f64) -> Reference {
    let order = |k| Vector3::new(wave(2.0, 1.7, 0.3, t, k), wave(1.5, 2.1, 1.0, t, k), wave(0.8, 1.3, -0.4, t, k));
    Reference {
        position: order(0),
        velocity: order(1),
        acceleration: order(2),
        jerk: order(3),
        snap: order(4),
        yaw: [wave(1.2, 0.9, 0.1, t, 0) + 0.5 * t, wave(1.2, 0.9, 0.1, t, 1) + 0.5, wave(1.2, 0.9, 0.1, t, 2)],
    }
}

/// The attitude that flies along the curve: body z along the thrust, body x along the heading seen from above.
fn flat_attitude(t: f64) -> Matrix3<f64> {
    let r = lissajous(t);
    let b3 = (r.acceleration + Vector3::z() * G).normalize();
    let b1 = Vector3::new(-r.yaw[0].sin(), r.yaw[0].cos(), 0.0).cross(&b3).normalize();
    Matrix3::from_columns(&[b1, b3.cross(&b1), b3])
}

/// A derivative by central differences of eighth order.
fn slope<T: std::ops::Sub<Output = T> + std::ops::Mul<f64, Output = T> + std::iter::Sum>(f: impl Fn(f64) -> T) -> T {
    let h = 4e-3;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let pair = |k: usize| (f((k + 1) as f64 * h) - f(-((k + 1) as f64) * h)) * (weights[k] / h);
    (0..4).map(pair).sum()
}

/// omega with R' = R omega^.
fn flat_rates(t: f64) -> Vector3<f64> {
    let m = flat_attitude(t).transpose() * slope(|s| flat_attitude(t + s));
    Vector3::new(m[(2, 1)], m[(0, 2)], m[(1, 0)])
}

fn flat_state(t: f64) -> Body {
    let r = lissajous(t);
    let rotation = Rotation3::from_matrix_unchecked(flat_attitude(t));
    let attitude = UnitQuaternion::from_rotation_matrix(&rotation).into_inner();
    Body { position: r.position, velocity: r.velocity, attitude, rates: flat_rates(t) }
}

fn flat_force(t: f64) -> f64 {
    (lissajous(t).acceleration + Vector3::z() * G).norm()
}

#[test]
fn on_the_reference_geometric_asks_for_the_flat_wrench() {
    let frame = frame();
    for i in 0..60 {
        let t = 0.17 * f64::from(i);
        let body = flat_state(t);
        let rates = body.rates;
        let torque = frame.inertia.component_mul(&slope(|s| flat_rates(t + s)))
            + rates.cross(&frame.inertia.component_mul(&rates));
        let wanted = Wrench::new(frame.mass * flat_force(t), torque.x, torque.y, torque.z);
        let found = control(Controller::Geometric, &frame, &gains(), &body, flat_force(t), &lissajous(t));
        assert!((found - wanted).amax() < 1e-7, "at {t}: {found} instead of {wanted}");
    }
}

/// The planner's exact model and the controller mean the same attitude by a place and a heading.
#[test]
fn on_the_reference_geometric_asks_for_the_planned_wrench() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let frame = Frame { inertia: vehicle.inertia.into(), mass: vehicle.mass, ..frame() };
    for i in 0..60 {
        let t = 0.17 * f64::from(i);
        let r = lissajous(t);
        let orders = [r.acceleration, r.jerk, r.snap].map(|v| [v.x, v.y, v.z]).concat();
        let state = FlatState::from_iterator(orders.into_iter().chain(r.yaw));
        let planned = flatness::wrench(&vehicle, G, &state);
        let found = control(Controller::Geometric, &frame, &gains(), &start(&frame, &r), flat_force(t), &r);
        assert!((found - planned).amax() < 1e-9, "at {t}: {found} instead of {planned}");
    }
}

#[test]
fn flights_begin_on_the_reference() {
    for i in 0..20 {
        let t = 0.31 * f64::from(i);
        let (found, wanted) = (start(&frame(), &lissajous(t)), flat_state(t));
        assert!((found.position - wanted.position).norm() + (found.velocity - wanted.velocity).norm() < 1e-12);
        assert!(super::angle_between(&found, &wanted) < 1e-7 && (found.rates - wanted.rates).norm() < 1e-8);
    }
}

/// Without motors: the body receives the wrench that the controller demands. Deviation in place (m) and attitude (rad)
/// at each instant, from 0.5 m and 20 degrees off the reference.
fn closed_loop(controller: Controller, gains: &Gains, follow: impl Fn(f64) -> Reference, n: usize) -> Vec<[f64; 2]> {
    let frame = frame();
    let h = 1e-3;
    let mut body = start(&frame, &follow(0.0));
    body.position += Vector3::new(0.3, -0.3, 0.26);
    body.attitude *= turned(0.25, -0.2, 0.14);
    let mut force = (follow(0.0).acceleration + Vector3::z() * G).norm();
    (0..n)
        .map(|i| {
            let reference = follow(i as f64 * h);
            let wanted = start(&frame, &reference);
            let off = [(body.position - reference.position).norm(), super::angle_between(&body, &wanted)];
            let wrench = control(controller, &frame, gains, &body, force, &reference);
            force = wrench[0] / frame.mass;
            body.step(&frame, h, [&wrench; 3], &Vector3::zeros());
            off
        })
        .collect()
}

#[test]
fn geometric_comes_back_exponentially() {
    let off = closed_loop(Controller::Geometric, &Gains::default(), lissajous, 8000);
    assert!(off[0][0] > 0.49 && off[0][1] > 0.33, "{:?}", off[0]);
    for (i, [place, attitude]) in off.iter().enumerate() {
        // The slowest poles are those of s^2 + 3.2 s + 4: -1.6 +- 1.2 i.
        let envelope = (-1.3 * i as f64 * 1e-3).exp();
        assert!(*place < 1.2 * envelope + 2e-3 && *attitude < 2.0 * envelope + 2e-3, "{i}: {place} {attitude}");
    }
    // What is left is that commands hold for a millisecond.
    assert!(off[7999][0] < 2e-3, "{:?}", off[7999]);
}

#[test]
fn pd_comes_back_to_hover() {
    let hover =
        |_: f64| Reference { position: Vector3::new(1.0, 2.0, 3.0), yaw: [2.0, 0.0, 0.0], ..Default::default() };
    let off = closed_loop(Controller::Pd, &Gains::default(), hover, 8000);
    for (i, [place, _]) in off.iter().enumerate() {
        assert!(*place < 1.5 * (-1.3 * i as f64 * 1e-3).exp() + 1e-4, "{i}: {place}");
    }
    assert!(off[7999][0] < 1e-4, "{:?}", off[7999]);
}

/// (21) to (28) written out in scalars, for a body of known angles.
#[test]
fn pd_is_the_paper_s_law() {
    let (frame, k) = (frame(), gains());
    for i in 0..40 {
        let t = 0.21 * f64::from(i);
        let (phi, theta) = (wave(0.4, 1.1, 0.2, t, 0), wave(0.35, 1.9, 0.8, t, 0));
        let r = lissajous(t);
        let psi = r.yaw[0] + wave(0.5, 2.3, 0.0, t, 0);
        let at = moving();
        let body = Body { attitude: turned(phi, theta, psi), position: r.position + at.velocity * 0.2, ..at };
        let (p, q, yaw_rate) = (1.2, -0.8, 2.1);
        let (c, s) = (r.yaw[0].cos(), r.yaw[0].sin());
        let (ex, ey, ez) = (-0.2, -0.4, 0.1);
        let (dx, dy, dz) = (r.velocity.x - 1.0, r.velocity.y - 2.0, r.velocity.z + 0.5);
        // (19): x'' = g (c theta - s (-phi)), y'' = g (s theta + c (-phi)), and once more with (16).
        let (ax, ay) = (G * (c * theta + s * phi), G * (s * theta - c * phi));
        let (jx, jy) = (G * (c * q + s * p), G * (s * q - c * p));
        let (ddx, ddy) = (r.acceleration.x - ax, r.acceleration.y - ay);
        let (dddx, dddy) = (r.jerk.x - jx, r.jerk.y - jy);
        let law = |ahead: f64, rate: f64, value: f64| ahead + k.velocity * rate + k.position * value;
        let (x2, y2) = (law(r.acceleration.x, dx, ex), law(r.acceleration.y, dy, ey));
        let (x3, y3) = (law(r.jerk.x, ddx, dx), law(r.jerk.y, ddy, dy));
        let (x4, y4) = (law(r.snap.x, dddx, ddx), law(r.snap.y, dddy, ddy));
        let roll = |x: f64, y: f64| (s * x - c * y) / G;
        let pitch = |x: f64, y: f64| (c * x + s * y) / G;
        let turn = |ahead: f64, rate: f64, angle: f64| ahead + k.attitude_rate * rate + k.attitude * angle;
        let wanted = Wrench::new(
            1.8 * (G + r.acceleration.z + k.climb * dz + k.altitude * ez),
            0.03 * turn(roll(x4, y4), roll(x3, y3) - p, roll(x2, y2) - phi),
            0.045 * turn(pitch(x4, y4), pitch(x3, y3) - q, pitch(x2, y2) - theta),
            0.07 * (r.yaw[2] + k.yaw_rate * (r.yaw[1] - yaw_rate) + k.yaw * (r.yaw[0] - psi)),
        );
        // The thrust that the rotors give is nothing to this law.
        for force in [0.0, 12.0] {
            let found = control(Controller::Pd, &frame, &k, &body, force, &r);
            assert!((found - wanted).amax() < 1e-10, "at {t}: {found} instead of {wanted}");
        }
    }
}

#[test]
fn yaw_takes_the_shorter_way() {
    let frame = frame();
    for controller in [Controller::Pd, Controller::Geometric] {
        let asked = |measured: f64, wanted: f64| {
            let body = Body::at_rest(Vector3::z(), measured);
            let reference = Reference { position: Vector3::z(), yaw: [wanted, 0.0, 0.0], ..Default::default() };
            control(controller, &frame, &gains(), &body, G, &reference)
        };
        let near = asked(0.0, 0.1);
        assert!(near[3] > 0.0);
        for k in [-3.0, -1.0, 0.0, 1.0, 2.0] {
            assert!((asked(3.1, 3.2 + k * TAU) - near).amax() < 1e-12, "{controller:?} turns {k} times");
            assert!((asked(-3.1, -3.2 + k * TAU) + asked(3.1, 3.2)).fixed_rows::<1>(3).amax() < 1e-12);
        }
    }
}

/// From far off, feedback leans the vehicle by no more than half of g.
#[test]
fn far_from_its_place_the_vehicle_leans_and_does_not_turn_over() {
    let frame = frame();
    for direction in [Vector3::x(), -Vector3::y(), Vector3::new(1.0, 1.0, -1.0).normalize(), -Vector3::z()] {
        let body = Body::at_rest(Vector3::zeros(), 0.0);
        let reference = Reference { position: direction * 50.0, ..Default::default() };
        let found = control(Controller::Geometric, &frame, &gains(), &body, G, &reference);
        // Level, the thrust is the vertical part of the force.
        assert!(found[0] >= 0.5 * 1.8 * G - 1e-9 && found[0] <= 1.5 * 1.8 * G, "{found}");
        let most = (0.5f64).asin().max((0.5f64).atan()) * 97.0 * 0.045;
        assert!(found[1].abs() < most && found[2].abs() < most, "{found}");
    }
}
