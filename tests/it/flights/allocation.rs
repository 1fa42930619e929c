//! Allocation against all active sets, the paper's formula, and what is to be given up first.

use super::{between, normal};
use crate::vehicles::{hexacopter, octocopter};
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::allocation::{Bounds, MOST_ROTORS, bounded};
use mavc::admissible::hover;
use mavc::flight::allocate::{Allocator, Belief};
use mavc::model::{Allocation, Model};
use nalgebra::{DMatrix, DVector, Matrix4};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;

/// The minimiser of (1/2)|x|^2 + (1/2) sum_i weight_i (w - B x)_i^2 with x from `least` to 1: every rotor at one of
/// them or free, the free ones by least squares, and the active set whose multipliers have the right signs.
fn by_active_sets(columns: &[Wrench], least: &[f64], w: &Wrench, weights: &Wrench) -> DVector<f64> {
    let n = columns.len();
    let b = DMatrix::from_fn(4, n, |i, k| columns[k][i]);
    let q = DMatrix::from_diagonal(&DVector::from_column_slice(weights.as_slice()));
    let hessian = DMatrix::identity(n, n) + b.transpose() * &q * &b;
    let linear = b.transpose() * &q * w;
    let value = |x: &DVector<f64>| 0.5 * x.dot(&(&hessian * x)) - linear.dot(x);
    let mut best: Option<DVector<f64>> = None;
    for code in 0..3usize.pow(n as u32) {
        let state: Vec<usize> = (0..n).map(|k| code / 3usize.pow(k as u32) % 3).collect();
        let free: Vec<usize> = (0..n).filter(|&k| state[k] == 2).collect();
        let mut x = DVector::from_fn(n, |k, _| [least[k], 1.0, 0.0][state[k]]);
        if !free.is_empty() {
            let right = &linear - &hessian * &x;
            let m = DMatrix::from_fn(free.len(), free.len(), |i, j| hessian[(free[i], free[j])]);
            let solved = m.cholesky().unwrap().solve(&DVector::from_fn(free.len(), |i, _| right[free[i]]));
            free.iter().zip(solved.iter()).for_each(|(&k, v)| x[k] = *v);
        }
        let slope = &hessian * &x - &linear;
        let slack = 1e-9 * (1.0 + linear.amax());
        let holds = (0..n).all(|k| match state[k] {
            0 => slope[k] >= -slack,
            1 => slope[k] <= slack,
            _ => (least[k] - 1e-12..=1.0 + 1e-12).contains(&x[k]),
        });
        if holds && best.as_ref().is_none_or(|b| value(&x) < value(b)) {
            best = Some(x);
        }
    }
    best.expect("a convex program has a minimiser")
}

#[test]
fn bounded_finds_the_minimiser_among_all_active_sets() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let (mut clipped, mut last) = (0, Wrench::zeros());
    for case in 0..300 {
        let n = 4 + case % 3;
        let columns: Vec<Wrench> = (0..n).map(|_| Wrench::from_fn(|_, _| normal(&mut random))).collect();
        // Within reach, at its edge and far out of it.
        let size = [0.3, 1.0, 4.0][case / 3 % 3];
        let w = columns.iter().fold(Wrench::zeros(), |sum, b| sum + b * between(&mut random, -size, 1.0 + size));
        let weights = Wrench::from_fn(|_, _| 10f64.powf(between(&mut random, 0.0, 5.0)));
        // From nothing and from another wrench's multipliers, as in flight.
        let start = if case % 2 == 0 { Wrench::zeros() } else { last };
        // Rotors that may stop, and rotors that may not.
        let least: Vec<f64> = (0..n).map(|_| if case % 5 < 3 { 0.0 } else { between(&mut random, 0.0, 0.4) }).collect();
        let bounds = Bounds { least: &least, most: &[1.0; MOST_ROTORS] };
        let lambda = bounded(&columns, bounds, &w, &weights, start);
        let wanted = by_active_sets(&columns, &least, &w, &weights);
        for (k, b) in columns.iter().enumerate() {
            let share = bounds.clip(k, b.dot(&lambda));
            assert!((share - wanted[k]).abs() < 1e-6, "case {case}, rotor {k}: {share} instead of {}", wanted[k]);
        }
        clipped += usize::from(wanted.iter().zip(&least).any(|(x, least)| x == least || *x == 1.0));
        last = lambda;
    }
    assert!((100..300).contains(&clipped), "{clipped} of the cases meet a bound");
}

/// The wrench that commanded speeds give under a belief.
fn given(model: &Model, belief: &Belief, speeds: &[f64]) -> Wrench {
    let a = Actuation::of(&model.vehicle).effectiveness;
    (0..speeds.len()).fold(Wrench::zeros(), |sum, k| sum + a.column(k) * (belief.capacity[k] * speeds[k] * speeds[k]))
}

