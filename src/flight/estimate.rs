//! Which rotors have lost how much: recursive least squares on the body's angular motion, (32) to (42), made safe.
//!
//! The paper's (40) has three equations a sample for n capacities, so at constant speeds most directions are unseen;
//! plain recursive least squares with a forgetting factor drifts along them, and the vehicle falls. Here
//!
//! - the estimate minimises the forgotten squares of the torque residuals plus a small pull towards the last estimate
//!   (which bounds the covariance), plus a small price on every loss (so that of two explanations the one with less
//!   loss is taken), over capacities from 0 to 1;
//! - a sample is taken in only where the torques differ from what the present estimate gives by more than noise
//!   explains, or where the last one was: in quiet hover nothing moves. One that speaks after silence tells of a change,
//!   and older ones are forgotten.

use crate::actuation::Actuation;
use crate::geometry::symmetric::eigenvalues;
use crate::model::Model;
use nalgebra::Vector3;

/// A sample speaks where its residual is this many standard deviations of the torque noise.
pub const SPEAKS: f64 = 4.0;

/// The torque noise is taken to be at least this share of one rotor's mean torque: models are never exact.
const MODEL_ERROR: f64 = 0.04;

/// Samples taken in after the last one that spoke.
const FOLLOWING: usize = 20;

/// Pull towards the last estimate and price of a loss, beside residuals in standard deviations of noise.
const PULL: f64 = 1.0;
const PRICE: f64 = 2.0;

/// Sweeps over the capacities a sample.
const SWEEPS: usize = 30;

/// Recursive least squares for theta in information form.
#[derive(Debug, Clone)]
pub struct Estimator {
    /// Rows 2 to 4 of A: torque per squared speed; one a rotor.
    columns: Vec<Vector3<f64>>,
    inertia: Vector3<f64>,
    forgetting: f64,
    /// Between samples, s.
    period: f64,
    /// Standard deviation of a torque sample, N m on each axis.
    noise: Vector3<f64>,
    /// Forgotten sums of Psi^T W Psi (n x n) and Psi^T W tau (n).
    information: Vec<f64>,
    evidence: Vec<f64>,
    /// theta, 0..1.
    pub capacity: Vec<f64>,
    /// Samples that are still taken in.
    awake: usize,
    last_rates: Option<Vector3<f64>>,
    /// Sums of squared modelled speeds and of the gyroscopic torque since the last sample, and their number.
    squares: Vec<f64>,
    gyroscopic: Vector3<f64>,
    count: usize,
    /// The same as last noted.
    last_squares: Vec<f64>,
    last_gyroscopic: Vector3<f64>,
    has_noted: bool,
    /// The regressor's columns of the last sample, in standard deviations of noise.
    regressor: Vec<Vector3<f64>>,
    /// Room for a matrix (n x n).
    spectrum: Vec<f64>,
}

/// Standard deviation of a torque sample, N m on each axis: of the gyroscope's noise, and of what no model is exact in.
pub fn torque_noise(model: &Model, gyroscope_noise: f64, period: f64) -> Vector3<f64> {
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
    /// `gyroscope_noise` is the standard deviation of a rate sample, rad/s; `period` the time between samples, s.
    pub fn new(model: &Model, forgetting: f64, gyroscope_noise: f64, period: f64) -> Self {
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
            information: vec![0.0; n * n],
            evidence: vec![0.0; n],
            capacity: vec![1.0; n],
            awake: 0,
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

    /// Notes the rotors' modelled speeds (rad/s) and measured body rates (rad/s), at even intervals.
    pub fn note(&mut self, speeds: &[f64], rates: &Vector3<f64>) {
        let gyroscopic = rates.cross(&self.inertia.component_mul(rates));
        // The integrals over the interval by the trapezium rule: where speeds change fast, a sum of one end's values
        // is off by more than noise.
        if self.has_noted {
            for ((sum, last), w) in self.squares.iter_mut().zip(&mut self.last_squares).zip(speeds) {
                let square = w * w;
                *sum += 0.5 * (*last + square);
                *last = square;
            }
            self.gyroscopic += (self.last_gyroscopic + gyroscopic) * 0.5;
            self.count += 1;
        } else {
            self.last_squares.iter_mut().zip(speeds).for_each(|(last, w)| *last = w * w);
            self.has_noted = true;
        }
        self.last_gyroscopic = gyroscopic;
    }

    /// Speeds (rad/s) that hold from the last note on, where they jump as a flight begins.
    pub fn settle(&mut self, speeds: &[f64]) {
        self.last_squares.iter_mut().zip(speeds).for_each(|(last, w)| *last = w * w);
    }

    /// Takes in what was noted since the last call, with the rates measured now. True where the estimate was updated.
    ///
    /// The mean torque of (37) over the interval is J (w - w_last)/period + mean of w x J w, to noise; the regressor
    /// of (36) takes the mean squares of the modelled speeds.
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
        if (torque - predicted).amax() > SPEAKS {
            if self.awake == 0 {
                // Something has changed since the last sample that spoke: what was seen before need not be true now.
                self.information.fill(0.0);
                self.evidence.fill(0.0);
            }
            self.awake = FOLLOWING;
        }
        if self.awake == 0 {
            return false;
        }
        self.awake -= 1;
        self.update(&torque);
        true
    }

    /// Minimises over 0 <= theta <= 1
    /// sum lambda^age |tau - Psi theta|^2 + PULL |theta - theta_last|^2 + PRICE sum (1 - theta)
    /// one capacity after the other until none moves.
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

    /// Rank of the regressor as it stands, and the ratio of the largest singular value to the smallest that counts: of
    /// the forgotten information where samples are taken in, else of the last sample. Singular values below 1e-3 of
    /// the largest do not count.
    /// `None` before the first sample.
    pub fn conditioning(&mut self) -> Option<(usize, f64)> {
        let n = self.capacity.len();
        match self.awake > 0 {
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
