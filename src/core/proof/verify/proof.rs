//! Bounds on quantities along a motion: at nodes, on a grid, at every instant.

use super::cost::WorkLeft;
use super::interval::{Interval, exceeds};
use super::motion::{Motion, State};
use crate::number::{number, up};
use std::ops::Range;

/// A quantity and its rate of change, at an instant or over a time interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rated {
    pub value: Interval,
    pub rate: Interval,
}

/// Evaluates the members with the given indices, in order.
pub type Evaluate<'a> = Box<dyn Fn(&State, &[usize]) -> Vec<Rated> + 'a>;

/// Quantities with the same bound: the one or two sides of a limit, the planes of sets.
pub struct Family<'a> {
    pub members: usize,
    pub evaluate: Evaluate<'a>,
    /// All are linear in time over each piece, so that its ends bound what lies between.
    pub linear: bool,
    /// They may jump where two pieces meet, so each node is checked from both sides.
    pub jumps: bool,
    /// The first and the last node of the part of the motion on which they are bounded, which may be one node; `None`
    /// for the whole motion.
    pub within: Option<(usize, usize)>,
    /// They are bounded at nodes only, not at points that stand for those of finer pieces.
    pub at_nodes_only: bool,
    pub measure: Measure,
    /// Units of work for a state, in addition to those of its members.
    pub overhead: u64,
    /// Units of work for each member at a state.
    pub of_a_member: u64,
}

/// How messages print a violation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// Conversion from the unit of the records to `unit`.
    pub factor: f64,
    pub unit: &'static str,
    /// The reference of a share, for example `of gravity`.
    pub whole: Option<&'static str>,
}

impl Measure {
    /// The measure of violations of planes.
    pub const WIDTH: Measure = Measure { factor: 100.0, unit: "%", whole: Some("of the healthy set's width") };

    /// A number with its unit.
    pub fn of(self, x: f64) -> String {
        format!("{} {}", number(x * self.factor), self.unit)
    }

    /// An upper bound of a number, with its unit.
    pub fn at_most(self, x: f64) -> String {
        format!("{} {}", up(x * self.factor, 6), self.unit)
    }
}

/// Where and by how much a bound is violated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Failure {
    pub member: usize,
    /// s
    pub at: f64,
    /// Upper bound of the quantity there.
    pub violation: f64,
}

/// Most bisections of one piece.
const DEEPEST: u32 = 24;

impl<'a> Family<'a> {
    /// Some members alone, in the given order.
    pub fn only(self, members: &[usize]) -> Family<'a> {
        let (members, evaluate) = (members.to_vec(), self.evaluate);
        let count = members.len();
        let of_these = move |state: &State, wanted: &[usize]| {
            let wanted: Vec<usize> = wanted.iter().filter_map(|&i| members.get(i).copied()).collect();
            evaluate(state, &wanted)
        };
        Family { members: count, evaluate: Box::new(of_these), ..self }
    }
}

impl Family<'_> {
    fn units(&self, members: usize) -> u64 {
        self.overhead.saturating_add(self.of_a_member.saturating_mul(members as u64))
    }

    fn everything(&self) -> Vec<usize> {
        (0..self.members).collect()
    }

    /// The pieces on which they are bounded; none if that is at one node.
    fn pieces(&self, motion: &Motion) -> Range<usize> {
        self.within.map_or(0..motion.pieces(), |(first, last)| first..last)
    }

    /// The node at which they are bounded, with the piece that ends there, if that is at one node.
    fn only_node(&self) -> Option<(usize, usize)> {
        self.within.filter(|(first, last)| first == last).map(|(node, _)| (node, node.saturating_sub(1)))
    }
}

/// The largest value of any member at the nodes and the extra points given by the spec's samples, if it is above
/// `most`.
pub fn above_at_nodes(family: &Family, motion: &Motion, most: f64) -> Option<Failure> {
    let members = family.everything();
    let mut worst: Option<Failure> = None;
    at_each_state(family, motion, |state, at| keep_worst(&mut worst, above(family, &members, state, at, most)));
    worst
}

