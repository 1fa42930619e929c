//! Batteries: energy by closed forms and by the table of rotor speeds, the charge that plans leave, and full thrust at
//! the lowest charge.

use crate::cli::mavc;
use crate::schemas::schema;
use mavc::Compiler;
use mavc::actuation::Wrench;
use mavc::admissible::allocation::Allocator;
use mavc::energy::Power;
use mavc::flight::Outcome;
use mavc::model::Rotor;
use mavc::motion::Trajectory;
use mavc::motion::wrench_model::WrenchModel;
use mavc::report::battery;
use mavc::report::trajectory_csv;
use mavc::{MissionPlan, PlanOutcome, Spec, compile};

const BATTERY: &str = "battery { capacity = 5 A*h; voltage = 22.2 V; hover_power = 220 W }";

const ROTOR: &str = "max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s";

/// The paper's octocopter, with these lines in its block, on a mission.
fn octo(inside: &str, mission: &str, plan: &str) -> Spec {
    octo_with(ROTOR, inside, mission, plan)
}

fn octo_with(rotor: &str, inside: &str, mission: &str, plan: &str) -> Spec {
    let text = text(rotor, inside, mission, plan);
    compile(&text).into_result().unwrap_or_else(|e| panic!("{e}"))
}

fn text(rotor: &str, inside: &str, mission: &str, plan: &str) -> String {
    format!(
        "vehicle octo {{
    layout  = \"PPNNPPNN\"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor {{ {rotor} }}
    {inside}
}}
faults {{ every 1 rotor lost as M }}
mission m {{
{mission}
}}
plan {{ against = [M1]; {plan} }}
"
    )
}

const HOP: &str =
    "start at [0, 0, 2] m\nwaypoint at [12, 4, 6] m  yaw 90 deg\nlimits { speed <= 5 m/s; tilt <= 25 deg }";

fn planned(spec: &Spec) -> MissionPlan {
    match mavc::plan(spec).unwrap().outcome() {
        PlanOutcome::Planned(plan) => (**plan).clone(),
        other => panic!("{other:?}"),
    }
}

/// Rest at one place for a time, s.
fn rest(seconds: f64) -> Trajectory {
    let mut node = mavc::motion::NodeState::default();
    node[2][0] = 5.0;
    Trajectory {
        times: vec![0.0, 0.4 * seconds, seconds],
        nodes: vec![node; 3],
        waypoint_nodes: vec![0, 2],
        model: WrenchModel::Exact,
    }
}

#[test]
fn hover_takes_its_power_times_the_time() {
    let spec = octo(BATTERY, HOP, "time = 8 s");
    let used = Power::of(spec.model()).unwrap().along(&rest(600.0));
    assert!((used.energy / (220.0 * 600.0) - 1.0).abs() < 1e-9, "{used:?}");
    assert!((used.most.value / 220.0 - 1.0).abs() < 1e-9);
    // 5 A*h at 22.2 V are 399.6 kJ.
    let left = used.left(spec.model().vehicle.battery.as_ref().unwrap());
    assert!((left - (1.0 - 132.0 / 399.6)).abs() < 1e-9, "{left}");
}

/// The same for rotors of different strength, one of which may not stop.
#[test]
fn hover_of_uneven_rotors_takes_the_hover_power() {
    let rotors = "rotor at [0.2, 0.2, 0] m spin P\nrotor at [0.2, -0.2, 0] m spin N max_thrust 9 N min_speed 150 rad/s
        rotor at [-0.25, -0.2, 0] m spin P torque_per_thrust 19 mm\nrotor at [-0.2, 0.2, 0] m spin N";
    let text = format!(
        "vehicle v {{
    mass    = 1.3 kg
    inertia = [0.013, 0.013, 0.024] kg*m^2
    rotor {{ max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 840 rad/s }}
    rotors {{ {rotors} }}
    battery {{ capacity = 74 W*h / (14.8 V); voltage = 14.8 V; hover_power = 190 W; keep = 0 % }}
}}
"
    );
    let spec = compile(&text).into_result().unwrap();
    let used = Power::of(spec.model()).unwrap().along(&rest(60.0));
    assert!((used.energy / (190.0 * 60.0) - 1.0).abs() < 1e-9, "{used:?}");
    let battery = spec.model().vehicle.battery.as_ref().unwrap();
    assert!((battery.energy() - 74.0 * 3600.0).abs() < 1e-6, "{}", battery.energy());
}

