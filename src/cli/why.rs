//! Why a plan is missing: asked once `mavc plan` has ended without one.

use super::progress::Progress;
use super::spec::timing;
use super::{Options, files};
use crate::explain::planners::Planners;
use crate::explain::{Explanation, explain};
use crate::model::{Mission, Model};
use std::time::Instant;

/// Asks the planner of the spec.
pub fn why(model: &Model, mission: &Mission, options: &Options) -> Option<Explanation> {
    let begin = Instant::now();
    let progress = Progress::new(options);
    let tell = |time: f64| progress.tell("why is there no plan", time);
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
