//! Errors of the vehicle as a whole: it cannot hover, or cannot hold its yaw.

use crate::diagnostic::Diagnostic;
use crate::model::{Rotor, Spin, Vehicle};
use crate::number::{number, significant};
use crate::read::context::Context;
use crate::source::Span;

/// Checks the weight against the thrust.
pub(super) fn check(cx: &mut Context, vehicle: &Vehicle) {
    let thrust: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let weight = vehicle.mass * cx.gravity;
    let finite = vehicle.rotors.iter().all(|r| r.max_thrust().is_finite() && r.drag_coefficient.is_finite());
    if !finite || !thrust.is_finite() || !weight.is_finite() {
        let (span, what) = match weight.is_finite() {
            true => (vehicle.span, "the rotors' thrust"),
            false => (vehicle.mass_span, "the vehicle's weight"),
        };
        let error = Diagnostic::error("mavc::unit::not_finite", span, format!("{what} is too large for a number"));
        cx.report(error.here("overflows").help("check the numbers, their exponents and units"));
        return;
    }
    if thrust <= weight {
        let message = format!(
            "vehicle `{}` cannot hover: it weighs {} N, but its rotors lift only {} N at full thrust",
            vehicle.name,
            number(weight),
            number(thrust)
        );
        cx.report(
            Diagnostic::error("mavc::vehicle::too_heavy", vehicle.mass_span, message)
                .here("too heavy for these rotors")
                .also(vehicle.span, format!("it has {} rotors", vehicle.rotors.len()))
                .help(format!(
                    "write a mass well below {} kg, or stronger rotors",
                    significant(thrust / cx.gravity, 3)
                )),
        );
    }
    let idle: f64 = vehicle.rotors.iter().map(Rotor::idle_thrust).sum();
    if idle >= weight {
        let message = format!(
            "vehicle `{}` cannot hover: it weighs {} N, but its rotors lift {} N even at their lowest speeds",
            vehicle.name,
            number(weight),
            number(idle)
        );
        cx.report(
            Diagnostic::error("mavc::vehicle::too_light", vehicle.mass_span, message)
                .here("too light for rotors that may not stop")
                .also(vehicle.span, format!("it has {} rotors", vehicle.rotors.len()))
                .help("write a lower `min_speed`, or remove it for rotors that may stop"),
        );
    }
}

/// Rotors that all turn the same way leave a drag torque that nothing balances.
pub(super) fn check_spins(cx: &mut Context, owner: &str, span: Span, spins: &[Spin]) {
    if spins.iter().all(|spin| *spin == spins[0]) {
        let message = format!("all rotors of {owner} turn the same way, so it cannot hold its yaw");
        cx.report(
            Diagnostic::error("mavc::vehicle::spin_balance", span, message)
                .here("every drag torque points the same way")
                .help("make some rotors turn the other way: both `P` and `N` are needed"),
        );
    }
}
