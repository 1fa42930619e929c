//! The explanation as a diagnostic on the spec.

use super::{Explanation, Statement};
use crate::diagnostic::Diagnostic;
use crate::model::{Mission, Model};
use crate::report::number::number;
use crate::source::Span;

/// Statements that are not met together.
pub const CONFLICT: &str = "mavc::plan::conflict";

/// The conflict, each of its statements labelled in place, with the changes that give a plan.
pub fn diagnose(explanation: &Explanation, model: &Model, mission: &Mission) -> Diagnostic {
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
        let (span, label) = (statement.span(model, mission), statement.label(model, mission));
        match labels.iter_mut().find(|(other, _)| *other == span) {
            Some((_, text)) => *text = format!("{text}, {label}"),
            None => labels.push((span, label)),
        }
    }
    let mut labels = labels.into_iter();
    let (span, label) = labels.next().unwrap_or((mission.span, String::new()));
    let error = Diagnostic::error(CONFLICT, span, headline(explanation)).here(label);
    labels.fold(error, |error, (span, label)| error.also(span, label)).help(help(explanation, model, mission))
}

fn headline(explanation: &Explanation) -> String {
    let conflict = &explanation.conflict;
    let time = match conflict.any_time {
        true => format!(", even in {} s", number(conflict.time)),
        false => String::new(),
    };
    match (conflict.proved, conflict.statements.len()) {
        (true, 1) => format!("a statement of the spec cannot be met{time}"),
        (true, n) => format!("{n} statements of the spec cannot hold together{time}"),
        (false, 1) => format!("a statement of the spec was not satisfied in our attempts{time}"),
        (false, n) => format!("{n} statements of the spec were not satisfied together in our attempts{time}"),
    }
}

fn help(explanation: &Explanation, model: &Model, mission: &Mission) -> String {
    let mut fixes = explanation.fixes.iter().map(|fix| fix.change.instruction(model, mission));
    let changes = match (fixes.next(), fixes.next()) {
        (None, _) => "change one of these statements; none of the single changes that were tried is enough".into(),
        (Some(one), None) => format!("{one}; this was tried and gives a plan"),
        (Some(one), Some(two)) => {
            let rest: String = [one, two].into_iter().chain(fixes).map(|fix| format!("\n- {fix}")).collect();
            format!("each of these was tried and gives a plan:{rest}")
        }
    };
    match explanation.conflict.irreducible {
        true => changes,
        false => format!("{changes}\nIt was not shown that every one of these statements is needed for the conflict"),
    }
}
