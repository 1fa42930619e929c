//! Reads what a place in the spec expects: a quantity of some dimension, a positive one, a whole number, a share.

use super::blame::sole_name;
use super::context::Context;
use super::expression::{Value, is_bare};
use super::interval::written;
use super::likely_unit::likely_units;
use crate::diagnostic::Diagnostic;
use crate::language::{Entry, Range, Takes};
use crate::model::Spread;
use crate::number::number;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Expr, ExprKind, Operator};
use crate::unit::{Dimension, Quantity, parse_unit};

/// What a field or clause expects: its name as the author writes it, and its usual unit.
#[derive(Clone, Copy)]
pub(super) struct Expected<'t> {
    pub what: &'t str,
    /// A unit text of the right dimension; `1` for a plain number.
    pub unit: &'static str,
    /// Whether the unit may also be written without its radians.
    pub coefficient: bool,
    /// Its row in the table, for bounds and guesses.
    pub row: Option<&'static Entry>,
}

impl<'t> Expected<'t> {
    /// What is expected beside the fields of the table.
    pub fn new(what: &'t str, unit: &'static str) -> Self {
        Expected { what, unit, coefficient: false, row: None }
    }

    /// What a field of the language table expects.
    pub fn of(entry: &'static Entry) -> Self {
        Expected { row: Some(entry), ..Expected::new(entry.name, entry.unit().unwrap_or("1")) }
    }

    pub fn dimension(&self) -> Dimension {
        parse_unit(self.unit, 1.0).map_or(Dimension::PLAIN, |unit| unit.dimension)
    }
}

impl<'a> Context<'a> {
    /// Remembers the unit that the number or list `expr` takes, in case its own is misspelt.
    pub(super) fn expect_unit(&mut self, due: Expected, expr: &Expr) {
        let unit = match &expr.kind {
            ExprKind::Number { unit, .. } | ExprKind::List { unit, .. } => unit.as_ref(),
            _ => None,
        };
        self.unit_due = unit.map(|unit| (unit.span, due.unit));
    }

    /// A single quantity of the expected dimension, in SI units.
    pub fn number(&mut self, due: Expected, expr: &'a Expr) -> Option<f64> {
        self.expect_unit(due, expr);
        let q = self.evaluate_quantity(expr)?;
        self.lower(due, q, expr)
    }

    /// A quantity of the expected dimension above zero, in SI units; `code` is the error code for any other value.
    pub fn positive(&mut self, due: Expected, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(due, expr)?;
        if value > 0.0 {
            return Some(value);
        }
        self.wrong_sign(due, "must be greater than zero", value, expr, code)
    }

    /// A quantity of the expected dimension, zero or above, in SI units; `code` is the error code for a negative value.
    pub fn not_negative(&mut self, due: Expected, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(due, expr)?;
        if value >= 0.0 {
            return Some(value);
        }
        self.wrong_sign(due, "cannot be negative", value, expr, code)
    }

    fn wrong_sign<T>(&mut self, due: Expected, rule: &str, value: f64, expr: &Expr, code: &'static str) -> Option<T> {
        let scale = parse_unit(due.unit, self.gravity).map_or(1.0, |unit| unit.numerator / unit.denominator);
        let found = number(value / scale);
        let found = if due.unit == "1" { found } else { format!("{found} {}", due.unit) };
        let error = Diagnostic::error(code, expr.span, format!("`{}` {rule}", due.what));
        let error = error.here(format!("this is {found}"));
        let error = match (&expr.kind, self.let_behind(expr).map(|(name, value)| (name, &value.kind))) {
            (ExprKind::Negate(inner), None) if value < 0.0 => {
                let corrected = self.sources.snippet(inner.span);
                error.help(format!("remove the minus sign: write `{corrected}`")).fix(expr.span, corrected)
            }
            (ExprKind::Name(_), Some((name, ExprKind::Negate(inner)))) if value < 0.0 => {
                let positive = self.sources.snippet(inner.span);
                error.help(format!("write `let {name} = {positive}`, or another value here"))
            }
            _ if value < 0.0 => error.help("find the sign that makes the value negative"),
            _ => error.help("write a value above zero"),
        };
        self.report_of_let(expr, rule, &found, error);
        None
    }

