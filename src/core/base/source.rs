//! Source texts and places in them.
//!
//! Every file of a file set has a [`FileId`]; a [`Span`] is a byte range of one file. Lines and
//! columns are computed only when they are shown to a person or sent to an editor.

pub mod visible;

use std::fmt;

/// Index of a file in a [`SourceMap`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct FileId(pub u32);

/// A half-open byte range `start..end` of one file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Span {
    pub file: FileId,
    pub start: u32,
    pub end: u32,
}

impl Span {
    pub fn new(file: FileId, start: usize, end: usize) -> Self {
        Span { file, start: start as u32, end: end as u32 }
    }

    /// The smallest span that covers both; `other` must be in the same file.
    pub fn to(self, other: Span) -> Span {
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

impl fmt::Debug for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}..{}", self.file.0, self.start, self.end)
    }
}

/// A value and the place where it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Spanned<T> {
    pub value: T,
    pub span: Span,
}

impl<T> Spanned<T> {
    pub fn new(value: T, span: Span) -> Self {
        Spanned { value, span }
    }
}

/// One file: its name, given by the user or by a `use`, and its text.
#[derive(Debug, Clone)]
pub struct Source {
    /// The user's spelling of the file; `<stdin>` for `-`.
    pub name: String,
    pub text: String,
    /// Byte offset of the start of each line; the first is 0.
    line_starts: Vec<u32>,
}

/// A file that is not UTF-8 text.
#[derive(Debug, Clone)]
pub struct NotUtf8 {
    /// The text up to a little after the first invalid byte, with U+FFFD for what is not UTF-8.
    pub source: Source,
    /// The offset of the first invalid byte, counted after a byte order mark.
    pub offset: usize,
    /// The first invalid byte.
    pub byte: u8,
}

/// A place for people: 1-based line, 1-based column in Unicode scalars.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LineColumn {
    pub line: usize,
    pub column: usize,
}

impl Source {
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let line_starts = std::iter::once(0)
            .chain(text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i as u32 + 1))
            .collect();
        Source { name: name.into(), text, line_starts }
    }

    /// Decodes the bytes of a file as UTF-8, without the byte order mark if there is one.
    ///
    /// # Errors
    /// [`NotUtf8`] has the first invalid byte and the text that can be shown.
    pub fn from_bytes(name: impl Into<String>, bytes: &[u8]) -> Result<Self, NotUtf8> {
        let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(Source::new(name, text)),
            Err(error) => {
                let offset = error.valid_up_to();
                let text = String::from_utf8_lossy(&bytes[..bytes.len().min(offset + 80)]);
                Err(NotUtf8 { source: Source::new(name, text), offset, byte: bytes[offset] })
            }
        }
    }

    /// The byte range of a 1-based line without its newline; beyond the last line, the empty range at the end.
    pub fn line(&self, line: usize) -> std::ops::Range<usize> {
        let start = |l: usize| self.line_starts.get(l).map_or(self.text.len(), |s| *s as usize);
        let (from, to) = (start(line - 1), start(line));
        from..from + self.text[from..to].trim_end_matches(['\r', '\n']).len()
    }

    /// The 0-based line that contains byte `offset` (clamped to the text).
    fn line_index(&self, offset: usize) -> usize {
        self.line_starts.partition_point(|&s| s as usize <= offset.min(self.text.len())) - 1
    }

    /// Line and column of a byte offset, in Unicode scalars; an offset inside a scalar counts as its start.
    pub fn place(&self, offset: usize) -> LineColumn {
        let line = self.line_index(offset);
        let start = self.line_starts[line] as usize;
        let column = self.text[start..].char_indices().take_while(|(i, _)| start + i < offset).count();
        LineColumn { line: line + 1, column: column + 1 }
    }

    /// 0-based line and UTF-16 column, as in the Language Server Protocol.
    pub fn place_utf16(&self, offset: usize) -> (u32, u32) {
        let line = self.line_index(offset);
        let start = self.line_starts[line] as usize;
        let units: usize =
            self.text[start..].char_indices().take_while(|(i, _)| start + i < offset).map(|(_, c)| c.len_utf16()).sum();
        (line as u32, units as u32)
    }

    /// The byte offset of a 0-based line and UTF-16 column. A column beyond the line gives the end of the line, a line
    /// beyond the last gives the end of the text, and a column inside a character gives the start of the character.
    pub fn offset_utf16(&self, line: u32, column: u32) -> usize {
        if line as usize >= self.line_starts.len() {
            return self.text.len();
        }
        let range = self.line(line as usize + 1);
        let mut units = 0;
        for (at, character) in self.text[range.clone()].char_indices() {
            units += character.len_utf16() as u64;
            if units > u64::from(column) {
                return range.start + at;
            }
        }
        range.end
    }
}

