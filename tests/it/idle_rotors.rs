//! Rotors that may not stop: their sets against corners of the speed box, and plans that stay in the healthy set too.

use crate::vehicles::{lost, mission, octocopter, waypoint};
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::verdict::{HoverVerdict, analyze};
use mavc::admissible::{AdmissibleSet, hover};
use mavc::flight::allocate::{Allocator, Belief};
use mavc::model::{Allocation, FaultMode, Mission, Model, PlannerKind, Problem, RotorState};
use mavc::planner::hover::{Decision, HoverPlanner};
use mavc::planner::selection::PlanningSet;
use mavc::planner::studies::{MissionPlan, PlanOutcome, Run, Scope, run_planners};
use mavc::planner::working_set::WorkingSet;
use proptest::prelude::*;

/// An octocopter whose rotors turn at least at `speeds`, rad/s, in order and from the first again.
fn idling(layout: &str, speeds: &[f64]) -> Model {
    let mut model = octocopter(layout);
    for (rotor, speed) in model.vehicle.rotors.iter_mut().zip(speeds.iter().cycle()) {
        rotor.min_speed = *speed;
    }
    model
}

/// The wrenches at all 2^n corners of the box of speeds under a mode: A diag(theta) Omega, stuck rotors at theirs.
fn corners(model: &Model, mode: usize) -> Vec<Wrench> {
    let a = Actuation::of(&model.vehicle).effectiveness;
    let mode = &model.modes[mode];
    let n = model.vehicle.rotors.len();
    let square = |code: usize, k: usize| {
        let rotor = &model.vehicle.rotors[k];
        match mode.rotors[k].stuck_at() {
            Some(share) => share * rotor.max_speed.powi(2),
            None => {
                if code >> k & 1 == 0 {
                    rotor.min_speed.powi(2)
                } else {
                    rotor.max_speed.powi(2)
                }
            }
        }
    };
    (0..1usize << n)
        .map(|code| (0..n).map(|k| a.column(k) * (mode.rotors[k].capacity() * square(code, k))).sum())
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sets_are_the_hull_of_the_speed_box(
        ppnn in any::<bool>(),
        speeds in prop::collection::vec(0.0..700.0f64, 8),
        capacity in prop::collection::vec(prop_oneof![Just(0.0), Just(1.0), 0.1..1.0f64], 8),
        stuck in prop::option::of((0usize..8, 0.0..1.0f64)),
    ) {
        let mut model = idling(if ppnn { "PPNNPPNN" } else { "PNPNPNPN" }, &speeds);
        let mut mode = lost(&model, &[]);
        mode.rotors = capacity.into_iter().map(RotorState::of_capacity).collect();
        if let Some((k, share)) = stuck {
            mode.rotors[k] = RotorState::Stuck(share);
        }
        model.modes.push(mode);
        let set = AdmissibleSet::of_mode(&model, 0);
        let corners = corners(&model, 0);
        let size = set.zonotope.scale()[0] + set.zonotope.offset.norm();
        for w in &corners {
            prop_assert!(set.polytope.contains(w, 1e-9 * size));
        }
        for f in &set.polytope.facets {
            let highest = corners.iter().map(|w| f.normal.dot(w)).fold(f64::NEG_INFINITY, f64::max);
            prop_assert!((highest - f.offset).abs() < 1e-9 * size, "{highest} {}", f.offset);
        }
    }
}

#[test]
fn a_lost_rotor_gives_wrenches_that_the_healthy_vehicle_cannot() {
    let mut model = idling("PNPNPNPN", &[300.0]);
    model.modes.push(lost(&model, &[1]));
    let [healthy, without] = [AdmissibleSet::healthy(&model), AdmissibleSet::of_mode(&model, 0)];
    // All others at their lowest: less thrust than the healthy vehicle has at least.
    let least = without.zonotope.offset;
    let idle = model.vehicle.rotors[0].idle_thrust();
    assert!((least[0] - 7.0 * idle).abs() < 1e-12 && (healthy.zonotope.offset[0] - 8.0 * idle).abs() < 1e-12);
    assert!(without.polytope.contains(&least, 1e-9) && !healthy.polytope.contains(&least, 1e-3));
}

