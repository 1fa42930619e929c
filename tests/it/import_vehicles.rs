//! `mavc import vehicle`: parameters of autopilots and files of simulators to specs, and back.

use crate::cli::{err, mavc, out};
use mavc::import::Imported;
use mavc::import::vehicle::import;
use mavc::model::Model;
use mavc::{Compiler, Spec, compile};
use rand_distr::{Distribution, StandardUniform};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeMap;

/// The spec's text; an error fails the test.
fn text(file: &str) -> String {
    let imported = import("frame.params", file.as_bytes());
    imported.text.unwrap_or_else(|| panic!("{:#?}", imported.diagnostics))
}

/// The spec with figures in place of each `?`.
fn filled(text: &str) -> Spec {
    let figures = [
        ("mass ", "2 kg"),
        ("inertia ", "[0.02, 0.02, 0.04] kg*m^2"),
        ("max_thrust ", "9 N"),
        ("torque_per_thrust ", "15 mm"),
        ("max_speed ", "900 rad/s"),
        ("let arm ", "0.25 m"),
        ("thrust_coefficient ", "1e-5 N*s^2/rad^2"),
    ];
    let line = |line: &str| match figures.iter().find(|(name, _)| line.trim_start().starts_with(name)) {
        Some((_, figure)) => line.replacen('?', figure, 1),
        None => line.replace("spin ?", "spin P"),
    };
    let text: String = text.lines().map(|l| line(l) + "\n").collect();
    compile(&text).into_result().unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// A file as QGroundControl saves it.
fn qgroundcontrol(values: &[(String, f32)]) -> String {
    let lines = values.iter().map(|(name, value)| format!("1\t1\t{name}\t{value}\t9\n"));
    format!("# Onboard parameters\n#\n{}", lines.collect::<String>())
}

/// The parameters of a text as 32-bit floats.
fn singles(text: &str) -> BTreeMap<String, f32> {
    let of = |line: &str| {
        let columns: Vec<&str> = line.split('\t').collect();
        (columns[2].to_string(), columns[3].parse().unwrap())
    };
    text.lines().filter(|line| !line.starts_with('#')).map(of).collect()
}

fn share(random: &mut Pcg64Mcg) -> f64 {
    StandardUniform.sample(random)
}

fn whole(random: &mut Pcg64Mcg) -> usize {
    let number: u32 = StandardUniform.sample(random);
    number as usize
}

/// Every key of every rotor comes back as the same 32-bit float, whatever its digits; other keys are named as left out.
#[test]
fn px4_parameters_come_back_as_the_same_floats() {
    let mut random = Pcg64Mcg::new(7);
    for round in 0..12 {
        let rotors = 4 + round % 9;
        let mut values = vec![("CA_AIRFRAME".to_string(), 0.0), ("CA_ROTOR_COUNT".to_string(), rotors as f32)];
        for i in 0..rotors {
            let mut put = |key: &str, value: f64| values.push((format!("CA_ROTOR{i}_{key}"), value as f32));
            let angle = std::f64::consts::TAU * (i as f64 + 0.3 * share(&mut random)) / rotors as f64;
            put("PX", 0.3 * angle.cos());
            put("PY", 0.3 * angle.sin());
            put("PZ", 0.1 * share(&mut random) - 0.05);
            put("AX", 0.0);
            put("AY", 0.0);
            put("AZ", -1.0);
            put("CT", if round % 2 == 0 { 7.5 } else { 5.0 + 4.0 * share(&mut random) });
            put("KM", (0.01 + 0.02 * share(&mut random)) * if i % 2 == 0 { 1.0 } else { -1.0 });
        }
        values.push(("MC_ROLL_P".into(), 6.5));
        let file = qgroundcontrol(&values);
        let imported = import("x.params", file.as_bytes());
        assert_eq!(imported.dropped, ["MC_ROLL_P"]);
        let spec = filled(&imported.text.unwrap());
        let back = singles(&mavc::pipeline::px4_params_text(&spec));
        let there = singles(&file);
        for (name, value) in there.iter().filter(|(name, _)| name.starts_with("CA_")) {
            assert_eq!(back.get(name).map(|v| v.to_bits()), Some(value.to_bits()), "{name}: {value}");
        }
        assert_eq!(back.len(), there.len() - 1);
    }
}

/// Axes: PX4 is forward, right, down; `KM` above zero turns counter-clockwise, which is P.
#[test]
fn an_airframe_script_is_read_with_its_defaults() {
    let script = "#!/bin/sh\n# @name Test Quad\n. ${R}etc/init.d/rc.mc_defaults\n\
                  param set-default MC_YAW_P 2.8\nparam set-default CA_ROTOR_COUNT 4\n\
                  param set-default CA_ROTOR0_PX 0.15\nparam set-default CA_ROTOR0_PY 0.2\n\
                  param set-default CA_ROTOR1_PX -0.15\nparam set-default CA_ROTOR1_PY -0.2\nparam set-default CA_ROTOR1_PZ -0.04\n\
                  param set-default CA_ROTOR2_PX 0.15\nparam set-default CA_ROTOR2_PY -0.2\nparam set-default CA_ROTOR2_KM -0.05\n\
                  param set-default CA_ROTOR3_PX -0.15\nparam set-default CA_ROTOR3_PY 0.2\nparam set CA_ROTOR3_KM -0.05\n";
    let imported = import("airframes/4999_test_quad", script.as_bytes());
    assert_eq!(imported.dropped, ["MC_YAW_P"]);
    insta::assert_snapshot!("airframe", imported.text.unwrap());
}

/// Every table of motors is a vehicle that compiles, with the frame's number of motors.
#[test]
fn every_frame_of_ardupilot_is_a_vehicle_or_a_reason() {
    let mut vehicles = 0;
    for class in 0..17 {
        let rotors = [0, 4, 6, 8, 8, 6, 0, 0, 0, 0, 0, 0, 12, 0, 10, 0, 0][class];
        for kind in 0..22 {
            let file = format!("FRAME_CLASS,{class}\nFRAME_TYPE,{kind}\nMOT_SPIN_MIN,0.15\n");
            let imported = import("copter.param", file.as_bytes());
            match imported.text {
                Some(text) => {
                    let spec = filled(&text);
                    let vehicle = &spec.model().vehicle;
                    assert_eq!(vehicle.rotors.len(), rotors, "{class} {kind}");
                    assert_eq!(vehicle.motors(), Some((1..=rotors as u32).collect()));
                    vehicles += 1;
                }
                None => {
                    assert_eq!(imported.diagnostics.len(), 1);
                    assert_eq!(imported.diagnostics[0].code, "mavc::import::unsupported", "{class} {kind}");
                }
            }
        }
    }
    assert_eq!(vehicles, 10 + 5 + 7 + 9 + 22 + 2 + 3);
}

/// Octa X against the published angles, by their own formula: clockwise from the nose, so that y is minus the sine.
#[test]
fn motors_of_ardupilot_are_where_its_documentation_draws_them() {
    let spec = filled(&text("FRAME_CLASS 3\nFRAME_TYPE 1\n"));
    let published = [
        (22.5, false),
        (-157.5, false),
        (67.5, true),
        (157.5, true),
        (-22.5, true),
        (-112.5, true),
        (-67.5, false),
        (112.5, false),
    ];
    for (rotor, (angle, is_ccw)) in spec.model().vehicle.rotors.iter().zip(published) {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        assert!((rotor.position[0] - 0.25 * cos).abs() < 1e-12 && (rotor.position[1] + 0.25 * sin).abs() < 1e-12);
        assert_eq!(rotor.spin == mavc::model::Spin::P, is_ccw);
    }
}

/// What `mavc emit mjcf` writes is read back as the same vehicle.
#[test]
fn mjcf_of_every_shipped_vehicle_comes_back() {
    for entry in std::fs::read_dir("specs/vehicles").unwrap() {
        let path = entry.unwrap().path();
        let spec = Compiler::new().file(&path).unwrap().into_result().unwrap();
        let there = spec.model();
        let back = filled(&text(&mavc::pipeline::mjcf_text(&spec)));
        let back: &Model = back.model();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(1e-3);
        assert!(near(there.vehicle.mass, back.vehicle.mass));
        assert!((0..3).all(|i| near(there.vehicle.inertia[i], back.vehicle.inertia[i])));
        for (a, b) in there.vehicle.rotors.iter().zip(&back.vehicle.rotors) {
            let ratio = |r: &mavc::model::Rotor| r.drag_coefficient / r.thrust_coefficient;
            assert!(near(a.max_thrust(), b.max_thrust()) && near(ratio(a), ratio(b)) && a.spin == b.spin);
            assert!(near(a.idle_thrust(), b.idle_thrust()) && (0..3).all(|i| near(a.position[i], b.position[i])));
        }
    }
}

const MOTOR: &str = "<plugin name='m' filename='libgazebo_motor_model.so'><linkName>LINK</linkName>\
    <turningDirection>TURN</turningDirection><timeConstantUp>0.0125</timeConstantUp><maxRotVelocity>1000</maxRotVelocity>\
    <motorConstant>8e-06</motorConstant><momentConstant>0.016</momentConstant><motorNumber>NUMBER</motorNumber></plugin>";

fn sdf() -> String {
    let mut out = "<?xml version='1.0'?><sdf version='1.6'><model name='My Quad'><link name='base'><pose>0 0 0.1 0 0 0</pose>\
        <inertial><pose>0.01 0 0 0 0 0</pose><mass>1.5</mass><inertia><ixx>0.03</ixx><iyy>0.04</iyy><izz>0.06</izz></inertia>\
        </inertial></link>"
        .to_string();
    for (k, (x, y, turn)) in
        [(0.2, -0.2, "ccw"), (-0.2, 0.2, "ccw"), (0.2, 0.2, "cw"), (-0.2, -0.2, "cw")].into_iter().enumerate()
    {
        out.push_str(&format!(
            "<link name='r{k}'><pose>{x} {y} 0.15 0 0 0.3</pose><inertial><mass>0.005</mass></inertial></link>{}",
            MOTOR.replace("LINK", &format!("r{k}")).replace("TURN", turn).replace("NUMBER", &k.to_string())
        ));
    }
    out + "</model></sdf>"
}

/// Masses, the common centre and Steiner's theorem by hand.
#[test]
fn sdf_gives_the_whole_vehicle() {
    let spec = compile(&text(&sdf())).into_result().unwrap_or_else(|e| panic!("{e}"));
    let vehicle = &spec.model().vehicle;
    assert_eq!(vehicle.name, "my_quad");
    let (base, rotor) = (1.5, 0.005);
    let mass: f64 = base + 4.0 * rotor;
    let (cx, cz) = (base * 0.01 / mass, (base * 0.1 + 4.0 * rotor * 0.15) / mass);
    assert!((vehicle.mass - mass).abs() < 1e-11);
    let ixx = 0.03 + base * (0.1 - cz).powi(2) + 4.0 * rotor * (0.04 + (0.15 - cz).powi(2));
    let iyy = 0.04
        + base * ((0.01 - cx).powi(2) + (0.1 - cz).powi(2))
        + 2.0 * rotor * ((0.2 - cx).powi(2) + (0.2 + cx).powi(2) + 2.0 * (0.15 - cz).powi(2));
    assert!(
        (vehicle.inertia[0] - ixx).abs() < 1e-10 && (vehicle.inertia[1] - iyy).abs() < 1e-10,
        "{:?}",
        vehicle.inertia
    );
    let first = &vehicle.rotors[0];
    assert!((first.position[0] - (0.2 - cx)).abs() < 1e-11 && (first.position[2] - (0.15 - cz)).abs() < 1e-11);
    assert_eq!((first.thrust_coefficient, first.max_speed, first.time_constant), (8e-6, 1000.0, Some(0.0125)));
    assert_eq!(vehicle.motors(), Some(vec![1, 2, 3, 4]));
}

/// Coefficients in revolutions per minute, and joints that place the links.
#[test]
fn urdf_of_gym_pybullet_drones_leaves_only_the_spins_open() {
    let mut urdf = "<robot name='cf'><properties arm='0.04' kf='3e-10' km='8e-12' thrust2weight='2'/>\
        <link name='base_link'><inertial><mass value='0.03'/><inertia ixx='1.4e-5' iyy='1.4e-5' izz='2.2e-5'/></inertial></link>"
        .to_string();
    for (k, (x, y)) in [(0.03, -0.03), (-0.03, -0.03), (-0.03, 0.03), (0.03, 0.03)].into_iter().enumerate() {
        urdf.push_str(&format!(
            "<link name='prop{k}_link'><inertial><mass value='0'/></inertial></link><joint name='j{k}' type='fixed'>\
             <parent link='base_link'/><child link='prop{k}_link'/><origin xyz='{x} {y} 0'/></joint>"
        ));
    }
    let imported = import("cf.urdf", (urdf + "</robot>").as_bytes());
    assert_eq!(imported.dropped, ["arm"]);
    let text = imported.text.unwrap();
    assert_eq!(text.matches("spin ?").count(), 4);
    let spec = filled(&text.replacen("spin ?", "spin N", 2));
    let rotor = &spec.model().vehicle.rotors[0];
    let rpm = std::f64::consts::PI / 30.0;
    assert!((rotor.thrust_coefficient * rpm * rpm / 3e-10 - 1.0).abs() < 1e-12);
    // Full thrust is twice the weight over four rotors, with the simulator's 9.8 m/s^2.
    assert!((rotor.max_thrust() - 2.0 * 0.03 * 9.8 / 4.0).abs() < 1e-12, "{}", rotor.max_thrust());
    assert_eq!(rotor.position, [0.03, -0.03, 0.0]);
}

/// Wrong files: the code, and a word of the message; the place lies in the text.
#[test]
fn wrong_files_get_a_placed_error() {
    let cases: &[(&str, &str, &str)] = &[
        ("", "mavc::import::format", "the file is empty"),
        ("QGC WPL 110\n", "mavc::import::format", "`mavc import mission`"),
        ("x,y,z\n0,0,1\n", "mavc::import::format", "`mavc import mission`"),
        ("FRAME_CLASS,0\n", "mavc::import::unsupported", "choose the frame"),
        ("hello\n", "mavc::import::format", "no vehicle"),
        ("1\t1\tCA_ROTOR_COUNT\t4", "mavc::import::syntax", "not complete"),
        ("param set CA_ROTOR_COUNT inf\n", "mavc::import::syntax", "finite number"),
        ("param set CA_ROTOR_COUNT 3\n", "mavc::import::unsupported", "4 to 32"),
        ("param set CA_ROTOR_COUNT -4\n", "mavc::import::unsupported", "4 to 32"),
        ("param set CA_ROTOR_COUNT 1e30\n", "mavc::import::unsupported", "4 to 32"),
        ("param set CA_ROTOR0_PX 1\n", "mavc::import::unsupported", "CA_ROTOR_COUNT"),
        ("param set CA_AIRFRAME 2\n", "mavc::import::unsupported", "VTOL"),
        ("param set CA_ROTOR_COUNT 4\nparam set CA_ROTOR2_AX 0.5\n", "mavc::import::unsupported", "motor 3"),
        ("param set CA_ROTOR_COUNT 4\nparam set CA_ROTOR1_TILT 1\n", "mavc::import::unsupported", "motor 2"),
        ("set MIXER quad_x\n", "mavc::import::unsupported", "mixer"),
        (". ${R}etc/init.d/rc.mc_defaults\n", "mavc::import::unsupported", "places a rotor"),
        (". ${R}etc/init.d-posix/airframes/4001_gz_x500\n", "mavc::import::unsupported", "name `4001_gz_x500`"),
        ("# @class VTOL\nset MIXER quad_x\n", "mavc::import::unsupported", "kind `VTOL`"),
        ("# @class Copter\n# @type Helicopter\nset MIXER heli\n", "mavc::import::unsupported", "kind `Helicopter`"),
        ("# @class Spacecraft\nparam set CA_AIRFRAME 99\n", "mavc::import::unsupported", "kind `Spacecraft`"),
        ("set MIXER skip\nparam set CA_MC_R0_PX 0.1\n", "mavc::import::unsupported", "PX4 has no more"),
        ("set MIXER none\n", "mavc::import::format", "no vehicle"),
        ("param set CA_ROTOR_COUNT ${N}\n", "mavc::import::syntax", "works out"),
        ("param set CA_ROTOR_COUNT 4\nparam set CA_ROTOR0_PX `arm`\n", "mavc::import::syntax", "`CA_ROTOR0_PX`"),
        ("param set CA_ROTOR0_PX 1e300\n", "mavc::import::syntax", "single precision"),
        ("FRAME_CLASS,7\n", "mavc::import::unsupported", "tricopter"),
        ("FRAME_CLASS,1\nFRAME_TYPE,11\n", "mavc::import::unsupported", "frame type 11"),
        ("FRAME_CLASS,1.5\n", "mavc::import::unsupported", "unknown"),
        ("<robot", "mavc::import::syntax", "well-formed"),
        ("<robot></wrong>", "mavc::import::syntax", "well-formed"),
        ("<!DOCTYPE a [<!ENTITY b \"c\">]><robot>&b;</robot>", "mavc::import::syntax", "well-formed"),
        ("<html/>", "mavc::import::unsupported", "not a robot"),
        ("<sdf/>", "mavc::import::unsupported", "no model"),
        ("<robot/>", "mavc::import::unsupported", "no rotor"),
        ("<mujoco/>", "mavc::import::unsupported", "no rotor"),
        ("<robot><properties kf='0' km='1'/></robot>", "mavc::import::unsupported", "above zero"),
        ("<robot><properties km='1'/></robot>", "mavc::import::syntax", "`kf`"),
        (
            "<robot><joint><parent link='a'/><child link='a'/></joint><link name='a'/></robot>",
            "mavc::import::syntax",
            "circle",
        ),
        (
            "<sdf><model><link name='a'><pose>1 2 x 0 0 0</pose></link></model></sdf>",
            "mavc::import::syntax",
            "6 finite numbers",
        ),
        (
            "<sdf><model><plugin><motorConstant>1</motorConstant></plugin></model></sdf>",
            "mavc::import::unsupported",
            "link",
        ),
    ];
    for (file, code, words) in cases {
        let imported = import("x", file.as_bytes());
        let error = imported.diagnostics.last().unwrap_or_else(|| panic!("{file}: no error"));
        assert_eq!((error.code, imported.text.is_none()), (*code, true), "{file}: {error:?}");
        let all = format!("{} {} {}", error.message, error.label, error.help.as_deref().unwrap_or_default());
        assert!(all.contains(words), "{file}: {all}");
        check_places(&imported, file);
    }
}

/// What a script leaves open or says twice is named.
#[test]
fn scripts_that_leave_something_open_get_a_warning() {
    let script = |lines: &str| {
        let frame = (0..4).fold("param set-default CA_ROTOR_COUNT 4\n".to_string(), |text, i| {
            let (x, y) = [(0.2, 0.1), (-0.2, -0.1), (0.2, -0.1), (-0.2, 0.1)][i];
            text + &format!("param set-default CA_ROTOR{i}_PX {x}\nparam set-default CA_ROTOR{i}_PY {y}\n")
        });
        import("4001_quad", (frame + lines).as_bytes())
    };
    assert_eq!(script("").diagnostics.len(), 0);
    // A value that is set once more and is the same says nothing new.
    assert_eq!(script("param set-default CA_ROTOR1_PX -0.2\n").diagnostics.len(), 0);
    for (lines, words) in [
        ("param set-default CA_ROTOR_COUNT 5\n", "no place of motor 5"),
        ("param set-default CA_ROTOR1_PX -0.3\n", "`CA_ROTOR1_PX` is set twice"),
    ] {
        let imported = script(lines);
        let found = imported.diagnostics.iter().find(|d| d.message.contains(words));
        assert_eq!(
            found.unwrap_or_else(|| panic!("{lines}: {:?}", imported.diagnostics)).code,
            "mavc::import::assumed"
        );
        assert!(imported.text.is_some());
        check_places(&imported, lines);
    }
    // A saved file has every parameter of every rotor.
    let saved = |without: &str, count: usize| {
        let rotor = |i: usize| {
            let (x, y) = [(0.2, 0.1), (-0.2, -0.1), (0.2, -0.1), (-0.2, 0.1)][i];
            let rows = [("PX", x), ("PY", y), ("PZ", 0.0), ("KM", 0.02)];
            rows.map(|(key, value)| format!("1\t1\tCA_ROTOR{i}_{key}\t{value}\t9\n")).concat()
        };
        let rows: String = (0..4).map(rotor).collect();
        let rows =
            rows.lines().filter(|row| without.is_empty() || !row.contains(without)).map(|row| format!("{row}\n"));
        import("saved.params", (rows.collect::<String>() + &format!("1\t1\tCA_ROTOR_COUNT\t{count}\t6\n")).as_bytes())
    };
    assert_eq!(saved("", 4).diagnostics.len(), 0);
    for (without, words) in
        [("CA_ROTOR2_PX", "motor 3 has no `CA_ROTOR2_PX`"), ("CA_ROTOR1_KM", "motor 2 has no `CA_ROTOR1_KM`")]
    {
        let imported = saved(without, 4);
        assert!(imported.diagnostics.iter().any(|d| d.message.contains(words)), "{words}: {:?}", imported.diagnostics);
        check_places(&imported, without);
    }
    assert!(saved("CA_ROTOR1_KM", 4).text.unwrap().contains("0.05 m  // torque_per_thrust is PX4's default"));
    // A script leaves out what is PX4's default.
    let default = script("param set-default CA_ROTOR2_KM -0.05\n");
    assert!(
        default.diagnostics.len() == 1 && default.diagnostics[0].message.contains("PX4's default, 0.05 m"),
        "{:?}",
        default.diagnostics
    );
    assert!(saved("", 5).diagnostics.iter().any(|d| d.message.contains("no place of motor 5")));
    let more = script("param set-default CA_ROTOR5_PX 0.4\n");
    assert!(
        more.diagnostics[0].message.contains("places motor 6, but `CA_ROTOR_COUNT` is 4"),
        "{:?}",
        more.diagnostics
    );
    for (text, words) in [
        ("FRAME_CLASS,2\n", "no `FRAME_TYPE`"),
        ("FRAME_CLASS,1\nFRAME_CLASS,2\nFRAME_TYPE,1\n", "`FRAME_CLASS` is set twice"),
    ] {
        let imported = import("copter.param", text.as_bytes());
        assert!(
            imported.diagnostics[0].message.contains(words) && imported.text.is_some(),
            "{:?}",
            imported.diagnostics
        );
        check_places(&imported, text);
    }
    let ring = (0..6).fold("param set CA_ROTOR_COUNT 6\n".to_string(), |text, i| {
        let (y, x) = f64::to_radians(60.0 * i as f64).sin_cos();
        text + &format!("param set CA_ROTOR{i}_PX {x:.3}\nparam set CA_ROTOR{i}_PY {y:.3}\n")
    });
    assert!(import("x", ring.as_bytes()).diagnostics[0].message.contains("proportions"));
}

/// Ratios of numbers that are finite need not be.
#[test]
fn infinite_ratios_are_errors() {
    let motors = |gear: &str| {
        let sites: String = (0..4).map(|i| format!("<site name='s{i}' pos='{i} 1 0'/>")).collect();
        let motors: String = (0..4).map(|i| format!("<motor site='s{i}' gear='{gear}'/>")).collect();
        format!("<mujoco><worldbody><body>{sites}</body></worldbody><actuator>{motors}</actuator></mujoco>")
    };
    assert!(import("x", motors("0 0 1 0 0 0.1").as_bytes()).text.is_some());
    let imported = import("x", motors("0 0 1e-320 0 0 0.1").as_bytes());
    let error = imported.diagnostics.last().unwrap();
    assert_eq!((error.code, imported.text.is_none()), ("mavc::import::syntax", true));
    assert!(error.message.contains("`torque_per_thrust` of motor 1"), "{error:?}");
}

fn check_places(imported: &Imported, file: &str) {
    for diagnostic in &imported.diagnostics {
        for span in diagnostic.labels.iter().map(|l| l.span).chain([diagnostic.span]) {
            let shown = &imported.sources.get(span.file).text;
            assert!(shown.get(span.start as usize..span.end as usize).is_some(), "{file}: {diagnostic:?}");
        }
        assert!(diagnostic.help.is_some() && diagnostic.message.len() < 300, "{diagnostic:?}");
    }
}

/// Bytes changed, removed and repeated at random: a spec that parses, or an error at a place; never a panic.
#[test]
fn changed_files_never_panic() {
    let px4: String = (0..4).fold("param set CA_ROTOR_COUNT 4\n".into(), |out, i| {
        out + &format!(
            "param set CA_ROTOR{i}_PX 0.{i}1\nparam set CA_ROTOR{i}_PY -0.2\nparam set CA_ROTOR{i}_KM {}\n",
            0.05 - 0.03 * i as f32
        )
    });
    let mjcf = "<mujoco><worldbody><body><inertial mass='1' diaginertia='1 1 1'/><site name='a' pos='0 1 0'/></body></worldbody>\
                <actuator><motor site='a' gear='0 0 1 0 0 -0.01' ctrlrange='0 4'/></actuator></mujoco>";
    let files = [px4, "FRAME_CLASS,3\nFRAME_TYPE 1\n# x\nA_B=4\n".into(), sdf(), mjcf.into()];
    let mut random = Pcg64Mcg::new(11);
    let marks: &[u8] = b"<>/='\"&\t\n0-.eNX\xff#,";
    let (mut read, mut refused) = (0, 0);
    for round in 0..600 {
        let mut bytes = files[round % files.len()].clone().into_bytes();
        for _ in 0..1 + round % 4 {
            let at = whole(&mut random) % bytes.len().max(1);
            match whole(&mut random) % 4 {
                0 => bytes.truncate(at),
                1 => drop(bytes.drain(at..(at + 9).min(bytes.len()))),
                2 => bytes.insert(at, marks[whole(&mut random) % marks.len()]),
                _ => {
                    let piece = bytes[at..(at + 40).min(bytes.len())].to_vec();
                    bytes.splice(at..at, piece);
                }
            }
        }
        let imported = import("x\u{202e}/../a b.params", &bytes);
        check_places(&imported, &String::from_utf8_lossy(&bytes));
        match &imported.text {
            Some(text) => {
                // Nothing but open or implausible figures may be wrong with it.
                let syntax =
                    compile(text).diagnostics.into_iter().filter(|d| d.code.starts_with("mavc::syntax")).count();
                assert_eq!(syntax, 0, "{text}");
                read += 1;
            }
            None => refused += 1,
        }
    }
    assert!(read > 50 && refused > 50, "{read} {refused}");
}

/// Deep and large files are refused or read in bounded time.
#[test]
fn deep_and_large_files_are_refused() {
    let deep = "<a>".repeat(300_000);
    assert_eq!(import("x", deep.as_bytes()).diagnostics[0].code, "mavc::import::syntax");
    let many = "<robot>".to_string() + &"<link/>".repeat(600_000);
    assert!(import("x", many.as_bytes()).diagnostics[0].message.contains("nodes limit"));
    let large = vec![b'A'; mavc::import::MAX_BYTES + 1];
    assert_eq!(import("x", &large).diagnostics[0].code, "mavc::import::format");
}

/// A chain as long as a file may have it, with the rotors at its end: each joint is passed once, so that it is read at
/// once.
#[test]
fn long_chains_of_links_are_read() {
    const LINKS: usize = 60_000;
    let mut urdf =
        "<robot name='chain'><properties kf='3e-10' km='8e-12' thrust2weight='2'/><link name='l0'/>".to_string();
    for i in 1..LINKS {
        urdf.push_str(&format!(
            "<link name='l{i}'/><joint><parent link='l{}'/><child link='l{i}'/><origin xyz='0.001 0 0'/></joint>",
            i - 1
        ));
    }
    for (k, place) in ["0.1 -0.1 0", "-0.1 -0.1 0", "-0.1 0.1 0", "0.1 0.1 0.04"].into_iter().enumerate() {
        urdf.push_str(&format!(
            "<link name='prop{k}_link'><inertial><mass value='0.25'/></inertial></link>\
             <joint><parent link='l{}'/><child link='prop{k}_link'/><origin xyz='{place}'/></joint>",
            LINKS - 1
        ));
    }
    let imported = import("chain.urdf", (urdf + "</robot>").as_bytes());
    let text = imported.text.unwrap_or_else(|| panic!("{:?}", imported.diagnostics));
    assert!(text.contains(" = 1 kg") && text.contains("[ 0.1,  0.1,  0.03] m"), "{text}");
}

/// As many motors and classes as a file may have.
#[test]
fn motors_of_many_classes_are_counted() {
    const MOTORS: usize = 60_000;
    let each = |of: &dyn Fn(usize) -> String| (0..MOTORS).map(of).collect::<String>();
    let text = format!(
        "<mujoco><default>{}</default><worldbody><body>{}</body></worldbody><actuator>{}</actuator></mujoco>",
        each(&|i| format!("<default class='c{i}'><motor gear='0 0 1 0 0 0.1'/></default>")),
        each(&|i| format!("<site name='s{i}'/>")),
        each(&|i| format!("<motor class='c{i}' site='s{i}'/>")),
    );
    let message = &import("x", text.as_bytes()).diagnostics[0].message;
    assert!(message.contains("a spec has 4 to 32 rotors, and the file 60000"), "{message}");
}

/// The parser compares every attribute of an element, and every namespace, with all others.
#[test]
fn elements_with_too_many_attributes_are_refused() {
    let refused = |text: &str| {
        let diagnostics = import("x", text.as_bytes()).diagnostics;
        diagnostics[0].message.contains("more than 1000 attributes")
    };
    let many = |name: &str, count: usize| (0..count).map(|i| format!("{name}{i}='>1'\n")).collect::<String>();
    assert!(refused(&format!("<robot {}/>", many("a", 1001))));
    assert!(!refused(&format!("<robot {}/>", many("a", 1000))));
    assert!(refused(&format!("<robot>{}</robot>", format!("<x {}/>", many("xmlns:a", 600)).repeat(2))));
    assert!(!refused(&format!(
        "<!-- {} --><?x {}?><robot><![CDATA[<{}]]></robot>",
        many("a", 2000),
        many("a", 2000),
        many("a", 2000)
    )));
}

/// The command: the spec on standard output, remarks on standard error; with an error nothing is written.
#[test]
fn the_command_writes_the_spec_or_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("copter.param"), "FRAME_CLASS,1\nFRAME_TYPE,1\nMOT_SPIN_MIN,0.1\n").unwrap();
    let ran = mavc(&["import", "vehicle", &path("copter.param"), "-o", &path("copter.mav")]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(err(&ran).contains("MOT_SPIN_MIN") && err(&ran).contains("mavc check"), "{}", err(&ran));
    let checked = mavc(&["check", &path("copter.mav")]);
    assert_eq!(checked.status.code(), Some(1));
    let said = err(&checked) + &out(&checked);
    assert_eq!(said.matches("mavc::value::unknown").count(), 6, "{said}");
    assert!(said.contains("`mass` of vehicle `copter` is not known yet"), "{said}");
    std::fs::write(path("bad.param"), "FRAME_CLASS,7\n").unwrap();
    let ran = mavc(&["import", "vehicle", &path("bad.param"), "-o", &path("bad.mav")]);
    assert_eq!((ran.status.code(), std::path::Path::new(&path("bad.mav")).exists()), (Some(1), false));
    let ran = mavc(&["import", "vehicle", &path("copter.param"), "-o", &path("copter.param")]);
    assert_eq!(ran.status.code(), Some(2), "{}", err(&ran));
    // What was filled in by hand is not overwritten.
    std::fs::write(path("copter.mav"), "mine").unwrap();
    let ran = mavc(&["import", "vehicle", &path("copter.param"), "-o", &path("copter.mav")]);
    assert_eq!(ran.status.code(), Some(2), "{}", err(&ran));
    assert!(err(&ran).contains("exists already; nothing was written"), "{}", err(&ran));
    assert_eq!(std::fs::read_to_string(path("copter.mav")).unwrap(), "mine");
}
