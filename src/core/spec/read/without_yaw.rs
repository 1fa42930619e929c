//! `without_yaw` in `plan` and in fault modes.

use super::context::Context;
use super::fields::Fields;
use crate::language::table::plan as table;
use crate::model::GiveUpYaw;

const CODE: &str = "mavc::plan::without_yaw";

/// The field's word: `None` where it is not written, `Some(None)` where it has an error, which is reported.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Option<GiveUpYaw>> {
    fields.get(table::WITHOUT_YAW.name)?;
    let word = fields.word(cx, CODE, &table::WITHOUT_YAW)?;
    Some(GiveUpYaw::ALL.into_iter().find(|choice| Some(choice.name()) == word))
}
