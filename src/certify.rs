//! Certificates from results, and the check that every plan goes through before it is called one. Records are
//! `crate::certificate`'s, and `crate::verify` decides them; what is written here it accepts.

pub mod between;
mod check;
mod facet;
mod infeasible;
mod plan;

use crate::certificate::{Certificate, Claim, DynamicModel, SCHEMA, TooEarlyClaim};
use crate::model::{Mission, MissionTime, Model, PlanModel};
use crate::motion::time_grid::determined;
use crate::planner::studies::{Comparison, PlanOutcome, Proof, Verification};
use crate::planner::timing::kinematics::{ROUNDING, least_time_within};
use crate::verify::{self, Settings};

pub use check::{check, check_rounds, is_plan};

/// The certificate of the last run's outcome. It is decided before it is given: what is written is accepted.
///
/// # Errors
/// Why there is none.
pub fn of(
    model: &Model,
    mission: &Mission,
    comparison: &Comparison,
    spec_sha256: String,
) -> Result<Certificate, String> {
    match comparison.runs.last().map(|run| (run, &run.outcome)) {
        Some((_, PlanOutcome::Planned(solved))) => {
            let mut certificate = plan::certificate(&solved.trajectory, &comparison.selected_by, spec_sha256);
            if let Claim::Plan(claim) = &mut certificate.claim {
                // A time that the spec lays down needs no bound.
                let is_open = determined(mission).is_none();
                claim.least_time_s = is_open.then(|| least_time_within(model, mission).seconds);
            }
            // What the check of plans has passed is not decided again.
            if solved.verification == Verification::Passed {
                return Ok(certificate);
            }
            match verify::decide_at_nodes(&certificate, model, Settings::default()) {
                Ok(_) => Ok(certificate),
                Err(refusal) => Err(refusal.sentence()),
            }
        }
        Some((_, PlanOutcome::Infeasible(Proof { at, .. }))) if least_time_within(model, mission).is_above(*at) => {
            too_early(model, mission, spec_sha256)
        }
        _ => by_multipliers(model, mission, comparison, spec_sha256),
    }
}

/// The certificate that the last run has no plan on the spec's grid of nodes: multipliers of its rows.
///
/// # Errors
/// Why there is none.
pub fn by_multipliers(
    model: &Model,
    mission: &Mission,
    comparison: &Comparison,
    spec_sha256: String,
) -> Result<Certificate, String> {
    match comparison.runs.last().map(|run| (run, &run.outcome)) {
        Some((run, PlanOutcome::Infeasible(Proof { at, .. }))) if has_one_time(model, mission) => {
            infeasible::certificate(model, mission, run, *at, (&comparison.selected_by, spec_sha256))
        }
        Some((_, PlanOutcome::Infeasible(Proof { .. }))) => {
            Err("no plan at many times is more than a certificate says".into())
        }
        _ => Err("no plan was found, and none was proved infeasible".into()),
    }
}

/// Whether the spec leaves one mission time only, so that having no plan then is having none.
fn has_one_time(model: &Model, mission: &Mission) -> bool {
    matches!(model.plan.time, MissionTime::Fixed(_)) || mission.waypoints.last().is_some_and(|w| w.time.is_some())
}

/// The certificate that a waypoint is due before any motion within the limits can be there.
fn too_early(model: &Model, mission: &Mission, spec_sha256: String) -> Result<Certificate, String> {
    let least = least_time_within(model, mission);
    let hold = mission.waypoints.last().map_or(0.0, |w| w.hold);
    let (waypoint, soonest) = least.too_early.unwrap_or((mission.waypoints.len() - 1, least.seconds - hold));
    let claim = Claim::TooEarly(TooEarlyClaim { waypoint: waypoint + 1, soonest_s: (1.0 - ROUNDING) * soonest });
    let kind = match model.plan.model {
        PlanModel::Hover => DynamicModel::Hover,
        PlanModel::Exact => DynamicModel::Exact,
    };
    let certificate = Certificate { schema: SCHEMA, spec_sha256, model: kind, claim };
    // What does not show it is not written.
    match verify::decide(&certificate, model, Settings::default()) {
        Ok(_) => Ok(certificate),
        Err(refusal) => Err(refusal.sentence()),
    }
}