/// For equal rotors, momentum theory: each takes its share of the hover power times (F/F_h)^1.5.
#[test]
fn power_follows_momentum_theory() {
    let spec = octo(BATTERY, HOP, "time = 8 s");
    let model = spec.model();
    let (power, allocator) = (Power::of(model).unwrap(), Allocator::new(&model.vehicle));
    let in_hover = 1.8 * 9.81 / 8.0;
    for wrench in [[17.658, 0.0, 0.0, 0.0], [25.0, 0.6, -0.3, 0.02], [12.0, -0.9, 0.4, -0.03], [35.316, 0.0, 0.0, 0.0]]
    {
        let wrench = Wrench::from(wrench);
        let due: f64 = allocator.thrusts(&wrench).iter().map(|f| 220.0 / 8.0 * (f / in_hover).powf(1.5)).sum();
        let told = power.for_wrench(&wrench);
        assert!((told / due - 1.0).abs() < 1e-9, "{wrench:?}: {told} {due}");
    }
    // Twice the thrust, 2^1.5 times the power.
    let twice = power.for_wrench(&Wrench::new(2.0 * 17.658, 0.0, 0.0, 0.0));
    assert!((twice / (220.0 * 2.0_f64.powf(1.5)) - 1.0).abs() < 1e-9, "{twice}");
}

/// The energy of a plan against the trapezoidal rule on the rotor speeds of its table, a hundred times finer than its
/// nodes.
#[test]
fn the_energy_is_that_of_the_rotor_speeds_in_the_table() {
    for settings in ["time = 5 s; samples = 100", "time = 5 s; samples = 100; model = hover"] {
        let spec = octo(BATTERY, HOP, settings);
        let (model, plan) = (spec.model(), planned(&spec));
        let used = Power::of(model).unwrap().along(&plan.trajectory);
        let rate = 100.0 * 100.0 / plan.time;
        let table = trajectory_csv::table(&plan.trajectory, model, Some(rate)).unwrap();
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let columns: Vec<usize> = (1..=8)
            .map(|k| reader.headers().unwrap().iter().position(|h| h == format!("omega_{k}")).unwrap())
            .collect();
        // All rotors are equal: w = sqrt(m g/(8 b)) in hover.
        let cubes =
            |row: &csv::StringRecord| columns.iter().map(|&c| row[c].parse::<f64>().unwrap().powi(3)).sum::<f64>();
        let b = 6.53 / 874.0_f64.powi(2);
        let in_hover = 8.0 * (1.8 * 9.81 / (8.0 * b)).powf(1.5);
        let powers: Vec<f64> = reader.records().map(|row| 220.0 * cubes(&row.unwrap()) / in_hover).collect();
        let sum: f64 = powers.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]) / rate).sum();
        assert!(powers.len() > 9_000);
        assert!((sum / used.energy - 1.0).abs() < 1e-5, "{settings}: {sum} {used:?}");
        assert!(used.error < 1e-6 * used.energy, "{used:?}");
        let largest = powers.iter().copied().fold(0.0, f64::max);
        assert!((largest / used.most.value - 1.0).abs() < 1e-3, "{settings}: {largest} {used:?}");
        // The plan moves: hover is not the answer.
        assert!(largest > 1.05 * 220.0, "{largest}");
    }
}

