//! Every spec that ships means what it should, and there is nothing to say about it.

use super::{check, check_file};
use mavc::model::MissionTime;

/// All `.mav` files under `specs`, sorted.
fn shipped() -> Vec<String> {
    let mut names = Vec::new();
    for folder in std::fs::read_dir("specs").unwrap() {
        for file in std::fs::read_dir(folder.unwrap().path()).unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|e| e == "mav") {
                names.push(path.display().to_string());
            }
        }
    }
    names.sort();
    names
}

#[test]
fn shipped_specs_have_models_and_no_diagnostics() {
    let names = shipped();
    assert!(names.len() >= 12, "{names:?}");
    for name in names {
        let (model, diagnostics) = check_file(&name);
        assert_eq!(diagnostics, vec![], "{name}");
        let stem = name.trim_start_matches("specs/").trim_end_matches(".mav").replace('/', "_");
        insta::assert_snapshot!(stem, model.unwrap().to_string());
    }
}

#[test]
fn the_paper_cases_hold_the_curve_and_the_modes() {
    for (case, modes, against) in [("case1", 8, 1), ("case2", 1, 1), ("case3", 8, 8)] {
        let model = check_file(&format!("specs/paper/{case}.mav")).0.unwrap();
        let mission = model.mission.unwrap();
        assert_eq!(model.modes.len(), modes);
        assert_eq!(model.plan.against.len(), against);
        assert_eq!(mission.waypoints.len(), 21);
        assert_eq!(mission.legs.len(), 20);
        assert!(mission.limits.is_empty() && mission.start_at_rest && mission.end_at_rest);
        for (k, waypoint) in mission.waypoints.iter().enumerate() {
            let s = 4.0 * std::f64::consts::PI * k as f64 / 20.0;
            let curve = [4.0 * (1.0 + s.cos()), 4.0 * s.sin(), 10.0 + 8.0 * (s / 2.0).sin()];
            for (found, due) in waypoint.position.iter().zip(curve) {
                assert!((found - due).abs() < 1e-12, "{case} {k}");
            }
            assert_eq!((waypoint.yaw, waypoint.within, waypoint.weight), (0.0, 0.05, 1.0));
        }
        assert!(mission.legs.iter().all(|leg| leg.share == mission.legs[0].share));
        assert_eq!(model.plan.samples, 200);
        assert_eq!(model.plan.reserve, 0.0);
        assert_eq!(model.plan.time, MissionTime::Minimum);
        assert_eq!((model.plan.snap_weight, model.plan.acceleration_weight), (1e-4, 1e-4));
    }
    let pair = check_file("specs/paper/case2.mav").0.unwrap();
    assert_eq!(pair.modes[0].lost(), vec![1, 6]);
    assert_eq!(pair.modes[0].name, "M1_6");
}

#[test]
fn the_paper_vehicles_hold_its_table() {
    let rows = [
        ("quad_pnpn", 1.32, 0.0128, 0.0239, 9.9865e-6, 1.5978e-7, 840.0, 4),
        ("hexa_pnpnpn", 1.54, 0.0168, 0.0308, 8.5485e-6, 1.3678e-7, 874.0, 6),
        ("hexa_ppnnpn", 1.54, 0.0168, 0.0308, 8.5485e-6, 1.3678e-7, 874.0, 6),
        ("octo_pnpnpnpn", 1.8, 0.0429, 0.0748, 8.5485e-6, 1.3678e-7, 874.0, 8),
        ("octo_ppnnppnn", 1.8, 0.0429, 0.0748, 8.5485e-6, 1.3678e-7, 874.0, 8),
    ];
    for (name, mass, ixx, izz, b, d, speed, n) in rows {
        let vehicle = check_file(&format!("specs/vehicles/{name}.mav")).0.unwrap().vehicle;
        assert_eq!((vehicle.mass, vehicle.inertia), (mass, [ixx, ixx, izz]));
        assert_eq!(vehicle.rotors.len(), n);
        let layout = name.split('_').nth(1).unwrap().to_uppercase();
        assert_eq!(vehicle.layout.as_deref(), Some(layout.as_str()));
        for (k, rotor) in vehicle.rotors.iter().enumerate() {
            let angle = 2.0 * std::f64::consts::PI * k as f64 / n as f64;
            assert!((rotor.position[0] - 0.211 * angle.sin()).abs() < 1e-12);
            assert!((rotor.position[1] - 0.211 * angle.cos()).abs() < 1e-12);
            assert_eq!(rotor.position[2], 0.0);
            assert_eq!((rotor.thrust_coefficient, rotor.drag_coefficient), (b, d));
            assert_eq!(rotor.max_speed, speed);
        }
    }
    // The quadcopter's hover speed, as printed in the paper.
    let quad = check_file("specs/vehicles/quad_pnpn.mav").0.unwrap();
    let hover = (quad.vehicle.mass * quad.gravity / 4.0 / 9.9865e-6).sqrt();
    assert!((hover - 569.35).abs() < 0.01);
}

#[test]
fn the_template_stands_alone() {
    let (model, diagnostics) = check(include_str!("../../../src/template.mav"));
    assert_eq!(diagnostics, vec![]);
    assert!(model.unwrap().mission.is_some());
    for (kind, text) in mavc::MISSION_TEMPLATES {
        let (model, diagnostics) = check(text);
        assert_eq!(diagnostics, vec![], "{kind}");
        let model = model.unwrap();
        // Each uses what a mission of its kind needs.
        assert!(model.vehicle.battery.is_some() && model.mission.unwrap().volumes.len() >= 2, "{kind}");
    }
}
