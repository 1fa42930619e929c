//! What commands claim of modes that plans do not provide for, of limits and causes, and of speeds.

use crate::cli::{flat, mavc_with};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::airspeed::{Airspeed, PLAUSIBLE};

const PLAIN_QUAD: &str = include_str!("../specs/flown/plain_quad.mav");
const TILTED_SPIN: &str = include_str!("../specs/flown/tilted_spin.mav");

fn run(args: &[&str], text: &str) -> (Option<i32>, String) {
    let ran = mavc_with(args, text);
    (ran.status.code(), String::from_utf8_lossy(&ran.stdout).into_owned() + &String::from_utf8_lossy(&ran.stderr))
}

/// No row provides for the loss of one of four rotors, so no sentence says that the plan stays inside its set.
#[test]
fn modes_without_rows_are_not_planned() {
    let drag = PLAIN_QUAD.replace("3e-3 N*m*s/rad +- 50 %", "6e-3 N*m*s/rad +- 20 %");
    let (code, told) = run(&["plan", "-v", "-", "-q"], &drag);
    let told = flat(&told);
    assert_eq!(code, Some(0), "{told}");
    for expected in [
        "RSP: found, 45 s, the spec's time; not planned for M1",
        "Not planned for M1: no torque is left in some direction",
        "m with the fault known after 100 ms (simulated); not proved.",
        "RSP guards nothing beyond RIP: no mode planned against has rows",
        "M1 - - no rows - - - not planned",
    ] {
        assert!(told.contains(expected), "{expected}: {told}");
    }
    assert!(!told.contains("stays inside the sets of all modes planned against") && !told.contains("caught"), "{told}");
    // At the lower end of the written drag the spin settles beyond the gyroscope, and no height is known to be enough.
    let (_, told) = run(&["plan", "-v", "-", "-q"], PLAIN_QUAD);
    assert!(flat(&told).contains("do not recover from any height; not proved."), "{told}");
    // With a mode that has rows the sentence is about that one.
    let (_, told) = run(&["plan", "-v", "-", "-q"], &PLAIN_QUAD.replace("against = [M1]", "against = [M1, W2]"));
    let told = flat(&told);
    assert!(!told.contains("all modes planned against"), "{told}");
    let (_, told) = run(&["plan", "-v", "-", "-q"], &PLAIN_QUAD.replace("against = [M1]", "against = [W2]"));
    assert!(!told.contains("ot planned for"), "{told}");
}

/// A row of a comparison names the sets that its plan leaves.
#[test]
fn comparisons_name_the_sets_that_a_plan_leaves() {
    let text = include_str!("../specs/flown/wall.mav")
        .replace("time = 5 s", "time = minimum")
        .replace("samples = 80", "samples = 40");
    let (code, told) = run(&["compare", "-v", "-", "-q"], &text);
    assert_eq!(code, Some(0), "{told}");
    let heading = told.lines().find(|line| line.contains("rows/node")).unwrap();
    assert!(heading.ends_with("leaves the sets of"), "{heading}");
    let row = |name: &str| told.lines().find(|line| line.trim_start().starts_with(name)).unwrap();
    assert!(row("RCP w ").ends_with(" -"), "{told}");
    let seconds = told.lines().filter(|line| line.trim_start().starts_with("RIP")).nth(2).unwrap();
    assert_eq!(row("RIP").ends_with(" w"), !seconds.ends_with(" 0"), "{told}");
}

/// The limit that `check` names is the one at which verdicts change: 2.2 kg, by the thrust of two opposite rotors,
/// 2 x 1.1 kgf.
#[test]
fn check_names_the_mass_at_which_the_vehicle_still_spins() {
    let (code, told) = run(&["check", "-"], &PLAIN_QUAD.replace("mass = 1.6 kg", "mass = 2.3 kg"));
    let told = flat(&told);
    assert_eq!(code, Some(3), "{told}");
    assert!(told.contains("with control of yaw at no mass; with yaw given up at 2.2 kg or less"), "{told}");
    let (_, told) = run(&["check", "-"], &PLAIN_QUAD.replace("mass = 1.6 kg", "mass = 2.19 kg"));
    assert!(!told.contains("cannot hover"), "{told}");
}

/// A drag that the wind turns into more than the thrust: in still air the vehicle hovers, and the message says so.
#[test]
fn check_names_the_drag_that_keeps_a_vehicle_from_hovering() {
    let against = TILTED_SPIN.replace("against = []", "against = [L5]");
    let (code, told) = run(&["check", "-"], &against.replace("drag = 0.6 N*s/m", "drag = 40 N*s/m"));
    let told = flat(&told);
    assert_eq!(code, Some(3), "{told}");
    let force = (3.0_f64.powi(2) + 1.0).sqrt() * 40.0;
    assert!((force - 126.5).abs() < 0.1);
    assert!(told.contains("a `drag` of 40 N*s/m turns the mission's wind of 3.16 m/s into 126 N"), "{told}");
    assert!(!told.contains("not possible at any mass"), "{told}");
}

/// The wind is not blamed for a yaw that is not held in still air either.
#[test]
fn check_blames_the_wind_only_for_what_still_air_would_change() {
    let survey = std::fs::read_to_string("examples/survey_hexa.mav").unwrap();
    let in_wind = survey.replacen("mass ", "drag = 0.5 N*s/m\n    mass ", 1).replacen(
        "limits {",
        "air { wind = [4, 0, 0] m/s }\n    limits {",
        1,
    );
    assert_eq!(
        in_wind.len(),
        survey.len() + "drag = 0.5 N*s/m\n    ".len() + "air { wind = [4, 0, 0] m/s }\n    ".len()
    );
    for text in [&survey, &in_wind] {
        let (code, told) = run(&["check", "-", "--set", "plan.against=[M5]"], text);
        assert_eq!(code, Some(3), "{told}");
        assert!(told.contains("cannot hold its yaw") && !told.contains("still air"), "{told}");
    }
}

/// A mode without control of yaw has a steady airspeed with yaw given up, by the thrust without roll and pitch torques;
/// and none is printed beyond what the drag can mean.
#[test]
fn airspeeds_of_modes_without_yaw() {
    let spec = mavc::compile(TILTED_SPIN).into_result().unwrap();
    let model = spec.model();
    let analysis = &mavc::analyze(&spec)[1];
    let level = analysis.without_yaw.as_ref().unwrap().level_thrust_n;
    let found = Airspeed::of(model, &AdmissibleSet::of_mode(model, 0)).unwrap();
    let weight = model.vehicle.mass * model.gravity;
    let most = weight + (1.0 - model.plan.reserve) * (level - weight);
    let expected = (most * most - weight * weight).sqrt() / 0.6;
    assert!(
        found.without_yaw && (found.largest_m_per_s.unwrap() / expected - 1.0).abs() < 1e-6,
        "{found:?} {expected}"
    );
    let (_, told) = run(&["analyze", "-v", "-"], TILTED_SPIN);
    let row = |name: &str| told.lines().find(|line| line.starts_with(name)).unwrap().to_string();
    assert!(row("healthy").ends_with(&format!("over {PLAUSIBLE} m/s")), "{told}");
    assert!(row("L5").ends_with("(no yaw)"), "{told}");
}
