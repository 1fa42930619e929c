//! Expressions, missions and plans come out with the numbers one would compute by hand.

use super::{QUAD, check, codes, model};
use mavc::model::{AfterFault, LimitKind, MissionTime, PlannerKind, RotorState, Spin};
use std::f64::consts::PI;

/// The x coordinate that `expression` gives, m.
fn metres(expression: &str) -> f64 {
    let text = format!(
        "let v = 2 m/s\nlet a = 4 m\nmission hop {{\n start at [-90, 0, 2] m\n waypoint at [{expression}, v*0 s + a, 5 m]\n}}"
    );
    model(&text).mission.unwrap().waypoints[1].position[0]
}

/// A mission with more legs than the usual 200 samples is no mistake: as many are taken as its legs leave free.
#[test]
fn samples_that_are_not_given_suffice_for_the_legs() {
    let samples = |legs: usize, plan: &str| {
        let waypoints: String = (1..=legs).map(|k| format!("waypoint at [{}, 0, 3] m\n", 3 * k)).collect();
        let vehicle = "vehicle v { layout = \"PPNNPN\"; arm = 0.3 m; mass = 2 kg; inertia = [0.02, 0.02, 0.04] kg*m^2
            rotor { max_thrust = 8 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s } }";
        let text = format!("{vehicle}\nmission m {{ start at [0, 0, 3] m\n{waypoints} }}\nplan {{ {plan} }}\n");
        let compiled = mavc::compile(&text);
        let codes: Vec<&str> = compiled.diagnostics.iter().map(|d| d.code).collect();
        let spec = compiled.spec.unwrap_or_else(|| panic!("{legs} legs: {codes:?}"));
        assert!(!codes.iter().any(|code| code.contains("samples") || code.contains("coarse")), "{legs}: {codes:?}");
        spec.model().plan.samples
    };
    assert_eq!(samples(20, "planner = rip"), 200);
    // Two legs are from or to rest, and need 5.
    assert_eq!(samples(300, "planner = rip"), (308.0_f64 / 0.6).ceil() as usize);
    assert_eq!(samples(300, "planner = rip; samples = 700"), 700);
}

#[test]
fn expressions() {
    let cases = [
        ("-2^2*1 m", -4.0),
        ("2^3^2*1 m", 512.0),
        ("2*a - 1 m", 7.0),
        ("a*sin(30 deg)", 2.0),
        ("a*cos(pi)", -4.0),
        ("sqrt(a*a)", 4.0),
        ("(a^3)^(1/3)", 4.0),
        ("abs(-3 m)", 3.0),
        ("min(3 m, 20 cm, a)", 0.2),
        ("max(3 m, 20 cm)", 3.0),
        ("v * 5 min", 600.0),
        ("g0 * (1 s)^2", 9.81),
        ("(1 + 2) cm", 0.03),
        ("atan2(1 m, 1 m) / (45 deg) * 1 m", 1.0),
        ("tan(45 deg) * 50 % * 1 m", 0.5),
        ("acos(0)/(1 rad) * 2 m", PI),
        ("36 km/h * 1 s", 10.0),
    ];
    for (expression, expected) in cases {
        let found = metres(expression);
        assert!((found - expected).abs() < 1e-12, "{expression} is {found}, not {expected}");
    }
}

#[test]
fn units_spread_over_bare_elements_only() {
    let mission = model("mission hop {\n start at [50 cm, 2, 3] m\n waypoint at [1, 2, 3] m + 2*[0, 0, 1] m\n limits { altitude in 1 .. 30 m; yaw in -30 .. 30 deg }\n}").mission.unwrap();
    assert_eq!(mission.waypoints[0].position, [0.5, 2.0, 3.0]);
    assert_eq!(mission.waypoints[1].position, [1.0, 2.0, 5.0]);
    assert_eq!(
        (mission.limits[0].kind.clone(), mission.limits[0].lower, mission.limits[0].upper),
        (LimitKind::Z, Some(1.0), Some(30.0))
    );
    assert!((mission.limits[1].lower.unwrap() + PI / 6.0).abs() < 1e-15);
}

