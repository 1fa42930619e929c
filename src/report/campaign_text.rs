//! Terminal report of a campaign.

use super::table::Table;
use super::terminal::vehicle_line;
use crate::campaign::HEALTHY;
use crate::campaign::agreement::{Agreement, Scope, Strength};
use crate::campaign::cases::Shard;
use crate::campaign::design::{Design, Missing, Plan};
use crate::campaign::run::AFTERMATH;
use crate::campaign::statistics::{Contingency, Share, wilson};
use crate::campaign::tally::{Cell, Group, Tally};
use crate::flight::Cause;
use crate::model::{Detection, Simulation};
use crate::number::{fixed, number, part_of_all, percent, significant};
use crate::planner::studies::{NotFound, PlanOutcome, Proof};
use std::cmp::Reverse;

/// Columns of running text.
const WIDTH: usize = 110;
/// Columns of a map.
const MAP: usize = 80;

/// Most modes that are listed one by one.
const SHOWN: usize = 40;

/// The whole report of the flights in `tally`, which are those of `shard`.
pub fn campaign(design: &Design, shard: Shard, tally: &Tally) -> String {
    let mut out = head(design, shard, tally);
    for (p, plan) in design.plans.iter().enumerate() {
        out.push_str(&format!("\n{}\n", planned(design, tally, p, plan)));
    }
    out.push_str(&left_out(&design.missing));
    out.push_str(&agreement(&Agreement::new(design, tally)));
    out
}

fn head(design: &Design, shard: Shard, tally: &Tally) -> String {
    let (model, cases) = (design.model, design.cases);
    let mission = model.mission.as_ref().map_or("", |m| m.name.as_str());
    let mut out = format!("Campaign on mission {mission} with {}\n", vehicle_line(model));
    let names: Vec<String> = design.plans.iter().map(|p| p.planner.name().to_uppercase()).collect();
    out.push_str(&format!(
        "{} in {} s, per plan: {} x {} x {} with a fault, and {} without\n",
        names.join(", "),
        number(design.time),
        counted(cases.modes, "mode"),
        counted(cases.times, "instant"),
        counted(cases.seeds, "seed"),
        counted(cases.seeds, "flight"),
    ));
    let part = match shard {
        Shard::WHOLE => String::new(),
        _ => format!("; shard {}/{} has {}", shard.index + 1, shard.of, tally.flights()),
    };
    out.push_str(&format!("campaign {}: {}{part}\n", design.id, counted(cases.count(), "flight")));
    out + &flown_how(design)
}

/// Controller, allocation, detection, reaction to a fault, and when a vehicle counts as lost.
fn flown_how(design: &Design) -> String {
    let model = design.model;
    let s = &model.simulation;
    let detection = match s.detection {
        Detection::Never => "no fault is detected".to_string(),
        Detection::After(delay) => format!("the fault is known after {} s", number(delay)),
        Detection::Estimator => format!("faults are estimated at {} Hz", number(s.estimator_rate)),
    };
    format!(
        "controller {}, allocation {}; {detection}; after_fault = {}\n\
         lost: {} m off the plan, tilted past 90 degrees for {} s or at the end, {}or on the ground; {}\n",
        s.controller.name(),
        model.vehicle.allocation.name(),
        s.after_fault.name(),
        number(s.lost_beyond),
        number(s.upside_down),
        off_heading(s),
        aftermath(design)
    )
}

/// How long a flight continues after its fault.
fn aftermath(design: &Design) -> String {
    let least = number(AFTERMATH);
    match design.plans.iter().all(|plan| plan.trajectory.ends_at_rest()) {
        true => format!("{least} s are flown after a fault"),
        false => format!("{least} s are flown after a fault, or the rest of a mission that ends in motion"),
    }
}

/// `heading 90 degrees off for 1 s or at the end, `, if the spec sets such a limit.
fn off_heading(s: &Simulation) -> String {
    s.lost_yaw.map_or(String::new(), |limit| {
        format!("heading {} degrees off for {} s or at the end, ", number(limit.to_degrees()), number(s.lost_yaw_after))
    })
}

fn counted(n: usize, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}

