//! The controller's knowledge of faults: none, the modes after a delay, or the estimator's capacities
//! (`docs/flight.md`, section 4).

use super::allocate::{Allocator, Belief};
use super::body::Body;
use super::estimate::Estimator;
use crate::actuation::Wrench;
use crate::admissible::hover;
use crate::model::{Detection, GiveUpYaw, Model, Rotor, RotorState, Simulation, Strike};

/// The belief takes over the estimate if some capacity differs by more than this.
const MOVED: f64 = 0.05;

/// A rotor whose estimated capacity is below `LOST` is treated as lost, above `SOUND` as healthy.
const LOST: f64 = 0.1;
const SOUND: f64 = 0.9;

/// A fault is isolated if every believed capacity is within this of the true one.
const CLOSE: f64 = 0.2;

/// A false alarm is a healthy rotor believed to have a capacity below `ALARM` for longer than `LASTING` (s).
const ALARM: f64 = 0.7;
const LASTING: f64 = 0.1;

/// Instants that differ by no more than this are the same instant of the clock, s: rounding of sums of periods.
const SAME_INSTANT: f64 = 1e-9;

/// Hover counts as possible if at most this share of thrust, roll and pitch is missing.
const HOVERS: f64 = 1e-3;

/// When a fault was detected and isolated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaultDetection {
    /// Index into [`Model::modes`].
    pub mode: usize,
    /// When the fault struck, s since the start.
    pub at: f64,
    /// Seconds from the fault until some affected rotor was believed weaker than before, or until a detection after a
    /// delay reported the fault. `None` if that did not happen; the estimator has to detect the fault while it lasts.
    pub detected_after: Option<f64>,
    /// Seconds from the fault until every believed capacity was within 0.2 of the true one; `None` if that did not
    /// happen.
    pub isolated_after: Option<f64>,
}

/// The state of the controller's knowledge during a flight, and its record.
pub(super) struct Knowledge<'a> {
    model: &'a Model,
    strikes: &'a [Strike],
    detection: Detection,
    /// The capacities and stuck rotors that the allocation uses.
    pub(super) belief: Belief,
    /// Whether some fault has become known.
    pub(super) fault_known: bool,
    estimator: Option<Estimator>,
    /// Acts of the controller between two samples of the estimator.
    estimator_ticks: usize,
    /// Rotor speeds modelled from the commands and the motors' lag, rad/s.
    modelled: Vec<f64>,
    /// Commanded speeds, rad/s.
    command: Vec<f64>,
    /// Factor by which the difference of speed and command decays within a period.
    remaining: Vec<f64>,
    thrust_coefficient: Vec<f64>,
    /// Speeds in hover with all rotors at the same share of full thrust, rad/s.
    hover_speed: Vec<f64>,
    /// The belief that the current estimate suggests.
    proposal: Belief,
    pub(super) hover: Wrench,
    found: Vec<FaultDetection>,
    /// The believed capacities at each fault: n entries for each.
    at_strike: Vec<f64>,
    /// Time between two acts of the controller, s.
    period: f64,
    /// For how long each healthy rotor has been believed weak, s.
    alarmed: Vec<f64>,
    false_alarms: usize,
    refused: usize,
    was_refused: bool,
    /// When the faults known after a delay next change, s.
    next_change: f64,
}

