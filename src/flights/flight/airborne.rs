//! A vehicle in flight: everything that moves, and the steps by which it is moved, in the order in which [`super::fly`]
//! takes them.

use super::air::{Air, TorqueGusts};
use super::allocate::Allocator;
use super::body::{Body, Frame};
use super::knowledge::Knowledge;
use super::loss::Watch;
use super::reduced_attitude::{SpinningRotors, WithoutYaw};
use super::reference::{Branching, Course, DESCENT, Reference, Stop};
use super::rotors::Rotors;
use super::sample::{Inertial, Sample, View};
use super::sensors::Sensors;
use super::sortie::Sortie;
use super::spin::Spin;
use super::way_out::{TakenWay, WayOut};
use super::{CONDITION_RATE, Flight, LANDING_MARGIN, Outcome, control, regressor, variation};
use crate::actuation::Wrench;
use crate::model::{AfterFault, Environment, FlownVehicle, Strike, Vehicle};
use nalgebra::Vector3;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use std::borrow::Cow;

/// While no stop keeps the volumes, one is tried again after this time, s.
const BETWEEN_STOPS: f64 = 0.1;

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

/// The state of a flight between two steps of the integration.
pub(super) struct Airborne<'s, 'a> {
    sortie: &'s Sortie<'a>,
    /// Steps of the integration so far, and their length, s.
    step: usize,
    h: f64,
    /// Steps between two acts of the controller, and acts between two samples of the regressor.
    control_steps: usize,
    condition_ticks: usize,
    random: Pcg64Mcg,
    /// Of its own, so that its draws change no other noise.
    others: Pcg64Mcg,
    /// The vehicle that flies, and what the controller takes it for.
    frame: Frame,
    known: Frame,
    environment: Environment,
    air: Air,
    torque_gusts: TorqueGusts,
    /// The wind, m/s, and the wrench of its gusts.
    blowing: Vector3<f64>,
    gust: Wrench,
    sensors: Sensors,
    knowledge: Knowledge<'a>,
    allocator: Allocator,
    without_yaw: Option<WithoutYaw>,
    course: Course<'a>,
    reference: Reference,
    /// The wrench that the controller demands.
    wanted: Wrench,
    rotors: Rotors,
    /// The wrench of the rotors, and their momentum about z, N m s.
    wrench: Wrench,
    momentum: f64,
    body: Body,
    spin: Spin,
    watch: Watch<'a>,
    /// When faults next begin or end, when a stop is next tried, and when the flight ends, s.
    next_event: f64,
    next_try: f64,
    duration: f64,
    gave_up_yaw_at: Option<f64>,
    way_out: Option<TakenWay>,
    /// Whether the way out is to stop and descend.
    descends: bool,
    /// Samples of the regressor.
    conditions: Vec<(usize, f64)>,
}

impl<'s, 'a> Airborne<'s, 'a> {
    pub fn new(sortie: &'s Sortie<'a>) -> Self {
        let Sortie { model, simulation, strikes, .. } = *sortie;
        let h = 1.0 / simulation.rate;
        let control_steps = (simulation.rate / simulation.control_rate).round().max(1.0) as usize;
        let period = control_steps as f64 * h;
        let estimator_ticks = (simulation.control_rate / simulation.estimator_rate).round().max(1.0) as usize;
        let condition_ticks = (simulation.control_rate / CONDITION_RATE).round().max(1.0) as usize;
        let mut random = Pcg64Mcg::seed_from_u64(sortie.seed);
        let mut others = Pcg64Mcg::seed_from_u64(sortie.seed ^ OTHER_NOISE);
        let vehicle = flown_vehicle(sortie, &mut others);
        let known = Frame::of(model);
        let airspeed = sortie.airspeed + Vector3::from(simulation.wind).norm();
        let air = Air::new(simulation.wind, simulation.gusts, simulation.gust_length, airspeed, period, &mut random);
        let span = 2.0 * vehicle.radius();
        let torque_gusts = TorqueGusts::new(simulation.torque_gusts, span, airspeed, period, &mut others);
        let course = sortie.course.clone();
        let reference = course.at(0.0);
        let environment = model.environment();
        Airborne {
            sortie,
            step: 0,
            h,
            control_steps,
            condition_ticks,
            random,
            others,
            frame: Frame::of_vehicle(&vehicle, model),
            body: control::start(&known, &reference.in_air(&environment)),
            known,
            environment,
            air,
            torque_gusts,
            blowing: Vector3::zeros(),
            gust: Wrench::zeros(),
            sensors: Sensors::new(simulation, period),
            knowledge: Knowledge::new(model, simulation, strikes, period, estimator_ticks),
            allocator: Allocator::new(model, model.vehicle.allocation),
            without_yaw: None,
            course,
            reference,
            wanted: Wrench::zeros(),
            rotors: Rotors::new(&vehicle, h),
            wrench: Wrench::zeros(),
            momentum: 0.0,
            spin: Spin::new(&vehicle, period),
            watch: Watch::new(sortie, period),
            next_event: 0.0,
            next_try: 0.0,
            duration: sortie.duration,
            gave_up_yaw_at: None,
            way_out: None,
            descends: false,
            // One entry for each sample of the regressor; only long landings need more room.
            conditions: Vec::with_capacity((sortie.duration.min(1e4) * CONDITION_RATE) as usize + 400),
        }
    }

