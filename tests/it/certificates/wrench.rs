//! The checker's wrenches against differences of the attitude, and its pieces against the planner's.

use super::Numbers;
use crate::vehicles::octocopter;
use mavc::certificate::{DynamicModel, MotionRecord, Vertical};
use mavc::model::Vehicle;
use mavc::motion::hover_map::{WrenchMap, YawState};
use mavc::motion::{NodeState, Trajectory};
use mavc::verify::interval::Interval;
use mavc::verify::motion::{Motion, State};
use mavc::verify::wrench::{Dynamics, Wrench};
use nalgebra::{Matrix3, Rotation3, Vector3};

pub const G: f64 = 9.81;

/// Polynomials of degree 5 for x, y, z and of degree 3 for yaw: derivatives at time 0.
pub type Path = [[f64; 6]; 4];

pub fn path(numbers: &mut Numbers) -> Path {
    let mut path = [[0.0; 6]; 4];
    for (axis, derivatives) in path.iter_mut().enumerate() {
        let highest = if axis == 3 { 3 } else { 5 };
        let sizes = [2.0, 2.0, 3.0, 4.0, 8.0, 10.0];
        for (d, size) in derivatives.iter_mut().zip(sizes).take(highest + 1) {
            *d = numbers.unit() * if axis == 3 { 0.4 * size } else { size };
        }
    }
    path
}

pub fn at(path: &Path, t: f64) -> Path {
    path.map(|d| std::array::from_fn(|i| (i..6).rev().fold(0.0, |sum, j| d[j] + sum * t / (j + 1 - i) as f64)))
}

/// Attitude by ZYX angles from the thrust's direction turned back by yaw.
fn attitude(path: &Path, t: f64) -> Matrix3<f64> {
    let now = at(path, t);
    let (s, c) = now[3][0].sin_cos();
    let (ax, ay, lift) = (now[0][2], now[1][2], now[2][2] + G);
    let (forward, left) = (c * ax + s * ay, c * ay - s * ax);
    let (roll, pitch) = ((-left).atan2(forward.hypot(lift)), forward.atan2(lift));
    Rotation3::from_euler_angles(roll, pitch, now[3][0]).into_inner()
}

/// Body rates from differences: [omega] = R' dR/dt.
fn rates(path: &Path, t: f64) -> Vector3<f64> {
    let h = 1e-3;
    let difference = (attitude(path, t - 2.0 * h) - attitude(path, t + 2.0 * h)
        + (attitude(path, t + h) - attitude(path, t - h)) * 8.0)
        / (12.0 * h);
    let m = attitude(path, t).transpose() * difference;
    Vector3::new(m[(2, 1)], m[(0, 2)], m[(1, 0)])
}

pub fn exact_by_differences(path: &Path, vehicle: &Vehicle, t: f64) -> [f64; 4] {
    let h = 1e-3;
    let omega = rates(path, t);
    let turning = (rates(path, t - 2.0 * h) - rates(path, t + 2.0 * h)
        + (rates(path, t + h) - rates(path, t - h)) * 8.0)
        / (12.0 * h);
    let j = Matrix3::from_diagonal(&Vector3::from(vehicle.inertia));
    let tau = j * turning + omega.cross(&(j * omega));
    let now = at(path, t);
    let force = Vector3::new(now[0][2], now[1][2], now[2][2] + G).norm() * vehicle.mass;
    [force, tau[0], tau[1], tau[2]]
}

pub fn state(path: &Path, t: f64) -> State {
    at(path, t).map(|d| d.map(Interval::point))
}

fn assert_close(found: &Wrench, expected: [f64; 4], rate: Option<[f64; 4]>, tolerance: f64) {
    for i in 0..4 {
        let value = found.value[i];
        assert!((value.middle() - expected[i]).abs() < tolerance, "{i}: {value:?} {}", expected[i]);
        assert!(value.high - value.low < 1e-10, "{i}: {value:?} is wide");
        if let Some(rate) = rate {
            assert!(
                (found.rate[i].middle() - rate[i]).abs() < 100.0 * tolerance,
                "{i}: {:?} {}",
                found.rate[i],
                rate[i]
            );
        }
    }
}

#[test]
fn exact_wrenches_are_those_of_the_attitudes_differences() {
    let mut vehicle = octocopter("PPNNPPNN").vehicle;
    vehicle.inertia = [0.03, 0.05, 0.07];
    let dynamics = Dynamics {
        vehicle: &vehicle,
        environment: mavc::model::Environment::vacuum(G),
        model: DynamicModel::Exact,
        one_yaw: None,
    };
    let mut numbers = Numbers(5);
    for _ in 0..200 {
        let path = path(&mut numbers);
        let h = 0.02;
        let around = [-h, h].map(|t| exact_by_differences(&path, &vehicle, t));
        let rate = std::array::from_fn(|i| (around[1][i] - around[0][i]) / (2.0 * h));
        let expected = exact_by_differences(&path, &vehicle, 0.0);
        let turning =
            (0..4).map(|i| (around[1][i] - 2.0 * expected[i] + around[0][i]).abs() / (h * h)).fold(0.0, f64::max);
        // The rate of change by central differences is off by a sixth of h^2 times the third derivative.
        let rate = (turning < 30.0).then_some(rate);
        assert_close(&dynamics.wrench(&state(&path, 0.0)), expected, rate, 2e-4);
    }
}

