//! `parts` of a vehicle: mass, centre of gravity and inertia against sums by hand, and beside measured values.

use super::{check, codes};
use mavc::model::Vehicle;

const ROTOR: &str = "rotor { max_thrust = 14 N; torque_per_thrust = 16 mm; max_speed = 900 rad/s }";
const RING: &str = "layout = \"PNPN\"; arm = 25 cm; first = 45 deg";
const PARTS: &str = "parts {
    motor_mass = 95 g
    arm_mass   = 60 g
    part battery { mass = 1.1 kg; at = [0, 0, -4] cm; size = [15, 7, 5] cm }
    part camera { mass = 410 g; at = [9, 0, -6] cm }
}";

fn text(fields: &str) -> String {
    format!("vehicle v {{\n{ROTOR}\n{fields}\n}}\n")
}

fn vehicle(fields: &str) -> Vehicle {
    let (model, diagnostics) = check(&text(fields));
    assert_eq!(diagnostics, vec![], "{fields}");
    model.unwrap().vehicle
}

fn found(fields: &str) -> Vec<&'static str> {
    codes(&text(fields))
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-12, "{a} is not {b}");
}

/// The sums about the frame's origin, and from there to the centre of gravity: the other way round than in the code.
#[test]
fn a_quadcopter_with_a_camera_in_front() {
    let vehicle = vehicle(&format!("{RING}\n{PARTS}"));
    let mass = 4.0 * 0.095 + 4.0 * 0.06 + 1.1 + 0.41;
    near(vehicle.mass, mass);
    let [x, y, z] = vehicle.centre_of_gravity.unwrap();
    near(x, 0.41 * 0.09 / mass);
    near(y, 0.0);
    near(z, -(1.1 * 0.04 + 0.41 * 0.06) / mass);
    // Four motors on a ring of R have m R^2 about z and half of it about x and y; four rods a third of that.
    let ring = (4.0 * 0.095 + 4.0 * 0.06 / 3.0) * 0.25 * 0.25;
    let (length, width, height) = (0.15_f64.powi(2), 0.07_f64.powi(2), 0.05_f64.powi(2));
    let about_x = ring / 2.0 + 1.1 / 12.0 * (width + height) + 1.1 * 0.0016 + 0.41 * 0.0036;
    let about_y = ring / 2.0 + 1.1 / 12.0 * (length + height) + 1.1 * 0.0016 + 0.41 * (0.0081 + 0.0036);
    let about_z = ring + 1.1 / 12.0 * (length + width) + 0.41 * 0.0081;
    near(vehicle.inertia[0], about_x - mass * z * z);
    near(vehicle.inertia[1], about_y - mass * (x * x + z * z));
    near(vehicle.inertia[2], about_z - mass * x * x);
    let side = 0.25 / 2.0_f64.sqrt();
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]];
    for (rotor, [along, across]) in vehicle.rotors.iter().zip(signs) {
        near(rotor.position[0], along * side - x);
        near(rotor.position[1], across * side);
        near(rotor.position[2], -z);
    }
}

#[test]
fn rotors_are_placed_from_the_origin_of_the_frame_only_if_there_is_one() {
    let measured = "mass = 2 kg; inertia = [0.02, 0.02, 0.035] kg*m^2";
    let plain = vehicle(&format!("{RING}; {measured}"));
    assert_eq!(plain.centre_of_gravity, None);
    let moved = vehicle(&format!("{RING}; {measured}; centre_of_gravity = [2, -1, 3] cm"));
    for (a, b) in plain.rotors.iter().zip(&moved.rotors) {
        for (axis, shift) in [0.02, -0.01, 0.03].into_iter().enumerate() {
            near(b.position[axis], a.position[axis] - shift);
        }
    }
    let one_by_one = "rotors { rotor at [0.2, 0.1, 0] m  spin P; rotor at [0.2, -0.1, 0] m  spin N; \
        rotor at [-0.2, -0.1, 0] m  spin P; rotor at [-0.2, 0.1, 0] m  spin N }";
    let placed = vehicle(&format!("{one_by_one}; {measured}; centre_of_gravity = [1, 0, 0] cm"));
    near(placed.rotors[0].position[0], 0.19);
}

