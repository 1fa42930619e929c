//! Every plan goes through the checker before it is called one: what the commands say, write and end with.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn finding(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/findings");
    folder.join(name).to_str().unwrap().into()
}

fn mavc(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavc")).args(args).env("NO_COLOR", "1").env("COLUMNS", "200").output().unwrap()
}

struct Planned {
    code: i32,
    text: String,
    report: Value,
    is_written: bool,
}

fn planned(spec: &str, more: &[&str]) -> Planned {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| -> PathBuf { folder.path().join(name) };
    let (table, report) = (at("traj.csv"), at("report.json"));
    let mut args =
        vec!["plan", "-v", spec, "-o", table.to_str().unwrap(), "--report", report.to_str().unwrap(), "--quiet"];
    args.extend(more);
    let ran = mavc(&args);
    let text = String::from_utf8(ran.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    Planned {
        code: ran.status.code().unwrap(),
        text,
        report: serde_json::from_slice(&std::fs::read(report).unwrap()).unwrap(),
        is_written: table.exists(),
    }
}

fn fails_the_check(spec: &str, why: &str) {
    let Planned { code, text, report, is_written } = planned(&finding(spec), &[]);
    assert!(code == 4 && !is_written, "{spec}: {code} {text}");
    assert!(text.contains(&format!("not found: the trajectory planned for {why}")), "{spec}: {text}");
    let planner = &report["planners"][0];
    assert_eq!((&planner["verdict"], &planner["check"]), (&"not found".into(), &Value::Null), "{planner:#}");
}

/// In six nanoseconds everything is as near as rounding.
#[test]
fn a_plan_that_fails_is_not_found_and_not_written() {
    fails_the_check("tiny_time.mav", "6e-9 s fails the check of plans: waypoint 1 at 0 s: its position is missed");
}

#[test]
fn a_plan_that_passes_says_so_in_the_report() {
    let Planned { code, report, is_written, .. } = planned(&finding("nodes_per_leg.mav"), &[]);
    assert!(code == 0 && is_written);
    assert_eq!(report["planners"][0]["check"]["outcome"], "checked");
}

/// Six rotors stuck where they hover leave a set of two dimensions, which no plane through three rotors bounds.
#[test]
fn what_cannot_be_decided_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let spec = folder.path().join("still.mav");
    let text = "vehicle octo {
    layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults { mode jam { rotors [1, 2, 3, 5, 6, 7] stuck at 33.801684532924964 % } }
mission still { start at [0, 0, 2] m; waypoint at [0, 0, 2] m }
plan { model = hover; planner = rcp; against = [jam]; time = 4 s; samples = 20; reserve = 0 % }
";
    std::fs::write(&spec, text).unwrap();
    let spec = spec.to_str().unwrap();
    let Planned { code, text, report, is_written } = planned(spec, &[]);
    assert!(code == 0 && is_written, "{text}");
    let why = "the set of jam: it has fewer than three dimensions";
    assert!(
        text.contains(&format!("RCP jam: found, 4 s, the spec's time; the check of plans could not decide: {why}")),
        "{text}"
    );
    let check = &report["planners"][0]["check"];
    assert_eq!((&check["outcome"], &check["undecided"]), (&"not_decided".into(), &why.into()));
    // The certificate of such a plan is weaker than the spec asks.
    let proof = folder.path().join("cert.json");
    let proof = proof.to_str().unwrap();
    assert_eq!(mavc(&["plan", "-v", spec, "--quiet", "--certificate", proof]).status.code(), Some(0));
    let verified = mavc(&["verify", proof, spec]);
    let told = String::from_utf8(verified.stdout).unwrap();
    assert_eq!(verified.status.code(), Some(7), "{told}");
    assert!(told.contains(&format!("- not decided: {why}")), "{told}");
}

/// The command refuses the forgeries that were once accepted.
#[test]
fn forgeries_are_refused_by_the_command() {
    for name in ["teleport", "nodes_not_tied", "nodes_per_leg", "other_planner", "overflow"] {
        let ran = mavc(&["verify", &finding(&format!("{name}.forged.json")), &finding(&format!("{name}.mav"))]);
        assert_eq!(ran.status.code(), Some(5), "{name}");
        let told = String::from_utf8(ran.stderr).unwrap();
        assert!(told.contains("mavc::verify::rejected") && ran.stdout.is_empty(), "{name}: {told}");
    }
}

