//! What the outputs alone say: a motor that is switched off or held at one value while the others work.

use super::fit::Effect;
use super::record::{Commands, MOTORS};
use nalgebra::{Matrix4, Vector4};
use std::ops::Range;

/// An output that follows no control while the others do.
#[derive(Debug, Clone, PartialEq)]
pub struct Frozen {
    /// From 0.
    pub motor: usize,
    /// s.
    pub from: f64,
    /// Share of full thrust at which it is.
    pub share: f64,
    /// Whether it is switched off.
    pub is_off: bool,
}

/// How long an output stays the same before it counts as frozen, s; and as switched off.
const HELD: f64 = 0.6;
const OFF: f64 = 0.15;
/// The fewest equal outputs that are not chance if the others move much, and if they move little.
const EQUAL: [usize; 2] = [8, 10];
/// The other outputs work if at least half of them move by this much of full thrust meanwhile; by so much more if one
/// is to be held, which may also rest for a moment.
const MOVING: f64 = 0.01;
const MOVING_MORE: f64 = 0.03;
/// A motor whose command follows from the others to more than this share of itself cannot be judged by them.
const OWN: f64 = 0.99;
/// Outputs within this share of no and of full thrust are saturated, and not frozen.
const SATURATED: f64 = 0.02;

/// The frozen stretches of each motor between two times (s), in their order: of several in which a motor is off only
/// the first. `commands` are those of [`study`](super::study::study).
pub fn frozen(
    times: &[f64],
    outputs: &[[f32; MOTORS]],
    commands: &Commands,
    range: [f64; 2],
    effects: &[Effect],
) -> Vec<Frozen> {
    let motors = effects.len();
    let [a, b] = range.map(|t| times.partition_point(|x| *x < t));
    let mut found: Vec<Frozen> = Vec::new();
    let value = |i: usize, motor: usize| outputs[i][motor];
    for motor in 0..motors {
        let (mut i, mut was_off) = (a, false);
        while i < b {
            let (share, is_off) = commands(i, motor);
            let same = |j: &usize| if is_off { commands(*j, motor).1 } else { value(*j, motor) == value(i, motor) };
            let end = (i..b).find(|j| !same(j)).unwrap_or(b).max(i + 1);
            let lasts = times[end - 1] - times[i];
            let is_held = lasts >= HELD && end - i >= EQUAL[0] && share > SATURATED && share < 1.0 - SATURATED;
            let works = |by: f64| works(commands, i..end, motor, motors, by);
            let is_asked = || {
                let by = if end - i >= EQUAL[1] { MOVING } else { MOVING_MORE };
                works(by) && is_asked(commands, i..end, motor, effects, by)
            };
            if is_off && !was_off && lasts >= OFF && works(MOVING) || is_held && is_asked() {
                found.push(Frozen { motor, from: times[i], share, is_off });
                was_off |= is_off;
            }
            i = end;
        }
    }
    found.sort_by(|x, y| x.from.total_cmp(&y.from));
    found
}

/// The difference of the largest and the least of some numbers.
fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    most - least
}

/// Whether at least half of the other motors move by so much meanwhile.
fn works(commands: &Commands, rows: Range<usize>, motor: usize, motors: usize, by: f64) -> bool {
    let others = (0..motors).filter(|k| *k != motor);
    let moving = others.filter(|k| spread(rows.clone().map(|i| commands(i, *k).0)) > by);
    2 * moving.count() >= motors - 1
}

/// Whether a mixer that commands the others what it does would move this motor by so much too: a step of pitch leaves
/// those beside the centre as they are. True if its command does not follow from the others'.
fn is_asked(commands: &Commands, rows: Range<usize>, motor: usize, effects: &[Effect], by: f64) -> bool {
    let all: Vec<Vector4<f64>> = effects.iter().map(|effect| Vector4::from(*effect)).collect();
    let normal: Matrix4<f64> = all.iter().map(|e| e * e.transpose()).sum();
    let Some(own) = normal.try_inverse().map(|inverse| inverse * all[motor]) else { return true };
    let share = own.dot(&all[motor]);
    let wanted = |row: usize| {
        let others = (0..all.len()).filter(|k| *k != motor);
        others.map(|k| own.dot(&all[k]) * commands(row, k).0).sum::<f64>() / (1.0 - share)
    };
    share > OWN || spread(rows.map(wanted)) > by
}
