//! What can be done after each fault: a strip over the time of the plan for every mode.

use super::document::Section;
use super::prose::unbroken;
use super::table::{self, Frame, numbers, table};
use crate::number::fixed;
use crate::report::record::Record;
use crate::report::recovery::{ModeRecoveryRecord, OUTCOMES, PieceRecord, RecoveryRecord, WORDS, premise, sentence};
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
        @for (index, mode) in recovery.modes.iter().enumerate() {
            tr {
                th scope="row" { (mode.name) }
                td { (strip(mode, index)) }
                td.n { (fixed(mode.uncovered_s, 2)) }
            }
        }
    };
    let body = html! {
        h2 { "After a fault " (unbroken(&sentence(recovery))) }
        p.legend {
            @for order in (0..OUTCOMES.len()).filter(|order| has(recovery, OUTCOMES[*order])) {
                span {
                    svg.way.{ "way-" (order) } viewBox="0 0 10 10" aria-hidden="true" {
                        rect width="10" height="10" {}
                    }
                    " " (WORDS[order])
                }
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

/// The script reads from `data-mode` which of the page's ways out are those of the strip.
fn strip(mode: &ModeRecoveryRecord, index: usize) -> Markup {
    let duration = mode.pieces.last().map_or(1.0, |piece| piece.to_s).max(f64::MIN_POSITIVE);
    let place = |t: f64| WIDTH * t / duration;
    let [view, label] = [format!("0 0 {WIDTH} {HEIGHT}"), format!("Outcomes of {}", mode.name)];
    html! {
        svg.ways data-mode=(index) viewBox=(view) preserveAspectRatio="none" role="img" aria-label=(label) {
            @for piece in &mode.pieces { (part(piece, &place)) }
        }
    }
}

fn part(piece: &PieceRecord, place: &dyn Fn(f64) -> f64) -> Markup {
    let order = OUTCOMES.iter().position(|outcome| *outcome == piece.outcome).unwrap_or(OUTCOMES.len() - 1);
    let (from, width) = (place(piece.from_s), place(piece.to_s - piece.from_s).max(NARROWEST));
    let [begins, ends] = [piece.from_s, piece.to_s].map(|t| fixed(t, 2));
    let outcome = piece.site.as_deref().unwrap_or(WORDS[order]);
    html! {
        rect.{ "way-" (order) } x=(from) width=(width) height=(HEIGHT) {
            title { (begins) " to " (ends) " s: " (outcome) }
        }
    }
}
