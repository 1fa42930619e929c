//! `mavc diagnose` and `mavc identify`: logs of simulated flights with known faults, and damaged logs.

mod flying;
mod own;

use flying::{Fault, Noise, log};
use mavc::diagnosis::study::{Evidence, Kind, Loss};
use mavc::pipeline::{Undiagnosed, Why, diagnose, identify};
use serde_json::Value;
use std::process::{Command, Output};

/// The losses of a log, without those within a second after the first of another motor.
fn losses(bytes: &[u8]) -> Vec<Loss> {
    let Ok(found) = diagnose(&mut &bytes[..], None, &[], &mut []) else { panic!("the log can be read") };
    found.diagnosis.losses().to_vec()
}

fn run(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavc")).args(args).env("NO_COLOR", "1").output().unwrap()
}

#[test]
fn a_motor_that_loses_thrust_is_found_at_every_rate() {
    for (number, (outputs, rates)) in [(10.0, 25.0), (50.0, 100.0), (400.0, 400.0)].into_iter().enumerate() {
        for (motor, capacity) in [(1, 0.0), (3, 0.3), (6, 0.6)] {
            let bytes = log(Fault::Capacity(motor, 12.0, capacity), 20.0, outputs, rates, 7 + number as u64);
            let found = losses(&bytes);
            let first = found.first().unwrap_or_else(|| panic!("motor {motor} to {capacity} at {outputs} Hz"));
            assert_eq!(first.motor + 1, motor, "{outputs} Hz: {found:?}");
            assert!((first.time - 17.0).abs() < 0.2, "{outputs} Hz: {first:?}");
            assert!((first.capacity - capacity).abs() < 0.2, "{outputs} Hz: {first:?}");
            assert_eq!(first.evidence, Evidence::Motion);
        }
    }
}

#[test]
fn a_healthy_flight_has_no_loss() {
    for seed in 1..6 {
        for rate in [10.0, 100.0] {
            assert_eq!(losses(&log(Fault::None, 40.0, rate, 2.5 * rate, seed)), []);
        }
    }
}

/// Steps of pitch turn the vehicle between two outputs, so that no command explains the turn; but the commands are the
/// same before and after.
#[test]
fn a_quick_manoeuvre_is_no_loss() {
    for seed in 1..9 {
        assert_eq!(losses(&log(Fault::Steps, 40.0, 10.0, 25.0, seed)), [], "{seed}");
    }
}

/// Without a single output nothing is searched.
#[test]
fn every_output_may_be_hidden() {
    let bytes = log(Fault::Capacity(3, 12.0, 0.0), 20.0, 10.0, 25.0, 3);
    let Ok(found) = diagnose(&mut &bytes[..], None, &[1, 2, 3, 4, 5, 6], &mut []) else { panic!("an answer") };
    assert!(found.diagnosis.losses().len() <= 1);
}

#[test]
fn an_output_that_is_off_or_held_is_told_from_a_motor_that_fails() {
    let off = losses(&log(Fault::Off(4, 12.0), 20.0, 25.0, 50.0, 1));
    assert_eq!((off[0].motor + 1, off[0].kind, off[0].evidence), (4, Kind::Off, Evidence::Output), "{off:?}");
    assert!((off[0].time - 17.0).abs() < 0.06, "{off:?}");
    let held = losses(&log(Fault::Held(2, 12.0, 1500), 20.0, 25.0, 50.0, 1));
    assert_eq!((held[0].motor + 1, held[0].kind, held[0].evidence), (2, Kind::Held, Evidence::Output), "{held:?}");
}

/// A motor that turns on at one speed, in a log that has its output and in one where that is not looked at: then its
/// command follows from the demands of the controller, also where two motors of six are hidden.
#[test]
fn a_motor_that_is_stuck_is_told_from_one_that_is_weak() {
    for (motor, others) in [(2, &[][..]), (5, &[5, 4][..]), (6, &[6][..]), (1, &[1, 2, 6][..])] {
        for rate in [10.0, 50.0] {
            let bytes = log(Fault::Stuck(motor, 12.0, 0.2), 20.0, rate, 50.0, 9);
            let Ok(found) = diagnose(&mut &bytes[..], None, others, &mut []) else { panic!("the log can be read") };
            let losses = found.diagnosis.losses();
            assert_eq!((losses[0].motor + 1, losses[0].evidence), (motor, Evidence::Motion), "{others:?}: {losses:?}");
            assert!((losses[0].time - 17.0).abs() < 0.2, "{losses:?}");
            // Slow outputs do not always show which; the command is about 0.6 then.
            assert!(losses[0].kind == Kind::Held || rate < 50.0, "{others:?} {rate} Hz: {losses:?}");
            let share = if losses[0].kind == Kind::Held { 0.2 } else { 0.33 };
            assert!((losses[0].capacity - share).abs() < 0.08, "{others:?} {rate} Hz: {losses:?}");
        }
    }
}

