//! Waypoints whose own tolerances are the narrowest, missed by less than the others': the first one, and one where a
//! rule begins.

use super::{Kind, evaluated, laid};
use crate::motion::Wish;
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::model::{Heading, Waypoint};
use mavc::verify::Premise;

const WAYPOINTS: &[Premise] = &[Premise::Waypoints];
const LIMITS: &[Premise] = &[Premise::Limits];

pub const KINDS: &[Kind] = &[
    evaluated("a narrow waypoint missed by what others allow", WAYPOINTS, place),
    evaluated("a narrow yaw missed by what others allow", WAYPOINTS, given),
    evaluated("a narrow yaw at the start that follows from the motion", LIMITS, |s, n| following(s, n, true)),
    evaluated("a narrow yaw where a rule begins", LIMITS, |s, n| following(s, n, false)),
];

/// Waypoints whose tolerance is narrower than that of the next one, with both tolerances.
fn narrow(spec: &Spec, of: fn(&Waypoint) -> f64) -> Vec<(usize, f64, f64)> {
    let points = &spec.truth.mission().waypoints;
    let both = (0..points.len() - 1).map(|i| (i, of(&points[i]), of(&points[i + 1])));
    both.filter(|(_, own, next)| *next > own + 2e-3).collect()
}

fn place(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let (waypoint, own, next) = *numbers.pick(&narrow(spec, |w| w.within))?;
    let direction: [f64; 3] = std::array::from_fn(|_| numbers.between(-1.0, 1.0));
    let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt().max(1e-3);
    let off = numbers.between(own + 2e-4, next);
    let mut wish = Wish::of(spec.truth.mission());
    wish.places[waypoint].iter_mut().zip(direction).for_each(|(p, d)| *p += off * d / length);
    laid(spec, &wish)
}

/// A yaw off by more than the waypoint's own tolerance and less than the next one's.
fn off(spec: &Spec, numbers: &mut Numbers, wanted: impl Fn(usize) -> bool) -> Option<Certificate> {
    let found: Vec<_> = narrow(spec, |w| w.yaw_within).into_iter().filter(|(i, ..)| wanted(*i)).collect();
    let (waypoint, own, next) = *numbers.pick(&found)?;
    let mut wish = Wish::of(spec.truth.mission());
    wish.places[waypoint][3] += numbers.sign() * numbers.between(own + 1.2e-3, 0.95 * next);
    laid(spec, &wish)
}

fn given(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let points = &spec.truth.mission().waypoints;
    off(spec, numbers, |i| points[i].heading == Heading::Given)
}

fn following(spec: &Spec, numbers: &mut Numbers, at_start: bool) -> Option<Certificate> {
    let points = &spec.truth.mission().waypoints;
    let begins = |i: usize| i == 0 || points[i - 1].heading != points[i].heading;
    off(spec, numbers, |i| points[i].heading != Heading::Given && begins(i) && (i == 0) == at_start)
}
