//! The rigid body of (3) to (9) with the attitude as a quaternion, which has no singular angle (`docs/flight.md`,
//! section 1).

use crate::actuation::Wrench;
use crate::model::{Model, Vehicle, YawDrag};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The constants of the rigid body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Mass, kg.
    pub mass: f64,
    /// Diagonal of the inertia J, kg m^2.
    pub inertia: Vector3<f64>,
    /// Gravity, m/s^2.
    pub gravity: f64,
    /// Linear drag along the axes of the body, N s/m.
    pub drag: Vector3<f64>,
    /// Drag about z; `None` if the spec gives none.
    pub yaw_drag: Option<YawDrag>,
}

impl Frame {
    /// The constants of a model, with the drag of its `simulate` block.
    pub fn of(model: &Model) -> Self {
        Frame::of_vehicle(&model.vehicle, model)
    }

    /// The constants of another vehicle in the world of a model, with the drag of its `simulate` block if that differs
    /// from the drag of the model's own vehicle.
    pub fn of_vehicle(vehicle: &Vehicle, model: &Model) -> Self {
        Frame {
            mass: vehicle.mass,
            inertia: vehicle.inertia.into(),
            gravity: model.gravity,
            yaw_drag: vehicle.yaw_drag,
            drag: match model.simulation.drag == model.vehicle.drag {
                true => vehicle.drag.into(),
                false => model.simulation.drag.into(),
            },
        }
    }
}

/// The state of the body, or its derivative with respect to time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Position p, m, world frame, z up.
    pub position: Vector3<f64>,
    /// Velocity v, m/s, world frame.
    pub velocity: Vector3<f64>,
    /// Attitude q from body to world; a unit quaternion up to rounding.
    pub attitude: Quaternion<f64>,
    /// Body rates [P, Q, R], rad/s, body frame.
    pub rates: Vector3<f64>,
}

impl Body {
    /// Level and at rest at a position (m) with a yaw (rad).
    pub fn at_rest(position: Vector3<f64>, yaw: f64) -> Self {
        let attitude = UnitQuaternion::from_euler_angles(0.0, 0.0, yaw).into_inner();
        Body { position, velocity: Vector3::zeros(), attitude, rates: Vector3::zeros() }
    }

    /// The attitude R as a rotation from body to world.
    pub fn rotation(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(self.attitude)
    }

    /// R e_3, the direction of the body's z axis in the world frame.
    pub fn up(&self) -> Vector3<f64> {
        let (w, v) = (self.attitude.w, self.attitude.imag());
        Vector3::new(2.0 * (v.x * v.z + w * v.y), 2.0 * (v.y * v.z - w * v.x), 1.0 - 2.0 * (v.x * v.x + v.y * v.y))
    }

    /// The ZYX angles [phi, theta, psi] of (4), rad.
    pub fn angles(&self) -> [f64; 3] {
        let (roll, pitch, yaw) = self.rotation().euler_angles();
        [roll, pitch, yaw]
    }

    /// The heading, rad: the direction of the nose (body x) seen from above, which is psi of (4), counter-clockwise
    /// from x, between -pi and pi. It is meaningless if the nose points straight up or down.
    pub fn heading(&self) -> f64 {
        let (w, v) = (self.attitude.w, self.attitude.imag());
        (2.0 * (w * v.z + v.x * v.y)).atan2(1.0 - 2.0 * (v.y * v.y + v.z * v.z))
    }

    /// The angle between the body's z axis and the vertical, rad.
    pub fn tilt(&self) -> f64 {
        let up = self.up();
        up.x.hypot(up.y).atan2(up.z)
    }

