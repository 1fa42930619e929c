//! The one way numbers are written for people: reports, stage texts and snapshots.

/// `x` with up to six significant digits, without trailing zeros: `0.211`, `8.5485e-6`, `12000`.
/// Zero never carries a sign; what is not a number is spelled `NaN`, `infinity`, `-infinity`.
pub fn number(x: f64) -> String {
    if x.is_nan() {
        return "NaN".into();
    }
    if x.is_infinite() {
        return if x > 0.0 {
            "infinity".into()
        } else {
            "-infinity".into()
        };
    }
    if x == 0.0 {
        return "0".into();
    }
    let scientific = format!("{x:.5e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = usize::try_from(5 - exponent).unwrap_or(0);
        trim(&format!("{x:.decimals$}")).to_string()
    } else {
        format!("{}e{exponent}", trim(mantissa))
    }
}

fn trim(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn writes_few_digits_and_no_negative_zero() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (0.211, "0.211"),
            (8.5485e-6, "8.5485e-6"),
            (874.0, "874"),
            (100000.0, "100000"),
            (999999.6, "1e6"),
            (1234567.0, "1.23457e6"),
            (-1.0 / 3.0, "-0.333333"),
            (0.0001, "0.0001"),
            (0.1 + 0.2, "0.3"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-infinity"),
        ];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
    }
}
