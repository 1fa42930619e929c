//! `mavc plan --certificate` and `mavc verify` as scripts use them.

use super::Numbers;
use std::path::Path;
use std::process::{Command, Output};

const SPEC: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }
}
faults { every 1 rotor lost as M }
mission turn {
    start at [0, 0, 2] m  yaw 0 deg
    waypoint at [3, 1, 3] m  yaw 40 deg
    hold 1 s
    waypoint at [5, 0, 2] m  yaw 90 deg
    limits {
        speed <= 3 m/s
        jerk  <= 30 m/s^3
        yaw_rate <= 60 deg/s
    }
}
plan { planner = rsp; against = [M1, M2]; time = 9 s; samples = 40 }
"#;

fn mavc(args: &[&str]) -> Output {
    let run = Command::new(env!("CARGO_BIN_EXE_mavc")).args(args).env("NO_COLOR", "1").env("COLUMNS", "200").output();
    run.unwrap()
}

fn code(ran: &Output) -> i32 {
    ran.status.code().unwrap()
}

fn said(ran: &Output) -> String {
    String::from_utf8(ran.stderr.clone()).unwrap()
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new(spec: &str) -> Folder {
        let folder = Folder(tempfile::tempdir().unwrap());
        std::fs::write(folder.spec(), spec).unwrap();
        folder
    }

    fn at(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().into()
    }

    fn spec(&self) -> String {
        self.at("spec.mav")
    }
}

#[test]
fn a_plan_is_certified_and_verified() {
    let folder = Folder::new(SPEC);
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    let ran = mavc(&["plan", "-v", &spec, "--quiet", "--certificate", &proof]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    let ran = mavc(&["verify", &proof, &spec]);
    let told = String::from_utf8(ran.stdout.clone()).unwrap();
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    assert!(told.contains("limit on jerk") && told.contains("inside the set of healthy"), "{told}");
    assert!(told.contains("proved at every instant"), "{told}");
    let flat = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        flat.ends_with(
            "accepted: the motion of 9 s is a plan of mission turn by RSP, for the facets selected by the included RIP plan"
        ),
        "{told}"
    );
    // The same bytes again.
    let text = std::fs::read(&proof).unwrap();
    assert_eq!(code(&mavc(&["plan", "-v", &spec, "--quiet", "--certificate", &proof])), 0);
    assert_eq!(std::fs::read(&proof).unwrap(), text);

    // Another spec, by an override or by its text.
    let other = mavc(&["verify", &proof, &spec, "--set", "vehicle.mass=2kg"]);
    assert_eq!(code(&other), 5);
    // Both hashes are named, and what is shown is the certificate's.
    let value: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let message = said(&other);
    let told = format!("written for another spec: {}, but this one is ", &value["spec_sha256"].as_str().unwrap()[..12]);
    assert!(message.contains(&told), "{message}");
    assert!(message.contains("cert.json:") && !message.contains("spec.mav"), "{message}");

    // A false number: the message says what does not hold, and when.
    let mut value: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let speed = &mut value["claim"]["plan"]["motion"]["x"][10][1];
    *speed = serde_json::json!(speed.as_f64().unwrap() + 0.5);
    std::fs::write(&proof, value.to_string()).unwrap();
    let false_claim = mavc(&["verify", &proof, &spec]);
    assert_eq!(code(&false_claim), 5);
    let message = said(&false_claim);
    for part in [
        "mavc::verify::rejected",
        "the joints of the motion at ",
        "and the next is 0.5 m/s in velocity",
        "at most 1e-5 m/s is allowed",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    // A start that moves points to the statement of the spec.
    let mut value: serde_json::Value = serde_json::from_slice(&text).unwrap();
    for node in value["claim"]["plan"]["motion"]["x"].as_array_mut().unwrap() {
        node[0] = serde_json::json!(node[0].as_f64().unwrap() + 0.2);
    }
    std::fs::write(&proof, value.to_string()).unwrap();
    let message = said(&mavc(&["verify", &proof, &spec]));
    for part in ["waypoint 1 at 0 s: its position is missed by", "m is allowed", "start at [0, 0, 2] m"] {
        assert!(message.contains(part), "{part}: {message}");
    }
}

/// Work is estimated before it begins, and the budget is what the message says.
#[test]
fn what_costs_too_much_is_refused() {
    let folder = Folder::new(SPEC);
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["plan", "-v", &spec, "--quiet", "--certificate", &proof])), 0);
    for budget in ["0.0001s", "1s,0.001MB", "0.0000001GB"] {
        let ran = mavc(&["verify", &proof, &spec, "--budget", budget]);
        assert_eq!(code(&ran), 8, "{budget}: {}", said(&ran));
        let message = said(&ran);
        assert!(
            message.contains("mavc::verify::too_costly") && message.contains("allow more with `--budget "),
            "{message}"
        );
        assert!(ran.stdout.is_empty());
    }
    let message = said(&mavc(&["verify", &proof, &spec, "--budget", "0.0001s"]));
    let (_, after) = message.split_once("`--budget ").unwrap();
    let enough = after.split_once('`').unwrap().0;
    assert_eq!(code(&mavc(&["verify", &proof, &spec, "--budget", enough])), 0, "{enough}");
    for wrong in ["", "10", "s", "-1s", "nans", "infs", "10s,,", "10kB"] {
        assert_eq!(code(&mavc(&["verify", &proof, &spec, "--budget", wrong])), 2, "{wrong}");
    }
}

