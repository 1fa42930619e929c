//! Missions of `benches/missions/generate.py`: each has a plan that the checker accepts.

use crate::cli::{code, err, folder, mavc, text};
use serde_json::Value;

/// Plans a mission with these options for `plan` and checks its certificate; the time found, s.
fn planned(spec: &str, planner: &str, samples: usize, effort: &str) -> f64 {
    let dir = folder();
    let (proof, report) = (dir.path().join("proof.json"), dir.path().join("report.json"));
    let (planner, samples) = (format!("plan.planner={planner}"), format!("plan.samples={samples}"));
    let plan = ["plan", spec, "--set", &planner, "--set", &samples, "--effort", effort];
    let written = ["--certificate", text(&proof), "--report", text(&report)];
    let ran = mavc(&[&plan[..], &written].concat());
    assert_eq!(code(&ran), 0, "{spec} {planner}: {}", err(&ran));
    // The effort is no part of what was shown.
    let checked = mavc(&["verify", text(&proof), spec, "--set", &planner, "--set", &samples]);
    assert_eq!(code(&checked), 0, "{spec} {planner}: {}", err(&checked));
    let report: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
    report["planners"][0]["time_s"].as_f64().unwrap()
}

fn spec(seed: &str) -> String {
    format!("tests/specs/generated/{seed}.mav")
}

/// The samples of a spec that does not give them.
const SAMPLES: usize = 200;

/// On coarse grids; a survey is below, and all are planned on their own grids in the second tier.
#[test]
fn windows_a_slalom_and_a_ring_are_planned_quickly() {
    planned(&spec("003"), "rip", 40, "quick");
    planned(&spec("008"), "rcp", 40, "quick");
    planned(&spec("012"), "rip", 40, "quick");
}

#[test]
#[ignore = "long"]
fn a_survey_and_windows_are_planned_on_their_own_grids() {
    planned(&spec("001"), "rcp", SAMPLES, "quick");
    planned(&spec("003"), "rip", SAMPLES, "quick");
}

#[test]
#[ignore = "long"]
fn a_slalom_and_a_ring_are_planned_on_their_own_grids() {
    planned(&spec("008"), "rcp", SAMPLES, "quick");
    planned(&spec("012"), "rip", SAMPLES, "quick");
}

#[test]
#[ignore = "long"]
fn a_pick_is_planned_on_its_own_grid_and_another_slalom_on_a_coarse_one() {
    planned(&spec("018"), "rip", SAMPLES, "quick");
    // A slalom on its own grid is above.
    planned(&spec("024"), "rcp", 80, "quick");
}

/// The second pass: between waypoints at 25 m the plan stays near their height and its lanes, with every planner.
#[test]
fn a_survey_flies_its_lanes_at_their_height() {
    let dir = folder();
    let report = dir.path().join("report.json");
    for planner in ["rip", "rcp", "rsp"] {
        let set = format!("plan.planner={planner}");
        let ran = mavc(&["plan", "-v", "examples/survey_hexa.mav", "--set", &set, "--report", text(&report)]);
        assert_eq!(code(&ran), 0, "{planner}: {}", err(&ran));
        let report: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
        let shape = &report["planners"][0]["shape"];
        let figure = |of: &str, name: &str| shape[of][name].as_f64().unwrap();
        assert!(figure("height", "z_m") < 26.0, "{planner}: {shape}");
        assert!(figure("deviation", "distance_m") < 1.0, "{planner}: {shape}");
    }
}

/// A yaw along the path on every leg, from a start that turns on the spot. On a coarse grid and with little effort,
/// because a plan that stops takes longer with any.
#[test]
#[ignore = "long"]
fn a_yaw_along_the_path_does_not_stop_a_slalom() {
    for planner in ["rip", "rcp"] {
        let time = planned(&spec("000"), planner, 100, "quick");
        assert!(time < 25.0, "{planner}: {time}");
    }
}
