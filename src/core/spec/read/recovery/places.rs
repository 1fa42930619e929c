//! Whether the vehicle may be wherever it can touch down on a landing site.

use super::SITE;
use crate::body::Body;
use crate::diagnostic::Diagnostic;
use crate::model::{DistanceFrom, LandingSite, Limit, Mission, Quantity, Vehicle};
use crate::number::{number, significant};
use crate::read::context::Context;

/// Checks every landing site of a mission whose volumes are imposed on this vehicle; whether all fit. Reports the first
/// reason for each site that does not.
pub fn check(cx: &mut Context, mission: &Mission, vehicle: &Vehicle) -> bool {
    let mut all_fit = true;
    for site in &mission.after_fault.sites {
        let error = of_limits(site, mission).or_else(|| of_areas(site, mission, vehicle.radius()));
        all_fit &= error.is_none();
        error.into_iter().for_each(|error| cx.report(error));
    }
    all_fit
}

/// Lengths that differ by less are equal, m.
const ROUNDING: f64 = 1e-9;

/// The error for a site that is not inside the limits on places and the volumes, which widen by the buffer.
fn of_limits(site: &LandingSite, mission: &Mission) -> Option<Diagnostic> {
    let buffer = mission.after_fault.buffer;
    let mut broken = mission.limits.iter().filter(|limit| limit.is_general()).filter_map(|limit| {
        let widened = if limit.kind.is_clearance() { 0.0 } else { buffer };
        let over = violation(limit, site)? - widened;
        (over > ROUNDING).then_some((limit, over))
    });
    let (limit, over) = broken.next()?;
    let (by, is_apart) = (significant(over, 3), limit.kind.is_clearance());
    let what = match (&limit.volume, is_apart) {
        (Some(volume), true) => format!("comes {by} m too near `{}`", volume.name),
        (Some(volume), false) => format!("reaches {by} m too far out for `{}`", volume.name),
        (None, _) => format!("reaches {by} m beyond the limit on {}", limit.kind.describe().name),
    };
    let help = match is_apart {
        true => "move the site, or reduce its `radius`".to_string(),
        false => {
            let centimetres = number((over * 100.0).ceil() / 100.0);
            format!("move the site, reduce its `radius`, or widen the mission's `buffer` by {centimetres} m")
        }
    };
    let kept = match limit.volume {
        Some(_) => "the vehicle keeps its size and the `clearance` from this",
        None => "the limit",
    };
    Some(error(site, &what).also(limit.span, kept).help(help))
}

/// The error for a site on which the vehicle could touch down too near an area to keep off.
fn of_areas(site: &LandingSite, mission: &Mission, size: f64) -> Option<Diagnostic> {
    mission.after_fault.keep_off.iter().find_map(|area| {
        let (_, distance) = area.separation([site.at[0], site.at[1]]);
        let over = size + area.clearance + site.radius - distance;
        (over > ROUNDING).then(|| {
            let what = format!("comes {} m too near `keep_off {}`", significant(over, 3), area.name);
            let kept = format!("the vehicle lands at least {} m from this", significant(size + area.clearance, 3));
            error(site, &what).also(area.span, kept).help("move the site, or reduce its `radius`")
        })
    })
}

fn error(site: &LandingSite, what: &str) -> Diagnostic {
    let message = format!("landing site `{}` {what}", site.name);
    let radius = significant(site.radius, 3);
    Diagnostic::error(SITE, site.span, message).here(format!("the vehicle lands within {radius} m of its middle"))
}

/// By how much the point of the site that violates a limit on places most does so, m; `None` for other limits, and for
/// lower limits on the height, which a landing vehicle leaves.
fn violation(limit: &Limit, site: &LandingSite) -> Option<f64> {
    let LandingSite { at: [x, y, z], radius, .. } = *site;
    let between = |c: f64| {
        let below = limit.lower.map_or(f64::NEG_INFINITY, |lower| lower - (c - radius));
        limit.upper.map_or(below, |upper| below.max(c + radius - upper))
    };
    match limit.kind.describe().quantity {
        Quantity::Axis { axis: 0, order: 0, .. } => Some(between(x)),
        Quantity::Axis { axis: 1, order: 0, .. } => Some(between(y)),
        Quantity::Axis { axis: 2, order: 0, .. } => Some(z - limit.upper?),
        Quantity::Along(normal) => Some(dot(normal, [x, y, z]) + radius * normal[0].hypot(normal[1]) - limit.upper?),
        Quantity::Distance(DistanceFrom::Point([a, b, c])) => {
            Some(((x - a).hypot(y - b) + radius).hypot(z - c) - limit.upper?)
        }
        Quantity::Distance(DistanceFrom::Axis([a, b])) => Some((x - a).hypot(y - b) + radius - limit.upper?),
        Quantity::Clearance(obstacle) => Some(limit.lower? - apart(&obstacle.body, site)),
        // Corridors belong to legs.
        Quantity::Distance(DistanceFrom::Line { .. }) => None,
        Quantity::Axis { .. } | Quantity::Norm { .. } | Quantity::Tilt => None,
        Quantity::Arrival(_) | Quantity::Heading(_) => None,
    }
}

/// The distance of a body from the nearest point of the site, m; negative where they overlap.
fn apart(body: &Body, site: &LandingSite) -> f64 {
    let LandingSite { at: [x, y, z], radius, .. } = *site;
    match body {
        Body::Prism { bottom, top, .. } | Body::Cylinder { bottom, top, .. } => {
            let (_, distance) = body.seen_from_above([x, y]);
            let (across, vertical) = (distance - radius, (bottom - z).max(z - top));
            if across > 0.0 && vertical > 0.0 { across.hypot(vertical) } else { across.max(vertical) }
        }
        Body::Ball { centre: [a, b, c], radius: of_ball } => {
            ((x - a).hypot(y - b) - radius).max(0.0).hypot(z - c) - of_ball
        }
        Body::HalfSpace { normal, offset } => dot(*normal, site.at) - offset - radius * normal[0].hypot(normal[1]),
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}
