//! Least times: closed forms, the planner's own, plans, and what is claimed beyond them.

use super::{SHA, decide, planned, verify};
use crate::vehicles::{limit, mission, octocopter, waypoint};
use mavc::certificate::{Certificate, Claim, DynamicModel, SCHEMA, TooEarlyClaim};
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::timing::kinematics::least_time_within;
use std::path::Path;

/// One leg from rest to rest in the exact model, waypoints met to the millimetre.
fn hop(to: [f64; 3], turn: f64, limits: &[(LimitKind, f64)]) -> Model {
    let mut model = octocopter("PPNNPPNN");
    let mut flight = mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint(to, turn)]);
    for point in &mut flight.waypoints {
        (point.within, point.yaw_within) = (1e-3, 1e-3);
    }
    flight.limits = limits.iter().map(|(kind, upper)| limit(kind.clone(), *upper)).collect();
    model.mission = Some(flight);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = PlanModel::Exact;
    model.plan.samples = 20;
    model
}

fn bound(model: &Model) -> f64 {
    least_time_within(Problem::of(model).unwrap()).seconds
}

fn claiming(model: &Model, waypoint: usize, soonest_s: f64) -> Certificate {
    let kind = match model.plan.model {
        PlanModel::Exact => DynamicModel::Exact,
        PlanModel::Hover => DynamicModel::Hover,
    };
    let claim = Claim::TooEarly(TooEarlyClaim { waypoint, soonest_s });
    Certificate { schema: SCHEMA, spec_sha256: SHA.into(), model: kind, capture_height_m: None, claim }
}

/// Missions whose least time has a closed form, up to the tolerances of waypoints and of the check.
fn closed_forms() -> Vec<(Model, f64)> {
    let full = octocopter("PPNNPPNN");
    let force: f64 = full.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum::<f64>() / full.vehicle.mass;
    // A climb begins with the thrust that the weight leaves and ends by falling; a descent the other way round.
    let ends = |speed: f64| 0.5 * speed * (1.0 / (force - 9.81) + 1.0 / 9.81);
    let leans = 20f64.to_radians();
    let tilted = force * leans.sin();
    vec![
        // d/v + v/a, full thrust lying on its side.
        (hop([100.0, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 2.0)]), 50.0 + 2.0 / force),
        (
            hop([60.0, 80.0, 2.0], 0.0, &[(LimitKind::SpeedHorizontal, 5.0), (LimitKind::Tilt, leans)]),
            20.0 + 5.0 / tilted,
        ),
        (hop([0.0, 0.0, 42.0], 0.0, &[(LimitKind::Climb, 4.0)]), 10.0 + ends(4.0)),
        (hop([0.0, 0.0, -38.0], 0.0, &[(LimitKind::Descent, 2.0)]), 20.0 + ends(2.0)),
        (hop([50.0, 0.0, 2.0], 0.0, &[(LimitKind::AccelerationHorizontal, 2.0)]), 10.0),
        (hop([32.0, 0.0, 2.0], 0.0, &[(LimitKind::Jerk, 1.0)]), 1024f64.cbrt()),
        (hop([0.0, 0.0, 2.0], 3.0, &[(LimitKind::YawRate, 0.3)]), 10.0),
        (hop([0.0, 0.0, 2.0], 2.0, &[(LimitKind::YawAcceleration, 0.5)]), 4.0),
    ]
}

#[test]
fn least_times_are_closed_forms() {
    for (mut model, expected) in closed_forms() {
        let least = bound(&model);
        assert!(least <= expected && least > expected * (1.0 - 3e-3), "{least} {expected}");
        // The checker comes to the same with code of its own: it accepts this, and nothing above.
        model.plan.time = MissionTime::Fixed(0.9 * least);
        let verdict = decide(&claiming(&model, 2, least), &model).unwrap();
        assert!(verdict.weaker.is_empty() && verdict.headline.contains("however the time is divided"), "{verdict:?}");
        let above = decide(&claiming(&model, 2, least * (1.0 + 1e-8)), &model).unwrap_err();
        assert_eq!(above.claim, "the earliest arrival at waypoint 2");
        // A time that is long enough is none to be too early for.
        model.plan.time = MissionTime::Fixed(1.1 * least);
        assert_eq!(decide(&claiming(&model, 2, least), &model).unwrap_err().claim, "the time of a waypoint");
        model.plan.time = MissionTime::Minimum;
        assert_eq!(decide(&claiming(&model, 2, least), &model).unwrap_err().claim, "the time of a waypoint");
    }
}