/// A heavier vehicle within the interval of its mass takes more.
#[test]
fn the_energy_is_that_of_the_largest_mass() {
    let text =
        "vehicle q { layout = \"PNPN\"; arm = 20 cm; mass = 1.3 kg +- 3 %; inertia = [0.013, 0.013, 0.024] kg*m^2
    rotor { max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 840 rad/s }
    battery { capacity = 5 A*h; voltage = 14.8 V; hover_power = 190 W } }";
    let spec = compile(text).into_result().unwrap();
    let used = Power::of(spec.model()).unwrap().along(&rest(60.0));
    assert!((used.energy / (190.0 * 60.0 * 1.03_f64.powf(1.5)) - 1.0).abs() < 1e-9, "{used:?}");
}

/// A battery without `thrust_at_empty` changes no plan; the report of the same plan has a line more, and JSON an
/// object.
#[test]
fn a_battery_alone_changes_no_plan() {
    let settings = "time = 8 s; samples = 30";
    let (without, with) = (octo("", HOP, settings), octo(BATTERY, HOP, settings));
    let (plain, powered) = (planned(&without), planned(&with));
    assert_eq!(plain.trajectory, powered.trajectory);
    assert!(battery::record(without.model(), &plain.trajectory).is_none());
    assert_eq!(battery::text(without.model(), &plain.trajectory), "");
    let record = battery::record(with.model(), &powered.trajectory).unwrap();
    assert!(record.left > 0.99 && record.caveat().is_none(), "{record:?}");
    assert_eq!((record.keep, record.full_thrust), (0.2, 1.0));
}

/// Ten minutes of hold take a third of the battery. With half of it, less is left than `keep`; with a quarter, it is
/// empty.
#[test]
fn a_plan_that_leaves_too_little_is_told() {
    let mission = "start at [0, 0, 2] m\nhold 600 s\nwaypoint at [1, 0, 2] m";
    let told = |capacity: &str, keep: &str| {
        let inside =
            format!("battery {{ capacity = {capacity}; voltage = 22.2 V; hover_power = 220 W; keep = {keep} }}");
        let spec = octo(&inside, mission, "time = 610 s; samples = 30; timing = proportional");
        let plan = planned(&spec);
        let record = battery::record(spec.model(), &plan.trajectory).unwrap();
        // The hop is slow: the closed form of hover holds to 0.1 %.
        assert!((record.energy_j / (220.0 * 610.0) - 1.0).abs() < 1e-3, "{record:?}");
        let text = battery::text(spec.model(), &plan.trajectory);
        let caveats = mavc::report::caveats::caveats(spec.model(), &plan);
        (text, caveats.iter().map(|c| c.message.clone()).collect::<Vec<_>>())
    };
    let (text, caveats) = told("5 A*h", "20 %");
    assert!(text.contains("37.3 W*h of 111 W*h (33.6 %), 66.4 % left (20 % to keep); mean power 220 W"), "{text}");
    assert!(caveats.is_empty(), "{caveats:?}");
    let (_, caveats) = told("2500 mA*h", "40 %");
    assert!(caveats[0].starts_with("The plan leaves 32.8 % of the charge, and `keep` requires 40 %."), "{caveats:?}");
    let (text, caveats) = told("1250 mA*h", "20 %");
    assert!(text.contains("none left"), "{text}");
    assert!(caveats[0].contains("more energy than the battery holds: 37.3 W*h of 27.8 W*h"), "{caveats:?}");
}

