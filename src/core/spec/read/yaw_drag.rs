//! `yaw_drag` and `yaw_drag_quadratic` of a vehicle.

use super::context::Context;
use super::expected::Expected;
use super::fields::Fields;
use super::written::Written;
use crate::diagnostic::Diagnostic;
use crate::language::table::vehicle as table;
use crate::model::YawDrag;

const INVALID: &str = "mavc::vehicle::not_positive";

/// `yaw_drag` and `yaw_drag_quadratic`; faulty where one has an error.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Written<YawDrag> {
    let quadratic = fields.quantity(cx, &table::YAW_DRAG_QUADRATIC, INVALID);
    if let Some(at) = fields.span_of("yaw_drag_quadratic").filter(|_| !fields.may_have("yaw_drag")) {
        let error = Diagnostic::error("mavc::vehicle::conflict", at, "`yaw_drag_quadratic` needs `yaw_drag`");
        cx.report(error.here("in addition to nothing").help("add the linear part: `yaw_drag = 3e-3 N*m*s/rad`"));
        return Written::Faulty;
    }
    let drag = fields.written("yaw_drag", |expr| {
        let due = Expected { coefficient: true, ..Expected::of(&table::YAW_DRAG) };
        let (linear, spread) = cx.interval(due, expr, INVALID)?;
        Some(YawDrag { linear, spread, quadratic: quadratic.or_default(|| table::YAW_DRAG_QUADRATIC.value())? })
    });
    if quadratic.is_faulty() { Written::Faulty } else { drag }
}
