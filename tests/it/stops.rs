//! Stops after a fault: against closed forms, and each one found against what a stop is.

use crate::vehicles::{lost, mission, octocopter, paper_case, waypoint};
use mavc::body::Body;
use mavc::model::{
    AfterFault, FaultMode, Limit, LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem, RotorState,
    Volume, VolumeSide,
};
use mavc::motion::checks::violation;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, X, Y, YAW, Z};
use mavc::planner::scp::Iterate;
use mavc::planner::selection::sets::PlanningSets;
use mavc::planner::stop::Stops;
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, Scope, run_planners};
use mavc::source::Span;
use nalgebra::Vector3;

fn run(model: &Model) -> Comparison {
    run_planners(Problem::of(model).unwrap(), Scope::Plan, None)
}

fn solved(comparison: &Comparison) -> &MissionPlan {
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(s) => s,
        other => panic!("{other:?}"),
    }
}

fn at_least(kind: LimitKind, lower: f64) -> Limit {
    Limit { kind, lower: Some(lower), upper: None, span: Span::default(), volume: None, leg: None }
}

fn held(mut model: Model) -> Model {
    model.plan.after_fault = AfterFault::Hold;
    model
}

const FLOOR: f64 = 1.0;
/// What is left of each rotor.
const LEFT: f64 = 0.4;

/// Straight down above a floor, by a plan that takes no notice of a fault that leaves two fifths of the thrust.
fn descent(wrench: PlanModel) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![FaultMode { rotors: vec![RotorState::Reduced(LEFT); 8], ..lost(&model, &[]) }];
    let points = vec![waypoint([0.0, 0.0, 30.0], 0.0), waypoint([0.0, 0.0, 2.0], 0.0)];
    model.mission = Some(Mission { limits: vec![at_least(LimitKind::Z, FLOOR)], ..mission(points) });
    model.plan.planner = PlannerKind::Rip;
    model.plan.against = vec![0];
    model.plan.model = wrench;
    model.plan.samples = 100;
    model.plan.time = MissionTime::Fixed(5.0);
    model
}

/// Without torques the remaining thrust brakes at `a = T/m - g`, so a descent at v can be stopped above the floor where
/// `v^2/(2 a)` is not more than the height above it.
#[test]
fn a_descent_is_committed_until_it_can_be_braked() {
    for wrench in [PlanModel::Hover, PlanModel::Exact] {
        let model = held(descent(wrench));
        let comparison = run(&model);
        let s = solved(&comparison);
        let vehicle = &model.vehicle;
        let thrust: f64 = vehicle.rotors.iter().map(|r| LEFT * r.max_thrust()).sum();
        let brakes = thrust / vehicle.mass - model.gravity;
        let hits = |t: f64| {
            let [height, speed, ..] = s.trajectory.at(t)[Z];
            speed < 0.0 && speed * speed / (2.0 * brakes) > height - FLOOR
        };
        let samples = 50_000;
        let last = (0..=samples).rev().map(|i| s.time * f64::from(i) / f64::from(samples)).find(|t| hits(*t)).unwrap();
        let step = s.time / 100.0;
        println!("{wrench:?}: {} s, in closed form {last} s, continued {} s", s.committed[0], s.outside[0].committed());
        assert!(last > 0.5 && last < s.outside[0].committed() - 2.0 * step, "{last} {:?}", s.outside);
        assert!((last..last + 2.0 * step).contains(&s.committed[0]), "{wrench:?}: {} s, {last} s", s.committed[0]);
    }
}

/// The same where the floor is the boundary of volumes: to stay outside, or inside.
fn is_committed_as_above_a_floor(wrench: PlanModel, volumes: &[(VolumeSide, Body)], samples: usize) {
    let committed = |volume: Option<&(VolumeSide, Body)>| {
        let mut model = held(descent(wrench));
        // Each node is asked for a stop.
        model.plan.samples = samples;
        let size = model.vehicle.radius();
        if let Some((side, body)) = volume {
            let clearance = FLOOR - size;
            let bodies = vec![body.clone()];
            let volume = Volume { name: "v".into(), side: *side, bodies, clearance, span: Span::default() };
            let mission = model.mission.as_mut().unwrap();
            mission.limits = volume.limits(size);
            mission.volumes = vec![volume];
        }
        solved(&run(&model)).committed[0]
    };
    let floor = committed(None);
    for volume in volumes {
        let found = committed(Some(volume));
        println!("{wrench:?} {volume:?}: {found} s, above a floor {floor} s");
        assert!((found - floor).abs() <= 2.0 * 5.0 / samples as f64, "{volume:?}: {found} s, {floor} s");
    }
}

