//! Rounds of selection: step (e) of section 5.3 of the paper, repeated at one mission time.
//!
//! RIP is zero rounds, RSP one. Facets violated at any node, in the exact model at any instant, are selected and
//! imposed at all of them. In the hover model, at a time at which RCP has a plan, rounds end at RCP's plan: each
//! program is a relaxation of RCP's, and a plan that violates no facet solves it.

use super::{Comparison, Setting};
use crate::planner::selection::PlanningSet;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
use std::iter;

impl Setting<'_> {
    /// Step (e) for the spec's number of rounds, from the RIP plan at T_d: RSP's set. The selected facets go to `out`.
    /// `rcp` is a plan of the joint set, if one is known.
    pub(super) fn select(&self, time: f64, rip: &Planned, rcp: Option<&Planned>, out: &mut Comparison) -> PlanningSet {
        let mut planned = rip.clone();
        for round in 1..=self.model().plan.rounds {
            if round > 1 {
                let set = self.sets.rip.with(out.selected.clone());
                let (decision, effort) = {
                    let initial_guesses: Vec<&Planned> = iter::once(&planned).chain(rcp).collect();
                    self.at("RSP", &set, time, WorkingSet::default(), &initial_guesses)
                };
                out.effort += effort;
                match decision {
                    Decision::Feasible(next) => planned = *next,
                    _ => break,
                }
            }
            out.selected_by.push(planned.trajectory());
            let new = self.sets.violated(self.model(), &planned);
            if new.is_empty() {
                break;
            }
            out.selected.extend(new);
        }
        self.sets.rip.with(out.selected.clone())
    }
}
