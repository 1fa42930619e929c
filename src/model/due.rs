//! What a place in the spec expects: a quantity of some dimension, a positive one, a whole number, a share.

use super::context::Context;
use super::expression::Value;
use crate::diagnostic::Diagnostic;
use crate::report::number::number;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind};
use crate::unit::{Dimension, Quantity, mismatch, parse_unit};

/// What a field or clause takes: its name as the author writes it, and the unit one would write.
#[derive(Clone, Copy)]
pub(super) struct Due<'t> {
    pub what: &'t str,
    /// A unit text of the right dimension; `1` for a plain number.
    pub unit: &'static str,
    /// Whether the dimension may also be spelled without its radians.
    pub coefficient: bool,
}

impl<'t> Due<'t> {
    pub fn new(what: &'t str, unit: &'static str) -> Self {
        Due { what, unit, coefficient: false }
    }

    pub fn dimension(&self) -> Dimension {
        parse_unit(self.unit, 1.0).map_or(Dimension::PLAIN, |unit| unit.dimension)
    }
}

impl<'a> Context<'a> {
    /// A single quantity of the dimension due, in SI.
    pub fn number(&mut self, due: Due, expr: &'a Expr) -> Option<f64> {
        let q = self.evaluate_quantity(expr)?;
        self.lower(due, q, expr)
    }

    /// As [`Context::number`], above zero; `code` names the mistake of one that is not.
    pub fn positive(&mut self, due: Due, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(due, expr)?;
        self.require(value > 0.0, code, due.what, "has to be greater than zero", value, due.unit, expr.span)
    }

    /// As [`Context::number`], zero or above.
    pub fn not_negative(&mut self, due: Due, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(due, expr)?;
        self.require(value >= 0.0, code, due.what, "cannot be negative", value, due.unit, expr.span)
    }

    #[allow(clippy::too_many_arguments)]
    fn require(
        &mut self,
        holds: bool,
        code: &'static str,
        what: &str,
        rule: &str,
        value: f64,
        unit: &str,
        span: Span,
    ) -> Option<f64> {
        if holds {
            return Some(value);
        }
        let scale = parse_unit(unit, self.gravity).map_or(1.0, |unit| unit.numerator / unit.denominator);
        let found = number(value / scale);
        let found = if unit == "1" { found } else { format!("{found} {unit}") };
        let error = Diagnostic::error(code, span, format!("`{what}` {rule}"));
        self.report(error.here(format!("this is {found}")));
        None
    }

    /// A share of a whole, `60 %` or `0.6`, as a number in 0..=1.
    pub fn share(&mut self, what: &str, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(Due::new(what, "1"), expr)?;
        if (0.0..=1.0).contains(&value) {
            return Some(value);
        }
        let mut error = Diagnostic::error(code, expr.span, format!("{what} lies between 0 % and 100 %"))
            .here(format!("this is {} %", number(value * 100.0)));
        if let ExprKind::Number { text, unit: None, .. } = &expr.kind
            && value <= 100.0
            && value > 0.0
        {
            error = error.help(format!("for percent, write `{text} %`")).fix(expr.span, format!("{text} %"));
        }
        self.report(error);
        None
    }

    /// A plain whole number within `range`.
    pub fn whole(
        &mut self,
        what: &str,
        expr: &'a Expr,
        range: std::ops::RangeInclusive<usize>,
        code: &'static str,
    ) -> Option<usize> {
        let value = self.number(Due::new(what, "1"), expr)?;
        self.whole_value(what, value, expr.span, range, code)
    }

    pub fn whole_value(
        &mut self,
        what: &str,
        value: f64,
        span: Span,
        range: std::ops::RangeInclusive<usize>,
        code: &'static str,
    ) -> Option<usize> {
        let (low, high) = (*range.start(), *range.end());
        if value.fract() == 0.0 && value >= low as f64 && value <= high as f64 {
            return Some(value as usize);
        }
        let message = format!("{what} is a whole number from {low} to {high}");
        self.report(Diagnostic::error(code, span, message).here(format!("this is {}", number(value))));
        None
    }

    /// `[x, y, z] m`: three quantities of the dimension due, in SI.
    pub fn triple(&mut self, due: Due, expr: &'a Expr) -> Option<[f64; 3]> {
        let list = match self.evaluate(expr)? {
            Value::List(list) => list,
            other => {
                return self.wrong_kind(&other, &format!("a list of three for `{}`", due.what), expr.span);
            }
        };
        let [x, y, z] = list[..] else {
            let message = format!("`{}` takes three numbers, not {}", due.what, list.len());
            let error = Diagnostic::error("mavc::unit::kind", expr.span, message);
            self.report(error.here(format!("{} here", list.len())).help(format!("write `[x, y, z] {}`", due.unit)));
            return None;
        };
        // Three of one wrong kind are one mistake.
        if x.dimension == y.dimension && y.dimension == z.dimension {
            self.lower(due, x, expr)?;
            return Some([x.value, y.value, z.value]);
        }
        let place = |k: usize| match &expr.kind {
            ExprKind::List { elements, .. } => elements.get(k).unwrap_or(expr),
            _ => expr,
        };
        let lowered = [x, y, z].into_iter().enumerate().map(|(k, q)| self.lower(due, q, place(k)));
        // All three are looked at before any is given up, so that each mistake is told.
        let [x, y, z] = lowered.collect::<Vec<_>>()[..] else {
            return None;
        };
        Some([x?, y?, z?])
    }

