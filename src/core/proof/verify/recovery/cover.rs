//! Covers a family with cells, and the time of its motions with parts, until every row holds in all of them.

use super::super::cost::WorkLeft;
use super::super::interval::{Interval, exceeds};
use super::super::motion::{Motion, State, X, Y, Z};
use super::super::proof::{Family, Rated};
use super::super::series::Scalar;
use super::super::sets::Plane;
use super::super::taylor::Taylor;
use super::super::wrench::{Dynamics, Held};
use super::start::{StartAbout, along};
use super::tube::{Cell, Deviations, Ends, Tube, blended};
use super::way::Way;
use crate::model::{HeldLimit, LimitKind, STOPS_TURNING};
use std::ops::Range;

/// Most bisections of the cells of a family.
const DEEPEST_CELL: u32 = 7;

/// Most bisections of the time in one piece, for one cell.
const DEEPEST_TIME: u32 = 8;

/// Units of work of enclosing the motions of a cell, in addition to those of a row.
const OF_A_TUBE: u64 = 200;

/// How many times as much work functions of the blend take as enclosures.
const MODELS: u64 = 10;

/// A quantity that has to stay at or below a bound in some pieces of all motions of a family.
pub(super) struct FamilyRow<'r> {
    pub name: String,
    pub family: Family<'r>,
    /// The quantity and the planes of a row on the wrench in one wind, for which blends are followed as functions.
    pub planes: Option<(Held, &'r [Plane])>,
    pub pieces: Range<usize>,
    /// The limit after a fault that it is, whose bound yields to the state in which the fault becomes known.
    pub held: Option<&'r HeldLimit>,
    pub most: f64,
}

/// Why a family is not shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Missed {
    /// What may be violated.
    pub row: String,
    /// s since the fault is known.
    pub at: f64,
    /// The enclosure of the violation at one instant there, in the unit of the row: if its width is the reason, smaller
    /// families may pass.
    pub value: Interval,
}

pub(super) struct Cover<'c, 'm, 's, 'a> {
    pub tube: &'c Tube<'m>,
    pub rows: &'c [FamilyRow<'c>],
    pub start: &'c StartAbout<'s, 'a>,
    pub way: &'c Way,
    pub plan: &'c Motion,
    pub dynamics: &'c Dynamics<'a>,
    pub purse: &'c mut WorkLeft,
}

/// A row that does not hold yet, on a piece.
#[derive(Clone, Copy)]
struct Open {
    row: usize,
    piece: usize,
}

impl Cover<'_, '_, '_, '_> {
    /// Whether every row holds along all motions of the family.
    pub fn all(mut self) -> Result<(), Missed> {
        let rows = self.rows.iter().enumerate();
        let open = rows.flat_map(|(row, of)| of.pieces.clone().map(move |piece| Open { row, piece })).collect();
        let everything = Interval::new(0.0, 1.0);
        let delays = if self.tube.dimensions() == 1 { Interval::ZERO } else { everything };
        self.cell(open, [everything, delays], DEEPEST_CELL)
    }

    fn cell(&mut self, open: Vec<Open>, cell: Cell, deeper: u32) -> Result<(), Missed> {
        let ends = self.ends(cell);
        let first = self.tube.over(0, Interval::ZERO, cell, &ends);
        let yields: Vec<f64> = self.rows.iter().map(|row| self.yields(row, &first)).collect();
        let (mut left, mut worst) = (Vec::new(), None);
        for at in open {
            let whole = Interval::new(0.0, self.tube.branch().duration(at.piece).high);
            let most = self.rows[at.row].most + yields[at.row];
            if let Err(missed) = self.part(at, whole, cell, &ends, most, DEEPEST_TIME) {
                if missed.value.low > most {
                    return Err(missed);
                }
                worst.get_or_insert(missed);
                left.push(at);
            }
        }
        let Some(worst) = worst else { return Ok(()) };
        if deeper == 0 || self.purse.0 == 0 {
            return Err(worst);
        }
        let axis = match self.tube.dimensions() {
            1 => 0,
            _ => usize::from(cell[1].high - cell[1].low > cell[0].high - cell[0].low),
        };
        let middle = cell[axis].middle();
        for half in [Interval::new(cell[axis].low, middle), Interval::new(middle, cell[axis].high)] {
            let mut part = cell;
            part[axis] = half;
            self.cell(left.clone(), part, deeper - 1)?;
        }
        Ok(())
    }

    /// Bisects a part of a piece until the mean value form bounds a row for all motions of a cell.
    fn part(
        &mut self,
        open: Open,
        part: Interval,
        cell: Cell,
        ends: &Ends,
        most: f64,
        deeper: u32,
    ) -> Result<(), Missed> {
        let FamilyRow { family, name, planes, .. } = &self.rows[open.row];
        let units = family.overhead + family.of_a_member * family.members as u64 + OF_A_TUBE;
        let units = if planes.is_some() { MODELS * units } else { units };
        let at = self.tube.branch().times[open.piece] + part.middle();
        let missed = |value: Interval| Missed { row: name.clone(), at, value };
        if !self.purse.spend(units) {
            return Err(missed(Interval::WHOLE));
        }
        let over = self.evaluate(open, part, cell, ends);
        if over.iter().all(|of| !exceeds(of.value.high, most)) {
            return Ok(());
        }
        if !self.purse.spend(units) {
            return Err(missed(Interval::WHOLE));
        }
        let middle = Interval::point(part.middle());
        let there = self.evaluate(open, middle, cell, ends);
        let away = part - middle;
        let mut is_open = false;
        for (over, there) in over.iter().zip(&there) {
            // Too wide at an instant: shorter times do not help.
            if exceeds(there.value.high, most) {
                return Err(missed(there.value));
            }
            is_open |= exceeds((there.value + over.rate * away).meet(over.value).high, most);
        }
        if !is_open {
            return Ok(());
        }
        if deeper == 0 {
            let largest = over.iter().map(|of| of.value).max_by(|a, b| a.high.total_cmp(&b.high));
            return Err(missed(largest.unwrap_or(Interval::WHOLE)));
        }
        for half in [Interval::new(part.low, middle.low), Interval::new(middle.low, part.high)] {
            self.part(open, half, cell, ends, most, deeper - 1)?;
        }
        Ok(())
    }

