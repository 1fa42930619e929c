//! Words: a verdict, a flight and the edge of a set have one word each in the terminal, JSON and on the page, and no
//! word says more than was shown.

use crate::cli::mavc_with;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::edge::{EDGE, HoverPlace};
use mavc::admissible::verdict::analyze;
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::studies::{PlanOutcome, Proof, Run, Scope, run_planners};
use mavc::report::record::Record;
use mavc::report::waypoints::{WaypointRecord, headline, listed, table, waypoints};
use mavc::report::{comparison_text, terminal};
use mavc::verdict::Verdict;
use mavc::verify::plan::MOST_MISS;
use serde_json::Value;

use crate::vehicles::{hexacopter, limit, lost, mission, octocopter, ring_model, waypoint};

const HEXA: &str = r#"vehicle hexa {
    layout  = "PNPNPN"
    arm     = 30 cm
    mass    = 2 kg
    inertia = [0.03, 0.03, 0.05] kg*m^2
    rotor { max_thrust = 12 N; torque_per_thrust = 16 mm; max_speed = 900 rad/s }
}
faults { mode gone { rotor 1 lost }; mode worn { rotor 1 reduced to 90 % } }
mission hop { start at [0, 0, 2] m; waypoint there at [0, 0, 2.2] m }
"#;

struct Told {
    code: i32,
    text: String,
    record: Value,
    page: String,
}

const THERE: &str = "waypoint there at [0, 0, 2.2] m";

/// `mavc plan` of [`HEXA`] to a waypoint with a `plan` block, as text (both streams), JSON and page.
fn planned(to: &str, plan: &str) -> Told {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (report, page) = (path("r.json"), path("p.html"));
    let spec = HEXA.replace(THERE, to) + &format!("plan {{ {plan} }}\n");
    let ran = mavc_with(&["plan", "-v", "-", "--report", &report, "--html", &page], &spec);
    let read = |name: &str| std::fs::read_to_string(name).unwrap();
    let text = String::from_utf8(ran.stdout).unwrap() + &String::from_utf8(ran.stderr).unwrap();
    Told {
        code: ran.status.code().unwrap(),
        text,
        record: serde_json::from_str(&read(&report)).unwrap(),
        page: read(&page),
    }
}

#[test]
#[ignore = "long"]
fn a_verdict_has_one_word_everywhere() {
    let turned = format!("{THERE} yaw 150 deg");
    for (to, plan, code, verdict) in [
        (THERE, "against = [worn]; planner = rip; time = 4 s; samples = 10", 0, Verdict::Found),
        (THERE, "against = [worn]; planner = rip; time = 0.05 s; samples = 10", 3, Verdict::ProvedInfeasible),
        // Torque about z is not in the relaxation, so that it does not suffice is not proved.
        (&turned, "against = [worn]; planner = rip; time = 0.5 s; samples = 10", 4, Verdict::NotFound),
        // The one mode that there is hovers on the edge, and no plan against it is found at any time.
        (THERE, "against = [gone]; planner = rsp; reserve = 0 %; samples = 10", 4, Verdict::NotAttempted),
    ] {
        let told = planned(to, plan);
        let word = verdict.word();
        assert_eq!(told.code, code, "{}", told.text);
        let planner = &told.record["planners"][0];
        assert_eq!(planner["verdict"], word, "{planner:#}");
        let statement = planner["statement"].as_str().unwrap();
        assert!(statement.starts_with(word), "{statement}");
        let line = told.text.lines().find(|line| line.starts_with("RIP: ") || line.starts_with("RSP: ")).unwrap();
        let headline = told.page.split("class=\"headline\">").nth(1).unwrap().split("</h2>").next().unwrap();
        assert!(line.contains(&format!(": {word}")), "{line}");
        // `PLAN FOUND, 4 s` or `PROVED INFEASIBLE at 0.05 s`
        let begins = headline.strip_prefix("PLAN ").unwrap_or(headline).to_lowercase();
        assert!(begins.starts_with(word), "{headline}");
        let others = || Verdict::ALL.into_iter().filter(|other| *other != verdict);
        assert!(others().all(|other| !line.contains(&format!(": {other}"))), "{line}");
        assert!(others().all(|other| !begins.starts_with(other.word())), "{headline}");
        if let Some(conflict) = told.record["conflict"].as_object() {
            let word = conflict["verdict"].as_str().unwrap();
            assert!(told.text.contains(&format!("× {word}")), "{}", told.text);
        }
    }
}

