//! The checker's planes against the sets that the planner uses.

use super::Numbers;
use crate::vehicles::{hexacopter, lost, octocopter, quadcopter};
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::model::{Allocation, Model, RotorState, Spread};
use mavc::verify::interval::Interval;
use mavc::verify::sets::{Generators, Plane, innermost, innermost_at_most};

fn excess(planes: &[Plane], w: &Wrench) -> f64 {
    let w: [Interval; 4] = std::array::from_fn(|i| Interval::point(w[i]));
    planes.iter().map(|p| p.violation(&w).middle()).fold(f64::NEG_INFINITY, f64::max)
}

/// Both say the same of wrenches about the boundary, to rounding.
fn assert_same(model: &Model, mode: Option<usize>, reserve: f64, numbers: &mut Numbers) {
    let set = mode.map_or_else(|| AdmissibleSet::healthy(model), |i| AdmissibleSet::of_mode(model, i));
    let set = set.guaranteed(model);
    let kept = set.with_reserve(reserve);
    let mode = mode.map(|i| &model.modes[i]);
    let generators = Generators::new(&model.vehicle, &model.environment(), mode, reserve);
    let planes = generators.planes().unwrap();
    let healthy = AdmissibleSet::healthy(model);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..300 {
        // A direction from hover, as far as the boundary, and a little less or more.
        let scale = healthy.zonotope.scale();
        let mut direction = Wrench::from_fn(|i, _| numbers.unit() * scale[i]);
        for e in &set.polytope.equalities {
            direction -= e.normal * e.normal.dot(&direction) / e.normal.norm_squared();
        }
        let Some((_, far)) = kept.polytope.chord(&set.hover, &direction, 1e-9) else { continue };
        let found = |share: f64| excess(&planes, &(set.hover + direction * (far * share)));
        assert!(found(0.999) < 1e-9, "{}", found(0.999));
        assert!(found(1.001) > 1e-9, "{}", found(1.001));
        assert!(found(1.0).abs() < 1e-9, "{}", found(1.0));
        (inside, outside) = (inside + 1, outside + 1);
    }
    assert!(inside > 200 && outside > 200, "{}: {inside}", set.name);
    let extent = generators.extent();
    let plain = set.allocation == Allocation::Bounded && !model.vehicle.is_uncertain();
    for (axis, range) in extent.iter().enumerate() {
        let n = Wrench::from_fn(|i, _| f64::from(u8::from(i == axis)));
        let shrunk = |n: &Wrench| n.dot(&set.hover) + (1.0 - reserve) * (set.zonotope.support(n) - n.dot(&set.hover));
        if plain {
            assert!((range.high - shrunk(&n)).abs() < 1e-9 && (range.low + shrunk(&-n)).abs() < 1e-9);
            continue;
        }
        // A set that lies within what the rotors give.
        let (low, high) = kept.polytope.chord(&set.hover, &n, 1e-9).unwrap();
        assert!(range.low <= set.hover[axis] + low + 1e-9 && range.high >= set.hover[axis] + high - 1e-9);
    }
}

/// Gives the vehicle intervals on its mass and on its rotors' thrusts and drags.
pub fn doubt(model: &mut Model) {
    let spread = |low, high| Spread { low, high };
    model.vehicle.mass_spread = spread(0.97, 1.04);
    for (k, rotor) in model.vehicle.rotors.iter_mut().enumerate() {
        rotor.spread.full_thrust = spread(0.96, 1.03);
        rotor.spread.idle_thrust = spread(0.9, 1.1);
        if k % 2 == 0 {
            rotor.spread.torque_per_thrust = spread(0.95, 1.04);
        }
    }
}

/// Rotors that may not stop, the pseudo-inverse, intervals, and what goes together of them.
#[test]
fn other_vehicles_sets_are_the_planners() {
    let mut numbers = Numbers(14);
    let idle = |model: &mut Model| model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 200.0);
    let inverted = |model: &mut Model| model.vehicle.allocation = Allocation::PseudoInverse;
    let heavier = |model: &mut Model| model.vehicle.mass_spread = Spread { low: 0.95, high: 1.05 };
    let kinds: [&dyn Fn(&mut Model); 6] = [
        &idle,
        &inverted,
        &doubt,
        &|m| {
            idle(m);
            doubt(m);
        },
        &|m| {
            idle(m);
            inverted(m);
        },
        &|m| {
            inverted(m);
            heavier(m);
        },
    ];
    for change in kinds {
        let mut model = octocopter("PPNNPPNN");
        model.modes = vec![lost(&model, &[3]), lost(&model, &[2]), lost(&model, &[4])];
        model.modes[1].rotors[1] = RotorState::Reduced(0.7);
        model.modes[2].rotors[3] = RotorState::Stuck(0.4);
        change(&mut model);
        for mode in [None, Some(0), Some(1), Some(2)] {
            assert_same(&model, mode, 0.0, &mut numbers);
            assert_same(&model, mode, 0.1, &mut numbers);
        }
    }
}

