//! Rotors that lag and are allocated by the pseudo-inverse, may not stop, or are known within intervals: what they are
//! commanded, decided without the rows that planned it.

use super::{compared, lagging, planning, shuttle, solved, with_commands};
use crate::intervals::{at, uncertain};
use crate::pseudo_inverse::squares;
use crate::vehicles::lost;
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::model::{Allocation, MissionTime, Model, PlanModel, PlanRotors, PlannerKind};
use mavc::motion::Trajectory;

const TAU: f64 = 0.1;

/// Rows are missed by this share of the range of what they bound at most.
const MISSED: f64 = 1e-5;

/// Stands the loss of rotor 1 with lagging rotors; at the shortest time of the hover model, where rows of the lag bind.
fn tolerating_a_loss() -> Model {
    let mut model = lagging(planning(shuttle(), PlanModel::Hover, MissionTime::Minimum), TAU);
    model.modes.push(lost(&model, &[1]));
    (model.plan.planner, model.plan.against) = (PlannerKind::Rcp, vec![0]);
    model
}

fn planned(model: &Model) -> Trajectory {
    solved(&compared(model)).trajectory.clone()
}

fn leads(model: &Model, plan: &Trajectory, tau: f64) -> Vec<Wrench> {
    with_commands(model, plan, tau, 4).into_iter().map(|(_, commanded)| commanded).collect()
}

/// How far commands leave the bounds on squared speeds under (42) after the loss, in shares of full ones.
fn clipped(model: &Model, leads: &[Wrench]) -> f64 {
    let full = model.vehicle.rotors[0].max_speed.powi(2);
    let beyond = |commanded: &Wrench| {
        let asked = squares(model, Some(0), commanded);
        asked.iter().map(|s| (s / full - 1.0).max(-s / full)).fold(f64::NEG_INFINITY, f64::max)
    };
    leads.iter().map(beyond).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn the_pseudo_inverse_is_commanded_nothing_that_it_clips() {
    let mut model = tolerating_a_loss();
    model.vehicle.allocation = Allocation::PseudoInverse;
    let plan = planned(&model);
    let most = clipped(&model, &leads(&model, &plan, TAU));
    assert!(most < MISSED && most > -1e-2, "passed by {most:e}; a bound should bind");

    let mut at_once = model.clone();
    at_once.plan.rotors = PlanRotors::Instant;
    let without = clipped(&model, &leads(&model, &planned(&at_once), TAU));
    assert!(without > 0.05, "a plan for rotors that follow at once is clipped by {without}");
}

/// Down, where thrust is least: the commands of rotors that may not stop stay above their lowest speed, by the thrusts
/// that allocation finds for them.
#[test]
fn rotors_that_may_not_stop_are_not_commanded_to() {
    let mut model = tolerating_a_loss();
    model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 350.0);
    let tau = model.thrust_lag().unwrap();
    let plan = planned(&model);
    let leads = leads(&model, &plan, tau);
    let idle: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::idle_thrust).sum();
    let least = leads.iter().map(|c| c[0]).fold(f64::INFINITY, f64::min);
    // After the loss seven rotors idle, before it eight: both sets are kept.
    assert!(least > idle * (1.0 - 1e-4), "{least} N, {idle} N at idle");
    for set in [AdmissibleSet::healthy(&model), AdmissibleSet::of_mode(&model, 0)] {
        let margin = leads.iter().map(|c| set.polytope.margin(c)).fold(f64::INFINITY, f64::min);
        assert!(margin > -1e-4, "passed by {margin:e}");
    }
    let below = self::leads(&model, &planned(&tolerating_a_loss()), tau);
    let below = below.iter().map(|c| c[0]).fold(f64::INFINITY, f64::min);
    assert!(below < 0.9 * idle, "{below} N: a plan that may stop rotors does not");
}

/// Commands lie in the set of every vehicle within the intervals, for the mass that it has.
#[test]
fn commands_hold_for_every_value() {
    let model = uncertain(tolerating_a_loss(), 0.04, 0.05, 0.1);
    let (robust, nominal) = (planned(&model), planned(&tolerating_a_loss()));
    let mut passed = 0;
    for case in 0..64_u32 {
        // Ends of the intervals in a fixed, uneven order.
        let end = |i: u32| if (case.wrapping_mul(2_654_435_761) >> (i + 7)) & 1 == 1 { 1.0 } else { -1.0 };
        let places: Vec<(f64, f64)> = (0..8).map(|k| (if case % 4 == 0 { end(k) } else { -1.0 }, end(8 + k))).collect();
        let other = at(&model, end(17), &places);
        let set = AdmissibleSet::of_mode(&other, 0);
        let margin = |plan: &Trajectory| {
            leads(&other, plan, TAU).iter().map(|c| set.polytope.margin(c)).fold(f64::INFINITY, f64::min)
        };
        assert!(margin(&robust) > -1e-4, "passed by {:e}", margin(&robust));
        passed += usize::from(margin(&nominal) < -1e-2);
    }
    assert!(passed > 16, "the plan without intervals fails in {passed} of 64");
}
