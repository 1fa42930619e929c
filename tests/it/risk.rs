//! Committed seconds, risk and its strip against sampling and another formulation; what a required risk chooses.

use crate::cli::{flat, mavc_with};
use crate::vehicles::{limit, lost, mission, octocopter, paper_case, viviani, waypoint};
use mavc::admissible::row::VIOLATED;
use mavc::model::{FaultMode, LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::motion::nearness::nearness;
use mavc::motion::risk::{rated_risk, risk};
use mavc::planner::hover::ACCEPTED;
use mavc::planner::studies::protect::{Protection, UNMET};
use mavc::planner::studies::{Comparison, MissionPlan, NotFound, PlanOutcome, Proof, Scope, run_planners};
use proptest::prelude::*;
use serde_json::Value;

fn run(model: &Model, scope: Scope) -> Comparison {
    run_planners(Problem::of(model).unwrap(), scope, None)
}

fn solved(comparison: &Comparison) -> &MissionPlan {
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(s) => s,
        other => panic!("{other:?}"),
    }
}

proptest! {
    /// Modes taken as independent: the mission is spared if each mode spares it.
    #[test]
    fn risk_is_what_no_mode_spares(modes in prop::collection::vec((0.0..1e-2f64, 0.0..100.0f64), 0..12)) {
        let spared: f64 = modes.iter().map(|(rate, committed)| (-rate * committed).exp()).product();
        prop_assert!((risk(modes) - (1.0 - spared)).abs() < 1e-12);
    }
}

#[test]
fn tiny_risks_keep_their_digits() {
    let rate = 1e-9 / 3600.0;
    assert!((risk([(rate, 15.0)]) / (rate * 15.0) - 1.0).abs() < 1e-11);
    assert_eq!(risk([]), 0.0);
}

/// A plan along the paper's curve that ignores faults, at a time at which it violates the set of rotor 1's loss.
fn careless(modes: &[usize]) -> Model {
    let mut model = paper_case(PlannerKind::Rip, modes);
    model.plan.samples = 100;
    model.plan.time = MissionTime::Fixed(17.0);
    model
}

#[test]
fn committed_until_the_last_sample_outside() {
    let model = careless(&[0, 3]);
    let comparison = run(&model, Scope::Plan);
    let s = solved(&comparison);
    let steps = 20_000;
    for (out, set) in s.outside.iter().zip(&comparison.sets) {
        let step = s.time / f64::from(steps);
        let is_out = |t: f64| {
            let w = s.trajectory.wrench(&model.vehicle, &model.environment(), &s.trajectory.at(t));
            set.rows.iter().any(|r| r.violation(&w) > VIOLATED)
        };
        let last = (0..=steps).rev().map(|i| f64::from(i) * step).find(|t| is_out(*t));
        assert!((out.committed() - last.unwrap_or(0.0)).abs() <= step, "{} {last:?}", out.committed());
    }
    assert!(s.outside.iter().any(|o| o.committed() > 0.0), "the plan leaves some set");
    // Only what has a rate counts.
    assert_eq!(rated_risk(&[None, None], &s.committed), None);
    let rate = 1e-3;
    let alone = rated_risk(&[Some(rate), None], &s.committed).unwrap();
    assert!((alone - (1.0 - (-rate * s.outside[0].committed()).exp())).abs() < 1e-12);
}

