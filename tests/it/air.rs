//! Drag and wind in plans, against closed forms, finite differences and the checker's own equations.

use crate::cli::mavc;
use crate::vehicles::octocopter;
use mavc::actuation::Wrench;
use mavc::certificate::DynamicModel;
use mavc::model::{Environment, Model};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::verify::interval::Interval;
use mavc::verify::motion::State;
use mavc::verify::wrench::Dynamics;
use mavc::{Compiler, PlanOutcome, Spec};

const RATE: f64 = 0.21;

const AIR: Environment = Environment {
    gravity: 9.81,
    drag_rates: [RATE; 3],
    wind: [4.0, -2.0, 0.7],
    wind_spread: [0.0; 3],
    yaw_at_rest: 0.0,
};

fn state(numbers: impl Fn(usize, usize) -> f64) -> NodeState {
    std::array::from_fn(|axis| std::array::from_fn(|order| numbers(axis, order)))
}

/// Some motion with all derivatives.
fn lively(phase: f64) -> NodeState {
    state(|axis, order| (1.0 + phase + 1.7 * axis as f64 + 0.9 * order as f64).sin() * [3.0, 6.0, 2.5, 4.0, 6.0][order])
}

#[test]
fn level_flight_at_constant_speed_needs_the_thrust_of_the_closed_form() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let drag = RATE * vehicle.mass;
    let still = Environment { wind: [0.0; 3], ..AIR };
    for speed in [0.0, 5.0, 14.0] {
        let flight = state(|axis, order| if (axis, order) == (X, 1) { speed } else { 0.0 });
        let wrench = WrenchModel::Exact.wrench(&vehicle, &still, &flight);
        let thrust = (vehicle.mass * still.gravity).hypot(drag * speed);
        assert!((wrench[0] - thrust).abs() < 1e-12 * thrust, "{speed}: {wrench:?}");
        assert!(wrench.rows(1, 3).amax() < 1e-12, "{speed}: {wrench:?}");
        let tilt = mavc::motion::tilt(&flight, &still);
        assert!((tilt - (drag * speed).atan2(vehicle.mass * still.gravity)).abs() < 1e-14, "{tilt}");
    }
    // Only the velocity through the air matters.
    let with_it = state(|axis, order| if order == 1 && axis < YAW { AIR.wind[axis] } else { 0.0 });
    let wrench = WrenchModel::Exact.wrench(&vehicle, &AIR, &with_it);
    assert!((wrench[0] - vehicle.mass * AIR.gravity).abs() < 1e-12 && wrench.rows(1, 3).amax() < 1e-12);
}

/// The planner's wrench against the checker's, whose equations are series of the attitude in time.
#[test]
fn the_wrench_in_air_is_the_checkers() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let dynamics = Dynamics { vehicle: &vehicle, environment: AIR, model: DynamicModel::Exact, one_yaw: None };
    for k in 0..50 {
        let now = lively(0.37 * k as f64);
        let expected = WrenchModel::Exact.wrench(&vehicle, &AIR, &now);
        if now[Z][2] + AIR.gravity + RATE * (now[Z][1] - AIR.wind[Z]) < 2.0 {
            continue;
        }
        let enclosed: State = now.map(|axis| {
            let mut all = [Interval::point(0.0); 6];
            for (slot, value) in all.iter_mut().zip(axis) {
                *slot = Interval::point(value);
            }
            all
        });
        for (found, wanted) in dynamics.value(&enclosed).iter().zip(expected.iter()) {
            let scale = 1e-9 * (1.0 + wanted.abs());
            assert!(found.low - scale <= *wanted && *wanted <= found.high + scale, "{k}: {found:?} {wanted}");
            assert!(found.high - found.low < 1e-6, "{k}: {found:?}");
        }
    }
}

#[test]
fn the_linear_map_in_air_is_the_derivative() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let at = lively(0.2);
    let map = WrenchModel::Exact.linearised(&vehicle, &AIR, &at);
    let wrench = |s: &NodeState| WrenchModel::Exact.wrench(&vehicle, &AIR, s);
    assert!((map.at(&at) - wrench(&at)).amax() < 1e-11);
    for axis in [X, Y, Z, YAW] {
        for order in 0..5 {
            let moved = |by: f64| {
                let mut moved = at;
                moved[axis][order] += by;
                wrench(&moved)
            };
            let h = 1e-5;
            let slope = (moved(h) - moved(-h)) / (2.0 * h);
            let of_map: Wrench = map.terms.iter().filter(|t| (t.0, t.1) == (axis, order)).map(|t| t.2).sum();
            assert!((slope - of_map).amax() < 1e-7 * (1.0 + slope.amax()), "{axis} {order}: {slope} {of_map}");
        }
    }
}