/// One planner: its flights by mode, and the map.
fn planned(design: &Design, tally: &Tally, p: usize, plan: &Plan) -> String {
    let against = match plan.against.as_slice() {
        [] => "no mode".to_string(),
        modes if modes.len() > 8 => format!("{} modes", modes.len()),
        modes => modes.join(", "),
    };
    let mut out = format!("{}, planned against {against}\n", plan.planner.name().to_uppercase());
    let (modes, all) = (worst(tally, p, design.cases.modes), design.cases.modes);
    if modes.len() < all {
        out.push_str(&format!("  the {SHOWN} of {all} modes with the most losses; `--report` lists all\n"));
    }
    let mut table = Table::new(&[
        "mode",
        "flights",
        "survived",
        "95 % CI",
        "RMSE",
        "max error",
        "heading",
        "detected",
        "violated",
        "last violation",
        "lost to",
    ]);
    let healthy = tally.healthy(p);
    let mut cells = group_cells(HEALTHY, healthy);
    cells.extend([String::new(), String::new(), causes(healthy)]);
    table.row(cells);
    for &m in &modes {
        let outside = &plan.outside[m];
        let mut cells = group_cells(&design.model.modes[m].name, tally.mode(p, m));
        cells.push(percent(outside.seconds / design.time));
        cells.push(outside.last.map_or("never".into(), |last| percent(last / design.time)));
        cells.push(causes(tally.mode(p, m)));
        table.row(cells);
    }
    out.push_str(&table.render(2));
    out.push_str(
        "  errors and headings are those of the flights that survived; violations are the plan's, in % of its time\n",
    );
    if let lost @ 1.. = healthy.all_lost() {
        let text = format!(
            "Warning: {lost} of {} without a fault {} lost. The vehicle cannot fly this plan, so its losses say little \
             about faults: limit the tilt, or give the mission more time.",
            counted(healthy.flights, "flight"),
            if lost == 1 { "was" } else { "were" }
        );
        out.push_str(&filled(&text));
    }
    let before: usize = (0..all).map(|m| tally.mode(p, m).lost_before).sum();
    if before > 0 {
        let were = if before == 1 { "was" } else { "were" };
        out.push_str(&filled(&format!("{} {were} lost before the fault could strike.", counted(before, "flight"))));
    }
    let diverged = healthy.diverged + (0..all).map(|m| tally.mode(p, m).diverged).sum::<usize>();
    if diverged > 0 {
        let flights = counted(diverged, "flight");
        out.push_str(&filled(&format!(
            "{flights} diverged: the integration broke down (NaN, infinity, or more than half a turn in one step). What \
             happened to the vehicle is unknown: such a flight counts as a flight, but neither as lost nor as survived."
        )));
    }
    if !modes.is_empty() {
        out.push_str(&map(design, tally, p, &modes));
    }
    out.pop();
    out
}

/// All modes as declared or, if there are many, those with the most losses.
fn worst(tally: &Tally, p: usize, modes: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..modes).collect();
    if modes > SHOWN {
        order.sort_by_key(|&m| Reverse(tally.mode(p, m).all_lost()));
        order.truncate(SHOWN);
        order.sort_unstable();
    }
    order
}

/// Name, flights, survival, errors of the flights that survived, and how soon the fault was detected.
fn group_cells(name: &str, group: &Group) -> Vec<String> {
    // No share is printed if every outcome is unknown.
    let survival = wilson(group.survived(), group.flights).filter(|_| group.diverged < group.flights);
    let (rms, max) = (group.rms_error.summary(), group.max_error.summary());
    let heading = group.max_heading_error.summary();
    let detected = group.detected_after.summary().map(|d| {
        let all = d.count == group.struck();
        format!("{} s{}", fixed(d.mean, 2), if all { String::new() } else { format!(" ({})", d.count) })
    });
    let dash = || "-".to_string();
    vec![
        name.into(),
        group.flights.to_string(),
        survival.map_or_else(dash, |s| format!("{} %", part_of_all(s.share))),
        survival.map_or_else(dash, |Share { low, high, .. }| format!("{} .. {}", hundred(low), hundred(high))),
        rms.map_or_else(dash, |s| format!("{} m", significant(s.mean, 3))),
        max.map_or_else(dash, |s| format!("{} m", significant(s.max, 3))),
        heading.map_or_else(dash, |s| format!("{} deg", fixed(s.max.to_degrees(), 1))),
        detected.unwrap_or_else(dash),
    ]
}

