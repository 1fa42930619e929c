//! What the spec of a file says.

use super::{PLAN, WPL, found, read, spec};
use crate::cli::mavc;
use mavc::Severity::{Error, Warning};
use mavc::{Compiler, model::Mission};

fn mission(text: &str) -> Mission {
    let spec = spec("field.plan", text);
    let compiled = Compiler::new().text("m.mav", format!("{spec}{}", super::HEXA).as_bytes());
    compiled.spec.unwrap().mission().unwrap().clone()
}

#[test]
fn a_plan_of_qgroundcontrol() {
    insta::assert_snapshot!(spec("some where/1 field\n.plan", PLAN));
    let codes: Vec<_> = found(PLAN)
        .into_iter()
        .map(|(code, severity, message)| (code, severity, message.chars().take(7).collect::<String>()))
        .collect();
    let item = |n: u8| format!("item {n}:");
    assert_eq!(codes, [("mavc::import::left_out", Warning, item(3)), ("mavc::import::assumed", Warning, item(7))]);
    assert_eq!(read("", PLAN).dropped, ["cruiseSpeed", "hoverSpeed"]);
}

#[test]
fn a_mission_of_mavlink() {
    insta::assert_snapshot!(spec("field.waypoints", WPL));
}

#[test]
fn tables_with_and_without_a_header() {
    insta::assert_snapshot!(spec(
        "t.csv",
        "z,y,x,t,heading,colour\n2,0,0,5,0,red\n2,0,10,8,90,blue\n5,10,10,15.5,180,red\n"
    ));
    insta::assert_snapshot!(spec("1.csv", "# from a flight\n0,0,1\n 1.5, -2e0 ,1\r\n\n3,3,3\n"));
}

/// Items of a plan whose home is at 47, 8, 400 m, each with its number.
fn plan(items: &[&str]) -> String {
    let items: Vec<String> = items
        .iter()
        .enumerate()
        .map(|(k, item)| format!(r#"{{"type":"SimpleItem","autoContinue":true,"doJumpId":{},{item}}}"#, k + 1))
        .collect();
    format!(
        r#"{{"fileType":"Plan","version":1,"mission":{{"version":2,"firmwareType":12,"vehicleType":2,
        "plannedHomePosition":[47,8,400],"items":[{}]}}}}"#,
        items.join(",")
    )
}

const A: &str = r#""command":16,"frame":3,"params":[0,0,0,null,47.001,8,30]"#;
const B: &str = r#""command":16,"frame":0,"params":[0,0,0,null,47.001,8.001,440]"#;

#[test]
fn heights_are_relative_to_home_or_above_sea() {
    let waypoints = mission(&plan(&[A, B])).waypoints;
    let height = |latitude: f64, longitude: f64, up: f64| {
        super::places::local([47.0, 8.0, 400.0], [latitude, longitude, 400.0 + up])
    };
    for (waypoint, due) in waypoints.iter().zip([height(47.001, 8.0, 30.0), height(47.001, 8.001, 40.0)]) {
        for i in 0..3 {
            assert!((waypoint.position[i] - due[i]).abs() < 6e-4, "{:?} {due:?}", waypoint.position);
        }
    }
}

#[test]
fn headings_become_yaws_and_the_autopilots_own_yaw_none() {
    use mavc::model::Heading::{Free, Given};
    let east = A.replace("null", "90");
    let south = B.replace("null", "180");
    let waypoints = mission(&plan(&[&east, &south, A, &B.replace("null", "0")])).waypoints;
    let headings: Vec<_> = waypoints.iter().map(|w| w.heading).collect();
    assert_eq!(headings, [Given, Given, Free, Given]);
    for (k, due) in [(0, 0.0_f64), (1, -90.0), (3, 90.0)] {
        let off = (waypoints[k].yaw.to_degrees() - due).rem_euclid(360.0);
        assert!(off.min(360.0 - off) < 1e-9, "{k}: {off}");
    }
    // In ArduPilot's plans 0 is none.
    let ardupilot = plan(&[A, &B.replace("null", "0")]).replace("\"firmwareType\":12", "\"firmwareType\":3");
    assert_eq!(mission(&ardupilot).waypoints[1].heading, Free);
}

