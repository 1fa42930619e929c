//! Whether what the plans predict comes true: flights lost against the times outside the fault sets.
//!
//! A mode that leaves no full control is outside its set all the time, whatever is planned. A prediction that only
//! tells such modes from the others is worth little, so the modes with hover inside their sets are counted apart.
//!
//! The prediction: a vehicle is lost where the fault strikes before the plan is outside the mode's set for the last
//! time. Only flights that lived to the fault say anything about it.

use super::design::Design;
use super::statistics::{Contingency, spearman};
use super::tally::Tally;
use crate::model::PlannerKind;

/// Below this a phi coefficient or a rank correlation says nothing; above the others it is moderate, and strong.
const CHANCE: f64 = 0.1;
const MODERATE: f64 = 0.3;
const STRONG: f64 = 0.5;

/// Over all declared modes, and over those with hover inside their sets.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    pub all: Scope,
    pub inside: Scope,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scope {
    pub modes: usize,
    /// Over all distinct plans, and for each planner. If planners share a plan, the total counts it once.
    pub total: Contingency,
    pub planners: Vec<(PlannerKind, Contingency)>,
    /// Of seconds outside with the share lost, over plans and modes.
    pub rank_correlation: Option<f64>,
    /// Pairs of plan and mode with struck flights.
    pub pairs: usize,
}

/// What a measure of agreement is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Worth {
    /// Predictions or observations are all the same.
    Undefined,
    /// The opposite of what is predicted happens more often than chance would have it.
    Opposite,
    Chance,
    Weak,
    Moderate,
    Strong,
}

impl Worth {
    pub fn of(measure: Option<f64>) -> Worth {
        match measure {
            None => Worth::Undefined,
            Some(m) if m <= -CHANCE => Worth::Opposite,
            Some(m) if m < CHANCE => Worth::Chance,
            Some(m) if m < MODERATE => Worth::Weak,
            Some(m) if m < STRONG => Worth::Moderate,
            Some(_) => Worth::Strong,
        }
    }
}

impl Agreement {
    pub fn new(design: &Design, tally: &Tally) -> Self {
        let hold = |m: &usize| design.inside[*m];
        Agreement {
            all: Scope::new(design, tally, (0..design.cases.modes).collect()),
            inside: Scope::new(design, tally, (0..design.cases.modes).filter(hold).collect()),
        }
    }
}

impl Scope {
    fn new(design: &Design, tally: &Tally, modes: Vec<usize>) -> Self {
        let mut scope = Scope { modes: modes.len(), ..Scope::default() };
        let mut pairs = Vec::new();
        for (p, plan) in design.plans.iter().enumerate() {
            let is_repeated =
                design.plans[..p].iter().any(|earlier| earlier.trajectory.is_same_motion(&plan.trajectory));
            let mut table = Contingency::default();
            for &m in &modes {
                let outside = &plan.outside[m];
                let (mut struck, mut lost) = (0, 0);
                for (k, cell) in tally.cells(p, m).iter().enumerate() {
                    let predicted = outside.last.is_some_and(|last| design.fault_time(k) < last);
                    table.add(predicted, cell.lost, cell.struck);
                    if !is_repeated {
                        scope.total.add(predicted, cell.lost, cell.struck);
                    }
                    struck += cell.struck;
                    lost += cell.lost;
                }
                if struck > 0 && !is_repeated {
                    pairs.push((outside.seconds, lost as f64 / struck as f64));
                }
            }
            scope.planners.push((plan.planner, table));
        }
        scope.rank_correlation = spearman(&pairs);
        scope.pairs = pairs.len();
        scope
    }
}
