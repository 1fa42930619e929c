//! Why there is no plan: an irreducible set of statements for which together none exists or none was found, and
//! changes that were tried and give a plan.
//!
//! Whether statements can hold together is decided by an [`Oracle`], the only interface to planners here.

mod bound;
pub mod detour;
pub mod diagnose;
mod filter;
mod grid;
mod instruction;
pub mod nearby;
pub mod oracle;
pub mod planners;
mod question;
pub mod remedy;
pub mod statement;

pub use oracle::{Answer, Oracle, Part};
pub use remedy::{Change, Fix};
pub use statement::Statement;

use crate::model::{PlanModel, Problem};
use crate::verdict::Verdict;
use question::Questions;

/// Most oracle queries of the search for a conflict. Chosen by hand.
pub const MOST_QUESTIONS: usize = 150;

/// Most additional oracle queries of the search for changes. Chosen by hand.
pub const MOST_TRIES: usize = 150;

/// Most queries for a conflict, and most additional ones for changes, in the exact model, where each query solves a
/// sequence of programs. Chosen by hand.
pub const MOST_ATTEMPTS: [usize; 2] = [60, 30];

/// Statements that are not satisfied together, and what was shown about them.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// In the order of [`statement::statements`].
    pub statements: Vec<Statement>,
    /// Whether it was proved that no plan satisfies them all; otherwise none was found.
    pub proved: bool,
    /// RSP: the proof holds only for the facets that the RIP plan selects.
    pub only_for_selection: bool,
    /// The proof holds only on the grid of the spec's samples; false if it holds for every grid.
    pub only_for_samples: bool,
    /// Whether a plan was found for the others whenever one of them was left out.
    pub irreducible: bool,
    /// The mission time at which plans were searched for, s.
    pub time: f64,
    /// None of them fixes the mission time: `time` is a time that is long for the mission.
    pub time_is_free: bool,
    /// Where a lower bound on the time is the proof: the least time of motions that keep all statements, s, which is
    /// above the required time and would not be without any one of them.
    pub least_time: Option<f64>,
}

impl Conflict {
    /// The verdict on the question whether a plan satisfies all statements at [`Conflict::time`].
    pub fn verdict(&self) -> Verdict {
        if self.proved { Verdict::ProvedInfeasible } else { Verdict::NotFound }
    }
}

/// A conflict and the single changes to the whole spec that give a plan, cheapest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    pub conflict: Conflict,
    pub fixes: Vec<Fix>,
    /// Number of oracle queries.
    pub questions: usize,
}

/// Explains why `oracle` has no plan for a mission. `None` if it has one at the required time (a long time if the spec
/// leaves it free), or finds none even when every statement is left out.
///
/// Algorithm: the deletion filter of J. W. Chinneck, *Feasibility and Infeasibility in Optimization* (2008), over the
/// statements of a spec: statements without rows first, the others by increasing weight in the multipliers that prove
/// the remaining statements infeasible. Where a lower bound on the time excludes the required time, the bound is asked
/// in place of the oracle, and no change is sought.
pub fn explain(problem: Problem, oracle: &mut dyn Oracle) -> Option<Explanation> {
    if let Some(explanation) = bound::too_short(problem) {
        return Some(explanation);
    }
    let [most_questions, most_tries] = match problem.model().plan.model {
        PlanModel::Hover => [MOST_QUESTIONS, MOST_TRIES],
        PlanModel::Exact => MOST_ATTEMPTS,
    };
    let mut questions = Questions::new(problem, oracle, most_questions);
    let conflict = filter::filter(&mut questions, &statement::statements(problem))?;
    questions.allow(most_tries);
    let fixes = remedy::fixes(&mut questions, &conflict);
    Some(Explanation { conflict, fixes, questions: questions.asked() })
}
