//! Progress: the planner and mission time being tried, or the number of flights and the time left. On a terminal it is
//! one line that changes; elsewhere plain lines on standard error, at most one every ten seconds.

mod lines;

use super::{Options, files};
use crate::flight::Flight;
use crate::model::PlannerKind;
use crate::number::number;
use crate::observer::{Observer, PLANNERS, Stages, Trial, trial_text};
use crate::solve::Effort;
use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use lines::Lines;
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// The form in which progress is shown.
enum Shown {
    Bar(ProgressBar),
    Lines(Lines),
    /// With `--quiet`.
    Nowhere,
}

impl Shown {
    fn new(quiet: bool, bar: impl FnOnce() -> ProgressBar) -> Self {
        match (quiet, std::io::stderr().is_terminal()) {
            (true, _) => Shown::Nowhere,
            (false, true) => Shown::Bar(bar()),
            (false, false) => Shown::Lines(Lines::new()),
        }
    }

    fn done(self) {
        match self {
            Shown::Bar(bar) => bar.finish_and_clear(),
            Shown::Lines(lines) => lines.done(),
            Shown::Nowhere => {}
        }
    }
}

/// Follows a run: shows progress, and with `--timings` prints the time of each stage.
pub struct Watch {
    quiet: bool,
    timings: bool,
    /// `None` between stages.
    shown: Mutex<Option<Shown>>,
    /// The planner whose plan is wanted.
    wanted: OnceLock<&'static str>,
}

impl Watch {
    pub fn new(options: &Options) -> Self {
        Watch { quiet: options.quiet, timings: options.timings, shown: Mutex::new(None), wanted: OnceLock::new() }
    }

    /// Attempts name this planner (`RSP`), for whose plan those of others are made.
    pub fn wants(&self, planner: PlannerKind) {
        let name = PLANNERS.into_iter().find(|name| name.eq_ignore_ascii_case(planner.name()));
        name.into_iter().for_each(|name| self.wanted.set(name).unwrap_or_default());
    }

    fn shown(&self) -> MutexGuard<'_, Option<Shown>> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Stages for Watch {
    fn ended(&self, stage: &str, took: Duration) {
        if let Some(shown) = self.shown().take() {
            shown.done();
        }
        if self.timings {
            files::eprint(&format!("{stage:<10} {:>9.2} ms\n", took.as_secs_f64() * 1e3));
        }
    }
}

impl Observer for Watch {
    fn begins(&self, what: &str) {
        let bar = || {
            let bar = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}  [{elapsed}]") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(100));
            bar
        };
        match self.shown().get_or_insert_with(|| Shown::new(self.quiet, bar)) {
            Shown::Bar(bar) => bar.set_message(what.to_string()),
            Shown::Lines(lines) => lines.update(what.to_string()),
            Shown::Nowhere => {}
        }
    }

    fn tries(&self, planner: &str, trial: Trial) {
        self.begins(&trial_text(self.wanted.get().copied(), planner, trial));
    }

    fn solved(&self, effort: &Effort) {
        if !self.timings {
            return;
        }
        let Effort { solves, iterations, starts, work, .. } = effort;
        let starts = match starts {
            0 => String::new(),
            1 => ", 1 start".into(),
            starts => format!(", {starts} starts"),
        };
        let milliseconds = effort.time.as_secs_f64() * 1e3;
        let work = *work as f64 / 1e6;
        let line =
            format!("{milliseconds:>9.2} ms in {solves} solves, {iterations} iterations, work {work:.1}{starts}");
        files::eprint(&format!("{:<10} {line}\n", "  solver"));
    }

    fn flown(&self, flight: &Flight, took: Duration, is_recorded: bool) {
        if self.timings {
            let seconds = took.as_secs_f64();
            let with_log = if is_recorded { ", with its log" } else { "" };
            let pace = number((flight.end / seconds).round());
            let step = number((1e9 * seconds / flight.steps.max(1) as f64).round());
            files::eprint(&format!("{:<10} {pace:>9} simulated seconds a second, {step} ns a step{with_log}\n", ""));
        }
    }

    fn asked(&self, variants: Option<usize>, effort: &Effort) {
        if self.timings {
            let variants = variants.map_or(String::new(), |n| format!("{n} variants, "));
            files::eprint(&format!("{:<10} {variants}{} solves\n", "  solver", effort.solves));
        }
    }
}

/// The progress of flights.
pub struct Flights {
    shown: Shown,
    /// Flights that an earlier run has flown.
    before: usize,
    done: AtomicUsize,
    all: usize,
    begin: Instant,
}

impl Flights {
    /// An earlier run has flown `done` of `all`; they do not count towards the speed.
    pub fn new(options: &Options, done: usize, all: usize) -> Self {
        let begin = Instant::now();
        let bar = || {
            let bar = ProgressBar::new(all as u64).with_position(done as u64);
            let template = "{wide_bar} {human_pos}/{human_len} flights{pace}";
            if let Ok(style) = ProgressStyle::with_template(template) {
                // The speed that indicatif computes would include the flights of the earlier run.
                let pace = move |state: &ProgressState, out: &mut dyn Write| {
                    let _ = out.write_str(&pace(done, state.pos() as usize, all, begin.elapsed()));
                };
                bar.set_style(style.with_key("pace", pace));
            }
            bar.enable_steady_tick(Duration::from_millis(200));
            bar
        };
        Flights { shown: Shown::new(options.quiet, bar), before: done, done: AtomicUsize::new(done), all, begin }
    }

    pub fn more(&self, flights: usize) {
        let done = self.done.fetch_add(flights, Ordering::Relaxed) + flights;
        match &self.shown {
            Shown::Bar(bar) => bar.inc(flights as u64),
            Shown::Lines(lines) => {
                let pace = pace(self.before, done, self.all, self.begin.elapsed());
                lines.update(format!("{done} of {} flights{pace}", self.all));
            }
            Shown::Nowhere => {}
        }
    }

    pub fn done(self) {
        self.shown.done();
    }
}

/// `, 130 a second, 12 s left`, from the flights of this run alone: an earlier run flew `before` of the `done`. Empty
/// until this run has flown one.
fn pace(before: usize, done: usize, all: usize, elapsed: Duration) -> String {
    let (flown, seconds) = (done.saturating_sub(before), elapsed.as_secs_f64());
    if flown == 0 || seconds <= 0.0 {
        return String::new();
    }
    let rate = flown as f64 / seconds;
    let left = (all.saturating_sub(done) as f64 / rate).ceil() as u64;
    let digits = usize::from(rate < 10.0);
    format!(", {rate:.digits$} a second, {} left", HumanDuration(Duration::from_secs(left)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resumed_campaign_is_as_fast_as_it_flies_now() {
        let ten = Duration::from_secs(10);
        assert_eq!(pace(0, 1_000, 4_000, ten), ", 100 a second, 30 seconds left");
        assert_eq!(pace(900_000, 901_000, 904_000, ten), pace(0, 1_000, 4_000, ten));
        assert_eq!(pace(10, 25, 40, ten), ", 1.5 a second, 10 seconds left");
        assert_eq!(pace(900, 900, 1_000, ten), "", "no flight of this run yet");
    }
}
