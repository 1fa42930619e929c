//! Each file that was changed, is missing or belongs to something else is named; a report that contradicts itself, the spec
//! or the certificate is refused.

use super::{DERIVED, SPEC, assessed, json, read, rows, write};
use crate::cli::mavc_in;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;

#[test]
fn each_broken_link_is_reported_where_it_is() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let check = || mavc_in(folder, &["safety", "field.mav", "-o", "out", "--check", "-q"]);
    assert_eq!(check().0, 0);

    // A file that was edited by hand, and one that is missing.
    for name in DERIVED {
        let text = read(&out, name);
        write(&out, name, &text.replacen("M1", "M9", 1));
        let (code, _, errors) = check();
        assert_eq!(code, 5, "{errors}");
        assert!(errors.contains(&format!("mavc: {name}: does not follow")) && errors.lines().count() == 1, "{errors}");
        std::fs::remove_file(out.join(name)).unwrap();
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains(&format!("cannot read out/{name}")), "{errors}");
        write(&out, name, &text);
    }

    // A rate or a site: the folder is that of another spec, and every file of the new one differs.
    let moved = ("at = [10, 6, 1] m", "at = [10, 12, 1] m");
    for (from, to) in [moved, ("2e-6 1/h", "3e-6 1/h")] {
        write(folder, "field.mav", &SPEC.replace(from, to));
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains("mavc::verify::other_spec"), "{errors}");
        let (code, text, errors) = mavc_in(folder, &["safety", "field.mav", "-o", "new"]);
        assert_eq!(code, 0, "{text}{errors}");
        assert!(DERIVED.iter().all(|name| read(&out, name) != read(&folder.join("new"), name)), "{to}");
    }
    let mixed = |report: &str, certificate: &str| {
        let args = ["safety", "field.mav", "-o", "mixed", "--report", report, "--certificate", certificate];
        let (code, text, errors) = mavc_in(folder, &args);
        assert!(code != 0 && !folder.join("mixed").exists(), "{text}{errors}");
        (code, errors)
    };
    let (code, errors) = mixed("out/report.json", "new/certificate.json");
    assert!(code == 2 && errors.contains("cannot use report.json: it is the report of another spec"), "{errors}");

    // A certificate that does not verify.
    write(folder, "field.mav", SPEC);
    let mut forged = json(&out, "certificate.json");
    let height = &mut forged["claim"]["plan"]["motion"]["z"][20][0];
    assert!(height.is_number(), "the record of a motion changed");
    *height = Value::from(7.0);
    write(folder, "forged.json", &forged.to_string());
    let (code, errors) = mixed("out/report.json", "forged.json");
    assert!(code == 5 && errors.contains("the certificate is rejected"), "{errors}");

    // A site, a mode, a time and an outcome that the spec does not have.
    let report = read(&out, "report.json");
    for (from, to, why) in [
        ("\"site\": \"pad\"", "\"site\": \"pod\"", "`pod`, which is not a landing site"),
        (
            "\"name\": \"board\",\n        \"pieces\"",
            "\"name\": \"plank\",\n        \"pieces\"",
            "its modes, M1, plank, ice,",
        ),
        ("\"to_s\": 12.0", "\"to_s\": 11.0", "end at 11 s, the plan at 12 s"),
        ("\"outcome\": \"none\"", "\"outcome\": \"flies\"", "the unknown outcome `flies`"),
    ] {
        assert!(report.contains(from), "{from}");
        write(folder, "broken.json", &report.replacen(from, to, 1));
        let (code, errors) = mixed("broken.json", "out/certificate.json");
        assert!(code == 2 && errors.contains("cannot use report.json") && errors.contains(why), "{errors}");
    }
}

