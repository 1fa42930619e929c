//! When a simulated vehicle counts as lost: thresholds that hardly any flight exceeds, or that nearly every flight
//! does.

use super::{Usual, short, warning};
use crate::model::{LostYaw, Simulation};
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;

/// Distance from the reference, m: any gust causes less, and more is another site.
const DISTANCE: Usual = Usual::new(0.05, 200.0);
/// How long a vehicle may be upside down or have a wrong heading, s: most flights end sooner than the upper end.
const SECONDS: Usual = Usual::new(0.01, 10.0);
/// Heading error, deg: less is noise, more is impossible.
const YAW: Usual = Usual::new(1.0, 180.0);

/// Warns of thresholds that distinguish nothing. `fields` are those of the `simulate` block at `block`.
pub(in crate::spec::read) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
    let yaw = match simulation.lost_yaw {
        LostYaw::Off => None,
        LostYaw::Beyond(angle) => Some(("lost_yaw", angle.to_degrees(), YAW, "deg")),
    };
    let limits = [
        ("lost_beyond", simulation.lost_beyond, DISTANCE, "m"),
        ("upside_down", simulation.upside_down, SECONDS, "s"),
        ("lost_yaw_after", simulation.lost_yaw_after, SECONDS, "s"),
    ];
    for (name, limit, usual, unit) in limits.into_iter().chain(yaw).filter(|(_, limit, usual, _)| !usual.has(*limit)) {
        let message = usual.outside(format!("`{name}` is {} {unit}", short(limit)), unit);
        let here = match limit > usual.high {
            true => "hardly any flight would count as lost",
            false => "nearly every flight would count as lost",
        };
        let span = fields.span_of(name).unwrap_or(block);
        cx.report(warning("mavc::sense::loss", span, message, "check the number and its unit").here(here));
    }
}
