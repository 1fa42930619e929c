//! A text in words and marks, whatever is wrong with it: for half-typed statements, which have no tree.

/// What a run of characters is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Letters, digits and `_`, with a letter or `_` in front.
    Word,
    Number,
    /// In double quotes; the last one of a line may lack its end.
    Text,
    /// `// ...`
    Comment,
    /// `/// ...` on a line of its own.
    Doc,
    /// One character of any other kind; the newline is one of them.
    Mark(char),
}

/// One word or mark, in bytes `start..end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lexeme {
    pub kind: Kind,
    pub start: usize,
    pub end: usize,
}

impl Lexeme {
    /// Its text in the whole that it was read from.
    pub fn text<'t>(&self, whole: &'t str) -> &'t str {
        whole.get(self.start..self.end).unwrap_or("")
    }

    pub fn is(&self, mark: char) -> bool {
        self.kind == Kind::Mark(mark)
    }
}

/// All words and marks of a text in their order; blanks are left out.
pub fn lexemes(text: &str) -> Vec<Lexeme> {
    let mut found: Vec<Lexeme> = Vec::new();
    let mut rest = text;
    let mut line_is_blank = true;
    while let Some(first) = rest.chars().next() {
        let start = text.len() - rest.len();
        let (kind, length) = match first {
            ' ' | '\t' | '\r' => {
                rest = &rest[1..];
                continue;
            }
            '/' if rest.starts_with("//") => {
                let is_doc = line_is_blank && rest.starts_with("///") && !rest.starts_with("////");
                let line = rest.split('\n').next().unwrap_or(rest).trim_end();
                (if is_doc { Kind::Doc } else { Kind::Comment }, line.len())
            }
            '"' => {
                // Not beyond the closing quote: many texts on one long line would take quadratic time.
                let inside = rest[1..].find(['"', '\n']).unwrap_or(rest.len() - 1);
                let closed = rest[1 + inside..].starts_with('"');
                (Kind::Text, if closed { inside + 2 } else { rest[..1 + inside].trim_end().len() })
            }
            c if c.is_ascii_digit() => (Kind::Number, number_length(rest)),
            c if c.is_ascii_alphabetic() || c == '_' => {
                let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
                (Kind::Word, end.unwrap_or(rest.len()))
            }
            mark => (Kind::Mark(mark), mark.len_utf8()),
        };
        line_is_blank = first == '\n';
        found.push(Lexeme { kind, start, end: start + length });
        rest = &rest[length..];
    }
    found
}

/// `12`, `1.5`, `8.5e-6`; the dots of `0..4` are no part of it.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
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
    fn words_numbers_texts_and_comments_are_told_apart() {
        let text = "/// doc\nmass = 1.5e-3 kg // note\nlet a = 0..4*pi; use \"x.mav\ny é";
        let all = lexemes(text);
        let shown: Vec<&str> = all.iter().filter(|l| !l.is('\n')).map(|l| l.text(text)).collect();
        assert_eq!(
            shown,
            [
                "/// doc", "mass", "=", "1.5e-3", "kg", "// note", "let", "a", "=", "0", ".", ".", "4", "*", "pi", ";",
                "use", "\"x.mav", "y", "é"
            ]
        );
        assert_eq!(all[0].kind, Kind::Doc);
        assert_eq!(all[6].kind, Kind::Comment);
        assert_eq!(lexemes("\u{1F600}").len(), 1);
        let texts: Vec<Lexeme> = lexemes("\"a\" \"b  \n\"\" \"");
        let ends: Vec<(usize, usize)> = texts.iter().map(|l| (l.start, l.end)).collect();
        assert_eq!(ends, [(0, 3), (4, 6), (8, 9), (9, 11), (12, 13)]);
    }
}
