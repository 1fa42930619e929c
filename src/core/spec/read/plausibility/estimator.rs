//! Fault detection in simulations: implausible delays and estimator memories.

use super::{Usual, short, warning};
use crate::model::{Detection, Simulation};
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;

/// Delay between a fault and its detection, s.
const DELAY: Usual = Usual::new(0.0, 5.0);
/// Shortest usual memory of the estimator, in samples.
const LEAST_SAMPLES: f64 = 2.0;
/// Longest usual memory of the estimator, s.
const LONGEST_MEMORY: f64 = 10.0;

/// Warns of a detection that comes too late to matter, and of a memory of hardly a sample or of the whole flight.
/// `fields` are those of the `simulate` block at `block`.
pub(in crate::spec::read) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
    let code = "mavc::sense::estimator";
    let place = |name: &str| fields.span_of(name).unwrap_or(block);
    if let Detection::After(delay) = simulation.detection
        && !DELAY.has(delay)
    {
        let message = DELAY.outside(format!("`detection` takes {} s", short(delay)), "s");
        let warning = warning(code, place("detection"), message, "look for `s` in place of `ms`");
        cx.report(warning.here("most flights are lost or saved by then"));
    }
    // A sample weighs lambda^k after k more samples: the weights sum to 1/(1 - lambda).
    let samples = 1.0 / (1.0 - simulation.forgetting);
    let seconds = samples / simulation.estimator_rate;
    if samples < LEAST_SAMPLES || seconds > LONGEST_MEMORY {
        let message = format!(
            "the estimator remembers {} samples ({} s), outside the usual range of {} samples to {} s",
            short(samples),
            short(seconds),
            short(LEAST_SAMPLES),
            short(LONGEST_MEMORY)
        );
        let here = match samples < LEAST_SAMPLES {
            true => "forgets before it has learnt",
            false => "a fault hardly changes the estimate",
        };
        let slip = "check `forgetting` and `estimator_rate`";
        cx.report(warning(code, place("forgetting"), message, slip).here(here));
    }
}
