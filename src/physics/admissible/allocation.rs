//! Bounded allocation: the rotor thrusts that produce a wrench with the smallest sum of squares
//! (`docs/method/verdicts.md`, "Allocation").

use crate::actuation::{Actuation, Wrench, signed_root};
use crate::model::{Rotor, Vehicle};
use nalgebra::Matrix4;

/// The largest number of rotors of a vehicle.
pub const MOST_ROTORS: usize = 32;

/// Newton steps after which the current point is returned.
const MOST_STEPS: usize = 60;

/// Weight on the missing part of a wrench relative to the squared shares of thrust; large enough to leave nothing
/// missing.
const EXACT: f64 = 1e12;

/// Allocates wrenches to the rotors of a healthy vehicle.
#[derive(Debug, Clone)]
pub struct Allocator {
    /// Wrench of each rotor at the full thrust of the strongest rotor, components multiplied by `scale`.
    columns: Vec<Wrench>,
    scale: Wrench,
    /// Lowest and full thrust of each rotor as shares of `strongest`.
    least: Vec<f64>,
    most: Vec<f64>,
    /// Full thrust of the strongest rotor, N.
    strongest: f64,
    /// Thrust coefficient b_k of each rotor, N s^2.
    coefficient: Vec<f64>,
}

impl Allocator {
    /// An allocator for the healthy vehicle.
    pub fn new(vehicle: &Vehicle) -> Self {
        let actuation = Actuation::of(vehicle);
        let full: Vec<Wrench> = (0..actuation.rotors()).map(|k| actuation.full(k)).collect();
        let extent = full.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
        let scale = extent.map(|e| if e > 1e-12 * extent.max() { 1.0 / e } else { 0.0 });
        let strongest = vehicle.rotors.iter().map(Rotor::max_thrust).fold(0.0, f64::max);
        let most: Vec<f64> = vehicle.rotors.iter().map(|r| r.max_thrust() / strongest).collect();
        let least = vehicle.rotors.iter().map(|r| r.idle_thrust() / strongest).collect();
        let columns = full.iter().zip(&most).map(|(g, most)| g.component_mul(&scale) / *most).collect();
        let coefficient = vehicle.rotors.iter().map(|r| r.thrust_coefficient).collect();
        Allocator { columns, scale, least, most, strongest, coefficient }
    }

    /// The rotor thrusts F (N, one for each rotor) that minimise `sum F_k^2` subject to `B F = w`, `F_min <= F <=
    /// F_max`, by [`bounded`] with a weight that leaves nothing of w missing. For a wrench outside the admissible set
    /// they minimise the missing part, each component as a share of its largest value.
    pub fn thrusts(&self, wrench: &Wrench) -> Vec<f64> {
        let w = wrench.component_mul(&self.scale);
        let bounds = Bounds { least: &self.least, most: &self.most };
        let lambda = bounded(&self.columns, bounds, &w, &Wrench::repeat(EXACT), Wrench::zeros());
        self.columns.iter().enumerate().map(|(k, b)| bounds.clip(k, b.dot(&lambda)) * self.strongest).collect()
    }

    /// The rotor speeds `w_k = sqrt(F_k / b_k)`, rad/s, below 0 for a negative thrust, for the thrusts of
    /// [`Allocator::thrusts`].
    pub fn speeds(&self, wrench: &Wrench) -> Vec<f64> {
        self.thrusts(wrench).iter().zip(&self.coefficient).map(|(f, b)| signed_root(f / b)).collect()
    }
}

/// The bounds `least[k] <= x_k <= most[k]` on the shares of thrust.
#[derive(Debug, Clone, Copy)]
pub struct Bounds<'a> {
    /// Lower bound of each rotor.
    pub least: &'a [f64],
    /// Upper bound of each rotor.
    pub most: &'a [f64],
}

impl Bounds<'_> {
    /// `x` clipped to the bounds of rotor k.
    pub fn clip(&self, k: usize, x: f64) -> f64 {
        x.clamp(self.least[k], self.most[k])
    }
}

