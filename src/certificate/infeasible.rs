//! A certificate that there is no plan: multipliers from the program that asks how far waypoints would have to be
//! overshot. Those of the dynamics are left out; the checker works them out itself.

use super::{
    Certificate, Claim, DynamicModel, FacetRecord, InfeasibleClaim, Multiplier, RowRecord, SCHEMA, Side, plan::facet_of,
};
use crate::admissible::AdmissibleSet;
use crate::model::{Mission, Model};
use crate::planner::compare::PlannerRun;
use crate::planner::rows::Engine;
use crate::planner::transcribe::{Purpose, Transcription};
use crate::planner::yaw::YawPlan;
use crate::qp::{Cone, QuadraticProgram, RowOrigin};
use crate::solve::{Outcome, solve};
use crate::verify;

/// Weight of the inputs' cost beside the overshoot: enough to make the solution unique, too little to matter.
const COST: f64 = 1e-12;

/// Multipliers below this share of the largest are left out, if the others show it still.
const NEGLIGIBLE: [f64; 4] = [1e-6, 1e-8, 1e-10, 0.0];

/// The certificate that `run` has no plan at `total` seconds.
///
/// # Errors Where yaw changes, some facet has no three rotors, or the multipliers found do not show it; they cannot
/// where the start is not at rest.
pub fn certificate(
    model: &Model,
    mission: &Mission,
    run: &PlannerRun,
    total: f64,
    sha256: String,
) -> Result<Certificate, String> {
    let healthy = AdmissibleSet::healthy(model);
    let mut engine = Engine::new(model, mission, &healthy);
    let layout = match engine.layout(total, model.plan.samples) {
        Ok(Some(layout)) => layout,
        Ok(None) => return Err("fixed times and holds leave some leg no time".into()),
        Err(_) => return Err("yaw alone has no plan".into()),
    };
    let YawPlan::Free { .. } = layout.yaw else { return Err("yaw changes, and was planned first".into()) };
    let maps = layout.yaw.maps(model, layout.flown.nodes());
    let form = Transcription::new(model, mission, &layout.flown, &run.set, &maps, layout.yaw.axes());
    let program = form.full_program(Purpose::Overshoot { epsilon: COST });
    let z = match solve(&program).0 {
        Outcome::Solved(solution) => solution.z,
        Outcome::Infeasible { certificate } => certificate,
        Outcome::Inconclusive { .. } => return Err("no multipliers were found".into()),
    };
    let facets = run.set.rows.iter().map(|row| facet_of(model, row)).collect::<Option<Vec<FacetRecord>>>();
    let facets = facets.ok_or("a flat set has facets that no three rotors span")?;
    let every = multipliers(&program, &z, form.tau(), mission).ok_or("a row of the program has no name")?;
    let size = |m: &Multiplier| m.z.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let largest = every.iter().map(size).fold(0.0, f64::max);
    let of = |share: f64| InfeasibleClaim {
        times_s: layout.flown.node_times.clone(),
        waypoint_nodes: layout.flown.waypoint_nodes.clone(),
        facets: facets.clone(),
        multipliers: every.iter().filter(|m| size(m) > share * largest).cloned().collect(),
    };
    let written = NEGLIGIBLE.iter().map(|&share| Certificate {
        schema: SCHEMA,
        spec_sha256: sha256.clone(),
        model: DynamicModel::Hover,
        claim: Claim::Infeasible(of(share)),
    });
    // What does not show it is not written.
    let mut shown = written.into_iter().filter(|certificate| verify::decide(certificate, model).is_ok());
    shown.next().ok_or_else(|| "the multipliers found do not show it".into())
}

/// The multipliers of all rows but the dynamics'. Rows of one origin follow each other in the program: the sides of a
/// limit, the parts of a cone.
fn multipliers(program: &QuadraticProgram, z: &[f64], tau: f64, mission: &Mission) -> Option<Vec<Multiplier>> {
    let mut found: Vec<Multiplier> = Vec::new();
    let mut at = 0;
    let mut seen: std::collections::BTreeMap<(usize, usize), usize> = Default::default();
    for cone in &program.cones {
        // Rows of the zero and the nonnegative cone stand alone, a second-order cone's belong together.
        let size = if let Cone::SecondOrder(n) = cone { *n } else { 1 };
        for first in (at..at + cone.rows()).step_by(size) {
            let mut values = z[first..first + size].to_vec();
            let row = match program.row_origin[first] {
                RowOrigin::Dynamics { .. } | RowOrigin::Overshoot | RowOrigin::Excess => continue,
                // Rows of the exact model's programs, which are not written down here.
                RowOrigin::Upright { .. }
                | RowOrigin::Thrust { .. }
                | RowOrigin::Duration { .. }
                | RowOrigin::Lag { .. } => {
                    return None;
                }
                RowOrigin::Rest { node, axis, derivative } => {
                    values[0] *= tau.powi(derivative as i32);
                    RowRecord::Rest { node, axis, derivative }
                }
                RowOrigin::Facet { facet, node } => RowRecord::Facet { facet, node },
                RowOrigin::Waypoint { waypoint } => RowRecord::Waypoint { waypoint },
                RowOrigin::WaypointYaw { waypoint } => {
                    let count = seen.entry((usize::MAX, waypoint)).or_default();
                    *count += 1;
                    // The transcription writes `tolerance + (psi - due)` first: what bounds psi from below.
                    let side = if *count == 1 { Side::Lower } else { Side::Upper };
                    RowRecord::WaypointYaw { waypoint, side }
                }
                RowOrigin::Limit { limit, node } => {
                    let count = seen.entry((limit, node)).or_default();
                    *count += 1;
                    let sides = [
                        mission.limits[limit].upper.map(|_| Side::Upper),
                        mission.limits[limit].lower.map(|_| Side::Lower),
                    ];
                    // A jerk limit has a cone for each interval beside its node, from the left.
                    let interval = node.saturating_sub(1) + *count - 1;
                    match sides.into_iter().flatten().nth(*count - 1) {
                        Some(side) if size == 1 => RowRecord::Limit { limit, node, side },
                        _ if size > 1 => RowRecord::LimitNorm { limit, node, interval },
                        _ => return None,
                    }
                }
            };
            // Dust of an interior point: no multiplier of an inequality is negative.
            if !matches!(cone, Cone::Zero(_)) {
                let rest = values[1..].iter().map(|v| v * v).sum::<f64>().sqrt() * (1.0 + 1e-14);
                values[0] = values[0].max(rest);
            }
            found.push(Multiplier { row, z: values });
        }
        at += cone.rows();
    }
    Some(found)
}
