//! The layout of a spec.
//!
//! The author decides the order of statements, where lines break, which statements share a line, and every comment. The
//! formatter decides indentation, blanks inside a line, columns and blank lines; `docs/formatting.md` describes how.
//! The layout depends only on words, comments and line breaks, so formatting twice changes nothing.
//!
//! # Steps
//! 1. `role` takes from the tree what words alone do not show: where a unit ends, which minus is a sign.
//! 2. `token` splits the text into words, marks and comments.
//! 3. `line` puts them on lines again, and `column` lines these up.

mod column;
mod line;
mod role;
mod token;

use crate::diagnostic::{Checked, Severity};
use crate::input::MAX_FILE_BYTES;
use crate::source::{FileId, Source, Span};
use crate::syntax::{parse, too_large};

/// The text of a spec in its layout; the meaning does not change. Lines end like the first one, in `\n` or `\r\n`; a
/// byte order mark is removed.
///
/// Errors in names and units do not matter. There is no value for a text with syntax errors, with the diagnostics of
/// [`parse`], nor where the result would exceed the size that a file may have.
pub fn format(file: FileId, source: &Source) -> Checked<String> {
    let Checked { value, mut diagnostics } = parse(file, source);
    let broken = diagnostics.iter().any(|d| d.severity == Severity::Error);
    let Some(tree) = value.filter(|_| !broken) else {
        return Checked { value: None, diagnostics };
    };
    let roles = role::roles(&tree);
    let tokens = token::tokens(&source.text, &roles);
    let mut lines = line::lines(&tokens, &roles);
    column::line_up(&mut lines);
    let mut text: String = lines.iter().map(ToString::to_string).collect();
    if source.text.split_once('\n').is_some_and(|(first, _)| first.ends_with('\r')) {
        text = text.replace('\n', "\r\n");
    }
    if text.len() > MAX_FILE_BYTES {
        diagnostics.push(too_large(&source.name, Span::new(file, 0, 0), MAX_FILE_BYTES));
        return Checked { value: None, diagnostics };
    }
    Checked { value: Some(text), diagnostics }
}
