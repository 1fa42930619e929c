//! The explanation as a diagnostic on the spec.

use super::{Explanation, Statement};
use crate::diagnostic::Diagnostic;
use crate::model::{MissionTime, Problem};
use crate::motion::time_grid::determined;
use crate::number::number;
use crate::planner::timing::kinematics::least_time_within;
use crate::read::is_override;
use crate::source::{SourceMap, Span};
use crate::verdict::Verdict;

/// Code of the error for statements that are not satisfied together.
pub const CONFLICT: &str = "mavc::plan::conflict";

/// The conflict as an error, with a label at each of its statements and the changes that give a plan. Statements at the
/// same place count as one, so that the headline's number is that of the labels.
pub fn diagnose(explanation: &Explanation, problem: Problem, sources: &SourceMap) -> Diagnostic {
    let (model, mission) = (problem.model(), problem.mission());
    let conflict = &explanation.conflict;
    // Statements that an author would rather change come first.
    let rank = |s: &Statement| match s {
        Statement::Time => 0,
        Statement::Arrival(_) => 1,
        Statement::Hold(_) | Statement::Stop(_) => 2,
        Statement::Limit(_) => 3,
        Statement::Mode(_) => 4,
        Statement::Reserve => 5,
        Statement::Waypoints { .. } => 6,
        Statement::RestAtStart | Statement::RestAtEnd => 7,
    };
    let mut labels: Vec<(Span, String)> = Vec::new();
    let mut ranked = conflict.statements.clone();
    ranked.sort_by_key(rank);
    for statement in &ranked {
        let (span, mut label) = (statement.span(problem), statement.label(problem));
        let is_set = matches!(statement, Statement::Mode(_)) && is_override(sources, model.plan.against_span);
        if is_set || is_override(sources, span) {
            label.push_str(", set by `--set`");
        }
        match labels.iter_mut().find(|(other, _)| *other == span) {
            Some((_, text)) => *text = format!("{text}, {label}"),
            None => labels.push((span, label)),
        }
    }
    // The spec's own text first, so that its labels share one excerpt.
    labels.sort_by_key(|(span, _)| is_override(sources, *span));
    let headline = headline(explanation, labels.len(), problem);
    let mut labels = labels.into_iter();
    let (span, label) = labels.next().unwrap_or((mission.span, String::new()));
    let error = Diagnostic::error(CONFLICT, span, headline).here(label);
    labels.fold(error, |error, (span, label)| error.also(span, label)).help(help(explanation, problem, sources))
}

/// The mission time that the spec fixes, s.
fn required_time(problem: Problem) -> Option<f64> {
    let (model, mission) = (problem.model(), problem.mission());
    determined(mission).or(match model.plan.time {
        MissionTime::Fixed(time) => Some(time),
        MissionTime::Minimum => None,
    })
}

/// The headline; `places` is the number of labels. A proof is for the spec's samples unless distances and limits
/// suffice, and under RSP for the selected facets.
fn headline(explanation: &Explanation, places: usize, problem: Problem) -> String {
    let model = problem.model();
    let required_time = required_time(problem);
    let conflict = &explanation.conflict;
    let verdict = conflict.verdict();
    // If a waypoint has a fixed time, the mission time is a different one.
    let (a_mission_of, it) = match conflict.statements.iter().any(|s| matches!(s, Statement::Arrival(_))) {
        true => ("a mission of ", "it"),
        false => ("", "this mission"),
    };
    let is_of_all = !conflict.only_for_samples && least_time_within(problem).too_early.is_some();
    let time = match (conflict.time_is_free && !is_of_all, required_time.filter(|time| *time < conflict.time)) {
        // Proved or tried only for this time: at another time the same samples are different instants.
        (true, Some(required)) => {
            let [tried, required] = [conflict.time, required].map(number);
            format!(" in {a_mission_of}{tried} s, the time that was tried; the spec requires {required} s")
        }
        (true, None) => format!(" in {a_mission_of}{} s, ample time for {it}", number(conflict.time)),
        (false, _) => String::new(),
    };
    let facets = if conflict.only_for_selection { " and the facets that RSP guards" } else { "" };
    let grid = match conflict.only_for_samples {
        true => format!(" with {} samples{facets}", model.plan.samples),
        false => String::new(),
    };
    match (verdict == Verdict::ProvedInfeasible, places) {
        (true, 1) => format!("{verdict}{grid}: a statement of the spec cannot be satisfied{time}"),
        (true, n) => format!("{verdict}{grid}: {n} statements of the spec cannot hold together{time}"),
        (false, 1) => {
            format!("{verdict}: a plan that satisfies this statement{time}; a guess at the cause, not a proof")
        }
        (false, n) => {
            format!(
                "{verdict}: a plan that satisfies these {n} statements together{time}; a guess at the cause, not a \
                 proof"
            )
        }
    }
}

fn help(explanation: &Explanation, problem: Problem, sources: &SourceMap) -> String {
    if let (Some(least), Some(required)) = (explanation.conflict.least_time, required_time(problem)) {
        let [least, required] = [least, required].map(number);
        return format!(
            "no motion that keeps these statements alone takes less than {least} s, and without any one of them this \
             bound is not above {required} s; `time = minimum` asks for the shortest time"
        );
    }
    let mut fixes = explanation.fixes.iter().map(|fix| fix.change.instruction(problem, sources));
    let changes = match (fixes.next(), fixes.next()) {
        (None, _) if explanation.conflict.statements.len() == 1 => {
            "change this statement; none of the changes that were tried is sufficient".into()
        }
        (None, _) => "change one of these statements; none of the single changes that were tried is sufficient".into(),
        (Some(one), None) => format!("{one}; this was tried and gives a plan"),
        (Some(one), Some(two)) => {
            let rest: String = [one, two].into_iter().chain(fixes).map(|fix| format!("\n- {fix}")).collect();
            format!("each of these was tried and gives a plan:{rest}")
        }
    };
    // Variants of a spec are planned without its required risk.
    let changes = match problem.model().plan.require_risk.is_some() && !explanation.fixes.is_empty() {
        true => format!("{changes}\nWhether such a plan meets the required risk was not checked"),
        false => changes,
    };
    match explanation.conflict.irreducible {
        true => changes,
        false => format!("{changes}\nIt was not shown that every one of these statements is needed for the conflict"),
    }
}
