//! The `parts` block: reads it, and gives mass, centre of gravity and inertia from it.

use super::POSITIVE;
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::{part as of_part, parts as table, vehicle};
use crate::model::{Composite, PartShape, Rotor, VehiclePart};
use crate::number::number;
use crate::read::context::{Context, duplicate};
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::source::Span;
use crate::syntax::ast::{Block, Name, Statement};

const CODE: &str = "mavc::vehicle::parts";

/// The most parts of a vehicle: far more than a builder weighs.
const MOST: usize = 1000;

/// What a `parts` block gives.
pub(super) struct Read {
    /// The parts with names.
    parts: Vec<VehiclePart>,
    /// The mass at each rotor's place, and that of the rod from the origin to it, kg.
    motor_mass: f64,
    arm_mass: f64,
    pub span: Span,
}

/// Reads the block of a vehicle, which messages call `owner`; `None` if it has errors.
pub(super) fn read<'a>(cx: &mut Context<'a>, block: &'a Block, owner: &str) -> Option<Read> {
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, format!("`parts` of {owner}"), span, &block.body, Group::Parts);
    let motor_mass = fields.quantity(cx, &table::MOTOR_MASS, POSITIVE).or_default(|| 0.0);
    let arm_mass = fields.quantity(cx, &table::ARM_MASS, POSITIVE).or_default(|| 0.0);
    let blocks: Vec<&'a Block> = block
        .body
        .iter()
        .filter_map(|statement| if let Statement::Block(inner) = statement { Some(inner) } else { None })
        .collect();
    if let Some(beyond) = blocks.get(MOST) {
        let error = Diagnostic::error(CODE, beyond.keyword.span, format!("a vehicle may have at most {MOST} parts"));
        cx.report(error.here("the limit is exceeded here").help("join parts that are near each other"));
        return None;
    }
    let mut parts = Some(Vec::new());
    let mut names: Vec<&Name> = Vec::new();
    for inner in &blocks {
        let mut found = one(cx, inner);
        if let Some(name) = &inner.name {
            if let Some(first) = names.iter().find(|first| first.value == name.value) {
                cx.report(duplicate("part", name, first.span));
                found = None;
            }
            names.push(name);
        }
        match (&mut parts, found) {
            (Some(list), Some(part)) => list.push(part),
            (list, _) => *list = None,
        }
    }
    let (parts, motor_mass, arm_mass) = (parts?, motor_mass?, arm_mass?);
    if !block.is_whole() {
        return None;
    }
    if parts.is_empty() && motor_mass + arm_mass == 0.0 {
        let error = Diagnostic::error(CODE, span, format!("`parts` of {owner} has no mass")).here("no part is in it");
        let example = "part battery { mass = 1.1 kg; at = [0, 0, -3] cm }";
        cx.report(error.help(format!("add the parts, such as `{example}`, or remove the block")));
        return None;
    }
    Some(Read { parts, motor_mass, arm_mass, span })
}

/// One `part`.
fn one<'a>(cx: &mut Context<'a>, block: &'a Block) -> Option<VehiclePart> {
    let (owner, span) = match &block.name {
        Some(name) => (format!("part `{}`", name.value), name.span),
        None => ("a part".into(), block.keyword.span),
    };
    let fields = Fields::of_block(cx, owner, span, &block.body, Group::Part);
    let mass = fields.demand_own(cx, "mass", "mass = 350 g");
    let mass = mass.and_then(|expr| cx.quantity(&of_part::MASS, expr, POSITIVE));
    let at = fields.demand_own(cx, "at", "at = [0, 0, -3] cm");
    let at = at.and_then(|expr| cx.triple(Expected::of(&of_part::AT), expr));
    let size = fields.written("size", |expr| {
        let sides = cx.triple(Expected::of(&of_part::SIZE), expr)?;
        let Some(bad) = sides.into_iter().find(|side| *side <= 0.0) else { return Some(sides) };
        let error = Diagnostic::error(POSITIVE, expr.span, "`size` must be greater than zero along every axis");
        cx.report(error.here(format!("contains {} m", number(bad))).help("write three lengths above zero"));
        None
    });
    let shape = size.optional().ok()?.map_or(PartShape::Point, PartShape::Box);
    block.is_whole().then_some(VehiclePart { mass: mass?, centre: at?, shape })
}

impl Read {
    /// What the parts make together, with the rotors (places from the frame's origin); `None`, which is reported, if
    /// that is beyond what a vehicle may be.
    pub fn composite(&self, cx: &mut Context, rotors: &[Rotor]) -> Option<Composite> {
        let mut parts = self.parts.clone();
        for rotor in rotors {
            let place = rotor.position;
            parts.push(VehiclePart { mass: self.motor_mass, centre: place, shape: PartShape::Point });
            let middle = place.map(|x| 0.5 * x);
            parts.push(VehiclePart { mass: self.arm_mass, centre: middle, shape: PartShape::Rod(place) });
        }
        let composite = Composite::of(&parts);
        let fits = cx.is_within_magnitude(Expected::of(&vehicle::MASS), composite.mass, self.span)
            && composite.moments().iter().all(|moment| {
                moment.is_finite() && cx.is_within_magnitude(Expected::of(&vehicle::INERTIA), *moment, self.span)
            });
        fits.then_some(composite)
    }

    /// The moments of inertia about the centre of gravity, of which none may be zero.
    pub fn inertia(&self, cx: &mut Context, composite: &Composite, owner: &str) -> Option<[f64; 3]> {
        let moments = composite.moments();
        let Some(axis) = moments.iter().position(|moment| *moment <= 0.0) else { return Some(moments) };
        let name = ["x", "y", "z"][axis];
        let message = format!("the parts of {owner} have no inertia about {name}");
        let error = Diagnostic::error(CODE, self.span, message).here("all parts are points on one line");
        cx.report(error.help("add the other parts, give them a `size`, or write the `inertia` of the vehicle"));
        None
    }
}
