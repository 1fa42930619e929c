//! Text for the terminal: aligned tables, and paragraphs.

/// The width of text for the terminal, columns: that of a new terminal window. A table with many columns is wider.
pub const WIDTH: usize = 80;

/// A space at which no line ends.
const JOINT: char = '\u{a0}';

/// Units that stay on the line of their number.
const UNITS: [&str; 16] =
    ["%", "m", "cm", "mm", "s", "ms", "N", "kg", "deg", "degrees", "m/s", "deg/s", "rad/s", "J", "Wh", "Hz"];

/// Code of at most so many columns stays on one line.
const CODE: usize = 32;

/// The text, with numbers joined to their units, and the words of short code.
fn unbroken(text: &str) -> String {
    let code = |(i, span): (usize, &str)| match i % 2 == 1 && span.len() <= CODE {
        true => span.replace(' ', &JOINT.to_string()),
        false => span.to_string(),
    };
    let text = text.split('`').enumerate().map(code).collect::<Vec<_>>().join("`");
    let mut joined = String::with_capacity(text.len());
    let mut after_number = false;
    for (i, word) in text.split(' ').enumerate() {
        let is_unit = UNITS.contains(&word.trim_end_matches([',', ';', '.', ':', ')']));
        if i > 0 {
            joined.push(if after_number && is_unit { JOINT } else { ' ' });
        }
        joined.push_str(word);
        after_number = word.ends_with(|c: char| c.is_ascii_digit());
    }
    joined
}

/// The lines of a paragraph, of at most [`WIDTH`] columns; the first begins with `first`, the others with `later`.
pub fn lines(text: &str, first: &str, later: &str) -> Vec<String> {
    // Other breaks than at blanks would part `risk-sensitive`, units and paths.
    let options = textwrap::Options::new(WIDTH)
        .initial_indent(first)
        .subsequent_indent(later)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    textwrap::wrap(&unbroken(text), options).iter().map(|line| line.replace(JOINT, " ")).collect()
}

/// A paragraph with a line break at its end.
pub fn filled(text: &str) -> String {
    lines(text, "", "").join("\n") + "\n"
}

/// A paragraph that is indented by two spaces, with a line break at its end.
pub fn indented(text: &str) -> String {
    lines(text, "  ", "  ").join("\n") + "\n"
}

/// A paragraph with a line break at its end, whose lines after the first are indented by two spaces.
pub fn hanging(text: &str) -> String {
    lines(text, "", "  ").join("\n") + "\n"
}

/// A last cell that begins behind this column is a figure: a row that is wider than the terminal stays as it is.
const LAST_PROSE: usize = 40;

/// A longer text in lines of at most [`WIDTH`] columns: sentences, and rows whose last cell is one. Rows of figures
/// stay whole, however many columns they have.
pub fn fitted(text: &str) -> String {
    text.lines().map(|line| fitted_line(line).join("\n") + "\n").collect()
}

fn fitted_line(line: &str) -> Vec<String> {
    if line.chars().count() <= WIDTH {
        return vec![line.to_string()];
    }
    let text = line.trim_start();
    let indent = &line[..line.len() - text.len()];
    let Some((before, last)) = text.rsplit_once("  ") else {
        return lines(text, indent, &format!("{indent}  "));
    };
    let first = format!("{indent}{before}  ");
    let column = first.chars().count();
    match column <= LAST_PROSE {
        true => lines(last, &first, &" ".repeat(column)),
        false => vec![line.to_string()],
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prose_is_fitted_and_figures_stay() {
        let words = "word ".repeat(30);
        let prose = format!("  {}", words.trim_end());
        let legend = format!("margin    {}", words.trim_end());
        let figures = format!("  M1{}", "     1.25".repeat(12));
        let text = fitted(&format!("{prose}\n{legend}\n{figures}\nshort\n"));
        let found: Vec<&str> = text.lines().collect();
        assert_eq!(found.len(), 2 + 3 + 1 + 1, "{text}");
        assert!(found[1].starts_with("    word") && found[3].starts_with("          word"), "{text}");
        assert_eq!(found[5..], [figures.as_str(), "short"]);
        assert!(found[..5].iter().all(|line| line.len() <= WIDTH), "{text}");
    }

    #[test]
    fn numbers_stay_beside_their_units() {
        let text = format!("{} takes 5.006 s", "x".repeat(WIDTH - 13));
        assert_eq!(lines(&text, "", "").last().unwrap(), "5.006 s");
    }
}
