//! The largest steady airspeed in level flight: closed forms, membership in the sets, and the wind in which plans hold
//! position.

use crate::cli::{flat, mavc_with};
use crate::intervals::{at, uncertain};
use crate::schemas::schema;
use crate::vehicles::{limit, lost, mission, octocopter, quadcopter, waypoint};
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::airspeed::{Airspeed, LimitedBy};
use mavc::model::{LimitKind, Model};
use mavc::report::analysis_text::analysis;
use serde_json::Value;

const DRAG: f64 = 0.35;

fn dragged(mut model: Model, reserve: f64) -> Model {
    model.vehicle.drag = [DRAG; 3];
    model.plan.reserve = reserve;
    model
}

fn airspeed(model: &Model, set: &AdmissibleSet) -> f64 {
    Airspeed::of(model, set).unwrap().largest_m_per_s.unwrap()
}

/// All eight rotors at full speed give no torque, so T_max is the sum of their thrusts.
#[test]
fn the_healthy_octocopter_by_its_closed_form() {
    let full = 8.0 * 8.5485e-6 * 874.0_f64.powi(2);
    for reserve in [0.0, 0.1, 0.5, 1.0] {
        let model = dragged(octocopter("PPNNPPNN"), reserve);
        let weight = 1.8 * model.gravity;
        let most = weight + (1.0 - reserve) * (full - weight);
        let expected = (most.powi(2) - weight.powi(2)).sqrt() / DRAG;
        let found = airspeed(&model, &AdmissibleSet::healthy(&model));
        assert!((found - expected).abs() <= 1e-9 * expected.max(1.0), "{reserve}: {found} {expected}");
    }
}

/// At the airspeed of each mode the wrench lies on the boundary of the planner's set, and, moved away from hover by the
/// reserve, on that of the zonotope, whose nearest point is found without facets.
#[test]
fn the_wrench_lies_on_the_boundary() {
    for reserve in [0.0, 0.1, 0.4] {
        let mut model = dragged(octocopter("PPNNPPNN"), reserve);
        model.modes = vec![lost(&model, &[1]), lost(&model, &[1, 6])];
        for set in AdmissibleSet::each(&model) {
            let speed = airspeed(&model, &set);
            let weight = set.hover[0];
            let thrust = |u: f64| Wrench::new((weight.powi(2) + (DRAG * u).powi(2)).sqrt(), 0.0, 0.0, 0.0);
            let away = |w: Wrench| set.hover + (w - set.hover) / (1.0 - reserve);
            let distance = |w: Wrench| (set.zonotope.nearest(&w) - w).norm();
            let [below, above] = [0.999, 1.001].map(|factor| thrust(factor * speed));
            let kept = set.with_reserve(reserve).polytope;
            assert!(kept.contains(&below, 1e-9) && !kept.contains(&above, 1e-9), "{} {reserve} {speed}", set.name);
            assert!(distance(away(below)) < 1e-9 && distance(away(above)) > 1e-4, "{} {reserve} {speed}", set.name);
        }
    }
}

/// Over intervals the airspeed is that of the worst vehicle: one with the weakest rotors, and the lightest or the
/// heaviest.
#[test]
fn intervals_take_the_worst_vehicle() {
    for reserve in [0.1, 0.8] {
        let model = uncertain(dragged(octocopter("PPNNPPNN"), reserve), 0.2, 0.05, 0.0);
        let found = airspeed(&model, &AdmissibleSet::healthy(&model));
        let of = |mass: f64, thrust: f64| {
            let one = at(&model, mass, &[(thrust, 0.0); 8]);
            airspeed(&one, &AdmissibleSet::healthy(&one))
        };
        let worst = of(-1.0, -1.0).min(of(1.0, -1.0));
        assert!((found / worst - 1.0).abs() < 1e-9, "{found} {worst}");
        for (mass, thrust) in [(0.0, 0.0), (0.5, -0.5), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0)] {
            assert!(of(mass, thrust) >= found * (1.0 - 1e-9), "{mass} {thrust}");
        }
    }
    // The heaviest of these cannot hover.
    let model = uncertain(dragged(octocopter("PPNNPPNN"), 0.1), 2.0, 0.0, 0.0);
    let found = Airspeed::of(&model, &AdmissibleSet::healthy(&model)).unwrap();
    assert_eq!((found.largest_m_per_s, found.limited_by), (None, None));
}

