//! Rotors that lag behind their commands: rows on the commanded wrench.
//!
//! If every thrust follows its command with f_c = f + tau f', a wrench w(t) can be flown exactly where its commanded
//! wrench c = w + tau w' is admissible as w is (docs/method/rotor-lag.md). So each facet is imposed on c too.

use crate::actuation::Wrench;
use crate::model::Vehicle;
use crate::motion::hover_map::WrenchMap;
use crate::motion::time_grid::TimeGrid;
use crate::motion::{NodeState, with_slopes};
use crate::planner::transcription::Transcription;
use crate::planner::yaw::YawPlan;
use crate::qp::build::Affine;
use std::collections::BTreeMap;

/// The slope of the inputs to use at a node, where that slope, and with it w', jumps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slope {
    /// That of the interval that ends there.
    Before,
    /// That of the interval that begins there; between nodes the only one.
    After,
}

/// An instant (see `Transcription::parts`) and the slope to use there.
pub type CommandAt = (usize, Slope);

/// The interval whose slope is used; `None` before the first and after the last.
pub(super) fn interval_of((instant, slope): CommandAt, parts: usize, intervals: usize) -> Option<usize> {
    let (interval, part) = (instant / parts, instant % parts);
    match slope {
        Slope::Before if part == 0 => interval.checked_sub(1),
        Slope::Before => None,
        Slope::After => (interval < intervals).then_some(interval),
    }
}

/// The map of the commanded wrench at each place where rows on it can be imposed.
pub type CommandMaps = BTreeMap<CommandAt, WrenchMap>;

impl YawPlan {
    /// The commanded wrench of the hover model at both ends of every interval. `tau` is the time constant of the
    /// rotors, s.
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
    /// A derivative, or the slope of an input, at the place of a commanded wrench. `None` if there is no such interval.
    pub(super) fn command_derivative(&self, at: CommandAt, axis: usize, order: usize) -> Option<Affine> {
        let (instant, slope) = at;
        let interval = interval_of(at, self.parts, self.grid.intervals())?;
        let input = self.orders[axis];
        if order <= input {
            return Some(match slope == Slope::After && instant % self.parts == 0 {
                true => self.at_beginning(interval, axis, order),
                false => self.derivative(instant, axis, order),
            });
        }
        let h = self.grid.node_times[interval + 1] - self.grid.node_times[interval];
        let mut rise = self.at_node(interval + 1, axis, input);
        rise.add(&self.at_beginning(interval, axis, input), -1.0);
        Some(rise.times(1.0 / h))
    }

    /// The commanded wrench of states at a node, by the maps of [`Self::commands`]; `None` without them or without such
    /// an interval.
    pub(super) fn command_wrench(&self, states: &[NodeState], at: CommandAt) -> Option<Wrench> {
        let map = self.commands?.get(&at)?;
        let interval = interval_of(at, self.parts, self.grid.intervals())?;
        let h = self.grid.node_times[interval + 1] - self.grid.node_times[interval];
        let ends = [&states[interval], &states[interval + 1]];
        Some(map.at(&with_slopes(&states[at.0 / self.parts], ends, h, self.orders)))
    }
}
