//! The spec's own planner alone, at the spec's time or at its shortest: `mavc plan`.

use super::candidates::nothing_selected_at;
use super::found::{Found, hint_from};
use super::{Comparison, NOTHING_TO_SELECT_BY, NotFound, PlanOutcome, PlannerRun, Run, Setting, label};
use crate::model::PlannerKind;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::Hint;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
use crate::solve::Effort;
use std::iter;

/// Why RSP is not attempted where no mode has a plan.
pub(super) const NO_COMMON_TIME: &str =
    "no plan was found for any fault mode alone, so there is no time T_d to select facets at";

impl Setting<'_> {
    /// The spec's own planner, at the spec's time or at its shortest.
    pub(super) fn plan(&self) -> Comparison {
        let mut out = self.without_runs();
        let kind = self.model().plan.planner;
        let (set, name, initial_guesses) = match kind {
            PlannerKind::Rip => (self.sets.rip.clone(), "RIP", Vec::new()),
            PlannerKind::Rcp => (self.sets.joint.clone(), "RCP", Vec::new()),
            PlannerKind::Rsp => match self.rsp_set(&mut out) {
                Ok((set, initial_guesses)) => {
                    if let (Some(time), Some(rip)) = (self.fixed_time(), initial_guesses.first()) {
                        let ignoring = PlanOutcome::Planned(Box::new(self.solved(time, rip)));
                        let run = self.run(PlannerKind::Rip, &[], Run::Common, ignoring, &self.sets.rip);
                        out.ignoring = Some(Box::new(run));
                    }
                    (set, "RSP", initial_guesses)
                }
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
        let (run, outcome, effort) = match self.fixed_time() {
            Some(time) => {
                let (decision, effort) = at(time);
                (Run::Common, self.common(time, &decision), effort)
            }
            None if kind == PlannerKind::Rip => {
                let found = self.rip_own();
                (Run::Own, self.own_with_binding(&found, &set), found.effort)
            }
            None => {
                let found = match out.common_time.filter(|_| kind == PlannerKind::Rsp) {
                    Some(common) => self.rsp_shortest(&set, common, nothing_selected, &initial_guesses),
                    None => self.search(name, &set, Hint::default(), WorkingSet::default()),
                };
                (Run::Own, self.own_with_binding(&found, &set), found.effort)
            }
        };
        out.effort += effort;
        out.runs.push(self.run(kind, against, run, outcome, &set));
        out
    }

    /// A run's planner once more, in the same set and from the run's plan; `None` if that has none.
    pub(super) fn again(&self, run: &PlannerRun) -> Option<(PlannerRun, Effort)> {
        let planned = run.outcome.plan()?.planned.as_deref()?;
        let (name, set) = (label(run.planner, &run.against), &run.set);
        let (outcome, effort) = match self.fixed_time() {
            Some(time) => {
                let (decision, effort) = self.at(&name, set, time, WorkingSet::default(), &[planned]);
                (self.common(time, &decision), effort)
            }
            None => {
                let hint = Hint { initial_guesses: vec![planned.clone()], ..Hint::default() };
                let found = self.search(&name, set, hint, WorkingSet::default());
                (self.own(&found), found.effort)
            }
        };
        Some((PlannerRun { outcome, ..run.clone() }, effort))
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
        self.rsp_set_at(time, rcp, out)
    }

    /// Steps (d) and (e): the RIP plan at `time` s, and the healthy set with the facets that it violates; also the
    /// initial guesses of RSP's plan, RIP's and then RCP's. `rcp` is the joint RCP's plan at that time.
    pub(super) fn rsp_set_at(
        &self,
        time: f64,
        rcp: Option<&Planned>,
        out: &mut Comparison,
    ) -> Result<(PlanningSet, Vec<Planned>), PlanOutcome> {
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

    /// RSP's shortest time for the facets selected at T_d = `common`; `initial_guesses` are those of
    /// [`Self::rsp_set_at`].
    pub(super) fn rsp_shortest(
        &self,
        set: &PlanningSet,
        common: f64,
        nothing_selected: bool,
        initial_guesses: &[Planned],
    ) -> Found {
        if let (true, Some(rip)) = (nothing_selected, initial_guesses.first()) {
            return nothing_selected_at(rip);
        }
        let mut effort = Effort::default();
        // The SCP planner starts from RCP's plan, which RSP's set allows; the hover planner's search uses the verdict
        // on T_d.
        let decision = match initial_guesses.get(1).filter(|_| self.finds_local_optima()) {
            Some(rcp) => Decision::Feasible(Box::new(rcp.clone())),
            None => {
                let guesses: Vec<&Planned> = initial_guesses.iter().collect();
                let (decision, spent) = self.rsp_at("RSP", set, common, &guesses, None);
                effort += spent;
                decision
            }
        };
        let hint = Hint { initial_guesses: initial_guesses.to_vec(), ..hint_from(common, decision) };
        let mut found = self.rsp_own("RSP", set, hint, WorkingSet::default());
        found.effort += effort;
        found
    }
}