#[test]
fn corners_are_those_of_the_box() {
    let uncertain = Environment { wind_spread: [1.0, 0.0, 0.5], ..AIR };
    let corners = uncertain.corners();
    assert_eq!(corners.len(), 4);
    for (x, z) in [(3.0, 0.2), (3.0, 1.2), (5.0, 0.2), (5.0, 1.2)] {
        assert!(corners.iter().any(|c| (c.wind[0] - x).abs() < 1e-12 && (c.wind[2] - z).abs() < 1e-12), "{x} {z}");
    }
    assert!(corners.iter().all(|c| c.wind_spread == [0.0; 3]));
    // Wind that acts on nothing is no uncertainty.
    assert_eq!(Environment { drag_rates: [0.0; 3], ..uncertain }.corners().len(), 1);
}

fn dash(air: &str, more: &str) -> String {
    format!(
        "vehicle octo {{
            layout = \"PPNNPPNN\"
            arm = 0.211 m
            mass = 1.8 kg
            inertia = [0.0429, 0.0429, 0.0748] kg*m^2
            drag = 0.35 N*s/m
            rotor {{ max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }}
        }}
        faults {{ every 1 rotor lost as M }}
        mission dash {{
            start at [0, 0, 5] m
            waypoint at [25, 0, 5] m
            {air}
            limits {{ tilt <= 30 deg }}
        }}
        plan {{ planner = rip; samples = 24 }}
        {more}"
    )
}

fn compiled(text: &str) -> Spec {
    Compiler::new().text("dash.mav", text.as_bytes()).into_result().unwrap()
}

fn planned(spec: &Spec) -> (Trajectory, f64) {
    match mavc::plan(spec).unwrap().outcome() {
        PlanOutcome::Planned(plan) => (plan.trajectory.clone(), plan.time),
        other => panic!("{other:?}"),
    }
}

/// The largest violation of the healthy set and of the limit on tilt in a wind, at 40 instants a piece.
fn worst(model: &Model, plan: &Trajectory, wind: [f64; 3]) -> (f64, f64) {
    let set = mavc::admissible::AdmissibleSet::healthy(model);
    let kept = set.with_reserve(model.plan.reserve);
    let environment = Environment { wind, wind_spread: [0.0; 3], ..model.environment() };
    let (mut out, mut tilt) = (f64::NEG_INFINITY, 0.0_f64);
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        for i in 0..=40 {
            let state = plan.within(k, h * f64::from(i) / 40.0);
            let wrench = plan.wrench(&model.vehicle, &environment, &state);
            for facet in &kept.polytope.facets {
                let width = set.zonotope.width(&facet.normal);
                out = out.max((facet.normal.dot(&wrench) - facet.offset) / width);
            }
            tilt = tilt.max(mavc::motion::tilt(&state, &environment));
        }
    }
    (out, tilt.to_degrees())
}

#[test]
#[ignore = "long"]
fn a_plan_stays_in_its_set_and_tilt_in_its_wind() {
    let spec = compiled(&dash("air { wind = [-6, 0, 0] m/s }", ""));
    let (plan, _) = planned(&spec);
    let (out, tilt) = worst(spec.model(), &plan, [-6.0, 0.0, 0.0]);
    assert!(out < 1e-4 && tilt < 30.01, "{out} {tilt}");
    // The tilt limit is tight in this wind, and a plan that knows no wind violates it.
    assert!(tilt > 29.9, "{tilt}");
    let calm = compiled(&dash("", ""));
    let (of_calm, _) = planned(&calm);
    let (_, blown) = worst(calm.model(), &of_calm, [-6.0, 0.0, 0.0]);
    assert!(blown > 35.0, "{blown}");
}

