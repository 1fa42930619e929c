//! Figures 3 to 5 and 10 to 12: the octocopter tracks the curve when healthy, with rotor 3 lost, and with the loss
//! detected.

use super::judgement::{STATEMENTS, agrees_if, not_comparable, statement};
use super::markdown::{fixed, paragraph, table};
use super::specs;
use mavc::flight::{Flight, Sortie, fly};

/// An error below the first counts as small: about the arm of the vehicle. One above the second, its width, counts as a
/// failure to track.
const SMALL: f64 = 0.2;
const FAILS: f64 = 0.4;

struct Flown {
    flight: Flight,
    /// The estimates of all capacities, mean over the last second.
    estimates: Vec<f64>,
}

fn flown(figure: &str) -> Flown {
    let spec = specs::paper(figure);
    let planning = mavc::plan(&spec).unwrap_or_else(|refusal| panic!("{figure}: {refusal}"));
    let plan = planning.plan().unwrap_or_else(|| panic!("{figure} has no plan"));
    let model = spec.model();
    let sortie = Sortie::along(model, &plan.trajectory, &model.simulation.faults, model.simulation.seed);
    let (mut estimates, mut count) = (vec![0.0; model.vehicle.rotors.len()], 0.0);
    let late = sortie.duration - 1.0;
    let flight = fly(
        &sortie,
        Some(&mut |sample| {
            if sample.time >= late {
                estimates.iter_mut().zip(sample.estimated).for_each(|(sum, e)| *sum += e);
                count += 1.0;
            }
        }),
    );
    estimates.iter_mut().for_each(|e| *e /= count);
    Flown { flight, estimates }
}

pub fn section() -> String {
    let [healthy, unknown, found] = ["figure3", "figure5", "figure12"].map(flown);
    let errors = |f: &Flown| {
        format!("{} m root mean square, {} m at most", fixed(f.flight.rms_error, 2), fixed(f.flight.max_error, 2))
    };
    let detected = found.flight.found[0];
    let milliseconds = |t: Option<f64>| t.map_or("never".into(), |t| format!("after {} ms", fixed(1000.0 * t, 0)));
    let (lost, sound): (Vec<f64>, Vec<f64>) = {
        let of = |keep: fn(usize) -> bool| (0..8).filter(|k| keep(*k)).map(|k| found.estimates[k]).collect();
        (of(|k| k == 2), of(|k| k != 2))
    };
    let least_sound = sound.iter().copied().fold(f64::INFINITY, f64::min);
    let rows = vec![
        statement(
            "Figure 3: a healthy vehicle tracks with a small error",
            errors(&healthy),
            agrees_if(healthy.flight.max_error < SMALL, "the error is not small"),
        ),
        statement(
            "Figures 4 and 5: with rotor 3 lost the controller fails to track",
            errors(&unknown),
            agrees_if(unknown.flight.max_error > FAILS, "it tracks"),
        ),
        statement(
            "Figures 10 and 11: with the estimator tracking is similar to the healthy vehicle's",
            errors(&found),
            agrees_if(found.flight.max_error < 1.5 * healthy.flight.max_error, "the errors are not similar"),
        ),
        statement(
            "Figure 12: the capacity of each rotor is properly diagnosed",
            format!(
                "rotor 3: {}, others at least {}; detected {}, isolated {}",
                fixed(lost[0], 2),
                fixed(least_sound, 2),
                milliseconds(detected.detected_after),
                milliseconds(detected.isolated_after)
            ),
            agrees_if(lost[0] < 0.1 && least_sound > 0.9, "the estimates are off"),
        ),
        statement(
            "the errors drawn in Figures 5 and 11",
            "as above",
            not_comparable("the curve's size, the time of the flight, the gains and the noise are not given"),
        ),
        statement(
            "a forgetting factor of 0.8 covers the last 0.8 s",
            "at 100 samples a second the memory, Ts/(1 - 0.8), is 0.05 s",
            not_comparable("the time between samples is not given"),
        ),
    ];
    paragraph(
        "`mavc simulate specs/paper/figure3.mav`, `figure5.mav` and `figure12.mav` fly the paper's PD law (21) to \
         (28) with the pseudo-inverse (42), on the nonlinear vehicle (3) to (9) with the motors, gyroscope noise and \
         position noise that are the defaults in docs/language.md. The path is Viviani's curve of case 1 in 30 s; \
         rotor 3 is lost at 5 s. Distances are from the planned position. An error below 0.2 m counts as small here, \
         and one above 0.4 m as a failure to track.",
    ) + &table(&STATEMENTS, &rows)
}
