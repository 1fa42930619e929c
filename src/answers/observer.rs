//! Following a long run: its progress, and the time of each stage.

use crate::flight::Flight;
use crate::solve::Effort;
use std::time::Duration;

pub use crate::planner::trial::Trial;
pub use mavc_verify::stages::{Silent, Stages, timed};

/// Receives the progress of a run, and by [`Stages::ended`] the time of each stage. Every method does nothing by
/// default; threads may call them at the same time.
pub trait Observer: Stages {
    /// Work has started that `what` describes, for a line of progress.
    fn begins(&self, _what: &str) {}

    /// A trial of `planner` begins.
    fn tries(&self, _planner: &str, _trial: Trial) {}

    /// What the solver did in the stage that ended last.
    fn solved(&self, _effort: &Effort) {}

    /// A flight was simulated in `took`; `is_recorded` if a log or a page is made of it.
    fn flown(&self, _flight: &Flight, _took: Duration, _is_recorded: bool) {}

    /// A search for an explanation has ended: the number of variants of the spec that were planned, if they were
    /// counted, and what the solver did.
    fn asked(&self, _variants: Option<usize>, _effort: &Effort) {}
}

impl Observer for Silent {}

/// The names by which [`Observer::tries`] calls the planners.
pub const PLANNERS: [&str; 3] = ["RIP", "RCP", "RSP"];

/// A trial for a line of progress, in at most 80 columns with what surrounds it. A search for RSP begins with RCP's
/// plan, which satisfies RSP's rows too.
pub fn trial_text(wanted: Option<&str>, planner: &str, trial: Trial) -> String {
    let other = wanted.filter(|wanted| *wanted != planner && PLANNERS.contains(&planner));
    let of = other.map_or(planner.to_string(), |wanted| format!("{wanted} begins with {planner}'s"));
    let seconds = |what: &str, time: Option<f64>| time.map(|time| format!("{what} {time:.2}"));
    let known = [seconds("feasible", trial.feasible), seconds("failed", trial.failed)];
    let left = trial.budget_left.map(|left| format!("budget left {:.0} %", (100.0 * left).floor()));
    let parts: Vec<String> = known.into_iter().chain([left]).flatten().collect();
    let known = if parts.is_empty() { String::new() } else { format!("; {}", parts.join(", ")) };
    format!("{of}: trying {:.2} s{known}", trial.time)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trials_name_the_planner_that_is_wanted() {
        let trial = Trial::at(35.0);
        assert_eq!(trial_text(Some("RSP"), "RSP", trial), "RSP: trying 35.00 s");
        assert_eq!(trial_text(Some("RSP"), "RCP", trial), "RSP begins with RCP's: trying 35.00 s");
        assert_eq!(trial_text(Some("RSP"), "round 2", trial), "round 2: trying 35.00 s");
        assert_eq!(trial_text(None, "RCP", trial), "RCP: trying 35.00 s");
    }

    #[test]
    fn trials_list_what_is_known() {
        let trial = Trial { time: 41.21, feasible: Some(41.754), failed: Some(40.9), budget_left: Some(0.628) };
        let text = trial_text(Some("RSP"), "RSP", trial);
        assert_eq!(text, "RSP: trying 41.21 s; feasible 41.75, failed 40.90, budget left 62 %");
        // With a sign before it and the elapsed time after it.
        let longest = Trial { time: 412.21, feasible: Some(414.75), failed: Some(404.9), budget_left: Some(1.0) };
        assert!(trial_text(None, "RSP", longest).len() <= 80 - "* ".len() - "  [2m]".len());
    }
}