fn square(reach: f64) -> Vec<[f64; 2]> {
    vec![[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]]
}

fn room() -> (VolumeSide, Body) {
    (VolumeSide::KeepIn, Body::Prism { corners: square(60.0), bottom: 0.0, top: 90.0 })
}

#[test]
#[ignore = "long"]
fn a_descent_towards_a_volume_is_committed_as_above_a_floor() {
    let below = Body::Prism { corners: square(40.0), bottom: -5.0, top: 0.0 };
    is_committed_as_above_a_floor(PlanModel::Exact, &[(VolumeSide::KeepOut, below), room()], 40);
}

/// In the hover model chains of integrators are null controllable however small their bounds, so without limits every
/// plan can be stopped from everywhere: the vehicle without a rotor only needs time.
#[test]
fn without_limits_the_hover_model_always_stops() {
    let mut model = held(paper_case(PlannerKind::Rip, &[0, 8]));
    model.plan.samples = 60;
    model.plan.time = MissionTime::Fixed(17.0);
    let comparison = run(&model);
    let s = solved(&comparison);
    assert!(s.outside.iter().any(|o| o.committed() > 1.0), "{:?}", s.outside);
    assert_eq!(s.committed, [0.0, 0.0]);
}

/// One mode says otherwise than the plan.
#[test]
fn a_mode_overrides_the_plan() {
    let mut model = held(descent(PlanModel::Hover));
    model.plan.samples = 40;
    model.modes.push(FaultMode { after_fault: Some(AfterFault::Continue), ..model.modes[0].clone() });
    model.plan.against = vec![0, 1];
    let comparison = run(&model);
    let s = solved(&comparison);
    assert_eq!(s.outside[0], s.outside[1]);
    assert_eq!(s.committed[1], s.outside[1].committed());
    assert!(s.committed[0] < s.committed[1]);
}

/// A mission that ends in flight is over before anything has stopped.
#[test]
fn a_mission_that_ends_in_flight_is_asked_at_its_end_too() {
    let mut model = held(descent(PlanModel::Hover));
    model.plan.samples = 40;
    let mission = model.mission.as_mut().unwrap();
    mission.end_at_rest = false;
    model.plan.time = MissionTime::Fixed(3.0);
    let comparison = run(&model);
    let s = solved(&comparison);
    let end = s.trajectory.nodes.last().unwrap();
    assert!(end[Z][1] < -5.0, "{end:?}");
    assert_eq!(s.committed, [s.time]);
}

/// The thrust's direction and how it turns, by differences.
fn direction(state: impl Fn(f64) -> NodeState, gravity: f64) -> (Vector3<f64>, Vector3<f64>) {
    let at = |t: f64| {
        let s = state(t);
        Vector3::new(s[X][2], s[Y][2], s[Z][2] + gravity).normalize()
    };
    let dt = 1e-5;
    (at(0.0), (at(dt) - at(0.0)) / dt)
}

/// A stop is inside the set and the limits at instants of its own, begins as the fault met the plan, and ends at rest.
fn is_a_stop(model: &Model, sets: &PlanningSets, struck: &NodeState, slope: &NodeState, stop: &Iterate) {
    let g = model.gravity;
    let steps = 40 * stop.grid.intervals();
    for i in 0..=steps {
        let (interval, share) = ((i / 40).min(stop.grid.intervals() - 1), (i % 40) as f64 / 40.0);
        let share = if i == steps { 1.0 } else { share };
        let state = stop.inside(interval, share);
        let wrench = stop.model.wrench(&model.vehicle, &mavc::model::Environment::vacuum(g), &state);
        for row in &sets.modes[0].rows {
            assert!(row.violation(&wrench) <= 1e-4, "{} of {steps}: {}", i, row.violation(&wrench));
        }
        for limit in &model.mission.as_ref().unwrap().limits {
            assert!(
                violation(limit, &state, &mavc::model::Environment::vacuum(g))
                    <= 1e-3 * limit.upper.unwrap_or(1.0).abs(),
                "{limit:?} {i}"
            );
        }
    }
    let begin = stop.inside(0, 0.0);
    for (axis, orders) in [(X, 2), (Y, 2), (Z, 2), (YAW, 2)] {
        for order in 0..orders {
            assert!((begin[axis][order] - struck[axis][order]).abs() < 1e-5, "{axis} {order}");
        }
    }
    if stop.model == WrenchModel::Exact {
        // Along a line through the plan's state with its slope, and along the stop.
        let along = |t: f64| -> NodeState {
            std::array::from_fn(|axis| std::array::from_fn(|m| struck[axis][m] + t * slope[axis][m]))
        };
        let h = stop.grid.node_times[1];
        let (n, turns) = direction(along, g);
        let (initial_guesses, turned) = direction(|t| stop.inside(0, t / h), g);
        assert!(
            (n - initial_guesses).norm() < 1e-5 && (turns - turned).norm() < 1e-3,
            "{n} {initial_guesses} {turns} {turned}"
        );
    } else {
        for (axis, order) in [(X, 2), (X, 3), (Y, 2), (Y, 3)] {
            assert!((begin[axis][order] - struck[axis][order]).abs() < 1e-4, "{axis} {order}");
        }
    }
    let end = stop.states.last().unwrap();
    for (axis, orders) in [(X, 3), (Y, 3), (Z, 1), (YAW, 1)] {
        assert!(end[axis][1..=orders].iter().all(|d| d.abs() < 1e-4), "{axis}: {:?}", end[axis]);
    }
}

