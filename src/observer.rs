//! Following a long run: what it does now, and how long each stage took.

use crate::flight::Flight;
use crate::solve::Effort;
use std::time::{Duration, Instant};

/// Receives the progress of a run. Every method does nothing by default; threads may call them at the same time.
pub trait Observer: Sync {
    /// Work of this kind has begun, for a line of progress.
    fn begins(&self, _what: &str) {}

    /// `planner` tries a mission time, s.
    fn tries(&self, _planner: &str, _time: f64) {}

    /// A stage such as `parse`, `model` or `plan` has ended.
    fn ended(&self, _stage: &str, _took: Duration) {}

    /// What the solver did in the stage that ended last.
    fn solved(&self, _effort: &Effort) {}

    /// A flight took `took`; `is_recorded` with a log or a page.
    fn flown(&self, _flight: &Flight, _took: Duration, _is_recorded: bool) {}

    /// What a search for an explanation took: the variants of the spec that were planned, where they were counted, and what the
    /// solver did.
    fn asked(&self, _variants: Option<usize>, _effort: &Effort) {}
}

/// Follows nothing.
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
