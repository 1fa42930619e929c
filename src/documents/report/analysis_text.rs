//! Terminal output of `mavc analyze`.

mod without_yaw;

use super::battery;
use super::terminal::{airspeed, vehicle_line};
use crate::admissible::edge::HoverPlace;
use crate::admissible::interval::Certainty;
use crate::admissible::parallel::{Parallel, least_angle};
use crate::admissible::verdict::{HoverVerdict, ModeAnalysis};
use crate::flight::equilibrium::settled_spins;
use crate::model::{Allocation, Model};
use crate::number::{down, significant};
use crate::report::headline::headline;
use crate::text_table::{Table, hanging};

/// Meaning of the columns after the verdict.
const LEGEND: &str = "
yaw free  without yaw control: the vehicle may spin
margin    distance from hover to the nearest facet [N, N m]; below 0: minus the largest violation; flat: no volume
heaviest  the largest mass that can hover
facets    inequalities of the mode's admissible set
rank      dimension of the set: 4 if thrust and all three torques can be varied independently
|e_p|     distance from hover to the nearest wrench that the mode can produce [N, N m]
";

/// Meaning of the column of airspeeds.
const AIRSPEED: &str = "\
airspeed  the largest steady airspeed in level flight with the plan's reserve; (tilt): the mission limits the tilt; \
(no yaw): with \
yaw given up; over 40 m/s drag that grows in proportion to the airspeed is not plausible
";

/// Meaning of the column of airspeeds of a vehicle with a drag for each axis of its body.
const AIRSPEED_OF_HEADINGS: &str = "\
airspeed  the largest steady airspeed in level flight with the plan's reserve, with the nose in the worst direction; \
(tilt): the mission limits the tilt
";

/// The whole output of `mavc analyze`: vehicle, table of modes with its legend, and headroom. `modes` are those of
/// [`crate::admissible::verdict`], the healthy vehicle first.
pub fn analysis(model: &Model, modes: &[ModeAnalysis]) -> String {
    let head = hanging(&headline(model, modes));
    let mut out = format!("{head}{}\n{}\n", vehicle_line(model), battery::full_thrust(model));
    out.push_str(&table_of_modes(model, modes));
    out.push_str(&legend(model, modes));
    out.push_str(&over_intervals(modes));
    out.push_str(&parallel_rows(modes));
    out.push_str(&without_yaw::table(modes));
    out.push_str(&without_yaw::settled(&settled_spins(model)));
    out.push_str(&headroom(modes));
    out
}

fn is_restricted(model: &Model) -> bool {
    model.vehicle.allocation == Allocation::PseudoInverse
}

fn has_airspeeds(modes: &[ModeAnalysis]) -> bool {
    modes.iter().any(|m| m.airspeed.is_some())
}

fn table_of_modes(model: &Model, modes: &[ModeAnalysis]) -> String {
    let mut headings = vec![
        "mode",
        "outcome",
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
    if is_restricted(model) {
        headings.push("unreached");
    }
    if has_airspeeds(modes) {
        headings.push("airspeed");
    }
    let mut table = Table::new(&headings);
    let optional = |x: Option<f64>, digits: usize| x.map_or("flat".into(), |v| significant(v, digits));
    let norm = |e: &[f64]| significant(e.iter().map(|v| v * v).sum::<f64>().sqrt(), 3);
    for m in modes {
        let mut cells = vec![
            m.name.clone(),
            m.outcome.word().into(),
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
        if is_restricted(model) {
            cells.push(
                optional(m.unreached_share.map(|share| 100.0 * share), 3)
                    + if m.unreached_share.is_some() { " %" } else { "" },
            );
        }
        cells.extend(m.airspeed.as_ref().map(airspeed));
        table.row(cells);
    }
    table.render(0)
}

/// What the columns of the table of modes mean.
fn legend(model: &Model, modes: &[ModeAnalysis]) -> String {
    let mut out = LEGEND.to_string();
    if has_airspeeds(modes) {
        out.push_str(if model.environment().is_isotropic() { AIRSPEED } else { AIRSPEED_OF_HEADINGS });
    }
    if modes.iter().any(|m| m.edge_words() == Some(HoverPlace::OnEdge.word())) {
        out.push_str(
            "the edge  hover can be reached, but in some direction no disturbance, however small, can be countered\n",
        );
    }
    if is_restricted(model) {
        out.push_str(
            "\nHere and in plans, each set is restricted to what the pseudo-inverse gives without clipping. The last \
             column\n\
             is the share of the set's volume that it does not reach.\n",
        );
    }
    out
}

/// Whether modes hover for every value of the spec's intervals; empty without intervals.
fn over_intervals(modes: &[ModeAnalysis]) -> String {
    if modes.iter().all(|m| m.robust.is_none()) {
        return String::new();
    }
    let mut table = Table::new(&["mode", "hovers", "worst", "best"]);
    for (m, r) in modes.iter().filter_map(|m| Some((m, m.robust?))) {
        let shown = |bound: Option<f64>| bound.map_or("-".into(), |margin| significant(margin, 4));
        // Hover is possible for all values, and on the edge for some of them.
        let edge = if r.hover == Certainty::Yes && r.acai_worst == Some(0.0) { ", at worst on the edge" } else { "" };
        let cells = [format!("{}{edge}", r.hover.name()), shown(r.acai_worst), shown(r.acai_best)];
        table.row(std::iter::once(m.name.clone()).chain(cells).collect());
    }
    format!(
        "\nOver the spec's intervals: does the mode hover with all axes controlled, and bounds on its \
        margin\n(- if hover may be out of reach or the set is flat)\n{}",
        table.render(0)
    )
}

/// A warning of modes whose rotors have almost the same effect on two axes; empty without any.
fn parallel_rows(modes: &[ModeAnalysis]) -> String {
    let faint: Vec<(&ModeAnalysis, Parallel)> =
        modes.iter().filter_map(|m| Some((m, m.nearest_rows.filter(|r| r.angle < least_angle())?))).collect();
    if faint.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["mode", "rows", "angle"]);
    for (m, rows) in faint {
        let angle = format!("{} degrees", significant(rows.angle.to_degrees(), 3));
        table.row(vec![m.name.clone(), rows.axes.join(", "), angle]);
    }
    format!(
        "\nWarning: nearly parallel rows of the actuation matrix: the rotors can hardly control these \
        axes separately\n{}",
        table.render(0)
    )
}

fn headroom(modes: &[ModeAnalysis]) -> String {
    let mut table = Table::new(&["mode", "thrust [N]", "tau_x [N m]", "tau_y [N m]", "tau_z [N m]"]);
    for m in modes {
        let both = |b: [f64; 2]| format!("{}/{}", significant(b[0], 3), significant(b[1], 3));
        match &m.headroom {
            Some(h) => table.row(vec![m.name.clone(), both(h.thrust), both(h.tau_x), both(h.tau_y), both(h.tau_z)]),
            None if m.verdict == HoverVerdict::Stabilizable => {
                table.row(vec![m.name.clone(), "heading not held".into()]);
            }
            None => table.row(vec![m.name.clone(), "no hover".into()]),
        }
    }
    format!("\nHeadroom from hover to the edge of each mode's admissible set, down/up\n{}", table.render(0))
}
