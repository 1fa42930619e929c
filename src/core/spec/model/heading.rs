//! Yaw that follows from the motion: towards a point, along the path, or free.

/// Along the path the yaw is required where the horizontal speed is at least this, m/s.
pub const SLOWEST: f64 = 0.3;

/// What the yaw at a waypoint follows from, and between two waypoints with the same rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Heading {
    /// It is [`Waypoint::yaw`](super::Waypoint::yaw), to within [`Waypoint::yaw_within`](super::Waypoint::yaw_within).
    Given,
    /// The direction to the point (x, y), m.
    Towards([f64; 2]),
    /// The direction of the horizontal velocity.
    AlongPath,
    /// Nothing is required.
    Free,
}

/// A direction that the yaw has to follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// To a point (x, y), m, where it is at least as far as `nearest` (m) horizontally.
    Towards { point: [f64; 2], nearest: f64 },
    /// The direction of the horizontal velocity, where it is at least [`SLOWEST`].
    AlongPath,
}

impl Target {
    /// The vector (x, y) whose direction is followed, for a position (m) and a velocity (m/s).
    pub fn vector(&self, position: [f64; 2], velocity: [f64; 2]) -> [f64; 2] {
        match self {
            Target::Towards { point, .. } => [point[0] - position[0], point[1] - position[1]],
            Target::AlongPath => velocity,
        }
    }

    /// The length from which on the vector's direction is required, m or m/s.
    pub fn least(&self) -> f64 {
        match self {
            Target::Towards { nearest, .. } => *nearest,
            Target::AlongPath => SLOWEST,
        }
    }

    /// The vector where its direction is required.
    pub fn direction(&self, position: [f64; 2], velocity: [f64; 2]) -> Option<[f64; 2]> {
        let vector = self.vector(position, velocity);
        (vector[0].hypot(vector[1]) >= self.least()).then_some(vector)
    }

    /// By how much a yaw is off that direction, from -pi to pi, rad.
    pub fn error(&self, position: [f64; 2], velocity: [f64; 2], yaw: f64) -> Option<f64> {
        let [x, y] = self.direction(position, velocity)?;
        let (sin, cos) = yaw.sin_cos();
        Some((sin * x - cos * y).atan2(cos * x + sin * y))
    }
}
