//! What can be done after a fault: sought along a plan, and how it compares with what the spec requires. Where too much
//! has no way out, the mission is planned again.

use super::planned::Planning;
use super::refusals::OtherSpec;
use super::tasks::Task;
use crate::number::{percent, significant};
use crate::observer::{Observer, timed};
use crate::recovery::replanning::replanned;
use crate::recovery::{Recovery, recovery};
use crate::report::recoverable::RecoverableRecord;
use crate::report::recovery::uncovered;

impl Task<'_> {
    /// Looks for a way out after every declared fault at instants of the plan of `planning`, and with `between` for
    /// families of ways out between these instants, for a certificate; `None` without a plan. If a larger share of the
    /// time has none than `require uncovered` allows, the mission is planned again with more room, and `planning`
    /// becomes what that gives.
    ///
    /// # Errors
    /// `planning` is the outcome for another spec.
    pub fn recovery(
        &self,
        planning: &mut Planning,
        between: bool,
        observer: &dyn Observer,
    ) -> Result<Option<Recovery>, OtherSpec> {
        planning.check_spec(self.spec())?;
        let Some(plan) = planning.plan() else { return Ok(None) };
        observer.begins("looking for a way out after each fault");
        let required = self.model().plan.recovery.require.is_some();
        // Families are sought once, about the plan that stays.
        let sought = between && !required;
        let mut found = timed(observer, "recovery", || recovery(self.problem(), &plan.trajectory, sought));
        if self.exceeds_uncovered(&found) {
            found = timed(observer, "re-planning", || self.again(planning, found, observer));
        }
        if let (true, Some(plan)) = (between && required, planning.plan()) {
            observer.begins("looking for families of ways out");
            let (change, longer) = (found.change, found.longer);
            found = timed(observer, "recovery", || recovery(self.problem(), &plan.trajectory, true));
            (found.change, found.longer) = (change, longer);
        }
        Ok(Some(found))
    }

    /// The plan of [`Task::plan`] and [`Task::recovery`] with its price, beside a comparison of planners; `None` if the
    /// spec does not require ways out.
    pub fn recoverable(&self, observer: &dyn Observer) -> Option<RecoverableRecord> {
        self.model().plan.recovery.require?;
        let mut planning = self.plan(observer);
        // It is a plan for this spec.
        let found = self.recovery(&mut planning, false, observer).ok()?;
        RecoverableRecord::new(self.model(), planning.run(), found.as_ref())
    }

    /// Plans again with more room, and keeps what leaves a smaller share of the time without a way out.
    fn again(&self, planning: &mut Planning, found: Recovery, observer: &dyn Observer) -> Recovery {
        let Some(required) = self.model().plan.recovery.require else { return found };
        let tries = |reserve: f64, time: Option<f64>| {
            let time = time.map_or(String::new(), |time| format!(" in {} s", significant(time, 3)));
            observer.begins(&format!("planning for ways out{time}, with {} in reserve", percent(reserve)));
        };
        let share = |found: &Recovery| uncovered(self.model(), found).0;
        let again = replanned(self.problem(), planning.comparison(), &found, &share, required.uncovered, &tries);
        let kept = match again.replanned {
            Some(replanned) => {
                planning.replace(self, replanned.comparison);
                replanned.recovery
            }
            None => found,
        };
        Recovery { longer: again.longer, ..kept }
    }

    /// Whether a larger share of the time has no way out than `require uncovered` allows.
    pub fn exceeds_uncovered(&self, found: &Recovery) -> bool {
        let required = self.model().plan.recovery.require;
        required.is_some_and(|required| uncovered(self.model(), found).0 > required.uncovered)
    }
}
