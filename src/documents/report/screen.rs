//! Text for one screen of a terminal: lines of at most [`WIDTH`] columns, each with a tone that a terminal shows as a
//! colour.

use crate::number::plural;
use crate::text_table::{Table, fitted, lines};
use std::cmp::Reverse;
use std::fmt;

pub use crate::text_table::WIDTH;

/// Most lines of a short text; a hint of the command may follow as the 25th line of a usual terminal.
const LINES: usize = 24;

/// The last line of a short text.
const EVERY_TABLE: &str = "-v prints every table";

/// Which modes are not shown.
const MORE_TO_SPARE: &str = " with more to spare";

/// Which modes are not shown of those without a way out.
const SHORTER_GAPS: &str = " with shorter gaps";

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

/// What may be left out of a screen without room for everything, from what is left out first to what stays longest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// A figure that explains another one.
    Reason,
    /// A remark on the model.
    Advice,
    /// The meaning of a column.
    Legend,
    /// A row of a table whose first rows are those that matter most.
    Row,
    /// A figure.
    Figure,
    /// A remark that a reader must not overlook.
    Finding,
}

/// Lines that are left out together.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    keep: Keep,
    /// What is counted in the last line if the part is left out, and how many of it.
    counted: Option<(Counted, usize)>,
    /// The names of the modes in its row.
    names: Option<String>,
}

/// What is counted if it is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counted {
    Remark,
    /// A labelled line of figures.
    Figure,
    /// A mode in a table that begins with the tightest.
    Mode,
    /// A mode in a table that begins with the longest time without a way out.
    Gap,
}

impl Counted {
    /// `2 remarks`, `5 modes with more to spare`; empty for none.
    fn words(self, n: usize) -> Option<String> {
        (n > 0).then(|| match self {
            Counted::Remark => plural(n, "remark"),
            Counted::Figure => plural(n, "figure"),
            Counted::Mode => format!("{}{MORE_TO_SPARE}", plural(n, "mode")),
            Counted::Gap => format!("{}{SHORTER_GAPS}", plural(n, "mode")),
        })
    }
}

#[derive(Debug, Clone, PartialEq)]
struct Line {
    tone: Tone,
    text: String,
    /// The index of its part; lines without one are never left out.
    part: Option<usize>,
}

/// Lines of text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Screen {
    lines: Vec<Line>,
    parts: Vec<Part>,
    /// Names of modes that are in no row, and how many there are.
    hidden: Vec<(String, usize)>,
}

impl Screen {
    /// The lines of a longer text, of the width of the terminal except for rows of figures.
    pub fn of_text(text: &str) -> Self {
        Screen::as_it_is(&fitted(text))
    }

    /// The lines of a text for programs.
    pub fn as_it_is(text: &str) -> Self {
        let mut screen = Screen::default();
        text.lines().for_each(|line| screen.lines.push(Line { tone: Tone::Plain, text: line.into(), part: None }));
        screen
    }

    /// A line with a text that fits.
    pub fn line(&mut self, tone: Tone, text: &str) {
        self.lines.push(Line { tone, text: text.trim_end().to_string(), part: None });
    }

    /// An empty line, unless the last one is empty or there is none.
    pub fn gap(&mut self) {
        if self.lines.last().is_some_and(|line| !line.text.is_empty()) {
            self.line(Tone::Plain, "");
        }
    }

    /// A paragraph; all its lines are indented by `indent` spaces, those after the first by `hanging` more.
    pub fn paragraph(&mut self, tone: Tone, indent: usize, hanging: usize, text: &str) {
        let [first, later] = [indent, indent + hanging].map(|n| " ".repeat(n));
        lines(text, &first, &later).iter().for_each(|line| self.line(tone, line));
    }

    /// Lines that may be left out.
    pub fn part(&mut self, keep: Keep, counted: Option<(Counted, usize)>, write: impl FnOnce(&mut Screen)) {
        let first = self.lines.len();
        write(self);
        let part = Some(self.parts.len());
        self.lines[first..].iter_mut().for_each(|line| line.part = part);
        self.parts.push(Part { keep, counted, names: None });
    }