#[test]
fn loiters_and_delays_hold_and_speeds_bound_their_legs() {
    let loiter = r#""command":19,"frame":3,"params":[7,0,0,0,47.002,8,30]"#;
    let delay = r#""command":93,"frame":2,"params":[4,0,0,0,0,0,0]"#;
    let climb = r#""command":178,"frame":2,"params":[2,1.5,0,0,0,0,0]"#;
    let across = r#""command":178,"frame":2,"params":[0,6,0,0,0,0,0]"#;
    let reset = r#""command":178,"frame":2,"params":[0,-2,0,0,0,0,0]"#;
    let flown = mission(&plan(&[A, loiter, delay, climb, across, B, reset, A]));
    assert_eq!(flown.waypoints.iter().map(|w| w.hold).collect::<Vec<_>>(), [0.0, 11.0, 0.0, 0.0]);
    let speeds: Vec<_> = flown
        .limits
        .iter()
        .filter(|limit| limit.volume.is_none())
        .map(|limit| (limit.name().to_string(), limit.upper.unwrap()))
        .collect();
    // PX4's own speeds where no item sets one; those of the mission are the largest of all legs.
    let due = [6.0, 3.0, 1.5, 5.0, 1.5, 5.0, 1.5];
    assert_eq!(speeds.iter().map(|(_, speed)| *speed).collect::<Vec<_>>(), due, "{speeds:?}");
}

/// `FlightTaskAuto` bounds the speed of a mission by `MPC_XY_VEL_MAX`.
#[test]
fn px4_flies_no_faster_than_its_bound() {
    let fast = r#""command":178,"frame":2,"params":[1,17,0,0,0,0,0]"#;
    let text = plan(&[A, fast, B]);
    let speeds = |text: &str| {
        let limits = mission(text).limits;
        let of_legs = limits.iter().filter(|limit| limit.volume.is_none());
        of_legs.filter_map(|limit| limit.upper).filter(|upper| *upper > 5.0).collect::<Vec<_>>()
    };
    assert_eq!(speeds(&text), [12.0]);
    let warned = |text: &str| found(text).iter().any(|(_, _, message)| message.contains("MPC_XY_VEL_MAX"));
    assert!(warned(&text));
    let ardupilot = text.replace("\"firmwareType\":12", "\"firmwareType\":3");
    assert!(speeds(&ardupilot).contains(&17.0) && !warned(&ardupilot));
}

#[test]
fn landings_go_straight_down_and_home() {
    let take_off = r#""command":22,"frame":3,"params":[0,0,0,null,47,8,20]"#;
    let land = r#""command":21,"frame":3,"params":[0,0,0,null,47.001,8.001,2]"#;
    let flown = mission(&plan(&[take_off, A, land])).waypoints;
    let heights: Vec<_> = flown.iter().map(|w| w.position[2].round()).collect();
    assert_eq!(heights, [0.0, 20.0, 30.0, 30.0, 10.0, -0.0]);
    assert!((4..6).all(|k| flown[3].position[..2] == flown[k].position[..2]));
    let home = r#""command":20,"frame":2,"params":[0,0,0,0,0,0,0]"#;
    let flown = mission(&plan(&[take_off, A, home])).waypoints;
    assert_eq!((flown.len(), flown[5].position), (6, [0.0; 3]));
    // PX4 flies to the place of a take-off that is not above home.
    let aside = take_off.replace("47,8,20", "47.0005,8,20");
    assert_eq!(mission(&plan(&[&aside, A])).waypoints.len(), 4);
}

