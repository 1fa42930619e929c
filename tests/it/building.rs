//! Specs that are built from values, and what is said of values that are wrong.

use mavc::builder::Builder;
use mavc::model::RotorState;
use mavc::{PlanOutcome, Spec};

/// An octocopter that may lose a rotor and flies 10 m.
fn octocopter() -> Builder {
    Builder::new()
        .vehicle("layout", "PPNNPPNN")
        .vehicle("arm", 0.211)
        .vehicle("mass", 1.8)
        .vehicle("inertia", [0.0429, 0.0429, 0.0748])
        .rotor("max_thrust", 6.53)
        .rotor("torque_per_thrust", 0.016)
        .rotor("max_speed", 874.0)
        .lost("M1", &[1])
        .waypoint([0.0, 0.0, 2.0])
        .waypoint([10.0, 0.0, 5.0])
        .at_most("speed", 6.0)
        .plan("samples", 60)
}

/// The codes and fields of what is wrong.
fn problems(builder: Builder) -> Vec<(String, &'static str)> {
    builder.build().unwrap_err().problems.into_iter().map(|problem| (problem.field, problem.code)).collect()
}

#[test]
fn a_built_spec_is_the_written_one() {
    let written = "
        vehicle craft {
            layout = \"PPNNPPNN\"; arm = 21.1 cm; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
            rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
        }
        faults { mode M1 { rotor 1 lost } }
        mission flight {
            start at [0, 0, 2] m
            waypoint at [10, 0, 5] m
            limits { speed <= 6 m/s }
        }
        plan { samples = 60 }";
    let written = mavc::compile(written).into_result().unwrap();
    let built = octocopter().build().unwrap();
    assert_eq!(built.model().to_string(), written.model().to_string());
    let again = mavc::compile(&octocopter().text()).into_result().unwrap();
    assert_eq!(again.sha256(), built.sha256());
    assert_eq!(mavc::format(&octocopter().text()).unwrap(), octocopter().text(), "the text is laid out");
}

#[test]
fn built_specs_plan_and_their_certificates_are_of_their_text() {
    let builder = octocopter().plan("planner", "rcp").plan("time", 6.0).plan("model", "hover");
    let text = builder.text();
    let spec: Spec = builder.build().unwrap();
    let planning = mavc::plan(&spec).unwrap();
    let PlanOutcome::Planned(plan) = planning.outcome() else { panic!("{:?}", planning.verdict()) };
    assert_eq!(plan.time, 6.0);
    let certificate = serde_json::to_vec(&mavc::certify(&spec, &planning).unwrap()).unwrap();
    let saved = mavc::compile(&text).into_result().unwrap();
    assert!(mavc::verify(&certificate, &saved).unwrap().undecided.is_empty());
}

