//! Noise of a simulated flight's sensors.

use super::{short, warning};
use crate::model::Simulation;
use crate::model::context::Context;
use crate::model::fields::Fields;
use crate::source::Span;

/// Largest standard deviation of a position, m: that of satellite navigation without corrections.
const POSITION: f64 = 5.0;
/// Largest standard deviation of a body rate, rad/s: many times that of a gyroscope on a vehicle that shakes.
const RATE: f64 = 1.0;

/// Warns of sensors that tell less than the cheapest do. `fields` are those of `simulate`, which stands at `block`.
pub(in crate::model) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
    let sensors = [
        (
            "position_noise",
            simulation.position_noise,
            POSITION,
            "m",
            "satellite navigation without corrections has 1 to 5 m",
        ),
        ("gyroscope_noise", simulation.gyroscope_noise, RATE, "rad/s", "a small gyroscope has 0.001 to 0.1 rad/s"),
    ];
    for (name, noise, most, unit, here) in sensors.into_iter().filter(|(_, noise, most, ..)| noise > most) {
        let message = format!("`{name}` is {} {unit}, where 0 to {} {unit} is usual", short(noise), short(most));
        let span = fields.span_of(name).unwrap_or(block);
        cx.report(warning("mavc::sense::noise", span, message, "check the number and its unit").here(here));
    }
}
