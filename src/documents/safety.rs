//! What a plan with its ways out means for a safety assessment: an FMEA worksheet, functional hazards, a fault tree, an
//! argument, and a page that links them. All are written from the same three texts, the spec, the report of
//! `mavc plan --recovery` and the certificate, so that they cannot disagree.

mod argument;
mod drawing;
pub mod evidence;
mod fault_tree;
mod heights;
pub mod inputs;
mod page;
pub mod quantities;
mod questions;
mod worksheets;

use crate::admissible::outcome::Outcome;
use crate::flight::equilibrium::{analyze_each, outcome_of};
use crate::model::{Model, Problem, RotorState};
use crate::number::{fixed, number, plural, significant};
use crate::spec::Spec;
use crate::text_table::fitted;
use crate::verify::Accepted;
use evidence::{Evidence, FAILED, ModeEvidence, Phase, Share};
use inputs::{Inputs, SUMS, TABLES, Text};
use quantities::{Quantities, Rated};
use sha2::{Digest, Sha256};

/// A safety assessment's input.
pub struct Case<'a> {
    pub problem: Problem<'a>,
    pub spec_sha256: &'a str,
    pub evidence: Evidence,
    pub inputs: Inputs<'a>,
    /// The texts of the spec.
    pub texts: Vec<Text<'a>>,
    /// The values of `--set`.
    pub set: Vec<&'a str>,
    /// What the checker says of the certificate.
    pub accepted: &'a Accepted,
    pub quantities: Quantities,
    /// Two different modes in one mission, as indices into the model's modes, and what both together leave of the
    /// vehicle; `None` where a rotor has two faults whose joint effect the spec does not determine.
    pub pairs: Vec<([usize; 2], Option<Outcome>)>,
    /// For each mode, why no way out was sought, if none was.
    not_sought: Vec<Option<String>>,
}

/// The names of the report and the certificate in the folder.
pub const REPORT: &str = "report.json";
pub const CERTIFICATE: &str = "certificate.json";

/// Outcomes with their effect and a word for how severe they are: mavc's own proposal, in the order of
/// [`crate::report::recovery::OUTCOMES`], with [`evidence::FAILED`] before the last.
pub const SEVERITIES: [(&str, &str, &str); 7] = [
    ("continue", "flies on along the plan to its end", "minor"),
    ("continue spinning", "flies on along the plan; the heading is lost", "major"),
    ("land at site", "lands at a prepared site; the mission is lost", "major"),
    ("land here", "lands where it comes to rest, outside the areas to keep off", "hazardous"),
    ("caught", "falls until its spin catches it, then lands near there, in simulated flights", "hazardous"),
    (
        "flight failed",
        "a way out was found, but its simulated flight did not end as planned: counted as loss of control",
        "catastrophic",
    ),
    ("none", "no way out is known: counted as loss of control", "catastrophic"),
];

impl<'a> Case<'a> {
    /// The case of a plan; `evidence` is read from the report of `inputs` ([`Evidence::read`]), and `spec` is that of
    /// `problem`.
    pub fn new(
        problem: Problem<'a>,
        spec: &'a Spec,
        evidence: Evidence,
        inputs: Inputs<'a>,
        accepted: &'a Accepted,
    ) -> Self {
        let model = problem.model();
        let failed = evidence.modes.iter().any(|mode| mode.with_outcome(FAILED) > 0.0);
        let open = failed.then(|| rated(model, &evidence, ModeEvidence::open_within));
        let counted = rated(model, &evidence, ModeEvidence::uncovered_within);
        let quantities = Quantities::new(counted, open.as_deref(), evidence.duration, model.plan.require_risk);
        let pairs = pairs(model);
        let reasons = evidence.modes.iter().enumerate();
        let not_sought =
            reasons.map(|(mode, found)| Some(not_sought(model, mode, found.not_attempted.as_deref()?))).collect();
        let (mut texts, set) = (inputs::texts(spec.sources()), inputs::set(spec.sources()));
        inputs::rename(&mut texts, inputs.spec_files);
        Case {
            problem,
            spec_sha256: spec.sha256(),
            evidence,
            inputs,
            texts,
            set,
            accepted,
            quantities,
            pairs,
            not_sought,
        }
    }

