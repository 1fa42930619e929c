//! The wrench of a motion against rigid bodies that fly it, against geometry, and its derivatives against differences.

use super::rigid::{self, Rigid};
use super::{compared, last, planning, solved, turning, vehicle};
use mavc::actuation::Wrench;
use mavc::flatness::{self, FlatState, INPUTS};
use mavc::flight::body::{Body, Frame};
use mavc::model::{MissionTime, Model, PlannerKind, Vehicle};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, X, Y, YAW, Z};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;

const G: f64 = 9.81;

/// Derivatives of a motion at every time, and the times between which they are smooth.
struct Motion<'a> {
    at: &'a dyn Fn(f64) -> NodeState,
    /// Where to look left of a knot: derivatives that end an interval.
    pieces: Vec<(f64, f64)>,
}

fn place(state: &NodeState, order: usize) -> Vector3<f64> {
    Vector3::new(state[X][order], state[Y][order], state[Z][order])
}

fn thrust(state: &NodeState) -> Vector3<f64> {
    place(state, 2) + Vector3::new(0.0, 0.0, G)
}

fn attitude(state: &NodeState) -> Matrix3<f64> {
    rigid::attitude(thrust(state), state[YAW][0])
}

/// ZYX angles of (4).
fn angles(r: &Matrix3<f64>) -> Vector3<f64> {
    Vector3::new(r[(2, 1)].atan2(r[(2, 2)]), (-r[(2, 0)]).asin(), r[(1, 0)].atan2(r[(0, 0)]))
}

/// How far two rigid bodies end from a motion that begins with body rates `w`, flown open loop by its wrench: the
/// simulator's and [`rigid::step`].
fn misses(vehicle: &Vehicle, motion: &Motion, w: Vector3<f64>) -> [f64; 2] {
    let begin = (motion.at)(motion.pieces[0].0);
    let r = attitude(&begin);
    let frame = Frame {
        mass: vehicle.mass,
        inertia: vehicle.inertia.into(),
        gravity: G,
        drag: Vector3::zeros(),
        yaw_drag: None,
    };
    let quaternion = UnitQuaternion::from_matrix(&r).into_inner();
    let (position, velocity) = (place(&begin, 0), place(&begin, 1));
    let mut body = Body { position, velocity, attitude: quaternion, rates: w };
    let mut other = Rigid::zeros();
    for (i, part) in [position, r.transpose() * velocity, angles(&r), w].into_iter().enumerate() {
        other.fixed_rows_mut::<3>(3 * i).copy_from(&part);
    }
    let mut worst = [0.0f64; 2];
    for &(from, to) in &motion.pieces {
        let steps = ((to - from) / 1e-3).ceil();
        let h = (to - from) / steps;
        for i in 0..steps as usize {
            let begin = from + h * i as f64;
            let wrench = |t: f64| {
                WrenchModel::Exact.wrench(vehicle, &mavc::model::Environment::vacuum(G), &(motion.at)(begin + t))
            };
            body.step(&frame, h, [&wrench(0.0), &wrench(0.5 * h), &wrench(h)], &Vector3::zeros());
            other = rigid::step(vehicle, G, &other, h, &wrench);
            let state = (motion.at)(begin + h);
            let miss = |found: Vector3<f64>| (found - place(&state, 0)).norm();
            let yaw = (body.angles()[2] - state[YAW][0]).sin().abs();
            worst[0] = worst[0].max(miss(body.position)).max(yaw);
            worst[1] = worst[1].max(miss(other.fixed_rows::<3>(0).into())).max((other[8] - state[YAW][0]).sin().abs());
        }
    }
    worst
}

