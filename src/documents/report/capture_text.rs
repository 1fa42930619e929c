//! Terminal output of `mavc analyze --capture`.

use super::terminal::vehicle_line;
use crate::flight::capture::{Capture, DELAYS, SEEDS};
use crate::model::Model;
use crate::number::{number, significant};
use crate::text_table::Table;

/// One row for each mode, lag and speed, one column for each delay.
pub fn captures(model: &Model, all: &[Capture]) -> String {
    let mut out = format!("{}\n\n", vehicle_line(model));
    if all.is_empty() {
        out.push_str("Yaw is given up in no mode that can hover: there is no height to be told.\n");
        return out;
    }
    out.push_str(&format!(
        "Height lost [m] from the fault until level flight is regained, by the delay until the fault is known:\n\
         the median of {SEEDS} flights, and the range where it is wider than 0.1 m. Simulated, not proved.\n"
    ));
    let delays = DELAYS.map(|delay| format!("{} ms", number(1000.0 * delay)));
    let headings: Vec<&str> = ["mode", "lag", "speed"].into_iter().chain(delays.iter().map(String::as_str)).collect();
    let mut table = Table::new(&headings);
    for row in all.chunks(DELAYS.len()) {
        let first = &row[0];
        let mut cells = vec![
            first.mode.clone(),
            format!("{} ms", significant(1000.0 * first.lag_s, 3)),
            format!("{} m/s", number(first.speed_m_per_s)),
        ];
        cells.extend(row.iter().map(cell));
        table.row(cells);
    }
    out.push_str(&table.render(0));
    out.push_str(
        "`-`: no flight regains level flight; `3 of 5`: only so many do. The vehicle stops on the spot. Another \
         controller may\n\
         lose less; the gains and sensors are those of `simulate`.\n",
    );
    out
}

fn cell(case: &Capture) -> String {
    let Some([least, median, largest]) = case.height_m else { return "-".into() };
    let up = |height: f64| format!("{:.1}", (10.0 * height).ceil() / 10.0);
    let range = if largest - least > 0.1 { format!(" ({} .. {})", up(least), up(largest)) } else { String::new() };
    let share =
        if case.regained < case.flights { format!(" {} of {}", case.regained, case.flights) } else { String::new() };
    format!("{}{range}{share}", up(median))
}
