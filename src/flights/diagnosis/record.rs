//! A recorded flight: series in time, in SI units, body x forward, y left, z up.

use std::collections::BTreeMap;

/// The most samples of a series; a longer one keeps every second, every fourth and so on. A log of up to 2.9 h keeps 50
/// samples a second, as many as the shortest windows (`samples`) use. Twice as many took more than 500 MB for a log of
/// 1 GB.
const MOST: usize = 1 << 20;

/// A time further ahead of the next one than this is damaged, s.
const FAR: f64 = 1.0;
/// So long after all others nothing is of the same flight, s.
const LONG: f64 = 3600.0;

/// Samples of `N` numbers in time, in their order.
#[derive(Debug, Clone)]
pub struct Series<const N: usize> {
    pub times: Vec<f64>,
    pub values: Vec<[f32; N]>,
    /// Every so many samples one is kept.
    stride: usize,
    seen: usize,
}

impl<const N: usize> Default for Series<N> {
    fn default() -> Self {
        Series { times: Vec::new(), values: Vec::new(), stride: 1, seen: 0 }
    }
}

impl<const N: usize> Series<N> {
    /// Adds a sample (s); one that is not finite or not after the last is left out. A last sample far ahead of its
    /// neighbours has a damaged time and is taken back. Returns whether all were in order.
    pub fn push(&mut self, time: f64, values: [f64; N]) -> bool {
        let mut is_in_order = time.is_finite();
        if let Some(last) = self.times.last().filter(|last| time <= **last) {
            let before = self.times.len().checked_sub(2).map_or(f64::NEG_INFINITY, |k| self.times[k]);
            if time > before && last - time > FAR {
                self.times.pop();
                self.values.pop();
            }
            is_in_order = false;
        }
        if !time.is_finite() || self.times.last().is_some_and(|last| time <= *last) {
            return false;
        }
        self.seen += 1;
        if !(self.seen - 1).is_multiple_of(self.stride) {
            return is_in_order;
        }
        self.times.push(time);
        self.values.push(values.map(|v| v as f32));
        if self.times.len() >= MOST {
            let mut at = 0;
            self.times.retain(|_| {
                at += 1;
                at % 2 == 1
            });
            at = 0;
            self.values.retain(|_| {
                at += 1;
                at % 2 == 1
            });
            self.stride *= 2;
        }
        is_in_order
    }

    /// Ends the series: a last sample long after the others has a damaged time.
    pub fn finish(&mut self) {
        if let [.., before, last] = self.times[..]
            && last - before > LONG
        {
            self.times.pop();
            self.values.pop();
        }
    }

    pub fn len(&self) -> usize {
        self.times.len()
    }

    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// The samples in `[from, to)`, s.
    pub fn within(&self, from: f64, to: f64) -> &[[f32; N]] {
        let [a, b] = [from, to].map(|t| self.times.partition_point(|x| *x < t));
        &self.values[a..b.max(a)]
    }

    /// The value at a time (s), between two samples in proportion; `None` outside the series and in gaps of more than
    /// `gap` s.
    pub fn at(&self, time: f64, gap: f64) -> Option<[f64; N]> {
        let k = self.times.partition_point(|x| *x <= time);
        if k == 0 || k == self.times.len() {
            let edge = if k == 0 { 0 } else { k - 1 };
            let near = self.times.get(edge).is_some_and(|t| *t == time);
            return near.then(|| self.values[edge].map(f64::from));
        }
        let (before, after) = (self.times[k - 1], self.times[k]);
        if after - before > gap {
            return None;
        }
        let share = (time - before) / (after - before);
        let [a, b] = [self.values[k - 1], self.values[k]];
        Some(std::array::from_fn(|i| f64::from(a[i]) * (1.0 - share) + f64::from(b[i]) * share))
    }

    /// The mean time between samples: the median of the differences, s; infinite for fewer than two.
    pub fn period(&self) -> f64 {
        let mut steps: Vec<f64> = self.times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        median(&mut steps).unwrap_or(f64::INFINITY)
    }
}

/// The median of some numbers, which it sorts; `None` of nothing.
pub fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Whose log it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Autopilot {
    ArduPilot,
    Px4,
    /// A simulated flight of mavc.
    Mavc,
}

/// The commands of a record, by row of its outputs and motor (from 0): the share of full thrust, and whether the motor
/// is switched off.
pub type Commands<'c> = dyn Fn(usize, usize) -> (f64, bool) + 'c;

/// The most motors of a record.
pub const MOTORS: usize = 16;

/// Everything that is read of a log.
#[derive(Debug, Clone)]
pub struct Record {
    pub autopilot: Autopilot,
    /// The last value of every parameter.
    pub parameters: BTreeMap<String, f64>,
    /// Outputs of motors as the log has them: by motor, from 0; NaN where there is none.
    pub outputs: Series<MOTORS>,
    /// Whether outputs are pulses in us; if not they are shares of full command.
    pub is_pulses: bool,
    /// Whether outputs are in the order of the spec's rotors, and not of the numbers of motors.
    pub is_by_rotor: bool,
    /// Thrust, roll, pitch and yaw that ArduPilot's controller demands of its mixer: of the thrust the share, of the
    /// others what the mixer adds to the motors of the largest factor, doubled.
    pub demands: Series<4>,
    /// rad/s.
    pub rates: Series<3>,
    /// Specific force, m/s^2.
    pub force: Series<3>,
    /// Roll, pitch, yaw, and those that were wanted, rad.
    pub attitude: Series<6>,
    /// Height, m.
    pub height: Series<1>,
    /// Height by air pressure, m: where the estimate of `height` is wrong in a fast turn, this is not.
    pub pressure_height: Series<1>,
    /// Velocity upwards, m/s.
    pub climb: Series<1>,
    /// How many samples were left out, because their time is before that of an earlier one.
    pub late: u64,
    /// Speed of each motor, rpm.
    pub speeds: Series<MOTORS>,
}

impl Record {
    pub fn new(autopilot: Autopilot) -> Self {
        Record {
            autopilot,
            parameters: BTreeMap::new(),
            outputs: Series::default(),
            is_pulses: true,
            is_by_rotor: false,
            demands: Series::default(),
            rates: Series::default(),
            force: Series::default(),
            attitude: Series::default(),
            height: Series::default(),
            pressure_height: Series::default(),
            climb: Series::default(),
            speeds: Series::default(),
            late: 0,
        }
    }

    /// Ends all series.
    pub fn finish(&mut self) {
        self.outputs.finish();
        self.demands.finish();
        self.rates.finish();
        self.force.finish();
        self.attitude.finish();
        self.height.finish();
        self.pressure_height.finish();
        self.climb.finish();
        self.speeds.finish();
    }

    /// A parameter, or its default.
    pub fn parameter(&self, name: &str, default: f64) -> f64 {
        self.parameters.get(name).copied().unwrap_or(default)
    }
}
