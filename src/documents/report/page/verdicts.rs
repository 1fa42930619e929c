//! The table of modes: their control at hover, and the margins of the plan.

use super::motion::signed_percent;
use super::prose::{terms, unbroken};
use super::table::{self, Frame, numbers, words};
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::{HoverVerdict, ModeAnalysis};
use crate::model::Model;
use crate::motion::outside::Outside;
use crate::number::{down, fixed, short_seconds, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome};
use crate::report::headline::headline;
use crate::report::terminal::{airspeed as text_of, holds};
use maud::{Markup, html};

/// Most rows; the modes that the plan must tolerate come first.
const MOST_ROWS: usize = 200;
/// Rows that are shown without unfolding.
const MOST_OPEN: usize = 12;

/// One mode with the plan's results for it.
struct Row<'a> {
    analysis: &'a ModeAnalysis,
    title: Option<&'a str>,
    /// Index into [`Model::modes`]; `None` for the healthy vehicle.
    mode: Option<usize>,
    outside: Option<&'a Outside>,
    committed: Option<f64>,
}

/// The table with the results of the run that the page shows first; `analyses` has the healthy vehicle first.
pub fn section(model: &Model, comparison: &Comparison, analyses: &[ModeAnalysis]) -> Markup {
    let shown = super::shown_first(model, comparison);
    let solved = shown.and_then(|i| match &comparison.runs[i].outcome {
        PlanOutcome::Planned(solved) => Some((super::content::run_label(comparison, i, solved.time), solved.as_ref())),
        _ => None,
    });
    let solved = solved.as_ref().map(|(label, s)| (label.as_str(), *s));
    table(model, analyses, solved, &headline(model, analyses))
}

/// The table if nothing was planned.
pub fn refused(model: &Model, analyses: &[ModeAnalysis]) -> Markup {
    table(model, analyses, None, &headline(model, analyses))
}

/// The table below another that has the outcomes.
pub fn details(model: &Model, analyses: &[ModeAnalysis]) -> Markup {
    table(model, analyses, None, "Verdicts and margins of each mode")
}

fn table(model: &Model, analyses: &[ModeAnalysis], solved: Option<(&str, &MissionPlan)>, title: &str) -> Markup {
    let row = |index: usize| {
        let place = index.checked_sub(1).and_then(|m| model.plan.against.iter().position(|&a| a == m));
        let of_plan = place.zip(solved);
        Some(Row {
            analysis: analyses.get(index)?,
            title: index.checked_sub(1).and_then(|m| model.modes[m].title.as_deref()),
            mode: index.checked_sub(1),
            outside: of_plan.and_then(|(p, (_, s))| s.outside.get(p)),
            committed: of_plan.and_then(|(p, (_, s))| s.committed.get(p).copied()),
        })
    };
    let others = (1..analyses.len()).filter(|i| !model.plan.against.contains(&(i - 1)));
    let order: Vec<usize> = std::iter::once(0).chain(model.plan.against.iter().map(|i| i + 1)).chain(others).collect();
    let rows: Vec<Row> = order.iter().take(MOST_ROWS).filter_map(|&i| row(i)).collect();
    // Columns of dashes are omitted, and so is a column that repeats another: a mission that continues is committed to
    // a mode until its last violation.
    let columns = Columns {
        without_yaw: analyses.iter().any(|a| a.verdict == HoverVerdict::Stabilizable),
        airspeed: analyses.iter().any(|a| a.airspeed.is_some()),
        heading: !model.environment().is_isotropic(),
        of_plan: solved.is_some(),
        after: solved.is_some() && holds(model),
    };
    // What decides comes first: on a narrow screen the rest is scrolled to.
    let mut heads = vec![words("Mode"), words("What it leaves")];
    if columns.of_plan {
        heads.push(numbers("Plan's spare", "healthy widths"));
        heads.extend(["Last violation", "Violated for"].map(|name| numbers(name, "s")));
    }
    if columns.after {
        heads.extend([words("After the fault"), numbers("Committed until", "s")]);
    }
    heads.extend([numbers("Hover margin", "N, N m"), numbers("Heaviest", "kg")]);
    heads.extend(columns.without_yaw.then(|| numbers("Without yaw", "disc, N m")));
    heads.extend(columns.airspeed.then(|| numbers("Airspeed", "")));
    let caption = Some(html! {
        "Control at hover"
        @if let Some((label, _)) = solved { ", and violations by the plan (" (label) ")" }
    });
    let frame = Frame { label: "Table of modes", terms: Some("modes-terms"), caption, ..Frame::default() };
    let more = Frame { label: "Table of more modes", terms: Some("modes-terms"), ..Frame::default() };
    let count = rows.len();
    let (shown, folded) = if count > MOST_OPEN { fold(rows) } else { (rows, Vec::new()) };
    html! {
        h2 { (unbroken(title)) }
        (table::table(frame, &heads, html! { @for row in &shown { (cells(model, row, columns)) } }))
        @if !folded.is_empty() {
            details {
                summary { (folded.len()) " more modes" }
                (table::table(more, &heads, html! { @for row in &folded { (cells(model, row, columns)) } }))
            }
        }
        @if order.len() > count {
            p.note { (order.len() - count) " more modes are omitted here; " code { "mavc analyze" } " lists all." }
        }
        (terms("modes-terms", meanings(columns, analyses)))
    }
}

