//! What is wrong with a statement that cannot be read, said in its author's terms.

use super::ast::{Block, Statement};
use super::place::{Kind, Place};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};

/// What could have stood where a statement fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Expected {
    Equals,
    Relation,
    Name,
    Text,
    Value,
    Word(&'static str),
    Effect,
    Clause,
    Closing(char),
    Comma,
    Unit,
    Operator,
    End,
}

/// Where a statement fails (bytes from its start) and what could have stood there, sorted.
pub(super) struct Failure {
    pub at: usize,
    pub expected: Vec<Expected>,
}

/// A statement that cannot be read.
pub(super) struct Broken<'a> {
    pub file: FileId,
    /// The statement, or its head where it has a body.
    pub text: &'a str,
    /// Where it starts in the file.
    pub start: usize,
    pub place: Place,
    pub has_body: bool,
}

pub(super) fn explain(statement: &Broken, failure: &Failure) -> Diagnostic {
    let at = statement.start + failure.at;
    let span = Span::new(statement.file, at, at + 1);
    Diagnostic::error(
        "mavc::syntax::unexpected",
        span,
        format!("expected {:?}", failure.expected),
    )
}

pub(super) fn unknown_block(word: &str, span: Span, place: Place) -> (Diagnostic, Option<Place>) {
    let meant = place.meant(word);
    let diagnostic = Diagnostic::error(
        "mavc::syntax::unknown_statement",
        span,
        format!("no block is called `{word}`"),
    );
    (diagnostic, meant.and_then(Place::of_block))
}

pub(super) fn check_head(block: Block, kind: Place) -> Result<Statement, Box<Diagnostic>> {
    let _ = kind;
    Ok(Statement::Block(block))
}

pub(super) fn misplaced(kind: Kind, place: Place, word: &str, span: Span) -> Diagnostic {
    let home = kind.home().map_or("elsewhere", Place::phrase);
    Diagnostic::error(
        "mavc::syntax::misplaced",
        span,
        format!("`{word}` stands {home}, not {}", place.phrase()),
    )
}