/// A time at which nothing was proved is not among those of a proof, and what is proved of many times is proved of
/// each: each of them asked for alone has the same verdict.
#[test]
fn what_is_proved_of_many_times_is_proved_of_each() {
    let mut up = octocopter("PPNNPPNN");
    up.mission = Some(mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([3.0, 0.0, 5.0], 0.0)]));
    up.mission.as_mut().unwrap().limits = vec![limit(LimitKind::Climb, 0.0)];
    (up.plan.planner, up.plan.time, up.plan.samples) = (PlannerKind::Rip, MissionTime::Minimum, 20);
    for model in [PlanModel::Exact, PlanModel::Hover] {
        up.plan.model = model;
        let comparison = run_planners(Problem::of(&up).unwrap(), Scope::Plan, None);
        let PlanOutcome::Infeasible(Proof { at, proved }) = &comparison.runs[0].outcome else { panic!("{model:?}") };
        assert!(proved.len() > 3 && proved.last() == Some(at) && proved.is_sorted(), "{model:?} {proved:?}");
        let record = Record::new(Problem::of(&up).unwrap(), &comparison, String::new());
        assert_eq!(&record.planners[0].proved_infeasible_s, proved);
        let text = terminal::plan(Problem::of(&up).unwrap(), &comparison);
        assert!(text.contains(&format!("proved infeasible at each of {} times, ", proved.len())), "{text}");
        for &time in proved.iter().filter(|t| **t < 1e4) {
            let mut fixed = up.clone();
            fixed.plan.time = MissionTime::Fixed(time);
            let comparison = run_planners(Problem::of(&fixed).unwrap(), Scope::Plan, None);
            assert_eq!(comparison.runs[0].outcome.verdict(), Verdict::ProvedInfeasible, "{model:?}, {time} s");
        }
    }
}

/// A hop with a mode that hovers on the edge of yaw: against it no plan is found, nor is one proved infeasible.
fn on_the_edge() -> Model {
    let mut model = hexacopter("PNPNPN");
    model.modes = vec![lost(&model, &[1])];
    model.mission = Some(mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([2.0, 1.0, 3.0], 0.4)]));
    (model.plan.model, model.plan.planner) = (PlanModel::Exact, PlannerKind::Rsp);
    (model.plan.against, model.plan.reserve, model.plan.samples) = (vec![0], 0.0, 20);
    model
}

/// That no mode has a plan is no proof about RSP, whose sets are larger than the modes'; nor about the modes.
#[test]
#[ignore = "long"]
fn rsp_without_a_common_time_is_not_attempted() {
    let model = on_the_edge();
    let problem = Problem::of(&model).unwrap();
    let plan = run_planners(problem, Scope::Plan, None);
    assert!(plan.common_time.is_none());
    assert_eq!(plan.runs.last().unwrap().outcome.verdict(), Verdict::NotAttempted, "{:?}", plan.runs);
    let text = terminal::plan(problem, &plan);
    assert!(text.contains("RSP: not attempted: ") && !text.contains("proved infeasible"), "{text}");
    // RCP against the mode is searched for, and RIP has a plan.
    let all = run_planners(problem, Scope::Everything, None);
    let verdict = |planner: PlannerKind| {
        let run = all.runs.iter().find(|run| run.planner == planner && run.run == Run::Own);
        run.map(|run| run.outcome.verdict())
    };
    assert_eq!(verdict(PlannerKind::Rip), Some(Verdict::Found));
    assert_eq!(verdict(PlannerKind::Rcp), Some(Verdict::NotFound));
    assert_eq!(verdict(PlannerKind::Rsp), None);
    let text = comparison_text::compare(problem, &all, None);
    assert!(text.contains("not found: no plan was found") && !text.contains("proved infeasible"), "{text}");
}

