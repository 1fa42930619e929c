//! Which constraints limit the time of a plan, leg by leg.

use super::waypoints;
use crate::model::{Limit, Mission, Problem};
use crate::number::{fixed, number, significant};
use crate::planner::scp::sensitivity::{Statement, Unit};
use crate::planner::studies::MissionPlan;
use crate::text_table::Table;
use serde::Serialize;

/// Statements whose relaxation saves less time than this are omitted, s.
const LEAST: f64 = 1e-3;

/// Statements listed on the line of one leg.
const MOST_LISTED: usize = 3;

/// The statements that limit the duration of one leg.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BindingRecord {
    /// From 1; leg k arrives at waypoint k + 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub leg: usize,
    /// Name of that waypoint; null if it has none.
    pub to: Option<String>,
    /// Duration of the leg, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub duration_s: f64,
    /// Active statements, the largest saving first; savings below 1 ms are omitted.
    pub statements: Vec<StatementRecord>,
}

/// One statement that is active on a leg.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "BindingStatement"))]
pub struct StatementRecord {
    /// A limit; a facet of a set, for the wrench or for the commanded wrench of lagging rotors; the upright thrust; a
    /// tolerance; rest at a waypoint.
    #[cfg_attr(test, schemars(extend(
        "enum" = ["limit", "set", "commands", "upright", "within", "yaw_within", "rest"]
    )))]
    pub kind: &'static str,
    /// The statement in the words of the spec.
    pub statement: String,
    /// The fault mode of the set; null for the healthy vehicle and for other statements.
    pub mode: Option<String>,
    /// By how much the statement is relaxed: 1 % of a limit, of a tolerance or of the healthy set's width; 10 cm or 1
    /// deg of a coordinate; 0.1 m/s at rest.
    #[cfg_attr(test, schemars(extend("enum" = ["1 %", "10 cm", "1 deg", "0.1 m/s"])))]
    pub relaxed_by: &'static str,
    /// By how much this shortens the mission, to first order, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub time_saved_s: f64,
}

/// One record for each leg, with the statements whose relaxation saves at least 1 ms.
pub fn records(problem: Problem, solved: &MissionPlan) -> Vec<BindingRecord> {
    let mission = problem.mission();
    let legs = solved.binding.iter().enumerate().map(|(leg, binding)| {
        let counted = binding.statements.iter().filter(|(_, seconds)| *seconds >= LEAST);
        BindingRecord {
            leg: leg + 1,
            to: mission.waypoints[leg + 1].name.clone(),
            duration_s: binding.duration,
            statements: counted.map(|&(statement, seconds)| record(problem, statement, seconds)).collect(),
        }
    });
    legs.collect()
}

fn record(problem: Problem, statement: Statement, time_saved_s: f64) -> StatementRecord {
    let (model, mission) = (problem.model(), problem.mission());
    let at = |waypoint: usize| format!("at {}", place(mission, waypoint));
    let mode = |set: usize| set.checked_sub(1).and_then(|mode| model.modes.get(mode)).map(|mode| mode.name.clone());
    let of = |set: usize| mode(set).unwrap_or_else(|| "the healthy vehicle".into());
    let (kind, text, relaxed_by) = match statement {
        Statement::Limit(limit) => {
            let limit = &mission.limits[limit];
            let relaxed_by = match Unit::of(&limit.kind) {
                Unit::Position => "10 cm",
                Unit::Yaw => "1 deg",
                Unit::Share => "1 %",
            };
            ("limit", bound(limit), relaxed_by)
        }
        Statement::Set(set) => ("set", format!("set of {}", of(set)), "1 %"),
        Statement::Commands(set) => ("commands", format!("commands in the set of {}", of(set)), "1 %"),
        Statement::Upright => ("upright", "upright thrust".to_string(), "1 %"),
        Statement::Within(waypoint) => ("within", format!("tolerance {}", at(waypoint)), "1 %"),
        Statement::YawWithin(waypoint) => ("yaw_within", format!("yaw tolerance {}", at(waypoint)), "1 %"),
        Statement::Rest(waypoint) => ("rest", format!("rest {}", at(waypoint)), "0.1 m/s"),
    };
    let mode = match statement {
        Statement::Set(set) | Statement::Commands(set) => mode(set),
        _ => None,
    };
    StatementRecord { kind, statement: text, mode, relaxed_by, time_saved_s }
}

