//! What a spec names, and what lies in a folder: pipes, links to other files, links to nowhere, circles.

use crate::cli::{mavc, mavc_with};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const QUAD: &str = include_str!("../../specs/parts/quad.mav");

/// No command here has any work to do; one that takes so long hangs.
const STUCK: Duration = Duration::from_secs(60);

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// Runs `mavc` in a folder; it must end by itself.
fn run(folder: &Path, args: &[&str]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(args)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begin.elapsed() > STUCK {
            child.kill().unwrap();
            panic!("{args:?} hangs");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    child.wait_with_output().unwrap()
}

fn said(ran: &Output) -> String {
    String::from_utf8_lossy(&ran.stdout).into_owned() + &String::from_utf8_lossy(&ran.stderr)
}

/// A folder with a pipe, a secret, and links to the secret under the names of a spec and of tables.
fn traps() -> tempfile::TempDir {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    pipe(&at("pipe.mav"));
    pipe(&at("pipe.csv"));
    fs::write(at("secret.key"), "token = hunter2 %%\n").unwrap();
    symlink("secret.key", at("link.mav")).unwrap();
    symlink("secret.key", at("link.csv")).unwrap();
    symlink("/proc/self/environ", at("proc.txt")).unwrap();
    symlink("/dev/zero", at("zero.mav")).unwrap();
    fs::write(at("quad.mav"), QUAD).unwrap();
    dir
}

#[test]
fn use_and_tables_take_only_regular_files_of_their_kind() {
    let dir = traps();
    for statement in [
        "use \"pipe.mav\"",
        "use \"link.mav\"",
        "use \"zero.mav\"",
        "use \"secret.key\"",
        "use \"/proc/self/environ\"",
        "use \"/dev/stdin\"",
        "mission m { waypoints from \"pipe.csv\" }",
        "mission m { waypoints from \"link.csv\" }",
        "mission m { waypoints from \"proc.txt\" }",
        "mission m { waypoints from \"quad.mav\" }",
        "mission m { waypoints from \"/dev/zero\" }",
        "vehicle v { rotor { table = \"pipe.csv\" } }",
        "vehicle v { rotor { table = \"link.csv\" } }",
        "vehicle v { rotor { table = \"/dev/zero\" } }",
    ] {
        fs::write(dir.path().join("a.mav"), format!("use \"quad.mav\"\n{statement}\n")).unwrap();
        let text = format!("use \"quad.mav\"\n{statement}\n");
        for format in ["human", "json", "short"] {
            let ran = run(dir.path(), &["check", "a.mav", "--format", format]);
            let told = said(&ran);
            assert_eq!(ran.status.code(), Some(1), "{statement}: {told}");
            assert!(told.contains("mavc::file::kind"), "{statement}: {told}");
            assert!(!told.contains("hunter2") && !told.contains("PATH="), "{told}");
        }
        // The same from standard input.
        let input = text.replace("\"quad", &format!("\"{}/quad", dir.path().display()));
        let input = input.replace("from \"", &format!("from \"{}/", dir.path().display()));
        assert!(!said(&mavc_with(&["check", "-"], &input)).contains("hunter2"));
    }
}

#[test]
fn a_link_to_another_spec_is_read() {
    let dir = traps();
    symlink("quad.mav", dir.path().join("alias.mav")).unwrap();
    fs::write(dir.path().join("a.mav"), "use \"alias.mav\"\n").unwrap();
    let ran = run(dir.path(), &["check", "a.mav"]);
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
}

#[test]
fn a_spec_that_is_named_goes_by_its_resolved_name_too() {
    let dir = traps();
    for command in [&["check"][..], &["analyze"], &["fmt", "--check"], &["emit", "ast"]] {
        for name in ["pipe.mav", "link.mav", "zero.mav"] {
            let ran = run(dir.path(), &[command, &[name]].concat());
            assert_eq!(ran.status.code(), Some(2), "{command:?} {name}: {}", said(&ran));
            assert!(said(&ran).contains(&format!("cannot read {name}: it is ")), "{}", said(&ran));
            assert!(!said(&ran).contains("hunter2"), "{}", said(&ran));
        }
    }
    // What a shell makes of `<(...)` has no such name.
    let ran = mavc_with(&["check", "/dev/stdin"], QUAD);
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
}

#[test]
fn a_folder_goes_on_past_bad_entries_and_reports_them() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    fs::create_dir_all(at("sub/.git")).unwrap();
    fs::write(at("sub/good.mav"), QUAD).unwrap();
    fs::write(at("sub/.git/hidden.mav"), "nonsense").unwrap();
    fs::write(at(".hidden.mav"), "nonsense").unwrap();
    symlink("user@host.1234", at(".#good.mav")).unwrap();
    symlink("nowhere", at("build")).unwrap();
    assert_eq!(run(dir.path(), &["check", "."]).status.code(), Some(0), "nothing of these concerns a check");

    symlink("nowhere.mav", at("dangling.mav")).unwrap();
    symlink("..", at("sub/loop")).unwrap();
    symlink("self", at("self")).unwrap();
    pipe(&at("a_pipe.mav"));
    fs::write(at("secret.key"), "hunter2\n").unwrap();
    symlink("secret.key", at("stolen.mav")).unwrap();
    for command in [&["check"][..], &["fmt", "--check"]] {
        let ran = run(dir.path(), &[command, &["."]].concat());
        let told = String::from_utf8(ran.stderr.clone()).unwrap();
        assert_eq!(ran.status.code(), Some(2), "{told}");
        for name in ["dangling.mav", "sub/loop", "a_pipe.mav", "stolen.mav"] {
            assert!(told.lines().any(|l| l.starts_with("mavc: cannot read ") && l.contains(name)), "{name}: {told}");
        }
        assert!(!said(&ran).contains("hunter2") && !told.contains("hidden"), "{told}");
        if command == ["check"] {
            let out = String::from_utf8(ran.stdout.clone()).unwrap();
            assert!(out.contains("sub/good.mav: no problems\n"), "{out}");
            assert!(out.ends_with("2 specs, 1 could not be read, 3 entries skipped: no problems\n"), "{out}");
        }
    }
    // A name beside the folder is not kept waiting either.
    let ran = run(dir.path(), &["check", "sub/.git/none", "sub/good.mav"]);
    assert!(said(&ran).contains("sub/good.mav: no problems"), "{}", said(&ran));
}

