//! The first line of every answer: what the fault modes leave of the vehicle.

use super::mode_names::within;
use crate::admissible::HEALTHY;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::flight::equilibrium::flips::{IntervalFlip, interval_flips};
use crate::model::{FaultMode, Model, RotorState};
use crate::number::{part_of_all, plural};
use std::collections::BTreeSet;

/// Most columns of a list of modes.
const NAMES: usize = 40;
/// Most rotors of a mode that are listed.
const MOST_ROTORS: usize = 4;

/// What fails in a mode, for counting modes of the same kind together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// So many rotors are lost, and nothing else.
    Lost(usize),
    Reduced,
    Stuck,
    Mixed,
    Nothing,
}

impl Kind {
    fn of(mode: &FaultMode) -> Self {
        let (mut lost, mut reduced, mut stuck) = (0, 0, 0);
        for rotor in &mode.rotors {
            match rotor {
                RotorState::Sound => {}
                RotorState::Lost => lost += 1,
                RotorState::Reduced(_) => reduced += 1,
                RotorState::Stuck(_) => stuck += 1,
            }
        }
        match (lost, reduced, stuck) {
            (0, 0, 0) => Kind::Nothing,
            (lost, 0, 0) => Kind::Lost(lost),
            (0, _, 0) => Kind::Reduced,
            (0, 0, _) => Kind::Stuck,
            _ => Kind::Mixed,
        }
    }

    /// The modes of a kind: `any single rotor lost` where these are all that there could be, else `3 single losses`.
    fn called(self, modes: &[&FaultMode], rotors: usize) -> String {
        let n = modes.len();
        if let [one] = modes {
            return format!("{} ({})", one.name, self.of_one());
        }
        match self {
            Kind::Lost(k) if are_all(modes, rotors, k) => match k {
                1 => "any single rotor lost".into(),
                2 => "any two rotors lost".into(),
                3 => "any three rotors lost".into(),
                k => format!("any {k} rotors lost"),
            },
            Kind::Lost(1) => format!("{n} single losses"),
            Kind::Lost(2) => format!("{n} double losses"),
            Kind::Lost(3) => format!("{n} triple losses"),
            Kind::Lost(k) => format!("{n} losses of {k} rotors"),
            Kind::Reduced => format!("{n} modes of reduced thrust"),
            Kind::Stuck => format!("{n} modes of stuck rotors"),
            Kind::Mixed => format!("{n} mixed modes"),
            Kind::Nothing => format!("{n} modes in which nothing fails"),
        }
    }

    fn of_one(self) -> String {
        match self {
            Kind::Lost(1) => "one rotor lost".into(),
            Kind::Lost(k) => format!("{k} rotors lost"),
            Kind::Reduced => "reduced thrust".into(),
            Kind::Stuck => "stuck".into(),
            Kind::Mixed => "mixed faults".into(),
            Kind::Nothing => "nothing fails".into(),
        }
    }
}

/// What fails in each of some declared modes, alike ones together in the order of the first of each: `one rotor lost`,
/// `2 rotors reduced to 60 %`.
pub fn by_failure(model: &Model, modes: impl Iterator<Item = usize>) -> Vec<(String, Vec<usize>)> {
    let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
    for mode in modes {
        let text = failure(&model.modes[mode]);
        match groups.iter_mut().find(|(of, _)| *of == text) {
            Some((_, modes)) => modes.push(mode),
            None => groups.push((text, vec![mode])),
        }
    }
    groups
}

/// What fails in some modes that fail alike; for a single mode that is not named after its rotors, these.
pub fn of_modes(model: &Model, what: &str, modes: &[usize]) -> String {
    let rotors = if let [mode] = modes { by_rotors(&model.modes[*mode]) } else { None };
    rotors.unwrap_or(what.into())
}

/// What fails in a mode by its rotors, `rotors 2, 3 lost`; `None` if its name has their numbers, as `M2_3`, if they are
/// all or many, and if they do not fail alike.
pub fn by_rotors(mode: &FaultMode) -> Option<String> {
    let failed: Vec<usize> = (1..=mode.rotors.len()).filter(|k| mode.rotors[k - 1] != RotorState::Sound).collect();
    let in_name: Vec<usize> = mode.name.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok()).collect();
    let are_few = failed.len() <= MOST_ROTORS && failed.len() < mode.rotors.len();
    let how = how_all(mode).filter(|_| are_few && in_name != failed)?;
    let numbers: Vec<String> = failed.iter().map(usize::to_string).collect();
    Some(format!("rotor{} {} {how}", if failed.len() == 1 { "" } else { "s" }, numbers.join(", ")))
}

/// How all rotors that fail in a mode do; `None` if they do not fail alike.
fn how_all(mode: &FaultMode) -> Option<String> {
    let mut failed = mode.rotors.iter().filter(|rotor| **rotor != RotorState::Sound);
    let first = failed.next()?;
    if failed.any(|rotor| rotor != first) {
        return None;
    }
    Some(match first {
        RotorState::Reduced(share) => format!("reduced to {} %", part_of_all(*share)),
        RotorState::Stuck(share) => format!("stuck at {} %", part_of_all(*share)),
        RotorState::Sound | RotorState::Lost => "lost".into(),
    })
}

