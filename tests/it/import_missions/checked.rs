//! `mavc check mission.plan --vehicle v.mav`, and `mavc import mission`.

use super::{HEXA, PLAN};
use crate::cli::{err, mavc, out};
use std::path::Path;
use std::process::Output;

/// Checks a mission with a vehicle; one line for each diagnostic.
fn check(mission: &str, vehicle: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("m.plan"), mission).unwrap();
    std::fs::write(path("v.mav"), vehicle).unwrap();
    mavc(&["check", &path("m.plan"), "--vehicle", &path("v.mav"), "--format", "short"])
}

/// Whether a line names this line of the file, this code and this beginning of the message.
fn says(checked: &Output, line: usize, code: &str, message: &str) {
    let text = out(checked);
    let is_it =
        |l: &str| l.contains(&format!("m.plan:{line}:")) && l.contains(code) && l.contains(&format!("]: {message}"));
    assert!(text.lines().any(is_it), "{line} {code} {message}\n{text}");
}

/// The line of the `doJumpId` of an item.
fn line_of(item: usize) -> usize {
    PLAN.lines().position(|line| line.contains(&format!("\"doJumpId\": {item},"))).unwrap() + 1
}

#[test]
fn an_item_in_a_fence_is_named_in_the_file() {
    let fine = check(PLAN, HEXA);
    assert_eq!(fine.status.code(), Some(0), "{}", out(&fine));
    let inside = check(&PLAN.replace("47.39777106, 8.5466122", "47.39815, 8.5461"), HEXA);
    assert_eq!(inside.status.code(), Some(1));
    says(&inside, line_of(2), "error[mavc::volume::waypoint]", "item 2: waypoint 3 is inside `keep_out fence_1`");
    let outside = check(&PLAN.replace("\"radius\": 150", "\"radius\": 50"), HEXA);
    assert_eq!(outside.status.code(), Some(1));
    let text = out(&outside);
    assert!(text.contains("is outside `keep_in fence_2`"), "{text}");
}

#[test]
fn a_speed_beyond_the_vehicle_is_named_at_its_item() {
    // ArduCopter has no bound of its own.
    let plan = PLAN.replace("\"firmwareType\": 12", "\"firmwareType\": 3");
    let fast = check(&plan.replace("[1, 8, -1", "[1, 80, -1"), HEXA);
    assert_eq!(fast.status.code(), Some(0));
    says(&fast, line_of(4), "warning[mavc::import::speed]", "item 4 sets 80 m/s");
    // Without drag no speed is too large.
    let free = check(&plan.replace("[1, 8, -1", "[1, 50, -1"), &HEXA.replace("    drag             = 1.6 N*s/m\n", ""));
    assert!(!out(&free).contains("import::speed"), "{}", out(&free));
}

#[test]
fn a_row_that_comes_too_soon_is_named() {
    let table = "x,y,z,t\n0,0,2,0\n100,0,2,1.5\n200,0,2,30\n";
    let vehicle = format!("{HEXA}plan {{ time = 30 s }}\n");
    let ran = check(table, &vehicle);
    assert_eq!(ran.status.code(), Some(3), "{}", out(&ran));
    says(&ran, 3, "error[mavc::import::too_soon]", "row 2 cannot be reached at 1.5 s");
    assert!(!out(&check(&table.replace("1.5", "15"), &vehicle)).contains("too_soon"));
    let held = check("x,y,z,t\n0,0,2,0\n100,0,2,1.5\n100,0,2,1.4\n", &vehicle);
    says(&held, 4, "error[mavc::mission::time_order]", "row 3: ");
}

#[test]
fn mistakes_of_the_vehicle_are_in_its_file() {
    let wrong = check(PLAN, &HEXA.replace("3.4 kg", "3.4 m"));
    assert_eq!(wrong.status.code(), Some(1));
    assert!(
        out(&wrong).lines().any(|line| line.contains("v.mav:5:") && line.contains("mavc::unit::mismatch")),
        "{}",
        out(&wrong)
    );
    let none = mavc(&["check", "-", "--vehicle", "no such.mav"]);
    assert_eq!(none.status.code(), Some(2));
    assert!(err(&none).contains("cannot read no such.mav"), "{}", err(&none));
    let alone = mavc(&["check", "examples/field.plan"]);
    assert_eq!(alone.status.code(), Some(2));
    assert!(err(&alone).contains("--vehicle"), "{}", err(&alone));
}

