//! Lower bounds on mission times: no trajectory within the spec's limits and sets is faster.

use super::caveats::exceeded_limits;
use crate::model::{Mission, Problem};
use crate::number::{down, down_but_above, tenths};
use crate::planner::studies::{PlanOutcome, PlannerRun};
use crate::planner::timing::kinematics::{LeastTime, least_time, least_time_inside};

/// Significant digits of the bound, which is rounded down.
const DIGITS: usize = 4;

/// The lower bound for a run, over all motions that satisfy the limits at every instant. If the run's plan exceeds
/// limits between its nodes, the bound allows all motions to exceed them as far.
pub fn bound_for(problem: Problem, run: &PlannerRun) -> LeastTime {
    let (model, mission) = (problem.model(), problem.mission());
    let mut past = vec![0.0; mission.limits.len()];
    if let PlanOutcome::Planned(solved) = &run.outcome {
        for exceeded in exceeded_limits(model, solved) {
            past[exceeded.limit] = exceeded.by;
        }
    }
    least_time(problem, &past, run.most_thrust(model))
}

/// The bound in words, for a mission of `total` s that has no plan because of it.
pub fn sentence(mission: &Mission, least: &LeastTime, total: f64) -> String {
    match least.too_early {
        Some((waypoint, soonest)) if waypoint + 1 < mission.waypoints.len() => {
            let due = mission.waypoints[waypoint].time.unwrap_or(0.0);
            let seconds = down_but_above(soonest, DIGITS, due);
            format!("no motion within limits and thrust reaches waypoint {} before {seconds} s", waypoint + 1)
        }
        _ => {
            let seconds = down_but_above(least.seconds, DIGITS, total);
            format!("no motion {} takes less than {seconds} s", mission.bounded_within(false))
        }
    }
}

/// The bound as [`gap`] writes it, s.
pub fn shown(seconds: f64) -> f64 {
    down(seconds, DIGITS).parse().unwrap_or(seconds)
}

/// The bound in words and the gap between it and the shortest time found; `None` if the bound is trivial.
pub fn gap(problem: Problem, run: &PlannerRun) -> Option<String> {
    let mission = problem.mission();
    let solved = run.outcome.plan()?;
    let least = bound_for(problem, run);
    if least.seconds <= 0.0 || least.is_above(solved.time) {
        return None;
    }
    let unwidened = least_time_inside(problem, run.most_thrust(problem.model()));
    let widened = match least.seconds < (1.0 - 1e-6) * unwidened.seconds {
        true => ", exceeded no further than by this plan between its nodes,",
        false => "",
    };
    let (seconds, gap) = (down(least.seconds, DIGITS), tenths(solved.time / least.seconds - 1.0));
    let within = mission.bounded_within(!run.against.is_empty());
    Some(format!("no motion {within}{widened} takes less than {seconds} s (gap {gap})"))
}
