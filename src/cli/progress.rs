//! Progress: which planner and mission time, how many flights and how long they still take. On interactive terminals a
//! line that changes; elsewhere plain lines on standard error, few and late.

mod lines;

use super::Options;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use lines::Lines;
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

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
    done: AtomicUsize,
    all: usize,
}

impl Flights {
    /// `done` of `all` are there already; they do not count towards the speed.
    pub fn new(options: &Options, done: usize, all: usize) -> Self {
        let bar = || {
            let bar = ProgressBar::new(all as u64).with_position(done as u64);
            let template = "{wide_bar} {human_pos}/{human_len} flights, {rate} a second, {eta} left";
            if let Ok(style) = ProgressStyle::with_template(template) {
                let rate = |state: &ProgressState, out: &mut dyn Write| {
                    let _ = write!(out, "{:.0}", state.per_sec());
                };
                bar.set_style(style.with_key("rate", rate));
            }
            bar.reset_eta();
            bar.enable_steady_tick(Duration::from_millis(200));
            bar
        };
        Flights { shown: Shown::new(options, bar), done: AtomicUsize::new(done), all }
    }

    pub fn more(&self, flights: usize) {
        let done = self.done.fetch_add(flights, Ordering::Relaxed) + flights;
        match &self.shown {
            Shown::Bar(bar) => bar.inc(flights as u64),
            Shown::Lines(lines) => lines.tell(format!("{done} of {} flights", self.all)),
            Shown::Nowhere => {}
        }
    }

    pub fn done(self) {
        self.shown.done();
    }
}
