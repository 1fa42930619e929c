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
