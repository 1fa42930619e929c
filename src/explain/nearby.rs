//! Mission times close to the one asked for at which the planner finds a plan, where it found none at that time. If there is
//! one, the spec is not blamed.

use crate::certify;
use crate::model::{Mission, MissionTime, Model};
use crate::motion::time_grid::determined;
use crate::planner::scp::NOT_FOUND;
use crate::planner::studies::{Comparison, NOTHING_TO_SELECT_BY, NotFound, PlanOutcome, Scope, compare};
use crate::solve::Effort;

/// Shares of the time asked for that are tried, the nearest first, where the shortest time found is no longer than that, or where
/// none was found.
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

/// The time asked for where none was found there and nothing was proved; `None` of all else.
fn asked_for(model: &Model, mission: &Mission, comparison: &Comparison) -> Option<f64> {
    let MissionTime::Fixed(time) = model.plan.time else { return None };
    let is_open = match &comparison.runs.last()?.outcome {
        PlanOutcome::NotFound(NotFound::Search { status, .. }) => status == NOT_FOUND,
        PlanOutcome::NotAttempted { why, .. } => why == NOTHING_TO_SELECT_BY,
        PlanOutcome::NotFound(NotFound::Check { .. }) => true,
        _ => false,
    };
    (is_open && determined(mission).is_none() && model.plan.require_risk.is_none()).then_some(time)
}

/// Looks for plans at times beside the spec's, where the planner found none there. `tell` hears each time, s.
pub fn nearby(model: &Model, mission: &Mission, comparison: &Comparison, tell: &dyn Fn(f64)) -> (Nearby, Effort) {
    let mut effort = Effort::default();
    let Some(asked) = asked_for(model, mission, comparison) else { return (Nearby::default(), effort) };
    let mut plan_at = |time: MissionTime| {
        let mut other = model.clone();
        other.plan.time = time;
        let mut found = compare(&other, mission, Scope::Plan, None);
        effort += found.effort;
        certify::check(&other, mission, &mut found);
        found.runs.last().and_then(|run| run.outcome.plan()).map(|solved| solved.time)
    };
    tell(asked);
    let shortest = plan_at(MissionTime::Minimum);
    if let Some(longer) = shortest.filter(|&time| time > asked) {
        return (Nearby { shorter: None, longer: Some(longer) }, effort);
    }
    let longer = LONGER.iter().find_map(|share| {
        let time = rounded(share * asked);
        tell(time);
        plan_at(MissionTime::Fixed(time))
    });
    (Nearby { shorter: shortest.filter(|&time| time < asked), longer }, effort)
}

/// To four digits: a time that one would write.
fn rounded(time: f64) -> f64 {
    format!("{time:.3e}").parse().unwrap_or(time)
}
