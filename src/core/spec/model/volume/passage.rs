//! Whether volumes close off a waypoint from the next one.
//!
//! Space is divided into boxes by planes across the axes. A box is closed if one bound on positions is violated, by
//! more than the checker allows, at each of its points: a convex quantity that is too small at the eight corners is too
//! small in between, and a linear one that is too large at the corners is too large in between. A path that keeps all
//! bounds passes only through open boxes. Where it passes an edge or a corner, all boxes about it are open, so a path
//! between two boxes joins them by common faces of open boxes. If there is no such chain from one waypoint to the next,
//! no path exists; what lies beyond the boxes counts as open where no bound excludes it. The converse does not hold:
//! small gaps are not found closed.

use super::reach::Reach;
use super::{Side, Volume};
use crate::body::Body;
use crate::model::{Limit, LimitKind, Waypoint};
use crate::source::Span;
use crate::tolerance::MOST_PAST_LIMIT;
use std::ops::Range;

/// Parts of the longest axis, tried in turn until the work is small enough.
const PARTS: [usize; 3] = [32, 16, 8];

/// Most planes of an axis that follow the volumes' own sides.
const MOST_OWN: usize = 40;

/// Most evaluations of an edge's distance: a tenth of a second.
const MOST_WORK: f64 = 2e7;

/// By how much a bound is violated in a closed box at least, in addition to twice what the checker allows, m.
const SLACK: f64 = 1e-3;

/// A leg that no path flies.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedOff {
    /// Index of the waypoint that cannot be reached from the one before.
    pub waypoint: usize,
    /// Statements that together close it off: a limit of each.
    pub by: Vec<usize>,
}

/// The first waypoint that is closed off from the one before by bounds on positions; `None` where none is found to be.
pub fn closed_off(limits: &[Limit], volumes: &[Volume], waypoints: &[Waypoint]) -> Option<ClosedOff> {
    let bounds: Vec<usize> =
        (0..limits.len()).filter(|&i| limits[i].is_general() && limits[i].value_at([0.0; 3]).is_some()).collect();
    let keeps_out = |i: usize| limits[i].kind.is_clearance();
    let (bodies, convex): (Vec<usize>, Vec<usize>) = bounds.iter().partition(|&&i| keeps_out(i));
    // Without a volume to keep out of, the bounds are convex.
    bodies.first()?;
    let bodies: Vec<(&Limit, Option<Reach>)> = bodies.iter().map(|&i| (&limits[i], Reach::of(&limits[i]))).collect();
    let keeps_convex = |waypoint: &Waypoint| convex.iter().all(|&i| is_kept(&limits[i], waypoint.position));
    let kept: Vec<bool> = waypoints.iter().map(keeps_convex).collect();
    // A line between two points that keep convex bounds keeps them.
    let is_free = |to: usize| kept[to - 1] && kept[to] && is_straight_free(&bodies, &waypoints[to - 1..=to]);
    let obstructed: Vec<usize> = (1..waypoints.len()).filter(|&to| !is_free(to)).collect();
    if obstructed.is_empty() {
        return None;
    }
    let boxes = PARTS.iter().find_map(|&parts| Boxes::new(limits, &bounds, volumes, waypoints, parts))?;
    let mut closed = vec![0_u16; boxes.count()];
    let statements = statements(limits, &bounds);
    for statement in &statements {
        boxes.closed_by(limits, statement).into_iter().for_each(|cell| closed[cell] += 1);
    }
    let parts = boxes.connected(&closed, &[]);
    let to = obstructed.into_iter().find(|&to| boxes.separates(&parts, &waypoints[to - 1..=to]))?;
    // What is closed off without a statement too does not need it.
    let (mut by, mut without) = (Vec::new(), Vec::new());
    for statement in &statements {
        let own = boxes.closed_by(limits, statement);
        own.iter().for_each(|&cell| closed[cell] -= 1);
        without.push(limits[statement[0]].span);
        if !boxes.separates(&boxes.connected(&closed, &without), &waypoints[to - 1..=to]) {
            own.iter().for_each(|&cell| closed[cell] += 1);
            without.pop();
            by.push(statement[0]);
        }
    }
    Some(ClosedOff { waypoint: to, by })
}