impl<'a> Knowledge<'a> {
    /// `period` is the time between two acts of the controller, s; the estimator samples every `estimator_ticks` of
    /// them.
    pub(super) fn new(
        model: &'a Model,
        simulation: &Simulation,
        strikes: &'a [Strike],
        period: f64,
        estimator_ticks: usize,
    ) -> Self {
        let rotors = &model.vehicle.rotors;
        let n = rotors.len();
        let full: f64 = rotors.iter().map(Rotor::max_thrust).sum();
        let share = (model.vehicle.mass * model.gravity / full).min(1.0);
        let estimator = (simulation.detection == Detection::Estimator).then(|| {
            let sample = period * estimator_ticks as f64;
            let noise = simulation.assumed_gyroscope_noise.unwrap_or(simulation.gyroscope_noise);
            Estimator::new(model, simulation.forgetting, simulation.threshold, noise, sample)
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

    /// Updates the knowledge at time `t` (s), act number `tick` of the controller. Returns whether the belief has
    /// changed.
    pub(super) fn update(&mut self, t: f64, tick: usize, measured: &Body, allocator: &Allocator) -> bool {
        for k in 0..self.modelled.len() {
            let difference = (self.modelled[k] - self.command[k]) * self.remaining[k];
            self.modelled[k] = if difference.abs() < 1e-12 { self.command[k] } else { self.command[k] + difference };
        }
        let changed = match self.detection {
            Detection::Never => false,
            Detection::After(delay) => t + SAME_INSTANT >= self.next_change && self.after_delay(t, delay),
            Detection::Estimator => self.estimate(tick, measured, allocator),
        };
        self.keep_score(t);
        changed
    }

    /// Sets the belief to the faults that struck at least `delay` s ago and lasted until then; they are known exactly.
    fn after_delay(&mut self, t: f64, delay: f64) -> bool {
        let now = t + SAME_INSTANT;
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
                self.belief.capacity[k] = self.belief.capacity[k].min(mode.rotors[k].capacity());
                self.belief.stuck[k] = self.belief.stuck[k].or(mode.rotors[k].stuck_at());
            }
        }
        true
    }

    /// Updates the estimator and takes its estimate over if it has changed enough.
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
        // An estimate under which the vehicle cannot hover is rejected unless the present belief is no better.
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

    /// Whether the first fault has been detected; a false alarm before it does not count.
    pub(super) fn first_is_known(&self) -> bool {
        self.found.first().is_some_and(|found| found.detected_after.is_some())
    }

    /// Records when faults are detected and isolated, and false alarms.
    fn keep_score(&mut self, t: f64) {
        while let Some(strike) = self.strikes.get(self.found.len()).filter(|s| s.at <= t + SAME_INSTANT) {
            self.found.push(FaultDetection {
                mode: strike.mode,
                at: strike.at,
                detected_after: None,
                isolated_after: None,
            });
            self.at_strike.extend_from_slice(&self.belief.capacity);
        }
        let active = |s: &&Strike| s.at <= t + SAME_INSTANT && s.until.is_none_or(|end| end > t);
        let truth = |k: usize| {
            let modes = self.strikes.iter().filter(active).map(|s| &self.model.modes[s.mode]);
            modes.fold((1.0_f64, false), |(c, stuck), m| {
                (c.min(m.rotors[k].capacity()), stuck || m.rotors[k].stuck_at().is_some())
            })
        };
        let touches = |s: &Strike, k: usize| self.model.modes[s.mode].rotors[k] != RotorState::Sound;
        let has_failed = |k: usize| self.strikes.iter().any(|s| s.at <= t + SAME_INSTANT && touches(s, k));
        let believed = |k: usize| (self.belief.capacity[k], self.belief.stuck[k].is_some());
        let n = self.belief.capacity.len();
        for k in 0..n {
            let weak = believed(k).0 < ALARM || believed(k).1;
            // A rotor that has recovered but is still believed weak is not a false alarm.
            let before = self.alarmed[k];
            self.alarmed[k] = if weak && !has_failed(k) { before + self.period } else { 0.0 };
            self.false_alarms += usize::from(before <= LASTING && self.alarmed[k] > LASTING);
        }
        if self.found.iter().all(|f| f.isolated_after.is_some()) {
            return;
        }
        // After the delay a fault is known exactly, even if it has ended by then.
        if let Detection::After(delay) = self.detection {
            let due = self.found.iter_mut().filter(|f| f.detected_after.is_none() && t + SAME_INSTANT >= f.at + delay);
            due.for_each(|f| {
                let after = Some((t - f.at).max(0.0));
                (f.detected_after, f.isolated_after) = (after, after);
            });
            return;
        }
        let is_close = |k: usize| {
            let ((c, stuck), (b, known_stuck)) = (truth(k), believed(k));
            if stuck { known_stuck || b < SOUND } else { (c - b).abs() <= CLOSE }
        };
        let all_close = (0..n).all(is_close);
        for (index, (found, strike)) in self.found.iter_mut().zip(self.strikes).enumerate() {
            if strike.until.is_some_and(|end| end <= t) {
                continue;
            }
            // A loss that was believed before the fault is not a detection.
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

    /// Commands rotors that the estimator believes lost to turn as in hover (rad/s). The allocation does not use their
    /// thrust; if one produces thrust after all, the estimator sees it.
    pub(super) fn probe(&self, command: &mut [f64]) {
        if self.estimator.is_none() {
            return;
        }
        for (k, speed) in command.iter_mut().enumerate() {
            if self.belief.capacity[k] == 0.0 {
                *speed = self.hover_speed[k];
            }
        }
    }

    /// Sets the commands (rad/s) that hold from now on.
    pub(super) fn command(&mut self, command: &[f64]) {
        self.command.copy_from_slice(command);
    }

    /// Sets the modelled speeds to the commands, as at the start of a flight.
    pub(super) fn settle(&mut self) {
        self.modelled.copy_from_slice(&self.command);
        if let Some(estimator) = &mut self.estimator {
            estimator.settle(&self.modelled);
        }
    }

    /// The thrust of the rotors by modelled speeds and believed capacities, N.
    pub(super) fn thrust(&self) -> f64 {
        let rotors = self.belief.capacity.iter().zip(&self.thrust_coefficient).zip(&self.modelled);
        rotors.map(|((theta, b), w)| theta * b * w * w.abs()).sum()
    }

    /// Whether yaw is given up after the last fault that has struck by `t` s; by the plan's word if none has.
    pub(super) fn gives_up_yaw(&self, t: f64) -> GiveUpYaw {
        let struck = self.strikes.iter().rev().find(|strike| strike.at <= t + SAME_INSTANT);
        struck.map_or(self.model.plan.without_yaw, |strike| self.model.gives_up_yaw(strike.mode))
    }

    /// The mean time constant of the rotors that are believed to give thrust, s.
    pub(super) fn lag(&self) -> f64 {
        let rotors = self.model.vehicle.rotors.iter().zip(&self.belief.capacity);
        let working = rotors.filter(|(_, capacity)| **capacity > 0.0);
        let (count, sum) = working.fold((0, 0.0), |(count, sum), (rotor, _)| (count + 1, sum + rotor.lag()));
        if count == 0 { 0.0 } else { sum / f64::from(count) }
    }

    /// Rank and condition number of the estimator's regressor; `None` without an estimator or before its first sample.
    pub(super) fn conditioning(&mut self) -> Option<(usize, f64)> {
        self.estimator.as_mut().and_then(Estimator::conditioning)
    }

    /// The estimated capacities; the believed ones without an estimator.
    pub(super) fn estimated(&self) -> &[f64] {
        self.estimator.as_ref().map_or(&self.belief.capacity, |e| &e.capacity)
    }

    /// The detections, the number of false alarms and the number of rejected estimates.
    pub(super) fn finish(self) -> (Vec<FaultDetection>, usize, usize) {
        (self.found, self.false_alarms, self.refused)
    }
}