/// All files of one compilation, in the order in which they were first named.
#[derive(Debug, Clone, Default)]
pub struct SourceMap {
    files: Vec<Source>,
}

impl SourceMap {
    pub fn add(&mut self, source: Source) -> FileId {
        self.files.push(source);
        FileId(self.files.len() as u32 - 1)
    }

    pub fn get(&self, file: FileId) -> &Source {
        &self.files[file.0 as usize]
    }

    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source)> {
        self.files.iter().enumerate().map(|(i, s)| (FileId(i as u32), s))
    }

    /// The text of a span; empty if the span lies outside the file.
    pub fn snippet(&self, span: Span) -> &str {
        self.get(span.file).text.get(span.start as usize..span.end as usize).unwrap_or("")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_scalars_and_utf16_units() {
        let s = Source::new("t", "ab\nα😀x\n");
        assert_eq!(s.place(0), LineColumn { line: 1, column: 1 });
        assert_eq!(s.place(3), LineColumn { line: 2, column: 1 });
        let x = s.text.find('x').unwrap();
        assert_eq!(s.place(x), LineColumn { line: 2, column: 3 });
        assert_eq!(s.place_utf16(x), (1, 3));
        assert_eq!(s.place(s.text.len()), LineColumn { line: 3, column: 1 });
    }

    #[test]
    fn utf16_columns_are_clamped_to_characters_lines_and_the_text() {
        let s = Source::new("t", "ab\r\nα😀x");
        let x = s.text.find('x').unwrap();
        assert_eq!(s.offset_utf16(1, 3), x);
        assert_eq!(s.offset_utf16(1, 2), s.text.find('😀').unwrap(), "inside a pair of surrogates");
        assert_eq!(s.offset_utf16(0, 99), 2);
        assert_eq!(s.offset_utf16(1, u32::MAX), s.text.len());
        assert_eq!(s.offset_utf16(u32::MAX, 0), s.text.len());
        for at in [0, 1, 2, 4, x, s.text.len()] {
            let (line, column) = s.place_utf16(at);
            assert_eq!(s.offset_utf16(line, column), at);
        }
    }

    #[test]
    fn bytes_are_utf8_or_say_where_they_are_not() {
        assert_eq!(Source::from_bytes("t", b"\xef\xbb\xbfplan").unwrap().text, "plan");
        let error = Source::from_bytes("t", b"let a\n = \xff\xfe 4").unwrap_err();
        assert_eq!((error.offset, error.byte), (9, 0xff));
        assert_eq!(error.source.place(error.offset), LineColumn { line: 2, column: 4 });
        // A character cut off at the end of the file.
        assert_eq!(Source::from_bytes("t", b"a \xe2\x82").unwrap_err().offset, 2);
    }

    #[test]
    fn lines_leave_out_their_end() {
        let s = Source::new("t", "ab\r\ncd\n");
        let text = |l| &s.text[s.line(l)];
        assert_eq!((text(1), text(2), text(3), text(9)), ("ab", "cd", "", ""));
    }
}