/// A plan in an interval of winds, with its certificate: accepted in full, and true in winds inside.
fn proved_in_every_wind(air: &str, winds: impl Fn(f64, f64, f64) -> [f64; 3], more: &str) {
    let folder = tempfile::tempdir().unwrap();
    let [path, proof] = ["dash.mav", "proof.json"].map(|name| folder.path().join(name));
    let text = dash(air, "").replace("samples = 24", &format!("samples = 24; {more}"));
    let text = text.replace("874 rad/s }", "874 rad/s; time_constant = 40 ms }");
    std::fs::write(&path, &text).unwrap();
    let [path, proof] = [&path, &proof].map(|path| path.to_str().unwrap());
    let output = mavc(&["plan", "-v", path, "--certificate", proof]);
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{printed}{}", String::from_utf8_lossy(&output.stderr));
    assert!(
        printed.split_whitespace().collect::<Vec<_>>().join(" ").contains("every imposed facet in every wind"),
        "{printed}"
    );
    let verified = mavc(&["verify", proof, path]);
    let printed = String::from_utf8_lossy(&verified.stdout).into_owned();
    assert_eq!(verified.status.code(), Some(0), "{printed}{}", String::from_utf8_lossy(&verified.stderr));
    assert!(printed.contains("inside the set of healthy, in every wind"), "{printed}");
    let spec = compiled(&text);
    let (plan, _) = planned(&spec);
    for k in 0..27 {
        let part = |place: i32| f64::from(place % 3 - 1);
        let wind = winds(part(k), part(k / 3), part(k / 9));
        let (out, tilt) = worst(spec.model(), &plan, wind);
        assert!(out < 1e-4 && tilt < 30.01, "{wind:?}: {out} {tilt}");
    }
}

#[test]
fn a_plan_stays_in_its_set_in_every_wind_of_an_interval() {
    let winds = |x: f64, y: f64, z: f64| [6.0 + 2.0 * x, 2.0 * y, 0.5 * z];
    proved_in_every_wind("air { wind = [6, 0, 0] m/s +- [2, 2, 0.5] m/s }", winds, "time = 5 s");
}

#[test]
#[ignore = "long"]
fn times_grow_with_the_wind() {
    let time = |wind: u32| planned(&compiled(&dash(&format!("air {{ wind = [-{wind}, 0, 0] m/s }}"), ""))).1;
    let times = [0, 8].map(time);
    // Against the wind.
    assert!(times[0] < times[1], "{times:?}");
}

