//! Mission times close to the required one at which the planner finds a plan after it found none at that time. If there
//! is one, no statement of the spec is blamed. The searches are quick ones whatever the spec's effort.

use crate::certify;
use crate::model::{MissionTime, Problem, SearchEffort};
use crate::motion::time_grid::determined;
use crate::planner::scp::NOT_FOUND;
use crate::planner::studies::{Comparison, NOTHING_TO_SELECT_BY, NotFound, PlanOutcome, Scope, run_planners};
use crate::solve::Effort;

/// Multiples of the required time that are tried, the nearest first, if the shortest time found is not longer than that
/// or if none was found. Chosen by hand.
const LONGER: [f64; 5] = [1.02, 1.05, 1.1, 1.3, 2.0];

/// Mission times, s, at which the spec's planner has a plan that passes the check of plans.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Nearby {
    pub shorter: Option<f64>,
    pub longer: Option<f64>,
}

impl Nearby {
    /// In ascending order.
    pub fn times(self) -> impl Iterator<Item = f64> {
        self.shorter.into_iter().chain(self.longer)
    }
}

/// The required time, if no plan was found and nothing was proved; otherwise `None`.
fn required_time(problem: Problem, comparison: &Comparison) -> Option<f64> {
    let (model, mission) = (problem.model(), problem.mission());
    let MissionTime::Fixed(time) = model.plan.time else { return None };
    let is_open = match &comparison.runs.last()?.outcome {
        PlanOutcome::NotFound(NotFound::Search { status, .. }) => status == NOT_FOUND,
        PlanOutcome::NotAttempted { why, .. } => why == NOTHING_TO_SELECT_BY,
        PlanOutcome::NotFound(NotFound::Check { .. }) => true,
        _ => false,
    };
    (is_open && determined(mission).is_none() && model.plan.require_risk.is_none()).then_some(time)
}

/// Searches for plans at times near the spec's, if the planner found none there. `on_progress` is called with each
/// time, s.
pub fn nearby(problem: Problem, comparison: &Comparison, on_progress: &dyn Fn(f64)) -> (Nearby, Effort) {
    let mut effort = Effort::default();
    let Some(required) = required_time(problem, comparison) else { return (Nearby::default(), effort) };
    let mut plan_at = |time: MissionTime| {
        let mut other = problem.model().clone();
        other.plan.time = time;
        other.plan.effort = SearchEffort::Quick;
        let other = Problem::of(&other)?;
        let mut found = run_planners(other, Scope::Plan, None);
        effort += found.effort;
        certify::check(other, &mut found);
        found.runs.last().and_then(|run| run.outcome.plan()).map(|solved| solved.time)
    };
    on_progress(required);
    let shortest = plan_at(MissionTime::Minimum);
    if let Some(longer) = shortest.filter(|&time| time > required) {
        return (Nearby { shorter: None, longer: Some(longer) }, effort);
    }
    let longer = LONGER.iter().find_map(|share| {
        let time = rounded(share * required);
        on_progress(time);
        plan_at(MissionTime::Fixed(time))
    });
    (Nearby { shorter: shortest.filter(|&time| time < required), longer }, effort)
}

/// Rounded to four digits, as an author would write it.
fn rounded(time: f64) -> f64 {
    format!("{time:.3e}").parse().unwrap_or(time)
}
