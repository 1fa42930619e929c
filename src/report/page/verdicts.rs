//! The table of modes: what each leaves at hover, and how the plan stands to it.

use super::motion::signed_percent;
use crate::admissible::verdict::{ModeAnalysis, Verdict};
use crate::model::Model;
use crate::planner::compare::{Comparison, Ending, Solved};
use crate::report::number::{fixed, significant};
use crate::trajectory::outside::Outside;
use maud::{Markup, html};

/// Rows at most; those that the plan must stand come first.
const MOST_ROWS: usize = 200;

/// One mode with what the plan makes of it.
struct Row<'a> {
    analysis: &'a ModeAnalysis,
    title: Option<&'a str>,
    /// Index into [`Model::modes`]; `None` for the healthy vehicle.
    mode: Option<usize>,
    outside: Option<&'a Outside>,
    committed: Option<f64>,
}

/// With the last run that has a plan; `analyses` healthy first.
pub fn section(model: &Model, comparison: &Comparison, analyses: &[ModeAnalysis]) -> Markup {
    let shown = super::shown_first(model, comparison);
    let solved = shown.and_then(|i| match &comparison.runs[i].ending {
        Ending::Solved(solved) => Some((super::content::run_label(&comparison.runs[i], solved.time), solved.as_ref())),
        _ => None,
    });
    table(model, analyses, solved.as_ref().map(|(label, s)| (label.as_str(), *s)))
}

/// Where nothing was planned.
pub fn refused(model: &Model, analyses: &[ModeAnalysis]) -> Markup {
    table(model, analyses, None)
}

fn headline(analyses: &[ModeAnalysis]) -> String {
    let modes = analyses.get(1..).unwrap_or_default();
    let kept = modes.iter().filter(|a| a.verdict == Verdict::Controllable && a.interior).count();
    match modes.len() {
        0 => "The spec declares no fault mode".into(),
        1 if kept == 1 => "The one declared mode keeps full control at hover".into(),
        1 => "The one declared mode does not keep full control at hover".into(),
        n if kept == n => format!("All {n} declared modes keep full control at hover"),
        n => format!("{kept} of {n} declared modes keep full control at hover"),
    }
}

fn table(model: &Model, analyses: &[ModeAnalysis], solved: Option<(&str, &Solved)>) -> Markup {
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
    // A table says nothing by columns of dashes.
    let columns = Columns { of_plan: solved.is_some(), after: !model.plan.against.is_empty() };
    html! {
        h2 { (headline(analyses)) }
        div.scroll tabindex="0" role="region" aria-label="Table of modes" {
            table {
                caption {
                    "What is left at hover"
                    @if let Some((label, _)) = solved { ", and how the plan (" (label) ") stands to it" }
                }
                thead {
                    tr {
                        th scope="col" { "Mode" }
                        th scope="col" { "Verdict" }
                        th.n scope="col" { "Hover margin" br; span.unit { "N, N m" } }
                        th.n scope="col" { "Heaviest" br; span.unit { "kg" } }
                        @if columns.of_plan {
                            th.n scope="col" { "Plan's margin" br; span.unit { "healthy widths" } }
                            th.n scope="col" { "Outside" br; span.unit { "s" } }
                            th.n scope="col" { "Last outside" br; span.unit { "s" } }
                        }
                        @if columns.after { th scope="col" { "After it" } }
                        @if columns.of_plan { th.n scope="col" { "Committed" br; span.unit { "s" } } }
                    }
                }
                tbody { @for row in &rows { (cells(model, row, columns)) } }
            }
        }
        @if order.len() > rows.len() { p.note { (order.len() - rows.len()) " more modes are left out here; " code { "mavc analyze" } " lists all." } }
        p.note {
            "Hover margin: signed distance from hover to the edge of the mode's set, every axis held."
            @if columns.of_plan {
                " Plan's margin: the smallest over the flight, negative outside, measured against the set that plans keep to."
            }
            @if analyses.iter().any(|a| a.verdict == Verdict::Stabilizable) {
                " Stabilizable without yaw: the vehicle stays up and level while it turns about z. With every axis held, yaw too, as "
                "in the sets drawn here, hover may be far outside."
            }
        }
    }
}

/// Columns beside those of hover.
#[derive(Clone, Copy)]
struct Columns {
    of_plan: bool,
    after: bool,
}

fn cells(model: &Model, row: &Row, columns: Columns) -> Markup {
    let Row { analysis: a, title, mode, outside, committed } = row;
    let verdict = match (a.verdict, a.interior) {
        (Verdict::Controllable, true) => ("good", "controllable"),
        (Verdict::Controllable, false) => ("edge", "controllable, on the edge"),
        (Verdict::Stabilizable, true) => ("edge", "stabilizable without yaw"),
        (Verdict::Stabilizable, false) => ("bad", "stabilizable without yaw, on the edge"),
        (Verdict::Unstable, _) => ("bad", "unstable"),
    };
    let dash = || "\u{2013}".to_string();
    let after =
        mode.filter(|m| model.plan.against.contains(m)).map_or_else(dash, |m| model.after_fault(m).name().into());
    html! {
        tr {
            th scope="row" { (a.name) @if let Some(title) = title { br; span.unit { (title) } } }
            td { span.verdict.(verdict.0) { (verdict.1) } }
            td.n { (a.acai.map_or("flat".into(), |m| signed(m, 4))) }
            td.n { (a.critical_mass_kg.map_or("none".into(), |m| significant(m, 4))) }
            @if columns.of_plan {
                td.n.bad[outside.is_some_and(|o| o.last.is_some())] {
                    (outside.map_or_else(dash, |o| signed_percent(-o.max_violation)))
                }
                td.n { (outside.map_or_else(dash, |o| if o.last.is_some() { fixed(o.seconds, 2) } else { "0".into() })) }
                td.n { (outside.map_or_else(dash, |o| o.last.map_or("never".into(), |l| fixed(l, 2)))) }
            }
            @if columns.after { td { (after) } }
            @if columns.of_plan {
                td.n { (committed.map_or_else(dash, |c| if c > 0.0 { fixed(c, 2) } else { "never".into() })) }
            }
        }
    }
}

/// `+1.2`, `−0.4`
fn signed(x: f64, digits: usize) -> String {
    match x {
        x if x < 0.0 => format!("\u{2212}{}", significant(-x, digits)),
        x => format!("+{}", significant(x, digits)),
    }
}