#[test]
fn every_kind_of_value_and_statement_is_written() {
    let spec = Builder::new()
        .top("gravity", 1.62)
        .vehicle("mass", 0.8)
        .vehicle("inertia", [0.01, 0.01, 0.02])
        .vehicle("allocation", "bounded")
        .vehicle("drag", [0.1, 0.1, 0.05])
        .rotor("thrust_coefficient", 9e-6)
        .rotor("drag_coefficient", 1.5e-7)
        .rotor("max_speed", 800.0)
        .placed_rotor([0.2, 0.2, 0.0], "P", &[("time_constant", 0.03)])
        .placed_rotor([-0.2, 0.2, 0.0], "N", &[])
        .placed_rotor([-0.2, -0.2, 0.0], "P", &[])
        .placed_rotor([0.2, -0.2, 0.0], "N", &[])
        .reduced("worn", &[1, 2], 0.7)
        .stuck("jam", &[3], 0.4)
        .mode("worn", "severity", 4)
        .mode("worn", "rate", 1e-9)
        .waypoint([0.0, 0.0, 2.0])
        .waypoint_with([4.0, 0.0, 3.0], &[("yaw", 0.5), ("within", 0.02), ("time", 8.5)])
        .hold(1.5)
        .waypoint([4.0, 4.0, 3.0])
        .end_moving()
        .between("altitude", 1.0, 9.0)
        .at_least("x", -1.0)
        .plan("against", ["worn"])
        .plan("reserve", 0.05)
        .plan("time", "minimum")
        .simulate("wind", [1.0, 0.0, 0.0])
        .simulate("drag", 0.2)
        .simulate("detection", 0.05)
        .strike("worn", 3.0)
        .campaign("planners", ["rip", "rsp"])
        .campaign("times", 3)
        .build()
        .unwrap();
    let model = spec.model();
    let mission = spec.mission().unwrap();
    assert_eq!((model.gravity, model.vehicle.rotors[0].time_constant), (1.62, Some(0.03)));
    assert_eq!(
        (model.modes[0].rotors[1], model.modes[1].rotors[2]),
        (RotorState::Reduced(0.7), RotorState::Stuck(0.4))
    );
    assert_eq!((model.modes[0].severity, model.modes[0].rate), (Some(4), Some(1e-9)));
    let second = &mission.waypoints[1];
    assert_eq!((second.yaw, second.within, second.time, second.hold), (0.5, 0.02, Some(8.5), 1.5));
    assert_eq!((mission.end_at_rest, mission.limits.len(), model.plan.reserve), (false, 2, 0.05));
    assert_eq!((model.plan.against.as_slice(), model.simulation.wind), (&[0][..], [1.0, 0.0, 0.0]));
    assert_eq!((model.simulation.faults[0].at, model.campaign.times), (3.0, 3));
    assert_eq!((model.vehicle.drag, model.simulation.drag), ([0.1, 0.1, 0.05], [0.2; 3]));
}

#[test]
fn an_unknown_mode_is_an_error_of_its_own() {
    assert_eq!(problems(octocopter().plan("against", ["M9"])), [("plan.against".into(), "mavc::name::unknown")]);
    assert_eq!(problems(octocopter().strike("M9", 1.0)), [("simulate.fault.M9".into(), "mavc::name::unknown")]);
    assert_eq!(problems(octocopter().mode("M9", "rate", 1.0)), [("modes.M9".into(), "mavc::name::unknown")]);
}

#[test]
fn numbers_that_are_not_finite_are_errors_of_their_own() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let builders = [
            (octocopter().vehicle("allocation", "bounded").top("gravity", wrong), "gravity"),
            (octocopter().waypoint([wrong, 0.0, 1.0]), "mission.waypoints[3].at"),
            (octocopter().waypoint_with([1.0; 3], &[("within", wrong)]), "mission.waypoints[3].within"),
            (octocopter().hold(wrong), "mission.hold[2]"),
            (octocopter().at_most("tilt", wrong), "mission.limits.tilt"),
            (octocopter().plan("time", wrong), "plan.time"),
            (octocopter().plan("reserve", wrong), "plan.reserve"),
            (octocopter().reduced("R", &[1], wrong), "modes.R"),
            (octocopter().strike("M1", wrong), "simulate.fault.M1"),
            (octocopter().simulate("wind", [0.0, wrong, 0.0]), "simulate.wind"),
        ];
        for (builder, field) in builders {
            assert_eq!(problems(builder), [(field.into(), "mavc::unit::not_finite")], "{wrong}");
        }
    }
}

