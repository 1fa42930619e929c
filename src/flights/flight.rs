//! Simulated flights: the vehicle of the paper's section 2 under a controller, with faults that strike during the
//! flight. See `docs/flight.md`.
//!
//! The rigid body is integrated by fourth-order Runge-Kutta steps. Motors are linear between two commands and are
//! integrated in closed form. Controller and estimator run at their own rates on the measurements of the sensors. Equal
//! seeds give equal flights.

pub mod air;
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

use crate::actuation::Wrench;
use crate::cancel;
use crate::model::{AfterFault, FlownVehicle, Model, Strike, Vehicle};
use air::{Air, TorqueGusts};
use allocate::Allocator;
use body::Frame;
pub use damage::{BrokenLimits, Damage};
use heading::HeadingErrors;
pub use knowledge::FaultDetection;
use knowledge::Knowledge;
use loss::Watch;
pub use loss::{Cause, Outcome};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use reduced_attitude::{SpinningRotors, WithoutYaw};
use reference::{Branching, Course, DESCENT, Reference, Stop};
use rotors::Rotors;
use sample::View;
pub use sample::{Inertial, Sample};
use sensors::Sensors;
pub use sortie::{Sortie, longest};
use spin::{EndOfSpin, Spin};
use std::borrow::Cow;
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

/// While no stop keeps the volumes, one is tried again after this time, s.
const BETWEEN_STOPS: f64 = 0.1;

/// Time allowed for a landing in addition to the duration of its descent, s.
const LANDING_MARGIN: f64 = 20.0;

/// Where a way out has come to rest on the ground, its reference sinks until the vehicle touches down, m/s. Chosen by
/// hand.
const SINK: f64 = 0.2;

/// What the seed of the noise is combined with for torques of gusts and draws of the vehicle.
const OTHER_NOISE: u64 = 0x5bd1_e995_9d2c_5680;

/// The vehicle that flies: that of the sortie, or with its parameters and its centre of gravity drawn.
fn flown_vehicle<'a>(sortie: &'a Sortie, random: &mut Pcg64Mcg) -> Cow<'a, Vehicle> {
    let simulation = sortie.simulation;
    let mut vehicle = Cow::Borrowed(sortie.vehicle.as_ref());
    if simulation.spread == FlownVehicle::Drawn {
        vehicle = Cow::Owned(variation::draw(&vehicle, random));
    }
    if simulation.centre_offset > 0.0 {
        vehicle = Cow::Owned(variation::off_centre(&vehicle, simulation.centre_offset, random));
    }
    vehicle
}

