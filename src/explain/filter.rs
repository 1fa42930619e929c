//! The deletion filter: leave statements out one after the other for good, as long as what is left still has no plan.

use super::Conflict;
use super::oracle::{Answer, Part};
use super::question::Questions;
use super::statement::Statement;
use std::collections::{BTreeMap, BTreeSet};

/// Statements that weigh less than this share of the heaviest are left out together, if they can be.
const IDLE: f64 = 1e-6;

/// Of more statements than this the lighter half is left out together, if it can be.
const FEW: usize = 8;

struct Filter<'q, 'a> {
    questions: &'q mut Questions<'a>,
    left_out: BTreeSet<Statement>,
    /// That what is left has no plan was proved, not only not found.
    proved: bool,
    /// And that it was proved of the facets that the RIP plan selects only.
    of_selection: bool,
    /// And that it was proved on the grid of the spec's samples only.
    of_samples: bool,
    /// What the parts of what is left weigh; no part is named twice.
    weights: BTreeMap<Part, f64>,
}

/// An irreducible set of `statements` that have no plan together; `None` where all have one, or none of them is to blame.
pub(super) fn filter(questions: &mut Questions, statements: &[Statement]) -> Option<Conflict> {
    let (proved, of_selection, of_samples, weights) = match questions.without(&BTreeSet::new())? {
        Answer::Feasible => return None,
        Answer::Infeasible { weights, of_selection, of_samples } => (true, of_selection, of_samples, weights),
        Answer::NotFound(weights) => (false, false, true, weights),
    };
    let weights = summed(weights);
    let mut filter = Filter { questions, left_out: BTreeSet::new(), proved, of_selection, of_samples, weights };
    // Multipliers say nothing of these; and a conflict that does not hang on time is told as such.
    let of = |wanted: fn(&Statement) -> bool| -> Vec<Statement> { statements.iter().copied().filter(wanted).collect() };
    filter.halve(&of(|s| matches!(s, Statement::Time)));
    filter.halve(&of(|s| matches!(s, Statement::Reserve)));
    filter.halve(&of(|s| matches!(s, Statement::Arrival(_) | Statement::Hold(_))));
    filter.weigh_down(statements);
    let irreducible = filter.check(statements);
    let Filter { questions, left_out, proved, of_selection, of_samples, .. } = filter;
    let kept: Vec<Statement> = statements.iter().copied().filter(|s| !left_out.contains(s)).collect();
    let (model, mission) = questions.variant(&left_out);
    let (time, any_time) = questions.time_of(&model, &mission);
    let conflict = Conflict { statements: kept, proved, of_selection, of_samples, irreducible, time, any_time };
    (!conflict.statements.is_empty()).then_some(conflict)
}

/// What each part weighs in all.
fn summed(weights: Vec<(Part, f64)>) -> BTreeMap<Part, f64> {
    let mut sums = BTreeMap::new();
    weights.into_iter().for_each(|(part, weight)| *sums.entry(part).or_default() += weight);
    sums
}

impl Filter<'_, '_> {
    /// Leaves statements out if what is left still has no plan. What was proved is not given up for what was not found.
    fn leave_out(&mut self, statements: &[Statement]) -> bool {
        let mut fewer = self.left_out.clone();
        fewer.extend(statements);
        match self.questions.without(&fewer) {
            Some(Answer::Infeasible { weights, of_selection, of_samples }) => {
                (self.proved, self.of_selection, self.of_samples) = (true, of_selection, of_samples);
                self.weights = summed(weights);
            }
            Some(Answer::NotFound(weights)) if !self.proved => self.weights = summed(weights),
            _ => return false,
        }
        self.left_out = fewer;
        true
    }

    /// Leaves out all of some statements, or as many of each half.
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

    /// The statements with rows by rising weight, weighed anew whenever some have gone; the lightest of many together.
    fn weigh_down(&mut self, statements: &[Statement]) {
        let mut waiting: Vec<Statement> = statements.iter().copied().filter(|s| s.has_rows()).collect();
        // Halved where so many could not go.
        let mut most = waiting.len();
        while !waiting.is_empty() {
            let mut weighed: Vec<(f64, Statement)> = waiting.iter().map(|&s| (self.weight(s), s)).collect();
            // A stable sort: those of one weight stay in the order of flight.
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

    /// Leaves each of what is left out once more. Where more asks for less than it seems (waypoint times move with what is
    /// asked, a selection with the plan it is made from) one may have become idle: it goes. Whether each is needed.
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
