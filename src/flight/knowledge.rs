//! What the controller knows of the rotors: nothing, the modes after a delay, or what the estimator says.

use super::allocate::{Allocator, Belief};
use super::body::Body;
use super::estimate::Estimator;
use crate::actuation::Wrench;
use crate::admissible::hover;
use crate::model::{Detection, Model, Simulation, Strike};

/// Beliefs follow the estimate where some capacity has moved by this much.
const MOVED: f64 = 0.05;

/// Estimates below are taken for lost rotors, above for sound ones.
const LOST: f64 = 0.1;
const SOUND: f64 = 0.9;

/// A fault is found where every capacity is believed this closely.
const CLOSE: f64 = 0.2;

/// A sound rotor believed weaker is a false alarm where that lasts for longer than this, s.
const ALARM: f64 = 0.7;
const LASTING: f64 = 0.1;

/// Hover counts as possible where no more than this share of thrust, roll and pitch is missing.
const HOVERS: f64 = 1e-3;

/// When a strike came to be known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// Index into [`Model::modes`].
    pub mode: usize,
    /// s
    pub at: f64,
    /// Seconds until some rotor that it touches was believed weaker than before, or until the fault was told; `None` where that
    /// never came, of an estimate while the fault lasted.
    pub detected_after: Option<f64>,
    /// Seconds until every rotor's capacity was believed within 0.2 of what it was.
    pub isolated_after: Option<f64>,
}

pub struct Knowledge<'a> {
    model: &'a Model,
    strikes: &'a [Strike],
    detection: Detection,
    pub belief: Belief,
    /// Some fault has become known.
    pub fault_known: bool,
    estimator: Option<Estimator>,
    estimator_ticks: usize,
    /// The rotors' speeds as the commands and the motors' lag give them, rad/s.
    modelled: Vec<f64>,
    command: Vec<f64>,
    /// What is left of a difference to the command after a period.
    remaining: Vec<f64>,
    thrust_coefficient: Vec<f64>,
    /// Speeds in hover, all rotors at one share of full thrust.
    hover_speed: Vec<f64>,
    proposal: Belief,
    hover: Wrench,
    found: Vec<Found>,
    /// What was believed as each strike came: one rotor after the other, strike after strike.
    at_strike: Vec<f64>,
    period: f64,
    /// Seconds for which each sound rotor has been believed weak.
    alarmed: Vec<f64>,
    false_alarms: usize,
    refused: usize,
    was_refused: bool,
    /// When what a delay lets be known changes next, s.
    next_change: f64,
}

impl<'a> Knowledge<'a> {
    pub fn new(
        model: &'a Model,
        simulation: &Simulation,
        strikes: &'a [Strike],
        period: f64,
        estimator_ticks: usize,
    ) -> Self {
        let rotors = &model.vehicle.rotors;
        let n = rotors.len();
        let full: f64 = rotors.iter().map(super::super::model::Rotor::max_thrust).sum();
        let share = (model.vehicle.mass * model.gravity / full).min(1.0);
        let estimator = (simulation.detection == Detection::Estimator).then(|| {
            let sample = period * estimator_ticks as f64;
            Estimator::new(model, simulation.forgetting, simulation.gyroscope_noise, sample)
        });
        Knowledge {
            model,
            strikes,
            detection: simulation.detection,
            belief: Belief::healthy(n),
            fault_known: false,
            estimator,
            estimator_ticks,
            modelled: vec![0.0; n],
            command: vec![0.0; n],
            remaining: rotors.iter().map(|r| (-period / r.lag()).exp()).collect(),
            thrust_coefficient: rotors.iter().map(|r| r.thrust_coefficient).collect(),
            hover_speed: rotors.iter().map(|r| (r.max_speed * share.sqrt()).max(r.min_speed)).collect(),
            proposal: Belief::healthy(n),
            hover: hover(model),
            found: Vec::with_capacity(strikes.len()),
            at_strike: Vec::with_capacity(strikes.len() * n),
            period,
            alarmed: vec![0.0; n],
            false_alarms: 0,
            refused: 0,
            was_refused: false,
            next_change: 0.0,
        }
    }

