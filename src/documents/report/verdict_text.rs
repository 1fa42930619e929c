//! The verdict on a planner's run in words, with exactly what was shown.

use super::{least_time, without_yaw};
use crate::flight::indistinguishable::listed;
use crate::model::{MissionTime, Model, PlanModel, PlannerKind, Problem};
use crate::motion::time_grid::determined;
use crate::number::number;
use crate::planner::scp::NOT_FOUND;
use crate::planner::studies::protect::UNMET;
use crate::planner::studies::{
    Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run, THESE_TIMES, THIS_YAW, Verification,
};
use crate::planner::timing::kinematics::least_time_within;

/// `proved infeasible at 12 s with 200 samples`: the verdict on a run, the times it is about, and its conditions.
pub fn statement(problem: Problem, comparison: &Comparison, run: &PlannerRun) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let verdict = run.outcome.verdict();
    let samples = model.plan.samples;
    match &run.outcome {
        PlanOutcome::Planned(solved) => {
            let undecided = match &solved.verification {
                Verification::Undecided(why) => format!("; the check of plans could not decide: {why}"),
                Verification::None | Verification::Passed => String::new(),
            };
            let time = shown_of_time(problem, comparison, run, solved);
            format!("{verdict}, {} s{time}{undecided}", number(solved.time))
        }
        PlanOutcome::NotFound(NotFound::Check { at, why }) => {
            format!("{verdict}: the trajectory planned for {} s fails the check of plans: {why}", number(*at))
        }
        // If several times were proved one by one, listing them is more informative than the bound.
        PlanOutcome::Infeasible(Proof { at, proved })
            if (model.plan.chooses_times || proved.len() == 1) && least_time_within(problem).is_above(*at) =>
        {
            let least = least_time_within(problem);
            let is_of_all = least.too_early.is_some_and(|(waypoint, _)| waypoint + 1 < mission.waypoints.len());
            let which = if is_of_all { "any mission time".to_string() } else { format!("{} s", number(*at)) };
            format!("{verdict} at {which}: {}", least_time::sentence(mission, &least, *at))
        }
        PlanOutcome::Infeasible(Proof { proved, .. }) => {
            format!("{verdict} {}{}", times(proved), conditions(problem, comparison, run))
        }
        PlanOutcome::NotFound(NotFound::Search { at, status }) if status == UNMET => {
            format!("{verdict}: a plan that meets the required risk in up to {} s", number(*at))
        }
        PlanOutcome::NotFound(NotFound::Search { at, status }) => {
            let others =
                if run.run == Run::Own && determined(mission).is_none() { " or any other time tried" } else { "" };
            let more = match status.as_str() {
                NOT_FOUND => "; a plan may exist".to_string(),
                THESE_TIMES | THIS_YAW => format!("; there is none {status}, but others may have one"),
                _ => format!("; a plan may exist; the solver stopped ({status})"),
            };
            let least = least_time_within(problem);
            match least.is_above(*at) && !others.is_empty() {
                true => {
                    let below = least_time::sentence(mission, &least, *at);
                    format!("{verdict} at any time tried with {samples} samples{more}, but {below}")
                }
                false => format!("{verdict} at {} s{others} with {samples} samples{more}", number(*at)),
            }
        }
        PlanOutcome::NotAttempted { why, .. } => format!("{verdict}: {why}"),
    }
}

/// The first sentence about a run on the terminal, the page and in the JSON report: `PLAN FOUND, 35 s; planner RSP
/// (risk-sensitive)`, or `PROVED INFEASIBLE at 12 s with 200 samples; planner RSP (risk-sensitive)`.
pub fn headline(problem: Problem, comparison: &Comparison, run: &PlannerRun) -> String {
    let (text, word) = (statement(problem, comparison, run), run.outcome.verdict().word());
    let rest = text.strip_prefix(word).unwrap_or(&text);
    let (plan, beside) = match run.outcome.plan() {
        Some(_) => ("PLAN ", without_yaw::beside_the_verdict(comparison)),
        None => ("", String::new()),
    };
    let (word, planner) = (word.to_uppercase(), run.planner.name().to_uppercase());
    format!("{plan}{word}{rest}; planner {planner} ({}){beside}", run.planner.in_full())
}

/// A sentence about the times at which the planner found plans (`found_at`, s, ascending) after it found none at the
/// spec's time.
pub fn elsewhere(model: &Model, found_at: &[f64]) -> Option<String> {
    let MissionTime::Fixed(required) = model.plan.time else { return None };
    let shorter = found_at.iter().rfind(|time| **time < required);
    let longer = found_at.iter().find(|time| **time > required);
    let required = number(required);
    match (shorter.copied().map(number), longer.copied().map(number)) {
        (Some(shorter), Some(longer)) => Some(format!(
            "Plans were found at {shorter} s and at {longer} s. At {required} s none was found, and nothing in the \
             spec was shown to rule one out: the planner may have missed it. Try one of these times."
        )),
        (None, Some(longer)) => Some(format!(
            "A plan was found at {longer} s. At {required} s none was found; whether one exists is open. Try {longer} \
             s, or `time = minimum`."
        )),
        _ => None,
    }
}

/// What was shown about the time of a plan, to follow it.
fn shown_of_time(problem: Problem, comparison: &Comparison, run: &PlannerRun, solved: &MissionPlan) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    match (run.run, solved.infeasible_at) {
        (Run::Own, _) if comparison.for_ways_out => ", planned again for ways out after faults".into(),
        (Run::Own, Some(below)) => {
            let conditions = conditions(problem, comparison, run);
            let gap = least_time::gap(problem, run).filter(|_| model.plan.chooses_times);
            let gap = gap.map_or(String::new(), |gap| format!("; {gap}"));
            format!(", the shortest time found; {} s is proved infeasible{conditions}{gap}", number(below))
        }
        (Run::Own, None) if determined(mission).is_some() => {
            ", the only time that the mission's fixed times allow".into()
        }
        (Run::Own, None) => {
            let gap = least_time::gap(problem, run).unwrap_or("a shorter one may exist".into());
            format!(", the shortest time found; {gap}")
        }
        (Run::Common, _) if matches!(model.plan.time, MissionTime::Fixed(_)) => ", the spec's time".into(),
        (Run::Common, _) => String::new(),
    }
}

/// The times of a proof, each proved separately.
fn times(proved: &[f64]) -> String {
    match proved {
        [] => String::new(),
        [one] => format!("at {} s", number(*one)),
        [first, .., last] => {
            format!("at each of {} times, {} to {} s,", proved.len(), number(*first), number(*last))
        }
    }
}

/// The conditions under which a proof holds, beyond the spec: the grid, waypoint times and a yaw that were chosen
/// before the rest, and the selected facets.
fn conditions(problem: Problem, comparison: &Comparison, run: &PlannerRun) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let samples = format!("{} samples", model.plan.samples);
    let mut conditions = vec![samples.as_str()];
    // Waypoint times that are searched for are only locally optimal.
    if model.plan.chooses_times {
        conditions.push("these waypoint times");
    }
    if model.plan.model == PlanModel::Hover && !mission.has_one_yaw() {
        conditions.push("the yaw planned first");
    }
    // The rows imposed beyond the healthy set follow from plans, and a proof holds for these rows only.
    if run.planner == PlannerKind::Rsp && model.plan.require_risk.is_some() {
        conditions.push("the protection chosen to meet the required risk");
    } else if run.planner == PlannerKind::Rsp && !comparison.selected.is_empty() {
        conditions.push("the facets that RSP guards");
    }
    format!(" with {}", listed(&conditions))
}
