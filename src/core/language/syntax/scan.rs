//! The scanner: splits a text into words, numbers, texts, comments and marks, whatever errors it has.
//!
//! The layout before the grammar, the formatter and the language server all use it. It knows single lexemes only: its
//! callers decide where a statement ends, and where a text without a closing quote was meant to end.

/// What a run of characters is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LexemeKind {
    /// Letters, digits and `_`, with a letter or `_` in front.
    Word,
    /// `12`, `1.5`, `8.5e-6`; the dots of `0..4` are not part of it.
    Number,
    /// In double quotes, the quotes included.
    Text,
    /// A text without its closing quote, up to the end of the line.
    UnclosedText,
    /// `// ...`, up to the end of the line.
    Comment,
    /// `/// ...` on a line of its own; only `lexemes` distinguishes it from another comment.
    Doc,
    Newline,
    /// One character of any other kind.
    Mark(char),
    /// `<=`, `>=`, `+-` or `..`
    Pair,
}

/// One word or mark, in bytes `start..end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lexeme {
    pub kind: LexemeKind,
    pub start: usize,
    pub end: usize,
}

impl Lexeme {
    /// Its text in the whole that it was read from.
    pub fn text<'t>(&self, whole: &'t str) -> &'t str {
        whole.get(self.start..self.end).unwrap_or("")
    }

    pub fn is(&self, mark: char) -> bool {
        self.kind == LexemeKind::Mark(mark)
    }
}

/// All lexemes of a text in their order, without a byte order mark.
pub fn lexemes(text: &str) -> impl Iterator<Item = Lexeme> {
    let (mut at, mut line_is_blank) = (byte_order_mark(text), true);
    std::iter::from_fn(move || {
        let mut lexeme = lexeme(text, at)?;
        if lexeme.kind == LexemeKind::Comment && line_is_blank && is_doc(lexeme.text(text)) {
            lexeme.kind = LexemeKind::Doc;
        }
        (at, line_is_blank) = (lexeme.end, lexeme.kind == LexemeKind::Newline);
        Some(lexeme)
    })
}

/// The first lexeme at or after `from`, past blanks.
pub fn lexeme(text: &str, from: usize) -> Option<Lexeme> {
    let start = after_blanks(text, from);
    let rest = text.get(start..)?;
    let first = rest.chars().next()?;
    let (kind, length) = match first {
        '\n' => (LexemeKind::Newline, 1),
        '/' if rest.starts_with("//") => (LexemeKind::Comment, line(rest).trim_end().len()),
        '"' => {
            // Not beyond the closing quote: many texts on one long line would take quadratic time.
            let inside = rest[1..].find(['"', '\n']).unwrap_or(rest.len() - 1);
            match rest[1 + inside..].starts_with('"') {
                true => (LexemeKind::Text, inside + 2),
                false => (LexemeKind::UnclosedText, rest[..1 + inside].trim_end().len()),
            }
        }
        c if c.is_ascii_digit() => (LexemeKind::Number, number_length(rest)),
        c if is_name(c) => (LexemeKind::Word, run(rest, is_name).len()),
        _ if ["<=", ">=", "+-", ".."].iter().any(|pair| rest.starts_with(pair)) => (LexemeKind::Pair, 2),
        mark => (LexemeKind::Mark(mark), mark.len_utf8()),
    };
    Some(Lexeme { kind, start, end: start + length })
}

/// Whether a comment describes the statement below it, where none is under way: `/// ...`.
pub fn is_doc(comment: &str) -> bool {
    comment.starts_with("///") && !comment.starts_with("////")
}

/// Whether a character may be in a name; a digit may not be in front.
pub fn is_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

pub fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t')
}

/// The run of accepted characters that `text` begins with.
pub fn run(text: &str, accept: impl Fn(char) -> bool) -> &str {
    &text[..text.find(|c: char| !accept(c)).unwrap_or(text.len())]
}

/// The name that `text` begins with; empty where it does not begin with one.
pub fn name(text: &str) -> &str {
    if text.starts_with(|c: char| c.is_ascii_digit()) { "" } else { run(text, is_name) }
}

/// How many bytes a byte order mark takes.
pub fn byte_order_mark(text: &str) -> usize {
    if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 }
}

/// Past spaces and tabs, and carriage returns before a newline.
fn after_blanks(text: &str, from: usize) -> usize {
    let bytes = text.as_bytes();
    let is_blank = |at: usize| match bytes.get(at) {
        Some(b' ' | b'\t') => true,
        Some(b'\r') => bytes.get(at + 1) == Some(&b'\n'),
        _ => false,
    };
    (from..).find(|&at| !is_blank(at)).unwrap_or(from)
}

fn line(text: &str) -> &str {
    text.split('\n').next().unwrap_or(text)
}

fn number_length(text: &str) -> usize {
    let digits = |from: usize| run(&text[from..], |c| c.is_ascii_digit()).len();
    let mut end = digits(0);
    if text[end..].starts_with('.') && digits(end + 1) > 0 {
        end += 1 + digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_numbers_texts_and_comments_are_recognised() {
        let text = "/// doc\nmass = 1.5e-3 kg // note\r\nlet a = 0..4*pi; use \"x.mav\ny é";
        let all: Vec<Lexeme> = lexemes(text).collect();
        let shown: Vec<&str> = all.iter().filter(|l| l.kind != LexemeKind::Newline).map(|l| l.text(text)).collect();
        assert_eq!(
            shown,
            [
                "/// doc", "mass", "=", "1.5e-3", "kg", "// note", "let", "a", "=", "0", "..", "4", "*", "pi", ";",
                "use", "\"x.mav", "y", "é"
            ]
        );
        assert_eq!([all[0].kind, all[6].kind], [LexemeKind::Doc, LexemeKind::Comment]);
        assert!(is_doc("/// doc") && !is_doc("// note") && !is_doc("//// rule"));
        assert_eq!(lexemes("\u{1F600}").count(), 1);
        let texts: Vec<Lexeme> = lexemes("\"a\" \"b  \n\"\" \"").filter(|l| l.kind != LexemeKind::Newline).collect();
        let ends: Vec<(usize, usize)> = texts.iter().map(|l| (l.start, l.end)).collect();
        assert_eq!(ends, [(0, 3), (4, 6), (9, 11), (12, 13)]);
    }
}
