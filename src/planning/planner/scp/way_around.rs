//! Ways around the volumes that a mission keeps out of: a coarse search, about which the initial guess is linearised.
//!
//! On each leg that enters a volume, the shortest path on a lattice of positions that keep every bound on positions is
//! searched for (A*: Hart, Nilsson and Raphael, 1968). It chooses on which sides the motion passes the volumes; the
//! steps that follow take the separating planes anew and keep these sides as far as that pays. Other ways are the
//! shortest ones on which the sides of the ways before are closed: `sides` chooses among them.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner};
use crate::body::BoundingBox;
use crate::model::Limit;
use crate::model::{LimitKind, Mission};
use crate::motion::time_grid::TimeGrid;
use crate::motion::{NodeState, X, Y, Z};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A position, m.
type Point = [f64; 3];

/// Cells of the lattice along its longest side, and at most in all. Chosen by hand.
const CELLS: f64 = 48.0;

/// How far the lattice reaches beyond the leg and the volumes near it, as a share of the leg's length. Chosen by hand.
const BEYOND: f64 = 0.3;

/// Violations of bounds on positions below this count as none, m.
const TOUCHING: f64 = 1e-3;

impl ScpPlanner<'_, '_> {
    /// The position at each instant, m; `None` if the mission keeps out of no volume.
    pub(super) fn positions(&self, iterate: &Iterate) -> Option<Vec<Point>> {
        keeps_out(self.problem().mission()).then(|| {
            let instants = iterate.grid.intervals() * PARTS + 1;
            (0..instants).map(|instant| position(&iterate.at(instant))).collect()
        })
    }

    /// A position for each instant that keeps out of the volumes, near those of an iterate that enters one; `None` if
    /// it enters none or if no way around was found.
    pub(super) fn way_around(&self, iterate: &Iterate) -> Option<Vec<Point>> {
        let mission = self.problem().mission();
        let mut positions = self.positions(iterate)?;
        let mut is_changed = false;
        for (leg, segment) in iterate.grid.segments.iter().enumerate() {
            let ends = segment.first_node * PARTS..=(segment.first_node + segment.intervals) * PARTS;
            let limits = limits_on(mission, segment.from);
            if positions[ends.clone()].iter().all(|p| is_free(&limits, p)) {
                continue;
            }
            let nth = self.sides.get(&leg).copied().unwrap_or(0);
            let way = nth_way(&limits, positions[*ends.start()], positions[*ends.end()], nth)?;
            let along = shares_of_length(&positions[ends.clone()]);
            for (p, share) in positions[ends].iter_mut().zip(along) {
                *p = at_share(&way, share);
            }
            is_changed = true;
        }
        is_changed.then_some(positions)
    }

    /// A position for each instant of a grid on a short way from one place to another around the volumes that hold on
    /// all legs, at shares of its length as of time; `None` where no volume is in the way, or none was found.
    pub(super) fn way_between(&self, grid: &TimeGrid, from: Point, to: Point) -> Option<Vec<Point>> {
        let mission = self.problem().mission();
        let limits: Vec<&Limit> = mission.limits.iter().filter(|limit| limit.is_general()).collect();
        if !keeps_out(mission) || obstructed(&limits, from, to).is_none() {
            return None;
        }
        let way = nth_way(&limits, from, to, 0)?;
        let times = &grid.node_times;
        let at = |instant: usize| {
            let (interval, part) = (instant / PARTS, (instant % PARTS) as f64 / PARTS as f64);
            let next = times.get(interval + 1).unwrap_or(&times[interval]);
            at_share(&way, (times[interval] + part * (next - times[interval])) / grid.total)
        };
        Some((0..=grid.intervals() * PARTS).map(at).collect())
    }
}

fn keeps_out(mission: &Mission) -> bool {
    mission.limits.iter().any(|limit| limit.kind.is_clearance())
}

/// The limits that hold on a leg.
fn limits_on(mission: &Mission, leg: usize) -> Vec<&Limit> {
    mission.limits.iter().filter(|limit| limit.concerns(leg)).collect()
}

fn position(state: &NodeState) -> Point {
    [state[X][0], state[Y][0], state[Z][0]]
}

/// Whether no bound on positions is violated.
fn is_free(limits: &[&Limit], p: &Point) -> bool {
    let is_kept = |limit: &&Limit| {
        limit.is_violated_by_less(*p, TOUCHING) || limit.violation_at(*p).is_none_or(|violation| violation <= TOUCHING)
    };
    limits.iter().all(is_kept)
}

fn distance(a: &Point, b: &Point) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// The share of the whole length at each of some points of a path.
fn shares_of_length(points: &[Point]) -> Vec<f64> {
    let mut lengths = vec![0.0];
    points.windows(2).for_each(|pair| lengths.push(lengths[lengths.len() - 1] + distance(&pair[0], &pair[1])));
    let whole = lengths[lengths.len() - 1];
    let last = (points.len() - 1).max(1) as f64;
    lengths.iter().enumerate().map(|(i, l)| if whole > 0.0 { l / whole } else { i as f64 / last }).collect()
}