#[test]
fn gravity_reaches_weights_and_g0() {
    let moon = model(
        "gravity = 1.62 m/s^2\nlet rope = 1 kgf\nmission hop {\n start at [0, 0, 2] m\n waypoint at [rope/(1 N/m), g0*(1 s)^2, 5 m]\n}",
    );
    assert_eq!(moon.gravity, 1.62);
    assert_eq!(moon.mission.unwrap().waypoints[1].position, [1.62, 1.62, 5.0]);
}

#[test]
fn yaw_keeps_the_last_and_turns_the_shorter_way() {
    let mission = model("mission hop {\n start at [0, 0, 2] m yaw 170 deg\n waypoint at [9, 0, 2] m yaw -170 deg\n waypoint at [9, 9, 2] m\n waypoint at [0, 9, 2] m yaw 90 deg\n}").mission.unwrap();
    let degrees: Vec<f64> = mission.waypoints.iter().map(|w| (w.yaw.to_degrees() * 1e9).round() / 1e9).collect();
    assert_eq!(degrees, [170.0, 190.0, 190.0, 90.0]);
}

#[test]
fn legs_share_time_by_distance_and_evenly_on_curves() {
    let shares = |text: &str| -> Vec<f64> { model(text).mission.unwrap().legs.iter().map(|l| l.share).collect() };
    let near = |found: Vec<f64>, due: &[f64]| {
        assert_eq!(found.len(), due.len());
        assert!(found.iter().zip(due).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {due:?}");
    };
    let explicit = "mission m {\n start at [0, 0, 2] m\n waypoint at [3, 0, 2] m\n waypoint at [3, 1, 2] m\n}\n";
    near(shares(explicit), &[0.75, 0.25]);
    near(shares(&format!("{explicit}plan {{ timing = uniform }}")), &[0.5, 0.5]);
    // A curve of 4 m in two unequal legs, then 4 m straight: 2, 2, 4.
    let mixed = "mission m {\n curve s in 0 .. 2, points = 3 { x = 1 m * s^2; y = 0 m; z = 5 m }\n waypoint at [8, 0, 5] m\n}\n";
    near(shares(mixed), &[0.25, 0.25, 0.5]);
    near(shares(&format!("{mixed}plan {{ timing = distance }}")), &[0.125, 0.375, 0.5]);
    // A turn on the spot counts one metre a radian.
    let turn = "mission m {\n start at [0, 0, 2] m\n waypoint at [0, 0, 2] m yaw 1 rad\n waypoint at [3, 0, 2] m\n}\n";
    near(shares(turn), &[0.25, 0.75]);
}

#[test]
fn a_curve_shares_the_point_it_starts_from() {
    let mission = model("mission m {\n start at [0, 0, 5] m\n hold 2 s\n curve s in 0 .. 2, points = 3 { x = 1 m * s; y = 0 m; z = 5 m }\n end moving\n}").mission.unwrap();
    assert_eq!(mission.waypoints.len(), 3);
    assert_eq!(mission.waypoints[0].hold, 2.0);
    assert!(mission.start_at_rest && !mission.end_at_rest);
}

#[test]
fn rings_turn_clockwise_from_the_left() {
    let text = QUAD.replace("arm ", "first = 45 deg\n arm ");
    let (model, _) = check(&text);
    let rotors = model.unwrap().vehicle.rotors;
    let side = 0.211 / 2f64.sqrt();
    let corners = [[side, side], [side, -side], [-side, -side], [-side, side]];
    for (rotor, corner) in rotors.iter().zip(corners) {
        assert!((rotor.position[0] - corner[0]).abs() < 1e-15 && (rotor.position[1] - corner[1]).abs() < 1e-15);
    }
    assert_eq!(rotors[0].spin, Spin::P);
}

#[test]
fn rotors_one_by_one_may_differ() {
    let model = super::check_file("specs/vehicles/coaxial_x8.mav").0.unwrap();
    let rotors = model.vehicle.rotors;
    assert_eq!(rotors.len(), 8);
    assert!((rotors[0].max_thrust() - 22.0).abs() < 1e-9 && (rotors[1].max_thrust() - 18.0).abs() < 1e-9);
    assert!((rotors[1].drag_coefficient / rotors[1].thrust_coefficient - 0.018).abs() < 1e-12);
    assert_eq!(rotors[1].position, [0.3, 0.3, -0.03]);
    assert_eq!(rotors[1].time_constant, Some(0.04));
}

#[test]
fn combinations_are_named_and_numbered() {
    let spec = "faults {\n every 2 rotors lost as D { severity = 9; occurrence = 2; detection = 5 }\n every 1 rotor stuck at 50 % as S\n mode W \"worn\" { rotor 3 reduced to 60 %; rate = 1e-5 1/h }\n}";
    let modes = model(spec).modes;
    let names: Vec<&str> = modes.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["D1_2", "D1_3", "D1_4", "D2_3", "D2_4", "D3_4", "S1", "S2", "S3", "S4", "W"]);
    assert_eq!(modes[4].lost(), [2, 4]);
    assert_eq!(modes[0].rpn(), Some(90));
    assert_eq!(modes[7].rotors[1], RotorState::Stuck(0.5));
    assert_eq!(modes[10].capacities(), [1.0, 1.0, 0.6, 1.0]);
    assert!((modes[10].rate.unwrap() * 3600.0 - 1e-5).abs() < 1e-20);
    assert_eq!(modes[10].title.as_deref(), Some("worn"));
}