/// Every command decides by one function and one tolerance whether hover lies inside a mode's set, on its edge or
/// outside.
#[test]
fn the_edge_is_one_for_every_command() {
    let (mut edges, mut dust) = (0, 0);
    for layout in ["PNPNPN", "PPNNPN", "PPPNNN"] {
        for arm in [0.211, 0.2837, 0.3, 1.0 / 3.0] {
            let mut model = ring_model(layout, 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0);
            model.vehicle.rotors.iter_mut().for_each(|r| r.position.iter_mut().for_each(|x| *x *= arm / 0.211));
            model.modes = (1..=6).map(|k| lost(&model, &[k])).collect();
            for mode in 0..6 {
                let set = AdmissibleSet::of_mode(&model, mode);
                let found = analyze(&model, &set);
                assert_eq!(set.has_hover_inside(), found.keeps_full_control(), "{layout} {arm} m: {found:?}");
                assert_eq!(found.interior, found.hover == HoverPlace::Inside);
                let margin = set.polytope.margin(&set.hover);
                edges += usize::from(found.hover_all_axes() == HoverPlace::OnEdge);
                dust += usize::from(found.hover_all_axes() == HoverPlace::OnEdge && margin > 0.0 && margin < EDGE);
            }
        }
    }
    assert!(edges > 10 && dust > 0, "{edges} on the edge, {dust} of them inside but for rounding");
}

/// `gone` hovers on the edge: that word in the tables of `analyze`, in JSON, on the page and in what `check` warns of.
#[test]
fn on_the_edge_is_one_word() {
    let spec = format!("{HEXA}plan {{ against = [gone]; reserve = 0 %; planner = rip; time = 4 s; samples = 10 }}\n");
    let out = |args: &[&str]| String::from_utf8(mavc_with(args, &spec).stdout).unwrap();
    let table = out(&["analyze", "-v", "-"]);
    let row = table.lines().find(|line| line.starts_with("gone")).unwrap();
    assert!(row.contains(" controllable ") && row.contains(" on the edge "), "{table}");
    let record: Value = serde_json::from_str(&out(&["analyze", "-v", "-", "--format", "json"])).unwrap();
    let gone = record["modes"].as_array().unwrap().iter().find(|mode| mode["name"] == "gone").unwrap();
    assert_eq!((&gone["verdict"], &gone["hover"]), (&"controllable".into(), &"on the edge".into()));
    let page = out(&["plan", "-v", "-", "--html", "-"]);
    assert!(page.contains("controllable, on the edge") && page.contains(r#""hover":"on the edge""#), "{page}");
    assert!(out(&["check", "-"]).contains("hover lies on the edge"), "{}", out(&["check", "-"]));
    let campaign = format!("{spec}campaign {{ times = 2; planners = rip }}\n");
    let ran = mavc_with(&["campaign", "-v", "-", "-o", "/dev/null", "--report", "-"], &campaign);
    let flown: Value = serde_json::from_slice(&ran.stdout).unwrap_or_else(|e| panic!("{e} {ran:?}"));
    let modes = flown["planners"][0]["modes"].as_array().unwrap();
    let inside: Vec<(&str, bool)> =
        modes.iter().map(|m| (m["name"].as_str().unwrap(), m["hover_inside"].as_bool().unwrap())).collect();
    assert_eq!(inside, [("gone", false), ("worn", true)]);
    assert_eq!((&modes[0]["verdict"], &modes[0]["hover"]), (&gone["verdict"], &gone["hover"]));
    assert_eq!(modes[0]["yaw_free"], gone["yaw_free"]);
    let text = String::from_utf8(mavc_with(&["campaign", "-v", "-"], &campaign).stdout).unwrap();
    assert!(text.lines().any(|line| line.trim_start().starts_with("gone") && line.contains(" on the edge ")), "{text}");
    let page =
        String::from_utf8(mavc_with(&["campaign", "-v", "-", "-o", "/dev/null", "--html", "-"], &campaign).stdout)
            .unwrap();
    assert!(page.contains("<td>on the edge</td>"), "{page}");
}

/// The plan of [`a_missed_waypoint_is_called_missed`], and the waypoint records of a mission that asks for other
/// places.
fn moved(by: f64, yaw_by: f64) -> Vec<WaypointRecord> {
    let mut model = octocopter("PPNNPPNN");
    model.mission = Some(mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([1.0, 0.0, 2.0], 0.3)]));
    (model.plan.model, model.plan.planner) = (PlanModel::Hover, PlannerKind::Rip);
    (model.plan.time, model.plan.samples) = (MissionTime::Fixed(6.0), 20);
    let flown = model.mission.as_ref().unwrap();
    let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
    let solved = comparison.runs[0].outcome.plan().unwrap();
    let end = solved.trajectory.nodes.last().unwrap();
    let mut asked = flown.clone();
    let last = &mut asked.waypoints[1];
    last.position = [end[0][0] + last.within + by, end[1][0], end[2][0]];
    last.yaw = end[3][0] + last.yaw_within + yaw_by;
    waypoints(&asked, solved)
}