#[test]
fn hover_wrenches_are_the_planners_map() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(6);
    for k in 0..200 {
        let path = path(&mut numbers);
        let now = at(&path, 0.0);
        let mut planned = NodeState::default();
        for (axis, derivatives) in now.iter().enumerate() {
            planned[axis].copy_from_slice(&derivatives[..5]);
        }
        let [psi, rate, acceleration, ..] = now[3];
        let one_yaw = (k % 2 == 0).then_some(psi + 0.1);
        let map = match one_yaw {
            Some(psi) => WrenchMap::with_free_yaw(&vehicle, G, psi),
            None => WrenchMap::new(&vehicle, G, YawState { psi, rate, acceleration }),
        };
        let dynamics = Dynamics {
            vehicle: &vehicle,
            environment: mavc::model::Environment::vacuum(G),
            model: DynamicModel::Hover,
            one_yaw,
        };
        assert_close(&dynamics.wrench(&state(&path, 0.0)), map.at(&planned).into(), None, 1e-9);
    }
}

fn vertical(model: DynamicModel, z: &[f64; 6]) -> Vertical {
    match model {
        DynamicModel::Hover => Vertical::Hover([z[0], z[1], z[2]]),
        DynamicModel::Exact => Vertical::Exact([z[0], z[1], z[2], z[3], z[4]]),
    }
}

/// Enclosures over a time interval hold every value on it.
#[test]
fn intervals_hold_their_instants() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(7);
    for model in [DynamicModel::Hover, DynamicModel::Exact] {
        let dynamics =
            Dynamics { vehicle: &vehicle, environment: mavc::model::Environment::vacuum(G), model, one_yaw: None };
        for _ in 0..30 {
            let path = path(&mut numbers);
            let ends = [0.0, 0.05].map(|t| at(&path, t));
            let record = MotionRecord {
                times_s: vec![0.0, 0.05],
                x: ends.iter().map(|d| d[0][..5].try_into().unwrap()).collect(),
                y: ends.iter().map(|d| d[1][..5].try_into().unwrap()).collect(),
                z: ends.iter().map(|d| vertical(model, &d[2])).collect(),
                yaw: ends.iter().map(|d| d[3][..3].try_into().unwrap()).collect(),
                waypoint_nodes: vec![0, 1],
            };
            let motion = Motion::new(&record, model, true).unwrap();
            let over = dynamics.wrench(&motion.over(0, Interval::new(0.0, 0.05)));
            for i in 0..=10 {
                let t = 0.005 * f64::from(i);
                let found = dynamics.wrench(&motion.over(0, Interval::point(t)));
                for axis in 0..4 {
                    assert!(over.value[axis].contains(found.value[axis].middle()), "{model:?} {axis} {t}");
                    assert!(over.rate[axis].contains(found.rate[axis].middle()), "{model:?} {axis} {t}");
                }
            }
            if model == DynamicModel::Exact {
                // The record is one polynomial, cut: its end is the next node.
                let gaps = motion.gaps(0);
                assert!(gaps.iter().flatten().all(|gap| *gap < 1e-9), "{gaps:?}");
            }
        }
    }
}

#[test]
fn pieces_are_the_planners() {
    let model = super::hop(mavc::model::PlannerKind::Rip, 8.0);
    let comparison = super::planned(&model);
    let mavc::planner::studies::PlanOutcome::Planned(solved) = &comparison.runs[0].outcome else { panic!("no plan") };
    let trajectory: &Trajectory = &solved.trajectory;
    let certificate = super::certified(&model).unwrap();
    let mavc::certificate::Claim::Plan(claim) = &certificate.claim else { panic!("not of a plan") };
    let motion = Motion::new(&claim.motion, DynamicModel::Hover, true).unwrap();
    for piece in 0..motion.pieces() {
        let h = trajectory.times[piece + 1] - trajectory.times[piece];
        for share in [0.0, 0.3, 1.0] {
            let expected = trajectory.within(piece, share * h);
            let found = motion.over(piece, Interval::point(share * h));
            for axis in 0..4 {
                for order in 0..=motion.order(axis) {
                    let (a, b) = (found[axis][order].middle(), expected[axis][order]);
                    assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{piece} {axis} {order}: {a} {b}");
                }
            }
        }
    }
}
