//! Words as the page sets them.

use maud::{Markup, html};

/// Units that a number is followed by.
const UNITS: [&str; 15] =
    ["s", "ms", "m", "cm", "m/s", "m/s^2", "N", "kg", "deg", "deg/s", "rad", "rad/s", "Hz", "%", "/"];

/// Text in which what stands between backticks is code.
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

/// The same text where no line ends between a number and its unit.
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
        // `200 / s` has two joints.
        joins = word.ends_with(|c: char| c.is_ascii_digit()) || is_unit && word == "/";
    }
    out
}
