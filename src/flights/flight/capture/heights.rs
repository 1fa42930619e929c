//! The height that a plan should have above the ground, mode by mode and speed by speed: captures at one delay, with
//! the rotors' own lag.

use super::{Capture, DELAYS, Fleet, is_captured};
use crate::model::Model;
use rayon::prelude::*;

/// The largest step between two simulated speeds, m/s.
const STEP: f64 = 5.0;
/// The most steps between simulated speeds.
const MOST_STEPS: usize = 8;

/// The most modes of a chart: those of one frame hardly differ, and every one takes sixty flights.
const DRAWN: usize = 2;

/// The captures of modes at some speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct CaptureHeights {
    /// Delay after which the fault is known, s.
    pub delay: f64,
    /// Speeds at the fault, ascending from 0, m/s.
    pub speeds: Vec<f64>,
    /// In the order of the modes, then by speed.
    pub cases: Vec<Capture>,
    /// The number of modes that are concerned but were left out.
    pub left_out: usize,
}

impl CaptureHeights {
    /// Simulates the captures of at most `most` modes of those that are concerned: every mode after which yaw is given
    /// up and the vehicle can still hover. Speeds reach from rest to `top_speed` (m/s) in even steps. `None` if no mode
    /// is concerned.
    pub fn simulate(model: &Model, delay: f64, top_speed: f64, most: usize) -> Option<Self> {
        let concerned: Vec<usize> = (0..model.modes.len()).filter(|&mode| is_captured(model, mode)).collect();
        if concerned.is_empty() {
            return None;
        }
        let steps = ((top_speed / STEP).ceil() as usize).clamp(1, MOST_STEPS);
        let speeds: Vec<f64> = (0..=steps).map(|k| top_speed * k as f64 / steps as f64).collect();
        let taken = &concerned[..most.min(concerned.len())];
        let fleets: Vec<Fleet> = taken.par_iter().map(|&mode| Fleet::of(model, mode, 1.0)).collect();
        let cases: Vec<(&Fleet, f64)> =
            fleets.iter().flat_map(|fleet| speeds.iter().map(move |&speed| (fleet, speed))).collect();
        let cases = cases.into_par_iter().map(|(fleet, speed)| fleet.capture(speed, delay)).collect();
        Some(CaptureHeights { delay, speeds, cases, left_out: concerned.len() - taken.len() })
    }

    /// Captures over all delays of [`DELAYS`], at the lowest and at the highest speed, of at most two modes: those that
    /// cost the most, in the order of the modes, then by speed and delay.
    pub fn curves(&self, model: &Model) -> Vec<Capture> {
        let mut costly: Vec<(usize, f64)> =
            self.modes().enumerate().map(|(k, of_mode)| (k, of_mode.iter().map(worst).fold(0.0, f64::max))).collect();
        costly.sort_by(|a, b| b.1.total_cmp(&a.1));
        costly.truncate(DRAWN);
        costly.sort_by_key(|(k, _)| *k);
        let names: Vec<&str> = self.modes().map(|of_mode| of_mode[0].mode.as_str()).collect();
        let index = |k: usize| model.modes.iter().position(|mode| mode.name == names[k]);
        let ends = [self.speeds[0], self.speeds[self.speeds.len() - 1]];
        let modes: Vec<usize> = costly.iter().filter_map(|(k, _)| index(*k)).collect();
        let fleets: Vec<Fleet> = modes.par_iter().map(|&mode| Fleet::of(model, mode, 1.0)).collect();
        let cases: Vec<(&Fleet, f64, f64)> = fleets
            .iter()
            .flat_map(|fleet| ends.map(|speed| (fleet, speed)))
            .flat_map(|(fleet, speed)| DELAYS.map(|delay| (fleet, speed, delay)))
            .collect();
        cases.into_par_iter().map(|(fleet, speed, delay)| fleet.capture(speed, delay)).collect()
    }

    /// The cases of each mode.
    pub fn modes(&self) -> impl Iterator<Item = &[Capture]> {
        self.cases.chunks(self.speeds.len())
    }

    /// The first case of which not every flight regained level flight: no height is known to be enough.
    pub fn hopeless(&self) -> Option<&Capture> {
        self.cases.iter().find(|case| worst(case).is_infinite())
    }

    /// The height that every mode asks for at every speed, m; infinite if no height is known to be enough.
    pub fn greatest(&self) -> f64 {
        self.cases.iter().map(worst).fold(0.0, f64::max)
    }

    /// The height that a mode asks for at a horizontal speed (m/s), m: the larger one of the two simulated speeds
    /// around it, because nothing is known in between. Beyond the last speed it is that of the last.
    pub fn height(&self, of_mode: &[Capture], speed: f64) -> f64 {
        let above = self.speeds.partition_point(|s| *s < speed).min(self.speeds.len() - 1);
        of_mode[above.saturating_sub(1)..=above].iter().map(worst).fold(0.0, f64::max)
    }
}

/// The largest height that a flight of a case lost, m; infinite if one did not regain level flight.
fn worst(case: &Capture) -> f64 {
    match case.height_m {
        Some([_, _, largest]) if case.regained == case.flights => largest,
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(speed: f64, height: f64, regained: usize) -> Capture {
        let height_m = Some([0.5 * height, 0.75 * height, height]);
        let (mode, lag_s, delay_s) = ("L".to_string(), 0.02, 0.1);
        let settled_rate_rad_s = Some(20.0);
        let drift_m = Some(1.0);
        Capture {
            mode,
            lag_s,
            speed_m_per_s: speed,
            delay_s,
            flights: 5,
            regained,
            settled_rate_rad_s,
            height_m,
            drift_m,
        }
    }

    #[test]
    fn between_two_speeds_the_larger_height_applies() {
        let cases = vec![case(0.0, 7.0, 5), case(4.0, 6.0, 5), case(8.0, 9.0, 5)];
        let heights = CaptureHeights { delay: 0.1, speeds: vec![0.0, 4.0, 8.0], cases, left_out: 0 };
        for (speed, height) in [(0.0, 7.0), (1.0, 7.0), (4.0, 7.0), (4.1, 9.0), (8.0, 9.0), (9.0, 9.0)] {
            assert_eq!(heights.height(&heights.cases, speed), height, "{speed}");
        }
        assert_eq!((heights.greatest(), heights.hopeless()), (9.0, None));
    }

    #[test]
    fn a_flight_that_does_not_recover_leaves_no_height() {
        let cases = vec![case(0.0, 7.0, 5), case(4.0, 6.0, 4)];
        let heights = CaptureHeights { delay: 0.1, speeds: vec![0.0, 4.0], cases, left_out: 0 };
        assert_eq!(heights.hopeless().map(|case| case.speed_m_per_s), Some(4.0));
        assert!(heights.greatest().is_infinite() && heights.height(&heights.cases, 0.5).is_infinite());
    }
}
