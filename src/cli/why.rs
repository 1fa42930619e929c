//! Why a plan is missing: asked once `mavc plan` has ended without one.

use super::progress::Progress;
use super::spec::timing;
use super::{Options, files};
use crate::explain::nearby::{self, Nearby};
use crate::explain::planners::Planners;
use crate::explain::{Explanation, explain};
use crate::model::{Mission, Model};
use crate::planner::studies::Comparison;
use std::cell::Cell;
use std::time::Instant;

/// Times beside the spec's at which the planner has a plan, where it found none at the time asked for.
pub fn nearby(model: &Model, mission: &Mission, comparison: &Comparison, options: &Options) -> Nearby {
    let begin = Instant::now();
    let progress = Progress::new(options);
    let tell = |time: f64| progress.say(format!("no plan was found; looking for times with one, near {time:.2} s"));
    let (nearby, effort) = nearby::nearby(model, mission, comparison, &tell);
    progress.done();
    if options.timings && effort.solves > 0 {
        timing(options, "nearby", begin);
        files::tell(&format!("{:<10} {} solves\n", "  solver", effort.solves));
    }
    nearby
}

/// Asks the planner of the spec.
pub fn why(model: &Model, mission: &Mission, options: &Options) -> Option<Explanation> {
    let begin = Instant::now();
    let progress = Progress::new(options);
    let asked = Cell::new(0);
    let tell = |time: f64| {
        asked.set(asked.get() + 1);
        progress
            .say(format!("no plan; which statements are in the way? Variant {} of the spec, {time:.2} s", asked.get()));
    };
    let mut planner = Planners::new(Some(&tell));
    let explanation = explain(model, mission, &mut planner);
    let effort = planner.effort;
    progress.done();
    timing(options, "why", begin);
    if options.timings {
        let asked = explanation.as_ref().map_or(0, |e| e.questions);
        files::tell(&format!("{:<10} {asked} questions, {} solves\n", "  solver", effort.solves));
    }
    explanation
}
