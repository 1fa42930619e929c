//! Where results go: files whole or absent, links, pipes, streams that fail.

use super::*;

/// `HOP` in a folder, over three files: the spec `hop.mav`, its vehicle `quad.mav` and the table `way.csv`.
fn hop_in(dir: &Path) -> PathBuf {
    let (vehicle, rest) = HOP.split_at(HOP.find("faults").unwrap());
    let rest = rest.replace("waypoint at [3, 1, 4] m", "waypoints from \"way.csv\"");
    let spec = dir.join("hop.mav");
    std::fs::write(&spec, format!("use \"quad.mav\"\n{rest}")).unwrap();
    std::fs::write(dir.join("quad.mav"), vehicle).unwrap();
    std::fs::write(dir.join("way.csv"), "x_m,y_m,z_m\n3,1,4\n").unwrap();
    spec
}

#[test]
fn results_never_replace_what_is_read() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    let spec = hop_in(dir.path());
    let read = ["hop.mav", "quad.mav", "way.csv"];
    let mut victims = read.map(at).to_vec();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("quad.mav", at("soft.mav")).unwrap();
        std::fs::hard_link(at("way.csv"), at("hard.csv")).unwrap();
        victims.extend([at("soft.mav"), at("hard.csv")]);
    }
    let before = read.map(|name| std::fs::read(at(name)).unwrap());
    for victim in &victims {
        for args in [["plan", "-o"], ["plan", "--report"], ["compare", "--report"]] {
            let ran = mavc(&[args[0], text(&spec), args[1], text(victim)]);
            assert_eq!(code(&ran), 2, "{args:?} {victim:?}: {}", err(&ran));
            assert!(err(&ran).contains("read: write to another file"), "{}", err(&ran));
            assert!(out(&ran).is_empty());
        }
    }
    assert_eq!(before, read.map(|name| std::fs::read(at(name)).unwrap()));
    let (one, same) = (at("one.csv"), dir.path().join("./one.csv"));
    for (table, report) in [(text(&one), text(&same)), ("-", "-")] {
        let ran = mavc(&["plan", "-v", text(&spec), "-o", table, "--report", report]);
        assert_eq!(code(&ran), 2);
        assert!(err(&ran).contains("same place"), "{}", err(&ran));
    }
    assert!(!one.exists());
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), victims.len());
}

#[cfg(unix)]
#[test]
fn results_keep_links_permissions_and_pipes() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    let spec = hop_in(dir.path());
    let plan = |target: &str| {
        let ran = mavc(&["plan", "-v", text(&spec), "-o", text(&at(target))]);
        assert_eq!(code(&ran), 0, "{target}: {}", err(&ran));
    };
    let has_table = |name: &str| std::fs::read_to_string(at(name)).unwrap().starts_with("t,x,y,z,");
    // A file that exists keeps its permissions, and a link stays a link to it.
    std::fs::create_dir(at("elsewhere")).unwrap();
    std::fs::write(at("elsewhere/real.csv"), "old").unwrap();
    std::fs::set_permissions(at("elsewhere/real.csv"), PermissionsExt::from_mode(0o600)).unwrap();
    symlink("elsewhere/real.csv", at("link.csv")).unwrap();
    plan("link.csv");
    assert!(at("link.csv").is_symlink() && has_table("elsewhere/real.csv"));
    assert_eq!(at("elsewhere/real.csv").metadata().unwrap().permissions().mode() & 0o777, 0o600);
    // A link to a file that is yet to be.
    symlink("elsewhere/later.csv", at("dangling.csv")).unwrap();
    plan("dangling.csv");
    assert!(at("dangling.csv").is_symlink() && has_table("elsewhere/later.csv"));
    assert_eq!(std::fs::read_dir(at("elsewhere")).unwrap().count(), 2);
    // A pipe is written.
    assert!(Command::new("mkfifo").arg(at("pipe")).status().unwrap().success());
    let pipe = at("pipe");
    let reader = std::thread::spawn(move || std::fs::read_to_string(pipe).unwrap());
    plan("pipe");
    assert!(at("pipe").metadata().unwrap().file_type().is_fifo());
    assert!(reader.join().unwrap().starts_with("t,x,y,z,"));
}

#[test]
fn a_report_on_standard_output_has_it_to_itself() {
    for command in ["plan", "compare"] {
        let ran = mavc_with(&[command, "-", "--report", "-"], HOP);
        assert_eq!(code(&ran), 0, "{}", err(&ran));
        let record: Value = serde_json::from_str(&out(&ran)).unwrap();
        assert_eq!(record["planners"][0]["verdict"], "found");
        assert!(!err(&ran).contains("Trajectory"), "{}", err(&ran));
    }
    let refused = mavc_with(&["plan", "-v", "-", "--report", "-", "--set", "plan.against=[M1]"], HOP);
    assert_eq!(code(&refused), 3);
    let record: Value = serde_json::from_str(&out(&refused)).unwrap();
    assert_eq!(record["planners"][0]["verdict"], "not attempted");
    assert!(!Path::new(env!("CARGO_MANIFEST_DIR")).join("-").exists());
}

