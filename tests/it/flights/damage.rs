//! What a fault does to the path, worked out again from the samples of the flight.

use super::plans::{CASE, THIRD};
use super::{quiet, sortie, staying, strike};
use crate::vehicles::{lost, quadcopter};
use mavc::flight::damage::HEADING_BROKEN;
use mavc::flight::{BrokenLimits, Damage, Flight, Sample, Sortie, fly};
use mavc::model::{AfterFault, Detection, GiveUpYaw, Limit, LimitKind, Model, Strike};
use mavc::source::Span;
use nalgebra::Vector3;

/// The instants of a flight: time, distance, height below the reference, position, speed, tilt, heading error.
struct Seen {
    t: f64,
    error: f64,
    drop: f64,
    position: Vector3<f64>,
    speed: f64,
    tilt: f64,
    heading: f64,
}

fn flown(model: &Model, strikes: &[Strike]) -> (Flight, Vec<Seen>) {
    let mut all = Vec::new();
    let mut look = |s: &Sample| {
        let off = s.body.position - s.reference.position;
        let position = s.body.position;
        let (speed, tilt) = (s.body.velocity.norm(), s.body.up().z.acos());
        all.push(Seen {
            t: s.time,
            error: off.norm(),
            drop: -off.z,
            position,
            speed,
            tilt,
            heading: s.heading.error(),
        });
    };
    let flight = fly(&Sortie::along(model, &CASE.1, strikes, 1), Some(&mut look));
    (flight, all)
}

fn limit(kind: LimitKind, upper: f64) -> Limit {
    Limit { kind, lower: None, upper: Some(upper), span: Span::default(), volume: None, leg: None }
}

fn case(change: impl FnOnce(&mut Model)) -> Model {
    let mut model = CASE.0.clone();
    change(&mut model);
    model
}

/// When the plan reaches each waypoint, s.
fn times() -> Vec<f64> {
    CASE.1.waypoint_nodes.iter().map(|&node| CASE.1.times[node]).collect()
}

#[test]
fn damage_is_that_of_the_samples_since_the_fault() {
    let at = 5.0;
    let model = case(|model| {
        model.simulation.detection = Detection::Never;
        // Tolerances of which some are kept: no waypoint is met to 5 cm.
        model.mission.as_mut().unwrap().waypoints.iter_mut().for_each(|waypoint| waypoint.within = 0.6);
        // Limits that hold well, that are broken, and that are exceeded by less than counts.
        model.mission.as_mut().unwrap().limits =
            vec![limit(LimitKind::Speed, 50.0), limit(LimitKind::Tilt, 0.05), limit(LimitKind::Z, 17.53)];
    });
    let (flight, seen) = flown(&model, &[strike(THIRD, at)]);
    let after = || seen.iter().filter(|s| s.t >= at);
    let most = |of: fn(&Seen) -> f64| after().map(of).fold(0.0, f64::max);
    assert_eq!((flight.damage.max_error, flight.damage.max_drop), (most(|s| s.error), most(|s| s.drop)));
    assert!(flight.damage.max_error > 0.3 && flight.damage.max_drop > 0.0, "{flight:?}");
    assert!(most(|s| s.speed) < 50.0 && most(|s| s.tilt) > 0.05 + 0.1 + 1e-6);
    let high = most(|s| s.position.z);
    assert!(high > 17.53 && high < 17.63, "{high}");
    assert_eq!(flight.damage.limits.text(), "tilt");
    assert_eq!(flight.damage.heading_broken, most(|s| s.heading.abs()) > HEADING_BROKEN);
    // Waypoints: the nearest sample between the middles of the legs before and after.
    let times = times();
    let waypoints = &model.mission.as_ref().unwrap().waypoints;
    let missed = |k: usize| {
        let begin = if k == 0 { 0.0 } else { 0.5 * (times[k - 1] + times[k]) };
        let end = times.get(k + 1).map_or(f64::INFINITY, |next| 0.5 * (times[k] + next));
        let place = Vector3::from(waypoints[k].position);
        let near = seen.iter().filter(|s| s.t > begin && s.t <= end).map(|s| (s.position - place).norm());
        near.fold(f64::INFINITY, f64::min) > waypoints[k].within + 1e-5
    };
    let due: Vec<usize> = (0..times.len()).filter(|&k| times[k] >= at).collect();
    let count = due.iter().filter(|&&k| missed(k)).count();
    assert_eq!((flight.damage.waypoints_due, flight.damage.waypoints_missed), (due.len(), count));
    assert!(count > 0 && count < due.len(), "{count} of {}", due.len());
}

#[test]
fn a_healthy_flight_is_judged_from_its_start_and_keeps_the_path() {
    let (flight, seen) = flown(&CASE.0, &[]);
    let Damage { waypoints_due, waypoints_missed, max_error, heading_broken, limits, .. } = flight.damage;
    assert_eq!((waypoints_due, heading_broken), (times().len(), false));
    // A plan may use all of a tolerance, so that a flight misses the waypoint by its tracking error.
    assert!(waypoints_missed <= 2, "{:?}", flight.damage);
    assert_eq!((max_error, limits), (flight.max_error, BrokenLimits::default()));
    assert!(seen.len() > 1000);
}

/// A vehicle that is lost misses every waypoint that was still to come; one that stops on purpose gives them up.
#[test]
fn waypoints_after_a_loss_are_missed_and_those_after_a_stop_are_not_due() {
    let at = 5.0;
    let later = times().iter().filter(|t| **t >= at).count();
    let dead = case(|model| {
        model.modes = vec![lost(model, &[1, 2, 3, 4, 5])];
        model.simulation.detection = Detection::Never;
    });
    let (flight, _) = flown(&dead, &[strike(0, at)]);
    assert!(flight.outcome.is_lost(), "{flight:?}");
    let Damage { waypoints_due, waypoints_missed, .. } = flight.damage;
    // The one whose turn it is when the fault strikes may be met before the vehicle has fallen far.
    assert!(waypoints_due == later && waypoints_missed + 1 >= later, "{flight:?}");
    let stops = case(|model| {
        model.simulation.detection = Detection::After(2.0);
        model.simulation.after_fault = AfterFault::Hold;
    });
    let (flight, _) = flown(&stops, &[strike(THIRD, at)]);
    let before = times().iter().filter(|t| (at..=7.0 + 2e-3).contains(*t)).count();
    assert!(before > 0 && flight.damage.waypoints_due == before, "{before} {flight:?}");
}

/// A quadcopter without a rotor turns: that breaks the heading unless yaw has been given up on purpose before.
#[test]
fn the_heading_is_not_judged_once_yaw_is_given_up() {
    let plan = staying([0.0, 0.0, 50.0], 0.0, 5.0);
    for (word, broken) in [(GiveUpYaw::WhereNeeded, false), (GiveUpYaw::Never, true)] {
        let mut model = quiet(quadcopter());
        model.modes = vec![lost(&model, &[2])];
        model.simulation.detection = Detection::After(0.02);
        model.plan.without_yaw = word;
        let strikes = [strike(0, 1.0)];
        let flight = fly(&sortie(&model, &plan, &strikes), None);
        assert_eq!(flight.damage.heading_broken, broken, "{flight:?}");
        assert!(flight.heading.max_after > HEADING_BROKEN && flight.damage.waypoints_due == 0);
    }
}
