//! Waypoint times before any planner runs: those of the hover model, whose own search keeps the legs' shares, and a last one that
//! is the mission's time.

use super::{Comparison, Progress, Scope, with_times};
use crate::model::{Leg, Mission, MissionTime, Model, PlanModel, PlannerKind};
use crate::motion::time_grid::{determined, has_fixed_times};
use crate::motion::wrench_model::WrenchModel;
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::ScpPlanner;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::timing::kinematics::initial;

/// In the hover model waypoint times are chosen first, by steps, for the set that the planner is bounded by; the legs then
/// keep these shares of any mission time. `None` where the steps find no plan.
fn with_better_times(model: &Model, mission: &Mission, progress: Progress) -> Option<Mission> {
    let sets = PlanningSets::of(model);
    let is_rip =
        model.plan.planner == PlannerKind::Rip || model.plan.planner == PlannerKind::Rsp && model.plan.rounds == 0;
    let set = if is_rip { &sets.rip } else { &sets.joint };
    let tell = |t: f64| {
        if let Some(progress) = progress {
            progress("waypoint times", t);
        }
    };
    let mut engine = HoverPlanner::new(model, mission, &sets.healthy);
    engine.on_progress = Some(&tell);
    let wrench = match mission.has_one_yaw() {
        true => WrenchModel::HoverAt(mission.waypoints[0].yaw),
        false => WrenchModel::HoverFollowing,
    };
    let found = ScpPlanner::new(&mut engine, wrench, set).shortest(&[], None).ok()?;
    let legs = found.planned.grid.segments.iter().filter(|s| !s.hold);
    Some(Mission { legs: legs.map(|s| Leg { share: s.duration }).collect(), ..mission.clone() })
}

/// The same mission with legs that take shares of the time as their own distances, turns and limits ask for.
fn by_their_limits(model: &Model, mission: &Mission) -> Mission {
    let legs = initial(model, mission).into_iter().map(|share| Leg { share }).collect();
    Mission { legs, ..mission.clone() }
}

/// Where the last waypoint alone has a time of its own, the same mission with that as the plan's time. The exact model's steps
/// can then begin from slower motions, as they do for missions written so.
pub(super) fn with_time_of_its_end(model: &Model, mission: &Mission) -> Option<(Model, Mission)> {
    let (last, others) = mission.waypoints.split_last()?;
    let alone = last.time.is_some() && others.iter().skip(1).all(|w| w.time.is_none());
    let time = determined(mission).filter(|_| alone && model.plan.model == PlanModel::Exact)?;
    let (mut model, mut mission) = (model.clone(), mission.clone());
    model.plan.time = MissionTime::Fixed(time);
    mission.waypoints.last_mut()?.time = None;
    Some((model, mission))
}

fn is_solved(comparison: &Comparison) -> bool {
    comparison.runs.last().is_some_and(|run| run.outcome.plan().is_some())
}

/// The second where it has a plan, with what both took.
fn better(first: Comparison, second: Comparison) -> Comparison {
    let mut effort = first.effort;
    effort += second.effort;
    Comparison { effort, ..if is_solved(&second) { second } else { first } }
}

/// In the hover model, whose own search keeps the legs' shares, waypoint times are chosen before any planner runs.
pub(super) fn with_times_before(model: &Model, mission: &Mission, scope: Scope, progress: Progress) -> Comparison {
    if has_fixed_times(mission) {
        return about_fixed_times(model, mission, scope, progress);
    }
    if scope == Scope::Plan && matches!(model.plan.time, MissionTime::Fixed(_)) {
        // A time that is long enough has a plan without a search for the times of waypoints.
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
    // The times that the steps chose may be worse than those of the legs' lengths at the time asked for.
    better(first, with_times(model, mission, scope, progress))
}

/// Between fixed times legs take time as their own limits ask for it; where no plan is found so, by their lengths, and then as the
/// steps choose.
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
