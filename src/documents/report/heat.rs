//! Heat strips: one line per mode over time, with the smallest margin as a colour or a character.

use crate::admissible::row::VIOLATED;
use crate::model::Model;
use crate::motion::Trajectory;
use crate::motion::nearness::nearness;
use crate::number::number;
use crate::planner::studies::Comparison;

/// Cells of a line.
const COLUMNS: usize = 64;

/// Most modes that are shown.
const MOST_MODES: usize = 24;

/// Classes of margin: upper end as a share of the healthy set's width, character, and background (one of the 256
/// terminal colours).
const CLASSES: [(f64, char, u8); 5] =
    [(-VIOLATED, '#', 160), (0.02, '+', 208), (0.05, '-', 220), (0.10, '.', 150), (f64::INFINITY, ' ', 71)];

/// The meaning of the characters, for the line below a strip.
const LEGEND: [&str; 5] = ["outside", "below 2 %", "below 5 %", "below 10 %", "more"];

fn class(margin: f64) -> (char, u8) {
    let (_, character, colour) = CLASSES.into_iter().find(|c| margin < c.0).unwrap_or(CLASSES[4]);
    (character, colour)
}

fn painted(character: char, background: u8) -> String {
    format!("\x1b[48;5;{background}m{character}\x1b[0m")
}

/// One line per mode in the order of the comparison (of many modes, those with the smallest margins), then the time
/// axis. Empty without modes. [`legend`] explains it.
pub fn strip(model: &Model, comparison: &Comparison, trajectory: &Trajectory, color: bool) -> String {
    let margins = comparison
        .sets
        .iter()
        .map(|set| nearness(trajectory, &model.vehicle, &model.environment(), &set.rows, COLUMNS));
    let lines = comparison.modes.iter().zip(margins).zip(&comparison.sets);
    // A mode without rows has no margin.
    let lines: Vec<(&String, Vec<f64>)> = lines.filter(|(_, set)| !set.rows.is_empty()).map(|(line, _)| line).collect();
    if lines.is_empty() {
        return String::new();
    }
    let least = |line: &Vec<f64>| line.iter().copied().fold(f64::INFINITY, f64::min);
    let mut nearest: Vec<f64> = lines.iter().map(|l| least(&l.1)).collect();
    nearest.sort_by(f64::total_cmp);
    let bound = nearest.get(MOST_MODES - 1).copied().unwrap_or(f64::INFINITY);
    let shown: Vec<&(&String, Vec<f64>)> = lines.iter().filter(|l| least(&l.1) <= bound).take(MOST_MODES).collect();
    let width = shown.iter().map(|l| l.0.chars().count()).max().unwrap_or(0).max(4);
    let mut out = String::new();
    for (name, margins) in &shown {
        let cell = |m: &f64| match (class(*m), color) {
            ((character, _), false) => character.to_string(),
            ((_, colour), true) => painted(' ', colour),
        };
        let cells: String = margins.iter().map(cell).collect();
        out.push_str(&format!("  {name:<width$} |{cells}|\n"));
    }
    let end = format!("{} s", number(trajectory.duration()));
    out.push_str(&format!("  {:<width$} 0{end:>COLUMNS$}\n", ""));
    if shown.len() < lines.len() {
        out.push_str(&format!("  {} more modes with larger margins\n", lines.len() - shown.len()));
    }
    out
}

/// The meaning of the characters or colours of strips, on one line.
pub fn legend(color: bool) -> String {
    let legend: Vec<String> = CLASSES
        .into_iter()
        .zip(LEGEND)
        .map(|((_, character, colour), meaning)| match color {
            true => format!("{} {meaning}", painted(' ', colour)),
            false if character == ' ' => format!("blank {meaning}"),
            false => format!("{character} {meaning}"),
        })
        .collect();
    format!("        {}\n", legend.join("  "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn margins_fall_into_their_classes() {
        let classes = [(-0.5, '#'), (-2.0 * VIOLATED, '#'), (0.0, '+'), (0.03, '-'), (0.07, '.'), (0.3, ' ')];
        for (margin, character) in classes {
            assert_eq!(class(margin).0, character, "{margin}");
        }
    }
}
