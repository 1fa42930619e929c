//! What flights of a campaign are lost to, and those of which nothing is known.

use super::*;
use crate::cli::flat;

const SIZE: [&str; 7] = ["spin.mav", "--times", "2", "--seeds", "1", "--quiet", "-v"];

/// An octocopter with a mode that leaves no torque about the vertical, and one that leaves no vehicle.
fn desk(more: &str) -> Desk {
    let desk = Desk::new();
    let vehicle = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs/vehicles/octo_ppnnppnn.mav");
    let text = format!(
        "use \"{}\"\nfaults {{ mode spin {{ rotors [1, 2] lost }}\n mode dead {{ rotors [1, 2, 3, 4] lost }} }}\n\
         mission hop {{ start at [0, 0, 2] m\n waypoint at [4, 1, 4] m }}\n\
         plan {{ model = hover; planner = rip; against = []; time = 12 s; samples = 40; without_yaw = never }}\n\
         campaign {{ planners = rip }}\n{more}\n",
        vehicle.display()
    );
    std::fs::write(desk.path("spin.mav"), text).unwrap();
    desk
}

fn rows(desk: &Desk) -> Vec<Row> {
    desk.lines("rows.csv")[1..].iter().map(|line| Row::read(line).unwrap()).collect()
}

#[test]
fn vehicles_that_spin_are_lost_and_the_table_says_to_what() {
    let simulate = "simulate { detection = 50 ms; duration = 20 s; lost_yaw = LIMIT }";
    for (limit, survives) in [("90 deg", false), ("off", true)] {
        let desk = desk(&simulate.replace("LIMIT", limit));
        let ran = desk.command(&[&SIZE[..], &["-o", "rows.csv", "--report", "r.json"]].concat()).output().unwrap();
        assert_eq!(ran.status.code(), Some(0), "{}", text(&ran));
        let printed = text(&ran);
        let spins: Vec<Row> = rows(&desk).into_iter().filter(|r| r.mode == "spin").collect();
        assert!(spins.len() == 2 && spins.iter().all(|r| r.is_survived() == survives && r.max_error < 1.0));
        assert!(spins.iter().all(|r| r.max_heading_error_after.is_some_and(|e| e > 1.5) && r.rms_heading_error > 0.1));
        assert_eq!(spins.iter().all(|r| r.turns >= 1), survives, "{spins:?}");
        let record: Value = serde_json::from_slice(&desk.bytes("r.json")).unwrap();
        crate::schemas::schema("campaign").assert_valid(&record);
        let of = |mode: usize| record["planners"][0]["modes"][mode]["flights"].clone();
        assert_eq!((of(0)["lost_by_heading"] == 2, of(0)["lost"] == 0), (!survives, survives), "{record}");
        let line = |mode: &str| printed.lines().find(|l| l.trim_start().starts_with(mode)).unwrap().to_string();
        assert_eq!(line("spin ").ends_with("  2 heading"), !survives, "{printed}");
        assert!(line("healthy").ends_with("  -") && !line("dead").ends_with("  -"), "{printed}");
        assert_eq!(
            flat(&printed).contains("heading 90 degrees off for 1 s or at the end, or on the ground"),
            !survives,
            "{printed}"
        );
        assert!(of(0)["max_heading_error_rad"].is_null() != survives);
    }
}

/// If two planners share a plan, the agreement of predictions with losses counts it once.
#[test]
fn one_plan_of_two_planners_counts_once() {
    let desk = desk("simulate { detection = 50 ms }");
    let both = ["--set", "campaign.planners=[rip,rsp]", "-o", "rows.csv", "--report", "r.json"];
    let ran = desk.command(&[&SIZE[..], &both].concat()).output().unwrap();
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran));
    let words = text(&ran).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("A plan that several planners share is counted once"));
    let record: Value = serde_json::from_slice(&desk.bytes("r.json")).unwrap();
    let tables = record["agreement"][0]["by_flight"].as_array().unwrap();
    let counts = |i: usize| ["hits", "misses", "false_alarms", "correct_negatives"].map(|of| tables[i][of].as_u64());
    assert_eq!(tables.len(), 3);
    assert!(counts(1) == counts(2) && counts(0) == counts(1) && counts(0) != [Some(0); 4], "{tables:?}");
}

/// Nothing is known of a flight whose integration breaks down: it is not lost, not survived, and the command says so.
#[test]
fn flights_that_diverge_are_counted_apart_and_end_with_9() {
    let desk = desk("simulate { detection = 50 ms }");
    let tiny = ["--set", "vehicle.inertia=[1e-12,1e-12,1e-12]kg*m^2", "-o", "rows.csv", "--report", "r.json"];
    let ran = desk.command(&[&SIZE[..], &tiny].concat()).output().unwrap();
    assert_eq!(ran.status.code(), Some(9), "{}", text(&ran));
    let all = rows(&desk);
    let diverged = desk.lines("rows.csv").iter().filter(|line| line.contains(",diverged,,")).count();
    assert!(diverged >= 2 && all.iter().filter(|r| !r.is_lost() && !r.is_survived()).count() == diverged, "{all:?}");
    let printed = text(&ran);
    assert!(printed.contains(&format!("{diverged} flights diverged: the integration broke down")), "{printed}");
    let record: Value = serde_json::from_slice(&desk.bytes("r.json")).unwrap();
    crate::schemas::schema("campaign").assert_valid(&record);
    let modes = record["planners"][0]["modes"].as_array().unwrap();
    let count = |group: &Value| group["diverged"].as_u64().unwrap() as usize;
    let healthy = count(&record["planners"][0]["healthy"]);
    assert_eq!(modes.iter().map(|m| count(&m["flights"])).sum::<usize>() + healthy, diverged);
    assert!(modes.iter().all(|m| m["flights"]["survival"]["share"] == 0.0));
}