    /// The time derivative of the state under a wrench (N and N m, body frame) and a velocity of the air (m/s, world
    /// frame). With v = R v_B:
    ///
    /// ```text
    /// p' = v                                                    (3)
    /// v' = (T/m) R e_3 - g e_3 - R D R^T (v - v_air)/m          (7) and (8) in the world frame
    /// q' = q (0, omega)/2                                       (5) and (6) without their singular angle
    /// omega' = J^-1 (tau - D(r) e_3 - omega x (J omega + h))    (9)
    /// ```
    ///
    /// `momentum` is h, that of the rotors about z (N m s), and D the yaw drag; (9) has neither.
    pub fn derivative(&self, frame: &Frame, wrench: &Wrench, momentum: f64, air: &Vector3<f64>) -> Body {
        let Frame { mass, inertia, gravity, drag, yaw_drag } = *frame;
        let through = self.velocity - air;
        let slowing = match drag.x == drag.y && drag.y == drag.z {
            true => through * (drag.x / mass),
            false => {
                let body = self.rotation();
                body * (body.inverse() * through).component_mul(&(drag / mass))
            }
        };
        let mut acceleration = self.up() * (wrench[0] / mass) - slowing;
        acceleration.z -= gravity;
        let spin = Quaternion::from_parts(0.0, 0.5 * self.rates);
        let mut torque = Vector3::new(wrench[1], wrench[2], wrench[3]);
        if let Some(drag) = yaw_drag {
            torque.z -= drag.torque(self.rates.z);
        }
        let mut angular = inertia.component_mul(&self.rates);
        angular.z += momentum;
        Body {
            position: self.velocity,
            velocity: acceleration,
            attitude: self.attitude * spin,
            rates: (torque - self.rates.cross(&angular)).component_div(&inertia),
        }
    }

    /// What an accelerometer at the centre of gravity reads, m/s^2, body frame: thrust (N) and drag in an air with a
    /// velocity (m/s, world frame).
    pub fn specific_force(&self, frame: &Frame, thrust: f64, air: &Vector3<f64>) -> Vector3<f64> {
        let through = self.rotation().inverse() * (self.velocity - air);
        (Vector3::z() * thrust - through.component_mul(&frame.drag)) / frame.mass
    }

    /// The state plus `h` times a derivative.
    fn along(&self, slope: &Body, h: f64) -> Body {
        Body {
            position: self.position + slope.position * h,
            velocity: self.velocity + slope.velocity * h,
            attitude: self.attitude + slope.attitude * h,
            rates: self.rates + slope.rates * h,
        }
    }

    /// Advances the state by one classical fourth-order Runge-Kutta step of `h` s with the wrenches (N and N m) at its
    /// start, middle and end. The quaternion is normalised afterwards.
    pub fn step(&mut self, frame: &Frame, h: f64, wrenches: [&Wrench; 3], air: &Vector3<f64>) {
        self.step_with(frame, h, wrenches, [0.0; 3], air);
    }

    /// [`Body::step`] with the momenta of the rotors about z (N m s) at the same instants.
    pub fn step_with(&mut self, frame: &Frame, h: f64, wrenches: [&Wrench; 3], momenta: [f64; 3], air: &Vector3<f64>) {
        let slope = |body: &Body, i: usize| body.derivative(frame, wrenches[i], momenta[i], air);
        let k1 = slope(self, 0);
        let k2 = slope(&self.along(&k1, 0.5 * h), 1);
        let k3 = slope(&self.along(&k2, 0.5 * h), 1);
        let k4 = slope(&self.along(&k3, h), 2);
        let sixth = h / 6.0;
        self.position += (k1.position + (k2.position + k3.position) * 2.0 + k4.position) * sixth;
        self.velocity += (k1.velocity + (k2.velocity + k3.velocity) * 2.0 + k4.velocity) * sixth;
        self.attitude += (k1.attitude + (k2.attitude + k3.attitude) * 2.0 + k4.attitude) * sixth;
        self.rates += (k1.rates + (k2.rates + k3.rates) * 2.0 + k4.rates) * sixth;
        self.attitude /= self.attitude.norm();
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let parts = [&self.position, &self.velocity, &self.rates];
        parts.iter().all(|v| v.iter().all(|x| x.is_finite())) && self.attitude.coords.iter().all(|x| x.is_finite())
    }
}