#[test]
fn no_samples_no_waypoints_and_no_inertia_are_errors_of_their_own() {
    let without_samples = Builder::plan(octocopter().plan("rounds", 1), "timing", "uniform");
    assert!(without_samples.build().is_ok());
    let vehicle = || {
        Builder::new()
            .vehicle("layout", "PNPN")
            .vehicle("arm", 0.2)
            .vehicle("mass", 1.0)
            .rotor("max_thrust", 5.0)
            .rotor("torque_per_thrust", 0.016)
            .rotor("max_speed", 900.0)
    };
    let able = || vehicle().vehicle("inertia", [0.01, 0.01, 0.02]);
    let flying = || able().waypoint([0.0, 0.0, 2.0]).waypoint([1.0, 0.0, 2.0]);
    assert_eq!(problems(flying().plan("samples", 0)), [("plan.samples".into(), "mavc::plan::samples")]);
    assert_eq!(problems(able().plan("samples", 9)), [("mission".into(), "mavc::mission::too_few_waypoints")]);
    let one = able().waypoint([0.0, 0.0, 2.0]);
    assert_eq!(problems(one), [("mission".into(), "mavc::mission::too_few_waypoints")]);
    let singular = vehicle().vehicle("inertia", [0.01, 0.0, 0.02]);
    assert_eq!(problems(singular), [("vehicle.inertia".into(), "mavc::vehicle::not_positive")]);
    let weightless = able().vehicle("mass", 0.0);
    assert_eq!(problems(weightless), [("vehicle.mass".into(), "mavc::name::duplicate")]);
}

#[test]
fn fields_and_values_that_do_not_fit_are_all_reported_at_once() {
    let wrong = octocopter()
        .vehicle("weight", 1.0)
        .rotor("max_thrust", "strong")
        .plan("planer", "rip")
        .plan("samples", [1.0; 3])
        .lost("M 2", &[2])
        .vehicle("layout", "PN\"PN");
    let error = wrong.build().unwrap_err();
    let found: Vec<(&str, &str)> = error.problems.iter().map(|p| (p.field.as_str(), p.code)).collect();
    assert_eq!(
        found,
        [
            ("vehicle.weight", "mavc::name::unknown_field"),
            ("vehicle.rotor.max_thrust", "mavc::unit::kind"),
            ("plan.planer", "mavc::name::unknown_field"),
            ("plan.samples", "mavc::unit::kind"),
            ("modes.M 2", "mavc::name::reserved"),
            ("vehicle.layout", "mavc::unit::kind"),
        ]
    );
    let text = error.to_string();
    assert!(text.contains("plan.planer: there is no field `planer` here; did you mean `planner`?"), "{text}");
    assert!(text.contains("vehicle.rotor.max_thrust: `max_thrust` takes a number, not \"strong\""), "{text}");
}

#[test]
fn mistakes_of_calls_do_not_hide_those_of_the_text() {
    let wrong = octocopter()
        .vehicle("allocation", 3)
        .waypoint([f64::NAN, 0.0, 5.0])
        .lost("M2", &[9])
        .lost("M 3", &[2])
        .plan("reserve", 2.0)
        .plan("against", ["M9"]);
    let error = wrong.build().unwrap_err();
    let mut found: Vec<&str> = error.problems.iter().map(|p| p.field.as_str()).collect();
    found.sort();
    let fields =
        ["mission.waypoints[3].at", "modes.M 3", "modes.M2", "plan.against", "plan.reserve", "vehicle.allocation"];
    assert_eq!(found, fields, "{error}");
}

#[test]
fn a_field_with_a_wrong_value_is_not_missing_as_well() {
    let builder = Builder::new()
        .vehicle("layout", "PPNNPPNN")
        .vehicle("arm", f64::NAN)
        .vehicle("mass", "heavy")
        .vehicle("inertia", 0.04)
        .rotor("max_thrust", 6.53)
        .rotor("torque_per_thrust", 0.016)
        .rotor("max_speed", f64::INFINITY);
    let found: Vec<String> = problems(builder).into_iter().map(|(field, _)| field).collect();
    assert_eq!(found, ["vehicle.arm", "vehicle.mass", "vehicle.inertia", "vehicle.rotor.max_speed"]);
}

#[test]
fn a_mode_without_rotors_is_an_error() {
    assert_eq!(problems(octocopter().lost("M2", &[])), [("modes.M2".into(), "mavc::fault::empty")]);
}

