//! Reads `keep_in` and `keep_out` blocks.

use super::outline::{self, CORNERS, SHAPE, SIZE};
use crate::body::Body;
use crate::diagnostic::Diagnostic;
use crate::language::table::volume as table;
use crate::language::{Entry, Group};
use crate::model::volume::{Side, Volume};
use crate::number::number;
use crate::read::context::{Context, duplicate};
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::syntax::ast::Block;

pub(super) const TOO_MANY: &str = "mavc::volume::too_many";

/// The most volumes of a mission, and the most areas to keep off: every one is checked at every instant.
pub(super) const MOST: usize = 100;

/// The fields that each shape takes; `shape` and `clearance` belong to all.
const TAKEN: [(&str, &[&str]); 5] = [
    ("box", &["from", "to", "turn"]),
    ("cylinder", &["centre", "radius", "height"]),
    ("polygon", &["corners", "bottom", "top"]),
    ("sphere", &["centre", "radius"]),
    ("half_space", &["point", "normal"]),
];

/// Reads the blocks of one mission, in the order written; `None` where one has an error.
pub fn read<'a>(cx: &mut Context<'a>, blocks: &[&'a Block]) -> Option<Vec<Volume>> {
    let mut volumes: Vec<Volume> = Vec::new();
    if let Some(block) = blocks.get(MOST) {
        let message = format!("a mission may have at most {MOST} volumes");
        let error = Diagnostic::error(TOO_MANY, block.keyword.span, message).here("the limit is exceeded here");
        cx.report(error.help("join volumes that touch, or leave out those far from the path"));
        return None;
    }
    for block in blocks {
        let volume = one(cx, block);
        if let Some(name) = &block.name {
            let earlier = volumes.iter().find(|v| v.name == name.value);
            if let Some(first) = earlier {
                cx.report(duplicate("volume", name, first.span));
            }
        }
        volumes.extend(volume);
    }
    (volumes.len() == blocks.len()).then_some(volumes)
}

/// Whether a block of a mission is a volume.
pub fn is_one(block: &Block) -> bool {
    [Side::KeepIn, Side::KeepOut].iter().any(|side| side.keyword() == block.keyword.value)
}

fn one<'a>(cx: &mut Context<'a>, block: &'a Block) -> Option<Volume> {
    let side = if block.keyword.value == Side::KeepIn.keyword() { Side::KeepIn } else { Side::KeepOut };
    let (name, span) = match &block.name {
        Some(name) => (name.value.clone(), name.span),
        None => (String::new(), block.keyword.span),
    };
    let owner = format!("`{} {name}`", side.keyword());
    let fields = Fields::of_block(cx, owner, span, &block.body, Group::Volume);
    let clearance = fields.quantity(cx, &table::CLEARANCE, SIZE).or_default(|| table::CLEARANCE.value());
    fields.demand(cx, "shape", "shape = box");
    let shape = fields.word(cx, SHAPE, &table::SHAPE).value()?;
    outline::misplaced(cx, &fields, shape, Group::Volume, &TAKEN);
    let read = Reader { fields: &fields, side };
    let bodies = match shape {
        "box" => read.cuboid(cx),
        "cylinder" => read.cylinder(cx),
        "polygon" => read.polygon(cx),
        "sphere" => read.sphere(cx),
        _ => read.half_space(cx),
    };
    let bodies = bodies.filter(|bodies| outline::is_near(cx, &fields, bodies));
    let volume = Volume { name, side, bodies: bodies?, clearance: clearance?, span };
    (block.name.is_some() && block.is_whole()).then_some(volume)
}

struct Reader<'f, 'a> {
    fields: &'f Fields<'a>,
    side: Side,
}

