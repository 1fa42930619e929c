//! Flights without yaw until their spin has settled, at the ends of the spec's intervals.

use super::{seen, sortie, staying, strike};
use crate::cli::mavc;
use mavc::flight::capture::heights;
use mavc::flight::equilibrium::settled_spins;
use mavc::flight::{Outcome, Sortie};
use mavc::model::{AfterFault, Detection, Model};
use nalgebra::Vector3;

const HUMMINGBIRD: &str = include_str!("../../specs/flown/hummingbird.mav");
const FAST_SPIN: &str = include_str!("../../specs/flown/fast_spin.mav");
const TILTED_SPIN: &str = include_str!("../../specs/flown/tilted_spin.mav");

fn model(text: &str) -> Model {
    mavc::compile(text).into_result().unwrap().model().clone()
}

/// Hovers at 400 m and loses the rotors of the first mode after 1 s. The height lost (m), and the flight.
fn hover(model: &mut Model, delay: f64, duration: f64) -> (f64, mavc::flight::Flight, Vector3<f64>) {
    model.simulation.detection = Detection::After(delay);
    (model.simulation.after_fault, model.simulation.lost_beyond) = (AfterFault::Continue, 300.0);
    (model.simulation.gyroscope_noise, model.simulation.position_noise) = (0.0, 0.0);
    let trajectory = staying([0.0, 0.0, 400.0], 0.0, duration);
    let strikes = [strike(0, 1.0)];
    let (flight, all) = seen(&sortie(model, &trajectory, &strikes), |s| (s.body.position.z, s.body.rates));
    let lowest = all.iter().map(|(z, _)| *z).fold(f64::INFINITY, f64::min);
    (400.0 - lowest, flight, all[all.len() - 1].1)
}

/// The heights (m) that another controller, written elsewhere, loses after 100 and 200 ms: the inertia of the rotors
/// turns the equilibrium's axis over while the body spins up, and the controlled axis must not follow. At most 1.2
/// times as much.
#[test]
fn rotors_with_inertia_do_not_turn_the_axis_over() {
    let cases = [
        (HUMMINGBIRD, 0.0, [1.95, 2.30]),
        (HUMMINGBIRD, 2.5e-5, [2.9, 5.1]),
        (HUMMINGBIRD, 4.2e-5, [20.5, 28.8]),
        (FAST_SPIN, 0.0, [5.15, 7.3]),
        (FAST_SPIN, 4e-5, [8.9, 13.0]),
    ];
    for (text, inertia, others) in cases {
        for (delay, other) in [0.1, 0.2].into_iter().zip(others) {
            let mut model = model(text);
            model.vehicle.rotors.iter_mut().for_each(|rotor| rotor.inertia = inertia);
            let (height, flight, _) = hover(&mut model, delay, 16.0);
            assert_eq!(flight.outcome, Outcome::Flown, "{inertia} {delay}");
            assert!(height < 1.2 * other, "{inertia} kg m^2, {delay} s: {height} m, the other {other} m");
        }
    }
}

/// With twice the drag the spin is within the range of the gyroscope at both ends of the interval; with the drag of the
/// spec it is not, and a gyroscope of ten times the range is.
#[test]
fn a_spin_beyond_the_gyroscope_is_no_capture() {
    let regained = |change: fn(&mut Model)| {
        let mut model = model(FAST_SPIN);
        change(&mut model);
        heights(&model, 0).iter().map(|found| (found.regained, found.flights)).collect::<Vec<_>>()
    };
    assert_eq!(regained(|_| {}), [(2, 5), (2, 5)]);
    // The upper end alone is 4.1e-3 N m s/rad, with which the spin settles at 28 rad/s.
    assert_eq!(regained(|model| model.vehicle.yaw_drag.as_mut().unwrap().linear *= 2.5), [(5, 5), (5, 5)]);
    assert_eq!(regained(|model| model.simulation.gyroscope_range *= 10.0), [(5, 5), (5, 5)]);
    let fixed = |model: &mut Model| model.vehicle.yaw_drag.as_mut().unwrap().spread = mavc::model::Spread::NONE;
    assert_eq!(regained(fixed), [(0, 5), (0, 5)]);
}

