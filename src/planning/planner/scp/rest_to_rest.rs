//! A first plan in closed form: the polyline through the waypoints, flown leg by leg from rest to rest.
//!
//! Where the polyline is free, every limit holds at rest and no rate has a lower bound, such a motion satisfies all
//! rows if it is slow enough: it stays on the polyline, and its wrench tends to that of hover. Each leg rests at both
//! ends, so that its duration is found for itself. The search for short times starts from here where the minimum-snap
//! motion ([`super::minimum_snap`]) leads to no plan.

use super::iterate::Iterate;
use super::way_around::{nth_way, obstructed};
use super::{PARTS, ScpPlanner};
use crate::model::Limit;
use crate::model::{Heading, LimitKind, Mission, Target, Waypoint};
use crate::motion::time_grid::{Segment, TimeGrid};
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::timing::kinematics;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Fewest intervals of a move along a line in the exact model: its inputs have to end position, velocity, acceleration
/// and jerk.
const LEAST_OF_MOVE: usize = 5;
/// Fewest intervals of a turn on the spot, whose inputs have to end yaw and yaw rate.
const LEAST_OF_TURN: usize = 3;
/// Turns by less than this are left to the moves, rad.
const SAME_YAW: f64 = 1e-9;
/// The part of a leg's duration that a turn on the spot gets, beside a move. Chosen by hand.
const SHARE_OF_TURN: f64 = 0.5;

/// Derivatives of orders 0 to 4 of a progress from 0 to 1 at the nodes of a phase.
type Progress = Vec<[f64; 5]>;

/// A part of a leg between two rests: a move along a line, or a turn or rest on the spot.
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

    /// The states at the nodes of the phase, for chains of integrators of these orders; `None` if there are too few.
    fn states(&self, times: &[f64], orders: [usize; 4]) -> Option<Vec<NodeState>> {
        let mut states = vec![NodeState::default(); times.len()];
        for axis in [X, Y, Z] {
            let (from, to) = (self.from[axis], self.to[axis]);
            let mut values = vec![[0.0; 5]; times.len()];
            if self.is_move() {
                values = progress(times, orders[axis])?.into_iter().map(|s| s.map(|s| (to - from) * s)).collect();
            }
            values.iter_mut().for_each(|value| value[0] += from);
            states.iter_mut().zip(values).for_each(|(state, values)| state[axis] = values);
        }
        let inputs: Vec<f64> = match self.towards {
            Some(point) => states.iter().map(|state| turning(state, point)).collect(),
            None => vec![0.0; times.len()],
        };
        let yaw = from_rest_to_rest(times, orders[YAW], self.yaw, &inputs)?;
        states.iter_mut().zip(yaw).for_each(|(state, yaw)| state[YAW] = yaw);
        Some(states)
    }
}

/// The acceleration of the yaw towards a point (x, y), m; rad/s^2.
fn turning(state: &NodeState, point: [f64; 2]) -> f64 {
    let [x, y] = [X, Y].map(|axis| point[axis] - state[axis][0]);
    let [vx, vy] = [X, Y].map(|axis| -state[axis][1]);
    let [ax, ay] = [X, Y].map(|axis| -state[axis][2]);
    let square = x * x + y * y;
    let rate = (x * vy - y * vx) / square;
    (x * ay - y * ax - 2.0 * rate * (x * vx + y * vy)) / square
}

