//! Plans written as missions and maps, measured by formulas that their writers do not use.

use super::places::local;
use super::spec;
use crate::cli::{HOP, err, mavc_with};
use mavc::exchange::mission::{geojson, kml, qgc_plan, wpl};
use mavc::exchange::trajectory::Written;
use mavc::model::Model;
use mavc::motion::Trajectory;
use mavc::{Compiler, PlanOutcome, Spec};
use serde_json::Value;
use std::sync::OnceLock;

const ORIGIN: [f64; 3] = [47.397742, 8.545594, 488.0];

/// From the ground and back to it, with a hold, a turn, and volumes beside and above the path.
const FLIGHT: &str = r#"
mission loop {
    origin_latitude  = 47.397742 deg
    origin_longitude = 8.545594 deg
    origin_altitude  = 488 m
    start at [1, 2, 0] m  yaw 90 deg
    waypoint at [1, 2, 20] m  vertical
    waypoint tower at [40, 10, 25] m  yaw 0 deg
    hold 3 s
    waypoint at [60, 50, 20] m  yaw 135 deg
    waypoint at [1, 2, 20] m
    waypoint at [1, 2, 0] m  vertical
    limits { speed <= 8 m/s; tilt <= 25 deg }
    keep_in field { shape = box; from = [-30, -30, -5] m; to = [90, 90, 60] m }
}
plan { model = hover; planner = rip; time = 50 s; samples = 60 }
"#;

/// A spec and its plan. Volumes to stay out of, which the model of this plan does not know, are added to the spec
/// afterwards.
fn planned() -> &'static (Spec, Trajectory) {
    static PLANNED: OnceLock<(Spec, Trajectory)> = OnceLock::new();
    PLANNED.get_or_init(|| {
        let text = format!("{}{FLIGHT}", super::HEXA.replace("    drag             = 1.6 N*s/m\n", ""));
        let spec = Compiler::new().text("loop.mav", text.as_bytes()).into_result().unwrap();
        let planning = mavc::plan(&spec).unwrap();
        let PlanOutcome::Planned(plan) = planning.outcome() else { panic!("no plan") };
        let pillars = "keep_out pillar { shape = cylinder; centre = [30, 40, 0] m; radius = 2 m; height = 30 m }\n\
                       keep_out shed { shape = box; from = [30, 0, 0] m; to = [34, 30, 4] m }\n    limits {";
        let exact = text.replace("limits {", pillars).replace("model = hover; ", "");
        let with = Compiler::new().text("loop.mav", exact.as_bytes()).into_result().unwrap();
        (with, plan.trajectory.clone())
    })
}

fn written(
    write: fn(&Trajectory, &Model, Option<f64>) -> Result<Written, String>,
    tolerance: Option<f64>,
) -> (String, String) {
    let (spec, trajectory) = planned();
    let written = write(trajectory, spec.model(), tolerance).unwrap();
    (String::from_utf8(written.bytes).unwrap(), written.remark.unwrap())
}

/// The distance of p from the segment between a and b: by a search along it.
fn apart(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let at = |s: f64| (0..3).map(|i| (a[i] + s * (b[i] - a[i]) - p[i]).powi(2)).sum::<f64>().sqrt();
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let (l, h) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if at(l) < at(h) { high = h } else { low = l }
    }
    at(low)
}

/// The largest distance of the plan from lines through points, in whatever order of time.
fn largest(points: &[[f64; 3]]) -> f64 {
    let trajectory = &planned().1;
    let instants = (0..=700).map(|k| trajectory.duration() * f64::from(k) / 700.0);
    let nearest = |t: f64| {
        let state = trajectory.at(t);
        let p = [state[0][0], state[1][0], state[2][0]];
        points.windows(2).map(|pair| apart(p, pair[0], pair[1])).fold(f64::INFINITY, f64::min)
    };
    instants.map(nearest).fold(0.0, f64::max)
}

/// The waypoints of a written mission that is read again, m.
fn read_back(name: &str, text: &str) -> Vec<[f64; 3]> {
    let text = format!("{}{}", spec(name, text), super::HEXA);
    let spec = Compiler::new().text("back.mav", text.as_bytes()).into_result().unwrap();
    // The origin of the spec is the home of the file, to the digits of both.
    let origin = spec.mission().unwrap().origin.unwrap();
    assert!((origin.latitude.to_degrees() - ORIGIN[0]).abs() < 1e-9 && (origin.altitude - ORIGIN[2]).abs() < 1e-9);
    spec.mission().unwrap().waypoints.iter().map(|w| w.position).collect()
}

