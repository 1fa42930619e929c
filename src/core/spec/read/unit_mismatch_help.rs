//! A quantity of the wrong dimension: guesses what its author meant, and what to write instead.

use super::context::Context;
use super::expected::{Expected, called, joined_unit};
use crate::diagnostic::Diagnostic;
use crate::language::{Entry, Group};
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, UnitText};
use crate::syntax::visit::Visit;
use crate::unit::{Dimension, Quantity, mismatch, parse_unit};

/// Units of mass, each with the unit of force of the same weight.
const WEIGHTS: [(&str, &str); 3] = [("g", "gf"), ("kg", "kgf"), ("lb", "lbf")];

/// Units of frequency, each with the unit of turning rate for one turn per period, and the period.
const TURNS: [(&str, &str, &str); 2] = [("Hz", "rev/s", "second"), ("1/min", "rpm", "minute")];

/// What to write in place of a value.
struct Remedy {
    /// Text before the new value: `for the weight of 666 g`; may be empty.
    purpose: String,
    /// The new value.
    text: String,
    /// Text after the new value; may be empty.
    besides: String,
    /// Whether nothing else can have been meant, so that the new value becomes a fix.
    is_certain: bool,
}

impl<'a> Context<'a> {
    /// The error for `expr`, whose value `q` does not have the expected dimension.
    pub(super) fn unit_differs(&self, due: Expected, q: Quantity, expr: &Expr) -> Diagnostic {
        let expected = due.dimension();
        let takes = if expected.is_plain() { "a plain number".into() } else { expected.describe() };
        let found = q.dimension.describe();
        let difference = mismatch(expected, q.dimension);
        let error = Diagnostic::error(
            "mavc::unit::mismatch",
            expr.span,
            format!("{} takes {takes}, not {found}", called(due.what)),
        )
        .here(format!("this is {found}"));
        let with = |action: &str| format!("{}\n{action}", difference.table);
        let behind = self.let_behind(expr);
        let written = behind.map_or(expr, |(_, value)| value);
        if let Some(slip) = self.likely_slip(expected, written) {
            return error.help(with(&slip));
        }
        if let Some(remedy) = self.remedy(due, q, written) {
            let Remedy { purpose, text, besides, is_certain } = remedy;
            let order = match behind {
                Some((name, _)) => format!("write `let {name} = {text}`"),
                None => format!("write `{text}`"),
            };
            // A factor with a unit of its own may be what is missing.
            let factor = difference.action.filter(|action| !is_certain && action.ends_with(')'));
            let purpose = match factor {
                Some(factor) => factor + ", or ",
                None if purpose.is_empty() => purpose,
                None => purpose + ", ",
            };
            let other = if behind.is_some() { ", or another value here" } else { "" };
            let error = error.help(format!("{}\n{purpose}{order}{besides}{other}", difference.table));
            // A `let` is not changed by a fix, because its other uses may be right.
            return if is_certain && behind.is_none() { error.fix(expr.span, text) } else { error };
        }
        let action = match difference.action {
            Some(action) => action,
            None => format!("write {}, as in `2 {}`", kind(expected), due.unit),
        };
        error.help(with(&action))
    }

