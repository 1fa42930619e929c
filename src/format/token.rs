//! Text to words, marks and comments. The text is known to be free of errors.

use super::role::{Role, Roles};

/// A word, a mark or a comment, and how it follows what stands before it.
#[derive(Debug, Clone, Copy)]
pub struct Token<'a> {
    pub text: &'a str,
    /// Byte offset in the text.
    pub start: usize,
    /// Line breaks between the token before and this one; the first one of a text counts as beginning a line.
    pub breaks: usize,
    pub sort: Sort,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Word,
    Comment,
    /// `///` that describes what follows.
    Doc,
}

impl Token<'_> {
    pub fn is_comment(&self) -> bool {
        self.sort != Sort::Word
    }

    pub fn begins_line(&self) -> bool {
        self.breaks > 0
    }
}

/// Every token but the `;` that separate nothing: at the end of a line, before a `}`, or after another.
pub fn tokens<'a>(text: &'a str, roles: &Roles) -> Vec<Token<'a>> {
    let all = all(text, roles);
    let mut kept: Vec<Token> = Vec::with_capacity(all.len());
    let mut dropped = 0;
    for (i, token) in all.iter().enumerate() {
        let breaks = token.breaks + std::mem::take(&mut dropped);
        if token.text == ";" {
            let before = kept.last().is_none_or(|k| k.is_comment() || matches!(k.text, "{" | ";")) || breaks > 0;
            let after = all.get(i + 1).is_none_or(|n| n.begins_line() || n.is_comment() || matches!(n.text, "}" | ";"));
            if before || after {
                // At the beginning of a line the next one begins it.
                dropped = breaks;
                continue;
            }
        }
        kept.push(Token { breaks, ..*token });
    }
    kept
}

fn all<'a>(text: &'a str, roles: &Roles) -> Vec<Token<'a>> {
    let mut tokens = Vec::new();
    let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let (mut breaks, mut brackets, mut in_statement) = (1, 0_usize, false);
    while at < text.len() {
        let rest = &text[at..];
        let byte = rest.as_bytes()[0];
        if byte == b'\n' {
            breaks += 1;
            in_statement &= brackets > 0;
        }
        if byte.is_ascii_whitespace() {
            at += 1;
            continue;
        }
        let mut sort = Sort::Word;
        let length = match roles.words.get(&at) {
            Some(Role::Unit(end)) => end - at,
            _ if rest.starts_with("//") => {
                let is_doc = rest.starts_with("///") && !rest.starts_with("////") && !in_statement;
                sort = if is_doc { Sort::Doc } else { Sort::Comment };
                rest.find('\n').unwrap_or(rest.len())
            }
            _ => word(rest),
        };
        let token = &rest[..length];
        match token {
            _ if sort != Sort::Word => {}
            "(" | "[" => brackets += 1,
            ")" | "]" => brackets = brackets.saturating_sub(1),
            _ => {}
        }
        if sort == Sort::Word {
            in_statement = !matches!(token, "{" | "}" | ";");
        }
        tokens.push(Token { text: token.trim_end(), start: at, breaks, sort });
        breaks = 0;
        at += length;
    }
    tokens
}

/// Bytes of the word or mark that `rest` begins with.
fn word(rest: &str) -> usize {
    let run = |from: usize, accept: fn(&u8) -> bool| {
        from + rest.as_bytes()[from..].iter().position(|b| !accept(b)).unwrap_or(rest.len() - from)
    };
    let digits = |from: usize| run(from, u8::is_ascii_digit);
    let byte_at = |i: usize| rest.as_bytes().get(i).copied().unwrap_or(b' ');
    match rest.as_bytes()[0] {
        b'"' => rest[1..].find('"').map_or(rest.len(), |i| i + 2),
        b'0'..=b'9' => {
            let mut end = digits(0);
            if byte_at(end) == b'.' && byte_at(end + 1).is_ascii_digit() {
                end = digits(end + 1);
            }
            let sign = usize::from(matches!(byte_at(end + 1), b'+' | b'-'));
            if matches!(byte_at(end), b'e' | b'E') && byte_at(end + 1 + sign).is_ascii_digit() {
                end = digits(end + 1 + sign);
            }
            end
        }
        b if b.is_ascii_alphabetic() || b == b'_' => run(0, |b| b.is_ascii_alphanumeric() || *b == b'_'),
        _ if ["<=", ">=", "..", "+-"].iter().any(|mark| rest.starts_with(mark)) => 2,
        _ => rest.chars().next().map_or(1, char::len_utf8),
    }
}
