//! Legs: shapes, limits of their own, stops and directions of arrival, by closed forms that share nothing with the
//! code.

use crate::cli::{mavc, mavc_with};
use mavc::model::{Heading, Limit, LimitKind, Part};
use mavc::verify::interval::Interval;
use mavc::verify::limits;
use proptest::prelude::*;
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;
use std::path::{Path, PathBuf};

const OCTO: &str = "vehicle octo {
    layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
";

fn run(args: &[&str]) -> (Option<i32>, String) {
    let output = mavc(args);
    let text = if output.stdout.is_empty() { output.stderr } else { output.stdout };
    (output.status.code(), String::from_utf8(text).unwrap())
}

/// A spec with this mission and plan, in a folder.
fn write(folder: &Path, mission: &str, plan: &str) -> PathBuf {
    let path = folder.join("legs.mav");
    std::fs::write(&path, format!("{OCTO}mission m {{\n{mission}\n}}\nplan {{ planner = rip; {plan} }}\n")).unwrap();
    path
}

fn limits_of(mission: &str) -> Vec<Limit> {
    let folder = tempfile::tempdir().unwrap();
    let spec = mavc::Compiler::new().file(write(folder.path(), mission, "")).unwrap().into_result().unwrap();
    spec.model().mission.clone().unwrap().limits
}

/// One row of a trajectory table: time, position, velocity, acceleration, jerk, and the waypoint that it marks.
struct Row {
    t: f64,
    p: [f64; 3],
    v: [f64; 3],
    a: [f64; 3],
    j: [f64; 3],
    yaw: f64,
    waypoint: usize,
}

