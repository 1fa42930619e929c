//! `against`: the fault modes that a plan must tolerate.

mod choose;
mod repeated;

use super::{CHOICE, MODE_NUMBERS};
use crate::diagnostic::{Diagnostic, nearest};
use crate::model::FaultMode;
use crate::read::context::{Context, either};
use crate::read::expected::Expected;
use crate::read::fault::Modes;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Expr, ExprKind, Field, FieldValue, Relation};
use choose::{Choice, Runs};

/// The indices of the modes that `field` chooses; `None` where it has an error. `incomplete` says that modes with
/// errors are missing from `modes`.
pub(super) fn read<'a>(cx: &mut Context<'a>, field: &'a Field, modes: &Modes, incomplete: bool) -> Option<Vec<usize>> {
    let expr = match &field.value {
        FieldValue::Where { field, relation, value } => {
            return filter(cx, field, relation.value, value, &modes.modes, incomplete);
        }
        FieldValue::Expr(expr) => expr,
    };
    let elements: &[Expr] = match &expr.kind {
        ExprKind::Name(name) if name == "all" => return Some((0..modes.modes.len()).collect()),
        ExprKind::List { elements, unit: None } => elements,
        _ => std::slice::from_ref(expr),
    };
    let choice = Choice::new(modes, expr, elements);
    match &expr.kind {
        ExprKind::List { unit: None, .. }
        | ExprKind::Name(_)
        | ExprKind::Text(_)
        | ExprKind::Range { .. }
        | ExprKind::Binary { .. } => {}
        _ => {
            let message = "`against` takes `all`, fault modes, or `where` with a condition";
            let error = Diagnostic::error(CHOICE, expr.span, message).here("none of these");
            cx.report(error.help("write `[M1, M2]`, `M1 .. M4`, or `where rpn >= 100`"));
            return None;
        }
    }
    let read: Vec<Option<Runs>> = elements.iter().map(|element| choice.read(cx, element)).collect();
    repeated::warn(cx, elements, &read);
    let mut taken = vec![false; modes.modes.len()];
    let all = read.into_iter().collect::<Option<Vec<_>>>()?;
    let all = all.into_iter().flatten().flatten();
    Some(all.filter(|&mode| !std::mem::replace(&mut taken[mode], true)).collect())
}

/// The place of the value of `field` if it is the empty list.
pub(super) fn empty_list(field: &Field) -> Option<Span> {
    match &field.value {
        FieldValue::Expr(Expr { kind: ExprKind::List { elements, .. }, span }) if elements.is_empty() => Some(*span),
        _ => None,
    }
}

/// `where rpn >= 100`: the modes that have this number and satisfy the condition.
fn filter<'a>(
    cx: &mut Context<'a>,
    field: &'a Spanned<String>,
    relation: Relation,
    value: &'a Expr,
    modes: &[FaultMode],
    incomplete: bool,
) -> Option<Vec<usize>> {
    let name = field.value.as_str();
    if !MODE_NUMBERS.contains(&name) {
        let error =
            Diagnostic::error("mavc::name::unknown_field", field.span, format!("fault modes have no number `{name}`"));
        let error = error.here("unknown number");
        cx.report(match nearest(name, MODE_NUMBERS) {
            Some(near) => error.help(format!("did you mean `{near}`?")).fix(field.span, near),
            None => error.help(format!("compare {}", either(&MODE_NUMBERS))),
        });
        return None;
    }
    let bound = cx.number(Expected::new(name, if name == "rate" { "1/h" } else { "1" }), value)?;
    let number_of = |mode: &FaultMode| match name {
        "rpn" => mode.rpn().map(f64::from),
        "severity" => mode.severity.map(f64::from),
        "occurrence" => mode.occurrence.map(f64::from),
        "detection" => mode.detection.map(f64::from),
        _ => mode.rate,
    };
    let holds = |x: f64| match relation {
        Relation::Less => x < bound,
        Relation::LessEqual => x <= bound,
        Relation::Greater => x > bound,
        Relation::GreaterEqual => x >= bound,
        Relation::Equal => x == bound,
    };
    let chosen: Vec<usize> = (0..modes.len()).filter(|&k| number_of(&modes[k]).is_some_and(holds)).collect();
    if chosen.is_empty() && !incomplete {
        let without = modes.iter().filter(|m| number_of(m).is_none()).count();
        let warning =
            Diagnostic::warning("mavc::plan::none_selected", field.span, "no fault mode satisfies this condition");
        let have = if without == 1 { "has" } else { "have" };
        let help =
            format!("give the modes a `{name}`, or change the condition: {without} of {} {have} none", modes.len());
        let help = if without == 0 { "change the condition, or list the modes".to_string() } else { help };
        cx.report(warning.here("selects nothing").help(help));
    }
    Some(chosen)
}

/// Warns of each statement none of whose modes is among `looked_at`, the modes that some block uses. If `against` is
/// the empty list at `empty` and no block uses a mode, warns only once.
pub(in crate::spec::read) fn warn_unused(
    cx: &mut Context,
    modes: &Modes,
    against: &[usize],
    looked_at: &[usize],
    empty: Option<Span>,
) {
    if let (Some(list), [], false) = (empty, looked_at, modes.modes.is_empty()) {
        return warn_none(cx, &modes.modes, list);
    }
    let mut used = vec![false; modes.modes.len()];
    looked_at.iter().for_each(|&k| used[k] = true);
    for statement in 0..modes.statements {
        let of_statement = || modes.origin.iter().enumerate().filter(move |(_, o)| **o == statement).map(|(k, _)| k);
        let Some(first) = of_statement().next() else {
            continue;
        };
        if of_statement().any(|k| used[k]) {
            continue;
        }
        let mode = &modes.modes[first];
        let count = of_statement().count();
        let message = match count {
            1 => format!("fault mode `{}` is neither planned against nor flown", mode.name),
            n => format!("none of these {n} fault modes is planned against or flown"),
        };
        let warning = Diagnostic::warning("mavc::fault::unused", mode.span, message).here("not in `against`");
        // The suggested list keeps the modes already chosen.
        let mut all = modes.families.named(against, &modes.modes);
        all.push(mode.name.as_str());
        // Which modes are controllable is known only from their sets, which this stage does not have.
        let list = format!("as in `[{}]`", all.join(", "));
        cx.report(warning.help(match count {
            1 => format!(
                "add it to `against`, {list}, if `mavc analyze` shows that a plan can tolerate it; until then `mavc \
                 plan` lists it as not covered"
            ),
            _ => format!(
                "add to `against` those that `mavc analyze` shows a plan can tolerate, {list}; until then `mavc plan` \
                 lists them as not covered"
            ),
        }));
    }
}

/// Warns of an empty `against` although modes are declared and no other block uses them.
fn warn_none(cx: &mut Context, modes: &[FaultMode], list: Span) {
    let message = "`against` is empty although fault modes are declared";
    let warning = Diagnostic::warning("mavc::plan::none_selected", list, message);
    let first = &modes[0];
    let (declared, some) = match modes.len() {
        1 => ("the only fault mode".to_string(), format!("`[{}]`", first.name)),
        n => (format!("the first of {n} fault modes"), format!("`all`, or some as in `[{}]`", first.name)),
    };
    let warning = warning.here("lists no mode").also(first.span, declared);
    cx.report(warning.help(format!("write {some}; a plan for the healthy vehicle alone needs no `faults`")));
}
