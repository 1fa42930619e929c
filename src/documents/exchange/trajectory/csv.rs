//! mavc's table, in either frame.

use super::{Choices, Exported};
use crate::exchange::frames::Frame;
use crate::report::trajectory_csv::{push_row, table};

/// The table; north, east, down with the same names of columns.
pub(super) fn text(plan: &Exported, choices: &Choices) -> Result<String, String> {
    let text = table(plan.trajectory, plan.model, choices.rate)?;
    Ok(match choices.frame() {
        Frame::EnuFlu => text,
        frame => turned(&text, frame),
    })
}

/// The table with every column in another frame.
fn turned(table: &str, frame: Frame) -> String {
    let header = table.lines().next().unwrap_or_default();
    let names: Vec<&str> = header.split(',').collect();
    let of = |name: &str| names.iter().position(|n| *n == name).expect("a column of the table");
    let vectors = ["", "v", "a", "j", "s"].map(|letter| ["x", "y", "z"].map(|axis| of(&format!("{letter}{axis}"))));
    let torque = ["tau_x", "tau_y", "tau_z"].map(of);
    let mut out = format!("{header}\n");
    for line in table.lines().skip(1) {
        let mut row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        let mut put = |columns: [usize; 3], turn: fn(Frame, [f64; 3]) -> [f64; 3]| {
            let values = turn(frame, columns.map(|column| row[column]));
            columns.iter().zip(values).for_each(|(column, value)| row[*column] = value);
        };
        vectors.iter().for_each(|columns| put(*columns, Frame::world));
        put(torque, Frame::body);
        // The ZYX angles of M R B: roll stays, pitch changes its sign.
        row[of("pitch")] *= -1.0;
        row[of("yaw")] = frame.yaw(row[of("yaw")]);
        for name in ["yaw_rate", "yaw_acc"] {
            row[of(name)] = frame.yaw_rate(row[of(name)]);
        }
        push_row(&mut out, &row);
    }
    out
}
