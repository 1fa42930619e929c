//! The first screen of an analysis: what each fault mode leaves of the vehicle, as on the terminal, each with a view of
//! the rotors that it takes.

use super::airframe;
use super::prose::{prose, terms, unbroken};
use super::summary::Found;
use super::table::{self, Frame, numbers, words};
use super::verdicts::class_of;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::flight::equilibrium::settled_spins;
use crate::model::Model;
use crate::report::analysis_screen::{HEADINGS, Overview, legend, remarks};
use crate::report::headline::headline;
use crate::report::mode_names::within;
use maud::{Markup, html};

/// Most columns of the names of modes, and most small views of a row.
const NAMES: usize = 48;
const MOST_VIEWS: usize = 12;

/// The headline and what a reader must not overlook.
pub fn found(model: &Model, modes: &[ModeAnalysis]) -> Found {
    Found { headline: headline(model, modes), warnings: remarks(model, modes), ..Found::default() }
}

/// The table of outcomes.
pub fn table(model: &Model, modes: &[ModeAnalysis]) -> Markup {
    let spins = settled_spins(model);
    let Overview { healthy, rows, others } = Overview::of(model, modes, &spins);
    let names: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    let mut heads = vec![words("Fault")];
    let columns = if spins.is_empty() { HEADINGS.len() - 1 } else { HEADINGS.len() };
    heads.extend(HEADINGS.iter().take(columns).enumerate().map(|(i, (name, unit))| match i {
        0 => words("After it"),
        3 => numbers("Largest mass", *unit),
        4 => numbers("Spin", format!("{name}, {unit}")),
        _ => numbers(&capital(name), *unit),
    }));
    let cells = |outcome: Option<Outcome>, cells: &[String]| {
        html! {
            @for (i, cell) in cells.iter().enumerate() {
                @match (i, outcome) {
                    (0, Some(outcome)) => td { span.verdict.(class_of(outcome)) { (cell) } },
                    (0, None) => td { (cell) },
                    _ => td.n { (unbroken(cell)) },
                }
            }
        }
    };
    let body = html! {
        tr { th scope="row" { "none" } (cells(modes.first().map(|mode| mode.outcome), &healthy)) }
        @for row in &rows {
            tr {
                th scope="row" {
                    (within(&names, &row.modes, NAMES))
                    div.views {
                        @for &mode in row.modes.iter().take(MOST_VIEWS) { (airframe::small(model, &model.modes[mode])) }
                    }
                }
                (cells(Some(row.outcome), &row.cells))
            }
        }
        @for (outcome, count) in &others {
            tr {
                th scope="row" { "and " (count) " more" }
                td { span.verdict.(class_of(*outcome)) { (outcome.word()) } }
            }
        }
    };
    let frame = Frame { label: "Table of outcomes", terms: Some("outcomes-terms"), ..Frame::default() };
    let meanings = [
        ("After it", "what remains of the vehicle in hover after the fault."),
        ("Climb", "thrust left beyond hover."),
        ("Yaw", "torque left about z, in the weaker and in the stronger direction."),
        ("Largest mass", "that with which hover is still inside the set that the outcome is about."),
    ];
    html! {
        div #outcomes {
            (table::table(frame, &heads, body))
            @for line in legend(model, modes, &spins) { p.note { (prose(&line)) } }
            (terms("outcomes-terms", meanings))
        }
    }
}

/// A text with its first letter in upper case.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