/// Simulates a flight.
///
/// `record` is called with the sample at every act of the controller and at the end of the flight. It only receives
/// samples with finite numbers: for a flight that diverges the last one is the sample before.
pub fn fly(sortie: &Sortie, mut record: Option<&mut dyn FnMut(&Sample)>) -> Flight {
    let Sortie { model, simulation, strikes, .. } = *sortie;
    let h = 1.0 / simulation.rate;
    let control_steps = (simulation.rate / simulation.control_rate).round().max(1.0) as usize;
    let period = control_steps as f64 * h;
    let estimator_ticks = (simulation.control_rate / simulation.estimator_rate).round().max(1.0) as usize;
    let condition_ticks = (simulation.control_rate / CONDITION_RATE).round().max(1.0) as usize;
    let mut random = Pcg64Mcg::seed_from_u64(sortie.seed);
    // Of its own, so that these draws change no other noise.
    let mut others = Pcg64Mcg::seed_from_u64(sortie.seed ^ OTHER_NOISE);
    // What flies, and what the controller takes it for.
    let vehicle = flown_vehicle(sortie, &mut others);
    let (frame, known) = (Frame::of_vehicle(&vehicle, model), Frame::of(model));
    let airspeed = sortie.airspeed + nalgebra::Vector3::from(simulation.wind).norm();
    let mut air = Air::new(simulation.wind, simulation.gusts, simulation.gust_length, airspeed, period, &mut random);
    let mut sensors = Sensors::new(simulation, period);
    let span = 2.0 * vehicle.radius();
    let mut torque_gusts = TorqueGusts::new(simulation.torque_gusts, span, airspeed, period, &mut others);
    let mut gust = Wrench::zeros();
    let mut rotors = Rotors::new(&vehicle, h);
    let mut spin = Spin::new(&vehicle, period);
    let mut next_try = 0.0;
    let mut knowledge = Knowledge::new(model, simulation, strikes, period, estimator_ticks);
    let mut allocator = Allocator::new(model, model.vehicle.allocation);
    let mut course = sortie.course.clone();
    let mut watch = Watch::new(sortie, period);
    // One entry for each sample of the regressor; only long landings need more room.
    let mut conditions = Vec::with_capacity((sortie.duration.min(1e4) * CONDITION_RATE) as usize + 400);
    let mut reference = course.at(0.0);
    let environment = model.environment();
    let mut body = control::start(&known, &reference.in_air(&environment));
    let mut blowing = nalgebra::Vector3::zeros();
    let mut next_event = 0.0;
    let mut wrench = Wrench::zeros();
    let mut wanted = Wrench::zeros();
    let mut duration = sortie.duration;
    let mut momentum = 0.0;
    let mut without_yaw: Option<WithoutYaw> = None;
    let mut gave_up_yaw_at = None;
    let mut way_out: Option<TakenWay> = None;
    let mut step = 0usize;
    let outcome = loop {
        let t = step as f64 / simulation.rate;
        if t >= next_event {
            next_event = struck(strikes, t, h, model, &mut rotors);
            (wrench, momentum) = (rotors.wrench(), rotors.momentum());
        }
        if step.is_multiple_of(control_steps) {
            cancel::checkpoint();
            let tick = step / control_steps;
            reference = course.at(t);
            let acceleration = || body.derivative(&frame, &wrench, momentum, &blowing).velocity;
            let is_after = !strikes.is_empty() && t >= strikes[0].at;
            if let Some(end) = watch.look(t, &body, &reference, is_after, acceleration) {
                break end;
            }
            spin.look(t, body.rates.z, without_yaw.is_some());
            // A duration that is NaN counts as elapsed.
            if t >= duration - 0.5 * h || duration.is_nan() {
                match spin.settles_by(t).filter(|_| sortie.goes_on) {
                    Some(later) => duration = later,
                    None => break watch.end(t, &body),
                }
            }
            blowing = air.next(&mut random);
            gust.fixed_rows_mut::<3>(1).copy_from(&torque_gusts.next(&mut others));
            let measured = sensors.measure(&body, &mut random);
            if knowledge.update(t, tick, &measured, &allocator) {
                allocator.believe(&knowledge.belief);
                without_yaw = match knowledge.fault_known {
                    true => WithoutYaw::of(
                        knowledge.gives_up_yaw(t),
                        model,
                        &allocator,
                        &knowledge.hover,
                        &knowledge.belief,
                        &simulation.gains,
                    ),
                    false => None,
                };
                watch.gave_up_yaw = without_yaw.is_some();
                gave_up_yaw_at = gave_up_yaw_at.or(without_yaw.as_ref().map(|_| t));
            }
            if let (true, None, AfterFault::Recovery) = (knowledge.first_is_known(), &way_out, simulation.after_fault)
                && let (Some(ways), Some(strike)) = (sortie.ways_out, strikes.first())
            {
                let found = (ways.find)(strike.mode, strike.at, t);
                way_out = Some(TakenWay { at: t, words: found.as_ref().map(|way| way.words.clone()) });
                if let (Some(way), Course::Plan(plan)) = (found, &course) {
                    let ends = t + way.motion.duration();
                    let (plan, motion) = (*plan, Cow::Owned(way.motion));
                    let branch = Branching { plan, begins: t, motion, returns: way.returns, sink: SINK };
                    course = Course::Branch(Box::new(branch));
                    reference = course.at(t);
                    watch.volumes.widen();
                    if way.returns {
                        duration = duration.max(ends);
                    } else {
                        watch.land(t, ends, course.at(ends).position.z);
                        duration = ends + LANDING_MARGIN;
                    }
                }
            }
            let stops = matches!(simulation.after_fault, AfterFault::Hold | AfterFault::Land);
            let wants_to_stop = knowledge.fault_known && stops;
            if wants_to_stop && !watch.is_stopping && t >= next_try {
                next_try = t + BETWEEN_STOPS;
                let wanted = simulation.after_fault == AfterFault::Land;
                let is_over = t + BETWEEN_STOPS >= course.end();
                if let Some((stop, lands)) = possible_stop(&watch, &reference, t, wanted, is_over, simulation.ground) {
                    let rest = stop.at_rest();
                    let height = stop.place_of_rest().z - simulation.ground;
                    duration = if lands {
                        rest + height / DESCENT + LANDING_MARGIN
                    } else {
                        simulation.duration.map_or(duration, |asked| duration.max(asked)).max(rest + 5.0)
                    };
                    course = Course::Stop(Box::new(stop));
                    reference = course.at(t);
                    watch.stop(t, lands);
                }
            }
            // The controller knows the air of the plan, in the middle of the possible winds.
            let aimed = reference.in_air(&environment);
            // The flight begins with the thrust that the reference needs.
            let force = match step {
                0 => (aimed.acceleration + nalgebra::Vector3::z() * known.gravity).norm(),
                _ => knowledge.thrust() / known.mass,
            };
            let gains = &simulation.gains;
            if let Some(without_yaw) = &without_yaw {
                let spinning = SpinningRotors { lag: knowledge.lag(), momentum };
                wanted = without_yaw.control(&known, gains, &measured, force, &aimed, spinning);
                allocator.bounded_speeds(&wanted, &mut rotors.command);
            } else {
                wanted = control::control(simulation.controller, &known, gains, &measured, force, &aimed);
                allocator.speeds(&wanted, &mut rotors.command);
            }
            knowledge.probe(&mut rotors.command);
            knowledge.command(&rotors.command);
            if step == 0 {
                rotors.settle();
                knowledge.settle();
                // Faults at the start override the initial speeds.
                next_event = struck(strikes, t, h, model, &mut rotors);
                wrench = rotors.wrench();
            }
            if tick > 0 && tick.is_multiple_of(condition_ticks) {
                conditions.extend(knowledge.conditioning());
            }
            let heading = watch.heading;
            rotors.hold_stuck();
            let force = body.specific_force(&frame, wrench[0], &blowing);
            let inertial = Inertial { rates: measured.rates, force };
            let view = View { body: &body, reference: &reference, heading, wrench: &wrench, wanted: &wanted, inertial };
            let sample = view.sample(t, &rotors, &knowledge, conditions.last(), false);
            if !sample.is_finite() || !all_finite(&rotors.command) {
                break Outcome::Diverged { at: t };
            }
            if let Some(record) = record.as_mut() {
                record(&sample);
            }
        }
        // Rotors with inertia react to a new command at once.
        let begin = (rotors.wrench(), rotors.momentum());
        rotors.half_step();
        let middle = (rotors.wrench(), rotors.momentum());
        rotors.half_step();
        (wrench, momentum) = (rotors.wrench(), rotors.momentum());
        let wrenches = [begin.0 + gust, middle.0 + gust, wrench + gust];
        body.step_with(&frame, h, wrenches.each_ref(), [begin.1, middle.1, momentum], &blowing);
        step += 1;
    };
    let end = step as f64 / simulation.rate;
    let gyroscope_saturated = sensors.saturated;
    let force = body.specific_force(&frame, wrench[0], &blowing);
    let inertial = Inertial { rates: sensors.measure(&body, &mut random).rates, force };
    let heading = watch.heading;
    let view = View { body: &body, reference: &reference, heading, wrench: &wrench, wanted: &wanted, inertial };
    let last = view.sample(end, &rotors, &knowledge, conditions.last(), true);
    if let Some(record) = record.as_mut().filter(|_| !matches!(outcome, Outcome::Diverged { .. })) {
        record(&last);
    }
    let (found, false_alarms, refused) = knowledge.finish();
    Flight {
        outcome,
        end,
        rms_error: watch.rms_error(),
        max_error: watch.max_error,
        rms_error_after: watch.rms_error_after(),
        max_tilt: watch.max_tilt,
        heading: watch.heading_errors(),
        damage: watch.damage(end, outcome.is_lost()),
        gave_up_yaw_at,
        way_out,
        spin: spin.end(body.rates.amax(), simulation.gyroscope_range),
        gyroscope_saturated,
        found,
        false_alarms,
        refused,
        regressor: regressor(conditions),
        steps: step,
    }
}