/// An output that no longer follows the mixer says nothing of the command of a hidden motor.
#[test]
fn a_hidden_motor_is_not_accused_for_another_that_stops() {
    for (fault, motor) in [(Fault::Off(4, 12.0), 4), (Fault::Held(2, 12.0, 1500), 2)] {
        for hidden in (1..=6).filter(|hidden| *hidden != motor) {
            let bytes = log(fault, 20.0, 10.0, 25.0, 1);
            let Ok(found) = diagnose(&mut &bytes[..], None, &[hidden], &mut []) else { panic!("an answer") };
            let losses = found.diagnosis.losses();
            assert!(!losses.is_empty() && losses.iter().all(|loss| loss.motor + 1 == motor), "{hidden}: {losses:?}");
        }
    }
}

/// mavc names a motor that fades within 3 s, with what is left of it. It misses one that fades over 20 s, but names no
/// other motor in its place.
#[test]
fn a_motor_that_fades_is_found_if_it_fades_fast() {
    let mut found = Vec::new();
    for lasts in [1.0, 3.0, 10.0, 20.0] {
        for (capacity, rate) in [(0.0, 10.0), (0.0, 100.0), (0.3, 10.0), (0.3, 100.0), (0.6, 10.0), (0.6, 100.0)] {
            let losses = losses(&log(Fault::Fades(3, 10.0, capacity, lasts), 40.0, rate, 2.5 * rate, 5));
            let own = losses.iter().find(|loss| loss.motor + 1 == 3);
            if lasts < 5.0 {
                let own = own.unwrap_or_else(|| panic!("{lasts} s to {capacity} at {rate} Hz: {losses:?}"));
                assert!((own.capacity - capacity).abs() < 0.2, "{lasts} s to {capacity} at {rate} Hz: {own:?}");
                assert!(own.time > 15.0 && own.time < 15.0 + lasts, "{own:?}");
            }
            found.push((lasts, own.is_some(), losses.len()));
        }
    }
    let slow = |lasts: f64| found.iter().filter(move |(other, ..)| *other == lasts);
    assert_eq!(slow(10.0).filter(|(_, is_found, _)| *is_found).count(), 5);
    assert!(slow(20.0).all(|(_, _, losses)| *losses == 0));
}

/// Before 3.5 ArduCopter's parameters had no class: the outputs that move say how many motors there are.
#[test]
fn an_old_log_has_the_motors_whose_outputs_move() {
    let mut old = log(Fault::Capacity(3, 12.0, 0.0), 20.0, 10.0, 25.0, 3);
    let mut rename = |from: &[u8], to: &[u8; 16], value: f32| {
        let at = old.windows(from.len()).position(|window| window == from).unwrap();
        old[at..at + 16].copy_from_slice(to);
        old[at + 16..at + 20].copy_from_slice(&value.to_le_bytes());
    };
    rename(b"FRAME_CLASS\0", b"FRAME\0\0\0\0\0\0\0\0\0\0\0", 1.0);
    rename(b"FRAME_TYPE\0", b"OTHER\0\0\0\0\0\0\0\0\0\0\0", 1.0);
    let Ok(found) = diagnose(&mut &old[..], None, &[], &mut []) else { panic!("an answer") };
    assert_eq!(found.diagnosis.losses()[0].motor + 1, 3);
    let said: Vec<&str> = found.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert!(said.iter().any(|said| said.contains("a hexacopter, by its six outputs that move")), "{said:?}");
    assert!(!said.iter().any(|said| said.contains("lacks parameters")), "{said:?}");
}

