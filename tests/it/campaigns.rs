//! Campaigns: statistics against values worked by hand, cases, rows, and shards as schedulers run them.

mod agreement;
mod columns;
mod losses;
mod statistics;

use mavc::campaign::cases::{Cases, Shard, fault_time, noise_seed};
use mavc::campaign::columns::COLUMNS;
use mavc::campaign::rows::{Row, header};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A quadcopter that hops; without rotor 2 it is lost.
const HOP: &str = r#"
vehicle quad {
    layout  = "PNPN"
    arm     = 0.211 m
    mass    = 1.32 kg
    inertia = [0.0128, 0.0128, 0.0239] kg*m^2
    rotor { thrust_coefficient = 9.9865e-6 N*s^2/rad^2; drag_coefficient = 1.5978e-7 N*m*s^2/rad^2; max_speed = 840 rad/s }
}
faults {
    mode gone { rotor 2 lost; without_yaw = never }
    mode weak { rotor 1 reduced to 85 % }
}
mission hop {
    start at [0, 0, 2] m
    waypoint at [3, 1, 4] m
}
plan { model = hover; planner = rsp; against = [weak]; time = 4 s; samples = 40 }
"#;

/// A folder with the spec.
struct Desk {
    folder: tempfile::TempDir,
}

impl Desk {
    fn new() -> Desk {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("hop.mav"), HOP).unwrap();
        Desk { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mavc"));
        command.arg("campaign").args(args).current_dir(self.folder.path()).env("NO_COLOR", "1");
        command
    }

