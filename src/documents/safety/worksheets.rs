//! The FMEA worksheet and the list of functional hazards, as CSV (RFC 4180).

use super::evidence::{CAUGHT, FAILED, NONE, Phase, Share};
use super::quantities::{exponential, hours, rounded};
use super::{Case, SEVERITIES, item, local_effect};
use crate::admissible::outcome::Outcome;
use crate::flight::equilibrium::outcome_of;
use crate::number::{number, shortest};
use crate::report::headline::by_failure;

/// The columns of the FMEA worksheet: the usual ones, and after them what mavc adds.
const FMEA: [&str; 24] = [
    "item",
    "function",
    "mode",
    "title",
    "phase",
    "local_effect",
    "next_effect",
    "end_effect",
    "site",
    "severity_class",
    "detection_method",
    "provision",
    "S",
    "O",
    "D",
    "RPN",
    "rate_per_h",
    "phase_from_s",
    "phase_to_s",
    "effect_times_s",
    "effect_s",
    "exposure_s",
    "basis",
    "spec_sha256",
];

const FHA: [&str; 13] = [
    "failure_condition",
    "modes",
    "phase",
    "lowest_height_m",
    "highest_height_m",
    "heights_above",
    "outcome",
    "effect",
    "severity_class",
    "mode_seconds",
    "probability_of_modes_with_rate",
    "modes_without_rate",
    "spec_sha256",
];

/// One row for each mode, phase and outcome.
pub fn fmea(case: &Case) -> Result<Vec<u8>, csv::Error> {
    let model = case.model();
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(FMEA)?;
    let known = match case.evidence.detection[..] {
        [least, most] => {
            format!("assumed known; looked at: after {} and after {} ms", number(1e3 * least), number(1e3 * most))
        }
        _ => format!("assumed known after {} ms", number(1e3 * case.evidence.detection[0])),
    };
    let count = |n: Option<u8>| n.map(|n| n.to_string()).unwrap_or_default();
    let in_hover: Vec<Outcome> = (0..model.modes.len()).map(|mode| outcome_of(model, mode)).collect();
    for (index, phase, shares) in case.shares() {
        let mode = &model.modes[index];
        let item = item(model, index);
        for share in shares {
            let (_, effect, severity) = SEVERITIES[share.outcome];
            let seconds = share.seconds();
            table.write_record([
                item.clone(),
                format!("thrust and torque of {item}"),
                mode.name.clone(),
                harmless(mode.title.as_deref().unwrap_or_default()),
                phase.label(),
                local_effect(model, index),
                format!("in hover: {}", in_hover[index].word()),
                effect.into(),
                share.site.unwrap_or_default().into(),
                severity.into(),
                known.clone(),
                share.branches.join(" "),
                count(mode.severity),
                count(mode.occurrence),
                count(mode.detection),
                mode.rpn().map(|rpn| rpn.to_string()).unwrap_or_default(),
                mode.rate.map(|rate| shortest(rounded(3600.0 * rate))).unwrap_or_default(),
                shortest(phase.from),
                shortest(phase.to),
                share
                    .times
                    .iter()
                    .map(|[from, to]| format!("{} to {}", shortest(*from), shortest(*to)))
                    .collect::<Vec<_>>()
                    .join("; "),
                shortest(rounded(seconds)),
                shortest(if share.outcome >= FAILED { rounded(seconds) } else { 0.0 }),
                basis(case.not_sought[index].as_deref(), &share).into(),
                case.spec_sha256.into(),
            ])?;
        }
    }
    table.into_inner().map_err(|e| e.into_error().into())
}

/// How an outcome is known.
fn basis<'a>(not_sought: Option<&'a str>, share: &Share) -> &'a str {
    match (not_sought, share) {
        (Some(why), _) => why,
        (None, Share { outcome: NONE, .. }) => "not found at the instants looked at",
        (None, Share { outcome: FAILED, .. }) => "found at an instant, but its simulated flight failed",
        (None, Share { outcome: CAUGHT, .. }) => "simulated at the instants looked at",
        (None, Share { is_proved: true, .. }) => "proved at every instant, and simulated",
        (None, Share { is_proved: false, .. }) => "checked at the instants looked at, and simulated",
    }
}

/// One row for each kind of failure, phase and outcome.
pub fn fha(case: &Case) -> Result<Vec<u8>, csv::Error> {
    let model = case.model();
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(FHA)?;
    for (condition, modes) in by_failure(model, 0..model.modes.len()) {
        for phase in &case.evidence.phases {
            for (outcome, (word, effect, severity)) in SEVERITIES.iter().enumerate() {
                let hit = hit(case, &modes, phase, outcome);
                if hit.modes.is_empty() {
                    continue;
                }
                let names = |modes: &[usize]| {
                    modes.iter().map(|&mode| model.modes[mode].name.as_str()).collect::<Vec<_>>().join(" ")
                };
                // Without a ground heights are those of the spec's coordinates.
                let (ground, above) = match case.problem.mission().ground {
                    Some(ground) => (ground, "ground"),
                    None => (0.0, "origin"),
                };
                let [low, high] = case.evidence.heights(hit.times.into_iter()).map(|z| rounded(z - ground));
                table.write_record([
                    condition.clone(),
                    names(&hit.modes),
                    phase.label(),
                    shortest(low),
                    shortest(high),
                    above.into(),
                    (*word).into(),
                    (*effect).into(),
                    (*severity).into(),
                    shortest(rounded(hit.seconds)),
                    hit.probability.map(shortest).unwrap_or_default(),
                    names(&hit.unrated),
                    case.spec_sha256.into(),
                ])?;
            }
        }
    }
    table.into_inner().map_err(|e| e.into_error().into())
}

/// The modes that have an outcome in a phase.
#[derive(Default)]
struct Hit {
    modes: Vec<usize>,
    /// When the modes have it, mode by mode, s since the start of the plan.
    times: Vec<[f64; 2]>,
    /// Summed over the modes.
    seconds: f64,
    /// That one of the modes with a rate strikes then; `None` if none has one.
    probability: Option<f64>,
    unrated: Vec<usize>,
}

fn hit(case: &Case, modes: &[usize], phase: &Phase, outcome: usize) -> Hit {
    let mut hit = Hit::default();
    let mut expected: Option<f64> = None;
    for &mode in modes {
        let shares = case.share(mode, phase).into_iter().filter(|share| share.outcome == outcome);
        let times: Vec<[f64; 2]> = shares.flat_map(|share| share.times).collect();
        let seconds: f64 = times.iter().map(|[from, to]| to - from).sum();
        if seconds == 0.0 {
            continue;
        }
        hit.times.extend(times);
        hit.modes.push(mode);
        hit.seconds += seconds;
        match case.model().modes[mode].rate {
            Some(rate) => *expected.get_or_insert(0.0) += rounded(3600.0 * rate) * hours(seconds),
            None => hit.unrated.push(mode),
        }
    }
    hit.probability = expected.map(|expected| exponential(expected, 1.0));
    hit
}

/// A text of the spec that no table program takes for a formula.
fn harmless(text: &str) -> String {
    let text = crate::source::visible::line(text).into_owned();
    match text.starts_with(['=', '+', '-', '@']) {
        true => format!("'{text}"),
        false => text,
    }
}
