//! The polynomials of a trajectory.

use super::Plan;
use crate::motion::{Trajectory, X, Y, YAW, Z};

/// Number of coefficients of a piece on each axis: of a quintic.
pub(super) const COEFFICIENTS: usize = 6;

/// One polynomial for each axis on an interval.
pub(super) struct Piece {
    /// When the piece starts and ends, s.
    pub(super) span: [f64; 2],
    /// For x, y, z and yaw in ascending powers of the time since the start of the piece.
    pub(super) axes: [[f64; COEFFICIENTS]; 4],
}

impl Plan<'_> {
    /// The pieces between nodes, without loss.
    pub(super) fn pieces(&self) -> Vec<Piece> {
        (0..self.trajectory.intervals()).map(|k| piece(self.trajectory, k)).collect()
    }
}

/// `c_i = d_i / i!` for the derivatives d at the left node up to the input, and the slope of the input after them.
fn piece(trajectory: &Trajectory, k: usize) -> Piece {
    let span = [trajectory.times[k], trajectory.times[k + 1]];
    let [left, right] = [&trajectory.nodes[k], &trajectory.nodes[k + 1]];
    let orders = trajectory.model.orders();
    let axes = [X, Y, Z, YAW].map(|axis| {
        let r = orders[axis];
        let mut factorial = 1.0;
        std::array::from_fn(|i| {
            factorial *= i.max(1) as f64;
            let derivative = match i {
                _ if i <= r => left[axis][i],
                _ if i == r + 1 => (right[axis][r] - left[axis][r]) / (span[1] - span[0]),
                _ => 0.0,
            };
            derivative / factorial
        })
    });
    Piece { span, axes }
}
