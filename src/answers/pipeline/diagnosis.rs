//! `diagnose`: a log, the vehicle that it is of, and what the losses in it leave of the vehicle.

use super::baseline::Baseline;
use crate::admissible::AdmissibleSet;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnosis::aftermath::Aftermath;
use crate::diagnosis::ending::{End, Flight};
use crate::diagnosis::fit::{Effect, effects};
use crate::diagnosis::record::{Autopilot, MOTORS, Record};
use crate::diagnosis::study::{Evidence, Kind, Loss, SHORTEST, Study, study};
use crate::diagnostic::Diagnostic;
use crate::flight::equilibrium::analyze_each;
use crate::log::{self, MISSING, Unreadable};
use crate::model::{FaultMode, Model, RotorState, Spread};
use crate::number::fixed;
use crate::report::diagnosis::Diagnosis;
use crate::source::Span;
use crate::spec::Spec;
use std::io::{self, Read};

/// A diagnosis, with the warnings about the log.
pub struct Diagnosed {
    pub diagnosis: Diagnosis,
    /// What was read.
    pub record: Record,
    pub diagnostics: Vec<Diagnostic>,
}

/// Why there is no diagnosis, and of which log: one of the baseline (from 0), or the log itself.
pub struct Undiagnosed {
    pub baseline: Option<usize>,
    pub why: Why,
}

/// Why nothing can be said of a log.
pub enum Why {
    /// The first is the error.
    Not(Vec<Diagnostic>),
    Io(io::Error),
    /// What was given beside the log cannot be used.
    Argument(String),
}

impl From<Why> for Undiagnosed {
    fn from(why: Why) -> Self {
        Undiagnosed { baseline: None, why }
    }
}

/// Figures of a vehicle that no log has, by field: they do not change what is asked.
pub(super) const FIGURES: [(&str, &str); 7] = [
    ("arm", "25 cm"),
    ("mass", "1 kg"),
    ("inertia", "[0.01, 0.01, 0.02] kg*m^2"),
    ("max_thrust", "10 N"),
    ("torque_per_thrust", "15 mm"),
    ("max_speed", "8000 rpm"),
    ("spin", "P"),
];
/// A motor is where a log has it if the cosine of the angle between the axes about which it turns the vehicle is so
/// large: 26 degrees, half of the angle between the motors of an octocopter.
const SAME_PLACE: f64 = 0.9;
/// A vehicle that turns more slowly than this hardly turns, rad/s.
const LEVEL: f32 = 0.7;
/// More samples than this with times before those of earlier ones are those of another flight.
const MANY: u64 = 100;
/// The share of full thrust in hover where the log shows none.
const HOVER: f64 = 0.5;

/// Reads a log and says which rotors lost thrust in it. `spec` is the vehicle's, `hidden` are motors (from 1) whose
/// outputs are not looked at, `baseline` logs of good flights of the same vehicle.
///
/// # Errors
/// The log cannot be read or is not one, or nothing says where the motors are.
pub fn diagnose(
    log: &mut dyn Read,
    spec: Option<&Spec>,
    hidden: &[usize],
    baseline: &mut [Box<dyn Read>],
) -> Result<Diagnosed, Undiagnosed> {
    let (record, mut diagnostics) = read(log)?;
    let vehicle = Vehicle::of(&record, spec).map_err(|error| Why::Not([vec![*error], diagnostics.clone()].concat()))?;
    diagnostics.extend(vehicle.warnings.iter().cloned().chain(log::assumed(&record)));
    let mut found = vehicle.study(&record, hidden).map_err(|error| Why::Not(vec![*error]))?;
    let model = vehicle.model(found.as_ref());
    if let Some(study) = &mut found {
        withdraw(study, &record, &model, &vehicle.motors);
    }
    let losses = found.as_ref().map_or(&[][..], |study| &study.losses);
    let (after, sets) = (1..=losses.len()).map(|n| analysis(&model, &vehicle.motors, &losses[..n])).unzip();
    let mut good = Baseline::new(&record, found.as_ref());
    for (k, other) in baseline.iter_mut().enumerate() {
        good.take(&vehicle, other.as_mut()).map_err(|why| Undiagnosed { baseline: Some(k), why })?;
    }
    let mut unknown = unknown_of(&record, found.as_ref());
    if baseline.len() == 1 {
        unknown.push("one baseline flight gives no spread: name two or more, of the same load".into());
    }
    let flights = found.as_ref().map_or(&[][..], |study| &study.flights);
    let aftermath = Aftermath::of(&record, flights, losses);
    let diagnosis = Diagnosis {
        autopilot: record.autopilot,
        model,
        motors: vehicle.motors,
        study: found,
        after,
        sets,
        aftermath,
        unknown,
        rates: rates(&record),
        is_partial: record.late > MANY,
        baseline: good.against(),
    };
    Ok(Diagnosed { diagnosis, record, diagnostics })
}

