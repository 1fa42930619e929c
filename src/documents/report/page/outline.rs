//! Volumes as flat views show them: from above (x, y) and from the side (x, z).
//!
//! A view shows the silhouette of a body. The sum of a body and a ball has as its silhouette that of the body and a
//! disc, so the boundary that the centre of gravity keeps is drawn exactly too. An oblique half space would cover a
//! whole view: it is cut by the plane of the view through a given point.

use super::chart::rounded;
use crate::body::Body;
use crate::model::{Volume, VolumeSide};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// A point of a view, m.
pub type Point = [f64; 2];

/// The coordinates that a view shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum View {
    Above,
    Side,
}

impl View {
    /// Indices into x, y, z: across and up.
    pub fn axes(self) -> [usize; 2] {
        match self {
            View::Above => [0, 1],
            View::Side => [0, 2],
        }
    }

    fn normal(self) -> usize {
        if self == View::Above { 2 } else { 1 }
    }
}

/// A volume in one view.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outline {
    /// Convex polygons whose union is the silhouette.
    pub areas: Vec<Vec<Point>>,
    /// The silhouette's boundary.
    pub edge: Vec<Vec<Point>>,
    /// The boundary that the centre of gravity keeps: size and clearance away from the volume's own.
    pub kept: Vec<Vec<Point>>,
}

/// Corners of a circle, and of the arcs of a rounded polygon.
const CORNERS: usize = 64;

/// Parts into which an edge of the kept boundary is divided where several bodies cover each other's.
const PARTS: usize = 40;

/// Half the length of the edge of a half space, m: beyond every view.
const FAR: f64 = 1e7;

/// A volume whose boundary is kept by `margin` m. Oblique half spaces are cut at `cut` (m).
pub fn outline(volume: &Volume, margin: f64, view: View, cut: [f64; 3]) -> Outline {
    let margin = if volume.side == VolumeSide::KeepIn { -margin } else { margin };
    let whole = whole_in_height(&volume.bodies);
    let bodies = match (&whole, view) {
        (Some(whole), View::Side) => std::slice::from_ref(whole),
        _ => &volume.bodies[..],
    };
    let of = |margin: f64| bodies.iter().filter_map(|body| silhouette(body, margin, view, cut)).collect::<Vec<_>>();
    let (areas, kept) = (of(0.0), of(margin));
    let points = |lines: Vec<Vec<Point>>| -> Vec<Vec<Point>> {
        lines.into_iter().map(|line| line.into_iter().map(|p| p.map(rounded)).collect()).collect()
    };
    let lines = |polygons: &[Vec<Point>]| match &volume.bodies[..] {
        // Only the plane of a half space: its other edges are beyond every view.
        [Body::HalfSpace { .. }] => polygons.iter().map(|polygon| polygon[1..3].to_vec()).collect(),
        _ => boundary(polygons),
    };
    Outline { edge: points(lines(&areas)), kept: points(lines(&kept)), areas: points(areas) }
}

/// The parts of a polygon as one prism with the same silhouette from the side: they have the same heights, and are
/// joined.
fn whole_in_height(bodies: &[Body]) -> Option<Body> {
    let [Body::Prism { bottom, top, .. }, _, ..] = bodies else { return None };
    let all = || {
        bodies.iter().flat_map(|body| match body {
            Body::Prism { corners, .. } => &corners[..],
            _ => &[],
        })
    };
    let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |e, c| (e.0.min(c[0]), e.1.max(c[0])));
    let corners = vec![[low, 0.0], [high, 0.0], [high, 1.0], [low, 1.0]];
    Some(Body::Prism { corners, bottom: *bottom, top: *top })
}

