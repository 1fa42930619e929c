//! Gusts against the correlations of the Dryden spectra.
//!
//! S(w) = sigma^2 2 tau / (1 + tau^2 w^2) along the wind belongs to R(t) = sigma^2 exp(-t/tau). Across it
//! S(w) = sigma^2 tau (1 + 3 tau^2 w^2) / (1 + tau^2 w^2)^2. With u = tau w and
//! (1 + 3 u^2)/(1 + u^2)^2 = 3/(1 + u^2) - 2/(1 + u^2)^2, and since 1/(1 + u^2) belongs to exp(-s)/2 and
//! 1/(1 + u^2)^2 to (1 + s) exp(-s)/4, R(t) = sigma^2 (3/2 - (1 + s)/2) exp(-s) = sigma^2 (1 - s/2) exp(-s), s = t/tau.

use mavc::flight::air::Air;
use nalgebra::Vector3;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;

const SIGMA: f64 = 1.7;
const LENGTH: f64 = 50.0;

fn record(mean: [f64; 3], speed: f64, h: f64, seed: u64, n: usize) -> Vec<Vector3<f64>> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut air = Air::new(mean, SIGMA, LENGTH, speed, h, &mut random);
    (0..n).map(|_| air.next(&mut random)).collect()
}

/// A mean wind to the north-east, its axes, and what blows along them beside the mean.
fn gusts(n: usize, share: f64) -> [Vec<f64>; 3] {
    let mean = [3.0, 4.0, 1.0];
    let speed = 8.0;
    let all = record(mean, speed, share * LENGTH / speed, 3, n);
    let axes = [Vector3::new(0.6, 0.8, 0.0), Vector3::new(-0.8, 0.6, 0.0), Vector3::z()];
    axes.map(|axis| all.iter().map(|v| (v - Vector3::from(mean)).dot(&axis)).collect())
}

fn correlation(a: &[f64], b: &[f64], lag: usize) -> f64 {
    let pairs = a.iter().zip(&b[lag..]);
    pairs.map(|(x, y)| x * y).sum::<f64>() / (a.len() - lag) as f64 / (SIGMA * SIGMA)
}

#[test]
fn gusts_have_the_variance_and_correlation_of_dryden() {
    // Steps of a tenth of tau, 40000 tau long. The estimate of R(t) has a standard deviation of at most
    // sqrt(2 tau / T) sigma^2 along the wind, as the integral of R^2 over all lags is tau sigma^4 (Bartlett); across
    // it that integral is 5/8 of this, so the same bound holds.
    let (n, per_tau) = (400_000, 10);
    let gusts = gusts(n, 1.0 / per_tau as f64);
    let tolerance = 4.0 * (2.0 / (n / per_tau) as f64).sqrt();
    assert!(tolerance < 0.03);
    for (axis, record) in gusts.iter().enumerate() {
        for lag in [0, 2, 5, 10, 20, 30] {
            let s = lag as f64 / per_tau as f64;
            let wanted = if axis == 0 { (-s).exp() } else { (1.0 - 0.5 * s) * (-s).exp() };
            let found = correlation(record, record, lag);
            assert!((found - wanted).abs() < tolerance, "axis {axis} at {s} tau: {found} instead of {wanted}");
        }
        // The mean of the record: its variance is 2 tau/T along and half of that across.
        let mean = record.iter().sum::<f64>() / n as f64 / SIGMA;
        assert!(mean.abs() < tolerance, "axis {axis}: {mean}");
        for other in &gusts[..axis] {
            for lag in [0, 10] {
                let cross = correlation(record, other, lag);
                assert!(cross.abs() < tolerance, "axis {axis} and one before it: {cross}");
            }
        }
    }
}

/// The record's first value, over many seeds: what blows at once has the variance too.
#[test]
fn gusts_have_blown_for_ever_when_a_flight_begins() {
    let n = 20_000;
    let mut squares = Vector3::zeros();
    for seed in 0..n {
        squares += record([0.0; 3], 5.0, 0.002, seed, 1)[0].map(|v| v * v / (SIGMA * SIGMA));
    }
    // The square of a normal variable has twice its variance squared.
    let tolerance = 4.0 * (2.0 / n as f64).sqrt();
    assert!((squares / n as f64 - Vector3::repeat(1.0)).amax() < tolerance, "{squares}");
}

/// Half a step twice has the transition of a whole one, so the correlation over a step is the same for any step. Over
/// steps of 5e-4 tau the mean square of a difference is 2 (1 - R).
#[test]
fn short_steps_are_as_rough_as_the_spectra_say() {
    let (n, share) = (400_000, 5e-4);
    for (axis, record) in gusts(n, share).iter().enumerate() {
        let squares = record.windows(2).map(|p| (p[1] - p[0]).powi(2)).sum::<f64>() / (n - 1) as f64;
        let kept = if axis == 0 { (-share).exp() } else { (1.0 - 0.5 * share) * (-share).exp() };
        let wanted = 2.0 * (1.0 - kept) * SIGMA * SIGMA;
        // Differences are nearly independent.
        let tolerance = 5.0 * (2.0 / n as f64).sqrt();
        assert!((squares / wanted - 1.0).abs() < tolerance, "axis {axis}: {squares:e} instead of {wanted:e}");
    }
}

/// The covariance is computed by a series below a thousandth of tau and in closed form above.
#[test]
fn series_and_closed_form_meet() {
    let at = |share: f64| record([0.0; 3], 5.0, share * LENGTH / 5.0, 11, 2000);
    let (below, above) = (at(0.001 - 1e-9), at(0.001 + 1e-9));
    for (a, b) in below.iter().zip(&above) {
        assert!((a - b).norm() < 1e-4, "{a} and {b}");
    }
}

#[test]
fn gusts_repeat_with_their_seed_only() {
    let of = |seed| record([1.0, 0.0, 0.0], 5.0, 0.002, seed, 500);
    assert_eq!(of(1), of(1));
    assert_ne!(of(1), of(2));
}

#[test]
fn air_without_gusts_is_the_mean_wind() {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let mut air = Air::new([1.0, -2.0, 0.5], 0.0, LENGTH, 5.0, 0.002, &mut random);
    assert!(!air.is_still());
    assert_eq!(air.next(&mut random), Vector3::new(1.0, -2.0, 0.5));
    let still = Air::new([0.0; 3], 0.0, LENGTH, 5.0, 0.002, &mut random);
    assert!(still.is_still());
    // Nothing was drawn.
    assert_eq!(random, Pcg64Mcg::seed_from_u64(1));
}
