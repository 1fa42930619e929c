//! `require risk <= 1e-6`: a bound that the plan must satisfy. `require capture_height { }` has a reader of its own.

use crate::diagnostic::Diagnostic;
use crate::model::{FaultMode, PlannerKind};
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::source::Span;
use crate::syntax::ast::Statement;

const CODE: &str = "mavc::plan::require";

/// The statement, before the modes are known.
pub(super) struct Risk {
    /// A probability; `None` if it has an error.
    at_most: Option<f64>,
    pub span: Span,
}

/// Reads the statement, if there is one.
pub(super) fn read<'a>(cx: &mut Context<'a>, body: &'a [Statement]) -> Option<Risk> {
    let mut found: Option<Risk> = None;
    for statement in body {
        let Statement::Require { name, at_most: bound, span } = statement else { continue };
        if let Some(first) = &found {
            let error = Diagnostic::error("mavc::name::duplicate", *span, "`require` is given twice in `plan`");
            cx.report(error.here("given again").also(first.span, "first given here").help("keep the smaller bound"));
            continue;
        }
        let at_most = match name.value.as_str() {
            "risk" => cx.number(Expected::new("risk", "1"), bound).and_then(|value| {
                if (0.0..1.0).contains(&value) {
                    return Some(value);
                }
                let error = Diagnostic::error(CODE, bound.span, "the required risk must be from 0 to below 1");
                let error = error.here(format!("this is {}", number(value)));
                cx.report(error.help("write a probability for the whole mission, such as `1e-6`"));
                None
            }),
            "capture_height" => {
                let message = "`require capture_height` takes no bound: the height is simulated";
                let error = Diagnostic::error(CODE, bound.span, message).here("remove the bound");
                cx.report(error.help("write `require capture_height { }`"));
                continue;
            }
            other => {
                let error = Diagnostic::error(CODE, name.span, format!("`{other}` cannot be required"));
                let error = error.here("neither `risk` nor `capture_height`");
                cx.report(error.help(
                    "write `require risk <= 1e-6` or `require capture_height { }`; limits go into \
                    the mission's `limits` block",
                ));
                None
            }
        };
        found = Some(Risk { at_most, span: *span });
    }
    found
}

impl Risk {
    /// The bound, if it can be required: the planner is free to choose the modes, and every mode has a rate. Reports
    /// errors otherwise.
    pub fn check(
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
