//! How the vehicle answers to its commands while nothing is wrong: gains of the torques and of the thrust, the lag of
//! the rotors, and what the commands leave unexplained.

use super::record::median;
use super::samples::Samples;
use crate::actuation::Actuation;
use crate::model::Vehicle;

/// Time constants of rotors that are tried, s.
const LAGS: [f64; 8] = [0.0, 0.01, 0.02, 0.03, 0.05, 0.08, 0.12, 0.2];
/// How many steps a finer search of them has between two neighbours.
const FINER: usize = 20;
/// Faster turns than this are left out of the fit, rad/s: torques that the model lacks grow with them.
pub const FAST: f64 = 2.0;
/// An axis whose commands explain less than this share of the variance gets no gain.
const EXPLAINED: f64 = 0.3;
/// On an axis without a gain windows are used up to this many typical angular accelerations: those that balance.
const QUIET: f64 = 4.0;
/// The least typical angular acceleration, rad/s^2.
const LEAST_TURNING: f64 = 0.05;

/// What a rotor at full thrust gives: thrust, roll, pitch and yaw torque, each relative to the mean rotor of the frame.
pub type Effect = [f64; 4];

/// The effects of the rotors of a vehicle.
pub fn effects(vehicle: &Vehicle) -> Vec<Effect> {
    let actuation = Actuation::of(vehicle);
    let full: Vec<_> = (0..actuation.rotors()).map(|k| actuation.full(k)).collect();
    let scale = |axis: usize| {
        let sum: f64 = full.iter().map(|w| w[axis].abs()).sum();
        if sum > 0.0 { sum / full.len() as f64 } else { 1.0 }
    };
    let scales: [f64; 4] = std::array::from_fn(scale);
    full.iter().map(|w| std::array::from_fn(|axis| w[axis] / scales[axis])).collect()
}

/// The answer of a vehicle to its commands.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Time constant of the rotors, s.
    pub lag: f64,
    /// Angular acceleration for each unit of torque command about roll, pitch and yaw, rad/s^2; `None` where the flight
    /// does not show it.
    pub gains: [Option<f64>; 3],
    /// Share of the variance of the angular acceleration that the commands explain.
    pub explained: [f64; 3],
    /// Specific force for each unit of thrust command, m/s^2; `None` if no force is logged.
    pub thrust: Option<f64>,
    /// The greatest angular acceleration with which a window is used, on an axis without a gain, rad/s^2.
    quiet: [f64; 3],
    /// Commands as the rotors follow them, by window and motor.
    pub commands: Vec<Vec<f64>>,
    /// What the commands leave unexplained, by window: thrust, roll, pitch, yaw, in units of the effects. NaN where
    /// nothing is known.
    pub residuals: Vec<[f64; 4]>,
}

/// The unit command of an axis by window.
fn torque(commands: &[f64], effects: &[Effect], axis: usize) -> f64 {
    commands.iter().zip(effects).map(|(u, e)| u * e[axis]).sum()
}

/// Slope and explained share of the variance of y over x, with the windows of the largest residuals left out twice.
fn slope(pairs: &[(f64, f64)]) -> (f64, f64) {
    let mut used: Vec<(f64, f64)> = pairs.to_vec();
    let mut found = (0.0, 0.0);
    for _ in 0..3 {
        let n = used.len().max(1) as f64;
        let (mx, my) = (used.iter().map(|p| p.0).sum::<f64>() / n, used.iter().map(|p| p.1).sum::<f64>() / n);
        let sum = |f: fn(f64, f64) -> f64| used.iter().map(|(x, y)| f(x - mx, y - my)).sum::<f64>();
        let (xx, xy, yy) = (sum(|x, _| x * x), sum(|x, y| x * y), sum(|_, y| y * y));
        if xx <= 0.0 || yy <= 0.0 {
            return (0.0, 0.0);
        }
        found = (xy / xx, xy * xy / (xx * yy));
        let residual = |(x, y): &(f64, f64)| (y - my - found.0 * (x - mx)).abs();
        let mut sizes: Vec<f64> = used.iter().map(residual).collect();
        let Some(typical) = median(&mut sizes) else { break };
        used.retain(|pair| residual(pair) <= 5.0 * typical);
    }
    found
}

