//! Waypoint times chosen before any planner runs: those of the hover model, whose own search keeps the legs' shares,
//! and that of the last waypoint, which is the mission's time.

use super::{Comparison, Progress, Scope, with_times};
use crate::model::{Leg, Mission, MissionTime, Model, PlannerKind, Problem};
use crate::motion::time_grid::determined;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::finds_local_optima;
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::ScpPlanner;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::timing::kinematics::initial;
use crate::planner::trial::Trial;

/// In the hover model waypoint times are chosen first, by sequential convex programming with the hover model's wrench,
/// for the set that the planner imposes; the legs then keep these shares of any mission time. `None` if no plan is
/// found.
fn with_better_times(problem: Problem, progress: Progress) -> Option<Model> {
    let (model, mission) = (problem.model(), problem.mission());
    let sets = PlanningSets::of(model);
    let is_rip =
        model.plan.planner == PlannerKind::Rip || model.plan.planner == PlannerKind::Rsp && model.plan.rounds == 0;
    let set = if is_rip { &sets.rip } else { &sets.joint };
    let report = |trial: Trial| {
        if let Some(progress) = progress {
            progress("waypoint times", trial);
        }
    };
    let mut hover = HoverPlanner::new(problem, &sets.healthy);
    hover.on_trial = Some(&report);
    let wrench = match mission.has_one_yaw() {
        true => WrenchModel::HoverAt(mission.waypoints[0].yaw),
        false => WrenchModel::HoverFollowing,
    };
    let found = ScpPlanner::new(&mut hover, wrench, set).shortest(&[], None).ok()?;
    let legs = found.planned.grid.segments.iter().filter(|s| !s.hold);
    let legs = legs.map(|s| Leg { share: s.duration }).collect();
    Some(problem.with_mission(Mission { legs, ..mission.clone() }))
}

/// The comparison with shares of the time by the distance, turn and limits of each leg.
fn with_times_by_limits(problem: Problem, scope: Scope, progress: Progress) -> Comparison {
    let legs = initial(problem).into_iter().map(|share| Leg { share }).collect();
    let model = problem.with_mission(Mission { legs, ..problem.mission().clone() });
    with_times(Problem::of(&model).unwrap_or(problem), scope, progress)
}

/// If the last waypoint alone has a fixed time, the model with that as the plan's time. The SCP planner can then use
/// continuation from slower motions, as it does for missions written so.
pub(super) fn with_time_of_its_end(problem: Problem) -> Option<Model> {
    let (model, mission) = (problem.model(), problem.mission());
    let (last, others) = mission.waypoints.split_last()?;
    let alone = last.time.is_some() && others.iter().skip(1).all(|w| w.time.is_none());
    let time = determined(mission).filter(|_| alone && finds_local_optima(model))?;
    let mut model = model.clone();
    model.plan.time = MissionTime::Fixed(time);
    model.mission.as_mut()?.waypoints.last_mut()?.time = None;
    Some(model)
}

fn is_solved(comparison: &Comparison) -> bool {
    comparison.runs.last().is_some_and(|run| run.outcome.plan().is_some())
}

/// The second if it has a plan, else the first, with the effort of both.
fn better(first: Comparison, second: Comparison) -> Comparison {
    let mut effort = first.effort;
    effort += second.effort;
    Comparison { effort, ..if is_solved(&second) { second } else { first } }
}

/// The comparison in the hover model with waypoint times chosen before any planner runs.
pub(super) fn with_times_before(problem: Problem, scope: Scope, progress: Progress) -> Comparison {
    if problem.mission().has_fixed_times() {
        return about_fixed_times(problem, scope, progress);
    }
    if scope == Scope::Plan && matches!(problem.model().plan.time, MissionTime::Fixed(_)) {
        // A time that is long enough has a plan without a search for waypoint times.
        let at_once = with_times_by_limits(problem, scope, progress);
        if is_solved(&at_once) {
            return at_once;
        }
    }
    let timed = with_better_times(problem, progress);
    let first = with_times(timed.as_ref().and_then(Problem::of).unwrap_or(problem), scope, progress);
    if scope != Scope::Plan || timed.is_none() || is_solved(&first) {
        return first;
    }
    // The times chosen may be worse than shares by length at the required mission time.
    better(first, with_times(problem, scope, progress))
}

/// With fixed times, three divisions of the time in turn until one has a plan: by the limits of each leg, by the
/// lengths of the legs, and as [`with_better_times`] chooses.
fn about_fixed_times(problem: Problem, scope: Scope, progress: Progress) -> Comparison {
    let first = with_times_by_limits(problem, scope, progress);
    if is_solved(&first) {
        return first;
    }
    let second = better(first, with_times(problem, scope, progress));
    if is_solved(&second) {
        return second;
    }
    let timed = with_better_times(problem, progress);
    match timed.as_ref().and_then(Problem::of) {
        Some(timed) => better(second, with_times(timed, scope, progress)),
        None => second,
    }
}
