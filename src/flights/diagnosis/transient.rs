//! Sudden losses, by how the vehicle turns in the second after them, whatever its inertia.
//!
//! A vehicle that hovers calmly does not show how fast it turns for a torque, so that the balance of `change` is all
//! that is known of it; when a rotor stops, it turns. For each instant at which it starts to turn, and each rotor and
//! capacity, the gains of the three axes are fitted to the seconds around it. The instant is a candidate if a loss
//! explains the angular acceleration better than the commands alone; `onset` decides.

use super::change::Change;
use super::fit::Effect;
use super::record::median;
use super::samples::Samples;

/// Seconds before an instant, and after it: a quadcopter without a rotor turns over in a fraction of a second.
const BEFORE: f64 = 4.0;
const AFTER: [f64; 3] = [0.15, 0.3, 0.9];
/// Time constants of rotors that are tried, s.
const LAGS: [f64; 3] = [0.02, 0.05, 0.1];
/// Faster turns than this are left out, rad/s.
const FASTEST: f64 = 6.0;
/// A vehicle that already turned faster than this in the second before is not under control, rad/s.
const CALM: f64 = 2.0;
/// An instant counts from so many standard deviations of the angular acceleration on.
const STARTS: f64 = 6.0;
/// The least standard deviation of an angular acceleration, rad/s^2.
const FLOOR: f64 = 0.15;
/// Share of an angular acceleration by which the model may be off.
const MODEL_ERROR: f64 = 0.25;
/// A loss is a candidate if it lowers the squared error by so many variances, to at most this share of what it is
/// without: `onset` decides, which knows more.
const THRESHOLD: f64 = 40.0;
const EXPLAINS: f64 = 0.75;
/// A candidate that lowers it by so many variances, to at most this share, is clear (recorded flights).
const CLEAR: f64 = 50.0;
const BEGINS: f64 = 0.35;
/// Half of the 95 % interval of a capacity, which the few windows show badly.
const SHARE_ERROR: f64 = 0.25;
/// The most candidates, and how far apart they are, s.
const MOST: usize = 6;
const APART: f64 = 1.0;
/// Capacities that are tried.
const CAPACITIES: [f64; 15] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7];

/// What the starts of turns show.
#[derive(Debug, Clone, Default)]
pub struct Candidates {
    /// The strongest, in the order of strength.
    pub strongest: Vec<Change>,
    /// The strongest that explains its few windows so well that it counts even if nothing explains what follows.
    pub clear: Option<Change>,
}

/// A loss that is tried: the motor gives this share of its torques from a window on.
#[derive(Clone, Copy)]
struct Tried {
    motor: usize,
    start: usize,
    capacity: f64,
}

/// Rows of the windows around an instant.
struct Around<'s> {
    samples: &'s Samples,
    commands: &'s [Vec<f64>],
    effects: &'s [Effect],
    rows: Vec<usize>,
    /// Offset and standard deviation of the angular acceleration before.
    offset: [f64; 3],
    spread: [f64; 3],
    /// Mean torque commands before.
    trim: [f64; 3],
}

impl Around<'_> {
    fn torque(&self, i: usize, axis: usize, lost: Option<Tried>) -> f64 {
        let capacity = |k: usize| match lost {
            Some(lost) if lost.motor == k && i >= lost.start => lost.capacity,
            _ => 1.0,
        };
        let sum: f64 =
            (0..self.effects.len()).map(|k| capacity(k) * self.commands[i][k] * self.effects[k][axis + 1]).sum();
        sum - self.trim[axis]
    }

    /// The squared error of the windows of `late`, the gains fitted to all until its end, with a rotor lost or none.
    fn error(&self, late: std::ops::Range<usize>, lost: Option<Tried>) -> f64 {
        let mut total = 0.0;
        for axis in 0..3 {
            let weight =
                |turning: f64| self.samples.share / (self.spread[axis].powi(2) + (MODEL_ERROR * turning).powi(2));
            let turning = |i: usize| self.samples.samples[i].turning[axis] - self.offset[axis];
            let (mut xx, mut xy) = (1e-9, 0.0);
            for &i in self.rows.iter().take_while(|i| **i < late.end) {
                let (x, y) = (self.torque(i, axis, lost), turning(i));
                xx += weight(y) * x * x;
                xy += weight(y) * x * y;
            }
            let gain = (xy / xx).max(0.0);
            let rows = self.rows.iter().filter(|i| late.contains(i));
            total += rows
                .map(|i| weight(turning(*i)) * (turning(*i) - gain * self.torque(*i, axis, lost)).powi(2))
                .sum::<f64>();
        }
        total
    }
}

/// The candidates in a range of windows, whatever the time constant of the rotors.
pub fn sudden(samples: &Samples, effects: &[Effect], range: std::ops::Range<usize>) -> Candidates {
    let mut kept = Candidates::default();
    let windows = |seconds: f64| ((seconds / samples.step).round() as usize).max(3);
    for lag in LAGS {
        let commands = samples.followed(lag);
        for start in range.clone().skip(windows(BEFORE) / 2) {
            let Some(around) = Around::new(samples, &commands, effects, range.clone(), start) else { continue };
            for after in AFTER.map(windows) {
                let found = around.loss(start, (start + after).min(range.end));
                found.into_iter().for_each(|(change, left)| kept.take(change, left));
            }
        }
    }
    kept
}

