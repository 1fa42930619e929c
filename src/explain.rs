//! Why there is no plan: an irreducible set of statements that cannot hold together, and changes that were tried and
//! work.
//!
//! Whether some statements hold together is asked of an [`Oracle`], which is all that is known of planners here.

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

use crate::model::{Mission, Model, PlanModel};
use crate::verdict::Verdict;
use question::Questions;

/// Questions that the search for a conflict may ask.
pub const MOST_QUESTIONS: usize = 150;

/// Questions that the search for changes may ask, beside those.
pub const MOST_TRIES: usize = 150;

/// The same two in the exact model, where each question is a sequence of programs.
pub const MOST_ATTEMPTS: [usize; 2] = [60, 30];

/// Statements that are not met together, with what was shown of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// In the order of [`statement::statements`].
    pub statements: Vec<Statement>,
    /// Whether it was proved that no plan meets them all; otherwise none was found.
    pub proved: bool,
    /// It was proved of the facets that the RIP plan selects, by RSP.
    pub of_selection: bool,
    /// The proof holds on the grid of the spec's samples; false where it holds for every grid.
    pub of_samples: bool,
    /// Whether a plan was found for the others whenever one of them was left out.
    pub irreducible: bool,
    /// The mission time at which they were asked for, s.
    pub time: f64,
    /// None of them fixes the mission time: `time` is one that is long for the mission.
    pub any_time: bool,
}

impl Conflict {
    /// On the question whether a plan meets all of the statements at [`Conflict::time`].
    pub fn verdict(&self) -> Verdict {
        if self.proved { Verdict::ProvedInfeasible } else { Verdict::NotFound }
    }
}

/// A conflict and the single changes to the whole spec that give a plan, cheapest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    pub conflict: Conflict,
    pub fixes: Vec<Fix>,
    /// Times that the oracle was asked.
    pub questions: usize,
}

/// Explains why `oracle` has no plan for a mission. `None` where it has one at the time asked for (a long one where the
/// spec leaves time free), or finds none even when every statement is left out.
///
/// The deletion filter of J. W. Chinneck, *Feasibility and Infeasibility in Optimization* (2008), over the statements of
/// a spec: those without rows first, the others by rising weight in the multipliers that show what is left infeasible.
pub fn explain(model: &Model, mission: &Mission, oracle: &mut dyn Oracle) -> Option<Explanation> {
    let [most_questions, most_tries] = match model.plan.model {
        PlanModel::Hover => [MOST_QUESTIONS, MOST_TRIES],
        PlanModel::Exact => MOST_ATTEMPTS,
    };
    let mut questions = Questions::new(model, mission, oracle, most_questions);
    let conflict = filter::filter(&mut questions, &statement::statements(model, mission))?;
    questions.allow(most_tries);
    let fixes = remedy::fixes(&mut questions, &conflict);
    Some(Explanation { conflict, fixes, questions: questions.asked() })
}
