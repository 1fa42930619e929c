//! Numbers of two significant digits, as an author would write them.

/// The k-th number of two significant digits, counted through all powers of ten: 1.0 is at 0, 9.9 at 89, 10 at 90.
fn at(k: i64) -> f64 {
    let digits = 10 + k.rem_euclid(90);
    // Parsed from text, so that it is the number that is printed.
    format!("{digits}e{}", k.div_euclid(90) - 1).parse().unwrap_or(f64::NAN)
}

/// The index of the smallest such number above `x` > 0.
fn above(x: f64) -> i64 {
    let power = x.log10().floor();
    let mut k = 90 * power as i64 + ((x / 10.0_f64.powf(power) - 1.0) * 10.0).floor() as i64;
    while at(k) > x {
        k -= 1;
    }
    while at(k) <= x {
        k += 1;
    }
    k
}

/// The numbers of two digits between `from` (excluded) and `to` (included), starting at the nearest to `from`; both >
/// 0.
pub(super) fn between(from: f64, to: f64) -> Vec<f64> {
    let up = to > from;
    let mut found = Vec::new();
    let mut k = if up { above(from) } else { above(from) - 1 };
    while at(k) == from {
        k -= 1;
    }
    loop {
        let value = at(k);
        // Also ends at NaN.
        if !(if up { value <= to } else { value >= to }) {
            return found;
        }
        found.push(value);
        k += if up { 1 } else { -1 };
    }
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn both_ways_and_across_powers_of_ten() {
        assert_eq!(between(9.75, 12.0), [9.8, 9.9, 10.0, 11.0, 12.0]);
        assert_eq!(between(9.8, 10.0), [9.9, 10.0]);
        assert_eq!(between(1.05, 0.97), [1.0, 0.99, 0.98, 0.97]);
        assert_eq!(between(1.0, 0.985), [0.99]);
        assert_eq!(between(0.05, 0.053), [0.051, 0.052, 0.053]);
        assert_eq!(between(3.0, 3.05), [0.0; 0]);
        assert_eq!(between(30.0, 29.0), [29.0]);
    }
}
