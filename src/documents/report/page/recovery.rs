//! What can be done after each fault: a strip over the time of the plan for every mode.

use super::document::Section;
use super::prose::unbroken;
use super::table::{self, Frame, numbers, table};
use crate::number::fixed;
use crate::report::record::Record;
use crate::report::recovery::{ModeRecord, OUTCOMES, RecoveryRecord, WORDS, premise, sentence};
use maud::{Markup, html};

/// Width and height of a strip in its own units.
const WIDTH: f64 = 1000.0;
const HEIGHT: f64 = 40.0;

/// The narrowest part of a strip, in its units: shorter ones would not be seen.
const NARROWEST: f64 = 3.0;

/// Of a plan along which ways out were sought.
pub fn section(record: &Record) -> Option<Section> {
    let recovery = record.recovery.as_ref()?;
    let heads = [table::words("Fault"), table::words("Outcome by the time at which it strikes"), numbers("Open", "s")];
    let frame = Frame { label: "Table of what can be done after each fault", ..Frame::default() };
    let rows = html! {
        @for mode in &recovery.modes {
            tr {
                th scope="row" { (mode.name) }
                td { (strip(mode)) }
                td.n { (fixed(mode.uncovered_s, 2)) }
            }
        }
    };
    let body = html! {
        h2 { (unbroken(&sentence(recovery))) }
        p.legend {
            @for (order, word) in WORDS.iter().enumerate().filter(|(order, _)| has(recovery, OUTCOMES[*order])) {
                span { svg.way.{ "way-" (order) } viewBox="0 0 10 10" aria-hidden="true" { rect width="10" height="10" {} } " " (word) }
            }
        }
        (table(frame, &heads, rows))
        @for text in premise(recovery, record.reserve) { p.note { (unbroken(&text)) } }
    };
    Some(Section::new("after-fault", "After a fault", body))
}

fn has(recovery: &RecoveryRecord, outcome: &str) -> bool {
    recovery.modes.iter().flat_map(|mode| &mode.pieces).any(|piece| piece.outcome == outcome)
}

fn strip(mode: &ModeRecord) -> Markup {
    let duration = mode.pieces.last().map_or(1.0, |piece| piece.to_s).max(f64::MIN_POSITIVE);
    let place = |t: f64| WIDTH * t / duration;
    html! {
        svg.ways viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } preserveAspectRatio="none" role="img" aria-label={ "Outcomes of " (mode.name) } {
            @for piece in &mode.pieces {
                @let order = OUTCOMES.iter().position(|outcome| *outcome == piece.outcome).unwrap_or(OUTCOMES.len() - 1);
                rect.{ "way-" (order) } x=(place(piece.from_s)) width=(place(piece.to_s - piece.from_s).max(NARROWEST)) height=(HEIGHT) {
                    title { (fixed(piece.from_s, 2)) " to " (fixed(piece.to_s, 2)) " s: " (piece.site.as_deref().unwrap_or(WORDS[order])) }
                }
            }
        }
    }
}