/// The defaults of parameters that a log lacks are assumed, and said to be.
#[test]
fn missing_parameters_of_the_motors_are_named() {
    let mut bytes = log(Fault::Capacity(3, 12.0, 0.0), 20.0, 10.0, 25.0, 3);
    let name = b"MOT_THST_EXPO";
    let at = bytes.windows(name.len()).position(|window| window == name).unwrap();
    bytes[at..at + 3].copy_from_slice(b"OLD");
    let Ok(found) = diagnose(&mut &bytes[..], None, &[], &mut []) else { panic!("an answer") };
    assert_eq!(found.diagnosis.losses()[0].motor + 1, 3);
    let [warning] = &found.diagnostics[..] else { panic!("{:?}", found.diagnostics) };
    assert_eq!(warning.code, "mavc::log::assumed");
    assert!(warning.message.ends_with("ArduPilot's defaults: MOT_THST_EXPO = 0.65"), "{}", warning.message);
}

#[test]
fn the_answer_its_record_and_its_exit_codes() {
    let folder = tempfile::tempdir().unwrap();
    let named = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_string()
    };
    let lost = named("lost.bin", &log(Fault::Capacity(3, 12.0, 0.0), 20.0, 50.0, 100.0, 3));
    let ran = run(&["diagnose", &lost]);
    assert_eq!(ran.status.code(), Some(10));
    let text = String::from_utf8(ran.stdout).unwrap();
    assert!(text.starts_with("motor 3 lost at 17.0"), "{text}");
    assert!(text.lines().count() <= 25 && text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let record: Value = serde_json::from_slice(&run(&["diagnose", &lost, "--format", "json"]).stdout).unwrap();
    crate::schemas::schema("diagnose").assert_valid(&record);
    assert_eq!((&record["answer"], &record["losses"][0]["motor"]), (&"loss".into(), &3.into()));
    let why = record["why"].as_str().unwrap();
    let shown = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(why.starts_with("without motor 3") && shown.contains(why), "{why}");

    let good = named("good.bin", &log(Fault::None, 30.0, 50.0, 100.0, 3));
    assert_eq!(run(&["diagnose", &good]).status.code(), Some(0));
    let slow = run(&["diagnose", &named("slow.bin", &log(Fault::None, 30.0, 1.0, 1.0, 3))]);
    assert_eq!(slow.status.code(), Some(11));
    assert!(String::from_utf8(slow.stdout).unwrap().contains("LOG_BITMASK"));
    for (name, bytes) in [("empty.bin", &b""[..]), ("text.bin", b"no log"), ("bag.bin", b"#ROSBAG V2.0\n")] {
        let ran = run(&["diagnose", &named(name, bytes)]);
        assert_eq!(ran.status.code(), Some(1), "{name}");
        assert!(String::from_utf8(ran.stderr).unwrap().contains("mavc::log::format"), "{name}");
    }
    let ran = run(&["diagnose", &named("flight.mcap", b"\x89MCAP0\r\n\x01")]);
    let said = String::from_utf8(ran.stderr).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(ran.status.code() == Some(1) && said.contains("mavc simulate -o flight.ulg"), "{said}");
    // The arguments beside the log.
    let spec = named("v.mav", b"vehicle v { mass = ? }");
    let pointer = named("pointer.bin", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n");
    let motor = "write the number of a motor";
    for (arguments, code, words) in [
        (&["identify", &good, "--mass", "2.1"][..], 2, "mass 2.1: `mass` is a mass and needs a unit"),
        (&["diagnose", &spec, &good], 2, "the log comes first"),
        (&["diagnose", &good, "--baseline", &good, &spec], 2, "which comes before"),
        (&["diagnose", &good, "--hide", "first"], 2, motor),
        (&["diagnose", &good, "--hide", "0"], 2, motor),
        (&["diagnose", &good, &spec], 1, "without a spec, the frame follows from the log"),
        (&["diagnose", &pointer], 1, "git lfs pull"),
    ] {
        let ran = run(arguments);
        let said = String::from_utf8(ran.stderr).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(ran.status.code() == Some(code) && said.contains(words), "{arguments:?}: {said}");
    }
    let others = [4, 5].map(|seed| named(&format!("other{seed}.bin"), &log(Fault::None, 30.0, 50.0, 100.0, seed)));
    let compare = |log: &str, baseline: [&str; 2]| {
        let ran = run(&["diagnose", log, "--baseline", baseline[0], baseline[1]]);
        let said = [ran.stdout, ran.stderr].map(|text| String::from_utf8(text).unwrap()).join("\n");
        (ran.status.code(), said.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let (code, said) = compare(&good, [&others[0], &others[1]]);
    assert!(code == Some(0) && said.contains("change"), "{said}");
    // A motor that was weak before the flight is no loss in it.
    let weak = named("weak.bin", &log(Fault::Capacity(2, -1.0, 0.6), 30.0, 50.0, 100.0, 6));
    let (code, said) = compare(&weak, [&others[0], &others[1]]);
    assert!(code == Some(10) && said.starts_with("motor 2 gives less thrust than in the baseline flights"), "{said}");
    let record = run(&["diagnose", &weak, "--baseline", &others[0], &others[1], "--format", "json"]).stdout;
    let record: Value = serde_json::from_slice(&record).unwrap();
    crate::schemas::schema("diagnose").assert_valid(&record);
    assert_eq!((&record["answer"], record["losses"].as_array().unwrap().len()), (&"weaker".into(), 0));
    // Two logs in one file: the second is not read, so that nothing is said to be found.
    let both = [std::fs::read(&good).unwrap(), std::fs::read(&lost).unwrap()].concat();
    let ran = run(&["diagnose", &named("both.bin", &both)]);
    assert_eq!(ran.status.code(), Some(11));
    let said = String::from_utf8(ran.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("split the log where the autopilot was started"), "{said}");
    // What cannot be a baseline is named.
    let short = named("short.bin", &log(Fault::None, 3.0, 50.0, 100.0, 4));
    for (other, why) in [
        (&good, "the baseline is the log itself"),
        (&others[0], "the baseline names this flight twice"),
        (&lost, "the baseline is not of a good flight: motor 3 loses thrust at 17.0 s"),
        (&short, "the baseline has less than 8 s of quiet flight"),
    ] {
        let (code, said) = compare(&good, [&others[0], other]);
        let name = std::path::Path::new(other).file_name().unwrap().to_str().unwrap();
        assert!(code == Some(1) && said.contains(why) && said.contains(name), "{said}");
    }
    // Nothing is found in a flight that was not searched.
    let ran = run(&["diagnose", &short]);
    assert_eq!(ran.status.code(), Some(11));
    assert!(String::from_utf8(ran.stdout).unwrap().contains("too short to search the motion"));
}

/// A spec of another vehicle than the one that flew.
#[test]
fn a_spec_that_contradicts_the_log_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    std::fs::write(path("a.bin"), log(Fault::None, 20.0, 50.0, 100.0, 3)).unwrap();
    let spec = |rotors: &str| {
        format!(
            "vehicle hexa {{
    mass = 1.8 kg; inertia = [0.02, 0.02, 0.04] kg*m^2
    rotor {{ max_thrust = 8 N; torque_per_thrust = 16 mm; max_speed = 8000 rpm }}
    rotors {{
{rotors}    }}
}}
"
        )
    };
    let places = [(0, -1, 'N'), (0, 1, 'P'), (1, 1, 'N'), (-1, -1, 'P'), (1, -1, 'P'), (-1, 1, 'N')];
    let rotors = |turned: usize| -> String {
        let rotor = |(k, (x, y, spin)): (usize, &(i32, i32, char))| {
            let (x, y) = if x * y == 0 { (0.0, *y as f64 * 0.3) } else { (*x as f64 * 0.26, *y as f64 * 0.15) };
            let spin = if (k + 1 == turned) == (*spin == 'P') { 'N' } else { 'P' };
            format!("        rotor at [{x}, {y}, 0] m  spin {spin}  motor {}\n", k + 1)
        };
        places.iter().enumerate().map(rotor).collect()
    };
    for (turned, warned) in [(0, None), (4, Some("have motor 4 elsewhere than the spec, or turning the"))] {
        std::fs::write(path("v.mav"), spec(&rotors(turned))).unwrap();
        let ran = run(&["diagnose", &path("a.bin"), &path("v.mav")]);
        let said = String::from_utf8(ran.stderr).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(ran.status.code(), Some(0), "{said}");
        assert_eq!(said.contains("mavc::log::assumed"), warned.is_some(), "{said}");
        assert!(warned.is_none_or(|warned| said.contains(warned)), "{said}");
    }
}