#[test]
fn strips_show_the_smallest_margin_of_each_part() {
    let model = careless(&[0]);
    let comparison = run(&model, Scope::Plan);
    let s = solved(&comparison);
    let rows = &comparison.sets[0].rows;
    let columns = 32;
    let strip = nearness(&s.trajectory, &model.vehicle, &model.environment(), rows, columns);
    let margin = |t: f64| {
        let w = s.trajectory.wrench(&model.vehicle, &model.environment(), &s.trajectory.at(t));
        rows.iter().map(|r| -r.violation(&w)).fold(f64::INFINITY, f64::min)
    };
    for (column, smallest) in strip.iter().enumerate() {
        let at = |i: i32| s.time * (column as f64 + (f64::from(i) + 0.5) / 400.0) / columns as f64;
        let sampled = (0..400).map(|i| margin(at(i))).fold(f64::INFINITY, f64::min);
        // The wrench is linear between nodes, so the smallest margin lies at a node or at an end.
        assert!(*smallest <= sampled + 1e-9 && *smallest >= sampled - 0.02, "{column}: {smallest} {sampled}");
    }
    let least = strip.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((least + s.outside[0].max_violation).abs() < 1e-9, "{least} {}", s.outside[0].max_violation);
}

/// All single losses, the curve, and a bound on the risk.
fn required(bound: f64, time: MissionTime) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = (1..=4).map(|k| FaultMode { rate: Some(1e-5 / 3600.0), ..lost(&model, &[k]) }).collect();
    model.mission = Some(viviani());
    model.plan.against = (0..4).collect();
    model.plan.samples = 40;
    model.plan.time = time;
    model.plan.require_risk = Some(bound);
    model
}

fn each_addition_takes_risk_away(time: MissionTime) {
    let free = required(0.9, time);
    let nothing = run(&free, Scope::Plan);
    // A bound that the RIP plan keeps needs no protection.
    assert_eq!(nothing.trade_off.len(), 1);
    assert_eq!(nothing.trade_off[0].added, Protection::Nothing);
    let before = nothing.trade_off[0].risk;
    assert!(before > 0.0, "the plan is committed to some mode");
    let bound = 0.3 * before;
    let model = required(bound, time);
    let found = run(&model, Scope::Plan);
    let s = solved(&found);
    let rates: Vec<Option<f64>> = model.modes.iter().map(|m| m.rate).collect();
    let kept = rated_risk(&rates, &s.committed).unwrap();
    assert!(kept <= bound, "{kept}");
    assert_eq!((found.trade_off[0].risk, found.trade_off.last().unwrap().risk), (before, kept));
    assert!(found.trade_off.len() > 1);
    assert!(found.trade_off.windows(2).all(|w| w[1].risk < w[0].risk && w[1].time >= w[0].time));
    // The plan is inside the set that it reports.
    for w in s.trajectory.node_wrenches(&model.vehicle, &model.environment()) {
        assert!(found.runs[0].set.rows.iter().all(|r| r.violation(&w) <= ACCEPTED));
    }
}

#[test]
fn a_required_risk_is_kept_and_each_addition_takes_risk_away() {
    each_addition_takes_risk_away(MissionTime::Fixed(18.0));
}

#[test]
fn a_risk_that_cannot_be_kept_is_reported_with_the_best_curve() {
    // At 16 s RIP has a plan and RCP jointly, from 16.83 s on, has none.
    let mut model = required(0.0, MissionTime::Fixed(16.2));
    model.plan.samples = 60;
    let found = run(&model, Scope::Plan);
    let outcome = &found.runs[0].outcome;
    assert!(
        matches!(outcome, PlanOutcome::NotFound(NotFound::Search { status, .. }) if status == UNMET),
        "{outcome:?}"
    );
    assert!(!found.trade_off.is_empty());
    // Where there is no plan at all, no risk is to blame.
    let early = run(&required(0.0, MissionTime::Fixed(12.0)), Scope::Plan);
    assert!(matches!(early.runs[0].outcome, PlanOutcome::Infeasible(Proof { .. })) && early.trade_off.is_empty());
}