/// A proof for one choice of waypoint times, or for one yaw, is none for a spec that leaves them open, and no exit
/// code, report or conflict says so.
#[test]
fn proofs_of_less_than_the_spec_are_none() {
    for (spec, time, confined) in [
        ("one_division.mav", "18.5s", "there is none with the waypoint times that were tried"),
        ("one_yaw.mav", "3s", "there is none with the yaw that is planned first"),
    ] {
        let Planned { code, text, report, is_written } =
            planned(&finding(spec), &["--set", &format!("plan.time={time}")]);
        assert!(code == 4 && !is_written, "{spec}: {code} {text}");
        assert!(text.contains(confined) && !text.contains("RIP: proved infeasible"), "{spec}: {text}");
        assert_eq!(report["planners"][0]["verdict"], "not found", "{spec}");
        assert_eq!(report["conflict"]["verdict"], "not found", "{spec}: {:#}", report["conflict"]);
    }
    // With more rounds other plans select too, and here what they select is infeasible where the RIP plan's facets are
    // not.
    let rounds = finding("more_rounds.mav");
    let Planned { code, report, .. } = planned(&rounds, &["--set", "plan.rounds=6"]);
    let told = report["planners"][0]["statement"].as_str().unwrap();
    assert!(code == 3 && told.ends_with(" samples and the facets that RSP guards"), "{told}");
    assert_eq!(planned(&rounds, &[]).code, 0);
    // The statement of the shortest time names its condition in JSON too.
    let Planned { code, report, .. } = planned(&finding("one_yaw.mav"), &["--set", "plan.time=minimum"]);
    let told = report["planners"][0]["statement"].as_str().unwrap();
    assert!(code == 0 && told.ends_with("is proved infeasible with 40 samples and the yaw planned first"), "{told}");
    // Here another yaw does meet what the one planned first does not: within its tolerance it may stay.
    let stays = ["--set", "plan.time=3s", "--set", "plan.samples=40"];
    let folder = tempfile::tempdir().unwrap();
    let held = folder.path().join("held.mav");
    let text = std::fs::read_to_string(finding("one_yaw.mav")).unwrap();
    let text = text.replace("yaw 0 deg", "yaw 45 deg").replace("yaw 90 deg", "yaw 45 deg");
    std::fs::write(&held, text).unwrap();
    assert_eq!(planned(held.to_str().unwrap(), &stays).code, 0);
}

/// Without rounds RSP selects nothing, so that no mode can be in its way; and missions that once ended in a panic, or
/// at rest but for rounding, have plans.
#[test]
fn missions_that_were_missed_or_blamed_on_others() {
    let Planned { code, report, .. } = planned(&finding("no_rounds.mav"), &[]);
    let kinds: Vec<&str> =
        report["conflict"]["statements"].as_array().unwrap().iter().map(|s| s["kind"].as_str().unwrap()).collect();
    assert!(code == 3 && !kinds.contains(&"mode") && report["conflict"]["only_for_selection"] == false, "{kinds:?}");
    for spec in ["ends_in_motion.mav", "carried_to_rest.mav"] {
        let Planned { code, text, .. } = planned(&finding(spec), &[]);
        assert_eq!(code, 0, "{spec}: {text}");
    }
}

/// A conflict is shown at one mission time, and nothing is said of the one that the spec asks for: there these
/// statements hold.
#[test]
fn a_conflict_is_about_the_time_at_which_it_was_tried() {
    let ran = mavc(&["plan", "-v", &finding("long_last_leg.mav")]);
    let told = String::from_utf8(ran.stderr).unwrap().replace("\n  │ ", " ");
    assert!(
        told.contains("cannot hold together in a mission of 61 s, the time that was tried; the spec requires 4 s"),
        "{told}"
    );
}

/// After a plan that ends in motion nothing leads further, but a vehicle that has stopped goes on holding its place.
#[test]
fn a_stop_is_flown_beyond_a_plan_that_ends_in_motion() {
    let spec = finding("hold_after_moving_end.mav");
    let flown = |more: &[&str]| {
        let ran = mavc(&[&["simulate", "-v", &spec], more].concat());
        (ran.status.code(), String::from_utf8(ran.stdout).unwrap())
    };
    let (code, told) = flown(&[]);
    assert!(code == Some(0) && told.contains("Simulated to its end at 20.00 s"), "{told}");
    let (_, told) = flown(&["--set", "simulate.after_fault=continue"]);
    assert!(!told.contains("at 20.00 s") && told.contains(" at 5.00 s"), "{told}");
}