/// With `thrust_at_empty`, sets and plans are those of a vehicle with the full thrust at the charge `keep`.
#[test]
fn sets_use_full_thrust_at_the_lowest_charge() {
    let settings = "time = 6 s; samples = 60";
    let sagging = BATTERY.replace(" }", "; keep = 30 %; thrust_at_empty = 70 % }");
    let (full, low) = (octo(BATTERY, HOP, settings), octo(&sagging, HOP, settings));
    let share = 0.7 + 0.3 * 0.3;
    for (a, b) in full.model().vehicle.rotors.iter().zip(&low.model().vehicle.rotors) {
        assert!((b.max_thrust() / a.max_thrust() - share).abs() < 1e-12);
        assert_eq!((a.thrust_coefficient, a.drag_coefficient), (b.thrust_coefficient, b.drag_coefficient));
    }
    let lift: f64 = low.model().vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    assert!((lift - 8.0 * 6.53 * share).abs() < 1e-9);
    // The same as a vehicle that is written with these numbers.
    let rotor = format!(
        "max_thrust = {} N; torque_per_thrust = 16 mm; max_speed = {} rad/s",
        6.53 * share,
        874.0 * share.sqrt()
    );
    let written = octo_with(&rotor, "", HOP, settings);
    let margins = |spec: &Spec| mavc::analyze(spec).iter().map(|mode| mode.acai.unwrap()).collect::<Vec<_>>();
    for (a, b) in margins(&low).iter().zip(margins(&written)) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    assert!(margins(&low)[1] < margins(&full)[1] - 0.05, "{:?} {:?}", margins(&low), margins(&full));
    // The checker decides the plan by the same sets, which it works out itself.
    let planning = mavc::plan(&low).unwrap();
    let certificate = serde_json::to_vec(&mavc::certify(&low, &planning).unwrap()).unwrap();
    assert!(mavc::verify(&certificate, &low).is_ok());
    let text = mavc::report::terminal::plan(low.problem().unwrap(), planning.comparison());
    let analysis = mavc::report::analysis_text::analysis(low.model(), &mavc::analyze(&low));
    for text in [text, analysis] {
        let line = "\nFull thrust is that with 30 % of the charge: 79 % of that with a full battery\n";
        assert!(text.contains(line), "{text}");
    }
}

/// Where full thrust is too low at the end for the mode, the plan is refused, and a larger `keep` helps.
#[test]
fn a_weak_battery_costs_fault_modes() {
    let verdict = |keep: &str| {
        let inside = BATTERY.replace(" }", &format!("; keep = {keep}; thrust_at_empty = 45 % }}"));
        let spec = octo(&inside.replace("220 W", "300 W"), HOP, "time = 6 s");
        mavc::analyze(&spec)[1].acai.unwrap()
    };
    assert!(verdict("0 %") < 0.0 && verdict("90 %") > 0.0, "{} {}", verdict("0 %"), verdict("90 %"));
}

#[test]
fn reports_with_a_battery_are_as_their_schema_says() {
    let schema = schema("report");
    let spec = octo(BATTERY, HOP, "time = 6 s; samples = 60");
    let planning = mavc::plan(&spec).unwrap();
    let record =
        mavc::report::record::Record::new(spec.problem().unwrap(), planning.comparison(), spec.sha256().into());
    let mut record = serde_json::to_value(&record).unwrap();
    schema.assert_valid(&record);
    let members: Vec<String> = record["planners"][0]["battery"].as_object().unwrap().keys().map(String::from).collect();
    assert_eq!(members.len(), 9, "{members:?}");
    for member in members {
        let mut less = record.clone();
        less["planners"][0]["battery"].as_object_mut().unwrap().remove(&member);
        assert!(!schema.is_valid(&less), "the battery may lack {member}");
    }
    record["planners"][0]["battery"]["surplus"] = 1.into();
    assert!(!schema.is_valid(&record));
}

/// `--set` changes a battery and adds its fields; the page has the figure, and a chart of the power.
#[test]
fn the_command_sets_and_shows_batteries() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    let settings = ["vehicle.battery.capacity = 20 mA*h", "plan.planner = rip", "plan.time = 8 s", "plan.samples = 40"];
    let settings: Vec<&str> = settings.iter().flat_map(|text| ["--set", text]).collect();
    let spec = folder.path().join("octo.mav");
    std::fs::write(&spec, text(ROTOR, BATTERY, HOP, "")).unwrap();
    let paths = [spec.to_str().unwrap(), "--html", page.to_str().unwrap()];
    let ran = mavc(&[&["plan"], &paths[..], &settings].concat());
    let printed = String::from_utf8(ran.stdout).unwrap();
    assert_eq!(ran.status.code(), Some(0), "{printed}{}", String::from_utf8_lossy(&ran.stderr));
    // 0.49 W*h of 0.444.
    assert!(printed.contains("of 0.444 W*h (111 %), none left (20 % to keep)"), "{printed}");
    assert!(printed.contains("The plan takes more energy than the battery holds"), "{printed}");
    let html = std::fs::read_to_string(page).unwrap();
    assert!(html.contains("Charge left") && html.contains("Electrical power"));
}