/// Holds add to it, fixed times delay it, and rest at a hold counts like rest at an end.
#[test]
fn holds_and_fixed_times_count() {
    let mut model = hop([10.0, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 1.0), (LimitKind::Acceleration, 1.0)]);
    let flight = model.mission.as_mut().unwrap();
    flight.waypoints.push(waypoint([20.0, 0.0, 2.0], 0.0));
    flight.waypoints[2].within = 1e-3;
    flight.legs.push(flight.legs[0]);
    let near = |model: &Model, expected: f64| {
        let least = bound(model);
        assert!(least <= expected && least > expected - 0.02, "{least} {expected}");
    };
    // Two legs of 10 s, and half a second at either end for 1 m/s at 1 m/s^2.
    near(&model, 21.0);
    model.mission.as_mut().unwrap().waypoints[1].hold = 5.0;
    near(&model, 27.0);
    model.mission.as_mut().unwrap().waypoints[1].time = Some(30.0);
    near(&model, 46.0);
    assert!(least_time_within(Problem::of(&model).unwrap()).too_early.is_none());
    model.mission.as_mut().unwrap().waypoints[1].time = Some(10.0);
    let (waypoint, soonest) = least_time_within(Problem::of(&model).unwrap()).too_early.unwrap();
    assert!(waypoint == 1 && (soonest - 11.0).abs() < 0.02, "{soonest}");
    assert!(decide(&claiming(&model, 2, soonest * (1.0 - 1e-9)), &model).is_ok());
    assert!(decide(&claiming(&model, 0, 1.0), &model).is_err() && decide(&claiming(&model, 9, 1.0), &model).is_err());
    for nonsense in [f64::NAN, f64::INFINITY] {
        assert!(decide(&claiming(&model, 2, nonsense), &model).is_err());
    }
}

/// A shipped spec, elaborated.
fn shipped(name: &str) -> Model {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs");
    let path = folder.join(format!("{name}.mav"));
    mavc::Compiler::new().file(path).unwrap().into_result().unwrap().model().clone()
}

/// No plan of a shipped spec is shorter than its bound, and each certificate carries one that is accepted.
#[test]
fn plans_stay_above_their_bounds() {
    for name in ["paper/case1", "paper/case2", "paper/figure12", "missions/inspection"] {
        let mut model = shipped(name);
        model.plan.samples = 60;
        let mission = model.mission.clone().unwrap();
        let found = planned(&model);
        let Some(solved) = found.runs.last().unwrap().outcome.plan() else { panic!("{name}") };
        assert!(bound(&model) > 0.0 && bound(&model) < solved.time, "{name}: {} {}", bound(&model), solved.time);
        let certificate = mavc::certify::of(Problem::of(&model).unwrap(), &found, SHA.into()).unwrap();
        let Claim::Plan(claim) = &certificate.claim else { panic!("{name}") };
        // A time that the last waypoint fixes needs no bound.
        let is_open = mission.waypoints.last().unwrap().time.is_none();
        assert_eq!(claim.least_time_s, is_open.then(|| bound(&model)), "{name}");
        assert!(verify(&serde_json::to_vec(&certificate).unwrap(), &model, SHA).is_ok(), "{name}");
        for claimed in [1.001 * bound(&model), -5.0] {
            let mut other = certificate.clone();
            let Claim::Plan(claim) = &mut other.claim else { panic!("{name}") };
            claim.least_time_s = Some(claimed);
            assert_eq!(decide(&other, &model).unwrap_err().claim, "the least time", "{name}");
        }
    }
}
