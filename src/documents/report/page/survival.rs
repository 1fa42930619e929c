//! A campaign: survival, the map over instants of the fault, and whether the plans predicted the losses.

use super::prose::true_minus;
use super::summary::{Figure, Found};
use super::table::{self, Frame, counts, numbers, words};
use crate::campaign::statistics::{Share, wilson};
use crate::number::{number, part_of_all, significant};
use crate::report::campaign_record::{AgreementRecord, CampaignRecord, CellRecord, ModeRecord, PlannerRecord};
use crate::report::campaign_text::by_flight;
use crate::report::simulation::detection;
use maud::{Markup, html};
use std::collections::BTreeSet;
use std::ops::Range;

/// Most modes of one map.
const MOST_MODES: usize = 60;
/// Most columns of one map.
const MOST_COLUMNS: usize = 24;

/// Classes of the share lost: name and largest share.
pub(super) const CLASSES: [(&str, f64); 5] =
    [("none", 0.0), ("up to 25 %", 0.25), ("up to 50 %", 0.5), ("over 50 %", 0.999_999), ("all", 1.0)];

/// The headline and figures of the campaign.
pub fn found(record: &CampaignRecord) -> Found {
    let shares: Vec<(String, f64)> =
        record.planners.iter().filter_map(|p| Some((p.name.to_uppercase(), survival(p)?.share))).collect();
    let list: Vec<String> =
        shares.iter().map(|(name, share)| format!("{} % with {name}", part_of_all(*share))).collect();
    let headline = match list.is_empty() {
        true => no_fault_flown(record),
        false => format!("Flights that survive a fault: {}", list.join(", ")),
    };
    let figures = vec![
        Figure::new("Flights", record.flights.to_string(), format!("of {} in the campaign", record.cases)),
        Figure::new(
            "Fault instants",
            record.times.to_string(),
            match record.seeds {
                1 => "with one seed each".to_string(),
                n => format!("with {n} seeds each"),
            },
        ),
        Figure::new(
            "Mission time T_d",
            record.mission_time_s.map_or("none".into(), |t| format!("{} s", number(t))),
            "the same for all planners",
        ),
    ];
    Found { headline, figures, ..Found::default() }
}

/// Why there is no result about faults.
fn no_fault_flown(record: &CampaignRecord) -> String {
    match (record.flights, record.planners.iter().any(|p| p.healthy.is_some())) {
        (0, false) => "Nothing was simulated: no planner found a plan".into(),
        (0, true) => "Nothing was simulated: this part of the campaign has no flights".into(),
        (_, _) => "No flight with a fault is among those simulated".into(),
    }
}

/// Share of flights with a fault that survive.
fn survival(planner: &PlannerRecord) -> Option<Share> {
    let flights: usize = planner.modes.iter().map(|m| m.flights.flights).sum();
    let of = |m: &ModeRecord| m.flights.lost + m.flights.trespassed + m.flights.diverged;
    let not_survived: usize = planner.modes.iter().map(of).sum();
    wilson(flights.saturating_sub(not_survived), flights)
}

/// `85.7 (60.1 to 96)`, in percent.
fn with_interval(share: Option<Share>) -> String {
    let cell = |s: Share| format!("{} ({} to {})", part_of_all(s.share), part_of_all(s.low), part_of_all(s.high));
    share.map_or("\u{2013}".into(), cell)
}

