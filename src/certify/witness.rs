//! Certificates of plans: the trajectory as a record.

use crate::certificate::{Certificate, Claim, DynamicModel, MotionRecord, PlanClaim, SCHEMA, Vertical};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};

/// The certificate of a plan; `selected_by` are the plans from which RSP selected facets, in order.
pub(super) fn certificate(trajectory: &Trajectory, selected_by: &[Trajectory], sha256: String) -> Certificate {
    let selected_by = selected_by.iter().map(motion).collect();
    let claim = PlanClaim { motion: motion(trajectory), selected_by, least_time_s: None };
    Certificate { schema: SCHEMA, spec_sha256: sha256, model: model_of(trajectory), claim: Claim::Plan(claim) }
}

/// The model of the wrench that the plan uses.
pub(super) fn model_of(trajectory: &Trajectory) -> DynamicModel {
    match trajectory.model {
        WrenchModel::HoverAt(_) | WrenchModel::HoverFollowing => DynamicModel::Hover,
        WrenchModel::Exact => DynamicModel::Exact,
    }
}

/// A trajectory as a record.
pub(super) fn motion(trajectory: &Trajectory) -> MotionRecord {
    let nodes = &trajectory.nodes;
    let vertical = |s: &NodeState| match model_of(trajectory) {
        DynamicModel::Hover => Vertical::Hover([s[Z][0], s[Z][1], s[Z][2]]),
        DynamicModel::Exact => Vertical::Exact(s[Z]),
    };
    MotionRecord {
        times_s: trajectory.times.clone(),
        x: nodes.iter().map(|s| s[X]).collect(),
        y: nodes.iter().map(|s| s[Y]).collect(),
        z: nodes.iter().map(vertical).collect(),
        yaw: nodes.iter().map(|s| [s[YAW][0], s[YAW][1], s[YAW][2]]).collect(),
        waypoint_nodes: trajectory.waypoint_nodes.clone(),
    }
}
