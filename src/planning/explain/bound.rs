//! A mission time below the lower bound on it: the bound alone names the statements, without a search for plans.

use super::oracle::{Answer, Oracle};
use super::question::Questions;
use super::{Conflict, Explanation, filter, statement};
use crate::model::{MissionTime, PlanModel, Problem};
use crate::planner::timing::kinematics::least_time_within;

/// Most statements times limits times legs that all queries together look at. Chosen by hand: about a second.
const MOST_LOOKS: usize = 1_000_000_000;

/// The lower bound on a mission's time as an oracle: it can only prove infeasibility.
struct Bound;

impl Oracle for Bound {
    fn ask(&mut self, problem: Problem, time: f64) -> Answer {
        match least_time_within(problem).is_above(time) {
            true => Answer::Infeasible { weights: Vec::new(), only_for_selection: false, only_for_samples: false },
            false => Answer::NotFound(Vec::new()),
        }
    }
}

/// The conflict of a spec in the exact model whose mission time lies below the bound; `None` for all others. (In the
/// hover model programs are convex, and a changed time is found at once.)
pub(super) fn too_short(problem: Problem) -> Option<Explanation> {
    let (model, mission) = (problem.model(), problem.mission());
    let MissionTime::Fixed(time) = model.plan.time else { return None };
    let least = least_time_within(problem);
    let is_bounded = model.plan.model == PlanModel::Exact && model.plan.chooses_times && least.too_early.is_none();
    if !is_bounded || !least.is_above(time) {
        return None;
    }
    let looks = mission.legs.len() * (1 + mission.limits.len());
    let mut bound = Bound;
    let mut questions = Questions::new(problem, &mut bound, (MOST_LOOKS / looks.max(1)).clamp(10, 1000));
    let statements = statement::statements(problem);
    let conflict = filter::filter(&mut questions, &statements)?;
    let left_out = statements.into_iter().filter(|statement| !conflict.statements.contains(statement)).collect();
    let mut kept = questions.variant(&left_out);
    kept.plan.time = MissionTime::Fixed(time);
    let least_time = Some(least_time_within(Problem::of(&kept)?).seconds);
    Some(Explanation { conflict: Conflict { least_time, ..conflict }, fixes: Vec::new(), questions: questions.asked() })
}