/// One time that is far ahead, and one rate that no gyroscope measures, take nothing else with them.
#[test]
fn one_damaged_sample_is_left_out() {
    let whole = log(Fault::Capacity(3, 12.0, 0.0), 20.0, 50.0, 100.0, 3);
    let head = |at: &usize| whole[*at..*at + 3] == [0xa3, 0x95, 3];
    let gyroscope: Vec<usize> = (0..whole.len() - 3).filter(head).collect();
    for at in [gyroscope[200], *gyroscope.last().unwrap()] {
        let mut late = whole.clone();
        late[at + 9] |= 1;
        assert_eq!(losses(&late).first().map(|loss| loss.motor + 1), Some(3), "{at}");
    }
    let mut wild = whole.clone();
    wild[gyroscope[200] + 12..gyroscope[200] + 16].copy_from_slice(&1e30_f32.to_le_bytes());
    let Ok(found) = diagnose(&mut &wild[..], None, &[], &mut []) else { panic!("an answer") };
    assert_eq!(found.diagnosis.losses()[0].motor + 1, 3);
    // A pulse that no output has.
    let outputs: Vec<usize> = (0..whole.len() - 3).filter(|at| whole[*at..*at + 3] == [0xa3, 0x95, 2]).collect();
    let mut long = whole.clone();
    long[outputs[600] + 11..outputs[600] + 13].copy_from_slice(&u16::MAX.to_le_bytes());
    assert_eq!(losses(&long).first().map(|loss| loss.motor + 1), Some(3));
    assert!(
        found.diagnostics.iter().any(|d| d.message.contains("1 sample of the gyroscope")),
        "{:?}",
        found.diagnostics
    );
}