#[test]
fn items_that_would_be_another_flight_are_errors_and_others_are_named() {
    let with = |item: &str| found(&plan(&[A, item, B]));
    let params = r#""frame":3,"params":[1,1,0,0,47,8,10]"#;
    for command in [18, 23, 31, 84, 92, 94, 177, 179, 213, 3000] {
        let found = with(&format!(r#""command":{command},{params}"#));
        assert_eq!((found[0].0, found[0].1), ("mavc::import::unsupported", Error), "{command}");
        assert!(found[0].2.contains(&format!("command {command}")), "{found:?}");
    }
    for command in [115, 183, 206, 530, 2500, 42000] {
        let found = with(&format!(r#""command":{command},{params}"#));
        assert_eq!((found.len(), found[0].0, found[0].1), (1, "mavc::import::left_out", Warning), "{command}");
        assert!(found[0].2.starts_with("item 2: "));
    }
    for frame in [1, 4, 7, 10, 99] {
        let found = with(&A.replace("\"frame\":3", &format!("\"frame\":{frame}")));
        assert_eq!(found[0].0, "mavc::import::unsupported", "{frame}");
    }
    let known = A.replace("\"frame\":3", r#""AMSLAltAboveTerrain":455,"frame":10"#);
    assert_eq!(with(&known)[0].0, "mavc::import::assumed");
    assert_eq!(with(&A.replace("16", "82"))[0].0, "mavc::import::assumed", "splines");
    assert_eq!(with(&A.replace("8,30", "8,-30"))[0].0, "mavc::import::assumed", "below home");
    let never = r#""command":17,"frame":3,"params":[0,0,0,0,47.002,8,30]"#;
    assert_eq!(with(never)[0].0, "mavc::import::left_out", "what follows a loiter without end");
}

#[test]
fn surveys_are_the_items_they_consist_of() {
    let survey = format!(
        r#"{{"type":"ComplexItem","complexItemType":"survey","TransectStyleComplexItem":{{"Items":[{{"type":"SimpleItem",{A}}},
        {{"type":"SimpleItem",{B}}}]}}}}"#
    );
    let whole = plan(&[]).replace("\"items\":[]", &format!("\"items\":[{survey}]"));
    assert_eq!(mission(&whole).waypoints.len(), 2);
    assert!(found(&whole)[0].2.contains("items 1 to 2"));
    let landing = whole.replace("TransectStyleComplexItem", "landing");
    assert_eq!(found(&landing)[0].0, "mavc::import::unsupported");
}