/// Survival and losses, planner by planner.
pub fn table(record: &CampaignRecord) -> Markup {
    let lost = |p: &PlannerRecord, of: fn(&ModeRecord) -> usize| p.modes.iter().map(of).sum::<usize>();
    let diverged: usize = record.planners.iter().map(|p| lost(p, |m| m.flights.diverged)).sum();
    let mut heads = vec![
        words("Planner"),
        words("Plan"),
        counts("Flights with a fault"),
        numbers("Survived", "%, 95 % interval"),
        counts("Lost by position"),
        counts("Upside down"),
        counts("To the ground"),
        counts("By heading"),
    ];
    let trespassed: usize = record.planners.iter().map(|p| lost(p, |m| m.flights.trespassed)).sum();
    heads.extend((trespassed > 0).then(|| counts("Past a volume")));
    heads.extend((diverged > 0).then(|| counts("Diverged")));
    heads.push(numbers("Healthy survived", "%, 95 % interval"));
    let caption = html! {
        "Detection: " (detection(record.detection, record.detection_delay_s))
        "; after a fault: " (record.after_fault) "; controller: " (record.controller)
    };
    let rows = html! {
        @for p in &record.planners {
            tr {
                th scope="row" { (p.name.to_uppercase()) }
                td { (p.verdict) }
                td.n { (lost(p, |m| m.flights.flights)) }
                td.n { (with_interval(survival(p))) }
                td.n { (lost(p, |m| m.flights.lost_by_position)) }
                td.n { (lost(p, |m| m.flights.lost_upside_down)) }
                td.n { (lost(p, |m| m.flights.lost_to_ground)) }
                td.n { (lost(p, |m| m.flights.lost_by_heading)) }
                @if trespassed > 0 { td.n { (lost(p, |m| m.flights.trespassed)) } }
                @if diverged > 0 { td.n { (lost(p, |m| m.flights.diverged)) } }
                td.n { (with_interval(p.healthy.as_ref().and_then(|h| h.survival))) }
            }
        }
    };
    let frame = Frame { label: "Table of planners", caption: Some(caption), ..Frame::default() };
    html! {
        h2 { "Flights lost, planner by planner" }
        (table::table(frame, &heads, rows))
    }
}

/// Whether a flight with this mode was lost, or its fate is unknown.
fn has_losses(mode: &ModeRecord) -> bool {
    mode.flights.lost + mode.flights.trespassed + mode.flights.diverged > 0
}

/// The names of the modes with which some planner lost a flight.
pub(super) fn harmful(record: &CampaignRecord) -> BTreeSet<&str> {
    let modes = record.planners.iter().flat_map(|planner| &planner.modes);
    modes.filter(|mode| has_losses(mode)).map(|mode| mode.name.as_str()).collect()
}

/// The number of modes with which no planner lost a flight.
pub(super) fn harmless(record: &CampaignRecord) -> usize {
    let harmful = harmful(record);
    let all: BTreeSet<&str> = record.planners.iter().flat_map(|p| &p.modes).map(|mode| mode.name.as_str()).collect();
    all.len() - harmful.len()
}

/// The share of struck flights that were lost, by mode and instant of the fault. Modes with which no planner lost a
/// flight are folded.
pub fn maps(record: &CampaignRecord) -> Markup {
    let (harmful, unharmed) = (harmful(record), harmless(record));
    let flown = || record.planners.iter().filter(|p| !p.modes.is_empty());
    let of = |has_losses: bool| {
        let is_shown = |mode: &&ModeRecord| harmful.contains(mode.name.as_str()) == has_losses;
        html! { div.maps { @for planner in flown() { div { (losses(planner, is_shown)) } } } }
    };
    html! {
        h2 { "Share of flights lost, by the instant of the fault" }
        div.legend {
            @for (k, (name, _)) in CLASSES.iter().enumerate() {
                span.entry { span.swatch.{ "lost" (k) } aria-hidden="true" { } (name) }
            }
            span.entry { span.swatch.before aria-hidden="true" { } "lost before the fault" }
        }
        @if !harmful.is_empty() { (of(true)) }
        @if unharmed > 0 { details { summary { (lost_nothing(unharmed)) } (of(false)) } }
    }
}

/// `28 modes lost no flight with any planner`
pub(super) fn lost_nothing(modes: usize) -> String {
    match modes {
        1 => "1 mode lost no flight with any planner".into(),
        n => format!("{n} modes lost no flight with any planner"),
    }
}

/// The instants of each column of a map.
fn columns(times: usize) -> Vec<Range<usize>> {
    let columns = times.min(MOST_COLUMNS);
    (0..columns).map(|c| c * times / columns..(c + 1) * times / columns).collect()
}

/// The class of a share, an index into [`CLASSES`].
pub(super) fn class_of(share: f64) -> usize {
    CLASSES.iter().position(|(_, most)| share <= *most).unwrap_or(CLASSES.len() - 1)
}

