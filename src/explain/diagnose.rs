//! The explanation as a diagnostic on the spec.

use super::{Explanation, Statement};
use crate::diagnostic::Diagnostic;
use crate::model::{Mission, MissionTime, Model, is_override};
use crate::motion::time_grid::determined;
use crate::number::number;
use crate::planner::timing::kinematics::least_time_within;
use crate::source::{SourceMap, Span};
use crate::verdict::Verdict;

/// Statements that are not met together.
pub const CONFLICT: &str = "mavc::plan::conflict";

/// The conflict, each of its statements labelled in place, with the changes that give a plan. What is said at one place counts
/// as one statement there, so that the headline's number is that of the labels.
pub fn diagnose(explanation: &Explanation, model: &Model, mission: &Mission, sources: &SourceMap) -> Diagnostic {
    let conflict = &explanation.conflict;
    // What one would rather change comes first.
    let rank = |s: &Statement| match s {
        Statement::Time => 0,
        Statement::Arrival(_) => 1,
        Statement::Hold(_) => 2,
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
        let (span, mut label) = (statement.span(model, mission), statement.label(model, mission));
        let asked = matches!(statement, Statement::Mode(_)) && is_override(sources, model.plan.against_span);
        if asked || is_override(sources, span) {
            label.push_str(", says `--set`");
        }
        match labels.iter_mut().find(|(other, _)| *other == span) {
            Some((_, text)) => *text = format!("{text}, {label}"),
            None => labels.push((span, label)),
        }
    }
    // The spec's own text first, so that its labels stand in one excerpt.
    labels.sort_by_key(|(span, _)| is_override(sources, *span));
    let headline = headline(explanation, labels.len(), model, mission);
    let mut labels = labels.into_iter();
    let (span, label) = labels.next().unwrap_or((mission.span, String::new()));
    let error = Diagnostic::error(CONFLICT, span, headline).here(label);
    labels.fold(error, |error, (span, label)| error.also(span, label)).help(help(explanation, model, mission, sources))
}

/// The mission time that the spec fixes, s.
fn asked_for(model: &Model, mission: &Mission) -> Option<f64> {
    determined(mission).or(match model.plan.time {
        MissionTime::Fixed(time) => Some(time),
        MissionTime::Minimum => None,
    })
}

/// `places`: the labels. A proof is one for the spec's samples, unless distances and
/// limits alone show it, and in RSP for the facets selected.
fn headline(explanation: &Explanation, places: usize, model: &Model, mission: &Mission) -> String {
    let asked_for = asked_for(model, mission);
    let conflict = &explanation.conflict;
    let verdict = conflict.verdict();
    // Where a waypoint has its time, the mission's is another one.
    let (a_mission_of, it) = match conflict.statements.iter().any(|s| matches!(s, Statement::Arrival(_))) {
        true => ("a mission of ", "it"),
        false => ("", "this mission"),
    };
    let is_of_all = !conflict.of_samples && least_time_within(model, mission).too_early.is_some();
    let time = match (conflict.any_time && !is_of_all, asked_for.filter(|asked| *asked < conflict.time)) {
        // Shown, or tried, of this time alone: at another one the same samples are other instants.
        (true, Some(asked)) => {
            let [tried, asked] = [conflict.time, asked].map(number);
            format!(" in {a_mission_of}{tried} s, at which they were tried; the spec asks for {asked} s")
        }
        (true, None) => format!(" in {a_mission_of}{} s, ample time for {it}", number(conflict.time)),
        (false, _) => String::new(),
    };
    let facets = if conflict.of_selection { " and the facets that the RIP plan selects" } else { "" };
    let grid = match conflict.of_samples {
        true => format!(" with {} samples{facets}", model.plan.samples),
        false => String::new(),
    };
    match (verdict == Verdict::ProvedInfeasible, places) {
        (true, 1) => format!("{verdict}{grid}: a statement of the spec cannot be met{time}"),
        (true, n) => format!("{verdict}{grid}: {n} statements of the spec cannot hold together{time}"),
        (false, 1) => format!("{verdict}: a plan that meets this statement{time}; a guess at the cause, not a proof"),
        (false, n) => {
            format!(
                "{verdict}: a plan that meets these {n} statements together{time}; a guess at the cause, not a proof"
            )
        }
    }
}

fn help(explanation: &Explanation, model: &Model, mission: &Mission, sources: &SourceMap) -> String {
    let mut fixes = explanation.fixes.iter().map(|fix| fix.change.instruction(model, mission, sources));
    let changes = match (fixes.next(), fixes.next()) {
        (None, _) if explanation.conflict.statements.len() == 1 => {
            "change this statement; none of the changes that were tried is enough".into()
        }
        (None, _) => "change one of these statements; none of the single changes that were tried is enough".into(),
        (Some(one), None) => format!("{one}; this was tried and gives a plan"),
        (Some(one), Some(two)) => {
            let rest: String = [one, two].into_iter().chain(fixes).map(|fix| format!("\n- {fix}")).collect();
            format!("each of these was tried and gives a plan:{rest}")
        }
    };
    // Variants of a spec are planned without what it requires of risk.
    let changes = match model.plan.require_risk.is_some() && !explanation.fixes.is_empty() {
        true => format!("{changes}\nWhether such a plan keeps the required risk was not looked at"),
        false => changes,
    };
    match explanation.conflict.irreducible {
        true => changes,
        false => format!("{changes}\nIt was not shown that every one of these statements is needed for the conflict"),
    }
}