    /// s since the start.
    pub fn time(&self) -> f64 {
        self.step as f64 / self.sortie.simulation.rate
    }

    /// Whether the controller acts before the next step.
    pub fn is_act(&self) -> bool {
        self.step.is_multiple_of(self.control_steps)
    }

    /// Lets faults begin and end that do so in the next step.
    pub fn strike(&mut self) {
        if self.time() >= self.next_event {
            self.apply_faults();
            (self.wrench, self.momentum) = (self.rotors.wrench(), self.rotors.momentum());
        }
    }

    /// Applies the faults that are active in the next step, and finds when they next change.
    fn apply_faults(&mut self) {
        let Sortie { model, strikes, .. } = *self.sortie;
        // Times of faults are rounded to steps.
        let now = self.time() + 0.5 * self.h;
        let is_active = |s: &&Strike| s.at <= now && s.until.is_none_or(|end| end > now);
        self.rotors.set_faults(strikes.iter().filter(is_active).map(|s| &model.modes[s.mode]));
        let changes = strikes.iter().flat_map(|s| std::iter::once(s.at).chain(s.until));
        self.next_event = changes.filter(|change| *change > now).fold(f64::INFINITY, f64::min) - 0.5 * self.h;
    }

    /// Compares the vehicle with its reference. Returns how the flight ends if it ends here.
    pub fn look(&mut self, t: f64) -> Option<Outcome> {
        self.reference = self.course.at(t);
        let acceleration = || self.body.derivative(&self.frame, &self.wrench, self.momentum, &self.blowing).velocity;
        let is_after = self.sortie.strikes.first().is_some_and(|first| t >= first.at);
        if let Some(end) = self.watch.look(t, &self.body, &self.reference, is_after, acceleration) {
            return Some(end);
        }
        self.spin.look(t, self.body.rates.z, self.without_yaw.is_some());
        // A duration that is NaN counts as elapsed.
        if t >= self.duration - 0.5 * self.h || self.duration.is_nan() {
            match self.spin.settles_by(t).filter(|_| self.sortie.goes_on) {
                Some(later) => self.duration = later,
                None => return Some(self.watch.end(t, &self.body)),
            }
        }
        None
    }

    /// Draws gusts, then what the sensors measure.
    pub fn measure(&mut self) -> Body {
        self.blowing = self.air.next(&mut self.random);
        self.gust.fixed_rows_mut::<3>(1).copy_from(&self.torque_gusts.next(&mut self.others));
        self.sensors.measure(&self.body, &mut self.random)
    }

