//! Sense checks: absurd numbers get a warning or an error, those of vehicles that fly get none, and `allow` silences.

use super::{QUAD, check, check_file, codes};
use mavc::diagnostic::{Diagnostic, Severity};
use mavc::model::{Rotor, Spin, Vehicle};
use std::path::{Path, PathBuf};

/// All `.mav` files under a folder, sorted.
fn files(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::from(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => folders.push(path),
                false if path.extension().is_some_and(|e| e == "mav") => found.push(path),
                false => {}
            }
        }
    }
    found.sort();
    found
}

fn is_sense(diagnostic: &Diagnostic) -> bool {
    diagnostic.code.starts_with("mavc::sense::")
}

/// Whether somebody who reads these learns that a number is absurd.
fn is_told(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| is_sense(d) || d.severity == Severity::Error)
}

/// Every number of a vehicle that may slip, by the fields that give it.
const NUMBERS: [(&str, &[&str]); 5] = [
    ("mass", &["mass"]),
    ("inertia", &["inertia"]),
    ("arm", &["arm", "at"]),
    ("thrust", &["thrust_coefficient", "max_thrust"]),
    ("torque ratio", &["drag_coefficient", "torque_per_thrust"]),
];

/// `text` with `factor` before every value of these fields, and how many there are. `at` counts in rotors alone.
fn scaled(text: &str, fields: &[&str], factor: &str) -> (String, usize) {
    let mut count = 0;
    let mut line_scaled = |line: &str| {
        let mut words = line.split_inclusive(' ').peekable();
        let (mut out, is_rotor) = (String::new(), line.trim_start().starts_with("rotor at"));
        while let Some(word) = words.next() {
            out += word;
            if !fields.contains(&word.trim()) || word.trim() == "at" && !is_rotor {
                continue;
            }
            while let Some(mark) = words.next_if(|word| matches!(word.trim(), "" | "=")) {
                out += mark;
            }
            out += factor;
            count += 1;
        }
        out
    };
    let lines: Vec<String> = text.lines().map(|line| line_scaled(line.split("//").next().unwrap())).collect();
    (lines.join("\n"), count)
}

fn vehicle_block(text: &str) -> Option<&str> {
    let start = text.find("vehicle ").filter(|&at| at == 0 || text.as_bytes()[at - 1] == b'\n')?;
    let end = start + text[start..].find("\n}")? + 2;
    Some(&text[start..end])
}

#[test]
fn what_ships_gets_no_sense_warning() {
    let mut vehicles = 0;
    for path in files("specs").into_iter().chain(files("examples")).chain(files("tests/specs/parts")) {
        let (model, diagnostics) = check_file(path.to_str().unwrap());
        assert!(!diagnostics.iter().any(is_sense), "{}: {diagnostics:#?}", path.display());
        vehicles += usize::from(model.is_some());
    }
    assert!(vehicles >= 20);
}

#[test]
fn a_factor_of_a_thousand_in_a_shipped_vehicle_is_reported() {
    let template = PathBuf::from("src/template.mav");
    let all = files("specs").into_iter().chain(files("examples")).chain([template]);
    let (mut vehicles, mut spellings) = (0, std::collections::BTreeSet::<&str>::new());
    for path in all {
        let text = std::fs::read_to_string(&path).unwrap();
        let Some(vehicle) = vehicle_block(&text) else { continue };
        assert!(!is_told(&check(&scaled(vehicle, &["mass"], "1*").0).1), "{}", path.display());
        vehicles += 1;
        for (what, fields) in NUMBERS {
            for factor in ["1000*", "0.001*"] {
                let (changed, count) = scaled(vehicle, fields, factor);
                assert!(count > 0, "{}: no {what}\n{changed}", path.display());
                let found = check(&changed).1;
                assert!(
                    is_told(&found),
                    "{}: {factor}{what} is told by nothing\n{changed}\n{found:#?}",
                    path.display()
                );
            }
            spellings.extend(fields.iter().copied().filter(|field| scaled(vehicle, &[field], "1*").1 > 0));
        }
    }
    assert!(vehicles >= 12 && spellings.len() == 8, "{vehicles} vehicles, {spellings:?}");
}

