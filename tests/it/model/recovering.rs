//! What a spec says of the time after a fault, as the model has it.

use super::{codes, model};
use mavc::model::{Body, Recovery, RecoverySettings};

const MISSION: &str = "
    mission hop {
        ground = 0 m
        start at [0, 0, 2] m
        waypoint at [10, 0, 5] m
        landing_site pad { at = [4, -8, 0] m; radius = 2 m }
        landing_site roof { at = [4, 8, 3] m; radius = 50 cm }
        limits { tilt <= 30 deg }
        MORE
    }
";

/// The text of a spec with these lines in its mission, and this behind it.
fn with(mission: &str, behind: &str) -> String {
    let allow = if mission.contains("keep_") { "allow = [unknown_size]\n" } else { "" };
    format!("{allow}{}{behind}", MISSION.replace("MORE", mission))
}

#[test]
fn the_orders_of_plan_and_modes_name_sites_whatever_comes_first_in_the_file() {
    use Recovery::{Continue, LandAt, LandAtSites, LandHere};
    let faults = "
        faults {
            every 1 rotor lost as M { recovery = [roof, continue] }
            every 2 rotors lost as D
            mode worn { rotor 2 reduced to 60 %; recovery = [land_here, pad, land_at_sites] }
        }
        plan { against = []; recovery { order = [continue, land_at_sites] } }
        campaign { }
    ";
    let model = model(&format!("{faults}{}", with("", "")));
    let of = |name: &str| model.recovery(model.modes.iter().position(|mode| mode.name == name).unwrap());
    for rotor in 1..=4 {
        assert_eq!(of(&format!("M{rotor}")), [LandAt(1), Continue]);
    }
    assert_eq!(of("D1_2"), [Continue, LandAtSites]);
    assert_eq!(of("worn"), [LandHere, LandAt(0), LandAtSites]);
    let mission = model.mission.as_ref().unwrap();
    let names = |way: Recovery| {
        mission.sites_of(way).into_iter().map(|k| mission.after_fault.sites[k].name.as_str()).collect::<Vec<_>>()
    };
    assert_eq!((names(LandAt(1)), names(LandAtSites)), (vec!["roof"], vec!["pad", "roof"]));
    assert!(names(Continue).is_empty() && names(LandHere).is_empty());
}

#[test]
fn what_is_not_written_is_as_the_reference_says() {
    let silent = model("mission hop { start at [0, 0, 2] m; waypoint at [10, 0, 5] m }");
    assert_eq!(silent.plan.recovery, RecoverySettings::default());
    assert_eq!((silent.plan.recovery.detection, silent.plan.recovery.within), ([0.2; 2], 30.0));
    let rules = &silent.mission.as_ref().unwrap().after_fault;
    assert!(rules.sites.is_empty() && rules.keep_off.is_empty() && rules.limits.is_empty() && rules.buffer == 0.0);
    // A delay of flights is that of ways out too, unless they have their own; the estimator has none.
    let delays = |text: &str| model(&with("", text)).plan.recovery.detection;
    assert_eq!(delays("simulate { detection = 50 ms }"), [0.05; 2]);
    assert_eq!(delays("simulate { detection = estimator }"), [0.2; 2]);
    let both = "simulate { detection = 50 ms }\nplan { recovery { detection = DELAY } }";
    assert_eq!(delays(&both.replace("DELAY", "0.1 s")), [0.1; 2]);
    assert_eq!(delays(&both.replace("DELAY", "0 .. 250 ms")), [0.0, 0.25]);
    assert_eq!(delays(&format!("let late = 300 ms\n{}", both.replace("DELAY", "0.1 s .. late"))), [0.1, 0.3]);
    // Only a block that is written uses defaults.
    let used = |text: &str| {
        let all = model(&with("", text)).defaults;
        all.into_iter().filter(|d| d.field.starts_with("plan.recovery")).map(|d| d.field).collect::<Vec<_>>()
    };
    assert_eq!(used("plan { samples = 60 }"), Vec::<String>::new());
    let fields = ["order", "keep", "detection"].map(|name| format!("plan.recovery.{name}"));
    assert_eq!(used("plan { recovery { within = 20 s } }"), fields);
}

#[test]
fn an_area_has_no_heights() {
    let areas = "
        keep_off street { shape = box; from = [-5, 20] m; to = [15, 26, 7] m; turn = 90 deg; clearance = 1 m }
        keep_off pond { shape = cylinder; centre = [30, 0] m; radius = 3 m }
        keep_off yard { shape = polygon; corners = [[0, 40], [10, 40], [10, 50], [5, 44], [0, 50]] m }
    ";
    let model = model(&with(areas, ""));
    let areas = &model.mission.as_ref().unwrap().after_fault.keep_off;
    assert_eq!(
        areas.iter().map(|area| (area.name.as_str(), area.clearance)).collect::<Vec<_>>(),
        [("street", 1.0), ("pond", 0.0), ("yard", 0.0)]
    );
    let apart = |area: usize, p: [f64; 3]| {
        let distance = areas[area].bodies.iter().map(|body: &Body| body.separation(p).distance);
        let distance = distance.fold(f64::INFINITY, f64::min);
        assert!((distance - areas[area].separation([p[0], p[1]]).1).abs() < 1e-9, "whatever the height");
        distance
    };
    for z in [-100.0, 0.0, 3.0, 1e5] {
        // Turned about its centre, the street goes from [2, 13] to [8, 33].
        assert!((apart(0, [5.0, 10.0, z]) - 3.0).abs() < 1e-9, "{}", apart(0, [5.0, 10.0, z]));
        assert!((apart(0, [7.0, 20.0, z]) + 1.0).abs() < 1e-9);
        assert!((apart(1, [34.0, 3.0, z]) - 2.0).abs() < 1e-9);
        assert!(apart(2, [1.0, 45.0, z]) < 0.0 && apart(2, [5.0, 49.0, z]) > 0.0, "inside, and in the bay");
    }
}

