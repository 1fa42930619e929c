//! `1.8 kg +- 3 %`: what intervals mean, in every form that a rotor may be said in.

use super::{QUAD, check};
use mavc::model::{RotorSpread, Spread, Vehicle};
use mavc::source::FileId;
use mavc::syntax::parse;

fn vehicle(mass: &str, rotor: &str) -> Vehicle {
    let text = format!(
        "vehicle v {{\n layout = \"PNPN\"\n arm = 20 cm\n mass = {mass}\n inertia = [13, 13, 24] g*m^2\n rotor {{ {rotor} }}\n}}\n"
    );
    let (model, diagnostics) = check(&text);
    assert_eq!(diagnostics, vec![], "{text}");
    model.unwrap().vehicle
}

fn close(spread: Spread, low: f64, high: f64) {
    assert!((spread.low - low).abs() < 1e-12 && (spread.high - high).abs() < 1e-12, "{spread:?} {low} {high}");
}

const ROTOR: &str = "max_thrust = 8 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s";

#[test]
fn percent_quantities_and_bare_middles() {
    for mass in [
        "1.6 kg +- 5 %",
        "1.6 kg +- 80 g",
        "1.6 +- 0.08 kg",
        "1.5 kg + 0.1 kg +- 2*40 g",
        "(1.6 kg +- 5 %)",
        "(1.6 +- 5 %) kg",
        "((1.6 +- 0.08) kg)",
        "(1.6 +- 80 g) kg",
    ] {
        let vehicle = vehicle(mass, ROTOR);
        assert!((vehicle.mass - 1.6).abs() < 1e-12);
        close(vehicle.mass_spread, 0.95, 1.05);
        assert!(vehicle.is_uncertain() && !vehicle.has_uncertain_rotors());
    }
    assert!(!vehicle("1.6 kg", ROTOR).is_uncertain());
    assert_eq!(vehicle("1.6 kg", ROTOR).rotors[0].spread, RotorSpread::default());
}

/// `1.6 kg +- 0.05` could be 5 % or 50 g, and nothing else is guessed either.
#[test]
fn what_is_not_an_interval_is_reported() {
    for (mass, code) in [
        ("1.6 kg +- 0.05", "mavc::unit::interval"),
        ("2*(0.8 kg +- 5 %)", "mavc::unit::interval"),
        ("((1.6 +- 5 %) kg) kg", "mavc::unit::interval"),
        ("(1.6 kg +- 5 %) kg", "mavc::unit::mismatch"),
        ("1.6 kg - 5 %", "mavc::unit::mismatch"),
    ] {
        let text = QUAD.replacen("mass    = 1.32 kg", &format!("mass = {mass}"), 1);
        assert_ne!(text, QUAD);
        let (_, diagnostics) = check(&text);
        let [error] = &diagnostics[..] else { panic!("{mass}: {diagnostics:?}") };
        assert_eq!(error.code, code, "{mass}");
        let help = error.help.as_deref().unwrap();
        assert!(!help.contains("5 % kg") && !help.contains(" - 5 %`"), "{mass}: {help}");
    }
}

/// By all combinations of the ends of the intervals.
#[test]
fn rotors_in_every_form() {
    let of = |rotor: &str| vehicle("1.6 kg", rotor).rotors[2].spread;
    // b, d and the speed: F = b w^2 and kappa = d/b.
    let s = of(
        "thrust_coefficient = 1e-5 N*s^2/rad^2 +- 4 %; drag_coefficient = 1.6e-7 N*m*s^2/rad^2 +- 10 %; max_speed = 800 rad/s +- 2 %",
    );
    close(s.full_thrust, 0.96 * 0.98 * 0.98, 1.04 * 1.02 * 1.02);
    close(s.idle_thrust, 0.96, 1.04);
    close(s.torque_per_thrust, 0.9 / 1.04, 1.1 / 0.96);
    // What a scale shows: F and kappa themselves; b = F/w^2 follows.
    let s = of("max_thrust = 8 N +- 0.4 N; torque_per_thrust = 16 mm +- 1 mm; max_speed = 800 rad/s +- 2 %");
    close(s.full_thrust, 0.95, 1.05);
    close(s.idle_thrust, 0.95 / (1.02 * 1.02), 1.05 / (0.98 * 0.98));
    close(s.torque_per_thrust, 15.0 / 16.0, 17.0 / 16.0);
    let s = of("max_thrust = 8 N +- 5 %; drag_coefficient = 2e-7 N*m*s^2/rad^2; max_speed = 800 rad/s");
    close(s.torque_per_thrust, 1.0 / 1.05, 1.0 / 0.95);
}

#[test]
fn intervals_are_printed_as_they_are_written() {
    let text = "vehicle v {\n    mass = 1.5 kg + 100 g +- 3 %\n}\n";
    let tree = parse(FileId(0), &mavc::source::Source::new("v.mav", text)).value.unwrap();
    let printed = tree.to_string();
    assert!(printed.contains("mass = 1.5 kg + 100 g +- 3 %"), "{printed}");
    // With a blank between them they are the two operators they always were.
    let (model, diagnostics) = check(&format!(
        "{QUAD}let a = 3 m + -2 m\nmission m {{\n start at [0, 0, 2] m\n waypoint at [a, 0, 2] m\n}}\n"
    ));
    assert_eq!(diagnostics, vec![]);
    assert_eq!(model.unwrap().mission.unwrap().waypoints[1].position[0], 1.0);
}

/// A rate may be zero, an interval around it may not.
#[test]
fn a_rate_is_one_number_or_an_interval() {
    let checked = |rate: &str| check(&format!("{QUAD}\nfaults {{ mode a {{ rotor 1 lost; rate = {rate} }} }}\n"));
    for (rate, per_hour, low, high) in
        [("1e-5 1/h +- 50 %", 1e-5, 0.5, 1.5), ("(2 +- 0.5) 1/h", 2.0, 0.75, 1.25), ("0 1/h", 0.0, 1.0, 1.0)]
    {
        let (model, diagnostics) = checked(rate);
        assert_eq!(diagnostics, vec![], "{rate}");
        let mode = &model.unwrap().modes[0];
        assert!((3600.0 * mode.rate.unwrap() - per_hour).abs() <= 1e-12 * per_hour);
        close(mode.rate_spread, low, high);
    }
    for rate in ["0 1/h +- 10 %", "1e-5 1/h +- 100 %", "1e-5 1/h +- 1e-6"] {
        let (_, diagnostics) = checked(rate);
        let [error] = &diagnostics[..] else { panic!("{rate}: {diagnostics:?}") };
        assert_eq!(error.code, "mavc::unit::interval", "{rate}");
    }
}
