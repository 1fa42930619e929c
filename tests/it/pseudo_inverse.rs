//! What the pseudo-inverse (42) gives without clipping: its set against the formula itself, verdicts and plans in it.

use crate::vehicles::{lost, mission, octocopter, paper_case, waypoint};
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::verdict::{HoverVerdict, analyze, analyze_all};
use mavc::admissible::{AdmissibleSet, hover};
use mavc::flight::allocate::{Allocator, Belief};
use mavc::model::RotorState;
use mavc::model::{Allocation, Environment, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

fn pseudo(mut model: Model) -> Model {
    model.vehicle.allocation = Allocation::PseudoInverse;
    model
}

/// `A_theta^+ (w - c)` of (42) by a singular value decomposition; c is what stuck rotors give.
pub fn squares(model: &Model, mode: Option<usize>, w: &Wrench) -> DVector<f64> {
    let a = Actuation::of(&model.vehicle).effectiveness;
    let n = model.vehicle.rotors.len();
    let fault = mode.map(|i| &model.modes[i]);
    let mut rest = *w;
    let b = DMatrix::from_fn(4, n, |i, k| match fault.and_then(|f| f.rotors[k].stuck_at()) {
        Some(share) => {
            if i == 0 {
                rest -= a.column(k) * (share * model.vehicle.rotors[k].max_speed.powi(2));
            }
            0.0
        }
        None => a[(i, k)] * fault.map_or(1.0, |f| f.rotors[k].capacity()),
    });
    // Rows of like size: w lies in the range, so their scale does not matter.
    let scale = DVector::from_fn(4, |i, _| 1.0 / b.row(i).norm().max(1e-300));
    let scaled = DMatrix::from_diagonal(&scale) * &b;
    let wanted = scale.component_mul(&DVector::from_column_slice(rest.as_slice()));
    scaled.pseudo_inverse(1e-9).unwrap() * wanted
}

/// How far the formula stays within the bounds on the squared speeds of working rotors, in shares of full ones.
fn room(model: &Model, mode: usize, w: &Wrench) -> f64 {
    let omega = squares(model, Some(mode), w);
    let fault = &model.modes[mode];
    let rotors = model.vehicle.rotors.iter().enumerate();
    rotors
        .filter(|(k, _)| fault.rotors[*k] != RotorState::Lost && fault.rotors[*k].stuck_at().is_none())
        .map(|(k, r)| {
            let full = r.max_speed.powi(2);
            ((omega[k] - r.min_speed.powi(2)) / full).min(1.0 - omega[k] / full)
        })
        .fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_set_is_where_the_formula_needs_no_clipping(
        ppnn in any::<bool>(),
        capacity in prop::collection::vec(prop_oneof![1 => Just(0.0), 3 => Just(1.0), 2 => 0.2..1.0f64], 8),
        stuck in prop::option::of((0usize..8, 0.0..1.0f64)),
        speeds in prop::collection::vec((0.0..200.0f64, 700.0..900.0f64), 8),
        points in prop::collection::vec(prop::array::uniform8(-0.3..1.3f64), 60),
    ) {
        let mut model = pseudo(octocopter(if ppnn { "PPNNPPNN" } else { "PNPNPNPN" }));
        for (rotor, (low, high)) in model.vehicle.rotors.iter_mut().zip(&speeds) {
            (rotor.min_speed, rotor.max_speed) = (*low, *high);
        }
        let mut mode = lost(&model, &[]);
        mode.rotors = capacity.into_iter().map(RotorState::of_capacity).collect();
        if let Some((k, share)) = stuck {
            mode.rotors[k] = RotorState::Stuck(share);
        }
        model.modes.push(mode);
        let set = AdmissibleSet::of_mode(&model, 0);
        prop_assume!(set.rank == 4);
        let zonotope = &set.zonotope;
        let (bounded, bounded_size) = (zonotope.facets(), zonotope.scale()[0]);
        for shares in &points {
            let w = zonotope.generators.iter().zip(shares).map(|(g, t)| g * *t).sum::<Wrench>() + zonotope.offset;
            let room = room(&model, 0, &w);
            prop_assume!(room.abs() > 1e-6);
            prop_assert_eq!(set.polytope.contains(&w, 0.0), room > 0.0, "{}", room);
            // What needs no clipping is given, so it lies in the zonotope.
            prop_assert!(room < 0.0 || bounded.contains(&w, 1e-9 * bounded_size));
        }
    }
}

/// Margins computed once by an independent program.
#[test]
fn margins_are_those_of_the_formula() {
    let mut model = octocopter("PNPNPNPN");
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    let bounded = analyze_all(&model, &AdmissibleSet::all(&model));
    let clipped = analyze_all(&pseudo(model.clone()), &AdmissibleSet::all(&pseudo(model)));
    for (mode, all) in clipped.iter().zip(&bounded).skip(1) {
        assert!((mode.acai.unwrap() - 0.134).abs() < 5e-4, "{:?}", mode.acai);
        assert!((all.acai.unwrap() - 0.1956).abs() < 5e-5, "{:?}", all.acai);
        assert!(all.unreached_share.is_none());
        assert_eq!(mode.verdict, HoverVerdict::Controllable);
    }
}

/// Facts of the paper's Table 6 that bounded allocation does not have: double losses that the pseudo-inverse loses.
#[test]
fn some_double_losses_hover_only_with_bounded_allocation() {
    let mut model = octocopter("PNPNPNPN");
    let pairs = [[1, 3], [1, 7], [2, 4], [2, 8], [3, 5], [4, 6], [5, 7], [6, 8]];
    model.modes = pairs.iter().map(|p| lost(&model, p)).collect();
    let unclipped = pseudo(model.clone());
    for (i, pair) in pairs.iter().enumerate() {
        assert_eq!(analyze(&model, &AdmissibleSet::of_mode(&model, i)).verdict, HoverVerdict::Controllable);
        let record = analyze(&unclipped, &AdmissibleSet::of_mode(&unclipped, i));
        assert_ne!(record.verdict, HoverVerdict::Controllable, "{pair:?}");
        assert!(record.acai.unwrap() < 0.0 && room(&unclipped, i, &hover(&unclipped)) < 0.0);
        assert!(record.residual4.iter().any(|e| *e != 0.0));
    }
}

#[test]
fn the_share_that_is_unreached_is_what_sampling_finds() {
    let mut model = pseudo(octocopter("PPNNPPNN"));
    model.modes.push(lost(&model, &[1]));
    let set = AdmissibleSet::of_mode(&model, 0);
    let share = analyze(&model, &set).unreached_share.unwrap();
    let bounded = set.zonotope.facets();
    let (scale, offset) = (set.zonotope.scale(), set.zonotope.offset);
    let middle = offset + 0.5 * set.zonotope.generators.iter().sum::<Wrench>();
    // A rank-1 lattice of the box around the set (Korobov): far more even than random points.
    let (mut inside, mut reached) = (0.0, 0.0);
    let points = 200_003_u64;
    for i in 0..points {
        let u = |a: u64| (i.wrapping_mul(a) % points) as f64 / points as f64 - 0.5;
        let w = middle + Wrench::new(u(1), u(76_237), u(49_397), u(118_273)).component_mul(&scale);
        if bounded.contains(&w, 0.0) {
            inside += 1.0;
            reached += f64::from(u8::from(room(&model, 0, &w) >= 0.0));
        }
    }
    let sampled = 1.0 - reached / inside;
    // Three standard deviations of as many random points.
    let width = 3.0 * (share * (1.0 - share) / inside).sqrt();
    assert!(inside > 10_000.0 && (share - sampled).abs() < width, "{share} {sampled} {width}");
    assert!(share > 0.05 && share < 0.95);
}

#[test]
fn flights_clip_nothing_inside_the_set() {
    let mut model = pseudo(octocopter("PPNNPPNN"));
    model.modes.push(lost(&model, &[3]));
    let set = AdmissibleSet::of_mode(&model, 0);
    let mut allocator = Allocator::new(&model, model.vehicle.allocation);
    allocator.believe(&Belief { capacity: model.modes[0].capacities(), stuck: vec![None; 8] });
    let a = Actuation::of(&model.vehicle).effectiveness;
    let given = |allocator: &mut Allocator, w: &Wrench| {
        let mut speeds = [0.0; 8];
        allocator.speeds(w, &mut speeds);
        speeds.iter().enumerate().filter(|(k, _)| *k != 2).map(|(k, s)| a.column(k) * (s * s)).sum::<Wrench>()
    };
    for facet in &set.polytope.facets {
        // Towards the facet from hover, a little before it and a little past it.
        let reach = set.polytope.chord(&set.hover, &facet.normal, 1e-9).unwrap().1;
        let [before, past] = [0.999, 1.001].map(|share| set.hover + facet.normal * (share * reach));
        assert!((given(&mut allocator, &before) - before).norm() < 1e-9);
        assert!((given(&mut allocator, &past) - past).norm() > 1e-6 * reach);
    }
}

#[test]
fn plans_ask_for_nothing_that_is_clipped() {
    let mut model = pseudo(paper_case(PlannerKind::Rcp, &[0, 2]));
    model.plan.samples = 60;
    model.plan.time = MissionTime::Fixed(24.0);
    let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
    let PlanOutcome::Planned(plan) = &comparison.runs[0].outcome else { panic!("{:?}", comparison.runs[0].outcome) };
    for w in plan.trajectory.node_wrenches(&model.vehicle, &model.environment()) {
        for mode in [0, 2] {
            assert!(room(&model, mode, &w) > -1e-5);
        }
        let healthy = squares(&model, None, &w);
        assert!(healthy.iter().all(|s| *s > -1e-5 * 874.0 * 874.0 && *s < (1.0 + 1e-5) * 874.0 * 874.0));
    }
    assert!(plan.outside.iter().all(|o| o.seconds == 0.0));
}

/// Both waypoints 30 m apart: as fast as each allocation allows.
#[test]
fn what_is_given_away_costs_time() {
    let time = |model: &Model| {
        let comparison = run_planners(Problem::of(model).unwrap(), Scope::Plan, None);
        let PlanOutcome::Planned(plan) = &comparison.runs[0].outcome else {
            panic!("{:?}", comparison.runs[0].outcome)
        };
        plan.time
    };
    let mut model = octocopter("PPNNPPNN");
    model.modes.push(lost(&model, &[1]));
    model.mission = Some(mission(vec![waypoint([0.0, 0.0, 0.0], 0.0), waypoint([20.0, 10.0, 15.0], 0.0)]));
    (model.plan.planner, model.plan.against, model.plan.samples) = (PlannerKind::Rcp, vec![0], 40);
    let (bounded, clipped) = (time(&model), time(&pseudo(model.clone())));
    assert!(clipped > bounded + 0.04, "{clipped} {bounded}");
}

/// In drag and wind the formula clips nothing along the plan, at nodes and between them, in any wind of the interval.
#[test]
fn plans_in_air_ask_for_nothing_that_is_clipped() {
    let mut model = pseudo(octocopter("PPNNPPNN"));
    model.modes = vec![lost(&model, &[1]), lost(&model, &[3])];
    let mut flight = mission(vec![waypoint([0.0, 0.0, 5.0], 0.0), waypoint([15.0, 4.0, 7.0], 0.0)]);
    (flight.air.wind, flight.air.wind_spread) = ([5.0, -2.0, 0.3], [1.0, 1.0, 0.0]);
    (model.vehicle.drag, model.mission) = ([0.35; 3], Some(flight));
    (model.plan.planner, model.plan.against, model.plan.samples) = (PlannerKind::Rcp, vec![0, 1], 20);
    (model.plan.model, model.plan.time) = (PlanModel::Exact, MissionTime::Fixed(2.8));
    let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
    let PlanOutcome::Planned(plan) = &comparison.runs[0].outcome else { panic!("{:?}", comparison.runs[0].outcome) };
    let motion = &plan.trajectory;
    let mut least = f64::INFINITY;
    for (k, i) in (0..motion.intervals()).flat_map(|k| (0..=4).map(move |i| (k, i))) {
        let state = motion.within(k, 0.25 * f64::from(i) * (motion.times[k + 1] - motion.times[k]));
        for (x, y) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 0.0), (0.3, -0.7)] {
            let wind = Environment { wind: [5.0 + x, -2.0 + y, 0.3], wind_spread: [0.0; 3], ..model.environment() };
            let w = motion.wrench(&model.vehicle, &wind, &state);
            least = (0..2).map(|mode| room(&model, mode, &w)).fold(least, f64::min);
        }
    }
    // In shares of a rotor's full speed squared.
    assert!(least > -1e-3, "{least}");
    // Bounded allocation gives more, and its plan is clipped by the formula.
    let mut bounded = model.clone();
    bounded.vehicle.allocation = Allocation::Bounded;
    let comparison = run_planners(Problem::of(&bounded).unwrap(), Scope::Plan, None);
    let PlanOutcome::Planned(other) = &comparison.runs[0].outcome else { panic!("{:?}", comparison.runs[0].outcome) };
    let air = model.environment();
    let worst =
        other.trajectory.node_wrenches(&model.vehicle, &air).iter().map(|w| room(&model, 0, w)).fold(1.0, f64::min);
    assert!(worst < -0.01, "{worst}");
}
