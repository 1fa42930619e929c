//! Missions that are planned from the polyline through their waypoints, flown from rest to rest.

use crate::cli::{code, err, folder, mavc, text};
use serde_json::Value;

const CRANE: &str = "tests/specs/rest_to_rest/crane_x8.mav";

mod thorough {
    use super::*;

    /// The shortest time found, and times above it: each has a plan that the checker accepts. The kinematic bound is
    /// 50.15 s, and a plan of 57.92 s is known.
    #[test]
    #[ignore = "long"]
    fn a_mission_with_vertical_legs_around_a_crane_has_plans() {
        let dir = folder();
        let (proof, report) = (dir.path().join("proof.json"), dir.path().join("report.json"));
        for time in ["minimum", "80s"] {
            let time = format!("plan.time={time}");
            let plan = ["plan", CRANE, "--set", &time, "--certificate", text(&proof), "--report", text(&report)];
            let ran = mavc(&plan);
            assert_eq!(code(&ran), 0, "{time}: {}", err(&ran));
            let checked = mavc(&["verify", text(&proof), CRANE, "--set", &time]);
            assert_eq!(code(&checked), 0, "{time}: {}", err(&checked));
            let report: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
            let found = report["planners"][0]["time_s"].as_f64().unwrap();
            assert!((50.15..150.01).contains(&found), "{found}");
            if time.contains("minimum") {
                assert!(found < 60.0, "{found}");
            }
        }
    }
}
