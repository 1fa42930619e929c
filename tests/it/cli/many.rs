//! Several specs in one run.

use super::{code, err, folder, mavc, mavc_with, out, text};
use std::fs;

const QUAD: &str = include_str!("../../specs/parts/quad.mav");

/// A folder with these files.
fn with(files: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = folder();
    for (name, content) in files {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }
    dir
}

fn name(dir: &tempfile::TempDir, file: &str) -> String {
    text(&dir.path().join(file)).to_string()
}

#[test]
fn a_folder_is_checked_in_order_with_a_summary() {
    let broken = QUAD.replace("1.32 kg", "1.32 m");
    let dir = with(&[
        ("b.mav", QUAD),
        ("a/z.mav", &broken),
        ("c.mav", QUAD),
        ("notes.txt", "no spec"),
        (".hidden/d.mav", &broken),
    ]);
    let ran = mavc(&["check", text(dir.path())]);
    assert_eq!(code(&ran), 1);
    let told = out(&ran);
    let verdicts: Vec<&str> = told.lines().filter(|line| line.starts_with(text(dir.path()))).collect();
    assert_eq!(
        verdicts,
        [
            format!("{}: 1 error", name(&dir, "a/z.mav")),
            format!("{}: no problems", name(&dir, "b.mav")),
            format!("{}: no problems", name(&dir, "c.mav")),
        ]
    );
    assert_eq!(told.lines().last(), Some("3 specs, 1 with problems: 1 error"));
    let quiet = out(&mavc(&["check", "--quiet", text(dir.path())]));
    assert!(quiet.contains("mavc::unit::mismatch") && !quiet.contains("specs,"), "{quiet}");
    // A file by itself has no summary, and each is checked once.
    let alone = out(&mavc(&["check", &name(&dir, "b.mav")]));
    assert!(alone.ends_with(&format!("\n{}: no problems\n", name(&dir, "b.mav"))), "{alone}");
    assert!(alone.contains(": full control without a fault; no fault modes declared\n"), "{alone}");
    let twice = mavc(&["check", &name(&dir, "c.mav"), &name(&dir, "b.mav"), &name(&dir, "c.mav")]);
    assert_eq!(out(&twice).lines().last(), Some("2 specs: no problems"));
    assert!(out(&twice).starts_with(&name(&dir, "c.mav")), "in the order named");
}

#[test]
fn what_several_specs_share_is_reported_once() {
    let broken = QUAD.replace("1.32 kg", "1.32 m");
    let dir = with(&[("a.mav", "use \"quad.mav\"\n"), ("b.mav", "use \"quad.mav\"\n"), ("quad.mav", &broken)]);
    let ran = mavc(&["check", text(dir.path())]);
    let told = out(&ran);
    assert_eq!(told.matches("mavc::unit::mismatch").count(), 1, "{told}");
    assert!(told.contains("b.mav: 1 error (1 reported above)"), "{told}");
    assert_eq!(told.lines().last(), Some("3 specs, 3 with problems: 1 error"));
    let json = out(&mavc(&["check", "--format", "json", text(dir.path())]));
    assert_eq!(json.lines().count(), 1, "{json}");
    serde_json::from_str::<serde_json::Value>(&json).unwrap();
}

#[test]
fn the_exit_code_is_the_worst() {
    let cannot_hover = format!(
        "{QUAD}faults {{ every 1 rotor lost as M }}\nmission m {{ start at [0, 0, 2] m; waypoint at [1, 0, 2] m }}\n\
         plan {{ planner = rcp }}\n"
    );
    let broken = QUAD.replace("1.32 kg", "1.32 m");
    let dir = with(&[("fine.mav", QUAD), ("hover.mav", &cannot_hover), ("broken.mav", &broken), ("empty/x", "")]);
    let check = |files: &[&str]| {
        let names: Vec<String> = files.iter().map(|file| name(&dir, file)).collect();
        mavc(&[vec!["check"], names.iter().map(String::as_str).collect()].concat())
    };
    assert_eq!(code(&check(&["fine.mav", "fine.mav"])), 0);
    assert_eq!(code(&check(&["hover.mav", "fine.mav"])), 3);
    assert_eq!(code(&check(&["fine.mav", "hover.mav", "broken.mav"])), 1);
    let ran = check(&["none.mav", "fine.mav", "broken.mav"]);
    assert_eq!(code(&ran), 2);
    assert!(err(&ran).contains("none.mav: no such file"), "{}", err(&ran));
    assert_eq!(out(&ran).lines().last(), Some("3 specs, 1 with problems, 1 could not be read: 1 error"));
    let ran = check(&["empty"]);
    assert_eq!((code(&ran), out(&ran).as_str()), (2, ""));
    assert_eq!(code(&mavc(&["check"])), 2);
    // Warnings count where they are denied.
    let warned = format!("{QUAD}let unused = 1\n");
    fs::write(dir.path().join("warned.mav"), warned).unwrap();
    assert_eq!(code(&check(&["warned.mav", "fine.mav"])), 0);
    let denied = mavc(&["check", "--deny", "warnings", &name(&dir, "warned.mav"), &name(&dir, "fine.mav")]);
    assert_eq!(code(&denied), 1);
}

#[test]
fn standard_input_may_be_one_of_several() {
    let ran = mavc_with(&["check", "specs/vehicles/quad_x.mav", "-"], QUAD);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    assert_eq!(
        out(&ran),
        "specs/vehicles/quad_x.mav: no problems\n  quad_x: full control without a fault; no fault modes declared\n\
         <stdin>: no problems\n  quad: full control without a fault; no fault modes declared\n\
         2 specs: no problems\n"
    );
}
