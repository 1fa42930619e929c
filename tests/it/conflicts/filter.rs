//! The deletion filter against brute force, on oracles that know their conflicts.

use crate::vehicles::{limit, mission, quadcopter, waypoint};
use mavc::explain::statement::statements;
use mavc::explain::{Answer, MOST_QUESTIONS, MOST_TRIES, Oracle, Part, Statement, explain};
use mavc::model::{LimitKind, MissionTime, Model, PlannerKind, Problem};
use mavc::planner::transcription::UNBOUNDED;
use mavc::source::SourceMap;
use rand_distr::{Distribution, Uniform};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeSet;

/// Has no plan where all statements of some conflict are there. What is there it reads off the mission itself.
struct Known {
    conflicts: Vec<BTreeSet<Statement>>,
    /// Whether a conflict is proved to have no plan, or none was found.
    proves: bool,
    /// Whether it weighs the parts of the first conflict that it sees.
    weighs: bool,
    asked: usize,
}

fn present(problem: Problem, whole: &Model, time: f64) -> BTreeSet<Statement> {
    let (model, mission) = (problem.model(), problem.mission());
    let there = |s: &Statement| match *s {
        Statement::Waypoints { first, .. } => mission.waypoints[first].within < UNBOUNDED,
        Statement::Arrival(i) => mission.waypoints[i].time.is_some(),
        Statement::Hold(i) => mission.waypoints[i].hold > 0.0,
        Statement::Stop(i) => mission.waypoints[i].stop,
        Statement::RestAtStart => mission.start_at_rest,
        Statement::RestAtEnd => mission.end_at_rest,
        Statement::Limit(i) => mission.limits[i].upper.is_some(),
        Statement::Mode(mode) => model.plan.against.contains(&mode),
        Statement::Reserve => model.plan.reserve > 0.0,
        Statement::Time => matches!(whole.plan.time, MissionTime::Fixed(fixed) if fixed == time),
    };
    statements(Problem::of(whole).unwrap()).into_iter().filter(there).collect()
}

struct Asked<'k> {
    known: &'k mut Known,
    whole: Model,
}

impl Oracle for Asked<'_> {
    fn ask(&mut self, problem: Problem, time: f64) -> Answer {
        self.known.asked += 1;
        let there = present(problem, &self.whole, time);
        let met = self.known.conflicts.iter().find(|conflict| conflict.is_subset(&there));
        let part = |s: &Statement| match *s {
            Statement::Waypoints { first, .. } => Some((Part::Waypoint(first), 1.0)),
            Statement::Limit(i) => Some((Part::Limit(i), 2.0)),
            Statement::RestAtStart => Some((Part::RestAtStart, 0.5)),
            _ => None,
        };
        match met {
            None => Answer::Feasible,
            Some(_) if !self.known.proves => Answer::NotFound(Vec::new()),
            Some(conflict) if self.known.weighs => Answer::Infeasible {
                weights: conflict.iter().filter_map(part).collect(),
                only_for_selection: false,
                only_for_samples: true,
            },
            Some(_) => Answer::Infeasible { weights: Vec::new(), only_for_selection: false, only_for_samples: true },
        }
    }
}

/// Some of everything that a spec can say.
fn spec() -> Model {
    let mut model = quadcopter();
    let mut points: Vec<_> = (0..5).map(|i| waypoint([3.0 * i as f64, 0.0, 2.0], 0.0)).collect();
    for (i, point) in points.iter_mut().enumerate() {
        // Each is a statement of its own.
        point.span.start = i as u32;
    }
    points[2].time = Some(8.0);
    points[3].hold = 2.0;
    let mut flown = mission(points);
    flown.limits = [LimitKind::Speed, LimitKind::Tilt, LimitKind::Climb].map(|kind| limit(kind, 0.5)).to_vec();
    for (i, limit) in flown.limits.iter_mut().enumerate() {
        limit.span.start = 10 + i as u32;
    }
    model.plan.time_span.start = 20;
    model.mission = Some(flown);
    model.plan.planner = PlannerKind::Rip;
    model.plan.reserve = 0.1;
    model.plan.time = MissionTime::Fixed(30.0);
    model
}

