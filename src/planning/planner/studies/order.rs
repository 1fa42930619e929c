//! The order of times: a plan inside a smaller set is one inside a larger set, so that RIP takes no longer than RSP,
//! RSP no longer than the joint RCP, and RCP against one mode no longer than against all.

use super::found::Found;
use super::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Run};
use crate::model::PlannerKind;
use crate::planner::Planned;
use crate::planner::timing::search::Shortest;

impl Found {
    /// The same, or the plan of a smaller set if that is shorter: a search that proves nothing can end with a longer
    /// plan for the larger set.
    pub(super) fn or_shorter(self, other: &Planned) -> Found {
        let own = self.time().unwrap_or(f64::INFINITY);
        if other.grid.total < own { self.replaced_by(other) } else { self }
    }

    /// The plan of a smaller set in place of the one that the search found. A proof about a shorter time stays.
    pub(super) fn replaced_by(mut self, other: &Planned) -> Found {
        let time = other.grid.total;
        let infeasible_at = self.time_below().filter(|&below| below < time);
        self.result = Ok(Shortest { infeasible_at, ..Shortest::new(time, other.clone()) });
        self
    }
}

impl Comparison {
    /// Takes the last run of another comparison of this mission for the own run at `place`, and puts own times in
    /// order.
    pub fn take_own(&mut self, place: usize, mut other: Comparison) {
        self.effort += other.effort;
        let Some(run) = other.runs.pop() else { return };
        self.runs[place] = run;
        put_in_order(&mut self.runs, self.modes.len(), self.own_selected_by.is_none());
    }
}

/// Puts own times in order. A planner's plan at T_d may be shorter than the one that its own search found, and replaces
/// it; then, from the smallest set to the largest (joint RCP, single modes, RSP, RIP), a shorter plan of an inner set
/// replaces a longer one. RSP's plan at T_d may replace its own only if the same facets are selected for both.
pub(super) fn put_in_order(runs: &mut [PlannerRun], modes: usize, one_selection: bool) {
    let common: Vec<PlannerRun> = runs.iter().filter(|run| run.run == Run::Common).cloned().collect();
    for own in runs.iter_mut().filter(|run| run.run == Run::Own) {
        let is_comparable = own.planner != PlannerKind::Rsp || one_selection;
        let same = common.iter().find(|run| is_comparable && run.planner == own.planner && run.against == own.against);
        if let Some(PlanOutcome::Planned(at)) = same.map(|run| &run.outcome) {
            own.outcome = shorter(&own.outcome, at);
        }
    }
    // The rank grows with the number of sets that a plan stays in: a planner may take plans of higher rank.
    let rank = |run: &PlannerRun| match run.planner {
        PlannerKind::Rcp if run.against.len() == modes => 3,
        PlannerKind::Rcp => 2,
        PlannerKind::Rsp => 1,
        PlannerKind::Rip => 0,
    };
    let flows = |inner: &PlannerRun, outer: &PlannerRun| match outer.planner {
        PlannerKind::Rip => true,
        _ => rank(inner) == 3 && rank(outer) < 3,
    };
    let mut order: Vec<usize> = (0..runs.len()).filter(|&i| runs[i].run == Run::Own).collect();
    order.sort_by_key(|&i| std::cmp::Reverse(rank(&runs[i])));
    for (place, &outer) in order.iter().enumerate() {
        for &inner in &order[..place] {
            if let (true, PlanOutcome::Planned(plan)) = (flows(&runs[inner], &runs[outer]), &runs[inner].outcome) {
                runs[outer].outcome = shorter(&runs[outer].outcome, plan);
            }
        }
    }
}

/// The outcome of an own search, or another plan that its set allows if that is shorter.
fn shorter(own: &PlanOutcome, other: &MissionPlan) -> PlanOutcome {
    let proved = match own {
        PlanOutcome::Planned(solved) if solved.time <= other.time => return own.clone(),
        PlanOutcome::Planned(solved) => solved.infeasible_at.filter(|&below| below < other.time),
        PlanOutcome::NotFound(NotFound::Search { .. }) => None,
        // RSP without a RIP plan to select by stays not attempted, whatever plans there are.
        _ => return own.clone(),
    };
    PlanOutcome::Planned(Box::new(MissionPlan { infeasible_at: proved, infeasible_above: Vec::new(), ..other.clone() }))
}
