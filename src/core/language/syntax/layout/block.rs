//! `{ }`: which block was left open, and which brace closes nothing.

use super::{Scanner, is_blank};
use crate::diagnostic::Diagnostic;
use crate::language::Place;
use crate::source::Span;
use crate::syntax::cut;

/// A block whose closing brace has not been met.
#[derive(Clone, Copy)]
pub(super) struct OpenBlock {
    /// Offset of the block's first word.
    head: usize,
    brace: usize,
    /// Start and indentation of the line with the head.
    pub line: usize,
    pub indent: usize,
}

impl Scanner<'_> {
    pub(super) fn open_block(&mut self, brace: usize) {
        self.close_brackets(brace);
        let head = self.statement.unwrap_or(brace);
        self.blocks.push(OpenBlock { head, brace, line: self.line_start, indent: self.line_indent });
        self.end_statement();
    }

    pub(super) fn close_block(&mut self, at: usize) {
        self.close_brackets(at);
        self.end_statement();
        let Some(block) = self.blocks.pop() else {
            self.report_stray(at);
            return;
        };
        if self.left_open.is_none() && self.seems_meant_for_outer(at, block) {
            self.left_open = Some(block);
        }
        if self.blocks.is_empty() {
            self.left_open = None;
            self.last_close = Some((block, at));
        }
    }

    /// The blocks open at `at` end there, and one of them should have ended before.
    pub(super) fn close_blocks(&mut self, at: usize) {
        let open = std::mem::take(&mut self.blocks);
        let misaligned = self.left_open.take();
        let culprit = misaligned.or(open.last().copied());
        let Some(block) = culprit.filter(|_| !open.is_empty()) else {
            return;
        };
        let name = self.head_text(block);
        let mut diagnostic = Diagnostic::error(
            "mavc::syntax::unclosed_block",
            self.span(block.brace, block.brace + 1),
            format!("the block `{name}` is never closed"),
        )
        .here("opened here")
        .help("write `}` where it should end");
        let (word, _) = self.name_at(at);
        if !word.is_empty() {
            let start = self.skip_while(at, is_blank);
            let message = format!("`{word}` is only allowed at the top level, but a block is still open here");
            diagnostic = diagnostic.also(self.span(start, start + word.len()), message);
        }
        if misaligned.is_some() {
            if let Some(line) = self.less_indented(block) {
                let indent = &self.text[block.line..][..block.indent];
                diagnostic = diagnostic.fix(self.span(line, line), format!("{indent}}}\n"));
            }
        } else {
            // Without evidence from the indentation, all open blocks end after the last thing written.
            let last = self.out[..at].iter().rposition(|b| !b.is_ascii_whitespace());
            let end = self.line_end(last.map_or(at, |last| last + 1)).min(at);
            let braces = open.iter().rev().map(|block| {
                let line = &self.text[block.line..];
                format!("\n{}}}", &line[..block.indent])
            });
            diagnostic = diagnostic.fix(self.span(end, end), braces.collect::<String>());
        }
        self.report(diagnostic);
        self.layout.blocks_unsure = true;
        self.layout.left_open.push(block.brace);
    }

    /// The first line in a block that is not indented more than its head: the block should have ended above.
    fn less_indented(&self, block: OpenBlock) -> Option<usize> {
        let mut line = self.line_end(block.brace);
        loop {
            line += self.out[line..].iter().position(|b| *b == b'\n')? + 1;
            let content = self.out[line..].iter().position(|b| !is_blank(*b as char))?;
            if self.out[line + content] != b'\n' && content <= block.indent {
                return Some(line);
            }
        }
    }

    fn report_stray(&mut self, at: usize) {
        let span = self.span(at, at + 1);
        let mut diagnostic =
            Diagnostic::error("mavc::syntax::stray_brace", span, "`}` closes nothing").here("no block is open here");
        if let Some((block, close)) = self.too_early.or(self.last_close) {
            let message = format!("`{}` was closed here", self.head_text(block));
            diagnostic = diagnostic.also(self.span(close, close + 1), message);
        }
        // Where statements of a block follow at the top level, the brace before them came too early.
        let extra = self.alone(self.too_early.map_or(at, |(_, close)| close));
        self.report(diagnostic.help("remove the brace that is one too many").fix(extra, ""));
        self.layout.blocks_unsure = true;
        self.out[at] = b' ';
    }

    /// The brace at `at`, with its line if it is alone on it.
    fn alone(&self, at: usize) -> Span {
        let (before, behind) = (self.text[..at].trim_end_matches([' ', '\t']), &self.text[at + 1..]);
        let above = before.strip_suffix("\r\n").or(before.strip_suffix('\n'));
        let is_alone = behind.is_empty() || behind.starts_with(['\n', '\r']);
        self.span(above.filter(|_| is_alone).map_or(at, str::len), at + 1)
    }

    /// A statement that starts at `start`, outside all blocks: one that belongs in a block shows that the brace before
    /// it came too early.
    pub(super) fn note_outside(&mut self, start: usize) {
        let (word, _) = self.name_at(start);
        self.too_early = match word {
            "gravity" => self.too_early,
            _ if Place::Top.openers().contains(&word) => None,
            _ => self.too_early.or(self.last_close),
        };
    }

    /// A brace that begins its line and lines up with an outer block rather than with the one it closes.
    fn seems_meant_for_outer(&self, at: usize, block: OpenBlock) -> bool {
        let column = self.line_indent;
        self.line_start + column == at
            && self.line_start != block.line
            && block.indent != column
            && self.blocks.iter().any(|outer| outer.indent == column)
    }

    /// The block's head as written, cut short where it is long.
    fn head_text(&self, block: OpenBlock) -> String {
        let head = self.text[block.head..block.brace].trim_end();
        if head.is_empty() { "{".to_string() } else { cut(head) }
    }

    /// Whether a block that is only allowed at the top level begins at `at`.
    pub(super) fn top_level_begins(&self, at: usize) -> bool {
        let (word, next) = self.name_at(at);
        match word {
            "vehicle" | "mission" => !self.name_at(next).0.is_empty() || self.text[next..].starts_with('{'),
            "plan" | "faults" | "simulate" | "campaign" => self.text[next..].starts_with('{'),
            _ => false,
        }
    }
}
