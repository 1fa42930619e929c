//! Terminal report of a campaign.

mod agreement;
mod path;
pub(super) mod remarks;

pub use agreement::by_flight;

use super::simulation::disturbed;
use super::terminal::vehicle_line;
use crate::campaign::HEALTHY;
use crate::campaign::agreement::Agreement;
use crate::campaign::cases::Shard;
use crate::campaign::design::{CampaignPlan, Design, Missing};
use crate::campaign::run::AFTERMATH;
use crate::campaign::statistics::{Share, wilson};
use crate::campaign::tally::{Group, Tally};
use crate::flight::Cause;
use crate::model::{Detection, LostYaw, Simulation};
use crate::number::{fixed, number, part_of_all, percent, plural, significant};
use crate::planner::studies::{NotFound, PlanOutcome, Proof};
use crate::text_table::{Table, indented};
use std::cmp::Reverse;

/// Most modes that are listed one by one.
const SHOWN: usize = 40;

/// The whole report of the flights in `tally`, which are those of `shard`.
pub fn campaign(design: &Design, shard: Shard, tally: &Tally) -> String {
    let mut out = head(design, shard, tally);
    for (p, plan) in design.plans.iter().enumerate() {
        out.push_str(&format!("\n{}\n", planned(design, tally, p, plan)));
    }
    out.push_str(&left_out(&design.missing));
    out.push_str(&agreement::agreement(&Agreement::new(design, tally)));
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
        plural(cases.modes, "mode"),
        plural(cases.times, "instant"),
        plural(cases.seeds, "seed"),
        plural(cases.seeds, "flight"),
    ));
    let part = match shard {
        Shard::WHOLE => String::new(),
        _ => format!("; shard {}/{} has {}", shard.index + 1, shard.of, tally.flights()),
    };
    out.push_str(&format!("campaign {}: {}{part}\n", design.id, plural(cases.count(), "flight")));
    out + &flown_how(design) + &paragraph(remarks::beyond_the_limit(design))
}

/// Controller, allocation, detection, reaction to a fault, and when a vehicle counts as lost.
pub(super) fn flown_how(design: &Design) -> String {
    let model = design.model;
    let s = &model.simulation;
    let detection = match s.detection {
        Detection::Never => "no fault is detected".to_string(),
        Detection::After(delay) => format!("the fault is known after {} s", number(delay)),
        Detection::Estimator => format!("faults are estimated at {} Hz", number(s.estimator_rate)),
    };
    format!(
        "controller {}, allocation {}; {detection}; after_fault = {}{}\n\
         {}; {}\n",
        s.controller.name(),
        model.vehicle.allocation.name(),
        s.after_fault.name(),
        disturbed(s),
        lost_if(s),
        aftermath(design)
    )
}

/// `lost: 5 m off the plan, tilted past 90 degrees for 1 s or at the end, or on the ground`
pub(super) fn lost_if(s: &Simulation) -> String {
    let [beyond, upside_down] = [s.lost_beyond, s.upside_down].map(number);
    let heading = off_heading(s);
    format!(
        "lost: {beyond} m off the plan, tilted past 90 degrees for {upside_down} s or at the end, {heading}or on the \
         ground"
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
    let LostYaw::Beyond(limit) = s.lost_yaw else { return String::new() };
    format!("heading {} degrees off for {} s or at the end, ", number(limit.to_degrees()), number(s.lost_yaw_after))
}

/// One planner: its flights by mode.
fn planned(design: &Design, tally: &Tally, p: usize, plan: &CampaignPlan) -> String {
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
        "  errors and headings are those of the flights that survived, since the fault; violations are the plan's, in \
         % of its time\n",
    );
    out.push_str(&paragraph(remarks::estimator(design, tally, p)));
    out.push_str(&paragraph(remarks::uncovered(design, tally, p)));
    out.push_str(&path::table(design, tally, p, &modes));
    for remark in
        [remarks::lost_healthy(tally, p), remarks::lost_before(design, tally, p), remarks::diverged(design, tally, p)]
    {
        out.push_str(&paragraph(remark));
    }
    out.pop();
    out
}

fn paragraph(remark: Option<String>) -> String {
    remark.map_or(String::new(), |text| indented(&text))
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
    let (rms, max) = (group.rms_error.summary(), group.max_error_after.summary());
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
pub(super) fn causes(group: &Group) -> String {
    let mut counts: Vec<(&str, usize)> = Cause::ALL.iter().zip(group.lost).map(|(c, n)| (cause(*c), n)).collect();
    counts.push(("in a keep_out or outside a keep_in", group.trespassed));
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

pub(super) fn hundred(share: f64) -> String {
    // One decimal, but 100 only for the whole.
    if share < 1.0 && share > 0.99949 { part_of_all(share) } else { fixed(100.0 * share, 1) }
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
