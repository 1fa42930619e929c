//! Every planner at its own shortest time and at T_d.

use super::found::{Found, hint_from};
use super::single_planner::NO_COMMON_TIME;
use super::{Comparison, NOTHING_TO_SELECT_BY, PlanOutcome, PlannerRun, Run, Setting, label};
use crate::model::PlannerKind;
use crate::motion::Trajectory;
use crate::planner::selection::PlanningSet;
use crate::planner::studies::candidates::nothing_selected_at;
use crate::planner::studies::order::put_in_order;
use crate::planner::timing::search::{Hint, RESOLUTION};
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
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

/// What the searches for the shortest times of RIP and every RCP found.
struct OwnTimes {
    rip: Found,
    /// RCP against all modes, or against the only one; `None` without modes.
    tightest: Option<Found>,
    /// RCP against each of several modes.
    singles: Vec<Found>,
    /// The bounds that RIP's time sets on every other.
    above_rip: Hint,
    effort: Effort,
}

impl OwnTimes {
    /// RCP against all of several modes.
    fn joint(&self) -> Option<&Found> {
        self.tightest.as_ref().filter(|_| !self.singles.is_empty())
    }

    /// RCP against each mode.
    fn singles(&self) -> &[Found] {
        if self.singles.is_empty() { self.tightest.as_slice() } else { &self.singles }
    }

    /// Where `plan` selects RSP's facets for its shortest time, s.
    fn selecting_time(&self) -> Option<f64> {
        let longest_single = self.singles().iter().filter_map(Found::time).max_by(f64::total_cmp);
        self.joint().and_then(Found::time).or(longest_single)
    }
}

