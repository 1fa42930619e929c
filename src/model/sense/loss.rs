//! When a simulated vehicle counts as lost: limits that hardly any flight passes, or that every flight does.

use super::{Usual, short, warning};
use crate::model::Simulation;
use crate::model::context::Context;
use crate::model::fields::Fields;
use crate::source::Span;

/// Distance from its place, m: less is a gust, more is another field.
const DISTANCE: Usual = Usual::new(0.05, 200.0);
/// How long a vehicle may be upside down or point away, s: most flights are over before the upper end.
const SECONDS: Usual = Usual::new(0.01, 10.0);
/// How far a vehicle may point away, deg: less is noise, more nothing can be.
const YAW: Usual = Usual::new(1.0, 180.0);

/// Warns of limits that judge nothing. `fields` are those of `simulate`, which stands at `block`.
pub(in crate::model) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
    let yaw = simulation.lost_yaw.map(|angle| ("lost_yaw", angle.to_degrees(), YAW, "deg"));
    let limits = [
        ("lost_beyond", simulation.lost_beyond, DISTANCE, "m"),
        ("upside_down", simulation.upside_down, SECONDS, "s"),
        ("lost_yaw_after", simulation.lost_yaw_after, SECONDS, "s"),
    ];
    for (name, limit, usual, unit) in limits.into_iter().chain(yaw).filter(|(_, limit, usual, _)| !usual.has(*limit)) {
        let message = format!("`{name}` is {} {unit}, where {} is usual", short(limit), usual.text(unit));
        let here =
            if limit > usual.high { "hardly any flight is lost by this" } else { "hardly any flight keeps to this" };
        let span = fields.span_of(name).unwrap_or(block);
        cx.report(warning("mavc::sense::loss", span, message, "check the number and its unit").here(here));
    }
}
