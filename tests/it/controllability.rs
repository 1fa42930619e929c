//! Verdicts and margins against the reference file (computed by independent code), closed forms and
//! brute force.

use mavc::admissible::diagnose::diagnose;
use mavc::admissible::verdict::analyze;
use mavc::admissible::{AdmissibleSet, intersection};
use mavc::model::Model;
use serde_json::Value;

use crate::vehicles::{hexacopter, lost, mission, octocopter, ring_model, waypoint};

#[derive(Debug)]
struct Case {
    model: Model,
    record: Value,
}

/// The paper's table of vehicles, with the record's faults as the only mode.
fn cases() -> Vec<Case> {
    let text = include_str!("../reference/controllability.json");
    let file: Value = serde_json::from_str(text).unwrap();
    let modes = file["modes"].as_array().unwrap();
    assert_eq!(modes.len(), 129);
    modes
        .iter()
        .map(|record| {
            let layout = record["layout"].as_str().unwrap();
            let mut model = match record["vehicle"].as_str().unwrap() {
                "quad" => ring_model(layout, 1.32, [0.0128, 0.0128, 0.0239], 9.9865e-6, 1.5978e-7, 840.0),
                "hexa" => ring_model(layout, 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0),
                _ => octocopter(layout),
            };
            let rotors: Vec<usize> =
                record["lost"].as_array().unwrap().iter().map(|k| k.as_u64().unwrap() as usize).collect();
            if !rotors.is_empty() {
                model.modes.push(lost(&model, &rotors));
            }
            Case { model, record: record.clone() }
        })
        .collect()
}

#[test]
fn all_reference_modes_agree() {
    for Case { model, record } in cases() {
        let set =
            if model.modes.is_empty() { AdmissibleSet::healthy(&model) } else { AdmissibleSet::of_mode(&model, 0) };
        let found = analyze(&model, &set);
        assert_eq!(found.verdict.name(), record["verdict"].as_str().unwrap(), "{record}");
        assert_eq!(found.interior, record["interior"].as_bool().unwrap(), "{record}\n{found:?}");
        assert_eq!(found.rank as u64, record["rank"].as_u64().unwrap(), "{record}");
        assert_eq!(found.facets.map(|f| f as u64), record["facets"].as_u64(), "{record}");
        let close = |name: &str, value: Option<f64>, tolerance: f64| {
            let expected = record[name].as_f64();
            assert_eq!(value.is_some(), expected.is_some(), "{name} of {record}");
            if let (Some(v), Some(e)) = (value, expected) {
                assert!((v - e).abs() <= tolerance, "{name}: {v} instead of {e} in {record}");
            }
        };
        close("acai", found.acai, 1e-6);
        close("acai_yaw_free", found.acai_yaw_free, 1e-6);
        close("critical_mass_kg", found.critical_mass_kg, 6e-5);
        close("critical_mass_yaw_free_kg", found.critical_mass_yaw_free_kg, 6e-5);
        for (name, residual) in [("residual4", &found.residual4[..]), ("residual3", &found.residual3[..])] {
            for (i, v) in residual.iter().enumerate() {
                let e = record[name][i].as_f64().unwrap();
                assert!((v - e).abs() <= 6e-5, "{name}[{i}]: {v} instead of {e} in {record}");
            }
        }
    }
}

/// Du and Quan's toolbox documents this vehicle: four rotors, arm 0.28 m, 0.1 m drag to thrust, 0..6 N.
#[test]
fn documented_acai_of_a_quadrotor_plus_and_cross() {
    for first in [0.0, std::f64::consts::FRAC_PI_4] {
        let mut model = ring_model("PNPN", 15.0 / 9.81, [0.01, 0.01, 0.02], 6.0, 0.6, 1.0);
        for (k, r) in model.vehicle.rotors.iter_mut().enumerate() {
            let a = first + k as f64 * std::f64::consts::FRAC_PI_2;
            r.position = [0.28 * a.sin(), 0.28 * a.cos(), 0.0];
        }
        let acai = analyze(&model, &AdmissibleSet::healthy(&model)).acai.unwrap();
        assert!((acai - 0.7299473938200366).abs() < 1e-12, "{acai}");
    }
}

/// If hover is not possible, or is on the edge, at every mass, the help does not suggest a lighter vehicle.
#[test]
fn a_lighter_vehicle_is_asked_for_only_where_it_helps() {
    let told = |mut model: Model, gone: &[usize], reserve: f64| {
        model.modes.push(lost(&model, gone));
        model.plan.against = vec![0];
        model.plan.reserve = reserve;
        model.mission = Some(mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([3.0, 0.0, 2.0], 0.0)]));
        let found = diagnose(&model).pop().unwrap();
        (found.label, found.help.unwrap())
    };
    // A quadcopter without a rotor lifts nothing with its torques balanced; PPNNPN would without 0.2 of its 1.54 kg.
    let quad = ring_model("PNPN", 1.32, [0.0128, 0.0128, 0.0239], 9.9865e-6, 1.5978e-7, 840.0);
    let (label, help) = told(quad, &[1], 0.0);
    assert_eq!(label, "not possible at any mass");
    assert!(help.contains("change the vehicle's layout") && !help.contains("lighter"), "{help}");
    let (label, help) = told(hexacopter("PPNNPN"), &[5], 0.0);
    assert!(label.starts_with("possible at 1.3") && help.contains("make the vehicle lighter"), "{label}: {help}");
    // PNPNPN hovers on the edge of yaw up to 2.66 kg.
    let (label, help) = told(hexacopter("PNPNPN"), &[1], 0.0);
    assert!(label.starts_with("even the smallest disturbance") && !help.contains("lighter"), "{label}: {help}");
    // Rotors that may not stop lift more than the weight: only then is their lowest speed to blame.
    let mut idle = octocopter("PNPNPNPN");
    idle.vehicle.rotors.iter_mut().for_each(|rotor| rotor.min_speed = 500.0);
    idle.vehicle.mass = 1.2;
    let (label, help) = told(idle, &[1], 0.0);
    assert!(label.starts_with("possible between ") && help.contains("`min_speed`"), "{label}: {help}");
}

#[test]
fn joint_set_of_all_single_faults_is_small() {
    for (layout, rows) in [("PNPNPNPN", 34), ("PPNNPPNN", 44)] {
        let mut model = octocopter(layout);
        for k in 1..=8 {
            let mode = lost(&model, &[k]);
            model.modes.push(mode);
        }
        let sets = AdmissibleSet::all(&model);
        assert_eq!(sets[0].polytope.facets.len(), 52);
        assert!(sets[1..].iter().all(|s| s.polytope.facets.len() == 40));
        let joint = intersection(&sets[1..].iter().collect::<Vec<_>>());
        assert_eq!(joint.facets.len(), rows, "{layout}");
        assert!(joint.margin(&sets[0].hover) > 0.0);
    }
}

#[test]
fn large_rings_have_the_expected_facets() {
    for (n, facets) in [(18, 436), (24, 1012), (32, 2308)] {
        let model = ring_model(&"PN".repeat(n / 2), 3.0, [0.1, 0.1, 0.2], 8.5485e-6, 1.3678e-7, 874.0);
        assert_eq!(AdmissibleSet::healthy(&model).polytope.facets.len(), facets, "{n} rotors");
    }
}
