//! The short output of `mavc compare`: what safety costs.

use super::battery;
use super::caveats::caveats;
use super::comparison_text::name_of;
use super::plan_screen::{instant, unsafe_until, warn_of_not_covered};
use super::planner_names::planners_in_full;
use super::record::rates;
use super::recoverable::{self, RecoverableRecord};
use super::screen::{Keep, Screen, Tone};
use super::terminal::vehicle_line;
use crate::admissible::row::VIOLATED;
use crate::admissible::without_yaw::planned::Provision;
use crate::model::{Model, PlannerKind, Problem};
use crate::motion::risk::rated_risk;
use crate::motion::time_grid::determined;
use crate::number::{percent, plural, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlannerRun, Run};
use crate::report::without_yaw;
use crate::text_table::Table;
use std::collections::BTreeSet;

/// Digits of times and energies.
const DIGITS: usize = 4;

/// The output; `recoverable` is the plan with ways out after faults, if the spec requires them.
pub fn screen(problem: Problem, comparison: &Comparison, recoverable: Option<&RecoverableRecord>) -> Screen {
    let (model, mission) = (problem.model(), problem.mission());
    let mut screen = Screen::default();
    screen.paragraph(Tone::Plain, 0, 2, &format!("{} with {}", mission.name, vehicle_line(model)));
    screen.gap();
    let (tone, text) = answer(model, comparison);
    screen.paragraph(tone, 2, 2, &text);
    warn_of_not_covered(model, &mut screen);
    if let Some(text) = without_yaw::not_planned(comparison, None) {
        screen.paragraph(Tone::Bad, 2, 2, &text);
    }
    let is_own = |run: &PlannerRun| run.run == Run::Own;
    let own = match determined(mission) {
        Some(_) => "Each planner alone, at the only time that the mission's fixed times allow",
        None => "Each planner alone, at the shortest time found for it",
    };
    block(&mut screen, problem, comparison, own, is_own);
    if let Some(time) = comparison.common_time {
        let title = format!("All planners at one time, {} s", significant(time, DIGITS));
        block(&mut screen, problem, comparison, &title, |run| !is_own(run));
    }
    if let Some(record) = recoverable {
        recoverable::write(&mut screen, record);
    }
    let hidden: BTreeSet<&[String]> =
        comparison.runs.iter().filter(|run| !is_shown(comparison, run)).map(|run| run.against.as_slice()).collect();
    if !hidden.is_empty() {
        let text = format!("RCP against each of {} alone: -v", plural(hidden.len(), "mode"));
        screen.paragraph(Tone::Plain, 2, 2, &text);
    }
    legends(model, comparison)
        .iter()
        .for_each(|text| screen.part(Keep::Legend, None, |screen| screen.paragraph(Tone::Plain, 2, 2, text)));
    if recoverable.is_none() {
        recoverable::write_not_attempted(&mut screen);
    }
    if let Some(text) = outside_the_model(model, comparison) {
        screen.remark(Keep::Finding, &text);
    }
    screen.close();
    screen
}

/// What the planners do, and the meaning of the columns. The last one is the first to go where lines are few.
fn legends(model: &Model, comparison: &Comparison) -> Vec<String> {
    if comparison.modes.is_empty() {
        return Vec::new();
    }
    let objective = match model.vehicle.battery {
        None => "; objective: errors and effort, minimised locally",
        Some(_) => "",
    };
    vec![
        planners_in_full(&[PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp]),
        format!(
            "covers: modes after which a plan is never unsafe; violation: largest, % of the healthy set's \
             width{objective}"
        ),
    ]
}

/// `the linear model does not hold for the plans of RIP, RSP, ...`; `None` if it holds for every plan shown.
fn outside_the_model(model: &Model, comparison: &Comparison) -> Option<String> {
    let leaves = |run: &&PlannerRun| {
        let plan = run.outcome.plan();
        plan.is_some_and(|plan| caveats(model, plan).iter().any(|caveat| caveat.kind.is_outside_the_model()))
    };
    let shown = comparison.runs.iter().filter(|run| is_shown(comparison, run));
    let mut names: Vec<String> = shown.filter(leaves).map(name_of).collect();
    names.sort_unstable();
    names.dedup();
    (!names.is_empty()).then(|| {
        format!(
            "The linear model does not hold for plans of {}, which tilt too far or leave no thrust; `mavc plan` says \
             where. Limit the tilt or plan with `model = exact`.",
            names.join(", ")
        )
    })
}

/// The planners that a reader chooses from: RIP, RSP, and RCP against all modes.
fn is_shown(comparison: &Comparison, run: &PlannerRun) -> bool {
    run.planner != PlannerKind::Rcp || run.against.len() == comparison.modes.len()
}

/// How many modes a plan covers: those whose sets or cores it never leaves.
fn covered(model: &Model, comparison: &Comparison, plan: &MissionPlan) -> usize {
    let is_planned = |i: &usize| comparison.provisions[*i] != Provision::Capture;
    (0..comparison.modes.len()).filter(is_planned).filter(|&i| unsafe_until(model, plan, i).is_none()).count()
}

/// The largest violation of a set; `None` if the plan leaves none.
fn violation(plan: &MissionPlan) -> Option<f64> {
    plan.outside.iter().map(|out| out.max_violation).filter(|v| *v > VIOLATED).reduce(f64::max)
}

