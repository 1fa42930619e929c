//! `check --watch`: each change is followed by another look. The tests wait for lines, however long these take.

use super::{code, err, folder, mavc_with, text};
use std::fs;
use std::io::{BufRead, BufReader, Lines};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdout, Command, Stdio};

const QUAD: &str = include_str!("../../specs/parts/quad.mav");

struct Watching {
    child: Child,
    out: Lines<BufReader<ChildStdout>>,
    err: Lines<BufReader<ChildStderr>>,
}

impl Watching {
    fn new(args: &[&str]) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
            .args(["check", "--watch"])
            .args(args)
            .env("NO_COLOR", "1")
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let out = BufReader::new(child.stdout.take().unwrap()).lines();
        let err = BufReader::new(child.stderr.take().unwrap()).lines();
        Watching { child, out, err }
    }

    /// Waits for this verdict on `spec`. A file that is being written may have another one before.
    fn until(&mut self, spec: &Path, verdict: &str) {
        let wanted = format!("{}: {verdict}", text(spec));
        loop {
            let line = self.out.next().expect("it watches").unwrap();
            assert!(!line.contains('\u{1b}'), "no screen is cleared in a pipe");
            if line == wanted {
                return;
            }
        }
    }

    /// Waits for these words on standard error.
    fn until_told(&mut self, words: &str) {
        while !self.err.next().expect("it watches").unwrap().contains(words) {}
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_file_that_changes_goes_and_comes_back_is_checked_again() {
    let dir = folder();
    let spec = dir.path().join("quad.mav");
    fs::write(&spec, QUAD).unwrap();
    let mut watching = Watching::new(&[text(&spec)]);
    watching.until(&spec, "no problems");
    fs::write(&spec, QUAD.replace("1.32 kg", "1.32 m")).unwrap();
    watching.until(&spec, "1 error");
    fs::remove_file(&spec).unwrap();
    watching.until_told("no such file");
    // As editors save: a neighbour takes its place.
    let neighbour = dir.path().join("quad.mav~");
    fs::write(&neighbour, QUAD).unwrap();
    fs::rename(&neighbour, &spec).unwrap();
    watching.until(&spec, "no problems");
}

#[test]
fn what_a_spec_uses_is_watched_even_before_it_is_there() {
    let dir = folder();
    let (spec, part) = (dir.path().join("missions/a.mav"), dir.path().join("vehicles/quad.mav"));
    fs::create_dir_all(spec.parent().unwrap()).unwrap();
    fs::create_dir_all(part.parent().unwrap()).unwrap();
    fs::write(&spec, "use \"../vehicles/quad.mav\"\n").unwrap();
    let mut watching = Watching::new(&[text(&spec)]);
    watching.until(&spec, "1 error");
    watching.until_told("Watching for changes");
    fs::write(&part, QUAD).unwrap();
    watching.until(&spec, "no problems");
    fs::write(&part, QUAD.replace("1.32 kg", "1.32 m")).unwrap();
    watching.until(&spec, "1 error");
}

#[test]
fn new_files_of_a_folder_are_found() {
    let dir = folder();
    let (first, second) = (dir.path().join("a.mav"), dir.path().join("deep/b.mav"));
    fs::write(&first, QUAD).unwrap();
    let mut watching = Watching::new(&[text(dir.path())]);
    watching.until(&first, "no problems");
    // Nothing that a check depends on: no round comes of it.
    fs::write(dir.path().join("notes.txt"), "x").unwrap();
    fs::create_dir(second.parent().unwrap()).unwrap();
    fs::write(&second, QUAD.replace("1.32 kg", "1.32 m")).unwrap();
    watching.until(&second, "1 error");
}

#[test]
fn standard_input_cannot_be_watched() {
    let ran = mavc_with(&["check", "--watch", "-"], QUAD);
    assert_eq!(code(&ran), 2);
    assert!(err(&ran).contains("--watch is for files"), "{}", err(&ran));
}
