//! `simulate` and `campaign`: what they mean, what they leave to defaults, and what waits for the plan.

use super::{QUAD, check, codes, model};
use mavc::language::Group;
use mavc::model::{AfterFault, Attitude, Controller, Detection, FlownVehicle, LostYaw, Model, PlannerKind, Simulation};
use mavc::read::{coarse_step, past_the_end, too_many_steps};

const REST: &str =
    "faults { every 1 rotor lost as M }\nmission hop {\n start at [0, 0, 2] m\n waypoint at [10, 0, 5] m\n}\n";

fn flown(blocks: &str) -> Model {
    model(&format!("{REST}{blocks}"))
}

const WHOLE: &str = "simulate {
    duration = 25 s
    rate = 2 kHz
    control_rate = 400 Hz
    estimator_rate = 80 Hz
    controller = pd
    detection = 50 ms
    after_fault = land
    position_gain = 5 1/s^2
    velocity_gain = 6 1/s
    altitude_gain = 7 1/s^2
    climb_gain = 8 1/s
    attitude_gain = 90 1/s^2
    attitude_rate_gain = 10 1/s
    yaw_gain = 11 1/s^2
    yaw_rate_gain = 12 1/s
    forgetting = 0.9
    gyroscope_noise = 1 deg/s
    gyroscope_range = 1000 deg/s
    position_noise = 2 cm
    drag = 0.3 N*s/m
    wind = [3, 0, -1] m/s
    gusts = 1 m/s
    gust_length = 40 m
    seed = 7
    threshold = 5
    assumed_gyroscope_noise = 0.5 deg/s
    attitude = estimated
    torque_gusts = 0.1 N*m
    spread = drawn
    centre_offset = 4 mm
    lost_beyond = 3 m
    upside_down = 0.25 s
    lost_yaw = 45 deg
    lost_yaw_after = 2 s
    ground = -1 m
    fault M3 at 8 s until 10 s
    fault M1 at 5 s
    fault M2 at 8 s
}
campaign {
    times = 4
    seeds = 5
    planners = rcp
    seed = 6
}
";

#[test]
fn every_field_is_read() {
    for (group, block) in [(Group::Simulate, "simulate"), (Group::Campaign, "campaign")] {
        let body = WHOLE.split(&format!("{block} {{\n")).nth(1).unwrap().split("\n}").next().unwrap();
        let lacks = group.names().find(|name| !format!("\n{body}").contains(&format!("\n    {name} = ")));
        assert_eq!(lacks, None, "a field of `{block}` that this spec does not set");
    }
    let model = flown(WHOLE);
    let s = &model.simulation;
    assert_eq!((s.duration, s.rate, s.control_rate, s.estimator_rate), (Some(25.0), 2000.0, 400.0, 80.0));
    assert_eq!(s.controller, Controller::Pd);
    assert_eq!((s.detection, s.after_fault), (Detection::After(0.05), AfterFault::Land));
    let g = s.gains;
    assert_eq!([g.position, g.velocity, g.altitude, g.climb], [5.0, 6.0, 7.0, 8.0]);
    assert_eq!([g.attitude, g.attitude_rate, g.yaw, g.yaw_rate], [90.0, 10.0, 11.0, 12.0]);
    assert_eq!((s.forgetting, s.gyroscope_noise, s.position_noise), (0.9, 1f64.to_radians(), 0.02));
    assert_eq!(s.threshold, 5.0);
    assert_eq!((s.attitude, s.spread), (Attitude::Estimated, FlownVehicle::Drawn));
    assert_eq!((s.assumed_gyroscope_noise, s.torque_gusts, s.centre_offset), (Some(0.5f64.to_radians()), 0.1, 4e-3));
    assert!((s.gyroscope_range - 1000_f64.to_radians()).abs() < 1e-12);
    assert_eq!((s.drag, s.wind, s.gusts, s.gust_length), ([0.3; 3], [3.0, 0.0, -1.0], 1.0, 40.0));
    assert_eq!((s.seed, s.lost_beyond, s.upside_down, s.ground, s.written), (7, 3.0, 0.25, -1.0, true));
    assert_eq!((s.lost_yaw, s.lost_yaw_after), (LostYaw::Beyond(std::f64::consts::FRAC_PI_4), 2.0));
    // By time; those of one time as written.
    let faults: Vec<_> = s.faults.iter().map(|f| (f.mode, f.at, f.until)).collect();
    assert_eq!(faults, [(0, 5.0, None), (2, 8.0, Some(10.0)), (1, 8.0, None)]);
    let c = &model.campaign;
    assert_eq!((c.times, c.seeds, c.seed, c.written), (4, 5, 6, true));
    assert_eq!(c.planners, [PlannerKind::Rcp]);
    insta::assert_snapshot!(model.to_string());
}

