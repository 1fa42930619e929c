//! Sense checks: values that are possible but not plausible for a multirotor, such as a mass of 6 g under 126 N of
//! thrust. Each is a warning with the computed value, the usual range and the likely slip; `allow` suppresses it. The
//! sources of the ranges are in `docs/diagnostics/sense.md`.

mod air;
mod battery;
mod estimator;
mod gains;
mod loss;
mod mission_scale;
mod noise;
mod parts;
mod vehicle;

pub(super) use air::{check as check_air, strong as check_strong_air};
pub(super) use battery::check as check_battery;
pub(super) use estimator::check as check_estimator;
pub(super) use gains::check as check_gains;
pub(super) use loss::check as check_loss;
pub(super) use mission_scale::{limits as check_limits, mission as check_mission, pace as check_pace};
pub(super) use noise::check as check_noise;
pub(super) use parts::{Measured, check as check_parts};
pub(super) use vehicle::{RotorSpans, VehicleSpans, check as check_vehicle};

use super::context::Context;
use crate::diagnostic::Diagnostic;
use crate::number::significant;
use crate::source::Span;

/// The usual range of a quantity, including both ends.
#[derive(Clone, Copy)]
struct Usual {
    low: f64,
    high: f64,
}

impl Usual {
    const fn new(low: f64, high: f64) -> Self {
        Usual { low, high }
    }

    fn has(self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// `found`, in words, and that it is outside this range.
    fn outside(self, found: String, unit: &str) -> String {
        format!("{found}, outside the usual range of {}", self.text(unit))
    }

    /// "0.02 to 2 m"
    fn text(self, unit: &str) -> String {
        let blank = if unit.is_empty() { "" } else { " " };
        format!("{} to {}{blank}{unit}", short(self.low), short(self.high))
    }
}

/// A computed number with three digits, which suffice to compare it with a range.
fn short(value: f64) -> String {
    significant(value, 3)
}

/// A warning whose help names the likely slip and the way to suppress the warning.
fn warning(code: &'static str, span: Span, message: String, slip: &str) -> Diagnostic {
    let word = code.rsplit("::").next().unwrap_or(code);
    let help = format!("{slip}; if the value is intended, write `allow = [{word}]` outside all blocks");
    Diagnostic::warning(code, span, message).help(help)
}

/// Warns of a fault without effect: `share` is the thrust that a rotor keeps.
pub(super) fn effect(cx: &mut Context, share: f64, span: Span) {
    if share < 1.0 {
        return;
    }
    let message = "a rotor is reduced to 100 %, outside the usual range of 0 to 99 %".to_string();
    let slip = "write the share that remains, not the share that is lost";
    cx.report(warning("mavc::sense::effect", span, message, slip).here("has no effect"));
}

/// Acceleration of gravity, m/s^2: from small moons to heavy planets.
const GRAVITY: Usual = Usual::new(1.0, 30.0);

pub(super) fn gravity(cx: &mut Context, gravity: f64, span: Span) {
    if GRAVITY.has(gravity) {
        return;
    }
    let message = GRAVITY.outside(format!("`gravity` is {} m/s^2", short(gravity)), "m/s^2");
    let warning = warning("mavc::sense::gravity", span, message, "check the number and its unit");
    cx.report(warning.here("on Earth it is 9.81 m/s^2"));
}
