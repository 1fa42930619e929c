//! Specs without a plan: `tests/specs/conflicts/*.mav`, each with the statements that cannot hold together in its first
//! line (`LINE KIND`, or `FILE:LINE KIND` in another file). What is said of them is checked on edited texts, by
//! planning.

mod exact;
mod filter;

use mavc::diagnostic::render_human;
use mavc::explain::diagnose::diagnose;
use mavc::explain::planners::Planners;
use mavc::explain::statement::statements;
use mavc::explain::{Change, Explanation, Statement, explain};
use mavc::model::{MissionTime, Model, Problem};
use mavc::motion::time_grid::determined;
use mavc::planner::studies::{PlanOutcome, Proof, Scope, run_planners};
use mavc::read::FileSet;
use mavc::source::Span;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// A spec as text, with what an edit has changed: its own file, and tables under the names that it uses.
#[derive(Clone)]
struct Text {
    folder: PathBuf,
    name: String,
    files: BTreeMap<String, String>,
    overrides: Vec<String>,
}

impl Text {
    fn read(path: &Path) -> Self {
        let name = path.file_name().unwrap().to_str().unwrap().to_string();
        let files = BTreeMap::from([(name.clone(), std::fs::read_to_string(path).unwrap())]);
        Text { folder: path.parent().unwrap().into(), name, files, overrides: Vec::new() }
    }

    /// Files and model; the text must be without errors.
    fn model(&self) -> (FileSet, Model) {
        let reader = |used: &Path| match self.files.get(used.to_str().unwrap()) {
            Some(text) => Ok(text.clone().into_bytes()),
            None => std::fs::read(self.folder.join(used)),
        };
        let compiler = self.overrides.iter().fold(mavc::Compiler::new().reading(&reader), mavc::Compiler::set);
        let compiled = compiler.text(&self.name, self.files[&self.name].as_bytes());
        let spec =
            compiled.into_result().unwrap_or_else(|e| panic!("{:?}\n{}{e:?}", self.overrides, self.files[&self.name]));
        (spec.files().clone(), spec.model().clone())
    }

    /// How `mavc plan` ends.
    fn outcome(&self) -> PlanOutcome {
        let (_, model) = self.model();
        let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
        comparison.runs.last().unwrap().outcome.clone()
    }

    /// How it ends at its own time, or at some long ones where it fixes none.
    fn outcomes(&self) -> Vec<PlanOutcome> {
        let (_, model) = self.model();
        let fixed = determined(model.mission.as_ref().unwrap()).is_some() || model.plan.time != MissionTime::Minimum;
        let at = |time: &str| {
            let mut text = self.clone();
            text.set("plan.time", time);
            text.outcome()
        };
        if fixed { vec![self.outcome()] } else { FREE.iter().map(|time| at(time)).collect() }
    }

    fn plans(&self) -> bool {
        matches!(self.outcome(), PlanOutcome::Planned(_))
    }

    /// Replaces what a place of the text covers by what `edit` makes of it.
    fn edit(&mut self, files: &FileSet, span: Span, edit: impl Fn(&str) -> String) {
        let source = files.sources.get(span.file);
        let (start, end) = (span.start as usize, span.end as usize);
        let text = &source.text;
        let edited = format!("{}{}{}", &text[..start], edit(&text[start..end]), &text[end..]);
        self.files.insert(file_name(&source.name), edited);
    }

    /// Writes statements behind the brace that opens a block, which stands on the line of a place.
    fn add(&mut self, files: &FileSet, span: Span, statements: &str) {
        let source = files.sources.get(span.file);
        let start = span.start as usize;
        let brace = start + source.text[start..].find('{').unwrap() + 1;
        self.edit(files, Span::new(span.file, brace, brace), |_| format!(" {statements};"));
    }