/// Whether the straight line between two waypoints keeps clear of every body, as far as some points of it show.
pub fn is_open(limits: &[Limit], ends: &[Waypoint]) -> bool {
    let bodies = limits.iter().filter(|limit| limit.kind.is_clearance());
    let bodies: Vec<(&Limit, Option<Reach>)> = bodies.map(|limit| (limit, Reach::of(limit))).collect();
    is_straight_free(&bodies, ends)
}

/// The bounds of each statement: those of one volume belong together.
fn statements(limits: &[Limit], bounds: &[usize]) -> Vec<Vec<usize>> {
    let mut found: Vec<(Span, Vec<usize>)> = Vec::new();
    for &i in bounds {
        match found.iter_mut().find(|(span, _)| *span == limits[i].span) {
            Some((_, own)) => own.push(i),
            None => found.push((limits[i].span, vec![i])),
        }
    }
    found.into_iter().map(|(_, own)| own).collect()
}

/// Points of a leg's straight line that are looked at: this decides only whether to look closer.
const POINTS: usize = 200;

fn is_straight_free(bodies: &[(&Limit, Option<Reach>)], ends: &[Waypoint]) -> bool {
    let (a, b) = (ends[0].position, ends[1].position);
    bodies.iter().filter(|(_, reach)| reach.is_none_or(|reach| reach.meets([a, b]))).all(|(limit, reach)| {
        (0..=POINTS).all(|k| {
            let p = std::array::from_fn(|i| a[i] + (b[i] - a[i]) * k as f64 / POINTS as f64);
            reach.is_some_and(|reach| !reach.contains(p)) || is_kept(limit, p)
        })
    })
}

/// Whether a position keeps a limit; limits on other quantities say nothing of it.
fn is_kept(limit: &Limit, p: [f64; 3]) -> bool {
    limit.violation_at(p).is_none_or(|violation| violation <= 0.0)
}

/// Boxes between planes across the axes.
struct Boxes {
    /// Where the planes of each axis are, m, ascending.
    planes: [Vec<f64>; 3],
    /// The statement that excludes what lies below the lowest plane of an axis, and above the highest.
    excluded: [[Option<Span>; 2]; 3],
}

/// By how much a limit is violated at least where no checked path passes, m.
pub fn slack(limit: &Limit) -> f64 {
    SLACK + 2.0 * MOST_PAST_LIMIT * limit.size()
}

fn body(limit: &Limit) -> Option<&Body> {
    match &limit.kind {
        LimitKind::Clearance(obstacle) => Some(&obstacle.body),
        _ => None,
    }
}

