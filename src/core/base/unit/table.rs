//! The table of units, and the parser of unit texts such as `N*s^2/rad^2`.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::LazyLock;

use super::{Dimension, Exponent};

/// A scale to SI units and a dimension. The scale is a fraction, so that `35 cm` is exactly 0.35 m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    pub numerator: f64,
    pub denominator: f64,
    pub dimension: Dimension,
}

/// Why a text is not a unit.
#[derive(Debug, Clone, PartialEq)]
pub enum UnitError {
    /// A word that is not a unit, and what was probably meant.
    Unknown { word: String, meant: Option<String> },
    /// The text is not a product of powers, or an exponent is too large.
    Malformed,
}

/// Symbol, numerator, denominator, base exponents (mass, length, time, angle, current), whether it takes prefixes.
type Row = (&'static str, f64, f64, [i64; 5], bool);

const UNITS: &[Row] = &[
    ("m", 1.0, 1.0, [0, 1, 0, 0, 0], true),
    ("g", 1.0, 1000.0, [1, 0, 0, 0, 0], true),
    ("s", 1.0, 1.0, [0, 0, 1, 0, 0], true),
    ("rad", 1.0, 1.0, [0, 0, 0, 1, 0], true),
    ("N", 1.0, 1.0, [1, 1, -2, 0, 0], true),
    ("J", 1.0, 1.0, [1, 2, -2, 0, 0], true),
    ("W", 1.0, 1.0, [1, 2, -3, 0, 0], true),
    ("Hz", 1.0, 1.0, [0, 0, -1, 0, 0], true),
    ("A", 1.0, 1.0, [0, 0, 0, 0, 1], true),
    ("V", 1.0, 1.0, [1, 2, -3, 0, -1], true),
    ("min", 60.0, 1.0, [0, 0, 1, 0, 0], false),
    ("h", 3600.0, 1.0, [0, 0, 1, 0, 0], false),
    ("deg", PI, 180.0, [0, 0, 0, 1, 0], false),
    ("rev", 2.0 * PI, 1.0, [0, 0, 0, 1, 0], false),
    ("rpm", 2.0 * PI, 60.0, [0, 0, -1, 1, 0], false),
    ("ft", 0.3048, 1.0, [0, 1, 0, 0, 0], false),
    ("inch", 0.0254, 1.0, [0, 1, 0, 0, 0], false),
    ("mi", 1609.344, 1.0, [0, 1, 0, 0, 0], false),
    ("mph", 1609.344, 3600.0, [0, 1, -1, 0, 0], false),
    ("kt", 1852.0, 3600.0, [0, 1, -1, 0, 0], false),
    ("lb", 0.45359237, 1.0, [1, 0, 0, 0, 0], false),
    ("oz", 0.028349523125, 1.0, [1, 0, 0, 0, 0], false),
    ("%", 1.0, 100.0, [0, 0, 0, 0, 0], false),
];

/// Units of force defined as the weight of a mass: symbol and mass in kg as a fraction, to be multiplied by the spec's
/// gravity.
const WEIGHTS: &[(&str, f64, f64)] = &[("kgf", 1.0, 1.0), ("gf", 1.0, 1000.0), ("lbf", 0.45359237, 1.0)];

const PREFIXES: &[(&str, f64, f64)] = &[
    ("G", 1e9, 1.0),
    ("M", 1e6, 1.0),
    ("k", 1e3, 1.0),
    ("d", 1.0, 1e1),
    ("c", 1.0, 1e2),
    ("m", 1.0, 1e3),
    ("u", 1.0, 1e6),
    ("µ", 1.0, 1e6),
    ("μ", 1.0, 1e6),
    ("n", 1.0, 1e9),
];

/// Common wrong spellings, and what to write; plurals in `s` count too.
const HABITS: &[(&str, &str)] = &[
    ("kgs", "kg"),
    ("cms", "cm"),
    ("mms", "mm"),
    ("kms", "km"),
    ("mile", "mi"),
    ("knot", "kt"),
    ("msec", "ms"),
    ("sec", "s"),
    ("second", "s"),
    ("hr", "h"),
    ("hour", "h"),
    ("minute", "min"),
    ("meter", "m"),
    ("metre", "m"),
    ("degree", "deg"),
    ("°", "deg"),
    ("radian", "rad"),
    ("newton", "N"),
    ("gram", "g"),
    ("kilogram", "kg"),
    ("percent", "%"),
    ("kph", "km/h"),
    ("kmh", "km/h"),
    ("kmph", "km/h"),
    ("mps", "m/s"),
    ("feet", "ft"),
    ("foot", "ft"),
    ("inches", "inch"),
    ("lbs", "lb"),
    ("pound", "lb"),
    ("rps", "rev/s"),
    // Without these, `mAh` would be read as metre, ampere and hour.
    ("Ah", "A*h"),
    ("mAh", "mA*h"),
    ("amp", "A"),
    ("ampere", "A"),
    ("volt", "V"),
    ("watt", "W"),
];

/// Every symbol of the table, without prefixes, in its order.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|row| row.0).chain(WEIGHTS.iter().map(|row| row.0))
}

