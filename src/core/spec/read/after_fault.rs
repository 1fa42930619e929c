//! `after_fault` in `plan` and in fault modes.

use super::context::Context;
use super::fields::Fields;
use super::written::Written;
use crate::diagnostic::Diagnostic;
use crate::language::table::plan as table;
use crate::model::AfterFault;
use crate::syntax::ast::ExprKind;

const CODE: &str = "mavc::plan::after_fault";

/// The field's word.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Written<AfterFault> {
    if let Some(expr) = fields.get("after_fault")
        && matches!(&expr.kind, ExprKind::Name(name) if name == AfterFault::Land.name())
    {
        let message = format!("`after_fault = land` is not allowed in {}", fields.owner);
        let error = Diagnostic::error(CODE, expr.span, message).here("only `simulate` takes `land`");
        let hold = AfterFault::Hold.name();
        cx.report(error.help("write `hold`: a vehicle that lands comes to rest first").fix(expr.span, hold));
        return Written::Faulty;
    }
    fields.choice(cx, &table::AFTER_FAULT, CODE, &[AfterFault::Continue, AfterFault::Hold])
}
