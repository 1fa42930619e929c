//! The time grid: node times, and the node at which each waypoint is reached (`docs/method/hover-model.md`, "Waypoint
//! times").

use crate::model::Mission;
use crate::model::grid::{Spacing, leg_durations, pieces};

/// A leg between two waypoints, or a hold at a waypoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Index of the waypoint at which the segment starts; a hold also ends there.
    pub from: usize,
    /// Whether the segment is a hold.
    pub hold: bool,
    /// Index of its first node.
    pub first_node: usize,
    /// Number of intervals; 1 for a hold.
    pub intervals: usize,
    /// Duration, s.
    pub duration: f64,
    /// How the nodes are spaced.
    pub spacing: Spacing,
    /// The duration for which the nodes were spaced, s. If the duration changes, the nodes keep their shares of it.
    pub spaced_for: f64,
}

impl Segment {
    /// The grid of this segment as a leg.
    pub(crate) fn leg_grid(&self) -> LegGrid {
        LegGrid { duration: self.duration, intervals: self.intervals, spaced_for: self.spaced_for }
    }

    /// The start of interval `nth`, s after the start of the segment.
    fn start_of(&self, nth: usize) -> f64 {
        match self.spacing {
            Spacing::Even => Spacing::Even.start_of(self.duration, nth, self.intervals),
            Spacing::Graded => {
                self.duration / self.spaced_for * Spacing::Graded.start_of(self.spaced_for, nth, self.intervals)
            }
        }
    }

    /// The length of each interval, s.
    fn steps(&self) -> impl Iterator<Item = f64> {
        (0..self.intervals).map(|i| match self.spacing {
            Spacing::Even => self.duration / self.intervals as f64,
            Spacing::Graded => self.start_of(i + 1) - self.start_of(i),
        })
    }
}

/// How one leg is divided into intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegGrid {
    /// Duration of the leg, s.
    pub duration: f64,
    /// Number of intervals.
    pub intervals: usize,
    /// [`Segment::spaced_for`], s.
    pub spaced_for: f64,
}

impl LegGrid {
    /// The grid of a leg with nodes spaced for its duration (s).
    pub fn new(duration: f64, intervals: usize) -> Self {
        LegGrid { duration, intervals, spaced_for: duration }
    }
}

/// The times of nodes and waypoints for one mission time.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeGrid {
    /// Mission time, s.
    pub total: f64,
    /// Legs and holds, in their order in time.
    pub segments: Vec<Segment>,
    /// Times of the nodes, s, ascending; one more than there are intervals.
    pub node_times: Vec<f64>,
    /// The node at which each waypoint is reached.
    pub waypoint_nodes: Vec<usize>,
}

impl TimeGrid {
    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.node_times.len()
    }

    /// The number of intervals.
    pub fn intervals(&self) -> usize {
        self.node_times.len() - 1
    }

    /// The length of each interval, s.
    pub fn steps(&self) -> impl Iterator<Item = f64> {
        self.segments.iter().flat_map(Segment::steps)
    }

    /// The grid without its holds: each is reduced to one node, at which all derivatives vanish. Programs leave holds
    /// out because nothing changes in them.
    pub fn flown(&self) -> TimeGrid {
        let mut segments: Vec<Segment> = self.segments.iter().filter(|s| !s.hold).copied().collect();
        for s in &mut segments {
            s.first_node -= self.holds_before(s.first_node);
        }
        let mut node_times: Vec<f64> = Vec::new();
        for (node, time) in self.node_times.iter().enumerate() {
            if !self.ends_a_hold(node) {
                let held = self.segments.iter().filter(|s| s.hold && s.first_node < node);
                node_times.push(time - held.map(|s| s.duration).sum::<f64>());
            }
        }
        let waypoint_nodes = self.waypoint_nodes.iter().map(|&n| n - self.holds_before(n)).collect();
        TimeGrid { total: node_times[node_times.len() - 1], segments, node_times, waypoint_nodes }
    }

    /// Extends values at the nodes of [`TimeGrid::flown`] to all nodes; both ends of a hold have the same value.
    pub(crate) fn with_holds<T: Clone>(&self, of_flown: &[T]) -> Vec<T> {
        (0..self.nodes()).map(|node| of_flown[node - self.holds_before(node)].clone()).collect()
    }

    /// Restricts values at all nodes to the nodes of [`TimeGrid::flown`].
    pub fn without_holds<T: Clone>(&self, of_all: &[T]) -> Vec<T> {
        (0..self.nodes()).filter(|&node| !self.ends_a_hold(node)).map(|node| of_all[node].clone()).collect()
    }

    /// The grid with the duration of each leg multiplied by a factor. `factor` takes the index of the waypoint at which
    /// the leg starts. Holds keep their durations.
    pub(crate) fn with_durations_times(&self, factor: impl Fn(usize) -> f64) -> TimeGrid {
        let mut changed = self.clone();
        for (old, s) in self.segments.iter().zip(&mut changed.segments) {
            if !s.hold {
                s.duration *= factor(s.from);
            }
            let begin = changed.node_times[s.first_node];
            for i in 1..=s.intervals {
                changed.node_times[old.first_node + i] = begin + s.start_of(i);
            }
        }
        changed.total = changed.node_times[changed.node_times.len() - 1];
        changed
    }

    /// The number of holds that end at or before a node.
    fn holds_before(&self, node: usize) -> usize {
        self.segments.iter().filter(|s| s.hold && s.first_node < node).count()
    }

    fn ends_a_hold(&self, node: usize) -> bool {
        self.segments.iter().any(|s| s.hold && s.first_node + 1 == node)
    }
}

