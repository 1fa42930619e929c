//! SDF, MJCF and URDF: frames, masses of shapes, and what is refused instead of ignored. `benches/readers/robots.py`
//! compares random vehicles with libsdformat and MuJoCo.

use mavc::compile;
use mavc::import::Imported;
use mavc::import::vehicle::import;
use mavc::model::Vehicle;

fn file(name: &str) -> String {
    std::fs::read_to_string(format!("tests/specs/findings/files/{name}")).unwrap()
}

fn read(text: &str) -> Imported {
    import("v.xml", text.as_bytes())
}

/// The vehicle of a file, with figures for what it leaves open.
fn vehicle(text: &str) -> Vehicle {
    let imported = read(text);
    let text = imported.text.unwrap_or_else(|| panic!("{:?}", imported.diagnostics));
    let text = text.replace("max_speed         = ?", "max_speed = 700 rad/s");
    let text = text.replacen("spin ?", "spin P", 2).replace("spin ?", "spin N");
    compile(&text).into_result().unwrap_or_else(|e| panic!("{e}")).model().vehicle.clone()
}

fn same(a: &Vehicle, b: &Vehicle) {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(1e-3);
    assert!(
        near(a.mass, b.mass) && (0..3).all(|i| near(a.inertia[i], b.inertia[i])),
        "{:?} {:?}",
        a.inertia,
        b.inertia
    );
    for (a, b) in a.rotors.iter().zip(&b.rotors) {
        assert!((0..3).all(|i| near(a.position[i], b.position[i])), "{:?} {:?}", a.position, b.position);
    }
}

/// `gz sdf -p` places the links of a merged model in frames.
#[test]
fn frames_of_sdf_place_links() {
    same(&vehicle(&file("merged_frames.sdf")), &vehicle(&file("flat.sdf")));
    same(&vehicle(&file("degrees.sdf")), &vehicle(&file("radians.sdf")));
    let turned = file("degrees.sdf").replace(
        "<pose degrees=\"true\">0 0 0 0 0 90</pose>",
        "<pose rotation_format='quat_xyzw'>0 0 0 0 0 1 1</pose>",
    );
    same(&vehicle(&turned), &vehicle(&file("radians.sdf")));
    // An empty pose is none, and a world may have a ground before the vehicle.
    let model = file("flat.sdf").replace("<pose>0 0 0 0 0 0</pose>", "<pose relative_to='__model__'/>");
    same(&vehicle(&model), &vehicle(&file("flat.sdf")));
    let world = model
        .replace(
            "<model name=\"quad\">",
            "<world name='w'><model name='ground'><link name='l'/></model><model name=\"quad\">",
        )
        .replace("</model>\n</sdf>", "</model></world></sdf>");
    same(&vehicle(&world), &vehicle(&file("flat.sdf")));
    let lost = file("merged_frames.sdf").replace("<frame name=\"_merged__body__model__\"", "<frame name=\"other\"");
    let error = read(&lost).diagnostics.pop().unwrap();
    assert!(error.message.contains("`base` is placed relative to `_merged__body__model__`"), "{error:?}");
    let circle = file("merged_frames.sdf").replace("relative_to=\"__model__\"", "relative_to=\"base\"");
    assert_eq!(read(&circle).diagnostics.pop().unwrap().code, "mavc::import::syntax");
}

/// A plate and a pack of 0.8 kg each: their common centre, and their moments by Steiner's theorem.
#[test]
fn masses_of_shapes_give_the_centre_of_gravity() {
    let found = vehicle(&file("geom_masses.xml"));
    assert_eq!(found.mass, 1.6);
    let boxed = |[a, b]: [f64; 2]| 0.8 / 3.0 * (a * a + b * b);
    let due = [
        boxed([0.08, 0.01]) + boxed([0.02, 0.015]) + 1.6 * 0.01 * 0.01,
        boxed([0.08, 0.01]) + boxed([0.04, 0.015]) + 1.6 * (0.03 * 0.03 + 0.01 * 0.01),
        boxed([0.08, 0.08]) + boxed([0.04, 0.02]) + 1.6 * 0.03 * 0.03,
    ];
    assert!((0..3).all(|i| (found.inertia[i] / due[i] - 1.0).abs() < 1e-9), "{:?} {due:?}", found.inertia);
    // The centre is at (0.03, 0, -0.01).
    let at = found.rotors[0].position;
    assert!((0..3).all(|i| (at[i] - [0.17, -0.2, 0.04][i]).abs() < 1e-9), "{at:?}");
    // With `inertiafromgeom="false"` nothing is known, and of a mesh neither.
    for text in [
        file("geom_masses.xml").replace("<worldbody>", "<compiler inertiafromgeom='false'/><worldbody>"),
        file("geom_masses.xml").replace("type=\"box\" pos", "type=\"mesh\" mesh=\"pack\" pos"),
    ] {
        assert!(read(&text).text.unwrap().contains("mass    = ?"));
    }
    let mesh = read(&file("geom_masses.xml").replace("type=\"box\" pos", "type=\"mesh\" mesh=\"pack\" pos"));
    assert!(mesh.diagnostics[0].message.contains("the mass of this shape is not computed"));
}

