//! Specs without a plan in the exact model: `tests/specs/conflicts/exact/*.mav`. The first line names the statements
//! that are not met together, as in `tests/specs/conflicts`, the second whether that is `proved` or a plan was only
//! `not found`.

use super::{Text, explained, named};
use mavc::explain::diagnose::diagnose;
use mavc::explain::planners::Planners;
use mavc::explain::{Answer, Explanation, MOST_ATTEMPTS, Oracle, explain};
use mavc::model::{Model, PlanModel, Problem};
use mavc::planner::transcription::UNBOUNDED;
use mavc::read::FileSet;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

struct Case {
    text: Text,
    files: FileSet,
    model: Model,
    explanation: Explanation,
}

/// Specs that take a third of the time to explain, though others have such conflicts too: they are left to the long
/// tests.
const SLOW: [&str; 2] = ["early_waypoint.mav", "last_waypoint.mav"];

static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases(false));
static SLOW_CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases(true));

fn cases(slow: bool) -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/conflicts/exact");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let case = |path: PathBuf| {
        let text = Text::read(&path);
        let (files, model, explanation) = explained(&text);
        Case { text, files, model, explanation }
    };
    paths.into_par_iter().filter(|path| SLOW.iter().any(|name| path.ends_with(name)) == slow).map(case).collect()
}

#[test]
fn every_spec_names_its_conflict() {
    assert!(CASES.len() >= 8, "{}", CASES.len());
    name_their_conflicts(&CASES);
}

#[test]
#[ignore = "long"]
fn every_slow_spec_names_its_conflict() {
    assert_eq!(SLOW_CASES.len(), SLOW.len());
    name_their_conflicts(&SLOW_CASES);
}

fn name_their_conflicts(cases: &[Case]) {
    for Case { text, files, model, explanation } in cases {
        assert_eq!(model.plan.model, PlanModel::Exact, "{}", text.name);
        let problem = Problem::of(model).unwrap();
        let mut lines = text.files[&text.name].lines();
        let wanted: Vec<&str> = lines.next().unwrap().strip_prefix("// conflict: ").unwrap().split(", ").collect();
        assert_eq!(named(explanation, files, problem, &text.name), wanted, "{}", text.name);
        let proved = match lines.next().unwrap() {
            "// proved" => true,
            "// not found" => false,
            other => panic!("{}: {other}", text.name),
        };
        assert_eq!(explanation.conflict.proved, proved, "{}", text.name);
        assert!(explanation.questions <= MOST_ATTEMPTS.iter().sum(), "{}", text.name);
        // The result distinguishes what is proved from what was only tried.
        let told = diagnose(explanation, problem, &files.sources);
        let words = if proved { "cannot hold together" } else { "not found: a plan that satisfies" };
        assert!(told.message.contains(words), "{}: {}", text.name, told.message);
        // The short tries miss a plan now and then; then that is said.
        let help = told.help.unwrap_or_default();
        match explanation.conflict.least_time {
            Some(_) => {
                assert!(help.starts_with("no motion that keeps these statements alone takes less than"), "{help}");
            }
            None => {
                let unsure = help.contains("It was not shown that every one");
                assert_eq!(unsure, !explanation.conflict.irreducible, "{}", text.name);
            }
        }
    }
}

/// Hands questions on, and keeps what was asked and answered.
struct Recording<'o> {
    inner: &'o mut dyn Oracle,
    answers: Vec<(Asked, Answer)>,
}

#[derive(PartialEq)]
struct Asked {
    /// Whether each limit, tolerance, rest and the reserve is there.
    rows: Vec<bool>,
    /// The mission time, fixed times and holds.
    times: Vec<Option<f64>>,
}

impl Asked {
    fn of(problem: Problem, time: f64) -> Self {
        let (model, mission) = (problem.model(), problem.mission());
        let limits = mission.limits.iter().map(|l| l.lower.is_some() || l.upper.is_some());
        let waypoints = mission.waypoints.iter().map(|w| w.within < UNBOUNDED);
        let others = [mission.start_at_rest, mission.end_at_rest, model.plan.reserve > 0.0];
        let times = mission.waypoints.iter().flat_map(|w| [w.time, Some(w.hold)]);
        Asked { rows: limits.chain(waypoints).chain(others).collect(), times: times.chain([Some(time)]).collect() }
    }

    /// Whether one question requires a part of the statements of another, at the same times.
    fn is_part_of(&self, other: &Asked) -> bool {
        self.times == other.times && self.rows.iter().zip(&other.rows).all(|(mine, others)| !mine || *others)
    }
}

impl Oracle for Recording<'_> {
    fn ask(&mut self, problem: Problem, time: f64) -> Answer {
        let answer = self.inner.ask(problem, time);
        self.answers.push((Asked::of(problem, time), answer.clone()));
        answer
    }
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// The changes are tried on the mission itself, so the planner has a plan there.
    #[test]
    #[ignore = "long"]
    fn every_change_offered_gives_a_plan() {
        let mut offered = 0;
        for Case { text, explanation, .. } in CASES.iter().chain(SLOW_CASES.iter()) {
            for fix in &explanation.fixes {
                let mut changed = text.clone();
                changed.change(fix.change);
                assert!(changed.plans(), "{} {:?}", text.name, fix.change);
                offered += 1;
            }
        }
        assert!(offered >= CASES.len(), "{offered}");
    }

    /// A plan answers every question that requires a part of the statements it satisfies; the planner is not called for
    /// it again.
    #[test]
    #[ignore = "long"]
    fn nothing_is_asked_that_is_known() {
        let mut checked = 0;
        for Case { text, model, explanation, .. } in
            CASES.iter().chain(SLOW_CASES.iter()).filter(|case| case.model.plan.against.is_empty())
        {
            let mut planners = Planners::default();
            let mut recording = Recording { inner: &mut planners, answers: Vec::new() };
            assert_eq!(
                explain(Problem::of(model).unwrap(), &mut recording).as_ref(),
                Some(explanation),
                "{}",
                text.name
            );
            assert_eq!(recording.answers.len(), explanation.questions);
            // Changes keep every statement but the one that they change; the filter has left some out.
            let named = explanation.conflict.statements.len();
            let of_filter = |asked: &Asked| asked.rows.iter().filter(|there| !*there).count() > 1;
            let answers: Vec<_> = recording.answers.iter().filter(|(asked, _)| of_filter(asked)).collect();
            for (i, (asked, _)) in answers.iter().enumerate() {
                let known = answers[..i].iter().any(|(before, a)| *a == Answer::Feasible && asked.is_part_of(before));
                assert!(!known, "{}: {:?}, {named} statements", text.name, asked.rows);
                checked += 1;
            }
        }
        assert!(checked > 10, "{checked}");
    }
}