/// Modes have parallel planes, whatever capacities they leave; the innermost of them say of a wrench what all say.
#[test]
fn innermost_planes_say_what_all_say() {
    let mut numbers = Numbers(21);
    for change in [|_: &mut Model| (), doubt] {
        let mut model = octocopter("PPNNPPNN");
        model.modes = vec![lost(&model, &[3]), lost(&model, &[2]), lost(&model, &[4])];
        model.modes[1].rotors[1] = RotorState::Reduced(0.7);
        model.modes[2].rotors[3] = RotorState::Stuck(0.4);
        change(&mut model);
        let of = |mode: Option<usize>| {
            let mode = mode.map(|i| &model.modes[i]);
            Generators::new(&model.vehicle, &model.environment(), mode, 0.1).planes().unwrap()
        };
        let planes: Vec<Plane> = [None, Some(0), Some(1), Some(2)].into_iter().flat_map(of).collect();
        let all: Vec<&Plane> = planes.iter().collect();
        let inner = innermost(&all);
        let kept: Vec<usize> = (0..planes.len()).filter(|&i| inner[i] == i).collect();
        assert!(kept.len() as u64 <= innermost_at_most(&model.vehicle, 4) && kept.len() < planes.len() / 3, "{kept:?}");
        let scale = AdmissibleSet::healthy(&model).zonotope.scale();
        for _ in 0..300 {
            let wrench: [Interval; 4] = std::array::from_fn(|i| Interval::point(2.0 * numbers.unit() * scale[i]));
            let violation = |i: usize| planes[i].violation(&wrench).high;
            let worst = |members: &[usize]| members.iter().map(|&i| violation(i)).fold(f64::NEG_INFINITY, f64::max);
            assert_eq!(worst(&kept), worst(&(0..planes.len()).collect::<Vec<_>>()));
            assert!((0..planes.len()).all(|i| violation(i) <= violation(inner[i])));
        }
        // A plane that is not one stands for none and is hidden by none.
        let mut broken = planes.clone();
        broken[kept[0]].offset = Interval { low: f64::NAN, high: f64::NAN };
        let inner = innermost(&broken.iter().collect::<Vec<_>>());
        assert!((0..planes.len()).all(|i| (inner[i] == kept[0]) == (i == kept[0])));
    }
}

#[test]
fn sets_are_the_planners() {
    let mut numbers = Numbers(8);
    for mut model in [octocopter("PPNNPPNN"), octocopter("PNPNPNPN"), hexacopter("PPNNPN"), quadcopter()] {
        model.modes = vec![lost(&model, &[1]), lost(&model, &[2])];
        model.modes[0].rotors[0] = RotorState::Reduced(0.6);
        model.modes[1].rotors[1] = RotorState::Stuck(0.3);
        for mode in [None, Some(0)] {
            assert_same(&model, mode, 0.0, &mut numbers);
            assert_same(&model, mode, 0.2, &mut numbers);
        }
    }
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[3]), lost(&model, &[1, 6]), lost(&model, &[4])];
    model.modes[2].rotors[3] = RotorState::Stuck(0.4);
    for mode in 0..3 {
        assert_same(&model, Some(mode), 0.1, &mut numbers);
    }
}

/// A quadcopter without rotor 1 reaches a flat set only: wrenches beside it are outside, however near hover they are.
#[test]
fn flat_sets_have_no_inside() {
    let mut model = quadcopter();
    model.modes = vec![lost(&model, &[1])];
    let set = AdmissibleSet::of_mode(&model, 0);
    let generators = Generators::new(&model.vehicle, &model.environment(), Some(&model.modes[0]), 0.0);
    let planes = generators.planes().unwrap();
    let inside = set.zonotope.generators.iter().fold(Wrench::zeros(), |sum, g| sum + g * 0.5);
    assert!(excess(&planes, &inside).abs() < 1e-12);
    let normal = set.polytope.equalities[0].normal;
    for side in [1.0, -1.0] {
        assert!(excess(&planes, &(inside + normal * (side * 1e-3))) > 1e-6);
    }
    // Along the set it ends where the planner's facets end.
    let direction = set.zonotope.generators[1] - set.zonotope.generators[3] * 0.7;
    let (_, far) = set.polytope.chord(&inside, &direction, 1e-9).unwrap();
    assert!(excess(&planes, &(inside + direction * (far * 0.999))) < 1e-9);
    assert!(excess(&planes, &(inside + direction * (far * 1.001))) > 1e-6);
    // Two rotors leave a plane, which is not decided.
    model.modes = vec![lost(&model, &[1, 2])];
    assert!(Generators::new(&model.vehicle, &model.environment(), Some(&model.modes[0]), 0.0).planes().is_err());
}