#[test]
fn plans_select_their_modes() {
    let faults = "faults {\n every 1 rotor lost as M { severity = 7; occurrence = 4; detection = 3 }\n mode W { rotor 3 reduced to 60 %; severity = 9; occurrence = 9; detection = 9 }\n}\nmission m {\n start at [0, 0, 2] m\n waypoint at [3, 0, 2] m\n}\n";
    let against = |plan: &str| model(&format!("{faults}plan {{ {plan} }}")).plan.against;
    assert_eq!(against(""), [0, 1, 2, 3, 4]);
    assert_eq!(against("against = all"), [0, 1, 2, 3, 4]);
    assert_eq!(against("against = [W, M2]"), [4, 1]);
    assert_eq!(against("against = where rpn > 84"), [4]);
    assert_eq!(against("against = where severity <= 7"), [0, 1, 2, 3]);
    let plan = model(&format!("{faults}plan {{ planner = rcp; time = 20 s; reserve = 0.25; against = all }}")).plan;
    assert_eq!((plan.planner, plan.time, plan.reserve), (PlannerKind::Rcp, MissionTime::Fixed(20.0), 0.25));
}

#[test]
fn a_mode_says_what_follows_it_or_the_plan_does() {
    let spec = "faults {\n every 1 rotor lost as M { after_fault = hold }\n mode W { rotor 3 reduced to 60 % }\n}\nmission m {\n start at [0, 0, 2] m\n waypoint at [3, 0, 2] m\n}\n";
    let continued = model(spec);
    assert_eq!((continued.after_fault(0), continued.after_fault(4)), (AfterFault::Hold, AfterFault::Continue));
    let held = model(&format!("{spec}plan {{ after_fault = hold }}"));
    assert_eq!(held.after_fault(4), AfterFault::Hold);
    let other = model(&format!("{}plan {{ after_fault = hold }}", spec.replace("= hold", "= continue")));
    assert_eq!((other.after_fault(0), other.after_fault(4)), (AfterFault::Continue, AfterFault::Hold));
    // What a flight does is another field.
    assert_eq!(held.simulation.after_fault, AfterFault::Continue);
    let text = held.to_string();
    assert!(text.contains("after_fault hold\n") && text.contains("  after_fault hold"), "{text}");
}

