//! A spinner on interactive terminals: which planner, which mission time.

use super::Options;
use indicatif::{ProgressBar, ProgressStyle};
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
