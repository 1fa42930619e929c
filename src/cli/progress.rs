//! Progress: which planner and mission time, how many flights and how long they still take. On interactive terminals a
//! line that changes; elsewhere plain lines on standard error, few and late.

mod lines;

use super::Options;
use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use lines::Lines;
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Where progress is shown.
enum Shown {
    Bar(ProgressBar),
    Lines(Lines),
    /// With `--quiet`.
    Nowhere,
}

impl Shown {
    fn new(options: &Options, bar: impl FnOnce() -> ProgressBar) -> Self {
        match (options.quiet, std::io::stderr().is_terminal()) {
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

/// Of planning.
pub struct Progress {
    shown: Shown,
}

impl Progress {
    pub fn new(options: &Options) -> Self {
        let bar = || {
            let bar = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}  [{elapsed}]") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(100));
            bar
        };
        Progress { shown: Shown::new(options, bar) }
    }

    /// A planner tries a mission time, s.
    pub fn tell(&self, planner: &str, time: f64) {
        self.say(format!("{planner}: is {time:.2} s enough?"));
    }

    /// What is done now.
    pub fn say(&self, message: String) {
        match &self.shown {
            Shown::Bar(bar) => bar.set_message(message),
            Shown::Lines(lines) => lines.tell(message),
            Shown::Nowhere => {}
        }
    }

    pub fn done(self) {
        self.shown.done();
    }
}

/// Of flights.
pub struct Flights {
    shown: Shown,
    /// Flights that were there.
    before: usize,
    done: AtomicUsize,
    all: usize,
    begin: Instant,
}

impl Flights {
    /// `done` of `all` are there already; they do not count towards the speed.
    pub fn new(options: &Options, done: usize, all: usize) -> Self {
        let begin = Instant::now();
        let bar = || {
            let bar = ProgressBar::new(all as u64).with_position(done as u64);
            let template = "{wide_bar} {human_pos}/{human_len} flights{pace}";
            if let Ok(style) = ProgressStyle::with_template(template) {
                // Of indicatif's own the rows that were there before would be part.
                let pace = move |state: &ProgressState, out: &mut dyn Write| {
                    let _ = out.write_str(&pace(done, state.pos() as usize, all, begin.elapsed()));
                };
                bar.set_style(style.with_key("pace", pace));
            }
            bar.enable_steady_tick(Duration::from_millis(200));
            bar
        };
        Flights { shown: Shown::new(options, bar), before: done, done: AtomicUsize::new(done), all, begin }
    }

    pub fn more(&self, flights: usize) {
        let done = self.done.fetch_add(flights, Ordering::Relaxed) + flights;
        match &self.shown {
            Shown::Bar(bar) => bar.inc(flights as u64),
            Shown::Lines(lines) => {
                let pace = pace(self.before, done, self.all, self.begin.elapsed());
                lines.tell(format!("{done} of {} flights{pace}", self.all));
            }
            Shown::Nowhere => {}
        }
    }

    pub fn done(self) {
        self.shown.done();
    }
}

/// `, 130 a second, 12 s left`, by the flights of this run alone: `before` of the `done` were there. Nothing before the
/// first.
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
        assert_eq!(pace(900, 900, 1_000, ten), "", "nothing is known yet");
    }
}
