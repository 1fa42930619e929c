//! Volumes: plans stay inside `keep_in` and outside `keep_out`, by closed forms that share nothing with the code.

use crate::cli::mavc;
use mavc::admissible::AdmissibleSet;
use mavc::model::{Limit, LimitKind, Problem};
use mavc::motion::wrench_model::WrenchModel;
use mavc::planner::hover::{Decision, HoverPlanner};
use mavc::planner::scp::{ScpPlanner, ScpSettings};
use mavc::planner::selection::sets::PlanningSets;
use mavc::verify::interval::Interval;
use mavc::verify::limits;
use proptest::prelude::*;
use std::path::Path;

type Point = [f64; 3];

/// The distance of p from an axis-aligned box.
fn from_box(p: Point, low: Point, high: Point) -> f64 {
    let out = |i: usize| (low[i] - p[i]).max(p[i] - high[i]).max(0.0);
    (0..3).map(|i| out(i).powi(2)).sum::<f64>().sqrt()
}

/// The distance of p from an upright cylinder.
fn from_cylinder(p: Point, centre: [f64; 2], radius: f64, bottom: f64, top: f64) -> f64 {
    let across = ((p[0] - centre[0]).hypot(p[1] - centre[1]) - radius).max(0.0);
    across.hypot((bottom - p[2]).max(p[2] - top).max(0.0))
}

/// By how much p is inside all edges of a counter-clockwise polygon.
fn inside(p: Point, corners: &[[f64; 2]]) -> f64 {
    let edge = |(a, b): (&[f64; 2], &[f64; 2])| {
        let (x, y) = (b[0] - a[0], b[1] - a[1]);
        (x * (p[1] - a[1]) - y * (p[0] - a[0])) / x.hypot(y)
    };
    corners.iter().zip(corners.iter().cycle().skip(1)).map(edge).fold(f64::INFINITY, f64::min)
}

fn run(args: &[&str]) -> (Option<i32>, String) {
    let output = mavc(args);
    let text = if output.stdout.is_empty() { output.stderr } else { output.stdout };
    (output.status.code(), String::from_utf8(text).unwrap())
}

/// Positions of a trajectory at 500 Hz.
fn positions(csv: &Path) -> Vec<Point> {
    let mut reader = csv::Reader::from_path(csv).unwrap();
    let columns: Vec<usize> =
        ["x", "y", "z"].map(|name| reader.headers().unwrap().iter().position(|h| h == name).unwrap()).to_vec();
    let row = |row: csv::StringRecord| [0, 1, 2].map(|i| row[columns[i]].parse().unwrap());
    reader.records().map(|r| row(r.unwrap())).collect()
}

