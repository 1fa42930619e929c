//! The explanation of a missing plan in the machine-readable report.

use crate::explain::Explanation;
use crate::model::Problem;
use crate::read::OVERRIDE;
use crate::source::{FileId, SourceMap};
use crate::verdict::Verdict;
use serde::Serialize;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConflictRecord {
    /// Whether a plan satisfies all statements: `proved infeasible` or `not found`.
    pub verdict: Verdict,
    /// RSP: a proof holds only for the facets that the RIP plan selects.
    pub only_for_selection: bool,
    /// A proof holds only on the grid of the spec's samples; false if it holds for every grid.
    pub only_for_samples: bool,
    /// Whenever one statement was left out, a plan was found for the others.
    pub irreducible: bool,
    /// The mission time at which plans were searched for, s.
    pub time_s: f64,
    /// None of the statements fixes the mission time: `time_s` is a time that is long for the mission.
    pub time_is_free: bool,
    pub statements: Vec<StatementRecord>,
    /// Cheapest first.
    pub fixes: Vec<FixRecord>,
    /// Searches for a plan, both for subsets of the statements and for changes.
    pub searches: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StatementRecord {
    pub kind: &'static str,
    /// The statement in words.
    pub message: String,
    /// Its place in words: `line 13`, `line 4 of octo.mav`, or the `--set` that makes it.
    #[serde(skip)]
    pub place: String,
    pub file: String,
    pub line: usize,
    pub column: usize,
    pub end_line: usize,
    pub end_column: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FixRecord {
    pub kind: &'static str,
    /// Index into `statements` of the one it changes; `None` if it changes something else.
    pub statement: Option<usize>,
    /// The new value, SI; `None` if a statement is removed.
    pub value: Option<f64>,
    /// The change in words.
    pub message: String,
    /// The mission time of the plan found with this change, s.
    pub time_s: f64,
}

impl ConflictRecord {
    pub fn new(explanation: &Explanation, problem: Problem, sources: &SourceMap) -> Self {
        let conflict = &explanation.conflict;
        let statement = |s: &crate::explain::Statement| {
            let span = s.span(problem);
            let source = sources.get(span.file);
            let (start, end) = (source.place(span.start as usize), source.place(span.end as usize));
            StatementRecord {
                kind: s.kind(),
                message: s.label(problem),
                place: match (source.name.as_str(), span.file) {
                    (OVERRIDE, _) => format!("`{OVERRIDE} {}`", source.text),
                    (_, FileId(0)) => format!("line {}", start.line),
                    (name, _) => format!("line {} of {name}", start.line),
                },
                file: source.name.clone(),
                line: start.line,
                column: start.column,
                end_line: end.line,
                end_column: end.column,
            }
        };
        let fix = |fix: &crate::explain::Fix| FixRecord {
            kind: fix.change.kind(),
            statement: fix.change.of().and_then(|of| conflict.statements.iter().position(|s| *s == of)),
            value: fix.change.value(),
            message: fix.change.instruction(problem, sources),
            time_s: fix.time,
        };
        ConflictRecord {
            verdict: conflict.verdict(),
            only_for_selection: conflict.only_for_selection,
            only_for_samples: conflict.only_for_samples,
            irreducible: conflict.irreducible,
            time_s: conflict.time,
            time_is_free: conflict.time_is_free,
            statements: conflict.statements.iter().map(statement).collect(),
            fixes: explanation.fixes.iter().map(fix).collect(),
            searches: explanation.questions,
        }
    }
}
