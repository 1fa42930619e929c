//! Characters that are not allowed outside texts and comments, and what was probably meant.

use super::{Scanner, is_name};
use crate::diagnostic::Diagnostic;
use crate::syntax::cut;

/// A character, its name, and the ASCII to write instead.
const LOOK_ALIKES: &[(&str, &str, &str)] = &[
    ("\u{2010}\u{2011}", "a hyphen", "-"),
    ("\u{2012}\u{2013}\u{2014}\u{2015}", "a dash", "-"),
    ("\u{2212}\u{fe63}\u{ff0d}", "a minus sign", "-"),
    ("\u{d7}\u{22c5}\u{b7}\u{2219}\u{2217}", "a multiplication sign", "*"),
    ("\u{f7}\u{2215}\u{2044}", "a division sign", "/"),
    ("\u{201c}\u{201d}\u{201e}\u{201f}\u{ab}\u{bb}\u{2033}", "a curly quote", "\""),
    ("\u{2018}\u{2019}\u{201a}\u{2032}\u{b4}", "a curly quote", "\""),
    ("\u{2264}\u{2a7d}", "less than or equal", "<="),
    ("\u{2265}\u{2a7e}", "greater than or equal", ">="),
    ("\u{b0}\u{ba}", "a degree sign", " deg"),
    ("\u{b5}\u{3bc}", "micro", "u"),
    ("\u{3c0}", "pi", "pi"),
    ("\u{b2}", "a raised two", "^2"),
    ("\u{b3}", "a raised three", "^3"),
    ("\u{221a}", "a root sign", "sqrt"),
    ("\u{2026}", "an ellipsis", ".."),
    ("\u{3001}", "a wide comma", ","),
    ("\u{ad}\u{200b}\u{200c}\u{200d}\u{2060}\u{feff}", "an invisible character", ""),
];

/// Any blank that is not the plain one.
const SPECIAL_SPACE: (&str, &str, &str) = ("", "a special space", " ");

impl Scanner<'_> {
    /// At most one message a statement; special spaces are then read as blanks.
    pub(super) fn odd_character(&mut self, start: usize) {
        let Some(c) = self.text[start..].chars().next() else {
            return;
        };
        self.at = start + c.len_utf8();
        let special_space = c.is_whitespace() && !c.is_control();
        let look_alike = match special_space {
            true => Some(&SPECIAL_SPACE),
            false => LOOK_ALIKES.iter().find(|(set, ..)| set.contains(c)),
        };
        let diagnostic = match look_alike {
            Some((_, name, instead)) => self.look_alike(start, c, name, instead),
            None if c == '\'' => self.single_quote(start),
            None if c.is_alphabetic() => self.foreign_letter(start),
            None => self.unknown_character(start, c),
        };
        if look_alike.is_some_and(|(_, _, instead)| instead.trim().is_empty()) || c.is_control() {
            self.blank(start, start + c.len_utf8());
        }
        if !std::mem::replace(&mut self.quiet, true) {
            self.report(diagnostic);
        }
    }

    fn look_alike(&self, start: usize, c: char, name: &str, instead: &str) -> Diagnostic {
        let span = self.span(start, start + c.len_utf8());
        let quoted = Some(start + c.len_utf8()).filter(|_| instead == "\"").and_then(|inside| {
            let line = &self.text[inside..self.line_end(inside)];
            let (end, close) =
                line.char_indices().find(|(_, c)| LOOK_ALIKES.iter().any(|l| l.2 == "\"" && l.0.contains(*c)))?;
            Some((self.span(start, inside + end + close.len_utf8()), format!("\"{}\"", &line[..end])))
        });
        let (fixed, put) = quoted.unwrap_or((span, instead.to_string()));
        let shown = if instead.trim().is_empty() { format!("U+{:04X}", c as u32) } else { c.to_string() };
        let help = match instead {
            "" => "delete it".to_string(),
            " " => "type a plain space".to_string(),
            _ => format!("write `{}`", instead.trim()),
        };
        Diagnostic::error(
            "mavc::syntax::character",
            span,
            format!("`{shown}` ({name}) does not belong to the language"),
        )
        .here("this character")
        .help(help)
        .fix(fixed, put)
    }

    fn single_quote(&mut self, start: usize) -> Diagnostic {
        let rest = &self.text[start + 1..];
        let close = rest.find(['\'', '\n']).filter(|&i| rest.as_bytes()[i] == b'\'').map(|i| start + 1 + i);
        let after = close.map_or(start + 1, |c| c + 1);
        self.at = after;
        if self.text[..start].ends_with(|c: char| c.is_ascii_digit()) {
            self.at = start + 1;
            let span = self.span(start, start + 1);
            return Diagnostic::error("mavc::syntax::character", span, "`'` is not a unit")
                .here("not expected after a number")
                .help("the foot is written `ft`")
                .fix(span, " ft");
        }
        let span = self.span(start, after);
        let diagnostic = Diagnostic::error("mavc::syntax::character", span, "a text needs double quotes")
            .here("single quotes mean nothing here");
        match close {
            Some(c) => {
                let text = &self.text[start + 1..c];
                diagnostic.help(format!("write `\"{}\"`", cut(text))).fix(span, format!("\"{text}\""))
            }
            None => diagnostic.help("write `\"`"),
        }
    }

    /// A name with letters beyond ASCII, shown whole.
    fn foreign_letter(&mut self, start: usize) -> Diagnostic {
        let bytes = self.text.as_bytes();
        let before = bytes[..start].iter().rev().take_while(|b| is_name(**b as char)).count();
        let after = self.text[start..]
            .find(|c: char| !(c.is_alphanumeric() || c == '_'))
            .map_or(self.text.len(), |i| start + i);
        self.at = after.max(self.at);
        let word = cut(&self.text[start - before..after]);
        Diagnostic::error(
            "mavc::syntax::character",
            self.span(start - before, after),
            format!("the name `{word}` has a letter beyond a to z"),
        )
        .here("names are made of a to z, A to Z, 0 to 9 and `_`")
        .help("spell it with plain letters")
    }

    fn unknown_character(&self, start: usize, c: char) -> Diagnostic {
        let shown = if c.is_control() { String::new() } else { format!("`{c}` ") };
        let message = format!("the character {shown}(U+{:04X}) does not belong to the language", c as u32);
        let span = self.span(start, start + c.len_utf8());
        let diagnostic = Diagnostic::error("mavc::syntax::character", span, message).here("this character");
        // The wide forms of East Asian keyboards are in the order of ASCII.
        match u32::from(c).checked_sub(0xfee0).and_then(char::from_u32).filter(char::is_ascii_graphic) {
            Some(plain) => diagnostic.help(format!("write `{plain}`")).fix(span, plain.to_string()),
            None => diagnostic.help("delete it, or put it in a comment or a text"),
        }
    }
}