/// A flight goes on until the spin has settled, and reports it where it is beyond the gyroscope; with a duration of its
/// own it ends, and reports that the spin has not settled.
#[test]
fn flights_go_on_until_the_spin_settles() {
    let mut model = model(FAST_SPIN);
    model.vehicle.yaw_drag.as_mut().unwrap().linear *= 2.0;
    model.simulation.lost_beyond = 30.0;
    let trajectory = staying([0.0, 0.0, 60.0], 0.0, 6.0);
    let strikes = [strike(0, 1.0)];
    let end = |goes_on: bool| mavc::flight::fly(&Sortie { goes_on, ..sortie(&model, &trajectory, &strikes) }, None);
    let (short, long) = (end(false), end(true));
    assert_eq!((short.outcome, long.outcome), (Outcome::Flown, Outcome::Flown));
    // The stop ends at 2.6 s, and 5 s are flown after it.
    assert!(!short.spin.unwrap().is_settled && (short.end - 7.6).abs() < 1e-6, "{short:?}");
    // At most five times Jz/yaw_drag = 6 s.
    assert!(long.spin.unwrap().is_settled && long.end > 12.0 && long.end < 31.2, "{long:?}");
    // Twice as long changes the rate by 2 % at most.
    let later = staying([0.0, 0.0, 60.0], 0.0, 2.0 * long.end);
    let later = mavc::flight::fly(&sortie(&model, &later, &strikes), None).spin.unwrap();
    assert!((later.rate / long.spin.unwrap().rate - 1.0).abs() < 0.02, "{later:?} {long:?}");
}

/// The equilibrium that analyses print is that in which flights settle: rate and tilt of the axis.
#[test]
fn analyses_print_the_spin_in_which_flights_settle() {
    for (text, constants) in [(TILTED_SPIN, 6.0), (HUMMINGBIRD, 8.0)] {
        for inertia in [0.0, 2e-5] {
            let mut model = model(text);
            (model.vehicle.drag, model.simulation.drag) = ([0.0; 3], [0.0; 3]);
            model.vehicle.rotors.iter_mut().for_each(|rotor| rotor.inertia = inertia);
            let [found] = &settled_spins(&model)[..] else { panic!() };
            let constant = model.vehicle.inertia[2] / model.vehicle.yaw_drag.unwrap().linear;
            let (_, flight, w) = hover(&mut model, 0.02, constants * constant);
            assert_eq!(flight.outcome, Outcome::Flown);
            let (rate, tilt) = (w.norm(), w.xy().norm().atan2(w.z.abs()).to_degrees());
            let is_near =
                (found.spin_rad_s.abs() / rate - 1.0).abs() < 0.05 && (found.axis_tilt_deg - tilt).abs() < 1.0;
            assert!(is_near, "{inertia}: {found:?}, flown {rate} rad/s, {tilt} deg");
        }
    }
}

/// What commands print of it.
#[test]
fn commands_warn_of_spins_beyond_the_gyroscope() {
    let run = |args: &[&str]| {
        let ran = mavc(args);
        (ran.status.code(), String::from_utf8_lossy(&ran.stdout).split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/specs/flown/fast_spin.mav");
    let (code, told) = run(&["simulate", "-v", path, "-q"]);
    assert_eq!(code, Some(0));
    assert!(told.contains("The gyroscope measures rates up to 34.9 rad/s: beyond them"), "{told}");
    let healthy = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/specs/flown/tilted_spin.mav");
    let (code, told) = run(&["simulate", "-v", healthy, "-q"]);
    assert_eq!(code, Some(0));
    assert!(told.contains("; no fault simulated"), "{told}");
}