/// `12 ground, 3 heading`: causes of loss, the most frequent first.
fn causes(group: &Group) -> String {
    let mut counts: Vec<(&str, usize)> = Cause::ALL.iter().zip(group.lost).map(|(c, n)| (cause(*c), n)).collect();
    counts.push(("diverged", group.diverged));
    counts.retain(|(_, n)| *n > 0);
    counts.sort_by_key(|(_, n)| Reverse(*n));
    let words: Vec<String> = counts.into_iter().map(|(name, n)| format!("{n} {name}")).collect();
    if words.is_empty() { "-".into() } else { words.join(", ") }
}

/// A cause as the table names it.
fn cause(cause: Cause) -> &'static str {
    match cause {
        Cause::Position => "position",
        Cause::UpsideDown => "upside down",
        Cause::Ground => "ground",
        Cause::Heading => "heading",
    }
}

fn hundred(share: f64) -> String {
    // One decimal, but 100 only for the whole.
    if share < 1.0 && share > 0.99949 { part_of_all(share) } else { fixed(100.0 * share, 1) }
}

/// A map of the share of struck flights that were lost: one line per mode, one column per instant.
fn map(design: &Design, tally: &Tally, p: usize, modes: &[usize]) -> String {
    let times = design.cases.times;
    let columns = times.min(MAP);
    let name = |m: usize| design.model.modes[m].name.as_str();
    let width = modes.iter().map(|&m| name(m).chars().count()).max().unwrap_or(0);
    let mut out = String::from("\n  Share lost, by the instant of the fault: . none, 1 to 9 tenths, # all");
    let any = |of: fn(&Cell) -> bool| modes.iter().any(|&m| tally.cells(p, m).iter().any(of));
    if any(|c| c.flights > 0 && c.struck == 0 && c.diverged == 0) {
        out.push_str(", x lost before it");
    }
    if any(|c| c.diverged > 0) {
        out.push_str(", ? diverged");
    }
    out.push('\n');
    for &m in modes {
        let cells = tally.cells(p, m);
        let line = (0..columns).map(|c| mark(&cells[c * times / columns..(c + 1) * times / columns]));
        out.push_str(&format!("  {:width$}  {}\n", name(m), line.collect::<String>()));
    }
    let end = format!("{} s", number(design.time));
    let gap = columns.saturating_sub(3).max(end.len() + 2);
    out + &format!("  {:width$}  0 s{end:>gap$}\n", "")
}

/// The character of a column, which may cover several cells.
fn mark(cells: &[Cell]) -> char {
    let sum = |of: fn(&Cell) -> usize| cells.iter().map(of).sum::<usize>();
    match (sum(|c| c.flights), sum(|c| c.struck), sum(|c| c.lost)) {
        (0, ..) => ' ',
        _ if sum(|c| c.diverged) > 0 => '?',
        (_, 0, _) => 'x',
        (_, _, 0) => '.',
        (_, struck, lost) if lost == struck => '#',
        // Some are lost and some are not: neither 0 nor 10.
        (_, struck, lost) => {
            char::from_digit(((10 * lost + struck / 2) / struck).clamp(1, 9) as u32, 10).unwrap_or('9')
        }
    }
}

/// The planners without a plan, with the reasons.
pub fn left_out(missing: &[Missing]) -> String {
    let mut out = String::new();
    for one @ Missing { planner, outcome } in missing {
        let why = match outcome {
            Some(PlanOutcome::Infeasible(Proof { at, .. }) | PlanOutcome::NotFound(NotFound::Search { at, .. })) => {
                format!("a plan of {} s with these samples", number(*at))
            }
            Some(PlanOutcome::NotAttempted { why, .. }) => why.clone(),
            _ => "there is no mode to plan against, or no common time".into(),
        };
        let verdict = one.verdict();
        out.push_str(&format!("\n{} is not flown; {verdict}: {why}\n", planner.name().to_uppercase()));
    }
    out
}