/// A plan's wrench, given to a rigid body, flies the plan.
#[test]
fn a_planned_wrench_flies_its_path() {
    let model = planning(turning(), PlannerKind::Rip, &[], MissionTime::Fixed(8.0));
    let comparison = compared(&model);
    let plan = &solved(last(&comparison)).trajectory;
    let times = &plan.times;
    let pieces = times.windows(2).map(|t| (t[0], t[1])).collect();
    let misses = misses(&model.vehicle, &Motion { at: &|t| plan.at(t), pieces }, Vector3::zeros());
    assert!(misses.iter().all(|m| *m < 1e-6), "{misses:?}");
    let tilts = times.iter().map(|t| angles(&attitude(&plan.at(*t))).xy().norm());
    assert!(tilts.fold(0.0, f64::max) > 0.2, "a plan that does not tilt shows little");
}

/// Sums of two oscillations on each axis: (amplitude, rate, phase), smooth to every order.
type Waves = [[(f64, f64, f64); 2]; 4];

/// The derivatives of (amplitude) sin(rate t + phase), each a quarter turn ahead of the one before.
fn waving(waves: &Waves, t: f64) -> NodeState {
    let of = |axis: usize, order: usize| -> f64 {
        let turn = std::f64::consts::FRAC_PI_2 * order as f64;
        waves[axis].iter().map(|(a, w, phase)| a * w.powi(order as i32) * (w * t + phase + turn).sin()).sum()
    };
    std::array::from_fn(|axis| std::array::from_fn(|order| of(axis, order)))
}

/// Oscillations whose accelerations add up to `most` at the most.
fn waves(most: f64) -> impl Strategy<Value = [(f64, f64, f64); 2]> {
    prop::array::uniform2((0.2..0.5f64, 0.5..3.0f64, 0.0..6.3f64).prop_map(move |(a, w, p)| (a * most / (w * w), w, p)))
}

/// Horizontal accelerations to 12 m/s^2 an axis: tilts of 60 degrees and more.
fn any_waves() -> impl Strategy<Value = Waves> {
    (waves(12.0), waves(12.0), waves(7.0), waves(4.0)).prop_map(|(x, y, z, yaw)| [x, y, z, yaw])
}

fn flat(state: &NodeState) -> FlatState {
    let mut flat = FlatState::zeros();
    for (i, order) in [2, 3, 4].into_iter().enumerate() {
        for axis in [X, Y, Z] {
            flat[3 * i + axis] = state[axis][order];
        }
    }
    flat.fixed_rows_mut::<3>(9).copy_from_slice(&state[YAW][..3]);
    flat
}

/// States of any tilt below 80 degrees of roll and above a tenth of the weight, upright or not.
fn any_state() -> impl Strategy<Value = FlatState> {
    let ranges = [25.0, 25.0, 25.0, 30.0, 30.0, 30.0, 200.0, 200.0, 200.0, 4.0, 3.0, 10.0];
    ranges.map(|r| -r..r).prop_map(FlatState::from).prop_filter("ZYX angles", |s| {
        let (sin, cos) = s[9].sin_cos();
        let (forward, left, up) = (cos * s[0] + sin * s[1], cos * s[1] - sin * s[0], s[2] + G);
        forward.hypot(up) > 0.17 * left.abs() && forward.hypot(up) > 2.0
    })
}

