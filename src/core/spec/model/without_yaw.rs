//! `without_yaw` in `plan` and in fault modes: whether yaw may be given up after a fault.

use super::Model;
use super::context::Context;
use super::fields::Fields;
use crate::language::table::plan as table;

const CODE: &str = "mavc::plan::without_yaw";

/// Whether yaw is given up on purpose once a fault is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GiveUpYaw {
    /// Never: the heading is held as far as the rotors that are left allow.
    Never,
    /// Where the rotors that are left do not control all axes about hover.
    #[default]
    WhereNeeded,
    /// Always.
    Always,
}

impl GiveUpYaw {
    const ALL: [GiveUpYaw; 3] = [GiveUpYaw::Never, GiveUpYaw::WhereNeeded, GiveUpYaw::Always];

    /// The word of the language.
    pub fn name(self) -> &'static str {
        match self {
            GiveUpYaw::Never => "never",
            GiveUpYaw::WhereNeeded => "where_needed",
            GiveUpYaw::Always => "always",
        }
    }
}

/// The field's word: `None` where it is not written, `Some(None)` where it has an error, which is reported.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Option<GiveUpYaw>> {
    fields.get(table::WITHOUT_YAW.name)?;
    let word = fields.word(cx, CODE, &table::WITHOUT_YAW)?;
    Some(GiveUpYaw::ALL.into_iter().find(|choice| Some(choice.name()) == word))
}

impl Model {
    /// Whether yaw is given up after a fault of the mode with index `mode` in [`Model::modes`]: the mode's own word, or else the
    /// plan's.
    ///
    /// # Panics
    /// If there is no such mode.
    pub fn gives_up_yaw(&self, mode: usize) -> GiveUpYaw {
        self.modes[mode].without_yaw.unwrap_or(self.plan.without_yaw)
    }
}