/// The angle (rad) that differs from `angle` by whole turns and is nearest to `near`.
fn nearest_branch(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// A motion of a chain of `order` integrators from 0 to 1 over the nodes, from rest to rest, with the smallest inputs.
/// `None` if there are too few nodes.
fn progress(times: &[f64], order: usize) -> Option<Progress> {
    from_rest_to_rest(times, order, [0.0, 1.0], &vec![0.0; times.len()])
}

/// A motion of a chain of `order` integrators over the nodes, from rest at one value to rest at another, with inputs
/// that are linear between nodes, zero at both ends, and elsewhere as near to `inputs` as possible. `None` if there are
/// too few nodes.
fn from_rest_to_rest(times: &[f64], order: usize, [from, to]: [f64; 2], inputs: &[f64]) -> Option<Progress> {
    let (begin, last) = (times[0], times.len() - 1);
    // In units of the duration, whose powers would differ in size.
    let duration = times[last] - begin;
    let t: Vec<f64> = times.iter().map(|t| (t - begin) / duration).collect();
    let inner = last.checked_sub(1).filter(|&inner| inner >= order)?;
    // What an input of 1 at node k, falling to 0 at its neighbours, adds to a derivative at the end.
    let at_end = |k: usize, derivative: usize| {
        let power = (order - 1 - derivative) as i32;
        let ramp = |from: f64, to: f64| {
            // The integral of (1 - t)^p/p! (t - from)/(to - from) between both, by parts.
            let primitive = |t: f64, n: i32| (1.0 - t).powi(n) / (1..=n).map(f64::from).product::<f64>();
            -primitive(to, power + 1) - (primitive(to, power + 2) - primitive(from, power + 2)) / (to - from)
        };
        ramp(t[k - 1], t[k]) - ramp(t[k + 1], t[k])
    };
    let weight = |k: usize| 0.5 * (t[k + 1] - t[k - 1]);
    let effect = DMatrix::from_fn(order, inner, |derivative, k| at_end(k + 1, derivative));
    let weighted = DMatrix::from_fn(inner, order, |k, derivative| effect[(derivative, k)] / weight(k + 1));
    let wanted = DVector::from_fn(inner, |k, _| inputs[k + 1] * duration.powi(order as i32));
    let mut missing = -(&effect * &wanted);
    missing[0] += to - from;
    let found = wanted + &weighted * (&effect * &weighted).lu().solve(&missing)?;
    let input = |k: usize| if k == 0 || k == last { 0.0 } else { found[k - 1] };
    let mut state = [0.0; 5];
    state[0] = from;
    let mut states = vec![state];
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
    states[last] = [to, 0.0, 0.0, 0.0, 0.0];
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
    (x.hypot(y) > 0.0).then(|| y.atan2(x))
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
    /// at every instant. `None` if some leg has no such motion, or too few intervals for it.
    pub(super) fn rest_to_rest(&mut self, samples: usize) -> Option<Iterate> {
        let yaws = yaws(self.mission());
        let legs = 0..self.mission().legs.len();
        let phases: Vec<Vec<Phase>> = legs.map(|leg| self.phases(leg, &yaws)).collect::<Option<_>>()?;
        // The nodes of a leg follow its duration, and that is found on its nodes: twice is enough.
        let first = self.fast_enough(&kinematics::initial(self.problem()), &phases, samples)?;
        let durations: Vec<f64> = first.grid.segments.iter().map(|s| s.duration).collect();
        self.fast_enough(&durations, &phases, samples)
    }

    /// The phases over the grid of these durations (s), each leg slower or faster so that it satisfies every row.
    fn fast_enough(&self, durations: &[f64], phases: &[Vec<Phase>], samples: usize) -> Option<Iterate> {
        let total = durations.iter().sum::<f64>() + self.held();
        let iterate = self.along_phases(&self.lay_out(Some(durations), total, samples)?.flown(), phases)?;
        let legs = iterate.grid.segments.iter();
        let changes = legs.map(|segment| Some(self.least_factor(&iterate, segment)? - 1.0)).collect::<Option<Vec<_>>>();
        Some(iterate.stepped(&iterate.states, &changes?))
    }

    /// The phases of a leg; `None` if no way around what is on it was found.
    fn phases(&self, leg: usize, yaws: &[f64]) -> Option<Vec<Phase>> {
        let mission = self.problem().mission();
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
        if phases.is_empty() {
            phases.push(Phase { from, to, yaw: [yaw; 2], towards: None });
        }
        Some(phases)
    }

    /// The phases of all legs over the nodes of a grid; `None` if a leg has too few intervals for its phases.
    fn along_phases(&self, grid: &TimeGrid, phases: &[Vec<Phase>]) -> Option<Iterate> {
        let mut states = vec![NodeState::default(); grid.nodes()];
        for (segment, phases) in grid.segments.iter().zip(phases) {
            let least: usize = phases.iter().map(Phase::least_intervals).sum();
            let spare = segment.intervals.checked_sub(least)?;
            let shares: f64 = phases.iter().map(Phase::share).sum();
            let (mut node, mut given, mut share) = (segment.first_node, 0, 0.0);
            for phase in phases {
                share += phase.share() / shares;
                let extra = (share * spare as f64).round() as usize - given;
                given += extra;
                let end = node + phase.least_intervals() + extra;
                let of_phase = phase.states(&grid.node_times[node..=end], self.wrench.orders())?;
                states[node..=end].copy_from_slice(&of_phase);
                node = end;
            }
        }
        Some(Iterate { grid: grid.clone(), states, model: self.wrench })
    }

    /// About the smallest factor of a leg's duration with which it satisfies every row at every instant.
    fn least_factor(&self, iterate: &Iterate, segment: &Segment) -> Option<f64> {
        let instants = segment.first_node * PARTS..=(segment.first_node + segment.intervals) * PARTS;
        self.least_slowing(segment.duration, |factor| {
            let slow = iterate.slower(factor);
            let form = self.transcription(&slow.grid, &[]);
            instants.clone().all(|instant| {
                self.largest_violation_at(&form, &slow.at(instant), instant) <= 0.0
                    && self.command_violation_at(&slow, instant) <= 0.0
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Problem;
    use crate::motion::wrench_model::WrenchModel;
    use crate::planner::hover::HoverPlanner;
    use crate::planner::selection::sets::PlanningSets;

    /// In both models, with a leg without a move, turns on the spot, a yaw towards a point, a hold and a vertical leg:
    /// every row holds, and the pieces join.
    #[test]
    fn the_polyline_satisfies_every_row() {
        let spec = crate::compile(
            "vehicle v { layout = \"PNPNPNPN\"; arm = 0.5 m; mass = 3 kg; inertia = [0.05, 0.06, 0.1] kg*m^2
    rotor { max_thrust = 8 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s } }
mission m {
    start at [0, 0, 2] m
    waypoint at [0, 0, 2] m  yaw 90 deg
    waypoint at [0, 0, 9] m  vertical
    hold 1 s
    waypoint at [8, 0, 9] m  yaw along path
    waypoint at [8, 6, 7] m  yaw along path
    waypoint at [0, 6, 5] m  yaw towards [4, -9, 0] m
    keep_in hall { shape = box; from = [-1, -1, 1] m; to = [9, 7, 10] m }
    limits { speed <= 4 m/s; tilt <= 25 deg; yaw_rate <= 90 deg/s }
}
plan { planner = rip; against = []; samples = 150 }",
        );
        let spec = spec.into_result().unwrap();
        let sets = PlanningSets::of(spec.model());
        let problem = Problem::of(spec.model()).unwrap();
        for wrench in [WrenchModel::Exact, WrenchModel::HoverFollowing] {
            let mut hover = HoverPlanner::new(problem, &sets.healthy);
            let mut planner = ScpPlanner::new(&mut hover, wrench, &sets.rip);
            let iterate = planner.rest_to_rest(150).unwrap();
            assert!(planner.largest_violation(&iterate) <= 0.0, "{wrench:?} {}", planner.largest_violation(&iterate));
            assert!(iterate.is_joined(1e-9), "{wrench:?}");
            for (waypoint, &node) in problem.mission().waypoints.iter().zip(&iterate.grid.waypoint_nodes) {
                let state = iterate.states[node];
                assert!((0..3).all(|axis| (state[axis][0] - waypoint.position[axis]).abs() < 1e-9), "{waypoint:?}");
                assert!((0..4).all(|axis| state[axis][1].abs() < 1e-9), "{waypoint:?}");
            }
        }
    }

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