#[test]
fn the_remaining_statements_are_a_smallest_conflict() {
    let model = spec();
    let all = statements(Problem::of(&model).unwrap());
    assert_eq!(all.len(), 14);
    let mut random = Pcg64Mcg::new(7);
    let chance = Uniform::new(0.0, 1.0).unwrap();
    for case in 0..200 {
        let conflicts: Vec<BTreeSet<Statement>> = (0..1 + case % 4)
            .map(|_| {
                let picked: BTreeSet<Statement> =
                    all.iter().copied().filter(|_| chance.sample(&mut random) < 0.3).collect();
                if picked.is_empty() { BTreeSet::from([all[case % all.len()]]) } else { picked }
            })
            .collect();
        // Brute force: a conflict is irreducible where no other lies within it.
        let smallest = |c: &BTreeSet<Statement>| conflicts.iter().all(|other| other == c || !other.is_subset(c));
        let (proves, weighs) = (case % 2 == 0, case % 3 == 0);
        let mut known = Known { conflicts: conflicts.clone(), proves, weighs, asked: 0 };
        let mut oracle = Asked { known: &mut known, whole: model.clone() };
        let found = explain(Problem::of(&model).unwrap(), &mut oracle).unwrap();
        let kept: BTreeSet<Statement> = found.conflict.statements.iter().copied().collect();
        assert!(conflicts.contains(&kept) && smallest(&kept), "{case}: {kept:?} of {conflicts:?}");
        assert!(found.conflict.irreducible);
        assert_eq!(found.conflict.proved, proves);
        assert_eq!(found.questions, known.asked);
        assert!(known.asked <= MOST_QUESTIONS + MOST_TRIES, "{}", known.asked);
        // Conflicts about time come last: one that does not hang on it is preferred.
        let without = conflicts.iter().any(|c| !c.contains(&Statement::Time));
        assert!(!without || !kept.contains(&Statement::Time));
    }
}

/// Four statements among three hundred waypoints, limits and rests: found within the number of questions.
#[test]
fn few_statements_among_many_are_found() {
    let mut model = spec();
    let flown = model.mission.as_mut().unwrap();
    let mut points: Vec<_> = (0..300).map(|i| waypoint([3.0 * f64::from(i), 0.0, 2.0], 0.0)).collect();
    for (i, point) in points.iter_mut().enumerate() {
        point.span.start = i as u32;
        point.time = (i % 10 == 3).then_some(10.0 * i as f64);
    }
    flown.legs = mission(points.clone()).legs;
    flown.waypoints = points;
    model.plan.time = MissionTime::Fixed(5000.0);
    let all = statements(Problem::of(&model).unwrap());
    assert_eq!(all.len(), 300 + 30 + 2 + 3 + 2);
    let mut random = Pcg64Mcg::new(11);
    let place = Uniform::new(0, all.len()).unwrap();
    for case in 0..20 {
        let conflict: BTreeSet<Statement> = (0..4).map(|_| all[place.sample(&mut random)]).collect();
        for (proves, weighs) in [(true, true), (true, false), (false, false)] {
            let mut known = Known { conflicts: vec![conflict.clone()], proves, weighs, asked: 0 };
            let mut oracle = Asked { known: &mut known, whole: model.clone() };
            let found = explain(Problem::of(&model).unwrap(), &mut oracle).unwrap();
            let kept: BTreeSet<Statement> = found.conflict.statements.iter().copied().collect();
            assert!(kept == conflict && found.conflict.irreducible, "{case}: {kept:?} of {conflict:?}");
            assert!(known.asked <= MOST_QUESTIONS + MOST_TRIES, "{}", known.asked);
        }
    }
}

