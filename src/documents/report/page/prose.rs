//! Typesetting of texts on the page.

use maud::{Markup, html};

/// A list below a table that explains its columns, folded; the table refers to `id` by `aria-describedby`.
pub fn terms<'a>(id: &str, terms: impl IntoIterator<Item = (&'a str, &'a str)>) -> Markup {
    html! {
        details {
            summary { "What the columns mean" }
            dl.terms id=(id) {
                @for (term, meaning) in terms { div { dt { (term) } dd { (prose(meaning)) } } }
            }
        }
    }
}

/// Units that may follow a number.
const UNITS: [&str; 17] =
    ["s", "ms", "m", "cm", "m/s", "m/s^2", "N", "kg", "deg", "deg/s", "rad", "rad/s", "Hz", "W", "W*h", "%", "/"];

/// Text in which passages between backticks are code.
pub fn prose(text: &str) -> Markup {
    let whole = text.matches('`').count().is_multiple_of(2);
    html! {
        @if whole {
            @for (i, part) in text.split('`').enumerate() {
                @if i % 2 == 1 { code { (part) } } @else { (unbroken(part)) }
            }
        } @else { (unbroken(text)) }
    }
}

/// The text with no line break between a number and its unit.
pub fn unbroken(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut joins = false;
    for (i, word) in text.split(' ').enumerate() {
        let bare = word.trim_end_matches([',', ';', '.', ':', ')']);
        let is_unit = joins && UNITS.contains(&bare);
        if i > 0 {
            out.push(if is_unit { '\u{a0}' } else { ' ' });
        }
        out.push_str(word);
        // `200 / s` and `3 N m` have two joints.
        joins = word.ends_with(|c: char| c.is_ascii_digit()) || is_unit && matches!(word, "/" | "N");
    }
    out
}

/// The text with a minus sign in place of the hyphen before each negative number.
pub fn true_minus(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = ' ';
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let negates = c == '-' && !before.is_alphanumeric() && rest.peek().is_some_and(char::is_ascii_digit);
        out.push(if negates { '\u{2212}' } else { c });
        before = c;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_ends_between_a_number_and_its_unit() {
        assert_eq!(unbroken("0.26 N m at 3 s, 17 N and 2 of"), "0.26\u{a0}N\u{a0}m at 3\u{a0}s, 17\u{a0}N and 2 of");
        assert_eq!(unbroken("200 / s"), "200\u{a0}/\u{a0}s");
    }

    #[test]
    fn only_negative_numbers_get_a_minus_sign() {
        assert_eq!(true_minus("-0.05 (phi -1)"), "\u{2212}0.05 (phi \u{2212}1)");
        assert_eq!(true_minus("1e-5, octo-8, well-known"), "1e-5, octo-8, well-known");
    }
}
