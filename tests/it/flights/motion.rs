//! Motors, drag and the order of the integrator: closed forms, and a very fine solution.

use super::{angle_between, moving};
use crate::vehicles::octocopter;
use mavc::actuation::Wrench;
use mavc::flight::body::{Body, Frame};
use mavc::flight::rotors::Rotors;
use mavc::model::Model;
use mavc::model::RotorState;
use nalgebra::Vector3;

fn still() -> Vector3<f64> {
    Vector3::zeros()
}

/// An octocopter without symmetry, in drag.
fn uneven() -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.inertia = [0.03, 0.045, 0.07];
    model.simulation.drag = [0.3; 3];
    model
}

/// `duration` s with motors that go from one uneven set of speeds to another, in steps as `fly` takes them.
fn swung(model: &Model, duration: f64, h: f64) -> Body {
    let frame = Frame::of(model);
    let mut rotors = Rotors::new(&model.vehicle, h);
    for k in 0..8 {
        rotors.speed[k] = 480.0 + 10.0 * k as f64;
        rotors.command[k] = 530.0 - 15.0 * (k as f64 - 3.0).abs();
    }
    let mut body = moving();
    let mut end = rotors.wrench();
    for _ in 0..(duration / h).round() as usize {
        let begin = end;
        rotors.half_step();
        let middle = rotors.wrench();
        rotors.half_step();
        end = rotors.wrench();
        body.step(&frame, h, [&begin, &middle, &end], &Vector3::new(1.0, -2.0, 0.5));
    }
    body
}

#[test]
fn steps_are_of_fourth_order_while_motors_lag() {
    let model = uneven();
    let fine = swung(&model, 0.4, 1e-4);
    let errors = [0.02, 0.01, 0.005].map(|h| {
        let body = swung(&model, 0.4, h);
        let part = |v: Vector3<f64>| v.norm();
        [
            part(body.position - fine.position),
            part(body.velocity - fine.velocity),
            part(body.rates - fine.rates),
            angle_between(&body, &fine),
        ]
    });
    for pair in errors.windows(2) {
        for (coarse, half) in pair[0].iter().zip(pair[1]) {
            let order = (coarse / half).log2();
            assert!((3.6..=4.5).contains(&order), "order {order} of {errors:?}");
        }
    }
}

#[test]
fn motors_step_as_one_minus_an_exponential() {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.rotors[3].time_constant = Some(0.05);
    let h = 1e-3;
    let mut rotors = Rotors::new(&model.vehicle, h);
    rotors.command.fill(600.0);
    for step in 1..=300 {
        rotors.half_step();
        rotors.half_step();
        let t = step as f64 * h;
        for (k, speed) in rotors.speed.iter().enumerate() {
            // 20 ms where the spec says nothing.
            let tau = if k == 3 { 0.05 } else { 0.02 };
            assert!((speed - 600.0 * (1.0 - (-t / tau).exp())).abs() < 1e-9, "rotor {k} at {t}: {speed}");
        }
    }
}

#[test]
fn rotors_give_what_faults_leave() {
    let model = octocopter("PPNNPPNN");
    let mut rotors = Rotors::new(&model.vehicle, 1e-3);
    rotors.command.fill(500.0);
    rotors.settle();
    // Row by row as (12) has it: thrust, arm to the left, arm to the rear, drag against the turn.
    let (b, d, l) = (8.5485e-6, 1.3678e-7, 0.211);
    let of = |theta: [f64; 8], square: [f64; 8]| {
        (0..8).fold(Wrench::zeros(), |sum, k| {
            let (s, c) = (std::f64::consts::FRAC_PI_4 * k as f64).sin_cos();
            let turn = if [0, 1, 4, 5].contains(&k) { -d } else { d };
            sum + Wrench::new(b, b * l * c, -b * l * s, turn) * (theta[k] * square[k])
        })
    };
    assert!((rotors.wrench() - of([1.0; 8], [250_000.0; 8])).norm() < 1e-12);
    let mut weak = crate::vehicles::lost(&model, &[2]);
    weak.rotors[4] = RotorState::Reduced(0.5);
    let mut stuck = crate::vehicles::lost(&model, &[]);
    stuck.rotors[6] = RotorState::Stuck(0.25);
    stuck.rotors[4] = RotorState::Reduced(0.8);
    rotors.set_faults([&weak, &stuck].into_iter());
    let theta = [1.0, 0.0, 1.0, 1.0, 0.5, 1.0, 1.0, 1.0];
    let mut square = [250_000.0; 8];
    // A quarter of full thrust is half of full speed.
    square[6] = 437.0 * 437.0;
    assert!((rotors.wrench() - of(theta, square)).norm() < 1e-12);
    rotors.command.fill(0.0);
    (0..2000).for_each(|_| rotors.half_step());
    let mut square = [0.0; 8];
    square[6] = 437.0 * 437.0;
    assert!((rotors.wrench() - of(theta, square)).norm() < 1e-12, "a stuck rotor follows no command");
    rotors.set_faults(std::iter::empty());
    (0..2000).for_each(|_| rotors.half_step());
    assert!(rotors.wrench().norm() < 1e-12, "a rotor that recovers follows again");
}

#[test]
fn constant_thrust_climbs_along_a_parabola() {
    let frame = Frame::of(&octocopter("PPNNPPNN"));
    let mut body = Body::at_rest(Vector3::new(1.0, 2.0, 3.0), 0.5);
    let thrust = Wrench::new(20.0, 0.0, 0.0, 0.0);
    (0..2000).for_each(|_| body.step(&frame, 1e-3, [&thrust; 3], &still()));
    let climb = 20.0 / 1.8 - 9.81;
    assert!((body.position - Vector3::new(1.0, 2.0, 3.0 + 2.0 * climb)).norm() < 1e-11);
    assert!((body.velocity - Vector3::new(0.0, 0.0, 2.0 * climb)).norm() < 1e-12);
}

#[test]
fn falling_in_drag_comes_to_its_terminal_velocity() {
    let frame = Frame::of(&uneven());
    let mut body = moving();
    let start = body;
    // m v' = -m g e_3 - c v.
    let rate = 0.3 / 1.8;
    let terminal = Vector3::new(0.0, 0.0, -9.81 / rate);
    let nothing = Wrench::zeros();
    for second in 1..=40 {
        (0..1000).for_each(|_| body.step(&frame, 1e-3, [&nothing; 3], &still()));
        let left = (-rate * f64::from(second)).exp();
        let velocity = terminal + (start.velocity - terminal) * left;
        assert!((body.velocity - velocity).norm() < 1e-9, "{} instead of {velocity}", body.velocity);
    }
    assert!((body.velocity - terminal).norm() < 0.15, "{}", body.velocity);
}

#[test]
fn a_body_in_wind_drifts_towards_the_wind() {
    let mut frame = Frame::of(&uneven());
    frame.gravity = 0.0;
    let wind = Vector3::new(4.0, -3.0, 0.5);
    let rate = 0.3 / 1.8;
    let mut body = Body::at_rest(Vector3::zeros(), 0.0);
    let nothing = Wrench::zeros();
    for second in 1..=20 {
        (0..1000).for_each(|_| body.step(&frame, 1e-3, [&nothing; 3], &wind));
        let t = f64::from(second);
        let gone = 1.0 - (-rate * t).exp();
        assert!((body.velocity - wind * gone).norm() < 1e-10);
        assert!((body.position - wind * (t - gone / rate)).norm() < 1e-9);
    }
}
