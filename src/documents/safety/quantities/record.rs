//! The quantities for programs, `quantities.json`.

use crate::safety::evidence::{FAILED, NONE, Phase};
use crate::safety::{Case, SEVERITIES, sha256};
use serde_json::{Value, json};

/// The quantities for programs.
pub fn record(case: &Case) -> Value {
    let q = &case.quantities;
    let model = case.model();
    let name = |mode: usize| model.modes[mode].name.as_str();
    let event = |mode: usize, phase: &Phase| format!("{}-uncovered-{}", name(mode), phase.tag());
    let singles = q.by_contribution().into_iter().map(|(mode, single)| {
        json!({
            "events": [event(mode, single.phase)],
            "uncovered_s": single.seconds,
            "probability": single.probability,
        })
    });
    let doubles = q.doubles().map(|([a, b], probability)| {
        let joint = case.pairs.iter().find(|(pair, _)| *pair == [a, b]).and_then(|(_, outcome)| *outcome);
        json!({
            "events": [format!("{}-covered", name(a)), format!("{}-covered", name(b))],
            "hover_with_both": joint.map_or("not looked at", |outcome| outcome.word()),
            "probability": probability,
        })
    });
    let cut_sets: Vec<Value> = match q.rated.is_empty() {
        true => without_rates(case, &event),
        false => singles.chain(doubles).collect(),
    };
    let modes = case.evidence.modes.iter().enumerate().map(|(mode, evidence)| {
        let rated = q.rated.iter().enumerate().find(|(_, one)| one.mode == mode);
        json!({
            "mode": name(mode),
            "in_fault_tree": q.rated.is_empty() || rated.is_some(),
            "rate_per_h": rated.map(|(_, one)| one.rate_per_h),
            "rate_interval_per_h": rated.filter(|(_, one)| !one.spread.is_none()).map(|(_, one)| one.interval()),
            "uncovered_s": evidence.uncovered(),
            "none_found_s": evidence.with_outcome(NONE),
            "failed_flights_s": evidence.with_outcome(FAILED),
            "proved_s": evidence.proved(),
            "saved_if_it_never_strikes": rated.map(|(at, _)| q.saved_without(at)),
            "saved_by_a_second_more_covered": rated.map(|(at, _)| q.saved_by_a_second(at)),
        })
    });
    json!({
        "spec_sha256": case.spec_sha256,
        "spec": case.texts.iter().map(|text| {
            json!({"file": text.file, "sha256": sha256(text.text.as_bytes())})
        }).collect::<Vec<_>>(),
        "set": case.set,
        "written_by": case.inputs.written_by,
        "report_sha256": sha256(case.inputs.report),
        "certificate_sha256": sha256(case.inputs.certificate),
        "branches_sha256": case.inputs.tables_sha256(),
        "mission_s": q.duration,
        "loss_of_control": {
            "per_mission": q.probability,
            "per_flight_hour": q.per_flight_hour(),
            "per_mission_over_rate_intervals": q.interval,
            "per_mission_if_failed_flights_were_covered": q.without_failures,
        },
        "target_per_mission": q.target,
        "left_of_target": q.budget(),
        "two_modes_strike": {
            "per_mission": q.two_strikes(|_| 1.0),
            "both_where_covered_at_most": (q.rated.len() > 1).then(|| q.both_covered(|_| 1.0)),
        },
        "flights": {
            "flown": case.evidence.flown,
            "failed": case.evidence.flown - case.evidence.survived,
            "failed_where_a_way_out_is_proved": case.evidence.failed_where_proved,
            "largest_share_of_failures_at_95_percent": case.evidence.largest_share_of_failures(),
            "per_mission_if_covered_strikes_fail_at_this_share":
                q.if_covered_fail(case.evidence.largest_share_of_failures()),
        },
        "modes": modes.collect::<Vec<_>>(),
        "cut_sets": cut_sets,
        "severities": SEVERITIES.iter().map(|(outcome, effect, word)| {
            json!({"outcome": outcome, "effect": effect, "severity": word})
        }).collect::<Vec<_>>(),
        "assumptions": case.assumptions(),
    })
}

/// The cut sets of a spec without rates; `event` names the event of a mode in a phase.
fn without_rates(case: &Case, event: &dyn Fn(usize, &Phase) -> String) -> Vec<Value> {
    let model = case.model();
    let mut sets = Vec::new();
    for mode in 0..model.modes.len() {
        for phase in &case.evidence.phases {
            let seconds = case.evidence.modes[mode].uncovered_within(phase);
            if seconds > 0.0 {
                sets.push(json!({"events": [event(mode, phase)], "uncovered_s": seconds, "probability": null}));
            }
        }
    }
    let pairs = case.pairs_with_ways_out();
    sets.extend(pairs.into_iter().map(|pair| {
        let events = pair.map(|mode| format!("{}-covered", model.modes[mode].name));
        json!({"events": events, "probability": null})
    }));
    sets
}