pub(super) fn read(log: &mut dyn Read) -> Result<(Record, Vec<Diagnostic>), Why> {
    match log::read(log) {
        Ok(log) => Ok((log.record, log.diagnostics)),
        Err(Unreadable::Not(error)) => Err(Why::Not(vec![*error])),
        Err(Unreadable::Io(error)) => Err(Why::Io(error)),
    }
}

/// The vehicle of a log.
pub(super) struct Vehicle {
    /// The text of its frame with `?`, if there is no spec.
    pub frame: Option<String>,
    spec: Spec,
    /// The log's motor (from 0) of each rotor.
    pub motors: Vec<usize>,
    pub warnings: Vec<Diagnostic>,
}

pub(super) fn missing(message: impl Into<String>, help: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(MISSING, Span::default(), message.into()).help(help))
}

impl Vehicle {
    pub fn of(record: &Record, spec: Option<&Spec>) -> Result<Self, Box<Diagnostic>> {
        let (frame, spec, warnings) = match spec {
            Some(spec) => (None, spec.clone(), contradiction(record, &spec.model().vehicle).into_iter().collect()),
            None => {
                let (text, warnings) = log::frame(record)?;
                let figures: Vec<(&str, String)> = FIGURES.map(|(name, value)| (name, value.to_string())).into();
                let spec = log::filled(&text, &figures).map_err(|why| {
                    missing(format!("the frame of the log cannot be used: {why}"), "name the spec of the vehicle")
                })?;
                (Some(text), spec, warnings)
            }
        };
        let vehicle = &spec.model().vehicle;
        let n = vehicle.rotors.len();
        let numbers = vehicle.motors().filter(|_| !record.is_by_rotor).unwrap_or_else(|| (1..=n as u32).collect());
        let motors: Vec<usize> = numbers.iter().map(|m| (*m as usize).wrapping_sub(1)).collect();
        let mut sorted = motors.clone();
        sorted.sort_unstable();
        if n > MOTORS || !sorted.iter().copied().eq(0..n) {
            let message = format!("the motors of the spec are not numbered 1 to {n}, at most {MOTORS}");
            return Err(missing(message, "give each rotor the number of its motor in the autopilot: `motor 3`"));
        }
        Ok(Vehicle { frame, spec, motors, warnings })
    }

    /// The mean lever of the rotors' thrusts about the axis of roll or pitch, in arms.
    pub fn mean_lever(&self, axis: usize) -> f64 {
        let rotors = &self.spec.model().vehicle.rotors;
        let longest = rotors.iter().map(|rotor| rotor.position[0].hypot(rotor.position[1])).fold(0.0, f64::max);
        let sum: f64 = rotors.iter().map(|rotor| rotor.position[1 - axis].abs()).sum();
        sum / rotors.len() as f64 / longest
    }

    /// Effects in the order of the log's motors.
    pub fn effects(&self) -> Vec<Effect> {
        in_order(effects(&self.spec.model().vehicle), &self.motors)
    }

    /// What the log says; `hidden` are motors from 1.
    pub fn study(&self, record: &Record, hidden: &[usize]) -> Result<Option<Study>, Box<Diagnostic>> {
        let n = self.motors.len();
        if let Some(wrong) = hidden.iter().find(|motor| !(1..=n).contains(motor)) {
            return Err(missing(format!("there is no motor {wrong}: the vehicle has {n}"), "name one of its motors"));
        }
        let hidden: Vec<usize> = hidden.iter().map(|motor| motor - 1).collect();
        let commands = log::commands(record);
        let rows = record.outputs.len();
        let dead: Vec<usize> = (0..n).filter(|k| !(0..rows).any(|row| commands(row, *k).0 > 0.0)).collect();
        if record.outputs.is_empty() {
            return Ok(None);
        }
        if dead.len() == n {
            return Ok(study(record, &commands, &self.effects(), &hidden));
        }
        if let [motor, ..] = dead[..] {
            let message = format!("the log has no output of motor {}, and the vehicle has {n} motors", motor + 1);
            let help = match record.autopilot {
                Autopilot::ArduPilot => "check `FRAME_CLASS` and `SERVOn_FUNCTION`, or name the spec of the vehicle",
                _ => "check `CA_ROTOR_COUNT` and the functions of the outputs, or name the spec of the vehicle",
            };
            return Err(missing(message, help));
        }
        Ok(study(record, &commands, &self.effects(), &hidden))
    }

