//! Change points: when the unexplained torques jump as if one rotor had lost thrust.
//!
//! For each instant the mean of the residuals after it is compared with the mean before it, over several lengths. A
//! loss of rotor k to capacity c moves the mean by `-(1 - c) u_k a_k`, u_k its command and a_k its effect. The jump
//! is weighed by its spread over the whole flight, so that gusts and manoeuvres which the flight has anyway are not
//! taken for a loss.

use super::fit::{Effect, Fit};
use super::record::median;
use super::samples::Samples;

/// How long before an instant the mean is taken, s, and how long after it: a vehicle that falls leaves little time.
const BEFORE: f64 = 3.0;
const AFTER: [f64; 4] = [0.3, 0.6, 1.2, 3.0];
/// A jump is a change if it lowers the squared error by more than this many variances.
const THRESHOLD: f64 = 45.0;
/// Faster turns than this say nothing of single rotors, rad/s: gyroscopic torques and the air's are not in the model.
const FASTEST: f64 = 4.0;
/// Losses of less thrust than this are not reported as changes.
const LEAST: f64 = 0.12;
/// The spread of the residuals is at least this many shares of a rotor: no model is exact.
const FLOOR: f64 = 0.012;
/// Errors of the model grow with torques: this share of the change of a command counts as spread.
const MODEL_ERROR: f64 = 0.2;
/// How much more the mean of windows varies than that of independent ones would, as a factor of its variance.
const CORRELATED: f64 = 4.0;

/// A loss of thrust of one rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// From 0.
    pub motor: usize,
    /// s; in the time of the log.
    pub time: f64,
    /// 95 % interval of the time, s.
    pub interval: [f64; 2],
    /// Whether the rotor gives the same thrust whatever its command.
    pub is_held: bool,
    /// Share of thrust that is left, of a held rotor the share of full thrust that it gives, and its 95 % interval.
    pub capacity: f64,
    pub capacity_interval: [f64; 2],
    /// How many variances of the squared error it explains.
    pub strength: f64,
    /// Motors whose loss explains the jump as well.
    pub alternatives: Vec<usize>,
}

/// Two findings are of the same change within this time, s.
const SAME: f64 = 0.3;

impl Change {
    /// What the rotor gives after it, as a share of full thrust.
    pub fn given(&self, command: f64) -> f64 {
        if self.is_held { self.capacity } else { self.capacity * command }
    }

    /// Keeps only those alternatives that another finding of the same change names too, if it agrees in the motor.
    pub fn narrow(&mut self, other: &Change) {
        let names = |motor: usize| motor == other.motor || other.alternatives.contains(&motor);
        if (self.time - other.time).abs() < SAME && names(self.motor) {
            self.alternatives.retain(|motor| names(*motor));
        }
    }
}

/// Sums of a quantity up to each window, for means over any stretch.
struct Sums {
    count: Vec<f64>,
    values: Vec<Vec<f64>>,
}

impl Sums {
    fn of(rows: impl Iterator<Item = Option<Vec<f64>>>, width: usize) -> Self {
        let (mut count, mut values) = (vec![0.0], vec![vec![0.0; width]]);
        for row in rows {
            let (n, last) = (*count.last().unwrap_or(&0.0), values.last().cloned().unwrap_or_default());
            count.push(n + f64::from(u8::from(row.is_some())));
            values.push(match row {
                Some(row) => last.iter().zip(&row).map(|(a, b)| a + b).collect(),
                None => last,
            });
        }
        Sums { count, values }
    }

    /// The mean over the windows `[a, b)` if at least `least` of them are there.
    fn mean(&self, a: usize, b: usize, least: f64) -> Option<Vec<f64>> {
        let n = self.count[b] - self.count[a];
        (n >= least.max(1.0)).then(|| self.values[b].iter().zip(&self.values[a]).map(|(x, y)| (x - y) / n).collect())
    }
}

/// The jump about one window.
struct Jump {
    difference: [f64; 4],
    /// Its variance from the scatter of the windows on both sides.
    variance: [f64; 4],
    commands: Vec<f64>,
    /// By how much the commanded thrust and torques changed.
    moved: [f64; 4],
}

struct Scan<'s> {
    samples: &'s Samples,
    effects: &'s [Effect],
    sums: Sums,
    /// Residual, commands and commanded torques.
    motors: usize,
}