/// The point at a share of the length of a path.
fn at_share(way: &[Point], share: f64) -> Point {
    let shares = shares_of_length(way);
    let after = shares.partition_point(|s| *s < share).clamp(1, way.len() - 1);
    let (a, b) = (shares[after - 1], shares[after]);
    let t = if b > a { ((share - a) / (b - a)).clamp(0.0, 1.0) } else { 0.0 };
    std::array::from_fn(|i| way[after - 1][i] + t * (way[after][i] - way[after - 1][i]))
}

/// A cell of a lattice and the estimated length of a path through it, for the queue of A*.
#[derive(Clone, Copy, PartialEq)]
struct Open {
    estimate: f64,
    cell: usize,
}

impl Eq for Open {}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.estimate.total_cmp(&other.estimate).then(self.cell.cmp(&other.cell))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

/// A short path from one point to another on which no bound on positions is violated, with its corners cut: the
/// shortest, or the `nth` of several ways, counted from 0, each the shortest that does not pass on a side on which one
/// before it passes.
pub(super) fn nth_way(limits: &[&Limit], from: Point, to: Point, nth: usize) -> Option<Vec<Point>> {
    let lattice = Lattice::around(limits, from, to);
    let mut taken: Vec<Side> = Vec::new();
    loop {
        let is_free = |p: &Point| is_free(limits, p) && !taken.iter().any(|side| side.contains(p));
        let way = shortened(&lattice.search(is_free, from, to)?, is_free, lattice.step);
        if taken.len() == nth {
            return Some(way);
        }
        taken.push(Side::of(limits, &way, from, to)?);
    }
}

/// The cosine of half the angle, seen along the straight leg, that a way closes to those after it: 50 degrees.
/// Chosen by hand.
const HALF_ANGLE: f64 = 0.64;

/// Points of a straight leg at which it is looked for obstacles. Chosen by hand.
const POINTS: usize = 200;

/// Where the straight leg violates bounds: the shares of its length at which that begins and ends; `None` if it never
/// does.
pub(super) fn obstructed(limits: &[&Limit], from: Point, to: Point) -> Option<(f64, f64)> {
    let point = |share: f64| std::array::from_fn(|i| from[i] + share * (to[i] - from[i]));
    let shares = (0..=POINTS).map(|k| k as f64 / POINTS as f64);
    let blocked: Vec<f64> = shares.filter(|&share| !is_free(limits, &point(share))).collect();
    Some((*blocked.first()?, *blocked.last()?))
}

/// The side of the obstacles of a leg on which a way passes them: positions beside the obstructed part of the straight
/// leg in about the direction in which the way is farthest from it.
struct Side {
    from: Point,
    /// Unit vector along the leg, and across it towards this side.
    along: Point,
    across: Point,
    /// Where the straight leg is obstructed, m from its start.
    part: (f64, f64),
}

impl Side {
    fn of(limits: &[&Limit], way: &[Point], from: Point, to: Point) -> Option<Self> {
        let length = distance(&from, &to);
        let (begin, end) = obstructed(limits, from, to)?;
        let along = std::array::from_fn(|i| (to[i] - from[i]) / length);
        let mut side = Side { from, along, across: [0.0; 3], part: (begin * length, end * length) };
        let far = way.iter().map(|p| side.beside(p).1).max_by(|a, b| norm(a).total_cmp(&norm(b)))?;
        let most = norm(&far);
        side.across = far.map(|x| x / most);
        (most > 0.0).then_some(side)
    }

    /// How far along the leg a position lies, m, and its offset from the straight leg.
    fn beside(&self, p: &Point) -> (f64, Point) {
        let from: Point = std::array::from_fn(|i| p[i] - self.from[i]);
        let along: f64 = (0..3).map(|i| from[i] * self.along[i]).sum();
        (along, std::array::from_fn(|i| from[i] - along * self.along[i]))
    }

    fn contains(&self, p: &Point) -> bool {
        let (along, offset) = self.beside(p);
        let across: f64 = (0..3).map(|i| offset[i] * self.across[i]).sum();
        self.part.0 <= along && along <= self.part.1 && across > HALF_ANGLE * norm(&offset)
    }
}

fn norm(v: &Point) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

struct Lattice {
    low: Point,
    /// Length of a cell, m.
    step: f64,
    counts: [usize; 3],
}

impl Lattice {
    /// A lattice over the leg and the volumes near it.
    fn around(limits: &[&Limit], from: Point, to: Point) -> Self {
        let beyond = BEYOND * distance(&from, &to);
        let mut low: Point = std::array::from_fn(|i| from[i].min(to[i]) - beyond);
        let mut high: Point = std::array::from_fn(|i| from[i].max(to[i]) + beyond);
        // A way around a volume leads along its sides: the lattice contains those that it meets, as far as they are
        // finite.
        for limit in limits {
            let LimitKind::Clearance(obstacle) = &limit.kind else { continue };
            let BoundingBox { low: bottom, high: top } = obstacle.around;
            let margin = limit.lower.unwrap_or(0.0) + beyond;
            if (0..3).all(|i| bottom[i] - margin <= high[i] && low[i] <= top[i] + margin) {
                for i in 0..3 {
                    if bottom[i].is_finite() && top[i].is_finite() {
                        low[i] = low[i].min(bottom[i] - margin);
                        high[i] = high[i].max(top[i] + margin);
                    }
                }
            }
        }
        let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let step = (longest / CELLS).max(f64::MIN_POSITIVE);
        Lattice { low, step, counts: std::array::from_fn(|i| ((high[i] - low[i]) / step).ceil() as usize + 1) }
    }

