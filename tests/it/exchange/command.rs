//! The options of the command: what goes together, and what is written where.

use crate::cli::{HOP, err, mavc_with, out};
use std::fs;

fn refused(arguments: &[&str], expected: &str) {
    let ran = mavc_with(&[&[arguments[0], "-"], &arguments[1..]].concat(), HOP);
    assert_eq!(ran.status.code(), Some(2), "{arguments:?}");
    assert!(err(&ran).contains(expected), "{arguments:?}: {}", err(&ran));
}

#[test]
fn options_that_mean_nothing_are_refused_before_planning() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("traj");
    let to = path.to_str().unwrap();
    refused(
        &["plan", "-o", to, "--format", "px5"],
        "possible values: csv, rows, px4, px4-offboard, ardupilot-guided, crazyflie",
    );
    refused(&["plan", "--format", "px4"], "--output");
    refused(
        &["plan", "-o", to, "--format", "px4", "--frame", "enu-flu"],
        "--format px4 fixes its frames (north, east, down",
    );
    refused(
        &["plan", "-o", to, "--format", "rosbag2", "--frame", "ned-frd"],
        "--format rosbag2 fixes its frames (east, north, up",
    );
    refused(&["plan", "-o", to, "--frame", "ned"], "possible values: enu-flu, ned-frd");
    refused(
        &["plan", "-o", to, "--format", "crazyflie", "--rate", "50Hz"],
        "--format crazyflie, which has polynomials instead of rows",
    );
    refused(
        &["plan", "-o", to, "--format", "rows", "--tolerance", "1cm"],
        "--tolerance has no effect with --format rows",
    );
    for wrong in ["1", "1km", "0mm", "-1cm", "x mm"] {
        let tolerance = format!("--tolerance={wrong}");
        refused(&["plan", "-o", to, "--format", "crazyflie", &tolerance], "write a length such as 1cm");
    }
    refused(&["simulate", "-o", to, "--format", "rosbag2"], "possible values: csv, mcap, ulog");
    refused(&["simulate", "-o", to, "--format", "csv", "--layout", to], "--format csv has no layout");
    refused(&["simulate", "-o", to, "--format", "ulog", "--layout", to], "give --layout its own name");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is written");
}

#[test]
fn a_bag_is_a_folder_or_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let plan = |to: &str| mavc_with(&["plan", "-v", "-", "-o", to, "--format", "rosbag2"], HOP);
    let ran = plan(&at("my bag"));
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(out(&ran).contains("\nTrajectory written to "), "{}", out(&ran));
    let metadata = fs::read_to_string(at("my bag/metadata.yaml")).unwrap();
    assert!(metadata.contains("    - bag_mybag_0.mcap\n"), "{metadata}");
    let inside = fs::read(at("my bag/bag_mybag_0.mcap")).unwrap();
    assert_eq!(plan(&at("plan.mcap")).status.code(), Some(0));
    assert!(inside == fs::read(at("plan.mcap")).unwrap());
    assert!(inside == plan("-").stdout, "standard output takes the same bytes");
    // A file is no folder.
    fs::write(at("taken"), "").unwrap();
    let ran = plan(&at("taken"));
    assert!(ran.status.code() == Some(2) && err(&ran).contains("cannot write"), "{}", err(&ran));
    assert_eq!(fs::read(at("taken")).unwrap(), b"");
}

#[test]
fn the_default_is_csv_and_a_refit_says_what_it_lost() {
    let plan = |arguments: &[&str]| mavc_with(&[&["plan", "-", "-o", "-"], arguments].concat(), HOP);
    let [plain, named] = [plan(&[]), plan(&["--format", "csv", "--frame", "enu-flu"])];
    assert!(plain.status.code() == Some(0) && plain.stdout == named.stdout && !plain.stdout.is_empty());
    let refit = plan(&["--format", "crazyflie", "--tolerance", "2 cm"]);
    assert!(err(&refit).contains("mavc: refitted by ") && err(&refit).contains("position within "), "{}", err(&refit));
    assert!(!err(&plan(&["--format", "crazyflie", "-q"])).contains("refitted"));
}
