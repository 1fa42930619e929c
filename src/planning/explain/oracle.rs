//! The interface to planners: oracle queries and answers.

use crate::model::Problem;

/// A part of a program to which multipliers can be assigned. Indices are those in [`crate::model::Model`] and
/// [`crate::model::Mission`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// `Mission::waypoints[i]`, its position and yaw.
    Waypoint(usize),
    RestAtStart,
    RestAtEnd,
    /// `Mission::limits[i]`
    Limit(usize),
    /// `Model::modes[i]`
    Mode(usize),
}

/// The answer of a planner for a mission at one mission time.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// It has a plan.
    Feasible,
    /// It proved that there is none.
    Infeasible {
        /// The weight of each part in the multipliers of the proof (>= 0; a part may occur more than once). Empty if
        /// there are no multipliers.
        weights: Vec<(Part, f64)>,
        /// Proved only for the facets that the RIP plan selects. (If RIP itself has no plan, nothing is selected.)
        only_for_selection: bool,
        /// Proved only on the grid of the spec's samples; false if it holds for every grid.
        only_for_samples: bool,
    },
    /// It found no plan and no proof; with the likely weight of each part, as above, if there is an estimate.
    NotFound(Vec<(Part, f64)>),
}

/// A planner as an oracle.
pub trait Oracle {
    /// Whether the problem's mission has a plan that takes `time` seconds, including holds, with the planner, the
    /// modes, the reserve and the samples of its `plan`, whose `time` is ignored.
    ///
    /// A limit without bounds is not a constraint, and neither is a waypoint whose tolerances are
    /// [`crate::planner::transcription::UNBOUNDED`] and whose weight is zero.
    fn ask(&mut self, problem: Problem, time: f64) -> Answer;

    /// The solver's work so far ([`crate::solve::Effort::work`]).
    fn work(&self) -> u64 {
        0
    }
}