/// Met means within the tolerance and what the verifier allows beside it; and the share is of the tolerance.
#[test]
fn a_missed_waypoint_is_called_missed() {
    for (by, yaw_by, missed) in [
        (-1e-3, -1e-3, false),
        (0.9 * MOST_MISS, -1e-3, false),
        (1.1 * MOST_MISS, -1e-3, true),
        (-1e-3, 1.1 * MOST_MISS, true),
        (1204.0, -1e-3, true),
    ] {
        let records = moved(by, yaw_by);
        let last = &records[1];
        assert_eq!(last.met, !missed, "{last:?}");
        let told = headline(&records);
        assert_eq!(told.starts_with("2 waypoints met; "), !missed, "{told}");
        assert_eq!(told.starts_with("1 of 2 waypoints missed; "), missed, "{told}");
        assert!((last.position_share - (last.position_tolerance_m + by) / last.position_tolerance_m).abs() < 1e-9);
        assert_eq!(last.share(), last.position_share.max(last.yaw_share));
        assert!(table(&records, 0).contains(&last.label()));
    }
    let told = headline(&moved(0.96, -0.04));
    assert!(told.ends_with("tightest: waypoint 2, 1.01 of 0.05 m allowed"), "{told}");
    let told = headline(&moved(-0.04, -1e-9));
    let yaw = told.split_once("waypoint 2, ").and_then(|(_, rest)| rest.strip_suffix(" deg of yaw allowed"));
    let (error, allowed) = yaw.and_then(|yaw| yaw.split_once(" of ")).unwrap_or_else(|| panic!("{told}"));
    assert_eq!(error, allowed);
}

/// Of many waypoints those are listed that take most of their tolerances, in the order of flight; the others are
/// counted.
#[test]
fn of_many_waypoints_the_worst_are_listed() {
    let one = moved(-0.04, -0.04).remove(1);
    let shares = [0.1, 0.9, 0.2, 0.3, 0.8, 0.4, 0.7, 0.2, 0.6, 0.5, 0.1];
    let records: Vec<WaypointRecord> = shares
        .iter()
        .enumerate()
        .map(|(i, &share)| WaypointRecord { number: i + 1, position_share: share, yaw_share: 0.0, ..one.clone() })
        .collect();
    let (worst, others) = listed(&records);
    assert_eq!(worst.iter().map(|w| w.number).collect::<Vec<_>>(), [2, 5, 7, 9, 10]);
    assert_eq!(others, Some((6, 0.4)));
    assert!(
        table(&records, 2).ends_with("  6 more, with errors of at most 40 % of their tolerances\n"),
        "{}",
        table(&records, 2)
    );
    let (all, others) = listed(&records[..8]);
    assert_eq!((all.len(), others), (8, None));
}