/// RCP against some modes: its set, and what the search for its shortest time found.
struct Conservative<'c> {
    against: &'c [String],
    set: &'c PlanningSet,
    found: &'c Found,
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
        let own = self.own_times();
        let conservative = self.conservative(&own);
        let mut runs = vec![self.run(PlannerKind::Rip, &[], Run::Own, self.own(&own.rip), &self.sets.rip)];
        for Conservative { against, set, found } in &conservative {
            runs.push(self.run(PlannerKind::Rcp, against, Run::Own, self.own(found), set));
        }
        let selecting_time = own.selecting_time();
        let common_time = self.fixed_time().or(selecting_time);
        let mut out = Comparison { runs, common_time, effort: own.effort, ..self.without_runs() };
        if let Some(at) = common_time {
            self.add_runs_at(at, &own, &conservative, &mut out);
        }
        put_in_order(&mut out.runs, self.sets.names.len(), out.own_selected_by.is_none());
        out
    }

    /// The shortest times of RIP and every RCP.
    fn own_times(&self) -> OwnTimes {
        // RIP and the tightest RCP first, in parallel: their times bound all others.
        let several = self.sets.names.len() > 1;
        let first = |what: &str, set: &PlanningSet| {
            let found = self.search(what, set, Hint::default(), WorkingSet::default());
            self.ended(1);
            found
        };
        let (rip, tightest) = rayon::join(
            || first("RIP", &self.sets.rip),
            || (!self.sets.names.is_empty()).then(|| first("RCP", &self.sets.joint)),
        );
        let mut effort = tightest.as_ref().map_or(Effort::default(), |f| f.effort);
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
        let others = singles.iter().chain(&tightest).filter_map(Found::planned);
        let shortest = others.min_by(|a, b| a.grid.total.total_cmp(&b.grid.total));
        let rip = self.at_most(rip, shortest);
        effort += rip.effort;
        OwnTimes { rip, tightest, singles, above_rip, effort }
    }

    /// RCP against each mode in the order of `against`, then against all if there are several.
    fn conservative<'c>(&'c self, own: &'c OwnTimes) -> Vec<Conservative<'c>> {
        let single = |((found, set), name): ((&'c Found, &'c PlanningSet), &'c String)| Conservative {
            against: std::slice::from_ref(name),
            set,
            found,
        };
        let singles = own.singles().iter().zip(&self.sets.singles).zip(&self.sets.names).map(single);
        let of_joint = |found| Conservative { against: &self.sets.names, set: &self.sets.joint, found };
        singles.chain(own.joint().map(of_joint)).collect()
    }

    /// Adds RSP at its own time, and a run of each planner at T_d = `at` s.
    fn add_runs_at(&self, at: f64, own: &OwnTimes, conservative: &[Conservative], out: &mut Comparison) {
        let binding = own.tightest.as_ref().and_then(Found::planned);
        let (decision, spent) = match self.finds_local_optima() {
            true => self.rip_at("RIP", at, self.at_its_time(binding), own.rip.planned()),
            false => self.at_or_own("RIP", &self.sets.rip, at, &own.rip, binding),
        };
        out.effort += spent;
        self.ended(1);
        let rsp_set = match &decision {
            Decision::Feasible(planned) => self.select(at, planned, self.at_its_time(binding), out),
            Decision::Infeasible | Decision::Inconclusive(_) => self.sets.rip.clone(),
        };
        let nothing_selected = out.selected.is_empty();
        let of_rip = self.common(at, &decision);
        let mut common = vec![self.run(PlannerKind::Rip, &[], Run::Common, of_rip, &self.sets.rip)];
        let ((rsp, rsp_common, rsp_effort), others) = rayon::join(
            || self.rsp_beside(at, own, &decision, &rsp_set, nothing_selected),
            || {
                let work = |run: &Conservative| self.conservative_at(at, run, &decision, binding);
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

    /// A run of RCP at T_d = `at` s, where RIP's decision is known. `binding` is the plan of the tightest RCP.
    fn conservative_at(
        &self,
        at: f64,
        &Conservative { against, set, found }: &Conservative,
        rip: &Decision,
        binding: Option<&Planned>,
    ) -> (PlannerRun, Effort) {
        let label = label(PlannerKind::Rcp, against);
        let (decision, spent) = match rip.planned().filter(|plan| self.is_inside(plan, set)) {
            // The plan of least cost in the healthy set is that of every smaller set that contains it.
            Some(rip) if self.finds_local_optima() => (Decision::Feasible(Box::new(rip.clone())), Effort::default()),
            _ => self.at_or_own(&label, set, at, found, binding),
        };
        let outcome = self.common(at, &decision);
        self.ended(1);
        (self.run(PlannerKind::Rcp, against, Run::Common, outcome, set), spent)
    }

    /// RSP at its own shortest time, and its outcome at T_d = `at` s, where RIP's decision selects the facets of
    /// `rsp_set`.
    fn rsp_beside(
        &self,
        at: f64,
        own: &OwnTimes,
        decision: &Decision,
        rsp_set: &PlanningSet,
        nothing_selected: bool,
    ) -> (OwnRsp, PlanOutcome, Effort) {
        let selecting_time = own.selecting_time();
        let fixed_elsewhere = self.fixed_time().is_some_and(|fixed| selecting_time != Some(fixed));
        if fixed_elsewhere && !self.sets.names.is_empty() {
            let (common, mut effort) = self.rsp_at_fixed_time(rsp_set, at, decision, nothing_selected);
            self.ended(1);
            let (own, spent) = self.rsp_selected_at(selecting_time.ok_or(at), own.tightest.as_ref());
            effort += spent;
            self.ended(1);
            return (own, common, effort);
        }
        let (known, of) = match &own.tightest {
            Some(found) => (found, &self.sets.joint),
            None => (&own.rip, &self.sets.rip),
        };
        let working_set = known.working_set.translated(of, rsp_set);
        let (outcome, common, effort) = self.rsp_own_and_common(
            rsp_set,
            at,
            KnownPlans { rip: &own.rip, rip_at: decision, rcp: own.tightest.as_ref().and_then(Found::planned) },
            own.above_rip.clone(),
            Some(decision).filter(|_| nothing_selected),
            working_set,
        );
        (OwnRsp { outcome, set: rsp_set.clone(), selected_by: None }, common, effort)
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