/// Parses a unit text: unit names with whole exponents joined by `*` and `/`, and a leading `1` for a
/// reciprocal. `/` divides by the one factor after it. `gravity` (m/s^2) scales `kgf`, `gf`, `lbf`.
///
/// # Errors
/// [`UnitError::Unknown`] with the first word that is not a unit, or [`UnitError::Malformed`] if the text is not a
/// product of powers.
pub fn parse_unit(text: &str, gravity: f64) -> Result<Unit, UnitError> {
    let mut unit = Unit { numerator: 1.0, denominator: 1.0, dimension: Dimension::PLAIN };
    let mut rest = text;
    let mut inverse = false;
    loop {
        let end = rest.find(['*', '/', '·']).unwrap_or(rest.len());
        let factor = parse_factor(&rest[..end], gravity)?;
        unit = if inverse { over(unit, factor) } else { times(unit, factor) }.ok_or(UnitError::Malformed)?;
        let Some(sign) = rest[end..].chars().next() else {
            break;
        };
        inverse = sign == '/';
        rest = &rest[end + sign.len_utf8()..];
    }
    let scale = unit.numerator / unit.denominator;
    if !(scale.is_finite() && scale > 0.0) {
        return Err(UnitError::Malformed);
    }
    // Reduced if one side divides the other, so that `kg` is exactly 1.
    let inverse = unit.denominator / unit.numerator;
    if scale.fract() == 0.0 {
        unit = Unit { numerator: scale, denominator: 1.0, ..unit };
    } else if inverse.fract() == 0.0 {
        unit = Unit { numerator: 1.0, denominator: inverse, ..unit };
    }
    Ok(unit)
}

fn times(a: Unit, b: Unit) -> Option<Unit> {
    Some(Unit {
        numerator: a.numerator * b.numerator,
        denominator: a.denominator * b.denominator,
        dimension: a.dimension.times(b.dimension)?,
    })
}

fn over(a: Unit, b: Unit) -> Option<Unit> {
    Some(Unit {
        numerator: a.numerator * b.denominator,
        denominator: a.denominator * b.numerator,
        dimension: a.dimension.over(b.dimension)?,
    })
}

/// `m`, `m^2`, `s^-1`, `m²`, `1`.
fn parse_factor(text: &str, gravity: f64) -> Result<Unit, UnitError> {
    let (word, exponent) = if let Some((word, exponent)) = text.split_once('^') {
        (word, exponent.parse::<i32>().map_err(|_| UnitError::Malformed)?)
    } else if let Some(word) = text.strip_suffix('²') {
        (word, 2)
    } else if let Some(word) = text.strip_suffix('³') {
        (word, 3)
    } else {
        (text, 1)
    };
    let unit = match word {
        "" => return Err(UnitError::Malformed),
        "1" => Unit { numerator: 1.0, denominator: 1.0, dimension: Dimension::PLAIN },
        _ => lookup(word, gravity)
            .ok_or_else(|| UnitError::Unknown { word: word.to_string(), meant: meant(word, gravity) })?,
    };
    let power = Exponent::new(i64::from(exponent), 1).ok_or(UnitError::Malformed)?;
    let dimension = unit.dimension.power(power).ok_or(UnitError::Malformed)?;
    let (up, down) = if exponent < 0 { (unit.denominator, unit.numerator) } else { (unit.numerator, unit.denominator) };
    let n = exponent.abs();
    Ok(Unit { numerator: up.powi(n), denominator: down.powi(n), dimension })
}

