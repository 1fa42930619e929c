//! The command as scripts use it: exit codes, files whole or absent, streams, equal bytes.

mod explaining;
mod flight_blocks;
mod folding;
mod many;
mod reports;
mod results;
mod shell;
pub mod shipped;
mod stuck;
mod sweeps;
mod watching;

use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Runs `mavc` in the repository's root.
pub fn mavc(args: &[&str]) -> Output {
    mavc_with(args, "")
}

pub fn mavc_with(args: &[&str], input: &str) -> Output {
    run_in(Path::new(env!("CARGO_MANIFEST_DIR")), args, input)
}

/// The exit code, standard output and standard error of a run in a folder.
pub fn mavc_in(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let output = run_in(folder, args, "");
    (code(&output), out(&output), err(&output))
}

fn run_in(folder: &Path, args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(args)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A command that never reads its input closes the pipe: no matter.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().expect("ended by itself")
}

pub fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A text as one line, whatever the width of its paragraphs and of the messages and labels of diagnostics.
pub fn flat(text: &str) -> String {
    text.split_whitespace().filter(|word| !matches!(*word, "│" | "·")).collect::<Vec<_>>().join(" ")
}

pub fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

pub fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

const CASE_1: &str = "specs/paper/case1.mav";

/// A short mission that plans in a moment.
pub const HOP: &str = r#"
vehicle quad {
    layout  = "PNPN"
    arm     = 0.211 m
    mass    = 1.32 kg
    inertia = [0.0128, 0.0128, 0.0239] kg*m^2
    rotor { thrust_coefficient = 9.9865e-6 N*s^2/rad^2; drag_coefficient = 1.5978e-7 N*m*s^2/rad^2; max_speed = 840 rad/s }
}
faults {
    every 1 rotor lost as M
    mode weak { rotor 1 reduced to 90 % }
}
mission hop {
    start at [0, 0, 2] m
    waypoint at [3, 1, 4] m
}
plan { model = hover; planner = rsp; against = [weak]; time = 6 s; samples = 40 }
"#;

#[test]
fn a_plan_writes_a_table_and_a_report() {
    let dir = folder();
    let (table, report) = (dir.path().join("traj.csv"), dir.path().join("report.json"));
    let ran = mavc(&["plan", "-v", CASE_1, "--set", "plan.time=20s", "-o", text(&table), "--report", text(&report)]);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    let csv = std::fs::read_to_string(&table).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 202);
    assert!(
        lines[0].starts_with("t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax,ay,az,yaw_acc,jx,jy,jz,sx,sy,sz,roll,pitch,thrust,")
    );
    assert!(
        lines[0]
            .ends_with("tau_x,tau_y,tau_z,omega_1,omega_2,omega_3,omega_4,omega_5,omega_6,omega_7,omega_8,waypoint")
    );
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    assert_eq!(record["planners"][0]["verdict"], "found");
    assert_eq!(record["planners"][0]["time_s"], 20.0);
    assert_eq!(record["spec_sha256"].as_str().unwrap().len(), 64);
    // Nothing is left beside the two files.
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
}

#[test]
fn the_same_spec_gives_the_same_bytes() {
    let dir = folder();
    let spec = dir.path().join("hop.mav");
    std::fs::write(&spec, HOP.replace("time = 6 s", "time = minimum")).unwrap();
    let run = |name: &str, threads: &str| {
        let path = dir.path().join(name);
        let ran = Command::new(env!("CARGO_BIN_EXE_mavc"))
            .args(["compare", "-v", text(&spec), "--report", text(&path)])
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert_eq!(code(&ran), 0, "{}", err(&ran));
        (ran.stdout, std::fs::read(path).unwrap())
    };
    let first = run("a.json", "1");
    assert_eq!(first, run("b.json", "2"));
    assert_eq!(first, run("c.json", "2"));
}

