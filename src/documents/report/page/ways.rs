//! The ways out that the page draws in space: the path of each from the detection of the fault to its end.

use super::chart::column;
use crate::model::Model;
use crate::motion::{X, Y, Z};
use crate::recovery::{FoundBranch, ModeRecovery, Recovery};
use crate::report::recovery::{OUTCOMES, WORDS, outcome, site_of};
use serde::Serialize;

/// Numbers in all paths together at most: a page stays small.
const MOST_NUMBERS: usize = 40_000;

/// Points of a path at most, and at least; where there is no room for these, every second way out is left out, or more.
const MOST_POINTS: usize = 48;
const FEWEST_POINTS: usize = 10;

/// The ways out after the faults of one mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeWays {
    pub name: String,
    /// In the order of time. At a time in none of them no way out was found.
    pub ways: Vec<WayContent>,
}

/// A way out, and the instants of the fault for which it is drawn: those nearest to its own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WayContent {
    /// s since the start of the plan.
    pub from: f64,
    /// s since the start of the plan.
    pub to: f64,
    /// When its fault strikes, when it begins, and when it ends, s since the start of the plan.
    pub fault: f64,
    pub begins: f64,
    pub ends: f64,
    /// The place of its outcome among [`OUTCOMES`], which colours it.
    pub order: usize,
    /// Where it leads, for people.
    pub words: String,
    /// m
    pub x: Vec<f64>,
    /// m
    pub y: Vec<f64>,
    /// m
    pub z: Vec<f64>,
}

/// Of every mode, in the order of the strips.
pub fn contents(model: &Model, recovery: &Recovery) -> Vec<ModeWays> {
    let count = |step: usize| -> usize {
        let pieces = recovery.modes.iter().flat_map(|mode| &mode.pieces);
        pieces.map(|piece| piece.branches.len().div_ceil(step)).sum()
    };
    let most = MOST_NUMBERS / (3 * FEWEST_POINTS);
    let step = (1..).find(|&step| count(step) <= most || count(step) == count(step + 1)).unwrap_or(1);
    let points = (MOST_NUMBERS / (3 * count(step).max(1))).clamp(FEWEST_POINTS, MOST_POINTS);
    let of_mode = |mode: &ModeRecovery| ModeWays {
        name: model.modes[mode.mode].name.clone(),
        ways: mode
            .pieces
            .iter()
            .flat_map(|piece| {
                let kept: Vec<&FoundBranch> =
                    piece.branches.iter().step_by(step).map(|index| &recovery.branches[*index]).collect();
                let middle = |k: usize| 0.5 * (kept[k].fault_at + kept[k + 1].fault_at);
                let last = kept.len().saturating_sub(1);
                let way = |k: usize| {
                    let from = if k == 0 { piece.from } else { middle(k - 1) };
                    way(model, kept[k], [from, if k == last { piece.to } else { middle(k) }], points)
                };
                (0..kept.len()).map(way).collect::<Vec<_>>()
            })
            .collect(),
    };
    recovery.modes.iter().map(of_mode).collect()
}

fn way(model: &Model, branch: &FoundBranch, [from, to]: [f64; 2], points: usize) -> WayContent {
    let FoundBranch { way, fault_at, delay, motion, .. } = branch;
    let name = outcome(Some(*way));
    let order = OUTCOMES.iter().position(|outcome| *outcome == name).unwrap_or(OUTCOMES.len() - 1);
    let words = site_of(model, *way).map_or(WORDS[order].to_string(), |site| format!("lands at {site}"));
    let along = |axis: usize| {
        let at = |k: usize| motion.at(motion.duration() * k as f64 / (points - 1) as f64)[axis][0];
        column((0..points).map(at))
    };
    let begins = fault_at + delay;
    let [x, y, z] = [X, Y, Z].map(along);
    WayContent { from, to, fault: *fault_at, begins, ends: begins + motion.duration(), order, words, x, y, z }
}
