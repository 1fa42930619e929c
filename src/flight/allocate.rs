//! From a wanted wrench to rotor speeds, by (42) or by bounded weighted least squares, with the capacities that the
//! controller believes in.

use crate::actuation::{Actuation, Wrench};
use crate::model::{Allocation, Model};
use nalgebra::{Matrix4, Matrix4xX};

/// Weights on the missing part of the wrench beside one on the rotors' shares of full thrust, for T, tau_x, tau_y,
/// tau_z in shares of the largest each can be. Yaw is given up first, thrust next, roll and pitch last.
const WEIGHTS: [f64; 4] = [1e6, 1e8, 1e8, 1e4];

/// Newton steps after which the point reached is taken.
const MOST_STEPS: usize = 60;

/// Directions of the wrench that the rotors give more weakly than this, against the strongest, are given up by (42).
const WEAK: f64 = 1e-6;

/// What the controller believes of each rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    /// theta of (32).
    pub capacity: Vec<f64>,
    /// Share of full thrust at which a rotor is stuck.
    pub stuck: Vec<Option<f64>>,
}

impl Belief {
    pub fn healthy(rotors: usize) -> Self {
        Belief { capacity: vec![1.0; rotors], stuck: vec![None; rotors] }
    }
}

/// Allocates wrenches; nothing here allocates memory once it is made.
#[derive(Debug, Clone)]
pub struct Allocator {
    method: Allocation,
    /// Wrench at full thrust over `extent`, healthy; one a rotor.
    full: Vec<Wrench>,
    /// The same under the belief; zero for stuck rotors.
    columns: Vec<Wrench>,
    /// What the stuck rotors give, over `extent`.
    shift: Wrench,
    /// Sum of the rotors' absolute wrenches: N, N m, N m, N m.
    extent: Wrench,
    max_speed: Vec<f64>,
    /// Pseudo-inverse of `columns`, n x 4 as its rows.
    inverse: Vec<Wrench>,
    /// Multipliers of the last wrench: near those of the next.
    lambda: Wrench,
}

impl Allocator {
    pub fn new(model: &Model, method: Allocation) -> Self {
        let actuation = Actuation::of(&model.vehicle);
        let full: Vec<Wrench> = (0..actuation.rotors()).map(|k| actuation.full(k)).collect();
        let extent = full.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
        let extent = extent.map(|e| if e > 1e-12 * extent.max() { e } else { 1.0 });
        let full: Vec<Wrench> = full.iter().map(|g| g.component_div(&extent)).collect();
        let n = full.len();
        let mut allocator = Allocator {
            method,
            columns: full.clone(),
            full,
            shift: Wrench::zeros(),
            extent,
            max_speed: model.vehicle.rotors.iter().map(|r| r.max_speed).collect(),
            inverse: vec![Wrench::zeros(); n],
            lambda: Wrench::zeros(),
        };
        allocator.believe(&Belief::healthy(n));
        allocator
    }

    /// Reconfigures: B = A diag(theta) of (41), and its pseudo-inverse where that is in use.
    pub fn believe(&mut self, belief: &Belief) {
        self.shift = Wrench::zeros();
        for k in 0..self.full.len() {
            self.columns[k] = match belief.stuck[k] {
                Some(share) => {
                    self.shift += self.full[k] * share;
                    Wrench::zeros()
                }
                None => self.full[k] * belief.capacity[k],
            };
        }
        if self.method == Allocation::PseudoInverse {
            let b = Matrix4xX::from_columns(&self.columns);
            let largest = b.norm();
            // (42) where B B^T can be inverted; where rotors are gone that gave a direction alone, without it.
            let inverse = b.clone().pseudo_inverse(WEAK * largest).unwrap_or_else(|_| b.transpose() * 0.0);
            inverse.row_iter().zip(&mut self.inverse).for_each(|(row, r)| *r = row.transpose());
        }
        self.lambda = Wrench::zeros();
    }

