//! The reaction to a fault that the risk of a mission assumes.

use super::{AfterFault, Model};

impl Model {
    /// The reaction to a fault of the mode with index `mode` in [`Model::modes`]: the mode's own, or else the plan's.
    /// Never [`AfterFault::Land`].
    ///
    /// # Panics
    /// If there is no such mode.
    pub fn after_fault(&self, mode: usize) -> AfterFault {
        self.modes[mode].after_fault.unwrap_or(self.plan.after_fault)
    }
}
