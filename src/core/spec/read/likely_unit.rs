//! Guesses from its size which unit a plain number was meant to have.

use super::expected::Expected;

/// Units of angles and of their rates, in degrees and in radians.
const RADIANS: [(&str, &str); 3] = [("deg", "rad"), ("deg/s", "rad/s"), ("deg/s^2", "rad/s^2")];

/// The largest number that may be an angle in radians: a full turn, rounded up.
const TURN: f64 = 6.4;

/// The largest number that may be a tilt in radians: a quarter turn, rounded up.
const QUARTER: f64 = 1.6;

/// The likely units of a plain number of this size, the likeliest first: at least one, and more than one where only the
/// author can know.
pub(super) fn likely_units(due: Expected, size: f64) -> Vec<&'static str> {
    let size = size.abs();
    let sizes = due.row.map_or(&[][..], |row| row.likely);
    if let Some((_, units)) = sizes.iter().find(|(below, _)| size < *below) {
        return units.to_vec();
    }
    let may_be_radians = size <= if due.what == "tilt" { QUARTER } else { TURN };
    let radians = RADIANS.iter().find(|(degrees, _)| may_be_radians && *degrees == due.unit);
    [due.unit].into_iter().chain(radians.map(|(_, radians)| *radians)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::table::rotor;

    #[test]
    fn only_small_angles_may_be_radians() {
        let of = |what, unit, size| likely_units(Expected::new(what, unit), size);
        assert_eq!(of("yaw", "deg", -1.57), ["deg", "rad"]);
        assert_eq!(of("yaw", "deg", 90.0), ["deg"]);
        assert_eq!(of("tilt", "deg", 3.0), ["deg"]);
        assert_eq!(of("yaw_rate", "deg/s", 2.0), ["deg/s", "rad/s"]);
        assert_eq!(of("at", "m", 2.0), ["m"]);
        assert_eq!(likely_units(Expected::of(&rotor::MAX_SPEED), 8500.0), ["rpm"]);
    }
}