impl Boxes {
    /// `None` if they would be too many.
    fn new(
        limits: &[Limit],
        bounds: &[usize],
        volumes: &[Volume],
        waypoints: &[Waypoint],
        parts: usize,
    ) -> Option<Self> {
        let mut planes: [Vec<f64>; 3] = Default::default();
        let mut excluded = [[None; 2]; 3];
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut own: [Vec<f64>; 3] = Default::default();
        let mut outer = [[f64::NEG_INFINITY, f64::INFINITY]; 3];
        for axis in 0..3 {
            let [low, high] = &mut ends[axis];
            for waypoint in waypoints {
                *low = low.min(waypoint.position[axis] - waypoint.within);
                *high = high.max(waypoint.position[axis] + waypoint.within);
            }
            for &i in bounds {
                let (Some(body), Some(margin)) = (body(&limits[i]), limits[i].lower) else { continue };
                let (bottom, top) = body.extent();
                // Just inside the sides that a vehicle keeps, so that boxes between these planes are closed.
                let reach = margin - 2.0 * slack(&limits[i]);
                for plane in [bottom[axis] - reach, bottom[axis], top[axis], top[axis] + reach] {
                    if plane.is_finite() {
                        own[axis].push(plane);
                        (*low, *high) = (low.min(plane), high.max(plane));
                    }
                }
            }
            let room = 0.05 * (*high - *low) + 1.0;
            (*low, *high) = (*low - room, *high + room);
            let kept = bounds.iter().filter(|&&i| limits[i].kind == [LimitKind::X, LimitKind::Y, LimitKind::Z][axis]);
            let kept = kept.map(|&i| {
                let Limit { lower, upper, span, .. } = limits[i];
                let slack = slack(&limits[i]);
                (lower.map(|lower| lower - slack), upper.map(|upper| upper + slack), span)
            });
            let inside = volumes.iter().filter(|volume| volume.side == Side::KeepIn).flat_map(|volume| {
                volume.bodies.iter().map(|body| {
                    let (bottom, top) = body.extent();
                    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
                    (finite(bottom[axis]), finite(top[axis]), volume.span)
                })
            });
            let [mut lowest, mut highest] = [f64::NEG_INFINITY, f64::INFINITY];
            for (lower, upper, span) in kept.chain(inside) {
                if let Some(lower) = lower.filter(|&lower| lower > lowest) {
                    (lowest, excluded[axis][0]) = (lower, Some(span));
                }
                if let Some(upper) = upper.filter(|&upper| upper < highest) {
                    (highest, excluded[axis][1]) = (upper, Some(span));
                }
            }
            outer[axis] = [lowest, highest];
            (*low, *high) = (low.max(lowest), high.min(highest));
            if *low >= *high {
                return None;
            }
        }
        let longest = ends.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        for axis in 0..3 {
            let [low, high] = ends[axis];
            // One box on each side reaches to what is excluded.
            planes[axis].extend(outer[axis].into_iter().filter(|x| x.is_finite()));
            let count = ((high - low) / longest * parts as f64).ceil().max(2.0) as usize;
            planes[axis].extend((0..=count).map(|k| low + (high - low) * k as f64 / count as f64));
            if own[axis].len() <= MOST_OWN {
                planes[axis].extend(own[axis].iter().filter(|&&plane| low < plane && plane < high));
            }
            planes[axis].sort_by(f64::total_cmp);
            planes[axis].dedup();
        }
        let boxes = Boxes { planes, excluded };
        let work = |&i: &usize| {
            let edges = match body(&limits[i]) {
                Some(Body::Prism { corners, .. }) => corners.len() as f64,
                _ => 1.0,
            };
            edges * boxes.near(&limits[i]).iter().map(|range| range.len() as f64 + 1.0).product::<f64>()
        };
        (bounds.iter().map(work).sum::<f64>() <= MOST_WORK).then_some(boxes)
    }

    fn counts(&self) -> [usize; 3] {
        [0, 1, 2].map(|axis| self.planes[axis].len() - 1)
    }

    fn count(&self) -> usize {
        self.counts().iter().product()
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        let [nx, ny, _] = self.counts();
        x + nx * (y + ny * z)
    }

