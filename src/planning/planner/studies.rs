//! Where a mission is planned: steps (a) to (f) of section 5.3 of the paper. They decide which planners are run at
//! which time, and how far each plan leaves each mode's set. [`run_planners`] is the beginning.

mod candidates;
mod committed;
mod common;
mod every_planner;
mod found;
mod order;
mod outcome;
pub mod protect;
mod rounds;
mod setting;
mod single_modes;
mod single_planner;
mod times;

pub use candidates::hardly_shorter;
pub use outcome::{
    Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run, Scope, THESE_TIMES, THIS_YAW, Verification,
    label, proofs_are_about,
};

use crate::model::Problem;
use crate::planner::finds_local_optima;
use crate::planner::timing::kinematics::least_time_within;
use crate::planner::trial::Trial;
use setting::Setting;
use std::sync::PoisonError;

/// Receives the planner's name, with how much of a comparison is done, and each trial before it begins.
pub type Progress<'a> = Option<&'a (dyn Fn(&str, Trial) + Sync)>;

/// Why RSP is not attempted.
pub const NOTHING_TO_SELECT_BY: &str = "RSP selects facets from a RIP plan, and no RIP plan was found";

/// Runs the planners of a scope. Hover must be admissible in every mode of `against`; see `crate::admissible::verdict`.
///
/// `progress` receives the planner's name and each trial before it begins.
pub fn run_planners(problem: Problem, scope: Scope, progress: Progress) -> Comparison {
    let ended = times::with_time_of_its_end(problem);
    let problem = ended.as_ref().and_then(Problem::of).unwrap_or(problem);
    let model = problem.model();
    // The SCP planner chooses waypoint times itself.
    let mut comparison = match model.plan.chooses_times && !finds_local_optima(model) {
        true => times::with_times_before(problem, scope, progress),
        false => with_times(problem, scope, progress),
    };
    if let Some(about) = proofs_are_about(problem) {
        let setting = Setting::new(problem, None);
        let least = least_time_within(problem);
        let has_no_yaw = |at: f64| about == THIS_YAW && setting.is_hopeless(at);
        let is_hopeless = |at: f64| least.is_above(at) || has_no_yaw(at);
        comparison.runs.iter_mut().for_each(|run| run.outcome.weaken(about, is_hopeless));
    }
    comparison
}

/// A run of a comparison, which is its only one here, once more on a mission that differs from the comparison's in its
/// limits only: the same planner in the same set, from the run's plan, without a second pass ([`pass_again`]). Without
/// a plan there is no run.
pub fn again(problem: Problem, comparison: &Comparison, run: &PlannerRun) -> Comparison {
    let ended = times::with_time_of_its_end(problem);
    let problem = ended.as_ref().and_then(Problem::of).unwrap_or(problem);
    let setting = Setting { weighs_risk: true, ..Setting::new(problem, None) };
    let (run, effort) = setting.again(run).unzip();
    Comparison { runs: run.into_iter().collect(), effort: effort.unwrap_or_default(), ..comparison.clone() }
}

/// Puts the plan of a second pass in place of each run's plan, where there is one that is as quick.
pub fn pass_again(problem: Problem, comparison: &mut Comparison) {
    let setting = Setting { weighs_risk: true, ..Setting::new(problem, None) };
    let effort = setting.pass_again(comparison);
    comparison.effort += effort;
}

/// A comparison with another plan of the mission as the outcome of its last run, with what is reported of it; `None`
/// without a run. Whether it is a plan of that run is for [`crate::certify::check`] to say.
pub fn adopted(problem: Problem, comparison: &Comparison, plan: &MissionPlan) -> Option<Comparison> {
    let mut comparison = comparison.clone();
    let setting = Setting { weighs_risk: true, ..Setting::new(problem, None) };
    let adopted = setting.described(plan.time, plan.trajectory.clone(), plan.objective, plan.rows);
    comparison.runs.last_mut()?.outcome = PlanOutcome::Planned(Box::new(adopted));
    comparison.for_ways_out = true;
    Some(comparison)
}

/// The comparison with the mission's shares of time for the legs.
fn with_times(problem: Problem, scope: Scope, progress: Progress) -> Comparison {
    let model = problem.model();
    let mut setting = Setting { weighs_risk: scope != Scope::Common, ..Setting::new(problem, progress) };
    if scope == Scope::Everything {
        setting.all = setting.runs_of_everything();
    }
    let mut comparison = match scope {
        Scope::Plan => match model.plan.require_risk {
            Some(bound) => setting.protect(bound),
            None => setting.plan(),
        },
        Scope::Common => setting.at_common_time(),
        Scope::Everything => setting.everything(),
    };
    if model.plan.require_risk.is_none() {
        let effort = setting.pass_again(&mut comparison);
        comparison.effort += effort;
    }
    comparison.effort += setting.stopping.into_inner().unwrap_or_else(PoisonError::into_inner);
    comparison
}
