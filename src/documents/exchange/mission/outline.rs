//! Outlines of volumes for maps.

use crate::model::{Body, Mission, Volume, VolumeSide};
use std::f64::consts::TAU;

/// Corners of a circle on a map: its sides are within 0.4 % of the radius.
const CORNERS: usize = 36;

/// A horizontal outline, counter-clockwise, m.
pub struct Outline {
    pub corners: Vec<[f64; 2]>,
    /// Heights of its lower and upper end, m.
    pub bottom: f64,
    pub top: f64,
}

/// The corners of a circle, m.
pub fn circle([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let angle = |k: usize| TAU * k as f64 / CORNERS as f64;
    (0..CORNERS).map(|k| [x + radius * angle(k).cos(), y + radius * angle(k).sin()]).collect()
}

/// The outline of a body: of a ball that of the cylinder about it. A half space has none.
pub fn of(body: &Body) -> Option<Outline> {
    Some(match body {
        Body::Prism { corners, bottom, top } => Outline { corners: corners.clone(), bottom: *bottom, top: *top },
        Body::Cylinder { centre, radius, bottom, top } => {
            Outline { corners: circle(*centre, *radius), bottom: *bottom, top: *top }
        }
        Body::Ball { centre: [x, y, z], radius } => {
            Outline { corners: circle([*x, *y], *radius), bottom: z - radius, top: z + radius }
        }
        Body::HalfSpace { .. } => return None,
    })
}

/// The names of volumes without an outline.
pub fn unbounded(mission: &Mission) -> Vec<&str> {
    let is_unbounded = |volume: &&Volume| volume.bodies.iter().any(|body| of(body).is_none());
    mission.volumes.iter().filter(is_unbounded).map(|volume| volume.name.as_str()).collect()
}

/// `keep_in` or `keep_out`.
pub fn keyword(volume: &Volume) -> &'static str {
    match volume.side {
        VolumeSide::KeepIn => "keep_in",
        VolumeSide::KeepOut => "keep_out",
    }
}

/// The waypoint's name, or its number.
pub fn name(mission: &Mission, index: usize) -> String {
    mission.waypoints[index].name.clone().unwrap_or_else(|| (index + 1).to_string())
}
