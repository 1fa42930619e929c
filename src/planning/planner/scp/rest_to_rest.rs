//! A first plan in closed form: the polyline through the waypoints, flown leg by leg from rest to rest.
//!
//! Where the polyline is free, every limit holds at rest and no rate has a lower bound, such a motion satisfies all
//! rows if it is slow enough: it stays on the polyline, and its wrench tends to that of hover. Each leg rests at both
//! ends, so that its duration is found for itself. The search for short times starts from here where the minimum-snap
//! motion ([`super::minimum_snap`]) leads to no plan.

use super::way_around::{nth_way, obstructed};
use super::*;
use crate::model::{Heading, LimitKind, Mission, Target, Waypoint};
use crate::planner::timing::{MAX_MISSION_TIME, kinematics};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Fewest intervals of a move along a line: its inputs have to end position, velocity, acceleration and jerk.
const LEAST_OF_MOVE: usize = 5;
/// Fewest intervals of a turn on the spot, whose inputs have to end yaw and yaw rate.
const LEAST_OF_TURN: usize = 3;
/// Turns by less than this are left to the moves, rad.
const SAME_YAW: f64 = 1e-9;
/// The part of a leg's duration that a turn on the spot gets, beside a move. Chosen by hand.
const SHARE_OF_TURN: f64 = 0.5;
/// Relative precision of the duration of a leg. Chosen by hand: the steps that follow shorten it anyway.
const PRECISION: f64 = 0.02;
/// Factor from one duration of a leg to the next while none is slow enough. Chosen by hand.
const SLOWER: f64 = 1.5;

/// Derivatives of orders 0 to 4 of a progress from 0 to 1 at the nodes of a phase.
type Progress = Vec<[f64; 5]>;

/// A part of a leg between two rests: a move along a line, or a turn on the spot.
struct Phase {
    from: [f64; 3],
    to: [f64; 3],
    /// Yaw at both ends, rad.
    yaw: [f64; 2],
    /// The point (x, y), m, that the yaw follows in between.
    towards: Option<[f64; 2]>,
}

impl Phase {
    fn is_move(&self) -> bool {
        self.from != self.to
    }

    fn least_intervals(&self) -> usize {
        if self.is_move() { LEAST_OF_MOVE } else { LEAST_OF_TURN }
    }

    /// How the phases of a leg share its intervals.
    fn share(&self) -> f64 {
        let length = (0..3).map(|i| (self.to[i] - self.from[i]).powi(2)).sum::<f64>().sqrt();
        if self.is_move() { length.sqrt() } else { SHARE_OF_TURN }
    }

    /// The states at nodes at which the progress of position and yaw is known.
    fn states(&self, position: &Progress, yaw: &Progress) -> Vec<NodeState> {
        let at = |(s, turn): (&[f64; 5], &[f64; 5])| {
            let mut state = NodeState::default();
            for order in 0..5 {
                for axis in [X, Y, Z] {
                    state[axis][order] = (self.to[axis] - self.from[axis]) * s[order];
                }
                state[YAW][order] = (self.yaw[1] - self.yaw[0]) * turn[order];
            }
            for axis in [X, Y, Z] {
                state[axis][0] += self.from[axis];
            }
            state[YAW][0] += self.yaw[0];
            if let Some(point) = self.towards {
                state[YAW] = bearing(&state, point, state[YAW][0]);
            }
            state
        };
        position.iter().zip(yaw).map(at).collect()
    }
}

/// The yaw towards a point, its rate and its acceleration, of the branch nearest to `near` (rad).
fn bearing(state: &NodeState, point: [f64; 2], near: f64) -> [f64; 5] {
    let [x, y] = [X, Y].map(|axis| point[axis] - state[axis][0]);
    let square = x * x + y * y;
    let [vx, vy] = [X, Y].map(|axis| -state[axis][1]);
    let [ax, ay] = [X, Y].map(|axis| -state[axis][2]);
    let rate = (x * vy - y * vx) / square;
    let acceleration = (x * ay - y * ax) / square - 2.0 * rate * (x * vx + y * vy) / square;
    [nearest_branch(y.atan2(x), near), rate, acceleration, 0.0, 0.0]
}

