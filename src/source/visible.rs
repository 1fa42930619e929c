//! Texts of others on their way to a reader. A control character can colour, clear or forge lines of a terminal, and a
//! bidirectional one can show a text in another order than it is read: both are shown as escapes, `\u{1b}`.

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character must not reach a terminal or a page as it is: a control character, one that changes the direction
/// of writing or deprecated shaping (U+206A to U+206F), or a separator that some readers take for the end of a line.
pub fn is_disguise(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{206f}')
}

/// A text of several lines: line ends (alone or after a carriage return) and tabs stay.
pub fn text(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let stays = |at: usize, c: char| matches!(c, '\n' | '\t') || c == '\r' && bytes.get(at + 1) == Some(&b'\n');
    escaped(text, stays, |out, c| _ = write!(out, "\\u{{{:x}}}", u32::from(c)))
}

/// A text within a line, such as the name of a file: line ends are escaped too.
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, |_, _| false, |out, c| _ = write!(out, "\\u{{{:x}}}", u32::from(c)))
}

/// The text of a JSON document that has been written: escapes of JSON, so that it means the same.
pub fn json(text: String) -> String {
    let stays = |_: usize, c: char| matches!(c, '\n' | '\t' | '\r');
    // Of what is escaped all lies in the basic plane, where JSON takes four digits.
    match escaped(&text, stays, |out, c| _ = write!(out, "\\u{:04x}", u32::from(c))) {
        Cow::Borrowed(_) => text,
        Cow::Owned(escaped) => escaped,
    }
}

/// A text in which every disguise is as many question marks as it has bytes: for texts so large that escapes would take many
/// times their memory.
pub fn blanked(text: &str) -> Cow<'_, str> {
    let is_bad = |c: char| is_disguise(c) && !matches!(c, '\n' | '\t' | '\r');
    if !text.chars().any(is_bad) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match is_bad(c) {
            true => out.extend(std::iter::repeat_n('?', c.len_utf8())),
            false => out.push(c),
        }
    }
    Cow::Owned(out)
}

fn escaped<'a>(text: &'a str, stays: impl Fn(usize, char) -> bool, escape: impl Fn(&mut String, char)) -> Cow<'a, str> {
    let is_bad = |at: usize, c: char| is_disguise(c) && !stays(at, c);
    let Some((first, _)) = text.char_indices().find(|&(at, c)| is_bad(at, c)) else { return Cow::Borrowed(text) };
    let mut out = String::with_capacity(text.len() + 16);
    out.push_str(&text[..first]);
    for (at, c) in text[first..].char_indices() {
        match is_bad(first + at, c) {
            true => escape(&mut out, c),
            false => out.push(c),
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanked_texts_keep_their_places() {
        assert_eq!(blanked("a\x1bk\n\u{202e}z"), "a?k\n???z");
        assert!(matches!(blanked("a\tb\r\n"), Cow::Borrowed(_)));
    }

    #[test]
    fn control_and_bidirectional_characters_become_escapes() {
        assert_eq!(
            text("a\x1b[31m\u{9b}2J\u{202e}\u{2066}\u{7f}\0b"),
            "a\\u{1b}[31m\\u{9b}2J\\u{202e}\\u{2066}\\u{7f}\\u{0}b"
        );
        assert_eq!(text("a\tb\r\nc\rd\n"), "a\tb\r\nc\\u{d}d\n");
        assert_eq!(line("a\nerror: b\t"), "a\\u{a}error: b\\u{9}");
    }

    #[test]
    fn other_text_is_left_as_it_is() {
        for plain in ["", "Grüße, 世界 \u{1f6a7}", "\u{65e5}\u{200d}", "1\u{a0}m"] {
            assert!(matches!(text(plain), Cow::Borrowed(_)) && matches!(line(plain), Cow::Borrowed(_)), "{plain}");
        }
    }

    #[test]
    fn json_keeps_its_meaning() {
        let whole = "a\u{202e}\x1b\u{7f}\u{85}\n\"\\";
        let written = json(serde_json::to_string_pretty(&[whole]).unwrap());
        assert!(written.is_ascii() && !written.replace('\n', "").contains(char::is_control), "{written}");
        assert_eq!(serde_json::from_str::<Vec<String>>(&written).unwrap(), [whole]);
    }
}