/// A thousand places of a site against a fence, a wall and a street: it is an error exactly if some point of the disc is
/// where the vehicle may not be, as its rim says.
#[test]
fn a_site_fits_if_all_of_its_rim_does() {
    let more = "
        buffer = 1 m
        keep_in field { shape = cylinder; centre = [5, 0, -5] m; radius = 30 m; height = 40 m; clearance = 50 cm }
        keep_out wall { shape = box; from = [-8, 6, -1] m; to = [-4, 12, 9] m; clearance = 1 m }
        keep_off street { shape = polygon; corners = [[12, -14], [20, -14], [20, -6], [16, -10], [12, -6]] m }
        landing_site tried { at = [X, Y, 0] m; radius = 1.5 m }
    ";
    let fixed = model(&with(more.split("landing_site").next().unwrap(), ""));
    let mission = fixed.mission.as_ref().unwrap();
    let (size, rules) = (fixed.vehicle.radius(), &mission.after_fault);
    let fits = |p: [f64; 3]| {
        let inside = (p[0] - 5.0).hypot(p[1]) + size + 0.5 <= 30.0 + rules.buffer;
        let wall = &mission.volumes.iter().find(|v| v.name == "wall").unwrap().bodies[0];
        let street = rules.keep_off[0].bodies.iter().map(|body| body.separation(p).distance);
        inside && wall.separation(p).distance >= size + 1.0 && street.fold(f64::INFINITY, f64::min) >= size
    };
    let (mut tried, mut fine) = (0, 0);
    for (i, j) in (0..24).flat_map(|i| (0..24).map(move |j| (i, j))) {
        let (x, y) = (-30.0 + 3.07 * f64::from(i), -34.0 + 2.93 * f64::from(j));
        let rim = (0..720).map(|k| f64::from(k).to_radians() / 2.0);
        let due = rim.map(|a| [x + 1.5 * a.cos(), y + 1.5 * a.sin(), 0.0]).all(fits);
        let place = more.replace('X', &x.to_string()).replace('Y', &y.to_string());
        let found = codes(&format!("{}{}", super::QUAD, with(&place, "")));
        let is_fine = found.is_empty();
        assert!(is_fine || found == ["mavc::recovery::site"], "{found:?}");
        assert_eq!(is_fine, due, "{x} {y}");
        (tried, fine) = (tried + 1, fine + usize::from(is_fine));
    }
    assert!(tried == 576 && (150..450).contains(&fine), "{fine} of {tried}");
}

#[test]
fn limits_after_a_fault_and_the_share_without_a_way_out() {
    let text = with("after_fault_limits { tilt <= 45 deg; descent <= 4 m/s; yaw_rate <= 90 deg/s }", "");
    let plan = "faults { every 1 rotor lost as M }\nplan { require uncovered <= 1.5 % }";
    let model = model(&format!("{text}{plan}"));
    let limits = &model.mission.as_ref().unwrap().after_fault.limits;
    let shown: Vec<String> = limits.iter().map(ToString::to_string).collect();
    assert_eq!(shown, ["tilt <= 45 deg", "descent <= 4 m/s", "yaw_rate in -90 .. 90 deg/s"]);
    // Those of the mission stay what they are.
    assert_eq!(model.mission.as_ref().unwrap().limits[0].to_string(), "tilt <= 30 deg");
    assert_eq!(model.plan.recovery.require.unwrap().uncovered, 0.015);
    assert_eq!((model.plan.require_risk, model.plan.require_span), (None, model.plan.span));
}

#[test]
fn the_model_as_text_has_what_is_written() {
    let text = with(
        "buffer = 3 m
        keep_off pond { shape = cylinder; centre = [30, 0] m; radius = 3 m; clearance = 1 m }
        after_fault_limits { tilt <= 45 deg }",
        "faults { mode worn { rotor 2 reduced to 60 %; recovery = [pad, land_here] } }
        plan { recovery { order = [roof, continue]; detection = 100 ms .. 200 ms; within = 20 s }; require uncovered <= 1 % }",
    );
    let shown = model(&text).to_string();
    for line in [
        "  worn: rotor 2 at 60 %, recovery [pad, land_here]\n",
        "  landing_site pad at [4, -8, 0] m, radius 2 m\n  landing_site roof at [4, 8, 3] m, radius 0.5 m\n",
        "  keep_off pond, clearance 1 m\n    centre [30, 0] m, radius 3 m\n",
        "  buffer 3 m\n  limit after a fault tilt <= 45 deg\n",
        "  uncovered at most 1 %\n  recovery [roof, continue], detection 0.1 .. 0.2 s, within 20 s, keep 0 %\n",
    ] {
        assert!(shown.contains(line), "{line}\n{shown}");
    }
    let silent = model(&with("", "simulate { detection = 50 ms }")).to_string();
    assert!(!silent.contains("  recovery") && !silent.contains("uncovered"), "{silent}");
}