    /// Brings knowledge up to time `t`, the tick-th act of the controller. True where the belief has changed.
    pub fn update(&mut self, t: f64, tick: usize, measured: &Body, allocator: &Allocator) -> bool {
        for k in 0..self.modelled.len() {
            let difference = (self.modelled[k] - self.command[k]) * self.remaining[k];
            self.modelled[k] = if difference.abs() < 1e-12 { self.command[k] } else { self.command[k] + difference };
        }
        let changed = match self.detection {
            Detection::Never => false,
            Detection::After(delay) => t + 1e-9 >= self.next_change && self.told(t, delay),
            Detection::Estimator => self.estimate(tick, measured, allocator),
        };
        self.keep_score(t);
        changed
    }

    /// After a delay the modes are known as they are.
    fn told(&mut self, t: f64, delay: f64) -> bool {
        let now = t + 1e-9;
        self.belief.capacity.fill(1.0);
        self.belief.stuck.fill(None);
        self.next_change = f64::INFINITY;
        for strike in self.strikes {
            let changes = [Some(strike.at), strike.until].into_iter().flatten().map(|at| at + delay);
            self.next_change = changes.filter(|at| *at > now).fold(self.next_change, f64::min);
            if strike.at + delay > now || strike.until.is_some_and(|end| end + delay <= now) {
                continue;
            }
            self.fault_known = true;
            let mode = &self.model.modes[strike.mode];
            for k in 0..self.belief.capacity.len() {
                self.belief.capacity[k] = self.belief.capacity[k].min(mode.capacity[k]);
                self.belief.stuck[k] = self.belief.stuck[k].or(mode.stuck[k]);
            }
        }
        true
    }

    fn estimate(&mut self, tick: usize, measured: &Body, allocator: &Allocator) -> bool {
        let Some(estimator) = &mut self.estimator else { return false };
        estimator.note(&self.modelled, &measured.rates);
        if !tick.is_multiple_of(self.estimator_ticks) || !estimator.sample(&measured.rates) {
            return false;
        }
        let mut moved: f64 = 0.0;
        for (k, estimate) in estimator.capacity.iter().enumerate() {
            let taken = match *estimate {
                e if e < LOST => 0.0,
                e if e > SOUND => 1.0,
                e => e,
            };
            self.proposal.capacity[k] = taken;
            moved = moved.max((taken - self.belief.capacity[k]).abs());
        }
        if moved <= MOVED {
            self.was_refused = false;
            return false;
        }
        // A belief under which the vehicle cannot hover is taken only where the present one cannot either.
        let missing = allocator.missing(&self.hover, &self.proposal);
        if missing > HOVERS && missing > allocator.missing(&self.hover, &self.belief) {
            self.refused += usize::from(!self.was_refused);
            self.was_refused = true;
            return false;
        }
        self.was_refused = false;
        self.belief.capacity.copy_from_slice(&self.proposal.capacity);
        self.fault_known |= self.belief.capacity.iter().any(|c| *c < ALARM);
        true
    }