/// The certificate is accepted, and the plan flown in its air stays near its reference.
#[test]
fn certificates_and_flights_have_the_air_of_the_plan() {
    let folder = tempfile::tempdir().unwrap();
    let [spec, proof, still] = ["dash.mav", "proof.json", "still.mav"].map(|name| folder.path().join(name));
    let text = dash("air { wind = [6, 0, 0] m/s }", "simulate { gyroscope_noise = 0 rad/s; position_noise = 0 m }");
    let text = text.replace("samples = 24", "samples = 24; time = 6 s");
    std::fs::write(&spec, &text).unwrap();
    std::fs::write(&still, text.replace("[6, 0, 0]", "[5, 0, 0]")).unwrap();
    let [spec, proof, still] = [&spec, &proof, &still].map(|path| path.to_str().unwrap());
    let output = mavc(&["plan", "-v", spec, "--certificate", proof]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(mavc(&["verify", proof, spec]).status.code(), Some(0));
    assert_eq!(mavc(&["verify", proof, still]).status.code(), Some(5));
    let error = |settings: &[&str]| -> f64 {
        let output = mavc(&[&["simulate", spec, "--report", "-"], settings].concat());
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        report["max_error_m"].as_f64().unwrap()
    };
    let known = error(&[]);
    // A vehicle that is flown in another air than that of its plan is pushed away.
    let unknown = error(&["--set", "simulate.wind=[0, 0, 0] m/s"]);
    assert!(known < 0.15 && unknown > 4.0 * known, "{known} {unknown}");
}

/// A plan of an interval of `drag` is that of its middle. Plan, certificate and its verdict say that it is shown for
/// no other value, and what it does at the ends.
#[test]
fn a_plan_of_an_interval_of_drag_is_shown_for_its_middle_alone() {
    let folder = tempfile::tempdir().unwrap();
    let [spec, exact, proof] = ["dash.mav", "exact.mav", "proof.json"].map(|name| folder.path().join(name));
    let text = dash("air { wind = [6, 0, 0] m/s }", "").replace("samples = 24", "samples = 24; time = 6 s");
    let interval =
        text.replace("drag = 0.35 N*s/m", "drag = 0.35 N*s/m +- 40 %").replace("planner = rip", "planner = rcp");
    std::fs::write(&spec, &interval).unwrap();
    std::fs::write(&exact, interval.replace(" +- 40 %", "")).unwrap();
    let [spec, exact, proof] = [&spec, &exact, &proof].map(|path| path.to_str().unwrap());
    let output = mavc(&["plan", spec, "--certificate", proof, "--report", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let plan = report["planners"].as_array().unwrap().iter().find(|run| run["warnings"].is_array()).unwrap();
    let warnings = plan["warnings"].as_array().unwrap();
    let caveat = warnings.iter().find(|warning| warning["kind"] == "drag_interval").expect("a caveat");
    let message = caveat["message"].as_str().unwrap();
    assert!(message.contains("`drag` = 0.35 N*s/m alone") && message.contains("0.49"), "{message}");
    let verified = mavc(&["verify", proof, spec]);
    let printed = String::from_utf8_lossy(&verified.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(verified.status.code(), Some(7), "{printed}");
    assert!(printed.contains("`drag`: shown for 0.35 N*s/m alone, the middle of its interval"), "{printed}");
    // The same plan as without the interval.
    let flown = |path: &str| mavc(&["plan", path, "-o", "-", "-q"]).stdout;
    assert!(!flown(spec).is_empty());
    assert_eq!(flown(spec), flown(exact));
    // What it violates at the ends is what the trajectory violates there.
    let model = compiled(&interval).model().clone();
    let rcp = compiled(&interval);
    let planned = mavc::plan(&rcp).unwrap();
    let solved = planned.plan().unwrap();
    let ends = solved.at_ends_of_drag.expect("an interval");
    let planned_sets = mavc::planner::selection::sets::PlanningSets::of(&model);
    for (share, found) in [0.0, 1.0].into_iter().zip(ends) {
        let at = model.at(mavc::model::DynamicFigure::Drag, share);
        let mut most = f64::NEG_INFINITY;
        for set in &planned_sets.modes {
            for k in 0..solved.trajectory.intervals() {
                let state = solved.trajectory.within(k, 0.0);
                let wrench = solved.trajectory.wrench(&at.vehicle, &at.environment(), &state);
                most = set.rows.iter().map(|row| row.violation(&wrench)).fold(most, f64::max);
            }
        }
        assert!(found >= most - 1e-9 && found < most + 0.05, "{share}: {found} {most}");
    }
}

/// ISO 2533, table 1: the density at 5000 m is 0.73612 kg/m^3, at -1000 m 1.3470 kg/m^3 (geopotential heights differ by
/// 4 m).
#[test]
fn altitude_gives_the_density_of_the_standard_atmosphere() {
    for (altitude, density) in [("5 km", 0.73643), ("-1 km", 1.3470), ("0 m", 1.225)] {
        let spec = compiled(&dash(&format!("air {{ altitude = {altitude} }}"), ""));
        let ratio = spec.model().mission.as_ref().unwrap().air.density_ratio;
        assert!((ratio * 1.225 - density).abs() < 2e-4, "{altitude}: {}", ratio * 1.225);
        let vehicle = &spec.model().vehicle;
        assert!((vehicle.drag[0] - 0.35 * ratio).abs() < 1e-12);
        assert!((vehicle.rotors[0].max_thrust() - 6.53 * ratio).abs() < 1e-9);
    }
}

/// Those that take longest: see CONTRIBUTING.md.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn lagging_rotors_and_wide_intervals_are_proved_in_every_wind() {
        let winds = |x: f64, y: f64, z: f64| [6.0 + 2.0 * x, 2.0 * y, 0.5 * z];
        let air = "air { wind = [6, 0, 0] m/s +- [2, 2, 0.5] m/s }";
        proved_in_every_wind(air, winds, "time = 5 s; rotors = lagging");
        // So wide that it is divided.
        let winds = |x: f64, y: f64, z: f64| [5.0 * x, 5.0 * y, z];
        proved_in_every_wind("air { wind = [0, 0, 0] m/s +- [5, 5, 1] m/s }", winds, "time = 6 s");
    }

    #[test]
    #[ignore = "long"]
    fn an_interval_takes_more_time_than_its_middle() {
        let time = |spread: &str| {
            let text = dash(&format!("air {{ wind = [6, 0, 0] m/s {spread} }}"), "");
            planned(&compiled(&text.replace("samples = 24", "samples = 12"))).1
        };
        let times = [time(""), time("+- [2, 2, 0.5] m/s")];
        assert!(times[0] < times[1], "{times:?}");
    }
}