/// The shipped mission: the distances of the plan from every volume, at 500 Hz, and the certificate.
fn keeps_its_volumes(time: &str, samples: usize) {
    let folder = tempfile::tempdir().unwrap();
    let [csv, proof] = ["plan.csv", "proof.json"].map(|name| folder.path().join(name));
    let spec = "specs/missions/mast_octo.mav";
    let [in_time, sampled] = [format!("plan.time={time}"), format!("plan.samples={samples}")];
    let settings = ["--set", "plan.planner=rip", "--set", &in_time, "--set", &sampled];
    let outputs = ["-o", csv.to_str().unwrap(), "--rate", "500Hz", "--certificate", proof.to_str().unwrap()];
    let (code, text) = run(&[&["plan", "-v", spec, "--report", "-"], &settings[..], &outputs].concat());
    assert_eq!(code, Some(0), "{text}");
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    // The vehicle: the arm and the propeller.
    let size = 0.211 + 0.13;
    let field = [[-5.0, -15.0], [40.0, -15.0], [40.0, 20.0], [30.0, 30.0], [-5.0, 30.0]];
    let distances = |p: Point| {
        let shed = [
            [[24.0, 7.0, 0.0], [34.0, 10.0, 9.0]],
            [[24.0, 10.0, 0.0], [27.0, 13.0, 9.0]],
            [[24.0, 13.0, 0.0], [34.0, 16.0, 9.0]],
        ];
        let from_shed = shed.iter().map(|[low, high]| from_box(p, *low, *high)).fold(f64::INFINITY, f64::min);
        let from_mast = from_cylinder(p, [15.0, 0.3], 0.4, 0.0, 30.0);
        let in_field = inside(p, &field).min(p[2]).min(25.0 - p[2]);
        [in_field - size, from_mast - size, from_shed - size]
    };
    let path = positions(&csv);
    assert!(path.len() > 3000, "{}", path.len());
    let nearest = path.iter().map(|p| distances(*p)).reduce(|a, b| [0, 1, 2].map(|i| a[i].min(b[i]))).unwrap();
    for (i, due) in [0.0, 2.0, 0.5].into_iter().enumerate() {
        // The checker allows 0.1 mm.
        assert!(nearest[i] >= due - 1e-4, "volume {i}: {nearest:?}");
        let told = report["planners"][0]["volumes"][i]["distance_m"].as_f64().unwrap();
        assert!((told - nearest[i]).abs() < 2e-3, "volume {i}: {told} {nearest:?}");
    }
    // The mast stands in the way, and the plan passes it as near as it may.
    assert!(nearest[1] < 2.05, "{nearest:?}");
    let (code, text) = run(&[&["verify", proof.to_str().unwrap(), spec], &settings[..]].concat());
    assert_eq!(code, Some(0), "{text}");
    for volume in ["keep_in field", "keep_out mast", "keep_out shed"] {
        let line = text.lines().find(|line| line.starts_with(volume)).unwrap_or_else(|| panic!("{text}"));
        assert!(line.ends_with("proved at every instant"), "{line}");
    }
    // Where the mast is thicker, the same motion is refused at a node, or reported to come too near between two.
    let certificate = std::fs::read_to_string(&proof).unwrap();
    let thicker = std::fs::read_to_string(spec)
        .unwrap()
        .replace("radius    = 40 cm", "radius    = 50 cm")
        .replace("planner = rsp; time = minimum", &format!("planner = rip; time = {time}; samples = {samples}"));
    let other = folder.path().join("thicker.mav");
    std::fs::write(&other, thicker).unwrap();
    let other_spec = mavc::Compiler::new().file(&other).unwrap().into_result().unwrap();
    let mut forged: serde_json::Value = serde_json::from_str(&certificate).unwrap();
    forged["spec_sha256"] = other_spec.sha256().into();
    let refused = mavc::verify(forged.to_string().as_bytes(), &other_spec).map(|verdict| verdict.weaker);
    assert!(format!("{refused:?}").contains("keep_out mast"), "{refused:?}");
}

#[test]
fn a_plan_keeps_its_volumes() {
    keeps_its_volumes("20s", 40);
}

