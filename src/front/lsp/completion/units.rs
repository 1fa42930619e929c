//! Units of a dimension, the likeliest first.

use crate::lsp::documentation;
use crate::unit::{Dimension, parse_unit, unit_names};

/// Units with prefixes, and compounds, that specs are written in.
const USUAL: [&str; 35] = [
    "mm",
    "cm",
    "km",
    "kg",
    "mg",
    "ms",
    "us",
    "mrad",
    "mN",
    "kN",
    "kHz",
    "mW",
    "kW",
    "mA*h",
    "m/s",
    "km/h",
    "cm/s",
    "m/s^2",
    "m/s^3",
    "rad/s",
    "deg/s",
    "rev/s",
    "rad/s^2",
    "deg/s^2",
    "1/s",
    "1/h",
    "N*m",
    "N*s/m",
    "kg*m^2",
    "g*m^2",
    "kg*cm^2",
    "1/s^2",
    "N*s^2/rad^2",
    "N*m*s^2/rad^2",
    "m^2",
];

/// Units of the dimension of `due`, `due` first, each with its value in SI; every unit where `due` is unknown.
pub fn of(due: Option<&'static str>, gravity: f64) -> Vec<(String, String)> {
    let dimension = due.and_then(|unit| parse_unit(unit, gravity).ok()).map(|unit| unit.dimension);
    let mut found: Vec<(String, String)> = Vec::new();
    let all = due.into_iter().chain(USUAL).chain(unit_names()).chain(documentation::units());
    for name in all {
        let Ok(unit) = parse_unit(name, gravity) else { continue };
        let fits = match dimension {
            Some(dimension) => unit.dimension == dimension,
            None => unit.dimension != Dimension::PLAIN,
        };
        if fits && found.iter().all(|(other, _)| other != name) {
            let scale = crate::number::significant(unit.numerator / unit.denominator, 4);
            let si = unit.dimension.to_string();
            found.push((name.to_string(), format!("{scale} {si}")));
        }
    }
    found
}