/// A report that contradicts the certificate, the spec or itself is refused, and the message names it.
#[test]
fn a_report_that_contradicts_itself_or_the_certificate_is_refused() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let report = json(&out, "report.json");
    let modes = report["recovery"]["modes"].as_array().unwrap();
    let has_none = |mode: &Value| mode["pieces"].as_array().unwrap().iter().any(|piece| piece["outcome"] == "none");
    let open = modes.iter().position(has_none).unwrap();
    let refused = |why: &str, change: &dyn Fn(&mut Value)| {
        let mut forged = report.clone();
        change(&mut forged);
        assert_ne!(forged, report, "{why}");
        write(folder, "forged.json", &forged.to_string());
        let args = ["--report", "forged.json", "--certificate", "out/certificate.json"];
        let (code, text, errors) = mavc_in(folder, &[&["safety", "field.mav", "-o", "forged"], &args[..]].concat());
        assert!(
            code == 2 && errors.contains("cannot use report.json") && errors.contains(why),
            "{why}: {text}{errors}"
        );
        assert!(!folder.join("forged").exists());
    };
    let pieces = |report: &mut Value, change: &dyn Fn(&mut Vec<Value>)| {
        change(report["recovery"]["modes"][open]["pieces"].as_array_mut().unwrap());
    };
    let without_gaps = |report: &mut Value| pieces(report, &|all| all.retain(|piece| piece["outcome"] != "none"));
    // The sums of an honest report, so that only what is tested contradicts them.
    let summed = |report: &mut Value| {
        let recovery = &mut report["recovery"];
        let all = recovery["modes"].as_array_mut().unwrap();
        for mode in all.iter_mut() {
            let none = mode["pieces"].as_array().unwrap().iter().filter(|piece| piece["outcome"] == "none");
            let sum: f64 = none.map(|piece| piece["to_s"].as_f64().unwrap() - piece["from_s"].as_f64().unwrap()).sum();
            mode["uncovered_s"] = Value::from(sum);
        }
        let open: f64 = all.iter().map(|mode| mode["uncovered_s"].as_f64().unwrap()).sum();
        recovery["uncovered"] = Value::from(open / (12.0 * all.len() as f64));
    };
    // Without the times that have no way out, and with the next ones over these times.
    refused("s, the plan at 12 s", &|forged| without_gaps(forged));
    // A hole beside a time without a way out, an overlap, and an end before that of the plan.
    for (member, by, why) in [
        ("from_s", 0.01, "do not follow each other"),
        ("from_s", -0.01, "do not follow each other"),
        ("to_s", -1.0, "end at 11 s, the plan at 12 s"),
    ] {
        refused(why, &|forged| {
            pieces(forged, &|all| {
                let last = all.last_mut().unwrap();
                assert_eq!(last["outcome"], "none", "the spec gave another mission");
                last[member] = Value::from(last[member].as_f64().unwrap() + by);
            });
            summed(forged);
        });
    }
    refused("do not cover the time from 0 to", &|forged| {
        without_gaps(forged);
        pieces(forged, &|all| {
            let mut reached = 0.0;
            for piece in all.iter_mut() {
                piece["from_s"] = Value::from(reached);
                reached = piece["to_s"].as_f64().unwrap();
            }
            all.last_mut().unwrap()["to_s"] = Value::from(12.0);
        });
        summed(forged);
    });
    refused("its share without a way out", &|forged| forged["recovery"]["uncovered"] = Value::from(0.001));
    refused("is uncovered for 0 s", &|forged| forged["recovery"]["modes"][open]["uncovered_s"] = Value::from(0.0));
    refused("it reaches waypoint 2 at", &|forged| {
        let waypoints = forged["planners"].as_array_mut().unwrap().last_mut().unwrap();
        let at = &mut waypoints["waypoints"][1]["at_s"];
        *at = Value::from(at.as_f64().unwrap() + 0.5);
    });
    refused("its plan takes 13 s, that of the certificate 12 s", &|forged| {
        forged["planners"].as_array_mut().unwrap().last_mut().unwrap()["time_s"] = Value::from(13.0);
    });
    refused("not those of the spec", &|forged| forged["recovery"]["detection_s"] = serde_json::json!([0.05]));
    refused("ways out, and counts", &|forged| {
        for count in ["flown", "survived"] {
            let counted = forged["recovery"][count].as_u64().unwrap();
            forged["recovery"][count] = Value::from(counted + 1);
        }
    });
    refused("whether a way out was sought after M1 does not follow from the spec", &|forged| {
        forged["recovery"]["modes"][open]["not_attempted"] = Value::from("no hover");
    });
    for by in [-20, 100] {
        refused("a search of its outcomes does not look at", &|forged| {
            let instants = forged["recovery"]["instants"].as_i64().unwrap();
            forged["recovery"]["instants"] = Value::from(instants + by);
        });
    }
}

/// The folder has the spec, and says of what its hash is; a copy of the spec gives the same assessment.
#[test]
fn the_folder_identifies_its_spec_and_its_program() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir_all(folder.join("missions")).unwrap();
    let vehicle = &SPEC[SPEC.find("vehicle").unwrap()..SPEC.find("faults").unwrap()];
    let spec = SPEC.replace(vehicle, "use \"../octo.mav\"\n");
    write(folder, "octo.mav", vehicle);
    write(folder, "missions/field.mav", &spec);
    let set = "plan.reserve=11%";
    let assess = |spec: &str, out: &str, more: &[&str]| {
        let (code, text, errors) =
            mavc_in(folder, &[&["safety", spec, "-o", out, "--set", set, "--set", "plan.effort=quick"], more].concat());
        assert_eq!(code, 0, "{text}{errors}");
        text
    };
    assess("missions/field.mav", "out", &[]);
    let out = folder.join("out");
    let quantities = json(&out, "quantities.json");
    assert_eq!(quantities["set"], serde_json::json!([set, "plan.effort=quick"]));
    let files: Vec<&str> =
        quantities["spec"].as_array().unwrap().iter().map(|text| text["file"].as_str().unwrap()).collect();
    assert_eq!(files, ["spec/missions/field.mav", "spec/octo.mav"]);
    let page = read(&out, "index.html");
    let mut whole = Sha256::new();
    let hex = |hash: Sha256| hash.finalize().iter().map(|b| format!("{b:02x}")).collect::<String>();
    for (name, text) in [(files[0], spec.as_str()), (files[1], vehicle)] {
        assert_eq!(read(&out, name), text);
        let own = hex(Sha256::new_with_prefix(text));
        assert!(page.contains(&own), "{name}");
    }
    for text in [spec.as_str(), vehicle, set] {
        whole.update((text.len() as u64).to_le_bytes());
        whole.update(text);
    }
    let whole = hex(whole);
    assert!(quantities["spec_sha256"] == whole.as_str() && page.contains(&whole));
    let version = mavc_in(folder, &["--version"]).1;
    let mut facts = version.lines();
    let number = facts.next().unwrap().trim_start_matches("mavc ");
    let commit = facts.next().unwrap().split_once("commit").unwrap().1.trim();
    assert_eq!(quantities["written_by"], format!("{number}, commit {commit}"));
    assert!(page.contains(&format!("{number}, commit {commit}")));

    // The copy is the spec, whatever its name, and a copy that was edited is reported.
    write(folder, "missions/renamed.mav", &spec);
    assess("missions/renamed.mav", "out", &["--check"]);
    assess("out/spec/missions/field.mav", "out", &["--check"]);
    write(&out, "spec/octo.mav", &vehicle.replace("2.3 kg", "2.4 kg"));
    let args = ["safety", "missions/field.mav", "-o", "out", "--set", set, "--check", "-q"];
    let (code, _, errors) = mavc_in(folder, &args);
    assert!(code == 5 && errors.contains("mavc: spec/octo.mav: does not follow"), "{errors}");
}