/// The page and the figures show the volumes, their kept boundaries and the marks, as far as there are any.
#[test]
fn pages_and_figures_show_volumes() {
    let folder = tempfile::tempdir().unwrap();
    let [page, figures] = ["page.html", "figures"].map(|name| folder.path().join(name));
    let spec = "specs/missions/mast_octo.mav";
    let settings = ["--set", "plan.planner=rip", "--set", "plan.samples=40", "--set", "plan.time=20s"];
    let outputs = ["--html", page.to_str().unwrap(), "--svg", figures.to_str().unwrap(), "--report", "-"];
    let (code, text) = run(&[&["plan", "-v", spec], &settings[..], &outputs].concat());
    assert_eq!(code, Some(0), "{text}");
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    let html = std::fs::read_to_string(&page).unwrap();
    let open = r#"<script id="content" type="application/json">"#;
    let content = &html[html.find(open).unwrap() + open.len()..];
    let content: serde_json::Value = serde_json::from_str(&content[..content.find("</script>").unwrap()]).unwrap();
    let volumes = content["volumes"].as_array().unwrap();
    let names: Vec<&str> = volumes.iter().map(|v| v["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["keep_in field", "keep_out mast", "keep_out shed"]);
    // The circle that the centre of gravity keeps about the mast: its radius, the arm, the propeller and the clearance.
    let points = |line: &serde_json::Value| -> Vec<[f64; 2]> { serde_json::from_value(line.clone()).unwrap() };
    for p in points(&volumes[1]["above"]["kept"][0]) {
        assert!(((p[0] - 15.0).hypot(p[1] - 0.3) - (0.4 + 0.211 + 0.13 + 2.0)).abs() < 1e-4, "{p:?}");
    }
    // The shed is drawn by parts, and its edge once.
    assert!(volumes[2]["above"]["areas"].as_array().unwrap().len() > 1);
    let length: f64 = volumes[2]["above"]["edge"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|line| {
            points(line).windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).collect::<Vec<_>>()
        })
        .sum();
    assert!((length - 52.0).abs() < 1e-3, "{length}");
    let records = report["planners"][0]["volumes"].as_array().unwrap();
    let marks = content["runs"][0]["nearest"].as_array().unwrap();
    assert_eq!(marks.len(), 3);
    for (i, (mark, record)) in marks.iter().zip(records).enumerate() {
        for axis in 0..3 {
            let [a, b] = [&mark["at"], &record["position_m"]].map(|p| p[axis].as_f64().unwrap());
            assert!((a - b).abs() < 1e-3, "{mark} {record}");
        }
        let column = content["runs"][0]["columns"][format!("volume_{i}")].as_array().unwrap();
        let least = column.iter().map(|d| d.as_f64().unwrap()).fold(f64::INFINITY, f64::min);
        assert!((least - record["distance_m"].as_f64().unwrap()).abs() < 0.05, "{least} {record}");
    }
    assert!(html.contains("Table of volumes"));
    for figure in ["path-above.svg", "path-side.svg", "distance.svg"] {
        let svg = std::fs::read_to_string(figures.join(figure)).unwrap();
        for name in names.iter() {
            assert!(svg.contains(name), "{figure} {name}");
        }
    }
    // Without volumes there is nothing of them.
    let spec = "specs/missions/inspection.mav";
    let (code, text) = run(&[
        "plan",
        spec,
        "--set",
        "plan.samples=40",
        "--html",
        page.to_str().unwrap(),
        "--svg",
        figures.join("b").to_str().unwrap(),
    ]);
    assert_eq!(code, Some(0), "{text}");
    let html = std::fs::read_to_string(&page).unwrap();
    let content = &html[html.find(open).unwrap()..];
    let content = &content[..content.find("</script>").unwrap()];
    assert!(!content.contains("\"volumes\"") && !content.contains("\"nearest\"") && !html.contains("Table of volumes"));
    assert!(!figures.join("b/path-above.svg").exists());
}

/// What `simulate` reports of volumes is the smallest distance of the positions that it logs.
#[test]
fn flights_report_how_near_they_came() {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("flight.csv");
    let settings = ["--set", "plan.planner=rip", "--set", "plan.samples=40", "--set", "plan.time=20s"];
    let report = folder.path().join("report.json");
    let outputs = ["-o", csv.to_str().unwrap(), "--rate", "500Hz", "--report", report.to_str().unwrap()];
    let (code, text) = run(&[&["simulate", "-v", "specs/missions/mast_octo.mav"], &settings[..], &outputs].concat());
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("Smallest distance in the flight of the vehicle"), "{text}");
    let report: serde_json::Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
    crate::schemas::schema("simulate").assert_valid(&report);
    let mast = &report["volumes"][1];
    assert_eq!(mast["name"], "mast");
    let distance = |p: &Point| from_cylinder(*p, [15.0, 0.3], 0.4, 0.0, 30.0) - 0.211 - 0.13;
    let nearest = positions(&csv).iter().map(distance).fold(f64::INFINITY, f64::min);
    let told = mast["distance_m"].as_f64().unwrap();
    assert!((told - nearest).abs() < 2e-3, "{told} {nearest}");
    // The flight deviates from its plan, which keeps 2 m.
    assert!(told > 1.5 && (told - 2.0).abs() > 1e-4, "{told}");
    let (_, text) =
        run(&["simulate", "-v", "specs/missions/inspection.mav", "--set", "plan.samples=40", "--report", "-"]);
    assert!(!text.contains("\"volumes\""), "{text}");
}

