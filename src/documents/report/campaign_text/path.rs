//! What faults do to the path: a table for each planner, and its maps.

use crate::campaign::HEALTHY;
use crate::campaign::design::Design;
use crate::campaign::path::PathSums;
use crate::campaign::tally::{Cell, Tally};
use crate::flight::BrokenLimits;
use crate::flight::damage::HEADING_BROKEN;
use crate::number::{number, part_of_all, significant};
use crate::text_table::Table;
use std::cmp::Reverse;

/// Columns of a map.
const MAP: usize = 80;

/// The path of the flights of each mode, lost flights included.
pub(super) fn table(design: &Design, tally: &Tally, p: usize, modes: &[usize]) -> String {
    let headings =
        ["mode", "hover", "deviation", "largest", "drop", "waypoints missed", "heading broken", "limits broken"];
    let mut table = Table::new(&headings);
    table.row(cells(HEALTHY, "", &tally.healthy(p).path));
    for &m in modes {
        table.row(cells(&design.model.modes[m].name, &design.modes[m].words, &tally.mode(p, m).path));
    }
    let note = format!(
        "  the path since the fault, of all struck flights: mean and largest of the largest distances from the \
         reference, largest\n  height below it; heading broken: more than {} degrees off, before yaw is given up\n",
        number(HEADING_BROKEN.to_degrees())
    );
    format!("\n{}{note}", table.render(2))
}

fn cells(name: &str, hover: &str, path: &PathSums) -> Vec<String> {
    let metres = |value: Option<f64>| value.map_or("-".into(), |m| format!("{} m", significant(m, 3)));
    let (deviation, drop) = (path.deviation.summary(), path.drop.summary());
    let missed = match (path.missed, path.due) {
        (_, 0) => "-".into(),
        (0, due) => format!("0 of {due}"),
        (missed, due) => format!("{missed} of {due} ({} %)", part_of_all(missed as f64 / due as f64)),
    };
    vec![
        name.into(),
        hover.into(),
        metres(deviation.map(|s| s.mean)),
        metres(deviation.map(|s| s.max)),
        metres(drop.map(|s| s.max)),
        missed,
        if path.flights == 0 { "-".into() } else { format!("{} of {}", path.heading, path.flights) },
        limits(path),
    ]
}

/// `12 speed, 3 tilt`: how many flights broke each limit, the most frequent first.
fn limits(path: &PathSums) -> String {
    let mut counts: Vec<(&str, usize)> = BrokenLimits::all().into_iter().zip(path.limits).collect();
    counts.retain(|(_, n)| *n > 0);
    counts.sort_by_key(|(_, n)| Reverse(*n));
    let words: Vec<String> = counts.into_iter().map(|(name, n)| format!("{n} {name}")).collect();
    if words.is_empty() { "-".into() } else { words.join(", ") }
}

/// The map of the share of struck flights that were lost, and where waypoints were missed the map of the share of
/// these.
pub(super) fn maps(design: &Design, tally: &Tally, p: usize, modes: &[usize]) -> String {
    let mut out = map(design, tally, p, modes, "Share lost", |c| (c.lost, c.struck));
    let any_missed = modes.iter().any(|&m| tally.mode(p, m).path.missed > 0);
    if any_missed {
        out.push_str(&map(design, tally, p, modes, "Share of the due waypoints missed", |c| {
            (c.path.missed, c.path.due)
        }));
    }
    out
}

/// What a map shows of a cell: a count, of how many.
type Share = fn(&Cell) -> (usize, usize);

/// A map: one line per mode, one column per instant.
fn map(design: &Design, tally: &Tally, p: usize, modes: &[usize], title: &str, share: Share) -> String {
    let times = design.cases.times;
    let columns = times.min(MAP);
    let name = |m: usize| design.model.modes[m].name.as_str();
    let width = modes.iter().map(|&m| name(m).chars().count()).max().unwrap_or(0);
    let mut out = format!("\n  {title}, by the instant of the fault: . none, 1 to 9 tenths, # all");
    let any = |of: &dyn Fn(&Cell) -> bool| modes.iter().any(|&m| tally.cells(p, m).iter().any(of));
    if any(&|c: &Cell| c.flights > 0 && c.struck == 0 && c.diverged == 0) {
        out.push_str(", x lost before it");
    }
    if any(&|c: &Cell| c.diverged > 0) {
        out.push_str(", ? diverged");
    }
    if any(&|c: &Cell| c.struck > 0 && share(c).1 == 0) {
        out.push_str(", - none due");
    }
    out.push('\n');
    for &m in modes {
        let cells = tally.cells(p, m);
        let line = (0..columns).map(|c| mark(&cells[c * times / columns..(c + 1) * times / columns], share));
        out.push_str(&format!("  {:width$}  {}\n", name(m), line.collect::<String>()));
    }
    let end = format!("{} s", number(design.time));
    let gap = columns.saturating_sub(3).max(end.len() + 2);
    out + &format!("  {:width$}  0 s{end:>gap$}\n", "")
}

/// The character of a column, which may cover several cells.
fn mark(cells: &[Cell], share: Share) -> char {
    let sum = |of: fn(&Cell) -> usize| cells.iter().map(of).sum::<usize>();
    let shares = cells.iter().map(share).fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    match (sum(|c| c.flights), sum(|c| c.struck), shares) {
        (0, ..) => ' ',
        _ if sum(|c| c.diverged) > 0 => '?',
        (_, 0, _) => 'x',
        (.., (_, 0)) => '-',
        (.., (0, _)) => '.',
        (.., (some, of)) if some == of => '#',
        // Some and not all: neither 0 nor 10.
        (.., (some, of)) => char::from_digit(((10 * some + of / 2) / of).clamp(1, 9) as u32, 10).unwrap_or('9'),
    }
}
