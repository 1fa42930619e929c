//! Flights in which yaw is given up on purpose.

use super::{seen, sortie, staying, strike};
use crate::vehicles::{lost, ring_model};
use mavc::flight::capture::{SEEDS, captures};
use mavc::flight::{Cause, Flight, Outcome};
use mavc::model::{AfterFault, Detection, Model, Spread, YawDrag};
use nalgebra::Vector3;

const DRAG: YawDrag = YawDrag { linear: 2.75e-3, spread: Spread::NONE, quadratic: 0.0 };

fn without(layout: &str, rotors: &[usize], delay: f64) -> Model {
    let mut model = match layout.len() {
        4 => ring_model(layout, 1.32, [0.0128, 0.0128, 0.0239], 9.9865e-6, 1.5978e-7, 840.0),
        _ => ring_model(layout, 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0),
    };
    model.vehicle.yaw_drag = Some(DRAG);
    model.modes.push(lost(&model, rotors));
    model.simulation.detection = Detection::After(delay);
    model.simulation.after_fault = AfterFault::Continue;
    model.simulation.lost_beyond = 30.0;
    (model.simulation.gyroscope_noise, model.simulation.position_noise) = (0.0, 0.0);
    model
}

/// Hovers for `duration` s at 40 m and loses rotors after 1 s. Also gives the height lost, the last distance from the
/// place (m) and the last rates (rad/s).
fn hover(model: &Model, duration: f64) -> (Flight, f64, f64, Vector3<f64>) {
    let place = Vector3::new(0.0, 0.0, 40.0);
    let trajectory = staying(place.into(), 0.0, duration);
    let strikes = [strike(0, 1.0)];
    let (flight, all) = seen(&sortie(model, &trajectory, &strikes), |s| (s.body.position, s.body.rates));
    let lowest = all.iter().map(|(p, _)| p.z).fold(f64::INFINITY, f64::min);
    let (at, rates) = all[all.len() - 1];
    (flight, 40.0 - lowest, (at - place).norm(), rates)
}

/// Every double loss that is interior without yaw, and every single one: the vehicle stays, with whatever heading.
#[test]
fn hexacopters_stay_where_they_are() {
    let cases: [(&str, &[usize], f64); 4] =
        [("PNPNPN", &[1], 0.2), ("PNPNPN", &[1, 4], 0.2), ("PNPNPN", &[1, 3], 0.6), ("PPNNPN", &[5], 0.2)];
    for (layout, rotors, near) in cases {
        let (flight, height, away, _) = hover(&without(layout, rotors, 0.05), 12.0);
        assert_eq!(flight.outcome, Outcome::Flown, "{layout} {rotors:?}");
        assert_eq!(flight.gave_up_yaw_at.map(|at| (at * 1000.0).round()), Some(1050.0), "{layout} {rotors:?}");
        assert!(height < near && away < 0.02, "{layout} {rotors:?}: {height} {away}");
    }
}

/// The table of docs/flight.md: the height that a quadcopter loses until it climbs again, by delay. Other code, with
/// another controller, lost 1.2, 4.5, 7.8, 9.9 and 11.7 m.
#[test]
fn a_quadcopter_is_captured_at_the_cost_of_height() {
    for (delay, expected, other) in
        [(0.02, 0.27, 1.2), (0.05, 1.87, 4.5), (0.1, 6.07, 7.8), (0.15, 7.66, 9.9), (0.2, 9.05, 11.7)]
    {
        let (flight, height, away, rates) = hover(&without("PNPN", &[1], delay), 16.0);
        assert_eq!(flight.outcome, Outcome::Flown, "{delay}");
        assert!((height - expected).abs() < 0.06 && height < other, "{delay}: {height}");
        assert!(away < 0.02, "{delay}: {away}");
        // It spins, about an axis that is tilted from z towards the lost rotor's.
        assert!((25.0..34.9).contains(&rates.z) && rates.xy().norm() / rates.z > 0.05, "{delay}: {rates}");
    }
}

/// Rotors of one vehicle that are alike up to a turn or a reflection cost the same height. The X frame has two parallel
/// edges among its possible torques, between which many discs are the largest.
#[test]
fn rotors_that_are_alike_cost_the_same_height() {
    let spec = mavc::compile(include_str!("../../../examples/parcel_quad.mav")).into_result().unwrap();
    let mut model = spec.model().clone();
    model.modes = (1..=4).map(|rotor| lost(&model, &[rotor])).collect();
    model.simulation.detection = Detection::After(0.1);
    (model.simulation.after_fault, model.simulation.lost_beyond) = (AfterFault::Continue, 30.0);
    (model.simulation.gyroscope_noise, model.simulation.position_noise) = (0.0, 0.0);
    let trajectory = staying([0.0, 0.0, 40.0], 0.0, 6.0);
    let lowest = |mode| {
        let strikes = [strike(mode, 1.0)];
        let (flight, heights) = seen(&sortie(&model, &trajectory, &strikes), |s| s.body.position.z);
        assert_eq!(flight.outcome, Outcome::Flown);
        heights.into_iter().fold(f64::INFINITY, f64::min)
    };
    let heights = [0, 1, 2, 3].map(lowest);
    assert!(heights.iter().all(|z| (z - heights[0]).abs() < 1e-4), "{heights:?}");
}

