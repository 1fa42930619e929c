//! Motion where there should be none, and waypoints that are missed.

use super::{Kind, evaluated, laid};
use crate::motion::{Wish, add_spline, split};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("not at rest at an end", &[Premise::Rest], moving_end),
    evaluated("not still in a hold", &[Premise::Rest], stirring),
    evaluated("flying through a hold", &[Premise::Rest], through),
    evaluated("a waypoint missed", &[Premise::Waypoints], missed),
    evaluated("a yaw missed", &[Premise::Waypoints], turned),
];

fn moving_end(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let mut wish = Wish::of(mission);
    match numbers.below(3) {
        0 => wish.start_at_rest = false,
        1 => wish.end_at_rest = false,
        _ => (wish.start_at_rest, wish.end_at_rest) = (false, false),
    }
    laid(spec, &wish)
}

/// A loop within the hold, which ends where it began.
fn stirring(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let held: Vec<usize> = (0..mission.waypoints.len()).filter(|&i| mission.waypoints[i].hold > 0.0).collect();
    let waypoint = *numbers.pick(&held)?;
    let mut motion = spec.honest.clone();
    let node = motion.waypoint_nodes[waypoint];
    split(&mut motion, node, 9);
    let axis = super::axis(numbers);
    let first = node + numbers.below(10 - motion.model.orders()[axis] - 1);
    add_spline(&mut motion, axis, first, 2, numbers.sign() * numbers.magnitude(1e-4, 0.1))?;
    Some(spec.claiming(&motion))
}

/// At the right place when the hold begins, and still moving.
fn through(spec: &Spec, _: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let wish = Wish { held: vec![false; mission.waypoints.len()], ..Wish::of(mission) };
    mission.waypoints.iter().any(|w| w.hold > 0.0).then(|| laid(spec, &wish))?
}

fn missed(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let mut wish = Wish::of(mission);
    let waypoint = numbers.below(wish.places.len());
    let direction: [f64; 3] = std::array::from_fn(|_| numbers.between(-1.0, 1.0));
    let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt().max(1e-3);
    let by = mission.waypoints[waypoint].within + 1e-5 * numbers.magnitude(11.0, 3e4);
    wish.places[waypoint].iter_mut().zip(direction).for_each(|(p, d)| *p += by * d / length);
    laid(spec, &wish)
}

fn turned(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let mut wish = Wish::of(mission);
    let waypoint = numbers.below(wish.places.len());
    let by = mission.waypoints[waypoint].yaw_within + 1e-5 * numbers.magnitude(11.0, 1e4);
    wish.places[waypoint][3] += numbers.sign() * by;
    laid(spec, &wish)
}