    /// The value of a field of the language table, in SI units; `code` is the error code for a value out of its range.
    pub fn quantity(&mut self, entry: &'static Entry, expr: &'a Expr, code: &'static str) -> Option<f64> {
        match entry.takes {
            Takes::Quantity(_, Range::Positive) | Takes::QuantityOr(_, Range::Positive, _) => {
                self.positive(Expected::of(entry), expr, code)
            }
            Takes::Quantity(_, Range::NotNegative) | Takes::QuantityOr(_, Range::NotNegative, _) => {
                self.not_negative(Expected::of(entry), expr, code)
            }
            _ => self.number(Expected::of(entry), expr),
        }
    }

    /// The whole number of a field of the language table, which messages call `what`.
    pub fn count(&mut self, entry: &'static Entry, what: &str, expr: &'a Expr, code: &'static str) -> Option<usize> {
        let (least, most) = entry.whole();
        self.whole(what, expr, least as usize..=most as usize, code)
    }

    /// A share, `60 %` or `0.6`, as a number in 0..=1.
    pub fn share(&mut self, what: &str, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(Expected::new(what, "1"), expr)?;
        if (0.0..=1.0).contains(&value) {
            return Some(value);
        }
        let mut error = Diagnostic::error(code, expr.span, format!("{what} must be between 0 % and 100 %"))
            .here(format!("this is {} %", number(value * 100.0)));
        if let ExprKind::Number { text, unit: None, .. } = &expr.kind
            && value <= 100.0
            && value > 0.0
        {
            error = error.help(format!("for percent, write `{text} %`")).fix(expr.span, format!("{text} %"));
        } else {
            error = error.help("write a share such as `10 %`");
        }
        self.report(error);
        None
    }

    /// A plain whole number within `range`, whose expression is evaluated here.
    pub fn whole(
        &mut self,
        what: &str,
        expr: &'a Expr,
        range: std::ops::RangeInclusive<usize>,
        code: &'static str,
    ) -> Option<usize> {
        let value = self.number(Expected::new(what, "1"), expr)?;
        self.whole_value(what, value, expr.span, range, code)
    }

