//! Outputs of motors as shares of their full thrust, by the parameters of the log.
//!
//! - ArduPilot (`AP_MotorsMulticopter.cpp`, 4.5): the pulse is linear in the actuator between `MOT_PWM_MIN` and
//!   `MOT_PWM_MAX`; the actuator is linear in the throttle between `MOT_SPIN_MIN` and `MOT_SPIN_MAX`; the thrust is
//!   `(1 - e) x + e x^2` of the throttle x, e = `MOT_THST_EXPO`. The compensation of the battery's voltage cancels.
//! - PX4 (documentation, `THR_MDL_FAC`): `actuator_motors` is the command signal s, the thrust `f s^2 + (1 - f) s`; a
//!   pulse is linear in s between its minimum and its maximum.

use crate::diagnosis::record::{Autopilot, MOTORS, Record};
use crate::diagnostic::Diagnostic;
use crate::source::Span;

/// The largest output of a log, at least 1.
fn largest(record: &Record) -> f64 {
    record.outputs.values.iter().flatten().filter(|v| v.is_finite()).fold(1.0, |a, b| a.max(f64::from(*b)))
}

/// From an output to a share of full thrust.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The outputs of no and of full thrust, for each motor.
    low: [f64; MOTORS],
    high: [f64; MOTORS],
    /// An output up to this one stands for a motor that is switched off; below every output if that cannot be told
    /// from the least command.
    off: f64,
    /// Share of the quadratic part.
    pub expo: f64,
}

/// ArduPilot's parameters for the thrust of a command, with their defaults (`AP_MotorsMulticopter.cpp`, 4.5).
const SHAPE: [(&str, f64); 3] = [("MOT_SPIN_MIN", 0.15), ("MOT_SPIN_MAX", 0.95), ("MOT_THST_EXPO", 0.65)];

/// A warning if a log of ArduPilot lacks parameters from which the thrust of a command follows.
pub fn assumed(record: &Record) -> Option<Diagnostic> {
    let is_missing = |(name, _): &(&str, f64)| !record.parameters.contains_key(*name);
    let missing: Vec<(&str, f64)> = SHAPE.into_iter().filter(is_missing).collect();
    let list = missing.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ");
    let help = "name a log that has the parameters, if the vehicle has others: capacities and times depend on them";
    let is_lacking = record.autopilot == Autopilot::ArduPilot && !missing.is_empty();
    is_lacking.then(|| {
        let message = format!("the log lacks parameters of the motors; mavc assumes ArduPilot's defaults: {list}");
        Diagnostic::warning(super::ASSUMED, Span::default(), message).help(help)
    })
}

impl Curve {
    /// The curve of a log.
    pub fn of(record: &Record) -> Self {
        let get = |name: &str, default: f64| record.parameter(name, default);
        let same = |low, high, expo| Curve { low: [low; MOTORS], high: [high; MOTORS], off: f64::NEG_INFINITY, expo };
        match record.autopilot {
            Autopilot::ArduPilot => {
                let rc = |name: &str| record.parameters.get(name).copied().filter(|x| *x > 0.0);
                let low = rc("MOT_PWM_MIN").or(rc("RC3_MIN")).unwrap_or(1000.0);
                let high = rc("MOT_PWM_MAX").or(rc("RC3_MAX")).filter(|high| *high > low + 100.0);
                let span = high.unwrap_or(low + 1000.0) - low;
                let [bottom, top, expo] = SHAPE.map(|(name, default)| get(name, default));
                let is_range = bottom >= 0.0 && top > bottom;
                let [bottom, top] = if is_range { [bottom, top] } else { [SHAPE[0].1, SHAPE[1].1] };
                let expo = expo.clamp(0.0, 1.0);
                let off = if span * bottom > 20.0 { low + 0.25 * span * bottom } else { f64::NEG_INFINITY };
                Curve { off, ..same(low + span * bottom, low + span * top, expo) }
            }
            // Thrust follows the square of the speed. Commands are shares of full speed; a log without them has speeds,
            // of which the largest stands for full speed.
            Autopilot::Mavc => same(0.0, largest(record), 1.0),
            Autopilot::Px4 => {
                let expo = get("THR_MDL_FAC", 0.0).clamp(0.0, 1.0);
                if !record.is_pulses {
                    return same(0.0, 1.0, expo);
                }
                let mut curve = same(get("PWM_MIN", 1000.0), get("PWM_MAX", 2000.0), expo);
                for motor in 0..MOTORS {
                    let of = |part: &str, default| {
                        let own = get(&format!("PWM_MAIN_{part}{}", motor + 1), f64::NAN);
                        let all = get(&format!("PWM_MAIN_{part}"), default);
                        if own > 0.0 { own } else { all }
                    };
                    curve.low[motor] = of("MIN", curve.low[motor]);
                    curve.high[motor] = of("MAX", curve.high[motor]);
                    if curve.high[motor] < curve.low[motor] + 100.0 {
                        (curve.low[motor], curve.high[motor]) = (1000.0, 2000.0);
                    }
                }
                curve
            }
        }
    }

    /// Whether an output stands for a motor that is switched off.
    pub fn is_off(&self, output: f64) -> bool {
        output <= self.off
    }

    /// The share of full thrust of a motor at an output; an output that is none, 0 or not finite, gives NaN or 0.
    pub fn share(&self, motor: usize, output: f64) -> f64 {
        if output.is_nan() {
            return f64::NAN;
        }
        let x = ((output - self.low[motor]) / (self.high[motor] - self.low[motor])).clamp(0.0, 1.0);
        (1.0 - self.expo) * x + self.expo * x * x
    }
}

/// For a sample of the outputs and a motor (both from 0) the share of full thrust, and whether the motor is switched
/// off. A table of all would be larger than the record.
pub fn commands(record: &Record) -> impl Fn(usize, usize) -> (f64, bool) {
    let curve = Curve::of(record);
    move |row, motor| {
        let output = f64::from(record.outputs.values[row][motor]);
        (curve.share(motor, output), curve.is_off(output))
    }
}