fn rows(csv: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(csv).unwrap();
    let headers = reader.headers().unwrap().clone();
    let column = |name: &str| headers.iter().position(|h| h == name).unwrap();
    let read = |row: csv::StringRecord| {
        let at = |name: &str| row[column(name)].parse::<f64>().unwrap();
        let three = |prefix: &str| ["x", "y", "z"].map(|axis| at(&format!("{prefix}{axis}")));
        let waypoint = at("waypoint") as usize;
        Row { t: at("t"), p: three(""), v: three("v"), a: three("a"), j: three("j"), yaw: at("yaw"), waypoint }
    };
    reader.records().map(|row| read(row.unwrap())).collect()
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The rows of the leg that arrives at a waypoint, counted from 1: between the rows that mark its ends, which may be up
/// to half a step outside.
fn leg(rows: &[Row], to: usize) -> &[Row] {
    let at = |waypoint: usize| rows.iter().position(|row| row.waypoint == waypoint).unwrap();
    &rows[at(to - 1) + 1..at(to)]
}

fn largest(rows: &[Row], value: impl Fn(&Row) -> f64) -> f64 {
    rows.iter().map(value).fold(f64::NEG_INFINITY, f64::max)
}

const MISSION: &str = "start at [0, 0, 2] m
    waypoint up at [0, 0, 10] m  vertical  { climb <= 2 m/s; tilt <= 8 deg }
    waypoint at [12, 0, 10] m  straight  { speed <= 3 m/s }
    waypoint b at [12, 10, 9] m  stop
    waypoint c at [0, 10, 8] m  corridor 50 cm  arrive from [1, 0, 0]
    waypoint at [0, 0, 2] m  within 10 cm
    limits { speed <= 9 m/s }";

/// A motion of the mission at every row: shapes, limits, rest and arrival, to within the checker's tolerances.
fn keeps_its_legs(csv: &Path) {
    let rows = rows(csv);
    assert!(rows.len() > 4000, "{}", rows.len());
    let over =
        |what: &str, found: f64, most: f64| assert!(found <= most + 1e-4 * most.max(1.0), "{what}: {found} of {most}");
    let up = leg(&rows, 2);
    over("vertical", largest(up, |r| r.p[0].hypot(r.p[1])), 0.05);
    over("past its ends", largest(up, |r| (2.0 - r.p[2]).max(r.p[2] - 10.0)), 0.05);
    over("climb", largest(up, |r| r.v[2]), 2.0);
    let out = |r: &Row| r.a[0].hypot(r.a[1]) * 8f64.to_radians().cos() - (r.a[2] + 9.81) * 8f64.to_radians().sin();
    over("tilt", largest(up, out) / 9.81, 0.0);
    let along = leg(&rows, 3);
    over("straight", largest(along, |r| r.p[1].hypot(r.p[2] - 10.0)), 0.05);
    over("past its ends", largest(along, |r| (-r.p[0]).max(r.p[0] - 12.0)), 0.05);
    over("speed", largest(along, |r| norm(r.v)), 3.0);
    let stop = rows.iter().position(|r| r.waypoint == 4).unwrap();
    let stop = rows[stop - 1..=stop + 1].iter().min_by(|a, b| norm(a.v).total_cmp(&norm(b.v))).unwrap();
    // Near the stop the velocity grows with the third power of the time: at most half a millisecond away.
    assert!(norm(stop.v) < 1e-4 && norm(stop.a) < 0.05, "{:?} {:?}", stop.v, stop.a);
    let corridor = leg(&rows, 5);
    let [x, y, z] = [-12.0, 0.0, -1.0].map(|part: f64| part / 145f64.sqrt());
    let aside = |r: &Row| {
        let from = [r.p[0] - 12.0, r.p[1] - 10.0, r.p[2] - 9.0];
        let ahead = from[0] * x + from[1] * y + from[2] * z;
        norm([from[0] - ahead * x, from[1] - ahead * y, from[2] - ahead * z])
    };
    over("corridor", largest(corridor, aside), 0.5);
    let arrival = corridor.last().unwrap();
    let angle = arrival.v[1].hypot(arrival.v[2]).atan2(-arrival.v[0]);
    // The row is within half a millisecond of the waypoint.
    assert!(angle <= 5.1f64.to_radians() && norm(arrival.v) > 1.0, "{angle} {:?}", arrival.v);
    // Limits of one leg do not hold on others.
    assert!(largest(&rows, |r| norm(r.v)) > 5.0 && largest(&rows, |r| r.j[0].abs()) > 0.0);
    assert!(rows.windows(2).all(|pair| pair[0].t < pair[1].t));
}

/// Plans the mission and checks it at 1 kHz and by its certificate; then a certificate for a slower leg is refused
/// there.
fn plan_and_check(plan: &str) {
    let folder = tempfile::tempdir().unwrap();
    let spec = write(folder.path(), MISSION, plan);
    let spec = spec.to_str().unwrap();
    let [csv, proof] = ["plan.csv", "proof.json"].map(|name| folder.path().join(name));
    let outputs = ["-o", csv.to_str().unwrap(), "--rate", "1kHz", "--certificate", proof.to_str().unwrap()];
    let (code, text) = run(&[&["plan", "-v", spec][..], &outputs].concat());
    assert_eq!(code, Some(0), "{text}");
    keeps_its_legs(&csv);
    let (code, text) = run(&["verify", proof.to_str().unwrap(), spec]);
    assert_eq!(code, Some(0), "{text}");
    for shown in [
        "vertical leg to waypoint `up`",
        "limit on climb on the leg to waypoint `up`",
        "limit on tilt on the leg to waypoint `up`",
        "straight leg to waypoint 3",
        "limit on speed on the leg to waypoint 3",
        "corridor to waypoint `c`",
    ] {
        let line = text.lines().find(|line| line.starts_with(shown)).unwrap_or_else(|| panic!("{shown}\n{text}"));
        assert!(line.ends_with("proved at every instant"), "{line}");
    }
    let line = text.lines().find(|line| line.contains("direction of arrival at waypoint `c`")).unwrap();
    assert!(line.ends_with("at the nodes"), "{line}");
    let certificate: Value = serde_json::from_slice(&std::fs::read(&proof).unwrap()).unwrap();
    for (from, to, refused) in [
        ("climb <= 2 m/s", "climb <= 1.9 m/s", "climb on the leg to waypoint `up`"),
        ("speed <= 3 m/s", "speed <= 2.9 m/s", "speed on the leg to waypoint 3"),
        ("corridor 50 cm", "corridor 1 cm", "corridor to waypoint `c`"),
        ("arrive from [1, 0, 0]", "arrive from [1, 0.3, 0]", "direction of arrival at waypoint `c`"),
        ("within 10 cm", "within 10 cm  straight", "straight leg to waypoint 6"),
        ("waypoint c at [0, 10, 8] m", "waypoint c at [0, 10, 8] m  stop", "rest"),
    ] {
        let text = if to.ends_with("stop") { MISSION.replace("arrive from [1, 0, 0]", "") } else { MISSION.into() };
        let other = write(folder.path(), &text.replace(from, to), plan);
        let other = mavc::Compiler::new().file(&other).unwrap().into_result().unwrap();
        let mut forged = certificate.clone();
        forged["spec_sha256"] = other.sha256().into();
        let answer = mavc::verify(forged.to_string().as_bytes(), &other).map(|verdict| verdict.headline);
        assert!(format!("{answer:?}").contains(refused), "{to}: {answer:?}");
    }
}

#[test]
fn a_plan_keeps_its_legs() {
    plan_and_check("time = 22 s; samples = 80");
}

/// A limit of one leg bounds the time of that leg: 10 m at 1 m/s after 10 m at up to 8 m/s. The bound is a certificate.
#[test]
fn limits_of_a_leg_bound_its_time() {
    let folder = tempfile::tempdir().unwrap();
    let mission = |limits: &str| {
        format!(
            "start at [0, 0, 2] m
    waypoint at [10, 0, 2] m
    waypoint at [20, 0, 2] m {limits}
    waypoint at [30, 0, 2] m
    limits {{ speed <= 8 m/s }}"
        )
    };
    let proof = folder.path().join("proof.json");
    let proof = proof.to_str().unwrap();
    for model in ["exact", "hover"] {
        let plan = format!("model = {model}; samples = 20; time = 11 s; timing = optimal");
        let spec = write(folder.path(), &mission("{ speed <= 1 m/s }"), &plan);
        let (code, text) = run(&["plan", "-v", spec.to_str().unwrap(), "--certificate", proof]);
        assert_eq!(code, Some(3), "{text}");
        // 9.9 m at 1 m/s and twice at 8 m/s, less what the checker allows; each of the latter has an end at rest, which
        // takes more.
        let claim: Value = serde_json::from_slice(&std::fs::read(proof).unwrap()).unwrap();
        let soonest = claim["claim"]["too_early"]["soonest_s"].as_f64().unwrap_or_else(|| panic!("{claim}"));
        assert!((9.9 + 2.0 * 9.9 / 8.0 - 2e-3..13.0).contains(&soonest), "{soonest}");
        let (code, text) = run(&["verify", proof, spec.to_str().unwrap()]);
        assert_eq!(code, Some(0), "{text}");
        let spec = write(folder.path(), &mission(""), &plan);
        let (code, text) = run(&["plan", "-v", spec.to_str().unwrap()]);
        assert_eq!(code, Some(0), "{text}");
    }
}

/// The limits that each clause imposes, by hand.
#[test]
fn clauses_impose_limits_on_their_leg() {
    let limits = limits_of(
        "start at [1, 2, 3] m  within 20 cm
    waypoint at [1, 2, 13] m  vertical
    waypoint b at [4, 6, 13] m  corridor 2 m
    waypoint at [5, 6, 13] m  arrive from [0, 0, 3]  { speed <= 4 m/s; altitude in 1 m .. 20 m }
    waypoint at [9, 6, 13] m
    limits { tilt <= 30 deg }",
    );
    let leg_of = |limit: &Limit| limit.leg.as_ref().map(|on| on.leg);
    let legs: Vec<_> = limits.iter().map(leg_of).collect();
    assert_eq!(legs, [None, Some(0), Some(0), Some(0), Some(1), Some(1), Some(1), Some(2), Some(2), Some(2)]);
    let uppers: Vec<f64> = limits.iter().map(|limit| limit.upper.unwrap()).collect();
    let tilt = 30f64.to_radians();
    let ahead = (3.0 * 4.0 + 4.0 * 6.0) / 5.0;
    let back = -(3.0 * 1.0 + 4.0 * 2.0) / 5.0;
    let due = [tilt, 0.2, 13.2, -2.8, 2.0, ahead + 2.0, back + 2.0, 5f64.to_radians(), 4.0, 20.0];
    assert!(uppers.iter().zip(due).all(|(found, due)| (found - due).abs() < 1e-12), "{uppers:?} {due:?}");
    assert_eq!(limits[7].kind, LimitKind::Arrival([-0.0, -0.0, -1.0]));
    assert_eq!(limits[9].lower, Some(1.0));
    // (2, 2, 13) is 0.6 x 1 + 0.8 x 0 ahead on the line of the second leg and 0.8 aside.
    assert!((limits[4].value_at([2.0, 2.0, 13.0]).unwrap() - 0.8).abs() < 1e-12);
}

/// A formatted leg: clauses apart by two blanks, braces on one line or on lines of their own.
#[test]
fn legs_are_formatted() {
    let spec = "mission m {
start at [0, 0, 2] m
waypoint a at [0, 0, 5] m   vertical stop {climb<=2 m/s;tilt<=8 deg}
waypoint b at [9, 0, 5] m yaw  along   path
waypoint at [9, 0, 5] m yaw towards b yaw_within 3 deg corridor 2 m arrive  from [1,0,0] {
speed<=3 m/s
acceleration <= 2 m/s^2
}
}
";
    let due = "mission m {
    start at [0, 0, 2] m
    waypoint a at [0, 0, 5] m  vertical  stop { climb <= 2 m/s; tilt <= 8 deg }
    waypoint b at [9, 0, 5] m  yaw along path
    waypoint at [9, 0, 5] m  yaw towards b  yaw_within 3 deg  corridor 2 m  arrive from [1, 0, 0] {
        speed        <= 3 m/s
        acceleration <= 2 m/s^2
    }
}
";
    let output = mavc_with(&["fmt", "-"], spec);
    assert_eq!(String::from_utf8(output.stdout).unwrap(), due);
    // The tree printed and parsed is the same tree.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.mav");
    std::fs::write(&path, due).unwrap();
    let (_, ast) = run(&["emit", "ast", path.to_str().unwrap()]);
    std::fs::write(&path, &ast).unwrap();
    let (_, again) = run(&["emit", "ast", path.to_str().unwrap()]);
    assert_eq!(ast, again);
    assert!(ast.contains("yaw along path") && ast.contains("yaw towards b"), "{ast}");
    assert!(ast.contains("arrive from [1, 0, 0]") && ast.contains("acceleration <= 2 m/s^2"), "{ast}");
}