#[test]
fn the_lightest_mass_is_where_all_rotors_idle() {
    let mut model = idling("PPNNPPNN", &[500.0]);
    let lightest = 8.0 * 8.5485e-6 * 500.0 * 500.0 / 9.81;
    let of = |model: &Model| analyze(model, &AdmissibleSet::healthy(model));
    assert!((of(&model).least_mass_kg.unwrap() - lightest).abs() < 1e-9);
    assert_eq!(of(&octocopter("PPNNPPNN")).least_mass_kg, Some(0.0));
    model.vehicle.mass = lightest - 0.01;
    assert_eq!(of(&model).verdict, HoverVerdict::Unstable);
    model.vehicle.mass = lightest + 0.01;
    assert_eq!(of(&model).verdict, HoverVerdict::Controllable);
}

#[test]
fn no_rotor_is_commanded_below_its_lowest_speed() {
    let model = idling("PPNNPPNN", &[300.0, 0.0, 450.0]);
    let mut belief = Belief::healthy(8);
    belief.capacity[2] = 0.0;
    for method in [Allocation::Bounded, Allocation::PseudoInverse] {
        let mut allocator = Allocator::new(&model, method);
        allocator.believe(&belief);
        let mut lowest = 0;
        for case in 0..40 {
            let f = f64::from(case);
            let off = Wrench::new(20.0 * f.sin(), 2.0 * (1.7 * f).cos(), 2.0 * (2.3 * f).sin(), 0.2 * (0.9 * f).sin());
            let mut speeds = [0.0; 8];
            allocator.speeds(&(hover(&model) + off), &mut speeds);
            for (speed, rotor) in speeds.iter().zip(&model.vehicle.rotors) {
                assert!((rotor.min_speed - 1e-9..=rotor.max_speed + 1e-9).contains(speed), "{method:?} {speed}");
                lowest += usize::from(rotor.min_speed > 0.0 && *speed < rotor.min_speed + 1e-9);
            }
        }
        assert!(lowest > 40, "{lowest}");
    }
}

/// Straight down, as fast as thrust can be taken away.
fn dive() -> Mission {
    mission(vec![waypoint([0.0, 0.0, 60.0], 0.0), waypoint([0.0, 0.0, 0.0], 0.0)])
}

#[test]
fn conservative_plans_keep_to_the_healthy_set_as_well() {
    // All rotors give less: with torques balanced, less than the healthy vehicle can.
    let mut model = idling("PNPNPNPN", &[420.0]);
    let weak = FaultMode { rotors: vec![RotorState::Reduced(0.7); 8], ..lost(&model, &[]) };
    model.modes.push(weak);
    model.mission = Some(dive());
    model.plan.planner = PlannerKind::Rcp;
    model.plan.against = vec![0];
    model.plan.samples = 40;
    let [healthy, weak] = [AdmissibleSet::healthy(&model), AdmissibleSet::of_mode(&model, 0)];
    let idle: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::idle_thrust).sum();
    assert!(hover(&model)[0] > idle);

    let plan = shortest(&model);
    let wrenches = plan.trajectory.node_wrenches(&model.vehicle, &model.environment());
    for set in [&healthy, &weak] {
        assert!(wrenches.iter().all(|w| set.polytope.margin(w) > -1e-4));
    }
    assert_eq!((plan.outside[0].seconds, plan.outside[0].rows), (0.0, 0));

    // The fault's set alone would dive faster, on thrust below what healthy rotors give at least.
    let alone = PlanningSet::of(&[&weak], &healthy);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let below = plan.infeasible_at.unwrap() - 0.2;
    let Decision::Feasible(planned) = engine.decide(below, 40, &alone, &mut WorkingSet::default()) else {
        panic!("fewer rows")
    };
    let thrust = |s| planned.model.wrench(&model.vehicle, &model.environment(), s)[0];
    let least = planned.states.iter().map(thrust).fold(f64::INFINITY, f64::min);
    assert!(least < idle - 0.5, "{least} {idle}");

    // Every planner at its own time: none takes less than RIP, for the healthy set bounds them all.
    let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Everything, None);
    let own = comparison.runs.iter().filter(|r| r.run == Run::Own);
    let times: Vec<f64> = own.map(|r| solved(&r.outcome).time).collect();
    assert!(times.len() == 3 && times.iter().all(|t| *t >= times[0]), "{times:?}");
}

fn solved(outcome: &PlanOutcome) -> &MissionPlan {
    match outcome {
        PlanOutcome::Planned(solved) => solved,
        other => panic!("{other:?}"),
    }
}

fn shortest(model: &Model) -> MissionPlan {
    let comparison = run_planners(Problem::of(model).unwrap(), Scope::Plan, None);
    solved(&comparison.runs[0].outcome).clone()
}