/// Every waypoint is in the report, few of them in the text, and the page has a table.
#[test]
fn waypoints_are_listed_in_every_report() {
    let points: String =
        (1..12).map(|i| format!("; waypoint p{i} at [0, 0, {}] m", 2.0 + 0.1 * f64::from(i))).collect();
    let told = planned(&points[2..], "against = [worn]; model = hover; planner = rip; time = 30 s; samples = 60");
    assert_eq!(told.code, 0, "{}", told.text);
    let planner = &told.record["planners"][0];
    let waypoints = planner["waypoints"].as_array().unwrap();
    assert_eq!(waypoints.len(), 12);
    let share = |w: &Value| w["position_share"].as_f64().unwrap().max(w["yaw_share"].as_f64().unwrap());
    let largest = waypoints.iter().map(share).fold(0.0, f64::max);
    assert_eq!(planner["max_waypoint_share"].as_f64(), Some(largest));
    assert!(told.text.contains("12 waypoints met") && told.text.contains("7 more, with errors of at most "));
    assert!(told.page.contains("Table of waypoints") && told.page.contains("11 p10"), "{}", told.page);
}

/// Every `verdict` of a planner in the schemas has the four words, and nothing has the old ones.
#[test]
fn schemas_have_the_same_words() {
    fn verdicts<'v>(value: &'v Value, found: &mut Vec<&'v Value>) {
        if let Some(members) = value.as_object() {
            // A mode has the paper's verdict, which is another word for another thing.
            let is_mode = members.contains_key("hover_inside");
            found.extend(members.get("verdict").filter(|_| !is_mode).and_then(|v| v.get("enum")));
            members.values().for_each(|v| verdicts(v, found));
        }
    }
    let words: Value = Verdict::ALL.map(Verdict::word).as_slice().into();
    for (name, number) in [("report", 3), ("campaign", 1)] {
        let text = std::fs::read_to_string(format!("docs/schema/{name}.schema.json")).unwrap();
        for old in ["solved", "inconclusive", "not_run"] {
            assert!(!text.contains(&format!("\"{old}\"")), "{name}: {old}");
        }
        let schema: Value = serde_json::from_str(&text).unwrap();
        let mut found = Vec::new();
        verdicts(&schema, &mut found);
        assert_eq!(found.len(), number, "{name}: {found:?}");
        // A conflict is told only where no plan was found.
        let few: Value = ["proved infeasible", "not found"].as_slice().into();
        assert!(found.iter().all(|enumerated| **enumerated == words || **enumerated == few), "{name}: {found:?}");
    }
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// A proof about RIP is one about RSP; without a proof and without a plan of RIP there is nothing to select RSP's
    /// facets by.
    #[test]
    #[ignore = "long"]
    fn rsp_without_a_plan_of_rip_is_not_attempted_but_where_that_is_proved() {
        let mut model = on_the_edge();
        let to = &mut model.mission.as_mut().unwrap().waypoints[1];
        (to.position, to.yaw) = ([0.0, 0.0, 2.2], 2.6);
        for (time, verdicts) in [
            (0.6, [Verdict::NotFound, Verdict::NotAttempted]),
            (0.05, [Verdict::ProvedInfeasible, Verdict::ProvedInfeasible]),
        ] {
            model.plan.time = MissionTime::Fixed(time);
            for (planner, verdict) in [PlannerKind::Rip, PlannerKind::Rsp].into_iter().zip(verdicts) {
                model.plan.planner = planner;
                let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
                assert_eq!(comparison.runs[0].outcome.verdict(), verdict, "{planner:?} in {time} s");
            }
            let all = run_planners(Problem::of(&model).unwrap(), Scope::Everything, None);
            let rsp = all.runs.iter().find(|run| run.planner == PlannerKind::Rsp && run.run == Run::Common).unwrap();
            assert_eq!(rsp.outcome.verdict(), verdicts[1], "{time} s");
        }
    }
}
