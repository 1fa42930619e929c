//! How a spec configures lagging rotors, and what is reported about them.

use serde_json::Value;
use std::process::{Command, Output};

const SPEC: &str = r#"
vehicle quad {
    layout = "PNPN"
    arm = 0.2 m
    mass = 1.2 kg
    inertia = [0.012, 0.012, 0.022] kg*m^2
    rotor { max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 900 rad/s; time_constant = 30 ms }
}
mission hop {
    start at [0, 0, 2] m
    waypoint at [6, 2, 4] m
}
plan { planner = rip; model = hover; rotors = lagging; time = 4 s; samples = 30 }
"#;

/// Runs a command on the spec in a folder of its own, where `{}` stands for the folder.
fn mavc(folder: &tempfile::TempDir, args: &[&str]) -> Output {
    let path = folder.path().to_str().unwrap();
    std::fs::write(folder.path().join("spec.mav"), SPEC).unwrap();
    let args = args.iter().map(|a| a.replace("{}", path));
    Command::new(env!("CARGO_BIN_EXE_mavc")).args(args).env("NO_COLOR", "1").output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn reports_say_with_which_constant() {
    let folder = tempfile::tempdir().unwrap();
    let ran = mavc(&folder, &["plan", "-v", "{}/spec.mav", "--report", "{}/report.json"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let said = text(&ran.stdout);
    assert!(said.contains("Rotors lag: thrusts follow their commands with a time constant of 60 ms"), "{said}");
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("the linear model's commanded wrench satisfies every imposed facet"), "{said}");
    let report: Value = serde_json::from_slice(&std::fs::read(folder.path().join("report.json")).unwrap()).unwrap();
    let constant = report["thrust_time_constant_s"].as_f64().unwrap();
    assert!((constant - 0.06).abs() < 1e-12, "{constant}");

    let ran = mavc(&folder, &["plan", "-v", "{}/spec.mav", "--set", "plan.rotors=instant", "--report", "-"]);
    let report: Value = serde_json::from_slice(&ran.stdout).unwrap();
    assert!(report["thrust_time_constant_s"].is_null());
    assert!(!text(&ran.stderr).contains("Rotors lag"));
}

#[test]
fn the_model_and_the_defaults_show_it() {
    let folder = tempfile::tempdir().unwrap();
    let shown = text(&mavc(&folder, &["emit", "model", "{}/spec.mav"]).stdout);
    assert!(shown.contains("rotors lagging"), "{shown}");
    let program = text(&mavc(&folder, &["emit", "qp", "{}/spec.mav"]).stdout);
    assert!(program.lines().any(|line| line.trim_start().starts_with("lag: ")), "{program}");
    let program = text(&mavc(&folder, &["emit", "qp", "{}/spec.mav", "--set", "plan.rotors=instant"]).stdout);
    assert!(!program.contains("lag: "), "{program}");
}

#[test]
fn certificates_cover_it() {
    let folder = tempfile::tempdir().unwrap();
    let ran = mavc(&folder, &["plan", "-v", "{}/spec.mav", "--certificate", "{}/cert.json"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let said = text(&ran.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("Proved at every instant, to within 0.01 %: the linear model's wrench satisfies"), "{said}");
    let ran = mavc(&folder, &["verify", "{}/cert.json", "{}/spec.mav"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let said = text(&ran.stdout);
    let line =
        |start: &str| said.lines().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start}: {said}"));
    for start in ["linear model's wrench inside", "linear model's commands inside"] {
        assert!(line(start).ends_with("proved at every instant"), "{said}");
    }
}

#[test]
fn a_flight_takes_the_plan() {
    let folder = tempfile::tempdir().unwrap();
    let ran = mavc(&folder, &["simulate", "-v", "{}/spec.mav", "-o", "{}/flight.csv"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
}