impl<'a> Reader<'_, 'a> {
    fn vector(&self, cx: &mut Context<'a>, entry: &'static Entry, example: &str) -> Option<[f64; 3]> {
        self.fields.demand(cx, entry.name, example).and_then(|expr| cx.triple(Expected::of(entry), expr))
    }

    fn quantity(&self, cx: &mut Context<'a>, entry: &'static Entry, example: &str) -> Option<f64> {
        self.fields.demand(cx, entry.name, example).and_then(|expr| cx.quantity(entry, expr, SIZE))
    }

    fn cuboid(&self, cx: &mut Context<'a>) -> Option<Vec<Body>> {
        let from = self.vector(cx, &table::FROM, "from = [-50, -50, 0] m");
        let to = self.vector(cx, &table::TO, "to = [50, 50, 30] m");
        let turn = self.fields.written("turn", |expr| cx.number(Expected::of(&table::TURN), expr));
        let (from, to, turn) = (from?, to?, turn.or_default(|| table::TURN.value())?);
        outline::in_order(cx, self.fields, from, to)?;
        let corners = outline::rectangle([from[0], from[1]], [to[0], to[1]], turn);
        Some(vec![Body::Prism { corners, bottom: from[2], top: to[2] }])
    }

    fn cylinder(&self, cx: &mut Context<'a>) -> Option<Vec<Body>> {
        let centre = self.vector(cx, &table::CENTRE, "centre = [12, 3, 0] m");
        let radius = self.quantity(cx, &table::RADIUS, "radius = 2 m");
        let height = self.quantity(cx, &table::HEIGHT, "height = 20 m");
        let ([x, y, bottom], radius, height) = (centre?, radius?, height?);
        Some(vec![Body::Cylinder { centre: [x, y], radius, bottom, top: bottom + height }])
    }

    fn sphere(&self, cx: &mut Context<'a>) -> Option<Vec<Body>> {
        let centre = self.vector(cx, &table::CENTRE, "centre = [12, 3, 5] m");
        let radius = self.quantity(cx, &table::RADIUS, "radius = 2 m");
        Some(vec![Body::Ball { centre: centre?, radius: radius? }])
    }

    fn half_space(&self, cx: &mut Context<'a>) -> Option<Vec<Body>> {
        let point = self.vector(cx, &table::POINT, "point = [0, 20, 0] m");
        let normal = self.vector(cx, &table::NORMAL, "normal = [0, 1, 0]");
        let (point, normal) = (point?, normal?);
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length <= 0.0 || !length.is_finite() {
            let span = self.fields.span_of("normal").unwrap_or(self.fields.span);
            let error = Diagnostic::error(SIZE, span, "`normal` must not be zero").here("has no direction");
            cx.report(error.help("write the direction that points out of the half space, as in `normal = [0, 1, 0]`"));
            return None;
        }
        let normal = normal.map(|x| x / length);
        Some(vec![Body::HalfSpace { normal, offset: (0..3).map(|i| normal[i] * point[i]).sum() }])
    }

    fn polygon(&self, cx: &mut Context<'a>) -> Option<Vec<Body>> {
        let expr = self.fields.demand(cx, "corners", "corners = [[0, 0], [4, 0], [4, 3]] m");
        let corners = expr.and_then(|expr| outline::corners(cx, expr));
        let bottom = self.quantity(cx, &table::BOTTOM, "bottom = 0 m");
        let top = self.quantity(cx, &table::TOP, "top = 20 m");
        let (expr, corners, bottom, top) = (expr?, corners?, bottom?, top?);
        if bottom >= top {
            let span = self.fields.span_of("top").unwrap_or(self.fields.span);
            let error = Diagnostic::error(SIZE, span, "`top` must be above `bottom`");
            cx.report(error.here(format!("{} m", number(top))).help(format!("write more than {} m", number(bottom))));
            return None;
        }
        let parts = outline::convex_parts(cx, expr, &corners)?;
        if self.side == Side::KeepIn && parts.len() > 1 {
            let error = Diagnostic::error(CORNERS, expr.span, "the polygon of a `keep_in` must be convex");
            let help =
                "use the convex outline as `keep_in`, and a `keep_out` for each bay that the vehicle must not enter";
            cx.report(error.here("has an inward corner").help(help));
            return None;
        }
        Some(parts.into_iter().map(|corners| Body::Prism { corners, bottom, top }).collect())
    }
}
