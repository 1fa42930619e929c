//! The short output of `mavc campaign`: who survives which faults, and whether the planners differ.

use super::campaign_text::{by_flight, hundred, lost_if, remarks};
use super::headline::headline_of;
use super::mode_names::within;
use super::planner_names::planners_in_full;
use super::screen::{Keep, Screen, Tone};
use super::simulation::manner;
use super::terminal::vehicle_line;
use crate::campaign::agreement::Agreement;
use crate::campaign::cases::{Shard, fault_time};
use crate::campaign::design::Design;
use crate::campaign::statistics::{Share, sign_test, wilson};
use crate::campaign::tally::{Group, Tally};
use crate::flight::equilibrium::outcomes;
use crate::flight::indistinguishable::listed;
use crate::model::PlannerKind;
use crate::number::{number, part_of_all, plural, significant};
use crate::text_table::Table;
use std::cmp::Reverse;

/// Most rows of modes.
const MOST_ROWS: usize = 5;
/// Most columns of the names of modes.
const NAMES: usize = 32;
/// A difference counts as significant below this probability.
const SIGNIFICANT: f64 = 0.05;

/// The output about the flights in `tally`, which are those of `shard`.
pub fn screen(design: &Design, shard: Shard, tally: &Tally) -> Screen {
    let (model, cases) = (design.model, design.cases);
    let mut screen = Screen::default();
    let mission = model.mission.as_ref().map_or("", |m| m.name.as_str());
    let part = match shard {
        Shard::WHOLE => String::new(),
        _ => format!(" (shard {}/{})", shard.index + 1, shard.of),
    };
    screen.paragraph(
        Tone::Plain,
        0,
        2,
        &format!(
            "Campaign on {mission} with {}: {}{part} of {} s",
            vehicle_line(model),
            plural(tally.flights(), "flight"),
            number(design.time)
        ),
    );
    screen.gap();
    let plans: Vec<Survival> = (0..design.plans.len()).map(|p| Survival::of(design, tally, p)).collect();
    let (tone, text) = answer(&plans);
    screen.paragraph(tone, 2, 2, &text);
    in_against(design, tally, &plans).iter().for_each(|text| screen.paragraph(Tone::Plain, 2, 2, text));
    missed(&plans).iter().for_each(|text| screen.paragraph(Tone::Plain, 2, 2, text));
    screen.paragraph(Tone::Plain, 2, 2, &headline_of(model, &outcomes(model)));
    screen.gap();
    screen.table(&planners(design, tally, &plans));
    let flown: Vec<PlannerKind> = design.plans.iter().map(|plan| plan.planner).collect();
    for text in [planners_in_full(&flown), manner(model), lost_if(&model.simulation)] {
        screen.part(Keep::Legend, None, |screen| screen.paragraph(Tone::Plain, 2, 2, &text));
    }
    if cases.modes > 0 {
        let (texts, note) = differences(design, tally, &plans);
        texts.iter().for_each(|text| screen.paragraph(Tone::Plain, 2, 2, text));
        note.iter().for_each(|text| {
            screen.part(Keep::Legend, None, |screen| screen.paragraph(Tone::Plain, 2, 2, text));
        });
        losers(&mut screen, design, tally, &plans);
        screen.paragraph(Tone::Plain, 2, 2, &by_flight(&Agreement::new(design, tally).all.total));
    }
    warnings(design, tally, &plans).iter().for_each(|text| screen.remark(Keep::Finding, text));
    screen.close();
    screen
}

/// The flights of one plan with a fault.
struct Survival {
    /// Its index.
    plan: usize,
    name: String,
    flights: usize,
    survived: usize,
    /// With an unknown end.
    diverged: usize,
    missed: usize,
    due: usize,
}

impl Survival {
    fn of(design: &Design, tally: &Tally, plan: usize) -> Self {
        let name = design.plans[plan].planner.name().to_uppercase();
        let mut sum = Survival { plan, name, flights: 0, survived: 0, diverged: 0, missed: 0, due: 0 };
        for group in (0..design.cases.modes).map(|m| tally.mode(plan, m)) {
            sum.flights += group.flights;
            sum.survived += group.survived();
            sum.diverged += group.diverged;
            sum.missed += group.path.missed;
            sum.due += group.path.due;
        }
        sum
    }

    fn lost(&self) -> usize {
        self.flights - self.survived - self.diverged
    }
}

/// `RIP loses 34 of 1296 flights with a fault, RSP 5, RCP none`
fn answer(plans: &[Survival]) -> (Tone, String) {
    if plans.iter().all(|plan| plan.flights == 0) {
        return (Tone::Warning, "No fault mode is declared: no flight had a fault".into());
    }
    let count = |n: usize| if n == 0 { "none".to_string() } else { n.to_string() };
    let all = plans.iter().map(|plan| plan.flights).max().unwrap_or(0);
    let parts: Vec<String> = plans
        .iter()
        .enumerate()
        .map(|(i, plan)| match i {
            0 => {
                format!("{} loses {} of {} with a fault", plan.name, count(plan.lost()), plural(plan.flights, "flight"))
            }
            _ if plan.flights == all => format!("{} {}", plan.name, count(plan.lost())),
            _ => format!("{} {} of {}", plan.name, count(plan.lost()), plan.flights),
        })
        .collect();
    let tone = if plans.iter().all(|plan| plan.lost() == 0) { Tone::Good } else { Tone::Warning };
    (tone, parts.join(", "))
}

