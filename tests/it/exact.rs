//! The exact model: flatness against the rigid body, plans against the spec, and what is reported without a plan.

mod agreement;
mod binding;
mod costs;
mod flatness;
mod plans;
mod rigid;
mod times;
mod verdicts;

use crate::vehicles::{limit, lost, mission, octocopter, waypoint};
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Scope, run_planners};

/// An octocopter with another inertia about each axis, planned for in the exact model.
fn vehicle() -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.inertia = [0.0429, 0.0512, 0.0748];
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    model.plan.model = PlanModel::Exact;
    model.plan.samples = 40;
    model
}

/// Up, across and back down while the nose turns.
fn turning() -> Mission {
    let mut mission = mission(vec![
        waypoint([0.0, 0.0, 2.0], 0.0),
        waypoint([4.0, 2.0, 5.0], 0.7),
        waypoint([7.0, -1.0, 4.0], 1.3),
        waypoint([9.0, 1.0, 3.0], 0.4),
    ]);
    mission.limits = vec![limit(LimitKind::Tilt, 40f64.to_radians()), limit(LimitKind::Speed, 4.0)];
    mission
}

fn planning(mission: Mission, planner: PlannerKind, against: &[usize], time: MissionTime) -> Model {
    let mut model = vehicle();
    model.mission = Some(mission);
    model.plan.planner = planner;
    model.plan.against = against.to_vec();
    model.plan.time = time;
    model
}

fn compared(model: &Model) -> Comparison {
    run_planners(Problem::of(model).unwrap(), Scope::Plan, None)
}

/// The run of the spec's own planner.
fn last(comparison: &Comparison) -> &PlannerRun {
    comparison.runs.last().unwrap()
}

fn solved(run: &PlannerRun) -> &MissionPlan {
    match &run.outcome {
        PlanOutcome::Planned(solved) => solved,
        other => panic!("{:?}: {other:?}", run.planner),
    }
}