/// A short way in the exact model, at 1.12 times the shortest time that is found for the healthy vehicle.
fn short(bound: Option<f64>) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = [1, 3].map(|k| FaultMode { rate: Some(1e-5 / 3600.0), ..lost(&model, &[k]) }).to_vec();
    let points = vec![waypoint([0.0, 0.0, 3.0], 0.0), waypoint([5.0, 2.0, 4.0], 0.0)];
    let limits = vec![limit(LimitKind::Tilt, 40f64.to_radians())];
    model.mission = Some(Mission { limits, ..mission(points) });
    model.plan.model = PlanModel::Exact;
    model.plan.planner = PlannerKind::Rip;
    model.plan.against = vec![0, 1];
    model.plan.samples = 20;
    let shortest = solved(&run(&model, Scope::Plan)).time;
    model.plan.time = MissionTime::Fixed((112.0 * shortest).round() / 100.0);
    model.plan.planner = PlannerKind::Rsp;
    model.plan.require_risk = bound;
    model
}

#[test]
#[ignore = "long"]
fn a_required_risk_is_kept_in_the_exact_model() {
    let mut model = short(Some(0.9));
    let nothing = run(&model, Scope::Plan);
    assert_eq!(nothing.trade_off.len(), 1);
    let before = nothing.trade_off[0].risk;
    assert!(before > 0.0, "the plan is committed to some mode");
    model.plan.require_risk = Some(0.5 * before);
    let found = run(&model, Scope::Plan);
    let s = solved(&found);
    let rates: Vec<Option<f64>> = model.modes.iter().map(|m| m.rate).collect();
    let kept = rated_risk(&rates, &s.committed).unwrap();
    assert!(kept <= 0.5 * before, "{kept} of {before}");
    assert!(found.trade_off.len() > 1 && found.trade_off.windows(2).all(|w| w[1].risk < w[0].risk));
    // Inside the set that it reports at instants of its own, and what is committed is the last of them outside.
    let steps = 20_000;
    let wrench = |t: f64| s.trajectory.wrench(&model.vehicle, &model.environment(), &s.trajectory.at(t));
    let instants = || (0..=steps).map(|i| s.time * f64::from(i) / f64::from(steps));
    let worst = |rows: &[mavc::admissible::row::SetRow], t: f64| {
        let w = wrench(t);
        rows.iter().map(|r| r.violation(&w)).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(instants().all(|t| worst(&found.runs[0].set.rows, t) <= 2e-4));
    for (set, committed) in found.sets.iter().zip(&s.committed) {
        let last = instants().rev().find(|t| worst(&set.rows, *t) > VIOLATED).unwrap_or(0.0);
        assert!((committed - last).abs() <= 2.0 * s.time / f64::from(steps), "{committed} {last}");
    }
}

/// A descent that no lost rotor can catch above the floor.
const DROP: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }
}
faults {
    mode weak { rotors [1, 2, 3, 4, 5, 6, 7, 8] reduced to 40 %; rate = 1e-4 1/h }
    mode tired { rotors [1, 2, 3, 4, 5, 6, 7, 8] reduced to 40 %; rate = 1e-4 1/h; after_fault = continue }
}
mission drop {
    start at [0, 0, 30] m
    waypoint at [0, 0, 2] m
    limits { altitude >= 1 m }
}
plan { planner = rip; time = 5 s; samples = 40; reserve = 0 %; after_fault = hold }
"#;

/// The text of a command over a spec on standard input, and its JSON report.
fn told(command: &str, spec: &str, arguments: &[&str]) -> (i32, String, Value) {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report.json");
    let mut all = vec![command, "-v", "-", "--report", report.to_str().unwrap()];
    all.extend(arguments);
    let ran = mavc_with(&all, spec);
    let text = String::from_utf8(ran.stdout).unwrap() + &String::from_utf8(ran.stderr).unwrap();
    let json = serde_json::from_str(&std::fs::read_to_string(&report).unwrap_or_else(|_| panic!("{text}"))).unwrap();
    (ran.status.code().unwrap(), text, json)
}

