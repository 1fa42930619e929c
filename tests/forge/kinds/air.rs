//! Plans of another air: without drag, in another wind, in one wind of an interval.

use super::rows::easier;
use super::{Kind, evaluated, grown};
use crate::numbers::Numbers;
use crate::specs::{Easier, Spec};
use crate::truth::Falsehood;
use mavc::certificate::Certificate;
use mavc::model::LimitKind;
use mavc::motion::{X, Y};
use mavc::verify::Premise;

const SETS: &[Premise] = &[Premise::Sets];
const LIMITS: &[Premise] = &[Premise::Limits];

pub const KINDS: &[Kind] = &[
    evaluated("a plan without drag", SETS, |s, n| easier(s, n, Easier::NoDrag)),
    evaluated("a plan in another wind", SETS, |s, n| easier(s, n, Easier::OtherWind)),
    evaluated("a plan in one wind of an interval", SETS, |s, n| easier(s, n, Easier::OneWind)),
    evaluated("the tilt of a plan without drag", LIMITS, |s, n| tilted(s, n, Easier::NoDrag)),
    evaluated("the tilt of a plan in another wind", LIMITS, |s, n| tilted(s, n, Easier::OtherWind)),
    evaluated("the tilt of a plan in one wind", LIMITS, |s, n| tilted(s, n, Easier::OneWind)),
];

/// A motion that keeps the limit on tilt in an easier air, and not in the spec's.
fn tilted(spec: &Spec, numbers: &mut Numbers, how: Easier) -> Option<Certificate> {
    let (_, easy) = spec.easier.iter().find(|e| e.0 == how)?;
    let index = spec.truth.mission().limits.iter().position(|limit| limit.kind == LimitKind::Tilt)?;
    let axis = [X, Y][numbers.below(2)];
    let is_false = |found: Option<Falsehood>| found == Some(Falsehood::Limit(index));
    let motion = grown(spec, numbers, (axis, 2), |motion, found| is_false(found) && easy.of_plan(motion).is_none())?;
    Some(spec.claiming(&motion))
}
