//! Statements that cannot be read: one error each, and what their bodies hold.

use super::{Builder, Rule, expected};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, StatementKind};
use crate::source::{Span, Spanned};
use crate::syntax::MAX_ERRORS;
use crate::syntax::ast::{Block, Statement};
use crate::syntax::mistake;
use pest::iterators::Pair;

impl Builder<'_> {
    /// Something between separators that is not a statement: reported once, then its body is read.
    pub(super) fn broken(&mut self, pair: Pair<Rule>, place: Place) -> Statement {
        let span = self.span(&pair);
        let (mut head, mut body) = ("", None);
        let mut start = span.start as usize;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::broken_text => {
                    // The grammar's blanks are ASCII; here all of Unicode's go.
                    head = part.as_str().trim();
                    start += part.as_str().len() - part.as_str().trim_start().len();
                }
                Rule::body => body = Some(part),
                _ => {}
            }
        }
        let late = self.late_brace.take().filter(|(brace, _)| *brace == start);
        let word = head.split(|c: char| !c.is_ascii_alphanumeric()).next().unwrap_or(head);
        let is_waypoint = word == "waypoint" && place == Place::Mission;
        let of_word = if is_waypoint { Some(Place::Limits) } else { Place::of_head(word) };
        let inside = late.map(|(_, inside)| inside).or(of_word).unwrap_or(Place::Unknown);
        let has_body = body.is_some();
        if !has_body {
            let rest = self.text[start + head.len()..].trim_start();
            self.late_brace = rest.starts_with('{').then_some((self.text.len() - rest.len(), inside));
        }
        if late.is_none() {
            let below = start + head.len();
            let brace_below = self.late_brace.map(|(brace, _)| &self.text[below..brace]);
            self.explain(mistake::Broken { file: self.file, text: head, start, place, has_body, brace_below });
        }
        let Some(body) = body else { return Statement::Broken(span) };
        let mut statements = self.body(body, inside);
        let fits = match inside {
            Place::Every => StatementKind::Every.fits(place),
            Place::Unknown | Place::Curve => false,
            _ => StatementKind::Block(inside).fits(place),
        };
        if !fits || is_waypoint || place == Place::Unknown {
            return Statement::Broken(span);
        }
        // Whatever its head means, the statements of the block are checked.
        let head_end = start + head.len();
        statements.push(Statement::Broken(Span::new(self.file, start, head_end)));
        let keyword = inside.keyword().unwrap_or("every").to_string();
        let keyword = Spanned::new(keyword, Span::new(self.file, start, start + word.len()));
        Statement::Block(Block { keyword, name: None, title: None, body: statements, doc: None, span })
    }

    fn explain(&mut self, statement: mistake::Broken) {
        let (start, end) = (statement.start, statement.start + statement.text.len());
        if self.is_settled(start, end) || self.diagnostics.len() > MAX_ERRORS {
            return;
        }
        let alone = |text: &str, has_body| expected::failure(text, statement.place, has_body);
        let separations = mistake::separations(&statement, alone);
        if !separations.is_empty() {
            self.diagnostics.extend(separations);
            return;
        }
        let failure = expected::failure(statement.text, statement.place, statement.has_body)
            .unwrap_or_else(|| mistake::Failure { at: statement.text.len(), expected: vec![mistake::Expected::End] });
        self.diagnostics.push(mistake::explain(&statement, &failure));
    }

    /// A block's end and the statement that starts at `next` need a new line or `;` between them.
    pub(super) fn expect_separator(&mut self, end: usize, next: Span) {
        let start = next.start as usize;
        if self.text[end..start].contains(['\n', ';', '\u{4}']) || self.is_settled(start, next.end as usize) {
            return;
        }
        let length = self.text[start..].chars().next().map_or(0, char::len_utf8);
        self.diagnostics.push(
            Diagnostic::error(
                "mavc::syntax::separator",
                Span::new(self.file, start, start + length),
                "a new line or `;` must follow a block's `}`",
            )
            .here("the next statement begins on the same line")
            .help("start a new line here")
            .fix(Span::new(self.file, start, start), "\n"),
        );
        self.settle(start);
    }

    /// No more errors for the statement around `at`.
    pub(super) fn settle(&mut self, at: usize) {
        let place = self.settled.partition_point(|&s| (s as usize) < at);
        self.settled.insert(place, at as u32);
    }

    /// Whether an error has been reported for the statement from `start` to `end`.
    fn is_settled(&self, start: usize, end: usize) -> bool {
        let first = self.settled.partition_point(|&s| (s as usize) < start);
        self.settled.get(first).is_some_and(|&s| (s as usize) < end)
    }
}