#[test]
fn problems_name_the_value_and_the_fix() {
    let shown = |builder: Builder| builder.build().unwrap_err().to_string();
    let mode = shown(octocopter().plan("against", ["M9"]));
    assert!(
        mode.starts_with("plan.against: unknown fault mode `M9`") && mode.contains("; use a declared name: `M1`"),
        "{mode}"
    );
    let rotor = shown(octocopter().lost("M2", &[9]));
    assert!(rotor.contains("a whole number from 1 to 8: this is 9"), "{rotor}");
}

#[test]
fn warnings_are_returned_with_the_spec() {
    let (_, warnings) = octocopter().build_with_warnings().unwrap();
    assert!(warnings.is_empty(), "{warnings:?}");
    let (spec, warnings) = octocopter().simulate("wind", [1.0, 0.0, 0.0]).build_with_warnings().unwrap();
    assert_eq!(spec.model().simulation.wind, [1.0, 0.0, 0.0]);
    let found: Vec<(&str, &str)> = warnings.iter().map(|w| (w.field.as_str(), w.code)).collect();
    assert_eq!(found, [("simulate.wind", "mavc::simulate::no_drag")]);
}

#[test]
fn built_volumes_are_the_written_ones() {
    let with_volumes = || {
        octocopter()
            .vehicle("size", 0.35)
            .keep_in("field", "box")
            .volume("field", "from", [-5.0, -20.0, 0.0])
            .volume("field", "to", [25.0, 20.0, 30.0])
            .volume("field", "turn", 0.1)
            .keep_out("mast", "cylinder")
            .volume("mast", "centre", [5.0, 0.5, 0.0])
            .volume("mast", "radius", 0.4)
            .volume("mast", "height", 30.0)
            .keep_out("shed", "polygon")
            .volume("shed", "corners", [[14.0, 7.0], [20.0, 7.0], [20.0, 9.5], [16.0, 9.0], [16.0, 12.0], [14.0, 12.0]])
            .volume("shed", "bottom", 0.0)
            .volume("shed", "top", 4.0)
            .volume("shed", "clearance", 0.5)
            .keep_out("hill", "half_space")
            .volume("hill", "point", [0.0, 0.0, -1.0])
            .volume("hill", "normal", [0.1, 0.0, 1.0])
            .keep_out("balloon", "sphere")
            .volume("balloon", "centre", [5.0, 5.0, 20.0])
            .volume("balloon", "radius", 2.0)
    };
    let built = with_volumes().build().unwrap();
    let written = "
        vehicle craft {
            layout = \"PPNNPPNN\"; arm = 21.1 cm; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 35 cm
            rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
        }
        faults { mode M1 { rotor 1 lost } }
        mission flight {
            start at [0, 0, 2] m
            waypoint at [10, 0, 5] m
            keep_in field { shape = box; from = [-5, -20, 0] m; to = [25, 20, 30] m; turn = 0.1 rad }
            keep_out mast { shape = cylinder; centre = [5, 0.5, 0] m; radius = 40 cm; height = 30 m }
            keep_out shed {
                shape = polygon; bottom = 0 m; top = 4 m; clearance = 50 cm
                corners = [[14, 7], [20, 7], [20, 9.5], [16, 9], [16, 12], [14, 12]] m
            }
            keep_out hill { shape = half_space; point = [0, 0, -1] m; normal = [0.1, 0, 1] }
            keep_out balloon { shape = sphere; centre = [5, 5, 20] m; radius = 2 m }
            limits { speed <= 6 m/s }
        }
        plan { samples = 60 }";
    let written = mavc::compile(written).into_result().unwrap();
    let volumes = |spec: &Spec| {
        let mission = spec.model().mission.as_ref().unwrap();
        mission.volumes.iter().map(|v| (v.name.clone(), v.side, v.bodies.clone(), v.clearance)).collect::<Vec<_>>()
    };
    assert_eq!(volumes(&built), volumes(&written));
    assert_eq!(built.model().to_string(), written.model().to_string());
    let text = with_volumes().text();
    assert_eq!(mavc::format(&text).unwrap(), text, "the text is laid out");
    // Mistakes name the call.
    let wrong = octocopter()
        .vehicle("size", 0.35)
        .keep_out("mast", "tower")
        .volume("mast", "radius", -1.0)
        .volume("shed", "top", 3.0)
        .keep_out("wall", "box")
        .volume("wall", "width", 2.0)
        .keep_in("yard", "polygon")
        .volume("yard", "corners", 3.0);
    let mut found: Vec<String> = problems(wrong).into_iter().map(|(field, _)| field).collect();
    found.sort();
    found.dedup();
    for field in [
        "mission.volumes.mast.shape",
        "mission.volumes.shed.top",
        "mission.volumes.wall.width",
        "mission.volumes.yard.corners",
    ] {
        assert!(found.iter().any(|f| f == field || field.starts_with(&format!("{f}."))), "{field}: {found:?}");
    }
}

