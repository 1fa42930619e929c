//! Sets, verdicts and plans over intervals, against vehicles with numbers drawn from them.

use crate::vehicles::{lost, octocopter, paper_case, quadcopter, ring_model};
use mavc::actuation::Wrench;
use mavc::admissible::diagnose::{NOT_ROBUST, diagnose};
use mavc::admissible::interval::{Certainty, guaranteed, possible, robust};
use mavc::admissible::verdict::{HoverVerdict, analyze};
use mavc::admissible::{AdmissibleSet, hover};
use mavc::model::RotorState;
use mavc::model::{MissionTime, Model, PlannerKind, Problem, RotorSpread, Spread};
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use proptest::prelude::*;

fn about(share: f64) -> Spread {
    Spread { low: 1.0 - share, high: 1.0 + share }
}

/// The vehicle with mass, thrusts and torque ratios at places (-1 to 1) in their intervals: the mass, then of each
/// rotor the thrust at full speed and the ratio. Nothing of it is uncertain.
pub fn at(model: &Model, mass: f64, places: &[(f64, f64)]) -> Model {
    let within = |s: Spread, place: f64| 0.5 * (s.low + s.high) + 0.5 * (s.high - s.low) * place;
    let mut model = model.clone();
    model.vehicle.mass *= within(model.vehicle.mass_spread, mass);
    model.vehicle.mass_spread = Spread::NONE;
    for (rotor, (thrust, ratio)) in model.vehicle.rotors.iter_mut().zip(places) {
        let kappa = rotor.drag_coefficient / rotor.thrust_coefficient * within(rotor.spread.torque_per_thrust, *ratio);
        // Idle thrust goes with b, as full thrust does: both intervals are b's here.
        rotor.thrust_coefficient *= within(rotor.spread.full_thrust, *thrust);
        rotor.drag_coefficient = kappa * rotor.thrust_coefficient;
        rotor.spread = RotorSpread::default();
    }
    model
}

/// Intervals of these half widths on every rotor: on b, and on the torque per thrust.
pub fn uncertain(mut model: Model, mass: f64, thrust: f64, ratio: f64) -> Model {
    model.vehicle.mass_spread = about(mass);
    for rotor in &mut model.vehicle.rotors {
        rotor.spread =
            RotorSpread { full_thrust: about(thrust), idle_thrust: about(thrust), torque_per_thrust: about(ratio) };
    }
    model
}

/// Ends of the intervals more often than what lies between.
fn place() -> impl Strategy<Value = f64> {
    prop_oneof![Just(-1.0), Just(1.0), -1.0..1.0f64]
}

