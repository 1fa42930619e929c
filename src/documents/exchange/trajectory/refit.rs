//! A trajectory refitted by fewer polynomials of degree 7.
//!
//! A piece meets position, velocity and acceleration of the trajectory at both ends, so that the pieces join with
//! continuous acceleration (C2); its two free coefficients are those of least squares. Pieces that met the jerk as well
//! would have none: on long missions their errors were seven to nine times as large. Pieces end at nodes. As few are
//! taken as the tolerance needs; with that many the largest error is then made smallest.

use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use nalgebra::{Matrix2, Vector2};

/// Number of coefficients of a piece on each axis.
pub(super) const COEFFICIENTS: usize = 8;

/// One polynomial for each axis.
pub(super) struct Piece {
    /// When the piece starts, s; after the rounded durations of those before it.
    start: f64,
    /// s, a float32.
    pub(super) duration: f64,
    /// For x, y, z and yaw in ascending powers of the time since the start of the piece, each a float32.
    pub(super) axes: [[f64; COEFFICIENTS]; 4],
}

/// The pieces and their largest errors.
pub(super) struct Fit {
    pub(super) pieces: Vec<Piece>,
    pub(super) errors: Errors,
}

/// Largest errors, and when that of the position occurs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Errors {
    /// m
    pub(super) position: f64,
    /// s
    pub(super) at: f64,
    /// m/s
    pub(super) velocity: f64,
    /// rad
    pub(super) yaw: f64,
}

/// Instants of each interval between nodes at which errors are taken: as many while pieces are searched as in the end,
/// so that what is found is what is measured.
const MEASURED: usize = 16;

/// The tolerance, m and rad, from which the smallest that some pieces reach is sought by doubling: the same for every
/// tolerance of the user, so that one proposed to the user is reached.
const FINEST: f64 = 1e-6;

/// Halvings of the range, a factor of 2^20, in which the smallest tolerance is sought for a number of pieces.
const HALVINGS: usize = 12;
const RANGE: f64 = 20.0;

/// The fit with the fewest pieces, `most` at most, whose positions (m) and yaw (rad) are within `tolerance`.
///
/// # Errors
/// That needs more pieces; the best fit with `most` pieces.
pub(super) fn refit(trajectory: &Trajectory, most: usize, tolerance: f64) -> Result<Fit, Fit> {
    if let Some(nodes) = nodes_within(trajectory, most, tolerance) {
        let fit = best(trajectory, nodes.len() - 1, tolerance);
        if fit.is_within(tolerance) {
            return Ok(fit);
        }
    }
    let mut enough = FINEST;
    while nodes_within(trajectory, most, enough).is_none() {
        enough *= 2.0;
    }
    // A piece of a single interval is taken whatever its error, so that this one may reach the tolerance too.
    let fit = best(trajectory, most, enough);
    if fit.is_within(tolerance) { Ok(fit) } else { Err(fit) }
}

impl Fit {
    /// Whether positions (m) and yaw (rad) are within a tolerance.
    fn is_within(&self, tolerance: f64) -> bool {
        self.errors.position <= tolerance && self.errors.yaw <= tolerance
    }
}

/// The fit with at most `count` pieces and the smallest error, from a tolerance that so many reach.
fn best(trajectory: &Trajectory, count: usize, reached: f64) -> Fit {
    // Powers of two of the tolerance: `high` is reached.
    let (mut low, mut high) = (-RANGE, 0.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match nodes_within(trajectory, count, reached * middle.exp2()) {
            Some(_) => high = middle,
            None => low = middle,
        }
    }
    let nodes = nodes_within(trajectory, count, reached * high.exp2()).unwrap_or_default();
    let mut ends: Vec<f64> = nodes.iter().map(|node| trajectory.times[*node]).collect();
    if ends.len() == 2 {
        // Some loaders fail on a single piece.
        ends.insert(1, 0.5 * (ends[0] + ends[1]));
    }
    let mut pieces: Vec<Piece> = Vec::new();
    let mut errors = Errors::default();
    for end in ends.windows(2) {
        let start = pieces.last().map_or(end[0], |last| last.start + last.duration);
        let piece = Piece::new(trajectory, [start, end[1]]);
        errors = errors.and(piece.errors(trajectory, MEASURED));
        pieces.push(piece);
    }
    Fit { pieces, errors }
}

/// The nodes at which pieces end, the first and the last node with them: each piece as long as the tolerance permits.
/// `None` if there are more than `most`.
fn nodes_within(trajectory: &Trajectory, most: usize, tolerance: f64) -> Option<Vec<usize>> {
    let last = trajectory.intervals();
    let mut nodes = vec![0];
    while let Some(&from) = nodes.last().filter(|node| **node < last) {
        if nodes.len() > most {
            return None;
        }
        let is_within = |to: usize| {
            let piece = Piece::new(trajectory, [trajectory.times[from], trajectory.times[to]]);
            let errors = piece.errors(trajectory, MEASURED);
            errors.position <= tolerance && errors.yaw <= tolerance
        };
        // A single interval always fits, up to rounding: the plan has a lower degree there.
        let (mut to, mut step) = (from + 1, 1);
        while to < last && is_within((to + step).min(last)) {
            to = (to + step).min(last);
            step *= 2;
        }
        while step > 1 {
            step /= 2;
            if to + step <= last && is_within(to + step) {
                to += step;
            }
        }
        nodes.push(to);
    }
    Some(nodes)
}

