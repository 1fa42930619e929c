//! Predicted against flown, and the path, worked out again from the rows.

use super::*;

/// Counts, scores and the path again, from the rows alone: without yaw to give up, `gone` is predicted lost by its
/// verdict.
pub(super) fn are_those_of_the_rows(desk: &Desk, record: &Value) {
    desk.run(&["hop.mav", "--times", "3", "--seeds", "2", "-o", "rows.csv", "--quiet"], 0);
    let rows: Vec<Row> = desk.lines("rows.csv")[1..].iter().map(|line| Row::read(line).unwrap()).collect();
    // RSP and RIP may have the same plan, which counts once: flights with the same seeds are the same then.
    let key =
        |r: &Row| (r.mode.clone(), r.fault_time.map(f64::to_bits), r.seed, r.end.to_bits(), r.rms_error.to_bits());
    let mut seen = BTreeSet::new();
    let struck: Vec<&Row> = rows.iter().filter(|r| r.fault_time.is_some() && seen.insert(key(r))).collect();
    let predicted = |r: &Row| r.mode == "gone";
    let count = |p: bool, l: bool| struck.iter().filter(|r| predicted(r) == p && r.is_lost() == l).count();
    let forecasts = record["predictors"].as_array().unwrap();
    for name in ["verdict", "core"] {
        let found = forecasts.iter().find(|f| f["predictor"] == name).unwrap();
        let table =
            ["hits", "misses", "false_alarms", "correct_negatives"].map(|of| found[of].as_u64().unwrap() as usize);
        assert_eq!(table, [count(true, true), count(false, true), count(true, false), count(false, false)], "{found}");
        let wrong = (table[1] + table[2]) as f64 / struck.len() as f64;
        assert!((found["brier"].as_f64().unwrap() - wrong).abs() < 1e-12);
        // Each class has one mode, so that its other modes have no flights and the probability is 1/2; of all flights
        // the other mode's share is known.
        assert!((found["brier_by_class"].as_f64().unwrap() - 0.25).abs() < 1e-12, "{found}");
        let squares = |mode: &str| {
            let own: Vec<&&Row> = struck.iter().filter(|r| r.mode == mode).collect();
            let others: Vec<&&Row> = struck.iter().filter(|r| r.mode != mode).collect();
            let p = (others.iter().filter(|r| r.is_lost()).count() + 1) as f64 / (others.len() + 2) as f64;
            own.iter().map(|r| (p - f64::from(u8::from(r.is_lost()))).powi(2)).sum::<f64>()
        };
        let base = (squares("gone") + squares("weak")) / struck.len() as f64;
        assert!((found["brier_base"].as_f64().unwrap() - base).abs() < 1e-12, "{found}");
    }
    assert!(forecasts.iter().all(|f| f["predictor"] != "capture"));
    for (p, planner) in ["rip", "rsp", "rcp"].into_iter().enumerate() {
        for (m, mode) in ["gone", "weak"].into_iter().enumerate() {
            let own: Vec<&Row> = rows.iter().filter(|r| r.planner == planner && r.mode == mode).collect();
            let path = &record["planners"][p]["modes"][m]["flights"]["path"];
            let sum = |of: fn(&mavc::campaign::rows::Path) -> usize| {
                own.iter().filter_map(|r| r.path.as_ref()).map(of).sum::<usize>()
            };
            assert_eq!(path["waypoints_due"], sum(|p| p.due));
            assert_eq!(path["waypoints_missed"], sum(|p| p.missed));
            assert_eq!(path["heading_broken"], sum(|p| usize::from(p.heading_broken)));
            assert_eq!(path["limits_broken"], sum(|p| usize::from(p.limits.any())));
            let mean = own.iter().filter_map(|r| r.max_error_after).sum::<f64>() / own.len() as f64;
            assert!((path["deviation_m"]["mean"].as_f64().unwrap() - mean).abs() < 1e-9);
            assert!(own.iter().all(|r| r.max_error_after.unwrap() <= r.max_error));
        }
    }
}

/// At a constant height one comparison predicts every flight of a mode: the height of capture against that over the
/// ground, and against how far below its reference the vehicle may be.
#[test]
fn capture_predicts_by_the_height_over_the_ground() {
    let desk = Desk::new();
    let level = HOP
        .replace("; without_yaw = never", "")
        .replace("[0, 0, 2]", "[0, 0, 5]")
        .replace("[3, 1, 4]", "[3, 1, 5]")
        .replace("    rotor {", "    yaw_drag = 2.75e-3 N*m*s/rad\n    rotor {");
    for (simulate, word) in [
        ("detection = 20 ms; lost_beyond = 20 m", "high enough"),
        ("detection = 20 ms; lost_beyond = 20 m; ground = 4.9 m", "too low"),
        ("detection = 20 ms; lost_beyond = 5 cm", "beyond lost_beyond"),
    ] {
        std::fs::write(desk.path("hop.mav"), format!("{level}simulate {{ {simulate} }}\n")).unwrap();
        let size = ["hop.mav", "--times", "2", "--seeds", "1", "--quiet", "--report", "r.json"];
        desk.run(&[&size[..], &["--set", "campaign.planners=rip"]].concat(), 0);
        let record: Value = serde_json::from_slice(&desk.bytes("r.json")).unwrap();
        crate::schemas::schema("campaign").assert_valid(&record);
        let gone = &record["planners"][0]["modes"][0];
        let at_rest = &gone["capture"][0];
        let needed = at_rest["height_m"].as_f64().unwrap();
        assert!(at_rest["regained"] == 5 && needed > 0.1 && needed < 5.0, "{at_rest}");
        let forecasts = record["predictors"].as_array().unwrap();
        let found = forecasts.iter().find(|f| f["predictor"] == "capture").unwrap();
        let class = &found["classes"][0];
        assert_eq!((&class["class"], &class["predicted_lost"]), (&word.into(), &(word != "high enough").into()));
        let sum = |key: &str| gone["times"].as_array().unwrap().iter().map(|c| c[key].as_u64().unwrap()).sum::<u64>();
        assert_eq!((class["struck"].as_u64(), class["lost"].as_u64()), (Some(sum("struck")), Some(sum("lost"))));
        assert_eq!(found["classes"].as_array().unwrap().len(), 1, "{found}");
    }
}
