//! What the messages of both autopilots mean: into one [`Record`], in SI units, body x forward, y left, z up.

use super::DAMAGED;
use crate::diagnosis::record::{Autopilot, MOTORS, Record, Series};
use crate::diagnostic::Diagnostic;
use crate::number::plural;
use crate::source::Span;
use std::collections::BTreeSet;

/// The most parameters of a log, each with a name of at most [`LONGEST_NAME`] bytes.
const MOST_PARAMETERS: usize = 8192;
const LONGEST_NAME: usize = 64;

/// The function of a servo output that drives ArduPilot's motor 1; motors 9 to 12 are from [`NINTH`] on.
const FIRST_FUNCTION: f64 = 33.0;
const NINTH: f64 = 82.0;

/// No output has longer pulses, us.
const LONGEST_PULSE: f64 = 3000.0;

/// Parameters that say what vehicle it is.
const FRAMES: [&str; 5] = ["FRAME", "FRAME_CLASS", "FRAME_TYPE", "CA_AIRFRAME", "CA_ROTOR_COUNT"];

/// Faster turns than this no gyroscope of an autopilot measures (ranges end at 4000 deg/s), rad/s.
const FASTEST: f64 = 100.0;

/// What could not be read.
#[derive(Debug, Default)]
pub struct Damage {
    pub messages: u64,
    /// Bytes that belong to no message.
    pub skipped: u64,
    /// Bytes of a last message that is not whole.
    pub cut: u64,
    /// Samples whose time is before that of an earlier one.
    pub late: u64,
    /// Samples of the gyroscope and of outputs beyond any range.
    pub wild: u64,
    /// Parameters of the frame that change.
    pub frames: BTreeSet<String>,
}

impl Damage {
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let warning = |message: String| Diagnostic::warning(DAMAGED, Span::default(), message);
        let mut found = Vec::new();
        if self.skipped > 0 {
            let message = format!("{} bytes of the log belong to no message and were passed over", self.skipped);
            found.push(warning(message).help("copy the log from the card again, if it is not damaged there"));
        }
        if self.cut > 3 {
            let message = "the log ends within a message";
            let advice = Diagnostic::advice(DAMAGED, Span::default(), message);
            found.push(advice.help("copy the log again; if the power was cut, its end was never written"));
        }
        if let Some(name) = self.frames.first() {
            let message = format!("`{name}` changes within the log, as if it held those of two vehicles");
            found.push(warning(message).help("the last value counts; split the log where the autopilot was started"));
        }
        if self.wild > 0 {
            let samples = plural(self.wild as usize, "sample");
            let message = format!("{samples} of the gyroscope or the outputs beyond any range, left out");
            found.push(warning(message));
        }
        if self.late > 100 {
            let message = format!("{} samples have times before those of earlier ones and were left out", self.late);
            found.push(warning(message).help("if the log has several flights, split it at its reboots"));
        }
        found
    }
}

/// Collects the messages of one log.
pub struct Collector {
    pub record: Record,
    pub damage: Damage,
    /// ArduPilot: the motor of each servo output, and whether the parameters that say it changed.
    motor_of: [Option<usize>; 32],
    /// Outputs with another function.
    is_other: [bool; 32],
    /// Whether a more exact source of a series was seen.
    has_ekf: bool,
    /// PX4 and mavc: whether the log has the commands of motors.
    has_commands: bool,
    /// mavc: whether the log has what the gyroscope measured, beside the true rates.
    is_measured: bool,
    /// The speeds of motors that were last reported.
    speeds: [f64; MOTORS],
    outputs: [f64; MOTORS],
    /// ArduPilot: the rates that its controller takes, for logs without an IMU.
    spare_rates: Series<3>,
}

/// Whether a message is of the first of several sensors: old logs do not number them.
fn is_first(instance: f64) -> bool {
    instance.is_nan() || instance <= 0.0
}

/// From forward, right, down to forward, left, up.
pub fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -y, -z]
}

impl Collector {
    pub fn new(autopilot: Autopilot) -> Self {
        Collector {
            record: Record::new(autopilot),
            damage: Damage::default(),
            motor_of: [None; 32],
            is_other: [false; 32],
            has_ekf: false,
            has_commands: false,
            is_measured: false,
            speeds: [f64::NAN; MOTORS],
            outputs: [f64::NAN; MOTORS],
            spare_rates: Series::default(),
        }
    }

    fn count(&mut self, is_in_order: bool) {
        self.damage.late += u64::from(!is_in_order);
    }