#[test]
fn reports_show_what_the_mission_does_after_each_fault() {
    for model in ["hover", "exact"] {
        let choice = format!("plan.model={model}");
        let (code, text, json) = told("plan", DROP, &["--set", &choice]);
        assert_eq!(code, 0, "{text}");
        let run = &json["planners"][0];
        let [weak, tired] = [0, 1].map(|i| &run["modes"][i]);
        assert_eq!((&weak["after_fault"], &tired["after_fault"]), (&"hold".into(), &"continue".into()));
        let [held, flown] = [weak, tired].map(|mode| mode["committed_s"].as_f64().unwrap());
        assert_eq!(tired["committed_s"], tired["last_violation_s"]);
        assert!(0.0 < held && held < flown, "{held} {flown}");
        let rate = 1e-4 / 3600.0;
        let risk = run["risk"].as_f64().unwrap();
        assert!((risk / (rate * (held + flown)) - 1.0).abs() < 1e-6, "{risk}");
        assert!(text.contains("last violation  after fault  committed"), "{text}");
        let row = |name: &str| text.lines().find(|l| l.trim_start().starts_with(name)).unwrap();
        let last_cells = |name: &str| row(name).split_whitespace().rev().take(3).collect::<Vec<_>>();
        assert_eq!(last_cells("weak"), ["s", &format!("{held:.2}"), "hold"], "{text}");
        assert_eq!(last_cells("tired"), ["s", &format!("{flown:.2}"), "continue"], "{text}");
        assert!(flat(&text).contains("a stop that was not found may exist, but is not counted"), "{text}");
    }
    // Where every mode continues the report has no such columns.
    let (_, text, json) = told("plan", DROP, &["--set", "plan.model=hover", "--set", "plan.against=[tired]"]);
    assert!(!text.contains("after fault") && flat(&text).contains("before its last violation"), "{text}");
    assert_eq!(json["planners"][0]["modes"][0]["after_fault"], "continue");
}