    /// The model with the thrust that the log shows in hover: of a frame without figures the mass is made to fit.
    fn model(&self, study: Option<&Study>) -> Model {
        let mut model = self.spec.model().clone();
        let hover = study.and_then(|study| study.hover).filter(|hover| *hover > 0.02 && *hover < 1.0).unwrap_or(HOVER);
        if self.frame.is_some() {
            let actuation = crate::actuation::Actuation::of(&model.vehicle);
            let full: f64 = (0..actuation.rotors()).map(|k| actuation.full(k)[0]).sum();
            model.vehicle.mass = full * hover / model.gravity;
        }
        model
    }
}

/// What rotors have, in the order of their motors (from 0).
fn in_order<T: Clone>(of_rotors: Vec<T>, motors: &[usize]) -> Vec<T> {
    let mut of_motors = of_rotors.clone();
    motors.iter().zip(of_rotors).for_each(|(motor, of_rotor)| of_motors[*motor] = of_rotor);
    of_motors
}

/// A warning if a spec has its motors elsewhere than the parameters of the log, or turning the other way.
fn contradiction(record: &Record, spec: &crate::model::Vehicle) -> Option<Diagnostic> {
    let (text, assumed) = log::frame(record).ok()?;
    let figures: Vec<(&str, String)> = FIGURES.map(|(name, value)| (name, value.to_string())).into();
    let frame = log::filled(&text, &figures).ok().filter(|_| assumed.is_empty() && !record.is_by_rotor)?;
    let help = "the spec counts; name that of the vehicle that flew, with the numbers of its motors";
    let warning = |message: String| Some(Diagnostic::warning(log::ASSUMED, Span::default(), message).help(help));
    let [own, logged] = [spec, &frame.model().vehicle].map(|vehicle| {
        let n = vehicle.rotors.len();
        let motors = vehicle.motors().unwrap_or_else(|| (1..=n as u32).collect());
        let motors: Vec<usize> = motors.iter().map(|m| (*m as usize).wrapping_sub(1)).collect();
        let is_whole = motors.iter().all(|motor| *motor < n);
        if is_whole { in_order(effects(vehicle), &motors) } else { Vec::new() }
    });
    if own.len() != logged.len() {
        return warning(format!("the spec has {} motors, and the log's parameters {}", own.len(), logged.len()));
    }
    let differs = |k: &usize| {
        let [a, b] = [own[*k], logged[*k]];
        let along = a[1] * b[1] + a[2] * b[2];
        along < SAME_PLACE * (a[1].hypot(a[2]) * b[1].hypot(b[2])) || a[3] * b[3] < 0.0
    };
    let others: Vec<String> = (0..own.len()).filter(differs).map(|k| (k + 1).to_string()).collect();
    let message = format!(
        "the log's parameters have {} {} elsewhere than the spec, or turning the other way",
        if others.len() == 1 { "motor" } else { "motors" },
        others.join(", ")
    );
    (!others.is_empty()).then(|| warning(message))?
}

/// Takes back losses that only the motion shows, after which the vehicle could not hover but flew on level.
fn withdraw(study: &mut Study, record: &Record, model: &Model, motors: &[usize]) {
    let mut kept: Vec<Loss> = Vec::new();
    for loss in std::mem::take(&mut study.losses) {
        let is_refuted = loss.evidence == Evidence::Motion && flies_level_after(record, &study.flights, loss.time) && {
            let all: Vec<Loss> = kept.iter().cloned().chain([loss.clone()]).collect();
            !matches!(analysis(model, motors, &all).0.outcome, Outcome::FullControl | Outcome::FliesOn)
        };
        if !is_refuted {
            kept.push(loss);
        }
    }
    study.losses = kept;
}

