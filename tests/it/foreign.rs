//! Files of other tools in the place of a spec: one error that names the command which reads them.

use crate::cli::{HOP, err, mavc, mavc_with, out};
use mavc::compile;
use std::path::Path;

const FILES: &str = "tests/specs/findings/files";

/// Every file of the findings, with the command that reads it.
fn files() -> Vec<(String, &'static str)> {
    let command = |name: &str| match name {
        "template.sdf.jinja" => "expand it first",
        _ if name.ends_with(".plan") || name.ends_with(".txt") || name.ends_with(".csv") => "mavc import mission",
        _ => "mavc import vehicle",
    };
    let mut found: Vec<_> = std::fs::read_dir(FILES)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_str().unwrap().to_string())
        .map(|name| (name.clone(), command(&name)))
        .collect();
    found.sort();
    assert!(found.len() >= 19, "{found:?}");
    found
}

#[test]
fn every_command_names_the_one_that_reads_the_file() {
    for (name, command) in files() {
        let path = format!("{FILES}/{name}");
        for run in ["plan", "analyze", "simulate", "fmt"] {
            let ran = mavc(&[run, &path]);
            let said = err(&ran);
            assert_eq!((ran.status.code(), said.matches(" × ").count()), (Some(1), 1), "{run} {name}: {said}");
            assert!(
                said.contains("mavc::file::foreign") && said.contains("expected a spec, found"),
                "{run} {name}: {said}"
            );
            let flat = said.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(flat.contains(command), "{run} {name}: {said}");
        }
        // The same for a library's and Python's text without a name.
        let compiled = compile(&std::fs::read_to_string(&path).unwrap());
        assert_eq!(compiled.diagnostics.len(), 1, "{name}: {}", compiled.render());
        let checked = mavc(&["check", &path]);
        let said = err(&checked) + &out(&checked);
        match command {
            "mavc import mission" => {
                assert_eq!((checked.status.code(), said.lines().count()), (Some(2), 1), "{name}: {said}");
                assert!(said.contains("--vehicle v.mav"), "{said}");
            }
            _ => assert_eq!(
                (checked.status.code(), said.contains("mavc::file::foreign")),
                (Some(1), true),
                "{name}: {said}"
            ),
        }
    }
}

#[test]
fn logs_results_and_specs_are_recognised() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let mut long = b"ULog\x01\x12\x35\x01".to_vec();
    long.resize(3 << 20, 0xff);
    for (name, bytes, words) in [
        ("flight.ulg", long.as_slice(), "a log of PX4"),
        ("flight.bin", b"\xa3\x95\x80\x80\xff\xfe", "a log of ArduPilot"),
        ("flight.mcap", b"\x89MCAP0\r\n\x01\xff", "an MCAP recording"),
        ("cert.json", b"{\"schema\": 9, \"spec_sha256\": \"\", \"claim\": {}}", "mavc verify"),
        ("traj.csv", b"t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax,ay,az\n0,0,0,0,0,0,0,0,0,0,0,0\n", "a trajectory of mavc"),
    ] {
        std::fs::write(path(name), bytes).unwrap();
        for run in [&["check"][..], &["import", "vehicle"], &["import", "mission"]] {
            let ran = mavc(&[run, &[&path(name)]].concat());
            let said = (err(&ran) + &out(&ran)).split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(ran.status.code() == Some(1) && said.contains(words), "{run:?} {name}: {said}");
        }
    }
    std::fs::write(path("hop.mav"), HOP).unwrap();
    for kind in ["vehicle", "mission"] {
        let ran = mavc(&["import", kind, &path("hop.mav")]);
        assert!(ran.status.code() == Some(1) && err(&ran).contains("this is a spec of mavc already"), "{}", err(&ran));
    }
}

/// Archives and pictures are named, and `import` without the word for the kind of file says which one it is.
#[test]
fn files_that_nothing_reads_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let named = |name: &str, bytes: &[u8]| {
        std::fs::write(folder.path().join(name), bytes).unwrap();
        folder.path().join(name).to_str().unwrap().to_string()
    };
    let archive = named("logs.zip", b"PK\x03\x04\x14\0\xff\xfe");
    for command in [&["check"][..], &["import", "mission"], &["import", "vehicle"], &["diagnose"], &["import"]] {
        let ran = mavc(&[command, &[&archive]].concat());
        let said = out(&ran) + &err(&ran);
        assert!(said.contains("a ZIP archive"), "{command:?}: {said}");
    }
    let plan = format!("{FILES}/{}", files().iter().find(|(name, _)| name.ends_with(".plan")).unwrap().0);
    let ran = mavc(&["import", &plan]);
    let said = err(&ran);
    assert!(ran.status.code() == Some(2) && said.contains("`mavc import mission"), "{said}");
    assert!(err(&mavc(&["import", "misson"])).contains("expected `vehicle` or `mission`, found `misson`"));
    assert!(err(&mavc(&["import", "mission", &named("empty.plan", b"")])).contains("the file is empty"));
}

#[test]
fn a_vehicle_that_is_no_spec_is_refused_beside_a_mission() {
    let (plan, parameters) = (format!("{FILES}/house.plan"), format!("{FILES}/px4_defaults.params"));
    for run in [&["check", plan.as_str()][..], &["import", "mission", plan.as_str()]] {
        let ran = mavc(&[run, &["--vehicle", &parameters]].concat());
        assert_eq!((ran.status.code(), err(&ran).lines().count()), (Some(2), 1), "{}", err(&ran));
        assert!(err(&ran).contains("mavc import vehicle"), "{}", err(&ran));
    }
    let ran = mavc(&["import", "mission", &plan, "--vehicle", "Cargo.toml"]);
    assert!(ran.status.code() == Some(2) && err(&ran).contains("end in `.mav`"), "{}", err(&ran));
}

