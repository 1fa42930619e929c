//! The first-order lag of rotors in plans: `rotors = lagging`.

use super::context::Context;
use super::{Model, Plan, PlanRotors, Rotor, Vehicle};
use crate::diagnostic::Diagnostic;

/// Plans assume that rotors turn at this share of their full speed or faster; the lag of the thrust is bounded there. Slower
/// rotors give less than a ninth of their full thrust.
pub const SLOWEST_SHARE: f64 = 1.0 / 3.0;

impl Rotor {
    /// Time constant of the first-order lag of the thrust in plans, (87) in docs/method.md, in seconds:
    /// `time_constant` (1 + s)/(2 s), where s is the slowest share of the full speed considered. At speeds from that share
    /// upwards, a thrust f with f + tau f' between idle and full thrust is one that the lag of the speed allows.
    pub fn thrust_lag(&self) -> f64 {
        let spread = self.spread;
        let idle = self.idle_thrust() * spread.idle_thrust.low / (self.max_thrust() * spread.full_thrust.high);
        let slowest = idle.sqrt().max(SLOWEST_SHARE);
        self.lag() * (1.0 + slowest) / (2.0 * slowest)
    }
}

impl Model {
    /// Time constant tau with which thrusts follow their commands in plans, f_c = f + tau f', in seconds: the largest over
    /// the rotors. `None` where they follow instantly.
    pub fn thrust_lag(&self) -> Option<f64> {
        match self.plan.rotors {
            PlanRotors::Instant => None,
            PlanRotors::Lagging => self.vehicle.rotors.iter().map(Rotor::thrust_lag).max_by(f64::total_cmp),
        }
    }
}

/// Whether every rotor has a time constant, where the plan needs one; reports an error otherwise.
pub(super) fn check(cx: &mut Context, plan: &Plan, vehicle: &Vehicle) -> bool {
    let silent = |rotor: &Rotor| rotor.time_constant.is_none();
    if plan.rotors == PlanRotors::Instant || !vehicle.rotors.iter().any(silent) {
        return true;
    }
    let message = "`rotors = lagging` needs a `time_constant` for every rotor";
    let which = match vehicle.rotors.iter().position(silent) {
        Some(first) if vehicle.rotors.iter().any(|r| !silent(r)) => format!("rotor {} has none", first + 1),
        _ => "its rotors have none".to_string(),
    };
    let error = Diagnostic::error("mavc::plan::time_constant", plan.rotors_span, message).here("required here");
    cx.report(error.also(vehicle.span, which).help("add `time_constant = 20 ms` to the vehicle's `rotor` block"));
    false
}

/// Whether the plan takes no lag into account or no rotor may reverse; reports an error otherwise: the time constant of (87) is
/// that of speeds above zero.
pub(super) fn none_reverses(cx: &mut Context, plan: &Plan, vehicle: &Vehicle) -> bool {
    if plan.rotors == PlanRotors::Instant || !vehicle.rotors.iter().any(Rotor::is_reversible) {
        return true;
    }
    let message = "a negative `min_speed` cannot be combined with `rotors = lagging`";
    let error = Diagnostic::error("mavc::vehicle::min_speed", plan.rotors_span, message);
    cx.report(
        error
            .here("needs rotors that keep their direction")
            .also(vehicle.span, "its rotors may reverse")
            .help("write `rotors = instant`, or remove `min_speed` for rotors that do not reverse"),
    );
    false
}