    /// Gives the waypoint at a place some tolerances or a time: as clauses, or as cells of a table.
    fn set_at(&mut self, files: &FileSet, span: Span, values: &[(&str, &str)]) {
        let source = files.sources.get(span.file);
        let header: Vec<&str> = source.text.lines().next().unwrap().split(',').collect();
        let is_table = source.name.ends_with(".csv");
        let in_row = |row: &str| {
            let mut cells: Vec<&str> = row.split(',').collect();
            for (name, value) in values {
                // The number alone, for the header has the unit.
                let column = header.iter().position(|h| h.rsplit_once('_').map_or(*h, |(h, _)| h) == *name).unwrap();
                cells[column] = value.split(' ').next().unwrap();
            }
            cells.join(",")
        };
        let in_clauses = |text: &str| {
            values.iter().fold(text.to_string(), |text, (name, value)| {
                let rest = without_clause(&text, name);
                if value.is_empty() { rest } else { format!("{rest} {name} {value}") }
            })
        };
        self.edit(files, span, |text| if is_table { in_row(text) } else { in_clauses(text) });
    }

    /// Leaves a statement out, as an author would.
    fn leave_out(&mut self, statement: Statement) {
        let (files, model) = self.model();
        let mission = model.mission.as_ref().unwrap();
        let span = statement.span(Problem::of(&model).unwrap());
        match statement {
            Statement::Waypoints { first, last } if first == last => {
                let nothing = [("within", "1000 m"), ("yaw_within", "100000 deg"), ("weight", "0")];
                self.set_at(&files, span, &nothing);
            }
            Statement::Waypoints { .. } => {
                self.add(&files, span, "within = 1 km; yaw_within = 100000 deg; weight = 0");
            }
            Statement::Arrival(i) => self.set_at(&files, mission.waypoints[i].span, &[("time", "")]),
            Statement::Stop(_) => self.edit(&files, span, |text| text.replace("  stop", "")),
            Statement::Hold(_) | Statement::Limit(_) => self.edit(&files, span, |_| String::new()),
            Statement::RestAtStart => self.add(&files, mission.span, "start moving"),
            Statement::RestAtEnd => self.add(&files, mission.span, "end moving"),
            Statement::Mode(mode) => {
                let kept = model.plan.against.iter().filter(|&&k| k != mode);
                let names: Vec<&str> = kept.map(|&k| model.modes[k].name.as_str()).collect();
                self.set("plan.against", &format!("[{}]", names.join(", ")));
            }
            Statement::Reserve => self.set("plan.reserve", "0%"),
            Statement::Time => self.set("plan.time", "minimum"),
        }
    }

    /// Sets a field as `--set` does, in place of an earlier value.
    fn set(&mut self, field: &str, value: &str) {
        self.overrides.retain(|old| !old.starts_with(&format!("{field}=")));
        self.overrides.push(format!("{field}={value}"));
    }

    /// Makes a change as its words tell an author to.
    fn change(&mut self, change: Change) {
        let (files, model) = self.model();
        let mission = model.mission.as_ref().unwrap();
        let words = change.instruction(Problem::of(&model).unwrap(), &files.sources);
        // What stands between the first two backticks is to be written.
        let written = words.split('`').nth(1).unwrap_or_else(|| panic!("{words}")).to_string();
        let value = || written.split_once('=').unwrap().1.trim().to_string();
        let clause = || written.split_once(' ').unwrap().1;
        match change {
            Change::Samples(_) => self.set("plan.samples", &value()),
            Change::Time(_) => self.set("plan.time", &value().replace(' ', "")),
            Change::Reserve(_) => self.set("plan.reserve", &value().replace(' ', "")),
            Change::Mass(_) => self.set("vehicle.mass", &value().replace(' ', "")),
            Change::Arrival { waypoint, .. } => {
                self.set_at(&files, mission.waypoints[waypoint].span, &[("time", clause())]);
            }
            Change::Within { first, last, .. } if first == last => {
                self.set_at(&files, mission.waypoints[first].span, &[("within", clause())]);
            }
            Change::Within { first, .. } => self.add(&files, mission.waypoints[first].span, &written),
            Change::Bound { limit, .. } => self.edit(&files, mission.limits[limit].span, |_| written.clone()),
            Change::NoLimit(limit) => self.leave_out(Statement::Limit(limit)),
            Change::NoHold(waypoint) => self.leave_out(Statement::Hold(waypoint)),
            Change::NoStop(waypoint) => self.leave_out(Statement::Stop(waypoint)),
            Change::NoMode(mode) => self.leave_out(Statement::Mode(mode)),
        }
    }
}

fn file_name(path: &str) -> String {
    Path::new(path).file_name().unwrap().to_str().unwrap().to_string()
}

