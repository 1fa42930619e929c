//! Whether the numbers of a battery fit together and to the vehicle.

use super::{Usual, short, warning};
use crate::model::{Battery, Rotor, Vehicle};
use crate::read::context::Context;
use crate::read::fields::Fields;

/// Mechanical over electrical power in hover: motors reach 50 to 90 %, their controllers 90 to 98 %, and the
/// electronics take a few percent.
const EFFICIENCY: Usual = Usual::new(0.25, 0.95);
/// Time for which a full battery lasts in hover, min: the longest known flights of battery-powered multirotors last
/// about two hours.
const HOVER_TIME: Usual = Usual::new(1.0, 150.0);

/// Warns of a hover power or a hover time that is not plausible. `fields` are those of the `battery` block.
pub(in crate::spec::read) fn check(cx: &mut Context, vehicle: &Vehicle, battery: &Battery, fields: &Fields) {
    let place = |name: &str| fields.span_of(name).unwrap_or(battery.span);
    let mechanical = mechanical_power(vehicle, cx.gravity);
    let efficiency = mechanical / battery.hover_power;
    if !EFFICIENCY.has(efficiency) {
        let percent = |share: f64| short(100.0 * share);
        let message = format!(
            "in hover the rotors of vehicle `{}` turn {} % of the electrical power into mechanical power, outside the \
             usual range of {} to {} %",
            vehicle.name,
            percent(efficiency),
            percent(EFFICIENCY.low),
            percent(EFFICIENCY.high)
        );
        let slip = "check `hover_power`, and the thrust, torque and speed of the rotors with their units";
        let here = format!("torque times speed of all rotors is about {} W", short(mechanical));
        cx.report(warning("mavc::sense::hover_power", place("hover_power"), message, slip).here(here));
    }
    let minutes = battery.energy() / battery.hover_power / 60.0;
    if !HOVER_TIME.has(minutes) {
        let found = format!("the battery of vehicle `{}` lasts {} min in hover", vehicle.name, short(minutes));
        let message = HOVER_TIME.outside(found, "min");
        let slip = "look for `A*h` in place of `mA*h`, or the other way round, and check `voltage` and `hover_power`";
        let here = format!("{} W*h with {} V", short(battery.energy() / 3600.0), short(battery.voltage));
        let warning = warning("mavc::sense::hover_time", place("capacity"), message, slip).here(here);
        cx.report(warning.also(place("hover_power"), format!("hover takes {} W", short(battery.hover_power))));
    }
}

/// Torque times speed of all rotors in hover, W, if each carries the weight in proportion to its full thrust.
fn mechanical_power(vehicle: &Vehicle, gravity: f64) -> f64 {
    let full: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let share = vehicle.mass * gravity / full;
    vehicle.rotors.iter().map(|rotor| rotor.drag_coefficient * (share.sqrt() * rotor.max_speed).powi(3)).sum()
}
