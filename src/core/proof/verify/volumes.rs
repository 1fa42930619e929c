//! Bounds on positions that volumes impose, decided in interval arithmetic.
//!
//! The distance of p from a convex body K is the largest of `(n.p - h(n)) / |n|` over all n, with h the support
//! function of K: any n gives a lower bound. A direction from the body to the middle of the interval of positions gives
//! a nearly sharp one. As a function of time the distance changes at a rate of at most |p'|.

use super::interval::Interval;
use super::motion::{State, X, Y, Z, series};
use crate::model::Body;
use crate::model::DistanceFrom;

/// Value and rate of change.
type Series = super::series::Series<2>;

/// The position along a unit vector.
pub fn along(normal: &[f64; 3], state: &State) -> Series {
    let parts = [X, Y, Z].into_iter().zip(normal);
    let part = |(axis, n): (usize, &f64)| series(&state[axis], 0).times(Interval::point(*n));
    parts.map(part).fold(Series::constant(Interval::ZERO), |sum, part| sum + part)
}

/// The distance from a point or a line.
pub fn away(from: &DistanceFrom, state: &State) -> Series {
    match from {
        DistanceFrom::Point(centre) => apart(state, centre),
        DistanceFrom::Axis(centre) => apart(state, centre),
        DistanceFrom::Line { point, along } => {
            let from: [Interval; 3] = std::array::from_fn(|i| state[[X, Y, Z][i]][0] - Interval::point(point[i]));
            let across = rejected(from, along.map(Interval::point));
            let rate = rejected([X, Y, Z].map(|axis| state[axis][1]), along.map(Interval::point));
            let length = |parts: [Interval; 3]| parts.iter().fold(Interval::ZERO, |sum, p| sum + p.square()).sqrt();
            Series::of_derivatives(&[length(across), Interval::around_zero(length(rate).high)])
        }
    }
}

/// The distance from a body.
pub fn clear(body: &Body, state: &State) -> Series {
    let axes = [X, Y, Z].map(|axis| state[axis][0]);
    let rate = Interval::around_zero(speed(state, 3).high);
    Series::of_derivatives(&[distance(body, axes), rate])
}

/// `a - (a . along) along`: the distance from a line through a point is the length of this for the way from the point,
/// and changes at a rate of at most its length for the velocity.
fn rejected(a: [Interval; 3], along: [Interval; 3]) -> [Interval; 3] {
    let ahead = (0..3).fold(Interval::ZERO, |sum, i| sum + a[i] * along[i]);
    std::array::from_fn(|i| a[i] - ahead * along[i])
}

/// The distance from a point in the plane or in space.
fn apart(state: &State, centre: &[f64]) -> Series {
    let square = [X, Y, Z]
        .into_iter()
        .zip(centre)
        .fold(Interval::ZERO, |sum, (axis, c)| sum + (state[axis][0] - Interval::point(*c)).square());
    Series::of_derivatives(&[square.sqrt(), Interval::around_zero(speed(state, centre.len()).high)])
}

/// |p'| of the first coordinates.
fn speed(state: &State, count: usize) -> Interval {
    [X, Y, Z][..count].iter().fold(Interval::ZERO, |sum, &axis| sum + state[axis][1].square()).sqrt()
}

/// Bounds on the distance of every p from the body; inside the body it is not positive. The lower one decides whether a
/// volume is kept, the upper one only whether to give up a proof.
fn distance(body: &Body, p: [Interval; 3]) -> Interval {
    let middle = p.map(Interval::middle);
    let direction = direction(body, middle);
    let n = direction.map(Interval::point);
    let length = (n[0].square() + n[1].square() + n[2].square()).sqrt();
    let along = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    let value = (along - support(body, n)) / length;
    match body {
        // No other direction bounds the body.
        Body::HalfSpace { .. } => value,
        Body::Ball { centre, radius } => {
            let from_centre = [0, 1, 2].map(|i| (p[i] - Interval::point(centre[i])).square());
            (from_centre[0] + from_centre[1] + from_centre[2]).sqrt() - Interval::point(*radius)
        }
        Body::Prism { .. } | Body::Cylinder { .. } => {
            // The distance from the body's point nearest to the middle, which is the middle itself inside.
            let gap = if value.middle() > 0.0 { direction } else { [0.0; 3] };
            let nearest = [0, 1, 2].map(|i| middle[i] - gap[i]);
            let apart = [0, 1, 2].map(|i| (p[i] - Interval::point(nearest[i])).square());
            let largest = middle.iter().chain(&nearest).map(|x| x.abs()).fold(1.0, f64::max);
            let most = (apart[0] + apart[1] + apart[2]).sqrt() + Interval::point(ROUNDING * largest);
            Interval::new(value.low, most.high)
        }
    }
}

