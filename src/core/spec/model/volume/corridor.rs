//! The corridor of a leg: the limits that it imposes, and whether a body to keep out of closes it, since a `straight`
//! leg has no way around.
//!
//! A path along a corridor passes every cross-section between its ends, to within the ends' tolerances. If one
//! cross-section lies whole in what a body and its margin forbid, no path exists. The distance from a convex body is
//! convex, so on the disc it is largest at a corner of a polygon about the disc; and the smallest violation at the
//! corners is concave along the leg, so that its largest value is found by a search over one interval. The converse
//! does not hold: bodies that close a corridor only together are not found.

use super::Boundary;
use super::passage::slack;
use super::reach::Reach;
use crate::model::legs::distance;
use crate::model::{DistanceFrom, Limit, LimitKind, OnLeg, Part, Waypoint};
use crate::source::Span;
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::sync::Arc;

/// The limits that keep a leg within `radius` (m) of the line between its waypoints, which are not at one place, and no
/// further than that past either of them. `name` is that of the corridor in messages.
pub fn limits([from, to]: [&Waypoint; 2], leg: usize, radius: f64, name: &str, span: Span) -> [Limit; 3] {
    let [from, to] = [from.position, to.position];
    let length = distance(from, to);
    let along: [f64; 3] = std::array::from_fn(|i| (to[i] - from[i]) / length);
    let volume = Arc::new(Boundary { name: name.to_string(), half_width: Some(radius) });
    let leg = Arc::new(OnLeg { leg, part: Part::Whole, name: name.to_string() });
    let bound = |kind, upper| Limit {
        kind,
        lower: None,
        upper: Some(upper),
        span,
        volume: Some(volume.clone()),
        leg: Some(leg.clone()),
    };
    let ahead = |p: [f64; 3]| (0..3).map(|i| along[i] * p[i]).sum::<f64>();
    [
        bound(LimitKind::Distance(DistanceFrom::Line { point: from, along }), radius),
        bound(LimitKind::Face(along), ahead(to) + radius),
        bound(LimitKind::Face(along.map(|part| -part)), radius - ahead(from)),
    ]
}

/// Corners of the polygon about a cross-section.
const CORNERS: usize = 16;
/// Steps of the search, each of which leaves two thirds of the interval: to 1e-7 of a leg.
const STEPS: usize = 40;

/// A leg whose corridor is closed: the waypoint where it arrives and the limit that closes it, both by index.
pub struct Closed {
    pub waypoint: usize,
    pub by: usize,
    /// Its half width, m.
    pub half_width: f64,
}

/// A bound that a body forbids, with the box that has all of what it forbids.
struct Forbidding {
    limit: usize,
    reach: Reach,
}

/// The first corridor that one limit of a `keep_out` closes; `None` where none is found to be.
pub fn closed(limits: &[Limit], waypoints: &[Waypoint]) -> Option<Closed> {
    let forbidding = limits.iter().enumerate().filter(|(_, limit)| limit.is_general());
    let forbidding: Vec<Forbidding> =
        forbidding.filter_map(|(limit, own)| Some(Forbidding { limit, reach: Reach::of(own)? })).collect();
    limits.iter().find_map(|limit| {
        let on = limit.leg.as_deref()?;
        let LimitKind::Distance(DistanceFrom::Line { along, .. }) = limit.kind else { return None };
        let half_width = limit.upper?;
        let radius = half_width + slack(limit);
        let ends = waypoints.get(on.leg..=on.leg + 1)?;
        // A cross-section that is forbidden whole has its middle on the line between the ends.
        let line = [0, 1].map(|i| ends[i].position);
        let near = forbidding.iter().filter(|body| body.reach.meets(line));
        let ends = [0, 1].map(|i| (Vector3::from(ends[i].position), ends[i].within));
        let by = { near }.find(|body| closes(&limits[body.limit], ends, Vector3::from(along), radius))?.limit;
        Some(Closed { waypoint: on.leg + 1, by, half_width })
    })
}

