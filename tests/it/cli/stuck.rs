//! What is reported of rotors that are stuck, and of faults that nobody notices.

use super::*;

/// A quadcopter of `mass` kg against rotors stuck at a share of full thrust, 36 N in all.
fn quad(mass: f64, mode: &str) -> String {
    format!(
        "vehicle q {{ layout = \"PNPN\"; first = 45 deg; arm = 25 cm; mass = {mass} kg
            inertia = [0.014, 0.014, 0.026] kg*m^2
            rotor {{ max_thrust = 9 N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }} }}
        faults {{ mode jam {{ {mode} }} }}
        mission m {{ start at [0, 0, 2] m\n waypoint at [1, 0, 2] m }}
        plan {{ planner = rcp; against = jam; reserve = 0 %; time = 6 s; samples = 30 }}
        simulate {{ fault jam at 1 s; detection = never; wind = [3, 4, 0] m/s; gusts = 0.3 m/s }}\n"
    )
}

fn run(command: &str, spec: &str) -> (i32, String) {
    let dir = folder();
    let path = dir.path().join("quad.mav");
    std::fs::write(&path, spec).unwrap();
    let ran = mavc(&[command, "-v", text(&path)]);
    (code(&ran), out(&ran) + &err(&ran))
}

/// All rotors of a ring with one stuck at 45 % of 9 N must give as much: the weight of 4 * 4.05 N / g = 1.65138 kg.
#[test]
fn a_stuck_rotor_lifts_one_mass_and_no_heavier_or_lighter_one() {
    for mass in [1.6, 1.652, 1.7] {
        let (code, shown) = run("check", &quad(mass, "rotor 2 stuck at 45 %"));
        assert!(shown.contains("possible only at 1.65138 kg"), "{shown}");
        assert!(!shown.contains("min_speed") && code != 0, "{shown}");
    }
    let (_, shown) = run("check", &quad(1.65138, "rotor 2 stuck at 45.00017 %"));
    assert!(!shown.contains("cannot_hover"), "{shown}");
}

/// With most rotors stuck the vehicle cannot be steered, even if they happen to carry its weight.
#[test]
fn what_cannot_be_steered_is_warned_of() {
    for (mode, dimensions) in [("rotors [1, 3]", 2), ("rotors [1, 2, 3]", 1), ("rotors [1, 2, 3, 4]", 0)] {
        let spec = quad(1.6, &format!("{mode} stuck at (1.6 * 9.81 / 36)"));
        let (code, shown) = run("check", &spec);
        assert!(shown.contains("the vehicle cannot be steered"), "{shown}");
        assert!(
            code == 0 && shown.contains(&format!("the admissible set has {dimensions} of 4 dimensions")),
            "{shown}"
        );
    }
}

#[test]
fn what_is_not_detected_is_not_isolated_and_wind_is_named() {
    let (_, shown) = run("simulate", &quad(1.6, "rotor 2 reduced to 85 %"));
    let fault = shown.lines().find(|line| line.trim_start().starts_with("jam")).unwrap();
    assert!(fault.split_whitespace().eq(["jam", "1", "s", "never", "never"]), "{shown}");
    assert!(flat(&shown).contains("wind of 5 m/s with gusts of 0.3 m/s"), "{shown}");
}

/// What a shell opened for reading is not written to.
#[cfg(unix)]
#[test]
fn standard_input_by_its_device_is_laid_out_on_standard_output() {
    let dir = folder();
    let path = dir.path().join("quad.mav");
    let spec = quad(1.6, "rotor 2 lost");
    std::fs::write(&path, &spec).unwrap();
    let input = std::fs::File::open(&path).unwrap();
    let ran = Command::new(env!("CARGO_BIN_EXE_mavc")).args(["fmt", "/dev/stdin"]).stdin(input).output().unwrap();
    assert!(out(&ran).contains("layout"), "{}", err(&ran));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), spec);
}
