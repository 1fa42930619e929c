//! Specs from the files of other tools: vehicles of autopilots and simulators, missions of ground stations. What a file
//! says is carried over; what it does not say stands as `?` or is left out, and nothing is invented: estimates
//! (`import/estimate`) stand in comments.
//!
//! A foreign file is a [`Source`] like a spec, so that every mistake in it is a [`Diagnostic`] with its place.

pub mod estimate;
pub mod json;
pub mod mission;
pub mod unknown;
pub mod vehicle;

use crate::diagnostic::{Diagnostic, Severity};
use crate::foreign::{self, Foreign};
use crate::source::{FileId, Source, SourceMap, Span};
use crate::syntax::ast::Item;

/// The largest file that is read, in bytes: 16 MiB.
pub const MAX_BYTES: usize = 16 << 20;

/// Code: the file is not one that can be read here.
pub const FORMAT: &str = "mavc::import::format";
/// Code: a line, value or element that its format does not allow.
pub const SYNTAX: &str = "mavc::import::syntax";
/// Code: the file means something that no spec can say.
pub const UNSUPPORTED: &str = "mavc::import::unsupported";
/// Code: the spec depends on something that the file does not say for certain.
pub const ASSUMED: &str = "mavc::import::assumed";

/// What became of a file.
#[derive(Debug, Clone)]
pub struct Imported {
    /// The text of the spec, laid out as `mavc fmt` does; `None` if there is an error.
    pub text: Option<String>,
    /// What was left out, in the words of the file, sorted: names of parameters, elements or items.
    pub dropped: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
    /// The file, for its diagnostics.
    pub sources: SourceMap,
}

impl Imported {
    /// Whether there is no spec.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }
}

/// The spec's text and what was left out of it, or why there is none; further diagnostics are reported beside it.
pub type Outcome = Result<(String, Vec<String>), Box<Diagnostic>>;

/// Reads the bytes of a file with `read`, which gets its text.
pub fn import(name: &str, bytes: &[u8], read: impl FnOnce(&Source, &mut Vec<Diagnostic>) -> Outcome) -> Imported {
    let mut diagnostics = Vec::new();
    let (source, outcome) = decoded(name, bytes, |source| read(source, &mut diagnostics));
    let mut sources = SourceMap::default();
    sources.add(source);
    let (text, mut dropped) = match outcome {
        Ok((text, dropped)) => (Some(text), dropped),
        Err(error) => {
            diagnostics.push(*error);
            (None, Vec::new())
        }
    };
    dropped.sort();
    dropped.dedup();
    let mut imported = Imported { text, dropped, diagnostics, sources };
    if imported.has_errors() {
        imported.text = None;
    }
    imported
}

fn decoded(name: &str, bytes: &[u8], read: impl FnOnce(&Source) -> Outcome) -> (Source, Outcome) {
    if bytes.is_empty() {
        let error = Diagnostic::error(FORMAT, Span::default(), "the file is empty");
        return (Source::new(name, ""), Err(Box::new(error.help("export or copy it again"))));
    }
    if let Some(other) = foreign::of_first_bytes(bytes) {
        let error = Diagnostic::error(FORMAT, Span::default(), format!("this is {}", other.what()));
        let error = error.help(other.help(name));
        return (Source::new(name, ""), Err(Box::new(error)));
    }
    if bytes.len() > MAX_BYTES {
        let error =
            Diagnostic::error(FORMAT, Span::default(), format!("the file is larger than {} MiB", MAX_BYTES >> 20));
        let error = error.help("name the file of one vehicle or mission");
        return (Source::new(name, ""), Err(Box::new(error)));
    }
    match Source::from_bytes(name, bytes) {
        Ok(source) => {
            let outcome = read(&source);
            (source, outcome)
        }
        Err(bad) => {
            let at = Span::new(FileId(0), bad.offset, bad.offset + '\u{fffd}'.len_utf8());
            let error = Diagnostic::error(FORMAT, at, "the file is not UTF-8 text");
            let error = error.here(format!("this is the byte 0x{:02x}", bad.byte)).help("name a text file");
            (bad.source, Err(Box::new(error)))
        }
    }
}

/// Whether a text is a spec of mavc already.
fn is_spec(source: &Source) -> bool {
    if source.text.len() > crate::input::MAX_FILE_BYTES {
        return false;
    }
    let tree = crate::syntax::parse(FileId(0), source);
    let is_clean = tree.diagnostics.iter().all(|d| d.severity != Severity::Error);
    // Lines `NAME=8` are parameters: a spec has more than fields.
    is_clean && tree.value.is_some_and(|tree| tree.items.iter().any(|item| !matches!(item, Item::Field(_))))
}

/// The error for a file that neither import reads, although it is known what it is; a spec if `kind` is `None`.
fn other(source: &Source, kind: Option<Foreign>) -> Diagnostic {
    let (what, help) = match kind {
        Some(kind) => (kind.what(), kind.help(&source.name)),
        None => {
            let name = crate::source::visible::line(&source.name);
            ("a spec of mavc already".into(), format!("check it as it is: `mavc check {name}`"))
        }
    };
    let code = if matches!(kind, Some(Foreign::Template(_))) { UNSUPPORTED } else { FORMAT };
    Diagnostic::error(code, at(source.line(1)), format!("this is {what}")).here("the first line").help(help)
}

/// A place in the file that is read.
pub fn at(range: std::ops::Range<usize>) -> Span {
    Span::new(FileId(0), range.start, range.end)
}