/// The tilt of level flight is `atan(drag u/(m g))`; the wind does not matter.
#[test]
fn a_limit_on_tilt_and_the_wind() {
    let mut model = dragged(octocopter("PPNNPPNN"), 0.1);
    let free = Airspeed::of(&model, &AdmissibleSet::healthy(&model)).unwrap();
    assert_eq!(free.limited_by, Some(LimitedBy::Thrust));
    let mut flown = mission(vec![waypoint([0.0, 0.0, 5.0], 0.0), waypoint([9.0, 0.0, 5.0], 0.0)]);
    flown.limits = vec![limit(LimitKind::Speed, 1.0), limit(LimitKind::Tilt, 1.0), limit(LimitKind::Tilt, 0.5)];
    model.mission = Some(flown);
    let tilted = Airspeed::of(&model, &AdmissibleSet::healthy(&model)).unwrap();
    assert_eq!(tilted.limited_by, Some(LimitedBy::Tilt));
    let expected = 1.8 * model.gravity * 0.5_f64.tan() / DRAG;
    assert!((tilted.largest_m_per_s.unwrap() / expected - 1.0).abs() < 1e-12);
    let flown = model.mission.as_mut().unwrap();
    // Steeper than thrust allows, and no limit at all.
    flown.limits = vec![limit(LimitKind::Tilt, 1.5), limit(LimitKind::Tilt, 1.6)];
    flown.air.wind = [20.0, 0.0, 3.0];
    let windy = Airspeed::of(&model, &AdmissibleSet::healthy(&model)).unwrap();
    assert_eq!(windy, free);
}

/// Without drag there is neither a column nor a key; a mode that cannot hover has none, also with yaw given up.
#[test]
fn without_drag_or_hover() {
    let mut model = quadcopter();
    model.modes = vec![lost(&model, &[1, 2])];
    let all = |model: &Model| mavc::admissible::verdict::analyze_all(model, &AdmissibleSet::all(model));
    let modes = all(&model);
    assert!(modes.iter().all(|mode| mode.airspeed.is_none()));
    assert!(!analysis(&model, &modes).contains("airspeed"));
    assert!(!serde_json::to_string(&modes).unwrap().contains("airspeed"));
    let model = dragged(model, 0.1);
    let modes = all(&model);
    assert!(modes[0].airspeed.unwrap().largest_m_per_s.is_some());
    assert_eq!(modes[1].airspeed.unwrap().largest_m_per_s, None);
    let text = analysis(&model, &modes);
    let line = text.lines().find(|line| line.starts_with("M1")).unwrap();
    assert!(line.trim_end().ends_with("none"), "{text}");
}

/// An octocopter that stays in place for two seconds in a wind, with losses of rotor 1 if `planner` is not `rip`.
fn hold(wind: &str, reserve: f64, planner: &str) -> String {
    let faults = if planner == "rip" { "" } else { "faults { mode M1 { rotor 1 lost } }" };
    format!(
        r#"
vehicle octo {{
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    drag    = 2.5 N*s/m
    rotor {{
        thrust_coefficient = 8.5485e-6 N*s^2/rad^2
        drag_coefficient   = 1.3678e-7 N*m*s^2/rad^2
        max_speed          = 874 rad/s
    }}
}}
{faults}
mission stay {{
    air {{ wind = {wind} }}
    waypoint at [0, 0, 5] m
    waypoint at [0, 0, 5] m
}}
plan {{ planner = {planner}; time = 2 s; samples = 10; reserve = {} % }}
"#,
        100.0 * reserve
    )
}

