//! Certificates from results, and the check that every plan goes through before it is called one. Records are
//! `crate::certificate`'s, and `crate::verify` decides them; what is written here it accepts.

pub mod between;
mod check;
mod facet;
mod infeasible;
mod plan;

use crate::certificate::Certificate;
use crate::model::{Mission, MissionTime, Model};
use crate::planner::compare::{Comparison, Ending, Verification};
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
    match comparison.runs.last().map(|run| (run, &run.ending)) {
        Some((_, Ending::Solved(solved))) => {
            let certificate = plan::certificate(&solved.trajectory, &comparison.selected_by, spec_sha256);
            // What the check of plans has passed is not decided again.
            if solved.verification == Verification::Passed {
                return Ok(certificate);
            }
            match verify::decide_at_nodes(&certificate, model, Settings::default()) {
                Ok(_) => Ok(certificate),
                Err(refusal) => Err(refusal.sentence()),
            }
        }
        Some((run, Ending::Infeasible { at, .. })) if has_one_time(model, mission) => {
            infeasible::certificate(model, mission, run, *at, (&comparison.selected_by, spec_sha256))
        }
        Some((_, Ending::Infeasible { .. })) => Err("no plan at many times is more than a certificate says".into()),
        _ => Err("no plan was found, and none was proved infeasible".into()),
    }
}

/// Whether the spec leaves one mission time only, so that having no plan then is having none.
fn has_one_time(model: &Model, mission: &Mission) -> bool {
    matches!(model.plan.time, MissionTime::Fixed(_)) || mission.waypoints.last().is_some_and(|w| w.time.is_some())
}
