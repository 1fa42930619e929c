//! Volumes whose polygon has many corners, or inward ones.

use super::{Kind, evaluated, grown};
use crate::numbers::Numbers;
use crate::specs::Spec;
use crate::truth::Outline;
use mavc::certificate::Certificate;
use mavc::motion::{X, Y};
use mavc::verify::Premise;

const LIMITS: &[Premise] = &[Premise::Limits];

pub const KINDS: &[Kind] = &[
    evaluated("into a keep-out of many corners", LIMITS, |s, n| past(s, n, |o| !o.keep_in && !has_inward_corners(o))),
    evaluated("into a keep-out with inward corners", LIMITS, |s, n| {
        past(s, n, |o| !o.keep_in && has_inward_corners(o))
    }),
    evaluated("out of a keep-in of many corners", LIMITS, |s, n| past(s, n, |o| o.keep_in)),
];

/// The corners are in counter-clockwise order.
fn has_inward_corners(outline: &Outline) -> bool {
    let n = outline.corners.len();
    (0..n).any(|i| {
        let [a, b, c] = [i, (i + 1) % n, (i + 2) % n].map(|k| outline.corners[k]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) < 0.0
    })
}

/// A motion that grows until it is past one of the outlines that are `wanted`.
fn past(spec: &Spec, numbers: &mut Numbers, wanted: fn(&Outline) -> bool) -> Option<Certificate> {
    let outlines = spec.truth.outlines.iter().enumerate();
    let found: Vec<usize> = outlines.filter(|(_, (outline, _))| wanted(outline)).map(|(i, _)| i).collect();
    let index = *numbers.pick(&found)?;
    let axis = [X, Y][numbers.below(2)];
    let motion = grown(spec, numbers, (axis, 0), |motion, found| found.is_some() && spec.truth.is_past(motion, index))?;
    Some(spec.claiming(&motion))
}
