//! `mavc simulate` as scripts use it: exit codes, the log, equal bytes, mistakes reported before anything runs.

use crate::cli::flat;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn simulate(spec: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mavc"));
    command.arg("simulate").arg(spec).args(args).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("ended by itself")
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A short flight with the octocopter; `more` joins the spec.
fn hop(folder: &Path, more: &str) -> std::path::PathBuf {
    let vehicle = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs/vehicles/octo_ppnnppnn.mav");
    let text = format!(
        "use \"{}\"
faults {{
    every 1 rotor lost as M
    mode half {{ rotors [1, 2, 3, 4] lost }}
    mode opposite {{ rotors [1, 5] lost }}
}}
mission hop {{
    start at [0, 0, 2] m
    waypoint at [4, 1, 4] m
}}
plan {{ model = hover; planner = rip; against = all; time = 6 s; samples = 40 }}
{more}
",
        vehicle.display()
    );
    // `half` and `opposite` need not be tolerated: the plan names other modes.
    let text = text.replace("against = all", "against = [M1]");
    let path = folder.join("hop.mav");
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_flight_writes_its_log_and_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let spec = hop(folder.path(), "simulate { fault M3 at 2 s }\n");
    let (log, report) = (folder.path().join("flight.csv"), folder.path().join("sim.json"));
    let outputs = ["-o", log.to_str().unwrap(), "--report", report.to_str().unwrap()];
    let ran = simulate(&spec, &outputs);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    let text = std::fs::read_to_string(&log).unwrap();
    let header: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap_or_else(|| panic!("no column {name}"));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|l| l.split(',').map(|c| c.parse().unwrap_or(f64::NAN)).collect()).collect();
    // The estimator has seen nothing at the very start.
    let rows = &rows[20..];
    assert_eq!(rows.len(), 581, "6 s at 100 rows a second and the end, but for those looked past");
    assert!(rows.iter().all(|r| r.len() == header.len()));
    assert_eq!(header.len(), 28 + 3 * 8 + 2);
    assert!(rows.iter().all(|r| r[column("regressor_rank")] >= 1.0 && r[column("regressor_condition")] >= 1.0));
    let last = &rows[rows.len() - 1];
    for (name, due) in [("x", 4.0), ("y", 1.0), ("z", 4.0)] {
        assert!((last[column(name)] - due).abs() < 0.1, "{name} {}", last[column(name)]);
    }
    assert!(last[column("believed_3")] == 0.0 && last[column("believed_4")] == 1.0);
    assert!(last[column("theta_3")] < 0.1);
    // What is printed as an error is the distance of the columns.
    for row in rows {
        let distance = ["x", "y", "z"]
            .map(|axis| (row[column(axis)] - row[column(&format!("{axis}_ref"))]).powi(2))
            .iter()
            .sum::<f64>()
            .sqrt();
        assert!((distance - row[column("error")]).abs() < 1e-12);
        let off = row[column("yaw")] - row[column("yaw_ref")] - row[column("heading_error")];
        assert!((off / std::f64::consts::TAU).fract().abs() < 1e-9, "{off}");
    }
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    let largest = rows.iter().map(|r| r[column("error")]).fold(0.0, f64::max);
    let told = record["max_error_m"].as_f64().unwrap();
    assert!(told >= largest && told < largest + 0.01, "{told} {largest}");
    let largest = rows.iter().map(|r| r[column("heading_error")].abs()).fold(0.0, f64::max);
    for name in ["max_heading_error_rad", "max_heading_error_after_rad"] {
        let told = record[name].as_f64().unwrap();
        assert!(told > 0.0 && told >= largest && told < largest + 0.01, "{name} {told} {largest}");
    }
    assert_eq!(record["turns"], 0);

    let again = (folder.path().join("again.csv"), folder.path().join("again.json"));
    let ran = simulate(&spec, &["-o", again.0.to_str().unwrap(), "--report", again.1.to_str().unwrap()]);
    assert_eq!(code(&ran), 0);
    assert_eq!(std::fs::read(&log).unwrap(), std::fs::read(&again.0).unwrap());
    assert_eq!(std::fs::read(&report).unwrap(), std::fs::read(&again.1).unwrap());
    let other = simulate(&spec, &["-o", again.0.to_str().unwrap(), "--set", "simulate.seed=2"]);
    assert_eq!(code(&other), 0);
    assert_ne!(std::fs::read(&log).unwrap(), std::fs::read(&again.0).unwrap());
}

#[test]
fn a_lost_vehicle_gives_exit_code_6_and_reports_when_and_why() {
    let folder = tempfile::tempdir().unwrap();
    let spec = hop(folder.path(), "simulate { fault half at 2 s }\n");
    let (log, report) = (folder.path().join("flight.csv"), folder.path().join("sim.json"));
    let ran = simulate(&spec, &["-o", log.to_str().unwrap(), "--report", report.to_str().unwrap()]);
    assert_eq!(code(&ran), 6);
    assert!(String::from_utf8(ran.stdout).unwrap().contains("LOST at "));
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    let at = record["outcome"]["at_s"].as_f64().unwrap();
    assert!(at > 2.0 && at < 4.0, "{at}");
    assert!(log.exists());
}