#[test]
fn a_mission_without_a_plan_is_certified() {
    let spec = SPEC
        .replace("yaw 40 deg", "")
        .replace("yaw 90 deg", "")
        .replace("time = 9 s", "time = 4 s; timing = proportional");
    let folder = Folder::new(&spec);
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(
        code(&mavc(&[
            "plan",
            &spec,
            "--quiet",
            "--set",
            "plan.planner=rip",
            "--set",
            "plan.model=hover",
            "--certificate",
            &proof
        ])),
        3
    );
    let ran = mavc(&["verify", &proof, &spec, "--set", "plan.planner=rip", "--set", "plan.model=hover"]);
    // What is about one grid alone is weaker than what the spec asks.
    assert_eq!(code(&ran), 7, "{}", said(&ran));
    let told = String::from_utf8(ran.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        told.contains(
            "accepted, weaker than the spec requires: proved infeasible on one grid: mission turn has no RIP plan of 4 s"
        ),
        "{told}"
    );
    assert!(
        told.contains("- one grid: motions whose nodes differ from those of 40 samples are not excluded"),
        "{told}"
    );
}

#[test]
fn files_and_usage() {
    let folder = Folder::new(SPEC);
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["verify", &proof, &spec])), 2);
    assert_eq!(code(&mavc(&["verify", "-", "-"])), 2);
    assert_eq!(code(&mavc(&["plan", "-v", &spec, "-o", &proof, "--certificate", &proof])), 2);
    assert_eq!(code(&mavc(&["plan", "-v", &spec, "--certificate", &spec])), 2);
    std::fs::write(&proof, "{}").unwrap();
    assert_eq!(code(&mavc(&["verify", &proof, &folder.at("cert.json")])), 1);
    assert!(!Path::new(&folder.at("none")).exists());
}

/// Files that are not certificates are reported as such and never cause a panic.
#[test]
fn what_is_not_a_certificate_is_reported() {
    let folder = Folder::new(SPEC);
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/certificates");
    let mut seen = 0;
    for entry in std::fs::read_dir(corpus).unwrap() {
        let path = entry.unwrap().path();
        let ran = mavc(&["verify", path.to_str().unwrap(), &folder.spec()]);
        assert_eq!(code(&ran), 5, "{}: {}", path.display(), said(&ran));
        assert!(said(&ran).contains("mavc::verify::malformed"), "{}: {}", path.display(), said(&ran));
        seen += 1;
    }
    assert!(seen >= 5);
}

/// The excerpt is the certificate's, at the place that breaks it, and the words are about it alone.
#[test]
fn what_breaks_a_certificate_is_shown_in_it() {
    let folder = Folder::new(SPEC);
    let proof = folder.at("cert.json");
    for (text, told, label) in [
        ("{\n  \"schema\": 1,\n", "the file is cut off", "the file ends in a value"),
        ("{ \"claim\": { \"plan\": { \"motion\": {", "the file is cut off", "the file ends in"),
        (" \n", "it is empty", ""),
        ("t,x,y\n0,1,2\n", "it is not JSON", "expected ident"),
        (
            "\u{feff}{\n  \"schema\": 2,\n  \"sets\": []\n}",
            "it is not the JSON of a certificate",
            "unknown field `sets`",
        ),
        ("{ \"schema\": 1, \"sets\": [] }", "its format has another version", "schema 1, but this program reads 2"),
        ("[]", "it is not the JSON of a certificate", "expected a certificate"),
    ] {
        std::fs::write(&proof, text).unwrap();
        let ran = mavc(&["verify", &proof, &folder.spec()]);
        let message = said(&ran);
        assert_eq!(code(&ran), 5, "{message}");
        assert!(
            message.contains(&format!("cannot read this certificate: {told}")) && message.contains(label),
            "{message}"
        );
        assert!(message.contains("cert.json") && !message.contains("spec.mav"), "{message}");
    }
    // Of a line as long as the file the place is shown with a little on both sides.
    let long = "0123456789".repeat(300);
    let text = format!("{{\"schema\":1,\"spec_sha256\":\"{long}\",\"model\":oops,\"claim\":\"{long}\"}}");
    std::fs::write(&proof, text).unwrap();
    let message = said(&mavc(&["verify", &proof, &folder.spec()]));
    assert!(message.contains("it is not JSON") && message.contains("\"model\":oops"), "{message}");
    assert!(message.lines().all(|line| line.chars().count() < 160), "{message}");
    std::fs::write(&proof, b"{ \"schema\": \xff").unwrap();
    let message = said(&mavc(&["verify", &proof, &folder.spec()]));
    assert!(message.contains("it is not text") && message.contains("not UTF-8 from here on"), "{message}");
}