fn report(args: &[&str], spec: &str) -> Value {
    let output = mavc_with(args, spec);
    let text = String::from_utf8(output.stdout).unwrap();
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn is_found(spec: &str) -> bool {
    let report = report(&["plan", "-", "--quiet", "--report", "-"], spec);
    report["planners"][0]["verdict"] == "found"
}

/// The airspeed of the last mode that the plan takes into account, as `mavc analyze` prints it.
fn told(spec: &str) -> f64 {
    let report = report(&["analyze", "-", "--quiet", "--format", "json"], spec);
    schema("analyze").assert_valid(&report);
    report["modes"].as_array().unwrap().last().unwrap()["airspeed"]["largest_m_per_s"].as_f64().unwrap()
}

/// In a constant wind the reserve is that of hover in this wind, and takes nothing from it: plans hold position up to
/// the airspeed without a reserve. In an interval of winds about still air they hold it up to the airspeed with the
/// reserve.
fn hold_position_up_to_the_airspeed(planner: &str) {
    let [bare, kept] = [0.0, 0.1].map(|reserve| told(&hold("[0, 0, 0] m/s", reserve, planner)));
    assert!(kept < 0.97 * bare, "{kept} {bare}");
    let constant = |speed: f64| format!("[{speed}, 0, 0] m/s");
    let between = |speed: f64| format!("[0, 0, 0] m/s +- [0, {speed}, 0] m/s");
    for (reserve, wind, limit) in [
        (0.0, &constant as &dyn Fn(f64) -> String, bare),
        (0.1, &constant, bare),
        (0.0, &between, bare),
        (0.1, &between, kept),
    ] {
        let is_held = |factor: f64| is_found(&hold(&wind(factor * limit), reserve, planner));
        assert!(is_held(0.99), "{planner} {reserve} {}", wind(limit));
        // In an interval the search for a plan that does not exist takes ten seconds.
        let is_quick = wind(limit) == constant(limit) || (planner, reserve) == ("rip", 0.1);
        assert!(!is_quick || !is_held(1.01), "{planner} {reserve} {}", wind(limit));
    }
}

/// The report of a plan names the airspeeds of the healthy vehicle and of the modes planned against.
#[test]
fn reports_of_plans_print_the_airspeeds() {
    let spec = hold("[5, 0, 0] m/s", 0.1, "rcp");
    let text = String::from_utf8(mavc_with(&["plan", "-v", "-", "--quiet"], &spec).stdout).unwrap();
    let line = "Largest steady airspeed in level flight with the reserve: healthy 18.18 m/s, M1 10.75 m/s RCP";
    assert!(flat(&text).contains(line), "{text}");
    let without = spec.replace("drag    = 2.5 N*s/m", "").replace("air { wind = [5, 0, 0] m/s }", "");
    let text = String::from_utf8(mavc_with(&["plan", "-v", "-", "--quiet"], &without).stdout).unwrap();
    assert!(text.contains("RCP") && !text.contains("airspeed"), "{text}");
}

/// A plan faster than 5 m/s has a caveat if its vehicle has no `drag`.
#[test]
fn fast_plans_without_drag_have_a_caveat() {
    let spec = |vehicle: &str, time: f64| {
        hold("[0, 0, 0] m/s", 0.1, "rip")
            .replace("drag    = 2.5 N*s/m", vehicle)
            .replacen(
                "waypoint at [0, 0, 5] m\n    waypoint at [0, 0, 5] m",
                "waypoint at [0, 0, 5] m\n    waypoint at [20, 0, 5] m",
                1,
            )
            .replace("time = 2 s", &format!("time = {time} s"))
    };
    let kinds = |spec: &str| -> Vec<String> {
        let report = report(&["plan", "-", "--quiet", "--report", "-"], spec);
        schema("report").assert_valid(&report);
        let planner = &report["planners"][0];
        assert_eq!(planner["verdict"], "found", "{planner}");
        let warnings = planner["warnings"].as_array().unwrap();
        warnings.iter().map(|w| w["kind"].as_str().unwrap().to_string()).collect()
    };
    // From rest to rest over 20 m, the speed is at least 20 m over the time: 6.7 m/s in 3 s.
    assert!(kinds(&spec("", 3.0)).contains(&"no_drag".to_string()));
    for (vehicle, time) in [("", 20.0), ("drag = 0 N*s/m", 3.0), ("drag = 0.35 N*s/m", 3.0)] {
        assert!(!kinds(&spec(vehicle, time)).contains(&"no_drag".to_string()), "{vehicle} {time}");
    }
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn plans_hold_position_up_to_the_airspeed() {
        hold_position_up_to_the_airspeed("rip");
    }

    #[test]
    #[ignore = "long"]
    fn plans_against_a_loss_hold_position_up_to_the_airspeed() {
        hold_position_up_to_the_airspeed("rcp");
    }
}
