//! Which plans serve as initial guesses of a search. Every command uses the same ones, so that `plan`, `compare` and a campaign
//! find the same plan for a planner at a time.

use super::{Found, Setting, plan_found, planned_of, time};
use crate::model::PlanModel;
use crate::planner::pool::Pool;
use crate::planner::rows::{Decision, Planned};
use crate::planner::search::Hint;
use crate::planner::select::PlanningSet;
use crate::solve::Effort;

impl Setting<'_> {
    /// The plan at one time from the initial guesses `first`, and if that finds none from `further`.
    pub(super) fn at_from(
        &self,
        what: &str,
        set: &PlanningSet,
        time: f64,
        first: &[&Planned],
        further: &[&Planned],
    ) -> (Decision, Effort) {
        let (decision, mut effort) = self.at(what, set, time, Pool::default(), first);
        if !matches!(decision, Decision::Inconclusive(_)) || further.is_empty() {
            return (decision, effort);
        }
        let (again, spent) = self.at(what, set, time, Pool::default(), further);
        effort += spent;
        (again, effort)
    }

    /// The joint RCP's plan as an initial guess at T_d: only if T_d is its own time, and not one that the spec fixes.
    pub(super) fn at_its_time<'p>(&self, rcp: Option<&'p Planned>) -> Option<&'p Planned> {
        rcp.filter(|_| self.fixed_time().is_none())
    }

    /// RIP's shortest time. A search for waypoint times proves nothing and may end longer than RCP's, which RIP never needs to be:
    /// the joint RCP is searched for in parallel, unless `rcp` is its plan already.
    pub(super) fn rip_own(&self, rcp: Option<&Planned>) -> Found {
        let rip = || self.search("RIP", &self.sets.rip, Hint::default(), Pool::default());
        if self.model.plan.model == PlanModel::Hover || !self.model.plan.chooses_times {
            return rip();
        }
        let joint = || {
            (!self.sets.names.is_empty())
                .then(|| self.search("RCP", &self.sets.joint, Hint::default(), Pool::default()))
        };
        let (mut rip, joint) = match rcp {
            Some(_) => (rip(), None),
            None => rayon::join(rip, joint),
        };
        rip.effort += joint.as_ref().map_or(Effort::default(), |found| found.effort);
        self.at_most(rip, rcp.or(joint.as_ref().and_then(plan_found)))
    }

    /// RSP's shortest time; `hint.begins` holds the RIP plan that selects, then plans that RSP's set allows.
    pub(super) fn rsp_own(&self, name: &str, set: &PlanningSet, hint: Hint, pool: Pool) -> Found {
        let allowed: Vec<Planned> = hint.begins.iter().skip(1).cloned().collect();
        let found = self.search(name, set, hint, pool);
        allowed.iter().fold(found, |found, plan| found.or_shorter(plan))
    }

    /// RSP's plan at one time from the initial guesses `begins`, and if that finds none from the joint RCP's plan at that time,
    /// which RSP's set allows: `rcp`, or a new one.
    pub(super) fn rsp_at(
        &self,
        name: &str,
        set: &PlanningSet,
        time: f64,
        begins: &[&Planned],
        rcp: Option<&Planned>,
    ) -> (Decision, Effort) {
        let (decision, mut effort) = self.at(name, set, time, Pool::default(), begins);
        if !matches!(decision, Decision::Inconclusive(_)) {
            return (decision, effort);
        }
        let (joint, spent) = match rcp {
            Some(rcp) => (Decision::Feasible(Box::new(rcp.clone())), Effort::default()),
            None => self.at("RCP", &self.sets.joint, time, Pool::default(), &[]),
        };
        effort += spent;
        let Some(rcp) = planned_of(&joint) else { return (decision, effort) };
        let (again, spent) = self.at(name, set, time, Pool::default(), &[rcp]);
        effort += spent;
        (again, effort)
    }

    /// RIP's search, or a further one warm-started from `shortest` if that is shorter: every set lies inside the healthy one, so
    /// its plan is one of RIP's.
    pub(super) fn at_most(&self, rip: Found, shortest: Option<&Planned>) -> Found {
        let is_shorter = |plan: &&Planned| time(&rip).is_none_or(|t| plan.profile.total < t);
        let Some(better) = shortest.filter(is_shorter) else { return rip };
        let again = self.search(
            "RIP",
            &self.sets.rip,
            Hint { begins: vec![better.clone()], ..Hint::default() },
            Pool::default(),
        );
        let mut effort = rip.effort;
        effort += again.effort;
        let found = if again.result.is_ok() { again } else { rip };
        Found { effort, ..found.or_shorter(better) }
    }
}