/// A vehicle with its rotors one by one, in one of two spellings of thrust and torque, with numbers changed by factors.
fn spelled(vehicle: &Vehicle, by_coefficient: bool, factors: [f64; 5]) -> String {
    let [mass, inertia, arm, thrust, torque] = factors;
    let [ixx, iyy, izz] = vehicle.inertia.map(|i| i * inertia);
    let rotor = |r: &Rotor| {
        let [x, y, z] = r.position.map(|p| p * arm);
        let spin = if r.spin == Spin::P { "P" } else { "N" };
        let b = r.thrust_coefficient * thrust;
        let ratio = r.drag_coefficient / r.thrust_coefficient * torque;
        let performance = match by_coefficient {
            true => format!("thrust_coefficient {b:e} N*s^2/rad^2 drag_coefficient {:e} N*m*s^2/rad^2", b * ratio),
            false => format!("max_thrust {:e} N torque_per_thrust {ratio:e} m", r.max_thrust() * thrust),
        };
        format!("rotor at [{x:e}, {y:e}, {z:e}] m spin {spin} max_speed {:e} rad/s {performance}\n", r.max_speed)
    };
    let rotors: String = vehicle.rotors.iter().map(rotor).collect();
    format!(
        "vehicle v {{\n mass = {:e} kg\n inertia = [{ixx:e}, {iyy:e}, {izz:e}] kg*m^2\n rotors {{\n{rotors}}}\n}}\n",
        vehicle.mass * mass
    )
}

#[test]
fn a_factor_of_a_thousand_is_reported_in_every_spelling() {
    let mut cases = 0;
    for path in files("specs/vehicles").into_iter().chain(files("examples")) {
        let vehicle = check_file(path.to_str().unwrap()).0.unwrap().vehicle;
        for by_coefficient in [true, false] {
            let as_it_is = check(&spelled(&vehicle, by_coefficient, [1.0; 5])).1;
            assert!(as_it_is.is_empty(), "{}: {as_it_is:#?}", path.display());
            for number in 0..5 {
                for factor in [1e3, 1e-3] {
                    let mut factors = [1.0; 5];
                    factors[number] = factor;
                    let found = check(&spelled(&vehicle, by_coefficient, factors)).1;
                    assert!(is_told(&found), "{}: {} times {factor}", path.display(), NUMBERS[number].0);
                    cases += 1;
                }
            }
        }
    }
    assert!(cases >= 200, "{cases}");
}

/// What is written in place of what.
type Changes<'a> = &'a [(&'a str, &'a str)];

