//! YAML of mav_trajectory_generation (`segmentsFromFile`): segments of x, y, z and yaw, with the time in nanoseconds
//! and coefficients in ascending powers.

use super::pieces::COEFFICIENTS;
use super::{Plan, list};
use std::fmt::Write;

/// Ends of segments are rounded to nanoseconds, so that the rounding of durations does not add up.
pub(super) fn text(plan: &Plan) -> String {
    let mut out = String::from("segments:\n");
    for piece in plan.pieces() {
        let [start, end] = piece.span.map(|time| (time * 1e9).round() as u64);
        let _ = writeln!(out, "  - N: {COEFFICIENTS}\n    D: 4\n    time: {}", end - start);
        out.push_str("    coefficients:\n");
        for axis in piece.axes {
            let _ = writeln!(out, "      - {}", list(axis));
        }
    }
    out
}
