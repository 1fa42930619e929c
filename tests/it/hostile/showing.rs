//! Control and bidirectional characters of names, texts, comments, tables and paths, in every output.

use crate::cli::mavc_with;
use mavc::source::visible::is_disguise;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Clears the screen, colours, goes back to the line's beginning, links, forges a line, turns the direction.
const DISGUISES: &str = "\u{1b}[2J\u{1b}[32m\rmavc: fine\u{8}\u{9b}31m\u{1b}]8;;http://x\u{7}\u{202e}\u{2066}\u{7f}";

fn run(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavc")).args(args).current_dir(folder).env("NO_COLOR", "1").output().unwrap()
}

/// Fails where a byte that was printed, or a file, holds a disguise.
fn assert_plain(what: &str, bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let text = text.replace("\r\n", "\n");
    let found = text.char_indices().find(|(_, c)| is_disguise(*c) && !matches!(c, '\n' | '\t'));
    assert!(found.is_none(), "{what}: {found:?} in {:?}", &text[found.unwrap().0.saturating_sub(80)..][..100]);
}

fn assert_plain_output(what: &str, ran: &Output) {
    assert_plain(what, &ran.stdout);
    assert_plain(what, &ran.stderr);
}

/// A spec with disguises wherever it may have text, and a table whose waypoints have names.
fn desk() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let comment = DISGUISES.replace('\r', "");
    let spec = crate::cli::HOP
        .replacen("vehicle", &format!("/// {comment}\nvehicle"), 1)
        .replacen("mode weak {", &format!("mode weak \"a {comment} b\" {{ // {comment}\n"), 1)
        .replacen("mission", &format!("/// {comment}\nmission"), 1)
        .replacen("waypoint at [3, 1, 4] m", "waypoints from \"t.csv\"", 1);
    fs::write(at("hop.mav"), spec).unwrap();
    let name = DISGUISES.replace('\r', "");
    fs::write(at("t.csv"), format!("x_m,y_m,z_m,name\n3,1,4,\"{name}\nmavc: forged\"\n")).unwrap();
    dir
}

#[test]
fn results_and_reports_hold_no_disguise() {
    let dir = desk();
    let results = ["-o", "o.csv", "--report", "r.json", "--html", "p.html", "--svg", "svg", "--certificate", "c.json"];
    let ran = run(dir.path(), &[&["plan", "hop.mav"][..], &results].concat());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    assert_plain_output("plan", &ran);
    for args in [
        &["check", "hop.mav", "--explain-defaults"][..],
        &["check", "hop.mav", "--format", "json"],
        &["check", "hop.mav", "--format", "short"],
        &["analyze", "hop.mav"],
        &["analyze", "hop.mav", "--format", "json"],
        &["emit", "ast", "hop.mav"],
        &["emit", "model", "hop.mav"],
        &["emit", "constraints", "hop.mav"],
        &["emit", "qp", "hop.mav", "--format", "json"],
        &["verify", "c.json", "hop.mav"],
        &["simulate", "hop.mav", "-o", "f.csv", "--report", "s.json", "--html", "s.html"],
        &["campaign", "hop.mav", "--times", "1", "-o", "rows.csv", "--report", "k.json", "--html", "k.html"],
    ] {
        assert_plain_output(args[0], &run(dir.path(), args));
    }
    let mut files = 0;
    for entry in fs::read_dir(dir.path()).unwrap().chain(fs::read_dir(dir.path().join("svg")).unwrap()) {
        let path = entry.unwrap().path();
        if path.is_file() && !path.ends_with("hop.mav") && !path.ends_with("t.csv") {
            assert_plain(path.to_str().unwrap(), &fs::read(&path).unwrap());
            files += 1;
        }
    }
    assert!(files > 12, "{files}");
}