/// The multipliers lambda of the bounded weighted least-squares problem
///
/// ```text
/// minimise  (1/2) sum_k x_k^2 + (1/2) sum_i weights_i (w - B x)_i^2   over  least_k <= x_k <= most_k
/// ```
///
/// where the columns of B (4 x n) are `columns`. The solution is `x_k = clip(b_k . lambda, least_k, most_k)`.
///
/// At the optimum `lambda_i = weights_i (w - B x)_i`, so lambda solves `lambda_i/weights_i + (B clip(B' lambda))_i =
/// w_i`. The left side is piecewise linear and monotone: it is the gradient of a strictly convex function of four
/// variables. Newton's method with an exact line search takes a step or two if `start` is near the solution.
///
/// # Panics
/// If there are more than [`MOST_ROTORS`] columns, or fewer bounds than columns.
pub fn bounded(columns: &[Wrench], bounds: Bounds, w: &Wrench, weights: &Wrench, start: Wrench) -> Wrench {
    let softness = weights.map(|q| 1.0 / q);
    let mut lambda = start;
    for _ in 0..MOST_STEPS {
        let mut gradient = lambda.component_mul(&softness) - w;
        let mut hessian = Matrix4::from_diagonal(&softness);
        for (k, b) in columns.iter().enumerate() {
            let share = b.dot(&lambda);
            gradient += b * bounds.clip(k, share);
            if (bounds.least[k]..=bounds.most[k]).contains(&share) {
                hessian += b * b.transpose();
            }
        }
        // The gradient is zero to rounding.
        if gradient.amax() <= 1e-12 + 1e-15 * lambda.amax() {
            break;
        }
        let Some(step) = hessian.cholesky().map(|c| -c.solve(&gradient)) else { break };
        let next = lambda + step * lowest(columns, bounds, w, &softness, &lambda, &step);
        if next == lambda || !next.iter().all(|l| l.is_finite()) {
            break;
        }
        lambda = next;
    }
    lambda
}

/// The exact line search of [`bounded`]: the length, as a multiple of `step`, at which the convex function is smallest
/// along `step` from `lambda`. Its slope is increasing and piecewise linear, with a kink wherever a share reaches a
/// bound.
fn lowest(columns: &[Wrench], bounds: Bounds, w: &Wrench, softness: &Wrench, lambda: &Wrench, step: &Wrench) -> f64 {
    let n = columns.len();
    let (mut shares, mut changes) = ([0.0; MOST_ROTORS], [0.0; MOST_ROTORS]);
    let mut kinks = [0.0; 2 * MOST_ROTORS];
    let mut count = 0;
    for (k, b) in columns.iter().enumerate() {
        (shares[k], changes[k]) = (b.dot(lambda), b.dot(step));
        for bound in [bounds.least[k], bounds.most[k]] {
            let t = (bound - shares[k]) / changes[k];
            if t > 0.0 && t.is_finite() {
                kinks[count] = t;
                count += 1;
            }
        }
    }
    // Without a kink the function is quadratic along the step, and the full Newton step ends at its minimum.
    if kinks[..count].iter().all(|t| *t >= 1.0) {
        return 1.0;
    }
    let linear = (lambda.component_mul(softness) - w).dot(step);
    let square = step.component_mul(softness).dot(step);
    let slope = |t: f64| {
        let rotors = shares[..n].iter().zip(&changes[..n]).enumerate();
        linear + square * t + rotors.map(|(k, (s, c))| c * bounds.clip(k, s + c * t)).sum::<f64>()
    };
    let kinks = &mut kinks[..count];
    kinks.sort_unstable_by(f64::total_cmp);
    let falling = kinks.partition_point(|t| slope(*t) < 0.0);
    let low = if falling > 0 { kinks[falling - 1] } else { 0.0 };
    let high = kinks.get(falling).copied().unwrap_or(low + 1.0);
    let (at_low, at_high) = (slope(low), slope(high));
    if at_high > at_low { (low - at_low * (high - low) / (at_high - at_low)).max(0.0) } else { low }
}
