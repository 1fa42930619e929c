//! Estimation of rotor capacities by regularised recursive least squares on the body's angular motion, (32) to (42).
//! The formulas are in `docs/flight.md`, section 4.
//!
//! The paper's (40) has three equations a sample for n capacities, so at constant speeds most directions are not
//! observable. Plain recursive least squares with a forgetting factor drifts along these directions until the vehicle
//! falls. Therefore
//!
//! - the estimate minimises, over capacities from 0 to 1, the exponentially weighted squares of the torque residuals,
//!   plus a small penalty on the distance from the last estimate, which bounds the covariance, plus a small price on
//!   losses, so that of two explanations the one with less loss is chosen;
//! - a sample is used only if its residual or the mean of the last ones exceeds the noise, or soon after such a sample,
//!   so that the estimate does not move in quiet hover. A large residual after a quiet period signals a change, and
//!   older samples are forgotten.

use crate::actuation::Actuation;
use crate::geometry::symmetric::eigenvalues;
use crate::model::Model;
use nalgebra::Vector3;

/// The error of the model as a share of the torque of one rotor in hover. It is added to the torque noise because no
/// model is exact.
const MODEL_ERROR: f64 = 0.04;

/// Time constant with which the constant part of the residual is learnt while no sample is used, s: that of a centre of
/// gravity and of thrusts that are not as modelled. It is at most [`MOST_BIAS`] standard deviations, so that a rotor
/// that fades slowly is not learnt away.
const BIAS_LEARNT: f64 = 5.0;
const MOST_BIAS: f64 = 5.0;
/// Time constant with which the variance of the residual is learnt, s, where it exceeds the assumed one: gusts, and
/// sensors that are worse than assumed. It is at most [`MOST_VARIANCE`], that of sensors three times as noisy, so that
/// no fault is learnt away.
const SPREAD_LEARNT: f64 = 10.0;
const MOST_VARIANCE: f64 = 9.0;
/// No sample is used before this time, s: it is the first that is known of constant part and variance.
const STARTUP: f64 = 0.3;

/// The variance of the mean is learnt from deviations of at most so many standard deviations: what exceeds them is a
/// change rather than noise. Chosen by hand; the standard deviation of normal noise is then learnt 5 % too small.
const OUTLIER: f64 = 2.0;

/// Number of samples of the mean of the residuals. A rotor that loses less than single samples show, or loses it slowly
/// because the vehicle hardly uses it, shifts this mean. Chosen by hand, as the least standard deviation of the mean
/// that is assumed.
const MEAN_OF: f64 = 20.0;
pub(super) const LEAST_SHIFT: f64 = 0.35;

/// Number of samples that are used from one with a large residual on.
const FOLLOWING: usize = 20;

/// Weight of the distance from the last estimate, and price of a loss. Residuals are in standard deviations of the
/// noise.
const PULL: f64 = 1.0;
const PRICE: f64 = 2.0;

/// Largest number of sweeps over the capacities for one sample.
const SWEEPS: usize = 30;

/// Regularised recursive least squares for theta of (32), in information form, for n rotors.
#[derive(Debug, Clone)]
pub struct Estimator {
    /// Rows 2 to 4 of A: the torque of each rotor per squared speed, N m s^2.
    columns: Vec<Vector3<f64>>,
    inertia: Vector3<f64>,
    forgetting: f64,
    /// Time between samples, s.
    period: f64,
    /// Standard deviation of a torque sample, N m on each axis.
    noise: Vector3<f64>,
    /// A residual beyond this many standard deviations is large.
    threshold: f64,
    /// The constant part of the residual, and the variance of the rest, at least 1, in standard deviations of the
    /// noise.
    bias: Vector3<f64>,
    variance: Vector3<f64>,
    /// The exponentially weighted mean of the residuals, and its variance about the constant part as far as it exceeds
    /// that of [`LEAST_SHIFT`], in standard deviations of the noise.
    mean: Vector3<f64>,
    mean_variance: Vector3<f64>,
    /// Samples from which they were learnt.
    learnt: usize,
    /// Exponentially weighted sums of Psi' W Psi (n x n, row-major) and Psi' W tau (n).
    information: Vec<f64>,
    evidence: Vec<f64>,
    /// The estimated capacity theta of each rotor, 0 to 1.
    pub capacity: Vec<f64>,
    /// How many more samples are used without a large residual.
    updates_left: usize,
    last_rates: Option<Vector3<f64>>,
    /// Sums of squared modelled speeds and of the gyroscopic torque since the last sample, and the number of terms.
    squares: Vec<f64>,
    gyroscopic: Vector3<f64>,
    count: usize,
    /// The values at the last call of [`Estimator::note`].
    last_squares: Vec<f64>,
    last_gyroscopic: Vector3<f64>,
    has_noted: bool,
    /// The columns of the regressor Psi of the last sample, in standard deviations of the noise.
    regressor: Vec<Vector3<f64>>,
    /// Scratch space for a matrix (n x n).
    spectrum: Vec<f64>,
}

