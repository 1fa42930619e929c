//! Following a long run: its progress, and the time of each stage.

use crate::flight::Flight;
use crate::solve::Effort;
use std::time::Duration;

pub use mavc_verify::stages::{Silent, Stages, timed};

/// Receives the progress of a run, and by [`Stages::ended`] the time of each stage. Every method does nothing by
/// default; threads may call them at the same time.
pub trait Observer: Stages {
    /// Work has started that `what` describes, for a line of progress.
    fn begins(&self, _what: &str) {}

    /// `planner` tries a mission time, s.
    fn tries(&self, _planner: &str, _time: f64) {}

    /// What the solver did in the stage that ended last.
    fn solved(&self, _effort: &Effort) {}

    /// A flight was simulated in `took`; `is_recorded` if a log or a page is made of it.
    fn flown(&self, _flight: &Flight, _took: Duration, _is_recorded: bool) {}

    /// A search for an explanation has ended: the number of variants of the spec that were planned, if they were
    /// counted, and what the solver did.
    fn asked(&self, _variants: Option<usize>, _effort: &Effort) {}
}

impl Observer for Silent {}

/// The names by which [`Observer::tries`] calls the planners.
pub const PLANNERS: [&str; 3] = ["RIP", "RCP", "RSP"];

/// The time (s) for which a plan is sought, for a line of progress; a plan of another planner on the way to the one
/// that is wanted is called so.
pub fn attempt(wanted: Option<&str>, planner: &str, time: f64) -> String {
    let other = wanted.filter(|wanted| *wanted != planner && PLANNERS.contains(&planner));
    match other {
        Some(wanted) => format!("{wanted}: trying {time:.2} s, first with {planner}"),
        None => format!("{planner}: trying {time:.2} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attempts_name_the_planner_that_is_wanted() {
        assert_eq!(attempt(Some("RSP"), "RSP", 35.0), "RSP: trying 35.00 s");
        assert_eq!(attempt(Some("RSP"), "RCP", 35.0), "RSP: trying 35.00 s, first with RCP");
        assert_eq!(attempt(Some("RSP"), "round 2", 35.0), "round 2: trying 35.00 s");
        assert_eq!(attempt(None, "RCP", 35.0), "RCP: trying 35.00 s");
    }
}
