//! `rotors = lagging`: what it needs of a vehicle.

use super::context::Context;
use crate::diagnostic::Diagnostic;
use crate::model::{PlanRotors, PlanSettings, Rotor, Vehicle};

/// Whether every rotor has a time constant, where the plan needs one; reports an error otherwise.
pub(super) fn check(cx: &mut Context, plan: &PlanSettings, vehicle: &Vehicle) -> bool {
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

/// Whether the plan takes no lag into account or no rotor may reverse; reports an error otherwise: the time constant of
/// (87) is that of speeds above zero.
pub(super) fn none_reverses(cx: &mut Context, plan: &PlanSettings, vehicle: &Vehicle) -> bool {
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
