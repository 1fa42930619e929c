//! Text for the terminal: aligned tables, and paragraphs.

/// The width of text for the terminal, columns.
pub const WIDTH: usize = 110;

/// A paragraph that is indented by two spaces, with a line break at its end.
pub fn indented(text: &str) -> String {
    textwrap::fill(text, textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ")) + "\n"
}

/// A paragraph with a line break at its end, whose lines after the first are indented by two spaces.
pub fn hanging(text: &str) -> String {
    textwrap::fill(text, textwrap::Options::new(WIDTH).subsequent_indent("  ")) + "\n"
}

/// Rows of cells under headings; the first column is aligned left, the others right.
#[derive(Debug, Clone, Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
    /// A further column that is aligned left, for words.
    words: Option<usize>,
}

impl Table {
    /// A table without rows.
    pub fn new(headings: &[&str]) -> Self {
        Table { rows: vec![headings.iter().map(ToString::to_string).collect()], words: None }
    }

    /// This table with one more column that is aligned left.
    pub fn with_words(self, column: usize) -> Self {
        Table { words: Some(column), ..self }
    }

    /// Adds a row, which may have fewer cells than there are headings.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The lines of the table, each indented by `indent` spaces.
    pub fn render(&self, indent: usize) -> String {
        self.lines(indent, false)
    }

    /// This table with every column aligned left.
    pub fn render_left(&self, indent: usize) -> String {
        self.lines(indent, true)
    }

    fn lines(&self, indent: usize, left: bool) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |c: usize| self.rows.iter().filter_map(|r| r.get(c)).map(|t| t.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut out = String::new();
        for row in &self.rows {
            let mut line = " ".repeat(indent);
            for (c, cell) in row.iter().enumerate() {
                let pad = " ".repeat(widths[c] - cell.chars().count());
                match c {
                    0 => line.push_str(&format!("{cell}{pad}")),
                    c if left || self.words == Some(c) => line.push_str(&format!("  {cell}{pad}")),
                    _ => line.push_str(&format!("  {pad}{cell}")),
                }
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
        out
    }
}
