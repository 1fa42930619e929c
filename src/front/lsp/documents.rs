//! The texts that are open in the editor.

use crate::read::resolve;
use crate::source::Source;
use gen_lsp_types::{Position, Range, TextDocumentContentChangeEvent};
use std::collections::BTreeMap;
use url::Url;

/// One open text.
#[derive(Debug, Clone)]
pub struct Document {
    /// The client's spelling, which answers repeat.
    pub uri: Url,
    pub version: i32,
    pub text: String,
    /// Counts openings: of two texts that each describe the other, the one opened first is the whole.
    pub order: u64,
}

/// The open texts, by the name that a compilation gives them.
#[derive(Debug, Clone, Default)]
pub struct Documents {
    open: BTreeMap<String, Document>,
    opened: u64,
}

impl Documents {
    pub fn open(&mut self, uri: Url, version: i32, text: String) {
        self.opened += 1;
        let document = Document { version, text, order: self.opened, uri: uri.clone() };
        self.open.insert(name_of(&uri), document);
    }

    pub fn close(&mut self, name: &str) {
        self.open.remove(name);
    }

    /// Makes the changes one after the other; those of a text that is not open are for nobody.
    pub fn change(&mut self, name: &str, version: i32, changes: Vec<TextDocumentContentChangeEvent>) {
        let Some(document) = self.open.get_mut(name) else { return };
        document.version = version;
        for change in changes {
            match change {
                TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(whole) => {
                    document.text = whole.text;
                }
                TextDocumentContentChangeEvent::TextDocumentContentChangePartial(part) => {
                    let source = Source::new("", std::mem::take(&mut document.text));
                    let (start, end) = offsets(&source, part.range);
                    document.text = source.text;
                    document.text.replace_range(start..end, &part.text);
                }
            }
        }
    }

    pub fn get(&self, name: &str) -> Option<&Document> {
        self.open.get(name)
    }

    pub fn iter(&self) -> impl Iterator<Item = (&str, &Document)> {
        self.open.iter().map(|(name, document)| (name.as_str(), document))
    }
}

/// The name that a compilation gives to the text of a URI: the path of a file, anything else as it is.
pub fn name_of(uri: &Url) -> String {
    match uri.to_file_path() {
        Ok(path) => resolve("", &path.to_string_lossy()).display().to_string(),
        Err(()) => uri.to_string(),
    }
}

/// The byte offset of a position; see [`Source::offset_utf16`].
pub fn offset(source: &Source, position: Position) -> usize {
    source.offset_utf16(position.line, position.character)
}

/// The byte offsets of a range, in order even where its ends are not.
pub fn offsets(source: &Source, range: Range) -> (usize, usize) {
    let (start, end) = (offset(source, range.start), offset(source, range.end));
    (start.min(end), start.max(end))
}

/// The position of a byte offset.
pub fn position(source: &Source, offset: usize) -> Position {
    let (line, character) = source.place_utf16(offset);
    Position { line, character }
}

/// The range of the bytes `start..end`.
pub fn range(source: &Source, start: usize, end: usize) -> Range {
    Range { start: position(source, start), end: position(source, end) }
}
