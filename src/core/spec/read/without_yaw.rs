//! `without_yaw` in `plan` and in fault modes.

use super::context::Context;
use super::fields::Fields;
use super::written::Written;
use crate::language::table::plan as table;
use crate::model::GiveUpYaw;

const CODE: &str = "mavc::plan::without_yaw";

/// The field's word.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Written<GiveUpYaw> {
    fields.choice(cx, &table::WITHOUT_YAW, CODE, &GiveUpYaw::ALL)
}
