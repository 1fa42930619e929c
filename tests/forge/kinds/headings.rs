//! Yaws that follow from the motion, and directions of arrival: nearly opposite, and just beyond the tolerance.

use super::{Kind, evaluated, laid, moved};
use crate::motion::Wish;
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::model::{Heading, LimitKind};
use mavc::motion::YAW;
use mavc::verify::Premise;
use std::f64::consts::PI;

const LIMITS: &[Premise] = &[Premise::Limits];

pub const KINDS: &[Kind] = &[
    evaluated("a yaw nearly opposite to its goal", LIMITS, |s, n| opposite(s, n, is_towards)),
    evaluated("a yaw nearly opposite to the path", LIMITS, |s, n| opposite(s, n, is_along)),
    evaluated("a yaw just off its goal", LIMITS, |s, n| just_off(s, n, is_towards)),
    evaluated("a yaw just off the path", LIMITS, |s, n| just_off(s, n, is_along)),
    evaluated("a yaw that turns round once", LIMITS, round),
    evaluated("an arrival flown backwards", LIMITS, backwards),
    evaluated("an arrival flown sideways", LIMITS, sideways),
];

fn is_towards(heading: &Heading) -> bool {
    matches!(heading, Heading::Towards(_))
}

fn is_along(heading: &Heading) -> bool {
    *heading == Heading::AlongPath
}

/// Whether the yaw of every waypoint follows from the motion by one rule.
fn follows(spec: &Spec, rule: fn(&Heading) -> bool) -> bool {
    spec.truth.mission().waypoints.iter().all(|point| rule(&point.heading))
}

/// The honest motion with its yaw turned throughout.
fn turned(spec: &Spec, by: f64) -> Option<Certificate> {
    let mut wish = Wish::of(spec.truth.mission());
    wish.places.iter_mut().for_each(|place| place[3] += by);
    laid(spec, &wish)
}

/// Off by 180 degrees less an angle of any size, whole turns apart.
fn opposite(spec: &Spec, numbers: &mut Numbers, rule: fn(&Heading) -> bool) -> Option<Certificate> {
    if !follows(spec, rule) {
        return None;
    }
    let short = [0.0, numbers.magnitude(1e-12, 1e-3), numbers.magnitude(1e-3, 0.15)][numbers.below(3)];
    let turns = [0.0, 0.0, 1.0, -1.0][numbers.below(4)];
    turned(spec, numbers.sign() * (PI - short) + turns * 2.0 * PI)
}

/// Just beyond the widest tolerance of any waypoint, or beyond it and less than opposite.
fn just_off(spec: &Spec, numbers: &mut Numbers, rule: fn(&Heading) -> bool) -> Option<Certificate> {
    if !follows(spec, rule) {
        return None;
    }
    let widest = spec.truth.mission().waypoints.iter().map(|w| w.yaw_within).fold(0.0, f64::max);
    let off = widest + numbers.magnitude(1.1e-3, 3.0);
    (off < PI).then(|| turned(spec, numbers.sign() * off))?
}

/// The right way at both ends, and round once between them.
fn round(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !follows(spec, is_towards) && !follows(spec, is_along) {
        return None;
    }
    let mut wish = Wish::of(spec.truth.mission());
    let last = wish.places.len() - 1;
    let from = numbers.below(last);
    let turn = numbers.sign() * 2.0 * PI;
    wish.places[from + 1..].iter_mut().for_each(|place| place[3] += turn);
    let motion = moved(spec, &wish)?;
    let is_round = motion.nodes.iter().any(|s| (s[YAW][0] - wish.places[from][3]).cos() < 0.0);
    is_round.then(|| spec.claiming(&motion))
}

/// A waypoint with a direction of arrival, and this direction.
fn arrival(spec: &Spec) -> Option<(usize, [f64; 3])> {
    spec.truth.mission().limits.iter().find_map(|limit| match limit.kind {
        LimitKind::Arrival(direction) => Some((limit.leg.as_deref()?.leg + 1, direction)),
        _ => None,
    })
}

/// The motion of least snap with this velocity at the waypoint, m/s.
fn arriving(spec: &Spec, waypoint: usize, velocity: [f64; 3]) -> Option<Certificate> {
    let mut wish = Wish::of(spec.truth.mission());
    wish.velocities.push((waypoint, velocity));
    laid(spec, &wish)
}

fn backwards(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let (waypoint, direction) = arrival(spec)?;
    let speed = numbers.magnitude(0.02, 2.0);
    let aside = if numbers.below(2) == 0 { 0.0 } else { speed * numbers.magnitude(1e-9, 0.05) };
    arriving(spec, waypoint, std::array::from_fn(|i| -speed * direction[i] + aside * numbers.between(-1.0, 1.0)))
}

fn sideways(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let (waypoint, direction) = arrival(spec)?;
    let [x, y, z] = direction;
    // At right angles to the direction, and to the vertical unless the direction is vertical.
    let across = if x.hypot(y) > 0.1 { [-y, x, 0.0] } else { [z, 0.0, -x] };
    let (speed, ahead) = (numbers.sign() * numbers.magnitude(0.02, 2.0), numbers.between(-1.0, 1.0));
    arriving(spec, waypoint, std::array::from_fn(|i| speed * across[i] + ahead * direction[i]))
}
