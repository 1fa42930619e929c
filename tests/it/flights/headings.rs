//! Heading errors: what is measured, when heading counts as lost, and what counts then.

use super::{quiet, seen, sortie, staying, strike, turned};
use crate::vehicles::{lost, octocopter, quadcopter};
use mavc::flight::body::Body;
use mavc::flight::heading::{DEFINED_UP_TO, Heading, Patience, wrapped};
use mavc::flight::{Cause, Outcome, Sample, Sortie, fly};
use mavc::model::{Controller, Detection, GiveUpYaw, LostYaw, Model, RotorState};
use mavc::motion::{X, Y, YAW};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const PLACE: [f64; 3] = [0.0, 0.0, 10.0];

fn with_attitude(roll: f64, pitch: f64, yaw: f64) -> Body {
    Body { attitude: turned(roll, pitch, yaw), ..Body::at_rest(Vector3::zeros(), 0.0) }
}

/// The direction of body x from above, whatever roll and pitch.
#[test]
fn heading_is_where_the_nose_points_seen_from_above() {
    for (roll, pitch, yaw) in [(0.0, 0.0, 2.0), (0.7, -0.9, -3.0), (-1.2, 0.4, 0.5), (0.2, 1.3, 1.0)] {
        let body = with_attitude(roll, pitch, yaw);
        let nose = body.rotation() * Vector3::x();
        assert!((body.heading() - yaw).abs() < 1e-12);
        assert!((body.heading() - nose.y.atan2(nose.x)).abs() < 1e-12);
        assert!((body.heading() - body.angles()[2]).abs() < 1e-12);
    }
}

#[test]
fn errors_are_within_half_a_turn_and_turns_are_counted() {
    let mut heading = Heading::default();
    // Three turns clockwise, against a plan that turns the other way once, past plus and minus half a turn.
    for i in 0..=3000 {
        let s = f64::from(i) / 3000.0;
        heading.look(&with_attitude(0.3, 0.2, wrapped(0.4 - 3.0 * TAU * s)), TAU * s);
        let due = 0.4 - 4.0 * TAU * s;
        assert!((heading.turned() - due).abs() < 1e-9, "{} {due}", heading.turned());
        assert!(heading.error().abs() <= PI && (heading.error() - wrapped(due)).abs() < 1e-9);
    }
    assert_eq!([wrapped(3.0 * PI - 0.1), wrapped(-0.5)].map(|x| (x * 1e9).round() / 1e9), [3.041592654, -0.5]);
}

/// A nose that swings over the vertical points backward: what was known before is kept.
#[test]
fn near_ninety_degrees_of_tilt_the_last_error_is_kept() {
    let mut heading = Heading::default();
    heading.look(&with_attitude(0.0, DEFINED_UP_TO - 1e-6, 0.3), 0.0);
    assert!((heading.error() - 0.3).abs() < 1e-9);
    for pitch in [DEFINED_UP_TO + 1e-6, FRAC_PI_2, 2.0, PI] {
        heading.look(&with_attitude(0.0, pitch, 1.0), 0.0);
        assert!((heading.error() - 0.3).abs() < 1e-9, "{pitch}");
    }
    heading.look(&with_attitude(0.0, 0.1, 0.5), 0.0);
    assert!((heading.error() - 0.5).abs() < 1e-9);
}

/// When the patience of 1 s with 90 degrees ends for a heading error that is given over time.
fn over_at(error: impl Fn(f64) -> f64) -> Option<f64> {
    let mut patience = Patience::new(LostYaw::Beyond(FRAC_PI_2), 1.0);
    (0..10_000).map(|i| f64::from(i) * 2e-3).find(|t| patience.is_over(wrapped(error(*t)), 2e-3))
}

#[test]
fn a_heading_is_lost_when_it_was_off_for_longer_than_a_second() {
    assert_eq!(over_at(|_| 1.5), None);
    let lasting = over_at(|t| if t > 3.0 { 1.6 } else { 0.0 }).unwrap();
    assert!((lasting - 4.0).abs() < 0.01, "{lasting}");
    // 0.9 s off, then right for longer than a second: forgiven, again and again.
    assert_eq!(over_at(|t| if t % 2.1 < 0.9 { 2.0 } else { 0.0 }), None);
}

/// Whoever spins points the right way once a turn: slow or fast, that does not count as kept.
#[test]
fn spinning_is_no_way_to_keep_a_heading() {
    for period in [0.05, 0.3, 1.0, 1.9, 2.1, 3.0, 3.9, 5.0, 10.0] {
        let at = over_at(|t| TAU * t / period).unwrap_or_else(|| panic!("a turn in {period} s goes unnoticed"));
        assert!(at < f64::max(4.0, period), "{period} s: {at}");
    }
}

/// A hexacopter's or octocopter's loss that leaves no torque about the vertical: it holds its place and spins.
fn spinning() -> Model {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.simulation.detection = Detection::After(0.1);
    model.modes = vec![lost(&model, &[1, 2])];
    model.plan.without_yaw = GiveUpYaw::Never;
    model
}