#[test]
fn diagnostics_show_escapes_and_true_places() {
    let text = format!("let {DISGUISES}a = 1 {DISGUISES} \"{DISGUISES}\n}} // \u{202e}\nlet b = b\u{1b} + 'x\u{1b}'\n");
    for format in ["human", "short", "json"] {
        let ran = mavc_with(&["check", "-", "--format", format], &text);
        assert_eq!(ran.status.code(), Some(1));
        assert_plain_output(format, &ran);
    }
    let ran = mavc_with(&["check", "-"], "let c = 1 /* \u{1b}[31m\u{202e} */ + d\n");
    let told = String::from_utf8(ran.stdout).unwrap();
    assert!(told.contains("/* \\u{1b}[31m\\u{202e} */ + d"), "{told}");
    // The column is the one of the text as it was written, and the mark is below the name.
    assert!(told.contains("<stdin>:1:26]"), "{told}");
    let line = told.lines().find(|line| line.contains("+ d")).unwrap();
    let mark = told.lines().rfind(|line| line.contains(['┬', '▲'])).unwrap();
    let place = mark.chars().position(|c| "┬▲".contains(c)).unwrap();
    assert_eq!(line.chars().nth(place), Some('d'), "{told}");
    // Laid out it would be told so, and shown so.
    assert_plain_output("fmt", &mavc_with(&["fmt", "--check", "-"], "let  c = 1 // \u{1b}[31m\n"));
    // What is laid out is the text itself.
    assert!(mavc_with(&["fmt", "-"], "let c = 1 // \u{1b}[31m\n").stdout.ends_with(b"// \x1b[31m\n"));
}

#[cfg(unix)]
#[test]
fn names_of_files_cannot_forge_lines() {
    let dir = tempfile::tempdir().unwrap();
    let name = "x\u{1b}[31m\nmavc: fine\u{202e}.mav";
    fs::write(dir.path().join(name), "let a = b\nuse \"none.mav\"\n").unwrap();
    let ran = run(dir.path(), &["check", "."]);
    assert_plain_output("check", &ran);
    let told = String::from_utf8_lossy(&ran.stdout).into_owned();
    assert!(told.contains("x\\u{1b}[31m\\u{a}mavc: fine\\u{202e}.mav"), "{told}");
    for args in [
        &["check", "--format", "short", "."][..],
        &["fmt", "--check", "."],
        &["plan", name],
        &["plan", "none", "-o", name],
        &["emit", "ast", name],
        &["verify", name, name],
        &["campaign", "merge", "-o", "all.csv", name],
        &["check", "none\u{1b}[31m\nmavc: fine"],
        &[&format!("--{name}")],
        &["explain", name],
        &["check", "--set", name, "."],
    ] {
        let ran = run(dir.path(), args);
        assert_plain_output(&format!("{args:?}"), &ran);
        let both = [ran.stdout, ran.stderr].concat();
        let forged = String::from_utf8_lossy(&both).lines().any(|line| line.trim_start().starts_with("mavc: fine"));
        assert!(!forged, "{args:?}: {}", String::from_utf8_lossy(&both));
    }
}

/// A certificate is another's file too.
#[test]
fn certificates_cannot_colour_the_terminal() {
    let dir = desk();
    let ran = run(dir.path(), &["plan", "hop.mav", "-o", "o.csv", "--certificate", "c.json"]);
    assert_eq!(ran.status.code(), Some(0));
    let text = fs::read_to_string(dir.path().join("c.json")).unwrap();
    let mut forged = 0;
    for key in
        ["\"planner\"", "\"model\"", "\"mode\"", "\"mission\"", "\"claim\"", "\"scope\"", "\"kind\"", "\"spec_sha256\""]
    {
        let Some((before, after)) = text.split_once(&format!("{key}: \"")) else { continue };
        for disguise in ["\\u001b[2J\\u001b[32m", "\u{202e}\u{9b}31m"] {
            fs::write(dir.path().join("f.json"), format!("{before}{key}: \"{disguise}{after}")).unwrap();
            let ran = run(dir.path(), &["verify", "f.json", "hop.mav"]);
            assert_ne!(ran.status.code(), Some(0));
            assert_plain_output(key, &ran);
            forged += 1;
        }
    }
    assert!(forged >= 4, "{forged}");
}
