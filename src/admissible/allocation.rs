//! Which rotor gives what: the bounded allocation of a wrench with the smallest sum of squared thrusts.

use crate::actuation::{Actuation, Wrench};
use crate::model::Vehicle;
use nalgebra::Matrix4;

/// Allocates wrenches to the rotors of a healthy vehicle.
#[derive(Debug, Clone)]
pub struct Allocator {
    /// Wrench per newton of each rotor, rows scaled by `scale`.
    columns: Vec<Wrench>,
    scale: Wrench,
    max_thrust: Vec<f64>,
    coefficient: Vec<f64>,
}

/// Newton steps after which the best point is returned.
const MOST_STEPS: usize = 200;

impl Allocator {
    pub fn new(vehicle: &Vehicle) -> Self {
        let actuation = Actuation::of(vehicle);
        let full: Vec<Wrench> = (0..actuation.rotors()).map(|k| actuation.full(k)).collect();
        let extent = full.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
        let scale = extent.map(|e| if e > 1e-12 * extent.max() { 1.0 / e } else { 0.0 });
        let max_thrust: Vec<f64> = vehicle.rotors.iter().map(|r| r.max_thrust()).collect();
        let columns = full.iter().zip(&max_thrust).map(|(g, t)| g.component_mul(&scale) / *t).collect();
        let coefficient = vehicle.rotors.iter().map(|r| r.thrust_coefficient).collect();
        Allocator { columns, scale, max_thrust, coefficient }
    }

    /// Thrusts F (N) that minimise sum F_k^2 subject to B F = w, 0 <= F_k <= F_max.
    ///
    /// The dual is concave and piecewise quadratic in four multipliers: F_k = clip(B_k . lambda), and lambda is
    /// found by Newton's method with a line search. For a wrench that no rotor speeds give, the thrusts come as
    /// near as the last step did.
    pub fn thrusts(&self, wrench: &Wrench) -> Vec<f64> {
        let w = wrench.component_mul(&self.scale);
        let mut lambda = Wrench::zeros();
        let mut best = (f64::INFINITY, self.clipped(&lambda));
        for _ in 0..MOST_STEPS {
            let thrusts = self.clipped(&lambda);
            let missing = w - self.produced(&thrusts);
            let error = missing.norm();
            if error < best.0 {
                best = (error, thrusts);
            }
            if error <= 1e-13 {
                break;
            }
            let mut hessian = Matrix4::identity() * 1e-12;
            for (k, c) in self.columns.iter().enumerate() {
                let f = c.dot(&lambda);
                if f >= 0.0 && f <= self.max_thrust[k] {
                    hessian += c * c.transpose();
                }
            }
            let Some(step) = hessian.cholesky().map(|c| c.solve(&missing)) else { break };
            // The dual rises along the step; halve until it does so enough.
            let (value, slope) = (self.dual(&lambda, &w), missing.dot(&step));
            let mut length = 1.0;
            while length > 1e-10 && self.dual(&(lambda + step * length), &w) < value + 1e-4 * length * slope {
                length *= 0.5;
            }
            if length <= 1e-10 {
                break;
            }
            lambda += step * length;
        }
        best.1
    }

    /// Rotor speeds, rad/s: w_k = sqrt(F_k / b_k).
    pub fn speeds(&self, wrench: &Wrench) -> Vec<f64> {
        self.thrusts(wrench).iter().zip(&self.coefficient).map(|(f, b)| (f / b).sqrt()).collect()
    }

    fn clipped(&self, lambda: &Wrench) -> Vec<f64> {
        self.columns.iter().zip(&self.max_thrust).map(|(c, &most)| c.dot(lambda).clamp(0.0, most)).collect()
    }

    fn produced(&self, thrusts: &[f64]) -> Wrench {
        self.columns.iter().zip(thrusts).fold(Wrench::zeros(), |sum, (c, f)| sum + c * *f)
    }

    /// lambda . w + sum_k min over F_k of (F_k^2 / 2 - B_k . lambda F_k).
    fn dual(&self, lambda: &Wrench, w: &Wrench) -> f64 {
        let parts = self.columns.iter().zip(self.clipped(lambda)).map(|(c, f)| f * (0.5 * f - c.dot(lambda)));
        lambda.dot(w) + parts.sum::<f64>()
    }
}
