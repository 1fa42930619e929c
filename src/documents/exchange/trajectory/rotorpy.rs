//! A Python module with a trajectory class as RotorPy expects it: `update(t)` returns the flat outputs.

use super::{Exported, list};
use crate::motion::{Trajectory, X, Y, YAW, Z};
use std::fmt::Write;

const TEMPLATE: &str = include_str!("../../../../assets/exchange/rotorpy_trajectory.py");

/// The line in whose place the pieces are written.
const PLACE: &str = "TIMES, PIECES = [], []  # the plan\n";
/// What stands for the plan in the first line of the documentation.
const TITLE: &str = "A PLAN";

/// The plan's own polynomials, without loss.
pub(super) fn text(plan: &Exported) -> String {
    let pieces = plan.pieces();
    let mut data = format!("TIMES = {}\nPIECES = [\n", list(plan.trajectory.times.iter().copied()));
    for piece in &pieces {
        let _ = writeln!(data, "    [{}],", piece.map(list).join(", "));
    }
    data.push_str("]\n");
    let [subject, version] = plan.origin();
    TEMPLATE.replacen(PLACE, &data, 1).replacen(TITLE, &format!("{subject}. {version}"), 1)
}

/// Number of coefficients of a piece on each axis: of a quintic.
const COEFFICIENTS: usize = 6;

/// One polynomial for each of x, y, z and yaw on an interval, in ascending powers of the time since its start.
type Piece = [[f64; COEFFICIENTS]; 4];

impl Exported<'_> {
    /// The pieces between nodes, without loss.
    fn pieces(&self) -> Vec<Piece> {
        (0..self.trajectory.intervals()).map(|k| piece(self.trajectory, k)).collect()
    }
}

/// `c_i = d_i / i!` for the derivatives d at the left node up to the input, and the slope of the input after them.
fn piece(trajectory: &Trajectory, k: usize) -> Piece {
    let [left, right] = [&trajectory.nodes[k], &trajectory.nodes[k + 1]];
    let orders = trajectory.model.orders();
    [X, Y, Z, YAW].map(|axis| {
        let r = orders[axis];
        let mut factorial = 1.0;
        std::array::from_fn(|i| {
            factorial *= i.max(1) as f64;
            let derivative = match i {
                _ if i <= r => left[axis][i],
                _ if i == r + 1 => (right[axis][r] - left[axis][r]) / (trajectory.times[k + 1] - trajectory.times[k]),
                _ => 0.0,
            };
            derivative / factorial
        })
    })
}