/// The silhouette of a body grown by `margin` m, or shrunk if it is negative; counter-clockwise. `None` if nothing is
/// left, or if it covers the view.
fn silhouette(body: &Body, margin: f64, view: View, cut: [f64; 3]) -> Option<Vec<Point>> {
    let circle = |centre: Point, radius: f64| {
        let at = |i: usize| TAU * i as f64 / CORNERS as f64;
        (radius > 0.0).then(|| {
            (0..CORNERS).map(|i| [centre[0] + radius * at(i).cos(), centre[1] + radius * at(i).sin()]).collect()
        })
    };
    match (body, view) {
        (Body::Prism { corners, .. }, View::Above) => moved(corners, margin),
        (Body::Prism { corners, bottom, top }, View::Side) => {
            // The shrunk prism is what its shrunk outline is in height.
            let shrunk = moved(corners, margin.min(0.0))?;
            let ends = |pick: fn(f64, f64) -> f64, from: f64| shrunk.iter().map(|c| c[0]).fold(from, pick);
            upright(ends(f64::min, f64::INFINITY), ends(f64::max, f64::NEG_INFINITY), *bottom, *top, margin)
        }
        (Body::Cylinder { centre, radius, .. }, View::Above) => circle(*centre, radius + margin),
        (Body::Cylinder { centre, radius, bottom, top }, View::Side) => {
            let reach = radius + margin.min(0.0);
            upright(centre[0] - reach, centre[0] + reach, *bottom, *top, margin)
        }
        (Body::Ball { centre, radius }, view) => circle(view.axes().map(|i| centre[i]), radius + margin),
        (Body::HalfSpace { normal, offset }, view) => {
            let across = view.axes().map(|i| normal[i]);
            let length = across[0].hypot(across[1]);
            // Parallel to the view: it covers all of it or nothing.
            if length < 1e-9 {
                return None;
            }
            let [x, y] = across.map(|n| n / length);
            let at = (offset + margin - normal[view.normal()] * cut[view.normal()]) / length;
            let corner = |along: f64, out: f64| [x * (at + out) - y * along, y * (at + out) + x * along];
            Some(vec![corner(-FAR, -FAR), corner(-FAR, 0.0), corner(FAR, 0.0), corner(FAR, -FAR)])
        }
    }
}

/// A rectangle, grown by a positive margin on all sides; a negative one, which the sides have already, moves bottom and
/// top.
fn upright(left: f64, right: f64, bottom: f64, top: f64, margin: f64) -> Option<Vec<Point>> {
    let (bottom, top) = if margin < 0.0 { (bottom - margin, top + margin) } else { (bottom, top) };
    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
    if left >= right || bottom >= top { None } else { moved(&corners, margin.max(0.0)) }
}

/// A convex counter-clockwise polygon grown by a disc, or shrunk by it.
fn moved(corners: &[Point], margin: f64) -> Option<Vec<Point>> {
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    let outward = |(a, b): (&Point, &Point)| (b[1] - a[1]).atan2(b[0] - a[0]) - 0.5 * PI;
    if margin == 0.0 {
        return Some(corners.to_vec());
    }
    if margin < 0.0 {
        let shrunk = edges().fold(corners.to_vec(), |polygon, edge| {
            let (sin, cos) = outward(edge).sin_cos();
            let bound = cos * edge.0[0] + sin * edge.0[1] + margin;
            clipped(&polygon, |p| cos * p[0] + sin * p[1] - bound)
        });
        return (shrunk.len() > 2).then_some(shrunk);
    }
    let mut grown = Vec::new();
    let angles: Vec<f64> = edges().map(outward).collect();
    for (i, corner) in corners.iter().enumerate() {
        let before = angles[(i + corners.len() - 1) % corners.len()];
        let turn = (angles[i] - before).rem_euclid(TAU);
        let parts = (turn / TAU * CORNERS as f64).ceil().max(1.0) as usize;
        grown.extend((0..=parts).map(|k| {
            let (sin, cos) = (before + turn * k as f64 / parts as f64).sin_cos();
            [corner[0] + margin * cos, corner[1] + margin * sin]
        }));
    }
    Some(grown)
}

/// The part of a convex polygon in which `over` is not positive (Sutherland and Hodgman).
pub fn clipped(polygon: &[Point], over: impl Fn(&Point) -> f64) -> Vec<Point> {
    let sides = polygon.iter().zip(polygon.iter().cycle().skip(1));
    sides
        .flat_map(|(p, q)| {
            let (a, b) = (over(p), over(q));
            let t = a / (a - b);
            let cut = ((a < 0.0) != (b < 0.0)).then(|| [0, 1].map(|i| p[i] + t * (q[i] - p[i])));
            (a <= 0.0).then_some(*p).into_iter().chain(cut)
        })
        .collect()
}

fn closed(polygon: &[Point]) -> Vec<Point> {
    polygon.iter().chain(polygon.first()).copied().collect()
}

/// The boundary of a union of convex polygons, as lines.
fn boundary(polygons: &[Vec<Point>]) -> Vec<Vec<Point>> {
    if let [one] = polygons {
        return vec![closed(one)];
    }
    let mut lines = Vec::new();
    for (own, polygon) in polygons.iter().enumerate() {
        let mut line: Vec<Point> = Vec::new();
        for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            // An edge that two polygons share lies inside of both.
            let shared = polygons.iter().enumerate().any(|(other, p)| {
                other != own && p.iter().zip(p.iter().cycle().skip(1)).any(|(c, d)| (c, d) == (b, a))
            });
            for k in 0..PARTS {
                let at = |k: usize| [0, 1].map(|i| a[i] + (b[i] - a[i]) * k as f64 / PARTS as f64);
                let middle = [0, 1].map(|i| 0.5 * (at(k)[i] + at(k + 1)[i]));
                let is_covered = |(other, p): (usize, &Vec<Point>)| {
                    let depth = inside(p, middle);
                    // Of two polygons with a common boundary the first draws it.
                    other != own && (depth > NEARLY || (depth > -NEARLY && other < own && !shared))
                };
                if shared || polygons.iter().enumerate().any(is_covered) {
                    push(&mut lines, &mut line);
                    continue;
                }
                if line.is_empty() {
                    line.push(at(k));
                }
                line.push(at(k + 1));
            }
        }
        push(&mut lines, &mut line);
    }
    lines
}

