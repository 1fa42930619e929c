//! Numbers in the cells of a thrust table: with a decimal point, and perhaps with separators of thousands.

/// Why a cell is not a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mistake {
    /// Completes "`12,5` in column `thrust`".
    pub what: &'static str,
    pub help: &'static str,
}

const NOT_A_NUMBER: Mistake =
    Mistake { what: "is not a number", help: "write a number such as `812.5`; its unit belongs in the header" };
const DECIMAL_COMMA: Mistake =
    Mistake { what: "has a decimal comma", help: "write decimal points: export the table with English numbers" };
const AMBIGUOUS: Mistake = Mistake {
    what: "may be a decimal number or one in thousands",
    help: "write it without the comma, or with a decimal point",
};

/// What may divide thousands, besides the comma: blanks, narrow ones too, and apostrophes.
const THOUSANDS: [char; 6] = [' ', '\u{a0}', '\u{2009}', '\u{202f}', '\'', '\u{2019}'];

/// The number in a cell of a table whose cells are divided by `separator`. A comma divides thousands, where that is the
/// only meaning: tables with semicolons are written where commas are decimal.
///
/// # Errors
/// It is not a finite number, or one with a decimal comma.
pub(super) fn number(text: &str, separator: u8) -> Result<f64, Mistake> {
    let is_plain = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    if text.chars().all(is_plain) {
        return finite(text);
    }
    let (sign, size) = match text.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let (whole, fraction) = size.split_once('.').map_or((size, None), |(whole, fraction)| (whole, Some(fraction)));
    let divides: &[char] = if whole.contains(',') { &[','] } else { &THOUSANDS };
    let groups: Vec<&str> = whole.split(divides).collect();
    let is_grouped = groups.iter().enumerate().all(|(k, group)| {
        let length = if k == 0 { 1..=3 } else { 3..=3 };
        length.contains(&group.len()) && group.bytes().all(|b| b.is_ascii_digit())
    }) && !groups[0].starts_with('0');
    let digits = |part: &str| part.bytes().all(|b| b.is_ascii_digit());
    if !is_grouped || !fraction.is_none_or(digits) {
        // `12,5`, `0,125` or `1.234,5`.
        let is_comma = size
            .split_once(',')
            .is_some_and(|(before, after)| !after.is_empty() && digits(after) && before.split('.').all(digits));
        return Err(if is_comma { DECIMAL_COMMA } else { NOT_A_NUMBER });
    }
    if whole.contains(',') && separator == b';' && groups.len() == 2 && fraction.is_none() {
        return Err(AMBIGUOUS);
    }
    finite(&format!("{sign}{}.{}", groups.concat(), fraction.unwrap_or("0")))
}

fn finite(text: &str) -> Result<f64, Mistake> {
    text.parse().ok().filter(|value: &f64| value.is_finite()).ok_or(NOT_A_NUMBER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_and_decimal_commas_are_told_apart() {
        for (text, separator, value) in [
            ("812", b',', Ok(812.0)),
            ("1.5e-2", b';', Ok(0.015)),
            ("-3.", b',', Ok(-3.0)),
            ("1,234", b',', Ok(1234.0)),
            ("1,234", b';', Err(AMBIGUOUS)),
            ("1,234.5", b';', Ok(1234.5)),
            ("12,345,678", b';', Ok(12_345_678.0)),
            ("-1,234", b',', Ok(-1234.0)),
            ("1 234", b';', Ok(1234.0)),
            ("7'850.25", b',', Ok(7850.25)),
            ("7\u{2019}850", b',', Ok(7850.0)),
            ("1\u{202f}234", b',', Ok(1234.0)),
            ("12,5", b',', Err(DECIMAL_COMMA)),
            ("0,125", b';', Err(DECIMAL_COMMA)),
            ("0,125", b',', Err(DECIMAL_COMMA)),
            ("1.234,5", b';', Err(DECIMAL_COMMA)),
            ("nan", b',', Err(NOT_A_NUMBER)),
            ("inf", b',', Err(NOT_A_NUMBER)),
            ("1e999", b',', Err(NOT_A_NUMBER)),
            ("0x10", b',', Err(NOT_A_NUMBER)),
            ("1,23,456", b',', Err(NOT_A_NUMBER)),
            ("12 34", b',', Err(NOT_A_NUMBER)),
            ("1,234.5.6", b',', Err(NOT_A_NUMBER)),
            (",", b';', Err(NOT_A_NUMBER)),
            ("-", b',', Err(NOT_A_NUMBER)),
            ("812 g", b',', Err(NOT_A_NUMBER)),
        ] {
            assert_eq!(number(text, separator), value, "{text} {}", separator as char);
        }
    }
}