#[test]
fn pseudo_inverse_is_the_paper_s_formula_where_nothing_clips() {
    let mut random = Pcg64Mcg::seed_from_u64(9);
    let mut compared = 0;
    for case in 0..200 {
        let model = if case % 2 == 0 { octocopter("PPNNPPNN") } else { hexacopter("PPNNPN") };
        let n = model.vehicle.rotors.len();
        let mut belief = Belief::healthy(n);
        if case % 4 >= 2 {
            belief.capacity.iter_mut().for_each(|c| *c = between(&mut random, 0.3, 1.0));
            belief.capacity[case % n] = 0.0;
        }
        let mut wrench = hover(&model);
        wrench += Wrench::from_fn(|i, _| normal(&mut random) * [2.0, 0.3, 0.3, 0.05][i]);
        // (41) and (42), in squared speeds.
        let a = Actuation::of(&model.vehicle).effectiveness;
        let b = DMatrix::from_fn(4, n, |i, k| a[(i, k)] * belief.capacity[k]);
        let square: Matrix4<f64> = (&b * b.transpose()).fixed_view::<4, 4>(0, 0).into_owned();
        // Rows of force and torque differ by orders of magnitude: the inverse is taken of the scaled matrix.
        let scale = Matrix4::from_diagonal(&square.diagonal().map(|d| 1.0 / d.sqrt()));
        let inverse = scale * (scale * square * scale).try_inverse().unwrap() * scale;
        let squares = b.transpose() * inverse * wrench;
        let full = 874.0 * 874.0;
        if squares.iter().any(|s| !(0.0..=full).contains(s)) {
            continue;
        }
        compared += 1;
        let mut allocator = Allocator::new(&model, Allocation::PseudoInverse);
        allocator.believe(&belief);
        let mut speeds = vec![0.0; n];
        allocator.speeds(&wrench, &mut speeds);
        for (speed, wanted) in speeds.iter().zip(squares.iter()) {
            assert!((speed * speed - wanted).abs() < 1e-9 * full, "{} instead of {wanted}", speed * speed);
        }
        assert!((given(&model, &belief, &speeds) - wrench).amax() < 1e-9);
    }
    assert!(compared > 60, "only {compared} clip nothing");
}

#[test]
fn pseudo_inverse_clips_to_the_speeds_there_are() {
    let model = octocopter("PPNNPPNN");
    let mut allocator = Allocator::new(&model, Allocation::PseudoInverse);
    let mut speeds = vec![0.0; 8];
    allocator.speeds(&Wrench::new(17.0, 20.0, 0.0, 0.0), &mut speeds);
    assert_eq!((speeds[0], speeds[4]), (874.0, 0.0));
}

#[test]
fn within_reach_both_give_what_is_asked() {
    let mut random = Pcg64Mcg::seed_from_u64(2);
    let model = octocopter("PPNNPPNN");
    let full: Vec<Wrench> = (0..8).map(|k| Actuation::of(&model.vehicle).full(k)).collect();
    let mut belief = Belief::healthy(8);
    belief.capacity[2] = 0.0;
    belief.capacity[5] = 0.6;
    for _ in 0..200 {
        // Some rotors between their bounds and none past them: the wrench is in the set.
        let shares: Vec<f64> = (0..8).map(|_| between(&mut random, 0.1, 0.9)).collect();
        let wrench = (0..8).fold(Wrench::zeros(), |sum, k| sum + full[k] * (belief.capacity[k] * shares[k]));
        let mut allocator = Allocator::new(&model, Allocation::Bounded);
        allocator.believe(&belief);
        let mut speeds = vec![0.0; 8];
        allocator.speeds(&wrench, &mut speeds);
        let error = given(&model, &belief, &speeds) - wrench;
        // The price on shares leaves a part of the wrench: least where its weight is large.
        let most = Wrench::new(2e-3, 2e-5, 2e-5, 2e-3);
        assert!((0..4).all(|i| error[i].abs() < most[i]), "{error}");
        assert_eq!(speeds[2], 0.0, "a lost rotor is asked for nothing");
    }
}

#[test]
fn yaw_is_given_up_first() {
    let mut random = Pcg64Mcg::seed_from_u64(4);
    let model = octocopter("PPNNPPNN");
    let belief = Belief::healthy(8);
    let mut allocator = Allocator::new(&model, Allocation::Bounded);
    let mut speeds = vec![0.0; 8];
    for case in 0..200 {
        let sign = if case % 2 == 0 { 1.0 } else { -1.0 };
        // All four rotors of one sense at full speed give 0.42 N m.
        let wrench =
            Wrench::new(17.658 + 2.0 * normal(&mut random), normal(&mut random) * 0.3, normal(&mut random) * 0.3, sign);
        allocator.speeds(&wrench, &mut speeds);
        let got = given(&model, &belief, &speeds);
        for i in 0..3 {
            let most = 1e-3 * [17.658, 1.0, 1.0][i];
            assert!((got[i] - wrench[i]).abs() < most, "{got} for {wrench}");
        }
        assert!(got[3] * sign > 0.1 && got[3] * sign < 0.42, "what yaw there is is given: {}", got[3]);
    }
}

