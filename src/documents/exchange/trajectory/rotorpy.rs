//! A Python module with a trajectory class as RotorPy expects it: `update(t)` returns the flat outputs.

use super::{Plan, list};
use std::fmt::Write;

const TEMPLATE: &str = include_str!("../../../../assets/exchange/rotorpy_trajectory.py");

/// The line in whose place the pieces are written.
const PLACE: &str = "TIMES, PIECES = [], []  # the plan\n";
/// What stands for the plan in the first line of the documentation.
const TITLE: &str = "A PLAN";

/// The plan's own polynomials, without loss.
pub(super) fn text(plan: &Plan) -> String {
    let pieces = plan.pieces();
    let mut data = format!("TIMES = {}\nPIECES = [\n", list(plan.trajectory.times.iter().copied()));
    for piece in &pieces {
        let _ = writeln!(data, "    [{}],", piece.axes.map(list).join(", "));
    }
    data.push_str("]\n");
    let [subject, version] = plan.origin();
    TEMPLATE.replacen(PLACE, &data, 1).replacen(TITLE, &format!("{subject}. {version}"), 1)
}