/// Runs `mavc` on `HOP` with standard output going to `stdout`; the code and what is told on standard error.
#[cfg(unix)]
fn mavc_onto(args: &[&str], spec: &Path, stdout: Stdio) -> (i32, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(args.iter().map(|arg| if *arg == "SPEC" { text(spec) } else { arg }))
        .stdin(Stdio::null())
        .stdout(stdout)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Nobody reads.
    drop(child.stdout.take());
    let ended = child.wait_with_output().unwrap();
    (code(&ended), err(&ended))
}

#[cfg(unix)]
#[test]
fn standard_output_that_fails_is_an_error_and_one_that_is_closed_is_not() {
    let dir = folder();
    let spec = hop_in(dir.path());
    let table = dir.path().join("traj.csv");
    let vehicle = dir.path().join("quad.mav");
    for args in [
        vec!["emit", "model", "SPEC"],
        vec!["emit", "ast", "SPEC"],
        vec!["emit", "qp", "SPEC", "--format", "json"],
        vec!["analyze", "SPEC"],
        vec!["analyze", "SPEC", "--format", "json"],
        vec!["check", "SPEC"],
        vec!["plan", "SPEC", "-o", text(&table)],
        vec!["plan", "SPEC", "-o", "-"],
        vec!["compare", "SPEC"],
        vec!["explain"],
        vec!["explain", "mavc::unit::mismatch"],
        vec!["--help"],
    ] {
        let (closed, told) = mavc_onto(&args, &spec, Stdio::piped());
        assert_eq!(closed, 0, "{args:?}: {told}");
        assert!(!told.contains("standard output") && !told.contains("panicked"), "{args:?}: {told}");
        std::fs::remove_file(&table).ok();
        #[cfg(target_os = "linux")]
        {
            let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
            let (failed, told) = mavc_onto(&args, &spec, full.into());
            assert_eq!(failed, 2, "{args:?}: {told}");
            let message = "mavc: cannot write to standard output: No space left on device\n";
            assert!(told.ends_with(message), "{args:?}: {told}");
            assert!(!table.exists());
        }
    }
    // A broken spec is read and told on standard error alone: closed too, it is no matter.
    std::fs::write(&vehicle, "vehicle quad { mass = 1 m }\n").unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(["plan", text(&spec)])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stderr.take());
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

#[test]
fn rates_resample_evenly() {
    let ran = mavc_with(&["plan", "-v", "-", "-o", "-", "--rate", "7 Hz"], HOP);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    let times: Vec<f64> = out(&ran).lines().skip(1).map(|l| l.split(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(times.len(), 43);
    assert!((times[1] - 1.0 / 7.0).abs() < 1e-12);
    assert_eq!(*times.last().unwrap(), 6.0);
    let ran = mavc_with(&["plan", "-v", "-", "-o", "-", "--rate", "100kHz", "--set", "plan.time=20s"], HOP);
    assert_eq!(code(&ran), 2);
    let most = "the trajectory would have 2000001 rows of 30 numbers; at most 333333 rows are allowed";
    assert!(err(&ran).contains(most), "{}", err(&ran));
    let long = ["--set", "simulate.duration=20000s"];
    let ran = mavc_with(&[&["simulate", "-", "-o", "-"], &long[..]].concat(), HOP);
    assert_eq!(code(&ran), 2);
    assert!(
        err(&ran).contains("the log would have 2000000 rows of 42 numbers; at most 238095 rows are"),
        "{}",
        err(&ran)
    );
    for bad in ["7", "fast", "-3Hz", "1e9Hz", "nanHz"] {
        assert_eq!(code(&mavc_with(&["plan", "-v", "-", "--rate", bad], HOP)), 2, "{bad}");
    }
}

/// A comparison looks for every planner's shortest time, and takes fewer samples than one plan.
#[test]
fn comparisons_are_bounded() {
    let fine = ["-", "--set", "plan.time=6s", "--set", "plan.samples=1001"];
    assert_eq!(code(&mavc_with(&[&["check"], &fine[..]].concat(), HOP)), 0);
    let ran = mavc_with(&[&["compare"], &fine[..]].concat(), HOP);
    assert_eq!(code(&ran), 1);
    assert!(err(&ran).contains("1001 samples are too many to compare planners: at most 1000"), "{}", err(&ran));
}
