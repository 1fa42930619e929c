//! What faults do to the path: a table for each planner.

use crate::campaign::HEALTHY;
use crate::campaign::design::Design;
use crate::campaign::path::PathSums;
use crate::campaign::tally::Tally;
use crate::flight::BrokenLimits;
use crate::flight::damage::HEADING_BROKEN;
use crate::number::{number, part_of_all, significant};
use crate::text_table::Table;
use std::cmp::Reverse;

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
         reference, largest height below it; heading broken: more than {} degrees off, before yaw is given up\n",
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
