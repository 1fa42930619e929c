//! The table of polynomials that Crazyswarm and uav_trajectories read, and that a Crazyflie's memory takes.

use super::px4::single;
use super::refit::{Errors, Fit, refit};
use super::{Choices, Exported, Written};
use crate::number::{down, number, plural, up};
use std::fmt::Write;

/// Most pieces: one takes 132 bytes of the 4 kB for trajectories.
const MOST_PIECES: usize = 31;

/// Largest error of positions (m), and of the yaw in rad, unless `--tolerance` is given.
const TOLERANCE: f64 = 0.01;

/// The table, with 33 columns in float32.
///
/// # Errors
/// The trajectory needs more pieces.
pub(super) fn written(plan: &Exported, choices: &Choices) -> Result<Written, String> {
    let tolerance = choices.tolerance.unwrap_or(TOLERANCE);
    let fit = refit(plan.trajectory, MOST_PIECES, tolerance).map_err(|best| refused(&best, tolerance))?;
    let mut text = String::from("duration");
    for axis in ["x", "y", "z", "yaw"] {
        (0..8).for_each(|power| text.push_str(&format!(",{axis}^{power}")));
    }
    text.push('\n');
    for piece in &fit.pieces {
        text.push_str(&single(piece.duration));
        for coefficient in piece.axes.as_flattened() {
            let _ = write!(text, ",{}", single(*coefficient));
        }
        text.push('\n');
    }
    let Errors { position, at, velocity, yaw } = fit.errors;
    let remark = format!(
        "refitted by {} of degree 7 with continuous acceleration: position within {} mm (at {} s), velocity within {} \
         mm/s, yaw within {} rad",
        plural(fit.pieces.len(), "piece"),
        up(1e3 * position, 3),
        number(at),
        up(1e3 * velocity, 3),
        up(yaw, 3)
    );
    Ok(Written { bytes: text.into_bytes(), remark: Some(remark) })
}

fn refused(best: &Fit, tolerance: f64) -> String {
    let Errors { position, at, yaw, .. } = best.errors;
    let [tolerance, position, enough] = [1e3 * tolerance, 1e3 * position, 1e3 * position.max(yaw)];
    format!(
        "the trajectory does not fit the {MOST_PIECES} pieces of a Crazyflie within {} mm (and {} mrad of yaw): with \
         so many the position is up to {} mm off, at {} s, and the yaw up to {} mrad; use --tolerance {}mm, or plan a \
         shorter mission",
        number(tolerance),
        number(tolerance),
        down(position, 3),
        number(at),
        down(1e3 * yaw, 3),
        up(enough, 3)
    )
}
