//! Whole flights: hover, repetition, and numbers that lead nowhere.

use super::{quiet, seen, sortie, staying, strike};
use crate::vehicles::{lost, octocopter};
use mavc::flight::body::Frame;
use mavc::flight::reference::Course;
use mavc::flight::{Cause, Outcome, Sample, control, fly};
use mavc::model::RotorState;
use mavc::model::{Allocation, Controller, Detection, Model};
use mavc::motion::{X, Y, Z};
use nalgebra::Vector3;

const PLACE: [f64; 3] = [1.0, -2.0, 10.0];

#[test]
fn hover_stays_where_it_is() {
    for controller in [Controller::Pd, Controller::Geometric] {
        for layout in ["PPNNPPNN", "PNPNPNPN"] {
            let mut model = quiet(octocopter(layout));
            model.simulation.controller = controller;
            model.vehicle.allocation = Allocation::PseudoInverse;
            let plan = staying(PLACE, 0.7, 10.0);
            let flight = fly(&sortie(&model, &plan, &[]), None);
            assert_eq!(flight.outcome, Outcome::Flown);
            assert!(flight.max_error < 1e-9 && flight.max_tilt < 1e-9, "{controller:?} {layout}: {flight:?}");
            assert_eq!((flight.end, flight.steps), (10.0, 10_000));
        }
    }
}

/// The bounded allocation pays for shares of full thrust, and so gives a little less than is asked. With shares x
/// alike, its optimum has x = lambda/n and a residual lambda/1e8 of the n rotors' thrust: of that thrust the share
/// n x/1e8 is missing, which feedback on height makes up for where it is low by that share of n rotors' thrust over
/// m K_pz.
#[test]
fn bounded_hover_sinks_by_what_its_price_explains() {
    let model = quiet(octocopter("PPNNPPNN"));
    let plan = staying(PLACE, 0.7, 20.0);
    let (flight, heights) = seen(&sortie(&model, &plan, &[]), |s: &Sample| s.body.position.z - PLACE[2]);
    let full = 8.0 * 8.5485e-6 * 874.0 * 874.0;
    let share = 1.8 * 9.81 / full;
    let wanted = -8.0 * share / 1e8 * full / (1.8 * 6.0);
    let last = *heights.last().unwrap();
    assert!((last / wanted - 1.0).abs() < 1e-3, "{last:e} instead of {wanted:e}");
    assert!(flight.max_error < 2e-7, "{flight:?}");
}

/// A flight that begins in motion has its thrust from the first instant: the wrench is the reference's own.
#[test]
fn flights_begin_with_the_thrust_they_need() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.vehicle.allocation = Allocation::PseudoInverse;
    let mut plan = staying(PLACE, 0.0, 0.5);
    plan.nodes[0][X] = [0.0, 3.0, 2.0, 1.5, 0.0];
    plan.nodes[0][Y] = [0.0, -1.0, 1.0, -2.0, 0.0];
    plan.nodes[0][Z] = [10.0, 0.5, 1.5, 0.0, 0.0];
    (plan.nodes[1][X][4], plan.nodes[1][Z][2]) = (0.0, 1.5);
    plan.nodes[1] = plan.within(0, 0.5);
    let (flight, all) = seen(&sortie(&model, &plan, &[]), |s: &Sample| (*s.wanted, *s.wrench));
    let reference = Course::Plan(&plan).at(0.0);
    let frame = Frame::of(&model);
    let force = (reference.acceleration + Vector3::z() * 9.81).norm();
    let body = control::start(&frame, &reference);
    let own = control::control(Controller::Geometric, &frame, &model.simulation.gains, &body, force, &reference);
    assert!((all[0].0 - own).amax() < 1e-9, "{} instead of {own}", all[0].0);
    assert!((all[0].1 - own).amax() < 1e-9, "{} instead of {own}", all[0].1);
    assert!(flight.max_error < 2e-3, "{flight:?}");
}

/// All that can be seen of a flight, bit by bit.
fn bits(model: &Model, seed: u64) -> (Vec<u64>, String) {
    let plan = staying(PLACE, 0.0, 4.0);
    let strikes = [strike(0, 1.0)];
    let sortie = mavc::flight::Sortie { seed, ..sortie(model, &plan, &strikes) };
    let (flight, samples) = seen(&sortie, |s| {
        let b = s.body;
        let body = b.position.iter().chain(&b.velocity).chain(&b.attitude.coords).chain(&b.rates);
        let rotors = s.wrench.iter().chain(s.wanted).chain(s.speeds).chain(s.believed).chain(s.estimated);
        body.chain(rotors).map(|v| v.to_bits()).collect::<Vec<_>>()
    });
    (samples.concat(), format!("{flight:?}"))
}

#[test]
fn the_same_seed_gives_the_same_flight() {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[3])];
    model.simulation.gusts = 1.0;
    model.simulation.drag = [0.3; 3];
    model.simulation.wind = [3.0, 1.0, 0.0];
    assert_eq!(bits(&model, 5), bits(&model, 5));
    let (one, another) = (bits(&model, 5), bits(&model, 6));
    assert_ne!(one.0, another.0);
    // Noise and gusts differ from the first sample on.
    let first = one.0.len() / 2000;
    assert_ne!(one.0[..2 * first], another.0[..2 * first]);
}

/// Nothing is drawn where nothing is random, so the seed says nothing.
#[test]
fn without_noise_the_seed_says_nothing() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.modes = vec![lost(&model, &[3])];
    assert_eq!(bits(&model, 5), bits(&model, 6));
}

