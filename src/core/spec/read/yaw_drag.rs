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
    let quadratic = match fields.get("yaw_drag_quadratic") {
        Some(expr) => cx.quantity(&table::YAW_DRAG_QUADRATIC, expr, INVALID),
        None => Some(table::YAW_DRAG_QUADRATIC.value()),
    };
    let Some(expr) = fields.get("yaw_drag") else {
        let Some(at) = fields.span_of("yaw_drag_quadratic").filter(|_| !fields.may_have("yaw_drag")) else {
            return if quadratic.is_some() { Written::Absent } else { Written::Faulty };
        };
        let error = Diagnostic::error("mavc::vehicle::conflict", at, "`yaw_drag_quadratic` needs `yaw_drag`");
        cx.report(error.here("in addition to nothing").help("add the linear part: `yaw_drag = 3e-3 N*m*s/rad`"));
        return Written::Faulty;
    };
    let linear = cx.interval(Expected { coefficient: true, ..Expected::of(&table::YAW_DRAG) }, expr, INVALID);
    let drag = linear.zip(quadratic).map(|((linear, spread), quadratic)| YawDrag { linear, spread, quadratic });
    Written::of(drag)
}