#[test]
fn mistakes_end_with_1_and_write_nothing() {
    let dir = folder();
    let table = dir.path().join("traj.csv");
    let ran = mavc_with(&["plan", "-v", "-", "-o", text(&table)], &HOP.replace("1.32 kg", "1.32 m"));
    assert_eq!(code(&ran), 1);
    assert!(err(&ran).contains("mavc::unit::mismatch"), "{}", err(&ran));
    assert!(out(&ran).is_empty());
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn a_mode_that_cannot_hover_ends_with_3_and_a_report() {
    let dir = folder();
    let (table, report) = (dir.path().join("traj.csv"), dir.path().join("report.json"));
    let args = ["plan", "-v", "-", "-o", text(&table), "--report", text(&report), "--set", "plan.against=[M1]"];
    let ran = mavc_with(&args, HOP);
    assert_eq!(code(&ran), 3);
    assert!(err(&ran).contains("mavc::analysis::cannot_hover"), "{}", err(&ran));
    assert!(!table.exists());
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    assert_eq!(record["planners"][0]["verdict"], "not attempted");
    let checked = mavc_with(&["check", "-", "--format", "short", "--set", "plan.against=[M1]"], HOP);
    assert_eq!(code(&checked), 3);
    assert!(out(&checked).contains("error[mavc::analysis::cannot_hover]"), "{}", out(&checked));
}

#[test]
fn modes_with_the_same_finding_share_a_diagnostic() {
    let args = ["check", "-", "--format", "json", "--set", "plan.against=all"];
    let ran = mavc_with(&args, HOP);
    assert_eq!(code(&ran), 3);
    let records: Vec<Value> = out(&ran).lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert_eq!(records.len(), 1, "{}", out(&ran));
    assert_eq!(records[0]["message"], "in each of the fault modes M1, M2, M3 and M4 the vehicle cannot hold its yaw");
    assert_eq!(records[0]["labels"][1]["file"], "--set");
    // Without a mission no mode has to be tolerated.
    let vehicle = HOP.split("mission").next().unwrap();
    assert_eq!(code(&mavc_with(&["check", "-", "--deny", "warnings"], vehicle)), 0);
    // Without `against` there is no place in the spec to point at.
    let ran =
        mavc_with(&["check", "-", "--format", "json", "--set", "plan.reserve=0"], &HOP.replace("against = [weak]", ""));
    assert!(!out(&ran).contains("must tolerate"), "{}", out(&ran));
}

#[test]
fn only_the_broken_override_is_reported() {
    for set in ["plan.against", "plan.against=[", "plan.agianst=[M1]", "wind.speed=3"] {
        let ran = mavc_with(&["check", "-", "--format", "short", "--set", set], HOP);
        assert_eq!(code(&ran), 1);
        assert_eq!(out(&ran).lines().count(), 1, "{}", out(&ran));
        assert!(out(&ran).starts_with("--set:1:"), "{}", out(&ran));
    }
}

#[test]
fn no_plan_in_time_ends_with_3_and_a_report() {
    let dir = folder();
    let (table, report) = (dir.path().join("traj.csv"), dir.path().join("report.json"));
    let args = ["plan", "-v", "-", "-o", text(&table), "--report", text(&report), "--set", "plan.time=0.7s"];
    let ran = mavc_with(&args, HOP);
    assert_eq!(code(&ran), 3, "{}{}", out(&ran), err(&ran));
    assert!(
        flat(&out(&ran))
            .contains("proved infeasible at 0.7 s: no motion within limits and thrust takes less than 0.8677 s"),
        "{}",
        out(&ran)
    );
    assert!(!table.exists() && report.exists());
    // Why, at the places of the spec and of `--set`, and the same in the report.
    let told = err(&ran);
    assert!(told.contains("mavc::plan::conflict") && flat(&told).contains("cannot hold together"), "{told}");
    assert!(told.contains("waypoint at [3, 1, 4] m") && told.contains("in 0.7 s"), "{told}");
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    let conflict = &record["conflict"];
    let list = |of: &str, member: &str| -> Vec<String> {
        let members = conflict[of].as_array().unwrap().iter();
        members.map(|m| m[member].as_str().unwrap().to_string()).collect()
    };
    assert!(list("statements", "kind").contains(&"time".to_string()), "{record:#}");
    assert!(list("statements", "message").iter().all(|m| told.contains(m.as_str())), "{told}\n{record:#}");
    assert!(list("fixes", "message").iter().all(|m| told.contains(m.as_str())), "{told}\n{record:#}");
    let time = conflict["statements"].as_array().unwrap().iter().find(|s| s["kind"] == "time").unwrap();
    assert_eq!(time["file"], mavc::read::OVERRIDE);
    // The time that would do does, and asks for no reasons.
    let later = conflict["fixes"].as_array().unwrap().iter().find(|f| f["kind"] == "time").unwrap();
    let set = format!("plan.time={}s", later["value"]);
    let ran = mavc_with(&["plan", "-v", "-", "-o", text(&table), "--report", text(&report), "--set", &set], HOP);
    assert_eq!(code(&ran), 0, "{}{}", out(&ran), err(&ran));
    assert!(!err(&ran).contains("mavc::plan::conflict"), "{}", err(&ran));
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&report).unwrap()).unwrap();
    assert!(record["conflict"].is_null());
}

