//! The height that a vehicle loses from a fault until it flies level again with yaw given up, by simulation.
//!
//! Nothing of this is proved: another controller, or another course of events, may lose less or more.

pub mod exposed;
pub mod heights;

use super::allocate::{Allocator, Belief};
use super::reduced_attitude::WithoutYaw;
use super::reference::Course;
use super::{Outcome, Sortie, fly};
use crate::admissible::hover;
use crate::model::{AfterFault, Allocation, Detection, Model, Simulation, Strike};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Z};
use rayon::prelude::*;
use serde::Serialize;

/// Delays until a fault is known, s.
pub const DELAYS: [f64; 6] = [0.02, 0.05, 0.1, 0.15, 0.2, 0.3];
/// Horizontal speeds at the fault, m/s.
pub const SPEEDS: [f64; 2] = [0.0, 5.0];
/// Time constants of the rotors, as multiples of the vehicle's own.
pub const LAGS: [f64; 2] = [1.0, 2.0];
/// Flights for each delay, speed and lag, with different noise and gusts.
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
    /// Number of flights, with different noise and gusts.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub flights: usize,
    /// Flights that regained level flight.
    pub regained: usize,
    /// Height lost by these flights, m, [least, median, largest]; null if there are none.
    pub height_m: Option<[f64; 3]>,
    /// Their largest horizontal distance from the reference, which stops on the spot, m; null if there are none.
    pub drift_m: Option<f64>,
}

/// The captures of every mode in which yaw is given up and hover is possible, in the order of the modes, then by lag,
/// speed and delay. Flights use the spec's controller, gains, sensors and air.
pub fn captures(model: &Model) -> Vec<Capture> {
    let modes = (0..model.modes.len()).filter(|&mode| is_captured(model, mode));
    let cases: Vec<(usize, f64, f64, f64)> = modes
        .flat_map(|mode| LAGS.map(|lag| (mode, lag)))
        .flat_map(|(mode, lag)| SPEEDS.map(|speed| (mode, lag, speed)))
        .flat_map(|(mode, lag, speed)| DELAYS.map(|delay| (mode, lag, speed, delay)))
        .collect();
    cases.into_par_iter().map(|(mode, lag, speed, delay)| capture(model, mode, lag, speed, delay)).collect()
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
    let at = |speed: f64| {
        let seeds = (0..SEEDS).map(|seed| model.simulation.seed + seed);
        let lost = seeds.filter_map(|seed| flight(model, mode, speed, model.simulation.detection, seed));
        let mut heights: Vec<f64> = lost.map(|found| found.0).collect();
        heights.sort_by(f64::total_cmp);
        CaptureHeight {
            speed_m_per_s: speed,
            flights: SEEDS as usize,
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

fn capture(model: &Model, mode: usize, lag: f64, speed: f64, delay: f64) -> Capture {
    let mut slower = model.clone();
    for rotor in &mut slower.vehicle.rotors {
        rotor.time_constant = Some(lag * rotor.lag());
    }
    let flights: Vec<Option<(f64, f64)>> = (0..SEEDS)
        .map(|seed| flight(&slower, mode, speed, Detection::After(delay), model.simulation.seed + seed))
        .collect();
    let mut heights: Vec<f64> = flights.iter().flatten().map(|found| found.0).collect();
    heights.sort_by(f64::total_cmp);
    let rotors = &slower.vehicle.rotors;
    Capture {
        mode: model.modes[mode].name.clone(),
        lag_s: rotors.iter().map(crate::model::Rotor::lag).sum::<f64>() / rotors.len() as f64,
        speed_m_per_s: speed,
        delay_s: delay,
        flights: flights.len(),
        regained: heights.len(),
        height_m: (!heights.is_empty()).then(|| [heights[0], heights[heights.len() / 2], heights[heights.len() - 1]]),
        drift_m: flights.iter().flatten().map(|found| found.1).reduce(f64::max),
    }
}

/// The height lost and the largest horizontal distance from the reference (m) of a flight in which `mode` strikes at a
/// horizontal speed; `None` if it does not regain level flight.
fn flight(model: &Model, mode: usize, speed: f64, detection: Detection, seed: u64) -> Option<(f64, f64)> {
    let simulation = Simulation {
        detection,
        after_fault: AfterFault::Hold,
        ground: 0.0,
        lost_beyond: HIGH,
        upside_down: ENDS,
        duration: Some(ENDS),
        seed,
        ..model.simulation.clone()
    };
    let node = |t: f64| {
        let mut node = NodeState::default();
        (node[X][0], node[X][1], node[Z][0]) = (speed * t, speed, HIGH);
        node
    };
    let trajectory = Trajectory {
        times: vec![0.0, ENDS],
        nodes: vec![node(0.0), node(ENDS)],
        waypoint_nodes: vec![0, 1],
        model: WrenchModel::HoverFollowing,
    };
    let span = simulation.span;
    let strikes = [Strike { mode, at: STRIKES, until: None, span, at_span: span }];
    let sortie = Sortie {
        model,
        simulation: &simulation,
        course: Course::Plan(&trajectory),
        mission: None,
        strikes: &strikes,
        seed,
        duration: ENDS,
        airspeed: speed,
    };
    let (mut lowest, mut away, mut last) = ((0.0, HIGH), 0.0_f64, f64::INFINITY);
    let flight = fly(
        &sortie,
        Some(&mut |sample| {
            let at = sample.body.position;
            if at.z < lowest.1 {
                lowest = (sample.time, at.z);
            }
            away = away.max((at - sample.reference.position).xy().norm());
            last = sample.body.velocity.norm();
        }),
    );
    let is_regained = flight.outcome == Outcome::Flown && lowest.0 < flight.end - SETTLED && last < SLOW;
    is_regained.then_some((HIGH - lowest.1, away))
}