    /// A remark: `! text`. It may be left out, and is counted then.
    pub fn remark(&mut self, keep: Keep, text: &str) {
        let write = |screen: &mut Screen| screen.paragraph(Tone::Warning, 2, 2, &format!("! {text}"));
        self.part(keep, Some((Counted::Remark, 1)), write);
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

    /// A fitted table of modes, the tightest first, whose rows after the first `always` may be left out. `modes` are
    /// the names of modes in each row, and how many there are.
    pub fn fitted_modes(
        &mut self,
        most: usize,
        always: usize,
        modes: &[(String, usize)],
        table: impl Fn(usize) -> Table,
    ) {
        let headings = self.lines.len();
        self.fitted(most, table);
        for (row, (names, n)) in modes.iter().enumerate().skip(always) {
            self.lines[headings + 1 + row].part = Some(self.parts.len());
            let counted = Some((Counted::Mode, *n));
            self.parts.push(Part { keep: Keep::Row, counted, names: Some(names.clone()) });
        }
    }

    /// Modes with more to spare than those in the rows of the table.
    pub fn hide_modes(&mut self, names: String, n: usize) {
        self.hidden.push((names, n));
    }

    /// The last line, after parts were left out until the screen fits: those to keep longest stay, the first of them
    /// before the others, and of the rest what still fits.
    pub fn close(&mut self) {
        let mut order: Vec<usize> = (0..self.parts.len()).collect();
        order.sort_by_key(|part| Reverse(self.parts[*part].keep));
        let mut is_kept = vec![false; self.parts.len()];
        for part in order {
            is_kept[part] = true;
            is_kept[part] = self.with(&is_kept).len() < LINES;
        }
        let (mut remarks, mut figures, mut gaps) = (0, 0, 0);
        let mut modes: usize = self.hidden.iter().map(|(_, n)| n).sum();
        let mut names: Vec<&str> = self.hidden.iter().rev().map(|(names, _)| names.as_str()).collect();
        let mut all_named = true;
        for (Part { counted, names: of_row, .. }, _) in
            self.parts.iter().zip(&is_kept).rev().filter(|(_, kept)| !**kept)
        {
            names.extend(of_row.as_deref());
            all_named &= of_row.is_some() || !matches!(counted, Some((Counted::Mode, _)));
            match *counted {
                Some((Counted::Remark, n)) => remarks += n,
                Some((Counted::Figure, n)) => figures += n,
                Some((Counted::Mode, n)) => modes += n,
                Some((Counted::Gap, n)) => gaps += n,
                None => {}
            }
        }
        names.reverse();
        let named = (modes > 0).then(|| format!("{}{MORE_TO_SPARE}", names.join(", ")));
        let line = |modes: Option<String>| {
            let left =
                [Counted::Remark.words(remarks), Counted::Figure.words(figures), modes, Counted::Gap.words(gaps)];
            let left: Vec<String> = left.into_iter().flatten().collect();
            let left = if left.is_empty() { String::new() } else { format!("; not shown: {}", left.join(", ")) };
            format!("  {EVERY_TABLE}{left}")
        };
        let mut all = [named, Counted::Mode.words(modes)].map(line);
        all.iter_mut()
            .filter(|last| last.chars().count() > WIDTH)
            .for_each(|last| *last = last.replace(MORE_TO_SPARE, "").replace(SHORTER_GAPS, ""));
        let [named, counted] = all;
        self.lines = self.with(&is_kept);
        self.line(Tone::Plain, if named.chars().count() <= WIDTH && all_named { &named } else { &counted });
    }

    /// The lines without the parts that are not kept.
    fn with(&self, is_kept: &[bool]) -> Vec<Line> {
        let kept = |line: &&Line| line.part.is_none_or(|part| is_kept[part]);
        let mut lines: Vec<Line> = self.lines.iter().filter(kept).cloned().collect();
        // No two empty lines meet where all between them is left out.
        lines.dedup_by(|line, before| line.text.is_empty() && before.text.is_empty());
        lines
    }

    /// The lines with their tones.
    pub fn lines(&self) -> impl Iterator<Item = (Tone, &str)> {
        self.lines.iter().map(|line| (line.tone, line.text.as_str()))
    }
}

/// Whether a table, indented by two spaces, is no wider than a screen.
pub fn fits(table: &Table) -> bool {
    table.render(2).lines().all(|line| line.chars().count() <= WIDTH)
}

/// Without colours, a line break after every line.
impl fmt::Display for Screen {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lines.iter().try_for_each(|line| writeln!(f, "{}", line.text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What matters least is left out first, the last of its kind before the others, and what is left out is counted.
    #[test]
    fn the_least_important_parts_are_left_out() {
        let shown = |lines: usize| {
            let mut screen = Screen::default();
            (0..lines).for_each(|i| screen.line(Tone::Plain, &format!("line {i}")));
            let mut table = Table::new(&["mode"]);
            (0..4).for_each(|row| table.row(vec![format!("row {row}")]));
            let rows = [("A", 1), ("B", 1), ("C1 .. C3", 3), ("D1, D2", 2)].map(|(names, n)| (names.to_string(), n));
            screen.fitted_modes(8, 2, &rows, |_| table.clone());
            screen.part(Keep::Reason, None, |screen| screen.line(Tone::Plain, "reason"));
            screen.remark(Keep::Advice, "advice");
            screen.remark(Keep::Finding, "finding");
            screen.close();
            screen.to_string()
        };
        let all = ["row 3", "row 2", "reason", "advice", "finding"];
        let kept = |text: &str| all.into_iter().filter(|part| text.contains(part)).collect::<Vec<_>>();
        assert_eq!(kept(&shown(15)), all);
        assert!(shown(15).ends_with("\n  -v prints every table\n") && shown(15).lines().count() == LINES);
        assert_eq!(kept(&shown(16)), ["row 3", "row 2", "advice", "finding"]);
        assert_eq!(kept(&shown(17)), ["row 3", "row 2", "finding"]);
        assert_eq!(kept(&shown(18)), ["row 2", "finding"]);
        let last = |text: &str| text.lines().last().unwrap().to_string();
        let text = shown(19);
        assert_eq!(kept(&text), ["finding"]);
        assert_eq!(last(&text), "  -v prints every table; not shown: 1 remark, C1 .. C3, D1, D2");
        assert_eq!(text.lines().count(), LINES);
        // Lines that are not part of one stay.
        assert_eq!(shown(40).lines().filter(|line| line.starts_with("line")).count(), 40);
        assert!(last(&shown(40)).ends_with("2 remarks, C1 .. C3, D1, D2"));
    }
}
