//! Guesses from its size which unit a plain number was meant to have.

use super::context::Context;
use super::expected::Expected;
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::visit::Visit;

/// Units of angles and of their rates, in degrees and in radians.
const RADIANS: [(&str, &str); 3] = [("deg", "rad"), ("deg/s", "rad/s"), ("deg/s^2", "rad/s^2")];

/// The largest number that may be an angle in radians: a full turn, rounded up.
const TURN: f64 = 6.4;

/// The same for a tilt: a quarter turn, rounded up.
const QUARTER: f64 = 1.6;

/// The likely units of a plain number of this size, the likeliest first: at least one, and more than one where only the
/// author can know.
pub(super) fn likely_units(due: Expected, size: f64) -> Vec<&'static str> {
    let size = size.abs();
    let sizes = due.row.map_or(&[][..], |row| row.likely);
    if let Some((_, units)) = sizes.iter().find(|(below, _)| size < *below) {
        return units.to_vec();
    }
    let may_be_radians = size > 0.0 && size <= if due.what == "tilt" { QUARTER } else { TURN };
    let radians = RADIANS.iter().find(|(degrees, _)| may_be_radians && *degrees == due.unit);
    [due.unit].into_iter().chain(radians.map(|(_, radians)| *radians)).collect()
}

impl Context<'_> {
    /// As [`likely_units`], for the value of `expr`, whose form may show that it is in radians: `pi/2`, or the
    /// parameter of a curve that runs through full turns.
    pub(super) fn likely_units_of(&self, due: Expected, size: f64, expr: &Expr) -> Vec<&'static str> {
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

/// Whether the curve parameter `parameter` is an angle in radians: its range is written with `pi`, or one of the
/// expressions takes its sine, cosine or tangent.
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
    struct Search<'w> {
        wanted: &'w dyn Fn(&Expr) -> bool,
        found: bool,
    }
    impl<'t> Visit<'t> for Search<'_> {
        fn expr(&mut self, expr: &'t Expr) {
            self.found |= (self.wanted)(expr);
            self.walk_expr(expr);
        }
    }
    let mut search = Search { wanted, found: false };
    search.expr(expr);
    search.found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::table::rotor;

    #[test]
    fn only_small_angles_may_be_radians() {
        let of = |what, unit, size| likely_units(Expected::new(what, unit), size);
        assert_eq!(of("yaw", "deg", -1.57), ["deg", "rad"]);
        assert_eq!(of("yaw", "deg", 90.0), ["deg"]);
        assert_eq!(of("tilt", "deg", 3.0), ["deg"]);
        assert_eq!(of("yaw_rate", "deg/s", 2.0), ["deg/s", "rad/s"]);
        assert_eq!(of("at", "m", 2.0), ["m"]);
        assert_eq!(likely_units(Expected::of(&rotor::MAX_SPEED), 8500.0), ["rpm"]);
    }
}
