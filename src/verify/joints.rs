//! Where pieces meet: what the gaps at all joints may move together.
//!
//! Let the gap of derivative i at joint k be `delta_i(k)`. The motion that starts like the one carried and has the same
//! inputs, without gaps, is apart from it in derivative j at time t by no more than
//!
//! `D_j(t) = sum over joints k before t, over i >= j, of |delta_i(k)| (t - t_k)^(i-j)/(i-j)!`,
//!
//! which grows with t, whatever the durations of pieces: a short piece buys nothing.

use super::Rejection;
use super::interval::{Interval, exceeds};
use super::motion::{Motion, X, Y, YAW, Z};
use crate::number::number;

/// Each derivative may jump by this at one joint: m, m/s, m/s^2, m/s^3; of yaw in rad.
pub const MOST_GAP: [f64; 4] = [1e-6, 1e-5, 1e-4, 1e-3];

/// Together the gaps move position, velocity, acceleration and jerk by no more than this, m, m/s, m/s^2, m/s^3; yaw and
/// its rate alike, in rad.
pub const MOST_MOVED: [f64; 4] = [1e-3, 1e-3, 1e-2, 1e-1];

const ORDINALS: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
const OF_YAW: [&str; 4] = ["yaw", "yaw rate", "", ""];
const UNITS: [&str; 4] = ["m", "m/s", "m/s^2", "m/s^3"];
const YAW_UNITS: [&str; 4] = ["rad", "rad/s", "", ""];

/// # Errors
/// A joint with too wide a gap, or gaps that move too much together.
pub(super) fn check(motion: &Motion) -> Result<(), Rejection> {
    let mut moved = [[Interval::ZERO; 4]; 4];
    for piece in 0..motion.pieces() {
        let gaps = motion.gaps(piece);
        for (axis, gaps) in gaps.iter().enumerate() {
            for (order, &gap) in gaps.iter().enumerate() {
                if exceeds(gap, MOST_GAP[order]) {
                    let (what, unit) = names(axis, order);
                    let why = format!(
                        "piece {} misses the next by {} {unit} in {what}, and at most {} {unit} is allowed",
                        piece + 1,
                        number(gap),
                        number(MOST_GAP[order])
                    );
                    let at = Some(motion.times[piece + 1]);
                    return Err(Rejection { at, ..Rejection::new("the joints of the motion", why) });
                }
            }
        }
        carry(&mut moved, motion.duration(piece));
        for (axis, gaps) in moved.iter_mut().zip(&gaps) {
            for (sum, &gap) in axis.iter_mut().zip(gaps) {
                *sum = *sum + Interval::point(gap);
            }
        }
    }
    together(&moved)
}

/// `D_j` after a piece without gaps of duration h: `sum over i >= j of D_i h^(i-j)/(i-j)!`.
fn carry(moved: &mut [[Interval; 4]; 4], h: Interval) {
    for axis in moved.iter_mut() {
        for j in 0..4 {
            axis[j] =
                (j..4).rev().fold(Interval::ZERO, |sum, i| axis[i] + h / Interval::point((i + 1 - j) as f64) * sum);
        }
    }
}

fn together(moved: &[[Interval; 4]; 4]) -> Result<(), Rejection> {
    for (order, &most) in MOST_MOVED.iter().enumerate() {
        let of_place = [X, Y, Z].iter().fold(Interval::ZERO, |sum, &axis| sum + moved[axis][order].square()).sqrt();
        for (axis, by) in [(X, of_place), (YAW, moved[YAW][order])] {
            if exceeds(by.high, most) {
                let (what, unit) = names(axis, order);
                let why = format!(
                    "together their gaps may move the {what} by {} {unit}, and at most {} {unit} is allowed",
                    number(by.high),
                    number(most)
                );
                return Err(Rejection::new("the joints of the motion", why));
            }
        }
    }
    Ok(())
}

fn names(axis: usize, order: usize) -> (&'static str, &'static str) {
    if axis == YAW { (OF_YAW[order], YAW_UNITS[order]) } else { (ORDINALS[order], UNITS[order]) }
}