/// The stop from a reference at `t` s, with a descent if one is `wanted`, and whether it descends: one that keeps the
/// volumes of the mission. `None` if there is none, so that the plan is followed for now. Where the plan `is_over` the
/// vehicle stays, if it cannot land.
fn possible_stop(
    watch: &Watch,
    reference: &Reference,
    t: f64,
    wanted: bool,
    is_over: bool,
    ground: f64,
) -> Option<(Stop, bool)> {
    let stop = Stop::from(reference, t, wanted, ground);
    if watch.volumes.are_kept_by(&stop, t, wanted) {
        return Some((stop, wanted));
    }
    is_over.then(|| (Stop::from(reference, t, false, ground), false))
}

fn all_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

/// Applies the faults that are active in the step that begins at `t`; returns when they next change, s.
fn struck(strikes: &[Strike], t: f64, h: f64, model: &Model, rotors: &mut Rotors) -> f64 {
    // Times of faults are rounded to steps.
    let now = t + 0.5 * h;
    let is_active = |s: &&Strike| s.at <= now && s.until.is_none_or(|end| end > now);
    rotors.set_faults(strikes.iter().filter(is_active).map(|s| &model.modes[s.mode]));
    let changes = strikes.iter().flat_map(|s| std::iter::once(s.at).chain(s.until));
    changes.filter(|change| *change > now).fold(f64::INFINITY, f64::min) - 0.5 * h
}

/// Summary of samples (rank, condition number); `None` without samples.
fn regressor(mut samples: Vec<(usize, f64)>) -> Option<Regressor> {
    let (lowest, highest) = samples.iter().fold((usize::MAX, 0), |(low, high), l| (low.min(l.0), high.max(l.0)));
    samples.sort_by(|a, b| a.1.total_cmp(&b.1));
    let median = samples.get(samples.len() / 2)?;
    Some(Regressor { lowest_rank: lowest, highest_rank: highest, median_condition: median.1 })
}
