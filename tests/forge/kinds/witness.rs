//! Claims that there is no plan, in parts.

use crate::motion::AXES;
use crate::numbers::Numbers;
use crate::specs::{Harder, Spec};
use mavc::certificate::{Certificate, Claim, DynamicModel, InfeasibleClaim, Multiplier, RowRecord, SCHEMA};
use mavc::model::PlanModel;

/// Nodes of the spec's grid, which has no holds.
pub fn grid_nodes(spec: &Spec) -> usize {
    spec.honest.nodes.len() - spec.truth.mission().waypoints.iter().filter(|w| w.hold > 0.0).count()
}

/// A claim about the spec.
pub fn claiming(spec: &Spec, claim: InfeasibleClaim) -> Certificate {
    let model = match spec.model().plan.model {
        PlanModel::Exact => DynamicModel::Exact,
        PlanModel::Hover => DynamicModel::Hover,
    };
    Certificate {
        schema: SCHEMA,
        spec_sha256: crate::SHA.into(),
        model,
        capture_height_m: None,
        claim: Claim::Infeasible(claim),
    }
}

/// A claim without anything to show it.
pub fn empty() -> InfeasibleClaim {
    InfeasibleClaim { selected_by: vec![], facets: vec![], thrust: vec![], multipliers: vec![] }
}

/// Multipliers alone.
pub fn of_rows(spec: &Spec, multipliers: Vec<Multiplier>) -> Certificate {
    claiming(spec, InfeasibleClaim { multipliers, ..empty() })
}

/// What shows that a harder spec has no plan.
pub fn of_harder(spec: &Spec, how: Harder) -> Option<InfeasibleClaim> {
    let (_, certificate) = spec.harder.iter().find(|h| h.0 == how)?;
    match &certificate.claim {
        Claim::Infeasible(claim) => Some(claim.clone()),
        _ => None,
    }
}

/// That of any harder one.
pub fn of_some(spec: &Spec, numbers: &mut Numbers) -> Option<InfeasibleClaim> {
    let (how, _) = numbers.pick(&spec.harder)?;
    of_harder(spec, *how)
}

pub fn row(row: RowRecord, z: &[f64]) -> Multiplier {
    Multiplier { row, z: z.to_vec() }
}

/// An axis along which the mission's end is not its start.
pub fn axis_of_flight(spec: &Spec, numbers: &mut Numbers) -> Option<usize> {
    let points = &spec.truth.mission().waypoints;
    let (first, last) = (points.first()?, points.last()?);
    let moved: Vec<usize> =
        AXES[..3].iter().copied().filter(|&i| (first.position[i] - last.position[i]).abs() > 0.2).collect();
    numbers.pick(&moved).copied()
}