    /// Updates what the controller knows of faults, and whether it gives up yaw.
    pub fn learn(&mut self, t: f64, measured: &Body) {
        let Sortie { model, simulation, .. } = *self.sortie;
        let Airborne { knowledge, allocator, .. } = self;
        if !knowledge.update(t, self.step / self.control_steps, measured, allocator) {
            return;
        }
        allocator.believe(&knowledge.belief);
        self.without_yaw = match knowledge.fault_known {
            true => WithoutYaw::of(
                knowledge.gives_up_yaw(t),
                model,
                allocator,
                &knowledge.hover,
                &knowledge.belief,
                &simulation.gains,
            ),
            false => None,
        };
        self.watch.gave_up_yaw = self.without_yaw.is_some();
        self.gave_up_yaw_at = self.gave_up_yaw_at.or(self.without_yaw.as_ref().map(|_| t));
    }

    /// With `after_fault = recovery`, seeks a way out once the first fault is known, and takes it.
    pub fn take_way_out(&mut self, t: f64) {
        let recovers = self.sortie.simulation.after_fault == AfterFault::Recovery;
        if !recovers || self.way_out.is_some() || !self.knowledge.first_is_known() {
            return;
        }
        let (Some(ways), Some(strike)) = (self.sortie.ways_out, self.sortie.strikes.first()) else { return };
        let found = (ways.find)(strike.mode, strike.at, t);
        self.way_out = Some(TakenWay { at: t, words: found.as_ref().map(|way| way.words().into()) });
        let (motion, returns) = match found {
            Some(WayOut::Branch { motion, returns, .. }) => (motion, returns),
            Some(WayOut::Stop { .. }) => {
                self.descends = true;
                return;
            }
            None => return,
        };
        let Course::Plan(plan) = &self.course else { return };
        let ends = t + motion.duration();
        let branch = Branching { plan, begins: t, motion: Cow::Owned(motion), returns, sink: SINK };
        self.follow(Course::Branch(Box::new(branch)), t);
        self.watch.volumes.widen();
        if returns {
            self.duration = self.duration.max(ends);
        } else {
            self.watch.land(t, ends, self.course.at(ends).position.z);
            self.duration = ends + LANDING_MARGIN;
        }
    }

    /// With `after_fault = hold` or `land`, stops once a fault is known and a stop keeps the volumes.
    pub fn stop(&mut self, t: f64) {
        let simulation = self.sortie.simulation;
        let descends = match simulation.after_fault {
            AfterFault::Hold => false,
            AfterFault::Land => true,
            AfterFault::Recovery if self.descends => true,
            AfterFault::Continue | AfterFault::Recovery => return,
        };
        if !self.knowledge.fault_known || self.watch.is_stopping || t < self.next_try {
            return;
        }
        self.next_try = t + BETWEEN_STOPS;
        let Some((stop, lands)) = self.possible_stop(t, descends) else { return };
        let rest = stop.at_rest();
        let height = stop.place_of_rest().z - simulation.ground;
        self.duration = if lands {
            rest + height / DESCENT + LANDING_MARGIN
        } else {
            simulation.duration.map_or(self.duration, |asked| self.duration.max(asked)).max(rest + 5.0)
        };
        self.follow(Course::Stop(Box::new(stop)), t);
        self.watch.stop(t, lands);
    }

    /// The stop from the reference at `t` s, with a descent if one is `wanted`, and whether it descends: one that keeps
    /// the volumes of the mission. `None` if there is none, so that the plan is followed for now. Where the plan ends
    /// before the next try the vehicle stays, if it cannot land.
    fn possible_stop(&self, t: f64, wanted: bool) -> Option<(Stop, bool)> {
        let ground = self.sortie.simulation.ground;
        let stop = Stop::from(&self.reference, t, wanted, ground);
        if self.watch.volumes.are_kept_by(&stop, t, wanted) {
            return Some((stop, wanted));
        }
        let is_over = t + BETWEEN_STOPS >= self.course.end();
        is_over.then(|| (Stop::from(&self.reference, t, false, ground), false))
    }

    fn follow(&mut self, course: Course<'a>, t: f64) {
        self.course = course;
        self.reference = self.course.at(t);
    }

