//! Which unit a plain number was probably meant to have, by its size.

use super::due::Due;

/// From a number's size below which the units beside it are likely.
type Sizes = &'static [(f64, &'static [&'static str])];

const ANY: f64 = f64::INFINITY;

/// Sizes of what multirotors have, field by field. Two units where the size leaves both possible, the likelier first.
const FIELDS: [(&[&str], Sizes); 8] = [
    (&["within"], &[(1.0, &["m"]), (ANY, &["cm"])]),
    (&["arm"], &[(5.0, &["m"]), (60.0, &["cm"]), (100.0, &["cm", "mm"]), (ANY, &["mm"])]),
    (&["torque_per_thrust"], &[(0.5, &["m"]), (5.0, &["cm", "mm"]), (ANY, &["mm"])]),
    (&["mass"], &[(50.0, &["kg"]), (1000.0, &["g", "kg"]), (ANY, &["g"])]),
    (&["max_thrust"], &[(100.0, &["N"]), (500.0, &["N", "gf"]), (ANY, &["gf", "N"])]),
    // The smallest rotors reach 4000 rad/s, the largest less than 1500 rpm.
    (
        &["max_speed", "min_speed"],
        &[(50.0, &["rad/s"]), (1500.0, &["rad/s", "rpm"]), (4000.0, &["rpm", "rad/s"]), (ANY, &["rpm"])],
    ),
    (&["time_constant"], &[(1.0, &["s"]), (ANY, &["ms"])]),
    (&["detection"], &[(1.0, &["s"]), (10.0, &["s", "ms"]), (ANY, &["ms"])]),
];

/// The largest angle that is as likely given in radians: a full turn, rounded up.
const TURN: f64 = 6.4;

/// A tilt goes to a quarter of a turn, rounded up.
const QUARTER: f64 = 1.6;

/// The units, the likeliest first, that a plain number of this size may have been meant in. More than one where only its
/// author can tell.
pub(super) fn likely_units(due: Due, size: f64) -> &'static [&'static str] {
    let size = size.abs();
    if let Some((_, sizes)) = FIELDS.iter().find(|(names, _)| names.contains(&due.what)) {
        return sizes.iter().find(|(below, _)| size < *below).map_or(&[], |(_, units)| units);
    }
    let may_be_radians = size > 0.0 && size <= if due.what == "tilt" { QUARTER } else { TURN };
    match due.unit {
        "deg" if may_be_radians => &["deg", "rad"],
        "deg/s" if may_be_radians => &["deg/s", "rad/s"],
        "deg/s^2" if may_be_radians => &["deg/s^2", "rad/s^2"],
        _ => &[],
    }
}