/// What fails in a mode; shares only if all its rotors have the same.
fn failure(mode: &FaultMode) -> String {
    let rotors = match mode.rotors.iter().filter(|rotor| **rotor != RotorState::Sound).count() {
        1 => "one rotor".to_string(),
        n => plural(n, "rotor"),
    };
    how_all(mode).map_or(Kind::of(mode).of_one(), |how| format!("{rotors} {how}"))
}

/// Whether the modes are all losses of `k` of so many rotors, each of them once.
fn are_all(modes: &[&FaultMode], rotors: usize, k: usize) -> bool {
    let different: BTreeSet<Vec<usize>> = modes.iter().map(|mode| mode.lost()).collect();
    let ways = (0..k).fold(1_u128, |ways, i| ways * (rotors - i) as u128 / (i as u128 + 1));
    different.len() == modes.len() && different.len() as u128 == ways
}

/// What the fault modes of a vehicle leave of it, in one sentence without a full stop: `survey_hexa: any single rotor
/// lost: 4 of 6 full control, 2 of 6 fly on, heading not held`. `outcomes` are those of the healthy vehicle, then of
/// every declared mode; modes of different kinds are counted apart.
pub fn headline_of(model: &Model, outcomes: &[Outcome]) -> String {
    let name = &model.vehicle.name;
    let (healthy, outcomes) = outcomes.split_first().map_or((Outcome::Lost, outcomes), |(first, rest)| (*first, rest));
    let mut parts = Vec::new();
    if healthy != Outcome::FullControl || model.modes.is_empty() {
        parts.push(match healthy {
            Outcome::Lost => "cannot hover even without a fault".to_string(),
            Outcome::FullControl => "full control without a fault".to_string(),
            _ => format!("without a fault: {}", healthy.word()),
        });
    }
    if model.modes.is_empty() {
        parts.push("no fault modes declared".into());
    }
    let kinds: Vec<Kind> = model.modes.iter().map(Kind::of).collect();
    for kind in kinds.iter().collect::<BTreeSet<_>>() {
        let of_kind: Vec<usize> = (0..kinds.len().min(outcomes.len())).filter(|&m| kinds[m] == *kind).collect();
        let declared: Vec<&FaultMode> = of_kind.iter().map(|&m| &model.modes[m]).collect();
        let counts: Vec<Outcome> = of_kind.iter().map(|&m| outcomes[m]).collect();
        parts.push(format!("{}: {}", kind.called(&declared, model.vehicle.rotors.len()), counted(&counts)));
    }
    format!("{name}: {}", parts.join("; "))
}

/// The sentence of [`headline_of`] for the modes of `mavc::analyze`.
pub fn headline(model: &Model, modes: &[ModeAnalysis]) -> String {
    headline_of(model, &modes.iter().map(|mode| mode.outcome).collect::<Vec<_>>())
}

/// `4 of 6 full control, 2 of 6 fly on, heading not held`; of one mode the word alone.
pub fn counted(outcomes: &[Outcome]) -> String {
    if let [one] = outcomes {
        return one.word().into();
    }
    let n = outcomes.len();
    let each = Outcome::ALL.iter().filter_map(|outcome| {
        let count = outcomes.iter().filter(|found| *found == outcome).count();
        (count > 0).then(|| format!("{count} of {n} {}", outcome.words_of(count)))
    });
    each.collect::<Vec<_>>().join(", ")
}

/// Why some outcomes are undecided, as a sentence for a note; `None` if none is. `outcomes` are those of the healthy
/// vehicle, then of every declared mode.
pub fn why_undecided(model: &Model, outcomes: &[Outcome]) -> Option<String> {
    let undecided = outcomes.iter().filter(|outcome| **outcome == Outcome::Undecided).count();
    let which = plural(undecided, "mode");
    if undecided == 0 {
        return None;
    }
    let flips = interval_flips(model, outcomes);
    if flips.is_empty() && model.vehicle.yaw_drag.is_none() && !model.vehicle.is_uncertain() {
        return Some(format!(
            "{which} undecided: hover needs a spin, and without `yaw_drag` of the vehicle its rate is unknown"
        ));
    }
    let names: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    let place = |flip: &IntervalFlip| names.iter().position(|name| *name == flip.mode);
    let mut alike: Vec<(String, Vec<usize>)> = Vec::new();
    for flip in flips {
        let (words, mode) = (flip.words(), place(&flip));
        match alike.iter_mut().find(|(same, _)| *same == words) {
            Some((_, modes)) => modes.extend(mode),
            None => alike.push((words, mode.into_iter().collect())),
        }
    }
    let of_modes = |(words, modes): &(String, Vec<usize>)| match modes.is_empty() {
        true => format!("{HEALTHY}: {words}"),
        false => format!("{}: {words}", within(&names, modes, NAMES)),
    };
    let flips: Vec<String> = alike.iter().map(of_modes).collect();
    Some(match flips.is_empty() {
        true => format!("{which} undecided: the vehicles of the spec's intervals differ in the outcome"),
        false => format!("{which} undecided. {}", flips.join("; ")),
    })
}