/// The standard deviation of a torque sample on each axis, N m: gyroscope noise and model error. `gyroscope_noise` is
/// in rad/s, `period` in s.
pub(super) fn torque_noise(model: &Model, gyroscope_noise: f64, period: f64) -> Vector3<f64> {
    // Two rate samples make one torque sample.
    let measured = Vector3::from(model.vehicle.inertia) * (gyroscope_noise * std::f64::consts::SQRT_2 / period);
    let actuation = Actuation::of(&model.vehicle);
    let hover = model.vehicle.mass * model.gravity / actuation.rotors() as f64;
    let modelled = Vector3::from_fn(|axis, _| {
        let rotors = actuation.effectiveness.column_iter().zip(&model.vehicle.rotors);
        let per_thrust = rotors.map(|(c, r)| c[axis + 1].abs() / r.thrust_coefficient).fold(0.0, f64::max);
        MODEL_ERROR * per_thrust * hover
    });
    measured.zip_map(&modelled, f64::hypot).map(|s| s.max(1e-12))
}

impl Estimator {
    /// An estimator that starts with all capacities at 1. `forgetting` is the factor lambda, `threshold` that of large
    /// residuals in standard deviations, `gyroscope_noise` the standard deviation of a rate sample (rad/s), and
    /// `period` the time between samples (s).
    pub fn new(model: &Model, forgetting: f64, threshold: f64, gyroscope_noise: f64, period: f64) -> Self {
        let actuation = Actuation::of(&model.vehicle);
        let n = actuation.rotors();
        let columns: Vec<Vector3<f64>> =
            actuation.effectiveness.column_iter().map(|c| c.fixed_rows::<3>(1).into_owned()).collect();
        let inertia = Vector3::from(model.vehicle.inertia);
        Estimator {
            inertia,
            forgetting,
            period,
            noise: torque_noise(model, gyroscope_noise, period),
            threshold,
            bias: Vector3::zeros(),
            variance: Vector3::repeat(1.0),
            mean: Vector3::zeros(),
            mean_variance: Vector3::zeros(),
            learnt: 0,
            information: vec![0.0; n * n],
            evidence: vec![0.0; n],
            capacity: vec![1.0; n],
            updates_left: 0,
            last_rates: None,
            squares: vec![0.0; n],
            gyroscopic: Vector3::zeros(),
            count: 0,
            last_squares: vec![0.0; n],
            last_gyroscopic: Vector3::zeros(),
            has_noted: false,
            regressor: vec![Vector3::zeros(); n],
            spectrum: vec![0.0; n * n],
            columns,
        }
    }

    /// Records the modelled rotor speeds (rad/s) and the measured body rates (rad/s). To be called at equal intervals.
    pub fn note(&mut self, speeds: &[f64], rates: &Vector3<f64>) {
        let gyroscopic = rates.cross(&self.inertia.component_mul(rates));
        // The integrals over the interval use the trapezium rule. If speeds change fast, a rectangle rule is off by
        // more than the noise.
        if self.has_noted {
            for ((sum, last), w) in self.squares.iter_mut().zip(&mut self.last_squares).zip(speeds) {
                let square = w * w.abs();
                *sum += 0.5 * (*last + square);
                *last = square;
            }
            self.gyroscopic += (self.last_gyroscopic + gyroscopic) * 0.5;
            self.count += 1;
        } else {
            self.last_squares.iter_mut().zip(speeds).for_each(|(last, w)| *last = w * w.abs());
            self.has_noted = true;
        }
        self.last_gyroscopic = gyroscopic;
    }

    /// Replaces the speeds (rad/s) of the last [`Estimator::note`], because they jump at the start of a flight.
    pub(super) fn settle(&mut self, speeds: &[f64]) {
        self.last_squares.iter_mut().zip(speeds).for_each(|(last, w)| *last = w * w.abs());
    }

