//! The check of plans: every trajectory found is verified at the nodes before it is called a plan.

use super::witness::certificate;
use crate::model::{MissionTime, Model, Problem};
use crate::motion::Trajectory;
use crate::planner::studies::{Comparison, NotFound, PlanOutcome, PlannerRun, Run, Verification};
use crate::verify::{self, Refusal, Settings};

/// Checks every plan of a comparison. A trajectory that fails is not a plan: the outcome of its run becomes
/// [`NotFound::Check`] with the reason. If that is the plan of a second pass, the plan before it takes its place.
pub fn check(problem: Problem, comparison: &mut Comparison) {
    let risk_required = !comparison.trade_off.is_empty();
    let mut runs = std::mem::take(&mut comparison.runs);
    for run in &mut runs {
        let selected_by = comparison.selected_by(run.planner, run.run);
        let planned = as_planned(problem, run, risk_required);
        decide(&planned, &mut run.outcome, selected_by);
        let plainer = run.plainer.take();
        if let (None, Some(plainer)) = (run.outcome.plan(), plainer) {
            run.outcome = PlanOutcome::Planned(plainer);
            decide(&planned, &mut run.outcome, selected_by);
        }
    }
    comparison.runs = runs;
}

/// Whether a trajectory of `time` s passes the check as a plan of the mission. An undecided check counts as passed.
pub fn is_plan(problem: Problem, time: f64, motion: &Trajectory, selected_by: &[Trajectory]) -> bool {
    let mut planned = problem.model().clone();
    planned.plan.time = MissionTime::Fixed(time);
    planned.plan.require_risk = None;
    // Variants of a spec are planned with one round.
    planned.plan.rounds = planned.plan.rounds.min(1);
    let certificate = certificate(&planned, motion, selected_by, String::new());
    !matches!(verify::decide_at_nodes(&certificate, &planned, Settings::default()), Err(Refusal::Rejected(_)))
}

/// Checks a plan of a model at the nodes.
fn decide(planned: &Model, outcome: &mut PlanOutcome, selected_by: &[Trajectory]) {
    let PlanOutcome::Planned(solved) = outcome else { return };
    let certificate = certificate(planned, &solved.trajectory, selected_by, String::new());
    match verify::decide_at_nodes(&certificate, planned, Settings::default()) {
        Ok(verdict) if verdict.undecided.is_empty() => solved.verification = Verification::Passed,
        Ok(verdict) => solved.verification = Verification::Undecided(verdict.undecided.join("; ")),
        Err(refusal @ Refusal::Budget { .. }) => solved.verification = Verification::Undecided(refusal.sentence()),
        Err(Refusal::Rejected(rejection)) => {
            *outcome = PlanOutcome::NotFound(NotFound::Check { at: solved.time, why: rejection.sentence() });
        }
    }
}

/// The spec as one run of a comparison planned it.
fn as_planned(problem: Problem, run: &PlannerRun, risk_required: bool) -> Model {
    let model = problem.model();
    let mut planned = model.clone();
    planned.plan.planner = run.planner;
    let named = |&mode: &usize| model.modes.get(mode).is_some_and(|m| run.against.contains(&m.name));
    planned.plan.against.retain(named);
    // `mavc compare` searches for each planner's own time even if the spec fixes a time.
    if run.run == Run::Own {
        planned.plan.time = MissionTime::Minimum;
    }
    if !risk_required {
        planned.plan.require_risk = None;
    }
    planned
}
