//! Operands and operators to one tree.

use super::{Built, Rule, span_of, unquote};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span, Spanned};
use crate::syntax::MAX_EXPRESSION_DEPTH;
use crate::syntax::ast::{Expr, ExprKind, Operator};
use pest::iterators::Pair;
use pest::pratt_parser::{Assoc, Op, PrattParser};
use std::sync::LazyLock;

static PRECEDENCE: LazyLock<PrattParser<Rule>> = LazyLock::new(|| {
    PrattParser::new()
        .op(Op::infix(Rule::dots, Assoc::Left))
        .op(Op::infix(Rule::spread, Assoc::Left))
        .op(Op::infix(Rule::plus, Assoc::Left) | Op::infix(Rule::dash, Assoc::Left))
        .op(Op::infix(Rule::times, Assoc::Left) | Op::infix(Rule::over, Assoc::Left))
        .op(Op::prefix(Rule::minus))
        .op(Op::infix(Rule::power, Assoc::Right))
});

/// A tree and its height.
struct Tree {
    expr: Expr,
    height: usize,
}

pub(super) fn expr(file: FileId, pair: Pair<Rule>) -> Built<Expr> {
    tree(file, pair).map(|tree| tree.expr)
}

fn tree(file: FileId, pair: Pair<Rule>) -> Built<Tree> {
    let pairs = pair.into_inner();
    // These are the ones that the precedence parser recurses on.
    let mut nested = pairs.clone().filter(|p| matches!(p.as_rule(), Rule::minus | Rule::power));
    if let Some(one_too_many) = nested.nth(MAX_EXPRESSION_DEPTH) {
        return Err(too_high(span_of(file, &one_too_many)));
    }
    PRECEDENCE
        .map_primary(|operand| self::operand(file, operand))
        .map_prefix(|sign, operand| {
            let operand = operand?;
            let sign = span_of(file, &sign);
            let span = sign.to(operand.expr.span);
            grow(ExprKind::Negate(Box::new(operand.expr)), span, sign, operand.height)
        })
        .map_infix(|left, operator, right| binary(left?, span_of(file, &operator), operator.as_rule(), right?))
        .parse(pairs)
}

fn binary(left: Tree, place: Span, rule: Rule, right: Tree) -> Built<Tree> {
    let span = left.expr.span.to(right.expr.span);
    let height = left.height.max(right.height);
    let operator = match rule {
        Rule::plus => Operator::Add,
        Rule::dash => Operator::Subtract,
        Rule::times => Operator::Multiply,
        Rule::over => Operator::Divide,
        Rule::power => Operator::Power,
        Rule::spread => {
            let kind = ExprKind::Interval { value: Box::new(left.expr), by: Box::new(right.expr) };
            return grow(kind, span, place, height);
        }
        _ => {
            if matches!(left.expr.kind, ExprKind::Range { .. }) {
                return Err(Box::new(
                    Diagnostic::error("mavc::syntax::range", place, "a range has two ends")
                        .here("a second `..`")
                        .also(left.expr.span, "this is a range already")
                        .help("keep one `..`"),
                ));
            }
            let kind = ExprKind::Range { low: Box::new(left.expr), high: Box::new(right.expr) };
            return grow(kind, span, place, height);
        }
    };
    let operator = Spanned::new(operator, place);
    grow(ExprKind::Binary { operator, left: Box::new(left.expr), right: Box::new(right.expr) }, span, place, height)
}

fn operand(file: FileId, pair: Pair<Rule>) -> Built<Tree> {
    let span = span_of(file, &pair);
    let leaf = |kind| Ok(Tree { expr: Expr { kind, span }, height: 1 });
    match pair.as_rule() {
        Rule::text => leaf(ExprKind::Text(unquote(pair.as_str()))),
        Rule::reference => leaf(ExprKind::Name(pair.as_str().to_string())),
        Rule::unknown => leaf(ExprKind::Unknown),
        Rule::quantity => leaf(quantity(file, pair)?),
        rule => compound(file, span, rule, pair),
    }
}

/// A call, a bracketed expression or a list, with the unit after it.
fn compound(file: FileId, span: Span, rule: Rule, pair: Pair<Rule>) -> Built<Tree> {
    let at = Span { end: span.start + 1, ..span };
    let (mut function, mut inside, mut unit, mut height, mut close) = (None, Vec::new(), None, 0, span.end);
    for part in pair.into_inner() {
        match part.as_rule() {
            Rule::name => function = Some(Spanned::new(part.as_str().to_string(), span_of(file, &part))),
            Rule::expr => {
                let element = tree(file, part)?;
                height = height.max(element.height);
                inside.push(element.expr);
            }
            Rule::rparen => close = span_of(file, &part).end,
            Rule::unit => unit = Some(Spanned::new(part.as_str().to_string(), span_of(file, &part))),
            _ => {}
        }
    }
    match (rule, function) {
        (Rule::call, Some(function)) => {
            let call_span = Span { end: close, ..span };
            let call = grow(ExprKind::Call { function, arguments: inside }, call_span, at, height)?;
            match unit {
                None => Ok(call),
                Some(_) => grow(ExprKind::Paren { inner: Box::new(call.expr), unit }, span, at, call.height),
            }
        }
        (Rule::paren, _) => {
            let inner = Box::new(inside.pop().expect("brackets hold an expression"));
            grow(ExprKind::Paren { inner, unit }, span, at, height)
        }
        _ => grow(ExprKind::List { elements: inside, unit }, span, at, height),
    }
}

fn quantity(file: FileId, pair: Pair<Rule>) -> Built<ExprKind> {
    let mut parts = pair.into_inner();
    let number = parts.next().expect("a quantity has a number");
    let unit = parts.next().map(|p| Spanned::new(p.as_str().to_string(), span_of(file, &p)));
    let text = number.as_str();
    let value: f64 = text.parse().unwrap_or(f64::NAN);
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    let size = match value {
        v if !v.is_finite() => "large",
        0.0 if mantissa.contains(|c: char| ('1'..='9').contains(&c)) => "small",
        _ => {
            return Ok(ExprKind::Number { value, text: text.to_string(), unit });
        }
    };
    let shown: String = text.chars().take(24).collect();
    Err(Box::new(
        Diagnostic::error(
            "mavc::syntax::number",
            span_of(file, &number),
            format!("the number `{shown}` is too {size}"),
        )
        .here("cannot be held")
        .help("numbers run from about 1e-308 to 1e308; choose another unit"),
    ))
}

/// One level more; `at` is where a limit passed is shown.
fn grow(kind: ExprKind, span: Span, at: Span, height: usize) -> Built<Tree> {
    if height >= MAX_EXPRESSION_DEPTH {
        return Err(too_high(at));
    }
    Ok(Tree { expr: Expr { kind, span }, height: height + 1 })
}

fn too_high(at: Span) -> Box<Diagnostic> {
    let message = format!("an expression may chain at most {MAX_EXPRESSION_DEPTH} operations");
    Box::new(
        Diagnostic::error("mavc::syntax::expression", at, message)
            .here("one too many")
            .help("move a part into a `let`"),
    )
}
