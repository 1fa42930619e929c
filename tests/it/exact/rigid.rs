//! The rigid body once more, as the paper writes it: (3), (5) to (9) in Euler angles and body velocities. And the
//! attitude and wrench of a motion from its geometry, with derivatives by differences.

use mavc::actuation::Wrench;
use mavc::model::Vehicle;
use nalgebra::{Matrix3, SVector, Vector3};

/// Position, body velocity, (phi, theta, psi), (P, Q, R).
pub type Rigid = SVector<f64, 12>;

/// R of (4): Rz(psi) Ry(theta) Rx(phi).
pub fn rotation(angles: Vector3<f64>) -> Matrix3<f64> {
    let [(sf, cf), (st, ct), (sp, cp)] = [angles.x, angles.y, angles.z].map(f64::sin_cos);
    Matrix3::new(cp, -sp, 0.0, sp, cp, 0.0, 0.0, 0.0, 1.0)
        * Matrix3::new(ct, 0.0, st, 0.0, 1.0, 0.0, -st, 0.0, ct)
        * Matrix3::new(1.0, 0.0, 0.0, 0.0, cf, -sf, 0.0, sf, cf)
}

/// The derivative of the state under a wrench.
fn derivative(vehicle: &Vehicle, gravity: f64, state: &Rigid, wrench: &Wrench) -> Rigid {
    let part = |i: usize| Vector3::new(state[3 * i], state[3 * i + 1], state[3 * i + 2]);
    let (v, angles, w) = (part(1), part(2), part(3));
    let r = rotation(angles);
    let thrust = Vector3::new(0.0, 0.0, wrench[0] / vehicle.mass);
    let velocity = thrust - r.transpose() * Vector3::new(0.0, 0.0, gravity) - w.cross(&v);
    let ((sf, cf), (tan, cos)) = (angles.x.sin_cos(), (angles.y.tan(), angles.y.cos()));
    let turn = w.y * sf + w.z * cf;
    let rates = Vector3::new(w.x + turn * tan, w.y * cf - w.z * sf, turn / cos);
    let [ixx, iyy, izz] = vehicle.inertia;
    let spin = Vector3::new(
        (wrench[1] + (iyy - izz) * w.y * w.z) / ixx,
        (wrench[2] + (izz - ixx) * w.z * w.x) / iyy,
        (wrench[3] + (ixx - iyy) * w.x * w.y) / izz,
    );
    let mut out = Rigid::zeros();
    for (i, value) in [r * v, velocity, rates, spin].into_iter().enumerate() {
        out.fixed_rows_mut::<3>(3 * i).copy_from(&value);
    }
    out
}

/// One step of Kutta's 3/8 rule: of fourth order, and another one than the simulator's. The wrench at a time within the
/// step.
pub fn step(vehicle: &Vehicle, gravity: f64, state: &Rigid, h: f64, wrench: &dyn Fn(f64) -> Wrench) -> Rigid {
    let slope = |s: Rigid, t: f64| derivative(vehicle, gravity, &s, &wrench(t));
    let k1 = slope(*state, 0.0);
    let k2 = slope(state + k1 * (h / 3.0), h / 3.0);
    let k3 = slope(state + (k2 - k1 / 3.0) * h, 2.0 * h / 3.0);
    let k4 = slope(state + (k1 - k2 + k3) * h, h);
    state + (k1 + (k2 + k3) * 3.0 + k4) * (h / 8.0)
}

/// The attitude that points body z along a thrust and keeps body x in the vertical plane of psi, as (4) does.
pub fn attitude(thrust: Vector3<f64>, psi: f64) -> Matrix3<f64> {
    let z = thrust.normalize();
    let x = Vector3::new(-psi.sin(), psi.cos(), 0.0).cross(&z).normalize();
    Matrix3::from_columns(&[x, z.cross(&x), z])
}

/// f' by differences of fourth order.
pub fn slope<T>(f: impl Fn(f64) -> T, h: f64) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    (f(h) - f(-h)) * (8.0 / (12.0 * h)) + (f(-2.0 * h) - f(2.0 * h)) * (1.0 / (12.0 * h))
}

/// Body rates at `t` of an attitude that changes: R' = R (w x).
pub fn rates(attitude: &dyn Fn(f64) -> Matrix3<f64>, t: f64, h: f64) -> Vector3<f64> {
    let turning = attitude(t).transpose() * slope(|s| attitude(t + s), h);
    Vector3::new(
        turning[(2, 1)] - turning[(1, 2)],
        turning[(0, 2)] - turning[(2, 0)],
        turning[(1, 0)] - turning[(0, 1)],
    ) * 0.5
}

/// What thrust and torque turn a body as `attitude` and `thrust` (per unit of mass) do.
pub fn wrench(vehicle: &Vehicle, attitude: &dyn Fn(f64) -> Matrix3<f64>, thrust: Vector3<f64>, h: f64) -> Wrench {
    let inertia = Vector3::from(vehicle.inertia);
    let w = rates(attitude, 0.0, h);
    let spin = slope(|s| rates(attitude, s, h), h);
    let torque = inertia.component_mul(&spin) + w.cross(&inertia.component_mul(&w));
    Wrench::new(vehicle.mass * thrust.norm(), torque.x, torque.y, torque.z)
}
