//! Imposes the volumes of a mission on the vehicle that flies it, and reports what geometry alone excludes.

use crate::diagnostic::Diagnostic;
use crate::model::volume::reach::Reach;
use crate::model::volume::which;
use crate::model::volume::{Side, corridor, passage};
use crate::model::{Limit, Mission, PlanModel, PlanSettings, Vehicle, Waypoint};
use crate::number::significant;
use crate::read::context::Context;
use crate::source::Span;

const OUTSIDE: &str = "mavc::volume::waypoint";
const NO_WAY: &str = "mavc::volume::no_way";

/// Adds the limits of the mission's volumes; whether the waypoints keep them.
pub fn impose(cx: &mut Context, mission: &mut Mission, vehicle: &Vehicle) -> bool {
    let areas = mission.after_fault.keep_off.first().map(|area| area.span);
    let Some(first) = mission.volumes.first().map(|volume| volume.span).or(areas) else { return true };
    let size = vehicle.radius();
    if vehicle.size.is_none() && vehicle.propeller_radius.is_none() {
        let message = format!(
            "the size of vehicle `{}` is not known: volumes keep its largest arm, {} m, without the propellers",
            vehicle.name,
            significant(size, 3)
        );
        let warning = Diagnostic::warning("mavc::volume::unknown_size", vehicle.span, message);
        let warning = warning.here("neither `size` nor `propeller_radius`").also(first, "a volume that keeps it");
        cx.report(warning.help("add `propeller_radius = 12 cm` or `size = 40 cm` to the vehicle, with its own values"));
    }
    let mut fits = true;
    for volume in &mission.volumes {
        let limits = volume.limits(size);
        fits &= keeps_waypoints(cx, &limits, &mission.waypoints, volume.side, volume.clearance + size);
        mission.limits.extend(limits);
    }
    fits && leaves_corridors(cx, mission, size) && leaves_ways(cx, mission, size)
}

/// Both ends of the leg to a waypoint, as messages name them, with their places.
fn ends(mission: &Mission, to: usize) -> [(String, Span); 2] {
    [to - 1, to].map(|index| (which(index, &mission.waypoints[index]), mission.waypoints[index].span))
}

/// Reports a leg whose corridor a volume closes.
fn leaves_corridors(cx: &mut Context, mission: &Mission, size: f64) -> bool {
    let Some(found) = corridor::closed(&mission.limits, &mission.waypoints) else { return true };
    let [(from, from_span), (to, to_span)] = ends(mission, found.waypoint);
    let by = &mission.limits[found.by];
    let message = format!("no straight way leads from {from} to {to}: `{}` closes it", by.name());
    let error = Diagnostic::error(NO_WAY, to_span, message).here("cannot be reached along a straight line");
    let error = error.also(from_span, "from here").also(by.span, "closes the way");
    let (kept, radius) = (significant(size, 3), significant(found.half_width, 3));
    cx.report(error.help(format!(
        "let the leg go around, by a waypoint beside the volume or without `straight` or `corridor`: it stays within \
         {radius} m of its line, and the vehicle keeps {kept} m and the `clearance` from the boundary"
    )));
    false
}

/// Reports a waypoint that the volumes close off from the one before it.
fn leaves_ways(cx: &mut Context, mission: &Mission, size: f64) -> bool {
    let Some(found) = passage::closed_off(&mission.limits, &mission.volumes, &mission.waypoints) else { return true };
    let [(from, from_span), (to, to_span)] = ends(mission, found.waypoint);
    let name = |limit: &Limit| match limit.volume {
        Some(_) => format!("`{}`", limit.name()),
        None => format!("the limit on {}", limit.name()),
    };
    let by: Vec<String> = found.by.iter().map(|&i| name(&mission.limits[i])).collect();
    let message = format!("no way leads from {from} to {to}: {} closed off", listed(&by));
    let mut error = Diagnostic::error(NO_WAY, to_span, message).here("cannot be reached");
    error = error.also(from_span, "from here");
    for &i in &found.by {
        error = error.also(mission.limits[i].span, "closes the way");
    }
    let kept = significant(size, 3);
    cx.report(error.help(format!("leave a gap: the vehicle keeps {kept} m and the `clearance` from each boundary")));
    false
}

/// `it is closed off by A, B and C`, without its end.
fn listed(names: &[String]) -> String {
    match names {
        [] => "it is".into(),
        [one] => format!("{one} keeps it"),
        [rest @ .., last] => format!("{} and {last} keep it", rest.join(", ")),
    }
}

/// Reports the first waypoint that violates a limit of a volume.
fn keeps_waypoints(cx: &mut Context, limits: &[Limit], waypoints: &[Waypoint], side: Side, margin: f64) -> bool {
    for limit in limits {
        let reach = Reach::of(limit);
        for (index, waypoint) in waypoints.iter().enumerate() {
            if reach.is_some_and(|reach| !reach.contains(waypoint.position)) {
                continue;
            }
            let Some(violation) = limit.violation_at(waypoint.position) else { continue };
            if violation <= 1e-9 {
                continue;
            }
            let which = which(index, waypoint);
            let (place, apart) = match side {
                Side::KeepIn if violation > margin => ("outside", String::new()),
                Side::KeepIn => ("too near the boundary of", format!(" by {} m", significant(violation, 3))),
                Side::KeepOut if violation > margin => ("inside", String::new()),
                Side::KeepOut => ("too near", format!(" by {} m", significant(violation, 3))),
            };
            let message = format!("{which} is {place} `{}`{apart}", limit.name());
            let error = Diagnostic::error(OUTSIDE, waypoint.span, message);
            let kept = format!("the vehicle keeps {} m from its boundary", significant(margin, 3));
            let error = error.here("the centre of gravity passes here").also(limit.span, kept);
            cx.report(error.help("move the waypoint or change the volume"));
            return false;
        }
    }
    true
}

/// Reports `keep_out` volumes in a plan of the hover model, whose programs are convex.
pub fn only_in_the_exact_model(cx: &mut Context, plan: &PlanSettings, mission: &Mission) -> bool {
    let Some(volume) = mission.volumes.iter().find(|v| v.side == Side::KeepOut) else { return true };
    if plan.model == PlanModel::Exact {
        return true;
    }
    let message = format!("`model = hover` cannot keep out of volumes, and the mission has `keep_out {}`", volume.name);
    let error = Diagnostic::error("mavc::volume::model", volume.span, message).here("not a convex constraint");
    cx.report(error.help("write `model = exact` in `plan`, or remove the volume"));
    false
}
