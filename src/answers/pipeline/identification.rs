//! `identify`: the spec of the vehicle that flew, from the frame and the flight of a log.

use super::diagnosis::{FIGURES, Undiagnosed, Vehicle, Why, missing, read, unknown_of};
use crate::diagnosis::capacity::student;
use crate::diagnosis::fit::Fit;
use crate::diagnosis::record::Record;
use crate::diagnosis::samples::Samples;
use crate::diagnosis::study::Study;
use crate::diagnostic::Diagnostic;
use crate::import::unknown;
use crate::log;
use crate::number::{fixed, significant};
use std::io::Read;

/// A spec that was identified.
pub struct Identified {
    /// The text of the spec; what the flight does not show stands as `?`.
    pub text: String,
    /// The figures that were identified or are missing, in the order of the text.
    pub figures: Vec<Figure>,
    pub diagnostics: Vec<Diagnostic>,
}

/// A figure of an identified spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The path by which `--set` sets it: `vehicle.rotor.max_thrust`.
    pub field: String,
    /// In SI units: the value, and the ends of its 95 % interval if the flight gives one; `None` stands as `?`.
    pub value: Option<(f64, Option<[f64; 2]>)>,
    /// Where it is from, or which flight or measurement would show it.
    pub remark: String,
}

/// Length of the parts of a flight whose spread gives the interval, s.
const PART: f64 = 2.0;
/// Half of the relative interval of full thrust by the thrust curve alone: `MOT_THST_EXPO` and `THR_MDL_FAC` are
/// seldom measured better.
const CURVE: f64 = 0.03;
/// Windows of at most this length show the time constant of rotors and the inertia, s, on axes of which the commands
/// explain so much: with less, gusts that the autopilot counters and noise that it follows bias both.
const FAST_WINDOWS: f64 = 0.03;
const WELL: f64 = 0.9;

/// Help where the frame is missing or cannot be used.
const FRAME: &str = "identify takes the frame from the log's parameters, FRAME_CLASS and FRAME_TYPE or CA_ROTOR*";

/// Writes the spec of the vehicle of a log. `mass` is a quantity as in a spec: `1.5 kg`.
///
/// # Errors
/// The log cannot be read or is not one, nothing says where the motors are, it has no flight, or the mass is not one.
pub fn identify(source: &mut dyn Read, mass: &str) -> Result<Identified, Undiagnosed> {
    let (record, mut diagnostics) = read(source)?;
    let not = |error: Box<Diagnostic>| Undiagnosed::from(Why::Not(vec![*error]));
    let of_frame = |error: Box<Diagnostic>| not(Box::new(error.help(FRAME)));
    let vehicle = Vehicle::of(&record, None).map_err(of_frame)?;
    diagnostics.extend(vehicle.warnings.iter().cloned().chain(log::assumed(&record)));
    let frame = vehicle.frame.clone().unwrap_or_default();
    let mut figures: Vec<(&str, String)> = FIGURES.map(|(name, value)| (name, value.to_string())).into();
    figures.iter_mut().filter(|(name, _)| *name == "mass").for_each(|(_, value)| *value = mass.to_string());
    let weighed = log::filled(&frame, &figures)
        .map_err(|why| Why::Argument(format!("mass {mass}: {why}; give it with its unit, such as 1.5kg")))?;
    let kilograms = weighed.model().vehicle.mass;
    let study = vehicle.study(&record, &[]).map_err(not)?;
    let Some(study) = study.as_ref().filter(|study| study.fit.is_some()) else {
        let why = unknown_of(&record, study.as_ref()).into_iter().next();
        let why = why.unwrap_or("the log shows no flight of 2 s or more".into());
        return Err(not(missing(why, "name the log of a flight with a hover")));
    };
    let (text, figures) = written(&frame, &record, &vehicle, study, mass, kilograms);
    Ok(Identified { text, figures, diagnostics })
}

/// The specific force for each unit of command: its mean and half of its 95 % interval, by parts of the flight.
fn thrust_per_command(samples: &Samples, fit: &Fit, study: &Study) -> Option<(f64, f64)> {
    let until = study.losses.first().map_or(f64::INFINITY, |loss| loss.interval[0]);
    let windows = ((PART / samples.step).round() as usize).max(4);
    let flies = |i: &usize| {
        let t = samples.samples[*i].time;
        t < until && study.flights.iter().any(|flight| t > flight.from + 1.5 && t < flight.to - 1.5)
    };
    let inside: Vec<usize> = (0..samples.samples.len()).filter(flies).collect();
    let of_part = |part: &[usize]| {
        let force: f64 = part.iter().map(|i| samples.samples[*i].force).sum();
        let command: f64 = part.iter().map(|i| fit.commands[*i].iter().sum::<f64>()).sum();
        force / command
    };
    let parts: Vec<f64> = inside.chunks(windows).filter(|p| p.len() == windows).map(of_part).collect();
    let parts: Vec<f64> = parts.into_iter().filter(|x| x.is_finite() && *x > 0.0).collect();
    let n = parts.len() as f64;
    let mean = parts.iter().sum::<f64>() / n;
    let variance = parts.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    (parts.len() >= 3).then(|| (mean, student(parts.len() - 1) * (variance / n).sqrt()))
}