impl<'s> Scan<'s> {
    fn new(samples: &'s Samples, fit: &'s Fit, effects: &'s [Effect], residuals: &[[f64; 4]], until: usize) -> Self {
        let motors = effects.len();
        let rows = residuals.iter().enumerate().map(|(i, residual)| {
            let is_slow = samples.samples[i].rates.iter().all(|w| w.abs() < FASTEST);
            let is_used = i < until && is_slow && residual.iter().all(|x| x.is_finite());
            is_used.then(|| [&residual[..], &fit.commands[i], &residual.map(|x| x * x)].concat())
        });
        Scan { samples, effects, sums: Sums::of(rows, 8 + motors), motors }
    }

    fn windows(&self, seconds: f64) -> usize {
        ((seconds / self.samples.step).round() as usize).max(2)
    }

    fn jump(&self, i: usize, after: f64) -> Option<Jump> {
        let (before, after) = (self.windows(BEFORE), self.windows(after));
        let n = self.samples.samples.len();
        // The windows about the instant mix both.
        let (start, end) = (i.saturating_sub(before), (i + 1 + after).min(n));
        let pre = self.sums.mean(start, i.saturating_sub(1).max(start), 0.4 * before as f64)?;
        let post = self.sums.mean(i + 1, end, 0.7 * after as f64)?;
        let wanted = |means: &[f64], axis: usize| -> f64 {
            means[4..4 + self.motors].iter().zip(self.effects).map(|(u, e)| u * e[axis]).sum()
        };
        let scatter = |means: &[f64], k: usize, windows: usize| {
            let square = means[4 + self.motors + k] - means[k] * means[k];
            CORRELATED * square.max(0.0) / (self.samples.share * windows as f64)
        };
        Some(Jump {
            difference: std::array::from_fn(|k| post[k] - pre[k]),
            variance: std::array::from_fn(|k| scatter(&post, k, after) + scatter(&pre, k, before)),
            moved: std::array::from_fn(|k| wanted(&post, k) - wanted(&pre, k)),
            commands: post[4..4 + self.motors].to_vec(),
        })
    }

    /// The typical size of jumps on each axis, after Gauss.
    fn spread(&self, after: f64) -> [f64; 4] {
        let jumps: Vec<[f64; 4]> =
            (0..self.samples.samples.len()).filter_map(|i| self.jump(i, after).map(|jump| jump.difference)).collect();
        std::array::from_fn(|axis| {
            let mut sizes: Vec<f64> = jumps.iter().map(|d| d[axis].abs()).collect();
            (1.4826 * median(&mut sizes).unwrap_or(1.0)).max(FLOOR)
        })
    }
}

/// How well a loss of each motor explains a jump: share of thrust that is lost, its standard deviation, strength, and
/// what stays unexplained.
fn explain(jump: &Jump, effects: &[Effect], spread: &[f64; 4]) -> Vec<[f64; 4]> {
    let weight: [f64; 4] =
        std::array::from_fn(|k| 1.0 / (spread[k].powi(2) + jump.variance[k] + (MODEL_ERROR * jump.moved[k]).powi(2)));
    let total: f64 = (0..4).map(|k| weight[k] * jump.difference[k].powi(2)).sum();
    effects
        .iter()
        .zip(&jump.commands)
        .map(|(effect, command)| {
            let v: [f64; 4] = std::array::from_fn(|k| -effect[k] * command);
            let dot = |a: &[f64; 4], b: &[f64; 4]| (0..4).map(|k| weight[k] * a[k] * b[k]).sum::<f64>();
            let norm = dot(&v, &v);
            if norm <= 1e-9 {
                return [0.0, 1.0, 0.0, total];
            }
            let lost = (dot(&v, &jump.difference) / norm).clamp(0.0, 1.0);
            let rest: [f64; 4] = std::array::from_fn(|k| jump.difference[k] - lost * v[k]);
            let left = dot(&rest, &rest);
            [lost, norm.sqrt().recip(), total - left, left]
        })
        .collect()
}

