//! The estimator on data of known capacities, and in flight.

use super::{between, normal, quiet, seen, sortie, staying, strike};
use crate::vehicles::{lost, octocopter};
use mavc::actuation::Actuation;
use mavc::flight::estimate::Estimator;
use mavc::model::{Detection, Model};
use nalgebra::Vector3;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;

/// s between samples, and notes in between.
const PERIOD: f64 = 0.01;
const NOTES: usize = 5;

/// Angular motion in which each sample holds exactly: squared speeds and gyroscopic torques go linearly to their next
/// values until the first note of an interval and stay, and the rates at its end follow from Euler's equation. Speeds
/// are random about hover; of some the one that slows the body is taken.
struct Motion {
    columns: Vec<Vector3<f64>>,
    inertia: Vector3<f64>,
    truth: Vec<f64>,
    rates: Vector3<f64>,
    last_rates: Vector3<f64>,
    last_speeds: Vec<f64>,
    random: Pcg64Mcg,
}

impl Motion {
    fn new(model: &Model, truth: &[f64], seed: u64) -> Self {
        let a = Actuation::of(&model.vehicle).effectiveness;
        Motion {
            columns: a.column_iter().map(|c| Vector3::new(c[1], c[2], c[3])).collect(),
            inertia: model.vehicle.inertia.into(),
            truth: truth.to_vec(),
            rates: Vector3::zeros(),
            last_rates: Vector3::zeros(),
            last_speeds: vec![0.0; truth.len()],
            random: Pcg64Mcg::seed_from_u64(seed),
        }
    }

    fn draw(&mut self) -> (Vec<f64>, Vector3<f64>) {
        let speeds: Vec<f64> = (0..self.truth.len()).map(|_| between(&mut self.random, 250.0, 750.0)).collect();
        let torque = |speeds: &[f64]| {
            let given = self.columns.iter().zip(&self.truth).zip(speeds);
            given.fold(Vector3::zeros(), |sum, ((c, theta), w)| sum + c * (theta * w * w))
        };
        let gyroscopic = |rates: &Vector3<f64>| rates.cross(&self.inertia.component_mul(rates));
        let now = torque(&speeds) - gyroscopic(&self.rates);
        let before = torque(&self.last_speeds) - gyroscopic(&self.last_rates);
        // The share of an interval before its first note, half of it the old value's.
        let share = 0.5 / NOTES as f64;
        let mean = now * (1.0 - share) + before * share;
        let next = self.rates + mean.component_div(&self.inertia) * PERIOD;
        (speeds, next)
    }

    /// One sample into the estimator, with noise of `sigma` rad/s on every rate.
    fn sample(&mut self, estimator: &mut Estimator, sigma: f64) {
        let draws: Vec<_> = (0..6).map(|_| self.draw()).collect();
        let calm = |d: &&(Vec<f64>, Vector3<f64>)| d.1.norm();
        let (speeds, next) = draws.iter().min_by(|a, b| calm(a).total_cmp(&calm(b))).unwrap();
        for note in 0..NOTES {
            let noise = Vector3::from_fn(|_, _| sigma * normal(&mut self.random));
            let last = note == NOTES - 1;
            estimator.note(speeds, &(self.rates + noise));
            if last {
                self.last_rates = self.rates;
                self.last_speeds.clone_from(speeds);
                self.rates = *next;
                let noise = Vector3::from_fn(|_, _| sigma * normal(&mut self.random));
                estimator.sample(&(self.rates + noise));
            }
        }
    }
}

