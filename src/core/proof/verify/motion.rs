//! The motion of a certificate: polynomial pieces rebuilt from the derivatives at the nodes, and their evaluation.

use super::interval::Interval;
use super::series::Series;
use crate::certificate::{DynamicModel, MAX_NODES, MotionRecord, Vertical};

/// Axes in the order of the records.
pub const X: usize = 0;
pub const Y: usize = 1;
pub const Z: usize = 2;
pub const YAW: usize = 3;

/// Derivatives of one axis up to the fifth; those above a piece's degree are zero.
pub type Axis = [Interval; 6];

/// Enclosures of all derivatives at an instant, or over a time interval.
pub type State = [Axis; 4];

/// Pieces between nodes.
#[derive(Debug, Clone)]
pub struct Motion {
    /// s
    pub times: Vec<f64>,
    /// `[node][axis][derivative]` up to the input's.
    nodes: Vec<[[f64; 5]; 4]>,
    pub waypoint_nodes: Vec<usize>,
    /// The input's derivative order of each axis.
    orders: [usize; 4],
    /// Number of points inside each piece at which rows are checked like at nodes, because the piece is longer than the
    /// spec's samples give.
    extra_points: Vec<usize>,
}

impl Motion {
    /// The motion of a record. `strict` also requires finite numbers and increasing times.
    ///
    /// # Errors
    /// What is wrong with the shape of the record.
    pub fn new(record: &MotionRecord, model: DynamicModel, strict: bool) -> Result<Motion, String> {
        let count = record.nodes();
        let lengths = [record.x.len(), record.y.len(), record.z.len(), record.yaw.len()];
        if count < 2 || lengths.iter().any(|&n| n != count) {
            return Err(format!("{count} times with {lengths:?} nodes of x, y, z and yaw are not a motion"));
        }
        let vertical = match model {
            DynamicModel::Hover => 2,
            DynamicModel::Exact => 4,
        };
        let fits = |z: &Vertical| z.derivatives().len() == vertical + 1;
        if let Some(node) = record.z.iter().position(|z| !fits(z)) {
            return Err(format!("z needs {} numbers at node {node}", vertical + 1));
        }
        let padded = |values: &[f64]| {
            let mut all = [0.0; 5];
            all[..values.len()].copy_from_slice(values);
            all
        };
        let node = |k: usize| [record.x[k], record.y[k], padded(record.z[k].derivatives()), padded(&record.yaw[k])];
        let nodes: Vec<[[f64; 5]; 4]> = (0..count).map(node).collect();
        if strict {
            let finite = record.times_s.iter().chain(nodes.iter().flatten().flatten()).all(|v| v.is_finite());
            if !finite {
                return Err("a number is not finite".into());
            }
            if !record.times_s.windows(2).all(|w| w[0] < w[1]) {
                return Err("the times do not increase".into());
            }
        }
        Ok(Motion {
            times: record.times_s.clone(),
            nodes,
            waypoint_nodes: record.waypoint_nodes.clone(),
            orders: [4, 4, vertical, 2],
            extra_points: vec![0; count - 1],
        })
    }

    /// Requires rows to be checked at `points` points inside a piece.
    pub(super) fn set_extra_points(&mut self, piece: usize, points: usize) {
        if let Some(extra) = self.extra_points.get_mut(piece) {
            *extra = points;
        }
    }

    /// Number of points at which rows are checked: nodes and extra points between them.
    pub fn checkpoints(&self) -> u64 {
        self.extra_points.iter().map(|&n| n as u64).fold(self.times.len() as u64, u64::saturating_add)
    }

    /// Number of extra points inside a piece, at most the largest number of samples.
    pub(super) fn extra_points(&self, piece: usize) -> usize {
        self.extra_points[piece].min(MAX_NODES)
    }

    /// Number of extra points inside some pieces.
    pub(super) fn extra_points_in(&self, pieces: std::ops::Range<usize>) -> u64 {
        let extra = self.extra_points.get(pieces).unwrap_or_default();
        extra.iter().map(|&n| n as u64).fold(0, u64::saturating_add)
    }

