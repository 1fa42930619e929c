//! Rotors that lag: what their rows mean, what motors make of plans that keep them, and what they cost.

mod climb;
mod motors;
mod plans;
mod spec;
mod theory;
mod vehicles;

use crate::vehicles::{mission, octocopter, waypoint};
use mavc::actuation::Wrench;
use mavc::model::{Mission, MissionTime, Model, PlanModel, PlanRotors, PlannerKind, Problem};
use mavc::motion::Trajectory;
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, Scope, run_planners};

/// The model with rotors whose thrusts are planned to follow in `tau` s.
pub fn lagging(mut model: Model, tau: f64) -> Model {
    model.plan.rotors = PlanRotors::Lagging;
    model.vehicle.rotors.iter_mut().for_each(|r| r.time_constant = Some(1.0));
    let of_one_second = model.thrust_lag().unwrap();
    model.vehicle.rotors.iter_mut().for_each(|r| r.time_constant = Some(tau / of_one_second));
    model
}

/// There and back, a little upwards, without turning; at a time that is not easy.
pub fn shuttle() -> Mission {
    mission(vec![
        waypoint([0.0, 0.0, 2.0], 0.3),
        waypoint([4.0, 1.0, 4.0], 0.3),
        waypoint([7.0, -2.0, 3.0], 0.3),
        waypoint([3.0, 0.0, 2.0], 0.3),
    ])
}

/// The same while the nose turns.
pub fn turning() -> Mission {
    let mut mission = shuttle();
    for (w, yaw) in mission.waypoints.iter_mut().zip([0.0, 0.7, 1.3, 0.4]) {
        w.yaw = yaw;
    }
    mission
}

pub fn planning(mission: Mission, model: PlanModel, time: MissionTime) -> Model {
    let mut octo = octocopter("PPNNPPNN");
    octo.mission = Some(mission);
    octo.plan.model = model;
    octo.plan.planner = PlannerKind::Rip;
    octo.plan.time = time;
    octo.plan.samples = 40;
    octo
}

fn compared(model: &Model) -> Comparison {
    run_planners(Problem::of(model).unwrap(), Scope::Plan, None)
}

fn solved(comparison: &Comparison) -> &MissionPlan {
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(solved) => solved,
        other => panic!("{other:?}"),
    }
}

pub fn shortest(model: &Model) -> f64 {
    solved(&compared(model)).time
}

/// w and w + tau w' along a plan, with w' by differences of the planned wrench inside an interval: near both its ends
/// and at `looks` instants between.
fn with_commands(model: &Model, plan: &Trajectory, tau: f64, looks: usize) -> Vec<(Wrench, Wrench)> {
    let mut all = Vec::new();
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        let d = 1e-3 * h;
        let w = |t: f64| plan.wrench(&model.vehicle, &model.environment(), &plan.within(k, t));
        let inner = h - 4.0 * d;
        for i in 0..=looks + 1 {
            let t = 2.0 * d + inner * i as f64 / (looks + 1) as f64;
            let rate = ((w(t + d) - w(t - d)) * 8.0 - (w(t + 2.0 * d) - w(t - 2.0 * d))) / (12.0 * d);
            all.push((w(t), w(t) + rate * tau));
        }
    }
    all
}
