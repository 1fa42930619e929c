//! The rigid body of (3) to (9), on a quaternion: no angle of it is singular.

use crate::actuation::Wrench;
use crate::model::Model;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// What stays the same during a flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// kg
    pub mass: f64,
    /// Diagonal of J, kg m^2.
    pub inertia: Vector3<f64>,
    /// m/s^2
    pub gravity: f64,
    /// Linear drag, N s/m.
    pub drag: f64,
}

impl Frame {
    pub fn of(model: &Model) -> Self {
        Frame {
            mass: model.vehicle.mass,
            inertia: model.vehicle.inertia.into(),
            gravity: model.gravity,
            drag: model.simulation.drag,
        }
    }
}

/// The state of the body, or its derivative with respect to time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// p_W, m, world frame, z up.
    pub position: Vector3<f64>,
    /// v_W, m/s, world frame.
    pub velocity: Vector3<f64>,
    /// q_WB, from the body to the world; of unit length but for what one step's rounding adds.
    pub attitude: Quaternion<f64>,
    /// [P, Q, R], rad/s, body frame.
    pub rates: Vector3<f64>,
}

impl Body {
    /// Level at a place, at rest.
    pub fn at_rest(position: Vector3<f64>, yaw: f64) -> Self {
        let attitude = UnitQuaternion::from_euler_angles(0.0, 0.0, yaw).into_inner();
        Body { position, velocity: Vector3::zeros(), attitude, rates: Vector3::zeros() }
    }

    pub fn rotation(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(self.attitude)
    }

    /// R e_3: where body z points in the world.
    pub fn up(&self) -> Vector3<f64> {
        let (w, v) = (self.attitude.w, self.attitude.imag());
        Vector3::new(2.0 * (v.x * v.z + w * v.y), 2.0 * (v.y * v.z - w * v.x), 1.0 - 2.0 * (v.x * v.x + v.y * v.y))
    }

    /// ZYX angles phi, theta, psi of (4), rad.
    pub fn angles(&self) -> [f64; 3] {
        let (roll, pitch, yaw) = self.rotation().euler_angles();
        [roll, pitch, yaw]
    }

    /// Heading: the direction of the nose (body x) seen from above, psi of (4), rad; counter-clockwise from x, within half a
    /// turn of zero. A nose that points straight up or down has none; the number then means nothing.
    pub fn heading(&self) -> f64 {
        let (w, v) = (self.attitude.w, self.attitude.imag());
        (2.0 * (w * v.z + v.x * v.y)).atan2(1.0 - 2.0 * (v.y * v.y + v.z * v.z))
    }

    /// Angle between body z and the vertical, rad.
    pub fn tilt(&self) -> f64 {
        let up = self.up();
        up.x.hypot(up.y).atan2(up.z)
    }

    /// With v = R v_B of (3), (7) and (8) read in the world frame
    ///
    /// p' = v, v' = (T/m) R e_3 - g e_3 - (drag/m) (v - v_air),
    /// q' = q (0, omega)/2, which is (5) and (6) without their singular angle,
    /// omega' = J^-1 (tau - omega x J omega), (9).
    pub fn derivative(&self, frame: &Frame, wrench: &Wrench, air: &Vector3<f64>) -> Body {
        let Frame { mass, inertia, gravity, drag } = *frame;
        let mut acceleration = self.up() * (wrench[0] / mass) - (self.velocity - air) * (drag / mass);
        acceleration.z -= gravity;
        let spin = Quaternion::from_parts(0.0, 0.5 * self.rates);
        let torque = Vector3::new(wrench[1], wrench[2], wrench[3]);
        let momentum = inertia.component_mul(&self.rates);
        Body {
            position: self.velocity,
            velocity: acceleration,
            attitude: self.attitude * spin,
            rates: (torque - self.rates.cross(&momentum)).component_div(&inertia),
        }
    }

    /// The state and `h` times a derivative.
    fn along(&self, slope: &Body, h: f64) -> Body {
        Body {
            position: self.position + slope.position * h,
            velocity: self.velocity + slope.velocity * h,
            attitude: self.attitude + slope.attitude * h,
            rates: self.rates + slope.rates * h,
        }
    }

    /// One step of the classical Runge-Kutta method of fourth order, `h` s long, with the wrenches at its start,
    /// middle and end. The quaternion is brought back to unit length afterwards.
    pub fn step(&mut self, frame: &Frame, h: f64, [start, middle, end]: [&Wrench; 3], air: &Vector3<f64>) {
        let k1 = self.derivative(frame, start, air);
        let k2 = self.along(&k1, 0.5 * h).derivative(frame, middle, air);
        let k3 = self.along(&k2, 0.5 * h).derivative(frame, middle, air);
        let k4 = self.along(&k3, h).derivative(frame, end, air);
        let sixth = h / 6.0;
        self.position += (k1.position + (k2.position + k3.position) * 2.0 + k4.position) * sixth;
        self.velocity += (k1.velocity + (k2.velocity + k3.velocity) * 2.0 + k4.velocity) * sixth;
        self.attitude += (k1.attitude + (k2.attitude + k3.attitude) * 2.0 + k4.attitude) * sixth;
        self.rates += (k1.rates + (k2.rates + k3.rates) * 2.0 + k4.rates) * sixth;
        self.attitude /= self.attitude.norm();
    }

    pub fn is_finite(&self) -> bool {
        let parts = [&self.position, &self.velocity, &self.rates];
        parts.iter().all(|v| v.iter().all(|x| x.is_finite())) && self.attitude.coords.iter().all(|x| x.is_finite())
    }
}
