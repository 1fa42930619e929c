//! Progress on interactive terminals: which planner and mission time, how many flights and how long they still take.

use super::Options;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::IsTerminal;
use std::time::Duration;

pub struct Progress {
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Nothing is drawn where standard error is no terminal, or with `--quiet`.
    pub fn new(options: &Options) -> Self {
        let wanted = !options.quiet && std::io::stderr().is_terminal();
        let bar = wanted.then(|| {
            let bar = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}  [{elapsed}]") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(100));
            bar
        });
        Progress { bar }
    }

    pub fn tell(&self, planner: &str, time: f64) {
        if let Some(bar) = &self.bar {
            bar.set_message(format!("{planner}: is {time:.2} s enough?"));
        }
    }

    pub fn done(self) {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
    }
}

/// A bar over flights.
pub struct Flights {
    bar: Option<ProgressBar>,
}

impl Flights {
    /// `done` of `all` are there already; they do not count towards the speed.
    pub fn new(options: &Options, done: usize, all: usize) -> Self {
        let wanted = !options.quiet && std::io::stderr().is_terminal();
        let bar = wanted.then(|| {
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
        });
        Flights { bar }
    }

    pub fn more(&self, flights: usize) {
        if let Some(bar) = &self.bar {
            bar.inc(flights as u64);
        }
    }

    pub fn done(self) {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
    }
}
