//! Reads a certificate from a file's bytes, or reports the place at which they are not one.

use crate::certificate::{Certificate, MAX_BYTES, SCHEMA};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::error::Category;

/// Code of the error for a file that is not a certificate.
pub const MALFORMED: &str = "mavc::verify::malformed";

/// A certificate, and the place of its spec's hash.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    pub certificate: Certificate,
    /// Place of the hash of its spec.
    pub hash: Span,
}

/// The field that every version of a certificate has.
#[derive(Deserialize)]
struct Version {
    schema: u32,
}

/// Reads a certificate; `file` is its text, for the places in messages.
///
/// # Errors
/// What is wrong with the file, at its place.
pub fn read(bytes: &[u8], file: FileId) -> Result<Read, Box<Diagnostic>> {
    // The text in messages also starts after the byte order mark.
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let malformed = |at: usize, why: &str, here: String| {
        let error =
            Diagnostic::error(MALFORMED, Span::new(file, at, at), format!("cannot read this certificate: {why}"));
        Box::new(error.here(here).help("give the file that `mavc plan --certificate` wrote"))
    };
    if bytes.len() > MAX_BYTES {
        let why = format!("it has more than {} MiB", MAX_BYTES >> 20);
        return Err(malformed(0, &why, "it begins here".into()));
    }
    let text = std::str::from_utf8(bytes)
        .map_err(|e| malformed(e.valid_up_to(), "it is not text", "not UTF-8 from here on".into()))?;
    if text.trim().is_empty() {
        return Err(malformed(0, "it is empty", String::new()));
    }
    let of_another_version = || {
        let written = serde_json::from_str::<Version>(text).ok().filter(|found| found.schema != SCHEMA)?;
        let at = text.find("\"schema\"").unwrap_or(0);
        let here = format!("schema {}, but this program reads {SCHEMA}", written.schema);
        let error = malformed(at, "its format has another version", here);
        Some(Box::new(error.help("write it again with `mavc plan --certificate`")))
    };
    let certificate: Certificate = serde_json::from_str(text).map_err(|e| {
        if let Some(older) = of_another_version() {
            return older;
        }
        let why = match e.classify() {
            Category::Eof => "the file is cut off",
            Category::Data => "it is not the JSON of a certificate",
            // A claim without its kind is also reported as a syntax error.
            _ if serde_json::from_str::<IgnoredAny>(text).is_ok() => "it is not the JSON of a certificate",
            Category::Syntax | Category::Io => "it is not JSON",
        };
        // The end is shown at the last character before it: there can be no label after the text.
        let at = if e.is_eof() { text.trim_end().len() - 1 } else { place(text, e.line(), e.column()) };
        malformed(boundary(text, at), why, words(&e.to_string()))
    })?;
    if let Some(older) = of_another_version() {
        return Err(older);
    }
    // A hash that is written with escapes is not found; then the place is the beginning of the file.
    let written = format!("\"{}\"", certificate.spec_sha256);
    let hash = text.find(&written).map_or(Span::new(file, 0, 0), |at| Span::new(file, at, at + written.len()));
    Ok(Read { certificate, hash })
}

/// The byte offset of a parser's line and column; columns count bytes.
fn place(text: &str, line: usize, column: usize) -> usize {
    let begins: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    begins + column.saturating_sub(1)
}

/// The last character boundary at or before `at`.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

/// The parser's message without the place, which is shown separately.
fn words(message: &str) -> String {
    let words = message.rsplit_once(" at line ").map_or(message, |(words, _)| words);
    words.replace("EOF while parsing", "the file ends in")
}
