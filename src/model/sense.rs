//! Sense checks: numbers that are possible and yet not those of any multirotor, such as 6 g under 126 N of thrust. Each
//! is a warning with what was computed, the usual range and the likely slip; `allow` silences it. Where the ranges come
//! from is written in `docs/diagnostics/sense.md`.

mod air;
mod estimator;
mod flight;
mod gains;
mod loss;
mod noise;
mod vehicle;

pub(super) use air::check as check_air;
pub(super) use estimator::check as check_estimator;
pub(super) use flight::{limits as check_limits, mission as check_mission, pace as check_pace};
pub(super) use gains::check as check_gains;
pub(super) use loss::check as check_loss;
pub(super) use noise::check as check_noise;
pub(super) use vehicle::{Written, WrittenRotor, check as check_vehicle};

use super::context::Context;
use crate::diagnostic::Diagnostic;
use crate::number::significant;
use crate::source::Span;

/// The usual range of a quantity, both ends in it.
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

    /// "0.02 to 2 m"
    fn text(self, unit: &str) -> String {
        let blank = if unit.is_empty() { "" } else { " " };
        format!("{} to {}{blank}{unit}", short(self.low), short(self.high))
    }
}

/// A computed number: nobody compares more than three digits with a usual range.
fn short(value: f64) -> String {
    significant(value, 3)
}

/// A warning whose help names the slip and the way to silence it.
fn warning(code: &'static str, span: Span, message: String, slip: &str) -> Diagnostic {
    let word = code.rsplit("::").next().unwrap_or(code);
    let help = format!("{slip}; if it is meant, write `allow = [{word}]` outside all blocks");
    Diagnostic::warning(code, span, message).help(help)
}

/// Warns of a fault that takes nothing: `share` of its thrust is left to a rotor.
pub(super) fn effect(cx: &mut Context, share: f64, span: Span) {
    if share < 1.0 {
        return;
    }
    let message = "a rotor is reduced to 100 %, where 0 to 99 % is usual".to_string();
    let slip = "write the share that is left, not the one that is lost";
    cx.report(warning("mavc::sense::effect", span, message, slip).here("this takes nothing from it"));
}

/// Acceleration of gravity, m/s^2: from small moons to heavy planets.
const GRAVITY: Usual = Usual::new(1.0, 30.0);

pub(super) fn gravity(cx: &mut Context, gravity: f64, span: Span) {
    if GRAVITY.has(gravity) {
        return;
    }
    let message = format!("a gravity of {} m/s^2, where {} is usual", short(gravity), GRAVITY.text("m/s^2"));
    let warning = warning("mavc::sense::gravity", span, message, "check the number and its unit");
    cx.report(warning.here("the Earth has 9.81 m/s^2"));
}