/// The strongest change of the windows before `until`, with `capacity` as what is known of each rotor in each window;
/// `None` if none is strong enough.
pub fn strongest(
    samples: &Samples,
    fit: &Fit,
    effects: &[Effect],
    residuals: &[[f64; 4]],
    range: std::ops::Range<usize>,
    known: &[usize],
) -> Option<Change> {
    let scan = Scan::new(samples, fit, effects, residuals, range.end);
    let mut best: Option<(usize, f64, Vec<[f64; 4]>, usize)> = None;
    for after in AFTER {
        let spread = scan.spread(after);
        for i in range.clone() {
            let Some(jump) = scan.jump(i, after) else { continue };
            let found = explain(&jump, effects, &spread);
            for (k, [lost, _, strength, left]) in found.iter().enumerate() {
                // What no single rotor explains is something else: a collision, a gust, the ground.
                let explains = *left < 0.3 * strength.max(1e-9);
                let strong = *strength > THRESHOLD && *lost > LEAST && explains && !known.contains(&k);
                if strong && best.as_ref().is_none_or(|b| *strength > b.1) {
                    best = Some((i, *strength, found.clone(), k));
                }
            }
        }
    }
    let (at, strength, found, motor) = best?;
    let [lost, deviation, ..] = found[motor];
    let (time, interval) = when(samples, fit, effects, residuals, at, motor, range.clone());
    // Others count as good as the best within the error of the model.
    let margin = (0.1 * strength).max(6.0);
    let alternatives = (0..effects.len()).filter(|k| *k != motor && found[*k][2] > strength - margin).collect();
    let half = 1.96 * deviation;
    Some(Change {
        motor,
        is_held: false,
        time,
        interval,
        capacity: 1.0 - lost,
        capacity_interval: [(1.0 - lost - half).max(0.0), (1.0 - lost + half).min(1.0)],
        strength,
        alternatives,
    })
}

/// The instant about window `at` from which a loss of the motor explains the residuals best, and its interval.
fn when(
    samples: &Samples,
    fit: &Fit,
    effects: &[Effect],
    residuals: &[[f64; 4]],
    at: usize,
    motor: usize,
    range: std::ops::Range<usize>,
) -> (f64, [f64; 2]) {
    let reach = ((1.5 / samples.step).round() as usize).max(4);
    let (from, to) = (at.saturating_sub(2 * reach).max(range.start), (at + reach).min(range.end));
    let rows: Vec<usize> = (from..to).filter(|i| residuals[*i].iter().all(|x| x.is_finite())).collect();
    let mut spread = [0.0; 4];
    let mut offset = [0.0; 4];
    for axis in 0..4 {
        let early = || rows.iter().filter(|i| **i + 2 < at).map(|i| residuals[*i][axis]);
        offset[axis] = median(&mut early().collect::<Vec<_>>()).unwrap_or(0.0);
        let mut sizes: Vec<f64> = early().map(|x| (x - offset[axis]).abs()).collect();
        spread[axis] = (1.4826 * median(&mut sizes).unwrap_or(1.0)).max(FLOOR);
    }
    let error = |start: usize| {
        let signal = |i: usize, k: usize| -effects[motor][k] * fit.commands[i][motor];
        let (mut vv, mut vd, mut dd) = (0.0, 0.0, 0.0);
        for &i in &rows {
            for k in 0..4 {
                let d = (residuals[i][k] - offset[k]) / spread[k];
                // A single wild window must not decide.
                let d = d.clamp(-12.0, 12.0);
                dd += d * d;
                if i >= start {
                    let v = (signal(i, k) / spread[k]).clamp(-12.0, 12.0);
                    vv += v * v;
                    vd += v * d;
                }
            }
        }
        let lost = if vv > 0.0 { (vd / vv).clamp(0.0, 1.0) } else { 0.0 };
        dd - 2.0 * lost * vd + lost * lost * vv
    };
    let candidates: Vec<usize> = (at.saturating_sub(reach).max(range.start)..(at + reach).min(range.end)).collect();
    let errors: Vec<f64> = candidates.iter().map(|start| error(*start)).collect();
    let Some(best) = (0..errors.len()).min_by(|a, b| errors[*a].total_cmp(&errors[*b])) else {
        let time = samples.samples[at].time;
        return (time, [time - samples.step, time + samples.step]);
    };
    let noise = (errors[best] / rows.len().max(1) as f64 / 4.0).max(1.0);
    let near = |i: &usize| errors[*i] < errors[best] + 3.84 * noise;
    let [low, high] = [(0..errors.len()).find(near), (0..errors.len()).rfind(near)].map(|i| i.unwrap_or(best));
    let half = 0.5 * samples.step;
    let time = |i: usize| samples.samples[candidates[i]].time - half;
    (time(best), [time(low) - samples.step, time(high) + samples.step])
}
