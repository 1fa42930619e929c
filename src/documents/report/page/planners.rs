//! The comparison of planners.

use super::motion::signed_percent;
use super::prose::{terms, unbroken};
use super::table::{Frame, counts, numbers, table, words};
use super::verdicts::violation_cells;
use crate::model::Mission;
use crate::number::{down, number, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Run};
use crate::report::record::{PlannerRecord, Record};
use crate::report::recoverable;
use crate::report::without_yaw;
use maud::{Markup, html};

/// The tables of the paper's section 5.4: each planner at its own shortest time, and all planners at one time.
pub fn section(mission: &Mission, comparison: &Comparison, record: &Record) -> Markup {
    let runs: Vec<(&PlannerRun, &PlannerRecord)> = comparison.runs.iter().zip(&record.planners).collect();
    let has_modes = !comparison.modes.is_empty();
    let has_risk = record.planners.iter().any(|p| p.risk.is_some());
    let has_solved = |which: Run| comparison.runs.iter().any(|r| r.run == which);
    let title = |which: Run| match (which, comparison.common_time) {
        (Run::Own, _) => "Each planner at its own shortest time".to_string(),
        (Run::Common, Some(t)) => format!("All planners at one time, {} s", number(t)),
        (Run::Common, None) => "All planners at one time".to_string(),
    };
    let found = record.planners.iter().filter(|planner| planner.time_s.is_some());
    let bound = found.filter_map(|planner| planner.time_lower_bound_s).reduce(f64::min);
    let heads = || {
        let mut heads = vec![words("Planner"), numbers("Time", "s")];
        if has_modes {
            heads.push(numbers("Smallest spare", "healthy widths"));
            heads.extend(["Longest violation", "Last violation"].map(|name| numbers(name, "s")));
        }
        heads.extend([numbers("Sum of errors", "m"), numbers("Largest error", "cm"), numbers("Yaw errors", "rad")]);
        heads.extend(["Objective", "Rows per node"].map(counts));
        heads.extend(has_risk.then(|| counts("Risk")));
        heads
    };
    let of_runs = |which: Run| {
        let title = title(which);
        let caption = Some(html! { (title) });
        let frame = Frame { label: &title, terms: Some("planners-terms"), caption, ..Frame::default() };
        let rows = html! {
            @for (run, record) in runs.iter().filter(|(r, _)| r.run == which) {
                (row(run, record, has_modes, has_risk))
            }
        };
        table(frame, &heads(), rows)
    };
    html! {
        h2 { (headline(comparison)) }
        @if let Some(bound) = bound {
            p.note { "No motion " (mission.bounded_within(false)) " takes less than " (down(bound, 4)) " s." }
        }
        @for which in [Run::Common, Run::Own] { @if has_solved(which) { (of_runs(which)) } }
        p.note { (unbroken(&recoverable::sentence(record.recoverable.as_ref()))) }
        (terms("planners-terms", meanings(has_modes, has_risk)))
    }
}

/// The meaning of the tables' columns.
fn meanings(has_modes: bool, has_risk: bool) -> Vec<(&'static str, &'static str)> {
    let mut found = Vec::new();
    if has_modes {
        found.extend([
            ("Smallest spare", "over the flight and all modes; negative outside a set."),
            ("Longest violation", "how long the plan is outside the admissible set of the worst mode."),
            ("Last violation", "of any mode's set; a fault before this instant still meets a violation."),
        ]);
    }
    found.extend([
        ("Sum of errors", "distances from the waypoints when they are passed."),
        ("Yaw errors", "the same for yaw."),
        ("Objective", "the cost that the planners minimise."),
        ("Rows per node", "inequalities on the wrench at each node."),
    ]);
    if has_risk {
        found.push(("Risk", "probability that a fault strikes while the mission is committed to it."));
    }
    found
}

/// The runs at their own times or at the common time that have a plan, each with its plan.
pub fn solved_runs(comparison: &Comparison, which: Run) -> impl Iterator<Item = (&PlannerRun, &MissionPlan)> {
    let runs = comparison.runs.iter().filter(move |run| run.run == which);
    runs.filter_map(|run| Some((run, run.outcome.plan()?)))
}

/// The main result of the comparison.
fn headline(comparison: &Comparison) -> String {
    let stays = |s: &MissionPlan| s.outside.iter().all(|o| o.last.is_none());
    let common: Vec<(&PlannerRun, &MissionPlan)> = solved_runs(comparison, Run::Common).collect();
    let inside = common.iter().filter(|(_, s)| stays(s)).count();
    match common.len() {
        0 => "No plan was found at a common time".into(),
        n if comparison.modes.is_empty() => format!("{n} plans at one time"),
        n => {
            let stay = if inside == 1 { "stays" } else { "stay" };
            let sets = match without_yaw::measured_by(comparison) {
                "admissible set" => "sets",
                "core" => "cores",
                _ => "sets and cores",
            };
            format!("At one time, {inside} of {n} plans {stay} inside the {sets} of all modes planned against")
        }
    }
}

fn row(run: &PlannerRun, record: &PlannerRecord, has_modes: bool, has_risk: bool) -> Markup {
    let name = match (run.against.len(), record.name) {
        (n, "rcp") if n > 1 => "RCP jointly".to_string(),
        _ => crate::planner::studies::label(run.planner, &run.against),
    };
    let PlanOutcome::Planned(solved) = &run.outcome else {
        let columns = 6 + if has_modes { 3 } else { 0 } + usize::from(has_risk);
        return html! { tr { th scope="row" { (name) } td.bad colspan=(columns) { (record.verdict) } } };
    };
    let longest = solved.outside.iter().map(|o| o.seconds).fold(0.0, f64::max);
    let last = solved.outside.iter().filter_map(|o| o.last).max_by(f64::total_cmp);
    let [seconds, last_violation] = violation_cells(longest, last);
    let value = |x: Option<f64>, digits: usize| x.map_or("\u{2013}".into(), |v| significant(v, digits));
    html! {
        tr {
            th scope="row" { (name) }
            td.n { (number(solved.time)) }
            @if has_modes {
                td.n.bad[last.is_some()] { (solved.smallest_margin().map_or("\u{2013}".into(), signed_percent)) }
                td.n { (seconds) }
                td.n { (last_violation) }
            }
            td.n { (value(record.position_error_m, 4)) }
            td.n { (value(record.max_waypoint_error_m.map(|e| 100.0 * e), 3)) }
            td.n { (value(record.yaw_error_rad, 3)) }
            td.n { (number(solved.least_objective)) }
            td.n { (run.set.rows.len()) }
            @if has_risk { td.n { (value(record.risk, 3)) } }
        }
    }
}
