//! What `mavc analyze` says to people.

use super::table::Table;
use super::terminal::vehicle_line;
use crate::admissible::edge::Place;
use crate::admissible::interval::Certainty;
use crate::admissible::parallel::{Parallel, least_angle};
use crate::admissible::verdict::{ModeAnalysis, Verdict};
use crate::model::{Allocation, Model};
use crate::number::{down, significant};

/// What the columns after the verdict mean.
const LEGEND: &str = "
yaw free  what counts once yaw is given up: the vehicle may spin
margin    from hover to the nearest facet [N, N m]; outside, below 0, to the one passed most; flat: no volume
heaviest  the largest mass that hovers
facets    the inequalities that bound what the mode can do
rank      its dimension: 4 where thrust and each torque can be moved by themselves
|e_p|     from hover to the nearest thrust and torques that the mode can give [N, N m]
";

/// The table of `mavc analyze`.
pub fn analysis(model: &Model, modes: &[ModeAnalysis]) -> String {
    let mut out = format!("{}\n\n", vehicle_line(model));
    let mut headings = vec![
        "mode",
        "verdict",
        "hover",
        "margin",
        "yaw-free margin",
        "heaviest",
        "yaw-free heaviest",
        "facets",
        "rank",
        "|e_p|",
        "yaw-free |e_p|",
    ];
    let gives_away = model.vehicle.allocation == Allocation::PseudoInverse;
    if gives_away {
        headings.push("given away");
    }
    let mut table = Table::new(&headings);
    let optional = |x: Option<f64>, digits: usize| x.map_or("flat".into(), |v| significant(v, digits));
    let norm = |e: &[f64]| significant(e.iter().map(|v| v * v).sum::<f64>().sqrt(), 3);
    for m in modes {
        let mut cells = vec![
            m.name.clone(),
            m.verdict.name().into(),
            m.hover_words(),
            optional(m.acai, 4),
            optional(m.acai_yaw_free, 4),
            m.critical_mass_kg.map_or("none".into(), |v| format!("{} kg", down(v, 4))),
            m.critical_mass_yaw_free_kg.map_or("none".into(), |v| format!("{} kg", down(v, 4))),
            m.facets.map_or("flat".into(), |f| f.to_string()),
            m.rank.to_string(),
            norm(&m.residual4),
            norm(&m.residual3),
        ];
        if gives_away {
            cells.push(
                optional(m.given_away.map(|share| 100.0 * share), 3) + if m.given_away.is_some() { " %" } else { "" },
            );
        }
        table.row(cells);
    }
    out.push_str(&table.render(0));
    out.push_str(LEGEND);
    if modes.iter().any(|m| m.hover == Place::OnEdge) {
        out.push_str(
            "the edge  hover is in reach, but in some direction the smallest disturbance cannot be countered\n",
        );
    }
    if gives_away {
        out.push_str(
            "\nOf each set only what the pseudo-inverse gives without clipping counts here and in plans; the last column is\n\
             the share of the set's volume that it gives away.\n",
        );
    }
    if modes.iter().any(|m| m.robust.is_some()) {
        out.push_str("\nOver the spec's intervals: does it hover with all axes held, and the bounds on its margin\n(- where hover can be out of reach, or the set is flat)\n");
        let mut table = Table::new(&["mode", "hovers", "worst", "best"]);
        for (m, r) in modes.iter().filter_map(|m| Some((m, m.robust?))) {
            let told = |bound: Option<f64>| bound.map_or("-".into(), |margin| significant(margin, 4));
            // Sure to hover, and on the edge for some of the values.
            let edge =
                if r.hover == Certainty::Yes && r.acai_worst == Some(0.0) { ", at worst on the edge" } else { "" };
            let cells = [format!("{}{edge}", r.hover.name()), told(r.acai_worst), told(r.acai_best)];
            table.row(std::iter::once(m.name.clone()).chain(cells).collect());
        }
        out.push_str(&table.render(0));
    }
    let faint: Vec<(&ModeAnalysis, Parallel)> =
        modes.iter().filter_map(|m| Some((m, m.nearest_rows.filter(|r| r.angle < least_angle())?))).collect();
    if !faint.is_empty() {
        let mut table = Table::new(&["mode", "rows", "angle"]);
        for (m, rows) in faint {
            let angle = format!("{} degrees", significant(rows.angle.to_degrees(), 3));
            table.row(vec![m.name.clone(), rows.axes.join(", "), angle]);
        }
        out.push_str("\nWarning: rows of the actuation matrix that are nearly parallel, so that the rotors hardly tell them apart\n");
        out.push_str(&table.render(0));
    }
    out.push_str("\nHeadroom from hover to the edge of what each mode can do, down/up\n");
    let mut table = Table::new(&["mode", "thrust [N]", "tau_x [N m]", "tau_y [N m]", "tau_z [N m]"]);
    for m in modes {
        let both = |b: [f64; 2]| format!("{}/{}", significant(b[0], 3), significant(b[1], 3));
        match &m.headroom {
            Some(h) => table.row(vec![m.name.clone(), both(h.thrust), both(h.tau_x), both(h.tau_y), both(h.tau_z)]),
            None if m.verdict == Verdict::Stabilizable => table.row(vec![m.name.clone(), "yaw is lost".into()]),
            None => table.row(vec![m.name.clone(), "no hover".into()]),
        }
    }
    out.push_str(&table.render(0));
    out
}
