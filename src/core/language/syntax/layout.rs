//! What is decided before the grammar: comments, line joining, and whether brackets and braces match.
//!
//! [`lay_out`] returns a text of the same length in which every remaining byte keeps its offset. Comments become
//! blanks, and so do newlines inside `( )` and `[ ]`. A bracket left open ends where the next line can only begin a
//! statement; a block left open ends where the next top-level block begins, marked by [`CUT`]. Both errors are reported
//! here, because only here the whole text is known.

mod block;
mod bracket;
mod character;

use super::scan::{self, Lexeme, LexemeKind, is_blank, is_name};
use super::{MAX_DEPTH, MAX_ERRORS, MAX_STATEMENTS, MAX_TOKENS};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use block::OpenBlock;

/// Replaces a newline that also ends every open block.
const CUT: u8 = 4;

/// A text ready for the grammar.
pub(super) struct Layout {
    pub text: String,
    /// In the order written.
    pub docs: Vec<Doc>,
    pub diagnostics: Vec<Diagnostic>,
    /// The text exceeds a limit and is not parsed.
    pub too_much: bool,
    /// Blocks may end elsewhere than the author meant.
    pub blocks_unsure: bool,
    /// The opening braces of the blocks that were left open, judged by indentation.
    pub left_open: Vec<usize>,
}

/// One `///` line.
pub(super) struct Doc {
    pub span: Span,
    pub text: String,
}

pub(super) fn lay_out(file: FileId, text: &str) -> Layout {
    let mut scanner = Scanner {
        file,
        text,
        out: text.as_bytes().to_vec(),
        at: 0,
        brackets: Vec::new(),
        blocks: Vec::new(),
        left_open: None,
        last_close: None,
        too_early: None,
        line_start: 0,
        line_indent: 0,
        statement: None,
        quiet: false,
        comment_ends: true,
        tokens: 0,
        statements: 0,
        layout: Layout {
            text: String::new(),
            docs: Vec::new(),
            diagnostics: Vec::new(),
            too_much: false,
            blocks_unsure: false,
            left_open: Vec::new(),
        },
    };
    scanner.run();
    let mut layout = scanner.layout;
    // Only whole characters are overwritten, and only by ASCII, so the bytes stay UTF-8.
    layout.text = String::from_utf8(scanner.out).unwrap_or_default();
    layout
}

struct Scanner<'a> {
    file: FileId,
    text: &'a str,
    out: Vec<u8>,
    /// Byte offset of the next character.
    at: usize,
    /// Offsets of the open `(` and `[` of this statement.
    brackets: Vec<usize>,
    blocks: Vec<OpenBlock>,
    /// An inner block whose `}` seems to be missing, judged by indentation.
    left_open: Option<OpenBlock>,
    /// The last top-level block and its closing brace.
    last_close: Option<(OpenBlock, usize)>,
    /// The one after which a statement follows that belongs in a block.
    too_early: Option<(OpenBlock, usize)>,
    /// Where the current line starts, and how many blanks it starts with.
    line_start: usize,
    line_indent: usize,
    /// Where the current statement began.
    statement: Option<usize>,
    /// This statement's odd characters have been reported.
    quiet: bool,
    /// False once no `*/` follows.
    comment_ends: bool,
    tokens: usize,
    statements: usize,
    layout: Layout,
}

