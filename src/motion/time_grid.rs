//! When each waypoint is reached, and which node that is.

use crate::model::Mission;
use crate::model::grid::{Spacing, leg_durations, pieces};

/// A leg, or a hold at a waypoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The waypoint it starts from; for a hold also the one it ends at.
    pub from: usize,
    pub hold: bool,
    pub first_node: usize,
    pub intervals: usize,
    /// s
    pub duration: f64,
    pub spacing: Spacing,
    /// The duration for which the nodes were spaced, s. Where the duration changes the nodes keep their shares of it.
    pub spaced_for: f64,
}

impl Segment {
    pub fn leg_grid(&self) -> LegGrid {
        LegGrid { duration: self.duration, intervals: self.intervals, spaced_for: self.spaced_for }
    }

    /// The start of an interval, s after the start of the segment.
    fn start_of(&self, nth: usize) -> f64 {
        match self.spacing {
            Spacing::Even => Spacing::Even.start_of(self.duration, nth, self.intervals),
            Spacing::Graded => {
                self.duration / self.spaced_for * Spacing::Graded.start_of(self.spaced_for, nth, self.intervals)
            }
        }
    }

    /// Length of each interval, s.
    fn steps(&self) -> impl Iterator<Item = f64> {
        (0..self.intervals).map(|i| match self.spacing {
            Spacing::Even => self.duration / self.intervals as f64,
            Spacing::Graded => self.start_of(i + 1) - self.start_of(i),
        })
    }
}

/// How one leg is cut into pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegGrid {
    /// s
    pub duration: f64,
    pub intervals: usize,
    /// [`Segment::spaced_for`], s
    pub spaced_for: f64,
}

impl LegGrid {
    pub fn new(duration: f64, intervals: usize) -> Self {
        LegGrid { duration, intervals, spaced_for: duration }
    }
}

/// Times of nodes and waypoints for one mission time.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeGrid {
    /// Mission time, s.
    pub total: f64,
    pub segments: Vec<Segment>,
    /// s; one more than there are intervals.
    pub node_times: Vec<f64>,
    /// Node at which each waypoint is reached.
    pub waypoint_nodes: Vec<usize>,
}

impl TimeGrid {
    pub fn nodes(&self) -> usize {
        self.node_times.len()
    }

    pub fn intervals(&self) -> usize {
        self.node_times.len() - 1
    }

    /// Length of each interval, s.
    pub fn steps(&self) -> impl Iterator<Item = f64> {
        self.segments.iter().flat_map(Segment::steps)
    }

    /// The same mission without its holds: each shrinks to one node, at which all derivatives vanish. Nothing changes in
    /// a hold, so programs leave them out.
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

    /// What is said of the nodes of [`TimeGrid::flown`], for all nodes: both ends of a hold are alike.
    pub fn with_holds<T: Clone>(&self, of_flown: &[T]) -> Vec<T> {
        (0..self.nodes()).map(|node| of_flown[node - self.holds_before(node)].clone()).collect()
    }

    /// What is said of all nodes, for those of [`TimeGrid::flown`].
    pub fn without_holds<T: Clone>(&self, of_all: &[T]) -> Vec<T> {
        (0..self.nodes()).filter(|&node| !self.ends_a_hold(node)).map(|node| of_all[node].clone()).collect()
    }

    /// The same nodes with the duration of each leg (by the waypoint it starts from) times a factor; holds stay as they are.
    pub fn with_durations_times(&self, factor: impl Fn(usize) -> f64) -> TimeGrid {
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

    /// Holds that end at or before a node.
    fn holds_before(&self, node: usize) -> usize {
        self.segments.iter().filter(|s| s.hold && s.first_node < node).count()
    }

    fn ends_a_hold(&self, node: usize) -> bool {
        self.segments.iter().any(|s| s.hold && s.first_node + 1 == node)
    }
}

impl TimeGrid {
    /// The mission with the grids of its legs, in order, and the mission's holds; `total` is the sum of durations, s, to the
    /// last digit.
    pub fn with_legs(mission: &Mission, legs: &[LegGrid], total: f64) -> TimeGrid {
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

    /// Times of nodes and waypoints; `first_node` is filled in.
    fn of_segments(mission: &Mission, mut segments: Vec<Segment>, total: f64) -> TimeGrid {
        let mut node_times = vec![0.0];
        let mut waypoint_nodes = vec![0];
        let mut begin = 0.0;
        for s in &mut segments {
            s.first_node = node_times.len() - 1;
            node_times.extend((1..=s.intervals).map(|i| begin + s.start_of(i)));
            begin += s.duration;
            if !s.hold {
                // A time that the spec fixes is met to the last digit.
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

/// The mission time that fixed times and holds determine, where they do.
pub fn determined(mission: &Mission) -> Option<f64> {
    let last = mission.waypoints.last()?;
    last.time.map(|t| t + last.hold)
}

/// Every mission time must exceed this: fixed times and holds up to the last of them, s.
pub fn earliest(mission: &Mission) -> f64 {
    let mut at = 0.0;
    for w in &mission.waypoints {
        at = w.time.unwrap_or(at) + w.hold;
    }
    at
}

/// Whether the spec says when some waypoint after the first is reached.
pub fn has_fixed_times(mission: &Mission) -> bool {
    mission.waypoints.iter().skip(1).any(|w| w.time.is_some())
}

/// Lays out the mission over `total` seconds with `samples` intervals: one for each hold, at least one for each leg
/// ([`Mission::least_intervals`] where there are enough).
///
/// Between fixed times, what holds leave is shared among the legs in proportion to [`crate::model::Leg::share`].
/// `None` where some leg would get no time.
pub fn time_grid(mission: &Mission, total: f64, samples: usize) -> Option<TimeGrid> {
    let durations = leg_durations(mission, total)?;
    let intervals = pieces(mission, &durations, samples);
    let legs: Vec<LegGrid> = durations.into_iter().zip(intervals).map(|(d, n)| LegGrid::new(d, n)).collect();
    Some(TimeGrid::with_legs(mission, &legs, total))
}