/// An L: its outline to stay in, and the bay to stay out of.
#[test]
fn a_fence_with_an_inward_corner_is_its_outline_without_the_bay() {
    let corners = "[[46.999,7.999],[46.999,8.003],[47.001,8.003],[47.001,8.001],[47.003,8.001],[47.003,7.999]]";
    let fence = |more: &str| {
        format!(
            r#""geoFence":{{"version":2,"circles":[],"polygons":[{{"inclusion":true,"version":1,"polygon":{corners}}}{more}]}}"#
        )
    };
    let whole =
        plan(&[A, &A.replace("47.001", "47.002")]).replace("\"version\":1,", &format!("\"version\":1,{},", fence("")));
    let volumes = mission(&whole).volumes;
    assert_eq!(volumes.iter().map(|v| v.name.as_str()).collect::<Vec<_>>(), ["fence_1", "fence_1_bay_1"]);
    // A grid of places is inside of the L exactly where it is in the outline and outside of the bay.
    let mut inside = 0;
    for (i, j) in (0..40).flat_map(|i| (0..40).map(move |j| (i, j))) {
        let (latitude, longitude) = (46.9985 + 0.000125 * f64::from(i) + 1e-6, 7.9985 + 0.000125 * f64::from(j) + 1e-6);
        let due = (46.999..47.003).contains(&latitude)
            && (7.999..8.003).contains(&longitude)
            && (latitude < 47.001 || longitude < 8.001);
        let p = super::places::local([47.0, 8.0, 400.0], [latitude, longitude, 400.0]);
        let is_in = |k: usize| volumes[k].bodies.iter().any(|body| body.separation(p).distance < 0.0);
        assert_eq!(is_in(0) && !is_in(1), due, "{latitude} {longitude}");
        inside += usize::from(due);
    }
    assert!(inside > 300, "{inside}");
    // PX4 takes the union of two, which no spec says; ArduPilot the intersection.
    let two = plan(&[A, B]).replace(
        "\"version\":1,",
        &format!("\"version\":1,{},", fence(&format!(r#",{{"inclusion":true,"polygon":{corners}}}"#))),
    );
    assert_eq!(found(&two)[0].0, "mavc::import::unsupported");
    assert_eq!(found(&two.replace("\"firmwareType\":12", "\"firmwareType\":3")), []);
}

/// A command is called harmless only if it is known to be: jumps to tags, released parachutes and attitudes for a time
/// are refused, and of what may do anything the warning says so.
#[test]
fn only_commands_that_are_known_to_change_nothing_are_called_so() {
    let with = |command: u32, first: f64| {
        let line = format!("2\t0\t3\t{command}\t{first}\t0\t0\t0\t0\t0\t0\t1\r\n2\t0\t3\t16\t2");
        found(&WPL.replacen("2\t0\t3\t16\t2", &line, 1))
    };
    for (command, first) in [(208, 2.0), (601, 1.0), (42703, 10.0), (42702, 1.0), (113, 5.0), (224, 1.0), (31000, 0.0)]
    {
        let found = with(command, first);
        let refused = |f: &&(_, _, String)| f.2.contains(&format!("a spec has no word for command {command}"));
        assert!(found.iter().filter(refused).any(|f| f.1 == Error), "{command}: {found:?}");
    }
    for (command, words) in [
        (208, "command 208 (DO_PARACHUTE) is left out: it does not change"),
        (211, "command 211 (DO_GRIPPER) is left out: it does not change"),
        (218, "command 218 (DO_AUX_FUNCTION) is left out, and may change"),
        (60000, "command 60000 is left out, and may change"),
    ] {
        let found = with(command, 1.0);
        assert!(found.iter().any(|f| f.1 == Warning && f.2.contains(words)), "{command}: {found:?}");
    }
}

/// Fences and rally points are saved in the format of missions.
#[test]
fn lists_of_fences_and_rally_points_are_called_so() {
    let home = "0\t1\t0\t16\t0\t0\t0\t0\t47.39\t8.54\t488\t1\n";
    for (command, words) in [(5001, "this is a geofence, not a mission"), (5100, "this is a list of rally points")] {
        let corners = format!("1\t0\t3\t{command}\t4\t0\t0\t0\t47.39\t8.55\t0\t1\n").repeat(4);
        for head in ["", home] {
            let found = found(&format!("QGC WPL 110\n{head}{corners}"));
            assert!(found.len() == 1 && found[0].2.contains(words), "{found:?}");
        }
    }
}

/// Rally points of a plan, and of MAVLink's text as items and as lines of their own: on the ground below them.
#[test]
fn rally_points_are_landing_sites_on_the_ground() {
    let rally = |points: &str| {
        let member = format!(r#""rallyPoints":{{"version":2,"points":[{points}]}},"#);
        plan(&[A, B]).replace("\"version\":1,\"mission\"", &format!("\"version\":1,{member}\"mission\""))
    };
    let whole = rally("[47.0005,8.0004,25],[46.9995,8,40]");
    let flown = mission(&whole);
    assert_eq!(flown.ground, Some(0.0));
    let due = [[47.0005, 8.0004], [46.9995, 8.0]].map(|[a, b]| super::places::local([47.0, 8.0, 400.0], [a, b, 400.0]));
    for (site, due) in flown.after_fault.sites.iter().zip(due) {
        assert!((0..3).all(|i| (site.at[i] - due[i]).abs() < 1e-3) && site.radius == 2.0, "{site:?} {due:?}");
    }
    let text = spec("field.plan", &whole);
    let remark = "// rally point 2, to be reached at 40 m above home: the site is on the ground below";
    assert!(text.contains(remark) && text.matches("// assumed").count() == 2, "{text}");
    assert_eq!((found(&whole), read("", &whole).dropped), (vec![], vec![]));
    assert!(!spec("field.plan", &rally("")).contains("ground"));
    // The Earth curves away below the tangent plane, and the ground with it.
    let far = mission(&rally("[47.04,8,25]"));
    let [site] = &far.after_fault.sites[..] else { panic!("{far:?}") };
    assert!(site.at[2] < -1.0 && far.ground == Some(site.at[2]), "{site:?}");
    assert_eq!(found(&rally("[47.04,8,25]")), []);
    // In a valley the ground is that of the lowest item, which is said.
    let valley = rally("[47.0005,8.0004,25]").replace("47.001,8,30]", "47.001,8,-20]");
    let ground = mission(&valley).ground.unwrap();
    assert!((ground + 20.0).abs() < 0.01 && found(&valley).iter().any(|f| f.2.contains("20 m below home")), "{ground}");

    let line = |k: u8, frame: u8, command: u32, east: f64, height: f64| {
        format!("{k}\t0\t{frame}\t{command}\t0\t0\t0\t0\t47\t{}\t{height}\t1\n", 8.0 + east)
    };
    let flight = line(0, 0, 16, 0.0, 400.0) + &line(1, 3, 16, 0.001, 30.0) + &line(2, 3, 16, 0.002, 30.0);
    let points = line(3, 3, 5100, 0.0003, 20.0) + &line(4, 0, 5100, 0.0004, 450.0);
    let text = format!("QGC WPL 110\n{flight}{points}RALLY 47.0002 8.0005 60.5 0.0 0.0 1\n");
    let spec = spec("field.waypoints", &text);
    let compiled = Compiler::new().text("m.mav", format!("{spec}{}", super::HEXA).as_bytes()).spec.unwrap();
    let mission = compiled.mission().unwrap();
    assert_eq!((mission.waypoints.len(), mission.after_fault.sites.len()), (2, 3), "{spec}");
    for height in ["20 m above home", "450 m above sea", "60.5 m above home"] {
        assert!(spec.contains(height), "{spec}");
    }
}

/// A rally point outside of a fence is named as such, at its place in the file.
#[test]
fn a_rally_point_that_is_no_landing_site_is_an_error_at_its_place() {
    let fence = r#""geoFence":{"version":2,"polygons":[],"circles":[{"inclusion":true,"version":1,
        "circle":{"center":[47,8],"radius":300}}]},"#;
    let rally = r#""rallyPoints":{"version":2,"points":[[47.0005,8,25],[47.0026,8,25]]},"#;
    let whole = plan(&[A, B]).replace("\"version\":1,\"mission\"", &format!("\"version\":1,{fence}{rally}\"mission\""));
    let spec = spec("field.plan", &whole);
    let compiled = Compiler::new().text("m.mav", format!("{spec}{}", super::HEXA).as_bytes());
    assert!(compiled.spec.is_some(), "{:?}", compiled.diagnostics);
    let outside = whole.replace("47.0026,8,25", "47.0027,8,25");
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("field.plan"), &outside).unwrap();
    std::fs::write(path("v.mav"), format!("{}plan {{ samples = 60 }}\n", super::HEXA)).unwrap();
    let ran = mavc(&["check", &path("field.plan"), "--vehicle", &path("v.mav"), "--format", "short"]);
    let text = String::from_utf8_lossy(&ran.stdout).into_owned();
    assert_eq!(ran.status.code(), Some(1), "{text}");
    assert!(text.contains("error[mavc::recovery::site]: rally point 2: landing site `rally_2` reaches"), "{text}");
}
