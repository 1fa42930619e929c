//! Wind, gusts and drag of a simulated flight.

use super::{Usual, short, warning};
use crate::model::{Rotor, Simulation, Vehicle};
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;

/// Strongest usual wind, m/s: a storm, 10 on the Beaufort scale.
const WIND: f64 = 25.0;
/// Strongest usual gusts, standard deviation in m/s: those of a storm.
const GUSTS: f64 = 10.0;
/// Length scale of gusts, m.
const GUST_LENGTH: Usual = Usual::new(1.0, 2000.0);
/// Largest usual drag over mass, 1/s: at this value the air slows the vehicle with a time constant of half a second.
const SLOWING: f64 = 2.0;

/// Warns of implausible wind, gusts and drag. `fields` are those of the `simulate` block at `block`.
pub(in crate::spec::read) fn check(
    cx: &mut Context,
    simulation: &Simulation,
    vehicle: Option<&Vehicle>,
    fields: &Fields,
    block: Span,
) {
    let at = |name: &str| fields.span_of(name).unwrap_or(block);
    let wind = simulation.wind.iter().map(|v| v * v).sum::<f64>().sqrt();
    // The wind and gusts of a mission are judged where they are written.
    let own = |name: &str| fields.span_of(name);
    strong(cx, own("wind").map(|span| (wind, span)), own("gusts").map(|span| (simulation.gusts, span)));
    if let Some(vehicle) = vehicle.filter(|_| wind <= WIND) {
        blown_away(cx, simulation, vehicle, wind, at("wind"), at("drag"));
    }
    if !GUST_LENGTH.has(simulation.gust_length) {
        let length = short(simulation.gust_length);
        let message = GUST_LENGTH.outside(format!("`gust_length` is {length} m"), "m");
        let slip = "check the number and its unit";
        cx.report(warning("mavc::sense::gusts", at("gust_length"), message, slip).here("length scale of the gusts"));
    }
    if let Some(slowing) = vehicle.map(|v| simulation.largest_drag() / v.mass).filter(|slowing| *slowing > SLOWING) {
        let message =
            format!("drag over mass is {} 1/s, outside the usual range of 0 to {} 1/s", short(slowing), short(SLOWING));
        let slip = "check the units of drag and mass";
        let here = format!("the vehicle would fall at {} m/s at most", short(cx.gravity / slowing));
        cx.report(warning("mavc::sense::drag", at("drag"), message, slip).here(here));
    }
}

/// Warns of wind and gusts (m/s) beyond a storm, each with the place where it is written.
pub(in crate::spec::read) fn strong(cx: &mut Context, wind: Option<(f64, Span)>, gusts: Option<(f64, Span)>) {
    let slip = "look for `m/s` in place of `km/h`, and for extra digits";
    if let Some((wind, span)) = wind.filter(|(wind, _)| *wind > WIND) {
        let message = format!("`wind` is {} m/s, outside the usual range of 0 to {} m/s", short(wind), short(WIND));
        cx.report(warning("mavc::sense::wind", span, message, slip).here("stronger than a storm"));
    }
    if let Some((gusts, span)) = gusts.filter(|(gusts, _)| *gusts > GUSTS) {
        let message = format!("`gusts` is {} m/s, outside the usual range of 0 to {} m/s", short(gusts), short(GUSTS));
        cx.report(warning("mavc::sense::gusts", span, message, slip).here("stronger than in a storm"));
    }
}

/// Warns of a steady wind that the vehicle cannot resist at full thrust.
fn blown_away(cx: &mut Context, simulation: &Simulation, vehicle: &Vehicle, wind: f64, span: Span, drag: Span) {
    let thrust: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let weight = vehicle.mass * cx.gravity;
    let sideways = (thrust * thrust - weight * weight).max(0.0).sqrt();
    // The least that the wind can push with, whatever the heading.
    let [x, y, _] = simulation.drag;
    let drag_across = x.min(y);
    let force = drag_across * wind;
    if force <= sideways {
        return;
    }
    let message = format!(
        "the wind pushes vehicle `{}` with {} N, but the vehicle can resist at most {} N",
        vehicle.name,
        short(force),
        short(sideways)
    );
    let warning = warning("mavc::sense::wind", span, message, "check wind and drag").here("blows the vehicle away");
    cx.report(warning.also(drag, format!("with a drag of {} N*s/m", short(drag_across))));
}