/// With more members than questions nothing wrong is said: all of the conflict is named, and not called irreducible.
#[test]
fn what_is_not_asked_is_not_claimed() {
    let mut model = spec();
    let flown = model.mission.as_mut().unwrap();
    let mut points: Vec<_> =
        (0..2 * MOST_QUESTIONS as u32 + 20).map(|i| waypoint([3.0 * f64::from(i), 0.0, 2.0], 0.0)).collect();
    points.iter_mut().enumerate().for_each(|(i, point)| point.span.start = i as u32);
    flown.legs = mission(points.clone()).legs;
    flown.waypoints = points;
    let all = statements(Problem::of(&model).unwrap());
    let conflict: BTreeSet<Statement> =
        all.iter().copied().filter(|s| matches!(s, Statement::Waypoints { first, .. } if first % 2 == 0)).collect();
    let mut known = Known { conflicts: vec![conflict.clone()], proves: true, weighs: false, asked: 0 };
    let mut oracle = Asked { known: &mut known, whole: model.clone() };
    let found = explain(Problem::of(&model).unwrap(), &mut oracle).unwrap();
    let kept: BTreeSet<Statement> = found.conflict.statements.iter().copied().collect();
    assert!(kept.is_superset(&conflict) && found.conflict.proved && !found.conflict.irreducible);
    assert!(known.asked <= MOST_QUESTIONS + MOST_TRIES, "{}", known.asked);
}

#[test]
fn a_spec_with_a_plan_has_no_conflict() {
    let model = spec();
    let mut known = Known { conflicts: Vec::new(), proves: true, weighs: true, asked: 0 };
    let mut oracle = Asked { known: &mut known, whole: model.clone() };
    assert_eq!(explain(Problem::of(&model).unwrap(), &mut oracle), None);
    assert_eq!(known.asked, 1);
}

/// Never finds a plan, whatever is left out.
struct Helpless;

impl Oracle for Helpless {
    fn ask(&mut self, _: Problem, _: f64) -> Answer {
        Answer::NotFound(Vec::new())
    }
}

#[test]
fn no_statement_is_blamed_where_none_is_to_blame() {
    let model = spec();
    assert_eq!(explain(Problem::of(&model).unwrap(), &mut Helpless), None);
}

#[test]
fn what_was_not_proved_is_not_called_so() {
    let model = spec();
    let problem = Problem::of(&model).unwrap();
    for (proves, wanted) in [
        (true, "proved infeasible with 200 samples: 2 statements of the spec cannot hold together"),
        (false, "not found: a plan that satisfies these 2 statements together; a guess at the cause, not a proof"),
    ] {
        let conflicts = vec![BTreeSet::from([Statement::Limit(0), Statement::Time])];
        let mut known = Known { conflicts, proves, weighs: true, asked: 0 };
        let mut oracle = Asked { known: &mut known, whole: model.clone() };
        let found = explain(problem, &mut oracle).unwrap();
        let told = mavc::explain::diagnose::diagnose(&found, problem, &SourceMap::default());
        assert_eq!((told.code, told.message.as_str()), ("mavc::plan::conflict", wanted));
        // Both of them, changed, and nothing else: every number of two digits above 30 s is another time.
        let kinds: Vec<&str> = found.fixes.iter().map(|fix| fix.change.kind()).collect();
        assert_eq!(kinds, ["time", "no_limit"], "{kinds:?}");
        assert_eq!(found.fixes[0].change.value(), Some(31.0));
    }
}

/// Finds plans as [`Known`] does, but gives no answer where a statement is left out.
struct Unsure<'k>(Asked<'k>, Statement);

impl Oracle for Unsure<'_> {
    fn ask(&mut self, problem: Problem, time: f64) -> Answer {
        match present(problem, &self.0.whole, time).contains(&self.1) {
            true => self.0.ask(problem, time),
            false => Answer::NotFound(Vec::new()),
        }
    }
}

#[test]
fn what_was_proved_is_not_given_up_for_what_was_not_found() {
    let model = spec();
    let problem = Problem::of(&model).unwrap();
    let conflicts = vec![BTreeSet::from([Statement::Limit(1), Statement::RestAtStart])];
    let mut known = Known { conflicts, proves: true, weighs: false, asked: 0 };
    let mut oracle = Unsure(Asked { known: &mut known, whole: model.clone() }, Statement::Limit(2));
    let found = explain(problem, &mut oracle).unwrap();
    assert_eq!(found.conflict.statements, [Statement::RestAtStart, Statement::Limit(1), Statement::Limit(2)]);
    assert!(found.conflict.proved && !found.conflict.irreducible);
    let told = mavc::explain::diagnose::diagnose(&found, problem, &SourceMap::default());
    assert!(told.help.unwrap().contains("not shown"));
}