/// The largest index of a limit in a certificate.
fn largest_limit(json: &serde_json::Value) -> Option<u64> {
    let own = json.get("limit").and_then(serde_json::Value::as_u64);
    let inner: Vec<&serde_json::Value> = match json {
        serde_json::Value::Array(all) => all.iter().collect(),
        serde_json::Value::Object(all) => all.values().collect(),
        _ => Vec::new(),
    };
    inner.into_iter().filter_map(largest_limit).chain(own).max()
}

/// A limit of one volume of a spec.
fn limit(volume: &str, is_kind: fn(&LimitKind) -> bool) -> Limit {
    let text = format!(
        "use \"tests/specs/parts/quad.mav\"
allow = [unknown_size]
mission m {{ start at [40, 40, 40] m; waypoint at [50, 40, 40] m; {volume} }}"
    );
    let folder = tempfile::tempdir().unwrap();
    let quad = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/parts/quad.mav");
    std::fs::copy(quad, folder.path().join("quad.mav")).unwrap();
    let path = folder.path().join("one.mav");
    std::fs::write(&path, text.replace("tests/specs/parts/", "")).unwrap();
    let spec = mavc::Compiler::new().file(&path).unwrap().into_result().unwrap();
    let mission = spec.model().mission.clone().unwrap();
    mission.limits.into_iter().find(|limit| is_kind(&limit.kind)).unwrap()
}

/// The limit of a `keep_out` with these fields.
fn keep_out(fields: &str) -> Limit {
    limit(&format!("keep_out c {{ {fields} }}"), LimitKind::is_clearance)
}

proptest! {
    /// The checker's bounds on the distance hold over boxes of positions, and are sharp at points outside. The upper
    /// one is as near as the box is small, so that a proof about a volume that is entered is given up soon.
    #[test]
    fn the_checker_bounds_distances(p in prop::array::uniform3(-9.0..9.0f64), half in 0.0..0.5f64, at in prop::array::uniform3(-1.0..1.0f64)) {
        let cylinder = keep_out("shape = cylinder; centre = [1, -2, 0] m; radius = 1.5 m; height = 5 m");
        let cuboid = keep_out("shape = box; from = [-1, -3, 0] m; to = [2, 3, 4] m");
        let ball = keep_out("shape = sphere; centre = [1, 2, 3] m; radius = 2 m");
        let hill = keep_out("shape = half_space; point = [0, 0, 1] m; normal = [0.6, 0, 0.8]");
        type Distance = fn(Point) -> f64;
        let known: [(&Limit, Distance); 4] = [
            (&cylinder, |p| from_cylinder(p, [1.0, -2.0], 1.5, 0.0, 5.0)),
            (&cuboid, |p| from_box(p, [-1.0, -3.0, 0.0], [2.0, 3.0, 4.0])),
            (&ball, |p| ((p[0] - 1.0).hypot(p[1] - 2.0).hypot(p[2] - 3.0) - 2.0).max(0.0)),
            (&hill, |p| (0.6 * p[0] + 0.8 * (p[2] - 1.0)).max(0.0)),
        ];
        for (limit, distance) in known {
            let margin = limit.lower.unwrap();
            let family = limits::family(limit, &mavc::model::Environment::vacuum(9.81), None);
            let violation = |half: f64| {
                let mut state: mavc::verify::motion::State = [[Interval::ZERO; 6]; 4];
                for axis in 0..3 {
                    state[axis][0] = Interval::new(p[axis] - half, p[axis] + half);
                }
                (family.evaluate)(&state, &[0])[0].value
            };
            let q = [0, 1, 2].map(|i| p[i] + half * at[i]);
            prop_assert!(margin - distance(q) <= violation(half).high + 1e-12);
            // Inside, where distances are negative for the checker, at least the violation of the boundary.
            prop_assert!(violation(half).low >= margin - distance(p) - 2.0 * half - 1e-9);
            if distance(p) > 1e-6 {
                let found = violation(0.0).high;
                prop_assert!((found - (margin - distance(p))).abs() < 1e-9, "{} {}", found, distance(p));
            }
            if distance(q) > 0.0 {
                prop_assert!(violation(half).low <= margin - distance(q) + 1e-9);
            }
        }
    }
}