/// Files that the others are written from are compared with the hashes that the folder states.
#[test]
fn a_changed_report_certificate_or_table_is_named() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let check = || mavc_in(folder, &["safety", "field.mav", "-o", "out", "--check", "-q"]);
    let (code, text, _) = check();
    assert!(
        code == 0 && text.starts_with("8 files follow from the spec, report.json and certificate.json\n"),
        "{text}"
    );
    assert!(text.contains("report.json itself is not proved"), "{text}");

    // The tables of the worksheet are in the folder, as `plan --branches` writes them.
    let sheet = rows(&read(&out, "fmea.csv"));
    let tables: BTreeSet<&str> = sheet.iter().flat_map(|row| row["provision"].split_whitespace()).collect();
    assert!(tables.len() > 4, "{tables:?}");
    let index = rows(&read(&out, "branches/index.csv"));
    assert_eq!(index.iter().map(|row| row["file"].as_str()).collect::<BTreeSet<_>>(), tables);
    assert!(text.contains(&format!("{} files in branches", tables.len() + 1)), "{text}");
    // With a certificate, as here: ways out that leave room for a proof are then sought first.
    mavc_in(folder, &["plan", "field.mav", "--branches", "planned", "--certificate", "c.json", "-q"]);
    let table = format!("branches/{}", tables.first().unwrap());
    assert!(read(&out, &table) == read(&folder.join("planned"), tables.first().unwrap()), "{table}");

    for name in ["report.json", "certificate.json", "branches/SHA256SUMS", &table] {
        let text = read(&out, name);
        for changed in [format!("{text} "), text.replacen('1', "2", 1), String::new()] {
            write(&out, name, &changed);
            let (code, _, errors) = check();
            let due = format!("mavc: {name}: changed since the folder was written");
            assert!(code == 5 && errors.contains(&due) && !errors.contains("does not follow"), "{errors}");
        }
        std::fs::remove_file(out.join(name)).unwrap();
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains(&format!("mavc: {name}: cannot read")), "{errors}");
        write(&out, name, &text);
    }
    assert_eq!(check().0, 0);
    // Files that the assessment does not have, of another one or anyone's.
    write(&out, "branches/M9_1.000s_100ms.csv", "t\n");
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("branches/M9_1.000s_100ms.csv: not of this assessment"), "{errors}");
    let args = ["--report", "out/report.json", "--certificate", "out/certificate.json", "-q"];
    let (code, _, errors) = mavc_in(folder, &[&["safety", "field.mav", "-o", "out"], &args[..]].concat());
    assert!(code == 0 && errors.starts_with("mavc: branches: not of this assessment"), "{errors}");
    assert_eq!(check().0, 5);
    std::fs::remove_dir_all(out.join("branches")).unwrap();
    assert_eq!(check().0, 0);
    write(&out, "fmea_old.csv", "mode\n");
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("mavc: fmea_old.csv: not of this assessment"), "{errors}");
    std::fs::remove_file(out.join("fmea_old.csv")).unwrap();
    assert_eq!(mavc_in(folder, &["safety", "field.mav", "-o", "out", "-q"]).0, 0);
    assert_eq!(check().0, 0);
    // Where every file states the hash of a forged report, the report is refused.
    let forged = read(&out, "report.json").replace("\"detection_s\": [", "\"detection_s\": [0.05, ");
    let hash = |text: &str| Sha256::digest(text).iter().map(|b| format!("{b:02x}")).collect::<String>();
    let honest = hash(&read(&out, "report.json"));
    write(&out, "report.json", &forged);
    for name in DERIVED {
        write(&out, name, &read(&out, name).replace(&honest, &hash(&forged)));
    }
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("cannot use report.json: its delays"), "{errors}");
}
