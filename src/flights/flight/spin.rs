//! Whether the spin of a vehicle that has given up yaw has settled.

use super::capture::settled::settling_time;
use crate::model::Vehicle;

/// Time constant of the average that takes the noise out of the rate and of its change, s.
const AVERAGED: f64 = 0.5;
/// The spin has settled once it is within this share of its rate in the end, or within [`SLIGHT`].
const SHARE: f64 = 0.02;
/// The spin has settled once it is within this rate of its rate in the end, rad/s.
const SLIGHT: f64 = 0.1;

/// The spin of a body after it has given up yaw.
#[derive(Debug, Clone)]
pub(super) struct Spin {
    /// Time from one sample to the next, s.
    period: f64,
    /// How long it takes to settle at most, and the time constant of the drag, s; `None` without yaw drag.
    times: Option<(f64, f64)>,
    /// When yaw was given up last, s since the start.
    began: Option<f64>,
    /// Averages of the rate, rad/s, and of its change, rad/s^2.
    rate: f64,
    change: f64,
}

/// The spin in which a flight ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndOfSpin {
    /// The rate about z in the end, rad/s.
    pub rate: f64,
    /// Whether it has settled: to within 2 % of its rate in the end, or 0.1 rad/s. Without yaw drag a spin that
    /// changes never does.
    pub is_settled: bool,
    /// Whether some rate of the body was beyond the range of the gyroscope in the end.
    pub is_beyond_gyroscope: bool,
}

impl Spin {
    pub(super) fn new(vehicle: &Vehicle, period: f64) -> Self {
        let times = settling_time(vehicle)
            .map(|settles| (settles, settles / super::capture::settled::SETTLES_IN))
            .filter(|times| times.0.is_finite());
        Spin { period, times, began: None, rate: 0.0, change: 0.0 }
    }

    /// Processes the rate about z (rad/s) at `t` s; `given_up` is whether yaw is given up.
    pub(super) fn look(&mut self, t: f64, rate: f64, given_up: bool) {
        if !given_up {
            self.began = None;
            return;
        }
        if self.began.is_none() {
            (self.began, self.rate, self.change) = (Some(t), rate, 0.0);
        }
        let share = self.period / AVERAGED;
        let next = self.rate + share * (rate - self.rate);
        self.change += share * ((next - self.rate) / self.period - self.change);
        self.rate = next;
    }

    fn is_settled(&self) -> bool {
        let left = match self.times {
            Some((_, constant)) => self.change.abs() * constant,
            // The time over which it would be seen.
            None => self.change.abs() * 10.0,
        };
        left <= (SHARE * self.rate.abs()).max(SLIGHT)
    }

    /// Until when the flight has to go on at least (s since the start) for the spin to settle: a time constant from
    /// `t`, and no longer than five of them from when yaw was given up. `None` if it has settled, yaw is not given up,
    /// or nothing ends the spin.
    pub(super) fn settles_by(&self, t: f64) -> Option<f64> {
        let (settles, constant) = self.times?;
        let end = self.began? + settles;
        (!self.is_settled() && t < end).then(|| (t + constant).min(end))
    }

    /// The spin at the end of a flight; `None` if yaw is not given up then.
    pub(super) fn end(&self, largest_rate: f64, range: f64) -> Option<EndOfSpin> {
        let ends =
            EndOfSpin { rate: self.rate, is_settled: self.is_settled(), is_beyond_gyroscope: largest_rate > range };
        self.began.map(|_| ends)
    }
}
