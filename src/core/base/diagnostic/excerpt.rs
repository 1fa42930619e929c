//! Source text as the terminal shows it: control and bidirectional characters are escaped, and long lines are cut.

use crate::source::{FileId, Source, SourceMap, Span, visible};
use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use std::borrow::Cow;
use std::cell::OnceCell;

/// A line is shown from its beginning, or to its end, if the span is at most this many bytes away from it.
pub const LONGEST: usize = 400;

/// Bytes shown on either side of a span where the line is cut; a line may be as long as a file.
pub const MARGIN: usize = 60;

/// Columns of a tab.
pub const TAB: usize = 4;

/// Columns before a line of source besides those of its number, and before a label below it.
const GUTTER: usize = 8;

/// A label has room for a few words, however far right its place is.
const LEAST_ROOM: usize = 24;

/// A source and its escaped form. Offsets are those of the escaped text unless stated otherwise.
pub struct Excerpt<'a> {
    read: &'a Source,
    /// The escaped text; the original if nothing needs escapes.
    pub shown: Cow<'a, Source>,
    name: String,
    /// After each escape, the offset in the original text and in the escaped text.
    marks: Vec<(usize, usize)>,
}

impl<'a> Excerpt<'a> {
    pub fn new(source: &'a Source) -> Self {
        let name = visible::line(&source.name).into_owned();
        let mut marks = Vec::new();
        let shown = match visible::text(&source.text) {
            Cow::Borrowed(_) => Cow::Borrowed(source),
            Cow::Owned(text) => {
                marks = escapes(&source.text, &text);
                Cow::Owned(Source::new(&name, text))
            }
        };
        Excerpt { read: source, shown, name, marks }
    }

    /// The escaped offset of an original offset.
    fn offset(&self, read: usize) -> usize {
        let behind = self.marks.partition_point(|mark| mark.0 <= read);
        behind.checked_sub(1).map_or(read, |k| self.marks[k].1 + (read - self.marks[k].0))
    }

    /// The escaped offset of the start of a span of the original text.
    pub fn start(&self, span: Span) -> usize {
        self.offset(span.start as usize)
    }

    /// The part of a span of the original text that is underlined: its beginning, if it is very long.
    pub fn place(&self, span: Span) -> SourceSpan {
        let (start, end) = (self.start(span), self.offset(span.end as usize));
        let end = end.min(boundary(&self.shown.text, start + LONGEST)).max(start);
        (start, end - start).into()
    }

    /// The columns that a label under the middle of a span of the original text has in `width` columns.
    pub fn room(&self, span: Span, width: usize) -> usize {
        let (source, place) = (&self.shown, self.place(span));
        let (start, end) = (place.offset(), place.offset() + place.len());
        let line = source.place(start).line;
        let of_line = source.line(line);
        let columns = |text: &str| text.chars().map(|c| if c == '\t' { TAB } else { 1 }).sum::<usize>();
        let before = columns(&source.text[of_line.start..start]);
        let half = columns(&source.text[start..end.min(of_line.end).max(start)]) / 2;
        let number = (line + 1).to_string().len();
        width.saturating_sub(GUTTER + number + before + half).max(LEAST_ROOM)
    }

    /// The original offset of an escaped offset.
    fn back(&self, shown: usize) -> usize {
        let behind = self.marks.partition_point(|mark| mark.1 <= shown);
        let next = self.marks.get(behind).map_or(usize::MAX, |mark| mark.0);
        behind.checked_sub(1).map_or(shown, |k| self.marks[k].0 + (shown - self.marks[k].1)).min(next)
    }
}

/// The offsets after each escape, in a text and in its escaped form by [`visible::text`].
fn escapes(read: &str, shown: &str) -> Vec<(usize, usize)> {
    let (mut marks, mut at) = (Vec::new(), 0);
    for (offset, c) in read.char_indices() {
        if shown[at..].starts_with(c) {
            at += c.len_utf8();
        } else {
            at += visible::line(c.encode_utf8(&mut [0; 4])).len();
            marks.push((offset + c.len_utf8(), at));
        }
    }
    marks
}

/// The excerpts of a file set, each created when it is first shown.
pub struct Excerpts<'a> {
    sources: &'a SourceMap,
    made: Vec<OnceCell<Excerpt<'a>>>,
}

impl<'a> Excerpts<'a> {
    pub fn new(sources: &'a SourceMap) -> Self {
        Excerpts { sources, made: sources.iter().map(|_| OnceCell::new()).collect() }
    }

    pub fn get(&self, file: FileId) -> &Excerpt<'a> {
        self.made[file.0 as usize].get_or_init(|| Excerpt::new(self.sources.get(file)))
    }
}

/// Finds lines by the source's index, so that many reports on a long file cost little.
impl SourceCode for Excerpt<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let (source, text) = (&self.shown, &self.shown.text);
        let (start, end) = (span.offset(), span.offset() + span.len());
        if !text.is_char_boundary(start) || !text.is_char_boundary(end) {
            return Err(MietteError::OutOfBounds);
        }
        let first = source.place(start).line.saturating_sub(before).max(1);
        let last = source.place(end.saturating_sub(1).max(start)).line + after;
        let from = if before == 0 { start } else { source.line(first).start };
        // Leaves out the line before if it is long.
        let own = source.line(source.place(start).line).start;
        let whole = [from, own].into_iter().find(|from| start <= from + LONGEST);
        let from = whole.unwrap_or_else(|| boundary(text, start - MARGIN));
        let to = source.line(last).end.max(end);
        let to = if to > end + LONGEST { boundary(text, end + MARGIN) } else { to };
        // Line and column numbers are those of the original text.
        let place = self.read.place(self.back(from));
        let contents = MietteSpanContents::new_named(
            self.name.clone(),
            &text.as_bytes()[from..to],
            (from, to - from).into(),
            place.line - 1,
            place.column - 1,
            last.saturating_sub(place.line) + 1,
        );
        Ok(Box::new(contents))
    }
}

/// The last character boundary at or before `at`.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_found_behind_escapes_and_back() {
        let source = Source::new("t", "a\x1bk\u{202e}\u{202e}é\r\n\x07\nz");
        let excerpt = Excerpt::new(&source);
        assert_eq!(excerpt.shown.text, "a\\u{1b}k\\u{202e}\\u{202e}é\r\n\\u{7}\nz");
        for letter in ['a', 'k', 'é', 'z', '\r'] {
            let (read, shown) = (source.text.find(letter).unwrap(), excerpt.shown.text.find(letter).unwrap());
            assert_eq!((excerpt.offset(read), excerpt.back(shown)), (shown, read), "{letter}");
        }
        assert_eq!(excerpt.offset(source.text.len()), excerpt.shown.text.len());
        // An escape's own place is where it begins.
        assert_eq!((excerpt.offset(1), excerpt.back(3)), (1, 2));
    }

    #[test]
    fn escapes_written_in_a_source_are_none() {
        let source = Source::new("t", "\\u{1b}\x1b\\u{1b}!");
        let excerpt = Excerpt::new(&source);
        assert_eq!(excerpt.shown.text, "\\u{1b}\\u{1b}\\u{1b}!");
        assert_eq!(excerpt.offset(source.text.find('!').unwrap()), 18);
    }
}
