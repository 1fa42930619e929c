//! Evaluates expressions: numbers with units, lists, ranges, names and calls.
//!
//! `None` always means that an error has been reported, so callers report nothing further.

use super::context::{CONSTANTS, Context, FUNCTIONS, MAX_EVALUATION_DEPTH, MAX_STEPS, State};
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, Operator, UnitText};
use crate::unit::{Dimension, Quantity, Unit, UnitError, compare, mismatch, parse_unit, unit_names};

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    Quantity(Quantity),
    List(Vec<Quantity>),
    /// Low and high.
    Range(Quantity, Quantity),
    Text(String),
}

impl Value {
    /// What it is, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Quantity(_) => "a number",
            Value::List(_) => "a list",
            Value::Range(..) => "a range",
            Value::Text(_) => "text",
        }
    }
}

/// Evaluation moves to a new stack of `STACK_MORE` bytes once fewer than `STACK_LEFT` are left. This is checked once
/// every `STACK_ASKED` levels, because the check costs more than most evaluations.
const STACK_LEFT: usize = 256 << 10;
const STACK_MORE: usize = 1 << 20;
const STACK_ASKED: u32 = 8;

/// The code of a `?`.
pub const UNKNOWN: &str = "mavc::value::unknown";

/// The error for a `?`.
pub(super) fn unknown(at: Span, message: impl Into<String>, help: impl Into<String>) -> Diagnostic {
    Diagnostic::error(UNKNOWN, at, message).here("to be filled in").help(help)
}

impl<'a> Context<'a> {
    /// The value of `expr`; `None` where it has an error, which has been reported.
    pub fn evaluate(&mut self, expr: &'a Expr) -> Option<Value> {
        self.steps = self.steps.saturating_add(1);
        if self.depth >= MAX_EVALUATION_DEPTH || self.steps > MAX_STEPS {
            self.report_too_much(expr.span);
            return None;
        }
        self.depth += 1;
        // Some threads have too small a stack for this depth.
        let value = if self.depth.is_multiple_of(STACK_ASKED) {
            stacker::maybe_grow(STACK_LEFT, STACK_MORE, || self.evaluate_kind(expr))
        } else {
            self.evaluate_kind(expr)
        };
        self.depth -= 1;
        value
    }

    /// The value of `expr`, which must be a single number with or without a unit.
    pub fn evaluate_quantity(&mut self, expr: &'a Expr) -> Option<Quantity> {
        let value = self.evaluate(expr)?;
        self.single(value, expr.span)
    }

    fn evaluate_kind(&mut self, expr: &'a Expr) -> Option<Value> {
        match &expr.kind {
            ExprKind::Number { value, unit, .. } => {
                let unit = match unit {
                    Some(unit) => self.unit(unit)?,
                    None => return self.finite(Quantity::plain(*value), expr.span),
                };
                self.finite(Quantity::with_unit(*value, unit), expr.span)
            }
            ExprKind::Text(text) => Some(Value::Text(text.clone())),
            ExprKind::Name(name) => self.named(name, expr.span),
            ExprKind::Unknown => {
                self.report(unknown(expr.span, "a value is not known yet", "write the value in place of `?`"));
                None
            }
            ExprKind::Call { function, arguments } => self.call(function, arguments, expr.span),
            ExprKind::Negate(inner) => match self.evaluate(inner)? {
                Value::Quantity(q) => Some(Value::Quantity(q.negated())),
                Value::List(list) => Some(Value::List(list.into_iter().map(Quantity::negated).collect())),
                other => self.wrong_kind(&other, "a number", inner.span),
            },
            ExprKind::Binary { operator, left, right } => self.binary(operator, left, right, expr.span),
            ExprKind::Paren { inner, unit } => {
                let value = self.evaluate(inner);
                match unit {
                    None => value,
                    Some(text) => {
                        let unit = self.unit(text);
                        self.attach(value?, unit?, text, inner.span)
                    }
                }
            }
            ExprKind::List { elements, unit } => self.list(elements, unit.as_ref()),
            ExprKind::Interval { value, by } => self.no_interval(value, by, expr.span),
            ExprKind::Range { low, high } => self.range(low, high),
        }
    }