    /// Runs `mavc campaign`, which must end with `code`; what it says on standard error.
    fn run(&self, args: &[&str], code: i32) -> String {
        let ran = self.command(args).output().unwrap();
        assert_eq!(ran.status.code(), Some(code), "{args:?}\n{}", text(&ran));
        String::from_utf8(ran.stderr).unwrap()
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    fn lines(&self, name: &str) -> Vec<String> {
        String::from_utf8(self.bytes(name)).unwrap().lines().map(String::from).collect()
    }
}

fn text(ran: &Output) -> String {
    String::from_utf8_lossy(&ran.stdout).into_owned() + &String::from_utf8_lossy(&ran.stderr)
}

#[test]
fn cases_are_every_combination_once() {
    let cases = Cases { planners: 3, modes: 4, times: 5, seeds: 2 };
    assert_eq!(cases.count(), 3 * (1 + 4 * 5) * 2);
    let all: Vec<_> = cases.of(Shard::WHOLE).collect();
    let key = |c: &mavc::campaign::cases::Case| (c.planner, c.strike.map(|s| (s.mode, s.time)), c.seed);
    let seen: BTreeSet<_> = all.iter().map(key).collect();
    assert_eq!(seen.len(), cases.count());
    assert_eq!(seen.iter().filter(|(_, strike, _)| strike.is_none()).count(), 3 * 2);
    assert!(all.iter().enumerate().all(|(k, case)| case.number == k && cases.case(k) == *case));
    // Paired flights are neighbours.
    assert_eq!((all[6].strike, all[6].seed, all[7].seed), (all[7].strike, 0, 1));
    // Shards part them.
    let mut parted = Vec::new();
    for index in 0..4 {
        let shard = Shard { index, of: 4 };
        let part: Vec<_> = cases.of(shard).collect();
        assert_eq!(part.len(), shard.count(cases.count()));
        assert!(part.iter().all(|case| case.number % 4 == index));
        parted.extend(part);
    }
    parted.sort_by_key(|case| case.number);
    assert_eq!(parted, all);
    let instants: Vec<f64> = (0..4).map(|k| fault_time(8.0, 4, k)).collect();
    assert_eq!(instants, [1.0, 3.0, 5.0, 7.0]);
}

#[test]
fn noise_depends_on_the_seeds_alone() {
    let seeds: BTreeSet<u64> = (0..1000).flat_map(|s| [noise_seed(1, s), noise_seed(2, s)]).collect();
    assert_eq!(seeds.len(), 2000);
}

#[test]
fn rows_read_back_as_written_and_strictly() {
    // The checksum by `printf %s '00ff...,2,1' | sha256sum`.
    let line = "00ff00ff00ff00ff,153,7,rsp,weak,0.25,1,lost,upside_down,1.398,0.1,2.5,1e-7,2.25,0.5,1.6,0.5,0.75,0.7,3,true,5,4,\
                speed+tilt,0.01,,2,1,2645a808";
    let row = Row::read(line).unwrap();
    assert_eq!(row.line(), line);
    assert!(row.is_lost() && !row.is_lost_before());
    assert_eq!(line.split(',').count(), COLUMNS.len());
    for (from, to) in [
        ("00ff00ff", "00FF00FF"),
        (",lost,", ",flown,"),
        ("upside_down", "boredom"),
        ("1.398", "inf"),
        (",2,1", ",2,-1"),
        (",2,1", ",2"),
        ("0.25", "soon"),
        // What reads as a number and is not as mavc writes it, and digits that were changed.
        (",153,", ",+153,"),
        (",7,", ",07,"),
        ("0.25", "0.250"),
        ("1.398", "1.399"),
        ("rsp", "rip"),
        ("speed+tilt", "tilt+speed"),
        ("speed+tilt", "mood"),
        ("speed+tilt", ""),
        ("true", "yes"),
    ] {
        assert!(Row::read(&line.replacen(from, to, 1)).is_err(), "{from} as {to}");
    }
}

#[test]
fn threads_never_change_the_rows() {
    let desk = Desk::new();
    let run = |rows: &str, report: &str, threads: &str| {
        let args = [
            "hop.mav",
            "--times",
            "5",
            "--seeds",
            "2",
            "-o",
            rows,
            "--report",
            report,
            "--threads",
            threads,
            "--quiet",
        ];
        desk.run(&args, 0);
    };
    run("a.csv", "a.json", "1");
    run("b.csv", "b.json", "2");
    assert!(desk.bytes("a.csv") == desk.bytes("b.csv"));
    assert!(desk.bytes("a.json") == desk.bytes("b.json"));
    let lines = desk.lines("a.csv");
    assert_eq!(lines[0], header());
    assert_eq!(lines.len(), 1 + 3 * (1 + 2 * 5) * 2);
    // The same noise for every plan: without a fault RSP flies as RIP where it plans the same.
    let rows: Vec<Row> = lines[1..].iter().map(|l| Row::read(l).unwrap()).collect();
    assert!(rows.iter().filter(|r| r.mode == "healthy").all(|r| !r.is_lost() && r.fault_time.is_none()));
    assert!(rows.iter().any(|r| r.mode == "gone" && r.is_lost()));
    assert!(rows.iter().all(|r| r.mode != "weak" || !r.is_lost()));
    // Standard output, rows that are tallied again, and a report of them: all the same.
    let streamed = desk.command(&["hop.mav", "--times", "5", "--seeds", "2", "-o", "-", "--quiet"]).output().unwrap();
    assert!(streamed.stdout == desk.bytes("a.csv"));
    desk.run(&["hop.mav", "--times", "5", "--seeds", "2", "--rows", "a.csv", "--report", "c.json"], 0);
    assert!(desk.bytes("c.json") == desk.bytes("a.json"));
    // Other options are another campaign.
    let other = desk.run(&["hop.mav", "--times", "5", "--seeds", "3", "--rows", "a.csv"], 2);
    assert!(other.contains("rows of another campaign"), "{other}");
}

#[test]
fn four_shards_one_of_them_killed_merge_to_the_bytes_of_one_run() {
    let desk = Desk::new();
    let size = ["hop.mav", "--times", "5", "--seeds", "8", "--quiet"];
    let with = |more: &[&'static str]| -> Vec<&'static str> { size.iter().chain(more).copied().collect() };
    desk.run(&with(&["-o", "whole.csv"]), 0);
    let whole = desk.bytes("whole.csv");

    // Shard 3 is killed once some rows are on disk.
    let third = with(&["-o", "3.csv", "--shard", "3/4", "--threads", "1"]);
    let mut child = desk.command(&third).stdout(std::process::Stdio::null()).spawn().unwrap();
    let part = desk.path("3.csv.part");
    let rows = |path: &Path| std::fs::read(path).map_or(0, |b| b.iter().filter(|b| **b == b'\n').count());
    while rows(&part) < 20 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it was killed");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!desk.path("3.csv").exists());
    let left = desk.bytes("3.csv.part");
    let first: Vec<u8> = left.clone();

    // The others run as separate processes, side by side.
    let spawn = |args: Vec<&'static str>| desk.command(&args).stdout(std::process::Stdio::null()).spawn().unwrap();
    let others = [
        spawn(with(&["-o", "1.csv", "--shard", "1/4", "--threads", "1"])),
        spawn(with(&["-o", "2.csv", "--shard", "2/4", "--threads", "2"])),
        spawn(with(&["-o", "4.csv", "--shard", "4/4", "--threads", "1"])),
    ];
    for mut child in others {
        assert!(child.wait().unwrap().success());
    }
    // What is missing is named.
    let told = desk.run(&["merge", "-o", "all.csv", "1.csv", "2.csv", "4.csv"], 2);
    assert!(told.contains("cases are missing, cases 2, 6, 10, 14, 18 and 61 more: they belong to shard 3/4"), "{told}");
    let told = desk.run(&["merge", "-o", "all.csv", "1.csv", "2.csv", "3.csv.part", "4.csv"], 2);
    assert!(told.contains("belong to shard 3/4") || told.contains("is incomplete"), "{told}");
    assert!(!desk.path("all.csv").exists());

    // A torn last line, as a machine that stops may leave it.
    let mut torn = first.clone();
    torn.extend_from_slice(&first[first.len() / 2..first.len() / 2 + 11]);
    std::fs::write(&part, &torn).unwrap();
    let told = desk.command(&third.iter().copied().filter(|a| *a != "--quiet").collect::<Vec<_>>()).output().unwrap();
    assert!(told.status.success(), "{}", text(&told));
    let done = first.iter().filter(|b| **b == b'\n').count() - 1;
    assert!(text(&told).contains(&format!("continuing after {done} of 66 flights")), "{}", text(&told));
    assert!(desk.bytes("3.csv").starts_with(&first));
    assert!(!part.exists());

    desk.run(&["merge", "-o", "all.csv", "4.csv", "2.csv", "1.csv", "3.csv", "--quiet"], 0);
    assert!(desk.bytes("all.csv") == whole);
    // Once more: nothing to fly, and nothing changes.
    let told = desk.run(&third.iter().copied().filter(|a| *a != "--quiet").collect::<Vec<_>>(), 0);
    assert!(told.contains("all 66 flights are there, nothing to fly"), "{told}");

    // A shard given twice.
    let told = desk.run(&["merge", "-o", "all.csv", "1.csv", "2.csv", "3.csv", "4.csv", "2.csv"], 2);
    assert!(told.contains("case 1 is in both 2.csv and 2.csv"), "{told}");
    // Nothing is written over a file that is read, and other rows are not joined.
    let told = desk.run(&["merge", "-o", "1.csv", "1.csv", "2.csv"], 2);
    assert!(told.contains("a file that is read"), "{told}");
    desk.run(&["hop.mav", "--times", "2", "--seeds", "1", "-o", "other.csv", "--quiet"], 0);
    let told = desk.run(&["merge", "-o", "all.csv", "1.csv", "2.csv", "other.csv", "4.csv"], 2);
    assert!(told.contains("other.csv, line 2: a row of campaign"), "{told}");
    assert!(desk.bytes("all.csv") == whole);
}

#[test]
fn rows_of_another_campaign_or_shard_are_not_gone_on_with() {
    let desk = Desk::new();
    desk.run(&["hop.mav", "--times", "2", "--seeds", "1", "-o", "rows.csv", "--shard", "1/2", "--quiet"], 0);
    std::fs::copy(desk.path("rows.csv"), desk.path("rows.csv.part")).unwrap();
    std::fs::remove_file(desk.path("rows.csv")).unwrap();
    let before = desk.bytes("rows.csv.part");
    // Another number of seeds, other text, another override, another shard.
    for (args, what) in [
        (vec!["--times", "2", "--seeds", "2"], "rows of another campaign"),
        (vec!["--times", "2", "--seeds", "1", "--set", "plan.reserve=1%"], "rows of another campaign"),
        (vec!["--times", "2", "--seeds", "1", "--shard", "2/2"], "as in rows of another shard"),
    ] {
        let args: Vec<&str> = ["hop.mav", "-o", "rows.csv"].into_iter().chain(args).collect();
        let told = desk.run(&args, 2);
        assert!(told.contains(what) && told.contains("delete it to start again"), "{told}");
        assert!(desk.bytes("rows.csv.part") == before && !desk.path("rows.csv").exists());
    }
    // Damage in the middle is no torn end.
    let damaged = String::from_utf8(before.clone()).unwrap().replacen(",flown,", ",fl\u{fffd}wn,", 1);
    std::fs::write(desk.path("rows.csv.part"), damaged).unwrap();
    let told = desk.run(&["hop.mav", "--times", "2", "--seeds", "1", "-o", "rows.csv"], 2);
    assert!(told.contains("rows.csv.part, line 2: ") && told.contains("is not a valid outcome"), "{told}");
    // Nor are finished rows of another campaign replaced: they may have taken hours.
    std::fs::remove_file(desk.path("rows.csv.part")).unwrap();
    std::fs::write(desk.path("rows.csv"), &before).unwrap();
    let told = desk.run(&["hop.mav", "--times", "1", "--seeds", "1", "-o", "rows.csv", "--quiet"], 2);
    assert!(told.contains("rows.csv holds rows of another campaign"), "{told}");
    assert!(desk.bytes("rows.csv") == before);
    // What is no campaign's may be.
    std::fs::write(desk.path("rows.csv"), "old notes\n").unwrap();
    desk.run(&["hop.mav", "--times", "1", "--seeds", "1", "-o", "rows.csv", "--quiet"], 0);
    assert_eq!(desk.lines("rows.csv").len(), 1 + 3 * 3);
}

#[test]
fn wrong_usage_ends_with_2() {
    let desk = Desk::new();
    for args in [
        &["hop.mav", "--shard", "0/4"][..],
        &["hop.mav", "--shard", "5/4"],
        &["hop.mav", "--shard", "half"],
        &["hop.mav", "--times", "0"],
        &["hop.mav", "--times", "10000", "--seeds", "1000000"],
        &["hop.mav", "-o", "rows.csv", "--report", "rows.csv"],
        &["hop.mav", "-o", "rows.csv", "--report", "rows.csv.part"],
        &["hop.mav", "-o", "hop.mav"],
        &["hop.mav", "-o", "rows.csv", "--rows", "rows.csv"],
        &["hop.mav", "--rows", "nowhere.csv"],
        &["merge", "-o", "all.csv"],
        &["merge", "-o", "all.csv", "hop.mav"],
        &[],
    ] {
        desk.run(args, 2);
    }
    assert_eq!(std::fs::read_dir(desk.folder.path()).unwrap().count(), 1);
}

#[test]
fn reports_are_as_their_schema_says() {
    let desk = Desk::new();
    let schema = crate::schemas::schema("campaign");
    let report = |name: &str| -> Value { serde_json::from_slice(&desk.bytes(name)).unwrap() };
    let size = ["hop.mav", "--times", "3", "--seeds", "2", "--report", "r.json"];
    desk.run(&[&size[..], &["--shard", "2/3"]].concat(), 0);
    schema.assert_valid(&report("r.json"));
    assert_eq!(report("r.json")["shard"]["index"], 2);
    desk.run(&size, 0);
    let whole = report("r.json");
    schema.assert_valid(&whole);
    assert_eq!(whole["flights"], whole["cases"]);
    let gone = &whole["planners"][0]["modes"][0];
    assert_eq!((&gone["name"], &gone["hover_inside"]), (&Value::from("gone"), &Value::from(false)));
    assert_eq!(gone["last_violation_s"], 4.0);
    assert_eq!(gone["flights"]["survival"]["share"], 0.0);
    agreement::are_those_of_the_rows(&desk, &whole);
    for pointer in [
        "",
        "/planners/0",
        "/planners/0/modes/0",
        "/planners/0/modes/0/flights",
        "/agreement/0/by_flight/0",
        "/planners/0/healthy/path",
        "/planners/0/modes/0/times/0",
    ] {
        let mut more = whole.clone();
        more.pointer_mut(pointer).unwrap()["surplus"] = 1.into();
        assert!(!schema.is_valid(&more), "{pointer} may have any member");
    }

    // A time too short for any plan, and a mode that cannot be tolerated: exit code 3, with a report.
    desk.run(&[&size[..], &["--set", "plan.time=0.2s"]].concat(), 3);
    schema.assert_valid(&report("r.json"));
    assert_eq!(report("r.json")["planners"][0]["verdict"], "proved infeasible");
    desk.run(&[&size[..], &["--set", "plan.against=[gone]"]].concat(), 3);
    schema.assert_valid(&report("r.json"));
}
