//! An iterate over a mission without its holds, and how changes of durations act on it.

use super::PARTS;
use crate::motion::time_grid::TimeGrid;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, state_between};

/// Derivatives at the nodes of a time grid without holds.
#[derive(Debug, Clone)]
pub struct Iterate {
    pub grid: TimeGrid,
    /// At every node, SI units.
    pub states: Vec<NodeState>,
    pub model: WrenchModel,
}

/// Derivatives of order m times `factor`^-m.
fn slower(state: &NodeState, factor: f64) -> NodeState {
    state.map(|axis| std::array::from_fn(|order| axis[order] * factor.powi(-(order as i32))))
}

impl Iterate {
    /// This iterate as a trajectory from 0 s on.
    pub fn trajectory(&self) -> Trajectory {
        Trajectory {
            times: self.grid.node_times.clone(),
            nodes: self.states.clone(),
            waypoint_nodes: self.grid.waypoint_nodes.clone(),
            model: self.model,
        }
    }

    /// The derivatives at an instant; see `Transcription::parts`.
    pub fn at(&self, instant: usize) -> NodeState {
        let (interval, part) = (instant / PARTS, instant % PARTS);
        if part == 0 {
            return self.states[interval];
        }
        let times = &self.grid.node_times;
        let h = times[interval + 1] - times[interval];
        let t = h * part as f64 / PARTS as f64;
        state_between(&self.states[interval], &self.states[interval + 1], h, t, self.model)
    }

    /// The derivatives a share of the way through an interval.
    pub fn inside(&self, interval: usize, share: f64) -> NodeState {
        let times = &self.grid.node_times;
        let h = times[interval + 1] - times[interval];
        state_between(&self.states[interval], &self.states[interval + 1], h, share * h, self.model)
    }

    /// This path in its shares of time, `factor` times slower.
    pub fn slower(&self, factor: f64) -> Iterate {
        Iterate {
            grid: self.grid.with_durations_times(|_| factor),
            states: self.states.iter().map(|s| slower(s, factor)).collect(),
            model: self.model,
        }
    }

    /// The iterate that a step leads to: `states` belong to the old durations, and each leg's duration changes by its
    /// relative change. Where legs change by different shares the pieces join at waypoints to first order only (72).
    pub fn stepped(&self, states: &[NodeState], changes: &[f64]) -> Iterate {
        let mut changed = states.to_vec();
        for s in &self.grid.segments {
            // A waypoint's node belongs to the leg that ends there.
            let first = if s.first_node == 0 { 0 } else { s.first_node + 1 };
            for state in &mut changed[first..=s.first_node + s.intervals] {
                *state = slower(state, 1.0 + changes[s.from]);
            }
        }
        Iterate { grid: self.grid.with_durations_times(|leg| 1.0 + changes[leg]), states: changed, model: self.model }
    }

    /// Whether each interval ends with the derivatives below the input's at which the next begins, to `within` of their
    /// largest size (of 1 in SI units where that is more). Not so after [`Self::stepped`] with legs that changed by
    /// different shares.
    pub fn is_joined(&self, within: f64) -> bool {
        let times = &self.grid.node_times;
        let largest =
            |axis: usize, order: usize| self.states.iter().fold(1.0, |most, s| f64::max(most, s[axis][order].abs()));
        let allowed: [[f64; 5]; 4] =
            std::array::from_fn(|axis| std::array::from_fn(|order| within * largest(axis, order)));
        self.states.windows(2).zip(times.windows(2)).all(|(pair, t)| {
            let h = t[1] - t[0];
            let reached = state_between(&pair[0], &pair[1], h, h, self.model);
            let same =
                |axis: usize, order: usize| (reached[axis][order] - pair[1][axis][order]).abs() <= allowed[axis][order];
            self.model.orders().iter().enumerate().all(|(axis, &input)| (0..input).all(|order| same(axis, order)))
        })
    }

    /// This time grid with other states.
    pub fn with_states(&self, states: Vec<NodeState>) -> Iterate {
        Iterate { grid: self.grid.clone(), states, model: self.model }
    }

    /// The iterate with the smallest changes of inputs that make its pieces join ([`Trajectory::joined`]).
    pub fn with_joined_pieces(&self) -> Iterate {
        self.with_states(self.trajectory().joined().nodes)
    }

    /// `share` of the way from this iterate's states to others at the same nodes.
    pub fn towards(&self, states: &[NodeState], share: f64) -> Vec<NodeState> {
        let blend = |from: &NodeState, to: &NodeState| -> NodeState {
            std::array::from_fn(|axis| std::array::from_fn(|m| from[axis][m] + share * (to[axis][m] - from[axis][m])))
        };
        self.states.iter().zip(states).map(|(from, to)| blend(from, to)).collect()
    }

    /// This path interpolated at the nodes of another time grid, at the same shares of each leg's duration.
    pub fn on(&self, grid: &TimeGrid) -> Iterate {
        let trajectory = self.trajectory();
        let mut states = Vec::with_capacity(grid.nodes());
        for (mine, other) in self.grid.segments.iter().zip(&grid.segments) {
            let begin = self.grid.node_times[mine.first_node];
            let there = grid.node_times[other.first_node];
            let factor = other.duration / mine.duration;
            let first = if states.is_empty() { 0 } else { 1 };
            for i in first..=other.intervals {
                let t = begin + (grid.node_times[other.first_node + i] - there) / factor;
                states.push(slower(&trajectory.at(t), factor));
            }
        }
        Iterate { grid: grid.clone(), states, model: self.model }
    }
}
