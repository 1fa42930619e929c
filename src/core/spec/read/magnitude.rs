//! The range of magnitudes that mavc computes with. It is far wider than any multirotor needs and narrow enough that
//! sums and products of any two values keep their digits. A value outside the range is an error.

use super::context::Context;
use super::expected::{Expected, called};
use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::language::table::rotor;
use crate::model::{Rotor, Vehicle};
use crate::number::number;
use crate::source::Span;
use crate::unit::parse_unit;

const CODE: &str = "mavc::unit::magnitude";

/// Smallest nonzero and largest magnitude, in SI units; zero is handled by the checks of signs.
type Bounds = (f64, f64);

/// The bounds of a row that gives none: products of smaller numbers underflow.
const ANY: Bounds = (1e-100, 1e12);
const fn of_row(entry: &Entry) -> Bounds {
    match entry.bounds {
        Some(bounds) => bounds,
        None => ANY,
    }
}

/// The thrust of one rotor at full speed, N: from a millionth of the smallest rotor's to more than a helicopter's.
const THRUST: Bounds = of_row(&rotor::MAX_THRUST);
const TORQUE: Bounds = of_row(&rotor::TORQUE_PER_THRUST);

fn has((low, high): Bounds, value: f64) -> bool {
    let size = value.abs();
    size <= high && (size == 0.0 || size >= low)
}

impl Context<'_> {
    /// Whether `value`, in SI units, is within the supported magnitudes; reports it otherwise.
    pub(super) fn is_within_magnitude(&mut self, due: Expected, value: f64, span: Span) -> bool {
        // The ranges of other plain numbers are checked where they are read.
        let bounds = due.row.and_then(|row| row.bounds).or((due.unit != "1").then_some(ANY));
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
