//! The circle closed: flights that mavc simulates, as the ULog that it writes, diagnosed without their faults.

use mavc::diagnosis::study::Loss;
use mavc::exchange::flight::{Format, Recorder};
use mavc::flight::Sample;
use mavc::observer::Silent;
use mavc::pipeline::{diagnose, fly_plan};

/// A vehicle with these rotors climbs and turns in gusts; `fault` is what happens to it.
fn spec(rotors: &str, fault: &str) -> String {
    format!(
        "vehicle v {{
    {rotors}
    mass = 2 kg; inertia = [0.02, 0.022, 0.038] kg*m^2
    rotor {{ max_thrust = {} N; torque_per_thrust = 16 mm; max_speed = 7500 rpm; time_constant = 40 ms }}
}}
faults {{ mode F {{ rotor 3 {} }} }}
mission m {{
    start at [0, 0, 60] m; waypoint at [4, 0, 62] m  yaw 40 deg; hold 3 s; waypoint at [0, 3, 60] m  yaw 0 deg
}}
plan {{ planner = rip; against = []; time = 18 s; samples = 45 }}
simulate {{
    control_rate = 400 Hz; rate = 1200 Hz; gusts = 1 m/s; drag = 0.3 N*s/m; gyroscope_noise = 0.006 rad/s
    detection = never; lost_beyond = 40 m; lost_yaw = off; upside_down = 3 s{}
}}
",
        if rotors.contains("X8") { 7 } else { 10 },
        if fault.is_empty() { "lost" } else { fault },
        if fault.is_empty() { "" } else { "; fault F at 11 s" },
    )
}

/// The losses in the log of a simulated flight with rows at a rate (Hz).
fn losses(text: &str, rate: f64) -> Vec<Loss> {
    let compiled = mavc::compile(text);
    let spec = compiled.spec.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let Ok(planning) = mavc::plan(&spec) else { panic!("a plan") };
    let solved = planning.plan().expect("a plan");
    let mut recorder = Recorder::new(Format::Ulog, spec.model(), Some(rate), solved.time).unwrap();
    let mut record = |sample: &Sample| recorder.add(sample);
    fly_plan(&spec, solved, Some(&mut record), &Silent);
    let Ok(found) = diagnose(&mut &recorder.finish()[..], Some(&spec), &[], &mut []) else { panic!("an answer") };
    found.diagnosis.losses().to_vec()
}

/// The loss is the first of the log, at its time, with its capacity in the interval; the name is the motor's.
fn finds(rotors: &str, fault: &str, rate: f64, motor: usize, capacity: f64) {
    let found = losses(&spec(rotors, fault), rate);
    let first = found.first().unwrap_or_else(|| panic!("no loss: {rotors}"));
    assert!(first.motor + 1 == motor && first.alternatives.is_empty(), "{found:?}");
    assert!((first.time - 11.0).abs() < 0.1, "{found:?}");
    let [low, high] = first.capacity_interval;
    assert!(low <= capacity && capacity <= high && high - low < 0.3, "{found:?}");
}

#[test]
fn a_rotor_is_named_by_the_number_of_its_motor() {
    let quad = "rotors {
        rotor at [ 0.2,  0.2, 0] m spin P motor 3
        rotor at [-0.2,  0.2, 0] m spin N motor 2
        rotor at [-0.2, -0.2, 0] m spin P motor 4
        rotor at [ 0.2, -0.2, 0] m spin N motor 1
    }";
    finds(quad, "lost", 50.0, 4, 0.0);
}

#[test]
fn a_loss_is_found_at_ten_and_at_four_hundred_hertz() {
    finds("layout = \"PPNNPN\"; arm = 0.25 m;", "lost", 10.0, 3, 0.0);
    finds("layout = \"PNPNPN\"; arm = 0.25 m;", "reduced to 40 %", 400.0, 3, 0.4);
}

#[test]
fn the_upper_and_the_lower_rotor_of_an_x8_are_distinguished() {
    let place = |x: f64, y: f64, z: f64, spin: char| format!("rotor at [{x}, {y}, {z}] m spin {spin};");
    let pair = |x: f64, y: f64, [above, below]: [char; 2]| place(x, y, 0.0, above) + &place(x, y, -0.06, below);
    let pairs = [(0.2, 0.2, ['P', 'N']), (-0.2, 0.2, ['N', 'P']), (-0.2, -0.2, ['P', 'N']), (0.2, -0.2, ['N', 'P'])];
    let rotors: String = pairs.into_iter().map(|(x, y, spins)| pair(x, y, spins)).collect();
    finds(&format!("rotors {{ {rotors} }} // X8\n"), "reduced to 30 %", 100.0, 3, 0.3);
}

#[test]
fn gusts_and_noise_are_no_loss() {
    assert_eq!(losses(&spec("layout = \"PPNNPPNN\"; arm = 0.25 m;", ""), 100.0), []);
}

/// The sentence about the end, from a log without a spec's faults.
fn why(text: &str) -> String {
    let spec = mavc::compile(text).spec.unwrap();
    let Ok(planning) = mavc::plan(&spec) else { panic!("a plan") };
    let solved = planning.plan().expect("a plan");
    let mut recorder = Recorder::new(Format::Ulog, spec.model(), Some(50.0), solved.time).unwrap();
    let mut record = |sample: &Sample| recorder.add(sample);
    fly_plan(&spec, solved, Some(&mut record), &Silent);
    let Ok(found) = diagnose(&mut &recorder.finish()[..], Some(&spec), &[], &mut []) else { panic!("an answer") };
    let json = serde_json::to_value(mavc::report::diagnosis::DiagnosisRecord::new(&found.diagnosis)).unwrap();
    json["why"].as_str().map(str::to_string).unwrap_or_default()
}

/// A lost rotor that turns counter-clockwise pushed the body clockwise: without it a ring PNPNPN, which needs all of its
/// yaw torque to hover, cannot counter a counter-clockwise turn.
#[test]
fn the_end_is_explained_by_the_set_and_the_log() {
    let ring = "layout = \"PNPNPN\"; arm = 0.25 m;";
    let said = why(&spec(ring, "lost"));
    assert!(said.starts_with("without motor 3 the other motors can hold height, roll and pitch, but "), "{said}");
    assert!(said.contains("have no yaw torque against a counter-clockwise turn"), "{said}");
    assert!(said.contains("the log shows ") && said.contains("deg/s") && said.contains("tilt of up to"), "{said}");
    // Six of eight rotors hold all that the eight do: nothing explains an end, and nothing is claimed.
    let said = why(&spec("layout = \"PPNNPPNN\"; arm = 0.25 m;", "lost"));
    assert!(said.contains("can hold height, attitude and heading"), "{said}");
    assert!(said.contains("no fast turn") && said.contains("in the air until the log ends"), "{said}");
    assert_eq!(why(&spec("layout = \"PPNNPPNN\"; arm = 0.25 m;", "")), "");
}
