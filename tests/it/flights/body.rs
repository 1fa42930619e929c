//! The rigid body: what mechanics conserves, and an end state by another integrator in another language.

use super::{moving, turned};
use mavc::actuation::Wrench;
use mavc::flight::body::{Body, Frame};
use nalgebra::{Matrix3, Vector3};

const FRAME: Frame = Frame {
    mass: 1.3,
    inertia: Vector3::new(0.021, 0.034, 0.052),
    gravity: 9.81,
    drag: Vector3::new(0.0, 0.0, 0.0),
    yaw_drag: None,
};

/// `duration` s under a constant wrench in steps of `h`.
fn flown(mut body: Body, frame: &Frame, wrench: Wrench, air: Vector3<f64>, duration: f64, h: f64) -> Body {
    for _ in 0..(duration / h).round() as usize {
        body.step(frame, h, [&wrench; 3], &air);
    }
    body
}

fn freely(body: Body, frame: &Frame, duration: f64, h: f64) -> Body {
    flown(body, frame, Wrench::zeros(), Vector3::zeros(), duration, h)
}

/// R of (4), from the quaternion's entries.
fn rotation(body: &Body) -> Matrix3<f64> {
    let (w, [x, y, z]) = (body.attitude.w, body.attitude.imag().into());
    Matrix3::new(
        w * w + x * x - y * y - z * z,
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        w * w - x * x + y * y - z * z,
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        w * w - x * x - y * y + z * z,
    )
}

/// R J omega, in the world.
fn spin(body: &Body) -> Vector3<f64> {
    rotation(body) * FRAME.inertia.component_mul(&body.rates)
}

fn turning_energy(body: &Body) -> f64 {
    0.5 * body.rates.dot(&FRAME.inertia.component_mul(&body.rates))
}

#[test]
fn free_turning_keeps_energy_and_angular_momentum() {
    let mut start = moving();
    // About the middle axis, where turning is unstable: all axes change places.
    start.rates = Vector3::new(0.5, 25.0, -0.8);
    let drift = |h: f64| {
        let end = freely(start, &FRAME, 2.0, h);
        assert!((end.rates - start.rates).norm() > 1.0, "the body does not tumble");
        let momentum = (spin(&end) - spin(&start)).norm() / spin(&start).norm();
        (momentum, (turning_energy(&end) / turning_energy(&start) - 1.0).abs())
    };
    let (coarse, middle, fine) = (drift(4e-3), drift(2e-3), drift(1e-3));
    assert!(fine.0 < 1e-6 && fine.1 < 1e-6, "{fine:?}");
    for (a, b) in [(coarse, middle), (middle, fine)] {
        assert!((a.0 / b.0).log2() > 3.7, "momentum drifts by {} and {}", a.0, b.0);
        assert!((a.1 / b.1).log2() > 3.7, "energy drifts by {} and {}", a.1, b.1);
    }
}

#[test]
fn free_fall_is_a_parabola_whatever_the_body_turns() {
    let mut start = moving();
    start.rates *= 10.0;
    for gravity in [0.0, 9.81] {
        let frame = Frame { gravity, ..FRAME };
        let end = freely(start, &frame, 3.0, 1e-3);
        let g = Vector3::new(0.0, 0.0, -gravity);
        let place = start.position + start.velocity * 3.0 + g * 4.5;
        assert!((end.position - place).norm() < 1e-11, "{}", end.position - place);
        let momentum = (end.velocity - start.velocity - g * 3.0) * frame.mass;
        assert!(momentum.norm() < 1e-11, "{momentum}");
        let energy = |b: &Body| 0.5 * b.velocity.norm_squared() + gravity * b.position.z;
        assert!((energy(&end) - energy(&start)).abs() < 1e-9);
    }
}

#[test]
fn steady_turn_about_a_principal_axis_turns_at_its_rate() {
    for axis in 0..3 {
        let mut start = Body::at_rest(Vector3::zeros(), 0.0);
        start.rates[axis] = 3.0;
        let end = freely(start, &FRAME, 1.0, 1e-3);
        let wanted = nalgebra::Rotation3::new(start.rates);
        assert!((rotation(&end) - wanted.matrix()).norm() < 1e-11, "axis {axis}");
    }
}

/// A torque about one axis from rest: the rate grows as it should and about that axis alone.
#[test]
fn torque_about_an_axis_turns_about_it() {
    for axis in 0..3 {
        let mut wrench = Wrench::zeros();
        wrench[axis + 1] = 0.01;
        let start = Body::at_rest(Vector3::zeros(), 0.4);
        let end = flown(start, &FRAME, wrench, Vector3::zeros(), 1.0, 1e-3);
        let mut rates = Vector3::zeros();
        rates[axis] = 0.01 / FRAME.inertia[axis];
        assert!((end.rates - rates).norm() < 1e-12, "axis {axis}: {}", end.rates);
        // Yaw counts counter-clockwise seen from above, roll to the right, pitch down at the nose.
        assert!((end.angles()[axis] - [0.0, 0.0, 0.4][axis] - 0.5 * rates[axis]).abs() < 1e-9, "{:?}", end.angles());
    }
}

#[test]
fn angles_and_up_are_those_of_the_rotation() {
    let body = moving();
    for (found, wanted) in body.angles().iter().zip([0.3, -0.2, 0.7]) {
        assert!((found - wanted).abs() < 1e-14);
    }
    let r = rotation(&body);
    assert!((body.up() - r.column(2)).norm() < 1e-15);
    assert!((body.rotation().to_rotation_matrix().matrix() - r).norm() < 1e-14);
    assert!((body.tilt() - (0.3f64.cos() * 0.2f64.cos()).acos()).abs() < 1e-14);
    let over = Body { attitude: turned(3.0, 0.0, 1.0), ..body };
    assert!((over.tilt() - 3.0).abs() < 1e-14);
}

/// Numbers of benches/oracles/rigid_body.py.
#[test]
fn constant_wrench_leads_where_dop853_leads() {
    let frame = Frame { drag: Vector3::repeat(0.25), ..FRAME };
    let wrench = Wrench::new(14.0, 0.012, -0.02, 0.009);
    let end = flown(moving(), &frame, wrench, Vector3::new(1.5, -0.7, 0.3), 2.0, 1e-3);
    let near = |name: &str, found: Vector3<f64>, wanted: [f64; 3]| {
        let error = (found - Vector3::from(wanted)).amax();
        assert!(error < 1e-8, "{name}: {error:e} from {wanted:?}");
    };
    near("position", end.position, [9.522179678554, -2.959960231995, -1.080134053411]);
    near("velocity", end.velocity, [6.301160767641, -3.289248645614, -1.824387649499]);
    near("rates", end.rates, [-1.086007972488, 0.549908159114, 2.326664558511]);
    let r = rotation(&end);
    near("row 1", r.row(0).transpose(), [0.776307913132, 0.488817630042, 0.397999181618]);
    near("row 2", r.row(1).transpose(), [-0.268667861621, 0.827751438127, -0.492590232151]);
    near("row 3", r.row(2).transpose(), [-0.570231184819, 0.275472106098, 0.773919578911]);
}
