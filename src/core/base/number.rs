//! The formatter of numbers in reports, messages and snapshots.

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

/// A lower bound with up to `digits` significant digits, rounded down.
pub fn down(x: f64, digits: usize) -> String {
    let rounded = significant(x, digits);
    let passes = |text: &str| text.parse::<f64>().is_ok_and(|value| value > x + SAME * x.abs());
    if !passes(&rounded) || x == 0.0 {
        return rounded;
    }
    let unit = 10f64.powf(x.abs().log10().floor() - (digits as f64 - 1.0));
    significant(x - 0.5 * unit, digits)
}

/// A lower bound, rounded down, with enough digits to show that it is above `other`.
pub fn down_but_above(x: f64, digits: usize, other: f64) -> String {
    let is_above = |text: &String| text.parse::<f64>().is_ok_and(|value| value > other);
    let written = (digits..=MOST_DIGITS).map(|digits| down(x, digits)).find(is_above);
    written.unwrap_or_else(|| down(x, digits))
}

/// Two numbers with enough digits to show that they differ.
pub fn apart(a: f64, b: f64) -> [String; 2] {
    let written = |digits| [a, b].map(|x| significant(x, digits));
    let differ = |pair: &[String; 2]| pair[0] != pair[1];
    (6..=MOST_DIGITS).map(written).find(differ).unwrap_or_else(|| written(MOST_DIGITS))
}

/// An upper bound with up to `digits` significant digits, rounded up.
pub fn up(x: f64, digits: usize) -> String {
    let text = down(-x, digits);
    text.strip_prefix('-').map_or_else(|| if text == "0" { text.clone() } else { format!("-{text}") }, str::to_string)
}

/// Most significant digits of a double.
const MOST_DIGITS: usize = 15;

/// Numbers with a smaller relative difference count as equal.
const SAME: f64 = 1e-9;

/// Significant digits of a share.
pub const DIGITS: usize = 3;

/// A share as percent with up to three significant digits: `14.6 %`.
pub fn percent(x: f64) -> String {
    format!("{} %", significant(100.0 * x, DIGITS))
}

/// A share that people compare with others as percent: three significant digits, at most one of them after the point.
/// What rounds to zero is `0 %`; below zero it keeps one digit, because the sign matters.
pub fn tenths(x: f64) -> String {
    let share = 100.0 * x;
    if share.abs() >= 1.0 || share == 0.0 || !share.is_finite() {
        return percent(x);
    }
    match fixed(share, 1) {
        zero if zero == "0.0" && share < 0.0 => format!("{} %", significant(share, 1)),
        zero if zero == "0.0" => "0 %".into(),
        shown => format!("{} %", trim(&shown)),
    }
}

/// A number beside a larger one of its kind: with as many decimals as the larger one has with up to `digits`
/// significant digits.
pub fn beside(x: f64, whole: f64, digits: usize) -> String {
    let exponent = whole.abs().max(x.abs()).log10().floor();
    if !exponent.is_finite() {
        return significant(x, digits);
    }
    let decimals = (digits as f64 - 1.0 - exponent).max(0.0) as usize;
    trim(&fixed(x, decimals)).to_string()
}

/// `1 row`, `2 rows`
pub fn plural(n: usize, word: &str) -> String {
    format!("{n} {word}{}", if n == 1 { "" } else { "s" })
}

/// A share of a whole in percent, like [`percent`], but `100` only for the whole. A share that would round up to it has
/// enough digits to differ, rounded down: `99.96`.
pub fn part_of_all(x: f64) -> String {
    let rounded = significant(100.0 * x, DIGITS);
    if rounded != "100" || x >= 1.0 {
        return rounded;
    }
    let missing = 100.0 * (1.0 - x);
    // Up to the first digit of the missing share.
    let decimals = (-missing.log10().floor()).clamp(1.0, 12.0);
    let scale = 10f64.powf(decimals);
    trim(&format!("{:.*}", decimals as usize, (100.0 * x * scale).floor() / scale)).to_string()
}

/// Seconds with two decimals; smaller values are `< 0.01`, never `0.00`.
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

/// Appends the shortest text that reads back as the same number; no `-0`.
pub fn push_shortest(out: &mut String, v: f64) {
    use std::fmt::Write;
    let v = if v == 0.0 { 0.0 } else { v };
    let written = match v != 0.0 && (v.abs() < 1e-5 || v.abs() >= 1e15) {
        true => write!(out, "{v:e}"),
        false => write!(out, "{v}"),
    };
    written.expect("a string takes what is written");
}

/// The shortest text that reads back as the same number; no `-0`.
pub fn shortest(v: f64) -> String {
    let mut text = String::new();
    push_shortest(&mut text, v);
    text
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
        assert_eq!(
            [3.99388, 2.46687, 2.4, 2.4 - 1e-12, 0.0].map(|x| down(x, 4)),
            ["3.993", "2.466", "2.4", "2.4", "0"]
        );
        assert_eq!([3.99312, 2.4, 2.4 + 1e-12, 0.0, 999.91].map(|x| up(x, 4)), ["3.994", "2.4", "2.4", "0", "1000"]);
        let above = [(13.4853, 13.48), (13.4853, 13.4), (13.48000012, 13.48), (2.0, 3.0)];
        assert_eq!(above.map(|(x, other)| down_but_above(x, 4, other)), ["13.485", "13.48", "13.4800001", "2"]);
        let shares = [0.0, 0.146378, 0.995, 0.9995, 0.99951, 0.9996, 0.99999, 1.0 - 1.0 / 3e6, 1.0].map(part_of_all);
        assert_eq!(shares, ["0", "14.6", "99.5", "99.95", "99.95", "99.96", "99.999", "99.99996", "100"]);
        let tenth = [0.146378, 0.0872, 0.00437, 0.000111, 0.0, -0.000213, -0.0394].map(tenths);
        assert_eq!(tenth, ["14.6 %", "8.72 %", "0.4 %", "0 %", "0 %", "-0.02 %", "-3.94 %"]);
        let pairs = [(0.0437, 20.0), (0.00623, 2.0), (20.0, 20.0), (1.66, 1.0), (0.0, 0.0), (30.04, 30.0)];
        assert_eq!(pairs.map(|(x, whole)| beside(x, whole, 3)), ["0", "0.01", "20", "1.66", "0", "30"]);
        assert_eq!([0.0, 0.0049, 0.005, 1.2].map(short_seconds), ["< 0.01", "< 0.01", "0.01", "1.20"]);
    }
}
