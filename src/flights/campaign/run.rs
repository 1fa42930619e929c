//! Simulates cases in parallel, with results in the order of the cases.

use super::cases::{Case, noise_seed};
use super::design::Design;
use super::rows::Row;
use crate::flight::{Sortie, WaysOut, fly};
use crate::model::{Problem, Strike};
use crate::recovery::flown_way_out;
use crate::source::Span;
use rayon::prelude::*;

/// Flights in a chunk for each thread: enough to balance flights that end early, and few enough that an interrupted
/// campaign loses little.
const CHUNK: usize = 16;

/// A flight continues for at least this long after the fault, s, in hover after the end of the mission: a vehicle that
/// is falling when the mission ends has not survived.
pub const AFTERMATH: f64 = 3.0;

/// Simulates one case.
pub fn fly_case(design: &Design, case: &Case) -> Row {
    let strikes: Vec<Strike> = case
        .strike
        .map(|s| Strike {
            mode: s.mode,
            at: design.fault_time(s.time),
            until: None,
            span: Span::default(),
            at_span: Span::default(),
        })
        .into_iter()
        .collect();
    let seed = noise_seed(design.model.campaign.seed, case.seed);
    let mut sortie = Sortie::along(design.model, &design.plan(case).trajectory, &strikes, seed);
    let plan = &design.plan(case).trajectory;
    let find = |mode: usize, at: f64, known: f64| flown_way_out(Problem::of(design.model)?, plan, mode, at, known);
    sortie.ways_out = Some(WaysOut { find: &find });
    // A shorter simulation would end before the later faults.
    sortie.duration = sortie.duration.max(design.time);
    if let Some(strike) = strikes.first().filter(|_| design.plan(case).trajectory.ends_at_rest()) {
        sortie.duration = sortie.duration.max(strike.at + AFTERMATH);
    }
    Row::new(design, case, &fly(&sortie, None))
}

/// Simulates cases and passes their rows to `take` in order, a chunk at a time.
///
/// # Errors
/// The first error of `take`, which ends the run.
pub fn fly_all<E>(
    design: &Design,
    cases: impl Iterator<Item = Case>,
    mut take: impl FnMut(&[Case], &[Row]) -> Result<(), E>,
) -> Result<(), E> {
    let size = CHUNK * rayon::current_num_threads();
    let mut cases = cases.peekable();
    while cases.peek().is_some() {
        let chunk: Vec<Case> = cases.by_ref().take(size).collect();
        let rows: Vec<Row> = chunk.par_iter().map(|case| fly_case(design, case)).collect();
        take(&chunk, &rows)?;
    }
    Ok(())
}
