//! `require risk <= bound`: which facets to impose, chosen greedily.
//!
//! Starting with the healthy set alone, each step tries, for the modes with the largest risk, the facet violated last,
//! all facets that the plan violates, and the mode's whole set, and adds the one that removes most risk per second of
//! mission time. Another order or choice may need less time: the result is not claimed to be the shortest.

use super::{Comparison, MissionPlan, NotFound, PlanOutcome, Run, Setting};
use crate::admissible::row::SetRow;
use crate::model::PlannerKind;
use crate::motion::outside::{ViolationInterval, violation_intervals};
use crate::motion::risk::risk;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::Hint;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};
use crate::solve::Effort;
use rayon::prelude::*;

/// Modes tried in a step: those with the largest risk. Chosen by hand.
const MOST_MODES: usize = 4;

/// Most single facets added; after them facets are only tried together, which bounds the number of steps.
/// Chosen by hand.
const MOST_SINGLES: usize = 8;

/// The status if the required risk is not met.
pub const UNMET: &str = "the required risk is not met";

/// What a step protects against.
#[derive(Debug, Clone, PartialEq)]
pub enum Protection {
    /// The healthy set alone.
    Nothing,
    /// The facets of a mode's set that the plan before violates at nodes, or the one that it violates last.
    Facets { mode: String, facets: usize },
    /// A mode's whole set.
    Mode { mode: String },
    /// The sets of all modes, if no single addition removes any risk.
    All,
}

/// One step of the trade-off.
#[derive(Debug, Clone, PartialEq)]
pub struct Addition {
    pub added: Protection,
    /// Of the mission with all that is protected so far, s.
    pub time: f64,
    pub risk: f64,
}

/// Rows that a step may add.
struct Candidate {
    added: Protection,
    rows: Vec<SetRow>,
    /// The modes whose whole sets these are.
    whole: Vec<usize>,
    /// Whether it is the one facet that the plan violates last.
    single: bool,
}

/// A plan with all that is protected so far.
struct ProtectedPlan {
    added: Protection,
    set: PlanningSet,
    /// Single facets added so far.
    singles: usize,
    /// The modes whose whole sets are protected.
    whole: Vec<usize>,
    solved: MissionPlan,
    planned: Planned,
    risk: f64,
}

