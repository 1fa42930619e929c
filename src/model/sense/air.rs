//! Wind, gusts and drag of a simulated flight.

use super::{Usual, short, warning};
use crate::model::context::Context;
use crate::model::fields::Fields;
use crate::model::{Rotor, Simulation, Vehicle};
use crate::source::Span;

/// Strongest wind, m/s: a storm, ten on Beaufort's scale.
const WIND: f64 = 25.0;
/// Strongest gusts, standard deviation in m/s: those of a storm.
const GUSTS: f64 = 10.0;
/// Length of gusts, m.
const GUST_LENGTH: Usual = Usual::new(1.0, 2000.0);
/// Drag over mass, 1/s: with more, the air stops the vehicle in half a second.
const SLOWING: f64 = 2.0;

/// Warns of air that no multirotor flies in. `fields` are those of `simulate`, which stands at `block`.
pub(in crate::model) fn check(
    cx: &mut Context,
    simulation: &Simulation,
    vehicle: Option<&Vehicle>,
    fields: &Fields,
    block: Span,
) {
    let at = |name: &str| fields.span_of(name).unwrap_or(block);
    let wind = simulation.wind.iter().map(|v| v * v).sum::<f64>().sqrt();
    if wind > WIND {
        let message = format!("a wind of {} m/s, where 0 to {} m/s is usual", short(wind), short(WIND));
        let slip = "look for `m/s` in place of `km/h`, and for digits too many";
        cx.report(warning("mavc::sense::wind", at("wind"), message, slip).here("stronger than a storm"));
    } else if let Some(vehicle) = vehicle {
        blown_away(cx, simulation, vehicle, wind, at("wind"), at("drag"));
    }
    if simulation.gusts > GUSTS {
        let message = format!("gusts of {} m/s, where 0 to {} m/s is usual", short(simulation.gusts), short(GUSTS));
        let slip = "look for `m/s` in place of `km/h`, and for digits too many";
        cx.report(
            warning("mavc::sense::gusts", at("gusts"), message, slip).here("the standard deviation of a storm is less"),
        );
    }
    if !GUST_LENGTH.has(simulation.gust_length) {
        let length = short(simulation.gust_length);
        let message = format!("gusts {length} m long, where {} is usual", GUST_LENGTH.text("m"));
        let slip = "check the number and its unit";
        cx.report(warning("mavc::sense::gusts", at("gust_length"), message, slip).here("the length scale of gusts"));
    }
    if let Some(slowing) = vehicle.map(|v| simulation.drag / v.mass).filter(|slowing| *slowing > SLOWING) {
        let message = format!("drag over mass is {} 1/s, where 0 to {} 1/s is usual", short(slowing), short(SLOWING));
        let slip = "check the units of drag and mass";
        let here = format!("falling, it would reach {} m/s", short(cx.gravity / slowing));
        cx.report(warning("mavc::sense::drag", at("drag"), message, slip).here(here));
    }
}

/// Warns of a steady wind that full thrust cannot hold against.
fn blown_away(cx: &mut Context, simulation: &Simulation, vehicle: &Vehicle, wind: f64, span: Span, drag: Span) {
    let thrust: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let weight = vehicle.mass * cx.gravity;
    let sideways = (thrust * thrust - weight * weight).max(0.0).sqrt();
    let force = simulation.drag * wind;
    if force <= sideways {
        return;
    }
    let message = format!(
        "the wind pushes vehicle `{}` with {} N, where at most {} N can be held against",
        vehicle.name,
        short(force),
        short(sideways)
    );
    let warning = warning("mavc::sense::wind", span, message, "check wind and drag").here("blows the vehicle away");
    cx.report(warning.also(drag, format!("times a drag of {} N*s/m", short(simulation.drag))));
}
