//! A row of a comparison beside those of the planners: the plan with ways out after faults, and what these cost.

use super::recovery::{RecoveryRecord, ReplannedRecord};
use super::screen::{Keep, Screen, Tone};
use crate::model::Model;
use crate::number::{percent, significant};
use crate::planner::studies::PlannerRun;
use crate::recovery::Recovery;
use crate::text_table::{Table, filled, indented};
use crate::verdict::Verdict;
use serde::Serialize;

/// The plan that `mavc plan` makes with `require uncovered`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RecoverableRecord {
    /// The planner of the plan before it was planned again, if it was.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::PLANNER.words())))]
    pub planner: &'static str,
    /// Whether there is a plan.
    #[cfg_attr(test, schemars(with = "String", extend("enum" = Verdict::ALL.map(Verdict::word))))]
    pub verdict: Verdict,
    /// Mission time, s; null without a plan.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: Option<f64>,
    /// The largest share of the time without a way out that `require uncovered` allows.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub required: f64,
    /// The share of the time without a way out; null without a plan.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub uncovered: Option<f64>,
    /// If the mission was planned again because the first plan did not meet the bound: how, and at what price. Omitted
    /// otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replanned: Option<ReplannedRecord>,
}

impl RecoverableRecord {
    /// Of the run of a plan and its ways out; `None` if the spec requires none.
    pub fn new(model: &Model, run: &PlannerRun, recovery: Option<&Recovery>) -> Option<Self> {
        let required = model.plan.recovery.require?.uncovered;
        let found = recovery.map(|recovery| RecoveryRecord::new(model, recovery));
        Some(RecoverableRecord {
            planner: run.planner.name(),
            verdict: run.outcome.verdict(),
            time_s: run.outcome.plan().map(|plan| plan.time),
            required,
            uncovered: found.as_ref().map(|found| found.uncovered),
            replanned: found.and_then(|found| found.replanned),
        })
    }

    /// `With ways out after faults, `require uncovered <= 0 %``
    pub fn title(&self) -> String {
        format!("With ways out after faults, `require uncovered <= {}`", percent(self.required))
    }

    /// `the same time`, `0.9 s (4.6 %) more`
    pub fn price(&self) -> String {
        match &self.replanned {
            Some(again) if again.price_s.abs() >= 5e-3 => {
                format!("{} s ({}) more", significant(again.price_s, 3), percent(again.price_s / again.time_before_s))
            }
            _ => "the same time".into(),
        }
    }

    /// The share without a way out of the plan found first, if it was planned again.
    pub fn before(&self) -> Option<String> {
        self.replanned.as_ref().map(|again| percent(again.uncovered_before))
    }
}

/// In words that nothing of the kind was attempted.
const NOT_ATTEMPTED: &str = "Ways out after faults: not sought; `mavc plan --recovery` looks for them.";

/// Digits of times.
const DIGITS: usize = 4;

/// In words on a screen, where there is room, that the spec does not ask for the row.
pub fn write_not_attempted(screen: &mut Screen) {
    screen.part(Keep::Legend, None, |screen| screen.paragraph(Tone::Plain, 2, 2, NOT_ATTEMPTED));
}

/// The row on a screen.
pub fn write(screen: &mut Screen, record: &RecoverableRecord) {
    screen.gap();
    screen.paragraph(Tone::Strong, 2, 2, &record.title());
    screen.table(&record.table());
    if let Some(text) = record.unmet() {
        screen.paragraph(Tone::Bad, 2, 2, text);
    }
}

/// The row for `-v`.
pub fn text(record: Option<&RecoverableRecord>) -> String {
    let Some(record) = record else { return format!("\n{}", filled(NOT_ATTEMPTED)) };
    let unmet = record.unmet().map_or(String::new(), indented);
    format!("\n{}\n{}{unmet}", record.title(), record.table().render(2))
}

/// The row as a sentence, for a page.
pub fn sentence(record: Option<&RecoverableRecord>) -> String {
    let Some(record) = record else { return NOT_ATTEMPTED.into() };
    let (Some(time), Some(uncovered)) = (record.time_s, record.uncovered) else {
        return format!("{}: {}.", record.title(), record.verdict.word());
    };
    let before = record.before().map_or(String::new(), |before| format!(", before {before}"));
    format!(
        "{}: {} s with {}, {}; without a way out {}{before}. {}",
        record.title(),
        significant(time, DIGITS),
        record.planner.to_uppercase(),
        record.price(),
        percent(uncovered),
        record.unmet().unwrap_or_default()
    )
}

impl RecoverableRecord {
    /// One row.
    fn table(&self) -> Table {
        let mut table = Table::new(&["planner", "time", "price of ways out", "without a way out", "before"]);
        let mut cells = vec![self.planner.to_uppercase()];
        match (self.time_s, self.uncovered) {
            (Some(time), Some(uncovered)) => {
                let before = self.before().unwrap_or("-".into());
                cells.extend([format!("{} s", significant(time, DIGITS)), self.price(), percent(uncovered), before]);
            }
            _ => cells.push(self.verdict.word().into()),
        }
        table.row(cells);
        table
    }

    /// If too many faults have no way out, that no better plan was found.
    fn unmet(&self) -> Option<&'static str> {
        let is_unmet = self.uncovered.is_some_and(|uncovered| uncovered > self.required);
        is_unmet.then_some("No plan with so few gaps was found; `mavc plan` names those that are left.")
    }
}
