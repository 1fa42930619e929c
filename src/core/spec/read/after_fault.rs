//! `after_fault` in `plan` and in fault modes.

use super::context::Context;
use super::fields::Fields;
use crate::diagnostic::Diagnostic;
use crate::language::table::plan as table;
use crate::model::AfterFault;
use crate::syntax::ast::ExprKind;

const CODE: &str = "mavc::plan::after_fault";

/// The field's word: `None` where it is not written, `Some(None)` where it has an error, which is reported.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Option<AfterFault>> {
    let expr = fields.get("after_fault")?;
    if matches!(&expr.kind, ExprKind::Name(name) if name == AfterFault::Land.name()) {
        let message = format!("`after_fault = land` is not allowed in {}", fields.owner);
        let error = Diagnostic::error(CODE, expr.span, message).here("only `simulate` takes `land`");
        let hold = AfterFault::Hold.name();
        cx.report(error.help("write `hold`: a vehicle that lands comes to rest first").fix(expr.span, hold));
        return Some(None);
    }
    let choices = [AfterFault::Continue, AfterFault::Hold];
    let word = fields.word(cx, CODE, &table::AFTER_FAULT)?;
    Some(choices.into_iter().find(|choice| Some(choice.name()) == word))
}
