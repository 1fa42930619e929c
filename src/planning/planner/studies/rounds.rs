//! Rounds of selection: step (e) of section 5.3 of the paper, repeated at one mission time.
//!
//! RIP is zero rounds, RSP one. Facets violated at any node, in the exact model at any instant, are selected and
//! imposed at all of them. In the hover model, at a time at which RCP has a plan, rounds end at RCP's plan: each
//! program is a relaxation of RCP's, and a plan that violates no facet solves it.

use super::{Comparison, NotFound, PlanOutcome, Progress, Setting};
use crate::admissible::row::SetRow;
use crate::model::Problem;
use crate::motion::Trajectory;
use crate::planner::hover::{Decision, Planned};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::times::with_time_of_its_end;
use crate::planner::timing::search::RESOLUTION;
use crate::planner::working_set::WorkingSet;
use crate::solve::Effort;
use std::collections::BTreeMap;
use std::iter;
use std::ops::RangeInclusive;

/// Most times tried beyond T_d until one has a plan, each 5 % longer than the last. Chosen by hand.
const MOST_STEPS: usize = 20;

/// The result of one number of rounds.
#[derive(Debug, Clone)]
pub struct Round {
    pub rounds: usize,
    /// Facets of the modes' sets that are selected at T_d.
    pub selected: usize,
    /// At T_d.
    pub common: PlanOutcome,
    /// At the shortest time found at which the plan of this many rounds, selected there, exists.
    pub own: PlanOutcome,
    /// The plans that each of the two selects by.
    pub common_selected_by: Vec<Trajectory>,
    pub own_selected_by: Vec<Trajectory>,
}

/// The decisions of rounds 0, 1, ... at one time, each with the facets selected for it. The last holds for all further
/// rounds: it violates nothing new, or it is not a plan.
type Chain = Vec<(Vec<SetRow>, Decision)>;

/// Each wanted number of rounds at T_d, and at its own shortest time with the selection redone there. `common_time` is
/// T_d; no rounds if no mode has a plan at any time. `progress` receives the round and each mission time, s, before it
/// is tried.
pub fn rounds(
    problem: Problem,
    comparison: &mut Comparison,
    wanted: RangeInclusive<usize>,
    progress: Progress,
) -> Vec<Round> {
    let ended = with_time_of_its_end(problem);
    let problem = ended.as_ref().and_then(Problem::of).unwrap_or(problem);
    let setting = Setting::new(problem, progress);
    let last = *wanted.end();
    let Some(common) = comparison.common_time else { return Vec::new() };
    let known = comparison.known.clone();
    let mut search =
        Search { setting: &setting, last, known: &known, chains: BTreeMap::new(), effort: Effort::default() };
    let at_common = setting.chain(common, last, &known, &mut search.effort);
    let mut found = Vec::new();
    for k in wanted {
        let (selected, decision) = &at_common[k.min(at_common.len() - 1)];
        // The plan of the round before, which this one's facets are selected by, is missing.
        let is_beyond = k >= at_common.len() && decision.planned().is_none();
        let outcome = match is_beyond {
            true => setting.without_rip(common, decision),
            false => setting.common(common, decision),
        };
        let common_selected_by = selected_by(&at_common, k);
        let (own, own_selected_by) = match setting.fixed_time() {
            Some(_) => (outcome.clone(), common_selected_by.clone()),
            None => search.shortest(k, common),
        };
        found.push(Round {
            rounds: k,
            selected: selected.len(),
            common: outcome,
            own,
            common_selected_by,
            own_selected_by,
        });
    }
    comparison.effort += search.effort;
    found
}

/// The plans that `rounds` rounds select by: those of the rounds before, as far as they go.
fn selected_by(chain: &Chain, rounds: usize) -> Vec<Trajectory> {
    chain.iter().take(rounds).filter_map(|(_, decision)| decision.planned()).map(Planned::trajectory).collect()
}

struct Search<'s, 'a> {
    setting: &'s Setting<'a>,
    last: usize,
    /// Plans for warm starts.
    known: &'s [Planned],
    /// By mission time in multiples of [`RESOLUTION`].
    chains: BTreeMap<i64, Chain>,
    effort: Effort,
}

impl Search<'_, '_> {
    fn at(&mut self, ticks: i64, rounds: usize) -> Option<&Planned> {
        let (setting, last, known, effort) = (self.setting, self.last, self.known, &mut self.effort);
        let chain = self.chains.entry(ticks).or_insert_with(|| setting.chain(seconds(ticks), last, known, effort));
        chain[rounds.min(chain.len() - 1)].1.planned()
    }

    /// Bisection from T_d, or from the first longer time with a plan. Feasibility need not be monotone in time, because
    /// each time has its own selection: the time found is one at which a plan was found, and none was [`RESOLUTION`]
    /// below it.
    fn shortest(&mut self, rounds: usize, common: f64) -> (PlanOutcome, Vec<Trajectory>) {
        let mut high = (common / RESOLUTION - 1e-6).ceil() as i64;
        let mut tried = 0;
        let mut low = 0;
        while self.at(high, rounds).is_none() {
            low = high;
            high = (high as f64 * 1.05).ceil() as i64;
            tried += 1;
            if tried > MOST_STEPS {
                let status = crate::planner::scp::NOT_FOUND.into();
                return (PlanOutcome::NotFound(NotFound::Search { at: seconds(low), status }), Vec::new());
            }
        }
        let mut stride = 2;
        while low == 0 {
            let down = (high - stride).max(1);
            match self.at(down, rounds) {
                Some(_) if down > 1 => high = down,
                _ => low = down,
            }
            stride *= 2;
        }
        while high - low > 1 {
            let middle = (low + high) / 2;
            match self.at(middle, rounds) {
                Some(_) => high = middle,
                None => low = middle,
            }
        }
        let setting = self.setting;
        match self.at(high, rounds) {
            Some(planned) => {
                let outcome = PlanOutcome::Planned(Box::new(setting.solved(seconds(high), planned)));
                (outcome, self.chains.get(&high).map_or_else(Vec::new, |chain| selected_by(chain, rounds)))
            }
            None => {
                let status = crate::planner::scp::NOT_FOUND.into();
                (PlanOutcome::NotFound(NotFound::Search { at: seconds(high), status }), Vec::new())
            }
        }
    }
}

fn seconds(ticks: i64) -> f64 {
    ticks as f64 / (1.0 / RESOLUTION).round()
}

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

    /// Rounds 0 to `last` at one time, each warm-started from the one before or from plans that are known.
    fn chain(&self, time: f64, last: usize, known: &[Planned], effort: &mut Effort) -> Chain {
        let mut selected: Vec<SetRow> = Vec::new();
        let mut chain: Chain = Vec::new();
        let mut before: Option<Planned> = None;
        for _ in 0..=last {
            let set = self.sets.rip.with(selected.clone());
            let name = format!("round {}", chain.len());
            // As in `everything`, so that both find the same plan.
            let rcp = self.at_its_time(known.last());
            let (decision, spent) = match &before {
                None => self.rip_at(&name, time, rcp, known.first()),
                Some(before) => {
                    let first: Vec<&Planned> = iter::once(before).chain(rcp).collect();
                    self.rsp_at(&name, &set, time, &first, None)
                }
            };
            *effort += spent;
            before = decision.planned().cloned();
            chain.push((selected.clone(), decision));
            let new = before.as_ref().map_or(Vec::new(), |planned| self.sets.violated(self.model(), planned));
            if new.is_empty() {
                break;
            }
            selected.extend(new);
        }
        chain
    }
}
