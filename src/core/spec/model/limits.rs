//! The kinds of limits: names and units.

use super::LimitKind;

impl LimitKind {
    /// Its name in running text, the unit in which reports show it, and the factor from SI to that unit.
    pub fn name_and_unit(self) -> (&'static str, &'static str, f64) {
        let degrees = 180.0 / std::f64::consts::PI;
        match self {
            LimitKind::X => ("x", "m", 1.0),
            LimitKind::Y => ("y", "m", 1.0),
            LimitKind::Z => ("altitude", "m", 1.0),
            LimitKind::Yaw => ("yaw", "deg", degrees),
            LimitKind::Speed => ("speed", "m/s", 1.0),
            LimitKind::SpeedHorizontal => ("horizontal speed", "m/s", 1.0),
            LimitKind::Climb => ("climb", "m/s", 1.0),
            LimitKind::Descent => ("descent", "m/s", 1.0),
            LimitKind::Acceleration => ("acceleration", "m/s^2", 1.0),
            LimitKind::AccelerationHorizontal => ("horizontal acceleration", "m/s^2", 1.0),
            LimitKind::Jerk => ("jerk", "m/s^3", 1.0),
            LimitKind::YawRate => ("yaw rate", "deg/s", degrees),
            LimitKind::YawAcceleration => ("yaw acceleration", "deg/s^2", degrees),
            LimitKind::Tilt => ("tilt", "deg", degrees),
            LimitKind::Face => ("position across a face", "m", 1.0),
            LimitKind::Distance => ("distance from the centre", "m", 1.0),
            LimitKind::Clearance => ("distance from a body", "m", 1.0),
            LimitKind::Arrival => ("direction of arrival", "deg", degrees),
            LimitKind::Heading => ("yaw", "deg", degrees),
        }
    }
}
