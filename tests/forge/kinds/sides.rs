//! Limits whose two sides differ, read as if both were one of them.

use super::least_time::{due_too_early, with_least_time};
use super::witness::{claiming, of_harder};
use super::{Kind, evaluated, grown, sooner, unfounded};
use crate::numbers::Numbers;
use crate::specs::{Harder, Spec};
use crate::truth::Falsehood;
use mavc::certificate::Certificate;
use mavc::model::{Limit, LimitKind};
use mavc::motion::{Trajectory, YAW};
use mavc::verify::Premise;

const LIMITS: &[Premise] = &[Premise::Limits];

pub const KINDS: &[Kind] = &[
    sooner("a least time by the other side of a limit", least),
    sooner("no time by the other side of a limit", too_early),
    unfounded("multipliers of the other side of a limit", &[], |s, _| {
        Some(claiming(s, of_harder(s, Harder::NarrowSides)?))
    }),
    evaluated("beyond the narrow side of a yaw rate", LIMITS, |s, n| beyond(s, n, LimitKind::YawRate, true)),
    evaluated("beyond the wide side of a yaw rate", LIMITS, |s, n| beyond(s, n, LimitKind::YawRate, false)),
    evaluated("beyond the narrow side of a yaw acceleration", LIMITS, |s, n| {
        beyond(s, n, LimitKind::YawAcceleration, true)
    }),
    evaluated("beyond the wide side of a yaw acceleration", LIMITS, |s, n| {
        beyond(s, n, LimitKind::YawAcceleration, false)
    }),
];

/// A limit on the yaw with two sides that differ, and its index.
fn uneven<'s>(spec: &'s Spec, kind: &LimitKind) -> Option<(usize, &'s Limit)> {
    let is_one = |limit: &Limit| limit.kind == *kind && limit.lower.zip(limit.upper).is_some_and(|(l, u)| l != -u);
    spec.truth.mission().limits.iter().enumerate().find(|(_, limit)| is_one(limit))
}

/// Between the honest arrival and the time that the narrow side of the rate would need for the turn.
fn bound(spec: &Spec, numbers: &mut Numbers, waypoint: usize) -> Option<f64> {
    let (_, limit) = uneven(spec, &LimitKind::YawRate)?;
    let points = &spec.truth.mission().waypoints;
    let turn = (points[waypoint].yaw - points[0].yaw).abs() - points[0].yaw_within - points[waypoint].yaw_within;
    let narrow = limit.upper?.abs().min(limit.lower?.abs());
    let reached = 1.002 * spec.honest.times[spec.honest.waypoint_nodes[waypoint]];
    (turn / narrow > reached).then(|| numbers.between(reached, turn / narrow))
}

fn least(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let bound = bound(spec, numbers, spec.honest.waypoint_nodes.len() - 1)?;
    with_least_time(spec, bound)
}

fn too_early(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let waypoint = 1 + numbers.below(spec.honest.waypoint_nodes.len() - 1);
    let soonest_s = bound(spec, numbers, waypoint)?;
    Some(due_too_early(spec, waypoint, soonest_s))
}

/// A motion beyond one side, for the narrow one within what the other side allows.
fn beyond(spec: &Spec, numbers: &mut Numbers, kind: LimitKind, narrow: bool) -> Option<Certificate> {
    let (index, limit) = uneven(spec, &kind)?;
    let (lower, upper) = (limit.lower?, limit.upper?);
    let derivative = if kind == LimitKind::YawRate { 1 } else { 2 };
    let passes = |motion: &Trajectory| {
        let values = motion.nodes.iter().map(|s| s[YAW][derivative]);
        let (least, most) = values.fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        let by_upper = most > upper;
        let wide = lower.abs().max(upper);
        let is_narrow = by_upper == (upper < -lower);
        is_narrow == narrow && (!narrow || most.max(-least) < wide)
    };
    let is_false = |found: Option<Falsehood>| found == Some(Falsehood::Limit(index));
    let motion = grown(spec, numbers, (YAW, derivative), |motion, found| is_false(found) && passes(motion))?;
    Some(spec.claiming(&motion))
}
