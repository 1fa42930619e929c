//! The explanation of a missing plan in the machine-readable report.

use crate::explain::Explanation;
use crate::model::Problem;
use crate::read::OVERRIDE;
use crate::source::{FileId, SourceMap};
use crate::verdict::Verdict;
use serde::Serialize;

/// Statements that are not satisfied together, and single changes to the spec that were tried and give a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ConflictRecord {
    /// Whether a plan satisfies all of them at `time_s`; `only_for_samples` and `only_for_selection` restrict a
    /// proof.
    #[cfg_attr(test, schemars(with = "String", extend("enum" = ["proved infeasible", "not found"])))]
    pub verdict: Verdict,
    /// Whether a proof holds only for the facets that the RIP plan selects; false if it holds for every selection.
    pub only_for_selection: bool,
    /// Whether a proof holds only on the grid of these samples; false if distances, limits and thrust prove it for
    /// every grid.
    pub only_for_samples: bool,
    /// Whether a plan was found for the others whenever one of the statements was left out.
    pub irreducible: bool,
    /// The mission time at which plans were searched for, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: f64,
    /// Whether none of the statements fixes the mission time; `time_s` is then a time that is long for the mission.
    pub time_is_free: bool,
    /// Where a lower bound on the time is the proof: the least time of motions that keep all statements, s; otherwise
    /// null. Without any one of the statements this bound is not above the required time.
    pub least_time_s: Option<f64>,
    /// In the order of flight, then limits, modes, reserve and time.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub statements: Vec<StatementRecord>,
    /// Single changes to the whole spec, cheapest first; empty if none of those tried is sufficient.
    pub fixes: Vec<FixRecord>,
    /// Searches for a plan, for subsets of the statements and for changes.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub searches: usize,
}

/// A statement of the spec.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StatementRecord {
    /// arrival: the time of a waypoint. time: the time of the plan.
    #[cfg_attr(test, schemars(extend("enum" = [
        "waypoint", "arrival", "hold", "stop", "rest_at_start", "rest_at_end", "limit", "mode", "reserve", "time",
    ])))]
    pub kind: &'static str,
    /// Its requirement, in words.
    pub message: String,
    /// Its place in words: `line 13`, `line 4 of octo.mav`, or the `--set` that makes it.
    #[serde(skip)]
    pub place: String,
    /// The file as it was named.
    pub file: String,
    /// First line, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub line: usize,
    /// Column of its start in Unicode scalars, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub column: usize,
    /// Last line, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub end_line: usize,
    /// Column just after the end, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub end_column: usize,
}

/// A change that gives a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FixRecord {
    /// What is changed; no_limit, no_hold, no_stop and no_mode remove a statement.
    #[cfg_attr(test, schemars(extend("enum" = [
        "samples", "time", "arrival", "within", "limit", "reserve", "no_limit", "no_hold", "no_stop", "no_mode", "mass",
    ])))]
    pub kind: &'static str,
    /// Index into `statements` of the one that is changed; null if something else is changed.
    pub statement: Option<usize>,
    /// The new value, SI; null if a statement is removed.
    pub value: Option<f64>,
    /// The change in words.
    pub message: String,
    /// The mission time at which a plan was found with this change, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
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
            least_time_s: conflict.least_time,
            statements: conflict.statements.iter().map(statement).collect(),
            fixes: explanation.fixes.iter().map(fix).collect(),
            searches: explanation.questions,
        }
    }
}