    /// A parameter, at the time of its message.
    pub fn parameter(&mut self, name: &str, value: f64, _time: f64) {
        if !value.is_finite() || name.len() > LONGEST_NAME {
            return;
        }
        if let Some(output) = name.strip_prefix("SERVO").and_then(|rest| rest.strip_suffix("_FUNCTION"))
            && let Ok(output @ 1..=32) = output.parse::<usize>()
        {
            let motor = match value {
                v if (FIRST_FUNCTION..FIRST_FUNCTION + 8.0).contains(&v) => Some((v - FIRST_FUNCTION) as usize),
                v if (NINTH..NINTH + 4.0).contains(&v) => Some((v - NINTH) as usize + 8),
                _ => None,
            };
            // A motor keeps its output when a parameter takes it away in flight.
            if motor.is_some() {
                self.motor_of[output - 1] = motor;
            }
            self.is_other[output - 1] = motor.is_none() && value != 0.0;
        }
        if FRAMES.contains(&name) && self.record.parameters.get(name).is_some_and(|known| *known != value) {
            self.damage.frames.insert(name.to_string());
        }
        if self.record.parameters.len() < MOST_PARAMETERS {
            self.record.parameters.insert(name.to_string(), value);
        }
    }

    /// The motor of an output of ArduPilot, from 0; before 3.6 the outputs are the motors.
    fn motor(&self, output: usize) -> Option<usize> {
        match self.motor_of.iter().any(Option::is_some) {
            true => self.motor_of[output],
            false => (output < 8 && !self.is_other[output]).then_some(output),
        }
    }

    fn put_outputs(&mut self, first: usize, pulses: &[f64]) {
        for (k, pulse) in pulses.iter().enumerate() {
            if let Some(motor) = self.motor(first + k) {
                self.outputs[motor] = *pulse;
            }
        }
    }

    /// What the gyroscope measured about forward, right, down, rad/s. Returns whether it was in order.
    fn rates(&mut self, time: f64, rates: [f64; 3]) -> bool {
        if rates.iter().any(|rate| rate.abs() > FASTEST) {
            self.damage.wild += 1;
            return true;
        }
        self.record.rates.push(time, turned(rates))
    }

    /// A message of ArduPilot: the fields of `dataflash::WANTED`.
    pub fn ardupilot(&mut self, name: &str, time: f64, v: &[f64]) {
        let radians = f64::to_radians;
        let record = &mut self.record;
        let is_in_order = match (name, v) {
            ("RCOU", pulses) if pulses.iter().any(|pulse| *pulse > LONGEST_PULSE) => {
                self.damage.wild += 1;
                true
            }
            ("RCOU", pulses) => {
                self.put_outputs(0, pulses);
                let outputs = self.outputs;
                self.record.outputs.push(time, outputs)
            }
            ("RCO2", pulses) => {
                self.put_outputs(14, pulses);
                true
            }
            ("IMU", [instance, gyro @ .., ax, ay, az]) if is_first(*instance) => {
                record.force.push(time, turned([*ax, *ay, *az]));
                self.rates(time, [gyro[0], gyro[1], gyro[2]])
            }
            ("RATE", [thrust, roll, pitch, yaw, rates @ ..]) => {
                let rates = [rates[0], rates[1], rates[2]].map(radians);
                if rates.iter().all(|rate| rate.abs() < FASTEST) {
                    self.spare_rates.push(time, turned(rates));
                }
                record.demands.push(time, [*thrust, *roll, -*pitch, -*yaw])
            }
            ("ATT", [roll, pitch, yaw, wanted @ ..]) => {
                let all = [*roll, -*pitch, -*yaw, wanted[0], -wanted[1], -wanted[2]];
                record.attitude.push(time, all.map(radians))
            }
            ("BARO", [instance, height]) if is_first(*instance) => {
                if !self.has_ekf {
                    record.height.push(time, [*height]);
                }
                record.pressure_height.push(time, [*height])
            }
            ("XKF1" | "NKF1" | "EKF1", [core, _, _, down, _, _, place]) if is_first(*core) => {
                if !self.has_ekf {
                    record.height = Default::default();
                    self.has_ekf = true;
                }
                record.climb.push(time, [-*down]);
                record.height.push(time, [-*place])
            }
            ("ESC", [instance, rpm]) if *instance >= 0.0 && *instance < MOTORS as f64 => {
                if let Some(motor) = self.motor(*instance as usize) {
                    self.speeds[motor] = *rpm;
                }
                let speeds = self.speeds;
                self.record.speeds.push(time, speeds);
                true
            }
            ("ESC1" | "ESC2" | "ESC3" | "ESC4" | "ESC5" | "ESC6" | "ESC7" | "ESC8", [rpm]) => {
                if let Some(motor) = self.motor(usize::from(name.as_bytes()[3] - b'1')) {
                    self.speeds[motor] = *rpm;
                }
                let speeds = self.speeds;
                self.record.speeds.push(time, speeds);
                true
            }
            _ => true,
        };
        self.count(is_in_order);
    }