#[test]
fn the_page_draws_the_flight_without_a_script() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    for (fault, code, losses) in [(Fault::Capacity(3, 12.0, 0.0), 10, 1), (Fault::None, 0, 0)] {
        std::fs::write(path("a.bin"), log(fault, 20.0, 50.0, 100.0, 3)).unwrap();
        let ran = run(&["diagnose", &path("a.bin"), "--html", &path("page.html")]);
        assert_eq!(ran.status.code(), Some(code));
        let page = std::fs::read_to_string(path("page.html")).unwrap();
        let text = String::from_utf8(ran.stdout).unwrap();
        assert!(page.contains(text.lines().next().unwrap()), "the page has the answer");
        // Commands and rates of the flight, thrust; commands and rates around a loss, and two sections.
        assert_eq!(page.matches("<svg").count(), 3 + 4 * losses);
        assert_eq!(page.matches("<polygon").count(), 6 + 2 * losses);
        for shape in ["path", "polygon", "circle", "rect"] {
            let closed = format!("</{shape}>");
            assert_eq!(page.matches(&format!("<{shape} ")).count(), page.matches(&closed).count(), "{shape}");
        }
        for odd in ["<script", "http:", "https:", "NaN", "inf ", "infM", "inf,"] {
            assert!(!page.contains(odd), "{odd}");
        }
    }
    let again = run(&["diagnose", &path("a.bin"), "--html", &path("a.bin")]);
    assert_eq!(again.status.code(), Some(2), "the log is not replaced");
}

#[test]
fn a_spec_is_identified_and_has_the_thrust_that_flew() {
    let bytes = log(Fault::None, 30.0, 50.0, 100.0, 3);
    let Ok(found) = identify(&mut &bytes[..], "2 kg") else { panic!("a spec") };
    let line = found.text.lines().find(|line| line.trim().starts_with("max_thrust")).unwrap();
    let newton: f64 = line.split('=').nth(1).unwrap().trim().split(' ').next().unwrap().parse().unwrap();
    let truth = 2.0 * 9.81 / (6.0 * 0.4);
    assert!((newton / truth - 1.0).abs() < 0.03, "{line}: {truth}");
    let checked = mavc::compile(&found.text);
    let others: Vec<_> = checked.diagnostics.iter().filter(|d| d.code != "mavc::value::unknown").collect();
    assert!(others.iter().all(|d| d.severity != mavc::Severity::Error), "{others:?}\n{}", found.text);
}

/// Steps in calm air show the inertia by its ratio to the arm, a hover in gusts does not.
#[test]
fn a_flight_of_quick_steps_shows_the_inertia() {
    let remark = |fault: Fault| {
        let bytes = log(fault, 60.0, 100.0, 100.0, 3);
        let Ok(found) = identify(&mut &bytes[..], "2 kg") else { panic!("a spec") };
        found.figures.into_iter().find(|figure| figure.field == "vehicle.inertia").unwrap().remark
    };
    assert!(remark(Fault::None).contains("fly quick steps of roll and pitch"));
    let said = remark(Fault::Steps);
    // Full thrust and the mean lever of a hexacopter in arms; `flying` turns with 50 rad/s^2 for each unit of lever.
    let thrust = 2.0 * 9.81 / (6.0 * 0.4);
    let words: Vec<f64> = said.split(' ').filter_map(|word| word.parse().ok()).collect();
    let [low, high] = words[..] else { panic!("{said}") };
    let truth = thrust / 50.0;
    assert!(low < truth && truth < high && high < 1.15 * low, "{said}: {truth}");
}

