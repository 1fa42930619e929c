//! The table of constraints that limit the time of each leg.

use super::document::Section;
use super::prose::unbroken;
use super::table::{self, Frame, numbers, table};
use crate::model::Mission;
use crate::number::{fixed, significant};
use crate::report::binding::{BindingRecord, HEADLINE, StatementRecord, notes};
use crate::report::record::PlannerRecord;
use maud::html;

/// Rows at most; the JSON report has all.
const MOST_ROWS: usize = 200;

/// For a plan whose time was searched for; `None` if no statement limits it.
pub fn section(mission: &Mission, planner: &PlannerRecord) -> Option<Section> {
    let limited: Vec<&BindingRecord> = planner.limited_by.iter().filter(|leg| !leg.statements.is_empty()).collect();
    let left_out = limited.len().saturating_sub(MOST_ROWS);
    let most = limited.iter().flat_map(|leg| leg.statements.iter().map(move |statement| (leg, statement)));
    let (leg, first) = most.max_by(|a, b| a.1.time_saved_s.total_cmp(&b.1.time_saved_s))?;
    let headline = format!(
        "Leg {}: relaxing {} by {} would save the most, {} s",
        leg.label(),
        first.statement,
        first.relaxed_by,
        significant(first.time_saved_s, 2)
    );
    let heads = [table::words("Leg"), numbers("Time", "s"), table::words("Limited by")];
    let caption = Some(html! { (unbroken(HEADLINE)) });
    let frame = Frame { label: "Table of what limits the time", caption, ..Frame::default() };
    let rows = html! {
        @for leg in limited.iter().take(MOST_ROWS) {
            tr {
                th scope="row" { (leg.label()) }
                td.n { (fixed(leg.duration_s, 2)) }
                td { (unbroken(&words(leg))) }
            }
        }
    };
    let body = html! {
        h2 { (unbroken(&headline)) }
        (table(frame, &heads, rows))
        @for note in notes(mission) { p.note { (unbroken(&note)) } }
        @if left_out > 0 { p.note { (left_out) " more legs are omitted here; " code { "--report" } " lists all." } }
    };
    Some(Section::new("limits", "What limits the time", body))
}

fn words(leg: &BindingRecord) -> String {
    leg.statements.iter().map(StatementRecord::words).collect::<Vec<_>>().join("; ")
}