/// How far rounding may place the nearest point outside of a body, as a share of the coordinates.
const ROUNDING: f64 = 1e-12;

/// h(n), the largest `n.q` over the points q of the body.
fn support(body: &Body, n: [Interval; 3]) -> Interval {
    let larger = |a: Interval, b: Interval| Interval { low: a.low.max(b.low), high: a.high.max(b.high) };
    let vertical = |bottom: f64, top: f64| larger(n[2] * Interval::point(bottom), n[2] * Interval::point(top));
    let along = |point: &[f64]| n.iter().zip(point).fold(Interval::ZERO, |sum, (n, x)| sum + *n * Interval::point(*x));
    match body {
        Body::Prism { corners, bottom, top } => {
            let across = corners.iter().map(|corner| along(corner)).reduce(larger).unwrap_or(Interval::WHOLE);
            across + vertical(*bottom, *top)
        }
        Body::Cylinder { centre, radius, bottom, top } => {
            let across = (n[0].square() + n[1].square()).sqrt();
            along(centre) + Interval::point(*radius) * across + vertical(*bottom, *top)
        }
        Body::Ball { centre, radius } => {
            let length = (n[0].square() + n[1].square() + n[2].square()).sqrt();
            along(centre) + Interval::point(*radius) * length
        }
        // The direction is the normal itself.
        Body::HalfSpace { offset, .. } => Interval::point(*offset),
    }
}

/// The direction in which the body lies farthest from `p`, not of unit length. Any direction is safe, a good one sharp;
/// that of a half space is its normal.
fn direction(body: &Body, p: [f64; 3]) -> [f64; 3] {
    let from_box = |x: f64, y: f64, inside: (f64, [f64; 2]), bottom: f64, top: f64| {
        let vertical = if p[2] > top { p[2] - top } else { (p[2] - bottom).min(0.0) };
        if x != 0.0 || y != 0.0 || vertical != 0.0 {
            return [x, y, vertical];
        }
        // Inside: towards the nearest face.
        let (depth, across) = inside;
        match (top - p[2]).min(p[2] - bottom) < depth {
            true => [0.0, 0.0, if top - p[2] < p[2] - bottom { 1.0 } else { -1.0 }],
            false => [across[0], across[1], 0.0],
        }
    };
    match body {
        Body::Prism { corners, bottom, top } => {
            let ([x, y], inside) = from_polygon(corners, [p[0], p[1]]);
            from_box(x, y, inside, *bottom, *top)
        }
        Body::Cylinder { centre, radius, bottom, top } => {
            let (x, y) = (p[0] - centre[0], p[1] - centre[1]);
            let length = x.hypot(y);
            let across = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
            let out = (length - radius).max(0.0);
            from_box(out * across[0], out * across[1], (radius - length, across), *bottom, *top)
        }
        Body::Ball { centre, .. } => {
            let from = [0, 1, 2].map(|i| p[i] - centre[i]);
            if from == [0.0; 3] { [1.0, 0.0, 0.0] } else { from }
        }
        Body::HalfSpace { normal, .. } => *normal,
    }
}

/// From the nearest point of a polygon to p, zero inside; and the depth of p with the outward normal of the nearest
/// edge.
fn from_polygon(corners: &[[f64; 2]], p: [f64; 2]) -> ([f64; 2], (f64, [f64; 2])) {
    let mut nearest = ([0.0, 0.0], f64::INFINITY);
    let mut inside = (f64::INFINITY, [1.0, 0.0]);
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let edge = [b[0] - a[0], b[1] - a[1]];
        let length = edge[0].hypot(edge[1]);
        let from = [p[0] - a[0], p[1] - a[1]];
        let outward = [edge[1] / length, -edge[0] / length];
        let depth = -(outward[0] * from[0] + outward[1] * from[1]);
        if depth < inside.0 {
            inside = (depth, outward);
        }
        let share = ((from[0] * edge[0] + from[1] * edge[1]) / (length * length)).clamp(0.0, 1.0);
        let gap = [from[0] - share * edge[0], from[1] - share * edge[1]];
        let distance = gap[0].hypot(gap[1]);
        if distance < nearest.1 {
            nearest = (gap, distance);
        }
    }
    if inside.0 >= 0.0 { ([0.0, 0.0], inside) } else { (nearest.0, inside) }
}