/// A simulated flight begins in the air, so its first height is not the ground: the loss is found although the vehicle is
/// never half a metre higher before it.
#[test]
fn a_loss_is_found_in_a_log_that_begins_in_the_air() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let spec = "vehicle octo {
    layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 0.016 m; max_speed = 874 rad/s }
}
faults { mode M1 { rotor 1 lost } }
mission short { start at [0, 0, 2] m; waypoint at [40, 0, 3] m }
plan { planner = rsp; model = hover; samples = 60; time = 20 s }
simulate { fault M1 at 10 s }
";
    std::fs::write(path("v.mav"), spec).unwrap();
    let flown = run(&["simulate", &path("v.mav"), "-o", &path("f.ulg"), "--format", "ulog", "--rate", "100Hz"]);
    assert_eq!(flown.status.code(), Some(0), "{}", String::from_utf8_lossy(&flown.stderr));
    let ran = run(&["diagnose", &path("f.ulg"), &path("v.mav"), "--format", "json"]);
    let record: Value = serde_json::from_slice(&ran.stdout).unwrap();
    assert!(record["flights"][0]["from_s"].as_f64().unwrap() < 0.5, "{record}");
    let loss = &record["losses"][0];
    assert!(loss["motor"] == 1 && (loss["time_s"].as_f64().unwrap() - 10.0).abs() < 0.5, "{record}");
}

#[test]
fn damaged_logs_end_in_an_answer_or_a_diagnostic() {
    // Short, and found: what is damaged would be answered.
    let whole = log(Fault::Capacity(3, 4.0, 0.0), 7.0, 10.0, 25.0, 3);
    assert_eq!(losses(&whole).first().map(|loss| loss.motor + 1), Some(3));
    let mut noise = Noise(11);
    for _ in 0..40 {
        let mut bytes = whole.clone();
        bytes.truncate((noise.uniform() * whole.len() as f64) as usize);
        for _ in 0..(noise.uniform() * 40.0) as usize {
            let at = (noise.uniform() * bytes.len() as f64) as usize;
            if let Some(byte) = bytes.get_mut(at) {
                *byte = (noise.uniform() * 256.0) as u8;
            }
        }
        if let Err(Undiagnosed { why: Why::Not(found), .. }) = diagnose(&mut &bytes[..], None, &[], &mut []) {
            assert!(!found.is_empty());
        }
    }
}

#[test]
fn the_readers_of_ulog_survive_every_byte() {
    let mut bytes = b"ULog\x01\x12\x35\x01\0\0\0\0\0\0\0\0".to_vec();
    let mut add = |kind: u8, body: &[u8]| {
        bytes.extend((body.len() as u16).to_le_bytes());
        bytes.push(kind);
        bytes.extend(body);
    };
    add(b'B', &[0; 40]);
    add(
        b'F',
        b"sensor_combined:uint64_t timestamp;float[3] gyro_rad;float[3] accelerometer_m_s2;uint8_t[4] _padding0;",
    );
    add(b'F', b"loop:loop[9] a;");
    add(b'A', b"\0\0\0sensor_combined");
    add(b'A', b"\0\x01\0loop");
    add(b'P', b"\x0ffloat MPC_X_Y_Zabcd");
    for i in 0..50_u64 {
        let mut body = vec![0, 0];
        body.extend((i * 4000).to_le_bytes());
        body.extend([0_u8; 24]);
        add(b'D', &body);
    }
    let Ok(read) = mavc::log::read(&mut &bytes[..]) else { panic!("a log") };
    assert_eq!(read.record.rates.len(), 50);
    let mut noise = Noise(5);
    for at in 0..bytes.len() {
        let mut other = bytes.clone();
        other[at] = (noise.uniform() * 256.0) as u8;
        let _ = mavc::log::read(&mut &other[..]);
        let _ = mavc::log::read(&mut &bytes[..at]);
    }
}
