//! The trajectory table (CSV). Scripts rely on its columns.

use crate::admissible::allocation::Allocator;
use crate::model::Model;
use crate::motion::{Trajectory, X, Y, YAW, Z, roll_pitch};
use crate::number::push_shortest;
use std::ops::RangeInclusive;

/// Most numbers in one table: its text, about 18 bytes per number, then takes less than 500 MB while it is written.
const MAX_NUMBERS: u64 = 10_000_000;

/// The rates that tables and logs may have, Hz.
pub const RATES: RangeInclusive<f64> = 1e-3..=1e5;

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// s since the start.
    pub time: f64,
    /// The waypoint that this row marks, from 1; 0 for none. If several share their nearest row, the last of them.
    pub waypoint: usize,
}

/// The rows of the table: one per node or, with a `rate` in Hz, one at each k/rate up to the first instant at or after
/// the end. Each waypoint marks its node or, with a rate, the nearest row.
pub fn rows(trajectory: &Trajectory, rate: Option<f64>) -> Vec<Row> {
    let times: Vec<f64> = match rate {
        None => trajectory.times.clone(),
        Some(rate) => (0..=last_row(trajectory.duration(), rate)).map(|k| k as f64 / rate).collect(),
    };
    let mut rows: Vec<Row> = times.into_iter().map(|time| Row { time, waypoint: 0 }).collect();
    for (waypoint, &node) in trajectory.waypoint_nodes.iter().enumerate() {
        let row = rate.map_or(node, |rate| (trajectory.times[node] * rate).round() as usize);
        rows[row].waypoint = waypoint + 1;
    }
    rows
}

/// Index of the last row at `rate` (Hz) for a flight of `duration` s: the first one at or after its end.
fn last_row(duration: f64, rate: f64) -> u64 {
    let rows = duration * rate;
    // An end that coincides with a row up to rounding needs no further row.
    let on_row = (rows - rows.round()).abs() <= 1e-9 * rows.max(1.0);
    (if on_row { rows.round() } else { rows.ceil() }) as u64
}

/// Whether a table of `rows` rows under the columns of `header` is small enough; messages call it `name`.
///
/// # Errors
/// It would have more than `MAX_NUMBERS` numbers.
pub fn few_enough(name: &str, rows: u64, header: &str) -> Result<(), String> {
    let columns = header.split(',').count() as u64;
    let most = MAX_NUMBERS / columns;
    match rows <= most {
        true => Ok(()),
        false => Err(format!(
            "the {name} would have {rows} rows of {columns} numbers; at most {most} rows are allowed: use a lower \
             --rate"
        )),
    }
}

/// The table of a plan, with rows at a rate (Hz) or one per node.
///
/// # Errors
/// The table would have too many numbers.
pub fn table(trajectory: &Trajectory, model: &Model, rate: Option<f64>) -> Result<String, String> {
    few_enough("trajectory", count(trajectory, rate), &header(model.vehicle.rotors.len()))?;
    Ok(render(trajectory, model, rate))
}

/// The names of the columns.
pub fn header(rotors: usize) -> String {
    let mut header = String::from(
        "t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax,ay,az,yaw_acc,jx,jy,jz,sx,sy,sz,roll,pitch,thrust,tau_x,tau_y,tau_z",
    );
    for k in 1..=rotors {
        header.push_str(&format!(",omega_{k}"));
    }
    header + ",waypoint"
}

/// Number of rows of the table; see [`rows`].
pub fn count(trajectory: &Trajectory, rate: Option<f64>) -> u64 {
    rate.map_or(trajectory.times.len() as u64, |rate| last_row(trajectory.duration(), rate) + 1)
}

/// The table as CSV text: one line per row, shortest round-trip numbers, `\n` line ends. A row after the end of the
/// flight repeats the last state.
pub fn render(trajectory: &Trajectory, model: &Model, rate: Option<f64>) -> String {
    let allocator = Allocator::new(&model.vehicle);
    let environment = model.environment();
    let mut out = header(model.vehicle.rotors.len()) + "\n";
    for Row { time, waypoint } in rows(trajectory, rate) {
        let s = trajectory.at(time);
        let (roll, pitch) = roll_pitch(&s, &environment);
        let wrench = trajectory.wrench(&model.vehicle, &environment, &s);
        let mut row = vec![time];
        row.extend([s[X][0], s[Y][0], s[Z][0], s[YAW][0]]);
        row.extend([s[X][1], s[Y][1], s[Z][1], s[YAW][1]]);
        row.extend([s[X][2], s[Y][2], s[Z][2], s[YAW][2]]);
        row.extend([s[X][3], s[Y][3], s[Z][3]]);
        row.extend([s[X][4], s[Y][4], s[Z][4]]);
        row.extend([roll, pitch]);
        row.extend(wrench.iter());
        row.extend(allocator.speeds(&wrench));
        row.push(waypoint as f64);
        push_row(&mut out, &row);
    }
    out
}

/// Appends a line of numbers, each as the shortest text that reads back as the same number; no `-0`.
pub fn push_row(out: &mut String, row: &[f64]) {
    for (k, v) in row.iter().enumerate() {
        if k > 0 {
            out.push(',');
        }
        push_shortest(out, *v);
    }
    out.push('\n');
}
