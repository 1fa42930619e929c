//! Compares two dimensions and shows the factors in which they differ.

use super::dimension::power;
use super::{Base, Dimension};

/// A comparison of an expected and a found dimension.
#[derive(Debug, Clone, PartialEq)]
pub struct Mismatch {
    /// Aligned lines: the two dimensions and, if they have a base dimension in common, the missing and the surplus
    /// factors.
    pub table: String,
    /// One action, such as `multiply by a length (m)`, if the two have a base dimension in common.
    pub action: Option<String>,
}

/// Compares an expected and a found dimension factor by factor. The table has one column for each base dimension, so
/// that corresponding factors are aligned:
/// ```text
/// expected  kg  m^2
///    found  kg  m
///  missing      m
/// ```
/// A row `too much` lists the factors that only the found dimension has, or has to a higher power.
pub fn mismatch(expected: Dimension, found: Dimension) -> Mismatch {
    compare(["expected", "found"], expected, found)
}

/// The table of the factors in which two dimensions differ; `names` are the titles of the two rows.
pub fn compare(names: [&str; 2], expected: Dimension, found: Dimension) -> Mismatch {
    let factor = expected.over(found).unwrap_or(Dimension::PLAIN);
    let (missing, surplus) = differences(expected, found);
    let shared = Base::ALL.into_iter().any(|b| !expected.exponent(b).is_zero() && !found.exponent(b).is_zero());
    let mut rows = vec![(names[0], expected), (names[1], found)];
    if shared {
        rows.extend([("missing", missing), ("too much", surplus)].into_iter().filter(|(_, d)| !d.is_plain()));
    }
    let title = rows.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let used: Vec<Base> =
        Base::ALL.into_iter().filter(|&b| rows.iter().any(|(_, d)| !d.exponent(b).is_zero())).collect();
    let width = |base: Base| rows.iter().map(|(_, d)| cell(*d, base).len()).max().unwrap_or(0);
    let line = |(name, dimension): &(&str, Dimension)| {
        let cells: String = used.iter().map(|&b| format!("  {:<w$}", cell(*dimension, b), w = width(b))).collect();
        let cells = if dimension.is_plain() { "  a plain number".to_string() } else { cells };
        format!("{name:>title$}{}", cells.trim_end())
    };
    let table = rows.iter().map(line).collect::<Vec<_>>().join("\n");
    Mismatch { table, action: shared.then(|| action(factor)) }
}

/// The factors that `found` lacks and those that it has in surplus.
fn differences(expected: Dimension, found: Dimension) -> (Dimension, Dimension) {
    let (mut missing, mut surplus) = (Dimension::PLAIN, Dimension::PLAIN);
    for base in Base::ALL {
        let (due, there) = (expected.only(base), found.only(base));
        let (e, f) = (due.exponent(base), there.exponent(base));
        let opposed = !e.is_zero() && !f.is_zero() && e.is_negative() != f.is_negative();
        let (lacks, exceeds) = match () {
            _ if opposed => (due, there),
            _ if e == f => continue,
            // `found` is absent, or of the same sign and nearer to zero: the difference is missing.
            _ if f.is_zero() || (!e.is_zero() && f.is_nearer_zero(e)) => {
                (due.over(there).unwrap_or(due), Dimension::PLAIN)
            }
            _ => (Dimension::PLAIN, there.over(due).unwrap_or(there)),
        };
        missing = missing.times(lacks).unwrap_or(missing);
        surplus = surplus.times(exceeds).unwrap_or(surplus);
    }
    (missing, surplus)
}

fn cell(dimension: Dimension, base: Base) -> String {
    let exponent = dimension.exponent(base);
    if exponent.is_zero() { String::new() } else { power(base, exponent) }
}

fn action(missing: Dimension) -> String {
    let inverse = Dimension::PLAIN.over(missing).unwrap_or(missing);
    let positive = Base::ALL.into_iter().any(|b| !missing.exponent(b).is_zero() && !missing.exponent(b).is_negative());
    match (missing.named(), inverse.named()) {
        (Some(_), _) if positive => format!("multiply by {}", missing.describe()),
        (_, Some(_)) => format!("divide by {}", inverse.describe()),
        _ if positive => format!("multiply by {}", missing.describe()),
        _ => format!("divide by {}", inverse.describe()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_aligned() {
        let inertia = Dimension::MASS.times(Dimension::LENGTH).and_then(|d| d.times(Dimension::LENGTH)).unwrap();
        let found = Dimension::MASS.times(Dimension::LENGTH).unwrap();
        let difference = mismatch(inertia, found);
        assert_eq!(difference.table, "expected  kg  m^2\n   found  kg  m\n missing      m");
        assert_eq!(difference.action.as_deref(), Some("multiply by a length (m)"));
        assert_eq!(mismatch(found, inertia).action.as_deref(), Some("divide by a length (m)"));
    }

    #[test]
    fn surplus_and_missing_factors_have_separate_rows() {
        let unit = |text: &str| crate::unit::parse_unit(text, 1.0).unwrap().dimension;
        let table = |expected: &str, found: &str| mismatch(unit(expected), unit(found)).table;
        assert_eq!(table("kg*m^2", "N*m"), "expected  kg  m^2\n   found  kg  m^2  s^-2\ntoo much           s^-2");
        assert_eq!(table("m/s", "m"), "expected  m  s^-1\n   found  m\n missing     s^-1");
        assert_eq!(table("m", "m^2"), "expected  m\n   found  m^2\ntoo much  m");
        assert_eq!(
            table("N", "kg*m^3/s"),
            "expected  kg  m    s^-2\n   found  kg  m^3  s^-1\n missing           s^-1\ntoo much      m^2"
        );
        assert_eq!(table("Hz", "s"), "expected  s^-1\n   found  s\n missing  s^-1\ntoo much  s");
    }

    #[test]
    fn nothing_in_common_gives_no_factor() {
        let difference = compare(["left", "right"], Dimension::MASS, Dimension::TIME);
        assert_eq!(difference.table, " left  kg\nright      s");
        assert_eq!(difference.action, None);
    }
}