    /// Checks that a number already evaluated is whole and within `range`; reports `code` at `span` if not.
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
        let message = format!("{what} must be a whole number from {low} to {high}");
        let help = match value {
            v if v < low as f64 => format!("write `{low}` or more"),
            v if v > high as f64 => format!("write `{high}` or less"),
            v => format!("write `{}` or `{}`", v.floor(), v.ceil()),
        };
        self.report(Diagnostic::error(code, span, message).here(format!("this is {}", number(value))).help(help));
        None
    }

    /// A drag along the axes x, y and z of the body, in SI units: `[0.35, 0.35, 0.2] N*s/m`, or one number for all of
    /// them.
    pub fn drag(&mut self, entry: &'static Entry, expr: &'a Expr, code: &'static str) -> Option<[f64; 3]> {
        let due = Expected::of(entry);
        let written = self.let_behind(expr).map_or(expr, |(_, value)| value);
        if !matches!(written.kind, ExprKind::List { .. }) {
            return self.not_negative(due, expr, code).map(|drag| [drag; 3]);
        }
        let drag = self.triple(due, expr)?;
        if let Some(bad) = drag.iter().find(|d| **d < 0.0) {
            let error = Diagnostic::error(code, expr.span, format!("`{}` cannot be negative along any axis", due.what));
            let error = error.here(format!("contains {} {}", number(*bad), due.unit));
            self.report(error.help("write three values of zero or above"));
            return None;
        }
        Some(drag)
    }

    /// A drag as [`Context::drag`] reads it, and its interval, the same share along all axes, if one is written: `0.35
    /// N*s/m +- 20 %`, `[0.35, 0.35, 0.2] N*s/m +- 20 %`.
    pub fn drag_interval(
        &mut self,
        entry: &'static Entry,
        expr: &'a Expr,
        code: &'static str,
    ) -> Option<([f64; 3], Spread)> {
        let ExprKind::Interval { value, by } = &expr.kind else {
            return match written(expr) {
                Some(_) => self.interval(Expected::of(entry), expr, code).map(|(drag, spread)| ([drag; 3], spread)),
                None => self.drag(entry, expr, code).map(|drag| (drag, Spread::NONE)),
            };
        };
        let middle = self.let_behind(value).map_or(&**value, |(_, value)| value);
        if !matches!(middle.kind, ExprKind::List { .. }) {
            return self.interval(Expected::of(entry), expr, code).map(|(drag, spread)| ([drag; 3], spread));
        }
        let (drag, spread) = (self.drag(entry, value, code), self.share_of_list(entry, by));
        Some((drag?, spread?))
    }

    /// `[x, y, z] m`: three quantities of the expected dimension, in SI units.
    pub fn triple(&mut self, due: Expected, expr: &'a Expr) -> Option<[f64; 3]> {
        self.expect_unit(due, expr);
        let Some(value) = self.evaluate(expr) else {
            self.bare_beside_errors(due, expr);
            return None;
        };
        let list = match value {
            Value::List(list) => list,
            other => {
                let message = format!("expected a list of three numbers for `{}`, found {}", due.what, other.kind());
                let error = Diagnostic::error("mavc::unit::kind", expr.span, message);
                let error = error.here(format!("this is {}", other.kind()));
                self.report(error.help(format!("write `[x, y, z] {}`", due.unit)));
                return None;
            }
        };
        let [x, y, z] = list[..] else {
            let message = format!("`{}` takes three numbers, not {}", due.what, list.len());
            let error = Diagnostic::error("mavc::unit::kind", expr.span, message);
            let error = error.here(format!("this list has {}", list.len()));
            self.report(error.help(format!("write `[x, y, z] {}`", due.unit)));
            return None;
        };
        // Three elements of the same wrong dimension are reported as one error.
        if x.dimension == y.dimension && y.dimension == z.dimension {
            for part in [x, y, z] {
                self.fit(due, part, expr)?;
            }
            self.note(expr.span, &[x.value, y.value, z.value], due.unit);
            return Some([x.value, y.value, z.value]);
        }
        let place = |k: usize| match &expr.kind {
            ExprKind::List { elements, .. } => elements.get(k).unwrap_or(expr),
            _ => expr,
        };
        let bare: Vec<&Expr> = [x, y, z]
            .into_iter()
            .enumerate()
            .map(|(k, q)| (q, place(k)))
            .filter(|(q, e)| is_bare(*q, e))
            .map(|b| b.1)
            .collect();
        let is_list = matches!(expr.kind, ExprKind::List { unit: None, .. });
        let others_fit = [x, y, z].iter().all(|q| q.dimension.is_plain() || q.dimension == due.dimension());
        // A unit after the list applies to every bare element, whether or not the others have their own.
        if is_list && others_fit && bare.len() > 1 && bare.iter().any(|e| sole_name(e).is_none()) {
            let mut error = self.unit_missing(due, 0.0, expr);
            error.span = bare[0].span;
            let error = bare[1..].iter().fold(error, |error, e| error.also(e.span, "missing unit"));
            self.report(error);
            return None;
        }
        let lowered = [x, y, z].into_iter().enumerate().map(|(k, q)| self.fit(due, q, place(k)));
        // All three are checked before any error returns, so that each one is reported.
        let [x, y, z] = lowered.collect::<Vec<_>>()[..] else {
            return None;
        };
        let [x, y, z] = [x?, y?, z?];
        self.note(expr.span, &[x, y, z], due.unit);
        Some([x, y, z])
    }

    /// `[x, y] m` or `[x, y, z] m`: two coordinates of the expected dimension, in SI units; a height does not matter.
    pub fn plane_point(&mut self, due: Expected, expr: &'a Expr) -> Option<[f64; 2]> {
        let written = self.let_behind(expr).map_or(expr, |(_, value)| value);
        if matches!(&written.kind, ExprKind::List { elements, .. } if elements.len() == 3) {
            return self.triple(due, expr).map(|[x, y, _]| [x, y]);
        }
        self.expect_unit(due, expr);
        let value = self.evaluate(expr)?;
        let [x, y] = match &value {
            Value::List(list) if matches!(list.len(), 2 | 3) => [list[0], list[1]],
            other => {
                let message = match other {
                    Value::List(list) => format!("`{}` takes two or three numbers, not {}", due.what, list.len()),
                    _ => format!("expected a point `[x, y]` for `{}`, found {}", due.what, other.kind()),
                };
                let error = Diagnostic::error("mavc::unit::kind", expr.span, message);
                let error = error.here(format!("this is {}", other.kind()));
                self.report(error.help(format!("write `[x, y] {}`", due.unit)));
                return None;
            }
        };
        let (x, y) = (self.fit(due, x, expr)?, self.fit(due, y, expr)?);
        self.note(expr.span, &[x, y], due.unit);
        Some([x, y])
    }

    /// Reports the plain numbers of a list in which another element has an error.
    fn bare_beside_errors(&mut self, due: Expected, expr: &Expr) {
        let ExprKind::List { elements, unit: None } = &expr.kind else { return };
        let mut bare = elements.iter().filter(|e| matches!(e.kind, ExprKind::Number { unit: None, .. }));
        if let Some(first) = bare.next() {
            let mut error = self.unit_missing(due, 0.0, expr);
            error.span = first.span;
            self.report(bare.fold(error, |error, e| error.also(e.span, "and so is this")));
        }
    }

    /// `a .. b` of the expected dimension, in SI units, in the order written.
    pub fn range_of(&mut self, due: Expected, expr: &'a Expr) -> Option<(f64, f64)> {
        let (a, b) = self.range_ends(expr, &format!("a range `a .. b` for `{}`", due.what))?;
        if a.dimension.is_plain() && !due.dimension().is_plain() {
            self.lacks_unit(due, a.value.abs().max(b.value.abs()), expr);
            return None;
        }
        let (a, b) = (self.fit(due, a, expr)?, self.fit(due, b, expr)?);
        self.note(expr.span, &[a, b], due.unit);
        Some((a, b))
    }

    /// Checks that `q` has the expected dimension and notes what was read; the value in SI units.
    pub fn lower(&mut self, due: Expected, q: Quantity, expr: &Expr) -> Option<f64> {
        let value = self.fit(due, q, expr)?;
        self.note(expr.span, &[value], due.unit);
        Some(value)
    }

    /// The value of `q` in SI units if it has the expected dimension, without a note for the editor: `q` may be a part
    /// of what is read.
    fn fit(&mut self, due: Expected, q: Quantity, expr: &Expr) -> Option<f64> {
        let expected = due.dimension();
        if q.dimension == expected {
            return self.is_within_magnitude(due, q.value, expr.span).then_some(q.value);
        }
        if due.coefficient && q.dimension == expected.without_angle() {
            let message = format!("the unit of `{}` is written without radians", due.what);
            let advice = Diagnostic::advice("mavc::unit::radian", expr.span, message)
                .here(format!("read as {}", due.unit))
                .help(format!("write `{}` to make the radians explicit", due.unit));
            self.report(match &expr.kind {
                ExprKind::Number { unit: Some(unit), .. }
                    if parse_unit(&format!("{}/rad^2", unit.value), 1.0).is_ok() =>
                {
                    advice.fix(unit.span, format!("{}/rad^2", unit.value))
                }
                _ => advice,
            });
            return Some(q.value);
        }
        match q.dimension.is_plain() {
            true => self.lacks_unit(due, q.value, expr),
            false => {
                let error = self.unit_differs(due, q, expr);
                self.report_of_let(expr, &expected.to_string(), &q.dimension.describe(), error);
            }
        }
        None
    }

    /// Reports a plain number of this size where a quantity is expected, unless the missing unit of its `let` has been
    /// reported already.
    fn lacks_unit(&mut self, due: Expected, size: f64, expr: &Expr) {
        if self.is_blamed(expr) {
            return;
        }
        let error = self.unit_missing(due, size, expr);
        let error = self.blame(expr, &likely_units(due, size), error);
        self.report(error);
    }

    fn unit_missing(&self, due: Expected, size: f64, expr: &Expr) -> Diagnostic {
        let kind = due.dimension().named().map_or("a quantity", |(name, _)| name);
        let message = format!("{} is {kind} and needs a unit", called(due.what));
        let error = Diagnostic::error("mavc::unit::missing", expr.span, message).here("missing unit");
        if let ExprKind::Number { text, unit: Some(percent), .. } = &expr.kind {
            let units = likely_units(due, text.parse().unwrap_or(size));
            let corrected = units.iter().map(|unit| format!("{text} {unit}")).collect();
            return one_of(error.here(format!("`{}` makes it a share", percent.value)), expr.span, corrected);
        }
        let units = likely_units(due, size);
        if let ExprKind::Range { high, .. } = &expr.kind
            && !matches!(high.kind, ExprKind::Number { .. })
        {
            let examples: Vec<String> = units.iter().map(|unit| format!("`0 .. 1 {unit}`")).collect();
            return error.help(format!("put the unit at the end, as in {}", examples.join(" or ")));
        }
        match units.iter().map(|unit| self.with_unit(expr, unit)).collect::<Option<Vec<_>>>() {
            Some(corrected) => one_of(error, expr.span, corrected),
            None => error.help(format!("add a unit: `(...) {}`", units[0])),
        }
    }

    /// The text of `expr` with a unit after it, where that fits on a line.
    pub(super) fn with_unit(&self, expr: &Expr, unit: &str) -> Option<String> {
        let text = self.sources.snippet(expr.span).trim();
        let closed = match &expr.kind {
            ExprKind::Negate(inner) => matches!(inner.kind, ExprKind::Number { .. }),
            ExprKind::Name(_) | ExprKind::Binary { .. } => false,
            _ => true,
        };
        let corrected = if closed { format!("{text} {unit}") } else { format!("({text}) {unit}") };
        (corrected.len() <= 48 && !corrected.contains('\n')).then_some(corrected)
    }

    /// A value as written, without its unit.
    pub(super) fn without_unit(&self, expr: &Expr) -> &'a str {
        let unit = match &expr.kind {
            ExprKind::Number { unit, .. } | ExprKind::List { unit, .. } | ExprKind::Paren { unit, .. } => unit.as_ref(),
            _ => None,
        };
        let end = unit.map_or(expr.span.end, |unit| unit.span.start);
        self.sources.snippet(Span { end, ..expr.span }).trim_end()
    }

    pub(super) fn in_scope(&self, name: &str) -> bool {
        self.lets.contains_key(name) || self.is_parameter(name)
    }

    pub(super) fn is_parameter(&self, name: &str) -> bool {
        self.parameter.is_some_and(|(parameter, _)| parameter == name)
    }
}

