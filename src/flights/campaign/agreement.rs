//! Whether the plans predict which flights are lost: losses compared with violations of the fault modes' sets.
//!
//! The prediction: a vehicle is lost if the fault strikes before the plan's last violation of the mode's set. Only
//! flights that were still flying when the fault struck are counted.
//!
//! A mode without full control violates its set at all times, whatever is planned. A prediction that only separates
//! such modes from the others is of little value, so the modes with hover inside their sets are also counted
//! separately.

use super::design::Design;
use super::statistics::Contingency;
use super::tally::Tally;
use crate::model::PlannerKind;

/// Over all declared modes, and over those with hover inside their sets.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    pub all: Scope,
    pub inside: Scope,
}

/// Agreement over some modes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scope {
    pub modes: usize,
    /// Over all distinct plans, and for each planner. If planners share a plan, the total counts it once.
    pub total: Contingency,
    pub planners: Vec<(PlannerKind, Contingency)>,
}

impl Agreement {
    /// From the flights counted so far.
    pub fn new(design: &Design, tally: &Tally) -> Self {
        let hold = |m: &usize| design.modes[*m].can_keep_reserve();
        Agreement {
            all: Scope::new(design, tally, (0..design.cases.modes).collect()),
            inside: Scope::new(design, tally, (0..design.cases.modes).filter(hold).collect()),
        }
    }
}

impl Scope {
    fn new(design: &Design, tally: &Tally, modes: Vec<usize>) -> Self {
        let mut scope = Scope { modes: modes.len(), ..Scope::default() };
        for (p, plan) in design.plans.iter().enumerate() {
            let is_repeated = design.is_repeated(p);
            let mut table = Contingency::default();
            for &m in &modes {
                let outside = &plan.outside[m];
                for (k, cell) in tally.cells(p, m).iter().enumerate() {
                    let predicted = outside.last.is_some_and(|last| design.fault_time(k) < last);
                    table.add(predicted, cell.lost, cell.struck);
                    if !is_repeated {
                        scope.total.add(predicted, cell.lost, cell.struck);
                    }
                }
            }
            scope.planners.push((plan.planner, table));
        }
        scope
    }
}
