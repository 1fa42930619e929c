//! Consecutive lines share columns: `=` and relations, the coordinates of rotors, comments.

use super::line::Line;
use super::role::Alignment;

/// Comments after statements, not after the braces of a block, begin in this column or later, counted from 0.
const COMMENT_COLUMN: usize = 34;
/// Blanks before a comment at least.
const COMMENT_GAP: usize = 2;
/// A longer cell is not aligned, and does not move the others.
const WIDEST_CELL: usize = 40;
const WIDEST_LINE: usize = 100;

pub fn line_up(lines: &mut [Line]) {
    for run in lines.chunk_by_mut(|a, b| a.run == b.run) {
        for table in run.chunk_by_mut(|a, b| shape(a).is_some() && shape(a) == shape(b)) {
            line_up_stops(table);
        }
        place_comments(run);
    }
}

/// Consecutive lines of one shape are aligned; a line with a wide cell has no shape.
fn shape(line: &Line) -> Option<(Alignment, usize)> {
    let starts = std::iter::once(0).chain(line.stops.iter().map(|stop| stop.end));
    let mut cells = starts.zip(&line.stops).map(|(start, stop)| width(&line.text[start..stop.end]));
    let kind = line.kind.filter(|_| cells.all(|cell| cell <= WIDEST_CELL));
    kind.map(|kind| (kind, line.stops.len()))
}

fn width(text: &str) -> usize {
    text.chars().count()
}

fn line_up_stops(lines: &mut [Line]) {
    let count = lines.first().filter(|_| lines.len() > 1).map_or(0, |line| line.stops.len());
    for k in 0..count {
        let widest = lines.iter().map(|line| width(&line.text[..line.stops[k].end])).max().unwrap_or(0);
        for line in lines.iter_mut() {
            let blanks = widest - width(&line.text[..line.stops[k].end]);
            line.text.insert_str(line.stops[k].start, &" ".repeat(blanks));
            for stop in &mut line.stops[k + 1..] {
                stop.start += blanks;
                stop.end += blanks;
            }
        }
    }
}

fn place_comments(lines: &mut [Line]) {
    let extent = |line: &Line| line.indent + width(&line.text);
    let is_beside = |line: &Line| line.comment.is_some() && !line.text.is_empty();
    let is_brace = |line: &Line| line.text == "}" || line.text.ends_with('{');
    let widest = lines.iter().filter(|line| is_beside(line)).map(extent).filter(|width| *width <= WIDEST_LINE).max();
    let column = widest.map_or(0, |widest| widest + COMMENT_GAP).max(COMMENT_COLUMN);
    for line in lines.iter_mut().filter(|line| is_beside(line)) {
        let gap = if is_brace(line) { COMMENT_GAP } else { column.saturating_sub(extent(line)).max(COMMENT_GAP) };
        if let Some(comment) = &mut line.comment {
            comment.gap = gap;
        }
    }
}