/// A six kilogram hexacopter with some fields changed.
fn hexa(changed: Changes) -> String {
    let mut text = "vehicle hexa {\n layout = \"PNPNPN\"\n arm = 0.45 m\n mass = 6 kg\n inertia = [0.21, 0.21, 0.38] kg*m^2\n \
                    rotor { max_thrust = 21 N; torque_per_thrust = 18 mm; max_speed = 6200 rpm; time_constant = 50 ms }\n}\n"
        .to_string();
    for (from, to) in changed {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// The last words of the sense warnings, sorted; an error fails the test.
fn sense(text: &str) -> Vec<&'static str> {
    let found = check(text).1;
    assert!(!found.iter().any(|d| d.severity == Severity::Error), "{text}\n{found:#?}");
    let sense = found.iter().filter(|d| is_sense(d));
    let mut words: Vec<_> = sense.map(|d| d.code.strip_prefix("mavc::sense::").unwrap()).collect();
    words.sort_unstable();
    words
}

#[test]
fn absurd_vehicles_get_the_warning_of_their_slip() {
    assert_eq!(sense(&hexa(&[])), Vec::<&str>::new());
    let cases: [(Changes, &[&str]); 11] = [
        (&[("6 kg", "6 g")], &["inertia", "thrust_to_weight"]),
        (&[("0.45 m", "45 m")], &["arm", "inertia"]),
        (&[("18 mm", "18 m")], &["torque_ratio"]),
        (&[("18 mm", "18 um")], &["torque_ratio"]),
        (&[("[0.21, 0.21, 0.38] kg*m^2", "[0.21, 0.21, 0.38] g*m^2")], &["inertia"]),
        (&[("6200 rpm", "6200 rad/s")], &["tip_speed"]),
        (&[("6200 rpm", "62 rpm")], &["tip_speed"]),
        (&[("50 ms", "50 s")], &["time_constant"]),
        (&[("21 N", "11 N")], &["thrust_to_weight"]),
        // A drag coefficient without its e-7: 53 of 56 planes of a set were found with the opposite slip.
        (
            &[(
                "max_thrust = 21 N; torque_per_thrust = 18 mm",
                "thrust_coefficient = 4.98e-5 N*s^2/rad^2; drag_coefficient = 9e-15 N*m*s^2/rad^2",
            )],
            &["torque_ratio"],
        ),
        (&[("21 N", "21 kgf"), ("6 kg", "60 kg"), ("[0.21, 0.21, 0.38] kg*m^2", "[2.1, 2.1, 3.8] kg*m^2")], &[]),
    ];
    for (changed, due) in cases {
        assert_eq!(sense(&hexa(changed)), due, "{changed:?}");
    }
}

#[test]
fn a_warning_shows_what_was_computed_from_what_and_the_slip() {
    let found = check(&hexa(&[("6 kg", "6 g")])).1;
    let warning = found.iter().find(|d| d.code == "mavc::sense::thrust_to_weight").unwrap();
    assert_eq!(
        warning.message,
        "the rotors of vehicle `hexa` lift 2141 times its weight, outside the usual range of 1.2 to 20 times"
    );
    assert_eq!(
        (warning.label.as_str(), warning.labels[0].message.as_str()),
        ("0.006 kg weigh 0.0589 N", "6 rotors give 126 N at full speed")
    );
    let help = warning.help.as_ref().unwrap();
    assert!(help.contains("`g` in place of `kg`") && help.contains("`allow = [thrust_to_weight]`"), "{help}");
}

#[test]
fn absurd_flights_get_the_warning_of_their_slip() {
    let flight = |waypoint: &str, rest: &str| {
        format!("{}mission m {{\n start at [0, 0, 2] m\n {waypoint}\n}}\n{rest}", hexa(&[]))
    };
    let hop = "waypoint at [10, 0, 5] m";
    assert_eq!(
        sense(&flight(hop, "plan { time = 10 s }\nsimulate { wind = [5, 0, 0] m/s; drag = 0.5 N*s/m; gusts = 2 m/s }")),
        [""; 0]
    );
    let cases: [(&str, &str, &[&str]); 22] = [
        (hop, "simulate { wind = [300, 0, 0] m/s; drag = 0.3 N*s/m }", &["wind"]),
        (hop, "simulate { wind = [20, 0, 0] m/s; drag = 6 N*s/m }", &["wind"]),
        (hop, "simulate { drag = 30 N*s/m }", &["drag"]),
        (hop, "simulate { gusts = 100 m/s; drag = 0.3 N*s/m }", &["gusts"]),
        (hop, "simulate { position_noise = 10 m }", &["noise"]),
        (hop, "simulate { position_gain = 0.004 1/s^2 }", &["gains"]),
        (hop, "simulate { lost_beyond = 2000 m; upside_down = 500 s }", &["loss", "loss"]),
        (hop, "simulate { lost_yaw_after = 1 ms }", &["loss"]),
        (hop, "simulate { lost_yaw = 0.001 deg }", &["loss"]),
        (hop, "simulate { detection = 100 s }", &["estimator"]),
        (hop, "simulate { forgetting = 0.01 }", &["estimator"]),
        (hop, "simulate { forgetting = 0.999999 }", &["estimator"]),
        (hop, "simulate { gyroscope_noise = 90 deg/s }", &["noise"]),
        (hop, "simulate { attitude_gain = 100 1/s^2; attitude_rate_gain = 1.6 1/s }", &["gains"]),
        (hop, "simulate { control_rate = 10 Hz; estimator_rate = 10 Hz }", &["gains"]),
        (hop, "simulate { position_gain = 0.004 1/s^2; velocity_gain = 0.0032 1/s }", &["gains"]),
        (hop, "plan { time = 6e-9 s }", &["speed"]),
        (hop, "plan { time = 20000 s }", &["duration", "speed"]),
        (
            "waypoint at [20000, 0, 5] m within 1 km\n waypoint at [10, 0, 5] m",
            "plan { time = 20 s }",
            &["speed", "tolerance"],
        ),
        ("waypoint at [0, 0, 2.004] m within 1 mm", "", &["distance"]),
        ("waypoint at [300000, 0, 2] m", "", &["distance"]),
        (
            "waypoint at [10, 0, 2] m\n limits { speed <= 8 km/s; climb <= 0 m/s; yaw_rate <= 90 rad/s }",
            "",
            &["limit", "limit"],
        ),
    ];
    for (waypoint, rest, due) in cases {
        assert_eq!(sense(&flight(waypoint, rest)), due, "{waypoint} {rest}");
    }
}

#[test]
fn magnitudes_beyond_all_reason_are_errors_and_never_a_crash() {
    let of = |changed: &[(&str, &str)]| {
        let found = check(&hexa(changed)).1;
        found.iter().find(|d| d.severity == Severity::Error).map(|d| d.code)
    };
    let magnitude = Some("mavc::unit::magnitude");
    assert_eq!(of(&[("21 N", "1e300 N")]), magnitude);
    assert_eq!(of(&[("6 kg", "1e-300 kg")]), magnitude);
    assert_eq!(of(&[("18 mm", "1e-20 m")]), magnitude);
    assert_eq!(of(&[("0.45 m", "1e200 m")]), magnitude);
    assert_eq!(of(&[("[0.21, 0.21, 0.38] kg*m^2", "[0.21, 1e-200, 0.21] kg*m^2")]), magnitude);
    // Coefficients without e-6 and e-7: 6.5 MN a rotor.
    let coefficients = "thrust_coefficient = 8.5485 N*s^2/rad^2; drag_coefficient = 1.3678e-1 N*m*s^2/rad^2";
    let slip = [("max_thrust = 21 N; torque_per_thrust = 18 mm", coefficients), ("6200 rpm", "874 rad/s")];
    assert_eq!(of(&slip), magnitude);
    assert_eq!(
        codes(&format!("{QUAD}simulate {{ wind = [1e300, 0, 0] m/s; drag = 1 N*s/m }}\n")),
        ["mavc::unit::magnitude"]
    );
}

#[test]
fn within_the_bounds_the_sets_end_with_an_answer() {
    // At the ends of what may be written, alone and together; nothing may crash.
    let numbers: [(&str, [&str; 2]); 5] = [
        ("6 kg", ["1e-6 kg", "1e6 kg"]),
        ("0.45 m", ["0.1 mm", "10 km"]),
        ("21 N", ["1e-6 N", "1e6 N"]),
        ("18 mm", ["1e-12 m", "10 km"]),
        ("6200 rpm", ["0.1 rad/s", "1e6 rad/s"]),
    ];
    let mut models = 0;
    for choice in 0..3usize.pow(5) {
        let pick = |k: usize| choice / 3usize.pow(k as u32) % 3;
        let changed: Vec<(&str, &str)> =
            numbers.iter().enumerate().filter(|(k, _)| pick(*k) > 0).map(|(k, n)| (n.0, n.1[pick(k) - 1])).collect();
        if let Some(model) = check(&hexa(&changed)).0 {
            models += 1;
            mavc::admissible::diagnose::diagnose(&model);
        }
    }
    assert!(models >= 60, "{models}");
}

#[test]
fn allow_silences_by_word_code_and_override() {
    let light = hexa(&[("21 N", "11 N")]);
    assert_eq!(codes(&light), ["mavc::sense::thrust_to_weight"]);
    for allow in [
        "[thrust_to_weight]",
        "thrust_to_weight",
        "[\"mavc::sense::thrust_to_weight\"]",
        "[\"sense::thrust_to_weight\",]",
    ] {
        let (model, found) = check(&format!("allow = {allow}\n{light}"));
        assert!(model.is_some() && found.is_empty(), "{allow}: {found:#?}");
    }
    // What is allowed elsewhere is not.
    assert_eq!(codes(&format!("allow = [inertia]\n{light}")), ["mavc::allow::idle", "mavc::sense::thrust_to_weight"]);
    // Warnings of every kind.
    assert_eq!(codes(&format!("{QUAD}let a = 1\n")), ["mavc::name::unused"]);
    assert_eq!(codes(&format!("{QUAD}let a = 1\nallow = [\"mavc::name::unused\"]\n")), [""; 0]);
    // An override adds it, and replaces it.
    let mut set =
        mavc::read::load("spec.mav", light.as_bytes(), &|_: &Path| Err(std::io::ErrorKind::NotFound.into())).0;
    let text = mavc::read::parse_override("allow=[thrust_to_weight]", &mut set.sources).unwrap();
    assert_eq!(mavc::read::elaborate(&set, &[text]).diagnostics, vec![]);
}

#[test]
fn allow_takes_warnings_alone_and_says_what_was_meant() {
    let of = |allow: &str| {
        let found = check(&format!("{QUAD}allow = {allow}\n")).1;
        assert_eq!(found.len(), 1, "{allow}: {found:#?}");
        (found[0].code, found[0].help.clone().unwrap_or_default())
    };
    assert_eq!(of("[tipspeed]"), ("mavc::allow::unknown", "did you mean `tip_speed`?".into()));
    let (code, help) = of("[unused]");
    assert!(
        code == "mavc::allow::unknown"
            && help.contains("\"mavc::name::unused\"")
            && help.contains("\"mavc::fault::unused\"")
    );
    assert_eq!(of("[too_heavy]").0, "mavc::allow::not_a_warning");
    assert_eq!(of("[\"mavc::analysis::hover_on_edge\"]").0, "mavc::allow::not_a_warning");
    assert_eq!(of("[3]").0, "mavc::allow::unknown");
    assert_eq!(of("[tip_speed]").0, "mavc::allow::idle");
    // An error stays one whatever is allowed, and no `allow` is called idle beside it.
    let heavy = hexa(&[("6 kg", "600 kg"), ("[0.21, 0.21, 0.38]", "[21, 21, 38]")]);
    assert_eq!(codes(&format!("{heavy}allow = [tip_speed]\n")), ["mavc::vehicle::too_heavy"]);
    let twice = codes(&format!("{QUAD}allow = [tip_speed]\nallow = [inertia]\n"));
    assert_eq!(twice, ["mavc::name::duplicate"]);
    assert_eq!(codes(&format!("{QUAD}plan {{ allow = [tip_speed] }}\n")), ["mavc::name::unknown_field"]);
}