    /// A message of PX4: a topic with the fields of `ulog::WANTED`.
    pub fn px4(&mut self, name: &str, time: f64, v: &[f64]) {
        let record = &mut self.record;
        let motors = |v: &[f64]| std::array::from_fn(|k| v.get(k).copied().unwrap_or(f64::NAN));
        let is_in_order = match (name, v) {
            ("actuator_motors", shares) if shares.iter().any(|share| share.abs() > 1.001) => {
                self.damage.wild += 1;
                true
            }
            // Thrusts of motors as the allocation demands them: better than pulses.
            ("actuator_motors", shares) => {
                if !self.has_commands {
                    record.outputs = Default::default();
                    record.is_pulses = false;
                    record.is_by_rotor = false;
                    self.has_commands = true;
                }
                record.outputs.push(time, motors(shares))
            }
            ("actuator_outputs", [count, pulses @ ..]) if record.is_pulses => {
                let mut pulses: [f64; MOTORS] = motors(pulses);
                pulses.iter_mut().skip((*count).clamp(0.0, 16.0) as usize).for_each(|pulse| *pulse = f64::NAN);
                record.outputs.push(time, pulses)
            }
            ("vehicle_angular_velocity", _) if self.is_measured => true,
            ("vehicle_angular_velocity", [x, y, z]) => {
                if !self.has_ekf {
                    record.rates = Default::default();
                    self.has_ekf = true;
                }
                self.rates(time, [*x, *y, *z])
            }
            ("sensor_combined", [x, y, z, ax, ay, az]) => {
                // The filtered rates of PX4 are better; those of a simulated flight are true, as no sensor's are.
                if record.autopilot == Autopilot::Mavc && !self.is_measured {
                    record.rates = Default::default();
                    self.is_measured = true;
                }
                let is_in_order = record.force.push(time, turned([*ax, *ay, *az]));
                let is_used = !self.has_ekf || self.is_measured;
                (!is_used || self.rates(time, [*x, *y, *z])) && is_in_order
            }
            ("vehicle_attitude", [w, x, y, z]) => {
                let [roll, pitch, yaw] = angles([*w, *x, *y, *z]);
                record.attitude.push(time, [roll, -pitch, -yaw, f64::NAN, f64::NAN, f64::NAN])
            }
            ("vehicle_local_position", [z, vz]) => {
                record.climb.push(time, [-*vz]);
                record.height.push(time, [-*z])
            }
            ("vehicle_air_data", [height]) => record.pressure_height.push(time, [*height]),
            ("esc_status", speeds) => record.speeds.push(time, motors(speeds)),
            ("mavc_rotors", speeds) => {
                record.autopilot = Autopilot::Mavc;
                // Without commands the speeds that follow them.
                if !self.has_commands {
                    record.is_pulses = false;
                    record.is_by_rotor = true;
                    record.outputs.push(time, motors(speeds));
                }
                true
            }
            _ => true,
        };
        self.count(is_in_order);
    }

    /// Ends the log: outputs that are shares although their topic has pulses in other logs (simulators).
    pub fn finish(&mut self) {
        if self.record.rates.is_empty() {
            self.record.rates = std::mem::take(&mut self.spare_rates);
        }
        self.record.late = self.damage.late;
        self.record.finish();
        let outputs = &self.record.outputs;
        let largest = outputs.values.iter().flatten().filter(|v| v.is_finite()).fold(0.0_f32, |a, b| a.max(*b));
        if self.record.is_pulses && largest > 0.0 && largest <= 1.5 {
            self.record.is_pulses = false;
        }
    }
}

/// Roll, pitch, yaw of a quaternion, rad.
fn angles([w, x, y, z]: [f64; 4]) -> [f64; 3] {
    let roll = (2.0 * (w * x + y * z)).atan2(1.0 - 2.0 * (x * x + y * y));
    let pitch = (2.0 * (w * y - z * x)).clamp(-1.0, 1.0).asin();
    let yaw = (2.0 * (w * z + x * y)).atan2(1.0 - 2.0 * (y * y + z * z));
    [roll, pitch, yaw]
}
