//! A campaign: what the faults do to the path, by mode, and by mode and instant of the fault.

use super::prose::true_minus;
use super::survival::{CLASSES, class_of, harmful, harmless, lost_nothing, map};
use super::table::{Frame, counts, numbers, table, words};
use crate::flight::damage::HEADING_BROKEN;
use crate::number::{number, part_of_all, significant};
use crate::report::campaign_record::{CampaignRecord, CellRecord, ModeRecord, PathRecord, PlannerRecord};
use maud::{Markup, html};

/// Most modes of one table.
const MOST_MODES: usize = 60;

/// The path after the fault, for each planner, folded; modes with which no planner lost a flight apart.
pub fn tables(record: &CampaignRecord) -> Markup {
    let flown = || record.planners.iter().filter(|p| !p.modes.is_empty());
    let (harmful, unharmed) = (harmful(record), harmless(record));
    html! {
        h2 { "The path after the fault" }
        p.note {
            "Over all struck flights, lost ones included. Deviation: largest distance from the reference since the \
             fault, mean and largest. A limit is broken if it is exceeded by more than the tolerance of campaigns, the \
             heading if it is more than "
            (number(HEADING_BROKEN.to_degrees())) " deg off before yaw is given up."
        }
        details {
            summary { "Each planner, with the modes that lost a flight" }
            @for planner in flown() { (harm(planner, true, |mode| harmful.contains(mode.name.as_str()))) }
        }
        @if unharmed > 0 {
            details {
                summary { (lost_nothing(unharmed)) }
                @for planner in flown() { (harm(planner, false, |mode| !harmful.contains(mode.name.as_str()))) }
            }
        }
        details {
            summary { "Maps of the deviation" }
            p.note { "Mean deviation in m; colour: share of the due waypoints missed; columns: instant of the fault in \
                s." }
            div.legend {
                @for (k, (name, _)) in CLASSES.iter().enumerate() {
                    span.entry { span.swatch.{ "lost" (k) } aria-hidden="true" { } (name) }
                }
            }
            div.maps {
                @for planner in flown() {
                    div { (map(planner, &worst(planner, |_| true).0, "deviations", None, cell)) }
                }
            }
        }
    }
}

/// The modes shown that suffer most, in their order, and how many are left out.
fn worst(planner: &PlannerRecord, is_shown: impl Fn(&ModeRecord) -> bool) -> (Vec<&ModeRecord>, usize) {
    let mut modes: Vec<&ModeRecord> = planner.modes.iter().filter(|mode| is_shown(mode)).collect();
    let all = modes.len();
    if modes.len() > MOST_MODES {
        let mean = |m: &ModeRecord| m.flights.path.deviation_m.map_or(0.0, |s| s.mean);
        modes.sort_by(|a, b| mean(b).total_cmp(&mean(a)));
        modes.truncate(MOST_MODES);
    }
    let left_out = all - modes.len();
    (modes, left_out)
}

fn harm(planner: &PlannerRecord, with_healthy: bool, is_shown: impl Fn(&ModeRecord) -> bool) -> Markup {
    let name = planner.name.to_uppercase();
    let (modes, left_out) = worst(planner, is_shown);
    let heads = [
        words("Mode"),
        words("Hover"),
        counts("Flights"),
        numbers("Deviation", "m, mean"),
        numbers("Largest", "m"),
        numbers("Below reference", "m, largest"),
        counts("Waypoints missed"),
        counts("Heading broken"),
        words("Limits broken"),
    ];
    let rows = html! {
        @if let Some(healthy) = planner.healthy.as_ref().filter(|_| with_healthy) { (row("healthy", "", &healthy.path)) }
        @for mode in &modes { (row(&mode.name, &mode.hover_words, &mode.flights.path)) }
    };
    html! {
        h3 { (name) }
        (table(Frame { label: &format!("Path after the fault, {name}"), ..Frame::default() }, &heads, rows))
        @if left_out > 0 { p.note { (left_out) " modes with less deviation are omitted." } }
    }
}

fn row(name: &str, hover: &str, path: &PathRecord) -> Markup {
    let metres = |value: Option<f64>| value.map_or("\u{2013}".into(), |m| true_minus(&significant(m, 3)));
    let limits: Vec<String> = path.limits.iter().map(|l| format!("{} {}", l.flights, l.limit)).collect();
    html! {
        tr {
            th scope="row" { (name) }
            td { (hover) }
            td.n { (path.flights) }
            td.n { (metres(path.deviation_m.map(|s| s.mean))) }
            td.n { (metres(path.deviation_m.map(|s| s.max))) }
            td.n { (metres(path.drop_m.map(|s| s.max))) }
            td.n { (path.waypoints_missed) " of " (path.waypoints_due) }
            td.n { (path.heading_broken) }
            td { @if limits.is_empty() { "\u{2013}" } @else { (limits.join(", ")) } }
        }
    }
}

/// The mean deviation of the struck flights of a cell, m, coloured by the share of the due waypoints missed.
fn cell(cells: &[CellRecord]) -> Markup {
    let sum = |of: fn(&CellRecord) -> usize| cells.iter().map(of).sum::<usize>();
    let struck = sum(|c| c.struck);
    if struck == 0 {
        return html! { td { } };
    }
    let deviation: f64 = cells.iter().filter_map(|c| Some(c.mean_deviation_m? * c.struck as f64)).sum();
    let text = significant(deviation / struck as f64, 2);
    let (missed, due) = (sum(|c| c.waypoints_missed), sum(|c| c.waypoints_due));
    if due == 0 {
        return html! { td { (text) } };
    }
    let title = format!("{missed} of {due} waypoints missed ({} %)", part_of_all(missed as f64 / due as f64));
    html! { td.{ "lost" (class_of(missed as f64 / due as f64)) } title=(title) { (text) } }
}
