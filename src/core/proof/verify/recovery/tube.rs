//! Families of motions: the blends of four branches, and all motions that begin and end near those of a blend.

use super::super::interval::Interval;
use super::super::motion::{Motion, State, over};
use super::super::series::Scalar;
use super::super::taylor::{PAIRS, Taylor};
use super::super::wrench::Models;
use super::response::Response;

/// Enclosures of the deviations of derivatives up to the third, SI: `[axis][order]`.
pub type Deviations = [[Interval; 4]; 4];

/// The shares of the last instant and of the longest delay in a blend, each within [0, 1].
pub type Cell = [Interval; 2];

/// The windows in which a motion returns from deviations of its position, velocity, acceleration and jerk, s; a shorter
/// motion takes its whole time. Any windows prove what they prove; chosen by hand.
const WINDOWS: [f64; 4] = [f64::INFINITY, 6.0, 4.0, 3.0];

/// Motions `(1-r) ((1-s) A + s B) + r ((1-s) C + s D)` with s and r in [0, 1], plus responses to deviations at their
/// start and at their end.
pub struct Tube<'m> {
    corners: [&'m Motion; 4],
    /// Whether there is one delay, and only A and B count.
    one_delay: bool,
    /// In the order of derivatives; those to deviations at the end are the same backwards.
    responses: [Response; 4],
}

/// Deviations at both ends from the blends of a cell.
#[derive(Debug, Clone, Copy)]
pub struct Ends {
    pub start: Deviations,
    pub end: Deviations,
}

impl Ends {
    pub const NONE: Ends = Ends { start: [[Interval::ZERO; 4]; 4], end: [[Interval::ZERO; 4]; 4] };
}

impl<'m> Tube<'m> {
    /// # Errors
    /// The branches do not have the same times or parts.
    pub fn new(corners: [&'m Motion; 4], one_delay: bool) -> Result<Self, String> {
        let [a, b, c, d] = corners;
        let differs = |other: &&Motion| other.times != a.times || other.waypoint_nodes != a.waypoint_nodes;
        if [b, c, d].iter().any(differs) {
            return Err("its branches have different node times or parts".into());
        }
        let duration = a.times[a.pieces()];
        let responses = std::array::from_fn(|order| Response::new(order, WINDOWS[order].min(duration)));
        Ok(Tube { corners, one_delay, responses })
    }

    /// One of the branches, whose node times all have.
    pub fn branch(&self) -> &'m Motion {
        self.corners[0]
    }

    /// From their start to their end, s.
    pub fn duration(&self) -> f64 {
        self.branch().times[self.branch().pieces()]
    }

    /// The dimensions of blends: with one delay only the instant of the fault varies.
    pub fn dimensions(&self) -> usize {
        if self.one_delay { 1 } else { 2 }
    }

    /// Enclosures over a part of a piece, s since it began, of all derivatives of the blend in the middle of a cell,
    /// and there of their rates of change with s, with r and with both.
    pub fn expansion(&self, piece: usize, part: Interval, cell: Cell) -> [State; 4] {
        let [middle, by_s, by_r, crossed] = blended(&self.corners.map(|motion| motion.node_in(piece, piece)), cell);
        if self.one_delay {
            return [moved(&middle, part), moved(&by_s, part), NOTHING, NOTHING];
        }
        [middle, by_s, by_r, crossed].map(|state| moved(&state, part))
    }

    /// All derivatives over a part of a piece, s since it began, as functions of the deviations of s and r from the
    /// middle of a cell, in halves of its sides.
    pub fn models(&self, piece: usize, part: Interval, cell: Cell, ends: &Ends) -> Models {
        let [middle, by_s, by_r, crossed] = self.expansion(piece, part, cell);
        let [ds, dr] = cell.map(|share| Interval::point((share - Interval::point(share.middle())).magnitude()));
        let deviations = self.deviations(piece, part, ends);
        std::array::from_fn(|axis| {
            std::array::from_fn(|order| {
                let deviation = deviations[axis][order];
                let centre = Interval::point(deviation.middle());
                let mut model = Taylor::of(middle[axis][order] + centre);
                model.linear[0] = by_s[axis][order] * ds;
                model.linear[1] = by_r[axis][order] * dr;
                model.quadratic[CROSSED] = crossed[axis][order] * ds * dr;
                model.rest = (deviation - centre).magnitude();
                model
            })
        })
    }

    /// Enclosures of all derivatives of the motions of a cell over a part of a piece, s since it began.
    pub fn over(&self, piece: usize, part: Interval, cell: Cell, ends: &Ends) -> State {
        let [middle, by_s, by_r, crossed] = self.expansion(piece, part, cell);
        let [ds, dr] = cell.map(|share| share - Interval::point(share.middle()));
        let mut state = plus(&middle, &by_s, ds);
        if !self.one_delay {
            state = plus(&plus(&state, &by_r, dr), &crossed, ds * dr);
        }
        plus(&state, &self.deviations(piece, part, ends), Interval::ONE)
    }

    /// By how much the motions of a cell deviate from its blends.
    fn deviations(&self, piece: usize, part: Interval, ends: &Ends) -> State {
        let mut state = NOTHING;
        let since = Interval::point(self.branch().times[piece]) + part;
        let before = Interval::point(self.duration()) - since;
        for (deviations, at, backwards) in [(&ends.start, since, false), (&ends.end, before, true)] {
            for (order, response) in self.responses.iter().enumerate() {
                if (0..4).all(|axis| deviations[axis][order] == Interval::ZERO) {
                    continue;
                }
                let mut values = response.over(at);
                // Backwards in time, odd derivatives change their sign, and so does the deviation of an odd one.
                if backwards {
                    values.iter_mut().enumerate().filter(|(k, _)| (k + order) % 2 == 1).for_each(|(_, v)| *v = -*v);
                }
                for (axis, derivatives) in state.iter_mut().enumerate() {
                    for (derivative, value) in derivatives.iter_mut().zip(values) {
                        *derivative = *derivative + value * deviations[axis][order];
                    }
                }
            }
        }
        state
    }
}

/// The place of the product of s and r among [`PAIRS`].
const CROSSED: usize = 3;

const _: () = assert!(PAIRS[CROSSED].0 == 0 && PAIRS[CROSSED].1 == 1);

const NOTHING: State = [[Interval::ZERO; 6]; 4];

/// The blend of four states in the middle of a cell, and its rates of change with s, with r and with both.
pub fn blended([a, b, c, d]: &[State; 4], cell: Cell) -> [State; 4] {
    let [s, r] = cell.map(|share| Interval::point(share.middle()));
    let along = minus(b, a);
    let (across, crossed) = (minus(c, a), minus(&minus(d, c), &along));
    let middle = plus(&plus(&plus(a, &along, s), &across, r), &crossed, s * r);
    [middle, plus(&along, &crossed, r), plus(&across, &crossed, s), crossed]
}

/// The derivatives of polynomials at the left end of a piece, over a part of the piece.
fn moved(left: &State, part: Interval) -> State {
    left.map(|axis| over(&axis, part))
}

/// a + weight b
fn plus(a: &State, b: &State, weight: Interval) -> State {
    std::array::from_fn(|axis| std::array::from_fn(|order| a[axis][order] + b[axis][order] * weight))
}

fn minus(a: &State, b: &State) -> State {
    std::array::from_fn(|axis| std::array::from_fn(|order| a[axis][order] - b[axis][order]))
}