#[test]
fn a_vehicle_that_keeps_its_place_and_spins_is_lost_by_heading() {
    let mut model = spinning();
    let plan = staying(PLACE, 0.5, 30.0);
    let strikes = [strike(0, 2.0)];
    let flight = fly(&sortie(&model, &plan, &strikes), None);
    let Outcome::Lost { at, cause: Cause::Heading, .. } = flight.outcome else { panic!("{flight:?}") };
    assert!(at > 3.0 && at < 15.0 && flight.max_error < 1.0 && flight.max_tilt < 1.0, "{flight:?}");
    assert!(!flight.outcome.is_survived() && flight.heading.max > FRAC_PI_2 && flight.heading.max <= PI);
    assert_eq!(flight.heading.max, flight.heading.max_after);
    // The old meaning, on request: the same flight goes on to its end.
    model.simulation.lost_yaw = LostYaw::Off;
    let (flight, all) = seen(&sortie(&model, &plan, &strikes), |s: &Sample| (s.time, s.heading, s.body.rates.z));
    assert_eq!(flight.outcome, Outcome::Flown);
    // Counted once more, from the rate about a vertical that it keeps.
    let turned: f64 = all.windows(2).map(|pair| 0.5 * (pair[0].2 + pair[1].2) * (pair[1].0 - pair[0].0)).sum();
    let last = all.last().unwrap().1.turned();
    assert!((last - turned).abs() < 0.05 * turned.abs() + 0.5, "{last} {turned}");
    assert!(flight.heading.turns >= 8 && flight.heading.turns == (last.abs() / TAU) as usize, "{flight:?} {last}");
    let squares: f64 = all.iter().map(|(_, heading, _)| heading.error().powi(2)).sum();
    assert!((flight.heading.rms - (squares / all.len() as f64).sqrt()).abs() < 0.01, "{flight:?}");
    // Angle and time are the spec's.
    (model.simulation.lost_yaw, model.simulation.lost_yaw_after) = (LostYaw::Beyond(0.1), 0.2);
    let strict = fly(&sortie(&model, &plan, &strikes), None);
    assert!(
        matches!(strict.outcome, Outcome::Lost { cause: Cause::Heading, at: soon, .. } if soon < at - 1.0),
        "{strict:?}"
    );
}

/// A second off is allowed in flight; a vehicle that points away when the flight ends has not kept its heading.
#[test]
fn a_heading_that_is_off_at_the_end_is_lost() {
    let model = spinning();
    let plan = staying(PLACE, 0.5, 30.0);
    let strikes = [strike(0, 2.0)];
    let (_, all) = seen(&sortie(&model, &plan, &strikes), |s: &Sample| (s.time, s.heading.error().abs()));
    let away = all.iter().find(|(_, error)| *error > 1.6).unwrap().0;
    let flown = |duration: f64| fly(&Sortie { duration, ..sortie(&model, &plan, &strikes) }, None);
    let flight = flown(away);
    let Outcome::Lost { at, cause: Cause::Heading, at_end: true } = flight.outcome else { panic!("{flight:?}") };
    assert!((at - away).abs() < 0.01, "{at} {away}");
    assert_eq!(flown(away - 0.2).outcome, Outcome::Flown);
}

/// Both controllers keep the plan's heading where the vehicle tilts and turns at once.
#[test]
fn a_sound_vehicle_keeps_its_heading() {
    for controller in [Controller::Geometric, Controller::Pd] {
        let mut model = quiet(quadcopter());
        model.simulation.controller = controller;
        let mut plan = staying(PLACE, 0.0, 4.0);
        (plan.nodes[0][X][2], plan.nodes[0][Y][2]) = (2.0, 2.0);
        (plan.nodes[0][X][1], plan.nodes[0][Y][1]) = (-4.0, -4.0);
        plan.nodes[0][YAW] = [0.0, 0.6, 0.0, 0.0, 0.0];
        plan.nodes[1] = plan.within(0, 4.0);
        let flight = fly(&sortie(&model, &plan, &[]), None);
        assert!(flight.max_tilt > 0.25, "{flight:?}");
        assert!(flight.heading.max < 2f64.to_radians(), "{controller:?} {flight:?}");
        assert_eq!((flight.heading.turns, flight.heading.max_after), (0, 0.0));
    }
}

/// Numbers that are finite but turn the vehicle over within a step are no flight, and nothing of them is recorded.
#[test]
fn an_integration_that_breaks_down_is_neither_lost_nor_survived() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.modes = vec![lost(&model, &[3])];
    model.modes[0].rotors[2] = RotorState::Reduced(0.85);
    for inertia in [1e-9, 1e-10, 1e-12, 1e-14] {
        model.vehicle.inertia = [inertia; 3];
        let plan = staying(PLACE, 0.0, 4.0);
        let strikes = [strike(0, 1.0)];
        let (flight, all) = seen(&Sortie { seed: 3, ..sortie(&model, &plan, &strikes) }, |s: &Sample| {
            let numbers = s.body.position.iter().chain(&s.body.velocity).chain(&s.body.rates).chain(s.wrench.iter());
            let numbers = numbers.chain(s.wanted.iter()).chain(s.speeds).chain(s.estimated).chain(s.believed);
            (s.time, numbers.fold(0.0, |most: f64, x| if x.is_finite() { most.max(x.abs()) } else { f64::INFINITY }))
        });
        let Outcome::Diverged { at } = flight.outcome else { panic!("{inertia}: {flight:?}") };
        assert!(!flight.outcome.is_lost() && !flight.outcome.is_survived());
        assert!((1.0..1.1).contains(&at) && flight.end == at, "{inertia}: {flight:?}");
        let (last, most) = *all.last().unwrap();
        assert!(last < at && last > at - 0.01 && most < 1e5, "{inertia}: {last} {most}");
        assert!(flight.max_error < 1.0 && flight.rms_error.is_finite(), "{flight:?}");
    }
}
