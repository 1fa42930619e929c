//! Commands agree: `mavc simulate` flies the plan that `mavc plan` writes, also one that was planned again.

use crate::cli::{folder, mavc_in};
use mavc::model::Problem;
use mavc::planner::studies::{Scope, run_planners};
use std::path::Path;

/// A table of numbers by the names of its columns; words are NaN.
fn columns(file: &Path, names: &[&str]) -> Vec<Vec<f64>> {
    let table = std::fs::read_to_string(file).unwrap();
    let mut lines = table.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let places: Vec<usize> = names
        .iter()
        .map(|name| header.iter().position(|h| h == name).unwrap_or_else(|| panic!("no column {name}")))
        .collect();
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        places.iter().map(|&place| cells[place]).collect()
    };
    lines.map(row).collect()
}

/// The largest difference between the rows of two tables in m and rad.
fn farthest(one: &[Vec<f64>], other: &[Vec<f64>]) -> f64 {
    assert_eq!(one.len(), other.len());
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).inspect(|d| assert!(d.is_finite())).fold(0.0, f64::max)
}

/// Place and yaw of the plan of a spec, every 10 ms, as planned and as the reference of a flight.
fn planned_and_flown(spec: &str) -> [Vec<Vec<f64>>; 2] {
    let dir = folder();
    std::fs::write(dir.path().join("s.mav"), spec).unwrap();
    let (code, out, errors) = mavc_in(dir.path(), &["plan", "s.mav", "-o", "plan.csv", "--rate", "100Hz"]);
    assert_eq!(code, 0, "{out}{errors}");
    let (code, out, errors) = mavc_in(dir.path(), &["simulate", "s.mav", "-o", "flight.csv"]);
    assert_eq!(code, 0, "{out}{errors}");
    let planned = columns(&dir.path().join("plan.csv"), &["t", "x", "y", "z", "yaw"]);
    let flown = columns(&dir.path().join("flight.csv"), &["t", "x_ref", "y_ref", "z_ref", "yaw_ref"]);
    [planned, flown]
}

/// The survey's plan has a second pass.
#[test]
fn a_flight_follows_the_second_pass_of_a_plan() {
    let spec = include_str!("../../examples/survey_hexa.mav");
    let [planned, flown] = planned_and_flown(spec);
    assert!(farthest(&planned, &flown) < 1e-9, "{}", farthest(&planned, &flown));

    let compiled = mavc::compile(spec).into_result().unwrap();
    let comparison = run_planners(Problem::of(compiled.model()).unwrap(), Scope::Plan, None);
    let run = comparison.runs.last().unwrap();
    let (plan, plainer) = (run.outcome.plan().unwrap(), run.plainer.as_deref().expect("a second pass"));
    let place = |row: &[f64], motion: &mavc::motion::Trajectory| {
        let state = motion.at(row[0]);
        vec![row[0], state[0][0], state[1][0], state[2][0]]
    };
    let rows = |motion| planned.iter().map(|row| place(row, motion)).collect::<Vec<_>>();
    let places: Vec<Vec<f64>> = planned.iter().map(|row| row[..4].to_vec()).collect();
    assert!(farthest(&rows(&plan.trajectory), &places) < 1e-9);
    // The plan before it is another one, so that flying it would fail this test.
    assert!(farthest(&rows(&plainer.trajectory), &places) > 0.05);
}

/// A plan that was planned again for ways out after faults (`require uncovered`).
#[test]
fn a_flight_follows_a_plan_that_was_planned_again() {
    let spec = crate::recovery::with_gaps("");
    let [first, flown] = planned_and_flown(&spec);
    assert!(farthest(&first, &flown) < 1e-9, "{}", farthest(&first, &flown));
    let [again, flown] = planned_and_flown(&crate::recovery::with_gaps("    require uncovered <= 0 %"));
    assert!(farthest(&again, &flown) < 1e-9, "{}", farthest(&again, &flown));
    assert!(farthest(&again, &first) > 0.05, "{}", farthest(&again, &first));
}
