//! The last word on a plan: each one found goes through the checker, at the nodes, before it is called a plan.

use super::plan::certificate;
use crate::model::{Mission, MissionTime, Model, Plan, PlannerKind};
use crate::motion::Trajectory;
use crate::planner::studies::rounds::Round;
use crate::planner::studies::{Comparison, NotFound, PlanOutcome, PlannerRun, Run, Verification};
use crate::verify::{self, Refusal, Settings};

/// Decides every plan of a comparison. What fails is not a plan: its run ends without one, and says why.
pub fn check(model: &Model, mission: &Mission, comparison: &mut Comparison) {
    let risk_required = !comparison.trade_off.is_empty();
    for run in &mut comparison.runs {
        let asked = asked_of(model, mission, run, risk_required);
        let selected_by = if run.planner == PlannerKind::Rsp { &comparison.selected_by[..] } else { &[] };
        decide(&asked, &mut run.outcome, selected_by);
    }
}

/// The same of numbers of rounds side by side.
pub fn check_rounds(model: &Model, mission: &Mission, rounds: &mut [Round]) {
    let mut asked = Model { mission: Some(mission.clone()), ..model.clone() };
    asked.plan.planner = PlannerKind::Rsp;
    asked.plan.require_risk = None;
    for round in rounds {
        asked.plan.rounds = round.rounds;
        decide(&asked, &mut round.common, &round.common_selected_by);
        let open = Model { plan: Plan { time: MissionTime::Minimum, ..asked.plan.clone() }, ..asked.clone() };
        decide(&open, &mut round.own, &round.own_selected_by);
    }
}

/// Whether a motion of `time` s passes the check as a plan of the mission, as far as that can be decided.
pub fn is_plan(model: &Model, mission: &Mission, time: f64, motion: &Trajectory, selected_by: &[Trajectory]) -> bool {
    let mut asked = Model { mission: Some(mission.clone()), ..model.clone() };
    asked.plan.time = MissionTime::Fixed(time);
    asked.plan.require_risk = None;
    // Variants of a spec are planned with one round.
    asked.plan.rounds = asked.plan.rounds.min(1);
    let certificate = certificate(motion, selected_by, String::new());
    !matches!(verify::decide_at_nodes(&certificate, &asked, Settings::default()), Err(Refusal::Rejected(_)))
}

/// Decides a plan of a model at the nodes.
fn decide(asked: &Model, outcome: &mut PlanOutcome, selected_by: &[Trajectory]) {
    let PlanOutcome::Planned(solved) = outcome else { return };
    let certificate = certificate(&solved.trajectory, selected_by, String::new());
    match verify::decide_at_nodes(&certificate, asked, Settings::default()) {
        Ok(verdict) if verdict.undecided.is_empty() => solved.verification = Verification::Passed,
        Ok(verdict) => solved.verification = Verification::Undecided(verdict.undecided.join("; ")),
        Err(refusal @ Refusal::Budget { .. }) => solved.verification = Verification::Undecided(refusal.sentence()),
        Err(Refusal::Rejected(rejection)) => {
            *outcome = PlanOutcome::NotFound(NotFound::Check { at: solved.time, why: rejection.sentence() });
        }
    }
}

/// The spec as one run of a comparison plans it.
fn asked_of(model: &Model, mission: &Mission, run: &PlannerRun, risk_required: bool) -> Model {
    let mut asked = Model { mission: Some(mission.clone()), ..model.clone() };
    asked.plan.planner = run.planner;
    let named = |&mode: &usize| model.modes.get(mode).is_some_and(|m| run.against.contains(&m.name));
    asked.plan.against.retain(named);
    // Beside a time that the spec fixes, `mavc compare` looks for each planner's own.
    if run.run == Run::Own {
        asked.plan.time = MissionTime::Minimum;
    }
    if !risk_required {
        asked.plan.require_risk = None;
    }
    asked
}