/// Under a changing yaw the hover model's wrench is not linear between nodes, where even RCP violates its rows
/// slightly.
#[test]
fn risk_says_where_it_counts_only_what_lies_between_samples() {
    let spec = r#"
vehicle octo {
    layout = "PPNNPPNN"
    arm = 0.211 m
    mass = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults { every 1 rotor lost as M { rate = 1e-5 1/h } }
mission turning {
    start at [0, 0, 2] m
    waypoint at [8, 2, 4] m yaw 120 deg
    waypoint at [3, 6, 3] m yaw -40 deg
    limits { tilt <= 20 deg }
}
plan { planner = rcp; model = hover; against = [M1, M2]; time = 5.1 s; samples = 40 }
"#;
    let said = "For M1 and M2 it counts only violations between samples, of at most";
    let told_of = |arguments: &[&str]| {
        let (code, text, json) = told("plan", spec, arguments);
        assert_eq!(code, 0, "{text}");
        let modes = json["planners"][0]["modes"].as_array().unwrap();
        let at_nodes = modes.iter().any(|mode| mode["violated_nodes"].as_u64().unwrap() > 0);
        let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
        (flat.contains(said), at_nodes, json["planners"][0]["risk"].as_f64().unwrap(), text)
    };
    let (is_told, at_nodes, risk, text) = told_of(&[]);
    assert!(is_told && !at_nodes && risk > 0.0, "{text}");
    // RIP is outside at nodes too, and a mode that never strikes counts for nothing.
    let (is_told, at_nodes, _, text) = told_of(&["--set", "plan.planner=rip", "--set", "plan.time=4.95s"]);
    assert!(!is_told && at_nodes, "{text}");
}

#[test]
fn comparisons_count_risk_by_what_is_done_after_a_fault() {
    let (code, text, json) = told("compare", DROP, &["--set", "plan.model=hover", "--set", "plan.against=[weak]"]);
    assert_eq!(code, 0, "{text}");
    let rip = json["planners"].as_array().unwrap().iter().find(|r| r["name"] == "rip").unwrap();
    let mode = &rip["modes"][0];
    let cell = |key: &str| format!("{:.2}", mode[key].as_f64().unwrap());
    let shown = format!("{} ({}; {})", cell("violation_duration_s"), cell("last_violation_s"), cell("committed_s"));
    assert!(text.contains(&shown), "{shown}\n{text}");
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(flat.contains("with `hold` also the last instant without a stop"), "{text}");
}

/// A descent that the faulty vehicle can fly, with a bound on the risk.
fn slower(bound: f64) -> String {
    DROP.replace("time = 5 s", "time = 8 s").replace("planner = rip", &format!("require risk <= {bound}"))
}

#[test]
fn a_required_risk_counts_stops() {
    // With more time the descent can be stopped from everywhere, though it ends outside: who holds need protect
    // nothing.
    let bound = 7.0 * 1e-4 / 3600.0;
    let spec = slower(bound);
    let keep = |after: &str| {
        let after = format!("plan.after_fault={after}");
        let against = "plan.against=[weak]";
        told("plan", &spec, &["--set", "plan.model=hover", "--set", &after, "--set", against])
    };
    let [(held, text, json), (continued, other, trade)] = ["hold", "continue"].map(keep);
    assert_eq!((held, continued), (0, 0), "{text}\n{other}");
    let steps = |json: &Value| json["trade_off"].as_array().unwrap().clone();
    // The screen shows what is allowed beside the risk.
    let chosen = ["--set", "plan.model=hover", "--set", "plan.after_fault=hold", "--set", "plan.against=[weak]"];
    let screen = mavc_with(&[&["plan", "-"], &chosen[..]].concat(), &spec);
    let screen = flat(&String::from_utf8(screen.stdout).unwrap());
    assert!(screen.contains(" risk ") && screen.contains(" (1.94e-7 allowed)"), "{screen}");
    assert_eq!(steps(&json).len(), 1, "{text}");
    assert!(steps(&trade).len() > 1, "{other}");
    for (text, json) in [(&text, &json), (&other, &trade)] {
        let curve = steps(json);
        assert_eq!(curve[0]["added"], "nothing");
        let (last, run) = (curve.last().unwrap(), &json["planners"][0]);
        assert_eq!((&last["risk"], &last["time_s"]), (&run["risk"], &run["time_s"]));
        assert!(last["risk"].as_f64().unwrap() <= bound);
        assert!(text.contains("Protection for a risk of at most") && text.contains("nothing"), "{text}");
        assert_eq!(text.lines().filter(|l| l.trim_start().starts_with("+ ")).count(), curve.len() - 1, "{text}");
    }
}

#[test]
fn a_required_risk_is_reported_in_the_exact_model() {
    let bound = 5.0 * 1e-4 / 3600.0;
    let spec = slower(bound);
    let chosen = ["--set", "plan.against=[tired]", "--set", "plan.samples=20"];
    let (code, text, json) = told("plan", &spec, &chosen);
    assert_eq!(code, 0, "{text}");
    let curve = json["trade_off"].as_array().unwrap();
    assert!(curve.len() > 1 && curve[0]["risk"].as_f64() > Some(bound), "{text}");
    assert!(curve.last().unwrap()["risk"].as_f64().unwrap() <= bound);
    assert_eq!((&json["model"], &json["planners"][0]["verdict"]), (&"exact".into(), &"found".into()));
    assert!(text.contains("exact model") && text.contains("Protection for a risk"), "{text}");
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_required_risk_is_kept_in_the_shortest_time() {
        each_addition_takes_risk_away(MissionTime::Minimum);
    }

    #[test]
    #[ignore = "long"]
    fn the_facet_passed_last_is_among_what_is_tried() {
        // At the shortest times adding one facet is cheaper than adding all that are violated.
        let finer = |bound: f64| {
            let mut model = required(bound, MissionTime::Minimum);
            model.plan.samples = 60;
            run(&model, Scope::Plan)
        };
        let found = finer(0.9 * finer(0.9).trade_off[0].risk);
        let added: Vec<&Protection> = found.trade_off.iter().map(|step| &step.added).collect();
        assert!(matches!(added[1], Protection::Facets { facets: 1, .. }), "{added:?}");
    }
}