#[test]
fn charts_replace_links_and_spare_what_is_read() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    fs::write(at("hop.mav"), crate::cli::HOP).unwrap();
    let plan = |svg: &str| run(dir.path(), &["plan", "hop.mav", "-o", "t.csv", "--svg", svg]);
    let ran = plan("fresh");
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
    let mut names: Vec<String> =
        fs::read_dir(at("fresh")).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    // Every chart's name leads to the spec, or is one more name of it.
    fs::create_dir(at("links")).unwrap();
    names.iter().for_each(|name| symlink("../hop.mav", at("links").join(name)).unwrap());
    let ran = plan("links");
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
    assert_eq!(fs::read_to_string(at("hop.mav")).unwrap(), crate::cli::HOP);
    for name in &names {
        assert!(!at("links").join(name).is_symlink());
        assert_eq!(fs::read(at("links").join(name)).unwrap(), fs::read(at("fresh").join(name)).unwrap());
    }
    fs::create_dir(at("hard")).unwrap();
    fs::hard_link(at("hop.mav"), at("hard").join(&names[0])).unwrap();
    fs::remove_file(at("t.csv")).unwrap();
    let ran = plan("hard");
    assert_eq!(ran.status.code(), Some(2), "{}", said(&ran));
    assert!(said(&ran).contains("which is read") && !at("t.csv").exists(), "{}", said(&ran));
    // Nor does a chart take the place of another result.
    let clash = format!("fresh/{}", names[0]);
    let ran = run(dir.path(), &["plan", "hop.mav", "-o", &clash, "--format", "csv", "--svg", "fresh"]);
    assert!(ran.status.code() == Some(2) && said(&ran).contains("another result"), "{}", said(&ran));
    // A pipe in the folder would be waited for.
    fs::create_dir(at("pipes")).unwrap();
    pipe(&at("pipes").join(&names[0]));
    assert_eq!(plan("pipes").status.code(), Some(2));
}

#[test]
fn threads_are_capped() {
    let ran = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(["analyze", "-v", "specs/vehicles/octo_ppnnppnn.mav"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env("RAYON_NUM_THREADS", "100000")
        .env("COLUMNS", "99999999999")
        .output()
        .unwrap();
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
    assert_eq!(ran.stdout, mavc(&["analyze", "-v", "specs/vehicles/octo_ppnnppnn.mav"]).stdout);
}