/// The error with what to write at `span`: a fix where there is one candidate, a list where only the author can choose.
fn one_of(error: Diagnostic, span: Span, corrected: Vec<String>) -> Diagnostic {
    let listed: Vec<String> = corrected.iter().map(|text| format!("`{text}`")).collect();
    let error = error.help(format!("write {}", listed.join(" or ")));
    match <[String; 1]>::try_from(corrected) {
        Ok([text]) => error.fix(span, text),
        Err(_) => error,
    }
}

/// A value and names joined to it as if they were its unit, `2e-5 / h` or `[1, 2, 3] kg * m ^ 2`: the value and that
/// unit. `may_be_unit` must hold for every name.
pub(super) fn joined_unit<'e>(
    operator: Operator,
    left: &'e Expr,
    right: &Expr,
    may_be_unit: &impl Fn(&str) -> bool,
) -> Option<(&'e Expr, String)> {
    let (name, power) = match &right.kind {
        ExprKind::Name(name) => (name, None),
        ExprKind::Binary { operator: Spanned { value: Operator::Power, .. }, left, right } => {
            match (&left.kind, &right.kind) {
                (ExprKind::Name(name), ExprKind::Number { text, unit: None, .. }) => (name, Some(text)),
                _ => return None,
            }
        }
        _ => return None,
    };
    if !matches!(operator, Operator::Divide | Operator::Multiply) || !may_be_unit(name) {
        return None;
    }
    let factor = power.map_or(name.clone(), |power| format!("{name}^{power}"));
    let (value, before) = match &left.kind {
        ExprKind::Number { unit, .. } | ExprKind::List { unit, .. } | ExprKind::Paren { unit, .. } => {
            (left, unit.as_ref().map(|unit| unit.value.clone()))
        }
        ExprKind::Binary { operator, left, right } => {
            let (value, unit) = joined_unit(operator.value, left, right, may_be_unit)?;
            (value, Some(unit))
        }
        _ => return None,
    };
    let unit = match (operator, before) {
        (Operator::Divide, unit) => format!("{}/{factor}", unit.as_deref().unwrap_or("1")),
        (_, Some(unit)) => format!("{unit}*{factor}"),
        (_, None) => factor,
    };
    // No real unit is longer, and a long product is examined again for each of its factors.
    (unit.len() <= 48).then_some((value, unit))
}

/// A field name in backquotes; a phrase as it is.
pub(super) fn called(what: &str) -> String {
    if what.contains([' ', '`']) { what.to_string() } else { format!("`{what}`") }
}