/// `after faults in `against`: RIP none of 20, RSP none of 20`, if flights were lost and other modes struck too.
fn in_against(design: &Design, tally: &Tally, plans: &[Survival]) -> Option<String> {
    let against = &design.model.plan.against;
    let is_planned = |mode: &usize| against.contains(mode);
    let struck = 0..design.cases.modes;
    if against.is_empty() || struck.clone().all(|mode| is_planned(&mode)) || plans.iter().all(|plan| plan.lost() == 0) {
        return None;
    }
    let part = |plan: &Survival| {
        let groups: Vec<&Group> = struck.clone().filter(is_planned).map(|mode| tally.mode(plan.plan, mode)).collect();
        let flights: usize = groups.iter().map(|group| group.flights).sum();
        let lost: usize = groups.iter().map(|group| group.flights - group.survived() - group.diverged).sum();
        format!("{} {} of {flights}", plan.name, if lost == 0 { "none".into() } else { lost.to_string() })
    };
    let parts: Vec<String> = plans.iter().map(part).collect();
    Some(format!("Lost after the modes in `against` alone: {}", parts.join(", ")))
}

/// `Waypoints missed after a fault: RIP 279 of 624, RSP 56 of 624`, if some were.
fn missed(plans: &[Survival]) -> Option<String> {
    let some: Vec<&Survival> = plans.iter().filter(|plan| plan.due > 0).collect();
    let part = |plan: &&Survival| format!("{} {} of {}", plan.name, plan.missed, plan.due);
    let is_missed = some.iter().any(|plan| plan.missed > 0);
    is_missed
        .then(|| format!("Waypoints missed after a fault: {}", some.iter().map(part).collect::<Vec<_>>().join(", ")))
}

/// One row for each plan.
fn planners(design: &Design, tally: &Tally, plans: &[Survival]) -> Table {
    let has_alarms = plans.iter().any(|plan| remarks::estimator(design, tally, plan.plan).is_some());
    let mut headings = vec!["planner", "survived", "95 % interval"];
    if has_alarms {
        headings.push("false alarms/h");
    }
    headings.push("healthy lost");
    let mut table = Table::new(&headings);
    for plan in plans {
        let dash = || "-".to_string();
        let share = wilson(plan.survived, plan.flights).filter(|_| plan.diverged < plan.flights);
        let healthy = tally.healthy(plan.plan);
        let mut cells = vec![
            plan.name.clone(),
            share.map_or_else(dash, |s| format!("{} %", part_of_all(s.share))),
            share.map_or_else(dash, |Share { low, high, .. }| format!("{} .. {}", hundred(low), hundred(high))),
        ];
        if has_alarms {
            cells.push(healthy.alarms_per_hour().map_or_else(dash, |per_hour| significant(per_hour, 3)));
        }
        cells.push(format!("{} of {}", healthy.all_lost(), healthy.flights));
        table.row(cells);
    }
    table
}

/// Whether the other plans lose more or fewer flights than that of the first: the sign test over pairs of mode and
/// instant, and what it assumes. Nothing if no flight was lost.
fn differences(design: &Design, tally: &Tally, plans: &[Survival]) -> (Vec<String>, Option<&'static str>) {
    let Some((first, others)) = plans.split_first() else { return (Vec::new(), None) };
    let share = |plan: usize, m: usize, t: usize| {
        let cell = &tally.cells(plan, m)[t];
        (cell.struck > 0).then(|| cell.lost as f64 / cell.struck as f64)
    };
    let pairs = || (0..design.cases.modes).flat_map(|m| (0..design.cases.times).map(move |t| (m, t)));
    // Planners with the same result share a sentence.
    let mut found: Vec<((usize, usize), Vec<&str>)> = Vec::new();
    for other in others {
        let both = pairs().filter_map(|(m, t)| Some((share(first.plan, m, t)?, share(other.plan, m, t)?)));
        let (mut fewer, mut more) = (0, 0);
        for (of_first, of_other) in both {
            fewer += usize::from(of_other < of_first);
            more += usize::from(of_other > of_first);
        }
        match found.iter_mut().find(|(counts, _)| *counts == (fewer, more)) {
            Some((_, names)) => names.push(&other.name),
            None => found.push(((fewer, more), vec![&other.name])),
        }
    }
    let sentence = |((fewer, more), names): &((usize, usize), Vec<&str>)| {
        let p = sign_test(*fewer, *more);
        let word = if p < SIGNIFICANT { "significant" } else { "not significant" };
        let p = if p < 1e-4 { "p < 0.0001".to_string() } else { format!("p = {}", significant(p, 2)) };
        let (others, first) = (listed(names), &first.name);
        let [loses, each] = if names.len() > 1 { ["lose", " each"] } else { ["loses", ""] };
        match fewer + more {
            0 => format!("{others}{each} {loses} as many flights as {first} at every instant of every mode"),
            _ => format!(
                "{others}{each} {loses} fewer flights than {first} at {fewer} pairs of mode and instant, more at \
                 {more}: {word} (sign test, {p})"
            ),
        }
    };
    if pairs().all(|(m, t)| plans.iter().all(|plan| share(plan.plan, m, t).is_none_or(|s| s == 0.0))) {
        return (Vec::new(), None);
    }
    let note = "the exact, two-sided sign test takes the instants as independent of each other";
    (found.iter().map(sentence).collect(), (!found.is_empty()).then_some(note))
}