impl Scanner<'_> {
    fn run(&mut self) {
        self.at = scan::byte_order_mark(self.text);
        self.blank(0, self.at);
        if let Some(at) = self.text.find('\r').filter(|_| !self.text.contains('\n')) {
            let message = "lines end with a carriage return alone, so the file is one long line";
            let diagnostic = Diagnostic::error("mavc::syntax::character", self.span(at, at + 1), message);
            self.report(diagnostic.here("the first one").help("save the file with Unix or Windows line ends"));
            self.layout.too_much = true;
        }
        self.begin_line();
        while self.at < self.text.len() && !self.layout.too_much {
            self.step();
        }
        if !self.layout.too_much {
            self.close_brackets(self.text.len());
            self.close_blocks(self.text.len());
        }
    }

    fn step(&mut self) {
        let Some(lexeme) = scan::lexeme(self.text, self.at) else {
            self.at = self.text.len();
            return;
        };
        self.at = lexeme.start;
        match lexeme.kind {
            LexemeKind::Newline => self.newline(),
            LexemeKind::Comment | LexemeKind::Doc => self.comment(),
            LexemeKind::Mark('/') if self.text[self.at..].starts_with("/*") => self.foreign_comment(),
            LexemeKind::Mark('#') => self.hash(),
            _ => self.token(lexeme),
        }
    }

    /// Anything that belongs to a statement.
    fn token(&mut self, lexeme: Lexeme) {
        let start = lexeme.start;
        if self.statement.is_none() && !lexeme.is('}') && !lexeme.is(';') {
            self.statement = Some(start);
            self.statements += 1;
            if self.blocks.is_empty() {
                self.note_outside(start);
            }
        }
        self.tokens += 1;
        self.at = lexeme.end;
        match lexeme.kind {
            LexemeKind::UnclosedText => self.unclosed_text(start),
            LexemeKind::Mark('(' | '[') => self.brackets.push(start),
            LexemeKind::Mark(')' | ']') => self.close_bracket(start),
            LexemeKind::Mark('{') => self.open_block(start),
            LexemeKind::Mark('}') => self.close_block(start),
            LexemeKind::Mark(';') => {
                self.close_brackets(start);
                self.end_statement();
            }
            LexemeKind::Mark(c) if !c.is_ascii_graphic() || c == '\'' => self.odd_character(start),
            _ => {}
        }
        if self.tokens > MAX_TOKENS {
            self.limit("mavc::syntax::tokens", start, format!("a file holds at most {MAX_TOKENS} words and marks"));
        } else if self.statements > MAX_STATEMENTS {
            self.limit("mavc::syntax::statements", start, format!("a file holds at most {MAX_STATEMENTS} statements"));
        } else if self.brackets.len() + self.blocks.len() > MAX_DEPTH {
            self.limit("mavc::syntax::depth", start, format!("brackets and blocks nest at most {MAX_DEPTH} deep"));
        }
    }

    fn limit(&mut self, code: &'static str, at: usize, message: String) {
        let length = self.text[at..].chars().next().map_or(0, char::len_utf8);
        let diagnostic = Diagnostic::error(code, self.span(at, at + length), message).here("the limit is passed here");
        let help = match code {
            "mavc::syntax::depth" => "move a part into a `let`",
            _ => "split the spec into several files and join them with `use`",
        };
        self.report(diagnostic.help(help));
        self.layout.too_much = true;
    }

    /// A newline ends the statement unless a bracket is open that may still be closed.
    fn newline(&mut self) {
        let start = self.at;
        self.at += 1;
        if self.text[..start].ends_with('\r') {
            self.blank(start - 1, start);
        }
        self.begin_line();
        if !self.brackets.is_empty() && !self.statement_begins(self.at) {
            self.out[start] = b' ';
            return;
        }
        self.close_brackets(start);
        self.end_statement();
        // One that is indented more than the open block is taken as nested in it.
        let is_outside = self.blocks.first().is_some_and(|outermost| self.line_indent <= outermost.indent);
        if is_outside && self.top_level_begins(self.at) {
            self.close_blocks(self.skip_while(self.at, is_blank));
            self.out[start] = CUT;
        }
    }

    fn begin_line(&mut self) {
        self.line_start = self.at;
        self.line_indent = self.skip_while(self.at, is_blank) - self.at;
    }

    fn end_statement(&mut self) {
        self.statement = None;
        self.quiet = false;
    }

    fn comment(&mut self) {
        let (start, end) = (self.at, self.line_end(self.at));
        let text = &self.text[start..end];
        if scan::is_doc(text) && self.statement.is_none() {
            let span = self.span(start, end);
            self.layout.docs.push(Doc { span, text: text[3..].trim().to_string() });
        }
        self.blank(start, end);
        self.at = end;
    }

    fn hash(&mut self) {
        let (start, end) = (self.at, self.line_end(self.at));
        let mark = self.span(start, start + 1);
        self.report(
            Diagnostic::error("mavc::syntax::comment", mark, "comments begin with `//`, not `#`")
                .here("`#` starts no comment")
                .help("write `//`")
                .fix(mark, "//"),
        );
        self.blank(start, end);
        self.at = end;
    }

    /// `/* .. */` of other languages: skipped like a comment.
    fn foreign_comment(&mut self) {
        let start = self.at;
        let close = if self.comment_ends { self.text[start + 2..].find("*/") } else { None };
        self.comment_ends = close.is_some();
        let end = close.map_or_else(|| self.line_end(start), |i| start + 2 + i + 2);
        let diagnostic = Diagnostic::error(
            "mavc::syntax::comment",
            self.span(start, start + 2),
            "comments begin with `//` and end with the line",
        )
        .here("`/*` starts no comment")
        .help("write `//` before each line of the comment");
        self.report(diagnostic);
        self.blank(start, end);
        self.at = end;
    }

    /// A text whose closing quote is not on its line.
    fn unclosed_text(&mut self, start: usize) {
        let end = self.text_end(start);
        let content = start + self.text[start..end].trim_end().len();
        let span = self.span(start, content);
        let diagnostic = Diagnostic::error("mavc::syntax::unclosed_text", span, "this text is never closed")
            .here("no `\"` follows on this line");
        let after_number = self.text[..start].ends_with(|c: char| c.is_ascii_digit());
        self.report(match after_number {
            true => diagnostic.help("the inch is written `inch`").fix(self.span(start, start + 1), " inch"),
            false => diagnostic.help("close it with `\"`").fix(self.span(content, content), "\""),
        });
        self.blank(start + 1, end);
        self.at = end;
    }

    /// Where a text that starts at `start` and is never closed probably ends: before a comment, a `;`, or the `{` after
    /// the title of a mode.
    fn text_end(&self, start: usize) -> usize {
        let line = &self.text[start..self.line_end(start)];
        let is_title = self.statement.is_some_and(|head| self.name_at(head).0 == "mode");
        let ends = [line.find(" //"), line.find(';'), line.find('{').filter(|_| is_title)];
        start + ends.into_iter().flatten().min().unwrap_or(line.len())
    }

    /// Keeps a diagnostic, up to the number that is shown.
    fn report(&mut self, diagnostic: Diagnostic) {
        if self.layout.diagnostics.len() <= MAX_ERRORS {
            self.layout.diagnostics.push(diagnostic);
        }
    }

    /// Overwrites all but newlines with blanks.
    fn blank(&mut self, start: usize, end: usize) {
        for byte in self.out[start..end].iter_mut().filter(|b| **b != b'\n') {
            *byte = b' ';
        }
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, start, end)
    }

    /// Where the line ends, before `\r\n` or `\n`.
    fn line_end(&self, from: usize) -> usize {
        let end = self.text[from..].find('\n').map_or(self.text.len(), |i| from + i);
        if end > from && self.text.as_bytes()[end - 1] == b'\r' { end - 1 } else { end }
    }

    fn skip_while(&self, from: usize, accept: fn(char) -> bool) -> usize {
        from + scan::run(&self.text[from..], accept).len()
    }

    /// The name that starts at `at` (empty where none does) and the offset of what follows it after blanks.
    fn name_at(&self, at: usize) -> (&str, usize) {
        let start = self.skip_while(at, is_blank);
        let end = self.skip_while(start, is_name);
        (scan::name(&self.text[start..end]), self.skip_while(end, is_blank))
    }
}