/// Whether a cross-section of this radius (m) lies whole in what the limit forbids. Ends are places and their
/// tolerances, m.
fn closes(limit: &Limit, [from, to]: [(Vector3<f64>, f64); 2], along: Vector3<f64>, radius: f64) -> bool {
    let (mut low, mut high) = (from.1, (to.0 - from.0).dot(&along) - to.1);
    if low >= high {
        return false;
    }
    let across = along.cross(&Vector3::ith(along.iamin(), 1.0)).normalize();
    let other = along.cross(&across);
    let corner = radius / (PI / CORNERS as f64).cos();
    let slack = slack(limit);
    // The smallest violation at the corners; `None` if one is so small that no section of the interval is closed: along
    // the leg a violation changes no faster than the place.
    let least = |s: f64, (low, high): (f64, f64)| {
        let enough = slack - (s - low).max(high - s);
        (0..CORNERS).try_fold(f64::INFINITY, |least, k| {
            let (sin, cos) = (2.0 * PI * k as f64 / CORNERS as f64).sin_cos();
            let p = from.0 + along * s + (across * cos + other * sin) * corner;
            let violation = limit.violation_at(p.into()).unwrap_or(f64::NEG_INFINITY);
            (violation > enough).then_some(least.min(violation))
        })
    };
    for _ in 0..STEPS {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        let Some((of_a, of_b)) = least(a, (low, high)).zip(least(b, (low, high))) else { return false };
        if of_a > slack || of_b > slack {
            return true;
        }
        (low, high) = if of_a < of_b { (a, high) } else { (low, b) };
    }
    least(0.5 * (low + high), (low, high)).is_some_and(|least| least > slack)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;
    use crate::model::{Volume, VolumeSide};
    use crate::source::Span;

    /// Against every cross-section of many, each looked at on a dense grid.
    #[test]
    fn what_is_closed_is_closed_and_what_a_grid_closes_is_found() {
        let mut seed = 7_u64;
        let mut number = |low: f64, high: f64| {
            seed = seed * 48_271 % 0x7fff_ffff;
            low + (high - low) * seed as f64 / f64::from(0x7fff_ffff)
        };
        let (mut closed, mut open) = (0, 0);
        for _ in 0..300 {
            let body = Body::Cylinder {
                centre: [number(-4.0, 14.0), number(-4.0, 4.0)],
                radius: number(0.5, 4.0),
                bottom: number(-6.0, 0.0),
                top: number(0.5, 6.0),
            };
            let volume = Volume {
                name: "mast".into(),
                side: VolumeSide::KeepOut,
                bodies: vec![body],
                clearance: 0.3,
                span: Span::default(),
            };
            let limit = &volume.limits(0.2)[0];
            let to = [10.0, number(-3.0, 3.0), number(-3.0, 3.0)];
            let (from, to) = (Vector3::zeros(), Vector3::from(to));
            let (along, radius) = ((to - from).normalize(), number(0.1, 3.0));
            let across = along.cross(&Vector3::z()).normalize();
            let other = along.cross(&across);
            // The smallest violation of the section where that is largest, by a grid of sections, radii and angles.
            let least = |s: f64| {
                let at = |r: f64, angle: f64| from + along * s + (across * angle.cos() + other * angle.sin()) * r;
                let grid =
                    (0..=3).flat_map(|i| (0..24).map(move |k| (radius * f64::from(i) / 3.0, f64::from(k) * PI / 12.0)));
                let violations = grid.map(|(r, angle)| limit.violation_at(at(r, angle).into()).unwrap());
                violations.fold(f64::INFINITY, f64::min)
            };
            let length = (to - from).norm();
            let best =
                (0..=100).map(|k| least(0.1 + (length - 0.2) * f64::from(k) / 100.0)).fold(f64::NEG_INFINITY, f64::max);
            let found = closes(limit, [(from, 0.1), (to, 0.1)], along, radius);
            // The polygon about the disc has its corners at 1.02 of the radius.
            assert!(!found || best > 0.0, "{best} {volume:?} {to:?} {radius}");
            assert!(found || best < 0.02 * radius + 0.1, "{best} {volume:?} {to:?} {radius}");
            if found { closed += 1 } else { open += 1 }
        }
        assert!(closed > 30 && open > 100, "{closed} {open}");
    }
}
