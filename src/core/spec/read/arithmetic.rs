//! The operators: on two numbers, and element by element on lists.

use super::context::{CONSTANTS, Context};
use super::expected::joined_unit;
use super::expression::{Value, trailing_unit};
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Expr, ExprKind, Operator};
use crate::unit::{Quantity, compare, parse_unit};

/// `left operator right`
#[derive(Clone, Copy)]
struct Join<'e, 'a> {
    operator: &'e Spanned<Operator>,
    left: &'a Expr,
    right: &'a Expr,
}

impl<'a> Context<'a> {
    /// `left operator right`; `span` covers both.
    pub(super) fn binary(
        &mut self,
        operator: &Spanned<Operator>,
        left: &'a Expr,
        right: &'a Expr,
        span: Span,
    ) -> Option<Value> {
        use Operator::{Add, Divide, Multiply, Subtract};
        use Value::{List, Quantity as One};
        if self.stands_apart(operator, left, right) {
            return None;
        }
        let (a, b) = (self.evaluate(left), self.evaluate(right));
        let join = Join { operator, left, right };
        match (a?, b?) {
            (One(a), One(b)) => {
                let q = self.combine(join, a, b)?;
                self.finite(q, span)
            }
            (List(a), One(b)) if matches!(operator.value, Multiply | Divide) => {
                self.each(join, a.into_iter().map(|a| (a, b)), span)
            }
            (One(a), List(b)) if operator.value == Multiply => self.each(join, b.into_iter().map(|b| (a, b)), span),
            (List(a), List(b)) if a.len() == b.len() && matches!(operator.value, Add | Subtract) => {
                self.each(join, a.into_iter().zip(b), span)
            }
            (a, b) => {
                let sign = symbol(operator);
                let message = format!("cannot apply `{sign}` to {} and {}", a.kind(), b.kind());
                self.report(
                    Diagnostic::error("mavc::unit::kind", operator.span, message)
                        .here("not defined for these operands")
                        .help("add or subtract lists of equal length, or multiply a list by a number"),
                );
                None
            }
        }
    }

    /// Reports a unit after an operator that should directly follow its number, as in `2e-5 / h`; whether there was
    /// one.
    fn stands_apart(&mut self, operator: &Spanned<Operator>, left: &Expr, right: &Expr) -> bool {
        let may_be_unit = |name: &str| !(self.in_scope(name) || CONSTANTS.contains(&name) || self.may_exist(name));
        let Some((value, unit)) = joined_unit(operator.value, left, right, &may_be_unit) else {
            return false;
        };
        if parse_unit(&unit, self.gravity).is_err() {
            return false;
        }
        let name = self.sources.snippet(right.span).split([' ', '^']).next().unwrap_or("");
        let message = format!("unknown name `{name}`; a unit must directly follow a number");
        let corrected = format!("{} {unit}", self.without_unit(value));
        self.report(
            Diagnostic::error("mavc::name::unknown", right.span, message)
                .here("a unit goes directly after a number, `)` or `]`")
                .help(format!("write `{corrected}`"))
                .fix(left.span.to(right.span), corrected),
        );
        true
    }

    fn each(
        &mut self,
        join: Join<'_, 'a>,
        pairs: impl Iterator<Item = (Quantity, Quantity)>,
        span: Span,
    ) -> Option<Value> {
        let list: Vec<Quantity> = pairs.map(|(a, b)| self.combine(join, a, b)).collect::<Option<_>>()?;
        match list.iter().find(|q| !q.value.is_finite()) {
            Some(&q) => self.finite(q, span),
            None => Some(Value::List(list)),
        }
    }

    fn combine(&mut self, join: Join<'_, 'a>, a: Quantity, b: Quantity) -> Option<Quantity> {
        let Join { operator, right, .. } = join;
        match operator.value {
            Operator::Add => a.plus(b).or_else(|| self.sides_differ(join, a, b)),
            Operator::Subtract => a.plus(b.negated()).or_else(|| self.sides_differ(join, a, b)),
            Operator::Multiply => a.times(b).or_else(|| self.no_exponent(operator.span)),
            Operator::Divide => a.over(b).or_else(|| self.no_exponent(operator.span)),
            Operator::Power if b.dimension.is_plain() => a.power(b.value).or_else(|| self.no_exponent(right.span)),
            Operator::Power => {
                let kind = b.dimension.describe();
                let message = format!("an exponent must be a plain number, not {kind}");
                self.report(
                    Diagnostic::error("mavc::unit::exponent", right.span, message)
                        .here("has a unit")
                        .help("remove the unit, or divide by it"),
                );
                None
            }
        }
    }

    fn sides_differ<T>(&mut self, join: Join<'_, 'a>, a: Quantity, b: Quantity) -> Option<T> {
        let Join { operator, left, right } = join;
        let (x, y) = (a.dimension, b.dimension);
        let message = format!("cannot apply `{}` to {} and {}", symbol(operator), x.describe(), y.describe());
        let table = compare(["left", "right"], x, y).table;
        let (bare, other) = if x.is_plain() { (left, y) } else { (right, x) };
        // `3 %` is a plain number that has its unit already.
        let unit_of_bare = trailing_unit(bare).map(|unit| unit.value.as_str());
        let is_share = operator.span.start < bare.span.start && unit_of_bare == Some("%");
        let bare_side =
            (x.is_plain() || y.is_plain()).then(|| other.named()).flatten().filter(|_| unit_of_bare.is_none());
        let error = Diagnostic::error("mavc::unit::mismatch", operator.span, message)
            .here("both sides must have the same dimension")
            .also(left.span, format!("this is {}", x.describe()))
            .also(right.span, format!("this is {}", y.describe()));
        let error = match bare_side {
            Some((_, unit)) => self.blame(bare, &[unit], error),
            None => error,
        };
        let slip = match bare_side.and_then(|(_, unit)| self.with_unit(bare, unit)) {
            _ if error.help.is_some() => error.help.as_ref().map(|help| format!("a unit is missing: {help}")),
            Some(corrected) => Some(format!("a unit is missing: write `{corrected}`")),
            None if is_share && matches!(left.kind, ExprKind::Number { .. } | ExprKind::Name(_)) => {
                let [whole, share] = [left, right].map(|side| self.sources.snippet(side.span));
                Some(format!("to change a quantity by a share, write `{whole}*(1 {} {share})`", symbol(operator)))
            }
            None => self.likely_slip(y, left).or_else(|| self.likely_slip(x, right)),
        };
        let error = error.help(match slip {
            Some(slip) => format!("{table}\n{slip}"),
            None => format!("{table}\ngive both sides units of the same dimension, or remove one side"),
        });
        match bare_side {
            Some(_) => self.report(error),
            None => self.report_of_sides([(left, a), (right, b)], error),
        }
        None
    }

    fn no_exponent<T>(&mut self, span: Span) -> Option<T> {
        let message = "the exponent of a quantity with a unit must be a whole number or a simple fraction";
        self.report(
            Diagnostic::error("mavc::unit::exponent", span, message)
                .here("too large, or no simple fraction")
                .help("write an exponent such as `2` or `1/2`, of at most 1000"),
        );
        None
    }
}

fn symbol(operator: &Spanned<Operator>) -> &'static str {
    match operator.value {
        Operator::Add => "+",
        Operator::Subtract => "-",
        Operator::Multiply => "*",
        Operator::Divide => "/",
        Operator::Power => "^",
    }
}
