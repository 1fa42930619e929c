//! Rotors that lag behind their commands: rows on the lead wrench.
//!
//! Where every thrust follows its command with f_c = f + tau f', a path w(t) of the wrench can be flown exactly where its
//! lead wrench c = w + tau w' stays admissible as w does (docs/method.md, section 14). So each facet stands for c too.

use crate::actuation::Wrench;
use crate::model::Vehicle;
use crate::motion::hover_map::WrenchMap;
use crate::motion::time_grid::TimeGrid;
use crate::motion::{NodeState, with_slopes};
use crate::planner::transcription::Transcription;
use crate::planner::yaw::YawPlan;
use crate::qp::build::Affine;
use std::collections::BTreeMap;

/// At a node the inputs bend, and w' jumps: which slope of theirs is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slope {
    /// That of the interval which ends there.
    Before,
    /// That of the interval which begins there; between nodes the only one.
    After,
}

/// An instant (see `Transcription::parts`) and the slope meant there.
pub type CommandAt = (usize, Slope);

/// The interval whose slope is meant; `None` before the first and after the last.
pub(super) fn interval_of((instant, slope): CommandAt, parts: usize, intervals: usize) -> Option<usize> {
    let (interval, part) = (instant / parts, instant % parts);
    match slope {
        Slope::Before if part == 0 => interval.checked_sub(1),
        Slope::Before => None,
        Slope::After => (interval < intervals).then_some(interval),
    }
}

/// The lead wrench where rows on it can stand.
pub type CommandMaps = BTreeMap<CommandAt, WrenchMap>;

impl YawPlan {
    /// The lead wrench of the hover model at both ends of every interval.
    pub fn commands(&self, vehicle: &Vehicle, gravity: f64, grid: &TimeGrid, tau: f64) -> CommandMaps {
        let map = |node: usize, jerk: f64| match self {
            YawPlan::Free { psi } => WrenchMap::commanded_with_free_yaw(vehicle, gravity, *psi, tau),
            YawPlan::Frozen(states) => WrenchMap::commanded(vehicle, gravity, states[node], jerk, tau),
        };
        let ends = |(interval, step): (usize, f64)| {
            let jerk = match self {
                YawPlan::Free { .. } => 0.0,
                YawPlan::Frozen(states) => (states[interval + 1].acceleration - states[interval].acceleration) / step,
            };
            [((interval, Slope::After), map(interval, jerk)), ((interval + 1, Slope::Before), map(interval + 1, jerk))]
        };
        grid.steps().enumerate().flat_map(ends).collect()
    }
}

impl Transcription<'_> {
    /// A derivative, or the slope of an input, where a lead wrench is taken; `bend` is what derivatives (node, axis, order)
    /// have more on the later side of their node. `None` where there is no such interval.
    pub(super) fn command_derivative(
        &self,
        at: CommandAt,
        (axis, order): (usize, usize),
        jump: &dyn Fn(usize, usize, usize) -> Affine,
    ) -> Option<Affine> {
        let (instant, slope) = at;
        let interval = interval_of(at, self.parts, self.grid.intervals())?;
        let input = self.orders[axis];
        if order <= input {
            let mut derivative = self.derivative(instant, axis, order);
            if slope == Slope::After && instant % self.parts == 0 {
                derivative.add(&jump(interval, axis, order), 1.0);
            }
            return Some(derivative);
        }
        let h = self.grid.node_times[interval + 1] - self.grid.node_times[interval];
        let mut rise = self.at_node(interval + 1, axis, input);
        rise.add(&self.at_node(interval, axis, input), -1.0);
        rise.add(&jump(interval, axis, input), -1.0);
        Some(rise.times(1.0 / h))
    }

    /// The lead wrench of states at a node, by the maps of [`Self::commands`]; `None` without them or without such an
    /// interval.
    pub(super) fn command_wrench(&self, states: &[NodeState], at: CommandAt) -> Option<Wrench> {
        let map = self.commands?.get(&at)?;
        let interval = interval_of(at, self.parts, self.grid.intervals())?;
        let h = self.grid.node_times[interval + 1] - self.grid.node_times[interval];
        let ends = [&states[interval], &states[interval + 1]];
        Some(map.at(&with_slopes(&states[at.0 / self.parts], ends, h, self.orders)))
    }
}
