//! The height that a vehicle loses from a fault until it flies level again with yaw given up, by simulation.
//!
//! Nothing of this is proved: another controller, or another course of events, may lose less or more.

pub mod exposed;
pub mod heights;
pub(super) mod settled;

use self::settled::Settled;
use super::allocate::{Allocator, Belief};
use super::reduced_attitude::WithoutYaw;
use super::reference::Course;
use super::{Flight, Outcome, Sample, Sortie, fly, variation};
use crate::admissible::hover;
use crate::model::{AfterFault, Allocation, Detection, Model, Simulation, Strike, Vehicle};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Z};
use rayon::prelude::*;
use serde::Serialize;
use std::borrow::Cow;

/// Delays until a fault is known, s.
pub const DELAYS: [f64; 6] = [0.02, 0.05, 0.1, 0.15, 0.2, 0.3];
/// Horizontal speeds at the fault, m/s.
pub const SPEEDS: [f64; 2] = [0.0, 5.0];
/// Time constants of the rotors, as multiples of the vehicle's own.
pub const LAGS: [f64; 2] = [1.0, 2.0];
/// Flights for each delay, speed and lag, with different noise and gusts; more where the spec's intervals have more
/// corners.
pub const SEEDS: u64 = 5;

/// When the fault strikes, and when the flight ends, s.
const STRIKES: f64 = 1.0;
const ENDS: f64 = 20.0;
/// Level flight is regained if the lowest point is at least this long before the end (s), with a speed below this (m/s)
/// at the end.
const SETTLED: f64 = 2.0;
const SLOW: f64 = 1.5;
/// Height of the flight above a ground that is out of reach, m.
const HIGH: f64 = 1e4;

/// The flights after one fault mode, at one speed, lag and delay.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Capture {
    /// The mode's name.
    pub mode: String,
    /// Mean time constant of the rotors, s.
    pub lag_s: f64,
    /// Horizontal speed at the fault, m/s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub speed_m_per_s: f64,
    /// Time until the fault is known, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub delay_s: f64,
    /// Number of flights, with different noise and gusts, at the corners of the spec's intervals in turn.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub flights: usize,
    /// Flights that regained level flight, at corners at which the vehicle still flies level when its spin has settled.
    pub regained: usize,
    /// The largest body rate on an axis when the spin has settled, over the corners of the intervals, rad/s; null if it
    /// does not settle in level flight at some corner. Beyond the range of the gyroscope no flight counts as regained.
    pub settled_rate_rad_s: Option<f64>,
    /// Height lost by these flights, m, [least, median, largest]; null if there are none.
    pub height_m: Option<[f64; 3]>,
    /// Their largest horizontal distance from the reference, which stops on the spot, m; null if there are none.
    pub drift_m: Option<f64>,
}

/// The captures of every mode in which yaw is given up and hover is possible, in the order of the modes, then by lag,
/// speed and delay. Flights use the spec's controller, gains, sensors and air.
pub fn captures(model: &Model) -> Vec<Capture> {
    let modes = (0..model.modes.len()).filter(|&mode| is_captured(model, mode));
    let fleets: Vec<(usize, f64)> = modes.flat_map(|mode| LAGS.map(|lag| (mode, lag))).collect();
    let fleets: Vec<Fleet> = fleets.into_par_iter().map(|(mode, lag)| Fleet::of(model, mode, lag)).collect();
    let cases: Vec<(&Fleet, f64, f64)> = fleets
        .iter()
        .flat_map(|fleet| SPEEDS.map(|speed| (fleet, speed)))
        .flat_map(|(fleet, speed)| DELAYS.map(|delay| (fleet, speed, delay)))
        .collect();
    cases.into_par_iter().map(|(fleet, speed, delay)| fleet.capture(speed, delay)).collect()
}

/// The height that a fault costs at a horizontal speed, with the detection of the spec.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CaptureHeight {
    /// Horizontal speed at the fault, m/s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub speed_m_per_s: f64,
    /// Number of flights.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub flights: usize,
    /// Flights that regained level flight.
    pub regained: usize,
    /// Median of the heights that these lost, m; null if there are none.
    pub height_m: Option<f64>,
}

/// The heights that a fault costs at each of [`SPEEDS`], in flights as in [`captures`], but with the rotors' own time
/// constant and the spec's detection. Empty if yaw is not given up after it, or hover is not possible then.
pub fn heights(model: &Model, mode: usize) -> Vec<CaptureHeight> {
    if !is_captured(model, mode) {
        return Vec::new();
    }
    let fleet = Fleet::of(model, mode, 1.0);
    let at = |speed: f64| {
        let (flights, lost) = fleet.fly(speed, model.simulation.detection);
        let heights: Vec<f64> = lost.iter().map(|found| found.0).collect();
        CaptureHeight {
            speed_m_per_s: speed,
            flights,
            regained: heights.len(),
            height_m: heights.get(heights.len() / 2).copied(),
        }
    };
    SPEEDS.map(at).to_vec()
}