    /// The boxes, by axis, that a bound may close.
    fn near(&self, limit: &Limit) -> [Range<usize>; 3] {
        let (low, high, margin) = match body(limit).zip(limit.lower) {
            Some((body, clearance)) => (body.extent().0, body.extent().1, clearance),
            None => ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3], 0.0),
        };
        [0, 1, 2].map(|axis| self.touching(axis, low[axis] - margin, high[axis] + margin))
    }

    /// The boxes of an axis that have a point between two planes.
    fn touching(&self, axis: usize, low: f64, high: f64) -> Range<usize> {
        let planes = &self.planes[axis];
        let count = planes.len() - 1;
        let first = planes[1..].partition_point(|&top| top < low).min(count);
        let end = planes[..count].partition_point(|&bottom| bottom <= high).max(first);
        first..end
    }

    /// The boxes that one of these bounds closes, in order.
    fn closed_by(&self, limits: &[Limit], bounds: &[usize]) -> Vec<usize> {
        let mut closed: Vec<usize> = bounds.iter().flat_map(|&i| self.closed_by_one(&limits[i])).collect();
        closed.sort_unstable();
        closed.dedup();
        closed
    }

    fn closed_by_one(&self, limit: &Limit) -> Vec<usize> {
        let [xs, ys, zs] = self.near(limit);
        let cells = || {
            let (xs, ys) = (xs.clone(), ys.clone());
            zs.clone().flat_map(move |z| {
                let xs = xs.clone();
                ys.clone().flat_map(move |y| xs.clone().map(move |x| [x, y, z]))
            })
        };
        let slack = slack(limit);
        let centre = match &limit.kind {
            LimitKind::Distance(from) => from.centre(),
            _ => None,
        };
        // The distance of a box from a point.
        if let (Some(centre), Some(upper)) = (centre, limit.upper) {
            let apart = |cell: [usize; 3]| {
                let out = |(i, c): (usize, &f64)| {
                    let planes = &self.planes[i];
                    (planes[cell[i]] - c).max(c - planes[cell[i] + 1]).max(0.0).powi(2)
                };
                centre.iter().enumerate().map(out).sum::<f64>().sqrt()
            };
            return cells().filter(|&cell| apart(cell) > upper + slack).map(|cell| self.index(cell)).collect();
        }
        // Every corner of every box once: whether the lower bound is violated there, and the upper one.
        let size = [xs.len() + 1, ys.len() + 1, zs.len() + 1];
        let corner = |[x, y, z]: [usize; 3]| x + size[0] * (y + size[1] * z);
        let mut violated = vec![[false; 2]; size.iter().product()];
        for z in 0..size[2] {
            for y in 0..size[1] {
                for x in 0..size[0] {
                    let at = [xs.start + x, ys.start + y, zs.start + z];
                    let value = limit.value_at([0, 1, 2].map(|i| self.planes[i][at[i]])).unwrap_or(f64::NAN);
                    violated[corner([x, y, z])] = [
                        limit.lower.is_some_and(|lower| value < lower - slack),
                        limit.upper.is_some_and(|upper| value > upper + slack),
                    ];
                }
            }
        }
        let is_closed = |&[x, y, z]: &[usize; 3]| {
            let of = |side: usize| {
                (0..8).all(|k| {
                    let at = [x - xs.start + k % 2, y - ys.start + k / 2 % 2, z - zs.start + k / 4];
                    violated[corner(at)][side]
                })
            };
            of(0) || of(1)
        };
        cells().filter(is_closed).map(|cell| self.index(cell)).collect()
    }

    /// The number of the part in which each box lies, parts being joined by common faces; 0 for closed boxes. Part 1 is
    /// joined to what lies beyond, as far as statements other than `without` leave it.
    fn connected(&self, closed: &[u16], without: &[Span]) -> Vec<u32> {
        let counts = self.counts();
        let mut parts = vec![0; closed.len()];
        let cell_of = |cell: usize| [cell % counts[0], cell / counts[0] % counts[1], cell / counts[0] / counts[1]];
        let is_open = |end: Option<Span>| end.is_none_or(|span| without.contains(&span));
        let is_outer = |cell: usize| {
            let at = cell_of(cell);
            let outer = |i: usize| [at[i] == 0, at[i] + 1 == counts[i]];
            (0..3).any(|i| (0..2).any(|side| outer(i)[side] && is_open(self.excluded[i][side])))
        };
        let mut queue: Vec<usize> = (0..closed.len()).filter(|&cell| closed[cell] == 0 && is_outer(cell)).collect();
        queue.iter().for_each(|&cell| parts[cell] = 1);
        let (mut part, mut next) = (1, 0);
        loop {
            while let Some(cell) = queue.pop() {
                let at = cell_of(cell);
                for axis in 0..3 {
                    for to in [at[axis].checked_sub(1), Some(at[axis] + 1).filter(|&k| k < counts[axis])] {
                        let Some(to) = to else { continue };
                        let mut beside = at;
                        beside[axis] = to;
                        let beside = self.index(beside);
                        if closed[beside] == 0 && parts[beside] == 0 {
                            parts[beside] = part;
                            queue.push(beside);
                        }
                    }
                }
            }
            let Some(cell) = (next..closed.len()).find(|&cell| closed[cell] == 0 && parts[cell] == 0) else { break };
            next = cell + 1;
            part += 1;
            parts[cell] = part;
            queue.push(cell);
        }
        parts
    }

    /// Whether no part has points within the tolerances of both waypoints.
    fn separates(&self, parts: &[u32], ends: &[Waypoint]) -> bool {
        let [a, b] = [0, 1].map(|end| self.parts_at(parts, &ends[end]));
        !a.is_empty() && !b.is_empty() && !a.iter().any(|part| b.contains(part))
    }

    fn parts_at(&self, parts: &[u32], waypoint: &Waypoint) -> Vec<u32> {
        let [low, high] = [-1.0, 1.0].map(|side| waypoint.position.map(|p: f64| p + side * waypoint.within));
        let [xs, ys, zs] = [0, 1, 2].map(|axis| self.touching(axis, low[axis], high[axis]));
        let mut found = Vec::new();
        for z in zs {
            for y in ys.clone() {
                for x in xs.clone() {
                    found.push(parts[self.index([x, y, z])]);
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found.retain(|&part| part != 0);
        found
    }
}

#[cfg(test)]
mod tests;
