//! `mavc diagnose` and `mavc identify`: logs of simulated flights with known faults, and damaged logs.

mod flying;
mod own;

use flying::{Fault, Noise, log};
use mavc::diagnosis::study::{Evidence, Kind, Loss};
use mavc::pipeline::{Undiagnosed, diagnose, identify};
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
    assert!(why.starts_with("why: without motor 3") && shown.contains(why), "{why}");

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
    let baseline = named("other.bin", &log(Fault::None, 30.0, 50.0, 100.0, 4));
    let compared = run(&["diagnose", &good, "--baseline", &baseline, &baseline]);
    assert!(String::from_utf8(compared.stdout).unwrap().contains("change"));
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
        if let Err(Undiagnosed::Not(found)) = diagnose(&mut &bytes[..], None, &[], &mut []) {
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
