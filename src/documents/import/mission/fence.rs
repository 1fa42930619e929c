//! The geofence of a plan as volumes: inclusion becomes `keep_in`, exclusion `keep_out`.

use super::draft::{Draft, Mark, Shape, Volume};
use super::items::{FileSettings, place, refuse};
use super::qgc_plan::{listed, numeric};
use crate::diagnostic::Diagnostic;
use crate::geodesy::TangentPlane;
use crate::import::json::{Json, JsonValue};
use crate::import::{SYNTAX, UNSUPPORTED, at};

type Read<T> = Result<T, Box<Diagnostic>>;

/// Corners of a polygon: the bound of a spec.
const MOST_CORNERS: usize = 200;
/// Bays of a polygon that are less deep than this stay part of it, m: the places of a plan are no finer.
const SHALLOW: f64 = 0.01;

pub fn read(fences: &Json, setting: &FileSettings, draft: &mut Draft) -> Read<()> {
    let plane = TangentPlane::at(setting.home.place);
    let empty = |key: &str| fences.get(key).and_then(Json::list).is_none_or(<[Json]>::is_empty);
    if !empty("polygon") || fences.get("polygon").is_some_and(|p| p.list().is_none()) {
        let message = "this is a geofence of version 1";
        let span = fences.get("polygon").map_or(fences.span.clone(), |there| there.span.clone());
        return refuse(UNSUPPORTED, &span, message, "an older form");
    }
    let mut number = 0;
    for key in ["polygons", "circles"] {
        let Some(list) = fences.get(key) else { continue };
        for fence in listed(list, key)? {
            number += 1;
            one(fence, number, &plane, draft)?;
        }
    }
    let inside: Vec<Mark> = draft.volumes.iter().filter(|v| v.is_inside).map(|v| v.mark.clone()).collect();
    if let ([first, second, ..], false) = (&inside[..], setting.is_ardupilot) {
        let message =
            "the plan has several inclusion fences: PX4 lets the vehicle be in any one of them, a spec in all at once";
        let error = Diagnostic::error(UNSUPPORTED, at(second.span.clone()), message).here("a second inclusion");
        let error = error.also(at(first.span.clone()), "the first");
        return Err(Box::new(error.help("draw one fence around all of them, with exclusions for what lies between")));
    }
    Ok(())
}

fn one(fence: &Json, number: usize, plane: &TangentPlane, draft: &mut Draft) -> Read<()> {
    let inclusion = need(fence, "inclusion")?;
    let JsonValue::Bool(is_inside) = inclusion.kind else {
        return refuse(SYNTAX, &inclusion.span, "`inclusion` must be true or false", inclusion.what());
    };
    let mark = Mark { name: format!("fence {number}"), span: inclusion.span.clone() };
    let name = format!("fence_{number}");
    if let Some(circle) = fence.get("circle") {
        let (centre, radius) = (need(circle, "center")?, need(circle, "radius")?);
        let [x, y] = corner(centre, plane)?;
        let length = numeric(radius, "radius")?;
        if length <= 0.0 || length > 1e6 {
            return refuse(
                SYNTAX,
                &radius.span,
                "the radius of a fence must be above 0 m, and at most 1000 km",
                "no radius",
            );
        }
        draft.volumes.push(Volume { mark, is_inside, name, shape: Shape::Circle { centre: [x, y], radius: length } });
        return Ok(());
    }
    let list = need(fence, "polygon")?;
    let corners = listed(list, "polygon")?;
    if corners.len() < 3 || corners.len() > MOST_CORNERS {
        let here = format!("{} corners", corners.len());
        let message = format!("the polygon of a fence must have 3 to {MOST_CORNERS} corners");
        return refuse(UNSUPPORTED, &list.span, &message, &here);
    }
    let mut points: Vec<[f64; 2]> = Vec::new();
    for point in corners {
        points.push(corner(point, plane)?);
    }
    points.dedup();
    if is_inside {
        include(points, &mark, &name, draft);
    } else {
        draft.volumes.push(Volume { mark, is_inside, name, shape: Shape::Polygon(points) });
    }
    Ok(())
}

/// The convex outline to stay inside of, and the bays between it and the polygon to stay out of: the same region, since
/// a spec's `keep_in` must be convex.
fn include(points: Vec<[f64; 2]>, mark: &Mark, name: &str, draft: &mut Draft) {
    let outline = outline(&points);
    let (n, m) = (points.len(), outline.len());
    let volume = |name: String, is_inside, corners: Vec<usize>| Volume {
        mark: mark.clone(),
        is_inside,
        name,
        shape: Shape::Polygon(corners.into_iter().map(|i| points[i]).collect()),
    };
    let mut bays = Vec::new();
    for k in 0..m {
        let (from, to) = (outline[k], outline[(k + 1) % m]);
        // Corners along the edge of the polygon from one corner of the outline to the next.
        let between: Vec<usize> = (0..n).map(|step| (from + step) % n).take_while(|i| *i != to).chain([to]).collect();
        let depth = between.iter().map(|i| distance(points[*i], points[from], points[to])).fold(0.0, f64::max);
        if between.len() > 2 && depth > SHALLOW {
            bays.push(between);
        }
    }
    draft.volumes.push(volume(name.into(), true, outline));
    let bays = bays.into_iter().enumerate().map(|(k, bay)| volume(format!("{name}_bay_{}", k + 1), false, bay));
    draft.volumes.extend(bays);
}

/// The distance of p from the line through a and b.
fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    (x * (p[1] - a[1]) - y * (p[0] - a[0])).abs() / x.hypot(y)
}

/// Indices of the corners of the convex hull, in the order of the polygon (A. M. Andrew, 1979: monotone chains).
fn outline(points: &[[f64; 2]]) -> Vec<usize> {
    let turn = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [points[a], points[b], points[c]];
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a].partial_cmp(&points[b]).unwrap_or(std::cmp::Ordering::Equal));
    let chain = |all: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for i in all {
            while let [.., a, b] = chain[..] {
                if turn(a, b, i) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(i);
        }
        chain
    };
    let mut hull = chain(&mut order.iter().copied());
    hull.extend(chain(&mut order.iter().rev().copied()));
    // The order of the polygon, whichever way round it is.
    hull.sort_unstable();
    hull.dedup();
    hull
}

fn need<'j>(object: &'j Json, key: &str) -> Read<&'j Json> {
    match object.get(key) {
        Some(value) => Ok(value),
        None => {
            let start = object.span.start;
            refuse(SYNTAX, &(start..start + 1), &format!("the object has no `{key}`"), &format!("needs `{key}`"))
        }
    }
}

/// x and y of a corner, rounded to the millimetre that is written.
fn corner(point: &Json, plane: &TangentPlane) -> Read<[f64; 2]> {
    let list = listed(point, "polygon")?;
    let [latitude, longitude, ..] = list else {
        return refuse(SYNTAX, &point.span, "a corner must be latitude and longitude", "not two numbers");
    };
    let degrees = [Some(numeric(latitude, "polygon")?), Some(numeric(longitude, "polygon")?)];
    let place = place(degrees, plane.origin().height, [&latitude.span, &longitude.span])?;
    let [x, y, _] = plane.local(&place).map(|v| (v * 1e3).round() / 1e3);
    if x.abs() > 999e3 || y.abs() > 999e3 {
        return refuse(UNSUPPORTED, &point.span, "a corner is more than 1000 km from the planned home", "too far");
    }
    Ok([x, y])
}
