//! Writes certificates from results, and runs the check that every trajectory must pass to be called a plan. The
//! records are those of `crate::certificate`; `crate::verify` decides them and accepts every certificate written here.

pub mod between;
mod check;
mod facet;
mod infeasible;
mod witness;

use crate::certificate::{Certificate, Claim, DynamicModel, SCHEMA, TooEarlyClaim};
use crate::model::{MissionTime, Model, PlanModel, Problem};
use crate::motion::time_grid::determined;
use crate::planner::studies::{Comparison, PlanOutcome, Proof, Verification};
use crate::planner::timing::kinematics::{ROUNDING, least_time_inside, least_time_within};
use crate::verify::{self, Settings};

pub use check::{check, is_plan};
pub use witness::{model_of, motion};

/// The certificate of the last run's outcome. It is verified before it is returned.
///
/// # Errors
/// The reason if there is no certificate.
pub fn of(problem: Problem, comparison: &Comparison, spec_sha256: String) -> Result<Certificate, String> {
    let (model, mission) = (problem.model(), problem.mission());
    match comparison.runs.last().map(|run| (run, &run.outcome)) {
        Some((run, PlanOutcome::Planned(solved))) => {
            let mut certificate =
                witness::certificate(problem.model(), &solved.trajectory, &comparison.selected_by, spec_sha256);
            certificate.capture_height_m = height(model);
            if let Claim::Plan(claim) = &mut certificate.claim {
                // A time that the spec fixes needs no bound.
                let is_open = determined(mission).is_none();
                let most_thrust = run.most_thrust(model);
                if is_open {
                    let least = least_time_inside(problem, most_thrust);
                    (claim.least_time_s, claim.weights) = (Some(least.seconds), least.weights);
                }
            }
            // A plan that passed the check of plans is not verified again.
            if solved.verification == Verification::Passed {
                return Ok(certificate);
            }
            match verify::decide_at_nodes(&certificate, model, Settings::default()) {
                Ok(_) => Ok(certificate),
                Err(refusal) => Err(refusal.sentence()),
            }
        }
        Some((_, PlanOutcome::Infeasible(Proof { at, .. }))) if least_time_within(problem).is_above(*at) => {
            too_early(problem, spec_sha256)
        }
        _ => by_multipliers(problem, comparison, spec_sha256),
    }
}

/// The simulated height that the limits of a mission keep, m.
fn height(model: &Model) -> Option<f64> {
    model.plan.require_capture.and_then(|required| required.height)
}

/// The certificate that the last run has no plan on the spec's grid of nodes: multipliers of its rows.
///
/// # Errors
/// The reason if there is no certificate.
pub fn by_multipliers(problem: Problem, comparison: &Comparison, spec_sha256: String) -> Result<Certificate, String> {
    match comparison.runs.last().map(|run| (run, &run.outcome)) {
        Some((run, PlanOutcome::Infeasible(Proof { at, .. }))) if has_one_time(problem) => {
            infeasible::certificate(problem, run, *at, &comparison.selected_by, spec_sha256)
        }
        Some((_, PlanOutcome::Infeasible(Proof { .. }))) => {
            Err("a certificate cannot show that there is no plan at several times".into())
        }
        _ => Err("no plan was found, and none was proved infeasible".into()),
    }
}

/// Whether the spec allows only one mission time, so that infeasibility at that time is infeasibility of the spec.
fn has_one_time(problem: Problem) -> bool {
    let (model, mission) = (problem.model(), problem.mission());
    matches!(model.plan.time, MissionTime::Fixed(_)) || mission.waypoints.last().is_some_and(|w| w.time.is_some())
}

/// The certificate that a waypoint is due before any motion within limits and thrust can be there.
fn too_early(problem: Problem, spec_sha256: String) -> Result<Certificate, String> {
    let (model, mission) = (problem.model(), problem.mission());
    let least = least_time_within(problem);
    let hold = mission.waypoints.last().map_or(0.0, |w| w.hold);
    let (waypoint, soonest) = least.too_early.unwrap_or((mission.waypoints.len() - 1, least.seconds - hold));
    let claim = TooEarlyClaim { waypoint: waypoint + 1, soonest_s: (1.0 - ROUNDING) * soonest, weights: least.weights };
    let claim = Claim::TooEarly(claim);
    let kind = match model.plan.model {
        PlanModel::Hover => DynamicModel::Hover,
        PlanModel::Exact => DynamicModel::Exact,
    };
    let certificate = Certificate { schema: SCHEMA, spec_sha256, model: kind, capture_height_m: height(model), claim };
    // A certificate that does not show its claim is not written.
    match verify::decide(&certificate, model, Settings::default()) {
        Ok(_) => Ok(certificate),
        Err(refusal) => Err(refusal.sentence()),
    }
}