impl Fit {
    /// The fit of the windows in `[from, until)`, s, in which the vehicle flies.
    pub fn of(samples: &Samples, effects: &[Effect], range: [f64; 2]) -> Self {
        Fit::with(&LAGS, samples, effects, range)
    }

    /// The fit with a finer time constant of the rotors.
    pub fn refined(&self, samples: &Samples, effects: &[Effect], range: [f64; 2]) -> Self {
        let at = LAGS.iter().position(|lag| *lag == self.lag).unwrap_or(0);
        let [low, high] = [LAGS[at.saturating_sub(1)], LAGS[(at + 1).min(LAGS.len() - 1)]];
        let finer: Vec<f64> = (0..=FINER).map(|k| low + (high - low) * k as f64 / FINER as f64).collect();
        Fit::with(&finer, samples, effects, range)
    }

    /// The fit with that of some time constants (s) that explains most.
    fn with(lags: &[f64], samples: &Samples, effects: &[Effect], [from, until]: [f64; 2]) -> Self {
        let mut best: Option<Fit> = None;
        for &lag in lags {
            let commands = samples.followed(lag);
            let used: Vec<usize> = (0..samples.samples.len())
                .filter(|i| {
                    let s = &samples.samples[*i];
                    s.is_valid && s.time >= from && s.time < until && s.rates.iter().all(|w| w.abs() < FAST)
                })
                .collect();
            let mut fit = Fit {
                lag,
                gains: [None; 3],
                explained: [0.0; 3],
                thrust: None,
                quiet: [f64::INFINITY; 3],
                commands: Vec::new(),
                residuals: Vec::new(),
            };
            for axis in 0..3 {
                let pairs: Vec<(f64, f64)> = used
                    .iter()
                    .map(|i| (torque(&commands[*i], effects, axis + 1), samples.samples[*i].turning[axis]))
                    .collect();
                let (gain, explained) = slope(&pairs);
                fit.explained[axis] = if gain > 0.0 { explained } else { 0.0 };
                let mut sizes: Vec<f64> = pairs.iter().map(|(_, turning)| turning.abs()).collect();
                fit.quiet[axis] = QUIET * median(&mut sizes).unwrap_or(0.0).max(LEAST_TURNING);
                fit.gains[axis] = (gain > 0.0 && explained > EXPLAINED).then_some(gain);
            }
            let mut ratios: Vec<f64> = used
                .iter()
                .map(|i| samples.samples[*i].force / torque(&commands[*i], effects, 0))
                .filter(|r| r.is_finite())
                .collect();
            fit.thrust = median(&mut ratios).filter(|r| *r > 0.0);
            let total = |fit: &Fit| fit.explained[0] + fit.explained[1];
            if best.as_ref().is_none_or(|best| total(&fit) > total(best)) {
                fit.commands = commands;
                best = Some(fit);
            }
        }
        let mut fit = best.expect("there is a time constant");
        let n = samples.samples.len();
        fit.residuals = (0..n).map(|i| fit.residual(samples, effects, i, &fit.commands[i])).collect();
        fit
    }

    /// What is unexplained in window `i` if each rotor gives this share of its full thrust.
    pub fn residual(&self, samples: &Samples, effects: &[Effect], i: usize, given: &[f64]) -> [f64; 4] {
        let s = &samples.samples[i];
        let turns = |axis: usize| self.gains[axis].is_none() && s.turning[axis].abs() > self.quiet[axis];
        if !s.is_valid || (0..3).any(turns) {
            return [f64::NAN; 4];
        }
        std::array::from_fn(|axis| {
            let wanted = torque(given, effects, axis);
            match axis {
                0 => self.thrust.map_or(0.0, |gain| s.force / gain - wanted),
                _ => self.gains[axis - 1].map_or(0.0, |gain| s.turning[axis - 1] / gain) - wanted,
            }
        })
    }
}