/// A turn inside `count` polygons of 200 corners about [x, 0], each turned a little.
fn inside_polygons(count: usize, x: f64, radius: f64) -> String {
    let corner = |k: usize, i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / 200.0 + 0.001 * k as f64;
        format!("[{:.5}, {:.5}]", x + radius * angle.cos(), radius * angle.sin())
    };
    let polygon = |k: usize| {
        let corners: Vec<String> = (0..200).map(|i| corner(k, i)).collect();
        let corners = corners.join(", ");
        format!("keep_in p{k} {{ shape = polygon; corners = [{corners}] m; bottom = 0 m; top = 30 m }}\n")
    };
    let polygons: String = (0..count).map(polygon).collect();
    format!(
        "vehicle octo {{
    layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 0.3 m
    rotor {{ max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }}
}}
mission turn {{
    start at [0, 0, 10] m
    waypoint at [4, 2, 10] m
    waypoint at [4, -2, 10] m
    {polygons}
}}
plan {{ planner = rip; time = 6 s; samples = 24 }}"
    )
}

/// What a plan costs, and how many rows its last program has, with at most so many rows of volumes in every program.
fn planned_with(spec: &str, max_rows_of_volumes: usize) -> (f64, usize) {
    let spec = mavc::compile(spec).into_result().unwrap();
    let (healthy, sets) = (AdmissibleSet::healthy(spec.model()), PlanningSets::of(spec.model()));
    let mut settings = ScpSettings::DEFAULT;
    settings.subproblem.max_rows_of_volumes = max_rows_of_volumes;
    let mut hover = HoverPlanner::new(Problem::of(spec.model()).unwrap(), &healthy);
    let mut planner = ScpPlanner::with_settings(&mut hover, WrenchModel::Exact, &sets.rip, settings);
    match planner.decide(6.0, &[]) {
        Decision::Feasible(planned) => (planned.objective, planned.rows),
        _ => panic!("no plan"),
    }
}

/// Where volumes have more rows than fit in memory at their bounds, programs have those near the plan.
#[test]
fn programs_do_not_hold_every_row_of_many_volumes() {
    let spec = inside_polygons(21, 2.0, 20.0);
    let sides = 21 * 200;
    let (_, rows) = planned_with(&spec, ScpSettings::DEFAULT.subproblem.max_rows_of_volumes);
    assert!(rows < sides, "{rows} rows of {sides} sides at 25 nodes");
}