/// Whether yaw is given up after a fault, and hover is possible then.
fn is_captured(model: &Model, mode: usize) -> bool {
    let fault = &model.modes[mode];
    let belief = Belief { capacity: fault.capacities(), stuck: fault.stuck() };
    let allocator = Allocator::new(model, Allocation::Bounded);
    let hover = hover(model);
    allocator.missing(&hover, &belief) < 1e-3
        && WithoutYaw::is_given_up(model.gives_up_yaw(mode), &allocator, &hover, &belief)
}

/// The vehicles that lose rotors in one mode: those at the corners of the spec's intervals.
struct Fleet {
    /// The spec with the rotors' time constants of this fleet.
    model: Model,
    mode: usize,
    corners: Vec<Vehicle>,
    /// How the spin of each of them ends.
    settled: Vec<Settled>,
}

impl Fleet {
    /// `lag` is a multiple of the rotors' time constants.
    fn of(model: &Model, mode: usize, lag: f64) -> Self {
        let mut model = model.clone();
        for rotor in &mut model.vehicle.rotors {
            rotor.time_constant = Some(lag * rotor.lag());
        }
        let corners = variation::corners(&model.vehicle);
        let settled = corners.iter().map(|vehicle| Settled::of(&model, vehicle, mode)).collect();
        Fleet { model, mode, corners, settled }
    }

    fn capture(&self, speed: f64, delay: f64) -> Capture {
        let (flights, lost) = self.fly(speed, Detection::After(delay));
        let rotors = &self.model.vehicle.rotors;
        Capture {
            mode: self.model.modes[self.mode].name.clone(),
            lag_s: rotors.iter().map(crate::model::Rotor::lag).sum::<f64>() / rotors.len() as f64,
            speed_m_per_s: speed,
            delay_s: delay,
            flights,
            regained: lost.len(),
            settled_rate_rad_s: Settled::largest(&self.settled),
            height_m: (!lost.is_empty()).then(|| [lost[0].0, lost[lost.len() / 2].0, lost[lost.len() - 1].0]),
            drift_m: lost.iter().map(|found| found.1).reduce(f64::max),
        }
    }

    /// The number of flights, and the height lost and the drift (m) of each that regains level flight, by height.
    fn fly(&self, speed: f64, detection: Detection) -> (usize, Vec<(f64, f64)>) {
        let flights = self.corners.len().max(SEEDS as usize);
        let range = self.model.simulation.gyroscope_range;
        let of = |k: usize| {
            let corner = k % self.corners.len();
            if !self.settled[corner].is_level_within(range) {
                return None;
            }
            let seed = self.model.simulation.seed + k as u64;
            let hold = Hold { model: &self.model, vehicle: &self.corners[corner], mode: self.mode, speed, ends: ENDS };
            hold.fly(detection, seed)
        };
        let mut lost: Vec<(f64, f64)> = (0..flights).filter_map(of).collect();
        lost.sort_by(|a, b| a.0.total_cmp(&b.0));
        (flights, lost)
    }
}

/// A flight far above the ground in which a mode strikes at a horizontal speed, and the vehicle then stops on the spot.
struct Hold<'a> {
    model: &'a Model,
    /// The vehicle that flies.
    vehicle: &'a Vehicle,
    mode: usize,
    /// m/s
    speed: f64,
    /// Duration, s.
    ends: f64,
}

impl Hold<'_> {
    /// The height lost and the largest horizontal distance from the reference (m); `None` if the vehicle does not
    /// regain level flight.
    fn fly(&self, detection: Detection, seed: u64) -> Option<(f64, f64)> {
        let (mut lowest, mut away, mut last) = ((0.0, HIGH), 0.0_f64, f64::INFINITY);
        let flight = self.seen(detection, seed, &mut |sample| {
            let at = sample.body.position;
            if at.z < lowest.1 {
                lowest = (sample.time, at.z);
            }
            away = away.max((at - sample.reference.position).xy().norm());
            last = sample.body.velocity.norm();
        });
        let is_regained = flight.outcome == Outcome::Flown && lowest.0 < flight.end - SETTLED && last < SLOW;
        is_regained.then_some((HIGH - lowest.1, away))
    }

    fn seen(&self, detection: Detection, seed: u64, look: &mut dyn FnMut(&Sample)) -> Flight {
        let Hold { model, vehicle, mode, speed, ends } = *self;
        let simulation = Simulation {
            detection,
            after_fault: AfterFault::Hold,
            ground: 0.0,
            lost_beyond: HIGH,
            upside_down: ends,
            duration: Some(ends),
            seed,
            ..model.simulation.clone()
        };
        let node = |t: f64| {
            let mut node = NodeState::default();
            (node[X][0], node[X][1], node[Z][0]) = (speed * t, speed, HIGH);
            node
        };
        let trajectory = Trajectory {
            times: vec![0.0, ends],
            nodes: vec![node(0.0), node(ends)],
            waypoint_nodes: vec![0, 1],
            model: WrenchModel::HoverFollowing,
        };
        let span = simulation.span;
        let strikes = [Strike { mode, at: STRIKES, until: None, span, at_span: span }];
        let sortie = Sortie {
            model,
            vehicle: Cow::Borrowed(vehicle),
            simulation: &simulation,
            course: Course::Plan(&trajectory),
            mission: None,
            strikes: &strikes,
            seed,
            duration: ends,
            airspeed: speed,
            goes_on: false,
            ways_out: None,
        };
        fly(&sortie, Some(look))
    }
}