/// The quoted name of a waypoint, or `waypoint 3`.
fn place(mission: &Mission, waypoint: usize) -> String {
    match &mission.waypoints[waypoint].name {
        Some(name) => format!("`{name}`"),
        None => format!("waypoint {}", waypoint + 1),
    }
}

/// `climb <= 4 m/s`, `keep_in field`
fn bound(limit: &Limit) -> String {
    if let Some(volume) = &limit.volume {
        return volume.name.clone();
    }
    let description = limit.kind.describe();
    let (name, unit, factor) = (description.name, description.unit, description.factor());
    let value = |bound: f64| number(bound * factor);
    match (limit.lower, limit.upper) {
        (Some(low), Some(high)) if low == -high => format!("{name} <= {} {unit}", value(high)),
        (Some(low), Some(high)) => format!("{name} in {} .. {} {unit}", value(low), value(high)),
        (Some(low), None) => format!("{name} >= {} {unit}", value(low)),
        (None, Some(high)) => format!("{name} <= {} {unit}", value(high)),
        (None, None) => name.to_string(),
    }
}

/// One line for each leg whose time some statement limits; empty if the time was not searched for.
pub fn text(problem: Problem, solved: &MissionPlan) -> String {
    let mission = problem.mission();
    let records = records(problem, solved);
    let mut table = Table::new(&["leg", "time", "limited by"]);
    let last_fixed = last_fixed(mission);
    let relaxed = records.iter().filter(|record| record.leg > last_fixed);
    let (limited, others): (Vec<_>, Vec<_>) = relaxed.partition(|record| !record.statements.is_empty());
    if limited.is_empty() {
        return String::new();
    }
    for record in limited {
        let listed: Vec<String> = record.statements.iter().take(MOST_LISTED).map(StatementRecord::words).collect();
        table.row(vec![record.label(), format!("{} s", fixed(record.duration_s, 2)), listed.join("; ")]);
    }
    let others = match others.len() {
        0 => String::new(),
        1 => "  On the other leg no relaxation saves 1 ms.\n".to_string(),
        n => format!("  On the other {n} legs no relaxation saves 1 ms.\n"),
    };
    let notes: String = notes(mission).iter().map(|note| format!("  {note}\n")).collect();
    format!("\n  {HEADLINE}\n{}{others}{notes}", table.render_left(2))
}

/// Index of the last waypoint with a fixed time, 0 if there is none.
fn last_fixed(mission: &Mission) -> usize {
    mission.waypoints.iter().rposition(|w| w.time.is_some()).unwrap_or(0)
}

/// What the table omits: legs up to the last fixed time, and the holds after it.
pub fn notes(mission: &Mission) -> Vec<String> {
    let fixed = last_fixed(mission);
    let mut notes = Vec::new();
    if fixed > 0 {
        let at = place(mission, fixed);
        notes.push(format!("Legs up to {at}, whose time is fixed, are not relaxed: they do not lengthen the mission."));
    }
    if mission.waypoints[fixed..].iter().any(|w| w.hold > 0.0) {
        notes.push("Holds are not relaxed: each lengthens the mission by its duration.".into());
    }
    notes
}

/// The caption of the table, in the terminal and on the page.
pub const HEADLINE: &str =
    "What limits the time, and the time saved to first order by relaxing each by 1 % (a set: 1 % of its width)";

impl BindingRecord {
    /// ``the leg to waypoint 2 `climb` ``
    pub fn to(&self) -> String {
        format!("the leg to {}", waypoints::waypoint(self.leg + 1, self.to.as_deref()))
    }

    /// ``1 to `climb` ``
    pub fn label(&self) -> String {
        let to = self.to.as_ref().map_or(String::new(), |name| format!(" to `{name}`"));
        format!("{}{to}", self.leg)
    }
}

impl StatementRecord {
    /// `climb <= 4 m/s: relaxing it by 1 % saves 0.096 s`
    pub fn saved(&self) -> String {
        let seconds = significant(self.time_saved_s, 2);
        format!("{}: relaxing it by {} saves {seconds} s", self.statement, self.relaxed_by)
    }

    /// `climb <= 4 m/s: 0.096 s`
    pub fn words(&self) -> String {
        let by = if self.relaxed_by == "1 %" { String::new() } else { format!(" for {}", self.relaxed_by) };
        format!("{}: {} s{by}", self.statement, significant(self.time_saved_s, 2))
    }
}