#[test]
fn faults_strike_and_end_when_they_are_said_to() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.simulation.detection = Detection::After(0.1);
    model.modes = vec![lost(&model, &[3])];
    let plan = staying(PLACE, 0.0, 4.0);
    let strikes = [mavc::model::Strike { until: Some(2.5), ..strike(0, 1.0) }];
    let (flight, all) = seen(&sortie(&model, &plan, &strikes), |s: &Sample| (s.time, s.wrench[0], s.believed[2]));
    for (t, thrust, believed) in &all {
        // At the very instants a sample shows what holds from then on.
        assert_eq!(*believed == 0.0, *t > 1.1 - 1e-6 && *t < 2.6 - 1e-6, "{t}: {believed}");
        if *t < 1.0 - 1e-6 {
            assert!((thrust - 17.658).abs() < 1e-3, "{t}: {thrust}");
        }
    }
    let at = |time: f64| all.iter().find(|s| (s.0 - time).abs() < 1e-6).unwrap().1;
    // An eighth of the thrust is gone at once.
    assert!((at(1.0) / 17.658 - 0.875).abs() < 1e-4, "{}", at(1.0));
    assert!((at(4.0 - 0.002) / 17.658 - 1.0).abs() < 0.01, "{}", at(3.998));
    let found = flight.found[0];
    assert!((found.detected_after.unwrap() - 0.1).abs() < 1e-6 && (found.isolated_after.unwrap() - 0.1).abs() < 1e-6);
    assert!(flight.rms_error_after > flight.rms_error && flight.outcome == Outcome::Flown, "{flight:?}");
}

/// The controller acts on the thrust that the rotors give, also where one of them is stuck.
#[test]
fn a_stuck_rotor_that_is_known_disturbs_little() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.simulation.detection = Detection::After(0.1);
    for share in [0.2, 0.6] {
        let mut mode = lost(&model, &[]);
        mode.rotors[2] = RotorState::Stuck(share);
        model.modes = vec![mode];
        let plan = staying(PLACE, 0.0, 8.0);
        let strikes = [strike(0, 2.0)];
        let look = |s: &Sample| ((s.body.position - s.reference.position).norm(), s.speeds[2]);
        let (flight, all) = seen(&sortie(&model, &plan, &strikes), look);
        let (off, speed) = *all.last().unwrap();
        assert!(off < 1e-3 && flight.max_error < 0.1, "stuck at {share}: {off} {flight:?}");
        assert!((speed - 874.0 * share.sqrt()).abs() < 1e-9);
    }
}

#[test]
fn a_vehicle_without_rotors_falls_to_its_end() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    model.modes = vec![lost(&model, &[1, 2, 3, 4, 5, 6, 7, 8])];
    let plan = staying(PLACE, 0.0, 1e4);
    let flight = fly(&sortie(&model, &plan, &[strike(0, 1.0)]), None);
    // Two metres of free fall.
    let Outcome::Lost { at, cause: Cause::Position, .. } = flight.outcome else { panic!("{flight:?}") };
    assert!((at - 1.0 - (4.0f64 / 9.81).sqrt()).abs() < 5e-3, "{at}");
    let mut low = model.clone();
    low.simulation.ground = 9.0;
    let flight = fly(&sortie(&low, &plan, &[strike(0, 1.0)]), None);
    assert!(matches!(flight.outcome, Outcome::Lost { cause: Cause::Ground, .. }), "{flight:?}");
}

#[test]
fn a_tumbling_vehicle_is_lost_and_not_flown_for_ever() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    let mut mode = lost(&model, &[1, 2, 8]);
    mode.rotors[4] = RotorState::Stuck(1.0);
    model.modes = vec![mode];
    let plan = staying(PLACE, 0.0, 1e4);
    let flight = fly(&sortie(&model, &plan, &[strike(0, 0.0)]), None);
    assert!(flight.end < 20.0, "{flight:?}");
    assert!(matches!(flight.outcome, Outcome::Lost { .. }), "{flight:?}");
    assert!(flight.max_tilt > 1.5);
}

#[test]
fn numbers_that_are_not_finite_end_a_flight_as_diverged() {
    let hover = staying(PLACE, 0.0, 5.0);
    for controller in [Controller::Pd, Controller::Geometric] {
        for allocation in [Allocation::PseudoInverse, Allocation::Bounded] {
            let mut model = quiet(octocopter("PPNNPPNN"));
            (model.simulation.controller, model.vehicle.allocation) = (controller, allocation);
            // A reference that is no number from 2 s on.
            let mut plan = staying(PLACE, 0.0, 2.0);
            plan.times.push(5.0);
            plan.nodes.push(plan.nodes[1]);
            plan.nodes[2][X][4] = f64::NAN;
            let flight = fly(&sortie(&model, &plan, &[]), None);
            let Outcome::Diverged { at } = flight.outcome else { panic!("{controller:?} {allocation:?} {flight:?}") };
            assert!((2.0..2.1).contains(&at), "{controller:?} {allocation:?}: {at}");
            for broken in [f64::NAN, f64::INFINITY] {
                model.vehicle.inertia[1] = broken;
                model.vehicle.mass = broken;
                let flight = fly(&sortie(&model, &hover, &[]), None);
                assert_eq!(flight.outcome, Outcome::Diverged { at: 0.0 }, "{controller:?} {allocation:?}");
                model = quiet(octocopter("PPNNPPNN"));
            }
        }
    }
    let model = quiet(octocopter("PPNNPPNN"));
    let endless = mavc::flight::Sortie { duration: f64::NAN, ..sortie(&model, &hover, &[]) };
    assert_eq!(fly(&endless, None).steps, 0);
}