/// The angle (rad) that differs from `angle` by whole turns and is nearest to `near`.
fn nearest_branch(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// A motion of a chain of `order` integrators from 0 to 1 over the nodes, from rest to rest, with zero inputs at both
/// ends and the smallest inputs in between that are linear between nodes. `None` if there are too few nodes.
fn progress(times: &[f64], order: usize) -> Option<Progress> {
    let (begin, last) = (times[0], times.len() - 1);
    let duration = times[last] - begin;
    let t: Vec<f64> = times.iter().map(|t| (t - begin) / duration).collect();
    let inner = last.checked_sub(1).filter(|&inner| inner >= order)?;
    // What an input of 1 at node k, falling to 0 at its neighbours, adds to the derivatives at the end.
    let at_end = |k: usize, derivative: usize| {
        let power = (order - 1 - derivative) as i32;
        let ramp = |from: f64, to: f64| {
            // The integral of (1 - t)^p (t - from)/(to - from)/p! between both, by parts.
            let primitive = |t: f64, n: i32| (1.0 - t).powi(n) / (1..=n).map(f64::from).product::<f64>();
            -primitive(to, power + 1) - (primitive(to, power + 2) - primitive(from, power + 2)) / (to - from)
        };
        ramp(t[k - 1], t[k]) - ramp(t[k + 1], t[k])
    };
    let weight = |k: usize| 0.5 * (t[k + 1] - t[k - 1]);
    let effect = DMatrix::from_fn(order, inner, |derivative, k| at_end(k + 1, derivative));
    let weighted = DMatrix::from_fn(inner, order, |k, derivative| effect[(derivative, k)] / weight(k + 1));
    let mut end = DVector::zeros(order);
    end[0] = 1.0;
    let inputs = &weighted * (&effect * &weighted).lu().solve(&end)?;
    let input = |k: usize| if k == 0 || k == last { 0.0 } else { inputs[k - 1] };
    let mut states = vec![[0.0; 5]];
    for k in 0..last {
        let h = t[k + 1] - t[k];
        let mut all: Vec<f64> = states[k][..order].to_vec();
        all.extend([input(k), (input(k + 1) - input(k)) / h]);
        let late = |i: usize| (i..all.len()).rev().fold(0.0, |sum, j| all[j] + sum * h / (j + 1 - i) as f64);
        let mut next = [0.0; 5];
        (0..order).for_each(|i| next[i] = late(i));
        next[order] = input(k + 1);
        states.push(next);
    }
    states[last] = [1.0, 0.0, 0.0, 0.0, 0.0];
    let scaled = |s: &[f64; 5]| std::array::from_fn(|m| s[m] / duration.powi(m as i32));
    Some(states.iter().map(scaled).collect())
}

/// What the yaw follows on a leg between two waypoints.
fn target_on(mission: &Mission, leg: usize) -> Option<Target> {
    mission.limits.iter().find_map(|limit| match limit.kind {
        LimitKind::Heading(target) if limit.leg.as_ref().is_some_and(|on| on.leg == leg) => Some(target),
        _ => None,
    })
}

/// The direction of a horizontal line, rad; `None` for a vertical one.
fn direction(from: [f64; 3], to: [f64; 3]) -> Option<f64> {
    let [x, y] = [X, Y].map(|axis| to[axis] - from[axis]);
    (x.hypot(y) > SAME_YAW).then(|| y.atan2(x))
}

/// The yaw at which the polyline rests at each waypoint, rad: the waypoint's own, or that towards the point that the
/// yaw follows on a leg before or after.
fn yaws(mission: &Mission) -> Vec<f64> {
    let mut last = mission.waypoints[0].yaw;
    let at = |(i, w): (usize, &Waypoint)| {
        let legs = [i.checked_sub(1), (i < mission.legs.len()).then_some(i)];
        let mut targets = legs.into_iter().flatten().filter_map(|leg| target_on(mission, leg));
        let towards = targets.find_map(|target| match target {
            Target::Towards { point, .. } => Some((point[1] - w.position[1]).atan2(point[0] - w.position[0])),
            Target::AlongPath => None,
        });
        let along = || {
            let before = i.checked_sub(1).filter(|&leg| target_on(mission, leg) == Some(Target::AlongPath))?;
            direction(mission.waypoints[before].position, w.position)
        };
        last = match (towards, w.heading) {
            (Some(angle), _) => nearest_branch(angle, last),
            (None, Heading::Given) => w.yaw,
            (None, _) => along().map_or(last, |angle| nearest_branch(angle, last)),
        };
        last
    };
    mission.waypoints.iter().enumerate().map(at).collect()
}

impl ScpPlanner<'_, '_> {
    /// A motion from rest to rest at every waypoint, over the grid with `samples` intervals, that satisfies every row
    /// at every instant.
    ///
    /// # Errors
    /// The first leg that has no such motion.
    pub(super) fn rest_to_rest(&mut self, samples: usize) -> Result<Iterate, usize> {
        let mission = self.hover.mission();
        let mut durations = kinematics::initial(self.hover.problem);
        let yaws = yaws(mission);
        let phases: Vec<Vec<Phase>> =
            (0..mission.legs.len()).map(|leg| self.phases(leg, &yaws)).collect::<Option<_>>().ok_or(0usize)?;
        let whole = |durations: &[f64]| durations.iter().sum::<f64>() + self.held();
        // The nodes of a leg follow its duration, and that is found on its nodes: twice is enough.
        for last in [false, true] {
            let grid = self.lay_out(Some(&durations), whole(&durations), samples).ok_or(0usize)?.flown();
            let iterate = self.along_phases(&grid, &phases)?;
            let factors = self.slow_enough(&iterate)?;
            if last {
                return Ok(iterate.stepped(&iterate.states, &factors.iter().map(|f| f - 1.0).collect::<Vec<_>>()));
            }
            durations = grid.segments.iter().map(|s| s.duration * factors[s.from]).collect();
        }
        Err(0)
    }

    /// The phases of a leg; `None` if no way around what is on it was found.
    fn phases(&self, leg: usize, yaws: &[f64]) -> Option<Vec<Phase>> {
        let mission = self.hover.problem.mission();
        let limits: Vec<&Limit> = mission.limits.iter().filter(|limit| limit.concerns(leg)).collect();
        let (from, to) = (mission.waypoints[leg].position, mission.waypoints[leg + 1].position);
        let way = match obstructed(&limits, from, to) {
            None => vec![from, to],
            Some(_) => nth_way(&limits, from, to, self.sides.get(&leg).copied().unwrap_or(0))?,
        };
        let target = target_on(mission, leg);
        let mut phases = Vec::new();
        let mut yaw = yaws[leg];
        let turn = |phases: &mut Vec<Phase>, at: [f64; 3], yaw: [f64; 2]| {
            if (yaw[1] - yaw[0]).abs() > SAME_YAW {
                phases.push(Phase { from: at, to: at, yaw, towards: None });
            }
        };
        for (nth, ends) in way.windows(2).enumerate() {
            let share = |k: usize| k as f64 / (way.len() - 1) as f64;
            let (begin, end, towards) = match target {
                None => {
                    let at = |k: usize| yaws[leg] + share(k) * (yaws[leg + 1] - yaws[leg]);
                    (at(nth), at(nth + 1), None)
                }
                Some(Target::AlongPath) => {
                    let along = direction(ends[0], ends[1]).map_or(yaw, |angle| nearest_branch(angle, yaw));
                    (along, along, None)
                }
                Some(Target::Towards { point, .. }) => {
                    let at = |p: [f64; 3], near| nearest_branch((point[1] - p[1]).atan2(point[0] - p[0]), near);
                    let begin = at(ends[0], yaw);
                    (begin, at(ends[1], begin), Some(point))
                }
            };
            turn(&mut phases, ends[0], [yaw, begin]);
            if ends[0] != ends[1] {
                phases.push(Phase { from: ends[0], to: ends[1], yaw: [begin, end], towards });
            }
            yaw = end;
        }
        turn(&mut phases, to, [yaw, yaws[leg + 1]]);
        Some(phases)
    }

    /// The phases of all legs over the nodes of a grid. Where a leg has too few intervals for its phases it is `Err`.
    fn along_phases(&self, grid: &TimeGrid, phases: &[Vec<Phase>]) -> Result<Iterate, usize> {
        let start = self.hover.problem.mission().waypoints[0].position;
        let mut states = vec![NodeState::default(); grid.nodes()];
        [X, Y, Z].into_iter().for_each(|axis| states[0][axis][0] = start[axis]);
        for (segment, phases) in grid.segments.iter().zip(phases) {
            let least: usize = phases.iter().map(Phase::least_intervals).sum();
            let spare = segment.intervals.checked_sub(least).ok_or(segment.from)?;
            let shares: f64 = phases.iter().map(Phase::share).sum();
            let (mut node, mut given, mut share) = (segment.first_node, 0, 0.0);
            for phase in phases {
                share += phase.share() / shares;
                let extra = (share * spare as f64).round() as usize - given;
                given += extra;
                let end = node + phase.least_intervals() + extra;
                let times = &grid.node_times[node..=end];
                let [position, yaw] = [4, 2].map(|order| progress(times, order));
                let (Some(position), Some(yaw)) =
                    (position.or_else(|| (!phase.is_move()).then(|| vec![[0.0; 5]; times.len()])), yaw)
                else {
                    return Err(segment.from);
                };
                states[node..=end].copy_from_slice(&phase.states(&position, &yaw));
                node = end;
            }
        }
        Ok(Iterate { grid: grid.clone(), states, model: self.wrench })
    }

    /// For each leg about the smallest factor of its duration with which it satisfies every row at every instant.
    fn slow_enough(&self, iterate: &Iterate) -> Result<Vec<f64>, usize> {
        let legs = iterate.grid.segments.iter();
        legs.map(|segment| self.slow_enough_on(iterate, segment).ok_or(segment.from)).collect()
    }

    fn slow_enough_on(&self, iterate: &Iterate, segment: &Segment) -> Option<f64> {
        let instants = segment.first_node * PARTS..=(segment.first_node + segment.intervals) * PARTS;
        let is_inside = |factor: f64| {
            let slow = iterate.slower(factor);
            let form = self.transcription(&slow.grid, &[]);
            instants.clone().all(|instant| {
                self.violation_at(&form, &slow.at(instant), instant) <= 0.0
                    && self.command_violation_at(&slow, instant) <= 0.0
            })
        };
        let (mut low, mut high) = (0.0, 1.0);
        while !is_inside(high) {
            (low, high) = (high, SLOWER * high);
            if high * segment.duration > MAX_MISSION_TIME {
                return None;
            }
        }
        while high - low > PRECISION * high {
            let middle = if low == 0.0 { high / SLOWER } else { 0.5 * (low + high) };
            if is_inside(middle) { high = middle } else { low = middle }
        }
        Some(high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_progress_ends_at_rest() {
        for (order, times) in [(4, vec![0.0, 0.5, 1.1, 1.8, 2.2, 3.0, 3.1, 4.0]), (2, vec![1.0, 2.0, 2.5, 4.0])] {
            let states = progress(&times, order).unwrap();
            let (last, before) = (times.len() - 1, times.len() - 2);
            let h = times[last] - times[before];
            let mut all: Vec<f64> = states[before][..=order].to_vec();
            all.push((0.0 - states[before][order]) / h);
            for i in 0..order {
                let end = (i..all.len()).rev().fold(0.0, |sum, j| all[j] + sum * h / (j + 1 - i) as f64);
                assert!((end - f64::from(u8::from(i == 0))).abs() < 1e-12, "{order} {i} {end}");
            }
            assert!(states.windows(2).all(|pair| pair[0][0] <= pair[1][0] + 1e-12));
        }
        assert!(progress(&[0.0, 1.0, 2.0, 3.0, 4.0], 4).is_none());
    }
}
