//! The table of waypoints: each error, its tolerance, and the error as a share of the tolerance.

use super::document::Section;
use super::prose::unbroken;
use super::table::{Frame, counts, numbers, table, words};
use crate::number::fixed;
use crate::report::record::PlannerRecord;
use crate::report::waypoints::{WaypointRecord, headline};
use maud::html;

/// Rows at most; the JSON report has all.
const MOST_ROWS: usize = 200;

/// The section for a plan; `None` if there is none.
pub fn section(planner: &PlannerRecord) -> Option<Section> {
    let waypoints = &planner.waypoints;
    let left_out = waypoints.len().saturating_sub(MOST_ROWS);
    let shares = ["Error", "Allowed", "Share", "Yaw error", "Allowed", "Share"].map(counts);
    let heads: Vec<_> = [words("Waypoint"), numbers("At", "s")].into_iter().chain(shares).collect();
    let frame = Frame {
        label: "Table of waypoints",
        caption: Some(html! { "Errors at the waypoints, their tolerances, and the errors as shares of these" }),
        ..Frame::default()
    };
    let body = html! {
        h2 { (unbroken(&headline(waypoints))) }
        (table(frame, &heads, html! { @for w in waypoints.iter().take(MOST_ROWS) { (row(w)) } }))
        @if left_out > 0 {
            p.note { (left_out) " more waypoints are omitted here; " code { "--report" } " lists all." }
        }
    };
    (!waypoints.is_empty()).then(|| Section::new("waypoints", "Waypoints", body))
}

fn row(waypoint: &WaypointRecord) -> maud::Markup {
    html! {
        tr {
            th scope="row" { (waypoint.label()) }
            td.n { (fixed(waypoint.at_s, 2)) }
            @for cell in waypoint.cells() { td.n.bad[!waypoint.met] { (unbroken(&cell)) } }
        }
    }
}
