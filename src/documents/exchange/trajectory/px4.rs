//! A table of PX4's `TrajectorySetpoint`, with the names of its fields as pyulog writes them.

use super::{Choices, Exported};
use crate::exchange::frames::{Frame, wrapped};
use crate::exchange::trajectory::instant::Instant;
use std::fmt::Write;

const HEADER: &str = "timestamp,position[0],position[1],position[2],velocity[0],velocity[1],velocity[2],\
                      acceleration[0],acceleration[1],acceleration[2],jerk[0],jerk[1],jerk[2],yaw,yawspeed";

/// Microseconds since the start, then float32: position (m), velocity, acceleration, jerk in north, east, down; yaw
/// (rad, clockwise from north, between -pi and pi) and its rate.
pub(super) fn text(plan: &Exported, choices: &Choices) -> Result<String, String> {
    let mut out = format!("{HEADER}\n");
    for instant in plan.instants(choices.rate(), HEADER)? {
        let _ = write!(out, "{}", (instant.time * 1e6).round());
        let vectors = [instant.position, instant.velocity, instant.acceleration, instant.jerk].map(world);
        for value in vectors.concat().into_iter().chain(heading(&instant)) {
            let _ = write!(out, ",{}", single(value));
        }
        out.push('\n');
    }
    Ok(out)
}

pub(super) fn world(vector: [f64; 3]) -> [f64; 3] {
    Frame::NedFrd.world(vector)
}

/// Yaw and yaw rate.
pub(super) fn heading(instant: &Instant) -> [f64; 2] {
    let [yaw, rate] = instant.yaw;
    [wrapped(Frame::NedFrd.yaw(yaw)), Frame::NedFrd.yaw_rate(rate)]
}

/// The shortest text that reads back as the same float32; no `-0`.
pub(super) fn single(value: f64) -> String {
    let value = value as f32;
    match value {
        0.0 => "0".into(),
        small if small.abs() < 1e-5 => format!("{small:e}"),
        _ => value.to_string(),
    }
}