/// Plans that touch their volumes cost the same whether programs have all rows of volumes or get those that are
/// violated.
#[test]
fn rows_of_volumes_that_are_added_make_the_same_plan() {
    // Its side is 0.1 m beyond the waypoints, between which the quickest turn goes further out.
    let spec = inside_polygons(1, -20.0, 24.4);
    let ((all, every), (added, some)) = (planned_with(&spec, 100_000), planned_with(&spec, 0));
    let (free, _) = planned_with(&inside_polygons(1, 2.0, 20.0), 0);
    assert!(all > 1.01 * free, "the volume does not matter: {all} {free}");
    assert!((added - all).abs() < 1e-3 * all, "{added} {all}");
    assert!(some < every / 2, "{some} rows of {every}");
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn the_shortest_plan_keeps_its_volumes() {
        keeps_its_volumes("minimum", 80);
    }

    /// The shortest way leads over the hedge, where the vehicle climbs slowly: another side is quicker, and is found.
    #[test]
    #[ignore = "long"]
    fn the_quickest_of_several_sides_is_flown() {
        let spec = mavc::compile(
            "vehicle octo {
        layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 0.35 m
        rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
    }
    mission over_or_around {
        start at [0, 0, 3] m
        waypoint at [20, 0, 3] m
        keep_out hedge { shape = box; from = [9, -6, 0] m; to = [11, 6, 6] m }
        limits { speed <= 8 m/s; tilt <= 35 deg; climb <= 1 m/s; descent <= 1 m/s }
    }
    plan { planner = rip; time = minimum; samples = 40 }",
        )
        .into_result()
        .unwrap();
        let problem = Problem::of(spec.model()).unwrap();
        let (healthy, sets) = (AdmissibleSet::healthy(spec.model()), PlanningSets::of(spec.model()));
        let shortest = |sides: usize| {
            let mut settings = ScpSettings::DEFAULT;
            settings.guidance.sides = sides;
            let mut hover = HoverPlanner::new(problem, &healthy);
            let mut planner = ScpPlanner::with_settings(&mut hover, WrenchModel::Exact, &sets.rip, settings);
            let found = planner.shortest(&[], None).unwrap();
            println!("{sides} other sides: {} s, {:?}", found.time, hover.effort);
            (found.time, found.planned.states.iter().map(|s| s[1][0].abs()).fold(0.0, f64::max))
        };
        // Over it: up by 3.35 m and down again, at 1 m/s.
        let (over, aside) = shortest(0);
        assert!(over > 6.7 && aside < 1.0, "{over} s, {aside} m aside");
        let (around, aside) = shortest(4);
        assert!(around < 5.5 && aside > 6.0, "{around} s, {aside} m aside");
    }

    /// A turn in a narrow room takes longer than one without walls, and that it takes longer is proved by the walls'
    /// own rows.
    #[test]
    #[ignore = "long"]
    fn rooms_make_missions_longer_and_proofs_use_their_walls() {
        let folder = tempfile::tempdir().unwrap();
        let spec = |room: &str, time: &str| {
            let path = folder.path().join("turn.mav");
            let text = format!(
                "vehicle octo {{
        layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 0.3 m
        rotor {{ max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }}
    }}
    mission turn {{
        start at [0, 0, 5] m
        waypoint at [8, 0, 5] m
        waypoint at [8, 8, 5] m
        {room}
        limits {{ tilt <= 30 deg; speed <= 6 m/s }}
    }}
    plan {{ model = hover; planner = rip; time = {time}; samples = 40; timing = proportional }}
    "
            );
            std::fs::write(&path, text).unwrap();
            path.to_str().unwrap().to_string()
        };
        let shortest = |room: &str| {
            let (code, text) = run(&["plan", "-v", &spec(room, "minimum"), "--report", "-"]);
            assert_eq!(code, Some(0), "{text}");
            serde_json::from_str::<serde_json::Value>(&text).unwrap()["planners"][0]["time_s"].as_f64().unwrap()
        };
        let free = shortest("");
        for room in [
            "keep_in room { shape = box; from = [-2, -2, 0] m; to = [8.4, 10, 12] m; turn = 1 deg }",
            "keep_in room { shape = sphere; centre = [-40, 4, 5] m; radius = 48.5 m }",
        ] {
            let walled = shortest(room);
            assert!(walled > free, "{room}: {walled} {free}");
            let proof = folder.path().join("proof.json");
            let proof = proof.to_str().unwrap();
            let between = spec(room, &format!("{free} s"));
            let (code, text) = run(&["plan", "-v", &between, "--certificate", proof]);
            assert_eq!(code, Some(3), "{room}: {text}");
            // The proof holds for this grid, which is less than the spec requires.
            let (code, text) = run(&["verify", proof, &between]);
            assert_eq!(code, Some(7), "{room}: {text}");
            assert!(text.contains("proved infeasible on one grid"), "{room}: {text}");
            // The limits before those of the room are on tilt and speed.
            let rows: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(proof).unwrap()).unwrap();
            assert!(largest_limit(&rows) >= Some(2), "{room}: {rows}");
        }
    }
}