#[test]
fn missions_come_back_at_the_same_places() {
    for (name, write) in [("back.plan", qgc_plan as fn(&_, &_, _) -> _), ("back.waypoints", wpl)] {
        let (text, remark) = written(write, None);
        let points = read_back(name, &text);
        // Every waypoint of the mission but the start, which is not an item, is one of the file, to 1 cm.
        let trajectory = &planned().1;
        for node in &trajectory.waypoint_nodes[1..] {
            let state = &trajectory.nodes[*node];
            let off = |p: &[f64; 3]| (0..3).map(|i| (p[i] - state[i][0]).powi(2)).sum::<f64>().sqrt();
            let nearest = points.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.01, "{name}: {nearest} m from waypoint at node {node}");
        }
        // The take-off starts below its item, and the home is not part of the way.
        let way: Vec<[f64; 3]> = [[1.0, 2.0, 0.0]].into_iter().chain(points[2..].iter().copied()).collect();
        let deviation = largest(&way);
        assert!(deviation < 0.51, "{name}: {deviation} m");
        let said: f64 = remark.split("within ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        assert!(said <= 0.5 && deviation <= said + 0.02, "{deviation} m, said {said} m");
        assert!(remark.contains("the times of the plan are lost"), "{remark}");
    }
}

#[test]
fn a_smaller_tolerance_takes_more_items() {
    let items = |tolerance: f64| {
        let points = read_back("back.plan", &written(qgc_plan, Some(tolerance)).0);
        let way: Vec<[f64; 3]> = [[1.0, 2.0, 0.0]].into_iter().chain(points[2..].iter().copied()).collect();
        (points.len(), largest(&way))
    };
    let ((coarse, far), (fine, near)) = (items(2.0), items(0.05));
    assert!(coarse < fine && far < 2.01 && near < 0.06, "{coarse} {far}, {fine} {near}");
}

#[test]
fn items_take_off_hold_turn_and_land() {
    let plan: Value = serde_json::from_str(&written(qgc_plan, None).0).unwrap();
    let items = plan["mission"]["items"].as_array().unwrap();
    let commands: Vec<i64> = items.iter().map(|item| item["command"].as_i64().unwrap()).collect();
    assert_eq!((commands[0], commands[commands.len() - 1]), (22, 21), "{commands:?}");
    let places: Vec<&Value> = items.iter().filter(|item| item["command"] != 178).collect();
    let holds: Vec<f64> = places.iter().map(|item| item["params"][0].as_f64().unwrap()).filter(|s| *s > 0.0).collect();
    assert_eq!(holds, [3.0]);
    let tower = places.iter().find(|item| item["params"][0] == 3.0).unwrap();
    assert!((tower["params"][3].as_f64().unwrap() - 90.0).abs() < 3.0, "east is 90 deg clockwise from north: {tower}");
    let speeds: Vec<f64> =
        items.iter().filter(|i| i["command"] == 178).map(|i| i["params"][1].as_f64().unwrap()).collect();
    assert!(!speeds.is_empty() && speeds.iter().all(|speed| (0.3..=8.1).contains(speed)), "{speeds:?}");
    // The pillar is beside the path: an exclusion. The plan flies over the shed, and a fence has no height.
    let fence = &plan["geoFence"];
    assert_eq!(fence["circles"].as_array().unwrap().len(), 1);
    assert_eq!(fence["circles"][0]["inclusion"], false);
    assert_eq!(fence["polygons"].as_array().unwrap().len(), 1);
    assert_eq!(fence["polygons"][0]["inclusion"], true);
    assert!(written(qgc_plan, None).1.ends_with("not a fence, since fences have no heights: shed"));
}

/// The lines between items of the plain text have twelve columns, and 0 is never a heading.
#[test]
fn plain_text_has_the_columns_of_its_readers() {
    let (text, _) = written(wpl, None);
    for (k, line) in text.lines().skip(1).enumerate() {
        let cells: Vec<f64> = line.split('\t').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!((cells.len(), cells[0]), (12, k as f64));
        assert_eq!(cells[7], 0.0, "ArduCopter takes no heading from it: {line}");
    }
}

/// The items of a spec's plan as `QGC WPL`, without the home: twelve numbers each.
fn items_of(spec: &str) -> Vec<Vec<f64>> {
    let spec = Compiler::new().file(spec).unwrap().into_result().unwrap();
    let planning = mavc::plan(&spec).unwrap();
    let PlanOutcome::Planned(plan) = planning.outcome() else { panic!("no plan") };
    let text = String::from_utf8(wpl(&plan.trajectory, spec.model(), None).unwrap().bytes).unwrap();
    let cells = |line: &str| line.split('\t').map(|cell| cell.parse().unwrap()).collect();
    text.lines().skip(2).map(cells).collect()
}