    /// The files of the folder, by name: those that follow from the spec and [`Case::inputs`], and these.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, String> {
        let mut files = self.derived()?;
        files.extend(
            [(REPORT, self.inputs.report), (CERTIFICATE, self.inputs.certificate)]
                .map(|(name, bytes)| (name.to_string(), bytes.to_vec())),
        );
        files.extend(self.inputs.tables.iter().map(|(name, bytes)| (format!("{TABLES}/{name}"), bytes.clone())));
        files.extend(self.inputs.sums().map(|text| (SUMS.to_string(), text.into_bytes())));
        Ok(files)
    }

    /// The files that follow from the spec and [`Case::inputs`], by name.
    pub fn derived(&self) -> Result<Vec<(String, Vec<u8>)>, String> {
        let json = |value: &serde_json::Value| serde_json::to_string_pretty(value).map(|text| text + "\n");
        let argument = argument::argument(self);
        let own: Vec<(&str, Vec<u8>)> = vec![
            ("fmea.csv", worksheets::fmea(self).map_err(|e| e.to_string())?),
            ("fha.csv", worksheets::fha(self).map_err(|e| e.to_string())?),
            ("faulttree.xml", fault_tree::open_psa(self).into_bytes()),
            ("quantities.json", json(&quantities::record(self)).map_err(|e| e.to_string())?.into_bytes()),
            ("argument.json", json(&argument.json(self)).map_err(|e| e.to_string())?.into_bytes()),
            ("argument.svg", drawing::svg(self, &argument).into_bytes()),
            ("index.html", page::page(self).into_bytes()),
        ];
        let texts = self.texts.iter().map(|text| (text.file.clone(), text.text.as_bytes().to_vec()));
        Ok(own.into_iter().map(|(name, bytes)| (name.to_string(), bytes)).chain(texts).collect())
    }

    /// What is assumed; each line is a node of the argument and a row of the page.
    fn assumptions(&self) -> [String; 8] {
        let [proved, covered] = self.evidence.proved_and_covered();
        let between = match () {
            () if proved == 0.0 => "Ways out hold between the instants looked at; this is not shown.".into(),
            () if proved < covered => format!(
                "The certificate proves {} s of the {} s x fault that count as covered, from the states that a \
                 simulation expects, within its tolerances; in the rest, ways out hold between the instants looked at, \
                 which is not shown.",
                fixed(proved, 2),
                fixed(covered, 2)
            ),
            () => {
                "When a fault is known, the vehicle is in the state that a simulation expects, within the tolerances \
                   of the certificate; from there a way out is proved at every instant."
                    .into()
            }
        };
        [
            "When the mission begins, nothing has failed. Each mode strikes at a constant rate, independently of all \
             others; a failure with one cause for several rotors is a mode of its own."
                .into(),
            "The spec is true: masses, inertias, places and thrust of rotors, rates and sites are as written.".into(),
            "A fault is known after the delays of the spec; a fault that stays undetected is not covered.".into(),
            between,
            "One simulated flight stands for all flights of a way out, and for the time to the instants around it. \
             Where it did not end as planned, that time counts as a loss of control."
                .into(),
            "A second fault in the same mission is a loss of control, because no way out is sought after it.".into(),
            "The tolerances within which a certificate shows its statements (documentation of mavc, Certificates: The \
             theorem) are harmless."
                .into(),
            "mavc reads the spec as its author means it; the parts of mavc that certificates trust (documentation of \
             mavc, Certificates: The checker alone) have no error; nor have the planner and the simulator that wrote \
             report.json, which is compared with the spec and the certificate, and not proved."
                .into(),
        ]
    }

    fn model(&self) -> &'a Model {
        self.problem.model()
    }

    /// For each mode, and each phase of the mission in which it may strike, what happens and for how long.
    fn shares(&self) -> impl Iterator<Item = (usize, &Phase, Vec<Share<'_>>)> {
        let modes = 0..self.model().modes.len();
        modes.flat_map(move |mode| self.evidence.phases.iter().map(move |phase| (mode, phase, self.share(mode, phase))))
    }

    fn share(&self, mode: usize, phase: &Phase) -> Vec<Share<'_>> {
        self.evidence.modes[mode].within(phase)
    }

    /// The pairs of modes that are both covered at some time: where they are not, each alone loses control.
    fn pairs_with_ways_out(&self) -> Vec<[usize; 2]> {
        let evidence = &self.evidence;
        let is_covered = |mode: &usize| evidence.modes[*mode].uncovered() < evidence.duration;
        self.pairs.iter().map(|(pair, _)| *pair).filter(|pair| pair.iter().all(is_covered)).collect()
    }

    /// The modes without a rate, if others have one: what the probabilities, the fault tree and its cut sets leave out.
    fn left_out(&self) -> Vec<usize> {
        let is_quantified = !self.quantities.rated.is_empty();
        let modes = self.model().modes.iter().enumerate();
        modes.filter(|(_, mode)| is_quantified && mode.rate.is_none()).map(|(index, _)| index).collect()
    }

    /// What is said of the modes that are left out: `M2, M3 have no rate: left out of ...`
    fn of_left_out(&self) -> Option<String> {
        let left_out = self.left_out();
        let names = self.names(&left_out);
        let open: f64 = left_out.iter().map(|mode| self.evidence.modes[*mode].uncovered()).sum();
        let all = self.evidence.duration * left_out.len() as f64;
        (!left_out.is_empty()).then(|| {
            format!(
                "{names} {} no rate: left out of these numbers, of the fault tree and of its cut sets; uncovered for \
                 {} of {} s x fault",
                has(left_out.len()),
                fixed(open, 2),
                fixed(all, 2)
            )
        })
    }

    /// The modes after which no way out was sought, by the reason.
    fn not_sought_by_reason(&self) -> Vec<(&str, Vec<usize>)> {
        let mut reasons: Vec<(&str, Vec<usize>)> = Vec::new();
        for (mode, why) in self.not_sought.iter().enumerate() {
            let Some(why) = why.as_deref() else { continue };
            match reasons.iter_mut().find(|(known, _)| *known == why) {
                Some((_, modes)) => modes.push(mode),
                None => reasons.push((why, vec![mode])),
            }
        }
        reasons
    }

    /// `M2, M3`
    fn names(&self, modes: &[usize]) -> String {
        modes.iter().map(|&mode| self.model().modes[mode].name.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// `35 of 93 simulated flights failed, 2 of them where the certificate proves a way out`
    fn flights(&self) -> String {
        let e = &self.evidence;
        let where_proved = match e.failed_where_proved {
            0 => String::new(),
            count => format!(", {count} of them where the certificate proves a way out"),
        };
        match (e.flown, e.flown - e.survived) {
            (0, _) => "no trajectory of a way out was found, so none was flown".into(),
            (flown, failed) => format!("{failed} of {flown} simulated flights failed{where_proved}"),
        }
    }

    /// Whether the probability exceeds the target of the spec.
    pub fn exceeds_target(&self) -> bool {
        self.quantities.budget().is_some_and(|left| left < 0.0)
    }

    /// The modes with the longest times without a way out, and how a plan that covers them can have such times.
    fn without_a_way(&self) -> String {
        let seconds = |mode: usize| self.evidence.modes[mode].with_outcome(evidence::NONE);
        let mut modes: Vec<usize> = (0..self.not_sought.len()).collect();
        modes.retain(|&mode| self.not_sought[mode].is_none() && seconds(mode) > 0.0);
        if modes.is_empty() {
            return String::new();
        }
        modes.sort_by(|a, b| seconds(*b).total_cmp(&seconds(*a)));
        let named = |mode: &usize| format!("{} {} s", self.model().modes[*mode].name, fixed(seconds(*mode), 2));
        let mut parts: Vec<String> = modes.iter().take(MOST_NAMED).map(named).collect();
        parts.extend((modes.len() > MOST_NAMED).then(|| plural(modes.len() - MOST_NAMED, "more mode")));
        let delays = self.model().plan.recovery.detection.map(|delay| number(1e3 * delay));
        let known = if delays[0] == delays[1] { delays[0].clone() } else { delays.join(" to ") };
        format!(
            "  no way out found: {}\n  A plan that stays inside a mode's set can lack a way out: until the fault is \
             known, after {known} ms, the vehicle leaves the plan.\n",
            parts.join(", ")
        )
    }

    /// The answer for people.
    pub fn text(&self) -> String {
        let q = &self.quantities;
        let name = &self.problem.mission().name;
        let mut text = match q.probability {
            Some(p) => {
                let hours = self.evidence.duration / 3600.0;
                format!(
                    "{name}: loss of control {} a mission of {} s, {} a flight hour\n",
                    short(p),
                    significant(self.evidence.duration, 4),
                    short(p / hours)
                )
            }
            None => format!("{name}: no mode has a rate, so no probability is stated\n"),
        };
        if let (Some(target), Some(left)) = (q.target, q.budget()) {
            let (target, by, highest) = (short(target), short(left.abs()), q.at_highest());
            text += &match left < 0.0 {
                true => format!("  exceeds the target of the spec, {target}, by {by}{highest} ({TARGET})\n"),
                false => format!("  meets the target of the spec, {target}: {by} left{highest} ({TARGET})\n"),
            };
        }
        if let Some([low, high]) = q.interval {
            text += &format!("  over the intervals of the rates: {} to {}\n", short(low), short(high));
        }
        if let Some(p) = q.without_failures {
            text += &format!("  if ways out whose simulated flight failed covered their time: {}\n", short(p));
        }
        let over_all = |outcome: usize| self.evidence.modes.iter().map(|mode| mode.with_outcome(outcome)).sum::<f64>();
        let [none, failed] = [evidence::NONE, FAILED].map(over_all);
        let all = self.evidence.duration * self.evidence.modes.len() as f64;
        text += &format!(
            "  counted as lost: {} of {} s x fault, over all modes{}\n",
            fixed(none + failed, 2),
            fixed(all, 2),
            if failed > 0.0 {
                format!(", {} s of it because simulated flights failed", fixed(failed, 2))
            } else {
                String::new()
            }
        );
        text += &self.without_a_way();
        for (why, modes) in self.not_sought_by_reason() {
            text += &format!("  after {}: {why}\n", self.names(&modes));
        }
        if let Some(left_out) = self.of_left_out() {
            text += &format!("  {left_out}\n");
        }
        let [singles, doubles] = [q.singles().count(), q.doubles().count()];
        if q.probability.is_some() {
            text += &format!("  {}, {}\n", plural(singles, "single cut set"), plural(doubles, "double cut set"));
        }
        for (at, single) in q.by_contribution().into_iter().take(3) {
            let [seconds, p] = [fixed(single.seconds, 2), short(single.probability)];
            let mode = &self.model().modes[at].name;
            text += &format!("  {mode} on {}: {seconds} s without a way out, {p}\n", single.phase.label());
        }
        text += &format!("  {}\n", self.flights());
        text += &format!("  certificate: {}\n", self.accepted.headline);
        for why in &self.accepted.weaker {
            text += &format!("  weaker than the spec requires: {why}\n");
        }
        fitted(&text)
    }
}

fn has(count: usize) -> &'static str {
    if count == 1 { "has" } else { "have" }
}