#[test]
fn heading_may_be_left_out_of_what_is_judged() {
    assert_eq!(flown("simulate { lost_yaw = off }").simulation.lost_yaw, LostYaw::Off);
    // A word of the language goes before a `let` of that name, and a `let` may hold the angle.
    assert_eq!(
        flown("let off = 3 deg\nsimulate { lost_yaw = off; gyroscope_noise = off/(1 s) }").simulation.lost_yaw,
        LostYaw::Off
    );
    let held = flown("let most = 0.25 rev\nsimulate { lost_yaw = most }").simulation.lost_yaw;
    let LostYaw::Beyond(held) = held else { panic!("{held:?}") };
    assert!((held - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    for wrong in ["0 deg", "-90 deg", "180 deg", "10 rad", "of", "never"] {
        let found = codes(&format!("{QUAD}{REST}simulate {{ lost_yaw = {wrong} }}"));
        assert_eq!(found, ["mavc::simulate::lost_yaw"], "{wrong}");
    }
    assert!(codes(&format!("{QUAD}{REST}simulate {{ lost_yaw = 2 s }}"))[0].starts_with("mavc::unit::"));
}

#[test]
fn blocks_that_are_not_written_are_neither_printed_nor_listed() {
    let model = flown("");
    let written = Simulation { span: model.plan.span, rate_span: model.plan.span, ..Simulation::default() };
    assert_eq!(model.simulation, written);
    assert_eq!(model.campaign.span, model.plan.span);
    let text = model.to_string();
    assert!(!text.contains("simulate") && !text.contains("campaign") && !text.contains("time_constant"), "{text}");
}

#[test]
fn empty_blocks_take_every_default() {
    let model = flown("simulate { }\ncampaign { }\n");
    let expected = Simulation {
        written: true,
        span: model.simulation.span,
        rate_span: model.simulation.span,
        ..Simulation::default()
    };
    assert_eq!(model.simulation, expected);
    let listed: Vec<String> =
        model.defaults.iter().map(|d| format!("{} = {} ({})", d.field, d.value, d.reason)).collect();
    let of_flights = listed.iter().filter(|d| !d.starts_with("plan.") && !d.starts_with("mission."));
    insta::assert_snapshot!(of_flights.cloned().collect::<Vec<_>>().join("\n"));
}

#[test]
fn the_ground_lies_below_the_lowest_waypoint() {
    let low = "mission hop {\n start at [0, 0, 0] m\n waypoint at [10, 0, -5] m\n}\n";
    assert_eq!(model(low).simulation.ground, -6.0);
    let model = model(&format!("{low}simulate {{ }}\n"));
    assert_eq!(model.simulation.ground, -6.0);
    assert!(model.defaults.iter().any(|d| d.field == "simulate.ground" && d.value == "-6 m"));
}

#[test]
fn modes_that_a_flight_strikes_with_are_used() {
    let with = |blocks: &str| {
        let modes = "faults {\n mode A { rotor 1 lost }\n mode B { rotor 2 lost }\n}\n";
        codes(&format!("{QUAD}{modes}plan {{ against = [A] }}\n{blocks}"))
    };
    assert_eq!(with(""), ["mavc::fault::unused"]);
    assert_eq!(with("simulate { fault A at 5 s }"), ["mavc::fault::unused"]);
    assert!(with("simulate { fault B at 5 s }").is_empty());
    assert!(with("campaign { }").is_empty());
}

#[test]
fn what_depends_on_the_time_of_the_plan_is_reported_once_it_is_known() {
    let model = flown("simulate {\n rate = 10 kHz\n fault M1 at 5 s\n fault M2 at 30 s\n}\n");
    assert!(past_the_end(&model, 31.0).is_empty());
    let late = past_the_end(&model, 30.0);
    assert_eq!((late.len(), late[0].code), (1, "mavc::simulate::past_the_end"));
    assert_eq!(past_the_end(&model, 4.0).len(), 2);
    assert_eq!(too_many_steps(&model, 10_000.0), None);
    assert_eq!(too_many_steps(&model, 10_001.0).unwrap().code, "mavc::simulate::too_many_steps");
    // Recovering at the very end is recovering; later is not.
    let model = flown("simulate {\n fault M1 at 5 s until 20 s\n}\n");
    assert!(past_the_end(&model, 20.0).is_empty());
    let late = past_the_end(&model, 19.0);
    assert_eq!((late.len(), late[0].code), (1, "mavc::simulate::past_the_end"));
    assert!(late[0].message.contains("ends at 20 s"), "{}", late[0].message);
    // A duration of its own has been checked.
    let model = flown("simulate {\n duration = 40 s\n fault M2 at 30 s\n}\n");
    assert!(past_the_end(&model, 20.0).is_empty());
}

#[test]
fn coarse_steps_are_reported_if_a_flight_is_configured() {
    let quick = QUAD.replace("max_speed", "time_constant = 1 ms; max_speed");
    let (model, diagnostics) = check(&format!("{quick}{REST}"));
    assert_eq!(diagnostics, vec![]);
    assert_eq!(coarse_step(&model.unwrap()).unwrap().code, "mavc::simulate::coarse_step");
    for blocks in ["campaign { }", "simulate { }"] {
        assert_eq!(codes(&format!("{quick}{REST}{blocks}")), ["mavc::simulate::coarse_step"]);
    }
    assert!(codes(&format!("{quick}{REST}simulate {{ rate = 2 kHz }}")).is_empty());
}

#[test]
fn rates_divide_to_rounding() {
    for (rate, control) in
        [("1 kHz", "1/(3 ms)"), ("1 kHz", "(1000/3) Hz"), ("10 kHz", "2.5 kHz"), ("500 Hz", "500 Hz")]
    {
        let fields = format!("rate = {rate}; control_rate = {control}; estimator_rate = {control}");
        let found = codes(&format!("{QUAD}simulate {{ {fields} }}"));
        assert!(found.is_empty(), "{fields}: {found:?}");
    }
    let hair = "rate = 1 kHz; control_rate = 333.3334 Hz; estimator_rate = 333.3334 Hz";
    assert_eq!(codes(&format!("{QUAD}simulate {{ {hair} }}")), ["mavc::simulate::rates"]);
}

/// What the help of a rate that divides nothing proposes is accepted.
#[test]
fn helps_for_rates_are_accepted() {
    for (fields, mended) in [
        ("control_rate = 300 Hz", "500 Hz"),
        ("control_rate = 333 Hz", "500 Hz"),
        ("control_rate = 210 Hz", "200 Hz"),
        ("rate = 1001 Hz", "1000 Hz"),
        ("estimator_rate = 130 Hz", "125 Hz"),
    ] {
        let text = format!("{QUAD}simulate {{ {fields} }}");
        let (_, diagnostics) = check(&text);
        let fix = diagnostics[0].fix.as_ref().unwrap();
        assert_eq!(fix.text, mended, "{fields}");
        let (before, after) = (&text[..fix.span.start as usize], &text[fix.span.end as usize..]);
        assert!(codes(&format!("{before}{mended}{after}")).is_empty(), "{fields}");
    }
}

#[test]
fn modes_with_errors_of_their_own_are_not_unknown() {
    let found = codes(&format!("{QUAD}faults {{ mode A {{ rotor 9 lost }} }}\nsimulate {{ fault A at 5 s }}\n"));
    assert_eq!(found, ["mavc::fault::rotor_index"]);
    // Nor is a `let` behind `detection` a wrong word.
    assert!(codes(&format!("{QUAD}let delay = 50 ms\nsimulate {{ detection = delay }}\n")).is_empty());
}
