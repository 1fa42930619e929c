//! The rows of a table in a file, each cell with its place in the text. Lines that begin with `#` are comments.

use super::load::Table;
use crate::number::plural;
use crate::source::Span;

/// One line of a table with its place.
pub(super) struct Row {
    /// The cells without surrounding blanks.
    pub record: csv::StringRecord,
    pub span: Span,
    /// The span of every cell, without surrounding blanks.
    pub cells: Vec<Span>,
}

/// A line that is not a row.
pub(super) struct BrokenRow {
    pub span: Span,
    pub message: String,
}

/// The lines of a table, the header first, whose cells are divided by `separator`.
pub(super) fn rows(table: &Table, separator: u8) -> impl Iterator<Item = Result<Row, BrokenRow>> {
    let reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .delimiter(separator)
        .from_reader(table.bytes.as_slice());
    reader.into_records().map(move |record| match record {
        Ok(record) => Ok(Row::new(table, record, separator)),
        Err(error) => Err(BrokenRow { span: place(table, error.position()), message: broken_row(&error) }),
    })
}

impl Row {
    fn new(table: &Table, record: csv::StringRecord, separator: u8) -> Self {
        let mut from = start(table, record.position());
        let cell = |_| {
            let end = cell_end(&table.bytes, from, separator);
            let span = trimmed(table, from, end);
            from = (end + 1).min(table.bytes.len());
            span
        };
        let cells = (0..record.len()).map(cell).collect();
        Row { span: place(table, record.position()), record, cells }
    }
}

/// The bytes of one line of the table.
fn place(table: &Table, position: Option<&csv::Position>) -> Span {
    let start = start(table, position);
    let end = start + table.bytes[start..].iter().take_while(|b| !matches!(b, b'\n' | b'\r')).count();
    trimmed(table, start, end)
}

/// Where the first line begins that is neither empty nor a comment.
pub(super) fn start_of_header(table: &Table) -> usize {
    start(table, None)
}

/// Where a line begins: the reader's position includes the empty lines and comments before it.
fn start(table: &Table, position: Option<&csv::Position>) -> usize {
    let mut start = position.map_or(0, |p| p.byte() as usize).min(table.bytes.len());
    loop {
        match table.bytes[start..] {
            [b'\n' | b'\r', ..] => start += 1,
            [b'#', ..] => start += table.bytes[start..].iter().take_while(|b| **b != b'\n').count(),
            _ => return start,
        }
    }
}

/// The end of the cell that begins at `from`: the next separator or end of line outside quotes.
fn cell_end(bytes: &[u8], from: usize, separator: u8) -> usize {
    let quoted = bytes[from..].starts_with(b"\"");
    let mut inside = false;
    let ends = |byte: &u8| {
        inside ^= quoted && *byte == b'"';
        !inside && (*byte == separator || matches!(byte, b'\n' | b'\r'))
    };
    bytes[from..].iter().position(ends).map_or(bytes.len(), |length| from + length)
}

/// A span of the table without surrounding blanks.
fn trimmed(table: &Table, start: usize, end: usize) -> Span {
    let blanks = |text: &[u8], rest: &[u8]| text.len() - rest.len();
    let text = &table.bytes[start..end];
    let (front, back) = (text.trim_ascii_start(), text.trim_ascii_end());
    match front.is_empty() {
        true => Span::new(table.file, start, start),
        false => Span::new(table.file, start + blanks(text, front), end - blanks(text, back)),
    }
}

fn broken_row(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("this row has {}, but the header has {expected_len}", plural(*len as usize, "cell"))
        }
        _ => "this row cannot be read".into(),
    }
}