impl Piece {
    /// The piece between two instants (s); its duration and coefficients are rounded to float32.
    fn new(trajectory: &Trajectory, [start, end]: [f64; 2]) -> Piece {
        let duration = single(end - start);
        let [left, right] = [trajectory.at(start), trajectory.at(start + duration)];
        let exact: [NodeState; FITTED] = std::array::from_fn(|k| trajectory.at(start + instant(k) * duration));
        let axes = [X, Y, Z, YAW].map(|axis| {
            let mut scaled = hermite(&left[axis], &right[axis], duration);
            least_squares(&mut scaled, &exact.map(|state| state[axis][0]));
            std::array::from_fn(|i| single(scaled[i] / duration.powi(i as i32)))
        });
        Piece { start, duration, axes }
    }

    /// Position and velocity of each axis `t` s after the start.
    fn at(&self, t: f64) -> [[f64; 2]; 4] {
        self.axes.map(|c| {
            let (mut value, mut slope) = (0.0, 0.0);
            for coefficient in c.iter().rev() {
                slope = slope * t + value;
                value = value * t + coefficient;
            }
            [value, slope]
        })
    }

    /// The largest errors at `count` instants of each interval between nodes, and at its end.
    fn errors(&self, trajectory: &Trajectory, count: usize) -> Errors {
        let end = self.start + self.duration;
        let mut errors = Errors::default();
        let first = trajectory.times.partition_point(|t| *t <= self.start);
        let inner = trajectory.times[first..].iter().copied().take_while(|t| *t < end);
        let mut from = self.start;
        for to in inner.chain([end]) {
            for k in 1..=count {
                let time = from + (to - from) * k as f64 / count as f64;
                errors = errors.and(self.error(&trajectory.at(time), time));
            }
            from = to;
        }
        errors
    }

    fn error(&self, exact: &NodeState, time: f64) -> Errors {
        let fit = self.at(time - self.start);
        let off = |order: usize| [X, Y, Z].map(|axis| (fit[axis][order] - exact[axis][order]).powi(2));
        let norm = |squares: [f64; 3]| squares.iter().sum::<f64>().sqrt();
        let yaw = (fit[YAW][0] - exact[YAW][0]).abs();
        Errors { position: norm(off(0)), at: time, velocity: norm(off(1)), yaw }
    }
}

impl Errors {
    fn and(self, other: Errors) -> Errors {
        let at = if other.position > self.position { other.at } else { self.at };
        Errors {
            position: self.position.max(other.position),
            at,
            velocity: self.velocity.max(other.velocity),
            yaw: self.yaw.max(other.yaw),
        }
    }
}

/// Coefficients in powers of u = t/h of the quintic with value, slope and second derivative of `left` at u = 0 and of
/// `right` at u = 1.
fn hermite(left: &[f64; 5], right: &[f64; 5], h: f64) -> [f64; COEFFICIENTS] {
    let [p0, v0, a0] = [left[0], left[1] * h, left[2] * h * h];
    let [p1, v1, a1] = [right[0], right[1] * h, right[2] * h * h];
    let step = p1 - p0;
    [
        p0,
        v0,
        0.5 * a0,
        10.0 * step - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
        -15.0 * step + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
        6.0 * step - 3.0 * (v0 + v1) - 0.5 * (a0 - a1),
        0.0,
        0.0,
    ]
}

/// Number of instants of a fit of least squares.
const FITTED: usize = 24;

/// The place of one of them in its piece, between 0 and 1.
fn instant(k: usize) -> f64 {
    (k + 1) as f64 / (FITTED + 1) as f64
}

/// Adds `(a + b u) u^3 (1 - u)^3`, which leaves the first two derivatives at both ends, with a and b such that the
/// polynomial is nearest to `exact` in least squares.
fn least_squares(c: &mut [f64; COEFFICIENTS], exact: &[f64; FITTED]) {
    let (mut normal, mut right) = (Matrix2::zeros(), Vector2::zeros());
    for (k, value) in exact.iter().enumerate() {
        let u = instant(k);
        let bump = (u * (1.0 - u)).powi(3);
        let row = Vector2::new(bump, u * bump);
        normal += row * row.transpose();
        right += row * (value - c.iter().rev().fold(0.0, |sum, coefficient| sum * u + coefficient));
    }
    let Some(found) = normal.lu().solve(&right) else { return };
    // u^3 (1 - u)^3 = u^3 - 3 u^4 + 3 u^5 - u^6
    for (power, share) in [(3, 1.0), (4, -3.0), (5, 3.0), (6, -1.0)] {
        c[power] += share * found[0];
        c[power + 1] += share * found[1];
    }
}

fn single(value: f64) -> f64 {
    f64::from(value as f32)
}
