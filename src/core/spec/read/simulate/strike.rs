//! `fault M1_6 at 5 s until 9 s`: a fault mode that strikes during the flight.

use super::Around;
use super::checks::{self, End};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::strike as table;
use crate::model::Strike;
use crate::number::number;
use crate::read::context::{Context, without_digits};
use crate::read::fields::Fields;
use crate::source::Span;
use crate::syntax::ast::{Block, Clauses, Expr, ExprKind, Statement};

const CODE: &str = "mavc::simulate::fault_time";

/// Every fault of the block in the order of time; `None` where one has an error.
pub(super) fn read_all<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    around: &Around,
    end: Option<End>,
) -> Option<Vec<Strike>> {
    let mut strikes: Vec<Strike> = Vec::new();
    let mut fine = true;
    for statement in &block.body {
        let Statement::Strike(clauses) = statement else { continue };
        let before = cx.diagnostics.len();
        let strike = read(cx, clauses, around, end);
        if cx.diagnostics.len() > before {
            // A strike with an error is not compared with the others.
            fine = false;
            continue;
        }
        match strike.and_then(|new| Some((new, strikes.iter().find(|old| old.meets(&new))?))) {
            Some((new, old)) => {
                cx.report(again(&around.modes[new.mode].name, &new, old));
                fine = false;
            }
            None => fine &= strike.is_some(),
        }
        strikes.extend(strike);
    }
    strikes.sort_by(|a, b| a.at.total_cmp(&b.at));
    fine.then_some(strikes)
}

/// The error for a mode that strikes while it is already active.
fn again(mode: &str, new: &Strike, old: &Strike) -> Diagnostic {
    let (first, last) = (new.at.min(old.at), new.at.max(old.at));
    let message = match first == last {
        true => format!("fault `{mode}` strikes twice at {} s", number(first)),
        false => format!("fault `{mode}` strikes at {} s and, still active, at {} s", number(first), number(last)),
    };
    let in_force = |strike: &Strike| match strike.until {
        Some(until) => format!("active from {} s to {} s", number(strike.at), number(until)),
        None => format!("active from {} s on", number(strike.at)),
    };
    Diagnostic::error("mavc::simulate::struck_twice", new.span, message)
        .here(in_force(new))
        .also(old.span, in_force(old))
        .help("remove one of the two, or end the earlier one before the later one with `until`")
}

fn read<'a>(cx: &mut Context<'a>, clauses: &'a Clauses, around: &Around, end: Option<End>) -> Option<Strike> {
    let name = clauses.name.as_ref()?;
    let fields = Fields::of_clauses(cx, format!("fault `{}`", name.value), clauses, Group::Strike);
    let mode = mode(cx, &name.value, name.span, around);
    let at_expr = fields.demand(cx, "at", "at 5 s");
    let at = at_expr.and_then(|expr| instant(cx, expr));
    let until = fields.written("until", |expr| Some((cx.quantity(&table::UNTIL, expr, CODE)?, expr.span)));
    let (at, at_span) = (at?, at_expr?.span);
    let mut fine = true;
    if let Some((until, span)) = until.value().filter(|(until, _)| *until <= at) {
        let message = format!("fault `{}` strikes at {} s but ends at {} s", name.value, number(at), number(until));
        let error = Diagnostic::error("mavc::simulate::recovery", span, message).here("not after the strike");
        cx.report(
            error
                .also(at_span, "it strikes here")
                .help(format!("write a time after {} s, or remove `until` for a fault that stays", number(at))),
        );
        fine = false;
    }
    if let Some((end, span, why)) = end.filter(|end| at >= end.0) {
        cx.report(checks::late(&name.value, at, at_span, end).also(span, why));
        fine = false;
    } else if let (Some((until, until_span)), Some((end, span, why))) = (until.value(), end)
        && until > end
        && until > at
    {
        cx.report(checks::late_recovery(&name.value, until, until_span, end).also(span, why));
        fine = false;
    }
    let until = until.optional().ok()?.map(|(until, _)| until);
    fine.then_some(Strike { mode: mode?, at, until, span: clauses.span, at_span })
}

/// The time of a strike, s.
fn instant<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<f64> {
    if matches!(expr.kind, ExprKind::Range { .. }) {
        let error = Diagnostic::error(CODE, expr.span, "a fault strikes at one time, not over a range");
        cx.report(error.here("a range").help("write both times, as in `at 5 s until 9 s`"));
        return None;
    }
    cx.quantity(&table::AT, expr, CODE)
}

/// The index of the mode `name`; `None` where there is no such mode, which is reported.
fn mode(cx: &mut Context, name: &str, span: Span, around: &Around) -> Option<usize> {
    let index = around.modes.iter().position(|mode| mode.name == name);
    if index.is_some() || cx.modes_unnamed {
        return index;
    }
    if matches!(name, "healthy" | "all" | "none") {
        let error = Diagnostic::error("mavc::simulate::choice", span, format!("`{name}` is not a fault mode"));
        cx.report(error.here("not a fault").help("name a mode that `faults` declares, such as `M1`"));
        return None;
    }
    if let Some(family) = around.families.find(name) {
        let first = &around.modes[family.first()].name;
        let message = format!("`{name}` names {} fault modes, but only one can strike at a time", family.count());
        let error = Diagnostic::error("mavc::simulate::choice", span, message).here("not a single fault mode");
        cx.report(error.help(format!("name one of them, such as `{first}`")).fix(span, first.as_str()));
        return None;
    }
    let names: Vec<&str> = around.modes.iter().map(|mode| mode.name.as_str()).collect();
    // A name that differs only in its number is rarely a misspelling.
    cx.unknown_among("fault mode", name, span, &names, |mode| without_digits(mode) != without_digits(name));
    None
}
