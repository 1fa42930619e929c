//! The decision of a planner on one mission time, in either model: a plan, a proof that there is none, or neither.

use crate::motion::time_grid::TimeGrid;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory};

/// The verdict of a planner on one mission time.
#[derive(Debug, Clone)]
pub enum Decision {
    /// A plan was found.
    Feasible(Box<Planned>),
    /// No plan exists, proved by multipliers that are checked in plain arithmetic or by a kinematic bound.
    Infeasible,
    /// No plan was found, and nothing was proved; the solver's status, or a clause for people.
    Inconclusive(String),
}

impl Decision {
    /// The plan, if one was found.
    pub fn planned(&self) -> Option<&Planned> {
        match self {
            Decision::Feasible(planned) => Some(planned),
            Decision::Infeasible | Decision::Inconclusive(_) => None,
        }
    }
}

/// A plan at one mission time: optimal in the hover model, a local optimum in the exact one.
#[derive(Debug, Clone)]
pub struct Planned {
    pub grid: TimeGrid,
    /// The model of the wrench that the plan was made with.
    pub model: WrenchModel,
    /// At every node, both ends of each hold included, SI units.
    pub states: Vec<NodeState>,
    /// Value of (48).
    pub objective: f64,
    /// Rows in the last program (facets and limits, each at one node).
    pub rows: usize,
}

impl Planned {
    /// The plan as polynomials between its nodes, with pieces that join.
    pub fn trajectory(&self) -> Trajectory {
        let at_nodes = Trajectory {
            times: self.grid.node_times.clone(),
            nodes: self.states.clone(),
            waypoint_nodes: self.grid.waypoint_nodes.clone(),
            model: self.model,
        };
        at_nodes.joined()
    }
}