#[test]
fn the_command_writes_a_spec_that_uses_the_vehicle() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::create_dir(path("out")).unwrap();
    std::fs::write(path("field.plan"), PLAN).unwrap();
    std::fs::write(path("v.mav"), HEXA).unwrap();
    let ran = mavc(&["import", "mission", &path("field.plan"), "--vehicle", &path("v.mav"), "-o", &path("out/m.mav")]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(err(&ran).contains("cruiseSpeed") && err(&ran).contains("item 3"), "{}", err(&ran));
    let text = std::fs::read_to_string(Path::new(&path("out/m.mav"))).unwrap();
    assert!(text.contains("\nuse \"../v.mav\"\n"), "{text}");
    let checked = mavc(&["check", &path("out/m.mav")]);
    assert_eq!(checked.status.code(), Some(0), "{}", out(&checked));
    // A file that is read is not replaced, and one with a mistake writes nothing.
    assert_eq!(mavc(&["import", "mission", &path("field.plan"), "-o", &path("field.plan")]).status.code(), Some(2));
    std::fs::write(path("bad.plan"), &PLAN[..500]).unwrap();
    assert_eq!(mavc(&["import", "mission", &path("bad.plan"), "-o", &path("out/bad.mav")]).status.code(), Some(1));
    assert!(!Path::new(&path("out/bad.mav")).exists());
}

/// The spec of a vehicle often has a mission, as those of `mavc new` have, and its `plan` may even name it.
#[test]
fn the_mission_of_the_vehicle_is_not_looked_at() {
    let own = "mission own { start at [0, 0, 2] m; waypoint at [9, 0, 2] m }\n";
    for plan in ["", "plan { samples = 60 }\n", "plan { mission = own; samples = 60 }\n"] {
        let vehicle = format!("{HEXA}{own}{plan}");
        let fine = check(PLAN, &vehicle);
        assert_eq!(fine.status.code(), Some(0), "{plan}{}", out(&fine));
        let inside = check(&PLAN.replace("47.39777106, 8.5466122", "47.39815, 8.5461"), &vehicle);
        says(&inside, line_of(2), "error[mavc::volume::waypoint]", "item 2: waypoint 3 is inside `keep_out fence_1`");
    }
    // The written spec flies the imported mission, too.
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("field.plan"), PLAN).unwrap();
    std::fs::write(path("v.mav"), format!("{HEXA}{own}plan {{ samples = 60 }}\n")).unwrap();
    let ran = mavc(&["import", "mission", &path("field.plan"), "--vehicle", &path("v.mav"), "-o", &path("field.mav")]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let model = mavc(&["emit", "model", &path("field.mav")]);
    assert!(out(&model).contains("\nmission field\n"), "{}", out(&model) + &err(&model));
}

/// Items are flown straight, so a fence across a leg leaves no way, although a way around it would be short.
#[test]
fn a_fence_across_a_leg_is_named_at_its_item() {
    let item = |id: usize, command: u32, east: f64| {
        let longitude = 8.5456075 + east / 75_460.0;
        format!(
            r#"{{"type":"SimpleItem","command":{command},"doJumpId":{id},"frame":3,"params":[0,0,0,null,47.3977507,{longitude},10]}}"#
        )
    };
    let plan = |radius: f64| {
        let fence = format!(
            r#"{{"circle":{{"center":[47.3977507,{}],"radius":{radius}}},"inclusion":false,"version":1}}"#,
            8.5456075 + 60.0 / 75_460.0
        );
        format!(
            "{{\"fileType\":\"Plan\",\"version\":1,\"groundStation\":\"QGroundControl\",\"mission\":{{\"version\":2,\"firmwareType\":12,\
             \"vehicleType\":2,\"cruiseSpeed\":15,\"hoverSpeed\":5,\"plannedHomePosition\":[47.3977507,8.5456075,488],\"items\":[\n{},\n{},\n{}]}},\n\
             \"geoFence\":{{\"version\":2,\"circles\":[{fence}],\"polygons\":[]}},\"rallyPoints\":{{\"version\":2,\"points\":[]}}}}\n",
            item(1, 22, 0.0),
            item(2, 16, 20.0),
            item(3, 16, 100.0)
        )
    };
    let across = check(&plan(15.0), HEXA);
    assert_eq!(across.status.code(), Some(1), "{}", out(&across));
    says(&across, 4, "error[mavc::volume::no_way]", "item 3: no straight way leads from waypoint 3 to waypoint 4");
    // The leg passes within its tolerance where the fence is smaller than that: no cross-section is closed.
    let small = check(
        &plan(0.02).replace("[0,0,0,null", "[0,2,0,null"),
        &HEXA.replace("propeller_radius = 12 cm", "size = 5 cm"),
    );
    assert!(!out(&small).contains("no_way"), "{}", out(&small));
}