/// `gainprm`, the turn of `inertial` and `settotalmass`.
#[test]
fn settings_of_mjcf_are_followed() {
    let text = file("general_gain.mjcf");
    let found = vehicle(&text);
    assert!((found.rotors[0].max_thrust() - 9.0).abs() < 1e-12);
    assert!((0..3).all(|i| (found.inertia[i] - [0.03, 0.01, 0.035][i]).abs() < 1e-12), "{:?}", found.inertia);
    let heavier = vehicle(&text.replace("<compiler ", "<compiler settotalmass='3' "));
    assert!((heavier.mass - 3.0).abs() < 1e-12 && (heavier.inertia[2] - 0.07).abs() < 1e-12);
    let limited =
        vehicle(&text.replace("gainprm=\"9\"", "gainprm=\"9\" forcerange=\"0 5\" dyntype=\"filter\" dynprm=\"0.03\""));
    assert!((limited.rotors[0].max_thrust() - 5.0).abs() < 1e-12);
    assert_eq!(limited.rotors[0].time_constant, Some(0.03));
    // A default of the class, as the actuators' own.
    let class = text.replace(" gear=\"0 0 1 0 0 -0.016\" ctrlrange=\"0 1\" gainprm=\"9\"", "").replace(
        "<worldbody>",
        "<default><general gear='0 0 2 0 0 -0.032' ctrlrange='0 1' gainprm='4'/></default><worldbody>",
    );
    assert!((vehicle(&class).rotors[0].max_thrust() - 8.0).abs() < 1e-12);
    for (from, to, words) in [
        ("gainprm=\"9\"", "gainprm=\"9\" biastype=\"affine\" biasprm=\"0 -1\"", "depends on its motion"),
        ("gainprm=\"9\"", "gainprm=\"9\" dyntype=\"integrator\"", "the dynamics `integrator`"),
        ("gainprm=\"9\"", "gainprm=\"-9\"", "falls with its control"),
        ("<compiler ", "<compiler boundmass='2' ", "`boundmass=\"2\"` of the compiler is not read"),
        ("<compiler ", "<compiler inertiagrouprange='3 3' ", "`inertiagrouprange"),
        ("<freejoint/>", "<freejoint/><include file='arms.xml'/>", "the file has `include`"),
        (
            "<site name=\"s2\" pos=\"-0.2 -0.2 0\"/>",
            "<body><joint axis='0 1 0'/><site name='s2' pos='-0.2 -0.2 0'/></body>",
            "an arm that moves",
        ),
        ("<site name=\"s2\"", "<site euler=\"20 0 0\" name=\"s2\"", "the site of a motor is turned"),
    ] {
        let error = read(&text.replacen(from, to, 9)).diagnostics.pop().unwrap();
        assert!(error.message.contains(words) && error.code == "mavc::import::unsupported", "{words}: {error:?}");
    }
    // A propeller that turns about its axis is on no such arm.
    let propeller = "<body pos='-0.2 -0.2 0'><joint axis='0 0 1'/><site name='s2'/></body>";
    let text = text.replace("<site name=\"s2\" pos=\"-0.2 -0.2 0\"/>", propeller);
    assert!((vehicle(&text).rotors[1].position[0] + 0.2).abs() < 1e-12);
}