/// For each member whether it is above `most` there.
pub fn each_above_at_nodes(family: &Family, motion: &Motion, most: f64) -> Vec<bool> {
    let members = family.everything();
    let mut is_above = vec![false; family.members];
    at_each_state(family, motion, |state, _| {
        for (found, is_above) in (family.evaluate)(state, &members).iter().zip(&mut is_above) {
            *is_above |= exceeds(found.value.high, most);
        }
    });
    is_above
}

/// Calls `look` with the states at which bounds are decided, and their instants.
fn at_each_state(family: &Family, motion: &Motion, mut look: impl FnMut(&State, f64)) {
    if let Some((node, piece)) = family.only_node() {
        return look(&motion.node_in(node, piece), motion.times[node]);
    }
    let pieces = family.pieces(motion);
    for piece in pieces.clone() {
        // A quantity that does not jump has the same value in both pieces.
        let ends = if family.jumps || piece + 1 == pieces.end { piece..=piece + 1 } else { piece..=piece };
        for node in ends {
            look(&motion.node_in(node, piece), motion.times[node]);
        }
        if family.at_nodes_only {
            continue;
        }
        for at in motion.extra_instants(piece) {
            look(&motion.over(piece, at), motion.times[piece] + at.middle());
        }
    }
}

/// The larger of two.
pub fn worse(a: Option<Failure>, b: Option<Failure>) -> Option<Failure> {
    let mut worst = a;
    keep_worst(&mut worst, b);
    worst
}

/// The largest value of any of `members` on a grid of `points` between the ends of every piece, and at them.
pub fn largest_on_grid(family: &Family, motion: &Motion, members: &[usize], points: usize) -> Option<Failure> {
    let mut worst: Option<Failure> = None;
    if let Some((node, piece)) = family.only_node() {
        return above(family, members, &motion.node_in(node, piece), motion.times[node], f64::NEG_INFINITY);
    }
    for piece in family.pieces(motion) {
        for node in [piece, piece + 1] {
            let state = motion.node_in(node, piece);
            keep_worst(&mut worst, above(family, members, &state, motion.times[node], f64::NEG_INFINITY));
        }
        for at in motion.grid(piece, points) {
            let state = motion.over(piece, at);
            let when = motion.times[piece] + at.middle();
            keep_worst(&mut worst, above(family, members, &state, when, f64::NEG_INFINITY));
        }
    }
    worst
}

/// Units of work of [`above_at_nodes`].
pub fn cost_at_nodes(family: &Family, motion: &Motion) -> u64 {
    let states = match family.only_node() {
        Some(_) => 1,
        None => {
            let pieces = family.pieces(motion);
            let ends = if family.jumps { 2 * pieces.len() } else { pieces.len() + 1 };
            let inside = if family.at_nodes_only { 0 } else { motion.extra_points_in(pieces) };
            inside.saturating_add(ends as u64)
        }
    };
    states.saturating_mul(family.units(family.members))
}

/// Units of work of [`largest_on_grid`].
pub fn cost_of_grid(family: &Family, motion: &Motion, members: usize, points: usize) -> u64 {
    (family.pieces(motion).len().max(1) as u64).saturating_mul(points as u64 + 2).saturating_mul(family.units(members))
}

fn keep_worst(worst: &mut Option<Failure>, found: Option<Failure>) {
    if let Some(found) = found.filter(|f| worst.is_none_or(|w| exceeds(f.violation, w.violation))) {
        *worst = Some(found);
    }
}

/// The largest of the members at a state that is above `most`.
fn above(family: &Family, members: &[usize], state: &State, at: f64, most: f64) -> Option<Failure> {
    let mut worst: Option<Failure> = None;
    for (&member, found) in members.iter().zip(&(family.evaluate)(state, members)) {
        if exceeds(found.value.high, most) {
            keep_worst(&mut worst, Some(Failure { member, at, violation: found.value.high }));
        }
    }
    worst
}

