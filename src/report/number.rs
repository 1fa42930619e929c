//! The one formatter of numbers for people: reports, messages and snapshots.

/// Up to six significant digits, trailing zeros cut, no `-0`; `not a number` and `infinity` spelled out.
pub fn number(x: f64) -> String {
    significant(x, 6)
}

/// Up to `digits` significant digits.
pub fn significant(x: f64, digits: usize) -> String {
    if x.is_nan() {
        return "not a number".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "infinity".into() } else { "-infinity".into() };
    }
    if x == 0.0 {
        return "0".into();
    }
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        trim(&format!("{x:.decimals$}")).to_string()
    } else {
        format!("{}e{exponent}", trim(mantissa))
    }
}

/// A share as percent with up to three significant digits: `14.6 %`.
pub fn percent(x: f64) -> String {
    format!("{} %", significant(100.0 * x, 3))
}

/// Seconds with two decimals; less than these can show is `< 0.01`, never `0.00`.
pub fn short_seconds(x: f64) -> String {
    if x < 0.005 { "< 0.01".into() } else { fixed(x, 2) }
}

/// Fixed decimals, no `-0`.
pub fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    if text.starts_with('-') && text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) {
        text[1..].to_string()
    } else {
        text
    }
}

fn trim(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (15.55, "15.55"),
            (0.1 + 0.2, "0.3"),
            (8.5485e-6, "8.5485e-6"),
            (1234567.0, "1.23457e6"),
            (123456.0, "123456"),
            (-0.00012, "-0.00012"),
            (f64::NAN, "not a number"),
            (f64::INFINITY, "infinity"),
        ];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
        assert_eq!(fixed(-0.0001, 2), "0.00");
        assert_eq!(percent(0.146378), "14.6 %");
        assert_eq!([0.0, 0.0049, 0.005, 1.2].map(short_seconds), ["< 0.01", "< 0.01", "0.01", "1.20"]);
    }
}
