//! The range of magnitudes that mavc computes with. It is far wider than any multirotor needs and narrow enough that sums
//! and products of any two values keep their digits. A value outside the range is an error.

use super::context::Context;
use super::due::{Due, called};
use super::{Rotor, Vehicle};
use crate::diagnostic::Diagnostic;
use crate::number::number;
use crate::source::Span;
use crate::unit::parse_unit;

const CODE: &str = "mavc::unit::magnitude";

/// Smallest nonzero and largest magnitude, in SI units; zero is handled by the checks of signs.
type Bounds = (f64, f64);

/// For fields that are not listed: products of smaller numbers underflow.
const ANY: Bounds = (1e-100, 1e12);
/// For a limit on a rate or on tilt: with smaller ones nothing can move, and the least times they imply overflow.
const RATE: Bounds = (1e-9, 1e12);

/// Thrust of one rotor at full speed, N: from a millionth of the smallest rotor's to more than a helicopter's.
const THRUST: Bounds = (1e-6, 1e6);
/// Torque per thrust of one rotor, m.
const TORQUE: Bounds = (1e-12, 1e4);

/// Fields with their own bounds: name, unit and bounds in SI units.
const FIELDS: [(&str, &str, Bounds); 41] = [
    ("gravity", "m/s^2", (1e-3, 1e4)),
    ("mass", "kg", (1e-6, 1e6)),
    ("inertia", "kg*m^2", (1e-15, 1e9)),
    ("arm", "m", (1e-4, 1e4)),
    ("propeller_radius", "m", (1e-4, 1e4)),
    ("size", "m", (1e-4, 1e4)),
    ("yaw_drag", "N*m*s/rad", (1e-12, 1e6)),
    ("yaw_drag_quadratic", "N*m*s^2/rad^2", (0.0, 1e6)),
    ("rotor_inertia", "kg*m^2", (1e-15, 1e6)),
    ("max_thrust", "N", THRUST),
    ("torque_per_thrust", "m", TORQUE),
    ("max_speed", "rad/s", (0.1, 1e6)),
    ("min_speed", "rad/s", (0.0, 1e6)),
    ("min_thrust", "N", (0.0, 1e9)),
    ("time_constant", "s", (1e-6, 1e4)),
    ("capacity", "A*h", (1e-3, 1e12)),
    ("voltage", "V", (1e-3, 1e6)),
    ("hover_power", "W", (1e-6, 1e9)),
    // Upper bounds of these are checked where they are read.
    ("time", "s", (1e-9, f64::INFINITY)),
    ("hold", "s", (0.0, f64::INFINITY)),
    ("duration", "s", (1e-9, f64::INFINITY)),
    ("at", "m", (1e-100, f64::INFINITY)),
    ("within", "cm", (1e-9, 1e9)),
    ("yaw_within", "deg", (1e-9, 1e9)),
    ("weight", "1", (0.0, 1e12)),
    ("snap", "1", (0.0, 1e12)),
    ("acceleration", "1", (0.0, 1e12)),
    ("wind", "m/s", (0.0, 1e4)),
    ("gusts", "m/s", (0.0, 1e4)),
    ("density", "kg/m^3", (1e-3, 1e3)),
    ("gust_length", "m", (1e-6, 1e9)),
    ("speed", "m/s", RATE),
    ("speed_horizontal", "m/s", RATE),
    ("climb", "m/s", RATE),
    ("descent", "m/s", RATE),
    ("acceleration", "m/s^2", RATE),
    ("acceleration_horizontal", "m/s^2", RATE),
    ("jerk", "m/s^3", RATE),
    ("yaw_rate", "deg/s", RATE),
    ("yaw_acceleration", "deg/s^2", RATE),
    ("tilt", "deg", RATE),
];

fn has((low, high): Bounds, value: f64) -> bool {
    let size = value.abs();
    size <= high && (size == 0.0 || size >= low)
}

impl Context<'_> {
    /// Whether `value`, in SI units, is within the supported magnitudes; reports it otherwise.
    pub(super) fn is_within_magnitude(&mut self, due: Due, value: f64, span: Span) -> bool {
        let own = FIELDS.iter().find(|(name, unit, _)| (*name, *unit) == (due.what, due.unit));
        // The ranges of plain numbers are checked where they are read.
        let bounds = own.map(|row| row.2).or((due.unit != "1").then_some(ANY));
        let Some(bounds) = bounds.filter(|bounds| !has(*bounds, value)) else { return true };
        let scale = parse_unit(due.unit, self.gravity).map_or(1.0, |unit| unit.numerator / unit.denominator);
        self.report(beyond(&called(due.what), value / scale, (bounds.0 / scale, bounds.1 / scale), due.unit, span));
        false
    }

    /// Whether the full thrust and the torque per thrust of every rotor are within the supported magnitudes; reports it
    /// otherwise. `places` gives the places of a rotor's thrust and torque.
    pub(super) fn has_magnitude(&mut self, vehicle: &Vehicle, places: impl Fn(usize) -> [Span; 2]) -> bool {
        let ratio = |rotor: &Rotor| rotor.drag_coefficient / rotor.thrust_coefficient;
        let odd = vehicle.rotors.iter().enumerate().find_map(|(k, rotor)| match () {
            _ if !has(THRUST, rotor.max_thrust()) => {
                Some((k, "a rotor's full thrust", rotor.max_thrust(), THRUST, "N"))
            }
            _ if !has(TORQUE, ratio(rotor)) => Some((k, "a rotor's torque per thrust", ratio(rotor), TORQUE, "m")),
            _ => None,
        });
        let Some((k, what, value, bounds, unit)) = odd else { return true };
        let [thrust, torque] = places(k);
        self.report(beyond(what, value, bounds, unit, if unit == "N" { thrust } else { torque }));
        false
    }
}

fn beyond(what: &str, value: f64, (low, high): Bounds, unit: &str, span: Span) -> Diagnostic {
    let blank = if unit == "1" { String::new() } else { format!(" {unit}") };
    let (side, bound) = if value.abs() > high { ("at most", high) } else { ("at least", low) };
    let message = format!("{what} must be {side} {}{blank} in magnitude", number(bound));
    let error = Diagnostic::error(CODE, span, message).here(format!("this is {}{blank}", number(value)));
    error.help("check the number, its exponent and its unit")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Group;

    /// A row whose name or unit the language does not have would have no effect.
    #[test]
    fn every_row_is_a_field_of_the_language() {
        for (name, unit, (low, high)) in FIELDS {
            let is_field = |group: Group| group.entries().iter().any(|e| e.name == name && e.unit() == Some(unit));
            assert!(name == "hold" || Group::ALL.into_iter().any(is_field), "{name} in {unit}");
            assert!(low < high, "{name}");
        }
    }
}