#[test]
fn defaults_are_listed() {
    let found = model("mission m {\n start at [0, 0, 2] m\n waypoint at [3, 0, 2] m\n}\nplan { reserve = 0 % }");
    let fields: Vec<&str> = found.defaults.iter().map(|d| d.field.as_str()).collect();
    assert_eq!(
        fields,
        [
            "gravity",
            "vehicle.allocation",
            "mission.m.yaw",
            "plan.within",
            "plan.yaw_within",
            "plan.weight",
            "plan.timing",
            "plan.planner",
            "plan.model",
            "plan.rotors",
            "plan.effort",
            "plan.against",
            "plan.time",
            "plan.samples",
            "plan.rounds",
            "plan.after_fault",
            "plan.without_yaw",
            "plan.snap",
            "plan.acceleration"
        ]
    );
    assert_eq!(found.mission.unwrap().waypoints[0].yaw_within, PI / 90.0);
}

#[test]
fn one_mistake_gives_one_error() {
    // An unknown `let` leaves no missing field behind, nor does a misspelled or broken one.
    assert_eq!(codes(&QUAD.replace("1.32 kg", "dry")), ["mavc::name::unknown"]);
    assert_eq!(codes(&QUAD.replace("mass ", "mas ")), ["mavc::name::unknown_field"]);
    assert_eq!(codes(&QUAD.replace("1.32 kg", "1.32 kg kg")), ["mavc::syntax::unit_blank"]);
    let told = codes(&format!("let a = = 3 m\nlet b = 2*a\n{QUAD}"));
    assert_eq!(told, ["mavc::syntax::unexpected", "mavc::name::unused"]);
    assert_eq!(codes(&format!("use \"gone.mav\"\nlet b = 2*a\n{QUAD}")), ["mavc::file::missing"]);
    let chain = format!("let a = 1 m + 1 s\nlet b = a\nlet c = b + a\n{QUAD}");
    assert_eq!(codes(&chain), ["mavc::unit::mismatch"]);
}

#[test]
fn all_mistakes_come_in_one_run() {
    let text = "let a = 1 m / 0\nlet b = 2 Nm\nvehicle quad {\n layout = \"PNP\"\n mass = 3\n reach = 4 m\n inertia = [1, 1, 9] kg*m^2\n}\nfaults { mode A { rotor 40 lost; severity = 12 } }\nmission m { start at [0, 0] m\n hold 0 s }\nplan { planner = best; samples = 0; within = -1 m; against = [B] }\n";
    let mut found = codes(text);
    found.sort_unstable();
    assert_eq!(
        found,
        [
            "mavc::fault::fmea",
            "mavc::fault::rotor_index",
            "mavc::mission::duration",
            "mavc::mission::tolerance",
            "mavc::name::missing_field",
            "mavc::name::missing_field",
            "mavc::name::unknown",
            "mavc::name::unknown_field",
            "mavc::plan::choice",
            "mavc::plan::samples",
            "mavc::unit::kind",
            "mavc::unit::missing",
            "mavc::unit::not_finite",
            "mavc::unit::unknown",
            "mavc::vehicle::inertia",
            "mavc::vehicle::rotor_count",
        ]
    );
}

/// Numbers that vanish when they are multiplied with themselves are none that mavc computes with.
#[test]
fn vanishing_numbers_are_refused() {
    let hop = |limits: &str| {
        format!("{QUAD}mission m {{\n start at [0, 0, 2] m\n waypoint at [5, 0, 3] m\n limits {{ {limits} }}\n}}\n")
    };
    for limit in [
        "speed <= 5e-324 m/s",
        "speed_horizontal <= 1e-10 m/s",
        "climb <= 5e-324 m/s",
        "descent <= 1e-10 m/s",
        "acceleration <= 5e-324 m/s^2",
        "acceleration_horizontal <= 1e-12 m/s^2",
        "jerk <= 5e-324 m/s^3",
        "yaw_rate <= 1e-300 deg/s",
        "yaw_acceleration <= 1e-300 deg/s^2",
        "tilt <= 1e-300 deg",
        "x <= 5e-324 m",
    ] {
        assert_eq!(codes(&hop(limit)), ["mavc::unit::magnitude"], "{limit}");
    }
    assert!(codes(&hop("speed <= 1 m/s; climb <= 0 m/s; x >= 0 m")).is_empty());
}