/// Every place but the take-off is reached with its heading, which a turn before it sets.
#[test]
fn turns_are_written_as_ardupilot_reads_them() {
    let items = items_of("tests/specs/findings/turns_at_corners.mav");
    let places: Vec<usize> = (0..items.len()).filter(|k| items[*k][3] == 16.0).collect();
    assert!(places.len() >= 2 && places.iter().all(|k| items[k - 1][3] == 115.0), "{items:?}");
    let heading = |k: usize| items[places[k] - 1][4];
    // Yaws of 0 and 180 deg are east and west.
    assert!((heading(0) - 90.0).abs() < 2.0 && (heading(places.len() - 1) - 270.0).abs() < 2.0, "{items:?}");
    assert!(items.iter().enumerate().all(|(k, item)| item[0] == (k + 1) as f64));
}

/// 0 cm would be the present height.
#[test]
fn no_waypoint_is_written_at_zero_height() {
    let items = items_of("tests/specs/findings/low_waypoints.mav");
    let heights: Vec<f64> = items.iter().filter(|item| item[3] == 16.0).map(|item| item[10]).collect();
    assert!(heights.iter().all(|z| (100.0 * z).trunc() != 0.0), "{heights:?}");
    assert!(heights.iter().filter(|z| z.abs() < 0.05).count() >= 2, "{heights:?}");
}

fn point(numbers: &[f64]) -> [f64; 3] {
    local(ORIGIN, [numbers[1], numbers[0], numbers.get(2).copied().unwrap_or(ORIGIN[2])])
}

#[test]
fn maps_show_the_path_where_it_is() {
    let (text, remark) = written(geojson, None);
    let map: Value = serde_json::from_str(&text).unwrap();
    let features = map["features"].as_array().unwrap();
    let numbers = |value: &Value| value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>();
    let path: Vec<[f64; 3]> =
        features[0]["geometry"]["coordinates"].as_array().unwrap().iter().map(|p| point(&numbers(p))).collect();
    let deviation = largest(&path);
    assert!(deviation < 0.101, "{deviation} m");
    assert!(remark.starts_with("the line is within 0."), "{remark}");
    let kinds: Vec<&str> = features.iter().map(|f| f["geometry"]["type"].as_str().unwrap()).collect();
    assert_eq!(kinds.iter().filter(|kind| **kind == "Point").count(), 6);
    assert_eq!(kinds.iter().filter(|kind| **kind == "Polygon").count(), 3);
    // Rings are closed and run counter-clockwise.
    for feature in features.iter().filter(|f| f["geometry"]["type"] == "Polygon") {
        let ring: Vec<Vec<f64>> =
            feature["geometry"]["coordinates"][0].as_array().unwrap().iter().map(numbers).collect();
        assert_eq!(ring.first(), ring.last());
        let area: f64 = ring.windows(2).map(|p| p[0][0] * p[1][1] - p[1][0] * p[0][1]).sum();
        assert!(area > 0.0);
    }
    let pillar = features.iter().find(|f| f["properties"]["name"] == "pillar").unwrap();
    assert_eq!(
        (pillar["properties"]["bottom_m"].as_f64(), pillar["properties"]["top_m"].as_f64()),
        (Some(488.0), Some(518.0))
    );
}

#[test]
fn kml_is_well_formed_and_has_the_same_path() {
    let (text, _) = written(kml, None);
    let mut open: Vec<&str> = Vec::new();
    for tag in text.split('<').skip(2).map(|rest| rest.split('>').next().unwrap()) {
        match tag.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name)),
            None => open.push(tag.split_whitespace().next().unwrap()),
        }
    }
    assert!(open.is_empty(), "{open:?}");
    let path =
        text.split("<altitudeMode>absolute</altitudeMode><coordinates>").nth(1).unwrap().split('<').next().unwrap();
    let points: Vec<[f64; 3]> =
        path.split(' ').map(|p| point(&p.split(',').map(|x| x.parse().unwrap()).collect::<Vec<f64>>())).collect();
    assert!(largest(&points) < 0.101);
}

#[test]
fn without_an_origin_the_field_is_named_before_anything_is_planned() {
    for format in ["qgc-plan", "wpl", "kml", "geojson"] {
        let ran = mavc_with(&["plan", "-v", "-", "-o", "-", "--format", format], HOP);
        assert_eq!(ran.status.code(), Some(2));
        assert!(err(&ran).contains("give its `origin_latitude`"), "{}", err(&ran));
    }
    let ran = mavc_with(&["plan", "-v", "-", "-o", "-", "--format", "kml", "--rate", "5Hz"], HOP);
    assert!(err(&ran).contains("leave --frame and --rate out"), "{}", err(&ran));
}