/// A statement without its clause of a name, which takes a number and a unit.
fn without_clause(statement: &str, name: &str) -> String {
    let words: Vec<&str> = statement.split(' ').collect();
    match words.iter().position(|word| *word == name) {
        Some(at) => [&words[..at], &words[(at + 3).min(words.len())..]].concat().join(" ").trim_end().to_string(),
        None => statement.to_string(),
    }
}

/// `LINE KIND`, as the first line of a spec names its statements.
fn named(explanation: &Explanation, files: &FileSet, problem: Problem, own: &str) -> Vec<String> {
    let name = |statement: &Statement| {
        let span = statement.span(problem);
        let source = files.sources.get(span.file);
        let line = source.place(span.start as usize).line;
        let file = file_name(&source.name);
        let place = if file == own { line.to_string() } else { format!("{file}:{line}") };
        format!("{place} {}", statement.kind())
    };
    explanation.conflict.statements.iter().map(name).collect()
}

fn explained(text: &Text) -> (FileSet, Model, Explanation) {
    let (files, model) = text.model();
    let explanation = explain(Problem::of(&model).unwrap(), &mut Planners::default()).expect("a conflict");
    (files, model, explanation)
}

/// A spec of the corpus with what is said of it.
struct Case {
    path: PathBuf,
    text: Text,
    files: FileSet,
    model: Model,
    explanation: Explanation,
}

/// Specs that take half of the time to explain: they are left to the long tests.
const SLOW: [&str; 4] = ["early_waypoint.mav", "sensitive.mav", "table.mav", "two_times.mav"];

/// Every other spec of the corpus, explained once for all tests.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases(false));
static SLOW_CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases(true));

fn cases(slow: bool) -> Vec<Case> {
    let case = |path: PathBuf| {
        let text = Text::read(&path);
        let (files, model, explanation) = explained(&text);
        Case { path, text, files, model, explanation }
    };
    // Side by side, for tests that wait for it wait together.
    corpus().into_par_iter().filter(|path| SLOW.iter().any(|name| path.ends_with(name)) == slow).map(case).collect()
}

fn all_cases() -> impl Iterator<Item = &'static Case> {
    CASES.iter().chain(SLOW_CASES.iter())
}

fn corpus() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/conflicts");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "mav"))
        .collect();
    paths.sort();
    paths
}

#[test]
fn every_spec_names_its_conflict() {
    assert!(CASES.len() >= 15, "{}", CASES.len());
    name_their_conflicts(&CASES);
}

#[test]
#[ignore = "long"]
fn every_slow_spec_names_its_conflict() {
    assert_eq!(SLOW_CASES.len(), SLOW.len());
    name_their_conflicts(&SLOW_CASES);
}

fn name_their_conflicts(cases: &[Case]) {
    for Case { path, text, files, model, explanation } in cases {
        let outcome = text.outcome();
        assert!(matches!(outcome, PlanOutcome::Infeasible(Proof { .. })), "{}: {}", text.name, short(&outcome));
        let problem = Problem::of(model).unwrap();
        let first = text.files[&text.name].lines().next().unwrap();
        let wanted: Vec<&str> = first.strip_prefix("// conflict: ").unwrap().split(", ").collect();
        assert_eq!(named(explanation, files, problem, &text.name), wanted, "{}", text.name);
        assert!(explanation.conflict.proved && explanation.conflict.irreducible, "{}", text.name);
        let told = diagnose(explanation, problem, &files.sources);
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(path.parent().unwrap());
        settings.set_snapshot_suffix("");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let rendered = render_human(&[told], &files.sources, 80, false);
        settings.bind(|| insta::assert_snapshot!(path.file_stem().unwrap().to_str().unwrap(), rendered));
    }
}