/// A template of a whole mission: its plan is found, leaves what it must of the charge, and is proved.
fn proved_template(kind: &str, compiler: &Compiler) -> (Spec, mavc::Planning) {
    let (_, text) = mavc::MISSION_TEMPLATES.into_iter().find(|(name, _)| *name == kind).unwrap();
    let spec = compiler.text("template.mav", text.as_bytes()).into_result().unwrap();
    let planning = mavc::plan(&spec).unwrap();
    assert_eq!(planning.verdict(), mavc::Verdict::Found, "{kind}");
    let battery = battery::record(spec.model(), &planning.plan().unwrap().trajectory).unwrap();
    assert!(!battery.is_short(), "{kind}: {battery:?}");
    let certificate = serde_json::to_vec(&mavc::certify(&spec, &planning).unwrap()).unwrap();
    let verified = mavc::verify(&certificate, &spec).unwrap();
    assert!(verified.weaker.is_empty(), "{kind}: {:?}", verified.weaker);
    (spec, planning)
}

/// A battery built from values is the written one, and its mistakes are those of the calls.
#[test]
fn batteries_are_built_from_values() {
    let vehicle = || {
        let builder = mavc::Builder::new().vehicle("layout", "PPNNPPNN").vehicle("arm", 0.211).vehicle("mass", 1.8);
        let builder = builder.vehicle("inertia", [0.0429, 0.0429, 0.0748]).rotor("max_thrust", 6.53);
        builder.rotor("torque_per_thrust", 0.016).rotor("max_speed", 874.0)
    };
    let powered = vehicle().battery("capacity", 18_000.0).battery("voltage", 22.2).battery("hover_power", 220.0);
    let spec = powered.clone().battery("thrust_at_empty", 0.7).build().unwrap();
    let written = octo(&BATTERY.replace(" }", "; thrust_at_empty = 70 % }"), HOP, "time = 8 s");
    let (built, written) = (&spec.model().vehicle, &written.model().vehicle);
    let numbers = |b: &mavc::model::Battery| [b.energy(), b.hover_power, b.keep, b.lowest_full_thrust()];
    assert_eq!(built.battery.as_ref().map(numbers), written.battery.as_ref().map(numbers));
    assert_eq!(built.rotors, written.rotors);
    let problems = powered.battery("keep", 1.0).battery("charge", 1.0).build().unwrap_err().problems;
    let told: Vec<_> = problems.iter().map(|p| (p.field.as_str(), p.code)).collect();
    assert!(told.contains(&("vehicle.battery.charge", "mavc::name::unknown_field")), "{told:?}");
    assert!(told.contains(&("vehicle.battery.keep", "mavc::vehicle::battery")), "{told:?}");
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// The delivery as it is written, which also survives its flight.
    #[test]
    #[ignore = "long"]
    fn the_delivery_is_proved_and_flies() {
        let (spec, planning) = proved_template("delivery", &Compiler::new());
        let flight = mavc::fly(&spec, &planning).unwrap();
        let survives = matches!(flight.outcome, Outcome::Flown | Outcome::Landed { .. });
        assert!(survives && flight.max_error < 1.0, "{:?}, {} m", flight.outcome, flight.max_error);
    }

    /// The others by RIP, which takes less time.
    #[test]
    #[ignore = "long"]
    fn the_other_templates_are_proved() {
        let others = mavc::MISSION_TEMPLATES.map(|(kind, _)| kind).into_iter().filter(|kind| *kind != "delivery");
        for kind in others {
            proved_template(kind, &Compiler::new().set("plan.planner=rip"));
        }
    }
}
