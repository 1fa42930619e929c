//! What is asked of a planner.

use crate::model::{Mission, Model};

/// Something that a plan meets, as far as multipliers can weigh it. Places are those in [`Model`] and [`Mission`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// `Mission::waypoints[i]`, its place and its yaw.
    Waypoint(usize),
    RestAtStart,
    RestAtEnd,
    /// `Mission::limits[i]`
    Limit(usize),
    /// `Model::modes[i]`
    Mode(usize),
}

/// What a planner says of a mission at one mission time.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// It has a plan.
    Feasible,
    /// It has shown that there is none.
    Infeasible {
        /// What each part weighs in the multipliers that show it (>= 0; a part may be named more than once). Empty where there
        /// are no multipliers.
        weights: Vec<(Part, f64)>,
        /// Shown only of the facets that the RIP plan selects. (Where RIP itself has no plan nothing is selected.)
        of_selection: bool,
        /// Shown on the grid of the spec's samples; false where it holds for every grid.
        of_samples: bool,
    },
    /// It has found no plan, and not shown that there is none; with what each part is likely to weigh, as above, where
    /// something tells.
    NotFound(Vec<(Part, f64)>),
}

/// A planner, asked for plans.
pub trait Oracle {
    /// Whether `mission` has a plan that takes `time` seconds, holds included, by the planner, the modes, the reserve
    /// and the samples of `model.plan`; its `time` and the mission of `model` count for nothing.
    ///
    /// A limit without bounds, and a waypoint whose tolerances are [`crate::planner::transcription::UNBOUNDED`] and whose
    /// weight is zero, ask for nothing.
    fn ask(&mut self, model: &Model, mission: &Mission, time: f64) -> Answer;
}
