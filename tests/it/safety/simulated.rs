//! Ways out whose simulated flight failed, and those that the certificate proves.

use super::{Files, assess, close, enumerated, json, read, rows, unwrapped, write, written};
use crate::cli::mavc_in;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::sync::OnceLock;

/// A vehicle beside its landing site, for which nearly every way out is proved between the instants too.
const PROVED: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 21 cm
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.5 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults { mode M1 { rotors [1] lost; rate = 1e-5 1/h }; mode M2 { rotors [2, 3, 4] lost; rate = 1e-7 1/h } }
mission hop {
    ground = 0 m
    start at [0, 0, 4] m
    waypoint at [8, 0, 5] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [4, 4, 0] m; radius = 1.5 m }
}
plan {
    model = hover
    planner = rip
    against = [M1]
    time = 6 s
    samples = 30
    recovery { order = [land_at_sites]; detection = 200 ms; within = 15 s }
}
"#;

/// A folder with this spec, and what the command makes of it in `out`.
fn proved() -> tempfile::TempDir {
    static FILES: OnceLock<Files> = OnceLock::new();
    written(FILES.get_or_init(|| assess("hop.mav", PROVED).1))
}

/// A flight that failed takes the time to the instants around it from the cover, in every file, also where the rotors
/// are proved to be able to fly it.
#[test]
fn a_way_out_whose_simulated_flight_failed_is_no_cover() {
    let folder = proved();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let mut report = json(&out, "report.json");
    let recovery = &mut report["recovery"];
    let survived = recovery["survived"].as_u64().unwrap();
    assert_eq!(survived, recovery["flown"].as_u64().unwrap());
    let mode = &mut recovery["modes"][0];
    assert_eq!(mode["name"], "M1");
    let long = |piece: &&mut Value| piece["branches"].as_array().unwrap().len() > 4;
    let piece = mode["pieces"].as_array_mut().unwrap().iter_mut().find(long).unwrap();
    let struck = |k: usize| -> f64 {
        let name = piece["branches"][k].as_str().unwrap().strip_prefix("M1_").unwrap();
        name.split_once('s').unwrap().0.parse().unwrap()
    };
    let seconds = struck(4) - struck(1);
    let of =
        |k: usize| serde_json::json!({"branch": piece["branches"][k], "from_s": struck(k - 1), "to_s": struck(k + 1)});
    let failed = [of(2), of(3)];
    let names: Vec<String> = failed.iter().map(|flight| flight["branch"].as_str().unwrap().to_string()).collect();
    piece["failed"] = Value::from(failed.to_vec());
    let assess = |report: &Value, name: &str| {
        write(folder, "failed.json", &report.to_string());
        let args = ["--report", "failed.json", "--certificate", "out/certificate.json"];
        mavc_in(folder, &[&["safety", "hop.mav", "-o", name], &args[..]].concat())
    };
    let (code, _, errors) = assess(&report, "miscounted");
    assert!(code == 2 && errors.contains("it does not name every simulated flight that failed"), "{errors}");
    report["recovery"]["survived"] = Value::from(survived - 2);
    // A failed flight that counts for less than the time to the instants around it.
    let mut shorter = report.clone();
    let pieces = shorter["recovery"]["modes"][0]["pieces"].as_array_mut().unwrap();
    let piece = pieces.iter_mut().find(|piece| !piece["failed"].as_array().is_none_or(Vec::is_empty)).unwrap();
    let from = &mut piece["failed"][0]["from_s"];
    *from = Value::from(from.as_f64().unwrap() + 0.1);
    let (code, _, errors) = assess(&shorter, "shorter");
    assert!(code == 2 && errors.contains("does not count for the time around it"), "{errors}");
    let (code, text, errors) = assess(&report, "failed");
    assert_eq!(code, 0, "{text}{errors}");
    assert!(text.contains("if ways out whose simulated flight failed covered their time: "), "{text}");

    let (before, after) = (json(&out, "quantities.json"), json(&folder.join("failed"), "quantities.json"));
    let of_mode = |quantities: &Value, member: &str| quantities["modes"][0][member].as_f64().unwrap();
    assert!((of_mode(&after, "failed_flights_s") - seconds).abs() < 1e-9);
    let more = of_mode(&after, "uncovered_s") - of_mode(&before, "uncovered_s");
    let less = of_mode(&before, "proved_s") - of_mode(&after, "proved_s");
    assert!((more - seconds).abs() < 1e-9 && (less - seconds).abs() < 1e-9, "{more} {less} {seconds}");
    let p = |quantities: &Value, member: &str| quantities["loss_of_control"][member].as_f64();
    let member = "per_mission_if_failed_flights_were_covered";
    assert_eq!(p(&before, member), None);
    assert_eq!(p(&after, member), p(&before, "per_mission"));
    assert!(p(&after, "per_mission") > p(&after, member));
    let (probability, _) = enumerated(&read(&folder.join("failed"), "faulttree.xml"));
    assert!(close(p(&after, "per_mission").unwrap(), probability));

    let sheet = rows(&read(&folder.join("failed"), "fmea.csv"));
    let rows_of = |is_failed: bool| {
        let basis = "found at an instant, but its simulated flight failed";
        sheet.iter().filter(move |row| row["mode"] == "M1" && (row["basis"] == basis) == is_failed)
    };
    let exposed: f64 = rows_of(true).map(|row| row["exposure_s"].parse::<f64>().unwrap()).sum();
    assert!((exposed - seconds).abs() < 1e-9, "{exposed}");
    let provisions =
        |is_failed: bool| rows_of(is_failed).map(|row| row["provision"].clone()).collect::<Vec<_>>().join(" ");
    assert_eq!(provisions(true), names.join(" "));
    assert!(names.iter().all(|name| !provisions(false).contains(name)));
    let argument = read(&folder.join("failed"), "argument.json");
    assert!(argument.contains(&format!("{seconds:.2} s of it because simulated flights failed")), "{argument}");
    let flights = &after["flights"];
    assert!(flights["failed"] == 2 && flights["failed_where_a_way_out_is_proved"] == 2, "{flights}");
    let flown = &flights["flown"];
    let counted = format!("2 of {flown} simulated flights failed, 2 of them where the certificate proves a way out");
    assert!(
        unwrapped(&text).contains(&counted) && read(&folder.join("failed"), "index.html").contains(&counted),
        "{text}"
    );
}

