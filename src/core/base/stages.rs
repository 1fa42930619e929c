//! The times of the stages of a run.

use std::time::{Duration, Instant};

/// Receives the time of each stage of a run; does nothing by default. Threads may call it at the same time.
pub trait Stages: Sync {
    /// A stage such as `parse`, `model` or `plan` has ended.
    fn ended(&self, _stage: &str, _took: Duration) {}
}

/// Does nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Stages for Silent {}

/// Runs a stage and reports how long it took.
pub fn timed<T, S: Stages + ?Sized>(stages: &S, stage: &str, work: impl FnOnce() -> T) -> T {
    let begin = Instant::now();
    let value = work();
    stages.ended(stage, begin.elapsed());
    value
}
