//! Flights: the vehicle of section 2 under a controller, with faults struck into it.
//!
//! The rigid body is integrated by Runge-Kutta steps of fourth order; motors, which are linear between two commands,
//! in closed form. Controller and estimator act at their own rates, on what the sensors give them. The same seed
//! gives the same flight.

pub mod air;
pub mod allocate;
pub mod body;
pub mod control;
pub mod estimate;
pub mod heading;
mod knowledge;
pub mod loss;
pub mod reference;
pub mod rotors;
mod sensors;
pub mod twins;

use crate::actuation::Wrench;
use crate::model::{AfterFault, Model, Simulation, Strike};
use crate::motion::{NodeState, Trajectory, X, Y, Z};
use air::Air;
use allocate::Allocator;
use body::{Body, Frame};
use heading::{Heading, HeadingErrors};
pub use knowledge::Found;
use knowledge::Knowledge;
use loss::Watch;
pub use loss::{Cause, Outcome};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use reference::{Course, DESCENT, Reference, Stop};
use rotors::Rotors;
use sensors::Sensors;

/// One flight to fly.
#[derive(Debug, Clone)]
pub struct Sortie<'a> {
    pub model: &'a Model,
    pub simulation: &'a Simulation,
    /// What is followed until a fault is known.
    pub course: Course<'a>,
    /// In the order of their times.
    pub strikes: &'a [Strike],
    pub seed: u64,
    /// s
    pub duration: f64,
    /// Speed through the air that gusts are taken to pass at, beside that of the mean wind, m/s.
    pub airspeed: f64,
}

impl<'a> Sortie<'a> {
    /// Along a plan, for as long as the spec says or the plan takes; no longer than one that ends in motion, after which nothing
    /// says where the vehicle should be. Gusts pass at the plan's mean speed.
    pub fn along(model: &'a Model, trajectory: &'a Trajectory, strikes: &'a [Strike], seed: u64) -> Self {
        let place = |s: &NodeState| nalgebra::Vector3::new(s[X][0], s[Y][0], s[Z][0]);
        let legs = trajectory.nodes.windows(2).map(|pair| (place(&pair[1]) - place(&pair[0])).norm());
        let longest = if trajectory.ends_at_rest() { f64::INFINITY } else { trajectory.duration() };
        Sortie {
            model,
            simulation: &model.simulation,
            course: Course::Plan(trajectory),
            strikes,
            seed,
            duration: model.simulation.duration.unwrap_or(trajectory.duration()).min(longest),
            airspeed: legs.sum::<f64>() / trajectory.duration(),
        }
    }
}

/// The longest that a flight along a plan of `time` s can take, s: with a landing, without the seconds of a stop.
pub fn longest(model: &Model, time: f64) -> f64 {
    let simulation = &model.simulation;
    let flown = simulation.duration.unwrap_or(time);
    let heights = model.mission.iter().flat_map(|m| m.waypoints.iter().map(|w| w.position[2] - simulation.ground));
    match simulation.after_fault {
        AfterFault::Land => flown + heights.fold(0.0, f64::max) / DESCENT + LANDING_MARGIN,
        _ => flown,
    }
}

/// What is to be seen of a flight at an instant.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a> {
    /// s
    pub time: f64,
    pub body: &'a Body,
    pub reference: &'a Reference,
    /// The vehicle's heading against the reference's.
    pub heading: Heading,
    /// What the rotors give, and what the controller asks for: N, N m.
    pub wrench: &'a Wrench,
    pub wanted: &'a Wrench,
    /// rad/s
    pub speeds: &'a [f64],
    /// Capacities that the controller believes in, and those that the estimator gives.
    pub believed: &'a [f64],
    pub estimated: &'a [f64],
    /// Rank and conditioning of the estimator's regressor at the last look, ten of which are taken a second.
    pub regressor: Option<(usize, f64)>,
    /// The flight ends here.
    pub is_last: bool,
}

impl Sample<'_> {
    /// Whether no number of it is NaN or infinite.
    fn is_finite(&self) -> bool {
        let wrenches = self.wrench.iter().chain(self.wanted);
        let rotors = self.speeds.iter().chain(self.believed).chain(self.estimated);
        self.body.is_finite() && self.reference.is_finite() && wrenches.chain(rotors).all(|x| x.is_finite())
    }
}

