//! Text to words, marks and comments. The text is known to be free of errors.

use super::role::{Role, Roles};
use crate::syntax::scan::{self, Lexeme, LexemeKind};

/// A word, a mark or a comment, and how many line breaks precede it.
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

/// Every token except a `;` that separates nothing: at the end of a line, before a `}`, or after another `;`.
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
                // If it begins a line, the next token begins that line.
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
    let mut at = scan::byte_order_mark(text);
    let (mut breaks, mut brackets, mut in_statement) = (1, 0_usize, false);
    while let Some(Lexeme { kind, start, mut end }) = scan::lexeme(text, at) {
        let mut sort = Sort::Word;
        match kind {
            LexemeKind::Newline => {
                breaks += 1;
                in_statement &= brackets > 0;
                at = end;
                continue;
            }
            LexemeKind::Comment | LexemeKind::Doc => {
                let is_doc = scan::is_doc(&text[start..end]) && !in_statement;
                sort = if is_doc { Sort::Doc } else { Sort::Comment };
            }
            _ => {
                if let Some(Role::Unit(last)) = roles.words.get(&start) {
                    end = *last;
                }
                match kind {
                    LexemeKind::Mark('(' | '[') => brackets += 1,
                    LexemeKind::Mark(')' | ']') => brackets = brackets.saturating_sub(1),
                    _ => {}
                }
                in_statement = !matches!(kind, LexemeKind::Mark('{' | '}' | ';'));
            }
        }
        tokens.push(Token { text: &text[start..end], start, breaks, sort });
        (breaks, at) = (0, end);
    }
    tokens
}