/// The number in the headline is that of the labels that follow, and each statement stands under one of them.
#[test]
fn as_many_statements_are_counted_as_labelled() {
    let mut shared = 0;
    for Case { text, files, model, explanation, .. } in CASES.iter() {
        let problem = Problem::of(model).unwrap();
        let told = diagnose(explanation, problem, &files.sources);
        let labels: Vec<(Span, &str)> = std::iter::once((told.span, told.label.as_str()))
            .chain(told.labels.iter().map(|label| (label.span, label.message.as_str())))
            .collect();
        let counted = told.message.split_once(": ").unwrap().1.split(' ').next().unwrap();
        assert_eq!(counted.parse().unwrap_or(1), labels.len(), "{}: {}", text.name, told.message);
        for statement in &explanation.conflict.statements {
            let at = statement.span(problem);
            let (_, label) = labels.iter().find(|(span, _)| *span == at).unwrap();
            assert!(label.contains(&statement.label(problem)), "{}: {label}", text.name);
        }
        shared += usize::from(labels.len() < explanation.conflict.statements.len());
    }
    assert!(shared > 0, "no place says two things");
}

/// A tolerance that would make another mission is not offered: none beyond ten times the spec's, nor beyond a quarter
/// of the way to the next waypoint.
#[test]
fn tolerances_offered_leave_the_mission_what_it_is() {
    for Case { text, model, explanation, .. } in CASES.iter() {
        let points = &model.mission.as_ref().unwrap().waypoints;
        for fix in &explanation.fixes {
            let Change::Within { first, last, within } = fix.change else { continue };
            for i in first..=last {
                let beside = [i.checked_sub(1), Some(i + 1).filter(|k| *k < points.len())];
                let way = |k: usize| {
                    let (a, b) = (points[i].position, points[k].position);
                    (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
                };
                let nearest = beside.into_iter().flatten().map(way).fold(f64::INFINITY, f64::min);
                assert!(within <= nearest / 4.0 + 1e-9, "{}: {within} m of {nearest} m", text.name);
                assert!(within <= 10.0 * points[i].within + 1e-9, "{}: {within} m", text.name);
            }
        }
    }
}

/// What `--set` says is told so, and the change is one of the command line.
#[test]
fn what_the_command_line_says_is_changed_there() {
    let path = corpus().into_iter().find(|path| path.ends_with("slow_in_time.mav")).unwrap();
    let mut text = Text::read(&path);
    text.set("plan.time", "9s");
    text.set("mission.limits.speed", "5.5m/s");
    let (files, model, explanation) = explained(&text);
    let told = diagnose(&explanation, Problem::of(&model).unwrap(), &files.sources);
    let labels: Vec<&str> = told.labels.iter().map(|label| label.message.as_str()).collect();
    assert!(labels.contains(&"in 9 s, set by `--set`"), "{labels:?}");
    assert!(labels.contains(&"keeping `speed <= 5.5 m/s`, set by `--set`"), "{labels:?}");
    // Labels of the spec's own text come first.
    assert_eq!(file_name(&files.sources.get(told.span.file).name), text.name);
    let mut offered = 0;
    for fix in &explanation.fixes {
        let words = fix.change.instruction(Problem::of(&model).unwrap(), &files.sources);
        if let Some((_, set)) = words.split_once("`--set ") {
            let (field, value) = set.trim_end_matches('`').split_once('=').unwrap();
            let mut changed = text.clone();
            changed.set(field, value);
            assert!(changed.plans(), "{words}");
            offered += 1;
        }
        assert!(!words.contains("`time =") && !words.contains("`speed <="), "{words}");
    }
    assert_eq!(offered, 2, "{:?}", explanation.fixes);
}

#[test]
#[ignore = "long"]
fn two_runs_say_the_same() {
    for case in all_cases().filter(|case| ["sensitive.mav", "corridor.mav"].contains(&case.text.name.as_str())) {
        assert_eq!(explained(&case.text).2, case.explanation, "{}", case.text.name);
    }
}

/// Mission times, s, at which texts that fix none are planned: long for every mission here.
const FREE: [&str; 2] = ["45s", "60s"];

/// On texts in which everything else is left out: the statements have no plan together, and one as soon as any of them
/// is left out too.
#[test]
#[ignore = "long"]
fn no_statement_can_be_spared() {
    for Case { text, model, explanation, .. } in all_cases() {
        let named = &explanation.conflict.statements;
        let mut alone = text.clone();
        let all = statements(Problem::of(model).unwrap());
        for statement in all.into_iter().filter(|s| !named.contains(s)) {
            alone.leave_out_of(text, statement);
        }
        let outcomes = alone.outcomes();
        let told: Vec<String> = outcomes.iter().map(short).collect();
        let none = outcomes.iter().all(|outcome| matches!(outcome, PlanOutcome::Infeasible(Proof { .. })));
        assert!(none, "{:?}\n{:#?}\n{told:?}", alone.overrides, alone.files);
        for &statement in named {
            let mut fewer = alone.clone();
            fewer.leave_out_of(text, statement);
            let outcomes = fewer.outcomes();
            let told: Vec<String> = outcomes.iter().map(short).collect();
            let any = outcomes.iter().any(|outcome| matches!(outcome, PlanOutcome::Planned(_)));
            assert!(any, "{:?} {statement:?}\n{:#?}\n{told:?}", fewer.overrides, fewer.files);
        }
    }
}

fn short(outcome: &PlanOutcome) -> String {
    match outcome {
        PlanOutcome::Planned(solved) => format!("solved in {} s", solved.time),
        other => format!("{other:?}"),
    }
}

impl Text {
    /// Leaves out a statement of the text that this one was made from.
    fn leave_out_of(&mut self, whole: &Text, statement: Statement) {
        let (_, before) = whole.model();
        let (_, now) = self.model();
        let places =
            |model: &Model| model.mission.as_ref().unwrap().limits.iter().map(|l| l.kind.clone()).collect::<Vec<_>>();
        // Limits that have gone have moved the others.
        let moved = match statement {
            Statement::Limit(limit) => {
                let kind = &before.mission.as_ref().unwrap().limits[limit].kind;
                Statement::Limit(places(&now).iter().position(|k| k == kind).unwrap())
            }
            other => other,
        };
        self.leave_out(moved);
    }
}

/// What is sought is what is needed, where a closed form tells: the way over the largest speed, and the shortest time
/// of a motion with bounded jerk from rest to rest, (32 d/j)^(1/3).
#[test]
fn times_offered_are_not_below_what_closed_forms_allow() {
    let time_of = |name: &str| {
        let case = CASES.iter().find(|case| case.text.name == name).unwrap();
        let times = case.explanation.fixes.iter().filter_map(|fix| match fix.change {
            Change::Time(time) | Change::Arrival { time, .. } => Some(time),
            _ => None,
        });
        times.fold(f64::INFINITY, f64::min)
    };
    // The least time, and what may be added for acceleration, coarse grids and rounding to two digits.
    // Up with all thrust against g, then falling to rest: T^2 = 2 d (a + g) / (a g), a = F/m - g.
    let up: f64 = 4.0 * 7.0 / 1.9 - 9.81;
    let rise = (2.0 * (40.0 - 0.1) * (up + 9.81) / (up * 9.81)).sqrt();
    let cases: [(&str, f64, f64); 5] = [
        ("heavy.mav", rise, 1.1),
        // Both ends may be missed by the tolerance.
        ("slow_in_time.mav", (60.0 - 0.1) / 6.0, 1.25),
        ("gentle.mav", (32.0_f64 * (10.0 - 0.1)).cbrt(), 1.1),
        // Half of the way takes all but the hold of 2 s, which the legs share by length: 10 m and 30 m.
        ("slow_descent.mav", 2.0 + (30.0 - 0.1) / 1.0 * 40.0 / 30.0, 1.1),
        ("moving.mav", 2.0 * (50.0 - 0.1) / 10.0, 1.2),
    ];
    for (name, least, more) in cases {
        let time = time_of(name);
        // Between nodes a limit may be violated by 5 %.
        assert!(time > 0.95 * least && time <= least * more, "{name}: {time} s, at least {least} s");
    }
}

mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn every_change_offered_gives_a_plan() {
        let mut kinds = Vec::new();
        for Case { text, explanation, .. } in all_cases() {
            for fix in &explanation.fixes {
                let mut changed = text.clone();
                changed.change(fix.change);
                assert!(changed.plans(), "{} {:?}\n{}", text.name, fix.change, changed.files[&text.name]);
                kinds.push(fix.change.kind());
            }
            if explanation.fixes.is_empty() {
                assert_eq!(text.name, "two_conflicts.mav");
            }
        }
        for kind in [
            "samples", "time", "arrival", "within", "limit", "reserve", "no_limit", "no_hold", "no_stop", "no_mode",
            "mass",
        ] {
            assert!(kinds.contains(&kind), "no {kind} is offered: {kinds:?}");
        }
    }
}