    fn named(&mut self, name: &'a str, span: Span) -> Option<Value> {
        if let Some((parameter, value)) = self.parameter
            && parameter == name
        {
            return Some(Value::Quantity(value));
        }
        match name {
            "pi" => return Some(Value::Quantity(Quantity::plain(std::f64::consts::PI))),
            "g0" => {
                let acceleration = Dimension::LENGTH.over(Dimension::TIME).and_then(|d| d.over(Dimension::TIME))?;
                return Some(Value::Quantity(Quantity::new(self.gravity, acceleration)));
            }
            _ => {}
        }
        if let Some(entry) = self.lets.get_mut(name) {
            entry.used = true;
            let value = self.settle_let(name);
            if let Some(Value::List(list)) = &value {
                self.steps = self.steps.saturating_add(list.len() as u32);
            }
            return value;
        }
        if FUNCTIONS.contains(&name) {
            let message = format!("the function `{name}` needs arguments in parentheses");
            self.report(
                Diagnostic::error("mavc::unit::argument", span, message)
                    .here("missing arguments")
                    .help(format!("write `{name}(...)`")),
            );
        } else if parse_unit(name, self.gravity).is_ok() && !self.may_exist(name) {
            let message = format!("unknown name `{name}`; a unit must directly follow a number");
            self.report(
                Diagnostic::error("mavc::name::unknown", span, message)
                    .here("a unit goes directly after a number, `)` or `]`")
                    .help(format!("write `1 {name}`, or put the unit after parentheses: `(...) {name}`")),
            );
        } else {
            // A `let` that is being evaluated cannot be part of its own definition.
            let waits = |name: &str| self.lets.get(name).is_some_and(|l| matches!(l.state, State::Busy));
            let names = match self.is_full() {
                true => Vec::new(),
                false => self.names_in_scope().into_iter().filter(|name| !waits(name)).collect(),
            };
            self.unknown("`let`", name, span, &names);
        }
        None
    }

