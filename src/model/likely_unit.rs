//! Guesses from its size which unit a plain number was meant to have.

use super::context::Context;
use super::due::Due;
use crate::syntax::ast::{Expr, ExprKind};

/// Upper bounds of a number's size, each with the likely units for numbers below it.
type Sizes = &'static [(f64, &'static [&'static str])];

const ANY: f64 = f64::INFINITY;

/// Typical sizes for multirotors by field. Two units where both are possible, the likelier first.
const FIELDS: [(&[&str], Sizes); 9] = [
    (&["within"], &[(1.0, &["m"]), (ANY, &["cm"])]),
    (&["arm", "propeller_radius", "size"], &[(5.0, &["m"]), (60.0, &["cm"]), (100.0, &["cm", "mm"]), (ANY, &["mm"])]),
    (&["torque_per_thrust"], &[(0.5, &["m"]), (5.0, &["cm", "mm"]), (ANY, &["mm"])]),
    (&["mass"], &[(50.0, &["kg"]), (1000.0, &["g", "kg"]), (ANY, &["g"])]),
    (&["max_thrust"], &[(100.0, &["N"]), (500.0, &["N", "gf"]), (ANY, &["gf", "N"])]),
    // The smallest rotors reach 4000 rad/s, the largest less than 1500 rpm.
    (
        &["max_speed", "min_speed"],
        &[(50.0, &["rad/s"]), (1500.0, &["rad/s", "rpm"]), (4000.0, &["rpm", "rad/s"]), (ANY, &["rpm"])],
    ),
    // Packs of small quadcopters hold 0.1 A*h, those of the largest multirotors less than 200 A*h.
    (&["capacity"], &[(90.0, &["A*h"]), (200.0, &["A*h", "mA*h"]), (ANY, &["mA*h"])]),
    (&["time_constant"], &[(1.0, &["s"]), (ANY, &["ms"])]),
    (&["detection"], &[(1.0, &["s"]), (10.0, &["s", "ms"]), (ANY, &["ms"])]),
];

/// Units of angles and of their rates, in degrees and in radians.
const RADIANS: [(&str, &str); 3] = [("deg", "rad"), ("deg/s", "rad/s"), ("deg/s^2", "rad/s^2")];

/// The largest number that may be an angle in radians: a full turn, rounded up.
const TURN: f64 = 6.4;

/// The same for a tilt: a quarter turn, rounded up.
const QUARTER: f64 = 1.6;

/// The likely units of a plain number of this size, the likeliest first: at least one, and more than one where only the
/// author can know.
pub(super) fn likely_units(due: Due, size: f64) -> Vec<&'static str> {
    let size = size.abs();
    if let Some((_, sizes)) = FIELDS.iter().find(|(names, _)| names.contains(&due.what)) {
        let fits = sizes.iter().find(|(below, _)| size < *below);
        return fits.map_or(vec![due.unit], |(_, units)| units.to_vec());
    }
    let may_be_radians = size > 0.0 && size <= if due.what == "tilt" { QUARTER } else { TURN };
    let radians = RADIANS.iter().find(|(degrees, _)| may_be_radians && *degrees == due.unit);
    [due.unit].into_iter().chain(radians.map(|(_, radians)| *radians)).collect()
}

impl Context<'_> {
    /// As [`likely_units`], for the value of `expr`, whose form may show that it is in radians: `pi/2`, or the parameter of a
    /// curve that runs through full turns.
    pub(super) fn likely_units_of(&self, due: Due, size: f64, expr: &Expr) -> Vec<&'static str> {
        let written = self.let_behind(expr).map_or(expr, |(_, value)| value);
        let radians = RADIANS.iter().find(|(degrees, _)| *degrees == due.unit).map(|(_, radians)| *radians);
        match radians.filter(|_| self.is_in_radians(written)) {
            Some(radians) => vec![radians],
            None => likely_units(due, size),
        }
    }

    /// Whether an expression has the form of an angle in radians.
    fn is_in_radians(&self, expr: &Expr) -> bool {
        let turns = |name: &str| name == "pi" || self.parameter_turns && self.is_parameter(name);
        let names = |e: &Expr| matches!(&e.kind, ExprKind::Name(name) if turns(name));
        // `s*180/pi` converts to degrees.
        let converts =
            |e: &Expr| matches!(&e.kind, ExprKind::Number { text, .. } if matches!(text.as_str(), "180" | "360"));
        any_part(expr, &names) && !any_part(expr, &converts)
    }
}

/// Whether the curve parameter `parameter` is an angle in radians: its range is written with `pi`, or one of the expressions
/// takes its sine, cosine or tangent.
pub(super) fn runs_through_turns(parameter: &str, range: &Expr, expressions: &[Option<&Expr>]) -> bool {
    let named = |wanted: &'static str| move |e: &Expr| matches!(&e.kind, ExprKind::Name(name) if name == wanted);
    let is_parameter = |e: &Expr| matches!(&e.kind, ExprKind::Name(name) if name == parameter);
    let turned = |e: &Expr| match &e.kind {
        ExprKind::Call { function, arguments, .. } => {
            matches!(function.value.as_str(), "sin" | "cos" | "tan")
                && arguments.iter().any(|argument| any_part(argument, &is_parameter))
        }
        _ => false,
    };
    any_part(range, &named("pi")) || expressions.iter().flatten().any(|expr| any_part(expr, &turned))
}

/// Whether `wanted` holds for `expr` or for a part of it.
fn any_part(expr: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let within = |part: &Expr| any_part(part, wanted);
    wanted(expr)
        || match &expr.kind {
            ExprKind::Paren { inner, .. } | ExprKind::Negate(inner) => within(inner),
            ExprKind::List { elements, .. } | ExprKind::Call { arguments: elements, .. } => elements.iter().any(within),
            ExprKind::Binary { left, right, .. }
            | ExprKind::Range { low: left, high: right }
            | ExprKind::Interval { value: left, by: right } => within(left) || within(right),
            ExprKind::Number { .. } | ExprKind::Name(_) | ExprKind::Text(_) | ExprKind::Unknown => false,
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::parse_unit;

    #[test]
    fn a_field_has_units_of_one_dimension_and_larger_numbers_have_smaller_units() {
        for (names, sizes) in FIELDS {
            let first = parse_unit(sizes[0].1[0], 9.81).unwrap();
            let scale = |unit: &str| {
                let unit = parse_unit(unit, 9.81).unwrap();
                assert_eq!(unit.dimension, first.dimension, "{names:?}");
                unit.numerator / unit.denominator
            };
            assert!(sizes.is_sorted_by(|a, b| a.0 < b.0), "{names:?}");
            assert!(sizes.is_sorted_by(|a, b| scale(a.1[0]) >= scale(b.1[0])), "{names:?}");
            assert_eq!(sizes.last().map(|(below, _)| *below), Some(ANY), "{names:?}");
        }
    }

    #[test]
    fn only_small_angles_may_be_radians() {
        let of = |what, unit, size| likely_units(Due::new(what, unit), size);
        assert_eq!(of("yaw", "deg", -1.57), ["deg", "rad"]);
        assert_eq!(of("yaw", "deg", 90.0), ["deg"]);
        assert_eq!(of("tilt", "deg", 3.0), ["deg"]);
        assert_eq!(of("yaw_rate", "deg/s", 2.0), ["deg/s", "rad/s"]);
        assert_eq!(of("at", "m", 2.0), ["m"]);
        assert_eq!(of("max_speed", "rad/s", 8500.0), ["rpm"]);
    }
}
