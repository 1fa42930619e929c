//! Flying the cases of a campaign that are not flown yet.

use super::output::{Output, Stop};
use crate::campaign::cases::Shard;
use crate::campaign::design::Design;
use crate::campaign::run::fly_all;
use crate::campaign::tally::Tally;
use crate::cli::progress::Flights;
use crate::cli::signals::Saying;
use crate::cli::target::Target;
use crate::cli::{CommandError, Options, files};
use crate::source::visible;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Flies the cases that have no row yet. `None`: the reader of the rows has gone away.
pub fn fly(
    design: &Design,
    shard: Shard,
    rows: Option<&Target>,
    options: &Options,
) -> Result<Option<Tally>, CommandError> {
    let (mut output, mut tally) = Output::open(rows, design, shard)?;
    // Rows of an earlier run do not count towards the speed.
    let begin = Instant::now();
    let (done, all) = (tally.flights(), shard.count(design.cases.count()));
    if done > 0 && !options.quiet {
        files::eprint(&if output.is_complete() {
            format!("mavc: {}: all {all} flights are there, nothing to fly\n", visible::line(&output.name()))
        } else {
            format!("mavc: {}: continuing after {done} of {all} flights\n", visible::line(&output.name()))
        });
    }
    let progress = Flights::new(options, done, all);
    let kept = Arc::new(AtomicUsize::new(done));
    let _saying = Saying::new(farewell(&output, kept.clone(), all));
    let flown = fly_all(design, design.cases.of(shard).skip(done), |cases, rows| {
        let lines: String = rows.iter().map(|row| row.line() + "\n").collect();
        output.add(&lines)?;
        cases.iter().zip(rows).for_each(|(case, row)| tally.add(case, row));
        progress.more(rows.len());
        kept.fetch_add(rows.len(), Ordering::Relaxed);
        Ok(())
    });
    progress.done();
    match flown.and_then(|()| output.finish()) {
        Ok(()) => {}
        Err(Stop::ReaderGone) => return Ok(None),
        Err(Stop::Failed(problem)) => return Err(problem),
    }
    if options.timings {
        files::eprint(&format!("{:<10} {:>9.2} ms\n", "fly", begin.elapsed().as_secs_f64() * 1e3));
    }
    if options.timings {
        let flights = all - done;
        let rate = flights as f64 / begin.elapsed().as_secs_f64();
        files::eprint(&format!("{:<10} {flights} flights, {rate:.1} a second\n", ""));
    }
    Ok(Some(tally))
}

/// The message on Ctrl-C.
fn farewell(output: &Output, kept: Arc<AtomicUsize>, all: usize) -> impl Fn() -> String + Send + 'static {
    let part = output.part().map(|part| visible::line(&part.display().to_string()).into_owned());
    move || match (&part, kept.load(Ordering::Relaxed)) {
        (Some(part), done) => {
            format!("{done} of {all} flights are in {part}: the same command continues from there")
        }
        (None, _) => "the flights are not kept: with `-o rows.csv` a campaign can be continued".into(),
    }
}