/// The first sentence is a verdict on waypoints and limits, and what was not kept is marked.
#[test]
fn a_flight_says_whether_it_met_its_waypoints_and_limits() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("sim.json");
    let flown = |limits: &str, simulate: &str| -> (String, Value) {
        let spec = hop(folder.path(), &format!("simulate {{ {simulate} }}\n"));
        let text = std::fs::read_to_string(&spec).unwrap();
        let text = text.replace("[4, 1, 4] m\n", &format!("[4, 1, 4] m\n    limits {{ {limits} }}\n"));
        std::fs::write(&spec, text).unwrap();
        let ran = simulate_with_report(&spec, &report);
        (flat(&ran), serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap())
    };
    let (text, record) = flown("speed <= 5 m/s; tilt <= 20 deg", "");
    assert!(
        text.contains(
            "to its end at 6.00 s: waypoints met, no limit exceeded by more than a tenth (tilt: 5.7 deg allowed); \
             no fault simulated"
        ),
        "{text}"
    );
    assert!(!text.contains("! limits") && !text.contains("! largest tilt"), "{text}");
    assert_eq!(record["limits_broken"], serde_json::json!([]));

    // A strong gust breaks limits that the plan keeps.
    let (text, record) = flown("speed <= 1.3 m/s; tilt <= 4 deg", "gusts = 3 m/s; drag = 1 N*s/m");
    let broken: Vec<&str> = record["limits_broken"].as_array().unwrap().iter().map(|l| l.as_str().unwrap()).collect();
    assert!(!broken.is_empty(), "{record}");
    let named = format!("! limits broken: {}", broken.join(", "));
    assert!(text.contains("limits BROKEN; no fault") && text.contains(&named), "{text}");
    assert!(text.contains("largest tilt ") && text.contains(" degrees (limit of the plan: 4)"), "{text}");
    assert!(text.contains("! without a fault the controller does not keep what the plan keeps"), "{text}");

    let (text, record) = flown("speed <= 5 m/s", "fault M3 at 2 s; detection = 50 ms; after_fault = land");
    let outcome = &record["outcome"];
    assert_eq!(outcome["status"], "landed", "{text}");
    let [x, y, z] = [0, 1, 2].map(|axis| outcome["place_m"][axis].as_f64().unwrap());
    let speed = outcome["speed_m_s"].as_f64().unwrap();
    assert!(0.0 < x && x < 4.5 && -0.5 < y && y < 1.5 && z.abs() < 0.1 && 0.0 < speed && speed <= 2.0, "{outcome}");
    assert!(text.contains(" s at [") && text.contains("] m, touching down at "), "{text}");
}

/// What a flight prints, with its record in a file.
fn simulate_with_report(spec: &Path, report: &Path) -> String {
    let ran = simulate(spec, &["--report", report.to_str().unwrap()]);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    String::from_utf8(ran.stdout).unwrap()
}

#[test]
fn mistakes_are_reported_before_anything_flies() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("flight.csv");
    for (block, codes) in [
        ("simulate { fault M3 at -1 s }", &["mavc::simulate::fault_time"][..]),
        ("simulate { fault M3 at 7 s }", &["mavc::simulate::past_the_end"]),
        ("simulate { fault M9 at 1 s }", &["mavc::name::unknown"]),
        ("simulate { attitude_gain = 0 1/s^2 }", &["mavc::simulate::not_positive"]),
        ("simulate { rate = 60 Hz; control_rate = 60 Hz; estimator_rate = 60 Hz }", &["mavc::simulate::coarse_step"]),
        (
            "simulate { fault M3 at -1 s; yaw_gain = -1 1/s^2 }",
            &["mavc::simulate::fault_time", "mavc::simulate::not_positive"],
        ),
    ] {
        let ran = simulate(&hop(folder.path(), block), &["-o", log.to_str().unwrap()]);
        assert_eq!(code(&ran), 1, "{block}\n{}", err(&ran));
        codes.iter().for_each(|code| assert!(err(&ran).contains(code), "{block}\n{}", err(&ran)));
        assert!(!log.exists());
    }
    // With the shortest time the end is known only once the mission is planned.
    let spec = hop(folder.path(), "simulate { fault M3 at 50 s }");
    let ran = simulate(&spec, &["-o", log.to_str().unwrap(), "--set", "plan.time=minimum"]);
    assert_eq!(code(&ran), 1, "{}", err(&ran));
    assert!(err(&ran).contains("mavc::simulate::past_the_end"));
    assert!(!log.exists());
}

#[test]
fn check_warns_of_modes_that_look_alike_in_hover() {
    let folder = tempfile::tempdir().unwrap();
    let check = |block: &str| {
        let spec = hop(folder.path(), block);
        let ran = Command::new(env!("CARGO_BIN_EXE_mavc")).arg("check").arg(spec).args(["--format", "short"]).output();
        String::from_utf8(ran.unwrap().stdout).unwrap()
    };
    let told = check("simulate { fault opposite at 1 s }");
    assert!(told.contains("mavc::simulate::alike") && told.contains("opposite from healthy"), "{told}");
    assert!(!check("simulate { fault M3 at 1 s }").contains("alike"));
    assert!(!check("simulate { detection = 50 ms; fault opposite at 1 s }").contains("alike"));
}

