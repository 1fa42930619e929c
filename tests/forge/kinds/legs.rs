//! Legs: off their lines, beyond their own limits, through a stop, with a yaw or a direction that does not follow.

use super::{Kind, evaluated, grown};
use crate::motion::{Timetable, Wish, add_spline};
use crate::numbers::Numbers;
use crate::specs::Spec;
use crate::truth::Falsehood;
use mavc::certificate::Certificate;
use mavc::model::{Limit, LimitKind};
use mavc::motion::{X, Y, YAW, Z};
use mavc::verify::Premise;

const LIMITS: &[Premise] = &[Premise::Limits];
const REST: &[Premise] = &[Premise::Rest];

pub const KINDS: &[Kind] = &[
    evaluated("off a straight leg", LIMITS, |s, n| off(s, n, "straight leg")),
    evaluated("off a vertical leg", LIMITS, |s, n| off(s, n, "vertical leg")),
    evaluated("out of a corridor", LIMITS, |s, n| off(s, n, "corridor")),
    evaluated("a leg's own limit exceeded", LIMITS, own_limit),
    evaluated("a direction of arrival missed", LIMITS, |s, n| off(s, n, "direction of arrival")),
    evaluated("a yaw that does not point to its goal", LIMITS, |s, n| off(s, n, "yaw on the leg")),
    evaluated("flying through a stop", REST, through),
    evaluated("creeping through a stop", REST, creeping),
];

/// A motion that grows until it is false by one of the limits that are `wanted`.
fn beyond(
    spec: &Spec,
    numbers: &mut Numbers,
    wanted: impl Fn(&Limit) -> bool,
    along: (usize, usize),
) -> Option<Certificate> {
    let limits = &spec.truth.mission().limits;
    if !limits.iter().any(&wanted) {
        return None;
    }
    let is_wanted = |found: Option<Falsehood>| match found {
        Some(Falsehood::Limit(index)) => wanted(&limits[index]),
        _ => false,
    };
    let motion = grown(spec, numbers, along, |_, found| is_wanted(found))?;
    Some(spec.claiming(&motion))
}

/// A limit of a leg whose name begins with `name` is exceeded.
fn off(spec: &Spec, numbers: &mut Numbers, name: &str) -> Option<Certificate> {
    let any = [X, Y, Z][numbers.below(3)];
    let along = match name {
        "direction of arrival" => (any, 1),
        "yaw on the leg" => (YAW, 0),
        _ => (any, 0),
    };
    beyond(spec, numbers, |limit| limit.leg.as_ref().is_some_and(|on| on.name.starts_with(name)), along)
}

/// A speed that other legs may have.
fn own_limit(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let any = [X, Y, Z][numbers.below(3)];
    let is_own = |limit: &Limit| {
        let is_speed = matches!(limit.kind, LimitKind::Speed | LimitKind::Climb);
        is_speed && limit.leg.is_some()
    };
    beyond(spec, numbers, is_own, (any, 1))
}

/// The motion of least snap without the stops.
fn through(spec: &Spec, _: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let wish = Wish { stops: vec![false; mission.waypoints.len()], ..Wish::of(mission) };
    let table = Timetable::asked(spec.model(), spec.total())?;
    let is_there = mission.waypoints.iter().any(|w| w.stop);
    is_there.then(|| Some(spec.claiming(&wish.motion(&table, spec.truth.equations)?)))?
}

/// A spline about the node of a stop, where it moves a little.
fn creeping(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let points = &spec.truth.mission().waypoints;
    let stops: Vec<usize> = (0..points.len()).filter(|&i| points[i].stop).collect();
    let node = spec.honest.waypoint_nodes[*numbers.pick(&stops)?];
    let mut motion = spec.honest.clone();
    let axis = super::axis(numbers);
    let inside = motion.model.orders()[axis] + 1;
    let first = node.checked_sub(1 + numbers.below(inside))?;
    add_spline(&mut motion, axis, first, 1, numbers.sign() * numbers.magnitude(1e-5, 1e-2))?;
    Some(spec.claiming(&motion))
}
