//! What a simulated vehicle knows of a fault, and when: delays and memories of no estimator.

use super::{Usual, short, warning};
use crate::model::context::Context;
use crate::model::fields::Fields;
use crate::model::{Detection, Simulation};
use crate::source::Span;

/// From a fault to when the vehicle knows of it, s.
const DELAY: Usual = Usual::new(0.0, 5.0);
/// Memory of the estimator, in its samples and in s.
const LEAST_SAMPLES: f64 = 2.0;
const LONGEST_MEMORY: f64 = 10.0;

/// Warns of a detection that comes too late to matter, and of a memory of hardly a sample or of the whole flight. `fields`
/// are those of `simulate`, which stands at `block`.
pub(in crate::model) fn check(cx: &mut Context, simulation: &Simulation, fields: &Fields, block: Span) {
    let code = "mavc::sense::estimator";
    let place = |name: &str| fields.span_of(name).unwrap_or(block);
    if let Detection::After(delay) = simulation.detection
        && !DELAY.has(delay)
    {
        let message = format!("a fault is known after {} s, where {} is usual", short(delay), DELAY.text("s"));
        let warning = warning(code, place("detection"), message, "look for `s` in place of `ms`");
        cx.report(warning.here("most flights are lost or saved by then"));
    }
    // A sample weighs lambda^k after k more: their weights add up to 1/(1 - lambda).
    let samples = 1.0 / (1.0 - simulation.forgetting);
    let seconds = samples / simulation.estimator_rate;
    if samples < LEAST_SAMPLES || seconds > LONGEST_MEMORY {
        let message = format!(
            "the estimator remembers {} samples, {} s, where {} samples to {} s is usual",
            short(samples),
            short(seconds),
            short(LEAST_SAMPLES),
            short(LONGEST_MEMORY)
        );
        let here = match samples < LEAST_SAMPLES {
            true => "it forgets before it has learnt",
            false => "a fault hardly changes what it has learnt",
        };
        let slip = "check `forgetting` and `estimator_rate`";
        cx.report(warning(code, place("forgetting"), message, slip).here(here));
    }
}
