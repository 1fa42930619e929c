//! Joints between pieces: a bound on the combined effect of all gaps.
//!
//! Let the gap of derivative i at joint k be `delta_i(k)`. The motion with the same start and inputs but without gaps
//! differs from the one in the certificate in derivative j at time t by at most
//!
//! `D_j(t) = sum over joints k before t, over i >= j, of |delta_i(k)| (t - t_k)^(i-j)/(i-j)!`,
//!
//! which grows with t, whatever the durations of the pieces: short pieces do not allow larger gaps.

use super::Rejection;
use super::interval::{Interval, exceeds};
use super::motion::{Motion, X, Y, YAW, Z};
use crate::number::number;

/// Largest gap of each derivative at one joint: m, m/s, m/s^2, m/s^3; yaw in rad.
pub const MOST_GAP: [f64; 4] = [1e-6, 1e-5, 1e-4, 1e-3];

/// Largest combined effect of all gaps on position, velocity, acceleration and jerk: m, m/s, m/s^2, m/s^3; on yaw and
/// its rate in rad.
pub const MOST_MOVED: [f64; 4] = [1e-3, 1e-3, 1e-2, 1e-1];

const ORDINALS: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
const OF_YAW: [&str; 4] = ["yaw", "yaw rate", "", ""];
const UNITS: [&str; 4] = ["m", "m/s", "m/s^2", "m/s^3"];
const YAW_UNITS: [&str; 4] = ["rad", "rad/s", "", ""];

/// Checks the gaps of a motion.
///
/// # Errors
/// A gap is too large, or all gaps together have too large an effect.
pub(super) fn check(motion: &Motion) -> Result<(), Rejection> {
    let mut moved = [[Interval::ZERO; 4]; 4];
    for piece in 0..motion.pieces() {
        let gaps = motion.gaps(piece);
        for (axis, gaps) in gaps.iter().enumerate() {
            for (order, &gap) in gaps.iter().enumerate() {
                if exceeds(gap, MOST_GAP[order]) {
                    let (what, unit) = names(axis, order);
                    let why = format!(
                        "the gap between piece {} and the next is {} {unit} in {what}; at most {} {unit} is allowed",
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
                    "together the gaps may change the {what} by {} {unit}; at most {} {unit} is allowed",
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