#[test]
fn usage_and_files_end_with_2() {
    let dir = folder();
    let missing = dir.path().join("none/traj.csv");
    for args in [
        vec!["plan", "-v", "no/such.mav"],
        vec!["plan", "-v", "specs"],
        vec!["plan", "-v", CASE_1, "-o", text(&missing)],
        vec!["plan", "-v", CASE_1, "-o", text(dir.path())],
        vec!["explain", "mavc::no::such"],
        vec!["emit", "sets", CASE_1, "--format", "json"],
        vec!["analyze", "-v", CASE_1, "--sweep", "mass=2kg"],
        vec!["check", CASE_1, "--explain-defaults", "--format", "json"],
        vec!["nonsense"],
    ] {
        let ran = mavc(&args);
        assert_eq!(code(&ran), 2, "{args:?}: {}", err(&ran));
        assert!(out(&ran).is_empty() && !err(&ran).is_empty(), "{args:?}");
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn check_speaks_three_formats() {
    let broken = HOP.replace("mass ", "mss ");
    let human = mavc_with(&["check", "-"], &broken);
    assert_eq!(code(&human), 1);
    assert!(out(&human).contains("<stdin>"), "{}", out(&human));
    let short = mavc_with(&["check", "-", "--format", "short"], &broken);
    assert!(out(&short).lines().all(|l| l.starts_with("<stdin>:") && l.contains("[mavc::")), "{}", out(&short));
    let json = mavc_with(&["check", "-", "--format", "json"], &broken);
    for line in out(&json).lines() {
        let record: Value = serde_json::from_str(line).unwrap();
        assert!(record["line"].as_u64().unwrap() >= 1 && record["column"].as_u64().unwrap() >= 1);
        assert!(record["code"].as_str().unwrap().starts_with("mavc::"));
    }
    // M1 to M4 are not planned against: warnings.
    assert_eq!(code(&mavc_with(&["check", "-"], HOP)), 0);
    assert_eq!(code(&mavc_with(&["check", "-", "--deny", "warnings"], HOP)), 1);
    let defaults = mavc_with(&["check", "-", "--explain-defaults"], HOP);
    assert!(out(&defaults).contains("plan.reserve"), "{}", out(&defaults));
}

#[test]
fn the_tree_needs_only_syntax() {
    let meant_otherwise = HOP.replace("1.32 kg", "1.32 m");
    let ran = mavc_with(&["emit", "ast", "-"], &meant_otherwise);
    assert_eq!((code(&ran), err(&ran)), (0, String::new()));
    assert!(out(&ran).contains("mass = 1.32 m"), "{}", out(&ran));
    let torn = HOP.replace("mass    = 1.32 kg", "mass    = = 1.32 kg");
    for (stage, spec) in [
        ("ast", &torn),
        ("model", &torn),
        ("model", &meant_otherwise),
        ("actuation", &meant_otherwise),
        ("sets", &meant_otherwise),
        ("constraints", &meant_otherwise),
        ("qp", &meant_otherwise),
    ] {
        let ran = mavc_with(&["emit", stage, "-"], spec);
        assert_eq!(code(&ran), 1, "{stage}: {}", err(&ran));
        assert!(out(&ran).is_empty() && err(&ran).contains("mavc::"), "{stage}: {}", err(&ran));
    }
}

#[test]
fn an_unknown_option_is_no_value() {
    let ran = mavc_with(&["plan", "-", "--threads", "4"], HOP);
    assert_eq!(code(&ran), 2);
    let told = "error: unexpected argument '--threads' found\n\nUsage: mavc plan <SPEC>\n";
    assert!(err(&ran).starts_with(told), "{}", err(&ran));
    let ran = mavc_with(&["plan", "-", "--reprot", "r.json"], HOP);
    assert!(err(&ran).contains("--report") && !err(&ran).contains("-- --"), "{}", err(&ran));
}

#[test]
fn every_stage_of_every_shipped_spec_can_be_printed() {
    for spec in shipped() {
        let name = text(&spec);
        for stage in ["ast", "model", "actuation", "sets"] {
            let ran = mavc(&["emit", stage, name]);
            assert_eq!(code(&ran), 0, "{stage} {name}: {}", err(&ran));
            assert!(!out(&ran).is_empty());
        }
        assert_eq!(code(&mavc(&["check", name])), 0, "{name}");
        assert_eq!(code(&mavc(&["analyze", "-v", name, "--format", "json"])), 0, "{name}");
    }
    for stage in ["constraints", "qp"] {
        assert_eq!(code(&mavc(&["emit", stage, CASE_1, "--set", "plan.time=24s"])), 0, "{stage}");
    }
}

fn shipped() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs");
    let mut found = Vec::new();
    for folder in ["vehicles", "paper", "missions"] {
        found.extend(std::fs::read_dir(root.join(folder)).unwrap().map(|e| e.unwrap().path()));
    }
    found.retain(|p| p.extension().is_some_and(|e| e == "mav"));
    found.sort();
    assert!(found.len() >= 12);
    found
}

#[test]
fn programs_are_exported() {
    let json = mavc_with(&["emit", "qp", "-", "--format", "json"], HOP);
    assert_eq!(code(&json), 0, "{}", err(&json));
    let program: Value = serde_json::from_str(&out(&json)).unwrap();
    let rows = program["b"].as_array().unwrap().len();
    assert_eq!(program["row_origin"].as_array().unwrap().len(), rows);
    let cones = program["cones"].as_array().unwrap();
    assert_eq!(cones.iter().map(|c| c["rows"].as_u64().unwrap() as usize).sum::<usize>(), rows);
    let keep_in =
        |k: usize| format!("keep_in k{k} {{ shape = box; from = [-9, -9, -9] m; to = [{}, 9, 9] m }}\n", 9 + k);
    let volumes: String = (0..100).map(keep_in).collect();
    let large = HOP.replace("start at", &format!("{volumes}start at"));
    // No plan is that short, which is proved at once.
    let refused = mavc_with(&["emit", "qp", "-", "--set", "plan.samples=2500", "--set", "plan.time=0.5s"], &large);
    assert_eq!(code(&refused), 2, "{}", err(&refused));
    assert!(err(&refused).contains("mavc::emit::rows"), "{}", err(&refused));
}

#[test]
fn new_writes_a_spec_that_plans_and_never_overwrites() {
    let dir = folder();
    let (spec, table) = (dir.path().join("first.mav"), dir.path().join("traj.csv"));
    assert_eq!(code(&mavc(&["new", text(&spec)])), 0);
    let before = std::fs::read(&spec).unwrap();
    assert_eq!(code(&mavc(&["new", text(&spec)])), 2);
    assert_eq!(before, std::fs::read(&spec).unwrap());
    let checked = mavc(&["check", text(&spec), "--deny", "warnings"]);
    assert_eq!(code(&checked), 0, "{}", out(&checked));
    let ran = mavc(&["plan", "-v", text(&spec), "-o", text(&table)]);
    assert_eq!(code(&ran), 0, "{}{}", out(&ran), err(&ran));
    assert!(table.exists());
    for warning in ["Between samples", "Past the linear model"] {
        assert!(!out(&ran).contains(warning), "{}", out(&ran));
    }
    assert_eq!(out(&mavc(&["new", "-"])).as_bytes(), before);
}

/// Every mission is written and checked. The inspection, whose plan takes least, is planned too; the very long tests of
/// batteries plan all of them.
#[test]
fn new_writes_whole_missions_that_check_and_plan() {
    let dir = folder();
    let kinds = mavc::MISSION_TEMPLATES.map(|(kind, _)| kind);
    assert_eq!(kinds, ["inspection", "delivery", "survey", "room"]);
    for kind in kinds {
        let spec = dir.path().join(kind).with_extension("mav");
        assert_eq!(code(&mavc(&["new", text(&spec), "--mission", kind])), 0);
        let checked = mavc(&["check", text(&spec), "--deny", "warnings"]);
        assert_eq!(code(&checked), 0, "{}", out(&checked));
        assert_eq!(code(&mavc(&["fmt", "--check", text(&spec)])), 0, "{kind} is not formatted");
    }
    let spec = dir.path().join("inspection.mav");
    let fewer = ["--set", "plan.planner=rip", "--set", "plan.samples=60", "--set", "plan.time=85s"];
    let ran = mavc(&[&["plan", "-v", text(&spec)], &fewer[..]].concat());
    assert_eq!(code(&ran), 0, "{}{}", out(&ran), err(&ran));
    assert!(out(&ran).contains("\n  battery: ") && out(&ran).contains("keep_out "), "{}", out(&ran));
    let unknown = mavc(&["new", "-", "--mission", "race"]);
    assert_eq!(code(&unknown), 2);
    assert!(err(&unknown).contains("inspection, delivery, survey, room"), "{}", err(&unknown));
}

/// A vehicle from its label is a spec without warnings whose estimates are marked; what depends on them is printed.
#[test]
fn new_writes_a_vehicle_of_estimates() {
    let dir = folder();
    let label = |motors: &str, mass: &str, diagonal: &str, propeller: &str| -> Vec<String> {
        let given = ["--vehicle", "--motors", motors, "--mass", mass, "--diagonal", diagonal, "--propeller", propeller];
        given.map(String::from).into()
    };
    let run = |name: &str, label: &[String], more: &[&str]| {
        let spec = dir.path().join(name);
        let given: Vec<&str> = label.iter().map(String::as_str).collect();
        (mavc(&[&["new", text(&spec)], &given[..], more].concat()), spec)
    };
    for (name, label) in [
        ("hexa.mav", label("6", "1.5kg", "55cm", "10in")),
        ("quad.mav", label("4", "620 g", "22 cm", "5x4.3")),
        ("octo.mav", label("8", "9kg", "1.1m", "457mm")),
    ] {
        let (ran, spec) = run(name, &label, &["--battery", "4S5000mAh"]);
        assert_eq!(code(&ran), 0, "{}", err(&ran));
        assert!(out(&ran).contains("yaw_drag from ") && out(&ran).contains("rotor.max_thrust from "), "{}", out(&ran));
        assert_eq!(code(&mavc(&["fmt", "--check", text(&spec)])), 0, "{name} is not formatted");
        let written = std::fs::read_to_string(&spec).unwrap();
        for field in ["inertia", "drag", "yaw_drag", "max_thrust", "torque_per_thrust", "max_speed", "rotor_inertia"] {
            let line = written.lines().find(|line| line.trim().starts_with(&format!("{field} "))).unwrap();
            assert!(line.contains("// estimate"), "{line}");
        }
        for field in ["mass", "arm", "capacity"] {
            let line = written.lines().find(|line| line.trim().starts_with(&format!("{field} "))).unwrap();
            assert!(!line.contains("estimate"), "{line}");
        }
        let compiled = mavc::compile(&written);
        assert_eq!(compiled.diagnostics, vec![], "{}", compiled.render());
        let vehicle = &compiled.spec.unwrap().model().vehicle.clone();
        assert!(vehicle.yaw_drag.unwrap().spread.high > 1.4 && vehicle.has_uncertain_rotors());
        assert!(vehicle.drag_spread.high > 1.4 && vehicle.rotors.iter().all(|rotor| rotor.inertia_spread.high > 1.5));
    }
    // Ranges that decide nothing one by one may do so together, and `analyze` says the same.
    let (ran, spec) = run("together.mav", &label("6", "1500g", "55cm", "10in"), &[]);
    let analyzed = out(&mavc(&["analyze", text(&spec)]));
    let headline = analyzed.lines().next().unwrap();
    assert!(out(&ran).contains(&format!("All ranges together: {headline}")), "{} {headline}", out(&ran));
    let (ran, spec) = run("known.mav", &label("4", "620g", "22cm", "5in"), &["--thrust", "480gf"]);
    assert!(!out(&ran).contains("max_thrust"), "{}", out(&ran));
    assert!(std::fs::read_to_string(&spec).unwrap().contains("max_thrust        = 4.7088 N"));
    let (odd, spec) = run("odd.mav", &label("5", "620g", "22cm", "5in"), &[]);
    assert!(code(&odd) == 2 && err(&odd).contains("even number of rotors") && !spec.exists(), "{}", err(&odd));
    for wrong in [label("4", "620", "22cm", "5in"), label("4", "620g", "22cm", "5"), label("4", "1m", "22cm", "5in")] {
        let (ran, spec) = run("wrong.mav", &wrong, &[]);
        assert!(code(&ran) == 2 && err(&ran).contains("such as") && !spec.exists(), "{}", err(&ran));
    }
    assert_eq!(code(&mavc(&["new", "-", "--vehicle", "--mass", "1kg"])), 2);
    assert_eq!(code(&mavc(&["new", "-", "--mass", "1kg"])), 2);
}

#[test]
fn yaw_planned_first_is_said() {
    let dir = folder();
    let plan = |spec: &str| {
        let table = dir.path().join("t.csv");
        let fewer = ["--set", "plan.model=hover", "--set", "plan.samples=60"];
        let output = mavc(&[&["plan", "-v", spec, "-o", text(&table), "--quiet"], &fewer[..]].concat());
        assert_eq!(code(&output), 0);
        out(&output).contains("Yaw changes: it was planned first")
    };
    assert!(plan("specs/missions/inspection.mav"));
    assert!(!plan("specs/paper/case1.mav"));
}
