//! Volumes on the page: their table, and how the views of the path show them.

use super::chart::{Bound, Chart, Line, rounded};
use super::document::Section;
use super::outline::{Outline, View, outline};
use super::prose::unbroken;
use super::table::{Frame, numbers, table, words};
use crate::body::Body;
use crate::model::{Problem, Volume, VolumeSide};
use crate::motion::NodeState;
use crate::motion::checks::violation;
use crate::number::{fixed, significant};
use crate::planner::studies::MissionPlan;
use crate::report::record::PlannerRecord;
use crate::report::volumes::{self, VolumeRecord};
use maud::html;
use serde::Serialize;

/// The columns of numbers, each with its unit.
const COLUMNS: [(&str, &str); 6] =
    [("Distance", "m"), ("Required", "m"), ("At", "s"), ("x", "m"), ("y", "m"), ("z", "m")];

/// Rows of the table at most; the JSON report has all.
const MOST_ROWS: usize = 200;

/// Distances that exceed the required one by less than this are written beside their marks, m.
const TIGHT: f64 = 0.1;

/// Most curves of the distances over time: the volumes to which the plan comes nearest.
const MOST_CURVES: usize = 6;

/// A volume as the script draws it; lengths in m.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VolumeContent {
    /// `keep_out mast`.
    pub name: String,
    pub keeps_in: bool,
    pub solids: Vec<Solid>,
    pub above: Outline,
    pub side: Outline,
}

/// A body in space.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Solid {
    /// With the heights between which the centre of gravity keeps the outline.
    Prism {
        corners: Vec<[f64; 2]>,
        heights: [f64; 2],
        kept: [f64; 2],
    },
    Ball {
        centre: [f64; 3],
        radius: f64,
        kept: f64,
    },
    /// `normal . p <= offset`.
    HalfSpace {
        normal: [f64; 3],
        offset: f64,
        kept: f64,
    },
}

/// Where a plan comes nearest to a volume.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NearestContent {
    /// `2 m from keep_out mast`, where the distance is hardly more than required.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// Whether the distance is less than required.
    pub bad: bool,
    pub at: [f64; 3],
}

/// The volumes of the mission, in the order of the spec.
pub fn contents(problem: Problem) -> Vec<VolumeContent> {
    let mission = problem.mission();
    let cut = middle(mission.waypoints.iter().map(|w| w.position));
    let size = problem.model().vehicle.radius();
    let content = |volume: &Volume| {
        let keeps_in = volume.side == VolumeSide::KeepIn;
        let margin = size + volume.clearance;
        let view = |view: View| outline(volume, margin, view, cut);
        let grown = if keeps_in { -margin } else { margin };
        VolumeContent {
            name: format!("{} {}", volume.side.keyword(), volume.name),
            keeps_in,
            solids: volume.bodies.iter().map(|body| solid(body, grown)).collect(),
            above: view(View::Above),
            side: view(View::Side),
        }
    };
    mission.volumes.iter().map(content).collect()
}

fn middle(points: impl Iterator<Item = [f64; 3]> + Clone) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        let ends = points.clone().fold((f64::INFINITY, f64::NEG_INFINITY), |e, p| (e.0.min(p[i]), e.1.max(p[i])));
        0.5 * (ends.0 + ends.1)
    })
}

fn solid(body: &Body, grown: f64) -> Solid {
    let prism = |corners: Vec<[f64; 2]>, bottom: f64, top: f64| Solid::Prism {
        corners: corners.into_iter().map(|c| c.map(rounded)).collect(),
        heights: [bottom, top].map(rounded),
        // Grown by a ball, the outline is kept at its full width between bottom and top.
        kept: [bottom - grown.min(0.0), top + grown.min(0.0)].map(rounded),
    };
    match body {
        Body::Prism { corners, bottom, top } => prism(corners.clone(), *bottom, *top),
        Body::Cylinder { bottom, top, .. } => {
            let round = Volume {
                name: String::new(),
                side: VolumeSide::KeepOut,
                bodies: vec![body.clone()],
                clearance: 0.0,
                span: Default::default(),
            };
            prism(outline(&round, 0.0, View::Above, [0.0; 3]).areas.swap_remove(0), *bottom, *top)
        }
        Body::Ball { centre, radius } => {
            Solid::Ball { centre: centre.map(rounded), radius: rounded(*radius), kept: rounded(radius + grown) }
        }
        Body::HalfSpace { normal, offset } => {
            Solid::HalfSpace { normal: *normal, offset: rounded(*offset), kept: rounded(offset + grown) }
        }
    }
}

/// Where a plan comes nearest to each volume.
pub fn nearest(problem: Problem, solved: &MissionPlan) -> Vec<NearestContent> {
    volumes::records(problem, solved).iter().map(mark).collect()
}

fn mark(record: &VolumeRecord) -> NearestContent {
    let words = || format!("{} from {}", unbroken(&metres(record.distance_m)), name(record));
    NearestContent {
        label: (record.distance_m < record.required_m + TIGHT).then(words),
        bad: is_short(record),
        at: record.position_m.map(rounded),
    }
}

