//! A `}` that closes nothing is one too many, or belongs to a `{` that is missing above. Where such a guess makes the
//! braces match, the text is laid out again under this assumption, and only its one error is reported.

use super::{Scanner, is_blank, is_name};
use crate::diagnostic::Diagnostic;
use crate::language::Place;
use crate::syntax::cut;

/// Readings tried for one text.
const MAX_GUESSES: usize = 8;

/// What may explain a brace that is left over; offsets into the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Guess {
    /// The head that starts here was meant to open a block.
    Head(usize),
    /// The top-level block on the line that starts here is nested in another one.
    Nested(usize),
}

pub(super) struct Guesses {
    /// Those assumed on this pass.
    pub taken: Vec<Guess>,
    /// Heads without a brace for which a `}` seems to be meant.
    heads: Vec<usize>,
    /// Lines where blocks left open were ended.
    pub cuts: Vec<usize>,
    /// The first brace that is left over.
    pub stray: Option<usize>,
    /// Braces that do not match.
    pub errors: usize,
}

/// The head of a block without `{` after it.
#[derive(Clone, Copy)]
pub(super) struct Unopened {
    head: usize,
    /// Where the head ends.
    end: usize,
    line: usize,
    indent: usize,
    /// Blocks open around it.
    depth: usize,
}

impl Guesses {
    pub fn new(taken: Vec<Guess>) -> Self {
        Guesses { taken, heads: Vec::new(), cuts: Vec::new(), stray: None, errors: 0 }
    }

    pub fn is_nested(&self, line: usize) -> bool {
        self.taken.contains(&Guess::Nested(line))
    }

    /// What to try next: the last suspect before the brace that is left over.
    pub fn next(&self) -> Option<Guess> {
        let stray = self.stray.filter(|_| self.taken.len() < MAX_GUESSES)?;
        let heads = self.heads.iter().map(|&at| (at, Guess::Head(at)));
        let cuts = self.cuts.iter().map(|&at| (at, Guess::Nested(at)));
        heads.chain(cuts).filter(|(at, _)| *at < stray).max_by_key(|(at, _)| *at).map(|(_, guess)| guess)
    }
}

impl Scanner<'_> {
    /// Remembers the head of a block that starts at `head` and has no `{`.
    pub(super) fn note_head(&mut self, head: usize) {
        if let Some(end) = self.head_end(head) {
            let (line, indent, depth) = (self.line_start, self.line_indent, self.blocks.len());
            self.unopened = Some(Unopened { head, end, line, indent, depth });
        }
    }

    /// Whether the `}` at `at` closes a block that was never opened. If so, reports the head and puts a `{` into the
    /// blank after it.
    pub(super) fn closes_unopened(&mut self, at: usize) -> bool {
        let Some(unopened) = self.unopened.filter(|u| u.depth == self.blocks.len()) else {
            return false;
        };
        let Unopened { head, end, line, indent, .. } = unopened;
        let around = self.blocks.last();
        let on_its_line = line == self.line_start && around.is_none_or(|block| block.line != line);
        let begins_its_line = self.line_start + self.line_indent == at;
        let lines_up = begins_its_line && indent == self.line_indent && around.is_none_or(|b| b.indent < indent);
        if !(on_its_line || lines_up) || self.text.get(end..at).is_none_or(|between| between.trim().is_empty()) {
            return false;
        }
        if !self.guesses.taken.contains(&Guess::Head(head)) {
            self.guesses.heads.push(head);
            return false;
        }
        let shown = cut(&self.text[head..end]);
        let diagnostic = Diagnostic::error(
            "mavc::syntax::missing_brace",
            self.span(head, end),
            format!("`{shown}` has no `{{` on its line"),
        );
        let help = if on_its_line { "write `{` after it" } else { "write `{` at the end of this line" };
        self.report(diagnostic.here("a block must open on this line").help(help).fix(self.span(end, end), " {"));
        self.out[end] = b'{';
        self.unopened = None;
        true
    }

    /// Where the head of a block that starts at `head` ends, if a blank follows it rather than `{`.
    fn head_end(&self, head: usize) -> Option<usize> {
        let (word, next) = self.name_at(head);
        let stop = self.skip_while(head, |c| !matches!(c, '\n' | ';' | '{' | '}'));
        let end = match Place::of_block(word) {
            _ if word == "every" => self.name_end(head + self.text[head..stop].find(" as ")? + " as ".len())?,
            Some(place) => {
                let end = if place.is_named() { self.name_end(next)? } else { self.name_end(head)? };
                let after = self.skip_while(end, is_blank).min(stop);
                match self.text[after..stop].strip_prefix('"').filter(|_| place == Place::Mode) {
                    Some(title) => after + 1 + title.find('"')? + 1,
                    None => end,
                }
            }
            None => return None,
        };
        let rest = self.text.get(end..stop)?;
        let (field, behind) = self.name_at(end);
        let is_field = !field.is_empty() && self.text[behind..].starts_with('=');
        let opens = match word {
            // `rotor 3 lost` and `rotor at [..] m` are statements.
            "rotor" => is_field || rest.trim().is_empty(),
            _ => !field.is_empty() || rest.trim().is_empty() || rest.trim_start().starts_with("//"),
        };
        (opens && self.text[end..].starts_with([' ', '\t', '\n', '\r'])).then_some(end)
    }

    /// The end of the name at `at`, after blanks.
    fn name_end(&self, at: usize) -> Option<usize> {
        let start = self.skip_while(at, is_blank);
        (!self.name_at(at).0.is_empty()).then(|| self.skip_while(start, is_name))
    }
}
