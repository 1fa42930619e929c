//! The fixed times and the holds of a mission.

use crate::diagnostic::Diagnostic;
use crate::model::Waypoint;
use crate::number::number;
use crate::read::context::Context;
use crate::source::Span;

/// How long a mission may last, s: over a day.
pub(in crate::spec::read) const MAX_DURATION: f64 = 100_000.0;

const TOO_LONG: &str = "mavc::mission::too_long";

/// Checks that fixed times increase and leave time for the holds between them, and that the mission starts at zero;
/// reports errors and returns `false` otherwise.
pub(super) fn check(cx: &mut Context, waypoints: &[Waypoint]) -> bool {
    let mut fine = true;
    const CODE: &str = "mavc::mission::time_order";
    // The earliest time at which the vehicle can leave the current waypoint, and the last fixed time with its place.
    let mut free_at = 0.0;
    let mut said: Option<(f64, Span)> = None;
    for (i, waypoint) in waypoints.iter().enumerate() {
        if let (Some(time), Some(span)) = (waypoint.time, waypoint.time_span) {
            if i == 0 && time != 0.0 {
                fine = false;
                let error = Diagnostic::error(CODE, span, "the first waypoint must be at time zero");
                let error = error.here(format!("this is {} s", number(time)));
                let error = error.help("remove the time of the first waypoint");
                let text = cx.sources.get(span.file).text.get(..span.start as usize).unwrap_or("");
                cx.report(match text.trim_end().strip_suffix("time") {
                    Some(before) => {
                        error.fix(Span { start: before.trim_end_matches([' ', '\t']).len() as u32, ..span }, "")
                    }
                    None => error,
                });
            } else if i > 0 && time <= free_at {
                fine = false;
                let message = match said {
                    Some((before, _)) if before == time => {
                        format!("two waypoints have the same time, {} s", number(time))
                    }
                    _ => format!(
                        "this waypoint is due at {} s, but the vehicle cannot leave the previous one before {} s",
                        number(time),
                        number(free_at)
                    ),
                };
                let mut error = Diagnostic::error(CODE, span, message).here("too early");
                if let Some((_, before)) = said {
                    error = error.also(before, "counted from here, including the holds between them");
                }
                let least = number(free_at);
                cx.report(error.help(format!("write a time after {least} s, counted from the start of the mission")));
            }
            free_at = time;
            said = Some((time, span));
        }
        if let Some(span) = waypoint.time_span.filter(|_| fine && free_at > MAX_DURATION) {
            cx.report(too_long(span, free_at));
            return false;
        }
        free_at += waypoint.hold;
        if fine && free_at > MAX_DURATION {
            cx.report(too_long(waypoint.hold_span.unwrap_or(waypoint.span), free_at));
            return false;
        }
    }
    fine
}

/// The error for a mission that lasts at least `duration` seconds, more than [`MAX_DURATION`].
pub(in crate::spec::read) fn too_long(span: Span, duration: f64) -> Diagnostic {
    Diagnostic::error(TOO_LONG, span, "a mission may last at most 100,000 s, over a day")
        .here(format!("this makes {} s", number(duration)))
        .help("write a shorter time, or correct the unit")
}