fn metres(length: f64) -> String {
    format!("{} m", significant(length, 3))
}

/// Whether a distance is less than required by more than reports print.
fn is_short(record: &VolumeRecord) -> bool {
    record.distance_m < record.required_m - 1e-3
}

/// The table of a plan; `None` without volumes.
pub fn section(problem: Problem, planner: &PlannerRecord) -> Option<Section> {
    let records = &planner.volumes;
    let spare = |record: &&VolumeRecord| record.distance_m - record.required_m;
    let least = records.iter().min_by(|a, b| spare(a).total_cmp(&spare(b)))?;
    let headline = format!(
        "The vehicle keeps {} from {} {}, of {} required",
        metres(least.distance_m),
        least.side,
        least.name,
        metres(least.required_m)
    );
    let caption = format!(
        "Smallest distance of the vehicle, {} m about its centre of gravity, from the boundary of each volume",
        significant(problem.model().vehicle.radius(), 3)
    );
    let left_out = records.len().saturating_sub(MOST_ROWS);
    let columns = COLUMNS.map(|(name, unit)| numbers(name, unit));
    let heads: Vec<_> = [words("Volume")].into_iter().chain(columns).collect();
    let frame = Frame { label: "Table of volumes", caption: Some(html! { (unbroken(&caption)) }), ..Frame::default() };
    let rows = html! {
        @for record in records.iter().take(MOST_ROWS) {
            tr {
                th scope="row" { (record.side) " " (record.name) }
                td.n.bad[is_short(record)] { (significant(record.distance_m, 3)) }
                td.n { (significant(record.required_m, 3)) }
                td.n { (fixed(record.at_s, 2)) }
                @for x in record.position_m { td.n { (fixed(x, 2)) } }
            }
        }
    };
    let body = html! {
        h2 { (unbroken(&headline)) }
        (table(frame, &heads, rows))
        @if left_out > 0 { p.note { (left_out) " more volumes are omitted here; " code { "--report" } " lists all." } }
    };
    Some(Section::new("volumes", "Volumes", body))
}

/// The volumes whose distances are drawn over time: indices in the order of the spec.
fn drawn(records: &[VolumeRecord]) -> Vec<usize> {
    let mut nearest: Vec<usize> = (0..records.len()).collect();
    nearest.sort_by(|&a, &b| records[a].distance_m.total_cmp(&records[b].distance_m));
    nearest.truncate(MOST_CURVES);
    nearest.sort_unstable();
    nearest
}

/// The number of curves of distances over time.
pub fn curves(problem: Problem) -> usize {
    problem.mission().volumes.len().min(MOST_CURVES)
}

fn name(record: &VolumeRecord) -> String {
    format!("{} {}", record.side, record.name)
}

/// The distances of the vehicle from the volumes that come nearest over the states of a plan, each with its column's
/// name, m.
pub fn distances<'s>(
    problem: Problem,
    solved: &MissionPlan,
    states: impl Iterator<Item = &'s NodeState> + Clone,
) -> Vec<(String, Vec<f64>)> {
    let (mission, environment) = (problem.mission(), problem.model().environment());
    if mission.volumes.is_empty() {
        return Vec::new();
    }
    let of = |index: usize| {
        let volume = &mission.volumes[index];
        let limits: Vec<_> = mission.limits.iter().filter(|l| l.volume.is_some() && l.span == volume.span).collect();
        let distance = |state: &NodeState| {
            volume.clearance
                - limits.iter().map(|l| violation(l, state, &environment)).fold(f64::NEG_INFINITY, f64::max)
        };
        (format!("volume_{index}"), states.clone().map(distance).collect())
    };
    drawn(&volumes::records(problem, solved)).into_iter().map(of).collect()
}

/// The chart of these distances; `None` without volumes.
pub fn chart(problem: Problem, solved: &MissionPlan) -> Option<Chart> {
    let records = volumes::records(problem, solved);
    let drawn = drawn(&records);
    let spare = |&&i: &&usize| records[i].distance_m - records[i].required_m;
    let least = &records[*drawn.iter().min_by(|a, b| spare(a).total_cmp(&spare(b)))?];
    let mut required: Vec<f64> = drawn.iter().map(|&i| records[i].required_m).filter(|&m| m > 0.0).collect();
    required.sort_by(f64::total_cmp);
    required.dedup();
    let word = |required: f64| {
        let of: Vec<String> =
            drawn.iter().filter(|&&i| records[i].required_m == required).map(|&i| name(&records[i])).collect();
        match &of[..] {
            [one] => format!("{one} at least"),
            _ => "others at least".to_string(),
        }
    };
    Some(Chart {
        id: "distance",
        title: "Distance from the boundaries of volumes",
        headline: format!(
            "The vehicle comes within {} of {} at {} s",
            metres(least.distance_m),
            name(least),
            fixed(least.at_s, 2)
        ),
        unit: "m",
        lines: drawn.iter().map(|&i| Line::new(name(&records[i]), format!("volume_{i}"))).collect(),
        bounds: required.into_iter().map(|bound| Bound::limit(word(bound), bound)).collect(),
        axis: None,
    })
}
