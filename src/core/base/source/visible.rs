//! Escapes for text from untrusted files. A control character can colour, clear or forge lines of a terminal, and a
//! bidirectional one can display text in another order than it is parsed: both are shown as escapes, `\u{1b}`.

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character must not reach a terminal or a page unescaped: a control character, one that changes the
/// direction of writing or deprecated shaping (U+206A to U+206F), or a separator that some programs treat as the end of
/// a line.
pub fn is_disguise(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{206f}')
}

/// Escapes text of several lines; line feeds (alone or after a carriage return) and tabs are kept.
pub fn text(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let stays = |at: usize, c: char| matches!(c, '\n' | '\t') || c == '\r' && bytes.get(at + 1) == Some(&b'\n');
    escaped(text, stays, |out, c| _ = write!(out, "\\u{{{:x}}}", u32::from(c)))
}

/// Escapes text within a line, such as the name of a file; line feeds and tabs are escaped too.
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, |_, _| false, |out, c| _ = write!(out, "\\u{{{:x}}}", u32::from(c)))
}

/// Escapes the text of a JSON document by JSON escapes, so that its meaning stays the same.
pub fn json(text: String) -> String {
    let stays = |_: usize, c: char| matches!(c, '\n' | '\t' | '\r');
    // All escaped characters are in the basic multilingual plane, for which JSON uses four digits.
    match escaped(&text, stays, |out, c| _ = write!(out, "\\u{:04x}", u32::from(c))) {
        Cow::Borrowed(_) => text,
        Cow::Owned(escaped) => escaped,
    }
}

/// Replaces every character of [`is_disguise`] by as many question marks as it has bytes: for texts so large that
/// escapes would take many times their memory. Line feeds, tabs and carriage returns are kept.
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
