//! Flights along a real plan: the paper's first case in 30 s.

use super::strike;
use mavc::flight::{Flight, Outcome, Sample, Sortie, fly};
use mavc::model::{AfterFault, Controller, Detection, MissionTime, Model, PlannerKind, Problem};
use mavc::motion::Trajectory;
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use std::sync::LazyLock;

pub(super) static CASE: LazyLock<(Model, Trajectory)> =
    LazyLock::new(|| planned("case1", |model| model.plan.time = MissionTime::Fixed(30.0)));

/// A spec of the paper with its plan.
fn planned(name: &str, change: impl FnOnce(&mut Model)) -> (Model, Trajectory) {
    let path = format!("{}/specs/paper/{name}.mav", env!("CARGO_MANIFEST_DIR"));
    let mut model = mavc::Compiler::new().file(path).unwrap().into_result().unwrap().model().clone();
    change(&mut model);
    let mut comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
    match comparison.runs.remove(0).outcome {
        PlanOutcome::Planned(solved) => (model, solved.trajectory),
        other => panic!("{other:?}"),
    }
}

/// Rotor 3 is mode 2.
pub(super) const THIRD: usize = 2;

fn flown(change: impl FnOnce(&mut Model), faulty: bool, mut look: impl FnMut(&Sample)) -> Flight {
    let (model, plan) = &*CASE;
    let mut model = model.clone();
    change(&mut model);
    let strikes = if faulty { vec![strike(THIRD, 5.0)] } else { Vec::new() };
    fly(&Sortie::along(&model, plan, &strikes, 1), Some(&mut |s| look(s)))
}

#[test]
fn healthy_the_plan_is_followed() {
    let geometric = flown(|_| (), false, |_| ());
    assert_eq!(geometric.outcome, Outcome::Flown);
    assert!((geometric.end - 30.0).abs() < 1e-3, "{}", geometric.end);
    assert!(geometric.rms_error < 0.02, "{geometric:?}");
    assert_eq!((geometric.false_alarms, geometric.refused, geometric.rms_error_after), (0, 0, 0.0));
    let pd = flown(|m| m.simulation.controller = Controller::Pd, false, |_| ());
    assert!(pd.rms_error < 0.2 && pd.outcome == Outcome::Flown, "{pd:?}");
}

#[test]
fn an_undetected_loss_is_felt_and_an_estimated_one_is_not() {
    let blind = flown(|m| m.simulation.detection = Detection::Never, true, |_| ());
    let seeing = flown(|_| (), true, |_| ());
    assert!(blind.max_error > 0.3, "{blind:?}");
    assert!(seeing.outcome == Outcome::Flown && seeing.max_error < 0.05, "{seeing:?}");
    assert!(seeing.found[0].isolated_after.is_some_and(|t| t < 0.5), "{seeing:?}");
}

/// Where speeds change fast between the estimator's samples, its regressor must be their mean: a sum of one end's
/// values made this flight lose sound rotors.
#[test]
fn a_plan_that_tilts_raises_no_false_alarm() {
    let (model, plan) = planned("campaign", |model| model.plan.planner = PlannerKind::Rcp);
    for seed in 1..=3 {
        let mut least: f64 = 1.0;
        let flight = fly(
            &Sortie::along(&model, &plan, &[], seed),
            Some(&mut |s: &Sample| least = s.estimated.iter().copied().fold(least, f64::min)),
        );
        assert_eq!((flight.outcome, flight.false_alarms), (Outcome::Flown, 0));
        assert!(least > 0.9, "{least}");
    }
}

#[test]
fn a_hold_comes_to_rest() {
    let mut last = None;
    let flight = flown(
        |m| m.simulation.after_fault = AfterFault::Hold,
        true,
        |s| last = Some((s.body.velocity.norm(), s.reference.velocity.norm(), s.body.tilt())),
    );
    let (speed, wanted, tilt) = last.unwrap();
    assert_eq!(flight.outcome, Outcome::Flown);
    assert!(speed < 0.05 && wanted < 1e-9 && tilt < 0.02, "{speed} {wanted} {tilt}");
    // It would otherwise still be on its way at 12 s.
    assert!(flight.max_error < 0.1, "{flight:?}");
}

#[test]
fn a_landing_is_soft() {
    let mut last = None;
    let flight = flown(
        |m| m.simulation.after_fault = AfterFault::Land,
        true,
        |s| last = Some((s.body.velocity, s.body.position.z, s.time)),
    );
    let (velocity, height, time) = last.unwrap();
    assert!(matches!(flight.outcome, Outcome::Landed { .. }), "{flight:?}");
    assert!((velocity.z + 1.0).abs() < 0.05 && velocity.xy().norm() < 0.05, "{velocity}");
    assert!(height < 0.01 && (flight.end - time) < 0.003 && flight.max_error < 0.1, "{flight:?}");
}
