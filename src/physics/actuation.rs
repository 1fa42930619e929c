//! The actuation matrix A of (1) and (10) to (13): `wrench = A Omega_s`, where Omega_s holds the squared rotor speeds
//! (`docs/method/sets.md`).

use crate::model::{FaultMode, Spin, Vehicle};
use nalgebra::{Matrix4xX, Vector4};
use std::fmt;

/// A wrench [T, tau_x, tau_y, tau_z] in N, N m, N m, N m, in the body frame.
pub type Wrench = Vector4<f64>;

/// The matrix A (4 x n) and the bounds `min_square[k] <= w_k^2 <= max_square[k]` on the squared speeds of the n rotors.
#[derive(Debug, Clone, PartialEq)]
pub struct Actuation {
    /// The matrix A: rows T (N s^2) and tau_x, tau_y, tau_z (N m s^2), one column for each rotor.
    pub effectiveness: Matrix4xX<f64>,
    /// w_min |w_min| of each rotor, rad^2/s^2; 0 for rotors that may stop, below 0 for those that may reverse.
    pub min_square: Vec<f64>,
    /// w_max^2 of each rotor, rad^2/s^2.
    pub max_square: Vec<f64>,
}

/// w |w|: the square of a speed with its sign, to which thrust and drag torque are proportional.
pub fn signed_square(speed: f64) -> f64 {
    speed * speed.abs()
}

/// The inverse of [`signed_square`].
pub fn signed_root(square: f64) -> f64 {
    if square < 0.0 { -(-square).sqrt() } else { square.sqrt() }
}

impl Actuation {
    /// The matrix and the bounds of a vehicle.
    ///
    /// Equation (13), rotor by rotor: a rotor at (x, y) with thrust F = b w^2 gives T = F, tau_x = y F, tau_y = -x F
    /// and tau_z = -d w^2 for spin P, +d w^2 for spin N.
    pub fn of(vehicle: &Vehicle) -> Self {
        let columns: Vec<Vector4<f64>> = vehicle
            .rotors
            .iter()
            .map(|r| {
                let [x, y, _] = r.position;
                let (b, d) = (r.thrust_coefficient, r.drag_coefficient);
                let drag = match r.spin {
                    Spin::P => -d,
                    Spin::N => d,
                };
                Vector4::new(b, b * y, -b * x, drag)
            })
            .collect();
        Actuation {
            effectiveness: Matrix4xX::from_columns(&columns),
            min_square: vehicle.rotors.iter().map(|r| signed_square(r.min_speed)).collect(),
            max_square: vehicle.rotors.iter().map(|r| r.max_speed * r.max_speed).collect(),
        }
    }

    /// The number of rotors n.
    pub fn rotors(&self) -> usize {
        self.max_square.len()
    }

    /// The wrench of rotor k (counted from 0) at full thrust, N and N m.
    ///
    /// # Panics
    /// If there is no rotor k.
    pub fn full(&self, k: usize) -> Wrench {
        self.effectiveness.column(k) * self.max_square[k]
    }

    /// The wrench of rotor k (counted from 0) at its lowest speed, N and N m; zero for a rotor that may stop.
    ///
    /// # Panics
    /// If there is no rotor k.
    pub fn idle(&self, k: usize) -> Wrench {
        self.effectiveness.column(k) * self.min_square[k]
    }

    /// Offset and generators of the healthy vehicle's zonotope: the wrench with every rotor at its lowest speed, and
    /// for each rotor the difference between full thrust and lowest speed. N and N m.
    pub fn healthy(&self) -> (Wrench, Vec<Wrench>) {
        let rotors = 0..self.rotors();
        (rotors.clone().map(|k| self.idle(k)).sum(), rotors.map(|k| self.full(k) - self.idle(k)).collect())
    }

    /// Offset and generators of the zonotope of a fault mode, like [`Actuation::healthy`]: both contributions of rotor
    /// k are multiplied by its capacity theta_k of (32), so that a lost rotor gives nothing even if it may not stop.
    /// The generator of a stuck rotor is zero, and its constant wrench is part of the offset.
    ///
    /// # Panics
    /// If the mode has fewer entries than the vehicle has rotors.
    pub fn under(&self, mode: &FaultMode) -> (Wrench, Vec<Wrench>) {
        let mut shift = Wrench::zeros();
        let generators = (0..self.rotors())
            .map(|k| match mode.rotors[k].stuck_at() {
                Some(share) => {
                    shift += self.full(k) * share;
                    Wrench::zeros()
                }
                None => {
                    let capacity = mode.rotors[k].capacity();
                    shift += self.idle(k) * capacity;
                    (self.full(k) - self.idle(k)) * capacity
                }
            })
            .collect();
        (shift, generators)
    }
}

impl fmt::Display for Actuation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in ["T", "tau_x", "tau_y", "tau_z"].iter().enumerate() {
            write!(f, "{name:<6}")?;
            for k in 0..self.rotors() {
                // The cosine of a right angle is 1e-17 in floating point; it is printed as 0.
                let v = self.effectiveness[(i, k)];
                let size = self.effectiveness.column(k).amax();
                let v = if v.abs() < 1e-14 * size { 0.0 } else { v };
                write!(f, " {v:>13.6e}")?;
            }
            writeln!(f)?;
        }
        let mut speeds = vec![("w_max ", &self.max_square)];
        if self.min_square.iter().any(|s| *s != 0.0) {
            speeds.insert(0, ("w_min ", &self.min_square));
        }
        for (name, squares) in speeds {
            write!(f, "{name}")?;
            for s in squares {
                write!(f, " {:>13.6}", signed_root(*s))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
