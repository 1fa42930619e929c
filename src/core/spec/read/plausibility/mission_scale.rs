//! The scale of missions: distances, times, speeds, tolerances and limits.

use super::{Usual, short, warning};
use crate::model::legs::distance;
use crate::model::{Limit, LimitKind, USUAL_SPEED, Waypoint};
use crate::read::context::Context;
use crate::read::mission::MAX_DURATION;
use crate::source::Span;

/// Length of the whole path, m: a shorter one is hardly a motion, for a longer one no battery lasts.
const PATH: Usual = Usual::new(0.05, 100_000.0);
/// Longest usual duration of a mission, s: four hours.
const DURATION: f64 = 4.0 * 3600.0;
/// Mean speed between two times that are fixed, m/s.
const PACE: Usual = Usual::new(0.001, 50.0);
/// Position tolerance of a waypoint, m.
const WITHIN: Usual = Usual::new(1e-4, 20.0);
/// Yaw tolerance of a waypoint, deg.
const YAW_WITHIN: Usual = Usual::new(0.001, 180.0);

/// Name, usual range, unit of that range, and that unit in SI, of a limit that is checked.
fn usual(kind: &LimitKind) -> Option<(&'static str, Usual, &'static str, f64)> {
    let degree = std::f64::consts::PI / 180.0;
    Some(match kind {
        LimitKind::Speed | LimitKind::SpeedHorizontal => ("speed", Usual::new(0.05, USUAL_SPEED), "m/s", 1.0),
        LimitKind::Climb => ("climb", Usual::new(0.02, 40.0), "m/s", 1.0),
        LimitKind::Descent => ("descent", Usual::new(0.02, 40.0), "m/s", 1.0),
        LimitKind::Acceleration | LimitKind::AccelerationHorizontal => {
            ("acceleration", Usual::new(0.02, 200.0), "m/s^2", 1.0)
        }
        LimitKind::Jerk => ("jerk", Usual::new(0.02, 20_000.0), "m/s^3", 1.0),
        LimitKind::YawRate => ("yaw rate", Usual::new(0.5, 2000.0), "deg/s", degree),
        LimitKind::YawAcceleration => ("yaw acceleration", Usual::new(0.5, 100_000.0), "deg/s^2", degree),
        LimitKind::Tilt => ("tilt", Usual::new(0.5, 90.0), "deg", degree),
        LimitKind::X | LimitKind::Y | LimitKind::Z | LimitKind::Yaw => return None,
        LimitKind::Face(_) | LimitKind::Distance(_) | LimitKind::Clearance(_) => return None,
        LimitKind::Arrival(_) | LimitKind::Heading(_) => return None,
    })
}

/// Warns of limits that bind nothing or allow hardly any motion. A bound of zero is taken as intended.
pub(in crate::spec::read) fn limits(cx: &mut Context, limits: &[Limit]) {
    for limit in limits {
        let Some((name, usual, unit, scale)) = usual(&limit.kind) else { continue };
        let ends = [limit.lower, limit.upper].into_iter().flatten().map(|end| end.abs() / scale);
        let Some(odd) = ends.into_iter().find(|end| *end > 0.0 && !usual.has(*end)) else { continue };
        let message = usual.outside(format!("the limit on {name} is {} {unit}", short(odd)), unit);
        let here = if odd > usual.high { "no multirotor reaches it" } else { "allows hardly any motion" };
        cx.report(warning("mavc::sense::limit", limit.span, message, "check the number and its unit").here(here));
    }
}