/// Where thrust and roll cannot be had together, roll is kept.
#[test]
fn thrust_is_given_up_before_roll_and_pitch() {
    let model = octocopter("PPNNPPNN");
    let mut allocator = Allocator::new(&model, Allocation::Bounded);
    let mut speeds = vec![0.0; 8];
    let wrench = Wrench::new(50.0, 1.5, -0.5, 0.0);
    allocator.speeds(&wrench, &mut speeds);
    let got = given(&model, &Belief::healthy(8), &speeds);
    assert!((got[1] - 1.5).abs() < 0.01 && (got[2] + 0.5).abs() < 0.01 && got[0] < 49.0, "{got}");
}

/// A rotor stuck at a share of full thrust gives it whatever is asked; the others make up for it.
#[test]
fn stuck_rotors_are_counted_in() {
    let model = octocopter("PPNNPPNN");
    for method in [Allocation::PseudoInverse, Allocation::Bounded] {
        let mut belief = Belief::healthy(8);
        belief.stuck[1] = Some(0.7);
        let mut allocator = Allocator::new(&model, method);
        allocator.believe(&belief);
        let mut speeds = vec![0.0; 8];
        let wrench = hover(&model);
        allocator.speeds(&wrench, &mut speeds);
        // What it turns at is known to whoever reckons with the thrust.
        assert!((speeds[1] - 874.0 * 0.7f64.sqrt()).abs() < 1e-9, "{}", speeds[1]);
        let got = given(&model, &belief, &speeds);
        let near = (0..4).all(|i| (got[i] - wrench[i]).abs() < 1e-3 * [17.658, 1.0, 1.0, 1.0][i]);
        assert!(near, "{method:?}: {got}");
    }
}

#[test]
fn missing_is_what_a_mode_cannot_give() {
    let model = octocopter("PPNNPPNN");
    let allocator = Allocator::new(&model, Allocation::Bounded);
    let mut belief = Belief::healthy(8);
    assert!(allocator.missing(&hover(&model), &belief) < 1e-4);
    // Yaw is left free.
    assert!(allocator.missing(&(hover(&model) + Wrench::new(0.0, 0.0, 0.0, 1.0)), &belief) < 1e-4);
    // All rotors together lift 52.24 N: of 60 N a share of 0.148 is missing.
    let missing = allocator.missing(&Wrench::new(60.0, 0.0, 0.0, 0.0), &belief);
    let most = 8.0 * 8.5485e-6 * 874.0 * 874.0;
    assert!((missing - (60.0 / most - 1.0)).abs() < 1e-4, "{missing}");
    // Without the rotors of one side nothing balances.
    [7, 0, 1].into_iter().for_each(|k| belief.capacity[k] = 0.0);
    assert!(allocator.missing(&hover(&model), &belief) > 0.05);
}

/// The gradient vanishes wherever Newton's method is started and however the weights differ.
#[test]
fn bounded_ends_at_the_minimiser_from_anywhere() {
    let mut random = Pcg64Mcg::seed_from_u64(6);
    for case in 0..3000 {
        let n = 4 + case % 9;
        let columns: Vec<Wrench> = (0..n).map(|_| Wrench::from_fn(|_, _| normal(&mut random))).collect();
        let size = [0.3, 1.0, 4.0][case / 9 % 3];
        let w = columns.iter().fold(Wrench::zeros(), |sum, b| sum + b * between(&mut random, -size, 1.0 + size));
        let weights = Wrench::from_fn(|_, _| 10f64.powf(between(&mut random, 0.0, 8.0)));
        let start = Wrench::from_fn(|_, _| normal(&mut random) * 10f64.powf(between(&mut random, -2.0, 4.0)));
        let least: Vec<f64> = (0..n).map(|_| if case % 4 < 3 { 0.0 } else { between(&mut random, 0.0, 0.9) }).collect();
        let bounds = Bounds { least: &least, most: &[1.0; MOST_ROTORS] };
        let lambda = bounded(&columns, bounds, &w, &weights, start);
        let residual = lambda.component_div(&weights) - w;
        let gradient =
            columns.iter().enumerate().fold(residual, |sum, (k, b)| sum + b * bounds.clip(k, b.dot(&lambda)));
        assert!(gradient.amax() < 1e-9 + 1e-14 * lambda.amax(), "case {case}: {gradient} at {lambda}");
    }
}