/// What a sample is made of, beside rotors and knowledge.
struct Looks<'a> {
    body: &'a Body,
    reference: &'a Reference,
    heading: Heading,
    wrench: &'a Wrench,
    wanted: &'a Wrench,
}

impl<'a> Looks<'a> {
    fn sample(
        self,
        time: f64,
        rotors: &'a Rotors,
        knowledge: &'a Knowledge,
        regressor: Option<&(usize, f64)>,
        is_last: bool,
    ) -> Sample<'a> {
        let Looks { body, reference, heading, wrench, wanted } = self;
        Sample {
            time,
            body,
            reference,
            heading,
            wrench,
            wanted,
            speeds: &rotors.speed,
            believed: &knowledge.belief.capacity,
            estimated: knowledge.estimated(),
            regressor: regressor.copied(),
            is_last,
        }
    }
}

/// What became of a flight.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    pub outcome: Outcome,
    /// s; when the flight ended.
    pub end: f64,
    /// Distance from where the vehicle should be, m: root of the mean square, and largest.
    pub rms_error: f64,
    pub max_error: f64,
    /// The same since the first fault; 0 where there was none.
    pub rms_error_after: f64,
    /// rad
    pub max_tilt: f64,
    pub heading: HeadingErrors,
    /// One for each strike that came before the end.
    pub found: Vec<Found>,
    /// Times a sound rotor was believed weaker than 0.7 for longer than 0.1 s.
    pub false_alarms: usize,
    /// Reconfigurations refused, because under them the vehicle could not hover.
    pub refused: usize,
    /// `None` where nothing is estimated.
    pub regressor: Option<Regressor>,
    /// Steps of the integrator.
    pub steps: usize,
}

/// How well the regressor along a flight could tell rotors apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regressor {
    pub lowest_rank: usize,
    pub highest_rank: usize,
    /// Largest singular value over the smallest that counts.
    pub median_condition: f64,
}

/// Looks at the regressor a second.
const CONDITION_RATE: f64 = 10.0;

/// What a landing is given beyond the time that its descent takes, s.
const LANDING_MARGIN: f64 = 20.0;

