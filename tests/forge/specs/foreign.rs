//! Certificates that harder specs have no plan, made by the planner: multipliers that show nothing about the spec
//! itself.

use super::Harder;
use mavc::certificate::Certificate;
use mavc::certify;
use mavc::model::{Limit, LimitKind, MissionTime, Model, PlannerKind, Problem, Rotor};
use mavc::planner::studies::{Scope, run_planners};

/// The share of the top speeds that the weaker vehicle's rotors have; its thrusts go with the square.
pub const WEAKER: f64 = 0.62;

/// Those that are found; some harder specs have a plan after all.
pub fn harder(model: &Model, total: f64) -> Vec<(Harder, Certificate)> {
    let changed = |how: Harder, change: &dyn Fn(&mut Model)| {
        let mut other = model.clone();
        change(&mut other);
        (how, other)
    };
    let mut tried = vec![
        changed(Harder::Shorter, &|m| shorten(m, total, 0.3)),
        changed(Harder::WeakerVehicle, &|m| m.vehicle.rotors.iter_mut().for_each(|r| r.max_speed *= WEAKER)),
    ];
    if model.mission.as_ref().is_some_and(|m| !m.limits.is_empty()) {
        tried.push(changed(Harder::StricterLimits, &|m| {
            let limits = m.mission.iter_mut().flat_map(|m| &mut m.limits);
            for limit in limits.filter(|l| l.kind != LimitKind::Z) {
                limit.upper = limit.upper.map(|u| 0.4 * u);
            }
        }));
    }
    if model.vehicle.rotors.iter().any(Rotor::is_reversible) {
        tried.push(changed(Harder::OneWay, &|m| m.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 0.0)));
    }
    let is_uneven = |l: &Limit| l.lower.zip(l.upper).is_some_and(|(lower, upper)| is_of_yaw(l) && lower != -upper);
    if model.mission.iter().flat_map(|m| &m.limits).any(is_uneven) {
        tried.push(changed(Harder::NarrowSides, &|m| {
            for limit in m.mission.iter_mut().flat_map(|m| &mut m.limits).filter(|l| is_of_yaw(l)) {
                let narrow = limit.lower.map(|lower| -lower).into_iter().chain(limit.upper).reduce(f64::min);
                (limit.lower, limit.upper) = (narrow.map(|n| -n), narrow);
            }
        }));
    }
    if model.plan.planner == PlannerKind::Rip && !model.plan.against.is_empty() {
        tried.push(changed(Harder::OtherPlanner, &|m| m.plan.planner = PlannerKind::Rcp));
    }
    tried.into_iter().filter_map(|(how, model)| Some((how, refuted(&model)?))).collect()
}

fn is_of_yaw(limit: &Limit) -> bool {
    matches!(limit.kind, LimitKind::YawRate | LimitKind::YawAcceleration)
}

fn shorten(model: &mut Model, total: f64, share: f64) {
    model.plan.time = MissionTime::Fixed(total * share);
    for point in model.mission.iter_mut().flat_map(|m| &mut m.waypoints) {
        point.time = point.time.map(|t| t * share);
        point.hold *= share;
    }
}

fn refuted(model: &Model) -> Option<Certificate> {
    let problem = Problem::of(model)?;
    let comparison = run_planners(problem, Scope::Plan, None);
    // A waypoint that is due too early has a certificate of its own.
    certify::by_multipliers(problem, &comparison, crate::SHA.into()).ok()
}
