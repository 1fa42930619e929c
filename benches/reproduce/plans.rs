//! The comparison of planners for each of the paper's cases, run once.

use super::specs;
use mavc::model::{Mission, Model, PlannerKind};
use mavc::motion::outside::Outside;
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Run, label};
use mavc::report::record::{Errors, errors};
use std::sync::OnceLock;

pub struct Plans {
    pub model: Model,
    pub mission: Mission,
    pub comparison: Comparison,
}

/// Case 1, 2 or 3.
pub fn of_case(number: usize) -> &'static Plans {
    static CASES: [OnceLock<Plans>; 3] = [const { OnceLock::new() }; 3];
    CASES[number - 1].get_or_init(|| {
        let spec = specs::case(number);
        let comparison = mavc::compare(&spec).unwrap_or_else(|refusal| panic!("case {number}: {refusal}"));
        let mission = spec.mission().cloned().unwrap_or_else(|| panic!("case {number} has a mission"));
        Plans { model: spec.model().clone(), mission, comparison }
    })
}

/// `RIP`, `RCP M1`, `RCP jointly`, `RSP`.
pub fn name(run: &PlannerRun) -> String {
    match (run.planner, run.against.len()) {
        (PlannerKind::Rcp, modes) if modes > 1 => JOINTLY.into(),
        _ => label(run.planner, &run.against),
    }
}

pub const JOINTLY: &str = "RCP jointly";

impl Plans {
    pub fn runs(&self, which: Run) -> impl Iterator<Item = &PlannerRun> {
        self.comparison.runs.iter().filter(move |r| r.run == which)
    }

    /// The planner's plan, if it has one.
    pub fn found(&self, planner: &str, which: Run) -> Option<&MissionPlan> {
        self.runs(which).find(|r| name(r) == planner).and_then(solved)
    }

    /// The same for a plan that the page needs.
    pub fn plan(&self, planner: &str, which: Run) -> &MissionPlan {
        self.found(planner, which).unwrap_or_else(|| panic!("{planner} has no plan ({which:?})"))
    }

    /// Own shortest time, s.
    pub fn shortest(&self, planner: &str) -> f64 {
        self.plan(planner, Run::Own).time
    }

    pub fn errors(&self, planner: &str, which: Run) -> Errors {
        errors(&self.mission, self.plan(planner, which))
    }

    /// T_d, s.
    pub fn common_time(&self) -> f64 {
        self.comparison.common_time.expect("some mode has a plan")
    }

    /// The violations of a mode's set by a planner's plan at T_d.
    pub fn outside(&self, planner: &str, mode: &str) -> &Outside {
        let place = self.comparison.modes.iter().position(|m| m == mode);
        &self.plan(planner, Run::Common).outside[place.unwrap_or_else(|| panic!("no mode {mode}"))]
    }

    /// Violated (facet, node) pairs over all modes at T_d.
    pub fn violations(&self, planner: &str) -> usize {
        self.plan(planner, Run::Common).outside.iter().map(|o| o.rows).sum()
    }
}

pub fn solved(run: &PlannerRun) -> Option<&MissionPlan> {
    match &run.outcome {
        PlanOutcome::Planned(s) => Some(s),
        _ => None,
    }
}