/// Warns of an implausible path, tolerance or duration, once each.
pub(in crate::spec::read) fn mission(cx: &mut Context, name: &str, span: Span, waypoints: &[Waypoint]) {
    let path: f64 = waypoints.windows(2).map(|pair| distance(pair[0].position, pair[1].position)).sum();
    if path > 0.0 && !PATH.has(path) {
        let message = PATH.outside(format!("the path of mission `{name}` is {} m long", short(path)), "m");
        let slip = match path > PATH.high {
            true => "look for `m` in place of `cm` or `mm`",
            false => "look for `mm` in place of `m`",
        };
        cx.report(warning("mavc::sense::distance", span, message, slip).here("measured from waypoint to waypoint"));
    }
    let metres = waypoints.iter().find(|w| !WITHIN.has(w.within)).map(|w| (w, w.within, WITHIN, "m"));
    let degrees = |w: &Waypoint| w.yaw_within.to_degrees();
    let turned = waypoints.iter().find(|w| !YAW_WITHIN.has(degrees(w) * (1.0 - 1e-9)));
    let turned = turned.map(|w| (w, degrees(w), YAW_WITHIN, "deg"));
    for (waypoint, value, usual, unit) in metres.into_iter().chain(turned) {
        let message = usual.outside(format!("a waypoint has a tolerance of {} {unit}", short(value)), unit);
        let here = if value > usual.high { "met almost anywhere" } else { "smaller than anyone can measure" };
        let slip = match unit {
            "m" => "look for `km` or `m` in place of `cm`, here or in `plan`",
            _ => "look for `rad` in place of `deg`, here or in `plan`",
        };
        cx.report(warning("mavc::sense::tolerance", waypoint.span, message, slip).here(here));
    }
    let times = waypoints.iter().filter_map(|w| Some((w.time? + w.hold, w.time_span?)));
    let holds: f64 = waypoints.iter().map(|w| w.hold).sum();
    let held = waypoints.iter().find_map(|w| w.hold_span).map(|span| (holds, span));
    if let Some((time, span)) = times.chain(held).find(|(time, _)| is_too_long(*time)) {
        too_long(cx, time, span);
    }
}

/// Whether a duration gets a warning; one beyond [`MAX_DURATION`] is an error and is reported elsewhere.
fn is_too_long(time: f64) -> bool {
    time > DURATION && time <= MAX_DURATION
}

fn too_long(cx: &mut Context, time: f64, span: Span) {
    let hours = |seconds: f64| short(seconds / 3600.0);
    let message = format!("the mission lasts {} h, outside the usual range of 0 to {} h", hours(time), hours(DURATION));
    let slip = "look for `s` in place of `ms`, and for extra digits";
    cx.report(warning("mavc::sense::duration", span, message, slip).here("no battery lasts this long"));
}

/// Warns of times that require an implausible mean speed. `total` is the time of the whole mission, s, and its place,
/// where that is fixed.
pub(in crate::spec::read) fn pace(cx: &mut Context, waypoints: &[Waypoint], total: Option<(f64, Span)>) {
    if let Some((time, span)) = total.filter(|(time, _)| is_too_long(*time)) {
        too_long(cx, time, span);
    }
    let last = waypoints.len().saturating_sub(1);
    // The last fixed time, and the shortest way and the holds since then.
    let (mut since, mut way, mut held) = (0.0, 0.0, 0.0);
    for (k, pair) in waypoints.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        held += from.hold;
        way += (distance(from.position, to.position) - from.within - to.within).max(0.0);
        let fixed = to.time.zip(to.time_span);
        let fixed = if k + 1 == last { fixed.or(total.map(|(time, span)| (time - to.hold, span))) } else { fixed };
        let Some((time, span)) = fixed else { continue };
        let flown = time - since - held;
        if flown > 0.0 && way > 0.0 && !PACE.has(way / flown) {
            return odd_pace(cx, way, flown, span, to.span);
        }
        (since, way, held) = (time, 0.0, 0.0);
    }
}

fn odd_pace(cx: &mut Context, way: f64, flown: f64, span: Span, to: Span) {
    let speed = way / flown;
    let message = PACE.outside(format!("the times require a mean speed of {} m/s", short(speed)), "m/s");
    let slip = match speed > PACE.high {
        true => "look for `ms` in place of `s`, and for `m` in place of `cm` or `mm`",
        false => "look for `s` in place of `ms`, and for `mm` in place of `m`",
    };
    let here = format!("at least {} m in {} s", short(way), short(flown));
    // From rest to rest, half the time accelerates and half decelerates: way = a t^2/4.
    let least = 4.0 * way / (flown * flown);
    let warning = warning("mavc::sense::speed", span, message, slip).here(here);
    cx.report(match speed > PACE.high {
        true => warning.also(to, format!("from rest to rest this takes at least {} m/s^2", short(least))),
        false => warning,
    });
}
