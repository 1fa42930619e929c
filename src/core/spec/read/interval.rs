//! Intervals as they are written: `1.8 kg +- 3 %`, `1.8 kg +- 50 g`.

use super::context::Context;
use super::expected::Expected;
use super::expression::{Value, is_bare, trailing_unit};
use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::model::Spread;
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, UnitText};
use crate::unit::Quantity;

const INTERVAL: &str = "mavc::unit::interval";

/// An interval as it is written: `value +- by`, or `(value +- by) unit`.
pub(super) struct Written<'a> {
    value: &'a Expr,
    by: &'a Expr,
    unit: Option<&'a UnitText>,
}

/// The interval that an expression consists of, in parentheses or not.
pub(super) fn written(expr: &Expr) -> Option<Written<'_>> {
    match &expr.kind {
        ExprKind::Interval { value, by } => Some(Written { value, by, unit: None }),
        ExprKind::Paren { inner, unit } => {
            let inside = written(inner)?;
            // With two units there is nothing for the outer one to apply to.
            (inside.unit.is_none() || unit.is_none()).then(|| Written { unit: unit.as_ref().or(inside.unit), ..inside })
        }
        _ => None,
    }
}

impl<'a> Context<'a> {
    /// A quantity above zero in SI units, and the interval around it as factors of it, if one is written; `code` is the
    /// error code of a value or an interval that does not lie above zero.
    pub(super) fn interval(&mut self, due: Expected, expr: &'a Expr, code: &'static str) -> Option<(f64, Spread)> {
        let Some(Written { value, by, unit }) = written(expr) else {
            return self.positive(due, expr, code).map(|value| (value, Spread::NONE));
        };
        let (middle, width) = (self.evaluate_quantity(value), self.evaluate_quantity(by));
        let (mut middle, mut width) = (middle?, width?);
        if let Some(text) = unit {
            let unit = self.unit(text)?;
            middle = self.attach_one(middle, unit, text, value.span)?;
            if is_bare(width, by) {
                width = Quantity::with_unit(width.value, unit);
            }
        }
        // A unit at the end applies to a bare middle: `1.8 +- 0.05 kg`.
        if is_bare(middle, value)
            && let Some(text) = trailing_unit(by)
        {
            let unit = self.unit(text)?;
            if unit.dimension == width.dimension && !width.dimension.is_plain() {
                middle = Quantity::with_unit(middle.value, unit);
            }
        }
        if let (ExprKind::Number { text, unit: None, .. }, false) = (&by.kind, middle.dimension.is_plain())
            && width.dimension.is_plain()
        {
            let percent = number(100.0 * width.value);
            let error = Diagnostic::error(INTERVAL, by.span, format!("`+- {text}` needs a unit or `%`"))
                .here("missing unit")
                .help(format!("write `{text} {}`, or `{percent} %`", due.unit));
            self.report(error);
            return None;
        }
        let middle = self.lower(due, middle, value)?;
        let share = match width.dimension.is_plain() {
            true => width.value,
            false => self.lower(due, width, by)? / middle,
        };
        if middle > 0.0 && (0.0..1.0).contains(&share) {
            self.note(expr.span, &[(1.0 - share) * middle, (1.0 + share) * middle], due.unit);
            return Some((middle, Spread { low: 1.0 - share, high: 1.0 + share }));
        }
        let (message, at, help) = match () {
            _ if middle <= 0.0 => {
                (format!("`{}` must be greater than zero", due.what), value.span, "write a value above zero")
            }
            _ if share < 0.0 => ("the value after `+-` cannot be negative".into(), by.span, "remove the minus sign"),
            _ => (
                format!("the interval of `{}` reaches zero", due.what),
                by.span,
                "write a narrower interval, all of it above zero",
            ),
        };
        let here = match middle <= 0.0 {
            true => "not above zero".to_string(),
            false => format!("this is {} % of the value", number(100.0 * share)),
        };
        self.report(Diagnostic::error(INTERVAL, at, message).here(here).help(help));
        None
    }

    /// A quantity of the language table in SI units, and the interval around it as factors of it, if one is written. An
    /// interval lies above zero, even if one number may be zero.
    pub(super) fn maybe_interval(
        &mut self,
        entry: &'static Entry,
        expr: &'a Expr,
        code: &'static str,
    ) -> Option<(f64, Spread)> {
        match written(expr) {
            Some(_) => self.interval(Expected::of(entry), expr, code),
            None => self.quantity(entry, expr, code).map(|value| (value, Spread::NONE)),
        }
    }

    /// The interval around a list of values, a share of each: `20 %`.
    pub(super) fn share_of_list(&mut self, entry: &'static Entry, by: &'a Expr) -> Option<Spread> {
        let width = self.evaluate_quantity(by)?;
        let is_share = width.dimension.is_plain() && !is_bare(width, by) && (0.0..1.0).contains(&width.value);
        if !is_share {
            let message =
                format!("the interval of three values of `{}` must be a share of them below 100 %", entry.name);
            let error = Diagnostic::error(INTERVAL, by.span, message).here("not such a share");
            self.report(error.help("write a percentage: `+- 20 %`"));
        }
        is_share.then_some(Spread { low: 1.0 - width.value, high: 1.0 + width.value })
    }

    /// Reports an interval where one number is expected.
    pub(super) fn no_interval(&mut self, value: &'a Expr, by: &'a Expr, span: Span) -> Option<Value> {
        let error = Diagnostic::error(INTERVAL, span, "an interval is not allowed here").here("expected one number");
        let [value, by] = [value, by].map(|e| self.sources.snippet(e.span).to_string());
        self.report(error.help(format!(
            "write `{value}` without `+- {by}`; an interval is allowed only in the fields `mass`, `drag`, \
             `yaw_drag` and `rate`, and in a rotor `max_thrust`, `thrust_coefficient`, `torque_per_thrust`, \
             `drag_coefficient`, `max_speed` and `rotor_inertia`"
        )));
        None
    }
}
