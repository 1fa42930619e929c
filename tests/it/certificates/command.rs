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
    let ran = mavc(&["plan", &spec, "--quiet", "--certificate", &proof]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    let ran = mavc(&["verify", &proof, &spec]);
    let told = String::from_utf8(ran.stdout.clone()).unwrap();
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    assert!(told.contains("limit on jerk") && told.contains("inside the set of healthy"), "{told}");
    assert!(told.contains("proved for every instant") && told.ends_with("every claim holds\n"), "{told}");
    // The same bytes again.
    let text = std::fs::read(&proof).unwrap();
    assert_eq!(code(&mavc(&["plan", &spec, "--quiet", "--certificate", &proof])), 0);
    assert_eq!(std::fs::read(&proof).unwrap(), text);

    // Another spec, by an override or by its text.
    let other = mavc(&["verify", &proof, &spec, "--set", "vehicle.mass=2kg"]);
    assert_eq!(code(&other), 5);
    // Both hashes are named, and what is shown is the certificate's.
    let value: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let message = said(&other);
    let told = format!("written for another spec: {}, and this one is ", &value["spec_sha256"].as_str().unwrap()[..12]);
    assert!(message.contains(&told), "{message}");
    assert!(message.contains("cert.json:") && !message.contains("spec.mav"), "{message}");

    // A false number: the message says which claim, where, and points to the statement.
    let mut value: serde_json::Value = serde_json::from_slice(&text).unwrap();
    value["claim"]["plan"]["limits"][0]["bounds"][0]["excess"] = serde_json::json!(-4.0);
    std::fs::write(&proof, value.to_string()).unwrap();
    let false_claim = mavc(&["verify", &proof, &spec]);
    assert_eq!(code(&false_claim), 5);
    let message = said(&false_claim);
    for part in ["mavc::verify::rejected", "limit 1 (speed) at ", "claimed: kept with 4 m/s to spare", "speed <= 3 m/s"]
    {
        assert!(message.contains(part), "{part}: {message}");
    }
}

/// What a certificate does not claim is no lie, but the reader is told of it.
#[test]
fn modes_of_which_nothing_is_claimed_are_named() {
    let folder = Folder::new(&SPEC.replace("time = 9 s", "time = 5 s"));
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["plan", &spec, "--quiet", "--certificate", &proof])), 0);
    let verified = || {
        let ran = mavc(&["verify", &proof, &spec]);
        assert_eq!(code(&ran), 0, "{}", said(&ran));
        String::from_utf8(ran.stdout).unwrap()
    };
    let whole = verified();
    assert!(whole.contains("facets of M1 kept") && whole.contains("facets of M2 kept"), "{whole}");
    // As many as RSP guards.
    let guards = |text: &str, before: &str| -> usize {
        let (_, after) = text.split_once(before).unwrap_or_else(|| panic!("{before}: {text}"));
        after.split_once(' ').unwrap().0.parse().unwrap()
    };
    let planned = String::from_utf8(mavc(&["plan", &spec]).stdout).unwrap();
    let (claimed, guarded) = (guards(&whole, "Claimed of the fault sets: "), guards(&planned, "RSP guards "));
    assert_eq!(claimed, guarded, "{whole}{planned}");
    let without = |modes: &[&str]| {
        let mut value: serde_json::Value = serde_json::from_slice(&std::fs::read(&proof).unwrap()).unwrap();
        let facets = value["claim"]["plan"]["facets"].as_array_mut().unwrap();
        facets.retain(|facet| !modes.contains(&facet["facet"]["mode"].as_str().unwrap()));
        std::fs::write(&proof, value.to_string()).unwrap();
    };
    without(&["M1"]);
    let fewer = verified();
    assert!(fewer.contains(" of M2, none of M1. Whether RSP guards more is not claimed"), "{fewer}");
    assert!(guards(&fewer, "Claimed of the fault sets: ") < claimed && fewer.contains("of M2 kept"), "{fewer}");
    without(&["M1", "M2"]);
    assert!(verified().contains("Claimed of the fault sets: 0 facets, none of M1, M2."));
    // Under RCP whole sets are claimed.
    let ran = mavc(&["plan", &spec, "--set", "plan.planner=rcp", "--set", "plan.time=9s", "--certificate", &proof]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    let ran = mavc(&["verify", &proof, &spec, "--set", "plan.planner=rcp", "--set", "plan.time=9s"]);
    let told = String::from_utf8(ran.stdout).unwrap();
    assert!(told.contains("inside the set of M1") && !told.contains("Claimed of the fault sets"), "{told}");
}

#[test]
fn a_mission_without_a_plan_is_certified() {
    let spec = SPEC.replace("yaw 40 deg", "").replace("yaw 90 deg", "").replace("time = 9 s", "time = 4 s");
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
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    assert!(String::from_utf8(ran.stdout).unwrap().contains("no plan of 4 s"));
}