    /// The extra points of a piece, s since it began.
    pub fn extra_instants(&self, piece: usize) -> impl Iterator<Item = Interval> {
        self.grid(piece, self.extra_points[piece])
    }

    /// Evenly spaced instants between the ends of a piece, s since it began.
    pub fn grid(&self, piece: usize, points: usize) -> impl Iterator<Item = Interval> {
        let whole = self.duration(piece);
        let share = move |i: usize| Interval::point(i as f64) / Interval::point((points + 1) as f64);
        (1..=points).map(move |i| share(i) * whole)
    }

    /// Number of pieces.
    pub fn pieces(&self) -> usize {
        self.times.len() - 1
    }

    /// The derivative order of an axis's input.
    pub fn order(&self, axis: usize) -> usize {
        self.orders[axis]
    }

    /// A derivative at a node, SI.
    pub fn at_node(&self, node: usize, axis: usize, order: usize) -> f64 {
        self.nodes[node][axis][order]
    }

    /// Duration of a piece, s.
    pub fn duration(&self, piece: usize) -> Interval {
        Interval::point(self.times[piece + 1]) - Interval::point(self.times[piece])
    }

    /// The input's constant rate of change over a piece.
    fn slope(&self, piece: usize, axis: usize) -> Interval {
        let input = self.orders[axis];
        let [left, right] = [piece, piece + 1].map(|node| Interval::point(self.nodes[node][axis][input]));
        (right - left) / self.duration(piece)
    }

    /// The derivatives at a node, with the rates of its inputs in the piece.
    pub fn node_in(&self, node: usize, piece: usize) -> State {
        std::array::from_fn(|axis| {
            let mut state = [Interval::ZERO; 6];
            for (slot, &value) in state.iter_mut().zip(&self.nodes[node][axis][..=self.orders[axis]]) {
                *slot = Interval::point(value);
            }
            state[self.orders[axis] + 1] = self.slope(piece, axis);
            state
        })
    }

    /// Enclosures of all derivatives over a part `at` of a piece, s since the piece began.
    pub fn over(&self, piece: usize, at: Interval) -> State {
        self.node_in(piece, piece).map(|axis| over(&axis, at))
    }

    /// The gaps between the end of a piece and its right node: `[axis][derivative]`, below the input's order.
    pub fn gaps(&self, piece: usize) -> [[f64; 4]; 4] {
        let end = self.over(piece, self.duration(piece));
        std::array::from_fn(|axis| {
            std::array::from_fn(|i| match i < self.orders[axis] {
                true => (end[axis][i] - Interval::point(self.nodes[piece + 1][axis][i])).magnitude(),
                false => 0.0,
            })
        })
    }
}

/// Enclosures of a polynomial's derivatives over the times `at`, from those at 0, by Taylor's formula about the middle
/// of these times: d_i(m) = sum over j >= i of d_j m^(j-i) / (j-i)!.
pub fn over(derivatives: &Axis, at: Interval) -> Axis {
    let middle = Interval::point(at.middle());
    let centre = shifted(derivatives, middle);
    if at.low == at.high { centre } else { shifted(&centre, at - middle) }
}

/// Derivatives of a polynomial after a time `by`.
fn shifted(derivatives: &Axis, by: Interval) -> Axis {
    std::array::from_fn(|i| {
        // Horner: d_i + by (d_(i+1) + by/2 (d_(i+2) + by/3 (...))).
        (i..6).rev().fold(Interval::ZERO, |sum, j| {
            let step = by / Interval::point((j + 1 - i) as f64);
            derivatives[j] + step * sum
        })
    })
}

/// The series of an axis's derivative of some order.
pub fn series<const N: usize>(axis: &Axis, order: usize) -> Series<N> {
    Series::of_derivatives(&axis[order..(order + N).min(6)])
}