/// The size of each part of a wrench that moves as states of [`any_state`] do.
fn sizes(model: &Model, w: &Wrench) -> Wrench {
    let [a, b, c] = model.vehicle.inertia;
    Wrench::new(model.vehicle.mass * G, 10.0 * a, 10.0 * b, 10.0 * c) + w.abs()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_wrench_of_any_smooth_motion_flies_it(waves in any_waves()) {
        let model = vehicle();
        let at = |t: f64| waving(&waves, t);
        let w = rigid::rates(&|t| attitude(&at(t)), 0.0, 1e-3);
        let found = misses(&model.vehicle, &Motion { at: &at, pieces: vec![(0.0, 2.0)] }, w);
        prop_assert!(found.iter().all(|m| *m < 1e-6), "{:?}", found);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// J w' + w x J w of the attitude that the thrust's direction and psi give, by differences.
    #[test]
    fn the_wrench_is_that_of_the_attitude(state in any_state()) {
        let model = vehicle();
        let part = |i: usize| Vector3::new(state[i], state[i + 1], state[i + 2]);
        let along = |t: f64| {
            let thrust = part(0) + part(3) * t + part(6) * (0.5 * t * t) + Vector3::new(0.0, 0.0, G);
            rigid::attitude(thrust, state[9] + t * (state[10] + 0.5 * t * state[11]))
        };
        let thrust = part(0) + Vector3::new(0.0, 0.0, G);
        // Attitudes turn in about |a| / |a'| s.
        let pace = (part(3).norm() / thrust.norm()).max((part(6).norm() / thrust.norm()).sqrt()).max(3.0);
        let wanted = rigid::wrench(&model.vehicle, &along, thrust, 2e-3 / pace);
        let found = flatness::wrench(&model.vehicle, G, &state);
        let error = (found - wanted).component_div(&sizes(&model, &wanted)).amax();
        prop_assert!(error < 1e-5, "{:e}: {:?} {:?}", error, found, wanted);
    }

    #[test]
    fn jacobian_and_curvature_are_slopes(state in any_state(), n in prop::array::uniform4(-1.0..1.0f64)) {
        let model = vehicle();
        let vehicle = &model.vehicle;
        let (value, slopes) = flatness::wrench_and_jacobian(vehicle, G, &state);
        prop_assert!((value - flatness::wrench(vehicle, G, &state)).amax() <= 1e-12 * value.amax());
        let n = Wrench::from(n);
        let curvature = flatness::curvature(vehicle, G, &state, &n);
        let unit = [1.0, 1.0, 1.0, 3.0, 3.0, 3.0, 20.0, 20.0, 20.0, 0.3, 0.3, 1.0];
        let size = sizes(&model, &value);
        for i in 0..INPUTS {
            let moved = |t: f64| { let mut s = state; s[i] += unit[i] * t; s };
            let by_differences = rigid::slope(|t| flatness::wrench(vehicle, G, &moved(t)), 1e-3);
            let error = (slopes.column(i) * unit[i] - by_differences).component_div(&(size + by_differences.abs())).amax();
            prop_assert!(error < 1e-6, "input {}: {:e}", i, error);
            let along = |t: f64| flatness::wrench_and_jacobian(vehicle, G, &moved(t)).1.transpose() * n;
            let bend = rigid::slope(along, 1e-3);
            for j in 0..INPUTS {
                let scale = unit[j] * n.abs().dot(&size);
                let wanted = bend[j] * unit[j];
                let error = (curvature[(i, j)] * unit[i] * unit[j] - wanted).abs() / (scale / unit[j] + wanted.abs());
                prop_assert!(error < 1e-5, "inputs {} {}: {:e}", i, j, error);
            }
            prop_assert!((curvature.row(i).transpose() - curvature.column(i)).amax() <= 1e-9 * curvature.amax());
        }
    }

    /// Small motions at any heading: half the motion, a quarter of the difference.
    #[test]
    fn small_motions_have_the_wrench_about_hover(state in any_state()) {
        let model = vehicle();
        let apart = |share: f64| {
            let mut node = NodeState::default();
            for (i, order) in [2, 3, 4].into_iter().enumerate() {
                for axis in [X, Y, Z] {
                    node[axis][order] = share * state[3 * i + axis];
                }
            }
            node[YAW] = [state[9], share * state[10], share * state[11], 0.0, 0.0];
            let of = |m: WrenchModel| m.wrench(&model.vehicle, &mavc::model::Environment::vacuum(G), &node);
            prop_assert_eq!(of(WrenchModel::Exact), flatness::wrench(&model.vehicle, G, &flat(&node)));
            Ok((of(WrenchModel::Exact) - of(WrenchModel::HoverFollowing)).component_div(&sizes(&model, &Wrench::zeros())).norm())
        };
        let (coarse, fine) = (apart(2e-3)?, apart(1e-3)?);
        let order = (coarse / fine).log2();
        prop_assert!((order - 2.0).abs() < 0.1, "order {}", order);
        prop_assert!(fine < 1e-3, "{:e}", fine);
    }
}