/// Most modes that the answer names with their times.
const MOST_NAMED: usize = 3;

/// What is compared with `require risk`.
const TARGET: &str = "`require risk` bounds strikes while the mission is committed; compared is the loss of control";

/// Why no way out was sought after a mode; `why` is the report's word for it.
fn not_sought(model: &Model, mode: usize, why: &str) -> String {
    let reason = match (why, outcome_of(model, mode)) {
        ("caught", _) => "the vehicle has to be caught",
        (_, Outcome::FliesOn) if model.vehicle.yaw_drag.is_none() => {
            "hover needs yaw to be given up, and the spec has no yaw_drag"
        }
        (_, Outcome::FliesOn) => "hover needs yaw to be given up",
        (_, Outcome::FullControl) => "hover has no margin with the reserve",
        (_, Outcome::Lost) => "hover is lost",
        (_, Outcome::Caught | Outcome::NoMargin | Outcome::Undecided) => "hover has no margin",
    };
    format!("none sought: {reason}")
}

/// A probability or a rate for people.
fn short(p: f64) -> String {
    if p == 0.0 { "0".into() } else { format!("{p:.3e}") }
}

/// SHA-256 in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

/// A text for an attribute or an element of XML.
fn escaped(text: &str) -> String {
    let text = crate::source::visible::line(text).into_owned();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The most modes of which pairs are formed: 19,900 pairs, each with a gate and a set of its own. Chosen by hand.
pub const MOST_MODES: usize = 200;

/// The modes that the fault tree counts: those with a rate, or all if none has one.
pub fn counted(model: &Model) -> Vec<usize> {
    let any = model.modes.iter().any(|mode| mode.rate.is_some());
    (0..model.modes.len()).filter(|&mode| !any || model.modes[mode].rate.is_some()).collect()
}

/// The modes with a rate, and their exposures: for how long a phase leaves them uncovered.
fn rated(model: &Model, evidence: &Evidence, uncovered: impl Fn(&ModeEvidence, &Phase) -> f64) -> Vec<Rated> {
    let of_mode = |(index, mode): (usize, &crate::model::FaultMode)| {
        let rate = quantities::rounded(3600.0 * mode.rate?);
        let open = |phase: &Phase| {
            let seconds = uncovered(&evidence.modes[index], phase);
            (seconds > 0.0).then(|| (phase.clone(), seconds))
        };
        let exposed = evidence.phases.iter().filter_map(open).collect();
        Some(Rated { mode: index, rate_per_h: rate, spread: mode.rate_spread, exposed })
    };
    model.modes.iter().enumerate().filter_map(of_mode).collect()
}

/// All pairs of different modes that are [`counted`].
fn pairs(model: &Model) -> Vec<([usize; 2], Option<Outcome>)> {
    let counted = counted(model);
    let mut pairs = Vec::new();
    let mut joint = model.clone();
    joint.modes.clear();
    for (at, &a) in counted.iter().enumerate() {
        for &b in &counted[at + 1..] {
            let rotors = together(&model.modes[a].rotors, &model.modes[b].rotors);
            joint.modes.extend(rotors.clone().map(|rotors| {
                let name = format!("{}_{}", model.modes[a].name, model.modes[b].name);
                crate::model::FaultMode { name, rotors, ..model.modes[a].clone() }
            }));
            pairs.push(([a, b], rotors.is_some()));
        }
    }
    let mut outcomes = analyze_each(&joint).into_iter().skip(1).map(|found| found.outcome);
    pairs.into_iter().map(|(pair, known)| (pair, if known { outcomes.next() } else { None })).collect()
}

/// What two faults leave of each rotor: a lost rotor stays lost; `None` if a rotor has two other faults that differ.
fn together(a: &[RotorState], b: &[RotorState]) -> Option<Vec<RotorState>> {
    let both = |(a, b): (&RotorState, &RotorState)| match (*a, *b) {
        (RotorState::Lost, _) | (_, RotorState::Lost) => Some(RotorState::Lost),
        (RotorState::Sound, other) | (other, RotorState::Sound) => Some(other),
        (one, other) => (one == other).then_some(one),
    };
    a.iter().zip(b).map(both).collect()
}

/// `rotor 3`, `rotors 1 and 2`: what fails in a mode.
fn item(model: &Model, mode: usize) -> String {
    let failed = model.modes[mode].rotors.iter().enumerate().filter(|(_, state)| **state != RotorState::Sound);
    let failed: Vec<String> = failed.map(|(rotor, _)| (rotor + 1).to_string()).collect();
    match &failed[..] {
        [] => "none".into(),
        [one] => format!("rotor {one}"),
        [others @ .., last] => format!("rotors {} and {last}", others.join(" ")),
    }
}

/// What the rotors of a mode still give.
fn local_effect(model: &Model, mode: usize) -> String {
    let of_state = |state: &RotorState| match state {
        RotorState::Sound => None,
        RotorState::Lost => Some("no thrust and no torque".to_string()),
        RotorState::Reduced(share) => {
            Some(format!("{} % of the thrust and torque of the speed", number(100.0 * share)))
        }
        RotorState::Stuck(share) => Some(format!("thrust stays at {} % of full thrust", number(100.0 * share))),
    };
    let mut effects: Vec<String> = model.modes[mode].rotors.iter().filter_map(of_state).collect();
    effects.dedup();
    effects.join("; ")
}

#[cfg(test)]
mod tests {
    use super::together;
    use crate::model::RotorState::{Lost, Reduced, Sound, Stuck};

    #[test]
    fn two_faults_of_a_rotor_need_a_joint_effect() {
        assert_eq!(
            together(&[Lost, Sound, Sound], &[Reduced(0.5), Stuck(0.2), Sound]),
            Some(vec![Lost, Stuck(0.2), Sound])
        );
        assert_eq!(together(&[Reduced(0.5)], &[Reduced(0.5)]), Some(vec![Reduced(0.5)]));
        assert_eq!(together(&[Reduced(0.5)], &[Reduced(0.7)]), None);
    }
}
