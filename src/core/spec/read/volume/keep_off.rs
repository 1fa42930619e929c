//! Reads `keep_off` blocks: areas seen from above.

use super::outline::{self, SHAPE, SIZE};
use super::statements::{MOST, TOO_MANY};
use crate::body::Body;
use crate::diagnostic::Diagnostic;
use crate::language::table::keep_off as table;
use crate::language::{Entry, Group};
use crate::model::KeepOff;
use crate::read::context::{Context, duplicate};
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::syntax::ast::Block;

/// The fields that each shape takes; `shape` and `clearance` belong to all.
const TAKEN: [(&str, &[&str]); 3] =
    [("box", &["from", "to", "turn"]), ("cylinder", &["centre", "radius"]), ("polygon", &["corners"])];

/// The ends of the bodies of an area, m: it has no heights.
const BOTTOM: f64 = f64::NEG_INFINITY;
const TOP: f64 = f64::INFINITY;

/// Reads the blocks of one mission, in the order written; `None` where one has an error.
pub fn read_keep_off<'a>(cx: &mut Context<'a>, blocks: &[&'a Block]) -> Option<Vec<KeepOff>> {
    let mut areas: Vec<KeepOff> = Vec::new();
    if let Some(block) = blocks.get(MOST) {
        let message = format!("a mission may have at most {MOST} areas to keep off");
        let error = Diagnostic::error(TOO_MANY, block.keyword.span, message).here("the limit is exceeded here");
        cx.report(error.help("join areas that touch, or leave out those far from the path"));
        return None;
    }
    for block in blocks {
        let area = one(cx, block);
        if let Some(name) = &block.name
            && let Some(first) = areas.iter().find(|area| area.name == name.value)
        {
            cx.report(duplicate("area", name, first.span));
        }
        areas.extend(area);
    }
    (areas.len() == blocks.len()).then_some(areas)
}

fn one<'a>(cx: &mut Context<'a>, block: &'a Block) -> Option<KeepOff> {
    let (name, span) = match &block.name {
        Some(name) => (name.value.clone(), name.span),
        None => (String::new(), block.keyword.span),
    };
    let fields = Fields::of_block(cx, format!("`keep_off {name}`"), span, &block.body, Group::KeepOff);
    let clearance = fields.quantity(cx, &table::CLEARANCE, SIZE).or_default(|| table::CLEARANCE.value());
    fields.demand(cx, "shape", "shape = box");
    let shape = fields.word(cx, SHAPE, &table::SHAPE).value()?;
    outline::misplaced(cx, &fields, shape, Group::KeepOff, &TAKEN);
    let bodies = match shape {
        "box" => rectangle(cx, &fields),
        "cylinder" => circle(cx, &fields),
        _ => polygon(cx, &fields),
    };
    let bodies = bodies.filter(|bodies| outline::is_near(cx, &fields, bodies));
    let area = KeepOff { name, bodies: bodies?, clearance: clearance?, span };
    (block.name.is_some() && block.is_whole()).then_some(area)
}

fn point<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, entry: &'static Entry, example: &str) -> Option<[f64; 2]> {
    fields.demand(cx, entry.name, example).and_then(|expr| cx.plane_point(Expected::of(entry), expr))
}

fn rectangle<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Vec<Body>> {
    let from = point(cx, fields, &table::FROM, "from = [0, 0] m");
    let to = point(cx, fields, &table::TO, "to = [40, 6] m");
    let turn = fields.written("turn", |expr| cx.number(Expected::of(&table::TURN), expr));
    let (from, to, turn) = (from?, to?, turn.or_default(|| table::TURN.value())?);
    outline::in_order(cx, fields, from, to)?;
    Some(vec![Body::Prism { corners: outline::rectangle(from, to, turn), bottom: BOTTOM, top: TOP }])
}

fn circle<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Vec<Body>> {
    let centre = point(cx, fields, &table::CENTRE, "centre = [12, 3] m");
    let radius = fields.demand(cx, "radius", "radius = 2 m").and_then(|expr| cx.quantity(&table::RADIUS, expr, SIZE));
    Some(vec![Body::Cylinder { centre: centre?, radius: radius?, bottom: BOTTOM, top: TOP }])
}

fn polygon<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Vec<Body>> {
    let expr = fields.demand(cx, "corners", "corners = [[0, 0], [4, 0], [4, 3]] m")?;
    let corners = outline::corners(cx, expr)?;
    let parts = outline::convex_parts(cx, expr, &corners)?;
    Some(parts.into_iter().map(|corners| Body::Prism { corners, bottom: BOTTOM, top: TOP }).collect())
}
