//! What the blocks of volumes and of areas share: outlines seen from above, and the checks of their fields.

use crate::body::Body;
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::model::volume::split;
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::read::expression::Value;
use crate::read::fields::Fields;
use crate::read::mission::MAX_DISTANCE;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind};

pub(super) const SHAPE: &str = "mavc::volume::shape";
pub(super) const SIZE: &str = "mavc::volume::size";
pub(super) const CORNERS: &str = "mavc::volume::corners";

/// The most corners of a polygon: to divide it takes at most their number cubed.
const MOST_CORNERS: usize = 200;

/// Whether a volume lies within [`MAX_DISTANCE`] of the origin; reports one that does not.
pub(super) fn is_near(cx: &mut Context, fields: &Fields, bodies: &[Body]) -> bool {
    let farthest = |body: &Body| match body {
        Body::HalfSpace { offset, .. } => offset.abs(),
        _ => {
            let (low, high) = body.extent();
            // Only an area to keep off has no end, and that upwards and downwards.
            low.into_iter().chain(high).map(f64::abs).filter(|x| x.is_finite()).fold(0.0, f64::max)
        }
    };
    let far = bodies.iter().map(farthest).fold(0.0, f64::max);
    if far <= MAX_DISTANCE {
        return true;
    }
    let message = format!("{} reaches more than 1000 km from the origin", fields.owner);
    let error = Diagnostic::error(SIZE, fields.span, message).here(format!("{} km", number(far / 1e3)));
    cx.report(error.help("place the origin where the mission starts, and write lengths in m"));
    false
}

/// Reports fields of `group` that belong to another shape; `of_shapes` has those that each shape takes.
pub(super) fn misplaced<'a>(
    cx: &mut Context<'a>,
    fields: &Fields<'a>,
    shape: &str,
    group: Group,
    of_shapes: &[(&str, &[&str])],
) {
    let taken = of_shapes.iter().find(|row| row.0 == shape).map_or(&[][..], |row| row.1);
    for entry in group.entries().iter().filter(|e| !["shape", "clearance"].contains(&e.name)) {
        let Some(span) = fields.span_of(entry.name).filter(|_| !taken.contains(&entry.name)) else { continue };
        let list: Vec<String> = taken.iter().map(|field| format!("`{field}`")).collect();
        let error = Diagnostic::error(SHAPE, span, format!("`shape = {shape}` takes no `{}`", entry.name));
        let help = format!("remove it, or choose another shape; this one takes {}", list.join(", "));
        cx.report(error.here("belongs to another shape").help(help));
    }
}

/// Whether `from` is below `to` on every axis; reports the first on which it is not.
pub(super) fn in_order<const N: usize>(cx: &mut Context, fields: &Fields, from: [f64; N], to: [f64; N]) -> Option<()> {
    let Some(axis) = (0..N).find(|&i| from[i] >= to[i]) else { return Some(()) };
    let name = ["x", "y", "z"][axis];
    let message = format!("`from` must be below `to` on every axis, and is not on {name}");
    let (a, b) = (fields.span_of("from"), fields.span_of("to"));
    let error = Diagnostic::error(SIZE, b.unwrap_or(fields.span), message);
    let error = error.here(format!("{name} = {} m", number(to[axis])));
    let error = error.also(a.unwrap_or(fields.span), format!("{name} = {} m", number(from[axis])));
    cx.report(error.help("exchange the two numbers: `from` is the lowest corner, `to` the highest"));
    None
}

/// The corners of a rectangle between two opposite ones, turned about its centre (rad).
pub(super) fn rectangle(from: [f64; 2], to: [f64; 2], turn: f64) -> Vec<[f64; 2]> {
    if turn == 0.0 {
        return vec![from, [to[0], from[1]], to, [from[0], to[1]]];
    }
    let [x, y] = [0, 1].map(|i| 0.5 * (from[i] + to[i]));
    let [a, b] = [0, 1].map(|i| 0.5 * (to[i] - from[i]));
    let (s, c) = turn.sin_cos();
    let corner = |(u, v): (f64, f64)| [x + c * u - s * v, y + s * u + c * v];
    [(-a, -b), (a, -b), (a, b), (-a, b)].map(corner).to_vec()
}

/// A polygon as convex parts, each counter-clockwise.
pub(super) fn convex_parts(cx: &mut Context, expr: &Expr, corners: &[[f64; 2]]) -> Option<Vec<Vec<[f64; 2]>>> {
    match split::convex_parts(corners) {
        Ok(parts) => Some(parts),
        Err(why) => {
            let error = Diagnostic::error(CORNERS, expr.span, format!("the corners do not bound an area: {why}"));
            cx.report(error.here("no polygon").help("give each corner once, in order along the edge"));
            None
        }
    }
}

/// `[[x, y], [x, y], ...] m`, m.
pub(super) fn corners<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<Vec<[f64; 2]>> {
    let due = Expected::new("corners", "m");
    let wrong = |cx: &mut Context<'a>, span: Span, here: &str| {
        let error = Diagnostic::error(CORNERS, span, "`corners` takes a list of points `[x, y]`").here(here);
        cx.report(error.help("write `[[0, 0], [4, 0], [4, 3]] m`, with at least three corners"));
        None
    };
    let ExprKind::List { elements, unit } = &expr.kind else { return wrong(cx, expr.span, "not a list") };
    if elements.len() < 3 {
        return wrong(cx, expr.span, "fewer than three corners");
    }
    if elements.len() > MOST_CORNERS {
        let message = format!("a polygon may have at most {MOST_CORNERS} corners");
        let error = Diagnostic::error(CORNERS, expr.span, message).here(format!("this one has {}", elements.len()));
        cx.report(error.help("leave out corners that hardly bend the edge"));
        return None;
    }
    let unit = match unit {
        Some(text) => Some((text, cx.unit(text)?)),
        None => None,
    };
    let mut found = Vec::with_capacity(elements.len());
    for element in elements {
        let list = match cx.evaluate(element)? {
            Value::List(list) if list.len() == 2 => list,
            _ => return wrong(cx, element.span, "not a point `[x, y]`"),
        };
        let mut point = [0.0; 2];
        for (to, quantity) in point.iter_mut().zip(list) {
            let quantity = match unit {
                Some((text, unit)) => cx.attach_one(quantity, unit, text, element.span)?,
                None => quantity,
            };
            *to = cx.lower(due, quantity, element)?;
        }
        found.push(point);
    }
    Some(found)
}