/// Until when a fault of some mode meets a violation, s; `None` if it never does.
fn unsafe_for_any(model: &Model, plan: &MissionPlan) -> Option<f64> {
    (0..plan.outside.len()).filter_map(|i| unsafe_until(model, plan, i)).reduce(f64::max)
}

/// `At the shortest times, covering all 8 modes costs 10 % more time: 20.1 s with RCP; RIP, ignoring faults, takes
/// 18.2 s, unsafe until 12.30 s`
fn answer(model: &Model, comparison: &Comparison) -> (Tone, String) {
    let n = comparison.modes.len();
    let planned = |which: Run| {
        let runs = comparison.runs.iter().filter(move |run| run.run == which && is_shown(comparison, run));
        runs.filter_map(|run| Some((run, run.outcome.plan()?))).collect::<Vec<_>>()
    };
    let which = if planned(Run::Own).is_empty() { Run::Common } else { Run::Own };
    let plans = planned(which);
    let rip = plans.iter().find(|(run, _)| run.planner == PlannerKind::Rip);
    let fastest = |plans: &[(&PlannerRun, &MissionPlan)]| {
        plans.iter().min_by(|a, b| a.1.time.total_cmp(&b.1.time)).map(|(run, plan)| (name_of(run), plan.time))
    };
    let seconds = |time: f64| format!("{} s", significant(time, DIGITS));
    if plans.is_empty() {
        let words: Vec<String> = comparison
            .runs
            .iter()
            .filter(|run| is_shown(comparison, run))
            .map(|run| format!("{} {}", name_of(run), run.outcome.verdict()))
            .collect();
        return (Tone::Bad, format!("NO PLAN: {}", words.join(", ")));
    }
    if n == 0 {
        let time = fastest(&plans).map_or(String::new(), |(name, time)| format!("{name} takes {}", seconds(time)));
        return (Tone::Warning, format!("No fault mode is planned against: nothing to compare. {time}"));
    }
    let ignoring = rip.map(|(_, plan)| {
        let unsafe_until =
            unsafe_for_any(model, plan).map_or(String::new(), |last| format!(", unsafe until {}", instant(plan, last)));
        format!("RIP, ignoring faults, takes {}{unsafe_until}", seconds(plan.time))
    });
    let of_all: Vec<_> = plans.iter().copied().filter(|(_, plan)| covered(model, comparison, plan) == n).collect();
    let all = if n == 1 { "the mode".to_string() } else { format!("all {n} modes") };
    match (fastest(&of_all), rip) {
        (Some(_), Some((_, plan))) if covered(model, comparison, plan) == n => (
            Tone::Good,
            format!("Covering {all} costs nothing: RIP, ignoring faults, covers them in {}", seconds(plan.time)),
        ),
        (Some((name, time)), Some((_, plan))) => {
            let more = percent(time / plan.time - 1.0);
            let cost = match time > plan.time {
                true => format!("costs {more} more time: {} with {name}", seconds(time)),
                false => format!("costs no time: {} with {name}", seconds(time)),
            };
            (Tone::Good, format!("At the shortest times, covering {all} {cost}; {}", ignoring.unwrap_or_default()))
        }
        (Some((name, time)), None) => (Tone::Good, format!("Covering {all} takes {} with {name}", seconds(time))),
        (None, _) => {
            let best = plans.iter().max_by_key(|(_, plan)| covered(model, comparison, plan));
            let best = best.map_or(String::new(), |(run, plan)| {
                format!("{} covers {} in {}", name_of(run), covered(model, comparison, plan), seconds(plan.time))
            });
            (Tone::Bad, format!("No plan covers {all}: {best}"))
        }
    }
}

/// A title and a table of planners.
fn block(
    screen: &mut Screen,
    problem: Problem,
    comparison: &Comparison,
    title: &str,
    wanted: impl Fn(&PlannerRun) -> bool,
) {
    let runs: Vec<&PlannerRun> =
        comparison.runs.iter().filter(|run| wanted(run) && is_shown(comparison, run)).collect();
    if runs.is_empty() {
        return;
    }
    let model = problem.model();
    let n = comparison.modes.len();
    let rates = rates(model);
    let has_risk = rates.iter().any(Option::is_some);
    let mut headings = vec!["planner", "time"];
    headings.push(if model.vehicle.battery.is_some() { "energy, of battery" } else { "objective" });
    if n > 0 {
        headings.extend(["covers", "violation", "unsafe"]);
    }
    if has_risk {
        headings.push("risk");
    }
    let mut table = Table::new(&headings);
    for run in runs {
        let Some(plan) = run.outcome.plan() else {
            table.row(vec![name_of(run), run.outcome.verdict().word().into()]);
            continue;
        };
        let mut cells = vec![name_of(run), format!("{} s", significant(plan.time, DIGITS))];
        cells.push(match battery::record(model, &plan.trajectory) {
            Some(record) => record.cell(),
            None => significant(plan.least_objective, 3),
        });
        if n > 0 {
            cells.push(format!("{} of {n}", covered(model, comparison, plan)));
            let worst =
                violation(plan).map_or("-".into(), |worst| if worst > 1.0 { "> 100 %".into() } else { percent(worst) });
            let until =
                unsafe_for_any(model, plan).map_or("never".into(), |last| format!("until {}", instant(plan, last)));
            cells.extend([worst, until]);
        }
        cells.extend(rated_risk(&rates, &plan.committed).map(|risk| significant(risk, 3)));
        table.row(cells);
    }
    screen.gap();
    screen.paragraph(Tone::Strong, 2, 2, title);
    screen.table(&table);
}
