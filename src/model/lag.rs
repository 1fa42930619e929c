//! Rotors that lag behind their commands, as plans take them: `rotors = lagging`.

use super::context::Context;
use super::{Model, Plan, PlanRotors, Rotor, Vehicle};
use crate::diagnostic::Diagnostic;

/// Plans count on rotors that turn at this share of their full speed or faster: there a thrust never rises quicker than
/// the motor can make it. (Slower ones give less than a ninth of their full thrust.)
pub const SLOWEST_SHARE: f64 = 1.0 / 3.0;

impl Rotor {
    /// Time constant of the first-order lag of the thrust that plans keep to, (87): `time_constant` (1 + s)/(2 s), with
    /// s the slowest share of the full speed that counts; s. At that s and above, a thrust f with f + tau f' between idle
    /// and full thrust is one that the speed's own lag allows.
    pub fn thrust_lag(&self) -> f64 {
        let spread = self.spread;
        let idle = self.idle_thrust() * spread.idle_thrust.low / (self.max_thrust() * spread.full_thrust.high);
        let slowest = idle.sqrt().max(SLOWEST_SHARE);
        self.lag() * (1.0 + slowest) / (2.0 * slowest)
    }
}

impl Model {
    /// Time constant tau with which plans take thrusts to follow their commands, f_c = f + tau f'; the largest over the
    /// rotors, s. `None` where they follow at once.
    pub fn thrust_lag(&self) -> Option<f64> {
        match self.plan.rotors {
            PlanRotors::Instant => None,
            PlanRotors::Lagging => self.vehicle.rotors.iter().map(Rotor::thrust_lag).max_by(f64::total_cmp),
        }
    }
}

/// Whether every rotor says how fast it follows, where the plan asks for that; otherwise an error is told.
pub(super) fn check(cx: &mut Context, plan: &Plan, vehicle: &Vehicle) -> bool {
    let silent = |rotor: &Rotor| rotor.time_constant.is_none();
    if plan.rotors == PlanRotors::Instant || !vehicle.rotors.iter().any(silent) {
        return true;
    }
    let message = "lagging rotors need a `time_constant` each";
    let which = match vehicle.rotors.iter().position(silent) {
        Some(first) if vehicle.rotors.iter().any(|r| !silent(r)) => format!("rotor {} has none", first + 1),
        _ => "its rotors have none".to_string(),
    };
    let error = Diagnostic::error("mavc::plan::time_constant", plan.rotors_span, message).here("asked for here");
    cx.report(error.also(vehicle.span, which).help("add `time_constant = 20 ms` to the vehicle's `rotor` block"));
    false
}