#[test]
fn files_and_usage() {
    let folder = Folder::new(SPEC);
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["verify", &proof, &spec])), 2);
    assert_eq!(code(&mavc(&["verify", "-", "-"])), 2);
    assert_eq!(code(&mavc(&["plan", &spec, "-o", &proof, "--certificate", &proof])), 2);
    assert_eq!(code(&mavc(&["plan", &spec, "--certificate", &spec])), 2);
    std::fs::write(&proof, "{}").unwrap();
    assert_eq!(code(&mavc(&["verify", &proof, &folder.at("cert.json")])), 1);
    assert!(!Path::new(&folder.at("none")).exists());
}

/// Files that are no certificates: told so, never a panic.
#[test]
fn what_is_no_certificate_is_told() {
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
        ("{\n  \"schema\": 1,\n", "it ends too early", "the file ends in a value"),
        ("{ \"claim\": { \"plan\": { \"sets\": [", "it ends too early", "the file ends in"),
        (" \n", "it is empty", ""),
        ("t,x,y\n0,1,2\n", "it is no JSON", "expected ident"),
        ("\u{feff}{\n  \"schema\": 1,\n  \"sets\": []\n}", "it is JSON of another kind", "unknown field `sets`"),
        ("[]", "it is JSON of another kind", "expected a certificate"),
    ] {
        std::fs::write(&proof, text).unwrap();
        let ran = mavc(&["verify", &proof, &folder.spec()]);
        let message = said(&ran);
        assert_eq!(code(&ran), 5, "{message}");
        assert!(message.contains(&format!("this is no certificate: {told}")) && message.contains(label), "{message}");
        assert!(message.contains("cert.json") && !message.contains("spec.mav"), "{message}");
    }
    // Of a line as long as the file the place is shown with a little on both sides.
    let long = "0123456789".repeat(300);
    let text = format!("{{\"schema\":1,\"spec_sha256\":\"{long}\",\"model\":oops,\"claim\":\"{long}\"}}");
    std::fs::write(&proof, text).unwrap();
    let message = said(&mavc(&["verify", &proof, &folder.spec()]));
    assert!(message.contains("it is no JSON") && message.contains("\"model\":oops"), "{message}");
    assert!(message.lines().all(|line| line.chars().count() < 160), "{message}");
    std::fs::write(&proof, b"{ \"schema\": \xff").unwrap();
    let message = said(&mavc(&["verify", &proof, &folder.spec()]));
    assert!(message.contains("it is no text") && message.contains("no UTF-8 from here on"), "{message}");
}

/// Claims of the plan changed by hand: numbers below zero are said as room to spare.
#[test]
fn false_claims_read_as_what_they_say() {
    let folder = Folder::new(&SPEC.replace("planner = rsp", "model = hover; planner = rsp"));
    let (spec, proof) = (folder.spec(), folder.at("cert.json"));
    assert_eq!(code(&mavc(&["plan", &spec, "--quiet", "--certificate", &proof])), 0);
    let text = std::fs::read_to_string(&proof).unwrap();
    let whole: serde_json::Value = serde_json::from_str(&text).unwrap();
    let plan = "/claim/plan";
    for (place, value, told) in [
        ("position_excess_m", serde_json::json!(-0.3), "m to spare; claimed: met with 0.3 m to spare"),
        ("yaw_excess_rad", serde_json::json!(-1), "rad to spare; claimed: met with 1 rad to spare"),
        ("joins_within", serde_json::json!(-1), "joins_within: -1 (m or rad) is below zero"),
        ("limits/0/bounds", serde_json::json!([]), "limit 1 (speed): no bound is claimed"),
        (
            "limits/0/bounds",
            serde_json::json!([{ "scope": "nodes", "excess": 5 }]),
            "the claim lets it be passed by 5 m/s, and more than",
        ),
        (
            "sets/0/bounds/0/excess",
            serde_json::json!(-1),
            "claimed: kept with 100 % to spare (of the healthy set's width)",
        ),
    ] {
        let mut changed = whole.clone();
        *changed.pointer_mut(&format!("{plan}/{place}")).unwrap() = value;
        std::fs::write(&proof, changed.to_string()).unwrap();
        let ran = mavc(&["verify", &proof, &spec]);
        assert_eq!(code(&ran), 5, "{place}: {}", said(&ran));
        assert!(said(&ran).contains(told), "{place}: {}", said(&ran));
    }
    // Given in the wrong order.
    std::fs::write(&proof, text).unwrap();
    let ran = mavc(&["verify", &spec, &proof]);
    assert_eq!(code(&ran), 2);
    assert!(said(&ran).contains("is a certificate; give the certificate first, then its spec"), "{}", said(&ran));
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
        for at in [100, 1_000, 5_000, 20_000] {
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
