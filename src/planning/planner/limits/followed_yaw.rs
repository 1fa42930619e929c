//! A yaw that follows a vector, such as the velocity or the direction of a target.

use crate::model::Target;
use crate::motion::{NodeState, X, Y, YAW};

/// A yaw that follows a vector, by the parts of that vector ahead and to the left of the vehicle: these change little
/// where a short vector turns far, as the angle between both does not.
pub(super) struct FollowedYaw {
    pub ahead: f64,
    pub aside: f64,
    /// The tangent of the largest angle.
    pub tan: f64,
    /// The length below which nothing is required.
    pub least: f64,
    /// A violation of one unit, m or m/s.
    pub unit: f64,
}

/// Where the direction is not required, the vector stays below this share of the least length. Chosen by hand.
pub(super) const PAUSED: f64 = 0.999;

/// About rest both conditions hold, and the cone is too narrow for a step's margin: below this width, m or m/s, a step
/// keeps the vector short. Chosen by hand.
const SHORT: f64 = 1e-3;

/// Angles up to which a yaw may differ from the direction are treated as at most this, rad. Chosen by hand.
const WIDEST: f64 = 1.4;

impl FollowedYaw {
    pub fn of(target: Target, upper: f64, state: &NodeState) -> FollowedYaw {
        let [position, velocity] = [0, 1].map(|order| [X, Y].map(|axis| state[axis][order]));
        let [x, y] = target.vector(position, velocity);
        let (sin, cos) = state[YAW][0].sin_cos();
        FollowedYaw {
            ahead: x * cos + y * sin,
            aside: y * cos - x * sin,
            tan: upper.min(WIDEST).tan(),
            least: target.least(),
            unit: x.hypot(y).max(1.0),
        }
    }

    /// By how much the vector is outside the cone about the yaw, and by how much it is too long for no direction to be
    /// required: one of the two has to be negative.
    pub fn beyond(&self) -> [f64; 2] {
        [self.aside.abs() - self.tan * self.ahead, self.ahead.hypot(self.aside) - PAUSED * self.least]
    }

    pub fn violation(&self) -> f64 {
        let [follow, pause] = self.beyond();
        follow.min(pause) / self.unit
    }

    /// Whether a step keeps the vector short, and not in the cone.
    pub fn is_paused(&self) -> bool {
        let [follow, pause] = self.beyond();
        follow > -SHORT && pause < follow
    }
}