/// The rows of many modes that are shown, and those that are folded: first those that a plan violates, then from the
/// worst outcome to the best, all in their order. The healthy vehicle is shown.
fn fold(rows: Vec<Row>) -> (Vec<Row>, Vec<Row>) {
    let mut order: Vec<usize> = (1..rows.len()).collect();
    let is_harmless = |i: usize| rows[i].outside.is_none_or(|o| o.last.is_none());
    order.sort_by_key(|&i| (is_harmless(i), std::cmp::Reverse(rows[i].analysis.outcome)));
    order.truncate(MOST_OPEN - 1);
    let mut shown = Vec::new();
    let mut folded = Vec::new();
    for (i, row) in rows.into_iter().enumerate() {
        if i == 0 || order.contains(&i) { shown.push(row) } else { folded.push(row) }
    }
    (shown, folded)
}

/// The meaning of the table's columns and verdicts.
fn meanings(columns: Columns, analyses: &[ModeAnalysis]) -> Vec<(&'static str, &'static str)> {
    let mut found = vec![
        (
            "What it leaves",
            "what remains of the vehicle at hover, and below it the paper's word: controllable, stabilizable or \
             unstable.",
        ),
        ("Hover margin", "signed distance from hover to the edge of the mode's set of full wrenches."),
        ("Heaviest", "the mass up to which hover lies inside the mode's set."),
    ];
    if columns.without_yaw {
        found.push((
            "Without yaw",
            "the largest roll and pitch torque about hover that the mode gives in every direction, if yaw is given up.",
        ));
    }
    if columns.airspeed {
        found.push((
            "Airspeed",
            match columns.heading {
                false => {
                    "the largest steady airspeed in level flight with the plan's reserve, by thrust or by the \
                    mission's limit on tilt; (no yaw): with yaw given up. Over 40 m/s a drag that grows in \
                    proportion to the airspeed is not plausible."
                }
                true => {
                    "the largest steady airspeed in level flight with the plan's reserve and the nose in the worst \
                    direction, by thrust or by the mission's limit on tilt."
                }
            },
        ));
    }
    if columns.of_plan {
        found.extend([
            ("Plan's spare", "the smallest over the flight, negative outside, to the set used for planning."),
            ("Violated for", "how long the plan is outside the mode's admissible set."),
            ("Last violation", "a lost rotor stays lost, so a fault before this instant still meets a violation."),
        ]);
    }
    if columns.after {
        found.extend([
            (
                "After the fault",
                "what the plan assumes: the mission continues as planned (`continue`), or the vehicle stops and stays \
                 (`hold`).",
            ),
            (
                "Committed until",
                "a fault before this instant may cost the mission. With `continue` it is the plan's last violation; \
                 with `hold` the last instant from which no stop inside the set was found.",
            ),
        ]);
    }
    if analyses.iter().any(|a| a.verdict == HoverVerdict::Stabilizable) {
        found.push((
            "Stabilizable without yaw",
            "the vehicle stays up and level while it turns about z. With yaw controlled too, as in the sets drawn \
             here, hover may be far outside.",
        ));
    }
    found
}

/// Cells of a table: how long a plan violates a set, s, and the last instant, s.
pub fn violation_cells(seconds: f64, last: Option<f64>) -> [String; 2] {
    match last {
        None => [dash(), "never".into()],
        Some(last) => [short_seconds(seconds), fixed(last, 2)],
    }
}

/// An empty cell.
fn dash() -> String {
    "\u{2013}".into()
}

/// Which columns there are beyond those of hover.
#[derive(Clone, Copy)]
struct Columns {
    /// Some mode hovers only with yaw given up.
    without_yaw: bool,
    airspeed: bool,
    /// Whether it depends on the direction of the nose.
    heading: bool,
    of_plan: bool,
    after: bool,
}

fn cells(model: &Model, row: &Row, columns: Columns) -> Markup {
    let Row { analysis: a, title, mode, outside, committed } = row;
    let class = class_of(a.outcome);
    let edge = a.edge_words().map_or_else(String::new, |words| format!(", {words}"));
    let yaw = if a.verdict == HoverVerdict::Stabilizable { " without yaw" } else { "" };
    let [seconds, last] = outside.map_or_else(|| [dash(), dash()], |o| violation_cells(o.seconds, o.last));
    let after =
        mode.filter(|m| model.plan.against.contains(m)).map_or_else(dash, |m| model.after_fault(m).name().into());
    html! {
        tr {
            th scope="row" { (a.name) @if let Some(title) = title { br; span.unit { (title) } } }
            td {
                span.verdict.(class) { (a.outcome.word()) }
                @if mode.is_some() || a.outcome != Outcome::FullControl {
                    br;
                    span.unit { (a.verdict.name()) (yaw) (edge) }
                }
            }
            @if columns.of_plan {
                td.n.bad[outside.is_some_and(|o| o.last.is_some())] {
                    (outside.map_or_else(dash, |o| signed_percent(-o.max_violation)))
                }
                td.n { (last) }
                td.n { (seconds) }
            }
            @if columns.after {
                td { (after) }
                td.n { (committed.map_or_else(dash, |c| if c > 0.0 { fixed(c, 2) } else { "never".into() })) }
            }
            td.n { (a.acai.map_or("flat".into(), |m| signed(m, 4))) }
            td.n { (a.critical_mass_kg.map_or("none".into(), |m| down(m, 4))) }
            @if columns.without_yaw {
                td.n { (a.without_yaw.as_ref().map_or("none".into(), |w| down(w.disc_n_m, 4))) }
            }
            @if let Some(airspeed) = a.airspeed {
                td.n { (text_of(&airspeed)) }
            }
        }
    }
}

/// The class of an outcome, for its colour.
pub fn class_of(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::FullControl => "good",
        Outcome::FliesOn | Outcome::Caught | Outcome::Undecided => "edge",
        Outcome::NoMargin | Outcome::Lost => "bad",
    }
}

/// `+1.2`, `−0.4`
fn signed(x: f64, digits: usize) -> String {
    match x {
        x if x < 0.0 => format!("\u{2212}{}", significant(-x, digits)),
        x => format!("+{}", significant(x, digits)),
    }
}