/// Parts of which each value of the whole is known: 2.13 kg, and the inertia of the first test.
#[test]
fn measured_values_replace_those_of_the_parts() {
    let from_parts = vehicle(&format!("{RING}\n{PARTS}"));
    let [x, y, z] = from_parts.inertia.map(|moment| 1.2 * moment);
    let measured = format!("mass = 2.2 kg +- 1 %; inertia = [{x}, {y}, {z}] kg*m^2; centre_of_gravity = [1, 0, 0] cm");
    let both = vehicle(&format!("{RING}; {measured}\n{PARTS}"));
    assert_eq!((both.mass, both.inertia), (2.2, [x, y, z]));
    assert!(both.is_uncertain());
    assert_eq!(both.centre_of_gravity, Some([0.01, 0.0, 0.0]));
}

/// The bounds of `mavc::sense::parts` from both sides.
#[test]
fn parts_that_contradict_a_measurement_are_warned_of() {
    let beside = |measured: &str| found(&format!("{RING}; {measured}\n{PARTS}"));
    let from_parts = vehicle(&format!("{RING}\n{PARTS}"));
    let mass = from_parts.mass;
    for (share, expected) in [(0.92, true), (0.90, false), (1.1, true), (1.13, false)] {
        // `share` is that of the measurement; the parts are 1 over it of it.
        let found = beside(&format!("mass = {} kg", share * mass));
        assert_eq!(found.is_empty(), expected, "{share}: {found:?}");
    }
    // An interval that reaches up to a tenth of the parts.
    assert_eq!(beside(&format!("mass = {} kg +- 5 %", 0.88 * mass)), Vec::<&str>::new());
    assert_eq!(beside(&format!("mass = {} kg +- 5 %", 0.80 * mass)), ["mavc::sense::parts"]);
    for (share, expected) in [(1.45, true), (1.55, false), (0.7, true), (0.65, false)] {
        let [x, y, z] = from_parts.inertia.map(|moment| share * moment);
        let found = beside(&format!("inertia = [{x}, {y}, {z}] kg*m^2"));
        assert_eq!(found.is_empty(), expected, "{share}: {found:?}");
    }
    let [x, _, z] = from_parts.centre_of_gravity.unwrap();
    // 5 % of 25 cm are 12.5 mm; the height does not matter.
    for (shift, expected) in [(0.012, true), (0.013, false), (-0.012, true), (-0.013, false)] {
        let found = beside(&format!("centre_of_gravity = [{}, 0, {}] m", x + shift, z + 0.3));
        assert_eq!(found.is_empty(), expected, "{shift}: {found:?}");
    }
}

#[test]
fn products_of_inertia_are_warned_of() {
    // Two weights across a diagonal: Ixz of m x z each, against the moments of the whole.
    let with = |height: f64| {
        let weights = format!(
            "parts {{ motor_mass = 95 g; part a {{ mass = 500 g; at = [20, 0, {height}] cm }}
             part b {{ mass = 500 g; at = [-20, 0, -{height}] cm }} }}"
        );
        found(&format!("{RING}\n{weights}"))
    };
    let coupling = |z: f64| {
        let product: f64 = 2.0 * 0.5 * 0.2 * z;
        let ring = 4.0 * 0.095 * 0.0625;
        let (about_x, about_z) = (ring / 2.0 + z * z, ring + 0.04);
        product / (about_x * about_z).sqrt()
    };
    assert!(coupling(0.013) < 0.1 && coupling(0.0145) > 0.1);
    assert_eq!(with(1.3), Vec::<&str>::new());
    assert_eq!(with(1.45), ["mavc::sense::products"]);
}

#[test]
fn a_vehicle_needs_its_mass_measured_or_from_parts() {
    assert_eq!(found(RING), ["mavc::name::missing_field", "mavc::name::missing_field"]);
    // Faulty parts are not reported as a missing mass too.
    assert_eq!(found(&format!("{RING}\nparts {{ part a {{ at = [0, 0, 0] m }} }}")), ["mavc::name::missing_field"]);
    assert_eq!(
        found(&format!("{RING}\nparts {{ part a {{ mass = 1 kg; at = [0, 0, 1] cm }} }}")),
        ["mavc::vehicle::parts"]
    );
}

#[test]
fn overrides_reach_the_masses_that_rotors_share() {
    let compiled = |set: &str, fields: &str| {
        mavc::Compiler::new().set(set).text("v.mav", text(&format!("{RING}\n{fields}")).as_bytes())
    };
    let heavier = compiled("vehicle.parts.motor_mass = 120 g", PARTS).spec.unwrap();
    near(heavier.model().vehicle.mass, 2.13 + 4.0 * 0.025);
    let added = compiled("vehicle.parts.arm_mass = 60 g", "mass = 2 kg; inertia = [0.02, 0.02, 0.035] kg*m^2");
    assert!(added.diagnostics.iter().any(|d| d.code == "mavc::sense::parts"), "{}", added.render());
}
