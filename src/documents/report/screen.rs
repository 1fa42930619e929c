//! Text for one screen of a terminal: lines of at most [`WIDTH`] columns, each with a tone that a terminal shows as a
//! colour.

use crate::text_table::Table;
use std::fmt;

/// The width of the short texts, columns.
pub const WIDTH: usize = 80;

/// The last line of a short text.
pub const EVERY_TABLE: &str = "  -v prints every table";

/// The fewest columns of names in a table.
const NAMES: usize = 8;

/// What a line means, for its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    Plain,
    /// A plan was found, a flight ended well.
    Good,
    /// There is no plan, a vehicle is lost.
    Bad,
    /// What a reader must not overlook.
    Warning,
    /// A heading.
    Strong,
}

/// Lines of text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Screen {
    lines: Vec<(Tone, String)>,
}

impl Screen {
    /// The lines of a longer text as they are.
    pub fn of_text(text: &str) -> Self {
        Screen { lines: text.lines().map(|line| (Tone::Plain, line.to_string())).collect() }
    }

    /// A line with a text that fits.
    pub fn line(&mut self, tone: Tone, text: &str) {
        self.lines.push((tone, text.trim_end().to_string()));
    }

    /// An empty line, unless the last one is empty or there is none.
    pub fn gap(&mut self) {
        if self.lines.last().is_some_and(|(_, text)| !text.is_empty()) {
            self.line(Tone::Plain, "");
        }
    }

    /// A paragraph; all its lines are indented by `indent` spaces, those after the first by `hanging` more.
    pub fn paragraph(&mut self, tone: Tone, indent: usize, hanging: usize, text: &str) {
        let [first, later] = [indent, indent + hanging].map(|n| " ".repeat(n));
        let options = textwrap::Options::new(WIDTH).initial_indent(&first).subsequent_indent(&later);
        textwrap::wrap(text, options).iter().for_each(|line| self.line(tone, line));
    }

    /// A remark that a reader must not overlook: `! text`.
    pub fn remark(&mut self, text: &str) {
        self.paragraph(Tone::Warning, 2, 2, &format!("! {text}"));
    }

    /// Remarks while the screen has at most `most` lines, and the number of those that are left out.
    pub fn remarks(&mut self, all: &[String], most: usize) {
        for (i, text) in all.iter().enumerate() {
            let before = self.lines.len();
            self.remark(text);
            let is_last = i + 1 == all.len();
            if self.lines.len() + usize::from(!is_last) > most {
                self.lines.truncate(before);
                let left = all.len() - i;
                self.remark(&format!("{left} more remark{}: -v", if left == 1 { "" } else { "s" }));
                return;
            }
        }
    }

    /// A table, indented by two spaces.
    pub fn table(&mut self, table: &Table) {
        table.render(2).lines().for_each(|line| self.line(Tone::Plain, line));
    }

    /// A table with names in the widest cells with which it fits, of `most` columns and not below `NAMES`.
    pub fn fitted(&mut self, most: usize, table: impl Fn(usize) -> Table) {
        let names = (NAMES..=most).rev().find(|names| fits(&table(*names))).unwrap_or(NAMES);
        self.table(&table(names));
    }

    /// Adds the lines of another text.
    pub fn extend(&mut self, other: Screen) {
        self.lines.extend(other.lines);
    }

    /// The lines with their tones.
    pub fn lines(&self) -> impl Iterator<Item = (Tone, &str)> {
        self.lines.iter().map(|(tone, text)| (*tone, text.as_str()))
    }

    /// How many lines there are.
    pub fn height(&self) -> usize {
        self.lines.len()
    }
}

/// Whether a table, indented by two spaces, is no wider than a screen.
pub fn fits(table: &Table) -> bool {
    table.render(2).lines().all(|line| line.chars().count() <= WIDTH)
}

/// Without colours, a line break after every line.
impl fmt::Display for Screen {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lines.iter().try_for_each(|(_, text)| writeln!(f, "{text}"))
    }
}
