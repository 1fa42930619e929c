//! The spec's own planner alone, at the spec's time or at its shortest: `mavc plan`.

use super::candidates::nothing_selected_at;
use super::found::{Found, hint_from};
use super::{Comparison, NOTHING_TO_SELECT_BY, NotFound, PlanOutcome, Run, Setting};
use crate::model::PlannerKind;
use crate::planner::hover::{Decision, Planned};
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::Hint;
use crate::planner::working_set::WorkingSet;
use crate::solve::Effort;
use std::iter;

/// Why RSP is not attempted where no mode has a plan.
const NO_COMMON_TIME: &str = "no plan was found for any fault mode alone, so there is no time T_d to select facets at";

impl Setting<'_> {
    /// The spec's own planner, at the spec's time or at its shortest.
    pub(super) fn plan(&self) -> Comparison {
        let mut out = self.without_runs();
        let kind = self.model().plan.planner;
        let (set, name, initial_guesses) = match kind {
            PlannerKind::Rip => (self.sets.rip.clone(), "RIP", Vec::new()),
            PlannerKind::Rcp => (self.sets.joint.clone(), "RCP", Vec::new()),
            PlannerKind::Rsp => match self.rsp_set(&mut out) {
                Ok((set, initial_guesses)) => (set, "RSP", initial_guesses),
                Err(outcome) => {
                    let which = if self.fixed_time().is_some() { Run::Common } else { Run::Own };
                    out.runs.push(self.run(kind, &self.sets.names, which, outcome, &self.sets.rip));
                    return out;
                }
            },
        };
        let against: &[String] = if kind == PlannerKind::Rip { &[] } else { &self.sets.names };
        let guesses: Vec<&Planned> = initial_guesses.iter().collect();
        let nothing_selected = out.selected.is_empty();
        let at = |time: f64| match guesses.first() {
            // If nothing is selected, RSP's plan is RIP's.
            Some(&rip) if nothing_selected => (Decision::Feasible(Box::new(rip.clone())), Effort::default()),
            Some(_) => self.rsp_at(name, &set, time, &guesses, None),
            None if kind == PlannerKind::Rip => self.rip_at(name, time, None, None),
            None => self.at(name, &set, time, WorkingSet::default(), &guesses),
        };
        let (run, outcome, planned, effort) = match self.fixed_time() {
            Some(time) => {
                let (decision, effort) = at(time);
                (Run::Common, self.common(time, &decision), decision.planned().cloned(), effort)
            }
            None if kind == PlannerKind::Rip => {
                let found = self.rip_own();
                (Run::Own, self.own_with_binding(&found, &set), found.planned().cloned(), found.effort)
            }
            None if nothing_selected && !initial_guesses.is_empty() => {
                let found = nothing_selected_at(&initial_guesses[0]);
                (Run::Own, self.own_with_binding(&found, &set), found.planned().cloned(), found.effort)
            }
            None => {
                // The SCP planner starts from RCP's plan, which RSP's set allows; the hover planner's search uses the
                // verdict on T_d.
                let rcp = initial_guesses.get(1).filter(|_| self.finds_local_optima());
                let hint = match (out.common_time, rcp) {
                    (None, _) => Hint::default(),
                    (Some(common), Some(rcp)) => hint_from(common, Decision::Feasible(Box::new(rcp.clone()))),
                    (Some(common), None) => {
                        let (decision, effort) = at(common);
                        out.effort += effort;
                        hint_from(common, decision)
                    }
                };
                let found = self.rsp_own(
                    name,
                    &set,
                    Hint { initial_guesses: initial_guesses.clone(), ..hint },
                    WorkingSet::default(),
                );
                (Run::Own, self.own_with_binding(&found, &set), found.planned().cloned(), found.effort)
            }
        };
        out.effort += effort;
        let (outcome, plainer, effort) = match (kind, &planned) {
            // What the plan keeps of the modes' sets, imposed or not, the second pass keeps too.
            (PlannerKind::Rip | PlannerKind::Rsp, Some(plan)) => {
                let kept = self.sets.kept(self.model(), plan, &set);
                self.with_comfort(outcome, planned.as_ref(), &kept)
            }
            _ => self.with_comfort(outcome, planned.as_ref(), &set),
        };
        out.plainer = plainer;
        out.effort += effort;
        out.runs.push(self.run(kind, against, run, outcome, &set));
        out
    }

    /// Steps (c) to (e) for RSP alone: T_d, the RIP plan there, and the healthy set with the facets that it violates;
    /// also the initial guesses of RSP's plan, RIP's and then RCP's.
    fn rsp_set(&self, out: &mut Comparison) -> Result<(PlanningSet, Vec<Planned>), PlanOutcome> {
        let joint = self.seek_common_time(out);
        let rcp = joint.as_ref().and_then(Found::planned);
        let Some(time) = out.common_time else {
            let found = self.search("RIP", &self.sets.rip, Hint::default(), WorkingSet::default());
            out.effort += found.effort;
            return Err(match self.own(&found) {
                // Nothing is proved about RSP itself: the modes' sets are smaller than RSP's, and may not be proved
                // infeasible either.
                PlanOutcome::Planned(s) => PlanOutcome::NotAttempted { at: s.time, why: NO_COMMON_TIME.into() },
                PlanOutcome::NotFound(NotFound::Search { at, .. }) => {
                    PlanOutcome::NotAttempted { at, why: NOTHING_TO_SELECT_BY.into() }
                }
                outcome => outcome,
            });
        };
        let (decision, effort) = self.rip_at("RIP", time, rcp, None);
        out.effort += effort;
        match decision {
            Decision::Feasible(planned) => {
                let set = self.select(time, &planned, rcp, out);
                Ok((set, iter::once(*planned).chain(rcp.cloned()).collect()))
            }
            _ => Err(self.without_rip(time, &decision)),
        }
    }
}