fn case() -> impl Strategy<Value = Model> {
    let shape = (0usize..4, prop::bool::ANY, prop::option::of((1usize..9, 0.0..1.0f64)));
    let capacity = prop::collection::vec(prop_oneof![1 => Just(0.0), 4 => Just(1.0), 2 => 0.3..1.0f64], 8);
    let widths = (0.0..0.1f64, prop_oneof![Just(0.0), 0.0..0.15f64], prop_oneof![Just(0.0), 0.0..0.2f64]);
    (shape, capacity, widths, prop_oneof![Just(0.0), 50.0..400.0f64]).prop_map(
        |((layout, whole, stuck), capacity, (mass, thrust, ratio), idle)| {
            let layout = ["PPNNPPNN", "PNPNPNPN", "PPPPNNNN", "PNNPNPPN"][layout];
            let mut model = uncertain(octocopter(layout), mass, thrust, ratio);
            model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = idle);
            let mut mode = lost(&model, &[]);
            if !whole {
                mode.rotors = capacity.into_iter().map(RotorState::of_capacity).collect();
            }
            if let Some((k, share)) = stuck.filter(|_| !whole) {
                mode.rotors[k - 1] = RotorState::Stuck(share);
            }
            model.modes.push(mode);
            model
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_guaranteed_is_given_and_what_is_given_is_possible(
        model in case(),
        values in prop::collection::vec((place(), prop::collection::vec((place(), place()), 8)), 6),
        points in prop::collection::vec((prop::array::uniform8(-0.2..1.2f64), 0.0..1.0f64), 12),
    ) {
        let set = AdmissibleSet::of_mode(&model, 0);
        let sure = guaranteed(&model, &set);
        let planned = set.guaranteed(&model);
        let possible = possible(&model, &set);
        let scale = set.zonotope.scale();
        let middle = set.zonotope.offset + 0.5 * set.zonotope.generators.iter().sum::<Wrench>();
        for (mass, places) in &values {
            let other = at(&model, *mass, places);
            let there = AdmissibleSet::of_mode(&other, 0);
            let ratio = other.vehicle.mass / model.vehicle.mass;
            for (shares, along) in &points {
                // Any wrench about the set, moved into what is guaranteed where that is not empty.
                let any: Wrench =
                    set.zonotope.generators.iter().zip(shares).map(|(g, t)| g * *t).sum::<Wrench>() + set.zonotope.offset;
                if let Some(inside) = sure.as_ref().and_then(|rows| rows.nearest(&any)) {
                    prop_assert!(there.polytope.contains(&inside, 1e-9 * scale[0]), "{inside}");
                }
                if let Some(nominal) = planned.polytope.nearest(&any) {
                    let needed = Wrench::new(nominal[0] * ratio, nominal[1], nominal[2], nominal[3]);
                    prop_assert!(there.polytope.contains(&needed, 1e-9 * scale[0]), "{needed}");
                }
                // Any wrench of the other vehicle, most of them on its boundary.
                let far = middle + (any - middle) * (1.0 + 4.0 * along);
                let Some(given) = there.polytope.nearest(&far) else { continue };
                prop_assert!(possible.contains(&given, 1e-6 * scale[0]), "{}", possible.margin(&given));
            }
        }
    }

    #[test]
    fn margins_and_verdicts_are_those_of_samples(
        model in case(),
        heavier in 0.6..2.4f64,
        values in prop::collection::vec((place(), prop::collection::vec((place(), place()), 8)), 12),
    ) {
        let mut model = model;
        model.vehicle.mass *= heavier;
        let set = AdmissibleSet::of_mode(&model, 0);
        let Some(robust) = robust(&model, &set) else { return Ok(()) };
        for (mass, places) in &values {
            let other = at(&model, *mass, places);
            let record = analyze(&other, &AdmissibleSet::of_mode(&other, 0));
            prop_assert!(record.robust.is_none());
            match robust.hover {
                Certainty::Yes => prop_assert_eq!(record.verdict, HoverVerdict::Controllable),
                Certainty::No => prop_assert_ne!(record.verdict, HoverVerdict::Controllable),
                Certainty::Depends => {}
            }
            let Some(acai) = record.acai else { continue };
            if let Some(worst) = robust.acai_worst {
                prop_assert!(acai >= worst - 1e-7, "{acai} {robust:?}");
            }
            if let Some(best) = robust.acai_best {
                prop_assert!(acai <= best + 1e-7, "{acai} {robust:?}");
            }
        }
    }
}

/// Without intervals on the torque ratios the bounds are reached: at the ends of all intervals.
#[test]
fn bounds_are_reached() {
    let mut model = uncertain(octocopter("PNPNPNPN"), 0.05, 0.08, 0.0);
    model.modes = [[1, 2], [1, 3], [2, 7]].iter().map(|pair| lost(&model, pair)).collect();
    for i in 0..3 {
        let found = robust(&model, &AdmissibleSet::of_mode(&model, i)).unwrap();
        let acai = |mass: f64, thrust: f64| {
            let other = at(&model, mass, &[(thrust, 0.0); 8]);
            analyze(&other, &AdmissibleSet::of_mode(&other, i)).acai.unwrap()
        };
        let worst = acai(-1.0, -1.0).min(acai(1.0, -1.0));
        let best = (0..=2000).map(|k| acai(f64::from(k) / 1000.0 - 1.0, 1.0)).fold(f64::NEG_INFINITY, f64::max);
        // Where hover can be out of reach nothing is claimed of the margin.
        assert_eq!(found.acai_worst.is_some(), worst >= 0.0, "{found:?} {worst}");
        assert_eq!(found.acai_best.is_some(), best >= 0.0, "{found:?} {best}");
        assert!(found.acai_worst.is_none_or(|found| (found - worst).abs() < 1e-9), "{found:?} {worst}");
        assert!(found.acai_best.is_none_or(|found| (best - 1e-9..best + 1e-5).contains(&found)), "{found:?} {best}");
    }
}

/// The single loss of PNPNPN hovers on the edge of yaw, whatever its mass; heavy PPNNPPNN can or cannot lift itself.
#[test]
fn three_verdicts() {
    let verdict = |mass: f64, share: f64| {
        let mut model = octocopter("PPNNPPNN");
        model.modes.push(lost(&model, &[1]));
        model.vehicle.mass = mass;
        model.vehicle.mass_spread = about(share);
        robust(&model, &AdmissibleSet::of_mode(&model, 0)).unwrap().hover
    };
    // It lifts 3.442 kg.
    assert_eq!(verdict(3.0, 0.1), Certainty::Yes);
    assert_eq!(verdict(3.2, 0.1), Certainty::Depends);
    assert_eq!(verdict(3.7, 0.1), Certainty::Depends);
    assert_eq!(verdict(3.9, 0.1), Certainty::No);
    // A flat set whose plane turns with the torque ratios holds nothing for sure; one tied to thrust alone neither.
    let mut quad = uncertain(quadcopter(), 0.0, 0.0, 0.05);
    quad.modes.push(lost(&quad, &[1]));
    assert!(guaranteed(&quad, &AdmissibleSet::of_mode(&quad, 0)).is_none());
    assert_eq!(robust(&quad, &AdmissibleSet::of_mode(&quad, 0)).unwrap().hover, Certainty::No);
}

/// By how much hover alone is worse for not knowing the drag: known in closed form on a ring of alternating spins.
/// With T spread evenly, yaw can be held while (kappa - delta) times the thrust left over exceeds delta T.
#[test]
fn torque_ratios_cost_yaw_in_proportion_to_thrust() {
    let model = uncertain(ring_model("PNPN", 1.0, [0.01; 3], 1e-5, 1.6e-7, 800.0), 0.0, 0.0, 0.1);
    let set = AdmissibleSet::healthy(&model);
    let yaw = Wrench::new(0.0, 0.0, 0.0, 1.0);
    let nominal = set.polytope.chord(&set.hover, &yaw, 1e-9).unwrap().1;
    let sure = guaranteed(&model, &set).unwrap().chord(&set.hover, &yaw, 1e-9).unwrap().1;
    // All thrust on two rotors: tau_z = kappa T. Of that 10 % of kappa T is not sure.
    let kappa_t = 0.016 * set.hover[0];
    assert!((nominal - kappa_t).abs() < 1e-9 && (sure - 0.9 * kappa_t).abs() < 1e-9, "{nominal} {sure} {kappa_t}");
}

#[test]
fn plans_hold_for_every_value() {
    let mut model = uncertain(paper_case(PlannerKind::Rcp, &[0, 2]), 0.04, 0.05, 0.1);
    model.plan.samples = 60;
    model.plan.time = MissionTime::Fixed(20.0);
    assert_eq!(diagnose(&model), vec![]);
    let plan = |model: &Model| {
        let comparison = run_planners(Problem::of(model).unwrap(), Scope::Plan, None);
        match &comparison.runs[0].outcome {
            PlanOutcome::Planned(plan) => plan.trajectory.clone(),
            other => panic!("{other:?}"),
        }
    };
    let robust = plan(&model);
    let mut certain = model.clone();
    certain.vehicle.mass_spread = Spread::NONE;
    certain.vehicle.rotors.iter_mut().for_each(|r| r.spread = RotorSpread::default());
    let nominal = plan(&certain);
    let mut passed = 0;
    for case in 0..400_u32 {
        // Ends of the intervals in a fixed, uneven order.
        let end = |i: u32| if (case.wrapping_mul(2_654_435_761) >> (i + 7)) & 1 == 1 { 1.0 } else { -1.0 };
        let places: Vec<(f64, f64)> = (0..8).map(|k| (if case % 4 == 0 { end(k) } else { -1.0 }, end(8 + k))).collect();
        let other = at(&model, end(17), &places);
        for mode in [0, 2] {
            let set = AdmissibleSet::of_mode(&other, mode);
            let margin = |trajectory: &mavc::motion::Trajectory| {
                let wrenches = trajectory.node_wrenches(&other.vehicle, &other.environment());
                wrenches.iter().map(|w| set.polytope.margin(w)).fold(f64::INFINITY, f64::min)
            };
            assert!(margin(&robust) > -1e-4, "{}", margin(&robust));
            passed += usize::from(margin(&nominal) < -1e-2);
        }
    }
    assert!(passed > 100, "the nominal plan fails in {passed} of 800");
}

#[test]
fn plans_against_what_is_not_sure_are_refused() {
    let mut model = paper_case(PlannerKind::Rcp, &[0]);
    model.vehicle.mass = 3.3;
    assert_eq!(diagnose(&model), vec![]);
    model.vehicle.mass_spread = about(0.1);
    let found = diagnose(&model);
    assert_eq!(found.iter().map(|d| d.code).collect::<Vec<_>>(), [NOT_ROBUST]);
    assert!(hover(&model)[0] * 1.1 > 3.442 * 9.81);
}