fn agreement(agreement: &Agreement) -> String {
    let mut out = String::from("\nDo the plans predict which flights are lost?\n");
    out.push_str(&filled(
        "Predicted lost: the fault strikes before the plan's last violation of the mode's set. Only flights that were \
         still flying when the fault struck are counted. A plan that several planners share is counted once.",
    ));
    let Agreement { all, inside } = agreement;
    if inside.modes == all.modes {
        out.push_str(&scope(all));
    } else if inside.modes == 0 {
        out.push_str(&scope(all));
        out.push_str(&filled("No mode has hover inside its set, so no plan can keep a reserve against any mode."));
    } else {
        out.push_str(&format!("\n  All {}\n{}", counted(all.modes, "mode"), scope(all)));
        let n = counted(inside.modes, "mode");
        out.push_str(&format!(
            "\n  Only the {n} with hover inside their sets: no plan can keep a reserve against the others\n"
        ));
        out.push_str(&scope(inside));
    }
    out.push('\n');
    out.push_str(&filled(
        "Intervals treat flights as independent. Flights struck at the same instant differ only in their noise, so \
         the true uncertainty is larger; more instants help more than more seeds.",
    ));
    out
}

/// The contingency table and its interpretation.
fn scope(scope: &Scope) -> String {
    let headings =
        ["planner", "hits", "misses", "false alarms", "correct negatives", "lost", "lost if predicted", "phi"];
    let mut table = Table::new(&headings);
    let mut row = |name: String, t: &Contingency| {
        let share =
            |a: usize, b: usize| if b == 0 { "-".into() } else { format!("{} %", part_of_all(a as f64 / b as f64)) };
        let mut cells = vec![name];
        cells.extend([t.hits, t.misses, t.false_alarms, t.correct_negatives].map(|n| n.to_string()));
        cells.push(share(t.hits + t.misses, t.total()));
        cells.push(share(t.hits, t.hits + t.false_alarms));
        cells.push(t.phi().map_or("undefined".into(), |phi| fixed(phi, 2)));
        table.row(cells);
    };
    scope.planners.iter().for_each(|(planner, t)| row(planner.name().to_uppercase(), t));
    row("all".into(), &scope.total);
    let safe = scope.planners.iter().filter(|(_, t)| t.hits + t.false_alarms == 0 && t.misses > 0);
    let called_safe: String = safe
        .map(|(planner, t)| {
            let (name, all) = (planner.name().to_uppercase(), counted(t.total(), "struck flight"));
            filled(&format!("{name} predicts no loss, yet {} of {all} were lost.", t.misses))
        })
        .collect();
    table.render(2) + &filled(&by_flight(&scope.total)) + &called_safe + &filled(&by_mode(scope))
}

/// The interpretation of phi.
pub fn by_flight(t: &Contingency) -> String {
    let lost = t.hits + t.misses;
    match (Strength::of(t.phi()), t.phi()) {
        (Strength::Undefined, _) if t.total() == 0 => {
            "No flight with a known outcome was struck by its fault: the prediction cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == 0 => {
            "No flight was lost to a fault: the prediction cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == t.total() => {
            "Every struck flight was lost: the prediction cannot be judged.".into()
        }
        (strength, phi) => {
            let phi = phi.map_or(String::new(), |phi| format!(" (phi {})", fixed(phi, 2)));
            let what = match strength {
                Strength::Undefined => {
                    "is the same for every flight, so it carries no information: no better than chance"
                }
                Strength::Opposite => "is worse than chance: flights predicted safe are lost more often",
                Strength::Chance => "is no better than chance",
                Strength::Weak => "agrees weakly with the outcomes",
                Strength::Moderate => "agrees moderately with the outcomes",
                Strength::Strong => "agrees strongly with the outcomes",
            };
            format!("Flight by flight, the prediction {what}{phi}.")
        }
    }
}

/// The interpretation of the rank correlation.
fn by_mode(scope: &Scope) -> String {
    let rho = scope.rank_correlation;
    let what = match Strength::of(rho) {
        Strength::Undefined => {
            return "Violation durations cannot be ranked against losses: one of the two never varies.".into();
        }
        Strength::Opposite => "longer violations go with fewer losses",
        Strength::Chance => "the duration of violations predicts losses no better than chance",
        Strength::Weak => "longer violations correlate weakly with more losses",
        Strength::Moderate => "longer violations correlate moderately with more losses",
        Strength::Strong => "longer violations correlate strongly with more losses",
    };
    let rho = rho.map_or(String::new(), |rho| fixed(rho, 2));
    format!("Over {} of plan and mode, {what} (Spearman's rank correlation {rho}).", counted(scope.pairs, "pair"))
}

fn filled(text: &str) -> String {
    let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
    textwrap::fill(text, options) + "\n"
}
