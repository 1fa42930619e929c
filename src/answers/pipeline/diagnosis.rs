//! `diagnose`: a log, the vehicle that it is of, and what the losses in it leave of the vehicle.

use crate::admissible::AdmissibleSet;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnosis::aftermath::Aftermath;
use crate::diagnosis::capacity::{Capacity, student};
use crate::diagnosis::fit::{Effect, effects};
use crate::diagnosis::record::{Autopilot, MOTORS, Record};
use crate::diagnosis::study::{Kind, Loss, Study, study};
use crate::diagnostic::Diagnostic;
use crate::flight::equilibrium::analyze_each;
use crate::log::{self, MISSING, Unreadable};
use crate::model::{FaultMode, Model, RotorState, Spread};
use crate::report::diagnosis::{Against, Diagnosis};
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

/// Why there is no diagnosis.
pub enum Undiagnosed {
    /// The first is the error.
    Not(Vec<Diagnostic>),
    Io(io::Error),
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
    let vehicle =
        Vehicle::of(&record, spec).map_err(|error| Undiagnosed::Not([vec![*error], diagnostics.clone()].concat()))?;
    diagnostics.extend(vehicle.warnings.iter().cloned());
    let found = vehicle.study(&record, hidden).map_err(|error| Undiagnosed::Not(vec![*error]))?;
    let model = vehicle.model(found.as_ref());
    let losses = found.as_ref().map_or(&[][..], |study| &study.losses);
    let (after, sets) = (1..=losses.len()).map(|n| analysis(&model, &vehicle.motors, &losses[..n])).unzip();
    let mut good: Vec<Vec<Capacity>> = Vec::new();
    for other in baseline.iter_mut() {
        let (record, _) = read(other.as_mut())?;
        let study = vehicle.study(&record, &[]).map_err(|error| Undiagnosed::Not(vec![*error]))?;
        good.extend(study.and_then(|study| study.capacities));
    }
    let own = found.as_ref().and_then(|study| study.capacities.as_ref());
    let against = own.filter(|_| !baseline.is_empty()).map(|own| compare(own, &good));
    let rate = |period: f64| if period.is_finite() { 1.0 / period } else { 0.0 };
    let rates = [rate(record.outputs.period()), rate(record.rates.period())];
    let mut unknown = too_slow(&record, found.as_ref(), rates);
    if !baseline.is_empty() && good.len() < 2 {
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
        rates,
        baseline: against.filter(|_| good.len() >= 2),
    };
    Ok(Diagnosed { diagnosis, record, diagnostics })
}

pub(super) fn read(log: &mut dyn Read) -> Result<(Record, Vec<Diagnostic>), Undiagnosed> {
    match log::read(log) {
        Ok(log) => Ok((log.record, log.diagnostics)),
        Err(Unreadable::Not(error)) => Err(Undiagnosed::Not(vec![*error])),
        Err(Unreadable::Io(error)) => Err(Undiagnosed::Io(error)),
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
            Some(spec) => (None, spec.clone(), Vec::new()),
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

    /// Effects in the order of the log's motors.
    fn effects(&self) -> Vec<Effect> {
        let of_rotors = effects(&self.spec.model().vehicle);
        let mut of_motors = of_rotors.clone();
        self.motors.iter().zip(of_rotors).for_each(|(motor, effect)| of_motors[*motor] = effect);
        of_motors
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

/// Capacities against those of good flights. The spread between flights is taken as that of all rotors alike, because a
/// few flights show too little of each.
fn compare(own: &[Capacity], good: &[Vec<Capacity>]) -> Vec<Against> {
    let (n, flights) = (own.len(), good.len() as f64);
    let means: Vec<f64> = (0..n).map(|k| good.iter().map(|flight| flight[k].value).sum::<f64>() / flights).collect();
    let squares: f64 =
        good.iter().flat_map(|flight| flight.iter().zip(&means)).map(|(c, m)| (c.value - m).powi(2)).sum();
    let freedom = n * good.len().saturating_sub(1);
    let variance = squares / freedom.max(1) as f64;
    let half = student(freedom) * (variance * (1.0 + 1.0 / flights)).sqrt();
    let against = |(motor, capacity): (usize, &Capacity)| Against {
        motor,
        mean: means[motor],
        change: capacity.value - means[motor],
        half,
    };
    own.iter().enumerate().map(against).collect()
}

/// What the log does not show, with the parameter to set. Sources: ArduPilot's documentation of `LOG_BITMASK`, PX4's of
/// `SDLOG_PROFILE`.
fn too_slow(record: &Record, study: Option<&Study>, [outputs, rates]: [f64; 2]) -> Vec<String> {
    let mut found = Vec::new();
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
        } else if !study.is_searched {
            found.push(
                "the motion was not searched: the flight is too short, or fewer than four outputs are known".into(),
            );
        }
    }
    found
}
