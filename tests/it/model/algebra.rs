//! Dimensions and units obey the laws one expects of them.

use mavc::unit::{Dimension, Exponent, Quantity, UnitError, mismatch, parse_unit};
use proptest::prelude::*;

fn dimension() -> impl Strategy<Value = Dimension> {
    prop::array::uniform4((-6i64..=6, 1i64..=3)).prop_map(|exponents| {
        let bases = [Dimension::MASS, Dimension::LENGTH, Dimension::TIME, Dimension::ANGLE];
        bases.into_iter().zip(exponents).fold(Dimension::PLAIN, |product, (base, (n, d))| {
            product.times(base.power(Exponent::new(n, d).unwrap()).unwrap()).unwrap()
        })
    })
}

/// Powers of base units with whole exponents, as one would write them.
fn unit_text() -> impl Strategy<Value = String> {
    let factor = (prop::sample::select(vec!["m", "mm", "kg", "g", "s", "ms", "rad", "deg", "N", "h", "rpm"]), 1..=3);
    (factor.clone(), prop::collection::vec((prop::bool::ANY, factor), 0..3)).prop_map(|((first, e), rest)| {
        rest.into_iter().fold(format!("{first}^{e}"), |text, (over, (word, e))| {
            format!("{text}{}{word}^{e}", if over { "/" } else { "*" })
        })
    })
}

proptest! {
    #[test]
    fn products_commute_associate_and_cancel(a in dimension(), b in dimension(), c in dimension()) {
        prop_assert_eq!(a.times(b), b.times(a));
        prop_assert_eq!(a.times(b).and_then(|ab| ab.times(c)), b.times(c).and_then(|bc| a.times(bc)));
        prop_assert_eq!(a.times(b).and_then(|ab| ab.over(b)), Some(a));
        prop_assert_eq!(a.over(a), Some(Dimension::PLAIN));
        prop_assert_eq!(a.times(Dimension::PLAIN), Some(a));
    }

    #[test]
    fn powers_distribute_and_roots_undo_them(a in dimension(), b in dimension(), n in 1i64..=4) {
        let (power, root) = (Exponent::new(n, 1).unwrap(), Exponent::new(1, n).unwrap());
        let product = a.times(b).and_then(|ab| ab.power(power));
        prop_assert_eq!(product, a.power(power).unwrap().times(b.power(power).unwrap()));
        prop_assert_eq!(a.power(power).and_then(|p| p.power(root)), Some(a));
    }

    #[test]
    fn the_missing_factor_fixes_a_mismatch(a in dimension(), b in dimension()) {
        let told = mismatch(a, b);
        prop_assert!(told.table.starts_with("expected"));
        prop_assert_eq!(a.over(b).and_then(|missing| b.times(missing)), Some(a));
    }

    #[test]
    fn a_dimension_of_whole_exponents_reads_back_as_written(text in unit_text()) {
        let unit = parse_unit(&text, 9.81).unwrap();
        if !unit.dimension.is_plain() {
            let again = parse_unit(&unit.dimension.to_string(), 9.81).unwrap();
            prop_assert_eq!(again.dimension, unit.dimension);
            prop_assert_eq!(again.numerator / again.denominator, 1.0);
        }
    }

    #[test]
    fn units_multiply_as_their_quantities_do(a in unit_text(), b in unit_text(), x in -1e3..1e3f64) {
        let one = |text: &str, x| Quantity::with_unit(x, parse_unit(text, 9.81).unwrap());
        let together = one(&format!("{a}*{b}"), x);
        let apart = one(&a, x).times(one(&b, 1.0)).unwrap();
        prop_assert_eq!(together.dimension, apart.dimension);
        prop_assert!((together.value - apart.value).abs() <= 1e-12 * apart.value.abs());
    }

    #[test]
    fn no_text_makes_the_reader_of_units_panic(text in "\\PC{0,20}", gravity in 0.1..30f64) {
        if let Ok(unit) = parse_unit(&text, gravity) {
            let scale = unit.numerator / unit.denominator;
            prop_assert!(scale.is_finite() && scale > 0.0);
        }
    }
}

#[test]
fn units_have_their_si_values() {
    let cases = [
        (1.0, "km", 1e3),
        (35.0, "cm", 0.35),
        (20.0, "ms", 0.02),
        (250.0, "us", 250e-6),
        (60.0, "%", 0.6),
        (620.0, "g", 0.62),
        (5.0, "min", 300.0),
        (1.0, "1/h", 1.0 / 3600.0),
        (180.0, "deg", std::f64::consts::PI),
        (60.0, "rpm", 2.0 * std::f64::consts::PI),
        (36.0, "km/h", 10.0),
        (1.0, "ft", 0.3048),
        (1.0, "kgf", 9.81),
        (500.0, "gf", 4.905),
        (1.0, "kg*m^2/s^2", 1.0),
        (2.0, "N/m^2", 2.0),
        (3.0, "s^-1", 3.0),
    ];
    for (x, text, si) in cases {
        let value = Quantity::with_unit(x, parse_unit(text, 9.81).unwrap()).value;
        assert!((value - si).abs() <= 1e-15 * si.abs(), "{x} {text} is {value}");
    }
    let newton = parse_unit("N", 9.81).unwrap().dimension;
    assert_eq!(parse_unit("kg*m/s^2", 9.81).unwrap().dimension, newton);
    assert_eq!(parse_unit("J/m", 9.81).unwrap().dimension, newton);
    assert_ne!(parse_unit("rad/s", 9.81).unwrap().dimension, parse_unit("1/s", 9.81).unwrap().dimension);
}

#[test]
fn what_is_not_a_unit_is_reported_with_a_suggestion() {
    let meant = |text: &str| match parse_unit(text, 9.81) {
        Err(UnitError::Unknown { meant, .. }) => meant,
        other => panic!("{text}: {other:?}"),
    };
    for (wrong, right) in
        [("Nm", "N*m"), ("Ns", "N*s"), ("kgm", "kg*m"), ("RPM", "rpm"), ("Kg", "kg"), ("sec", "s"), ("kph", "km/h")]
    {
        assert_eq!(meant(wrong).as_deref(), Some(right));
    }
    assert_eq!(meant("parsec"), None);
    for malformed in ["", "m**s", "m^", "m^x", "/s", "m^99999999999", "m^2000", "km^400"] {
        assert_eq!(parse_unit(malformed, 9.81), Err(UnitError::Malformed), "{malformed}");
    }
}