/// The yaw of a plan follows its rules at every node, by the table alone; forged specs with other rules are refused.
#[test]
fn the_yaw_follows_from_the_motion() {
    const YAWS: &str = "start at [0, 0, 2] m  yaw towards mast
    waypoint mast at [8, 5, 3] m  yaw along path  yaw_within 6 deg
    waypoint at [16, 0, 4] m  within 20 cm
    waypoint at [20, 8, 4] m  stop
    waypoint at [6, 9, 4] m  within 20 cm
    waypoint b at [0, 6, 3] m  yaw towards [20, 20, 0] m
    waypoint at [-6, 0, 2] m
    waypoint at [0, -4, 2] m  yaw free
    waypoint at [4, 0, 2] m  yaw 90 deg
    limits { speed <= 5 m/s; tilt <= 30 deg }";
    const PLAN: &str = "time = 32 s; samples = 140";
    let folder = tempfile::tempdir().unwrap();
    let spec = write(folder.path(), YAWS, PLAN);
    let spec = spec.to_str().unwrap();
    let [csv, proof] = ["plan.csv", "proof.json"].map(|name| folder.path().join(name));
    let outputs = ["-o", csv.to_str().unwrap(), "--certificate", proof.to_str().unwrap(), "--report", "-"];
    let (code, text) = run(&[&["plan", "-v", spec][..], &outputs].concat());
    assert_eq!(code, Some(0), "{text}");
    let report: Value = serde_json::from_str(&text).unwrap();
    let rows = rows(&csv);
    let at = |waypoint: usize| rows.iter().position(|row| row.waypoint == waypoint).unwrap();
    let off = |row: &Row, direction: [f64; 2], least: f64| {
        let error = row.yaw - direction[1].atan2(direction[0]);
        let error = error - std::f64::consts::TAU * (error / std::f64::consts::TAU).round();
        (direction[0].hypot(direction[1]) >= least).then_some(error.abs().to_degrees())
    };
    let along = |row: &Row| off(row, [row.v[0], row.v[1]], 0.3);
    let towards = |row: &Row, x: f64, y: f64| off(row, [x - row.p[0], y - row.p[1]], 0.211);
    type Error<'a> = &'a dyn Fn(&Row) -> Option<f64>;
    let checks: [(usize, usize, Error, f64); 5] = [
        (1, 1, &|row| towards(row, 8.0, 5.0), 2.0),
        // The tolerance is written at the mast alone.
        (2, 2, &along, 6.0),
        (2, 5, &along, 2.0),
        (6, 7, &|row| towards(row, 20.0, 20.0), 2.0),
        (9, 9, &|row| Some(((row.yaw.to_degrees() - 90.0 + 180.0).rem_euclid(360.0) - 180.0).abs()), 2.0),
    ];
    for (from, to, error, within) in checks {
        let errors: Vec<f64> = rows[at(from)..=at(to)].iter().filter_map(error).collect();
        assert!(!errors.is_empty(), "{from} {to}");
        let most = errors.iter().copied().fold(0.0, f64::max);
        assert!(most <= within + 0.01, "waypoints {from} to {to}: {most} of {within}");
    }
    // The path turns by more than a right angle at the stop, and the yaw with it.
    let turned = (rows[at(5)].yaw - rows[at(4) - 3].yaw).to_degrees().abs();
    assert!(turned > 60.0, "{turned}");
    let told = report["planners"][0]["headings"].as_array().unwrap();
    let names: Vec<&str> = told.iter().map(|row| row["name"].as_str().unwrap()).collect();
    assert_eq!(names[0], "yaw at waypoint 1");
    assert!(
        names.contains(&"yaw on the leg to waypoint 4") && names.contains(&"yaw on the leg to waypoint 7"),
        "{names:?}"
    );
    for row in told {
        let [tolerance, nodes, largest] = ["tolerance_rad", "at_nodes_rad", "largest_rad"].map(|key| row[key].as_f64());
        assert!(nodes.is_none_or(|nodes| nodes <= tolerance.unwrap() + 1e-4 && nodes <= largest.unwrap()), "{row}");
    }
    let (code, text) = run(&["verify", proof.to_str().unwrap(), spec]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("yaw on the leg to waypoint 4 within 2 deg (between the nodes "), "{text}");
    let certificate: Value = serde_json::from_slice(&std::fs::read(&proof).unwrap()).unwrap();
    for (from, to, refused) in [
        ("yaw towards [20, 20, 0] m", "yaw towards [20, 16, 0] m", "yaw on the leg to waypoint 7"),
        ("waypoint at [20, 8, 4] m  stop", "waypoint at [20, 8, 4] m  stop  yaw towards b", "yaw"),
        ("yaw free", "yaw free\n    waypoint at [2, -3, 2] m", "times"),
        ("yaw towards mast", "yaw towards b", "yaw at waypoint 1"),
    ] {
        let other = write(folder.path(), &YAWS.replace(from, to), PLAN);
        let other = mavc::Compiler::new().file(&other).unwrap().into_result().unwrap();
        let mut forged = certificate.clone();
        forged["spec_sha256"] = other.sha256().into();
        let answer = mavc::verify(forged.to_string().as_bytes(), &other).map(|verdict| verdict.headline);
        assert!(format!("{answer:?}").contains(refused), "{to}: {answer:?}");
    }
}