/// Every unit with every prefix that it takes, except the weights, which depend on gravity.
static PREFIXED: LazyLock<HashMap<String, Unit>> = LazyLock::new(|| {
    let prefixed = UNITS.iter().filter(|row| row.4).flat_map(|row| {
        let unit = from_row(row);
        PREFIXES.iter().map(move |(prefix, up, down)| {
            let scaled = Unit { numerator: unit.numerator * up, denominator: unit.denominator * down, ..unit };
            (format!("{prefix}{}", row.0), scaled)
        })
    });
    // The name of a unit takes precedence over a prefixed name: `min` is not a milli-inch.
    prefixed.chain(UNITS.iter().map(|row| (row.0.to_string(), from_row(row)))).collect()
});

fn lookup(word: &str, gravity: f64) -> Option<Unit> {
    PREFIXED.get(word).copied().or_else(|| weight(word, gravity))
}

/// The unit with the name `word`, without a prefix.
fn exact(word: &str, gravity: f64) -> Option<Unit> {
    weight(word, gravity).or_else(|| UNITS.iter().find(|row| row.0 == word).map(from_row))
}

fn weight(word: &str, gravity: f64) -> Option<Unit> {
    let (_, up, down) = WEIGHTS.iter().find(|row| row.0 == word)?;
    Some(Unit { numerator: up * gravity, denominator: *down, dimension: from_row(&UNITS[4]).dimension })
}

fn from_row(row: &Row) -> Unit {
    let bases = [Dimension::MASS, Dimension::LENGTH, Dimension::TIME, Dimension::ANGLE, Dimension::CURRENT];
    let dimension = bases.iter().zip(row.3).fold(Dimension::PLAIN, |product, (base, e)| {
        let factor = Exponent::new(e, 1).and_then(|e| base.power(e));
        factor.and_then(|factor| product.times(factor)).unwrap_or(product)
    });
    Unit { numerator: row.1, denominator: row.2, dimension }
}

/// The unit that was probably meant by `word`.
fn meant(word: &str, gravity: f64) -> Option<String> {
    let habits = [word, word.strip_suffix('s').unwrap_or(word)];
    let habit = HABITS.iter().find(|(wrong, _)| habits.iter().any(|habit| wrong.eq_ignore_ascii_case(habit)));
    let habit = habit.map(|(_, right)| right.to_string());
    habit
        .or_else(|| singular(word, gravity))
        .or_else(|| run_together(word, gravity))
        .or_else(|| powered(word, gravity))
        .or_else(|| other_case(word, gravity))
}

/// `deg` for `degs`, but not `N` for `Ns`, which more likely means newton-seconds.
fn singular(word: &str, gravity: f64) -> Option<String> {
    let stem = word.strip_suffix('s').filter(|stem| stem.len() > 2)?;
    exact(stem, gravity).map(|_| stem.to_string())
}

/// `N*m` for `Nm`: several units written without signs between them.
fn run_together(word: &str, gravity: f64) -> Option<String> {
    if word.len() > 12 {
        return None;
    }
    word.char_indices().skip(1).find_map(|(cut, _)| {
        let (first, rest) = word.split_at(cut);
        lookup(first, gravity)?;
        let rest = if lookup(rest, gravity).is_some() { rest.to_string() } else { run_together(rest, gravity)? };
        Some(format!("{first}*{rest}"))
    })
}

/// `m^2` for `m2`, `kg*m^2` for `kgm2`.
fn powered(word: &str, gravity: f64) -> Option<String> {
    let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let power = word[stem.len()..].parse::<u8>().ok().filter(|power| (2..=4).contains(power))?;
    // `ms2` may well be an acceleration.
    let known = stem != "ms" && lookup(stem, gravity).is_some();
    let base = if known { stem.to_string() } else { run_together(stem, gravity)? };
    Some(format!("{base}^{power}"))
}

/// `kg` for `Kg`, `rpm` for `RPM`.
fn other_case(word: &str, gravity: f64) -> Option<String> {
    let lower = word.to_lowercase();
    let prefixed = PREFIXES
        .iter()
        .flat_map(|(prefix, ..)| UNITS.iter().filter(|row| row.4).map(move |row| format!("{prefix}{}", row.0)));
    let all = unit_names().map(str::to_string).chain(prefixed);
    all.filter(|name| name.to_lowercase() == lower).find(|name| lookup(name, gravity).is_some())
}