const TRUTHS: [[f64; 8]; 4] = [
    [1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
    [1.0, 1.0, 1.0, 0.6, 1.0, 1.0, 0.3, 1.0],
    [0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0],
    [0.9, 0.8, 1.0, 0.7, 0.5, 1.0, 0.85, 0.95],
];

/// A motion and its estimator, which has seen half a second of it before the capacities changed.
fn after_healthy_motion(model: &Model, truth: &[f64], seed: u64, forgetting: f64, sigma: f64) -> (Motion, Estimator) {
    let mut motion = Motion::new(model, &vec![1.0; truth.len()], seed);
    let mut estimator = Estimator::new(model, forgetting, 4.0, sigma, PERIOD);
    (0..50).for_each(|_| motion.sample(&mut estimator, sigma));
    motion.truth = truth.to_vec();
    (motion, estimator)
}

#[test]
fn exciting_motion_without_noise_shows_every_capacity() {
    let model = octocopter("PPNNPPNN");
    for (seed, truth) in TRUTHS.iter().enumerate() {
        let (mut motion, mut estimator) = after_healthy_motion(&model, truth, seed as u64, 0.95, 0.0);
        let mut highest = 0;
        for _ in 0..300 {
            motion.sample(&mut estimator, 0.0);
            highest = highest.max(estimator.conditioning().unwrap().0);
        }
        for (found, wanted) in estimator.capacity.iter().zip(truth) {
            assert!((found - wanted).abs() < 0.02, "{:?} instead of {truth:?}", estimator.capacity);
        }
        assert_eq!(highest, 8);
    }
}

#[test]
fn noise_blurs_capacities_and_hides_none() {
    let model = octocopter("PPNNPPNN");
    let sigma = 0.005;
    for (seed, truth) in TRUTHS.iter().enumerate() {
        // A long memory: the yaw torque of a rotor is lost in one sample's noise.
        let (mut motion, mut estimator) = after_healthy_motion(&model, truth, seed as u64, 0.99, sigma);
        (0..2000).for_each(|_| motion.sample(&mut estimator, sigma));
        for (found, wanted) in estimator.capacity.iter().zip(truth) {
            assert!((found - wanted).abs() < 0.1, "{:?} instead of {truth:?}", estimator.capacity);
        }
    }
}

/// Old samples are forgotten, so that sums stay bounded: a long record contains no more information than 1/(1 - lambda)
/// samples, and the estimate can still turn round when the truth does.
#[test]
fn what_was_seen_is_forgotten() {
    let model = octocopter("PPNNPPNN");
    let mut motion = Motion::new(&model, &TRUTHS[0], 1);
    let mut estimator = Estimator::new(&model, 0.95, 4.0, 0.0, PERIOD);
    for _ in 0..20_000 {
        motion.sample(&mut estimator, 0.005);
        assert!(estimator.capacity.iter().all(|c| (0.0..=1.0).contains(c)));
    }
    motion.truth = TRUTHS[1].to_vec();
    (0..300).for_each(|_| motion.sample(&mut estimator, 0.0));
    for (found, wanted) in estimator.capacity.iter().zip(&TRUTHS[1]) {
        // The estimate stops moving as soon as noise explains the residuals.
        assert!((found - wanted).abs() < 0.05, "{:?}", estimator.capacity);
    }
}

/// Whatever comes in, capacities are shares.
#[test]
fn estimates_are_shares_whatever_is_measured() {
    let model = octocopter("PPNNPPNN");
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut estimator = Estimator::new(&model, 0.95, 4.0, 0.005, PERIOD);
    for _ in 0..5000 {
        let size = 10f64.powf(between(&mut random, -3.0, 3.0));
        let rates = Vector3::from_fn(|_, _| size * normal(&mut random));
        let speeds: Vec<f64> = (0..8).map(|_| between(&mut random, 0.0, 874.0)).collect();
        estimator.note(&speeds, &rates);
        estimator.sample(&rates);
        assert!(estimator.capacity.iter().all(|c| (0.0..=1.0).contains(c)), "{:?}", estimator.capacity);
        assert!(estimator.conditioning().is_none_or(|(_, condition)| condition.is_finite()));
    }
}

fn estimated(mut model: Model) -> Model {
    model.simulation.detection = Detection::Estimator;
    model
}

#[test]
fn quiet_hover_moves_no_estimate() {
    let model = octocopter("PPNNPPNN");
    assert_eq!(model.simulation.detection, Detection::Estimator);
    assert!(model.simulation.gyroscope_noise > 0.0);
    let plan = staying([0.0, 0.0, 10.0], 0.0, 60.0);
    let lowest = |s: &mavc::flight::Sample| s.estimated.iter().copied().fold(1.0, f64::min);
    let (flight, all) = seen(&sortie(&model, &plan, &[]), lowest);
    assert!(all.iter().all(|c| *c > 0.9), "{}", all.iter().copied().fold(1.0, f64::min));
    assert_eq!((flight.false_alarms, flight.refused), (0, 0));
    // In hover three torques are seen and no more.
    assert_eq!(flight.regressor.unwrap().lowest_rank, 3);
    assert!(flight.rms_error < 0.03, "{}", flight.rms_error);
}

#[test]
fn single_losses_in_hover_are_identified() {
    for noise in [false, true] {
        let mut model = octocopter("PPNNPPNN");
        if !noise {
            model = estimated(quiet(model));
        }
        model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
        let plan = staying([0.0, 0.0, 10.0], 0.0, 8.0);
        for mode in 0..8 {
            let strikes = [strike(mode, 2.0)];
            let (flight, all) = seen(&sortie(&model, &plan, &strikes), |s| s.believed.to_vec());
            assert!(!flight.outcome.is_lost(), "M{}: {flight:?}", mode + 1);
            let found = flight.found[0];
            assert!(found.detected_after.is_some_and(|t| t < 0.3), "{found:?}");
            assert!(found.isolated_after.is_some_and(|t| t < 0.5), "noise {noise} {found:?}");
            let last = all.last().unwrap();
            let truth = &model.modes[mode].capacities();
            assert!(last.iter().zip(truth).all(|(b, c)| (b - c).abs() < 0.2), "M{}: {last:?}", mode + 1);
            assert_eq!(flight.false_alarms, 0, "M{}", mode + 1);
        }
    }
}