/// A rule continues until another yaw is given, and holds on the legs between two waypoints with one rule.
#[test]
fn rules_of_the_yaw_continue() {
    let folder = tempfile::tempdir().unwrap();
    let mission = "start at [0, 0, 2] m  yaw along path
    waypoint at [9, 0, 2] m
    waypoint a at [9, 9, 2] m  yaw towards b
    curve s in 0 .. 1, points = 3 { x = 9 m - s * 4 m; y = 12 m; z = 2 m }
    waypoint b at [0, 12, 2] m  yaw 180 deg
    waypoint at [0, 20, 2] m
    waypoint at [9, 20, 2] m  yaw free
    waypoint at [9, 30, 2] m  yaw towards [9, 40, 0] m";
    let spec = mavc::Compiler::new().file(write(folder.path(), mission, "")).unwrap().into_result().unwrap();
    let mission = spec.model().mission.clone().unwrap();
    let to_b = Heading::Towards([0.0, 12.0]);
    let rules: Vec<Heading> = mission.waypoints.iter().map(|w| w.heading).collect();
    let given = Heading::Given;
    let due = [
        Heading::AlongPath,
        Heading::AlongPath,
        to_b,
        to_b,
        to_b,
        to_b,
        given,
        given,
        Heading::Free,
        Heading::Towards([9.0, 40.0]),
    ];
    assert_eq!(rules, due);
    let parts: Vec<(usize, Part)> =
        mission.limits.iter().map(|l| l.leg.as_ref().unwrap()).map(|on| (on.leg, on.part)).collect();
    assert_eq!(parts, [(0, Part::Whole), (2, Part::Whole), (3, Part::Whole), (4, Part::Whole), (8, Part::End)]);
    // The yaw at the waypoints as they tell it: east, west by north west, west, and so on by the shorter way.
    let yaws: Vec<f64> = mission.waypoints.iter().map(|w| w.yaw.to_degrees()).collect();
    let to_b = 3f64.atan2(-9.0).to_degrees();
    let due = [0.0, 0.0, to_b, 180.0, 180.0, 180.0, 180.0, 180.0, 180.0, 90.0];
    assert!(yaws.iter().zip(due).all(|(found, due)| (found - due).abs() < 1e-9), "{yaws:?}");
    // A rule in the hover model is refused.
    let text = std::fs::read_to_string(folder.path().join("legs.mav")).unwrap().replace("rip;", "rip; model = hover;");
    let codes: Vec<&str> = mavc::compile(&text).diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["mavc::mission::heading_model"]);
}

