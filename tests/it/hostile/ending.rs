//! Runs that are ended from outside leave nothing behind, or the next one takes it away.

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A campaign with more flights than any machine flies meanwhile.
const MANY: [&str; 5] = ["campaign", "hop.mav", "--seeds", "20000", "--quiet"];

fn desk() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("hop.mav"), crate::cli::HOP).unwrap();
    dir
}

fn spawn(folder: &Path, args: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(args)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn kill(child: &Child, signal: &str) {
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
}

/// The signals that end a program, with their numbers, except those that this process was started to ignore (`nohup`, a
/// job in the background of a script): programs that it starts ignore them too.
fn deadly() -> Vec<(&'static str, i32)> {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = mask.map_or(0, |mask| u64::from_str_radix(mask.trim(), 16).unwrap());
    let all = [("-INT", 2), ("-TERM", 15), ("-HUP", 1)];
    all.into_iter().filter(|(_, number)| ignored & (1 << (number - 1)) == 0).collect()
}

fn temporary(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with(".mavc-")).collect()
}

fn rows(part: &Path) -> usize {
    fs::read(part).map_or(0, |bytes| bytes.iter().filter(|b| **b == b'\n').count())
}

/// Until something is so, while the process runs.
fn until(child: &mut Child, so: impl Fn() -> bool) {
    while !so() {
        assert!(child.try_wait().unwrap().is_none(), "it has ended");
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn last_words(child: &mut Child) -> (std::process::ExitStatus, String) {
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    (child.wait().unwrap(), said)
}

#[test]
fn a_campaign_that_is_interrupted_says_how_to_go_on() {
    use std::os::unix::process::ExitStatusExt;
    let dir = desk();
    let part = dir.path().join("rows.csv.part");
    let mut before = 0;
    for (signal, number) in deadly() {
        let mut child = spawn(dir.path(), &[&MANY[..], &["-o", "rows.csv"]].concat());
        until(&mut child, || rows(&part) > before + 20);
        kill(&child, signal);
        let (status, said) = last_words(&mut child);
        // As the shell expects: ended by the signal.
        assert_eq!(status.signal(), Some(number), "{said}");
        before = rows(&part);
        let line = said
            .lines()
            .find(|line| line.contains("the same command continues from there"))
            .unwrap_or_else(|| panic!("{said}"));
        let done: usize = line.split(' ').nth(1).unwrap().parse().unwrap();
        // A chunk may have been written whose rows are not counted yet.
        assert!(done < before && done > 20, "{line}, and {before} lines are there");
        assert_eq!(temporary(dir.path()), Vec::<String>::new());
    }
}

#[test]
#[ignore = "long"]
fn without_a_file_nothing_can_be_gone_on_with() {
    let said_after = |seconds: u64| {
        let dir = desk();
        let mut child =
            spawn(dir.path(), &["campaign", "hop.mav", "--seeds", "20000", "-o", "/dev/null", "--threads", "1"]);
        std::thread::sleep(Duration::from_secs(seconds));
        kill(&child, "-TERM");
        last_words(&mut child).1
    };
    // Only once flights are flown is something said of them, which takes longer on a busy machine.
    let is_said = |seconds: &u64| said_after(*seconds).contains("the flights are not kept: with `-o rows.csv`");
    assert!([3, 10, 30, 90].iter().any(is_said));
}

#[test]
fn an_ignored_signal_stays_ignored() {
    let dir = desk();
    let part = dir.path().join("rows.csv.part");
    let program = env!("CARGO_BIN_EXE_mavc");
    let line = format!("trap '' HUP; exec {program} {} -o rows.csv", MANY.join(" "));
    let mut child = Command::new("sh")
        .args(["-c", &line])
        .current_dir(dir.path())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    until(&mut child, || rows(&part) > 5);
    kill(&child, "-HUP");
    let seen = rows(&part);
    until(&mut child, || rows(&part) > seen + 40);
    child.kill().unwrap();
    child.wait().unwrap();
}

/// A plan whose trajectory stands in its temporary file, held up by a report that goes to a pipe nobody reads.
fn held_up(dir: &Path) -> Child {
    if !dir.join("pipe").exists() {
        assert!(Command::new("mkfifo").arg(dir.join("pipe")).status().unwrap().success());
    }
    let mut child = spawn(dir, &["plan", "hop.mav", "-o", "o.csv", "--report", "pipe"]);
    let is_written = || temporary(dir).iter().any(|name| fs::metadata(dir.join(name)).is_ok_and(|m| m.len() > 0));
    until(&mut child, is_written);
    child
}

#[test]
fn temporary_files_go_on_signals() {
    let dir = desk();
    for (signal, _) in deadly() {
        let mut child = held_up(dir.path());
        kill(&child, signal);
        assert!(!child.wait().unwrap().success());
        assert_eq!(temporary(dir.path()), Vec::<String>::new(), "{signal}");
    }
}

#[test]
fn a_limit_on_sizes_is_an_error_and_leaves_nothing() {
    let dir = desk();
    let line = format!("ulimit -f 1; exec {} plan hop.mav -o o.csv", env!("CARGO_BIN_EXE_mavc"));
    let ran = Command::new("sh").args(["-c", &line]).current_dir(dir.path()).output().unwrap();
    assert_eq!(ran.status.code(), Some(2), "{ran:?}");
    assert!(String::from_utf8_lossy(&ran.stderr).contains("cannot write o.csv"));
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
}