#[test]
fn what_follows_a_fault_is_built_as_it_is_written() {
    let built = octocopter()
        .vehicle("size", 0.35)
        .mode("M1", "recovery", ["continue", "pad"])
        .mission("ground", 0.0)
        .mission("buffer", 4.0)
        .landing_site("pad", [12.0, -8.0, 0.0], 2.0)
        .keep_off("street", "polygon")
        .area("street", "corners", [[0.0, 5.0], [40.0, 5.0], [40.0, 11.0]])
        .area("street", "clearance", 1.0)
        .keep_off("pond", "cylinder")
        .area("pond", "centre", [30.0, -20.0, 0.0])
        .area("pond", "radius", 3.0)
        .after_fault_at_most("tilt", 0.75)
        .recovery("order", ["continue", "land_at_sites"])
        .recovery("detection", 0.1)
        .recovery("within", 20.0);
    let text = built.text();
    assert_eq!(mavc::format(&text).unwrap(), text, "the text is laid out");
    let written = "
        vehicle craft {
            layout = \"PPNNPPNN\"; arm = 21.1 cm; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 35 cm
            rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
        }
        faults { mode M1 { rotor 1 lost; recovery = [continue, pad] } }
        mission flight {
            ground = 0 m
            buffer = 4 m
            start at [0, 0, 2] m
            waypoint at [10, 0, 5] m
            limits { speed <= 6 m/s }
            landing_site pad { at = [12, -8, 0] m; radius = 2 m }
            keep_off street { shape = polygon; corners = [[0, 5], [40, 5], [40, 11]] m; clearance = 1 m }
            keep_off pond { shape = cylinder; centre = [30, -20] m; radius = 3 m }
            after_fault_limits { tilt <= 0.75 rad }
        }
        plan { samples = 60; recovery { order = [continue, land_at_sites]; detection = 100 ms; within = 20 s } }";
    let written = mavc::compile(written).into_result().unwrap();
    assert_eq!(built.build().unwrap().model().to_string(), written.model().to_string());
    // Mistakes name the call.
    let wrong = octocopter()
        .landing_site("pad", [0.0, 0.0, f64::NAN], 2.0)
        .keep_off("street", "sphere")
        .area("yard", "radius", 2.0)
        .after_fault_at_most("altitude", 30.0)
        .recovery("order", "continue")
        .recovery("until", 3.0);
    let found: Vec<String> = problems(wrong).into_iter().map(|(field, _)| field).collect();
    for field in [
        "mission.landing_sites.pad.at",
        "mission.keep_off.street.shape",
        "mission.keep_off.yard.radius",
        "mission.after_fault_limits.altitude",
        "plan.recovery.order",
        "plan.recovery.until",
    ] {
        assert!(found.iter().any(|f| f == field || field.starts_with(&format!("{f}."))), "{field}: {found:?}");
    }
}
