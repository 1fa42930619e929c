//! What a place in the spec expects: a quantity of some dimension, a positive one, a whole number, a share.

use super::context::{Context, State};
use super::elaborate::expr_of;
use super::expression::{Value, is_bare, trailing_unit};
use super::overrides::OVERRIDE;
use crate::diagnostic::Diagnostic;
use crate::report::number::number;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Expr, ExprKind, Operator};
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
        if value > 0.0 {
            return Some(value);
        }
        self.wrong_sign(due, "has to be greater than zero", value, expr, code)
    }

    /// As [`Context::number`], zero or above.
    pub fn not_negative(&mut self, due: Due, expr: &'a Expr, code: &'static str) -> Option<f64> {
        let value = self.number(due, expr)?;
        if value >= 0.0 {
            return Some(value);
        }
        self.wrong_sign(due, "cannot be negative", value, expr, code)
    }

    fn wrong_sign<T>(&mut self, due: Due, rule: &str, value: f64, expr: &Expr, code: &'static str) -> Option<T> {
        let scale = parse_unit(due.unit, self.gravity).map_or(1.0, |unit| unit.numerator / unit.denominator);
        let found = number(value / scale);
        let found = if due.unit == "1" { found } else { format!("{found} {}", due.unit) };
        let error = Diagnostic::error(code, expr.span, format!("`{}` {rule}", due.what));
        let error = error.here(format!("this is {found}"));
        self.report(match &expr.kind {
            ExprKind::Negate(inner) if value < 0.0 => {
                let mended = self.sources.snippet(inner.span);
                error.help(format!("take the sign out: write `{mended}`")).fix(expr.span, mended)
            }
            _ if value < 0.0 => error.help("look for the sign that makes it negative"),
            _ => error.help("write a value above zero"),
        });
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
        } else {
            error = error.help("write a share such as `10 %`");
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
        let help = match value {
            v if v < low as f64 => format!("write `{low}` or more"),
            v if v > high as f64 => format!("write `{high}` or less"),
            v => format!("write `{}` or `{}`", v.floor(), v.ceil()),
        };
        self.report(Diagnostic::error(code, span, message).here(format!("this is {}", number(value))).help(help));
        None
    }

    /// `[x, y, z] m`: three quantities of the dimension due, in SI.
    pub fn triple(&mut self, due: Due, expr: &'a Expr) -> Option<[f64; 3]> {
        let list = match self.evaluate(expr)? {
            Value::List(list) => list,
            other => {
                let message = format!("a list of three for `{}` is due here, not {}", due.what, other.kind());
                let error = Diagnostic::error("mavc::unit::kind", expr.span, message);
                let error = error.here(format!("this is {}", other.kind()));
                self.report(error.help(format!("write `[x, y, z] {}`", due.unit)));
                return None;
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
            self.fit(due, x, expr)?;
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
        // A unit behind the list goes to every bare element, whether or not the others have theirs.
        if is_list && others_fit && bare.len() > 1 && bare.iter().any(|e| sole_name(e).is_none()) {
            let mut error = self.unit_missing(due, expr);
            error.span = bare[0].span;
            let error = bare[1..].iter().fold(error, |error, e| error.also(e.span, "and so is this"));
            self.report(error);
            return None;
        }
        let lowered = [x, y, z].into_iter().enumerate().map(|(k, q)| self.fit(due, q, place(k)));
        // All three are looked at before any is given up, so that each mistake is told.
        let [x, y, z] = lowered.collect::<Vec<_>>()[..] else {
            return None;
        };
        let [x, y, z] = [x?, y?, z?];
        self.note(expr.span, &[x, y, z], due.unit);
        Some([x, y, z])
    }

    /// `a .. b` of the dimension due, in SI, in the order written.
    pub fn range_of(&mut self, due: Due, expr: &'a Expr) -> Option<(f64, f64)> {
        let (a, b) = self.range_ends(expr, &format!("a range `a .. b` for `{}`", due.what))?;
        let (a, b) = (self.fit(due, a, expr)?, self.fit(due, b, expr)?);
        self.note(expr.span, &[a, b], due.unit);
        Some((a, b))
    }

    /// Drops the dimension of `q` once it is the one due, and notes what was read.
    pub fn lower(&mut self, due: Due, q: Quantity, expr: &Expr) -> Option<f64> {
        let value = self.fit(due, q, expr)?;
        self.note(expr.span, &[value], due.unit);
        Some(value)
    }

    /// As [`Context::lower`], of a part of what is read.
    fn fit(&mut self, due: Due, q: Quantity, expr: &Expr) -> Option<f64> {
        let expected = due.dimension();
        if q.dimension == expected {
            return Some(q.value);
        }
        if due.coefficient && q.dimension == expected.without_angle() {
            let message = format!("`{}` is usually given per square of a rate in radians", due.what);
            let advice = Diagnostic::advice("mavc::unit::radian", expr.span, message)
                .here(format!("taken as {}", due.unit))
                .help(format!("write `{}` to say so", due.unit));
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
        let error = match q.dimension.is_plain() {
            true if self.is_blamed(expr) => return None,
            true => {
                let error = self.unit_missing(due, expr);
                self.blame(expr, due.unit, error)
            }
            false => self.unit_differs(due, q, expr),
        };
        self.report(error);
        None
    }

    /// Where `expr` lacks a unit because a `let` does, says so there, once: other uses of the `let` stay silent.
    pub(super) fn blame(&mut self, expr: &Expr, unit: &str, error: Diagnostic) -> Diagnostic {
        let mut chain = Vec::new();
        let mut found: Option<&'a Expr> = None;
        let mut name = sole_name(expr);
        while let Some((&key, entry)) = name.filter(|n| !self.is_parameter(n)).and_then(|n| self.lets.get_key_value(n))
        {
            found = expr_of(entry.field);
            name = found.and_then(sole_name);
            chain.push(key);
        }
        let (Some(value), Some(&last)) = (found.filter(|e| trailing_unit(e).is_none()), chain.last()) else {
            return error;
        };
        let Some(mended) = self.with_unit(value, unit) else {
            return error;
        };
        for name in &chain {
            if let Some(entry) = self.lets.get_mut(name) {
                entry.state = State::Done(None);
            }
        }
        let help = match self.sources.get(value.span.file).name == OVERRIDE {
            true => format!("write `--set {last}={}`", mended.replace(' ', "")),
            false => format!("write `let {last} = {mended}`"),
        };
        error.also(value.span, format!("`{last}` has no unit here")).help(help).fix(value.span, mended)
    }

    /// Whether the `let` behind `expr` has been told to lack its unit since it was evaluated.
    fn is_blamed(&self, expr: &Expr) -> bool {
        let name = sole_name(expr).filter(|name| !self.is_parameter(name));
        name.and_then(|n| self.lets.get(n)).is_some_and(|l| matches!(l.state, State::Done(None)))
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
        if let ExprKind::Binary { operator, left, right } = &expr.kind
            && let Some((value, unit)) = joined_unit(operator.value, left, right, &|_| true)
            && parse_unit(&unit, self.gravity).is_ok_and(|unit| unit.dimension == expected)
        {
            let (name, number) = (self.sources.snippet(right.span), self.without_unit(value));
            return Some(format!("`{name}` is a name here; with the unit `{name}`, write `{number} {unit}`"));
        }
        let name = units.into_iter().find(|unit| self.in_scope(unit))?;
        Some(format!("`{name}` after a number is the unit; to multiply by the name `{name}`, write `2*{name}`"))
    }

    /// A value as written, its unit aside.
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

    fn is_parameter(&self, name: &str) -> bool {
        self.parameter.is_some_and(|(parameter, _)| parameter == name)
    }
}

/// The name that an expression is, its sign aside.
fn sole_name(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Negate(inner) | ExprKind::Paren { inner, unit: None } => sole_name(inner),
        _ => None,
    }
}

/// A value and names joined to it as if they were its unit, `2e-5 / h` or `[1, 2, 3] kg * m ^ 2`: the value and that unit.
/// All the names are such as `may_be_unit` lets pass.
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
    // No unit that people write is longer, and a long product is looked at again for each of its factors.
    (unit.len() <= 48).then_some((value, unit))
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
        ExprKind::Binary { left, right, .. }
        | ExprKind::Range { low: left, high: right }
        | ExprKind::Interval { value: left, by: right } => {
            collect_units(left, into);
            collect_units(right, into);
        }
        ExprKind::Name(_) | ExprKind::Text(_) => {}
    }
}