    fn names_in_scope(&self) -> Vec<&'a str> {
        let parameter = self.parameter.iter().map(|(name, _)| *name);
        self.lets.keys().copied().chain(parameter).chain(CONSTANTS).collect()
    }

    /// The unit that a text stands for, or an error that says what to write.
    pub fn unit(&mut self, text: &UnitText) -> Option<Unit> {
        let error = match parse_unit(&text.value, self.gravity) {
            Ok(unit) => return Some(unit),
            Err(error) => error,
        };
        let code = "mavc::unit::unknown";
        let diagnostic = match error {
            UnitError::Malformed => Diagnostic::error(code, text.span, format!("`{}` is not a unit", text.value))
                .here("not a product of units with small whole exponents")
                .help("write it like `kg*m^2` or `m/s^2`, without spaces"),
            UnitError::Unknown { word, .. } if self.names_in_scope().contains(&word.as_str()) => {
                let error = Diagnostic::error(code, text.span, format!("`{word}` is a name, not a unit"))
                    .here("expected a unit");
                // `3 m*a`: what comes before the name may be a unit all the same.
                let split = text.value.find(&*word).filter(|&at| at > 1);
                let parts = split.map(|at| (&text.value[..at - 1], &text.value[at - 1..at], &text.value[at..]));
                match parts.filter(|(unit, ..)| parse_unit(unit, self.gravity).is_ok()) {
                    Some((unit, operator, name)) => {
                        let apart = format!("{unit} {operator} {name}");
                        error.help(format!("write `{} {apart}`", self.number_before(text))).fix(text.span, apart)
                    }
                    None => error
                        .help(format!("to multiply, write `{}*{}`", self.number_before(text), text.value))
                        .fix(text.span, format!("*{}", text.value)),
                }
            }
            UnitError::Unknown { word, meant } => {
                let due = self.unit_due.filter(|(span, _)| *span == text.span).map(|(_, due)| due);
                let whole = |near: &str| text.value.replacen(&word, near, 1);
                // Of the names as near as each other, one that fits is meant.
                let fitting = |due: &str| nearest(&word, unit_names().filter(|name| self.fits(&whole(name), due)));
                let near = meant
                    .or_else(|| due.and_then(fitting).or_else(|| nearest(&word, unit_names())).map(str::to_string));
                let diagnostic = Diagnostic::error(code, text.span, format!("unknown unit `{word}`"));
                match near {
                    Some(near) => {
                        let whole = whole(&near);
                        let diagnostic = diagnostic.here("not a known unit");
                        match due {
                            // The unit that was probably meant does not fit either.
                            Some(due) if !self.fits(&whole, due) => {
                                diagnostic.help(format!("`{whole}` measures something else: use a unit like `{due}`"))
                            }
                            _ => diagnostic.help(format!("write `{whole}`")).fix(text.span, whole),
                        }
                    }
                    None => diagnostic.here("not a known unit").help(
                        "use a known unit: m g s rad N J W Hz with prefixes (mm, kg, us), or min h deg rev rpm ft inch \
                         lb kgf gf %",
                    ),
                }
            }
        };
        self.report(diagnostic);
        None
    }

    /// Whether a unit measures what is due; radians may be left out where they are squared.
    fn fits(&self, unit: &str, due: &str) -> bool {
        let dimension = |unit: &str| match unit {
            "1" => Some(Dimension::PLAIN),
            unit => parse_unit(unit, self.gravity).ok().map(|unit| unit.dimension),
        };
        let (found, due_here) = (dimension(unit), dimension(due));
        let plainer = |d: Option<Dimension>| d.map(Dimension::without_angle);
        found.is_none() || found == due_here || due.contains("rad^2") && plainer(found) == plainer(due_here)
    }

    /// The number that a unit follows, as written; `(...)` where it follows a bracket.
    fn number_before(&self, text: &UnitText) -> &str {
        let source = &self.sources.get(text.span.file).text;
        let before = source.get(..text.span.start as usize).unwrap_or("").trim_end();
        let digits = before.trim_end_matches(|c: char| c.is_ascii_alphanumeric() || c == '.');
        match &before[digits.len()..] {
            "" => "(...)",
            number => number,
        }
    }

    /// `(...) m`: applies the unit to the value in the parentheses, which must be a plain number.
    fn attach(&mut self, value: Value, unit: Unit, text: &UnitText, span: Span) -> Option<Value> {
        match value {
            Value::Quantity(q) => {
                let q = self.attach_one(q, unit, text, span)?;
                self.finite(q, span)
            }
            Value::Range(a, b) => {
                let (a, b) = (self.attach_one(a, unit, text, span)?, self.attach_one(b, unit, text, span)?);
                Some(Value::Range(a, b))
            }
            Value::List(list) => {
                let spread = list.into_iter().map(|q| self.attach_one(q, unit, text, span));
                Some(Value::List(spread.collect::<Option<_>>()?))
            }
            other => self.wrong_kind(&other, "a number", span),
        }
    }

    pub(super) fn attach_one(&mut self, q: Quantity, unit: Unit, text: &UnitText, span: Span) -> Option<Quantity> {
        if q.dimension.is_plain() {
            return Some(Quantity::with_unit(q.value, unit));
        }
        let message = format!("the unit `{}` follows {}, which already has a unit", text.value, q.dimension.describe());
        self.report(
            Diagnostic::error("mavc::unit::mismatch", text.span, message)
                .here("a unit can follow only a plain number")
                .also(span, format!("this is {}", q.dimension.describe()))
                .help(format!("{}\nremove this unit or the one inside", mismatch(Dimension::PLAIN, q.dimension).table)),
        );
        None
    }

    fn list(&mut self, elements: &'a [Expr], unit: Option<&UnitText>) -> Option<Value> {
        let unit_known = unit.map(|text| self.unit(text));
        let mut list = Some(Vec::with_capacity(elements.len()));
        for element in elements {
            let q = self.evaluate_quantity(element).and_then(|q| match unit_known {
                Some(unit) if is_bare(q, element) => unit.map(|unit| Quantity::with_unit(q.value, unit)),
                _ => Some(q),
            });
            match (&mut list, q) {
                (Some(list), Some(q)) => list.push(q),
                (list, _) => *list = None,
            }
        }
        list.map(Value::List)
    }

    /// `a .. b`; a unit at the end applies to a bare start: `0 .. 30 m`.
    fn range(&mut self, low: &'a Expr, high: &'a Expr) -> Option<Value> {
        let (a, b) = (self.evaluate_quantity(low), self.evaluate_quantity(high));
        let (mut a, b) = (a?, b?);
        if is_bare(a, low)
            && let Some(text) = trailing_unit(high)
        {
            let unit = self.unit(text)?;
            if unit.dimension == b.dimension {
                a = Quantity::with_unit(a.value, unit);
            }
        }
        if a.dimension != b.dimension {
            let message = format!("a range cannot go from {} to {}", a.dimension.describe(), b.dimension.describe());
            let difference = compare(["start", "end"], a.dimension, b.dimension);
            let error = Diagnostic::error("mavc::unit::mismatch", high.span, message)
                .here(format!("this is {}", b.dimension.describe()))
                .also(low.span, format!("this is {}", a.dimension.describe()))
                .help(format!("{}\ngive both ends the same unit, as in `1 .. 30 m`", difference.table));
            self.report_of_sides([(low, a), (high, b)], error);
            return None;
        }
        Some(Value::Range(a, b))
    }

    pub(super) fn finite(&mut self, q: Quantity, span: Span) -> Option<Value> {
        if q.value.is_finite() {
            return Some(Value::Quantity(q));
        }
        self.report(
            Diagnostic::error("mavc::unit::not_finite", span, "the value is not a finite number")
                .here(if q.value.is_nan() { "this is not a number" } else { "this is infinite" })
                .help("check for a division by zero, a root of a negative number or an overflow"),
        );
        None
    }

    pub(super) fn single(&mut self, value: Value, span: Span) -> Option<Quantity> {
        match value {
            Value::Quantity(q) => Some(q),
            other => self.wrong_kind(&other, "a single number", span),
        }
    }

    pub(super) fn wrong_kind<T>(&mut self, found: &Value, due: &str, span: Span) -> Option<T> {
        let message = format!("expected {due}, found {}", found.kind());
        let error = Diagnostic::error("mavc::unit::kind", span, message).here(format!("this is {}", found.kind()));
        self.report(match found {
            Value::Text(text) if text.starts_with(|c: char| c.is_ascii_digit() || "-[(".contains(c)) => {
                let is_written_here = self.sources.snippet(span).starts_with('"');
                let error = error.help(format!("remove the quotes: write `{text}`"));
                if is_written_here { error.fix(span, text) } else { error }
            }
            _ => error.help(format!("write {due}")),
        });
        None
    }

    /// The two ends of a range; `due` says what was expected.
    pub(super) fn range_ends(&mut self, expr: &'a Expr, due: &str) -> Option<(Quantity, Quantity)> {
        if let ExprKind::Binary { operator, left, right } = &expr.kind
            && operator.value == Operator::Subtract
        {
            let (low, high) = (self.sources.snippet(left.span), self.sources.snippet(right.span));
            let error =
                Diagnostic::error("mavc::unit::kind", operator.span, format!("expected {due}, found a subtraction"));
            self.report(
                error
                    .here("subtracts one end from the other")
                    .help(format!("write `{low} .. {high}`"))
                    .fix(operator.span, ".."),
            );
            return None;
        }
        match self.evaluate(expr)? {
            Value::Range(low, high) => Some((low, high)),
            Value::Quantity(_) => {
                let error = Diagnostic::error("mavc::unit::kind", expr.span, format!("expected {due}, found a number"));
                self.report(error.here("only one end").help("write both ends, as in `LOW .. HIGH`"));
                None
            }
            Value::List(ends) if ends.len() == 2 => {
                let error = Diagnostic::error("mavc::unit::kind", expr.span, format!("expected {due}, found a list"));
                let error = error.here("this is a list");
                self.report(match self.ends_of_list(expr) {
                    Some(range) => error.help(format!("write `{range}`")).fix(expr.span, range),
                    None => error.help("write both ends, as in `LOW .. HIGH`"),
                });
                None
            }
            other => self.wrong_kind(&other, due, expr.span),
        }
    }

    /// `[1, 30] m` rewritten as `1 .. 30 m`, where the list is a literal.
    fn ends_of_list(&self, expr: &Expr) -> Option<String> {
        let ExprKind::List { elements, unit } = &expr.kind else { return None };
        let [low, high] = elements.as_slice() else { return None };
        let is_number = |end: &Expr| match &end.kind {
            ExprKind::Number { unit: None, .. } => true,
            ExprKind::Negate(inner) => matches!(inner.kind, ExprKind::Number { unit: None, .. }),
            _ => false,
        };
        let [from, to] = [low, high].map(|end| self.sources.snippet(end.span).trim());
        match unit {
            None => Some(format!("{from} .. {to}")),
            Some(unit) if is_number(low) && is_number(high) => Some(format!("{from} .. {to} {}", unit.value)),
            Some(_) => None,
        }
    }

    /// Reports once that a limit of evaluation is exceeded.
    fn report_too_much(&mut self, span: Span) {
        const CODE: &str = "mavc::unit::too_much";
        if self.diagnostics.iter().any(|d| d.code == CODE) {
            return;
        }
        let message = "evaluating this spec takes too much work";
        self.report(Diagnostic::error(CODE, span, message).here("the limit is exceeded here").help(format!(
            "use fewer points or shorter expressions: the limits are {MAX_EVALUATION_DEPTH} levels of nesting, counted \
             through `let`s, and {MAX_STEPS} steps in all"
        )));
    }
}

/// A plain number that is not written with a unit of its own.
pub(super) fn is_bare(q: Quantity, expr: &Expr) -> bool {
    q.dimension.is_plain() && trailing_unit(expr).is_none()
}

/// The unit at the very end of an expression's text.
pub(super) fn trailing_unit(expr: &Expr) -> Option<&UnitText> {
    match &expr.kind {
        ExprKind::Number { unit, .. } | ExprKind::Paren { unit, .. } | ExprKind::List { unit, .. } => unit.as_ref(),
        ExprKind::Negate(inner) => trailing_unit(inner),
        ExprKind::Binary { right, .. } => trailing_unit(right),
        _ => None,
    }
}
