//! Fewer or unevenly placed nodes, with rows broken where there are none.

use super::{Kind, evaluated};
use crate::motion::{Timetable, Wish, evenly, holds};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::model::grid::leg_durations;
use mavc::motion::Trajectory;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("merged pieces", &[Premise::Density], merged),
    evaluated("one leg's pieces merged", &[Premise::Density], one_leg),
    evaluated("clustered nodes", &[Premise::Density], clustered),
];

fn merged(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    kept_at_nodes(spec, laid(spec, numbers, |numbers, _, _| Some(evenly(3 + numbers.below(4))))?)
}

fn one_leg(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let coarse = numbers.below(spec.truth.mission().legs.len());
    let motion = laid(spec, numbers, move |numbers, leg, count| {
        Some(if leg == coarse { evenly(3 + numbers.below(3)) } else { evenly(count) })
    })?;
    kept_at_nodes(spec, motion)
}

/// A forger looks at the nodes first.
fn kept_at_nodes(spec: &Spec, motion: Trajectory) -> Option<Certificate> {
    (spec.truth.tightest(&motion) <= 1.0).then(|| spec.claiming(&motion))
}

/// As many nodes as asked for or more, most of them near the ends of the leg, and one long piece.
fn clustered(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let motion = laid(spec, numbers, |numbers, _, count| {
        let (from, to) = (numbers.between(0.2, 0.45), numbers.between(0.55, 0.8));
        let half = count / 2 + numbers.below(8) + 1;
        let before = (1..=half).map(|i| from * i as f64 / half as f64);
        let after = (0..=half).map(|i| to + (1.0 - to) * i as f64 / half as f64);
        let mut shares: Vec<f64> = before.chain(after).collect();
        *shares.last_mut()? = 1.0;
        Some(shares)
    })?;
    Some(spec.claiming(&motion))
}

/// The least snap on nodes of the forger's choice: leg and count asked for to shares of the leg.
fn laid(
    spec: &Spec,
    numbers: &mut Numbers,
    mut within: impl FnMut(&mut Numbers, usize, usize) -> Option<Vec<f64>>,
) -> Option<Trajectory> {
    let mission = spec.truth.mission();
    let durations = leg_durations(mission, spec.total())?;
    let counts = mavc::model::grid::pieces(mission, &durations, spec.model().plan.samples);
    let shares: Option<Vec<Vec<f64>>> = counts.iter().enumerate().map(|(i, &n)| within(numbers, i, n)).collect();
    let table = Timetable::of(&holds(mission), &durations, &shares?);
    let motion = Wish::of(mission).motion(&table, spec.truth.equations)?;
    Some(motion)
}
