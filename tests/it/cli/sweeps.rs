//! `mavc analyze --sweep`: where verdicts change, and what cannot be swept.

use super::{HOP, code, err, folder, mavc, mavc_with, out, text};
use serde_json::Value;

#[test]
fn analysis_sweeps_find_the_critical_mass() {
    // PNPNPNPN loses control over eight double faults above 1.8827 kg.
    let spec = "use \"specs/vehicles/octo_pnpnpnpn.mav\"\nfaults { mode D { rotors [1, 3] lost } }\n";
    let dir = folder();
    let path = dir.path().join("d.mav");
    let root = env!("CARGO_MANIFEST_DIR");
    std::fs::write(&path, spec.replace("specs/", &format!("{root}/specs/"))).unwrap();
    let ran = mavc(&["analyze", "-v", text(&path), "--sweep", "mass=1.5..2.5kg", "--format", "json"]);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    let record: Value = serde_json::from_str(&out(&ran)).unwrap();
    let flips = record["flips"].as_array().unwrap();
    assert_eq!(flips.len(), 1, "{flips:?}");
    assert!((flips[0]["at"].as_f64().unwrap() - 1.8827).abs() < 1e-4, "{flips:?}");
    assert_eq!(record["modes"][0]["name"], "healthy");
}

#[test]
fn a_sweep_goes_on_where_the_vehicle_is_too_heavy() {
    let sweep = |args: &[&str]| {
        let ran = mavc_with(&[&["analyze", "-", "--sweep"], args].concat(), HOP);
        assert_eq!(code(&ran), 0, "{args:?}: {}", err(&ran));
        out(&ran)
    };
    let flips_of_healthy = |what: &str| -> Vec<(f64, Value)> {
        let record: Value = serde_json::from_str(&sweep(&[what, "--format", "json"])).unwrap();
        let flips = record["flips"].as_array().unwrap().iter().filter(|f| f["mode"] == "healthy");
        flips.map(|f| (f["at"].as_f64().unwrap(), f["above"].clone())).collect()
    };
    // Four rotors lift 4 b w^2.
    let lift = 4.0 * 9.9865e-6 * 840.0 * 840.0;
    let found = flips_of_healthy("mass=1..6kg");
    assert!(found.len() == 1 && found[0].1 == "unstable", "{found:?}");
    assert!((found[0].0 - lift / 9.81).abs() < 1e-4, "{found:?}");
    // Too heavy at both ends of the range, and gravity for the mass.
    assert_eq!(flips_of_healthy("mass=5..6kg"), []);
    let found = flips_of_healthy("gravity=9..40 m/s^2");
    assert!(found.len() == 1 && (found[0].0 - lift / 1.32).abs() < 1e-4, "{found:?}");
    // A slower rotor cannot lift what it lifted.
    let told = sweep(&["vehicle.rotor.max_speed=400..840rad/s"]);
    assert!(told.contains("  healthy: lost; above ") && told.contains("full control"), "{told}");
}

#[test]
fn lowest_thrusts_batteries_and_the_air_are_swept() {
    let battery = "battery { capacity = 5 A*h; voltage = 22.2 V; hover_power = 220 W }\n rotor {";
    let spec = HOP.replacen("rotor {", battery, 1);
    let flips = |spec: &str, what: &str| -> Vec<(f64, Value)> {
        let ran = mavc_with(&["analyze", "-v", "-", "--format", "json", "--sweep", what], spec);
        assert_eq!(code(&ran), 0, "{what}: {}", err(&ran));
        let record: Value = serde_json::from_str(&out(&ran)).unwrap();
        let all = record["flips"].as_array().unwrap().iter();
        all.map(|f| (f["at"].as_f64().unwrap(), f["above"].clone())).collect()
    };
    // Rotors that may not stop cannot balance the loss of one; those that reverse can.
    let found = flips(HOP, "rotor.min_thrust=-40..20%");
    assert!(!found.is_empty(), "{found:?}");
    // At 20 % charge four rotors lift 0.2 + 0.8 x of 4 b w^2: below that the vehicle is too heavy, which is no mistake
    // here.
    let lift = 4.0 * 9.9865e-6 * 840.0 * 840.0;
    let found = flips(&spec, "battery.thrust_at_empty=10..100%");
    let least = 100.0 * (1.32 * 9.81 / lift - 0.2) / 0.8;
    assert!(found.iter().any(|f| (f.0 - least).abs() < 1e-3 && f.1 == "controllable"), "{least} {found:?}");
    // Thrust is proportional to the density of the air, and given for 1.225 kg/m^3.
    let found = flips(&HOP.replace("mission hop {", "mission hop { air { }"), "mission.air.density=0.4..1.2kg/m^3");
    let least = 1.225 * 1.32 * 9.81 / lift;
    assert!(found.iter().any(|f| (f.0 - least).abs() < 1e-4 && f.1 == "controllable"), "{least} {found:?}");
    // A swept mass is too heavy at the charge that the battery keeps.
    let weak = spec.replace("battery {", "battery { thrust_at_empty = 50 %;");
    let found = flips(&weak, "mass=1..3kg");
    assert!(found.iter().any(|f| (f.0 - 0.6 * lift / 9.81).abs() < 1e-4 && f.1 == "unstable"), "{found:?}");
}

#[test]
fn sweeps_of_what_no_verdict_depends_on_are_refused() {
    for (sweep, told) in [
        ("masss=1..2kg", "no verdict depends on a field `masss`; did you mean `mass`?"),
        ("max_speed=1..2rad/s", "no verdict depends on a field `max_speed`; did you mean `rotor.max_speed`?"),
        (
            "plan.time=10s..20s",
            "no verdict depends on `plan.time`; sweep gravity, arm, mass, drag, yaw_drag, rotor.thrust_coefficient, ",
        ),
        ("first=0..45deg", "no verdict depends on `first`; sweep "),
        ("altitude=0..1m", "no verdict depends on a field `altitude`; did you mean `mission.air.altitude`?"),
        ("mass=-1..2kg", "at -1kg: `mass` must be greater than zero"),
        ("mass=1..2m", "at 1m: "),
    ] {
        let ran = mavc_with(&["analyze", "-v", "-", "--sweep", sweep], HOP);
        assert_eq!(code(&ran), 2, "{sweep}: {}", err(&ran));
        assert!(out(&ran).is_empty());
        assert!(err(&ran).contains(&format!("mavc: --sweep {sweep}: {told}")), "{}", err(&ran));
    }
}
