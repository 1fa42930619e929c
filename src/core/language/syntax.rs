//! Text to tree.
//!
//! # Steps
//! 1. `layout` looks at the whole text: comments become blanks, lines inside brackets are joined, brackets
//!    and braces are matched, limits are kept.
//! 2. The grammar (`grammar/mav.pest`) splits the result into statements; `build` makes the tree ([`ast`]).
//! 3. A statement that fits none is read again alone, and `mistake` explains what is wrong with it.
//! 4. `repair` reads the text again with the fixes of its errors made, so that no error hides another.
//!
//! `scan` splits a text into words and marks, here as in the formatter and in the language server. Names, units and
//! meanings belong to `read`.

pub mod ast;
mod build;
mod layout;
mod mistake;
mod print;
mod repair;
pub mod scan;
pub mod visit;

pub use crate::language::Place;

use crate::diagnostic::{Checked, Diagnostic};
use crate::input::MAX_FILE_BYTES;
use crate::source::{FileId, NotUtf8, Source, Span};
use ast::SpecFile;

/// How deep brackets and blocks nest.
pub const MAX_DEPTH: usize = 64;
/// Statements in one file.
pub const MAX_STATEMENTS: usize = 10_000;
/// Words, numbers, texts and marks in one file.
pub const MAX_TOKENS: usize = 200_000;
/// Height of one expression's tree: operators nested in one another.
pub const MAX_EXPRESSION_DEPTH: usize = 256;
/// Errors shown for one file.
pub const MAX_ERRORS: usize = 200;

/// Reads one file. The tree holds every statement that can be read, some of them as the fixes of their errors would
/// have them. There is no tree only where the text exceeds a limit.
pub fn parse(file: FileId, source: &Source) -> Checked<SpecFile> {
    let bytes = source.text.len();
    if bytes > MAX_FILE_BYTES {
        let diagnostic = too_large(&source.name, Span::new(file, 0, 0), MAX_FILE_BYTES);
        return Checked { value: None, diagnostics: vec![diagnostic] };
    }
    let (value, mut diagnostics) = repair::read(&source.text, MAX_ERRORS, |text| read_once(file, text));
    crate::diagnostic::sort(&mut diagnostics);
    if diagnostics.len() > MAX_ERRORS {
        diagnostics.truncate(MAX_ERRORS);
        let end = Span::new(file, bytes, bytes);
        diagnostics.push(Diagnostic::error(
            "mavc::syntax::too_many",
            end,
            format!("`{}` has more than {MAX_ERRORS} errors; the others are not shown", source.name),
        ));
    }
    Checked { value, diagnostics }
}

/// The tree and the errors of a text as it is; no tree where it exceeds a limit.
fn read_once(file: FileId, text: &str) -> repair::Reading {
    let layout = layout::lay_out(file, text);
    if layout.too_much {
        return (None, layout.diagnostics);
    }
    let (tree, diagnostics) = build::build(file, &layout);
    (Some(tree), diagnostics)
}

/// The diagnostic for a spec or a table of more than `limit` bytes.
pub fn too_large(name: &str, span: Span, limit: usize) -> Diagnostic {
    let message = format!("`{name}` is larger than {} MiB ({limit} bytes)", limit >> 20);
    Diagnostic::error("mavc::file::too_large", span, message).help("split it into several files")
}

/// The diagnostic for a file that is not text; `file` is where [`NotUtf8::source`] was added.
pub fn not_utf8(file: FileId, error: &NotUtf8) -> Diagnostic {
    let end = error.source.text[error.offset..].chars().next().map_or(0, char::len_utf8);
    let message =
        format!("`{}` is not UTF-8 text: byte {} is {:#04x}", error.source.name, error.offset + 1, error.byte);
    Diagnostic::error("mavc::file::encoding", Span::new(file, error.offset, error.offset + end), message)
        .here("the text ends here")
        .help(match (error.offset, error.byte) {
            // A byte order mark of another encoding.
            (0, 0xff | 0xfe) => "this seems to be UTF-16: save the file as UTF-8",
            _ => "save the file as UTF-8",
        })
}

/// Messages cut long words short.
fn cut(word: &str) -> String {
    match word.char_indices().nth(40) {
        Some((end, _)) => format!("{}..", &word[..end]),
        None => word.to_string(),
    }
}
