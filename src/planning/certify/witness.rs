//! Certificates of plans: the trajectory as a record.

use crate::admissible::AdmissibleSet;
use crate::admissible::without_yaw::planned::{Obstacle, Provision};
use crate::certificate::{Certificate, Claim, DynamicModel, MotionRecord, PlanClaim, SCHEMA, SpinRecord, Vertical};
use crate::model::{Model, PlannerKind};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};

/// The certificate of a plan of a model; `selected_by` are the plans from which RSP selected facets, in order.
pub(super) fn certificate(
    model: &Model,
    trajectory: &Trajectory,
    selected_by: &[Trajectory],
    sha256: String,
) -> Certificate {
    let selected_by = selected_by.iter().map(motion).collect();
    let claim = PlanClaim {
        motion: motion(trajectory),
        selected_by,
        without_yaw: without_yaw(model),
        least_time_s: None,
        weights: Vec::new(),
        recovery: None,
    };
    let (model, claim) = (model_of(trajectory), Claim::Plan(claim));
    Certificate { schema: SCHEMA, spec_sha256: sha256, model, capture_height_m: None, claim }
}

/// The modes for which a plan of the model gives up yaw; none for RIP, which no mode concerns.
fn without_yaw(model: &Model) -> Vec<SpinRecord> {
    if model.plan.planner == PlannerKind::Rip || Obstacle::of(model).is_some() {
        return Vec::new();
    }
    let healthy = AdmissibleSet::healthy(model);
    let record = |&mode: &usize| match Provision::of(model, &AdmissibleSet::of_mode(model, mode), &healthy) {
        Provision::WithoutYaw(core) => Some(SpinRecord {
            mode: model.modes[mode].name.clone(),
            spin_rad_s: core.spin_rad_s,
            turning_rad_s: core.turning_rad_s,
        }),
        Provision::WithYaw | Provision::Capture => None,
    };
    model.plan.against.iter().filter_map(record).collect()
}

/// The model of the wrench that the plan uses.
pub fn model_of(trajectory: &Trajectory) -> DynamicModel {
    match trajectory.model {
        WrenchModel::HoverAt(_) | WrenchModel::HoverFollowing => DynamicModel::Hover,
        WrenchModel::Exact => DynamicModel::Exact,
    }
}

/// A trajectory as a record.
pub fn motion(trajectory: &Trajectory) -> MotionRecord {
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