proptest! {
    /// The checker's violation of a yaw that follows is the sine of the error less the tolerance, 1 beyond a right
    /// angle, and none near the point.
    #[test]
    fn the_checker_knows_the_error_of_the_yaw(p in prop::array::uniform2(-9.0..9.0f64), yaw in -9.0..9.0f64) {
        let limits = limits_of("start at [9, 9, 3] m  yaw towards [1, -2, 0] m; waypoint at [4, 9, 3] m  yaw 0 deg");
        prop_assert!(limits[0].kind.is_heading());
        let family = limits::family(&limits[0], &mavc::model::Environment::vacuum(9.81), Some((0, 0)));
        let mut state = [[Interval::ZERO; 6]; 4];
        for (axis, value) in [(0, p[0]), (1, p[1]), (3, yaw)] {
            state[axis][0] = Interval::point(value);
        }
        let found = (family.evaluate)(&state, &[0])[0].value;
        let (x, y) = (1.0 - p[0], -2.0 - p[1]);
        let error = (yaw.cos() * x + yaw.sin() * y) / x.hypot(y);
        let off = error.clamp(-1.0, 1.0).acos() - 2f64.to_radians();
        let due = if x.hypot(y) < 0.211 { -1.0 } else { off.min(FRAC_PI_2).sin() };
        prop_assert!((found.high - due).abs() < 1e-6 && (found.high - found.low).abs() < 1e-9, "{:?} {}", found, due);
    }

    /// The checker's bound on the distance from a line holds over boxes of positions, and is sharp at points.
    #[test]
    fn the_checker_bounds_distances_from_a_line(p in prop::array::uniform3(-9.0..9.0f64), half in 0.0..0.5f64, at in prop::array::uniform3(-1.0..1.0f64)) {
        let limits = limits_of("start at [1, 2, 3] m; waypoint at [4, 6, 15] m  corridor 2 m");
        let along = [3.0, 4.0, 12.0].map(|part: f64| part / 13.0);
        let distance = |p: [f64; 3]| {
            let from = [p[0] - 1.0, p[1] - 2.0, p[2] - 3.0];
            let cross = [
                from[1] * along[2] - from[2] * along[1],
                from[2] * along[0] - from[0] * along[2],
                from[0] * along[1] - from[1] * along[0],
            ];
            norm(cross)
        };
        let family = limits::family(&limits[0], &mavc::model::Environment::vacuum(9.81), None);
        let violation = |half: f64| {
            let mut state = [[Interval::ZERO; 6]; 4];
            for (axis, value) in state.iter_mut().zip(p) {
                axis[0] = Interval::new(value - half, value + half);
            }
            (family.evaluate)(&state, &[0])[0].value
        };
        let inside: [f64; 3] = std::array::from_fn(|i| p[i] + half * at[i]);
        let over = violation(half);
        prop_assert!(over.low <= distance(inside) - 2.0 + 1e-9 && distance(inside) - 2.0 <= over.high + 1e-9);
        let here = violation(0.0);
        prop_assert!((here.high - (distance(p) - 2.0)).abs() < 1e-9 && (here.low - (distance(p) - 2.0)).abs() < 1e-9);
    }

    /// The checker's violation of a direction of arrival is the distance of the velocity from the cone.
    #[test]
    fn the_checker_knows_directions_of_arrival(v in prop::array::uniform3(-9.0..9.0f64)) {
        let limits = limits_of("start at [1, 2, 3] m; waypoint at [4, 6, 15] m  arrive from [-2, 1, 2]; waypoint at [9, 6, 15] m");
        prop_assert!(limits[0].kind.is_arrival());
        let family = limits::family(&limits[0], &mavc::model::Environment::vacuum(9.81), Some((1, 1)));
        let mut state = [[Interval::ZERO; 6]; 4];
        for (axis, value) in state.iter_mut().zip(v) {
            axis[1] = Interval::point(value);
        }
        let found = (family.evaluate)(&state, &[0])[0].value;
        let ahead = (2.0 * v[0] - v[1] - 2.0 * v[2]) / 3.0;
        let angle = (ahead / norm(v)).clamp(-1.0, 1.0).acos() - 5f64.to_radians();
        // Where the velocity points backwards the apex of the cone is nearest.
        let due = if norm(v) == 0.0 { 0.0 } else { norm(v) * angle.min(FRAC_PI_2).sin() };
        prop_assert!((found.high - due).abs() < 1e-9, "{:?} {}", found, due);
        prop_assert!((found.high - found.low).abs() < 1e-9);
    }
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// Proofs of infeasibility use the rows of a leg at the nodes of that leg: here a turn has too little time for its
    /// corridor.
    #[test]
    #[ignore = "long"]
    fn proofs_use_the_rows_of_legs() {
        let folder = tempfile::tempdir().unwrap();
        let proof = folder.path().join("proof.json");
        let proof = proof.to_str().unwrap();
        let mission = |clauses: &str| {
            format!(
                "start at [0, 0, 5] m
        waypoint at [8, 0, 5] m
        waypoint at [8, 8, 5] m  {clauses}
        limits {{ tilt <= 30 deg; speed <= 6 m/s }}"
            )
        };
        let plan =
            |model: &str, time: &str| format!("model = {model}; time = {time}; samples = 40; timing = proportional");
        let shortest = |clauses: &str| {
            let spec = write(folder.path(), &mission(clauses), &plan("hover", "minimum"));
            let (code, text) = run(&["plan", "-v", spec.to_str().unwrap(), "--report", "-"]);
            assert_eq!(code, Some(0), "{text}");
            serde_json::from_str::<Value>(&text).unwrap()["planners"][0]["time_s"].as_f64().unwrap()
        };
        let free = shortest("");
        let mut longer = 0;
        for clauses in [
            "corridor 20 cm",
            "straight  { jerk <= 20 m/s^3 }",
            "{ speed <= 5 m/s }",
            "{ jerk <= 12 m/s^3 }",
            "{ altitude <= 5.01 m; x <= 8.01 m; tilt <= 25 deg }",
        ] {
            let bound = shortest(clauses);
            assert!(bound >= free, "{clauses}: {bound} {free}");
            if bound < 1.01 * free {
                continue;
            }
            longer += 1;
            let spec = write(folder.path(), &mission(clauses), &plan("hover", &format!("{free} s")));
            let (code, text) = run(&["plan", "-v", spec.to_str().unwrap(), "--certificate", proof]);
            assert_eq!(code, Some(3), "{clauses}: {text}");
            let (code, text) = run(&["verify", proof, spec.to_str().unwrap()]);
            assert_eq!(code, Some(7), "{clauses}: {text}");
            assert!(text.contains("proved infeasible on one grid"), "{clauses}: {text}");
        }
        assert!(longer >= 3, "{longer}");
    }

    /// In the hover model limits hold at the nodes; so do those of legs, and stops are at rest.
    #[test]
    #[ignore = "long"]
    fn the_hover_model_keeps_legs_at_its_nodes() {
        let folder = tempfile::tempdir().unwrap();
        let spec = write(folder.path(), MISSION, "model = hover; samples = 100");
        let [csv, proof] = ["plan.csv", "proof.json"].map(|name| folder.path().join(name));
        let outputs = ["-o", csv.to_str().unwrap(), "--certificate", proof.to_str().unwrap()];
        let (code, text) = run(&[&["plan", "-v", spec.to_str().unwrap()][..], &outputs].concat());
        assert_eq!(code, Some(0), "{text}");
        let rows = rows(&csv);
        let near = |found: f64, most: f64| assert!(found <= most + 1e-5, "{found} of {most}");
        near(largest(leg(&rows, 2), |r| r.p[0].hypot(r.p[1])), 0.05);
        near(largest(leg(&rows, 2), |r| r.v[2]), 2.0);
        near(largest(leg(&rows, 3), |r| norm(r.v)), 3.0);
        near(largest(leg(&rows, 3), |r| r.p[1].hypot(r.p[2] - 10.0)), 0.05);
        let [stop, arrival] = [4, 5].map(|waypoint| rows.iter().find(|r| r.waypoint == waypoint).unwrap());
        assert_eq!((stop.v, stop.a), ([0.0; 3], [0.0; 3]));
        assert!(arrival.v[1].hypot(arrival.v[2]).atan2(-arrival.v[0]) < 5.001f64.to_radians(), "{:?}", arrival.v);
        assert!(largest(&rows, |r| norm(r.v)) > 5.0);
        let (code, text) = run(&["verify", proof.to_str().unwrap(), spec.to_str().unwrap()]);
        // Between the nodes of this model limits are exceeded, as ever.
        assert!(code == Some(7) && text.contains("100 pieces join") && text.contains("is a plan of"), "{text}");
    }

    /// The same in the shortest time.
    #[test]
    #[ignore = "long"]
    fn the_shortest_plan_keeps_its_legs() {
        plan_and_check("samples = 150");
    }
}