    /// What to write for a value that is a number or a list followed by one unit.
    fn remedy(&self, due: Expected, q: Quantity, written: &Expr) -> Option<Remedy> {
        let (value, unit) = self.value_and_unit(written)?;
        let (expected, found) = (due.dimension(), q.dimension);
        let of = |text: &str| parse_unit(text, self.gravity).map_or(Dimension::PLAIN, |unit| unit.dimension);
        let (force, mass, rate, turning) = (of("N"), of("kg"), of("Hz"), of("rad/s"));
        let certain =
            |purpose: String, text: String| Some(Remedy { purpose, text, besides: String::new(), is_certain: true });
        let guess =
            |text: String, besides: String| Some(Remedy { purpose: String::new(), text, besides, is_certain: false });
        if expected == force && found == mass {
            let purpose = format!("for the weight of {value} {unit}");
            return certain(
                purpose,
                match WEIGHTS.iter().find(|pair| pair.0 == unit) {
                    Some((_, weight)) => format!("{value} {weight}"),
                    None => format!("{value} {unit} * g0"),
                },
            );
        }
        if expected == mass && found == force {
            let purpose = format!("for the mass that weighs {value} {unit}");
            return certain(
                purpose,
                match WEIGHTS.iter().find(|pair| pair.1 == unit) {
                    Some((mass, _)) => format!("{value} {mass}"),
                    None => format!("{value} {unit} / g0"),
                },
            );
        }
        if expected == turning && found == rate {
            if let Some((_, turns, time)) = TURNS.iter().find(|pair| pair.0 == unit) {
                let text = format!("{value} {turns}");
                // The speed of a rotor is often given in turns, that of a heading rarely.
                return match due.unit {
                    "rad/s" => certain(format!("for {value} turns per {time}"), text),
                    _ => guess(format!("{value} {}", due.unit), format!(", or `{text}` for turns")),
                };
            }
            let other = if due.unit == "rad/s" { ("rev/s", "turns") } else { ("rad/s", "radians") };
            return guess(format!("{value} {}", due.unit), format!(", or `{value} {}` for {}", other.0, other.1));
        }
        if expected == rate && found == turning {
            return match TURNS.iter().find(|pair| pair.1 == unit) {
                Some((counted, _, time)) => {
                    certain(format!("for {value} times per {time}"), format!("{value} {counted}"))
                }
                None => guess(format!("{value} {}", due.unit), ", without the angle".into()),
            };
        }
        if (expected == rate && found == Dimension::TIME) || (expected == Dimension::TIME && found == rate) {
            return certain(String::new(), format!("1/({value} {unit})"));
        }
        let sibling = match sibling(due, found) {
            Some(other) => format!("; {} is given by `{other}`", kind(found)),
            None => String::new(),
        };
        if expected.is_plain() {
            return guess(value.to_string(), format!(" without a unit, or a share such as `10 %`{sibling}"));
        }
        let purpose = expected.named().map_or(String::new(), |(name, _)| format!(" for {name}"));
        guess(format!("{value} {}", due.unit), format!("{purpose}{sibling}"))
    }

    /// A number or a list as written, and the unit that follows it.
    fn value_and_unit(&self, expr: &Expr) -> Option<(&'a str, &'a str)> {
        fn unit_of(expr: &Expr) -> Option<&UnitText> {
            match &expr.kind {
                ExprKind::Number { unit, .. } | ExprKind::List { unit, .. } | ExprKind::Paren { unit, .. } => {
                    unit.as_ref()
                }
                ExprKind::Negate(inner) => unit_of(inner),
                _ => None,
            }
        }
        let unit = unit_of(expr)?;
        let value = self.sources.snippet(Span { end: unit.span.start, ..expr.span }).trim_end();
        (value.len() <= 48 && !value.contains('\n')).then(|| (value, self.sources.snippet(unit.span)))
    }

    /// The help for a common cause of a mismatch: `2 g` for twice gravity, `2 s` for twice the parameter `s`.
    pub(super) fn likely_slip(&self, expected: Dimension, expr: &Expr) -> Option<String> {
        let mut units = Units::default();
        units.expr(expr);
        let units = units.0;
        let acceleration = Expected::new("", "m/s^2").dimension();
        if expected == acceleration && units.contains(&"g") {
            return Some("`g` is the gram: for gravity, write `2*g0`".into());
        }
        if let ExprKind::Binary { operator, left, right } = &expr.kind
            && let Some((value, unit)) = joined_unit(operator.value, left, right, &|_| true)
            && parse_unit(&unit, self.gravity).is_ok_and(|unit| unit.dimension == expected)
        {
            let (name, number) = (self.sources.snippet(right.span), self.without_unit(value));
            return Some(format!("`{name}` is a name here: for the unit `{name}`, write `{number} {unit}`"));
        }
        let name = units.into_iter().find(|unit| self.in_scope(unit))?;
        Some(format!("`{name}` after a number is the unit: to multiply by the name `{name}`, write `2*{name}`"))
    }
}

/// The related field that takes a quantity of this dimension.
fn sibling(due: Expected, found: Dimension) -> Option<&'static str> {
    let family = due.row?.family?;
    let takes = |entry: &&'static Entry| entry.family == Some(family) && Expected::of(entry).dimension() == found;
    Group::ALL.into_iter().flat_map(Group::entries).copied().find(takes).map(|entry| entry.name)
}

/// The usual name of a dimension, without a unit.
fn kind(dimension: Dimension) -> &'static str {
    dimension.named().map_or("a quantity", |(name, _)| name)
}

/// The units in an expression.
#[derive(Default)]
struct Units<'e>(Vec<&'e str>);

impl<'e> Visit<'e> for Units<'e> {
    fn unit(&mut self, unit: &'e UnitText) {
        self.0.push(&unit.value);
    }
}