#[test]
fn a_mission_without_a_plan_is_not_flown() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("flight.csv");
    let report = folder.path().join("sim.json");
    let outputs = ["-o", log.to_str().unwrap(), "--report", report.to_str().unwrap(), "--set", "plan.time=0.5s"];
    let ran = simulate(&hop(folder.path(), ""), &outputs);
    assert_eq!(code(&ran), 3);
    assert!(!log.exists());
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    assert_eq!(record["planners"][0]["verdict"], "proved infeasible");
    let many = simulate(&hop(folder.path(), ""), &["-o", log.to_str().unwrap(), "--set", "simulate.duration=90000s"]);
    assert_eq!(code(&many), 2, "a log past its bound: {}", err(&many));
    // Without a log there is nothing to bound: the flight ends soon, where all rotors on one side are lost.
    let spec = hop(folder.path(), "simulate { fault half at 1 s; duration = 90000 s }");
    assert_eq!(code(&simulate(&spec, &[])), 6);
}

/// Two rotors that leave no torque about the vertical: the vehicle keeps its place and spins.
#[test]
fn a_vehicle_that_turns_away_is_lost_unless_the_spec_says_otherwise() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("sim.json");
    let flown = |more: &str| {
        let block = format!(
            "faults {{ mode neighbours {{ rotors [1, 2] lost; without_yaw = never }} }}\n\
             simulate {{ fault neighbours at 1 s; detection = 50 ms; duration = 15 s; {more} }}\n"
        );
        let ran = simulate(&hop(folder.path(), &block), &["-v", "--report", report.to_str().unwrap()]);
        let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
        crate::schemas::schema("simulate").assert_valid(&record);
        (code(&ran), String::from_utf8(ran.stdout).unwrap(), record)
    };
    let (exit, text, record) = flown("");
    assert_eq!(exit, 6, "{text}");
    assert_eq!((&record["outcome"]["status"], &record["outcome"]["cause"]), (&"lost".into(), &"heading".into()));
    assert!(text.contains(": heading more than 90 degrees off for longer than 1 s\n"), "{text}");
    let (exit, text, record) = flown("lost_yaw = 45 deg; lost_yaw_after = 500 ms");
    assert!(exit == 6 && text.contains(": heading more than 45 degrees off for longer than 0.5 s\n"), "{text}");
    assert!(record["max_heading_error_rad"].as_f64().unwrap() < 2.0, "{record}");
    let (exit, text, record) = flown("lost_yaw = off");
    let text = flat(&text);
    let turns = record["turns"].as_u64().unwrap();
    assert!(exit == 0 && turns >= 8 && record["max_error_m"].as_f64().unwrap() < 1.0, "{text}");
    assert!(text.contains(&format!("; {turns} whole turns away from the planned heading ")), "{text}");
    assert!(text.contains(" heading error: ") && text.contains(" degrees rms; largest 180.0"), "{text}");
}

/// An inertia of nearly nothing: once the fault disturbs it, steps follow nothing any more.
#[test]
fn an_integration_that_breaks_down_ends_with_9_and_a_log_of_what_came_before() {
    let folder = tempfile::tempdir().unwrap();
    let (log, report, page) =
        (folder.path().join("flight.csv"), folder.path().join("sim.json"), folder.path().join("sim.html"));
    let spec = hop(folder.path(), "simulate { fault M3 at 2 s; detection = 50 ms }\n");
    for inertia in ["1e-9", "1e-10", "1e-12"] {
        let set = format!("vehicle.inertia=[{inertia},{inertia},{inertia}]kg*m^2");
        let args = [
            "-v",
            "-o",
            log.to_str().unwrap(),
            "--report",
            report.to_str().unwrap(),
            "--html",
            page.to_str().unwrap(),
            "--set",
            &set,
        ];
        let ran = simulate(&spec, &args);
        assert_eq!(code(&ran), 9, "{inertia}: {}", err(&ran));
        let text = String::from_utf8(ran.stdout).unwrap();
        assert!(text.contains("\n  DIVERGED at 2.0") && !text.contains("LOST"), "{text}");
        let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
        crate::schemas::schema("simulate").assert_valid(&record);
        assert_eq!(record["outcome"]["status"], "diverged");
        let rows = std::fs::read_to_string(&log).unwrap();
        let last: f64 = rows.lines().last().unwrap().split(',').next().unwrap().parse().unwrap();
        assert!((1.98..2.1).contains(&last), "{inertia}: {last}");
        let numbers = rows.lines().skip(1).flat_map(|line| line.split(',')).filter(|cell| !cell.is_empty());
        numbers.for_each(|cell| assert!(cell.parse::<f64>().is_ok_and(|x| x.abs() < 1e6), "{inertia}: {cell}"));
        assert!(std::fs::read_to_string(&page).unwrap().contains("Diverged at"));
    }
}