    /// Speeds (rad/s) into `speeds` for a wrench. A rotor believed lost gets none, a stuck one what it has.
    pub fn speeds(&mut self, wrench: &Wrench, speeds: &mut [f64]) {
        let wanted = wrench.component_div(&self.extent) - self.shift;
        if self.method == Allocation::Bounded {
            self.lambda = bounded(&self.columns, &wanted, &WEIGHTS.into(), self.lambda);
        }
        let rows = if self.method == Allocation::Bounded { &self.columns } else { &self.inverse };
        let by = if self.method == Allocation::Bounded { &self.lambda } else { &wanted };
        for (k, speed) in speeds.iter_mut().enumerate() {
            *speed = self.max_speed[k] * rows[k].dot(by).clamp(0.0, 1.0).sqrt();
        }
    }

    /// How much of a wrench's thrust, roll and pitch (in shares of the largest each can be) cannot be given under a
    /// belief by rotors within their bounds; yaw is left free.
    pub fn missing(&self, wrench: &Wrench, belief: &Belief) -> f64 {
        let mut wanted = wrench.component_div(&self.extent);
        let mut columns = [Wrench::zeros(); 32];
        for (k, full) in self.full.iter().enumerate() {
            match belief.stuck[k] {
                Some(share) => wanted -= full * share,
                None => columns[k] = full * belief.capacity[k],
            }
        }
        let columns = &columns[..self.full.len()];
        let weights = Wrench::new(1e6, 1e6, 1e6, 1e-3);
        let lambda = bounded(columns, &wanted, &weights, Wrench::zeros());
        let given = columns.iter().fold(Wrench::zeros(), |sum, b| sum + b * b.dot(&lambda).clamp(0.0, 1.0));
        (wanted - given).fixed_rows::<3>(0).norm()
    }
}

/// Multipliers lambda of the shares x_k = clip(b_k . lambda, 0, 1) that minimise
///
/// (1/2) sum x_k^2 + (1/2) sum_i weight_i (w - B x)_i^2 over 0 <= x <= 1.
///
/// With the residual r = w - B x the optimum has lambda = weight r, so lambda solves
/// lambda/weight + B clip(B^T lambda) = w: piecewise linear, monotone, the gradient of a strictly convex function of
/// four variables. Newton's method with a line search ends after a step or two from a lambda nearby.
pub fn bounded(columns: &[Wrench], w: &Wrench, weights: &Wrench, start: Wrench) -> Wrench {
    let softness = weights.map(|q| 1.0 / q);
    // The value, its gradient, and the columns of the rotors that are free.
    let look = |lambda: &Wrench| {
        let soft = lambda.component_mul(&softness);
        let (mut value, mut gradient) = (0.5 * lambda.dot(&soft) - lambda.dot(w), soft - w);
        for b in columns {
            let share = b.dot(lambda);
            let x = share.clamp(0.0, 1.0);
            value += x * (share - 0.5 * x);
            gradient += b * x;
        }
        (value, gradient)
    };
    let mut lambda = start;
    let (mut value, mut gradient) = look(&lambda);
    for _ in 0..MOST_STEPS {
        if gradient.amax() <= 1e-12 {
            break;
        }
        let mut hessian = Matrix4::from_diagonal(&softness);
        for b in columns {
            let share = b.dot(&lambda);
            if (0.0..=1.0).contains(&share) {
                hessian += b * b.transpose();
            }
        }
        let Some(step) = hessian.cholesky().map(|c| -c.solve(&gradient)) else { break };
        let slope = gradient.dot(&step);
        let mut length = 1.0;
        let taken = loop {
            let next = lambda + step * length;
            let (v, g) = look(&next);
            // Where rounding hides the value's fall, that of the gradient counts.
            if v <= value + 1e-4 * length * slope || g.amax() < 0.5 * gradient.amax() {
                break Some((next, v, g));
            }
            length *= 0.5;
            if length < 1e-12 {
                break None;
            }
        };
        let Some(next) = taken else { break };
        (lambda, value, gradient) = next;
    }
    lambda
}