    /// The members of a row for all motions of a cell, over a part of a piece.
    fn evaluate(&self, Open { row, piece }: Open, part: Interval, cell: Cell, ends: &Ends) -> Vec<Rated> {
        let FamilyRow { family, planes, .. } = &self.rows[row];
        let state = self.tube.over(piece, part, cell, ends);
        let Some((held, planes)) = planes else {
            return (family.evaluate)(&state, &(0..family.members).collect::<Vec<usize>>());
        };
        let found = self.dynamics.held_by_models(*held, &state, &self.tube.models(piece, part, cell, ends));
        let along = |normal: &[Interval; 4], of: &[Taylor; 4]| {
            normal.iter().zip(of).fold(Taylor::of(Interval::ZERO), |sum, (n, part)| sum + part.scaled(*n)).range()
        };
        let rated = |plane: &Plane| Rated {
            value: along(&plane.normal, &found.value) - plane.offset,
            rate: along(&plane.normal, &found.rate),
        };
        planes.iter().map(rated).collect()
    }

    /// The deviations from the blends of a cell that all its motions need at their ends.
    ///
    /// A motion begins near the state of the plan when the fault becomes known, plus the blend of how far the branches
    /// begin from the plan.
    fn ends(&self, cell: Cell) -> Ends {
        let at_corners = [[0, 0], [1, 0], [0, 1], [1, 1]]
            .map(|[s, r]| along(self.plan, self.start.known([s, r].map(|share| Interval::point(f64::from(share))))));
        let start = self.short_of_the_plan(cell, 0.0, &blended(&at_corners, cell));
        let expected = self.tube.over(0, Interval::ZERO, cell, &Ends { start, ..Ends::NONE });
        let within = self.start.deviations(&expected);
        let start = std::array::from_fn(|axis| std::array::from_fn(|i| start[axis][i] + within[axis][i]));
        match self.way {
            Way::Down(_) => Ends { start, ..Ends::NONE },
            Way::Back => {
                let last = self.tube.branch().pieces() - 1;
                let blends = self.tube.expansion(last, self.tube.branch().duration(last), cell);
                Ends { start, end: self.short_of_the_plan(cell, self.tube.duration(), &blends) }
            }
        }
    }

    /// How far the plan is from blends, some time after the fault becomes known. With the plan y at the time J of a
    /// motion, which is linear in s and r, and the blend b:
    ///
    /// `y(J) - b = y(J_m) - b_m + (y' dJ/ds - db/ds) ds + (y' dJ/dr - db/dr) dr - d^2b/(ds dr) ds dr`,
    ///
    /// with ds and dr from the middle m of the cell, and y' over all J.
    fn short_of_the_plan(&self, cell: Cell, after: f64, [middle, by_s, by_r, crossed]: &[State; 4]) -> Deviations {
        let centre = cell.map(|share| Interval::point(share.middle()));
        let [ds, dr] = [cell[0] - centre[0], cell[1] - centre[1]];
        let after = Interval::point(after);
        let there = along(self.plan, self.start.known(centre) + after);
        let all = along(self.plan, self.start.known(cell) + after);
        let width = |[from, to]: [f64; 2]| Interval::point(to) - Interval::point(from);
        let (faults, delays) = (width(self.start.faults), width(self.start.delays));
        std::array::from_fn(|axis| {
            std::array::from_fn(|order| {
                if order >= self.plan.order(axis) {
                    return Interval::ZERO;
                }
                let slope = all[axis][order + 1];
                let by_fault = (slope * faults - by_s[axis][order]) * ds;
                let by_delay = (slope * delays - by_r[axis][order]) * dr;
                let apart = there[axis][order] - middle[axis][order];
                apart + by_fault + by_delay - crossed[axis][order] * ds * dr
            })
        })
    }

    /// By how much the bound of a row yields to the states in which the fault becomes known.
    fn yields(&self, row: &FamilyRow, first: &State) -> f64 {
        let Some(held) = row.held else { return 0.0 };
        let members: Vec<usize> = (0..row.family.members).collect();
        let over = (row.family.evaluate)(first, &members).iter().map(|of| of.value.high).fold(0.0, f64::max);
        let further = match held.limit.kind {
            LimitKind::Tilt => tilts_further(first, self.start.gravity()),
            _ => 0.0,
        };
        (over + further).min(held.yields)
    }
}

/// How far a thrust moves away from a cone before its turning is stopped at [`STOPS_TURNING`], as a share of gravity.
fn tilts_further(first: &State, gravity: f64) -> f64 {
    let square = |axis: usize, order: usize| first[axis][order].square();
    let up = first[Z][2] + Interval::point(gravity);
    let thrust = (square(X, 2) + square(Y, 2) + up.square()).sqrt();
    let rate = (square(X, 3) + square(Y, 3)).sqrt() / thrust;
    let angle = rate.square() / Interval::point(2.0 * STOPS_TURNING);
    (angle * thrust / Interval::point(gravity)).high
}
