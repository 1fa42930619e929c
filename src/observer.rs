//! Following a long run: its progress, and the time of each stage.

use crate::flight::Flight;
use crate::solve::Effort;
use std::time::{Duration, Instant};

/// Receives the progress of a run. Every method does nothing by default; threads may call them at the same time.
pub trait Observer: Sync {
    /// Work has started that `what` describes, for a line of progress.
    fn begins(&self, _what: &str) {}

    /// `planner` tries a mission time, s.
    fn tries(&self, _planner: &str, _time: f64) {}

    /// A stage such as `parse`, `model` or `plan` has ended.
    fn ended(&self, _stage: &str, _took: Duration) {}

    /// What the solver did in the stage that ended last.
    fn solved(&self, _effort: &Effort) {}

    /// A flight was simulated in `took`; `is_recorded` if a log or a page is made of it.
    fn flown(&self, _flight: &Flight, _took: Duration, _is_recorded: bool) {}

    /// A search for an explanation has ended: the number of variants of the spec that were planned, if they were counted, and
    /// what the solver did.
    fn asked(&self, _variants: Option<usize>, _effort: &Effort) {}
}

/// An observer that does nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {}

/// Runs a stage and reports how long it took.
pub fn timed<T>(observer: &dyn Observer, stage: &str, work: impl FnOnce() -> T) -> T {
    let begin = Instant::now();
    let value = work();
    observer.ended(stage, begin.elapsed());
    value
}