    fn point(&self, cell: usize) -> Point {
        let at = self.indices(cell);
        std::array::from_fn(|i| self.low[i] + self.step * at[i] as f64)
    }

    fn indices(&self, cell: usize) -> [usize; 3] {
        let [nx, ny, _] = self.counts;
        [cell % nx, cell / nx % ny, cell / nx / ny]
    }

    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.counts[0] * (y + self.counts[1] * z)
    }

    /// The neighbours of a cell, in the 26 directions.
    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> + '_ {
        let at = self.indices(cell);
        (0..27usize).filter(|code| *code != 13).filter_map(move |code| {
            let by = [code % 3, code / 3 % 3, code / 9];
            let mut to = [0; 3];
            for i in 0..3 {
                to[i] = (at[i] + by[i]).checked_sub(1).filter(|&k| k < self.counts[i])?;
            }
            Some(self.cell(to))
        })
    }

    /// The cell nearest to a point among those that are free.
    fn nearest(&self, is_free: &impl Fn(&Point) -> bool, p: &Point) -> Option<usize> {
        let all = 0..self.counts.iter().product();
        let free = all.filter(|&cell| distance(&self.point(cell), p) <= 4.0 * self.step && is_free(&self.point(cell)));
        free.min_by(|&a, &b| distance(&self.point(a), p).total_cmp(&distance(&self.point(b), p)))
    }

    fn search(&self, is_free: impl Fn(&Point) -> bool, from: Point, to: Point) -> Option<Vec<Point>> {
        let (start, goal) = (self.nearest(&is_free, &from)?, self.nearest(&is_free, &to)?);
        let cells = self.counts.iter().product();
        let mut lengths = vec![f64::INFINITY; cells];
        let mut before = vec![usize::MAX; cells];
        let mut queue = BinaryHeap::new();
        let left = |cell: usize| distance(&self.point(cell), &self.point(goal));
        lengths[start] = 0.0;
        queue.push(Reverse(Open { estimate: left(start), cell: start }));
        while let Some(Reverse(Open { estimate, cell })) = queue.pop() {
            if cell == goal {
                break;
            }
            if estimate > lengths[cell] + left(cell) {
                continue;
            }
            for next in self.neighbours(cell) {
                let length = lengths[cell] + distance(&self.point(cell), &self.point(next));
                if length >= lengths[next] {
                    continue;
                }
                // A cell that is not free is looked at once, not from each of its 26 neighbours.
                if !is_free(&self.point(next)) {
                    lengths[next] = f64::NEG_INFINITY;
                    continue;
                }
                (lengths[next], before[next]) = (length, cell);
                queue.push(Reverse(Open { estimate: length + left(next), cell: next }));
            }
        }
        if lengths[goal].is_infinite() {
            return None;
        }
        let mut way = vec![to];
        let mut cell = goal;
        while cell != usize::MAX {
            way.push(self.point(cell));
            cell = before[cell];
        }
        way.push(from);
        way.reverse();
        Some(way)
    }
}

/// The path without the points that a straight line passes freely.
fn shortened(way: &[Point], is_free: impl Fn(&Point) -> bool, step: f64) -> Vec<Point> {
    let is_clear = |a: &Point, b: &Point| {
        let parts = (2.0 * distance(a, b) / step).ceil().max(1.0);
        (1..parts as usize).all(|k| {
            let t = k as f64 / parts;
            is_free(&std::array::from_fn(|i| a[i] + t * (b[i] - a[i])))
        })
    };
    let mut kept = vec![way[0]];
    let mut at = 0;
    while at + 1 < way.len() {
        let next = (at + 1..way.len()).rev().find(|&k| k == at + 1 || is_clear(&way[at], &way[k]));
        at = next.unwrap_or(at + 1);
        kept.push(way[at]);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    #[test]
    fn cells_that_are_not_free_are_looked_at_once() {
        let (from, to) = ([0.0; 3], [10.0, 0.0, 0.0]);
        let lattice = Lattice::around(&[], from, to);
        let blocked = RefCell::new(Vec::new());
        let is_free = |p: &Point| {
            let is_free = norm(&[p[0] - 5.0, p[1], p[2]]) > 2.0;
            if !is_free {
                blocked.borrow_mut().push(p.map(f64::to_bits));
            }
            is_free
        };
        assert!(lattice.search(is_free, from, to).is_some());
        let mut blocked = blocked.into_inner();
        let looked_at = blocked.len();
        blocked.sort_unstable();
        blocked.dedup();
        assert!(looked_at > 100 && looked_at == blocked.len(), "{looked_at} of {} cells", blocked.len());
    }
}
