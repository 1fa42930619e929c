//! Terminal output of `mavc analyze --capture`.

use super::terminal::vehicle_line;
use crate::flight::capture::{Capture, DELAYS, SEEDS};
use crate::flight::variation::corners;
use crate::model::Model;
use crate::number::{number, significant};
use crate::text_table::{Table, indented};

/// One row for each mode, lag and speed, one column for each delay.
pub fn captures(model: &Model, all: &[Capture]) -> String {
    let mut out = format!("{}\n\n", vehicle_line(model));
    if all.is_empty() {
        out.push_str("No mode that can hover gives up yaw, so there is no height to report.\n");
        return out;
    }
    let corners = corners(&model.vehicle).len();
    let flown = match corners {
        1 => format!("the median of {SEEDS} flights, and the range where it is wider than 0.1 m"),
        _ => format!(
            "the largest of {} flights with values at the ends of the spec's intervals ({corners} vehicles)",
            corners.max(SEEDS as usize)
        ),
    };
    out.push_str(&format!(
        "Height lost [m] from the fault until level flight is regained, by the delay until the fault is known:\n\
         {flown}. Simulated, not proved.\n"
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
        cells.extend(row.iter().map(|case| cell(case, corners > 1)));
        table.row(cells);
    }
    out.push_str(&table.render(0));
    out.push_str(
        "`-`: no flight regains level flight; `3 of 5`: only so many do. The vehicle stops on the spot. Another \
         controller may\n\
         lose less; the gains and sensors are those of `simulate`.\n",
    );
    out.push_str(&spins(model, all));
    if all.iter().any(|case| case.settled_rate_rad_s.is_none_or(|rate| rate > SPINS))
        && !model.vehicle.has_rotor_inertia()
    {
        out.push_str(&indented(NO_ROTOR_INERTIA));
    }
    out
}

/// A vehicle that turns faster in the end, rad/s, spins because its rotors leave it no choice.
const SPINS: f64 = 5.0;

/// Why heights without `rotor_inertia` are not to be trusted.
const NO_ROTOR_INERTIA: &str = "Warning: without `rotor_inertia` the rotors have no momentum; that of a propeller can \
                                multiply these heights.";

/// The modes whose spin does not settle within the range of the gyroscope: flights there do not count as regained.
fn spins(model: &Model, all: &[Capture]) -> String {
    let range = model.simulation.gyroscope_range;
    let where_it_is = match corners(&model.vehicle).len() {
        1 => "No flight counts as regained.",
        _ => "Flights at such ends of the intervals do not count as regained.",
    };
    let mut out = String::new();
    for row in all.chunk_by(|a, b| (&a.mode, a.lag_s) == (&b.mode, b.lag_s)) {
        let Capture { mode, lag_s, settled_rate_rad_s, .. } = &row[0];
        let of = format!("{mode} with rotors of {} ms", significant(1000.0 * lag_s, 3));
        let text = match settled_rate_rad_s {
            Some(rate) if *rate <= range => continue,
            Some(rate) => format!(
                "the spin settles at up to {} rad/s, and the gyroscope measures rates up to {} rad/s",
                significant(*rate, 3),
                significant(range, 3)
            ),
            None => "the vehicle does not stay level until its spin has settled".to_string(),
        };
        out.push_str(&indented(&format!("Warning: {of}: {text}. {where_it_is}")));
    }
    out
}

fn cell(case: &Capture, is_worst: bool) -> String {
    let Some([least, median, largest]) = case.height_m else { return "-".into() };
    let up = |height: f64| format!("{:.1}", (10.0 * height).ceil() / 10.0);
    if is_worst {
        let share = if case.regained < case.flights {
            format!(" {} of {}", case.regained, case.flights)
        } else {
            String::new()
        };
        return up(largest) + &share;
    }
    let range = if largest - least > 0.1 { format!(" ({} .. {})", up(least), up(largest)) } else { String::new() };
    let share =
        if case.regained < case.flights { format!(" {} of {}", case.regained, case.flights) } else { String::new() };
    format!("{}{range}{share}", up(median))
}