/// A gyroscope that ends below the spin: the controller is misled, and the report says so.
#[test]
fn a_gyroscope_that_ends_below_the_spin_is_told() {
    let mut model = without("PNPN", &[1], 0.02);
    assert_eq!(hover(&model, 10.0).0.gyroscope_saturated, 0.0);
    model.simulation.gyroscope_range = 10.0;
    let (flight, ..) = hover(&model, 10.0);
    assert!(flight.gyroscope_saturated > 1.0, "{flight:?}");
}

/// Two opposite rotors lost: torques about one axis alone, which the spin carries around. The vehicle stays.
#[test]
fn without_two_opposite_rotors_the_vehicle_stays() {
    for (rotors, delay) in [([1, 3], 0.05), ([2, 4], 0.1)] {
        let (flight, height, away, rates) = hover(&without("PNPN", &rotors, delay), 20.0);
        assert_eq!(flight.outcome, Outcome::Flown);
        assert!(height < 0.4 && away < 0.05 && flight.max_tilt < 0.1, "{height} {away} {flight:?}");
        // It turns ever faster until the drag balances the torque of the two rotors.
        assert!(rates.z.abs() > 60.0, "{rates}");
    }
}

/// The shipped quadcopter survives the loss of a rotor above the height that `mavc analyze --capture` names, and is
/// lost below it.
#[test]
fn the_height_named_decides() {
    let spec = mavc::compile(include_str!("../../../examples/parcel_quad.mav")).into_result().unwrap();
    let mut model = spec.model().clone();
    model.modes.truncate(1);
    let cases = captures(&model);
    let case = cases.iter().find(|c| (c.speed_m_per_s, c.delay_s) == (0.0, 0.1) && c.lag_s == 0.02).unwrap();
    let ([_, _, most], SEEDS) = (case.height_m.unwrap(), case.regained as u64) else { panic!("{case:?}") };
    model.simulation.detection = Detection::After(0.1);
    (model.simulation.after_fault, model.simulation.lost_beyond) = (AfterFault::Hold, 30.0);
    for (height, survives) in [(most + 0.3, true), (most - 0.7, false)] {
        model.simulation.ground = 40.0 - height;
        let (flight, ..) = hover(&model, 16.0);
        let lost = matches!(flight.outcome, Outcome::Lost { cause: Cause::Ground, .. });
        assert_eq!((flight.outcome == Outcome::Flown, lost), (survives, !survives), "{height} {flight:?}");
    }
}

#[test]
fn with_control_of_yaw_it_is_not_given_up() {
    let (flight, ..) = hover(&without("PPNNPN", &[1], 0.05), 6.0);
    assert_eq!((flight.outcome, flight.gave_up_yaw_at), (Outcome::Flown, None));
    let mut model = without("PNPNPN", &[1], 0.05);
    model.simulation.detection = Detection::Never;
    let (flight, ..) = hover(&model, 3.0);
    assert_eq!(flight.gave_up_yaw_at, None);
}

/// The yaw drag and the momentum of rotors, against angular momentum: a free body without torques.
#[test]
fn the_body_slows_down_by_its_yaw_drag() {
    use mavc::actuation::Wrench;
    use mavc::flight::body::{Body, Frame};
    let quad = without("PNPN", &[1], 0.05);
    let frame = Frame::of(&quad);
    let mut body = Body::at_rest(Vector3::zeros(), 0.0);
    body.rates.z = 30.0;
    let none = Wrench::zeros();
    for _ in 0..1000 {
        body.step(&frame, 1e-3, [&none; 3], &Vector3::zeros());
    }
    let expected = 30.0 * (-2.75e-3_f64 / 0.0239).exp();
    assert!((body.rates.z - expected).abs() < 1e-9, "{}", body.rates.z);

    // With the rotors' momentum h and r = 0 the roll and pitch rates turn at h/J.
    let mut body = Body::at_rest(Vector3::zeros(), 0.0);
    body.rates.x = 0.1;
    let momentum = 0.01;
    for _ in 0..1000 {
        body.step_with(&frame, 1e-3, [&none; 3], [momentum; 3], &Vector3::zeros());
    }
    let angle = momentum / 0.0128;
    assert!((body.rates - Vector3::new(0.1 * angle.cos(), 0.1 * angle.sin(), 0.0)).amax() < 1e-9, "{}", body.rates);
}

/// Rotors that react to new commands: the motion must not depend on the steps of the integration, of which one or eight
/// share a command.
#[test]
fn the_reaction_to_a_command_begins_with_it() {
    let last = |rate: f64| {
        let mut model = without("PNPN", &[1], 0.05);
        model.vehicle.rotors.iter_mut().for_each(|rotor| rotor.inertia = 2e-5);
        (model.simulation.rate, model.simulation.control_rate) = (rate, 500.0);
        let (_, _, _, rates) = hover(&model, 1.6);
        rates
    };
    let [coarse, fine] = [500.0, 4000.0].map(last);
    assert!(coarse.norm() > 1.0 && (coarse - fine).norm() < 1e-5, "{coarse} {fine}");
}
