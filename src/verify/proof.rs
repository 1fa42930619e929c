//! What holds at nodes, on a grid, at every instant: bounds on quantities along a motion.

use super::interval::{Interval, exceeds};
use super::motion::{Motion, State};
use crate::certificate::{Bound, Scope};
use crate::report::number::number;

/// A quantity and its rate of change, at an instant or over a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rated {
    pub value: Interval,
    pub rate: Interval,
}

/// The quantities asked for, in order.
pub type Evaluate<'a> = Box<dyn Fn(&State, &[usize]) -> Vec<Rated> + 'a>;

/// Some quantities that one bound is about: limits have one or two sides, sets a plane for each.
pub struct Family<'a> {
    pub members: usize,
    pub evaluate: Evaluate<'a>,
    /// All are linear in time over each piece, so that its ends bound what lies between.
    pub linear: bool,
    /// They may jump where two pieces meet, so that each node is looked at from both.
    pub jumps: bool,
    pub measure: Measure,
}

/// How messages say by how much a bound is passed or kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// Of the unit in that of the records.
    pub factor: f64,
    pub unit: &'static str,
    /// What a share is one of.
    pub whole: Option<&'static str>,
}

impl Measure {
    /// What excesses over planes are measured in.
    pub const WIDTH: Measure = Measure { factor: 100.0, unit: "%", whole: Some("of the healthy set's width") };

    /// A number with its unit.
    pub fn of(self, x: f64) -> String {
        format!("{} {}", number(x * self.factor), self.unit)
    }

    /// What an excess says of a bound.
    pub fn kept_or_passed(self, excess: f64) -> String {
        match excess > 0.0 {
            true => format!("passed by {}", self.of(excess)),
            false => format!("kept with {} to spare", self.of(-excess)),
        }
    }
}

/// Why a bound does not stand.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    pub member: usize,
    /// s
    pub at: f64,
    /// What the quantity is at most there.
    pub excess: f64,
    /// It is false; otherwise it could not be proved.
    pub refuted: bool,
}

/// Points of a grid in one piece.
pub const MAX_GRID: usize = 1_000;

/// Halvings of one piece.
const DEEPEST: u32 = 24;

/// Evaluations of single quantities left to one certificate.
#[derive(Debug, Clone, Copy)]
pub struct Budget(pub usize);

impl Budget {
    fn spend(&mut self, much: usize) -> bool {
        self.0 = self.0.saturating_sub(much + 1);
        self.0 > 0
    }
}

/// Shows that every member stays at or below the bound, or says where it does not.
pub fn holds(family: &Family, motion: &Motion, bound: &Bound, budget: &mut Budget) -> Result<(), Failure> {
    let everything: Vec<usize> = (0..family.members).collect();
    (0..motion.pieces()).try_for_each(|piece| over_piece(family, motion, piece, &everything, bound, budget))
}

/// The members that are shown to stay at or below the bound, in order; none once the budget is spent.
pub fn kept(family: &Family, motion: &Motion, bound: &Bound, budget: &mut Budget) -> Vec<usize> {
    let mut members: Vec<usize> = (0..family.members).collect();
    for piece in 0..motion.pieces() {
        while let Err(failure) = over_piece(family, motion, piece, &members, bound, budget) {
            members.retain(|&member| member != failure.member);
        }
    }
    members
}

/// Shows it over one piece of the motion.
fn over_piece(
    family: &Family,
    motion: &Motion,
    piece: usize,
    members: &[usize],
    bound: &Bound,
    budget: &mut Budget,
) -> Result<(), Failure> {
    // What is linear and does not jump does not depend on the piece that a node is seen from.
    let once = family.linear && !family.jumps && piece + 1 < motion.pieces();
    for node in piece..=piece + usize::from(!once) {
        at_instant(family, &motion.node_in(node, piece), motion.times[node], members, bound.excess, budget)?;
    }
    let whole = motion.duration(piece);
    match bound.scope {
        Scope::Nodes => Ok(()),
        Scope::Grid(points) => (1..=points.min(MAX_GRID)).try_for_each(|i| {
            let share = Interval::point(i as f64) / Interval::point((points + 1) as f64);
            let at = share * whole;
            let state = motion.over(piece, at);
            at_instant(family, &state, motion.times[piece] + at.middle(), members, bound.excess, budget)
        }),
        Scope::EveryInstant if family.linear => Ok(()),
        Scope::EveryInstant => {
            let stretch = Interval::new(0.0, whole.high);
            throughout(family, motion, piece, stretch, members, bound.excess, DEEPEST, budget)
        }
    }
}

fn at_instant(
    family: &Family,
    state: &State,
    at: f64,
    members: &[usize],
    most: f64,
    budget: &mut Budget,
) -> Result<(), Failure> {
    let enough = budget.spend(members.len());
    for (&member, found) in members.iter().zip(&(family.evaluate)(state, members)) {
        if !enough || exceeds(found.value.high, most) {
            return Err(Failure { member, at, excess: found.value.high, refuted: found.value.low > most });
        }
    }
    Ok(())
}

/// Halves a stretch of a piece until the mean value form keeps every member below: f(t) lies in f(m) + f'(T)(T - m).
#[allow(clippy::too_many_arguments)]
fn throughout(
    family: &Family,
    motion: &Motion,
    piece: usize,
    stretch: Interval,
    members: &[usize],
    most: f64,
    deeper: u32,
    budget: &mut Budget,
) -> Result<(), Failure> {
    let middle = Interval::point(stretch.middle());
    let at_middle = (family.evaluate)(&motion.over(piece, middle), members);
    let over = (family.evaluate)(&motion.over(piece, stretch), members);
    let away = stretch - middle;
    let at = motion.times[piece] + middle.low;
    let enough = budget.spend(2 * members.len());
    let mut left = Vec::new();
    for ((&member, there), all) in members.iter().zip(&at_middle).zip(&over) {
        let value = (there.value + all.rate * away).meet(all.value);
        if !exceeds(value.high, most) {
            continue;
        }
        let refuted = there.value.low > most;
        if refuted || deeper == 0 || !enough {
            return Err(Failure { member, at, excess: there.value.high, refuted });
        }
        left.push(member);
    }
    if left.is_empty() {
        return Ok(());
    }
    for half in [Interval::new(stretch.low, middle.low), Interval::new(middle.low, stretch.high)] {
        throughout(family, motion, piece, half, &left, most, deeper - 1, budget)?;
    }
    Ok(())
}