    /// When faults were found, and false alarms.
    fn keep_score(&mut self, t: f64) {
        while let Some(strike) = self.strikes.get(self.found.len()).filter(|s| s.at <= t + 1e-9) {
            self.found.push(Found { mode: strike.mode, at: strike.at, detected_after: None, isolated_after: None });
            self.at_strike.extend_from_slice(&self.belief.capacity);
        }
        let active = |s: &&Strike| s.at <= t + 1e-9 && s.until.is_none_or(|end| end > t);
        let truth = |k: usize| {
            let modes = self.strikes.iter().filter(active).map(|s| &self.model.modes[s.mode]);
            modes.fold((1.0_f64, false), |(c, stuck), m| (c.min(m.capacity[k]), stuck || m.stuck[k].is_some()))
        };
        let touches = |s: &Strike, k: usize| {
            let mode = &self.model.modes[s.mode];
            mode.capacity[k] < 1.0 || mode.stuck[k].is_some()
        };
        let has_failed = |k: usize| self.strikes.iter().any(|s| s.at <= t + 1e-9 && touches(s, k));
        let believed = |k: usize| (self.belief.capacity[k], self.belief.stuck[k].is_some());
        let n = self.belief.capacity.len();
        for k in 0..n {
            let weak = believed(k).0 < ALARM || believed(k).1;
            // A rotor that has recovered was weak: that it is still believed so is no false alarm.
            let before = self.alarmed[k];
            self.alarmed[k] = if weak && !has_failed(k) { before + self.period } else { 0.0 };
            self.false_alarms += usize::from(before <= LASTING && self.alarmed[k] > LASTING);
        }
        if self.found.iter().all(|f| f.isolated_after.is_some()) {
            return;
        }
        // What a delay lets be known is known as it was, also of a fault that is over by then.
        if let Detection::After(delay) = self.detection {
            let told = self.found.iter_mut().filter(|f| f.detected_after.is_none() && t + 1e-9 >= f.at + delay);
            told.for_each(|f| {
                let after = Some((t - f.at).max(0.0));
                (f.detected_after, f.isolated_after) = (after, after);
            });
            return;
        }
        let is_close = |k: usize| {
            let ((c, stuck), (b, told)) = (truth(k), believed(k));
            if stuck { told || b < SOUND } else { (c - b).abs() <= CLOSE }
        };
        let all_close = (0..n).all(is_close);
        for (index, (found, strike)) in self.found.iter_mut().zip(self.strikes).enumerate() {
            if strike.until.is_some_and(|end| end <= t) {
                continue;
            }
            // What was believed before is not found now.
            let before = &self.at_strike[index * n..(index + 1) * n];
            let is_seen = |k: usize| self.belief.capacity[k] < before[k] - MOVED || self.belief.stuck[k].is_some();
            if found.detected_after.is_none() && (0..n).any(|k| touches(strike, k) && is_seen(k)) {
                found.detected_after = Some((t - strike.at).max(0.0));
            }
            if found.isolated_after.is_none() && found.detected_after.is_some() && all_close {
                found.isolated_after = Some((t - strike.at).max(0.0));
            }
        }
    }

    /// Has rotors that the estimator believes lost turn as they would in hover (rad/s). Nothing is asked of them; should
    /// one answer, the estimator sees it.
    pub fn probe(&self, command: &mut [f64]) {
        if self.estimator.is_none() {
            return;
        }
        for (k, speed) in command.iter_mut().enumerate() {
            if self.belief.capacity[k] == 0.0 {
                *speed = self.hover_speed[k];
            }
        }
    }

    /// The commands (rad/s) that hold from now on.
    pub fn command(&mut self, command: &[f64]) {
        self.command.copy_from_slice(command);
    }

    /// Rotors turn as commanded, as where a flight begins.
    pub fn settle(&mut self) {
        self.modelled.copy_from_slice(&self.command);
        if let Some(estimator) = &mut self.estimator {
            estimator.settle(&self.modelled);
        }
    }

    /// The thrust that the rotors are taken to give, N.
    pub fn thrust(&self) -> f64 {
        let rotors = self.belief.capacity.iter().zip(&self.thrust_coefficient).zip(&self.modelled);
        rotors.map(|((theta, b), w)| theta * b * w * w).sum()
    }

    /// Rank and condition number of the estimator's regressor.
    pub fn conditioning(&mut self) -> Option<(usize, f64)> {
        self.estimator.as_mut().and_then(Estimator::conditioning)
    }

    /// Capacities as estimated; as believed where nothing is.
    pub fn estimated(&self) -> &[f64] {
        self.estimator.as_ref().map_or(&self.belief.capacity, |e| &e.capacity)
    }

    pub fn finish(self) -> (Vec<Found>, usize, usize) {
        (self.found, self.false_alarms, self.refused)
    }
}