/// Whether a vehicle flew on for 3 s after a time, s, or until the log ends, hardly turning.
fn flies_level_after(record: &Record, flights: &[Flight], time: f64) -> bool {
    let Some(flight) = flights.iter().find(|flight| flight.from < time && flight.to > time) else { return false };
    let [from, to] = [time + 0.2, flight.to.min(time + 3.0)];
    if to - from < 0.5 || to == flight.to && flight.end != End::Open {
        return false;
    }
    let rates = record.rates.within(from, to);
    let turns = |rates: &[f32; 3]| rates.iter().any(|rate| rate.abs() > LEVEL);
    let many = rates.iter().filter(|rates| turns(rates)).count();
    !rates.is_empty() && 20 * many < rates.len()
}

/// What some losses leave of a vehicle, and its set of wrenches.
fn analysis(model: &Model, motors: &[usize], losses: &[Loss]) -> (ModeAnalysis, AdmissibleSet) {
    let state = |motor: &usize| {
        losses.iter().rfind(|loss| loss.motor == *motor).map_or(RotorState::Sound, |loss| match loss.kind {
            Kind::Held => RotorState::Stuck(loss.capacity),
            Kind::Lost | Kind::Off => RotorState::Lost,
            Kind::Reduced => RotorState::of_capacity(loss.capacity),
        })
    };
    let mode = FaultMode {
        name: "after".into(),
        title: None,
        doc: None,
        rotors: motors.iter().map(state).collect(),
        severity: None,
        occurrence: None,
        detection: None,
        rate: None,
        rate_spread: Spread::NONE,
        after_fault: None,
        without_yaw: None,
        recovery: None,
        span: Span::default(),
    };
    let model = Model { modes: vec![mode], ..model.clone() };
    (analyze_each(&model).pop().expect("healthy and one mode"), AdmissibleSet::of_mode(&model, 0))
}

/// How often outputs of motors and rates of turn are logged, Hz; 0 where they are not.
fn rates(record: &Record) -> [f64; 2] {
    [record.outputs.period(), record.rates.period()].map(|period| if period.is_finite() { 1.0 / period } else { 0.0 })
}

/// What the log does not show, with the parameter to set. Sources: ArduPilot's documentation of `LOG_BITMASK`, PX4's of
/// `SDLOG_PROFILE`.
pub(super) fn unknown_of(record: &Record, study: Option<&Study>) -> Vec<String> {
    let [outputs, rates] = rates(record);
    let mut found = Vec::new();
    if record.late > MANY {
        found.push(format!(
            "{} samples have times before those of earlier ones: split the log where the autopilot was started",
            record.late
        ));
    }
    let set = match record.autopilot {
        Autopilot::ArduPilot => "set bits 10 (motor outputs) and 7 (IMU) of LOG_BITMASK, and bit 0 (fast attitude)",
        _ => "set SDLOG_PROFILE to 16 (high rate) beside 1 (default)",
    };
    if outputs == 0.0 {
        found.push(format!("the log has no outputs of motors: {set}"));
    } else if rates == 0.0 {
        found.push(format!("the log has no rates of turn: {set}"));
    } else if study.is_none() {
        found.push(format!(
            "outputs at {outputs:.1} Hz and rates of turn at {rates:.1} Hz are too slow: at least 4 Hz: {set}"
        ));
    } else if let Some(study) = study {
        if study.flights.is_empty() {
            found.push("the log has no flight of 2 s or more".into());
        } else if !study.is_determined {
            found.push("fewer than four outputs are known, so that the motion cannot be searched for losses".into());
        }
        let spins = study.flights.iter().find(|flight| flight.has_crashed_in_a_spin());
        if let Some(flight) = spins.filter(|_| study.losses.is_empty()) {
            let time = fixed(flight.to, 1);
            found.push(format!(
                "the flight ends at {time} s in a fast turn and an impact, which no loss of one motor explains"
            ));
        }
        let short = study.flights.iter().zip(&study.searched).filter(|(_, searched)| searched.is_none());
        let short: Vec<String> =
            short.map(|(flight, _)| format!("from {} to {} s", fixed(flight.from, 1), fixed(flight.to, 1))).collect();
        if study.is_determined && !short.is_empty() {
            let flights = if short.len() == 1 { "flight" } else { "flights" };
            let which = short.join(", ");
            let least = fixed(SHORTEST, 1);
            found.push(format!("too short to search the motion, which takes {least} s: {flights} {which}"));
        }
    }
    found
}
