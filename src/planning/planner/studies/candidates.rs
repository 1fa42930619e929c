//! Which plans serve as initial guesses of a search. Every command uses the same ones, so that `plan`, `compare` and a
//! campaign find the same plan for a planner at a time. (RIP's shortest time may be shorter in `compare`, which knows
//! the plans of all other planners.)

use super::Setting;
use super::found::Found;
use crate::model::SearchEffort;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::{Hint, Shortest};
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
use crate::solve::Effort;

impl Setting<'_> {
    /// RIP's plan at one mission time, s. The initial guess is `rcp`, if given. Where candidates are shared and no plan
    /// is found, the next initial guesses are the plan at RIP's shortest time (`own`) if that is no longer, and with
    /// `effort = thorough` the joint RCP's plan at that time, whose set lies inside RIP's.
    pub(super) fn rip_at(
        &self,
        name: &str,
        time: f64,
        rcp: Option<&Planned>,
        own: Option<&Planned>,
    ) -> (Decision, Effort) {
        let rip =
            |guess: Option<&Planned>| self.at(name, &self.sets.rip, time, WorkingSet::default(), guess.as_slice());
        let (mut decision, mut effort) = rip(rcp);
        let is_open = |decision: &Decision| self.shares_candidates() && matches!(decision, Decision::Inconclusive(_));
        if let Some(own) = own.filter(|plan| plan.grid.total <= time && is_open(&decision)) {
            let (found, spent) = rip(Some(own));
            effort += spent;
            decision = found;
        }
        if is_open(&decision) && rcp.is_none() && self.is_thorough() && !self.sets.names.is_empty() {
            let (joint, spent) = self.at("RCP", &self.sets.joint, time, WorkingSet::default(), &[]);
            effort += spent;
            if let Some(rcp) = joint.planned() {
                let (found, spent) = rip(Some(rcp));
                effort += spent;
                decision = found;
            }
        }
        (decision, effort)
    }

    fn is_thorough(&self) -> bool {
        self.model().plan.effort == SearchEffort::Thorough
    }

    /// The joint RCP's plan as an initial guess at T_d: only if T_d is its own time and not one that the spec fixes.
    pub(super) fn at_its_time<'p>(&self, rcp: Option<&'p Planned>) -> Option<&'p Planned> {
        rcp.filter(|_| self.fixed_time().is_none())
    }

    /// Whether plans of smaller sets are initial guesses for larger ones. Not in the hover model, whose search proves
    /// that nothing shorter exists on its grid, and not where legs share the time by the paper's rule, which the plans
    /// then reproduce.
    fn shares_candidates(&self) -> bool {
        self.finds_local_optima() && (self.model().plan.chooses_times || !self.mission().leaves_times_free())
    }

    /// RIP's shortest time. With `effort = thorough`, or where the plan is [`Shortest::is_slowed`], the joint RCP is
    /// searched for too: its set lies inside RIP's, and where its plan is shorter RIP starts from it again.
    pub(super) fn rip_own(&self) -> Found {
        let mut rip = self.search("RIP", &self.sets.rip, Hint::default(), WorkingSet::default());
        let is_slowed = rip.result.as_ref().is_ok_and(|shortest| shortest.is_slowed);
        if !(self.is_thorough() || is_slowed) || !self.shares_candidates() || self.sets.names.is_empty() {
            return rip;
        }
        let joint = self.search("RCP", &self.sets.joint, Hint::default(), WorkingSet::default());
        rip.effort += joint.effort;
        self.at_most(rip, joint.planned())
    }

    /// RSP's shortest time; `hint.initial_guesses` holds the RIP plan that selects, then the joint RCP's plan, which
    /// RSP's set allows. In the exact model that one is taken if RSP leaves some mode's set and hardly saves time by
    /// it; the hover model keeps to the paper's RSP.
    pub(super) fn rsp_own(&self, name: &str, set: &PlanningSet, hint: Hint, working_set: WorkingSet) -> Found {
        let allowed: Vec<Planned> = hint.initial_guesses.iter().skip(1).cloned().collect();
        let found = self.search(name, set, hint, working_set);
        let found = allowed.iter().fold(found, Found::or_shorter);
        let leaves = |plan: &Planned| !self.sets.violated(self.model(), plan).is_empty();
        match (found.planned(), allowed.first().filter(|_| self.finds_local_optima())) {
            (Some(own), Some(rcp))
                if rcp.grid.total <= own.grid.total + hardly_shorter(own.grid.total) && leaves(own) =>
            {
                found.replaced_by(rcp)
            }
            _ => found,
        }
    }

    /// RSP's plan at one mission time, s, from `initial_guesses`, and if that finds none from the joint RCP's plan at
    /// that time, which RSP's set allows: `rcp`, or a new one.
    pub(super) fn rsp_at(
        &self,
        name: &str,
        set: &PlanningSet,
        time: f64,
        initial_guesses: &[&Planned],
        rcp: Option<&Planned>,
    ) -> (Decision, Effort) {
        let (decision, mut effort) = self.at(name, set, time, WorkingSet::default(), initial_guesses);
        if !matches!(decision, Decision::Inconclusive(_)) {
            return (decision, effort);
        }
        let (joint, spent) = match rcp {
            Some(rcp) => (Decision::Feasible(Box::new(rcp.clone())), Effort::default()),
            None => self.at("RCP", &self.sets.joint, time, WorkingSet::default(), &[]),
        };
        effort += spent;
        let Some(rcp) = joint.planned() else { return (decision, effort) };
        let (again, spent) = self.at(name, set, time, WorkingSet::default(), &[rcp]);
        effort += spent;
        (again, effort)
    }

    /// RIP's search, or a further one warm-started from `shortest` if that is shorter: every set lies inside the
    /// healthy one, so its plan is one of RIP's.
    pub(super) fn at_most(&self, rip: Found, shortest: Option<&Planned>) -> Found {
        let is_shorter = |plan: &&Planned| rip.time().is_none_or(|t| plan.grid.total < t);
        let Some(better) = shortest.filter(is_shorter) else { return rip };
        let again = self.search(
            "RIP",
            &self.sets.rip,
            Hint { initial_guesses: vec![better.clone()], ..Hint::default() },
            WorkingSet::default(),
        );
        let mut effort = rip.effort;
        effort += again.effort;
        let found = if again.result.is_ok() { again } else { rip };
        Found { effort, ..found.or_shorter(better) }
    }
}

/// A difference from a mission time, s, that no plan should leave a mode's set for. Chosen by hand.
pub fn hardly_shorter(time: f64) -> f64 {
    (0.003 * time).max(0.05)
}

/// RSP's shortest time if nothing is selected at T_d: RIP's plan there, which stays inside every set. A shorter one
/// would be RIP's alone, which nothing protects against faults.
pub(super) fn nothing_selected_at(rip: &Planned) -> Found {
    let shortest = Shortest::new(rip.grid.total, rip.clone());
    Found { result: Ok(shortest), working_set: WorkingSet::default(), effort: Effort::default() }
}
