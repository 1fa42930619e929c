//! The lower bound beside every time: which no motion within the spec's limits stays below.

use super::number::{down, percent};
use crate::model::{Mission, Model};
use crate::planner::compare::{Ending, PlannerRun};
use crate::planner::kinematics::{LeastTime, least_time, least_time_within};
use crate::trajectory::checks::limit_excesses;

/// Of the bound itself, which is rounded down.
const DIGITS: usize = 4;

/// The bound to set beside a run: of motions that keep the limits at every instant. Where its plan exceeds some between the
/// nodes the bound lets all motions exceed them as far.
pub fn beside(model: &Model, mission: &Mission, run: &PlannerRun) -> LeastTime {
    let mut past = vec![0.0; mission.limits.len()];
    if let Ending::Solved(solved) = &run.ending {
        for excess in limit_excesses(&solved.trajectory, model, 0.0) {
            past[excess.limit] = excess.by;
        }
    }
    least_time(model, mission, &past)
}

/// What no motion stays below.
pub fn sentence(mission: &Mission, least: &LeastTime) -> String {
    match least.too_early {
        Some((waypoint, soonest)) if waypoint + 1 < mission.waypoints.len() => {
            format!("no motion within the limits reaches waypoint {} before {} s", waypoint + 1, down(soonest, DIGITS))
        }
        _ => format!("no motion within the limits takes less than {} s", down(least.seconds, DIGITS)),
    }
}

/// The bound and the gap to it, after a shortest time found; `None` where the bound says nothing.
pub fn gap(model: &Model, mission: &Mission, run: &PlannerRun) -> Option<String> {
    let solved = run.ending.solved()?;
    let least = beside(model, mission, run);
    if least.seconds <= 0.0 || least.is_above(solved.time) {
        return None;
    }
    let widened = match least.seconds < (1.0 - 1e-6) * least_time_within(model, mission).seconds {
        true => ", exceeded no further than by this plan between its nodes,",
        false => "",
    };
    let (seconds, gap) = (down(least.seconds, DIGITS), percent(solved.time / least.seconds - 1.0));
    Some(format!("no motion within the limits{widened} takes less than {seconds} s (gap {gap})"))
}
