//! `require risk <= 1e-6` and `require uncovered <= 0 %`: a bound that the plan must satisfy. `require capture_height
//! { }` has a reader of its own.

use crate::diagnostic::Diagnostic;
use crate::model::{FaultMode, PlannerKind};
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::source::Span;
use crate::syntax::ast::{Expr, Statement};

const CODE: &str = "mavc::plan::require";

/// What is bounded.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Bounded {
    /// The risk of the mission, a probability.
    Risk,
    /// The share of the time without a way out after a fault.
    Uncovered,
    /// A name that is not known, which is reported.
    Unknown,
}

/// The statement, before the modes are known.
pub(super) struct Requirement {
    pub bounded: Bounded,
    /// A probability or a share; `None` if it has an error.
    pub at_most: Option<f64>,
    pub span: Span,
}

/// Reads the statement, if there is one.
pub(super) fn read<'a>(cx: &mut Context<'a>, body: &'a [Statement]) -> Option<Requirement> {
    let mut found: Option<Requirement> = None;
    for statement in body {
        let Statement::Require { name, at_most: bound, span } = statement else { continue };
        let (bounded, at_most) = match name.value.as_str() {
            "risk" => (Bounded::Risk, risk(cx, bound)),
            "uncovered" => (Bounded::Uncovered, cx.share("the required `uncovered`", bound, CODE)),
            "capture_height" => {
                let message = "`require capture_height` takes no bound: the height is simulated";
                let error = Diagnostic::error(CODE, bound.span, message).here("remove the bound");
                cx.report(error.help("write `require capture_height { }`"));
                continue;
            }
            other => {
                let error = Diagnostic::error(CODE, name.span, format!("`{other}` cannot be required"));
                let error = error.here("none of `risk`, `uncovered` and `capture_height`");
                cx.report(error.help(
                    "write `require risk <= 1e-6`, `require uncovered <= 0 %` or `require capture_height { }`; limits \
                     go into the mission's `limits` block",
                ));
                (Bounded::Unknown, None)
            }
        };
        match &found {
            None => found = Some(Requirement { bounded, at_most, span: *span }),
            Some(first) => cx.report(second(first, bounded, *span)),
        }
    }
    found
}

/// The error for a second bound.
fn second(first: &Requirement, bounded: Bounded, span: Span) -> Diagnostic {
    let is_both =
        matches!((first.bounded, bounded), (Bounded::Risk, Bounded::Uncovered) | (Bounded::Uncovered, Bounded::Risk));
    let error = if is_both {
        let error = Diagnostic::error(CODE, span, "a plan cannot require both `risk` and `uncovered`");
        error.here("a second bound").help("remove one: with a bound on the risk the planner chooses what to protect")
    } else {
        let error = Diagnostic::error("mavc::name::duplicate", span, "`require` is given twice in `plan`");
        error.here("given again").help("keep the smaller bound")
    };
    error.also(first.span, "first given here")
}

/// A probability.
fn risk<'a>(cx: &mut Context<'a>, bound: &'a Expr) -> Option<f64> {
    let value = cx.number(Expected::new("risk", "1"), bound)?;
    if (0.0..1.0).contains(&value) {
        return Some(value);
    }
    let error = Diagnostic::error(CODE, bound.span, "the required risk must be from 0 to below 1");
    let error = error.here(format!("this is {}", number(value)));
    cx.report(error.help("write a probability for the whole mission, such as `1e-6`"));
    None
}

impl Requirement {
    /// The bound on the risk, if it can be required: the planner is free to choose the modes, and every mode has a
    /// rate. Reports errors otherwise.
    pub fn check_risk(
        &self,
        cx: &mut Context,
        planner: Option<PlannerKind>,
        against: Option<&[usize]>,
        modes: &[FaultMode],
    ) -> Option<f64> {
        let mut fine = true;
        if let Some(kind) = planner.filter(|kind| *kind != PlannerKind::Rsp) {
            let message = format!("`require risk` cannot be combined with `planner = {}`", kind.name());
            let error =
                Diagnostic::error(CODE, self.span, message).here("needs a planner that chooses what to protect");
            cx.report(error.help("remove `planner`, or write `planner = rsp`"));
            fine = false;
        }
        let unrated: Vec<&FaultMode> =
            against.unwrap_or_default().iter().filter_map(|&i| modes.get(i)).filter(|m| m.rate.is_none()).collect();
        if let Some(first) = unrated.first() {
            let message = match unrated.as_slice() {
                [one] => format!("mode `{}` has no rate, so its risk is unknown", one.name),
                all => format!("{} modes, such as `{}`, have no rate, so their risk is unknown", all.len(), first.name),
            };
            let mut error =
                Diagnostic::error("mavc::plan::without_rate", self.span, message).here("a risk is required here");
            let mut labelled: Vec<Span> = Vec::new();
            for mode in &unrated {
                if !labelled.contains(&mode.span) && labelled.len() < 3 {
                    labelled.push(mode.span);
                    error = error.also(mode.span, "no rate");
                }
            }
            cx.report(
                error.help("give each mode its failure rate, such as `rate = 1e-5 1/h`, or remove it from `against`"),
            );
            fine = false;
        }
        self.at_most.filter(|_| fine)
    }
}
