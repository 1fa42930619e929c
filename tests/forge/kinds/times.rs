//! Another schedule than the spec's.

use super::{Kind, evaluated};
use crate::motion::{Timetable, Wish, evenly, holds, split};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::model::grid::leg_durations;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("a waypoint early or late", &[Premise::Times], moved_between_legs),
    evaluated("a hold cut short", &[Premise::Times], short_hold),
    evaluated("another mission time", &[Premise::Times], other_total),
    evaluated("a late beginning", &[Premise::Times], late),
    evaluated("on after the last waypoint", &[Premise::Times], onwards),
];

/// A motion with these holds and durations of the legs, as finely cut as the spec asks for.
fn timed(spec: &Spec, holds: &[f64], durations: &[f64]) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let counts = mavc::model::grid::pieces(mission, durations, spec.model().plan.samples);
    let even: Vec<Vec<f64>> = counts.iter().map(|&n| evenly(n)).collect();
    let table = Timetable::of(holds, durations, &even);
    let wish = Wish { held: holds.iter().map(|&h| h > 0.0).collect(), ..Wish::of(mission) };
    Some(spec.claiming(&wish.motion(&table, spec.truth.equations)?))
}

fn moved_between_legs(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let mut durations = leg_durations(mission, spec.total())?;
    if durations.len() < 2 {
        return None;
    }
    let leg = numbers.below(durations.len() - 1);
    let by = numbers.sign() * durations[leg].min(durations[leg + 1]) * numbers.magnitude(1e-6, 0.3);
    durations[leg] += by;
    durations[leg + 1] -= by;
    timed(spec, &holds(mission), &durations)
}

fn short_hold(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    let (mut waits, mut durations) = (holds(mission), leg_durations(mission, spec.total())?);
    let held: Vec<usize> = (0..durations.len()).filter(|&i| waits[i] > 0.0).collect();
    let waypoint = *numbers.pick(&held)?;
    let by = waits[waypoint] * numbers.magnitude(1e-6, 0.99);
    waits[waypoint] -= by;
    // The rest goes to the leg before, or after.
    let leg = if waypoint > 0 && numbers.below(2) == 0 { waypoint - 1 } else { waypoint };
    durations[leg] += by;
    timed(spec, &waits, &durations)
}

fn other_total(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.has_one_grid() {
        return None;
    }
    let mission = spec.truth.mission();
    let total = spec.total() * (1.0 + numbers.sign() * numbers.magnitude(1e-6, 0.4));
    timed(spec, &holds(mission), &leg_durations(mission, total)?)
}

/// All times shifted: the mission does not begin at 0.
fn late(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut motion = spec.honest.clone();
    let mission = spec.truth.mission();
    let last = motion.times.len() - 1;
    if spec.has_one_grid() || mission.waypoints.iter().any(|w| w.time.is_some()) || numbers.below(2) == 0 {
        // The first node alone.
        let by = numbers.magnitude(1e-7, 1e-2);
        split(&mut motion, 0, 1);
        motion.times[0] -= by;
        return Some(spec.claiming(&motion));
    }
    let by = numbers.sign() * numbers.magnitude(1e-6, 10.0);
    motion.times[..=last].iter_mut().for_each(|t| *t += by);
    Some(spec.claiming(&motion))
}

/// Standing still behind the last waypoint.
fn onwards(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut motion = spec.honest.clone();
    if !spec.truth.mission().end_at_rest {
        return None;
    }
    let (end, mut node) = (motion.times[motion.times.len() - 1], motion.nodes[motion.nodes.len() - 1]);
    // At rest with inputs of zero from here on; the input leaps over a piece of no duration to speak of.
    node[0][4] = 0.0;
    node[1][4] = 0.0;
    for (axis, order) in crate::motion::AXES.into_iter().zip(motion.model.orders()) {
        node[axis][order] = 0.0;
    }
    for by in [1e-9, numbers.magnitude(1e-3, 10.0)] {
        motion.times.push(end + by);
        motion.nodes.push(node);
    }
    Some(spec.claiming(&motion))
}
