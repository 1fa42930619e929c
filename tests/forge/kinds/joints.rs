//! Pieces that do not meet.

use super::{Kind, evaluated};
use crate::motion::{AXES, Timetable, Wish, split};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, Z};
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("one gap in position or yaw", &[Premise::Joints], |s, n| one_gap(s, n, 0)),
    evaluated("one gap in velocity or yaw rate", &[Premise::Joints], |s, n| one_gap(s, n, 1)),
    evaluated("one gap in acceleration", &[Premise::Joints], |s, n| one_gap(s, n, 2)),
    evaluated("one gap in jerk", &[Premise::Joints], |s, n| one_gap(s, n, 3)),
    evaluated("small gaps that add up", &[Premise::Joints], many_gaps),
    evaluated("tiny pieces at the ends", &[Premise::Joints], tiny_ends),
    evaluated("a leap over a tiny piece", &[Premise::Joints], leap),
];

/// Shifts one derivative at one node by ten tolerances or more.
fn one_gap(spec: &Spec, numbers: &mut Numbers, derivative: usize) -> Option<Certificate> {
    let mut motion = spec.honest.clone();
    let axis = super::axis(numbers);
    if derivative >= motion.model.orders()[axis] {
        return None;
    }
    let node = 1 + numbers.below(motion.nodes.len() - 2);
    let tolerance = 1e-6 * 10f64.powi(derivative as i32);
    // Waypoints and limits forgive some of it, so that joints alone stand in the way.
    motion.nodes[node][axis][derivative] += numbers.sign() * tolerance * numbers.magnitude(11.0, 1e4);
    Some(spec.claiming(&motion))
}

/// Gaps below the tolerance of one joint, with signs under which they cancel in the end (Prouhet, Thue, Morse), on
/// pieces of one duration.
fn many_gaps(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut motion = spec.honest.clone();
    let axis = super::axis(numbers);
    let derivative = 1 + numbers.below(motion.model.orders()[axis] - 1);
    let leg = numbers.below(spec.truth.mission().legs.len());
    let (mut from, to) = (motion.waypoint_nodes[leg], motion.waypoint_nodes[leg + 1]);
    // A hold comes before the leg.
    from += usize::from(spec.truth.mission().waypoints[leg].hold > 0.0);
    let more = [19, 9, 3, 1][derivative] << numbers.below(2);
    for piece in (from..to).rev() {
        split(&mut motion, piece, more);
    }
    let count = (to - from) * (more + 1);
    let block = 1 << (derivative + 1);
    let h = motion.times[from + 1] - motion.times[from];
    let gap = numbers.between(0.5, 0.95) * 1e-6 * 10f64.powi(derivative as i32);
    let mut drift = [0.0; 5];
    for k in 0..count / block * block {
        let sign = if ((k % block) as u32).count_ones().is_multiple_of(2) { 1.0 } else { -1.0 };
        drift = carried(&drift, h, derivative);
        drift[derivative] += sign * gap;
        let node = from + 1 + k;
        // What rests or waits stays exactly so.
        if k + 1 < count / block * block && node < from + count {
            for (own, by) in motion.nodes[node][axis].iter_mut().zip(&drift[..=derivative]) {
                *own += by;
            }
        }
    }
    Some(spec.claiming(&motion))
}

fn carried(drift: &[f64; 5], h: f64, highest: usize) -> [f64; 5] {
    let mut next = [0.0; 5];
    for (i, value) in next.iter_mut().enumerate().take(highest + 1) {
        let mut power = 1.0;
        for (n, by) in drift[i..=highest].iter().enumerate() {
            power *= if n == 0 { 1.0 } else { h / n as f64 };
            *value += by * power;
        }
    }
    next
}

/// A motion that neither starts nor ends at rest, with a tiny piece at each end over which it stops: its gaps times
/// powers of the piece's duration are nothing.
fn tiny_ends(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mission = spec.truth.mission();
    if !mission.start_at_rest || !mission.end_at_rest {
        return None;
    }
    let table = Timetable::asked(spec.model(), spec.total())?;
    let wish = Wish { start_at_rest: false, end_at_rest: false, ..Wish::of(mission) };
    let mut motion = wish.motion(&table, spec.truth.equations)?;
    let tiny = numbers.magnitude(1e-12, 1e-4);
    let last = motion.nodes.len() - 1;
    let [start, end] = [0, last].map(|node| stopped(motion.nodes[node], motion.model));
    // The moving ends stay, each a moment from its end of the motion.
    motion.nodes.insert(0, start);
    motion.times.insert(1, tiny);
    motion.nodes.push(end);
    motion.times.insert(last + 1, motion.times[last + 1] - tiny);
    motion.waypoint_nodes.iter_mut().skip(1).for_each(|n| *n += if *n == last { 2 } else { 1 });
    Some(spec.claiming(&motion))
}

fn stopped(mut state: NodeState, model: WrenchModel) -> NodeState {
    for (axis, order) in AXES.into_iter().zip(model.orders()) {
        state[axis][1..=order.min(3)].fill(0.0);
    }
    state
}

/// Two copies of a node a moment apart; between them the motion leaps to another place, where it stays for some nodes.
fn leap(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut motion: Trajectory = spec.honest.clone();
    let from = 1 + numbers.below(motion.nodes.len() - 3);
    let to = (from + 1 + numbers.below(4)).min(motion.nodes.len() - 2);
    if motion.waypoint_nodes.iter().any(|&n| (from..=to).contains(&n)) {
        return None;
    }
    let axis = [X, Y, Z][numbers.below(3)];
    let by = numbers.sign() * numbers.magnitude(0.01, 1.0);
    motion.nodes[from..=to].iter_mut().for_each(|s| s[axis][0] += by);
    let tiny = numbers.magnitude(1e-12, 1e-6);
    motion.nodes.insert(from, spec.honest.nodes[from]);
    let time = motion.times[from] - tiny;
    motion.times.insert(from, time);
    motion.waypoint_nodes.iter_mut().filter(|n| **n >= from).for_each(|n| *n += 1);
    Some(spec.claiming(&motion))
}
