//! Logs of simulated flights as other tools read them.

mod layouts;
mod mcap;
mod ulog;

use crate::flight::Sample;
use crate::model::Model;
use crate::report::simulation::{Log, Thinning};

/// A format of flight logs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// mavc's table.
    #[default]
    Csv,
    /// MCAP with JSON, for Foxglove.
    Mcap,
    /// The format of PX4's logs, for PlotJuggler and pyulog.
    Ulog,
}

/// Every format with its name.
pub const FORMATS: [(Format, &str); 3] = [(Format::Csv, "csv"), (Format::Mcap, "mcap"), (Format::Ulog, "ulog")];

/// A log that is written sample by sample.
pub enum Recorder {
    Csv(Log),
    Rows(Rows),
}

/// The rows of a flight.
pub struct Rows {
    format: Format,
    thinning: Thinning,
    motors: Motors,
    rows: Vec<Row>,
}

/// The state of a flight at an instant; world x east, y north, z up, body x forward, y left, z up, SI units.
struct Row {
    time: f64,
    position: [f64; 3],
    velocity: [f64; 3],
    /// From body to world: w, x, y, z.
    attitude: [f64; 4],
    /// Roll, pitch, yaw.
    angles: [f64; 3],
    rates: [f64; 3],
    reference: [f64; 3],
    reference_velocity: [f64; 3],
    reference_yaw: [f64; 2],
    error: f64,
    heading_error: f64,
    tilt: f64,
    /// Thrust and torques that the rotors produce.
    wrench: [f64; 4],
    /// Those that the controller demands.
    demanded: [f64; 4],
    /// Speed (rad/s), capacity as estimated and capacity as the allocation believes, of each rotor.
    rotors: Vec<[f64; 3]>,
    /// The command of each motor by its number, as a share of full speed; `None` for more motors than PX4 has.
    commands: Option<[f64; MOST_MOTORS]>,
    /// Readings of gyroscope (rad/s) and accelerometer (m/s^2).
    inertial: [[f64; 3]; 2],
    /// Rank and condition number of the estimator's regressor.
    regressor: Option<[f64; 2]>,
}

/// The motors of `actuator_motors` of PX4.
const MOST_MOTORS: usize = 12;

/// Where the commands of a vehicle's rotors are among those of its motors.
#[derive(Debug, Clone, Default)]
struct Motors {
    /// The motor (from 0) and the full speed (rad/s) of each rotor; empty for a vehicle with more than [`MOST_MOTORS`].
    of_rotors: Vec<(usize, f64)>,
}

impl Motors {
    fn of(model: &Model) -> Self {
        let rotors = &model.vehicle.rotors;
        let numbers = model.vehicle.motors().unwrap_or_else(|| (1..=rotors.len() as u32).collect());
        let places = numbers.iter().map(|number| (*number as usize).wrapping_sub(1));
        let of_rotors: Vec<(usize, f64)> = places.zip(rotors.iter().map(|rotor| rotor.max_speed)).collect();
        let fits = of_rotors.iter().all(|(motor, _)| *motor < MOST_MOTORS);
        Motors { of_rotors: if fits { of_rotors } else { Vec::new() } }
    }

    /// The commanded speeds (rad/s) as shares of full speed, by motor; NaN where there is none.
    fn shares(&self, commands: &[f64]) -> Option<[f64; MOST_MOTORS]> {
        let mut shares = [f64::NAN; MOST_MOTORS];
        self.of_rotors.iter().zip(commands).for_each(|((motor, full), speed)| shares[*motor] = speed / full);
        (!self.of_rotors.is_empty()).then_some(shares)
    }
}

impl Recorder {
    /// A log in a format, with rows at about `rate` Hz of a flight of at most `duration` s.
    ///
    /// # Errors
    /// The log would have too many numbers.
    pub fn new(format: Format, model: &Model, rate: Option<f64>, duration: f64) -> Result<Self, String> {
        let log = Log::at(model, rate, duration)?;
        Ok(match format {
            Format::Csv => Recorder::Csv(log),
            _ => {
                let motors = Motors::of(model);
                Recorder::Rows(Rows { format, thinning: log.thinning, motors, rows: Vec::new() })
            }
        })
    }

    /// A message if the rate is not the requested one.
    pub fn remark(&self) -> Option<&str> {
        match self {
            Recorder::Csv(log) => log.thinning.remark.as_deref(),
            Recorder::Rows(rows) => rows.thinning.remark.as_deref(),
        }
    }

    /// Adds a row if one is due, or if the sample is the last.
    pub fn add(&mut self, sample: &Sample) {
        match self {
            Recorder::Csv(log) => log.add(sample),
            Recorder::Rows(Rows { thinning, motors, rows, .. }) => {
                if thinning.is_due(sample) {
                    rows.push(Row::of(sample, motors));
                }
            }
        }
    }

    /// The log's bytes.
    pub fn finish(self) -> Vec<u8> {
        match self {
            Recorder::Csv(log) => log.csv.into_bytes(),
            Recorder::Rows(Rows { format: Format::Ulog, rows, .. }) => ulog::bytes(&rows),
            Recorder::Rows(Rows { rows, .. }) => mcap::bytes(&rows),
        }
    }
}

/// A layout that shows a log of a vehicle with so many rotors: XML for PlotJuggler, JSON for Foxglove.
///
/// # Errors
/// The format has none.
pub fn layout(format: Format, rotors: usize) -> Result<String, String> {
    match format {
        Format::Csv => Err("--format csv has no layout: --layout is for mcap (Foxglove) and ulog (PlotJuggler)".into()),
        Format::Mcap => Ok(layouts::foxglove(rotors)),
        Format::Ulog => Ok(layouts::plotjuggler(rotors)),
    }
}

impl Row {
    fn of(sample: &Sample, motors: &Motors) -> Self {
        let Sample { body, reference, .. } = sample;
        let q = body.attitude;
        let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
        let rotors = sample.speeds.iter().zip(sample.estimated).zip(sample.believed);
        Row {
            time: sample.time,
            position: body.position.into(),
            velocity: body.velocity.into(),
            attitude: [q.w, q.i, q.j, q.k].map(|part| sign * part),
            angles: body.angles(),
            rates: body.rates.into(),
            reference: reference.position.into(),
            reference_velocity: reference.velocity.into(),
            reference_yaw: [reference.yaw[0], reference.yaw[1]],
            error: (body.position - reference.position).norm(),
            heading_error: sample.heading.error(),
            tilt: body.tilt(),
            wrench: (*sample.wrench).into(),
            demanded: (*sample.wanted).into(),
            rotors: rotors.map(|((speed, estimated), believed)| [*speed, *estimated, *believed]).collect(),
            commands: motors.shares(sample.commands),
            inertial: [sample.inertial.rates.into(), sample.inertial.force.into()],
            regressor: sample.regressor.map(|(rank, condition)| [rank as f64, condition]),
        }
    }
}
