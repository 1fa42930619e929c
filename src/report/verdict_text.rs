//! The verdict on a planner's run as text: its word, and exactly what was shown.

use super::number::number;
use crate::model::{Mission, Model, PlanModel, PlannerKind};
use crate::planner::compare::protect::UNMET;
use crate::planner::compare::{Comparison, Ending, PlannerRun, Run, Solved, Verification};
use crate::planner::profile::determined;
use crate::planner::successive::NOT_FOUND;

/// `proved infeasible at 12 s with 200 samples`: the verdict on a run, for which times, and under which conditions.
pub fn statement(model: &Model, mission: &Mission, comparison: &Comparison, run: &PlannerRun) -> String {
    let verdict = run.ending.verdict();
    let samples = model.plan.samples;
    match &run.ending {
        Ending::Solved(solved) => {
            let undecided = match &solved.verification {
                Verification::Undecided(why) => format!("; not decided by the check of plans: {why}"),
                Verification::None | Verification::Passed => String::new(),
            };
            format!("{verdict}, {} s{}{undecided}", number(solved.time), shown_of_time(model, mission, run, solved))
        }
        Ending::Failed { at, why } => {
            format!("{verdict}: the motion planned for {} s fails the check of plans: {why}", number(*at))
        }
        Ending::Infeasible { proved, .. } => {
            format!("{verdict} {}{}", times(proved), conditions(model, mission, comparison, run))
        }
        Ending::Inconclusive { at, status } if status == UNMET => {
            format!("{verdict}: a plan that keeps the required risk, in up to {} s", number(*at))
        }
        Ending::Inconclusive { at, status } => {
            let others =
                if run.run == Run::Own && determined(mission).is_none() { " or any other time tried" } else { "" };
            let solver = if status == NOT_FOUND { String::new() } else { format!("; the solver stopped ({status})") };
            format!("{verdict} at {} s{others} with {samples} samples; a plan may exist{solver}", number(*at))
        }
        Ending::NotAttempted { why, .. } => format!("{verdict}: {why}"),
    }
}

/// What was shown of the time of a plan, after it.
fn shown_of_time(model: &Model, mission: &Mission, run: &PlannerRun, solved: &Solved) -> String {
    match (run.run, solved.infeasible_at) {
        (Run::Own, Some(below)) => format!(
            ", the shortest time found; {} s is proved infeasible with {} samples{}",
            number(below),
            model.plan.samples,
            // Waypoint times that are searched for are a local best.
            if model.plan.chooses_times { " and these waypoint times" } else { "" }
        ),
        (Run::Own, None) if determined(mission).is_some() => {
            ", the only time that the mission's fixed times allow".into()
        }
        (Run::Own, None) => ", the shortest time found; a shorter one may exist".into(),
        (Run::Common, _) => String::new(),
    }
}

/// The times of a proof, each of which was proved by itself.
fn times(proved: &[f64]) -> String {
    match proved {
        [] => String::new(),
        [one] => format!("at {} s", number(*one)),
        [first, .., last] => {
            format!("at each of {} times, {} to {} s,", proved.len(), number(*first), number(*last))
        }
    }
}

/// What a proof holds for, beside the spec: the grid, a yaw that was planned before the rest, and the facets selected.
fn conditions(model: &Model, mission: &Mission, comparison: &Comparison, run: &PlannerRun) -> String {
    let mut conditions = vec![format!("with {} samples", model.plan.samples)];
    if model.plan.model == PlanModel::Hover && !mission.has_one_yaw() {
        conditions.push("for the yaw planned first".into());
    }
    if run.planner == PlannerKind::Rsp && !comparison.selected.is_empty() {
        conditions.push("for the facets that the RIP plan selects".into());
    }
    format!(" {}", conditions.join(", "))
}