    /// `a .. b` of the dimension due, in SI, in the order written.
    pub fn range_of(&mut self, due: Due, expr: &'a Expr) -> Option<(f64, f64)> {
        match self.evaluate(expr)? {
            Value::Range(a, b) => Some((self.lower(due, a, expr)?, self.lower(due, b, expr)?)),
            other => self.wrong_kind(&other, &format!("a range `a .. b` for `{}`", due.what), expr.span),
        }
    }

    /// Drops the dimension of `q` once it is the one due.
    pub fn lower(&mut self, due: Due, q: Quantity, expr: &Expr) -> Option<f64> {
        let expected = due.dimension();
        if q.dimension == expected {
            return Some(q.value);
        }
        if due.coefficient && q.dimension == expected.without_angle() {
            let message = format!("`{}` is usually given per square of a rate in radians", due.what);
            self.report(
                Diagnostic::advice("mavc::unit::radian", expr.span, message)
                    .here(format!("taken as {}", due.unit))
                    .help(format!("write `{}` to say so", due.unit)),
            );
            return Some(q.value);
        }
        let error = if q.dimension.is_plain() { self.unit_missing(due, expr) } else { self.unit_differs(due, q, expr) };
        self.report(error);
        None
    }

    fn unit_missing(&self, due: Due, expr: &Expr) -> Diagnostic {
        let kind = due.dimension().named().map_or("a quantity", |(name, _)| name);
        let message = format!("{} is {kind} and needs a unit", called(due.what));
        let error = Diagnostic::error("mavc::unit::missing", expr.span, message).here("a plain number");
        if let ExprKind::Number { text, unit: Some(percent), .. } = &expr.kind {
            let mended = format!("{text} {}", due.unit);
            return error
                .here(format!("`{}` makes a share of it", percent.value))
                .help(format!("write `{mended}`"))
                .fix(expr.span, mended);
        }
        if matches!(expr.kind, ExprKind::Range { .. }) {
            return error.help(format!("put the unit at the end, as in `0 .. 1 {}`", due.unit));
        }
        match self.with_unit(expr, due.unit) {
            Some(mended) => error.help(format!("write `{mended}`")).fix(expr.span, mended),
            None => error.help(format!("put a unit behind it: `(...) {}`", due.unit)),
        }
    }

    /// The text of `expr` with a unit behind it, where that fits on a line.
    pub(super) fn with_unit(&self, expr: &Expr, unit: &str) -> Option<String> {
        let text = self.sources.snippet(expr.span).trim();
        let closed = match &expr.kind {
            ExprKind::Negate(inner) => matches!(inner.kind, ExprKind::Number { .. }),
            ExprKind::Name(_) | ExprKind::Binary { .. } => false,
            _ => true,
        };
        let mended = if closed { format!("{text} {unit}") } else { format!("({text}) {unit}") };
        (mended.len() <= 48 && !mended.contains('\n')).then_some(mended)
    }

    fn unit_differs(&self, due: Due, q: Quantity, expr: &Expr) -> Diagnostic {
        let expected = due.dimension();
        let takes = if expected.is_plain() { "a plain number".into() } else { expected.describe() };
        let found = q.dimension.describe();
        let told = mismatch(expected, q.dimension);
        let error = Diagnostic::error(
            "mavc::unit::mismatch",
            expr.span,
            format!("{} takes {takes}, not {found}", called(due.what)),
        )
        .here(format!("this is {found}"));
        let action = match self.likely_slip(expected, expr) {
            Some(slip) => slip,
            None if q.dimension == expected.without_angle() => match due.unit {
                "rad/s" => "say the angle too: turns in a second are written `rev/s`, in a minute `rpm`".to_string(),
                unit => format!("say the angle too, as in `{unit}`: one turn is 2*pi rad"),
            },
            None => told.action.unwrap_or_default(),
        };
        error.help(format!("{}\n{action}", told.table).trim_end().to_string())
    }

    /// A well-known slip behind a mismatch: `2 g` for twice gravity, `2 s` for twice the parameter `s`.
    pub(super) fn likely_slip(&self, expected: Dimension, expr: &Expr) -> Option<String> {
        let mut units = Vec::new();
        collect_units(expr, &mut units);
        let acceleration = Due::new("", "m/s^2").dimension();
        if expected == acceleration && units.contains(&"g") {
            return Some("`g` is the gram; for gravity write `2*g0`".into());
        }
        let name = units.into_iter().find(|unit| self.in_scope(unit))?;
        Some(format!("`{name}` after a number is the unit; to multiply by the name `{name}`, write `2*{name}`"))
    }

    fn in_scope(&self, name: &str) -> bool {
        self.lets.contains_key(name) || self.parameter.is_some_and(|(parameter, _)| parameter == name)
    }
}

/// A field by its name in backquotes, anything else as it is said.
fn called(what: &str) -> String {
    if what.contains([' ', '`']) { what.to_string() } else { format!("`{what}`") }
}

fn collect_units<'e>(expr: &'e Expr, into: &mut Vec<&'e str>) {
    let mut note = |unit: &'e Option<crate::syntax::ast::UnitText>| into.extend(unit.iter().map(|u| u.value.as_str()));
    match &expr.kind {
        ExprKind::Number { unit, .. } => note(unit),
        ExprKind::Paren { inner, unit } => {
            note(unit);
            collect_units(inner, into);
        }
        ExprKind::List { elements, unit } => {
            note(unit);
            elements.iter().for_each(|e| collect_units(e, into));
        }
        ExprKind::Call { arguments, .. } => arguments.iter().for_each(|e| collect_units(e, into)),
        ExprKind::Negate(inner) => collect_units(inner, into),
        ExprKind::Binary { left, right, .. } | ExprKind::Range { low: left, high: right } => {
            collect_units(left, into);
            collect_units(right, into);
        }
        ExprKind::Name(_) | ExprKind::Text(_) => {}
    }
}
