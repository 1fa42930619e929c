//! Rows that are broken at a node: limits, sets, commands, the upright thrust; among them plans of easier specs.

use super::{Kind, Known, Make, evaluated, grown};
use crate::numbers::Numbers;
use crate::specs::{Easier, Spec};
use crate::truth::Falsehood;
use mavc::certificate::Certificate;
use mavc::model::{LimitKind, PlanModel};
use mavc::motion::{X, Y, YAW, Z};
use mavc::verify::Premise;

const LIMITS: &[Premise] = &[Premise::Limits];
const SETS: &[Premise] = &[Premise::Sets];

const fn limit(name: &'static str, make: Make) -> Kind {
    Kind { name, known: Known::Evaluated, premises: LIMITS, make }
}

pub const KINDS: &[Kind] = &[
    limit("limit on x exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::X))),
    limit("limit on y exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Y))),
    limit("limit on z exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Z))),
    limit("limit on yaw exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Yaw))),
    limit("limit on speed exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Speed))),
    limit("limit on horizontal speed exceeded", |s, n| {
        exceeded(s, n, |kind| matches!(kind, LimitKind::SpeedHorizontal))
    }),
    limit("limit on climb exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Climb))),
    limit("limit on descent exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Descent))),
    limit("limit on acceleration exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Acceleration))),
    limit("limit on horizontal acceleration exceeded", |s, n| {
        exceeded(s, n, |kind| matches!(kind, LimitKind::AccelerationHorizontal))
    }),
    limit("limit on jerk exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Jerk))),
    limit("limit on yaw rate exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::YawRate))),
    limit("limit on yaw acceleration exceeded", |s, n| {
        exceeded(s, n, |kind| matches!(kind, LimitKind::YawAcceleration))
    }),
    limit("limit on tilt exceeded", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Tilt))),
    limit("a keep-in left by its flat side", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Face(_)))),
    limit("a keep-in left by its round side", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Distance(_)))),
    limit("a keep-out entered", |s, n| exceeded(s, n, |kind| matches!(kind, LimitKind::Clearance(_)))),
    evaluated("a wrench outside the set", SETS, outside),
    evaluated("a RIP plan given as RCP's", SETS, |s, n| easier(s, n, Easier::RipInsteadOfRcp)),
    evaluated("a plan of a lighter vehicle", SETS, |s, n| easier(s, n, Easier::Lighter)),
    evaluated("a plan without the reserve", SETS, |s, n| easier(s, n, Easier::NoReserve)),
    evaluated("a plan against another mode", SETS, |s, n| easier(s, n, Easier::OtherMode)),
    evaluated("a plan of nominal numbers", SETS, |s, n| easier(s, n, Easier::Nominal)),
    evaluated("a plan without the pseudo-inverse", SETS, |s, n| easier(s, n, Easier::Bounded)),
    evaluated("a plan for rotors that may stop", SETS, |s, n| easier(s, n, Easier::StoppingRotors)),
    evaluated("a plan for instant rotors", &[Premise::Commands], |s, n| easier(s, n, Easier::Instant)),
    evaluated("a flat set left", SETS, |s, n| flat(s, n, [Y, YAW])),
    evaluated("beyond a flat set within its plane", SETS, |s, n| flat(s, n, [Z, X])),
    evaluated("less than a tenth of the weight", &[Premise::Upright], falling),
    evaluated("thrust that points down", &[Premise::Upright], diving),
];

fn exceeded(spec: &Spec, numbers: &mut Numbers, is_kind: fn(&LimitKind) -> bool) -> Option<Certificate> {
    let limits = &spec.truth.mission().limits;
    let of_kind: Vec<usize> = (0..limits.len()).filter(|&i| is_kind(&limits[i].kind)).collect();
    // Several volumes have limits of one kind.
    let nth = if of_kind.len() > 1 { numbers.below(of_kind.len()) } else { 0 };
    let index = *of_kind.get(nth)?;
    let horizontal = [X, Y][numbers.below(2)];
    let any = [X, Y, Z][numbers.below(3)];
    let along = match limits[index].kind {
        LimitKind::X => (X, 0),
        LimitKind::Y => (Y, 0),
        LimitKind::Z => (Z, 0),
        LimitKind::Yaw | LimitKind::Heading(_) => (YAW, 0),
        LimitKind::YawRate => (YAW, 1),
        LimitKind::YawAcceleration => (YAW, 2),
        LimitKind::Climb | LimitKind::Descent => (Z, 1),
        LimitKind::Speed => (any, 1),
        LimitKind::SpeedHorizontal => (horizontal, 1),
        LimitKind::Acceleration => (any, 2),
        LimitKind::AccelerationHorizontal | LimitKind::Tilt => (horizontal, 2),
        LimitKind::Jerk => (horizontal, 3),
        LimitKind::Face(_) | LimitKind::Distance(_) | LimitKind::Clearance(_) => (any, 0),
        LimitKind::Arrival(_) => (any, 1),
    };
    let motion = grown(spec, numbers, along, |_, found| found == Some(Falsehood::Limit(index)))?;
    Some(spec.claiming(&motion))
}

fn outside(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let axis = super::axis(numbers);
    let motion = grown(spec, numbers, (axis, 2), |_, found| found == Some(Falsehood::Set))?;
    Some(spec.claiming(&motion))
}

/// A motion that is a plan where one thing is easier, and not of the spec.
pub fn easier(spec: &Spec, numbers: &mut Numbers, how: Easier) -> Option<Certificate> {
    let (_, easy) = spec.easier.iter().find(|e| e.0 == how)?;
    let axis = super::axis(numbers);
    let fits = |found: Option<Falsehood>| matches!(found, Some(Falsehood::Set | Falsehood::Commands));
    let motion = grown(spec, numbers, (axis, 2), |motion, found| fits(found) && easy.of_plan(motion).is_none())?;
    Some(spec.claiming(&motion))
}

/// Of a set in which yaw and roll torques are tied to each other; thrust and pitch torque are free.
fn flat(spec: &Spec, numbers: &mut Numbers, axes: [usize; 2]) -> Option<Certificate> {
    if !spec.is_flat() {
        return None;
    }
    let axis = axes[numbers.below(2)];
    let motion = grown(spec, numbers, (axis, 2), |_, found| found == Some(Falsehood::Set))?;
    Some(spec.claiming(&motion))
}

/// The exact model's thrust hardly up, or down.
fn falling(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    plunging(spec, numbers, 0.0)
}

fn diving(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    plunging(spec, numbers, 0.15)
}

/// Vertical acceleration of less than a tenth of the weight, less `more` of it again.
fn plunging(spec: &Spec, numbers: &mut Numbers, more: f64) -> Option<Certificate> {
    if spec.model().plan.model != PlanModel::Exact {
        return None;
    }
    let g = spec.model().gravity;
    let lowest = |motion: &mavc::motion::Trajectory| {
        motion.nodes.iter().map(|s| (s[Z][2] + g) / g).fold(f64::INFINITY, f64::min)
    };
    let order = spec.honest.model.orders()[Z];
    let first = numbers.below(spec.honest.nodes.len().checked_sub(order + 2)?);
    let mut motion = spec.honest.clone();
    let size = g * numbers.between(0.9 + more, 1.05 + more);
    crate::motion::add_spline(&mut motion, Z, first, 2, -size)?;
    let low = lowest(&motion);
    (low < 0.1 - more - 2e-3).then(|| spec.claiming(&motion))
}
