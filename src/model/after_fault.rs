//! `after_fault` in `plan` and in fault modes: what the mission does once a fault has struck, as its risk is counted.

use super::context::Context;
use super::fields::Fields;
use super::{AfterFault, Model};
use crate::diagnostic::Diagnostic;
use crate::language::table::plan as table;
use crate::syntax::ast::ExprKind;

const CODE: &str = "mavc::plan::after_fault";

/// The field's word: `None` where it is not written, `Some(None)` where something else stands there.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Option<AfterFault>> {
    let expr = fields.get("after_fault")?;
    if matches!(&expr.kind, ExprKind::Name(name) if name == AfterFault::Land.name()) {
        let message = format!("`after_fault = land` is flown by `simulate`, and no choice in {}", fields.owner);
        let error = Diagnostic::error(CODE, expr.span, message).here("belongs to `simulate`");
        let hold = AfterFault::Hold.name();
        cx.report(error.help("a vehicle that lands comes to rest first: write `hold`").fix(expr.span, hold));
        return Some(None);
    }
    let choices = [AfterFault::Continue, AfterFault::Hold];
    let word = fields.word(cx, CODE, &table::AFTER_FAULT)?;
    Some(choices.into_iter().find(|choice| Some(choice.name()) == word))
}

impl Model {
    /// What the mission does after a fault of a mode, by its place in [`Model::modes`]: what the mode says, else the plan.
    /// Never [`AfterFault::Land`].
    pub fn after_fault(&self, mode: usize) -> AfterFault {
        self.modes[mode].after_fault.unwrap_or(self.plan.after_fault)
    }
}
