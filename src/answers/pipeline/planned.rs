//! What planning gives (`tasks` plans): a plan with what was tried, and why none was found.

use super::refusals::OtherSpec;
use super::tasks::Task;
use crate::certify::between::{Between, between};
use crate::explain::Explanation;
use crate::explain::detour::Detour;
use crate::explain::nearby::Nearby;
use crate::flight::capture::heights::CaptureHeights;
use crate::observer::{Observer, timed};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun};
use crate::spec::{Spec, SpecIdentity};
use crate::verdict::Verdict;
use std::sync::{Arc, OnceLock};

/// The outcome of planning one mission with the spec's planner.
#[derive(Debug, Clone)]
pub struct Planning {
    pub(super) comparison: Comparison,
    /// The spec that was planned.
    pub(super) spec: SpecIdentity,
    /// The simulated height that its limits keep, m.
    pub(super) height: Option<f64>,
    /// The captures against which it is measured, once they are simulated.
    pub(super) capture_heights: OnceLock<Option<Arc<CaptureHeights>>>,
    /// The detours of its plan, with what statements against them gave.
    pub(super) detours: Vec<Detour>,
    /// Whether its search was ended before it was done.
    pub(super) cut_short: bool,
}

impl Planning {
    pub(super) fn run(&self) -> &PlannerRun {
        &self.comparison.runs[self.comparison.runs.len() - 1]
    }

    /// A plan, a proof of infeasibility, or neither.
    pub fn outcome(&self) -> &PlanOutcome {
        &self.run().outcome
    }

    /// The outcome as one of four words.
    pub fn verdict(&self) -> Verdict {
        self.outcome().verdict()
    }

    /// The plan, if one was found.
    pub fn plan(&self) -> Option<&MissionPlan> {
        self.outcome().plan()
    }

    /// What reports print: the sets, the facets that RSP selected, and under `require risk` the trade-off.
    pub fn comparison(&self) -> &Comparison {
        &self.comparison
    }

    /// The detours of the plan with what was tried. Where one quick search is cheap, statements that forbid them were
    /// tried together.
    pub fn detours(&self) -> &[Detour] {
        &self.detours
    }

    /// Whether the search was told to end with what it had: a longer search may find a shorter plan.
    pub fn was_cut_short(&self) -> bool {
        self.cut_short
    }

    /// Puts another plan of the mission in place of the one that was found.
    pub(super) fn replace(&mut self, task: &Task, comparison: Comparison) {
        self.detours = comparison.runs.last().map_or(Vec::new(), |run| task.untried(run));
        self.comparison = comparison;
        self.capture_heights = OnceLock::new();
    }

    /// The rows of the plan that are proved to hold between its nodes; `None` without a plan.
    ///
    /// # Errors
    /// `task` is that of another spec.
    pub fn between(&self, task: &Task, observer: &dyn Observer) -> Result<Option<Vec<Between>>, OtherSpec> {
        self.check_spec(task.spec())?;
        observer.begins("looking for a proof of every instant");
        Ok(timed(observer, "prove", || {
            let run = self.run();
            run.outcome.plan().map(|plan| between(task.problem(), run, plan))
        }))
    }

    /// # Errors
    /// Another spec was planned.
    pub(super) fn check_spec(&self, spec: &Spec) -> Result<(), OtherSpec> {
        if self.spec == spec.identity() { Ok(()) } else { Err(OtherSpec) }
    }
}

/// Why no plan was found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Explained {
    /// Times below and above the spec's at which the planner found a plan. If there is one, no statement is blamed.
    pub nearby: Nearby,
    /// Statements that together leave no plan, proved or as far as the search found, and changes that give one.
    pub conflict: Option<Explanation>,
}
