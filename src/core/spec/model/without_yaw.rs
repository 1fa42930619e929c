//! Whether yaw may be given up after a fault.

use super::Model;

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
    /// Every choice.
    pub const ALL: [GiveUpYaw; 3] = [GiveUpYaw::Never, GiveUpYaw::WhereNeeded, GiveUpYaw::Always];

    /// The word of the language.
    pub fn name(self) -> &'static str {
        match self {
            GiveUpYaw::Never => "never",
            GiveUpYaw::WhereNeeded => "where_needed",
            GiveUpYaw::Always => "always",
        }
    }
}

impl Model {
    /// Whether yaw is given up after a fault of the mode with index `mode` in [`Model::modes`]: the mode's own word, or
    /// else the plan's.
    ///
    /// # Panics
    /// If there is no such mode.
    pub fn gives_up_yaw(&self, mode: usize) -> GiveUpYaw {
        self.modes[mode].without_yaw.unwrap_or(self.plan.without_yaw)
    }
}
