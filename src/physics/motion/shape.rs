//! The shape of a motion: how high it rises, how far it strays from the straight legs, and how far the yaw turns.
//!
//! Heights and distances are sampled in ten steps an interval, and the largest sample is refined
//! ([`peak`]). A peak that all samples miss exceeds the value given by at most `a s^2 / 8`, where
//! `s` is the step and `a` the largest second derivative of the quantity: by 1 mm for intervals of 0.2 s and 20 m/s^2.
//! The yaw is monotone between the roots of its rate, so that its total variation is a sum of differences, exact where
//! the rate changes its sign at most once in a step.

use super::checks::{Peak, STEPS, leg_intervals, peak, peak_over};
use super::{NodeState, Trajectory, X, Y, YAW, Z};
use crate::model::legs::distance;
use crate::model::{Heading, Mission};
use std::ops::Range;

/// Instants nearer to a waypoint than this count as the waypoint's, s.
const SAME_INSTANT: f64 = 1e-3;

/// Bisections for an instant at which the yaw turns back: to 1e-12 of a step.
const BISECTIONS: usize = 40;

/// The shape of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The greatest height (z), m, and when it is attained.
    pub top: Peak,
    pub top_place: Place,
    /// How much higher that is than the highest waypoint, m; negative if the motion stays below it.
    pub above: f64,
    /// In the order of flight.
    pub legs: Vec<LegShape>,
    /// `None` where no leg has a given yaw at both ends.
    pub yaw: Option<Turned>,
}

/// Where a motion is at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// At a waypoint, by index.
    Waypoint(usize),
    /// On the leg with this index in [`Mission::legs`].
    Leg(usize),
}

/// The shape of one leg, without the hold before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegShape {
    /// Distance between its waypoints, m.
    pub length: f64,
    /// The largest height above the higher of its two waypoints, m.
    pub climb: Peak,
    /// The largest distance from the segment between its waypoints, m.
    pub deviation: Peak,
    /// The largest distance from the segment with heights above the higher waypoint taken as its height, m: what a
    /// limit on height leaves.
    pub aside: Peak,
}

/// How far the yaw turns on the legs that have a given yaw at both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turned {
    /// Total variation of the yaw, rad.
    pub turned: f64,
    /// Sum of the differences between the waypoints' yaws, rad: the least that reaches them exactly.
    pub required: f64,
}

impl Shape {
    /// The shape of a trajectory of this mission.
    pub fn of(trajectory: &Trajectory, mission: &Mission) -> Self {
        let top = peak(trajectory, |state| state[Z][0]);
        let highest = mission.waypoints.iter().map(|w| w.position[Z]).fold(f64::NEG_INFINITY, f64::max);
        Shape {
            top,
            top_place: place(trajectory, mission, top.at),
            above: top.value - highest,
            legs: (0..mission.legs.len()).map(|leg| leg_shape(trajectory, mission, leg)).collect(),
            yaw: turned(trajectory, mission),
        }
    }

    /// The index of the leg with the largest deviation, the first of several.
    pub fn farthest(&self) -> usize {
        let by = |leg: &usize| self.legs[*leg].deviation.value;
        (0..self.legs.len()).rev().max_by(|a, b| by(a).total_cmp(&by(b))).unwrap_or(0)
    }
}

/// Where a trajectory is at an instant, s.
fn place(trajectory: &Trajectory, mission: &Mission, at: f64) -> Place {
    let nodes = &trajectory.waypoint_nodes;
    let is_at = |&waypoint: &usize| {
        let arrival = nodes[waypoint];
        let held = usize::from(mission.waypoints[waypoint].hold > 0.0);
        let departure = (arrival + held).min(trajectory.intervals());
        let [from, to] = [arrival, departure].map(|node| trajectory.times[node]);
        (from - SAME_INSTANT..=to + SAME_INSTANT).contains(&at)
    };
    if let Some(waypoint) = (0..nodes.len()).find(is_at) {
        return Place::Waypoint(waypoint);
    }
    let reached = nodes.iter().filter(|&&node| trajectory.times[node] < at).count();
    Place::Leg(reached.saturating_sub(1).min(mission.legs.len() - 1))
}

fn leg_shape(trajectory: &Trajectory, mission: &Mission, leg: usize) -> LegShape {
    let [from, to] = [leg, leg + 1].map(|waypoint| mission.waypoints[waypoint].position);
    let position = |state: &NodeState| [X, Y, Z].map(|axis| state[axis][0]);
    let highest = from[Z].max(to[Z]);
    let capped = |[x, y, z]: [f64; 3]| [x, y, z.min(highest)];
    let over =
        |quantity: &dyn Fn(&NodeState) -> f64| peak_over(trajectory, leg_intervals(trajectory, mission, leg), quantity);
    LegShape {
        length: distance(from, to),
        climb: over(&|state| state[Z][0] - highest),
        deviation: over(&|state| distance_from_segment(position(state), [from, to])),
        aside: over(&|state| distance_from_segment(capped(position(state)), [from, to])),
    }
}

/// The distance of a point from the segment between two points, m.
pub fn distance_from_segment(p: [f64; 3], [a, b]: [[f64; 3]; 2]) -> f64 {
    let dot = |u: [f64; 3], v: [f64; 3]| (0..3).map(|i| u[i] * v[i]).sum::<f64>();
    let along: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
    let square = dot(along, along);
    let from_a: [f64; 3] = std::array::from_fn(|i| p[i] - a[i]);
    let share = if square > 0.0 { (dot(from_a, along) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, std::array::from_fn(|i| a[i] + share * along[i]))
}

fn turned(trajectory: &Trajectory, mission: &Mission) -> Option<Turned> {
    let is_given = |waypoint: usize| mission.waypoints[waypoint].heading == Heading::Given;
    let yaw = |waypoint: usize| mission.waypoints[waypoint].yaw;
    let legs = (0..mission.legs.len()).filter(|&leg| is_given(leg) && is_given(leg + 1));
    legs.map(|leg| Turned {
        turned: variation(trajectory, leg_intervals(trajectory, mission, leg)),
        required: (yaw(leg + 1) - yaw(leg)).abs(),
    })
    .reduce(|sum, leg| Turned { turned: sum.turned + leg.turned, required: sum.required + leg.required })
}

/// The total variation of the yaw over some intervals, rad.
fn variation(trajectory: &Trajectory, intervals: Range<usize>) -> f64 {
    let mut sum = 0.0;
    for k in intervals {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        let at = |t: f64| trajectory.within(k, t)[YAW];
        for step in 0..STEPS {
            let [mut low, mut high] = [step, step + 1].map(|i| h * i as f64 / STEPS as f64);
            let [begin, end] = [low, high].map(at);
            if begin[1] * end[1] >= 0.0 {
                sum += (end[0] - begin[0]).abs();
                continue;
            }
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (low + high);
                if at(middle)[1] * begin[1] > 0.0 { low = middle } else { high = middle }
            }
            let back = at(low)[0];
            sum += (back - begin[0]).abs() + (end[0] - back).abs();
        }
    }
    sum
}
