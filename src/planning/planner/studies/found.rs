//! The result of one search for a shortest time.

use crate::planner::timing::search::{Hint, NoTime, Shortest};
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
use crate::solve::Effort;

/// The result of a search with what later searches can use.
#[derive(Clone)]
pub(super) struct Found {
    pub result: Result<Shortest, NoTime>,
    /// Rows that bound in it.
    pub working_set: WorkingSet,
    pub effort: Effort,
}

impl Found {
    /// The plan at the shortest time.
    pub fn planned(&self) -> Option<&Planned> {
        self.result.as_ref().ok().map(|s| &s.planned)
    }

    /// The shortest time, s.
    pub fn time(&self) -> Option<f64> {
        self.result.as_ref().ok().map(|s| s.time)
    }

    /// The shorter time that was proved infeasible, s.
    pub fn time_below(&self) -> Option<f64> {
        self.result.as_ref().ok()?.infeasible_at
    }
}

/// What the search for the shortest time can use of a decision at T_d.
pub(super) fn hint_from(at: f64, decision: Decision) -> Hint {
    match decision {
        Decision::Feasible(planned) => Hint { feasible: Some(at), planned: Some(planned), ..Hint::default() },
        _ => Hint { near: Some(at), ..Hint::default() },
    }
}
