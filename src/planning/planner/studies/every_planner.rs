//! Every planner at its own shortest time and at T_d.

use super::found::{Found, hint_from};
use super::single_planner::NO_COMMON_TIME;
use super::{Comparison, NOTHING_TO_SELECT_BY, PlanOutcome, Run, Setting, label};
use crate::model::PlannerKind;
use crate::motion::Trajectory;
use crate::planner::hover::{Decision, Planned};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::candidates::nothing_selected_at;
use crate::planner::studies::order::put_in_order;
use crate::planner::timing::search::{Hint, RESOLUTION};
use crate::planner::working_set::WorkingSet;
use crate::solve::Effort;
use rayon::prelude::*;

/// What is known when RSP is planned.
#[derive(Clone, Copy)]
struct KnownPlans<'k> {
    rip: &'k Found,
    /// RIP's decision at T_d.
    rip_at: &'k Decision,
    /// The joint RCP's plan at its own time, which RSP's set allows.
    rcp: Option<&'k Planned>,
}

/// RSP at its own shortest time.
struct OwnRsp {
    outcome: PlanOutcome,
    set: PlanningSet,
    /// The plans that select the facets, if these are not those at T_d.
    selected_by: Option<Vec<Trajectory>>,
}

impl Setting<'_> {
    /// How many runs [`Self::everything`] makes where there is a T_d.
    pub(super) fn runs_of_everything(&self) -> usize {
        let modes = self.sets.names.len();
        let conservative = if modes > 1 { modes + 1 } else { modes };
        2 * (conservative + 2)
    }

    /// RIP, RCP per mode, RCP jointly and RSP, at their own shortest times and at T_d.
    pub(super) fn everything(&self) -> Comparison {
        // RIP and the tightest RCP first, in parallel: their times bound all others.
        let several = self.sets.names.len() > 1;
        let (rip, tightest) = rayon::join(
            || {
                let found = self.search("RIP", &self.sets.rip, Hint::default(), WorkingSet::default());
                self.ended(1);
                found
            },
            || {
                (!self.sets.names.is_empty()).then(|| {
                    let found = self.search("RCP", &self.sets.joint, Hint::default(), WorkingSet::default());
                    self.ended(1);
                    found
                })
            },
        );
        let mut effort = Effort::default();
        effort += tightest.as_ref().map_or(Effort::default(), |f| f.effort);
        let above_rip = Hint { infeasible: rip.time_below(), near: rip.time(), ..Hint::default() };
        let mut singles: Vec<Found> = Vec::new();
        if let Some(joint) = tightest.as_ref().filter(|_| several) {
            let initial_guesses = joint.planned().cloned().into_iter().collect();
            singles = self.singles_own(&rip, Hint { feasible: joint.time(), initial_guesses, ..above_rip.clone() });
            singles.iter().for_each(|f| effort += f.effort);
            if let Some(plan) = joint.planned() {
                singles = singles.into_iter().map(|single| single.or_shorter(plan)).collect();
            }
            self.share(&mut singles);
        }
        let singles: Vec<&Found> = if several { singles.iter().collect() } else { tightest.iter().collect() };
        let joint = tightest.as_ref().filter(|_| several);
        let others = singles.iter().copied().chain(joint).filter_map(Found::planned);
        let shortest = others.min_by(|a, b| a.grid.total.total_cmp(&b.grid.total));
        let rip = self.at_most(rip, shortest);
        effort += rip.effort;

        let longest_single = singles.iter().filter_map(|f| f.time()).max_by(f64::total_cmp);
        // Where `plan` selects RSP's facets for its shortest time.
        let selecting_time = joint.and_then(Found::time).or(longest_single);
        let common_time = self.fixed_time().or(selecting_time);

        let none: &[String] = &[];
        let mut runs = vec![self.run(PlannerKind::Rip, none, Run::Own, self.own(&rip), &self.sets.rip)];
        // Modes, set, and what its own search found.
        let mut conservative: Vec<(&[String], &PlanningSet, &Found)> = Vec::new();
        for ((&found, set), name) in singles.iter().zip(&self.sets.singles).zip(&self.sets.names) {
            conservative.push((std::slice::from_ref(name), set, found));
        }
        conservative.extend(joint.map(|j| (self.sets.names.as_slice(), &self.sets.joint, j)));
        for (against, set, found) in &conservative {
            runs.push(self.run(PlannerKind::Rcp, against, Run::Own, self.own(found), set));
        }
        let is_local = self.finds_local_optima();
        let mut out = Comparison { runs, common_time, effort, ..self.without_runs() };
        if let Some(at) = common_time {
            let binding = tightest.as_ref().and_then(Found::planned);
            let (decision, spent) = match is_local {
                true => self.rip_at("RIP", at, self.at_its_time(binding), rip.planned()),
                false => self.at_or_own("RIP", &self.sets.rip, at, &rip, binding),
            };
            out.effort += spent;
            self.ended(1);
            let rsp_set = match &decision {
                Decision::Feasible(planned) => self.select(at, planned, self.at_its_time(binding), &mut out),
                _ => self.sets.rip.clone(),
            };
            let selected = &out.selected;
            let mut common =
                vec![self.run(PlannerKind::Rip, none, Run::Common, self.common(at, &decision), &self.sets.rip)];
            let fixed_elsewhere = self.fixed_time().is_some_and(|fixed| selecting_time != Some(fixed));
            let ((rsp, rsp_common, rsp_effort), others) = rayon::join(
                || {
                    if fixed_elsewhere && !self.sets.names.is_empty() {
                        let (common, mut effort) = self.rsp_at_fixed_time(&rsp_set, at, &decision, selected.is_empty());
                        self.ended(1);
                        let (own, spent) = self.rsp_selected_at(selecting_time.ok_or(at), joint.or(tightest.as_ref()));
                        effort += spent;
                        self.ended(1);
                        return (own, common, effort);
                    }
                    let (known, of) = match &tightest {
                        Some(found) => (found, &self.sets.joint),
                        None => (&rip, &self.sets.rip),
                    };
                    let working_set = known.working_set.translated(of, &rsp_set);
                    let at_once = Some(&decision).filter(|_| selected.is_empty());
                    let (own, common, effort) = self.rsp_own_and_common(
                        &rsp_set,
                        at,
                        KnownPlans { rip: &rip, rip_at: &decision, rcp: binding },
                        above_rip.clone(),
                        at_once,
                        working_set,
                    );
                    (OwnRsp { outcome: own, set: rsp_set.clone(), selected_by: None }, common, effort)
                },
                || {
                    let work = |&(against, set, found): &(&[String], &PlanningSet, &Found)| {
                        let label = label(PlannerKind::Rcp, against);
                        let (decision, spent) = match decision.planned().filter(|plan| self.is_inside(plan, set)) {
                            // The plan of least cost in the healthy set is that of every smaller set that contains it.
                            Some(rip) if is_local => (Decision::Feasible(Box::new(rip.clone())), Effort::default()),
                            _ => self.at_or_own(&label, set, at, found, binding),
                        };
                        let outcome = self.common(at, &decision);
                        self.ended(1);
                        (self.run(PlannerKind::Rcp, against, Run::Common, outcome, set), spent)
                    };
                    conservative.par_iter().map(work).collect::<Vec<_>>()
                },
            );
            out.effort += rsp_effort;
            for (run, spent) in others {
                common.push(run);
                out.effort += spent;
            }
            out.runs.push(self.run(PlannerKind::Rsp, &self.sets.names, Run::Own, rsp.outcome, &rsp.set));
            out.own_selected_by = rsp.selected_by;
            common.push(self.run(PlannerKind::Rsp, &self.sets.names, Run::Common, rsp_common, &rsp_set));
            out.runs.extend(common);
        }
        put_in_order(&mut out.runs, self.sets.names.len(), out.own_selected_by.is_none());
        out
    }

    /// RSP's plan at the time that the spec fixes, s, where RIP's decision selects; as `plan` makes it.
    fn rsp_at_fixed_time(
        &self,
        set: &PlanningSet,
        at: f64,
        rip: &Decision,
        nothing_selected: bool,
    ) -> (PlanOutcome, Effort) {
        match rip {
            Decision::Feasible(_) if nothing_selected => (self.common(at, rip), Effort::default()),
            Decision::Feasible(planned) => {
                let (decision, effort) = self.rsp_at("RSP", set, at, &[planned], None);
                (self.common(at, &decision), effort)
            }
            _ => (self.without_rip(at, rip), Effort::default()),
        }
    }

    /// RSP's shortest time as `plan` finds it if the spec fixes no time: for the facets selected at `at` s, the joint
    /// RCP's shortest time, whatever time the spec fixes; where there is none, the error is that time.
    fn rsp_selected_at(&self, at: Result<f64, f64>, rcp: Option<&Found>) -> (OwnRsp, Effort) {
        let mut selection = self.without_runs();
        let selected = match at {
            Ok(at) => self.rsp_set_at(at, rcp.and_then(Found::planned), &mut selection).map(|found| (at, found)),
            Err(at) => Err(PlanOutcome::NotAttempted { at, why: NO_COMMON_TIME.into() }),
        };
        let (outcome, set) = match selected {
            Ok((at, (set, initial_guesses))) => {
                let found = self.rsp_shortest(&set, at, selection.selected.is_empty(), &initial_guesses);
                selection.effort += found.effort;
                (self.own(&found), set)
            }
            Err(outcome) => (outcome, self.sets.rip.clone()),
        };
        (OwnRsp { outcome, set, selected_by: Some(selection.selected_by) }, selection.effort)
    }

    /// RSP at its own shortest time and at T_d, in this order. The own time is not below RIP's, and not above T_d if
    /// there is a plan at T_d. RIP's decision at T_d is RSP's too if it is given as `nothing_selected`. Without a plan
    /// of RIP there is nothing to select by, and no own time is searched for.
    fn rsp_own_and_common(
        &self,
        set: &PlanningSet,
        at: f64,
        known: KnownPlans,
        above_rip: Hint,
        nothing_selected: Option<&Decision>,
        working_set: WorkingSet,
    ) -> (PlanOutcome, PlanOutcome, Effort) {
        let KnownPlans { rip, rip_at, rcp } = known;
        if let Some(same) = nothing_selected {
            self.ended(2);
            let (own, common) = match same {
                Decision::Feasible(planned) if self.fixed_time().is_none() => {
                    (self.own(&nothing_selected_at(planned)), self.common(at, same))
                }
                Decision::Feasible(_) => (self.own(rip), self.common(at, same)),
                _ => (PlanOutcome::NotAttempted { at, why: NOTHING_TO_SELECT_BY.into() }, self.without_rip(at, same)),
            };
            return (own, common, Effort::default());
        }
        if self.finds_local_optima() {
            let first: Vec<&Planned> = rip_at.planned().into_iter().chain(self.at_its_time(rcp)).collect();
            let (decision, mut effort) = self.rsp_at("RSP", set, at, &first, None);
            self.ended(1);
            let outcome = self.common(at, &decision);
            let initial_guesses = rip_at.planned().into_iter().chain(rcp).cloned().collect();
            let hint = match self.at_its_time(rcp) {
                Some(rcp) => hint_from(at, Decision::Feasible(Box::new(rcp.clone()))),
                None => hint_from(at, decision),
            };
            let own = self.rsp_own("RSP", set, Hint { initial_guesses, ..hint }, working_set);
            self.ended(1);
            effort += own.effort;
            return (self.own(&own), outcome, effort);
        }
        // If T_d is a mode's shortest time it is most often RSP's too: the time below is tried in parallel.
        let below = at - RESOLUTION;
        let ((decision, mut effort), shorter) = rayon::join(
            || self.at("RSP", set, at, working_set.clone(), &[]),
            || self.fixed_time().is_none().then(|| self.at("RSP", set, below, working_set.clone(), &[])),
        );
        let outcome = self.common(at, &decision);
        self.ended(1);
        let mut hint = hint_from(at, decision);
        if let Some((shorter, spent)) = shorter {
            effort += spent;
            match shorter {
                Decision::Infeasible => hint.infeasible = Some(below),
                feasible @ Decision::Feasible(_) => hint = hint_from(below, feasible),
                Decision::Inconclusive(_) => {}
            }
        }
        hint.infeasible = hint.infeasible.or(above_rip.infeasible);
        let mut own = self.search("RSP", set, hint, working_set);
        self.ended(1);
        effort += own.effort;
        if let Some(rcp) = rcp {
            own = own.or_shorter(rcp);
        }
        (self.own(&own), outcome, effort)
    }
}