/// The text of the spec with its figures.
fn written(
    frame: &str,
    record: &Record,
    vehicle: &Vehicle,
    study: &Study,
    mass: &str,
    kilograms: f64,
) -> (String, Vec<Figure>) {
    let n = vehicle.motors.len();
    let commands = log::commands(record);
    let samples = Samples::of(record, n, &|row, motor| commands(row, motor).0);
    let fit = study.fit.as_ref();
    let thrust = samples.as_ref().zip(fit).and_then(|(samples, fit)| thrust_per_command(samples, fit, study));
    let thrust = thrust.map(|(mean, half)| (mean * kilograms, (half / mean).hypot(CURVE)));
    let quick = fit.zip(samples.as_ref()).filter(|_| study.step <= FAST_WINDOWS);
    let quick = quick.map(|(fit, samples)| fit.refined(samples, &vehicle.effects(), study.range));
    let quick = quick.as_ref();
    let lag = quick.filter(|fit| fit.lag > 0.0 && fit.explained[..2].iter().all(|e| *e > WELL));
    let figure = |name: &str| match name {
        "mass" => Some((mass.to_string(), (kilograms, None), "as given".to_string())),
        "max_thrust" => thrust.map(|(newton, relative)| {
            let relative = relative.max(0.001);
            let text = format!("{} N +- {} %", significant(newton, 3), fixed(100.0 * relative, 1));
            let interval = [newton * (1.0 - relative), newton * (1.0 + relative)];
            (text, (newton, Some(interval)), "from the accelerometer and the commands in flight".to_string())
        }),
        _ => None,
    };
    let hint = |name: &str| match name {
        "arm" => Some("measure it: from the middle of the frame to a motor".into()),
        "inertia" => Some(turning(quick, thrust, vehicle)),
        "torque_per_thrust" => {
            Some("not from one flight: a turn shows only its ratio to Izz; measure on a stand".into())
        }
        "max_speed" => Some("log the speed of the rotors (ESC telemetry) in a climb at full thrust".into()),
        "max_thrust" => Some("hover for 15 s with the accelerometer logged".into()),
        _ => None,
    };
    let mut out = String::new();
    let mut figures = Vec::new();
    // The figures of single rotors have no path and no hint.
    let mut paths = unknown::paths(frame).into_iter().peekable();
    for line in frame.lines() {
        let code = line.split("//").next().unwrap_or(line);
        let name = code.trim().trim_start_matches("let ").split('=').next().unwrap_or("").trim();
        match code.trim_end().strip_suffix('?') {
            Some(head) => {
                let (text, value, remark) = match figure(name) {
                    Some((text, value, remark)) => (text, Some(value), remark),
                    None => ("?".into(), None, hint(name).unwrap_or_default()),
                };
                let comment = if remark.is_empty() { String::new() } else { format!("  // {remark}") };
                out.push_str(&format!("{head}{text}{comment}\n"));
                if let Some(field) = paths.next_if(|path| path.rsplit('.').next() == Some(name)) {
                    figures.push(Figure { field, value, remark });
                }
            }
            None => {
                out.push_str(line);
                out.push('\n');
                if let Some(fit) = lag.filter(|_| code.trim() == "rotor {" || code.trim_end().ends_with("rotor {")) {
                    let text =
                        format!("        time_constant = {} ms  // as the vehicle turns\n", fixed(1000.0 * fit.lag, 0));
                    out.push_str(&text);
                    let (field, remark) = ("vehicle.rotor.time_constant".into(), "as the vehicle turns".into());
                    figures.push(Figure { field, value: Some((fit.lag, None)), remark });
                }
            }
        }
    }
    (out, figures)
}

/// What the flight shows of the inertia: its ratio to the arm. The commands that explain a share r of a turn bias its
/// gain g down, those that the turn explains bias it up: the truth is between g and g / r (errors in variables; also
/// where the autopilot counters a part of what disturbs the vehicle).
fn turning(fit: Option<&Fit>, thrust: Option<(f64, f64)>, vehicle: &Vehicle) -> String {
    let manoeuvre = "fly quick steps of roll and pitch in calm air, with outputs and rates logged at 100 Hz or more";
    let Some((fit, (thrust, relative))) = fit.zip(thrust) else { return manoeuvre.into() };
    let ratio = |(axis, name): (usize, &str)| {
        let gain = fit.gains[axis].filter(|_| fit.explained[axis] > WELL)?;
        let lever = vehicle.mean_lever(axis);
        let of = |gain: f64, thrust: f64| significant(thrust * lever / gain, 3);
        let ends = [of(gain / fit.explained[axis], thrust * (1.0 - relative)), of(gain, thrust * (1.0 + relative))];
        Some(format!("{name} is {} to {} kg*m times the arm", ends[0], ends[1]))
    };
    let ratios: Vec<String> = [(0, "Ixx"), (1, "Iyy")].into_iter().filter_map(ratio).collect();
    if ratios.is_empty() { manoeuvre.into() } else { ratios.join(", ") }
}