#[test]
fn arms_that_turn_wings_and_includes_are_not_passed_over() {
    let flat = file("flat.sdf");
    let arm = "<link name='arm'/><joint name='tilt' type='revolute'><parent>base</parent><child>arm</child></joint>\
               <link name=\"prop1\">";
    let tilting = flat.replace("<link name=\"prop1\">", arm).replacen(
        "<joint name=\"j1\" type=\"revolute\"><parent>base",
        "<joint name=\"j1\" type=\"revolute\"><parent>arm",
        1,
    );
    let error = read(&tilting).diagnostics.pop().unwrap();
    assert!(error.message.contains("a rotor is on the arm `arm`, which turns or slides"), "{error:?}");
    assert!(read(&tilting.replace("'tilt' type='revolute'", "'tilt' type='fixed'")).text.is_some());
    let include =
        flat.replacen("<link name=\"base\">", "<include><uri>model://camera</uri></include><link name=\"base\">", 1);
    assert!(read(&include).diagnostics.pop().unwrap().message.contains("the model includes another"));
    let wing = flat
        .replace("</model>", "<plugin filename='gz-sim-lift-drag-system' name='gz::sim::systems::LiftDrag'/></model>");
    let imported = read(&wing);
    assert!(
        imported.text.is_some() && imported.diagnostics[0].message.contains("lift and drag of a surface are left out")
    );
    let massless = read(&flat.replace("</model>", "<link name='tip'/></model>"));
    assert!(massless.diagnostics.iter().any(|d| d.message.contains("1 of the model have no `inertial`")));
    // In URDF the same.
    let urdf = file("prop_radius.urdf");
    let arm = "<link name=\"arm\"/><joint name=\"tilt\" type=\"revolute\"><parent link=\"base_link\"/>\
               <child link=\"arm\"/></joint>";
    let fixed = "<joint name=\"prop1_joint\" type=\"fixed\"><parent link=";
    let tilting = urdf.replace(&format!("{fixed}\"base_link\""), &format!("{arm}{fixed}\"arm\""));
    let error = read(&tilting).diagnostics.pop().unwrap();
    assert!(error.message.contains("a rotor is on the arm `arm`"), "{error:?}");
}

#[test]
fn the_radius_of_propellers_is_read() {
    let imported = read(&file("prop_radius.urdf"));
    assert!(!imported.dropped.contains(&"prop_radius".to_string()));
    assert_eq!(vehicle(&file("prop_radius.urdf")).propeller_radius, Some(0.025));
}

#[test]
fn templates_are_called_so() {
    for (text, program) in [
        (file("template.sdf.jinja"), "Jinja"),
        ("<?xml version='1.0'?>\n{% set a = 1 %}<sdf/>".into(), "Jinja"),
        ("<%# pi %><sdf/>".into(), "ERB"),
        ("<robot xmlns:xacro='http://ros.org/wiki/xacro'><xacro:property name='a' value='1'/></robot>".into(), "xacro"),
    ] {
        for imported in [
            import("v.sdf.jinja", text.as_bytes()),
            mavc::import::mission::import("v.sdf.jinja", text.as_bytes(), None),
        ] {
            let error = imported.diagnostics.last().unwrap();
            assert_eq!(error.message, format!("this is a template of {program}"));
            assert!(error.help.as_ref().unwrap().contains("`mavc import vehicle v."), "{error:?}");
        }
    }
}

/// Gazebo and MuJoCo read names with prefixes that nothing declares, and comments with two hyphens.
#[test]
fn what_gazebo_and_mujoco_read_is_read() {
    let flat = file("flat.sdf");
    let same_model = vehicle(&flat);
    let loose = flat
        .replacen("<link name=\"base\">", "<!-- a -- b --><link name=\"base\" gz:note='x:y'><gz:extra/>", 1)
        .replacen("<sdf", "<!-- first -->\n<sdf", 1);
    assert_ne!(loose, flat);
    same(&vehicle(&loose), &same_model);
    // The place of a mistake stays where it is in the file.
    let wrong = loose.replacen("<mass>", "<mass>x", 1);
    let error = read(&wrong).diagnostics.pop().unwrap();
    assert!(wrong[error.span.start as usize..].starts_with("<mass"), "{error:?}");
    assert_eq!(read("<sdf><a b:c='1'</sdf>").diagnostics.pop().unwrap().code, "mavc::import::syntax");
}

/// PX4's motor model takes the number of a motor from `actuator_number` before `motorNumber`; without a number of its
/// own for each, the spec numbers them, and compiles.
#[test]
fn motors_of_gazebo_sim_have_their_numbers() {
    let flat = file("flat.sdf");
    let numbers = |text: &str| vehicle(text).motors().unwrap();
    let named = flat.replace("motorNumber", "actuator_number");
    assert!(named != flat && numbers(&named) == numbers(&flat));
    let both = flat.replace("</turningDirection>", "</turningDirection><actuator_number>9</actuator_number>");
    let none = (0..4).fold(flat.clone(), |text, i| text.replace(&format!("<motorNumber>{i}</motorNumber>"), ""));
    assert!(!none.contains("motorNumber"));
    for text in [none, both] {
        let imported = read(&text);
        let message = &imported.diagnostics[0].message;
        assert!(message.contains("the same number, or none"), "{message}");
        assert_eq!(numbers(&text), [1, 2, 3, 4]);
    }
}

/// A scene of MuJoCo includes the vehicle: the error names its file.
#[test]
fn a_scene_that_includes_the_vehicle_names_its_file() {
    let scene =
        "<mujoco model=\"scene\"><include file=\"x2.xml\"/><worldbody><light pos=\"0 0 3\"/></worldbody></mujoco>";
    let error = read(scene).diagnostics.pop().unwrap();
    assert!(error.message.contains("includes `x2.xml`") && error.help.unwrap().contains("name `x2.xml`"));
}

