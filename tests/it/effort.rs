//! What a search for a plan may take: the effort, and Ctrl-C.

use crate::cli::{code, err, folder, mavc, out, text};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

const SLALOM: &str = "benches/missions/known/slalom_quad.mav";
const RIP: &str = "plan.planner=rip";

/// With `quick` a slalom around five volumes is planned too, with less work; an unknown effort is refused.
#[test]
#[ignore = "long"]
fn a_quick_search_finds_a_plan_with_less_work() {
    let work = |effort: &str| {
        let ran = mavc(&["plan", "-v", SLALOM, "--set", RIP, "--effort", effort, "--timings"]);
        assert_eq!(code(&ran), 0, "{}", err(&ran));
        let report = err(&ran);
        let solver = report.lines().find(|line| line.contains(" work ")).unwrap().to_owned();
        let after = solver.split(" work ").nth(1).unwrap();
        after.split([',', ' ']).next().unwrap().parse::<f64>().unwrap()
    };
    let (quick, normal) = (work("quick"), work("normal"));
    assert!(quick < 0.5 * normal, "{quick} {normal}");
    let refused = mavc(&["plan", "-v", SLALOM, "--effort", "hasty"]);
    assert_eq!(code(&refused), 2, "{}", out(&refused));
}

/// The first Ctrl-C ends the search for a shortest time with its best plan, which is written; the exit code says so
/// unless that is accepted.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "long"]
fn ctrl_c_ends_a_search_with_its_best_plan() {
    let dir = folder();
    for (accepts, expected) in [(false, 130), (true, 0)] {
        let table = dir.path().join(format!("{accepts}.csv"));
        // A shell without job control starts background jobs with SIGINT ignored, and their children inherit that.
        let mut command = Command::new("env");
        command.args(["--default-signal=INT", env!("CARGO_BIN_EXE_mavc")]);
        command.args(["plan", SLALOM, "--set", RIP, "-o", text(&table)]);
        if accepts {
            command.arg("--accept-best");
        }
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        sleep(Duration::from_secs(2));
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        let ran = child.wait_with_output().unwrap();
        let (said, message) = (String::from_utf8_lossy(&ran.stdout), String::from_utf8_lossy(&ran.stderr));
        assert_eq!(ran.status.code(), Some(expected), "{message}");
        assert!(said.contains("PLAN FOUND") && said.contains("planner RIP"), "{said}");
        assert!(message.contains("cut short"), "{message}");
        assert!(std::fs::read_to_string(&table).unwrap().lines().count() > 200);
    }
}