impl Setting<'_> {
    fn risk_of(&self, solved: &MissionPlan) -> f64 {
        risk(self.weights(solved))
    }

    /// Rate (1/s) and committed time (s) of each mode. (The spec refuses modes without a rate; they would count as sure
    /// to fail.)
    fn weights(&self, solved: &MissionPlan) -> Vec<(f64, f64)> {
        let rates = self.model().plan.against.iter().map(|&mode| self.model().modes[mode].rate.unwrap_or(f64::MAX));
        rates.zip(solved.committed.iter().copied()).collect()
    }

    /// The plan of a set at the spec's time, or at its shortest, which is not below that of the step before. `what`
    /// names the attempt in progress reports.
    fn plan_of(
        &self,
        what: &str,
        set: &PlanningSet,
        before: Option<&ProtectedPlan>,
    ) -> (Result<(MissionPlan, Planned), PlanOutcome>, Effort) {
        let initial_guesses = before.map(|step| &step.planned);
        let time = self.fixed_time().or(before.map(|step| step.solved.time));
        let mut effort = Effort::default();
        let mut hint = Hint::default();
        if let Some(time) = time {
            let (decision, spent) = self.at(what, set, time, WorkingSet::default(), initial_guesses.as_slice());
            effort += spent;
            if let Some(planned) = decision.planned() {
                // A time that is infeasible for the larger set is so for this one.
                let infeasible_at = before.and_then(|step| step.solved.infeasible_at);
                return (Ok((MissionPlan { infeasible_at, ..self.solved(time, planned) }, planned.clone())), effort);
            }
            if self.fixed_time().is_some() {
                return (Err(self.common(time, &decision)), effort);
            }
            let infeasible = matches!(decision, Decision::Infeasible).then_some(time);
            hint = Hint {
                near: Some(time),
                infeasible,
                initial_guesses: initial_guesses.cloned().into_iter().collect(),
                ..hint
            };
        }
        let found = self.search(what, set, hint, WorkingSet::default());
        effort += found.effort;
        let outcome = self.own(&found);
        match (outcome, found.result) {
            (PlanOutcome::Planned(solved), Ok(shortest)) => (Ok((*solved, shortest.planned)), effort),
            (outcome, _) => (Err(outcome), effort),
        }
    }

    /// The candidates of a step.
    fn candidates(&self, step: &ProtectedPlan) -> Vec<Candidate> {
        let weights = self.weights(&step.solved);
        let mut modes: Vec<(usize, f64)> =
            weights.iter().enumerate().map(|(m, w)| (m, w.0 * w.1)).filter(|m| m.1 > 0.0).collect();
        modes.retain(|m| !step.whole.contains(&m.0));
        modes.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut all = Vec::new();
        for &(m, _) in modes.iter().take(MOST_MODES) {
            let mode = self.sets.names[m].clone();
            let rows = &self.sets.modes[m].rows;
            let mut facets = |which: &[usize], single: bool| {
                let added = Protection::Facets { mode: mode.clone(), facets: which.len() };
                let rows = which.iter().map(|&f| rows[f].clone()).collect();
                all.push(Candidate { added, rows, whole: Vec::new(), single });
            };
            let passed = &step.solved.outside[m].facets;
            if !passed.is_empty() {
                facets(passed, false);
            }
            let last =
                self.violated_last(&step.solved, m).filter(|f| step.singles < MOST_SINGLES && passed[..] != [*f]);
            if let Some(facet) = last {
                facets(&[facet], true);
            }
            let added = Protection::Mode { mode };
            all.push(Candidate { added, rows: rows.clone(), whole: vec![m], single: false });
        }
        all
    }

    /// The facet of a mode's set that commits the mission longest: the one violated last, up to the last instant from
    /// which the mission is committed. Imposing any other facet does not change that instant.
    fn violated_last(&self, solved: &MissionPlan, mode: usize) -> Option<usize> {
        let (trajectory, until) = (&solved.trajectory, solved.committed[mode]);
        let rows = &self.sets.modes[mode].rows;
        let before = (0..trajectory.intervals()).rev().filter(|&k| trajectory.times[k] < until);
        let last = |k: usize| -> Option<ViolationInterval> {
            let (found, _) =
                violation_intervals(trajectory, &self.model().vehicle, &self.model().environment(), rows, k);
            found.into_iter().filter(|s| s.from < until).max_by(|a, b| a.to.total_cmp(&b.to))
        };
        before.into_iter().find_map(last).map(|interval| interval.row)
    }

    fn tried(&self, before: &ProtectedPlan, candidate: Candidate) -> (Result<ProtectedPlan, PlanOutcome>, Effort) {
        let Candidate { added, rows, whole, single } = candidate;
        let set = before.set.with(rows);
        let (result, effort) = self.plan_of(&before.trying(&added), &set, Some(before));
        let whole = before.whole.iter().copied().chain(whole).collect();
        let step = result.map(|(solved, planned)| {
            let risk = self.risk_of(&solved);
            ProtectedPlan { added, set, whole, singles: before.singles + usize::from(single), solved, planned, risk }
        });
        (step, effort)
    }

    /// Protects until the risk is at most `bound`.
    pub(super) fn protect(&self, bound: f64) -> Comparison {
        let mut out = self.without_runs();
        let which = if self.fixed_time().is_some() { Run::Common } else { Run::Own };
        let finish = |mut out: Comparison, outcome: PlanOutcome, set: &PlanningSet| {
            out.runs.push(self.run(PlannerKind::Rsp, &self.sets.names, which, outcome, set));
            out
        };
        let (first, effort) = self.plan_of("RIP", &self.sets.rip, None);
        out.effort += effort;
        let mut step = match first {
            Ok((solved, planned)) => {
                let risk = self.risk_of(&solved);
                let set = self.sets.rip.clone();
                ProtectedPlan { added: Protection::Nothing, set, whole: Vec::new(), singles: 0, solved, planned, risk }
            }
            Err(outcome) => return finish(out, outcome, &self.sets.rip),
        };
        loop {
            out.trade_off.push(Addition { added: step.added.clone(), time: step.solved.time, risk: step.risk });
            if step.risk <= bound {
                out.selected = step.set.rows[self.sets.rip.rows.len().min(step.set.rows.len())..].to_vec();
                return finish(out, PlanOutcome::Planned(Box::new(step.solved)), &step.set);
            }
            let tried: Vec<(Result<ProtectedPlan, PlanOutcome>, Effort)> =
                self.candidates(&step).into_par_iter().map(|candidate| self.tried(&step, candidate)).collect();
            tried.iter().for_each(|t| out.effort += t.1);
            let gains = |next: &ProtectedPlan| (next.risk < step.risk).then(|| price(&step, next));
            let best = tried
                .into_iter()
                .filter_map(|t| t.0.ok())
                .filter_map(|next| Some((gains(&next)?, next)))
                .max_by(|a, b| a.0.partial_cmp(&b.0).unwrap_or(std::cmp::Ordering::Equal));
            let all: Vec<usize> = (0..self.sets.names.len()).collect();
            step = match best {
                Some((_, next)) => next,
                None if step.whole != all => {
                    let rows = self.sets.joint.rows.clone();
                    let every = Candidate { added: Protection::All, rows, whole: Vec::new(), single: false };
                    let (joint, effort) = self.tried(&step, every);
                    out.effort += effort;
                    match joint {
                        Ok(next) if next.risk < step.risk => ProtectedPlan { whole: all, ..next },
                        _ => return finish(out, unmet(&step), &step.set),
                    }
                }
                None => return finish(out, unmet(&step), &step.set),
            };
        }
    }
}

impl ProtectedPlan {
    /// The next attempt, as progress reports name it.
    fn trying(&self, added: &Protection) -> String {
        let protected = match added {
            Protection::Nothing => "nothing".into(),
            Protection::Facets { mode, facets } => format!("{facets} facets of {mode}"),
            Protection::Mode { mode } => mode.clone(),
            Protection::All => "every mode".into(),
        };
        format!("risk {:.2e}, protecting {protected}", self.risk)
    }
}

fn unmet(step: &ProtectedPlan) -> PlanOutcome {
    PlanOutcome::NotFound(NotFound::Search { at: step.solved.time, status: UNMET.into() })
}

/// Risk removed per second of mission time, then in all: additions that cost no time come first.
fn price(before: &ProtectedPlan, after: &ProtectedPlan) -> (f64, f64) {
    let (gain, seconds) = (before.risk - after.risk, after.solved.time - before.solved.time);
    (if seconds > 0.0 { gain / seconds } else { f64::INFINITY }, gain)
}
