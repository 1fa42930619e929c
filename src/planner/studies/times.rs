//! Waypoint times chosen before any planner runs: those of the hover model, whose own search keeps the legs' shares, and that of the
//! last waypoint, which is the mission's time.

use super::{Comparison, Progress, Scope, with_times};
use crate::model::{Leg, Mission, MissionTime, Model, PlannerKind};
use crate::motion::time_grid::{determined, has_fixed_times};
use crate::motion::wrench_model::WrenchModel;
use crate::planner::finds_local_optima;
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::ScpPlanner;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::timing::kinematics::initial;

/// In the hover model waypoint times are chosen first, by sequential convex programming with the hover model's wrench, for the set
/// that the planner imposes; the legs then keep these shares of any mission time. `None` if no plan is found.
fn with_better_times(model: &Model, mission: &Mission, progress: Progress) -> Option<Mission> {
    let sets = PlanningSets::of(model);
    let is_rip =
        model.plan.planner == PlannerKind::Rip || model.plan.planner == PlannerKind::Rsp && model.plan.rounds == 0;
    let set = if is_rip { &sets.rip } else { &sets.joint };
    let report = |t: f64| {
        if let Some(progress) = progress {
            progress("waypoint times", t);
        }
    };
    let mut hover = HoverPlanner::new(model, mission, &sets.healthy);
    hover.on_progress = Some(&report);
    let wrench = match mission.has_one_yaw() {
        true => WrenchModel::HoverAt(mission.waypoints[0].yaw),
        false => WrenchModel::HoverFollowing,
    };
    let found = ScpPlanner::new(&mut hover, wrench, set).shortest(&[], None).ok()?;
    let legs = found.planned.grid.segments.iter().filter(|s| !s.hold);
    Some(Mission { legs: legs.map(|s| Leg { share: s.duration }).collect(), ..mission.clone() })
}

/// The same mission with shares of the time by the distance, turn and limits of each leg.
fn by_their_limits(model: &Model, mission: &Mission) -> Mission {
    let legs = initial(model, mission).into_iter().map(|share| Leg { share }).collect();
    Mission { legs, ..mission.clone() }
}

/// If the last waypoint alone has a fixed time, the same mission with that as the plan's time. The SCP planner can then use
/// continuation from slower motions, as it does for missions written so.
pub(super) fn with_time_of_its_end(model: &Model, mission: &Mission) -> Option<(Model, Mission)> {
    let (last, others) = mission.waypoints.split_last()?;
    let alone = last.time.is_some() && others.iter().skip(1).all(|w| w.time.is_none());
    let time = determined(mission).filter(|_| alone && finds_local_optima(model))?;
    let (mut model, mut mission) = (model.clone(), mission.clone());
    model.plan.time = MissionTime::Fixed(time);
    mission.waypoints.last_mut()?.time = None;
    Some((model, mission))
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
pub(super) fn with_times_before(model: &Model, mission: &Mission, scope: Scope, progress: Progress) -> Comparison {
    if has_fixed_times(mission) {
        return about_fixed_times(model, mission, scope, progress);
    }
    if scope == Scope::Plan && matches!(model.plan.time, MissionTime::Fixed(_)) {
        // A time that is long enough has a plan without a search for waypoint times.
        let at_once = with_times(model, &by_their_limits(model, mission), scope, progress);
        if is_solved(&at_once) {
            return at_once;
        }
    }
    let timed = with_better_times(model, mission, progress);
    let first = with_times(model, timed.as_ref().unwrap_or(mission), scope, progress);
    if scope != Scope::Plan || timed.is_none() || is_solved(&first) {
        return first;
    }
    // The times chosen may be worse than shares by length at the required mission time.
    better(first, with_times(model, mission, scope, progress))
}

/// With fixed times, three divisions of the time in turn until one has a plan: by the limits of each leg, by the lengths of the legs,
/// and as [`with_better_times`] chooses.
fn about_fixed_times(model: &Model, mission: &Mission, scope: Scope, progress: Progress) -> Comparison {
    let first = with_times(model, &by_their_limits(model, mission), scope, progress);
    if is_solved(&first) {
        return first;
    }
    let second = better(first, with_times(model, mission, scope, progress));
    if is_solved(&second) {
        return second;
    }
    match with_better_times(model, mission, progress) {
        Some(timed) => better(second, with_times(model, &timed, scope, progress)),
        None => second,
    }
}
