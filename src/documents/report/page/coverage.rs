//! Which fault modes a plan covers, until when it does not cover others, and which it leaves out.

use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::admissible::without_yaw::planned::Provision;
use crate::flight::indistinguishable::listed;
use crate::model::Model;
use crate::number::fixed;
use crate::planner::studies::{Comparison, MissionPlan};

/// Most modes of a list that are named.
const MOST_NAMED: usize = 12;

/// Modes that a plan treats alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    pub name: &'static str,
    pub modes: String,
    /// Whether a fault of these modes meets a violation.
    pub is_bad: bool,
}

/// The modes that `solved` covers at every instant, those that it covers only after some instant, and the declared
/// modes that it leaves out; kinds without a mode are omitted. `analyses` has the healthy vehicle first.
pub fn coverage(
    model: &Model,
    analyses: &[ModeAnalysis],
    comparison: &Comparison,
    solved: &MissionPlan,
) -> Vec<Coverage> {
    let (mut always, mut later, mut caught) = (Vec::new(), Vec::new(), Vec::new());
    for (i, name) in comparison.modes.iter().enumerate() {
        match unsafe_until(solved, i) {
            _ if comparison.provisions[i] == Provision::Capture => caught.push(name.clone()),
            Some(until) => later.push(format!("{name} before {} s", fixed(until, 2))),
            None => always.push(name.clone()),
        }
    }
    let is_left_out = |i: &usize| !model.plan.against.contains(i);
    let left_out: Vec<usize> = (0..model.modes.len()).filter(is_left_out).collect();
    let kinds = [
        ("Covered at every instant:", always, false),
        ("Not covered:", later, true),
        ("Not covered, the vehicle falls until its spin catches it:", caught, true),
    ];
    let of_plan = kinds.into_iter().filter(|(_, modes, _)| !modes.is_empty());
    let of_plan = of_plan.map(|(name, modes, is_bad)| Coverage { name, modes: named(&modes), is_bad });
    let outcomes = Outcome::ALL.into_iter().filter_map(|outcome| {
        // The healthy vehicle comes first.
        let is_of = |i: &&usize| analyses.get(**i + 1).is_some_and(|analysis| analysis.outcome == outcome);
        let names: Vec<String> = left_out.iter().filter(is_of).map(|&i| model.modes[i].name.clone()).collect();
        (!names.is_empty()).then(|| format!("{} ({})", named(&names), outcome.words_of(names.len())))
    });
    let outcomes: Vec<String> = outcomes.collect();
    let others = (!outcomes.is_empty()).then(|| Coverage {
        name: "Not planned against:",
        modes: outcomes.join("; "),
        is_bad: false,
    });
    of_plan.chain(others).collect()
}

/// The instant before which a fault of a mode may meet a violation, s; `None` if it meets none at any instant. `mode`
/// is an index into the comparison's modes.
pub fn unsafe_until(solved: &MissionPlan, mode: usize) -> Option<f64> {
    let committed = solved.committed.get(mode).copied().filter(|until| *until > 0.0);
    committed.or_else(|| solved.outside.get(mode)?.last)
}

/// `M1, M2 and M3`, or the first of many.
fn named(modes: &[String]) -> String {
    match modes.len() {
        n if n <= MOST_NAMED => listed(&modes.iter().map(String::as_str).collect::<Vec<_>>()),
        n => format!("{} and {} more", modes[..MOST_NAMED - 1].join(", "), n - MOST_NAMED + 1),
    }
}
