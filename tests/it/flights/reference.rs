//! Stops: continued motion, rest at the end, descent.

use mavc::flight::reference::{Course, DESCENT, Reference, Stop};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use nalgebra::Vector3;

const BEGIN: f64 = 3.7;

fn flying() -> Reference {
    Reference {
        position: Vector3::new(1.0, 2.0, 13.0),
        velocity: Vector3::new(6.0, -3.0, 1.0),
        acceleration: Vector3::new(-1.0, 2.0, 0.5),
        jerk: Vector3::new(3.0, -1.0, -2.0),
        snap: Vector3::new(5.0, 5.0, 0.0),
        yaw: [0.7, -0.4, 0.3],
    }
}

fn stop(lands: bool) -> (Stop, Course<'static>) {
    let stop = Stop::from(&flying(), BEGIN, lands, 0.0);
    (stop.clone(), Course::Stop(Box::new(stop)))
}

/// Derivatives are those of the values before them.
fn differs(course: &Course, t: f64) -> f64 {
    let h = 1e-4;
    let (before, at, after) = (course.at(t - h), course.at(t), course.at(t + h));
    let pairs = [
        (before.position, after.position, at.velocity),
        (before.velocity, after.velocity, at.acceleration),
        (before.acceleration, after.acceleration, at.jerk),
        (before.jerk, after.jerk, at.snap),
    ];
    let yaw = |k: usize| ((after.yaw[k] - before.yaw[k]) / (2.0 * h) - at.yaw[k + 1]).abs();
    let off = |(b, a, d): &(Vector3<f64>, Vector3<f64>, Vector3<f64>)| ((a - b) / (2.0 * h) - d).norm();
    pairs.iter().map(off).chain([yaw(0), yaw(1)]).fold(0.0, f64::max)
}

#[test]
fn stops_continue_what_was_flown() {
    let (_, course) = stop(false);
    let (from, to) = (flying(), course.at(BEGIN));
    let parts = |r: &Reference| [r.position, r.velocity, r.acceleration, r.jerk];
    for (a, b) in parts(&from).iter().zip(parts(&to)) {
        assert!((a - b).norm() < 1e-12, "{a} and {b}");
    }
    for k in 0..3 {
        assert!((from.yaw[k] - to.yaw[k]).abs() < 1e-12);
    }
}

#[test]
fn stops_end_at_rest_and_stay() {
    let (stop, course) = stop(false);
    let end = course.at(stop.at_rest());
    for part in [end.velocity, end.acceleration, end.jerk] {
        assert!(part.norm() < 1e-10, "{part}");
    }
    assert!(end.yaw[1].abs() + end.yaw[2].abs() < 1e-10);
    for later in [0.001, 1.0, 50.0] {
        let stays = course.at(stop.at_rest() + later);
        assert!((stays.position - end.position).norm() < 1e-12 && (stays.yaw[0] - end.yaw[0]).abs() < 1e-12);
        assert!(stays.velocity.norm() + stays.acceleration.norm() + stays.jerk.norm() + stays.snap.norm() < 1e-9);
    }
}

#[test]
fn stops_have_the_derivatives_they_say() {
    for lands in [false, true] {
        let (stop, course) = stop(lands);
        for i in 1..200 {
            let t = BEGIN + 0.05 * f64::from(i);
            // A descent begins and ends its easing with a kink in the acceleration, and a stop with one in the snap.
            let kinks = [BEGIN, stop.at_rest(), stop.at_rest() + 2.0];
            if kinks.iter().all(|k| (t - k).abs() > 1e-3) {
                assert!(differs(&course, t) < 1e-5, "{} at {t}, landing {lands}", differs(&course, t));
            }
        }
    }
}

/// From a steady 7 m/s the braking is at most 3 m/s^2.
#[test]
fn stops_brake_as_gently_as_they_should() {
    let steady = Reference { velocity: Vector3::new(7.0, 0.0, 0.0), ..Default::default() };
    let course = Course::Stop(Box::new(Stop::from(&steady, 0.0, false, -10.0)));
    let most = (0..1000).map(|i| course.at(0.005 * f64::from(i)).acceleration.norm()).fold(0.0, f64::max);
    assert!(most <= 3.0 + 1e-9 && most > 2.9, "{most}");
}

#[test]
fn descents_come_to_one_metre_a_second() {
    let (stop, course) = stop(true);
    let rest = course.at(stop.at_rest());
    assert!(rest.velocity.norm() < 1e-10);
    let (a, b) = (course.at(stop.at_rest() + 5.0), course.at(stop.at_rest() + 9.0));
    assert_eq!(DESCENT, 1.0);
    assert!((a.velocity - Vector3::new(0.0, 0.0, -1.0)).norm() < 1e-12 && a.acceleration.norm() < 1e-12);
    assert!((b.position - a.position - Vector3::new(0.0, 0.0, -4.0)).norm() < 1e-10);
    // Coming to speed takes two seconds, in which it goes down by one metre.
    assert!((rest.position.z - course.at(stop.at_rest() + 2.0).position.z - 1.0).abs() < 1e-10);
}

/// The reference has the derivatives of the plan, and is at rest after the plan's end.
#[test]
fn plans_are_followed_to_their_end() {
    let mut left = NodeState::default();
    let mut right = NodeState::default();
    left[X] = [1.0, 2.0, -0.5, 0.3, 0.8];
    left[Y] = [-1.0, 0.5, 0.2, -0.7, 1.1];
    left[Z] = [5.0, 0.4, 0.6, 0.0, 0.0];
    left[YAW] = [0.2, 0.3, -0.1, 0.0, 0.0];
    (right[X][4], right[Y][4], right[Z][2], right[YAW][2]) = (-0.4, 0.2, -0.3, 0.4);
    let ends = Trajectory { times: vec![0.0, 2.0], nodes: vec![left, right], ..broken() };
    let end = ends.within(0, 2.0);
    let plan = Trajectory { nodes: vec![left, end], ..ends };
    let course = Course::Plan(&plan);
    for i in 1..20 {
        assert!(differs(&course, 0.1 * f64::from(i)) < 1e-6);
    }
    let rest = course.at(2.5);
    assert!((rest.position - course.at(2.0).position).norm() < 1e-12);
    assert!(rest.velocity.norm() + rest.acceleration.norm() + rest.jerk.norm() + rest.snap.norm() == 0.0);
    assert_eq!(rest.yaw[1..], [0.0, 0.0]);
}

fn broken() -> Trajectory {
    Trajectory { times: Vec::new(), nodes: Vec::new(), waypoint_nodes: vec![0, 1], model: WrenchModel::HoverFollowing }
}