    /// Processes a sample: what was recorded since the last call, with the body rates measured now (rad/s). Returns
    /// whether the estimate was updated.
    ///
    /// By (37) the mean torque over the interval is `J (w - w_last)/period` plus the mean of `w x J w`. The regressor
    /// of (36) uses the mean squares of the modelled speeds.
    pub fn sample(&mut self, rates: &Vector3<f64>) -> bool {
        let count = self.count.max(1) as f64;
        let gyroscopic = self.gyroscopic / count;
        for (k, sum) in self.squares.iter_mut().enumerate() {
            self.regressor[k] = (self.columns[k] * (*sum / count)).component_div(&self.noise);
            *sum = 0.0;
        }
        self.gyroscopic = Vector3::zeros();
        self.count = 0;
        let Some(last) = self.last_rates.replace(*rates) else { return false };
        let torque = self.inertia.component_mul(&((rates - last) / self.period)) + gyroscopic;
        let torque = torque.component_div(&self.noise);
        let predicted = self.regressor.iter().zip(&self.capacity).fold(Vector3::zeros(), |sum, (p, c)| sum + p * *c);
        let residual = torque - predicted;
        let scale = self.variance.map(|v| v.max(1.0).sqrt());
        // A residual that no constant part explains is a fault, also at the start.
        let is_starting = (self.learnt as f64) * self.period < STARTUP;
        if is_starting && self.updates_left == 0 && residual.amax() <= self.threshold + MOST_BIAS {
            self.learn(&residual);
            return false;
        }
        self.mean += (residual - self.mean) / MEAN_OF;
        let of_mean = self.mean_variance.map(|v| v.max(LEAST_SHIFT * LEAST_SHIFT).sqrt());
        let single = (residual - self.bias).component_div(&scale).amax();
        let lasting = (self.mean - self.bias).component_div(&of_mean).amax();
        if single.max(lasting) > self.threshold {
            if self.updates_left == 0 {
                // A large residual after a quiet period signals a change, so older samples may no longer be valid.
                self.information.fill(0.0);
                self.evidence.fill(0.0);
            }
            self.updates_left = FOLLOWING;
        }
        if self.updates_left == 0 {
            self.learn(&residual);
            return false;
        }
        self.updates_left -= 1;
        self.regressor.iter_mut().for_each(|p| *p = p.component_div(&scale));
        self.update(&(torque - self.bias).component_div(&scale));
        true
    }

    /// Learns the constant part of the residuals and their variance about it, from the residual of a sample in quiet
    /// flight.
    fn learn(&mut self, residual: &Vector3<f64>) {
        self.learnt += 1;
        let rate = |seconds: f64, before: usize| (1.0 / (self.learnt + before) as f64).max(self.period / seconds);
        let (of_bias, of_variance) = (rate(BIAS_LEARNT, 0), rate(SPREAD_LEARNT, FOLLOWING));
        self.bias += (residual - self.bias) * of_bias;
        self.bias = self.bias.map(|b| b.clamp(-MOST_BIAS, MOST_BIAS));
        let squares = (residual - self.bias).map(|e| e * e);
        self.variance += (squares - self.variance) * of_variance;
        self.variance = self.variance.map(|v| v.min(MOST_VARIANCE));
        let most = self.mean_variance.map(|v| OUTLIER * OUTLIER * v.max(LEAST_SHIFT * LEAST_SHIFT));
        let shifts = (self.mean - self.bias).zip_map(&most, |e, most| (e * e).min(most));
        self.mean_variance += (shifts - self.mean_variance) * of_variance;
    }

    /// Minimises `sum lambda^age |tau - Psi theta|^2 + PULL |theta - theta_last|^2 + PRICE sum (1 - theta_k)` over
    /// `0 <= theta <= 1`, by coordinate descent.
    fn update(&mut self, torque: &Vector3<f64>) {
        let n = self.capacity.len();
        for k in 0..n {
            let p = self.regressor[k];
            for l in 0..n {
                let entry = &mut self.information[k * n + l];
                *entry = self.forgetting * *entry + p.dot(&self.regressor[l]);
            }
            self.evidence[k] = self.forgetting * self.evidence[k] + p.dot(torque);
        }
        let mut last = [0.0; 32];
        last[..n].copy_from_slice(&self.capacity);
        for _ in 0..SWEEPS {
            let mut moved: f64 = 0.0;
            for k in 0..n {
                let row = &self.information[k * n..(k + 1) * n];
                let others: f64 = row.iter().zip(&self.capacity).map(|(a, c)| a * c).sum::<f64>();
                let slope = others - self.evidence[k] + PULL * (self.capacity[k] - last[k]) - 0.5 * PRICE;
                let next = (self.capacity[k] - slope / (row[k] + PULL)).clamp(0.0, 1.0);
                moved = moved.max((next - self.capacity[k]).abs());
                self.capacity[k] = next;
            }
            if moved < 1e-6 {
                break;
            }
        }
    }

    /// Rank and condition number of the regressor. While samples are used this is the exponentially weighted regressor,
    /// otherwise that of the last sample. Singular values at or below 1e-3 of the largest do not count; the condition
    /// number is the ratio of the largest to the smallest that counts. `None` before the first sample.
    pub fn conditioning(&mut self) -> Option<(usize, f64)> {
        let n = self.capacity.len();
        match self.updates_left > 0 {
            true => self.spectrum.copy_from_slice(&self.information),
            false => (0..n * n).for_each(|i| self.spectrum[i] = self.regressor[i / n].dot(&self.regressor[i % n])),
        }
        let mut singular = [0.0; 32];
        let singular = &mut singular[..n];
        eigenvalues(&mut self.spectrum, singular);
        singular.iter_mut().for_each(|s| *s = s.max(0.0).sqrt());
        singular.sort_unstable_by(|a, b| b.total_cmp(a));
        let kept = singular.iter().filter(|s| **s > 1e-3 * singular[0]).count();
        (kept > 0).then(|| (kept, singular[0] / singular[kept - 1]))
    }
}