/// Flies. `record` is given every instant at which the controller acts, and the last of the flight, with finite numbers
/// only: of a flight that diverges the last ones before.
pub fn fly(sortie: &Sortie, mut record: Option<&mut dyn FnMut(&Sample)>) -> Flight {
    let Sortie { model, simulation, strikes, .. } = *sortie;
    let h = 1.0 / simulation.rate;
    let control_steps = (simulation.rate / simulation.control_rate).round().max(1.0) as usize;
    let period = control_steps as f64 * h;
    let estimator_ticks = (simulation.control_rate / simulation.estimator_rate).round().max(1.0) as usize;
    let look_ticks = (simulation.control_rate / CONDITION_RATE).round().max(1.0) as usize;
    let mut random = Pcg64Mcg::seed_from_u64(sortie.seed);
    let frame = Frame::of(model);
    let airspeed = sortie.airspeed + nalgebra::Vector3::from(simulation.wind).norm();
    let mut air = Air::new(simulation.wind, simulation.gusts, simulation.gust_length, airspeed, period, &mut random);
    let mut sensors = Sensors::new(simulation, period);
    let mut rotors = Rotors::new(model, h);
    let mut knowledge = Knowledge::new(model, simulation, strikes, period, estimator_ticks);
    let mut allocator = Allocator::new(model, model.vehicle.allocation);
    let mut course = sortie.course.clone();
    let mut watch = Watch::new(simulation, period);
    // As many as looks, but for landings that take longer.
    let mut conditions = Vec::with_capacity((sortie.duration.min(1e4) * CONDITION_RATE) as usize + 400);
    let mut reference = course.at(0.0);
    let mut body = control::start(&frame, &reference);
    let mut blowing = nalgebra::Vector3::zeros();
    let mut next_event = 0.0;
    let mut wrench = Wrench::zeros();
    let mut wanted = Wrench::zeros();
    let mut duration = sortie.duration;
    let mut step = 0usize;
    let outcome = loop {
        let t = step as f64 / simulation.rate;
        if t >= next_event {
            next_event = struck(strikes, t, h, model, &mut rotors);
            wrench = rotors.wrench();
        }
        if step.is_multiple_of(control_steps) {
            let tick = step / control_steps;
            reference = course.at(t);
            if let Some(end) = watch.look(t, &body, &reference, !strikes.is_empty() && t >= strikes[0].at) {
                break end;
            }
            // A duration that is no number is none.
            if t >= duration - 0.5 * h || duration.is_nan() {
                break watch.end(t, &body);
            }
            blowing = air.next(&mut random);
            let measured = sensors.measure(&body, &mut random);
            if knowledge.update(t, tick, &measured, &allocator) {
                allocator.believe(&knowledge.belief);
            }
            if knowledge.fault_known && simulation.after_fault != AfterFault::Continue && !watch.is_stopping {
                let lands = simulation.after_fault == AfterFault::Land;
                let stop = Stop::from(&reference, t, lands, simulation.ground);
                let rest = stop.at_rest();
                let height = stop.place_of_rest().z - simulation.ground;
                duration = if lands {
                    rest + height / DESCENT + LANDING_MARGIN
                } else {
                    duration.max(simulation.duration.unwrap_or(0.0)).max(rest + 5.0)
                };
                course = Course::Stop(Box::new(stop));
                reference = course.at(t);
                watch.is_stopping = true;
                watch.may_land = lands;
            }
            // A flight begins with the thrust that its reference takes.
            let force = match step {
                0 => (reference.acceleration + nalgebra::Vector3::z() * frame.gravity).norm(),
                _ => knowledge.thrust() / frame.mass,
            };
            wanted = control::control(simulation.controller, &frame, &simulation.gains, &measured, force, &reference);
            allocator.speeds(&wanted, &mut rotors.command);
            knowledge.probe(&mut rotors.command);
            knowledge.command(&rotors.command);
            if step == 0 {
                rotors.settle();
                knowledge.settle();
                // Faults at the very start hold whatever the command.
                next_event = struck(strikes, t, h, model, &mut rotors);
                wrench = rotors.wrench();
            }
            if tick > 0 && tick.is_multiple_of(look_ticks) {
                conditions.extend(knowledge.conditioning());
            }
            let heading = watch.heading;
            let looks = Looks { body: &body, reference: &reference, heading, wrench: &wrench, wanted: &wanted };
            let sample = looks.sample(t, &rotors, &knowledge, conditions.last(), false);
            if !sample.is_finite() || !all_finite(&rotors.command) {
                break Outcome::Diverged { at: t };
            }
            if let Some(record) = record.as_mut() {
                record(&sample);
            }
        }
        let begin = wrench;
        rotors.half_step();
        let middle = rotors.wrench();
        rotors.half_step();
        wrench = rotors.wrench();
        body.step(&frame, h, [&begin, &middle, &wrench], &blowing);
        step += 1;
    };
    let end = step as f64 / simulation.rate;
    let looks = Looks { body: &body, reference: &reference, heading: watch.heading, wrench: &wrench, wanted: &wanted };
    let last = looks.sample(end, &rotors, &knowledge, conditions.last(), true);
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
        found,
        false_alarms,
        refused,
        regressor: regressor(conditions),
        steps: step,
    }
}

fn all_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

/// Sets the rotors' faults for the step that begins at `t`; returns when they change next, s.
fn struck(strikes: &[Strike], t: f64, h: f64, model: &Model, rotors: &mut Rotors) -> f64 {
    // Times are taken at the step they round to.
    let now = t + 0.5 * h;
    let is_active = |s: &&Strike| s.at <= now && s.until.is_none_or(|end| end > now);
    rotors.set_faults(strikes.iter().filter(is_active).map(|s| &model.modes[s.mode]));
    let changes = strikes.iter().flat_map(|s| std::iter::once(s.at).chain(s.until));
    changes.filter(|change| *change > now).fold(f64::INFINITY, f64::min) - 0.5 * h
}

fn regressor(mut looks: Vec<(usize, f64)>) -> Option<Regressor> {
    let (lowest, highest) = looks.iter().fold((usize::MAX, 0), |(low, high), l| (low.min(l.0), high.max(l.0)));
    looks.sort_by(|a, b| a.1.total_cmp(&b.1));
    let median = looks.get(looks.len() / 2)?;
    Some(Regressor { lowest_rank: lowest, highest_rank: highest, median_condition: median.1 })
}