impl TimeGrid {
    /// The grid of a mission from the grids of its legs, in order, and the mission's holds. `total` is the mission time
    /// (s); the last node is placed there exactly.
    pub(crate) fn with_legs(mission: &Mission, legs: &[LegGrid], total: f64) -> TimeGrid {
        let mut segments = Vec::new();
        let spacing = mission.spacing;
        for (i, w) in mission.waypoints.iter().enumerate() {
            if w.hold > 0.0 {
                let (duration, spaced_for) = (w.hold, w.hold);
                segments.push(Segment {
                    from: i,
                    hold: true,
                    first_node: 0,
                    intervals: 1,
                    duration,
                    spacing,
                    spaced_for,
                });
            }
            if let Some(&LegGrid { duration, intervals, spaced_for }) = legs.get(i) {
                segments.push(Segment {
                    from: i,
                    hold: false,
                    first_node: 0,
                    intervals,
                    duration,
                    spacing,
                    spaced_for,
                });
            }
        }
        TimeGrid::of_segments(mission, segments, total)
    }

    /// The grid of these segments, whose `first_node` is computed here.
    fn of_segments(mission: &Mission, mut segments: Vec<Segment>, total: f64) -> TimeGrid {
        let mut node_times = vec![0.0];
        let mut waypoint_nodes = vec![0];
        let mut begin = 0.0;
        for s in &mut segments {
            s.first_node = node_times.len() - 1;
            node_times.extend((1..=s.intervals).map(|i| begin + s.start_of(i)));
            begin += s.duration;
            if !s.hold {
                // A time that the spec fixes is met exactly.
                begin = mission.waypoints[s.from + 1].time.unwrap_or(begin);
                waypoint_nodes.push(node_times.len() - 1);
            }
            node_times[s.first_node + s.intervals] = begin;
        }
        if let Some(end) = node_times.last_mut() {
            *end = total;
        }
        TimeGrid { total, segments, node_times, waypoint_nodes }
    }
}

/// The mission time (s) if the spec determines it, that is, if the time of the last waypoint is fixed.
pub fn determined(mission: &Mission) -> Option<f64> {
    let last = mission.waypoints.last()?;
    last.time.map(|t| t + last.hold)
}

/// The lower bound (s) that every mission time must exceed: the last fixed time and all holds after it.
pub fn earliest(mission: &Mission) -> f64 {
    let mut at = 0.0;
    for w in &mission.waypoints {
        at = w.time.unwrap_or(at) + w.hold;
    }
    at
}

/// The grid of a mission over `total` seconds with `samples` intervals: one for each hold and at least one for each leg
/// ([`Mission::least_intervals`] if there are enough).
///
/// Between fixed times the time without holds is shared among the legs in proportion to [`crate::model::Leg::share`].
/// `None` if some leg would get no time.
pub fn time_grid(mission: &Mission, total: f64, samples: usize) -> Option<TimeGrid> {
    let durations = leg_durations(mission, total)?;
    let intervals = pieces(mission, &durations, samples);
    let legs: Vec<LegGrid> = durations.into_iter().zip(intervals).map(|(d, n)| LegGrid::new(d, n)).collect();
    Some(TimeGrid::with_legs(mission, &legs, total))
}
