//! The sets that the page draws: rows of a mode's admissible set, as used for planning.

use super::MOST_MODES;
use super::chart::precise;
use crate::actuation::Wrench;
use crate::admissible::AdmissibleSet;
use crate::admissible::edge::HoverPlace;
use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::{Provision, Turning};
use crate::model::{FaultMode, Model, RotorState};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::{Comparison, PlanOutcome};
use serde::Serialize;

/// Rows of all sets shown together: a page stays small.
const MOST_ROWS: usize = 16_000;

/// A set with its name.
#[derive(Debug, Clone)]
pub struct ShownSet {
    pub name: String,
    /// Its title in the spec.
    pub title: Option<String>,
    /// Index of the mode in the comparison, if plans are measured against it.
    pub against: Option<usize>,
    pub set: PlanningSet,
    /// The core by which plans are measured, where they give up yaw; they are then measured by no wrench.
    pub core: Option<PlanningSet>,
}

impl ShownSet {
    /// The rows by which plans are measured.
    pub fn measure(&self) -> &[SetRow] {
        &self.core.as_ref().unwrap_or(&self.set).rows
    }

    /// The smallest margin of a wrench, or to a core of how a motion turns, in widths of the healthy set; negative
    /// outside.
    pub fn margin(&self, w: &Wrench, turning: &Turning) -> f64 {
        let of = |row: &SetRow| -row.violation(w) - row.of_core(Some(turning));
        self.measure().iter().map(of).fold(f64::INFINITY, f64::min)
    }
}

/// A set for the script.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetContent {
    pub name: String,
    pub title: Option<String>,
    /// Rotors that the mode affects: the index, counted from 0, and whether the rotor is lost.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub struck: Vec<(usize, bool)>,
    /// Where hover lies relative to the mode's whole set of full wrenches, as `mavc analyze` reports it; `None` if
    /// unknown.
    pub hover: Option<HoverPlace>,
    /// Whether plans are measured against it, so that it has a column of margins.
    pub planned: bool,
    /// `[n_T, n_x, n_y, n_z, e]`, made dimensionless by the healthy set's widths: `n . w <= e`.
    pub rows: Vec<[f64; 5]>,
    /// `[n_T, n_x, n_y, n_z, e]`, made dimensionless likewise, of a flat set: `n . w = e`.
    pub equalities: Vec<[f64; 5]>,
    /// The core by which plans are measured where they give up yaw: `[a, b, e]`, thrusts T and torques of size rho
    /// about x and y with `a T + b rho <= e`. Empty where yaw is kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub core: Vec<[f64; 3]>,
}

impl SetContent {
    /// `mode` is that of the set; `None` for the healthy vehicle.
    pub fn new(shown: &ShownSet, mode: Option<&FaultMode>) -> Self {
        let states = mode.map_or(&[][..], |mode| &mode.rotors).iter().enumerate();
        let row = |r: &SetRow| [r.normal[0], r.normal[1], r.normal[2], r.normal[3], r.offset].map(precise);
        let (equalities, rows): (Vec<_>, Vec<_>) = shown.set.rows.iter().partition(|r| r.equality);
        SetContent {
            name: shown.name.clone(),
            title: shown.title.clone(),
            struck: states
                .filter(|(_, s)| **s != RotorState::Sound)
                .map(|(k, s)| (k, *s == RotorState::Lost))
                .collect(),
            hover: None,
            planned: shown.against.is_some(),
            rows: rows.into_iter().map(row).collect(),
            equalities: equalities.into_iter().map(row).collect(),
            core: shown.core.as_ref().map_or_else(Vec::new, core_rows),
        }
    }
}

/// Without the momenta: they change what the motion asks, not the core.
fn core_rows(core: &PlanningSet) -> Vec<[f64; 3]> {
    let row = |r: &SetRow| [r.normal[0], r.core.map_or(0.0, |c| c.torque), r.offset].map(precise);
    let mut rows: Vec<[f64; 3]> = core.rows.iter().map(row).collect();
    rows.dedup();
    rows
}

/// The healthy set first, then those of the modes planned against, in the comparison's order (of many modes, those with
/// the smallest margins), then other declared modes as far as they fit.
pub fn shown(model: &Model, comparison: &Comparison) -> Vec<ShownSet> {
    let nearest = |against: &usize| {
        let margins = comparison.runs.iter().filter_map(|run| match &run.outcome {
            PlanOutcome::Planned(s) => s.outside.get(*against).map(|o| -o.max_violation),
            _ => None,
        });
        margins.fold(f64::INFINITY, f64::min)
    };
    let mut order: Vec<usize> = (0..comparison.modes.len()).collect();
    order.sort_by(|a, b| nearest(a).total_cmp(&nearest(b)));
    let mut kept: Vec<usize> = order.into_iter().take(MOST_MODES).collect();
    kept.sort_unstable();
    let healthy = AdmissibleSet::healthy(model);
    let measured = kept.into_iter().map(|against| match &comparison.provisions[against] {
        Provision::WithYaw => ShownSet {
            name: comparison.modes[against].clone(),
            title: model.modes[model.plan.against[against]].title.clone(),
            against: Some(against),
            set: comparison.sets[against].clone(),
            core: None,
        },
        // The whole set is drawn.
        Provision::WithoutYaw(_) => ShownSet {
            against: Some(against),
            core: Some(comparison.sets[against].clone()),
            ..mode(model, model.plan.against[against], &healthy)
        },
        Provision::Capture => mode(model, model.plan.against[against], &healthy),
    });
    let others = (0..model.modes.len()).filter(|i| !model.plan.against.contains(i)).map(|i| mode(model, i, &healthy));
    within_reason(std::iter::once(whole(model, &healthy)).chain(measured).chain(others))
}

/// The healthy set and those of declared modes, if nothing was planned.
pub fn declared(model: &Model) -> Vec<ShownSet> {
    let healthy = AdmissibleSet::healthy(model);
    let against = model.plan.against.iter().copied();
    let others = (0..model.modes.len()).filter(|i| !model.plan.against.contains(i));
    let modes = against.chain(others).map(|i| mode(model, i, &healthy));
    within_reason(std::iter::once(whole(model, &healthy)).chain(modes))
}

/// The first set, and the sets after it as long as all have at most [`MOST_ROWS`] rows together.
fn within_reason(sets: impl Iterator<Item = ShownSet>) -> Vec<ShownSet> {
    let mut rows = 0;
    let fits = |s: &ShownSet| {
        rows += s.set.rows.len();
        rows <= MOST_ROWS
    };
    sets.take(MOST_MODES + 1).take_while(fits).collect()
}

fn planned(model: &Model, set: &AdmissibleSet, healthy: &AdmissibleSet) -> PlanningSet {
    PlanningSet::of(&[&set.guaranteed(model).with_reserve(model.plan.reserve)], healthy)
}

fn whole(model: &Model, healthy: &AdmissibleSet) -> ShownSet {
    ShownSet {
        name: healthy.name.clone(),
        title: None,
        against: None,
        set: planned(model, healthy, healthy),
        core: None,
    }
}

fn mode(model: &Model, index: usize, healthy: &AdmissibleSet) -> ShownSet {
    let set = AdmissibleSet::of_mode(model, index);
    let title = model.modes[index].title.clone();
    ShownSet { name: set.name.clone(), title, against: None, set: planned(model, &set, healthy), core: None }
}
