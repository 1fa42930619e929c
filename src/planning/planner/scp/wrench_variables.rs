//! Variables for the wrench at instants with many facets.
//!
//! The row of a facet couples the twenty or more variables on which the motion at its instant depends. Where many
//! facets hold at an instant, four variables u stand for the change of the wrench there, and a row has these, sigma and
//! epsilon. With the linearised wrench w(s) of (70), w_0 and its change w_t per relative change of time at the iterate,
//!
//! ```text
//! diag(unit) u = w(s) - w_0 + (4 w_0 + w_t) epsilon
//! e (1 + 4 epsilon) - n.w_0 - n.diag(unit) u + sigma >= 0
//! ```
//!
//! which with u eliminated is the row of (73).

use super::subproblem::{ORDER_OF_TIME, Step};
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use std::collections::BTreeMap;

/// The variables for the wrench of one program.
pub(super) struct WrenchVariables {
    /// By instant the first of its four variables.
    first: BTreeMap<usize, usize>,
    /// The change of each component that counts as one, N and N m: no facet's row then has a coefficient above one.
    unit: Wrench,
    /// The number of variables with those before.
    end: usize,
}

impl WrenchVariables {
    /// For the rows `chosen` of a program that has `before` other variables, at instants with at least `many` facets.
    pub fn of(chosen: &[RowAt], set: &PlanningSet, many: usize, before: usize) -> Self {
        let mut facets: BTreeMap<usize, usize> = BTreeMap::new();
        for RowAt { row, instant } in chosen {
            if matches!(row, Row::Facet(facet) if set.rows[*facet].core.is_none()) {
                *facets.entry(*instant).or_default() += 1;
            }
        }
        facets.retain(|_, facets| *facets >= many);
        let first: BTreeMap<usize, usize> = facets.into_keys().zip((before..).step_by(4)).collect();
        let largest = |k: usize| set.rows.iter().fold(0.0_f64, |most, row| most.max(row.normal[k].abs()));
        let unit = Wrench::from_fn(|k, _| if largest(k) > 0.0 { 1.0 / largest(k) } else { 1.0 });
        WrenchVariables { end: before + 4 * first.len(), first, unit }
    }

    /// The number of the program's variables.
    pub fn end(&self) -> usize {
        self.end
    }

    /// `n.diag(unit) u` at an instant; `None` where it has no variables.
    fn along(&self, instant: usize, n: &Wrench) -> Option<Affine> {
        let first = *self.first.get(&instant)?;
        let terms = (0..4).map(|k| (first + k, n[k] * self.unit[k])).filter(|term| term.1 != 0.0);
        Some(Affine { terms: terms.collect(), constant: 0.0 })
    }
}

impl Transcription<'_> {
    /// The slack of a facet at an instant with variables for its wrench; `None` elsewhere.
    pub(super) fn slack_in(
        &self,
        variables: &WrenchVariables,
        step: &Step,
        instant: usize,
        row: &SetRow,
    ) -> Option<Affine> {
        let mut slack = variables.along(instant, &-row.normal)?;
        slack.constant = row.offset - row.normal.dot(&step.wrenches[instant]);
        slack.add(&self.duration_change(self.leg_of(instant)), ORDER_OF_TIME * row.offset);
        Some(slack)
    }

    /// The equations of the variables for the wrench.
    pub(super) fn wrench_equations(&self, builder: &mut Builder, variables: &WrenchVariables, step: &Step) {
        for (&instant, &first) in &variables.first {
            let wrench = self.wrench_expression(instant);
            let now = step.wrenches[instant];
            let longer = ORDER_OF_TIME * now + step.time_sensitivities[instant];
            let epsilon = self.duration_change(self.leg_of(instant));
            for k in 0..4 {
                let n = Wrench::from_fn(|i, _| if i == k { 1.0 / variables.unit[k] } else { 0.0 });
                let mut row = wrench.along(&n).plus_constant(-n.dot(&now)).plus(first + k, -1.0);
                row.add(&epsilon, n.dot(&longer));
                builder.zero(row, RowOrigin::Wrench { node: instant / self.parts });
            }
        }
    }
}