/// Flown round a corner with a turning nose, so that a plan for a healthy vehicle is outside the set of a fault: each
/// stop found is one.
fn finds_stops(wrench: PlanModel, yaw: f64) {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[1])];
    let points = [[0.0, 0.0, 4.0], [8.0, 0.0, 6.0], [8.0, 8.0, 4.0]];
    let points = points.iter().enumerate().map(|(i, p)| waypoint(*p, yaw * i as f64)).collect();
    let limits = vec![
        Limit { kind: LimitKind::Speed, lower: None, upper: Some(8.0), span: Span::default(), volume: None, leg: None },
        at_least(LimitKind::Z, 3.0),
    ];
    model.mission = Some(Mission { limits, ..mission(points) });
    model.plan.planner = PlannerKind::Rip;
    model.plan.against = vec![0];
    model.plan.model = wrench;
    model.plan.samples = 40;
    model.plan.time = MissionTime::Fixed(5.0);
    let comparison = run(&model);
    let s = solved(&comparison);
    let sets = PlanningSets::of(&model);
    let mut stops = Stops::new(Problem::of(&model).unwrap(), &sets.healthy, &sets.modes[0], s.trajectory.model);
    let mut found = 0;
    for node in (0..s.trajectory.nodes.len() - 1).step_by(8) {
        let struck = &s.trajectory.nodes[node];
        if let Some(stop) = stops.find(struck) {
            // Derivatives of the plan's derivatives are the next ones.
            let slope: NodeState =
                std::array::from_fn(|a| std::array::from_fn(|m| if m < 4 { struck[a][m + 1] } else { 0.0 }));
            is_a_stop(&model, &sets, struck, &slope, &stop);
            found += 1;
        }
    }
    assert!(found >= 3, "{found}");
}

#[test]
fn what_is_found_is_a_stop() {
    finds_stops(PlanModel::Exact, 0.8);
}

#[test]
#[ignore = "long"]
fn what_is_found_in_the_hover_model_is_a_stop() {
    [0.0, 0.8].into_iter().for_each(|yaw| finds_stops(PlanModel::Hover, yaw));
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// The same with a floor far below: nothing is in the way.
    #[test]
    #[ignore = "long"]
    fn without_a_floor_the_descent_is_never_committed() {
        for wrench in [PlanModel::Hover, PlanModel::Exact] {
            let mut model = held(descent(wrench));
            model.mission.as_mut().unwrap().limits = vec![at_least(LimitKind::Z, -200.0)];
            let comparison = run(&model);
            let s = solved(&comparison);
            assert!(s.outside[0].committed() > 4.0, "{:?}", s.outside);
            assert_eq!(s.committed, [0.0]);
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_descent_towards_other_bodies_is_committed_as_above_a_floor() {
        let ball = Body::Ball { centre: [0.0, 0.0, -500.0], radius: 500.0 };
        let hill = Body::HalfSpace { normal: [0.0, 0.0, 1.0], offset: 0.0 };
        is_committed_as_above_a_floor(PlanModel::Exact, &[ball, hill].map(|body| (VolumeSide::KeepOut, body)), 60);
        is_committed_as_above_a_floor(PlanModel::Hover, &[room()], 60);
    }
}