/// The modes that lost flights with the most losses, modes with the same numbers together.
fn losers(screen: &mut Screen, design: &Design, tally: &Tally, plans: &[Survival]) {
    let all: Vec<String> = design.model.modes.iter().map(|mode| mode.name.clone()).collect();
    let lost = |group: &Group| group.flights - group.survived() - group.diverged;
    let mut rows: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
    for m in 0..design.cases.modes {
        let counts: Vec<usize> = plans.iter().map(|plan| lost(tally.mode(plan.plan, m))).collect();
        if counts.iter().all(|count| *count == 0) {
            continue;
        }
        match rows.iter_mut().find(|(of, _)| *of == counts) {
            Some((_, modes)) => modes.push(m),
            None => rows.push((counts, vec![m])),
        }
    }
    screen.gap();
    if rows.is_empty() {
        screen.line(Tone::Good, "  No mode lost a flight.");
        return;
    }
    rows.sort_by_key(|(counts, _)| Reverse(counts.iter().sum::<usize>()));
    let hidden = rows.split_off(rows.len().min(MOST_ROWS));
    let mut headings = vec!["lost after"];
    headings.extend(plans.iter().map(|plan| plan.name.as_str()));
    headings.extend(["flights each", "fault at"]);
    screen.fitted(NAMES, |names| {
        let mut table = Table::new(&headings);
        for (counts, modes) in &rows {
            let each = plans.first().map_or(0, |plan| tally.mode(plan.plan, modes[0]).flights);
            let mut cells = vec![within(&all, modes, names)];
            cells.extend(counts.iter().map(usize::to_string));
            cells.extend([each.to_string(), when_lost(design, tally, plans, modes)]);
            table.row(cells);
        }
        table
    });
    let more: usize = hidden.iter().map(|(_, modes)| modes.len()).sum();
    if more > 0 {
        screen.line(Tone::Plain, &format!("  and {} with fewer losses, -v", plural(more, "mode")));
    }
}

/// The instants of the faults of these modes that lost flights: `0.5 s`, or `0.5 to 5.85 s` from the first to the last.
fn when_lost(design: &Design, tally: &Tally, plans: &[Survival], modes: &[usize]) -> String {
    let is_lost =
        |t: usize| plans.iter().any(|plan| modes.iter().any(|&mode| tally.cells(plan.plan, mode)[t].lost > 0));
    let mut lost =
        (0..design.cases.times).filter(|&t| is_lost(t)).map(|t| fault_time(design.time, design.cases.times, t));
    let Some(first) = lost.next() else { return "-".into() };
    match lost.next_back() {
        Some(last) => format!("{} to {} s", number(first), number(last)),
        None => format!("{} s", number(first)),
    }
}

/// What a reader must not overlook; a warning about several plans is printed once.
fn warnings(design: &Design, tally: &Tally, plans: &[Survival]) -> Vec<String> {
    let mut all: Vec<String> = remarks::beyond_the_limit(design).into_iter().collect();
    let mut of_plans: Vec<(String, Vec<&str>)> = Vec::new();
    for plan in plans {
        let p = plan.plan;
        let of_plan = [
            remarks::lost_healthy(tally, p),
            remarks::lost_before(design, tally, p),
            remarks::diverged(design, tally, p),
            remarks::uncovered(design, tally, p),
        ];
        for text in of_plan.into_iter().flatten() {
            let text = text.trim_start_matches("Warning: ").to_string();
            match of_plans.iter_mut().find(|(same, _)| *same == text) {
                Some((_, names)) => names.push(&plan.name),
                None => of_plans.push((text, vec![&plan.name])),
            }
        }
    }
    all.extend(of_plans.iter().map(|(text, names)| format!("{}: {text}", names.join(", "))));
    for missing in &design.missing {
        all.push(format!("{} is not flown: {}", missing.planner.name().to_uppercase(), missing.verdict()));
    }
    all
}
