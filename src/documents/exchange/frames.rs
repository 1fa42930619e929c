//! The two pairs of frames in which the field writes trajectories, and the map between them.
//!
//! mavc's world is x east, y north, z up (ENU) and its body x forward, y left, z up (FLU). PX4 and ArduPilot have a
//! world north, east, down (NED) and a body forward, right, down (FRD). With
//!
//! ```text
//!     | 0 1  0 |            | 1  0  0 |
//! M = | 1 0  0 |        B = | 0 -1  0 |
//!     | 0 0 -1 |            | 0  0 -1 |
//! ```
//!
//! which are their own inverses, vectors of the world turn into `M v`, vectors of the body into `B w`, and the attitude
//! R from body to world into `M R B`. A yaw psi, counter-clockwise from east, turns into `pi/2 - psi`, clockwise from
//! north.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use std::f64::consts::{FRAC_PI_2, PI};

/// A world frame with the body frame that goes with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// World x east, y north, z up; body x forward, y left, z up.
    #[default]
    EnuFlu,
    /// World x north, y east, z down; body x forward, y right, z down.
    NedFrd,
}

impl Frame {
    /// A vector of mavc's world in this world.
    pub fn world(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Frame::EnuFlu => [x, y, z],
            Frame::NedFrd => [y, x, -z],
        }
    }

    /// A vector of mavc's body in this body.
    pub fn body(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Frame::EnuFlu => [x, y, z],
            Frame::NedFrd => [x, -y, -z],
        }
    }

    /// A yaw (rad), which is not wrapped.
    pub fn yaw(self, yaw: f64) -> f64 {
        match self {
            Frame::EnuFlu => yaw,
            Frame::NedFrd => FRAC_PI_2 - yaw,
        }
    }

    /// A derivative of the yaw.
    pub fn yaw_rate(self, rate: f64) -> f64 {
        match self {
            Frame::EnuFlu => rate,
            Frame::NedFrd => -rate,
        }
    }

    /// An attitude from body to world as a quaternion w, x, y, z with w >= 0.
    pub fn quaternion(self, attitude: &Matrix3<f64>) -> [f64; 4] {
        let turned = match self {
            Frame::EnuFlu => *attitude,
            Frame::NedFrd => {
                let world = Matrix3::new(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0);
                world * attitude * Matrix3::from_diagonal(&[1.0, -1.0, -1.0].into())
            }
        };
        let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turned)).into_inner();
        let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
        [q.w, q.i, q.j, q.k].map(|part| sign * part)
    }
}

/// An angle (rad) between -pi and pi.
pub fn wrapped(angle: f64) -> f64 {
    let turned = angle - 2.0 * PI * (angle / (2.0 * PI)).round();
    turned.clamp(-PI, PI)
}
