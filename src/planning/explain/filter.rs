//! The deletion filter: statements are left out for good, one after the other, as long as the rest still has no plan.

use super::Conflict;
use super::oracle::{Answer, Part};
use super::question::Questions;
use super::statement::Statement;
use crate::model::Problem;
use std::collections::{BTreeMap, BTreeSet};

/// Statements whose weight is below this share of the largest are left out together, if possible. Chosen by hand.
const IDLE: f64 = 1e-6;

/// If more statements than this remain, the lighter half is left out together, if possible. Chosen by hand.
const FEW: usize = 8;

struct Filter<'q, 'a> {
    questions: &'q mut Questions<'a>,
    left_out: BTreeSet<Statement>,
    /// It was proved that the remaining statements have no plan; otherwise none was found.
    proved: bool,
    /// The proof holds only for the facets that the RIP plan selects.
    only_for_selection: bool,
    /// The proof holds only on the grid of the spec's samples.
    only_for_samples: bool,
    /// The weight of each remaining part.
    weights: BTreeMap<Part, f64>,
}

/// An irreducible subset of `statements` without a plan; `None` if all of them together have one, or if there is none
/// even without any of them.
pub(super) fn filter(questions: &mut Questions, statements: &[Statement]) -> Option<Conflict> {
    let (proved, only_for_selection, only_for_samples, weights) = match questions.without(&BTreeSet::new())? {
        Answer::Feasible => return None,
        Answer::Infeasible { weights, only_for_selection, only_for_samples } => {
            (true, only_for_selection, only_for_samples, weights)
        }
        Answer::NotFound(weights) => (false, false, true, weights),
    };
    let weights = summed(weights);
    let mut filter =
        Filter { questions, left_out: BTreeSet::new(), proved, only_for_selection, only_for_samples, weights };
    // Statements without rows come first: they have no multipliers, and a conflict that does not depend on time should
    // not name the time.
    let of = |wanted: fn(&Statement) -> bool| -> Vec<Statement> { statements.iter().copied().filter(wanted).collect() };
    filter.halve(&of(|s| matches!(s, Statement::Time)));
    filter.halve(&of(|s| matches!(s, Statement::Reserve)));
    filter.halve(&of(|s| matches!(s, Statement::Arrival(_) | Statement::Hold(_) | Statement::Stop(_))));
    filter.weigh_down(statements);
    let irreducible = filter.check(statements);
    let Filter { questions, left_out, proved, only_for_selection, only_for_samples, .. } = filter;
    let kept: Vec<Statement> = statements.iter().copied().filter(|s| !left_out.contains(s)).collect();
    let variant = questions.variant(&left_out);
    let (time, time_is_free) = questions.time_of(Problem::of(&variant)?);
    let conflict = Conflict {
        statements: kept,
        proved,
        only_for_selection,
        only_for_samples,
        irreducible,
        time,
        time_is_free,
        least_time: None,
    };
    (!conflict.statements.is_empty()).then_some(conflict)
}

/// The total weight of each part.
fn summed(weights: Vec<(Part, f64)>) -> BTreeMap<Part, f64> {
    let mut sums = BTreeMap::new();
    weights.into_iter().for_each(|(part, weight)| *sums.entry(part).or_default() += weight);
    sums
}

impl Filter<'_, '_> {
    /// Leaves statements out if the rest still has no plan. A proof is not exchanged for a search without a result.
    fn leave_out(&mut self, statements: &[Statement]) -> bool {
        let mut fewer = self.left_out.clone();
        fewer.extend(statements);
        match self.questions.without(&fewer) {
            Some(Answer::Infeasible { weights, only_for_selection, only_for_samples }) => {
                (self.proved, self.only_for_selection, self.only_for_samples) =
                    (true, only_for_selection, only_for_samples);
                self.weights = summed(weights);
            }
            Some(Answer::NotFound(weights)) if !self.proved => self.weights = summed(weights),
            _ => return false,
        }
        self.left_out = fewer;
        true
    }

    /// Leaves out all of some statements, otherwise as many of each half as possible.
    fn halve(&mut self, statements: &[Statement]) {
        if !statements.is_empty() && !self.leave_out(statements) && statements.len() > 1 {
            let (first, second) = statements.split_at(statements.len() / 2);
            self.halve(first);
            self.halve(second);
        }
    }

    fn weight(&self, statement: Statement) -> f64 {
        statement.parts().iter().filter_map(|part| self.weights.get(part)).sum()
    }

    /// Tries to leave out the statements with rows, by increasing weight, with weights updated after each success; of
    /// many statements the lightest are tried together.
    fn weigh_down(&mut self, statements: &[Statement]) {
        let mut waiting: Vec<Statement> = statements.iter().copied().filter(|s| s.has_rows()).collect();
        // Halved if that many could not be left out together.
        let mut most = waiting.len();
        while !waiting.is_empty() {
            let mut weighed: Vec<(f64, Statement)> = waiting.iter().map(|&s| (self.weight(s), s)).collect();
            // A stable sort: statements of equal weight stay in the order of flight.
            weighed.sort_by(|a, b| a.0.total_cmp(&b.0));
            let heaviest = weighed.last().map_or(0.0, |last| last.0);
            let idle = weighed.iter().take_while(|(weight, _)| *weight < IDLE * heaviest).count();
            let light = if weighed.len() > FEW { weighed.len() / 2 } else { 1 };
            let next: Vec<Statement> = weighed.iter().take(idle.max(light).min(most)).map(|(_, s)| *s).collect();
            if !self.leave_out(&next) && next.len() > 1 {
                most = next.len() / 2;
                continue;
            }
            waiting.retain(|s| !next.contains(s));
            if next.len() == 1 && waiting.len() > FEW {
                most = waiting.len();
            }
        }
    }

    /// Tries each remaining statement once more, and returns whether each is needed. Feasibility need not be monotone
    /// (waypoint times depend on the statements, a selection on the plan it is made from), so one may have become
    /// redundant.
    fn check(&mut self, statements: &[Statement]) -> bool {
        let mut kept: Vec<Statement> = statements.iter().copied().filter(|s| !self.left_out.contains(s)).collect();
        let mut needed = true;
        let mut at = 0;
        while at < kept.len() {
            if self.leave_out(&[kept[at]]) {
                kept.remove(at);
                (needed, at) = (true, 0);
                continue;
            }
            let mut fewer = self.left_out.clone();
            fewer.insert(kept[at]);
            needed &= self.questions.without(&fewer) == Some(Answer::Feasible);
            at += 1;
        }
        needed
    }
}
