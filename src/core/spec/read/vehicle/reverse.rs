//! What a vehicle whose rotors may reverse cannot be combined with yet.

use super::rotor::MIN_SPEED;
use crate::diagnostic::Diagnostic;
use crate::model::{Allocation, Rotor, Vehicle};
use crate::read::context::Context;
use crate::source::Span;

/// Reports rotors that may reverse together with the pseudo-inverse or with intervals; `at` gives where
/// the `min_speed` of a rotor is written.
pub(super) fn check(cx: &mut Context, vehicle: &Vehicle, at: impl Fn(usize) -> Span) {
    let Some(first) = vehicle.rotors.iter().position(Rotor::is_reversible) else { return };
    let (other, why, help) = if vehicle.allocation == Allocation::PseudoInverse {
        ("`allocation = pseudo_inverse`", "a pseudo-inverse clips at zero thrust", "write `allocation = bounded`")
    } else if vehicle.is_uncertain() {
        // The rows that intervals shrink hold for thrusts that are not negative.
        ("intervals or `thrust_at_empty`", "intervals require thrusts of at least zero", "write exact values")
    } else {
        return;
    };
    let message = format!("rotors that can reverse cannot be combined with {other}");
    cx.report(
        Diagnostic::error(MIN_SPEED, at(first), message)
            .here(why)
            .help(format!("{help}, or remove the negative `min_speed` or `min_thrust`")),
    );
}
