//! Where inside the interval of a figure the outcome of a mode changes: what a measurement of the figure would decide.

use super::outcome;
use crate::admissible::outcome::Outcome;
use crate::admissible::{AdmissibleSet, HEALTHY, verdict};
use crate::model::{DynamicFigure, Model};
use crate::number::significant;
use serde::Serialize;

/// Halvings of an interval: to a thousandth of its width.
const HALVINGS: usize = 10;
/// At most so many modes are looked at, because each takes a dozen verdicts (chosen by hand).
const MOST: usize = 32;

/// A change of a mode's outcome inside the interval of one figure, the others in the middle of theirs. The outcomes at
/// the two ends differ; changes and changes back in between are not sought.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct IntervalFlip {
    /// `drag`, `yaw_drag` or `rotor_inertia`.
    pub field: &'static str,
    /// The mode's name.
    pub mode: String,
    /// The value at which the outcome changes, in `unit`; of a figure with several values the largest.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at: f64,
    /// The SI unit.
    pub unit: &'static str,
    /// The outcome at the lower end of the interval.
    pub below_outcome: Outcome,
    /// The outcome at the upper end.
    pub above_outcome: Outcome,
}

/// The changes of modes that are undecided. `outcomes` are those of the healthy vehicle, then of every declared mode.
pub fn interval_flips(model: &Model, outcomes: &[Outcome]) -> Vec<IntervalFlip> {
    let vehicle = &model.vehicle;
    let figures = DynamicFigure::ALL.into_iter().filter(|figure| !figure.spread(vehicle).is_none());
    let mut flips = Vec::new();
    if figures.clone().next().is_none() {
        return flips;
    }
    let mut middle = model.clone();
    DynamicFigure::ALL.into_iter().for_each(|figure| figure.place_middle(&mut middle.vehicle));
    let undecided = (0..outcomes.len()).filter(|k| outcomes[*k] == Outcome::Undecided).take(MOST);
    // What other intervals leave undecided, these do not decide.
    let modes: Vec<Option<usize>> = undecided
        .map(|k| k.checked_sub(1))
        .filter(|mode| outcome_alone(&middle, *mode) != Outcome::Undecided)
        .collect();
    for figure in figures {
        let mut alone = model.clone();
        for other in DynamicFigure::ALL.into_iter().filter(|other| *other != figure) {
            other.place_middle(&mut alone.vehicle);
        }
        flips.extend(modes.iter().filter_map(|mode| of_mode(&alone, figure, *mode)));
    }
    flips
}

/// The outcome of one mode, `None` for the healthy vehicle.
fn outcome_alone(model: &Model, mode: Option<usize>) -> Outcome {
    match mode {
        None => verdict::outcome(model, &AdmissibleSet::healthy(model)),
        Some(mode) => outcome(model, mode, verdict::outcome(model, &AdmissibleSet::of_mode(model, mode))),
    }
}

/// The change of one mode, `None` for the healthy vehicle; `model` has no other interval of a [`DynamicFigure`].
fn of_mode(model: &Model, figure: DynamicFigure, mode: Option<usize>) -> Option<IntervalFlip> {
    let at = |share: f64| outcome_alone(&model.at(figure, share), mode);
    let (below, above) = (at(0.0), at(1.0));
    if below == above {
        return None;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if at(middle) == below { low = middle } else { high = middle }
    }
    let spread = figure.spread(&model.vehicle);
    let factor = spread.low + 0.5 * (low + high) * (spread.high - spread.low);
    let entry = figure.entry();
    Some(IntervalFlip {
        field: entry.name,
        mode: mode.map_or(HEALTHY, |mode| &model.modes[mode].name).to_string(),
        at: factor * figure.largest(&model.vehicle),
        unit: entry.unit().unwrap_or("1"),
        below_outcome: below,
        above_outcome: above,
    })
}

impl IntervalFlip {
    /// `lost up to `yaw_drag` = 0.0019 N*m*s/rad, caught above`; without the mode.
    pub fn words(&self) -> String {
        let IntervalFlip { field, at, unit, below_outcome, above_outcome, .. } = self;
        let at = significant(*at, 3);
        format!("{} up to `{field}` = {at} {unit}, {} above", below_outcome.word(), above_outcome.word())
    }
}
