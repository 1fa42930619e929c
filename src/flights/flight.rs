//! Simulated flights: the vehicle of the paper's section 2 under a controller, with faults that strike during the
//! flight. See `docs/flight.md`.
//!
//! The rigid body is integrated by fourth-order Runge-Kutta steps. Motors are linear between two commands and are
//! integrated in closed form. Controller and estimator run at their own rates on the measurements of the sensors. Equal
//! seeds give equal flights.

pub mod air;
mod airborne;
pub mod allocate;
pub mod body;
pub mod capture;
pub mod control;
pub mod damage;
pub mod equilibrium;
pub mod estimate;
pub mod heading;
pub mod indistinguishable;
mod knowledge;
pub mod loss;
pub mod reduced_attitude;
pub mod reference;
pub mod rotors;
mod sample;
mod sensors;
mod single_axis;
mod sortie;
pub mod spin;
pub mod variation;
pub mod volumes;
mod way_out;

use crate::cancel;
use airborne::Airborne;
pub use damage::{BrokenLimits, Damage};
use heading::HeadingErrors;
pub use knowledge::FaultDetection;
pub use loss::{Cause, Outcome};
pub use sample::{Inertial, Sample};
pub use sortie::{Sortie, longest};
use spin::EndOfSpin;
pub use way_out::{TakenWay, WayOut, WaysOut};

/// The result of a simulated flight.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// How it ended.
    pub outcome: Outcome,
    /// When it ended, s since the start.
    pub end: f64,
    /// Root mean square of the distance from the reference position, m.
    pub rms_error: f64,
    /// Largest distance from the reference position, m.
    pub max_error: f64,
    /// Root mean square of the distance from the reference position since the first fault, m; 0 without a fault.
    pub rms_error_after: f64,
    /// Largest tilt, rad.
    pub max_tilt: f64,
    /// Heading errors.
    pub heading: HeadingErrors,
    /// What happened to the path since the first fault, or over the whole flight without one.
    pub damage: Damage,
    /// When yaw was first given up on purpose, s since the start; `None` if it never was.
    pub gave_up_yaw_at: Option<f64>,
    /// The way out that it took after the first fault; `None` if none was sought.
    pub way_out: Option<TakenWay>,
    /// The spin in the end; `None` if yaw is not given up then.
    pub spin: Option<EndOfSpin>,
    /// For how long some body rate was beyond the range of the gyroscope, s.
    pub gyroscope_saturated: f64,
    /// The detection of each fault that struck before the end.
    pub found: Vec<FaultDetection>,
    /// How often a healthy rotor was believed to have a capacity below 0.7 for longer than 0.1 s.
    pub false_alarms: usize,
    /// How often an estimate was rejected because the vehicle could not hover under it.
    pub refused: usize,
    /// Rank and conditioning of the regressor; `None` without an estimator.
    pub regressor: Option<Regressor>,
    /// Number of integration steps.
    pub steps: usize,
}

/// Rank and conditioning of the estimator's regressor over a flight, sampled ten times a second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regressor {
    /// Smallest rank.
    pub lowest_rank: usize,
    /// Largest rank.
    pub highest_rank: usize,
    /// Median condition number: the largest singular value over the smallest one that counts towards the rank.
    pub median_condition: f64,
}

/// Samples of the regressor per second.
const CONDITION_RATE: f64 = 10.0;

/// Time allowed for a landing in addition to the duration of its descent, s.
const LANDING_MARGIN: f64 = 20.0;

/// Simulates a flight.
///
/// `record` is called with the sample at every act of the controller and at the end of the flight. It only receives
/// samples with finite numbers: for a flight that diverges the last one is the sample before.
pub fn fly(sortie: &Sortie, mut record: Option<&mut dyn FnMut(&Sample)>) -> Flight {
    let mut flown = Airborne::new(sortie);
    let outcome = loop {
        flown.strike();
        if flown.is_act() {
            cancel::checkpoint();
            let t = flown.time();
            if let Some(end) = flown.look(t) {
                break end;
            }
            let measured = flown.measure();
            flown.learn(t, &measured);
            flown.take_way_out(t);
            flown.stop(t);
            flown.command(&measured);
            flown.sample_regressor();
            let Some(sample) = flown.sample(measured.rates) else { break Outcome::Diverged { at: t } };
            if let Some(record) = record.as_mut() {
                record(&sample);
            }
        }
        flown.advance();
    };
    flown.finish(outcome, record)
}

/// Summary of samples (rank, condition number); `None` without samples.
fn regressor(mut samples: Vec<(usize, f64)>) -> Option<Regressor> {
    let (lowest, highest) = samples.iter().fold((usize::MAX, 0), |(low, high), l| (low.min(l.0), high.max(l.0)));
    samples.sort_by(|a, b| a.1.total_cmp(&b.1));
    let median = samples.get(samples.len() / 2)?;
    Some(Regressor { lowest_rank: lowest, highest_rank: highest, median_condition: median.1 })
}