#[test]
fn the_argument_uses_ways_out_that_the_certificate_proves() {
    let folder = proved();
    let out = folder.path().join("out");
    let proved = json(&out, "quantities.json")["modes"][0]["proved_s"].as_f64().unwrap();
    assert!(proved > 0.9 * 6.0, "{proved}");
    // The report counts what its search proved; the certificate decides.
    let reported = json(&out, "report.json")["recovery"]["modes"][0]["proved_s"].as_f64().unwrap();
    assert!((proved - reported).abs() < 1e-9, "{proved} {reported}");
    let sheet = rows(&read(&out, "fmea.csv"));
    let of = |mode: &str, basis: &str| -> f64 {
        let rows = sheet.iter().filter(|row| row["mode"] == mode && row["basis"] == basis);
        rows.map(|row| row["effect_s"].parse::<f64>().unwrap()).sum()
    };
    let checked = of("M1", "checked at the instants looked at, and simulated");
    assert!((of("M1", "proved at every instant, and simulated") - proved).abs() < 1e-9);
    assert!((checked + proved - 6.0).abs() < 1e-9, "{checked}");
    assert!((of("M2", "none sought: hover is lost") - 6.0).abs() < 1e-9);
    // One reason in one wording.
    for name in ["index.html", "argument.json"] {
        assert!(read(&out, name).contains("none sought: hover is lost"), "{name}");
    }

    let argument = json(&out, "argument.json");
    let texts = |kind: &str| -> Vec<String> {
        let nodes = argument["nodes"].as_array().unwrap().iter().filter(|node| node["type"] == kind);
        nodes.map(|node| format!("{} {}", node["text"].as_str().unwrap(), node["sha256"])).collect()
    };
    let certificate: String = Sha256::digest(std::fs::read(out.join("certificate.json")).unwrap())
        .iter()
        .map(|b| format!("{b:02x}"))
        .collect();
    let due =
        format!("certificate.json: ways out after M1, proved at every instant of {proved:.2} s \"{certificate}\"");
    assert!(texts("solution").contains(&due), "{:?}", texts("solution"));
    let between = match checked > 1e-9 {
        true => format!("The certificate proves {proved:.2} s of the {:.2} s x fault", proved + checked),
        false => "from there a way out is proved at every instant".into(),
    };
    assert!(texts("assumption").iter().any(|text| text.contains(&between)), "{:?}", texts("assumption"));

    // A certificate of the same plan without these families proves none of it.
    let mut bare = json(&out, "certificate.json");
    assert!(bare["claim"]["plan"]["recovery"]["families"].as_array().is_some_and(|all| !all.is_empty()));
    bare["claim"]["plan"]["recovery"] = Value::Null;
    write(folder.path(), "bare.json", &bare.to_string());
    let args = ["safety", "hop.mav", "-o", "bare", "--report", "out/report.json", "--certificate", "bare.json"];
    let (code, text, errors) = mavc_in(folder.path(), &args);
    assert_eq!(code, 0, "{text}{errors}");
    let bare = folder.path().join("bare");
    assert_eq!(json(&bare, "quantities.json")["modes"][0]["proved_s"], 0.0);
    assert!(read(&bare, "argument.json").contains("Ways out hold between the instants looked at; this is not shown."));
    assert!(!read(&bare, "fmea.csv").contains("proved at every instant"));
}
