//! Capacities from the balance of torques in quiet flight: a motor that is commanded more than its counterpart gives
//! less for each command, or the centre of gravity is not where the frame's centre is.

use super::fit::{Effect, FAST, Fit};
use super::samples::Samples;
use nalgebra::{DMatrix, DVector, Matrix3};

/// The length of the parts whose spread gives the interval, s.
const PART: f64 = 4.0;
/// A window is quiet below these rates, rad/s, and angular accelerations, rad/s^2.
const SLOW: f64 = 0.25 * FAST;
const STEADY: f64 = 3.0;
/// A part needs at least this share of quiet windows.
const QUIET: f64 = 0.5;
/// Student's 97.5 % quantile for 1, 2, ... degrees of freedom; 1.96 beyond.
const STUDENT: [f64; 15] =
    [12.71, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131];

/// The capacity of a rotor relative to the strongest one, and its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capacity {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

/// The 97.5 % quantile of Student's distribution.
pub fn student(freedom: usize) -> f64 {
    STUDENT.get(freedom.wrapping_sub(1)).copied().unwrap_or(if freedom == 0 { f64::INFINITY } else { 1.96 })
}

/// The capacities nearest to 1 with which mean commands balance, relative to the strongest; `None` if torques of the
/// frame are not independent.
fn balanced(commands: &[f64], effects: &[Effect]) -> Option<Vec<f64>> {
    let n = commands.len();
    let m = DMatrix::from_fn(3, n, |axis, k| commands[k] * effects[k][axis + 1]);
    let square: Matrix3<f64> = (&m * m.transpose()).fixed_view::<3, 3>(0, 0).into_owned();
    let ones = DVector::from_element(n, 1.0);
    let correction = m.transpose() * DMatrix::from_iterator(3, 3, square.try_inverse()?.iter().copied()) * (&m * &ones);
    let c = ones - correction;
    let strongest = c.max();
    (strongest > 0.0).then(|| c.iter().map(|c| (c / strongest).max(0.0)).collect())
}

/// The capacities of the rotors in the quiet parts between two times (s); `None` if fewer than two are.
pub fn capacities(samples: &Samples, fit: &Fit, effects: &[Effect], range: [f64; 2]) -> Option<Vec<Capacity>> {
    let n = effects.len();
    let windows = ((PART / samples.step).round() as usize).max(4);
    let inside: Vec<usize> = (0..samples.samples.len())
        .filter(|i| samples.samples[*i].time > range[0] && samples.samples[*i].time < range[1])
        .collect();
    let is_quiet = |i: &&usize| {
        let s = &samples.samples[**i];
        s.is_valid && s.rates.iter().all(|w| w.abs() < SLOW) && s.turning.iter().all(|a| a.abs() < STEADY)
    };
    let mut parts: Vec<Vec<f64>> = Vec::new();
    for part in inside.chunks(windows) {
        let quiet: Vec<&usize> = part.iter().filter(is_quiet).collect();
        if (quiet.len() as f64) < QUIET * windows as f64 {
            continue;
        }
        let mean: Vec<f64> =
            (0..n).map(|k| quiet.iter().map(|i| fit.commands[**i][k]).sum::<f64>() / quiet.len() as f64).collect();
        parts.extend(balanced(&mean, effects));
    }
    let count = parts.len() as f64;
    // One part has no spread.
    if parts.len() < 2 {
        return None;
    }
    Some(
        (0..n)
            .map(|k| {
                let mean = parts.iter().map(|p| p[k]).sum::<f64>() / count;
                let variance = parts.iter().map(|p| (p[k] - mean).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
                let half = student(parts.len() - 1) * (variance / count).sqrt();
                Capacity { value: mean, low: (mean - half).max(0.0), high: (mean + half).min(1.0) }
            })
            .collect(),
    )
}