/// Some models have the thrust and the moments of the whole body in place of rotors.
#[test]
fn moments_of_the_whole_body_are_not_called_rotors() {
    let text = "<mujoco><worldbody><body><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>\
                <site name='s'/></body></worldbody><actuator><motor gear='0 0 1 0 0 0' site='s'/><motor gear='0 0 0 -1e-5 0 0' site='s'/>\
                </actuator></mujoco>";
    let error = read(text).diagnostics.pop().unwrap();
    assert!(error.message.contains("a moment of the whole body"), "{error:?}");
}

/// Rotors of the motor model have an inertia, slowed down in the simulation, and a drag across their axes.
#[test]
fn the_inertia_and_the_drag_of_rotors_are_read() {
    let text = file("flat.sdf");
    let inertia = |text: &str| vehicle(text).rotors.iter().map(|rotor| rotor.inertia).collect::<Vec<_>>();
    assert_eq!(inertia(&text), [2e-7; 4]);
    let real = text.replace("<motorType>", "<rotorVelocitySlowdownSim>1</rotorVelocitySlowdownSim><motorType>");
    assert_eq!(inertia(&real), [2e-6; 4]);
    let dragged = text.replace("<motorType>", "<rotorDragCoefficient>1e-4</rotorDragCoefficient><motorType>");
    // Four rotors at sqrt(m g/(4 k)) rad/s.
    let due = 4.0 * 1e-4 * (1.64 * 9.81 / (4.0 * 8e-6_f64)).sqrt();
    let drag = vehicle(&dragged).drag;
    assert!((drag[0] / due - 1.0).abs() < 1e-3 && drag[1] == drag[0] && drag[2] == 0.0, "{drag:?}, {due}");
    let said = read(&dragged).text.unwrap();
    assert!(!said.contains("// drag") && said.contains("// yaw_drag"), "{said}");
    assert_eq!(read(&text).dropped, ["timeConstantDown"]);
    let world = "<sdf version='1.9'><world name='w'><include><uri>x500</uri></include></world></sdf>";
    assert!(read(world).diagnostics.pop().unwrap().message.contains("the world includes its vehicles"));
}

/// Without figures of the file the estimates stand in comments, change nothing there, and are fields when the
/// slashes go.
#[test]
fn estimates_stand_in_comments() {
    let file = |name: &str| file(name).replace("<izz>2e-6</izz>", "");
    let text = read(&file("flat.sdf")).text.unwrap();
    let plain = vehicle(&file("flat.sdf"));
    assert!(plain.yaw_drag.is_none() && !plain.has_rotor_inertia() && plain.drag == [0.0; 3]);
    let field = |line: &str| match line.trim().strip_prefix("// ").filter(|rest| rest.contains("(estimate")) {
        Some(rest) => rest.split("  (").next().unwrap().to_string(),
        None => line.to_string(),
    };
    let fields: Vec<String> = text.lines().map(field).collect();
    let estimated = compile(&fields.join("\n"));
    let vehicle = estimated.into_result().unwrap_or_else(|e| panic!("{e}")).model().vehicle.clone();
    // 1.64 kg on four rotors, at arms of 0.15 m to each side; thrust and speed suggest the propeller, and hover its tips.
    let turns = 1.0 / std::f64::consts::TAU;
    let diameter = (8e-6 / turns.powi(2) / (0.1 * 1.225)).powf(0.25);
    let tips = 0.5 * diameter * (1.64 * 9.81 / 4.0 / 8e-6_f64).sqrt();
    let drag = 1.55 * 1.64 * 9.81 / tips;
    // They are written with two digits.
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 0.05, "{a} is not {b}");
    near(vehicle.drag[0], drag);
    near(vehicle.yaw_drag.unwrap().linear, drag * 2.0 * 0.15 * 0.15);
    // From half to twice the rule.
    let rule = 1.5e-5 * (diameter / 0.2).powi(5);
    let one = &vehicle.rotors[0];
    near(one.inertia * one.inertia_spread.low, 0.5 * rule);
    near(one.inertia * one.inertia_spread.high, 2.0 * rule);
    assert!((vehicle.drag_spread.low - 0.5).abs() < 1e-12 && (vehicle.drag_spread.high - 1.5).abs() < 1e-12);
    // Without masses there is nothing to estimate from; the inertia has the rule behind its `?`.
    let bare = read(&file("flat.sdf").replace("<mass>", "<!--").replace("</mass>", "-->")).text.unwrap();
    assert!(
        !bare.contains("drag =") && bare.contains("// estimate, half to twice: [0.25, 0.25, 0.45] m R^2"),
        "{bare}"
    );
}