/// What is shown of a bound at every instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Throughout {
    /// For each member whether it is proved to stay at or below the bound. One for which the remaining work does not
    /// suffice is not proved.
    pub proved: Vec<bool>,
    /// Where members are surely above the bound between the nodes, at most one instant of each.
    pub refuted: Vec<Failure>,
}

impl Throughout {
    /// Whether every member is proved.
    pub fn is_proved(&self) -> bool {
        self.proved.iter().all(|&proved| proved)
    }
}

/// Whether the members stay at or below `most` at every instant.
pub fn throughout(family: &Family, motion: &Motion, most: f64, purse: &mut WorkLeft) -> Throughout {
    let found = Throughout { proved: vec![true; family.members], refuted: Vec::new() };
    let mut proof = Proof { family, motion, most, found, purse };
    if let Some((node, piece)) = family.only_node() {
        let members = proof.open();
        proof.at_nodes([node], piece, &members);
    }
    for piece in family.pieces(motion) {
        let members = proof.open();
        if members.is_empty() {
            break;
        }
        proof.at_nodes([piece, piece + 1], piece, &members);
        if !family.linear {
            let whole = Interval::new(0.0, motion.duration(piece).high);
            let members = proof.open();
            proof.over(piece, whole, members, DEEPEST);
        }
    }
    proof.found
}

struct Proof<'p> {
    family: &'p Family<'p>,
    motion: &'p Motion,
    most: f64,
    found: Throughout,
    purse: &'p mut WorkLeft,
}

impl Proof<'_> {
    /// The members that are not yet given up.
    fn open(&self) -> Vec<usize> {
        (0..self.family.members).filter(|&member| self.found.proved[member]).collect()
    }

    fn give_up(&mut self, members: &[usize]) {
        members.iter().for_each(|&member| self.found.proved[member] = false);
    }

    fn at_nodes(&mut self, nodes: impl IntoIterator<Item = usize>, piece: usize, members: &[usize]) {
        for node in nodes {
            if !self.purse.spend(self.family.units(members.len())) {
                return self.give_up(members);
            }
            let found = (self.family.evaluate)(&self.motion.node_in(node, piece), members);
            for (&member, found) in members.iter().zip(&found) {
                if exceeds(found.value.high, self.most) {
                    self.found.proved[member] = false;
                }
            }
        }
    }

    /// Bisects a part of a piece until the mean value form bounds every member: f(t) lies in f(m) + f'(T)(T - m).
    fn over(&mut self, piece: usize, part: Interval, mut members: Vec<usize>, deeper: u32) {
        members.retain(|&member| self.found.proved[member]);
        if members.is_empty() {
            return;
        }
        if !self.purse.spend(self.family.units(members.len()).saturating_mul(2)) {
            return self.give_up(&members);
        }
        let middle = Interval::point(part.middle());
        let at_middle = (self.family.evaluate)(&self.motion.over(piece, middle), &members);
        let over = (self.family.evaluate)(&self.motion.over(piece, part), &members);
        let away = part - middle;
        let mut left = Vec::with_capacity(members.len());
        for ((&member, there), all) in members.iter().zip(&at_middle).zip(&over) {
            let value = (there.value + all.rate * away).meet(all.value);
            if !exceeds(value.high, self.most) {
                continue;
            }
            let is_refuted = there.value.low > self.most;
            if is_refuted {
                let at = self.motion.times[piece] + middle.low;
                self.found.refuted.push(Failure { member, at, violation: there.value.high });
            }
            match is_refuted || deeper == 0 {
                true => self.found.proved[member] = false,
                false => left.push(member),
            }
        }
        // The recursion would keep one copy of these for each of its depths.
        drop((members, at_middle, over));
        for half in [Interval::new(part.low, middle.low), Interval::new(middle.low, part.high)] {
            self.over(piece, half, left.clone(), deeper.saturating_sub(1));
        }
    }
}
