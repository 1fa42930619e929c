//! `fault M1_6 at 5 s until 9 s`: a fault mode that strikes during the flight.

use super::Around;
use super::checks::{self, End};
use crate::diagnostic::Diagnostic;
use crate::model::Strike;
use crate::model::context::{Context, without_digits};
use crate::model::due::Due;
use crate::model::fields::Fields;
use crate::report::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Clauses, Expr, ExprKind, Statement};

const CODE: &str = "mavc::simulate::fault_time";
const CLAUSES: [&str; 2] = ["at", "until"];

/// Every fault of the block in the order of time, `None` where one has an error.
pub(super) fn read_all<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    around: &Around,
    end: Option<End>,
) -> Option<Vec<Strike>> {
    let mut strikes = Some(Vec::new());
    for statement in &block.body {
        let Statement::Strike(clauses) = statement else { continue };
        match (&mut strikes, read(cx, clauses, around, end)) {
            (Some(list), Some(strike)) => list.push(strike),
            (list, _) => *list = None,
        }
    }
    if let Some(list) = &mut strikes {
        list.sort_by(|a: &Strike, b| a.at.total_cmp(&b.at));
    }
    strikes
}

fn read<'a>(cx: &mut Context<'a>, clauses: &'a Clauses, around: &Around, end: Option<End>) -> Option<Strike> {
    let name = clauses.name.as_ref()?;
    let fields = Fields::of_clauses(cx, format!("fault `{}`", name.value), clauses, &CLAUSES);
    let mode = mode(cx, &name.value, name.span, around);
    let at_expr = fields.demand(cx, "at", "at 5 s");
    let at = at_expr.and_then(|expr| instant(cx, expr));
    let until = match fields.get("until") {
        Some(expr) => cx.number(Due::new("until", "s"), expr).map(|until| Some((until, expr.span))),
        None => Some(None),
    };
    let (at, at_span) = (at?, at_expr?.span);
    let mut fine = true;
    if let Some((until, span)) = until.flatten().filter(|(until, _)| *until <= at) {
        let message = format!("fault `{}` strikes at {} s and is over at {} s", name.value, number(at), number(until));
        let error = Diagnostic::error("mavc::simulate::recovery", span, message).here("not after the strike");
        cx.report(
            error
                .also(at_span, "it strikes here")
                .help(format!("write a time after {} s, or take `until` out: the fault then stays", number(at))),
        );
        fine = false;
    }
    if let Some((end, span, why)) = end.filter(|end| at >= end.0) {
        cx.report(checks::late(&name.value, at, at_span, end).also(span, why));
        fine = false;
    }
    let until = until?.map(|(until, _)| until);
    fine.then_some(Strike { mode: mode?, at, until, span: clauses.span, at_span })
}

/// The time of a strike.
fn instant<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<f64> {
    if matches!(expr.kind, ExprKind::Range { .. }) {
        let error = Diagnostic::error(CODE, expr.span, "a fault strikes at one time, not over a range");
        cx.report(error.here("a range").help("write both times, as in `at 5 s until 9 s`"));
        return None;
    }
    cx.not_negative(Due::new("at", "s"), expr, CODE)
}

/// The index of the mode that is called `name`.
fn mode(cx: &mut Context, name: &str, span: Span, around: &Around) -> Option<usize> {
    let index = around.modes.iter().position(|mode| mode.name == name);
    if index.is_some() || around.incomplete {
        return index;
    }
    if matches!(name, "healthy" | "all" | "none") {
        let error = Diagnostic::error("mavc::simulate::choice", span, format!("`{name}` is not a fault mode"));
        cx.report(error.here("not a fault").help("name a mode that `faults` declares, such as `M1`"));
        return None;
    }
    let names: Vec<&str> = around.modes.iter().map(|mode| mode.name.as_str()).collect();
    // A number is rarely misspelt.
    cx.unknown_among("fault mode", name, span, &names, |mode| without_digits(mode) != without_digits(name));
    None
}
