//! What the outputs alone say: a motor that is switched off or held at one value while the others work.

use super::record::{Commands, MOTORS};

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
/// The other outputs work if at least half of them move by this much of full thrust meanwhile.
const MOVING: f64 = 0.01;
/// Outputs within this share of no and of full thrust are saturated, and not frozen.
const SATURATED: f64 = 0.02;

/// The frozen stretches of each motor between two times (s), in their order: of several in which a motor is off only
/// the first. `commands` are those of [`study`](super::study::study).
pub fn frozen(
    times: &[f64],
    outputs: &[[f32; MOTORS]],
    commands: &Commands,
    range: [f64; 2],
    motors: usize,
) -> Vec<Frozen> {
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
            let is_held = lasts >= HELD && share > SATURATED && share < 1.0 - SATURATED;
            if (is_off && !was_off && lasts >= OFF || is_held) && works(commands, i..end, motor, motors) {
                found.push(Frozen { motor, from: times[i], share, is_off });
                was_off |= is_off;
            }
            i = end;
        }
    }
    found.sort_by(|x, y| x.from.total_cmp(&y.from));
    found
}

/// Whether at least half of the other motors move meanwhile.
fn works(commands: &Commands, rows: std::ops::Range<usize>, motor: usize, motors: usize) -> bool {
    let moving = (0..motors).filter(|k| *k != motor).filter(|k| {
        let of = || rows.clone().map(|i| commands(i, *k).0);
        of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min) > MOVING
    });
    2 * moving.count() >= motors - 1
}
