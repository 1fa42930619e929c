//! The explanation of a missing plan in the machine-readable report.

use crate::explain::Explanation;
use crate::model::{Mission, Model, OVERRIDE};
use crate::source::{FileId, SourceMap};
use crate::verdict::Verdict;
use serde::Serialize;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConflictRecord {
    /// Whether a plan meets all of the statements: `proved infeasible` or `not found`.
    pub verdict: Verdict,
    /// A proof is one for the facets that the RIP plan selects, by RSP.
    pub of_selection: bool,
    /// A proof holds on the grid of the spec's samples; false where it holds for every grid.
    pub of_samples: bool,
    /// A plan was found for the others whenever one statement was left out.
    pub irreducible: bool,
    /// The mission time at which the statements were asked for, s.
    pub time_s: f64,
    /// None of the statements fixes the mission time: `time_s` is one that is long for the mission.
    pub any_time: bool,
    pub statements: Vec<StatementRecord>,
    /// Cheapest first.
    pub fixes: Vec<FixRecord>,
    /// Plans asked for, of the statements and of the changes.
    pub questions: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StatementRecord {
    pub kind: &'static str,
    /// The same for people.
    pub message: String,
    /// Where, for people: `line 13`, `line 4 of octo.mav`, or the `--set` that says it.
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
    /// Which of `statements` it changes; `None` where it is another one.
    pub statement: Option<usize>,
    /// The number changed to, SI; `None` where a statement is left out.
    pub value: Option<f64>,
    /// The same for people.
    pub message: String,
    /// The mission time of the plan it gave, s.
    pub time_s: f64,
}

impl ConflictRecord {
    pub fn new(explanation: &Explanation, model: &Model, mission: &Mission, sources: &SourceMap) -> Self {
        let conflict = &explanation.conflict;
        let statement = |s: &crate::explain::Statement| {
            let span = s.span(model, mission);
            let source = sources.get(span.file);
            let (start, end) = (source.place(span.start as usize), source.place(span.end as usize));
            StatementRecord {
                kind: s.kind(),
                message: s.label(model, mission),
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
            message: fix.change.instruction(model, mission, sources),
            time_s: fix.time,
        };
        ConflictRecord {
            verdict: conflict.verdict(),
            of_selection: conflict.of_selection,
            of_samples: conflict.of_samples,
            irreducible: conflict.irreducible,
            time_s: conflict.time,
            any_time: conflict.any_time,
            statements: conflict.statements.iter().map(statement).collect(),
            fixes: explanation.fixes.iter().map(fix).collect(),
            questions: explanation.questions,
        }
    }
}
