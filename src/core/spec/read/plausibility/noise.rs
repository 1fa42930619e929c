//! Sensor noise of simulated flights.

use super::{short, warning};
use crate::model::Simulation;
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;

/// Largest usual standard deviation of a position, m: that of satellite navigation without corrections.
const POSITION: f64 = 5.0;
/// Largest usual standard deviation of a body rate, rad/s: many times that of a gyroscope on a vibrating vehicle.
const RATE: f64 = 1.0;

/// Warns of sensors with more noise than the cheapest have. `fields` are those of the `simulate` block at `block`.
pub(in crate::spec::read) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
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
        let message =
            format!("`{name}` is {} {unit}, outside the usual range of 0 to {} {unit}", short(noise), short(most));
        let span = fields.span_of(name).unwrap_or(block);
        cx.report(warning("mavc::sense::noise", span, message, "check the number and its unit").here(here));
    }
}