/// The vehicle's spec may have a mission of the same name.
#[test]
fn a_mission_of_the_same_name_is_no_conflict() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("hexa.mav"), HEXA).unwrap();
    let plan = format!("{FILES}/house.plan");
    let checked = mavc(&["check", &plan, "--vehicle", &path("hexa.mav")]);
    assert_eq!(checked.status.code(), Some(0), "{}", err(&checked));
    let imported = mavc(&["import", "mission", &plan, "--vehicle", &path("hexa.mav"), "-o", &path("new.mav")]);
    assert_eq!(imported.status.code(), Some(0), "{}", err(&imported));
    assert!(std::fs::read_to_string(path("new.mav")).unwrap().contains("mission house_2 {"));
    let checked = mavc(&["check", &path("new.mav"), "--set", "plan.mission=house_2"]);
    assert_eq!(checked.status.code(), Some(0), "{}{}", err(&checked), out(&checked));
}

const HEXA: &str = r#"vehicle hexa {
    layout  = "PPNNPN"
    arm     = 30 cm
    mass    = 3.4 kg
    size    = 40 cm
    inertia = [0.05, 0.05, 0.09] kg*m^2
    rotor { max_thrust = 13 N; torque_per_thrust = 17 mm; max_speed = 7500 rpm }
}
mission house { start at [0, 0, 2] m; waypoint at [10, 0, 5] m }
plan { mission = house }
"#;

/// An ending that says another format is never mavc's table.
#[test]
fn the_ending_of_the_output_says_the_format() {
    let spec = "tests/specs/findings/turns_at_corners.mav";
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    for (name, begin) in [
        ("a.plan", "{"),
        ("a.waypoints", "QGC WPL 110"),
        ("a.KML", "<?xml"),
        ("a.geojson", "{"),
        ("a.csv", "t,x,y,z"),
        ("a.txt", "t,x,y,z"),
    ] {
        let ran = mavc(&["plan", "-v", spec, "-q", "-o", &path(name)]);
        assert_eq!(ran.status.code(), Some(0), "{name}: {}", err(&ran));
        assert!(std::fs::read_to_string(path(name)).unwrap().starts_with(begin), "{name}");
    }
    for (name, words) in [
        ("b.py", "--format px4-offboard, ardupilot-guided or rotorpy"),
        ("b.json", "--report"),
        ("b.html", "--html"),
        ("b.svg", "--svg"),
        ("b.db3", "--format rosbag2"),
        ("b.params", "a trajectory is not a file of this kind"),
    ] {
        let ran = mavc_with(&["plan", "-v", "-", "-o", &path(name)], HOP);
        assert_eq!((ran.status.code(), Path::new(&path(name)).exists()), (Some(2), false), "{name}");
        assert!(err(&ran).contains(words), "{name}: {}", err(&ran));
    }
    // Flight logs too.
    std::fs::write(path("hop.mav"), HOP).unwrap();
    for (name, begin) in [("f.ulg", &b"ULog"[..]), ("f.mcap", b"\x89MCAP"), ("f.csv", b"t,")] {
        let ran = mavc(&["simulate", "-v", &path("hop.mav"), "-q", "-o", &path(name)]);
        assert_eq!(ran.status.code(), Some(0), "{name}: {}", err(&ran));
        assert!(std::fs::read(path(name)).unwrap().starts_with(begin), "{name}");
    }
    for (name, words) in [("g.plan", "`mavc plan -o`"), ("g.bin", "--format mcap or ulog"), ("g.html", "--html")] {
        let ran = mavc(&["simulate", "-v", &path("hop.mav"), "-o", &path(name)]);
        assert_eq!((ran.status.code(), Path::new(&path(name)).exists()), (Some(2), false), "{name}");
        assert!(err(&ran).contains(words), "{name}: {}", err(&ran));
    }
    // Whoever names a format gets it.
    let ran = mavc(&["plan", "-v", spec, "-q", "-o", &path("c.json"), "--format", "csv"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
}

/// `--set` sets fields; a statement is written in the spec.
#[test]
fn a_statement_that_is_set_says_where_it_is_written() {
    for set in ["simulate.fault=M1 at 5 s", "simulate.fault = 1", "mission.waypoint=[1, 2, 3] m"] {
        let ran = mavc_with(&["check", "-", "--set", set], HOP);
        let said = err(&ran) + &out(&ran);
        assert!(ran.status.code() == Some(1) && said.contains("`--set` sets fields, and `"), "{set}: {said}");
        assert!(said.contains("write it in the spec"), "{set}: {said}");
    }
    // The help names the mode that was asked for.
    for (mode, named) in [("M1", "M1"), ("M2", "M2"), ("M2 at 3 s", "M2"), ("3", "M1")] {
        let said = err(&mavc_with(&["simulate", "-", "--set", &format!("simulate.fault={mode}")], HOP));
        assert!(said.contains(&format!("`simulate {{ fault {named} at 5 s }}`")), "{mode}: {said}");
    }
}

/// A flight that begins on the ground of its mission does not end there at once.
#[test]
fn a_mission_may_begin_on_its_ground() {
    let text = HOP.replace("start at [0, 0, 2] m", "ground = 2 m\n    start at [0, 0, 2] m");
    assert_ne!(text, HOP);
    let compiled = compile(&text);
    let spec = compiled.spec.as_ref().unwrap_or_else(|| panic!("{}", compiled.render()));
    assert_eq!((spec.mission().unwrap().ground, spec.model().simulation.ground), (Some(2.0), 1.0));
    let above = compile(&text.replace("ground = 2 m", "ground = 2.1 m"));
    assert!(above.diagnostics.iter().any(|d| d.message.contains("`ground` must not be above a waypoint")));
}