    /// Commands the rotors.
    pub fn command(&mut self, measured: &Body) {
        let simulation = self.sortie.simulation;
        let Airborne { knowledge, allocator, rotors, known, .. } = self;
        // The controller knows the air of the plan, in the middle of the possible winds.
        let aimed = self.reference.in_air(&self.environment);
        // The flight begins with the thrust that the reference needs.
        let force = match self.step {
            0 => (aimed.acceleration + Vector3::z() * known.gravity).norm(),
            _ => knowledge.thrust() / known.mass,
        };
        let gains = &simulation.gains;
        if let Some(without_yaw) = &self.without_yaw {
            let spinning = SpinningRotors { lag: knowledge.lag(), momentum: self.momentum };
            self.wanted = without_yaw.control(known, gains, measured, force, &aimed, spinning);
            allocator.bounded_speeds(&self.wanted, &mut rotors.command);
        } else {
            self.wanted = control::control(simulation.controller, known, gains, measured, force, &aimed);
            allocator.speeds(&self.wanted, &mut rotors.command);
        }
        knowledge.probe(&mut rotors.command);
        knowledge.command(&rotors.command);
        if self.step == 0 {
            rotors.settle();
            knowledge.settle();
            // Faults at the start override the initial speeds.
            self.apply_faults();
            self.wrench = self.rotors.wrench();
        }
        self.rotors.hold_stuck();
    }

    /// Samples the regressor where one is due.
    pub fn sample_regressor(&mut self) {
        let tick = self.step / self.control_steps;
        if tick > 0 && tick.is_multiple_of(self.condition_ticks) {
            self.conditions.extend(self.knowledge.conditioning());
        }
    }

    /// The state at this instant, with the body rates that the gyroscope reads; `None` if a number is not finite.
    pub fn sample(&self, rates: Vector3<f64>) -> Option<Sample<'_>> {
        let sample = self.any_sample(rates, false);
        let is_finite = sample.is_finite() && self.rotors.command.iter().all(|x| x.is_finite());
        is_finite.then_some(sample)
    }

    fn any_sample(&self, rates: Vector3<f64>, is_last: bool) -> Sample<'_> {
        let force = self.body.specific_force(&self.frame, self.wrench[0], &self.blowing);
        let view = View {
            body: &self.body,
            reference: &self.reference,
            heading: self.watch.heading,
            wrench: &self.wrench,
            wanted: &self.wanted,
            inertial: Inertial { rates, force },
        };
        view.sample(self.time(), &self.rotors, &self.knowledge, self.conditions.last(), is_last)
    }

    /// A step of the integration.
    pub fn advance(&mut self) {
        // Rotors with inertia react to a new command at once.
        let begin = (self.rotors.wrench(), self.rotors.momentum());
        self.rotors.half_step();
        let middle = (self.rotors.wrench(), self.rotors.momentum());
        self.rotors.half_step();
        (self.wrench, self.momentum) = (self.rotors.wrench(), self.rotors.momentum());
        let wrenches = [begin.0 + self.gust, middle.0 + self.gust, self.wrench + self.gust];
        let momenta = [begin.1, middle.1, self.momentum];
        self.body.step_with(&self.frame, self.h, wrenches.each_ref(), momenta, &self.blowing);
        self.step += 1;
    }

    /// The result of a flight that ends here, whose last sample is recorded unless it diverged.
    pub fn finish(mut self, outcome: Outcome, record: Option<&mut dyn FnMut(&Sample)>) -> Flight {
        let (end, gyroscope_saturated) = (self.time(), self.sensors.saturated);
        let rates = self.sensors.measure(&self.body, &mut self.random).rates;
        if let Some(record) = record.filter(|_| !matches!(outcome, Outcome::Diverged { .. })) {
            record(&self.any_sample(rates, true));
        }
        let Airborne { mut watch, body, .. } = self;
        let (found, false_alarms, refused) = self.knowledge.finish();
        Flight {
            outcome,
            end,
            rms_error: watch.rms_error(),
            max_error: watch.max_error,
            rms_error_after: watch.rms_error_after(),
            max_tilt: watch.max_tilt,
            heading: watch.heading_errors(),
            damage: watch.damage(end, outcome.is_lost()),
            gave_up_yaw_at: self.gave_up_yaw_at,
            way_out: self.way_out,
            spin: self.spin.end(body.rates.amax(), self.sortie.simulation.gyroscope_range),
            gyroscope_saturated,
            found,
            false_alarms,
            refused,
            regressor: regressor(self.conditions),
            steps: self.step,
        }
    }
}