/// Depths below this count as on the boundary, m.
const NEARLY: f64 = 1e-6;

/// Adds a line without the points that lie on a straight one.
fn push(lines: &mut Vec<Vec<Point>>, line: &mut Vec<Point>) {
    let mut kept: Vec<Point> = Vec::new();
    for p in line.drain(..) {
        if let [.., a, b] = kept[..] {
            let across = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            if across.abs() <= 1e-9 * (p[0] - a[0]).hypot(p[1] - a[1]) {
                kept.pop();
            }
        }
        kept.push(p);
    }
    if kept.len() > 1 {
        lines.push(kept);
    }
}

/// The depth of a point in a convex counter-clockwise polygon, m; negative outside.
fn inside(polygon: &[Point], p: Point) -> f64 {
    let edge = |(a, b): (&Point, &Point)| {
        let (x, y) = (b[0] - a[0], b[1] - a[1]);
        (x * (p[1] - a[1]) - y * (p[0] - a[0])) / x.hypot(y).max(f64::MIN_POSITIVE)
    };
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(edge).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Span;

    fn volume(side: VolumeSide, bodies: Vec<Body>) -> Volume {
        Volume { name: "v".into(), side, bodies, clearance: 0.0, span: Span::default() }
    }

    fn prism(corners: &[Point]) -> Body {
        Body::Prism { corners: corners.to_vec(), bottom: 1.0, top: 3.0 }
    }

    /// Every point of the kept boundary is the margin away from the bodies, by their own distances.
    #[test]
    fn kept_boundaries_are_as_far_away_as_they_should_be() {
        let ell = vec![
            prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]]),
            prism(&[[0.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]]),
        ];
        let turned = prism(&[[0.0, 0.0], [3.0, 1.0], [2.0, 4.0], [-1.0, 3.0]]);
        let cylinder = Body::Cylinder { centre: [1.0, 2.0], radius: 2.0, bottom: 1.0, top: 3.0 };
        let ball = Body::Ball { centre: [1.0, 2.0, 2.0], radius: 2.0 };
        let half = Body::HalfSpace { normal: [0.6, 0.48, 0.64], offset: 1.0 };
        for (side, bodies) in [
            (VolumeSide::KeepOut, ell),
            (VolumeSide::KeepOut, vec![turned.clone()]),
            (VolumeSide::KeepIn, vec![turned]),
            (VolumeSide::KeepOut, vec![cylinder.clone()]),
            (VolumeSide::KeepIn, vec![cylinder]),
            (VolumeSide::KeepIn, vec![ball]),
            (VolumeSide::KeepOut, vec![half]),
        ] {
            let volume = volume(side, bodies);
            let drawn = outline(&volume, 0.5, View::Above, [0.0, 0.0, 2.0]);
            assert!(!drawn.kept.is_empty(), "{volume:?}");
            for p in drawn.kept.iter().flatten().filter(|p| p[0].abs() < 100.0) {
                let at = [p[0], p[1], 2.0];
                let apart = volume.bodies.iter().map(|b| b.separation(at).distance).fold(f64::INFINITY, f64::min);
                let due = if side == VolumeSide::KeepIn { -0.5 } else { 0.5 };
                assert!((apart - due).abs() < 1e-3, "{volume:?} {p:?} {apart}");
            }
        }
    }

    /// The inner edge of a polygon in two parts is not drawn, and the outer ones are, once.
    #[test]
    fn the_edge_of_a_union_has_no_inner_lines() {
        let parts = vec![
            prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [0.0, 2.0]]),
            prism(&[[0.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]]),
        ];
        let drawn = outline(&volume(VolumeSide::KeepOut, parts), 0.5, View::Above, [0.0; 3]);
        let length =
            |line: &Vec<Point>| -> f64 { line.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum() };
        let whole: f64 = drawn.edge.iter().map(length).sum();
        assert!((whole - 18.0).abs() < 1e-9, "{whole}");
        let side = outline(
            &volume(VolumeSide::KeepOut, vec![prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0]])]),
            0.5,
            View::Side,
            [0.0; 3],
        );
        assert_eq!(side.areas, [[[0.0, 1.0], [4.0, 1.0], [4.0, 3.0], [0.0, 3.0]]]);
    }
}