fn losses(planner: &PlannerRecord, is_shown: impl Fn(&&ModeRecord) -> bool) -> Markup {
    let mut modes: Vec<&ModeRecord> = planner.modes.iter().filter(is_shown).collect();
    let all = modes.len();
    if modes.len() > MOST_MODES {
        modes.sort_by_key(|m| std::cmp::Reverse(m.flights.lost));
        modes.truncate(MOST_MODES);
    }
    html! {
        (map(planner, &modes, "survival", Some("Lost/struck flights; columns: instant of the fault in s"), cell))
        @if all > modes.len() {
            p.note { (all - modes.len()) " modes with fewer losses are omitted." }
        }
    }
}

/// A map of the flights of a planner: a row for each mode, and a column for the instants of the fault that it shows
/// together.
pub(super) fn map(
    planner: &PlannerRecord,
    modes: &[&ModeRecord],
    of: &str,
    caption: Option<&str>,
    cell: fn(&[CellRecord]) -> Markup,
) -> Markup {
    let times = planner.modes.first().map_or(&[][..], |m| &m.times);
    let parts = columns(times.len());
    let name = planner.name.to_uppercase();
    let instants = parts.iter().map(|part| counts(significant(times[part.start].fault_time_s, 3)));
    let heads: Vec<_> = [words("Mode")].into_iter().chain(instants).collect();
    let rows = html! {
        @for mode in modes {
            tr {
                th scope="row" { (mode.name) }
                @for part in &parts { (cell(&mode.times[part.clone()])) }
            }
        }
    };
    let caption = caption.map(|text| html! { (text) });
    let frame = Frame { label: &format!("Map of {of}, {name}"), class: Some("map"), caption, ..Frame::default() };
    html! {
        h3 { (name) }
        (table::table(frame, &heads, rows))
    }
}

fn cell(cells: &[CellRecord]) -> Markup {
    let sum = |of: fn(&CellRecord) -> usize| cells.iter().map(of).sum::<usize>();
    let (flights, struck, lost) = (sum(|c| c.flights), sum(|c| c.struck), sum(|c| c.lost));
    if flights == 0 {
        return html! { td { } };
    }
    if struck == 0 && sum(|c| c.diverged) > 0 {
        return html! { td { "diverged" } };
    }
    if struck == 0 {
        return html! { td.before { "before" } };
    }
    html! { td.{ "lost" (class_of(lost as f64 / struck as f64)) } { (lost) "/" (struck) } }
}

fn by_planner(agreement: &AgreementRecord, modes: &str) -> Markup {
    let heads = [words("Planner"), numbers("Share lost", "%"), counts("phi")];
    let caption = html! { "Over " (modes) };
    let rows = html! {
        @for t in &agreement.by_flight {
            tr {
                th scope="row" { (t.planner.map_or("all".into(), str::to_uppercase)) }
                td.n { (t.base_rate.map_or("\u{2013}".into(), part_of_all)) }
                td.n { (t.phi.map_or("\u{2013}".into(), |r| true_minus(&significant(r, 3)))) }
            }
        }
    };
    let (label, caption) = (&*format!("Agreement over {modes}"), Some(caption));
    table::table(Frame { label, class: Some("compact"), caption, ..Frame::default() }, &heads, rows)
}

/// Whether the plans predict which flights are lost.
pub fn agreement(record: &CampaignRecord) -> Markup {
    let modes = |a: &AgreementRecord| match a.modes {
        "inside" => format!("the {} modes with hover inside their sets", a.mode_count),
        _ => format!("all {} modes", a.mode_count),
    };
    html! {
        h2 { "Do the plans predict which flights are lost?" }
        p.note {
            "Predicted lost: the fault strikes before the plan's last violation of the mode's set. phi: agreement of \
             predicted and actual losses, 1 for perfect agreement, 0 for no better than chance. Intervals treat \
             flights as independent."
        }
        @for a in &record.agreement {
            (by_planner(a, &modes(a)))
            @if let Some(all) = a.by_flight.first() { p.note { (true_minus(&by_flight(&all.counts))) } }
        }
    }
}