impl Candidates {
    /// Keeps a candidate, which leaves a share of the squared error, unless one near it is stronger; at most [`MOST`].
    fn take(&mut self, new: Change, left: f64) {
        let is_clear = new.strength > CLEAR && left < BEGINS;
        if is_clear && self.clear.as_ref().is_none_or(|best| best.strength < new.strength) {
            self.clear = Some(new.clone());
        }
        let is_near = |other: &Change| (other.time - new.time).abs() <= APART;
        let kept = &mut self.strongest;
        if kept.iter().any(|other| is_near(other) && other.strength >= new.strength) {
            return;
        }
        kept.retain(|other| !is_near(other));
        kept.push(new);
        kept.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        kept.truncate(MOST);
    }
}

impl<'s> Around<'s> {
    /// The windows around an instant; `None` if too few are before it, or the vehicle does not start to turn.
    fn new(
        samples: &'s Samples,
        commands: &'s [Vec<f64>],
        effects: &'s [Effect],
        range: std::ops::Range<usize>,
        start: usize,
    ) -> Option<Self> {
        let before = ((BEFORE / samples.step).round() as usize).max(3);
        let is_used = |i: &usize| {
            let s = &samples.samples[*i];
            s.is_valid && s.rates.iter().all(|w| w.abs() < FASTEST) && commands[*i].iter().all(|u| u.is_finite())
        };
        let calm = |i: usize| samples.samples[i].rates.iter().all(|w| w.is_nan() || w.abs() <= CALM);
        let last_second = ((1.0 / samples.step).round() as usize).max(3);
        if !(start.saturating_sub(last_second)..start.saturating_sub(2)).all(calm) {
            return None;
        }
        let from = start.saturating_sub(before).max(range.start);
        let early: Vec<usize> = (from..start.saturating_sub(2)).filter(is_used).collect();
        if early.len() < before / 3 {
            return None;
        }
        let end = (start + before).min(range.end);
        let rows = (early[0]..end).filter(is_used).collect();
        let mut around =
            Around { samples, commands, effects, rows, offset: [0.0; 3], spread: [0.0; 3], trim: [0.0; 3] };
        for axis in 0..3 {
            let mut values: Vec<f64> = early.iter().map(|i| samples.samples[*i].turning[axis]).collect();
            around.offset[axis] = median(&mut values).unwrap_or(0.0);
            let mut sizes: Vec<f64> = values.iter().map(|x| (x - around.offset[axis]).abs()).collect();
            around.spread[axis] = (1.4826 * median(&mut sizes).unwrap_or(0.0)).max(FLOOR);
            let trim: f64 = early.iter().map(|i| around.torque(*i, axis, None)).sum();
            around.trim[axis] = trim / early.len() as f64;
        }
        let turns = |i: usize, k: usize| (samples.samples[i].turning[k] - around.offset[k]).abs();
        let starts = |i: usize| (0..3).any(|k| turns(i, k) > STARTS * around.spread[k]);
        (start..(start + 2).min(range.end)).any(starts).then_some(around)
    }

    /// The loss from window `start` on that lowers the squared error of the windows until `end` most; `None` if none
    /// explains them. With it the share of the squared error that is left.
    fn loss(&self, start: usize, end: usize) -> Option<(Change, f64)> {
        let healthy = self.error(start..end, None);
        if healthy < THRESHOLD {
            return None;
        }
        let best_of = |k: usize| {
            let lost = |capacity: f64| Tried { motor: k, start, capacity };
            let all = CAPACITIES.map(|c| (self.error(start..end, Some(lost(c))), c));
            all.into_iter().fold((f64::INFINITY, 1.0), |best, one| if one.0 < best.0 { one } else { best })
        };
        let each: Vec<(f64, f64)> = (0..self.effects.len()).map(best_of).collect();
        let motor = (0..each.len()).min_by(|a, b| each[*a].0.total_cmp(&each[*b].0))?;
        let (error, capacity) = each[motor];
        if healthy - error < THRESHOLD || error > EXPLAINS * healthy {
            return None;
        }
        let noise = (error / (self.samples.share * (3 * (end - start)) as f64)).max(1.0);
        let step = self.samples.step;
        let time = self.samples.samples[start].time - 0.5 * step;
        let change = Change {
            motor,
            is_held: false,
            time,
            interval: [time - 2.0 * step, time + step],
            capacity,
            capacity_interval: [(capacity - SHARE_ERROR).max(0.0), (capacity + SHARE_ERROR).min(1.0)],
            strength: healthy - error,
            alternatives: (0..each.len()).filter(|k| *k != motor && each[*k].0 < error + 9.0 * noise).collect(),
        };
        Some((change, error / healthy))
    }
}
