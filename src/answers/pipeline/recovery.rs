//! What can be done after a fault: sought along a plan, and how it compares with what the spec requires.

use super::tasks::{OtherSpec, Planning, Task};
use crate::observer::{Observer, timed};
use crate::recovery::{Recovery, recovery};
use crate::report::recovery::uncovered;

impl Task<'_> {
    /// Looks for a way out after every declared fault at instants of the plan of `planning`; `None` without a plan.
    ///
    /// # Errors
    /// `planning` is the outcome for another spec.
    pub fn recovery(&self, planning: &Planning, observer: &dyn Observer) -> Result<Option<Recovery>, OtherSpec> {
        self.ways_out(planning, observer, false)
    }

    /// The same, and families of ways out between these instants for a certificate.
    ///
    /// # Errors
    /// `planning` is the outcome for another spec.
    pub fn recovery_between(
        &self,
        planning: &Planning,
        observer: &dyn Observer,
    ) -> Result<Option<Recovery>, OtherSpec> {
        self.ways_out(planning, observer, true)
    }

    fn ways_out(
        &self,
        planning: &Planning,
        observer: &dyn Observer,
        between: bool,
    ) -> Result<Option<Recovery>, OtherSpec> {
        planning.check_spec(self.spec())?;
        let Some(plan) = planning.plan() else { return Ok(None) };
        observer.begins("looking for a way out after each fault");
        Ok(Some(timed(observer, "recovery", || recovery(self.problem(), &plan.trajectory, between))))
    }

    /// Whether a larger share of the time has no way out than `require uncovered` allows.
    pub fn exceeds_uncovered(&self, found: &Recovery) -> bool {
        let required = self.model().plan.recovery.require;
        required.is_some_and(|required| uncovered(self.model(), found).0 > required.uncovered)
    }
}