/// The spec given as the certificate.
#[test]
fn the_wrong_order_is_noticed() {
    let folder = Folder::new(&SPEC.replace("planner = rsp", "model = hover; planner = rsp"));
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["plan", "-v", &spec, "--quiet", "--certificate", &proof])), 0);
    let ran = mavc(&["verify", &spec, &proof]);
    assert_eq!(code(&ran), 2);
    assert!(said(&ran).contains("is a certificate; give the certificate first, then its spec"), "{}", said(&ran));
}

/// Lists that promise more than is read end at their bound, before memory is spent on them.
#[test]
fn endless_lists_are_refused_while_they_are_read() {
    let folder = Folder::new(SPEC);
    let proof = folder.at("cert.json");
    let many = |entry: &str, count: usize| vec![entry; count].join(",");
    let head = format!("{{\"schema\":2,\"spec_sha256\":\"{}\",\"model\":\"exact\",\"claim\":", "0".repeat(64));
    for (claim, told) in [
        (format!("{{\"plan\":{{\"motion\":{{\"times_s\":[{}", many("0", 130_000)), "more than 23001 entries"),
        (format!("{{\"plan\":{{\"motion\":{{\"z\":[{}", many("[]", 10)), "three derivatives of z"),
        (format!("{{\"plan\":{{\"motion\":{{\"x\":[{}", many("[]", 10)), "invalid length 0"),
        (format!("{{\"infeasible\":{{\"multipliers\":[{{\"z\":[{}", many("1", 9)), "more than 4 entries"),
        (format!("{{\"infeasible\":{{\"facets\":[{{\"rotors\":[{}", many("1", 9)), "more than 3 entries"),
    ] {
        std::fs::write(&proof, format!("{head}{claim}")).unwrap();
        let ran = mavc(&["verify", &proof, &folder.spec()]);
        assert_eq!(code(&ran), 5, "{}", said(&ran));
        assert!(said(&ran).contains(told), "{told}: {}", said(&ran));
    }
}

/// Bytes of a certificate changed at random: a verdict, never a panic.
#[test]
fn hostile_bytes_end_in_a_verdict() {
    let model = super::hop(mavc::model::PlannerKind::Rip, 8.0);
    let certificate = super::certified(&model).unwrap();
    let text = serde_json::to_vec(&certificate).unwrap();
    let mut numbers = Numbers(11);
    for _ in 0..400 {
        let mut bytes = text.clone();
        for _ in 0..=numbers.below(4) {
            let at = numbers.below(bytes.len());
            match numbers.below(4) {
                0 => bytes[at] = b"0123456789-eE+.,[]{}\"nul"[numbers.below(24)],
                1 => bytes.truncate(at),
                2 => bytes.insert(at, b"0123456789-e"[numbers.below(12)]),
                _ => {
                    let end = (at + numbers.below(200)).min(bytes.len());
                    bytes.drain(at..end);
                }
            }
            if bytes.is_empty() {
                break;
            }
        }
        let _ = super::verify(&bytes, &model, super::SHA);
    }
    for extreme in ["1e308", "-1e308", "1e-320", "0", "18446744073709551615", "1e400"] {
        for at in [100, 500, 1_500, 3_000] {
            let mut changed = String::from_utf8(text.clone()).unwrap();
            let begin = changed[at..].find(',').unwrap() + at + 1;
            let end = begin + changed[begin..].find([',', ']', '}']).unwrap();
            changed.replace_range(begin..end, extreme);
            let verdict = super::verify(changed.as_bytes(), &model, super::SHA);
            // What is nearly nothing may stand where nearly nothing stood.
            assert!(verdict.is_err() || ["1e-320", "0"].contains(&extreme), "{extreme} at {at}");
        }
    }
}
