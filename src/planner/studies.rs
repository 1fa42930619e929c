//! Steps (a) to (f) of section 5.3: which planners are run at which time, and how each plan stands to each mode.

mod candidates;
mod committed;
mod common;
mod every_planner;
mod order;
mod outcome;
pub mod protect;
pub mod rounds;
mod times;

pub use outcome::{
    Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run, Scope, THESE_TIMES, THIS_YAW, Verification,
    label, proofs_are_about,
};

use crate::model::{Mission, MissionTime, Model, PlanModel, PlannerKind};
use crate::motion::outside::{Outside, outside};
use crate::motion::time_grid::determined;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::hover::{ACCEPTED, Decision, HoverPlanner, Planned};
use crate::planner::scp::ScpPlanner;
use crate::planner::selection::PlanningSet;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::timing::kinematics::least_time_within;
use crate::planner::timing::search::{Hint, NoTime, Shortest};
use crate::planner::working_set::WorkingSet;
use crate::solve::Effort;
use candidates::nothing_selected_at;
use rayon::prelude::*;
use std::iter;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Told the planner's name, how much of a comparison is done, and each mission time (s) before it is tried.
pub type Progress<'a> = Option<&'a (dyn Fn(&str, f64) + Sync)>;

/// Why RSP is not attempted.
pub const NOTHING_TO_SELECT_BY: &str = "no RIP plan was found to select facets by";
const NO_COMMON_TIME: &str = "no plan was found for any fault mode alone, so there is no time T_d to select facets at";

struct Setting<'a> {
    model: &'a Model,
    mission: &'a Mission,
    sets: PlanningSets,
    progress: Progress<'a>,
    /// Whether plans are asked how long they are committed.
    weighs_risk: bool,
    /// Spent on stops after faults.
    stopping: Mutex<Effort>,
    /// Runs of a whole comparison that are done, and how many there are; 0 of 0 where it is not one.
    done: AtomicUsize,
    all: usize,
}

/// A search's result with what later searches can use.
#[derive(Clone)]
struct Found {
    result: Result<Shortest, NoTime>,
    working_set: WorkingSet,
    effort: Effort,
}

/// Runs the planners. Every mode in `against` must hold hover; see `crate::admissible::verdict`.
///
/// `progress` is told the planner's name and each mission time tried.
pub fn compare(model: &Model, mission: &Mission, scope: Scope, progress: Progress) -> Comparison {
    let ended = times::with_time_of_its_end(model, mission);
    let (model, mission) = ended.as_ref().map_or((model, mission), |(model, mission)| (model, mission));
    let mut comparison = match model.plan.chooses_times {
        true if model.plan.model == PlanModel::Hover => times::with_times_before(model, mission, scope, progress),
        _ => with_times(model, mission, scope, progress),
    };
    if let Some(about) = proofs_are_about(model, mission) {
        let setting = Setting::new(model, mission, None);
        let least = least_time_within(model, mission);
        let has_no_yaw = |at: f64| about == THIS_YAW && setting.with_engine("", |e| e.is_hopeless(at)).0;
        let is_hopeless = |at: f64| least.is_above(at) || has_no_yaw(at);
        comparison.runs.iter_mut().for_each(|run| run.outcome.weaken(about, is_hopeless));
    }
    comparison
}

/// The same with the legs' shares of time as the mission has them.
fn with_times(model: &Model, mission: &Mission, scope: Scope, progress: Progress) -> Comparison {
    let mut setting = Setting { weighs_risk: scope != Scope::Common, ..Setting::new(model, mission, progress) };
    if scope == Scope::Everything {
        setting.all = setting.runs_of_everything();
    }
    let mut comparison = match scope {
        Scope::Plan => match model.plan.require_risk {
            Some(bound) => setting.protect(bound),
            None => setting.plan(),
        },
        Scope::Common => setting.at_common_time(),
        Scope::Everything => setting.everything(),
    };
    comparison.effort += setting.stopping.into_inner().unwrap_or_else(PoisonError::into_inner);
    comparison
}

impl<'a> Setting<'a> {
    fn new(model: &'a Model, mission: &'a Mission, progress: Progress<'a>) -> Self {
        let (sets, stopping) = (PlanningSets::of(model), Mutex::default());
        Setting { model, mission, sets, progress, weighs_risk: false, stopping, done: AtomicUsize::new(0), all: 0 }
    }

    /// The time that the spec asks for or determines.
    fn fixed_time(&self) -> Option<f64> {
        determined(self.mission).or(match self.model.plan.time {
            MissionTime::Fixed(t) => Some(t),
            MissionTime::Minimum => None,
        })
    }

    fn with_engine<T>(&self, what: &str, work: impl FnOnce(&mut HoverPlanner) -> T) -> (T, Effort) {
        let tell = |t: f64| match (self.progress, self.all) {
            (None, _) => {}
            (Some(progress), 0) => progress(what, t),
            (Some(progress), all) => {
                progress(&format!("{what} ({} of {all} plans done)", self.done.load(Ordering::Relaxed)), t);
            }
        };
        let mut engine = HoverPlanner::new(self.model, self.mission, &self.sets.healthy);
        engine.on_progress = Some(&tell);
        let value = work(&mut engine);
        let effort = engine.effort;
        (value, effort)
    }

    /// Counts runs as done.
    fn ended(&self, runs: usize) {
        self.done.fetch_add(runs, Ordering::Relaxed);
    }

    fn search(&self, what: &str, set: &PlanningSet, hint: Hint, working_set: WorkingSet) -> Found {
        let mut working_set = working_set;
        let (result, effort) = match self.model.plan.model {
            PlanModel::Hover => self.with_engine(what, |e| e.shortest(set, hint, &mut working_set)),
            PlanModel::Exact => {
                let initial_guesses: Vec<&Planned> =
                    hint.planned.as_deref().into_iter().chain(&hint.initial_guesses).collect();
                let larger = hint.larger;
                self.with_engine(what, |e| {
                    ScpPlanner::new(e, WrenchModel::Exact, set).shortest(&initial_guesses, larger)
                })
            }
        };
        Found { result, working_set, effort }
    }

    /// The plan at one time; `begins` may be plans of any set.
    fn at(
        &self,
        what: &str,
        set: &PlanningSet,
        time: f64,
        mut working_set: WorkingSet,
        initial_guesses: &[&Planned],
    ) -> (Decision, Effort) {
        match self.model.plan.model {
            PlanModel::Hover => self.with_engine(what, |e| {
                e.progress(time);
                e.decide(time, self.model.plan.samples, set, &mut working_set)
            }),
            PlanModel::Exact => {
                self.with_engine(what, |e| ScpPlanner::new(e, WrenchModel::Exact, set).decide(time, initial_guesses))
            }
        }
    }

    fn solved(&self, time: f64, planned: &Planned) -> MissionPlan {
        let trajectory = planned.trajectory();
        let outside: Vec<Outside> = self
            .sets
            .modes
            .iter()
            .map(|s| outside(&trajectory, &self.model.vehicle, self.model.gravity, &s.rows))
            .collect();
        let committed = if self.weighs_risk { self.committed(&trajectory, &outside) } else { Vec::new() };
        MissionPlan {
            time,
            trajectory,
            committed,
            objective: planned.objective,
            rows: planned.rows,
            outside,
            verification: Verification::None,
            binding: Vec::new(),
            infeasible_at: None,
            infeasible_above: Vec::new(),
        }
    }

    fn own(&self, found: &Found) -> PlanOutcome {
        match &found.result {
            Ok(s) => PlanOutcome::Planned(Box::new(MissionPlan {
                infeasible_at: s.infeasible_at,
                infeasible_above: s.infeasible_above.clone(),
                ..self.solved(s.time, &s.planned)
            })),
            Err(NoTime::Infeasible { times }) => PlanOutcome::proved_infeasible(times),
            Err(NoTime::Inconclusive { at, status }) => {
                PlanOutcome::NotFound(NotFound::Search { at: *at, status: status.clone() })
            }
        }
    }

    /// The same with what limits the time found.
    fn own_with_binding(&self, found: &Found, set: &PlanningSet) -> PlanOutcome {
        let mut outcome = self.own(found);
        if let (PlanOutcome::Planned(solved), Some(planned)) = (&mut outcome, plan_found(found)) {
            let (binding, _) = self.with_engine("", |e| ScpPlanner::new(e, planned.model, set).binding(planned));
            solved.binding = binding.unwrap_or_default();
        }
        outcome
    }

    fn common(&self, time: f64, decision: &Decision) -> PlanOutcome {
        match decision {
            Decision::Feasible(planned) => PlanOutcome::Planned(Box::new(self.solved(time, planned))),
            Decision::Infeasible => PlanOutcome::proved_infeasible(&[time]),
            Decision::Inconclusive(status) => {
                PlanOutcome::NotFound(NotFound::Search { at: time, status: status.clone() })
            }
        }
    }

    fn run(
        &self,
        planner: PlannerKind,
        against: &[String],
        run: Run,
        outcome: PlanOutcome,
        set: &PlanningSet,
    ) -> PlannerRun {
        PlannerRun { planner, against: against.to_vec(), run, outcome, set: set.clone() }
    }

    /// A comparison without runs, at the spec's time where it has one.
    fn begun(&self) -> Comparison {
        Comparison {
            modes: self.sets.names.clone(),
            sets: self.sets.modes.clone(),
            runs: Vec::new(),
            common_time: self.fixed_time(),
            selected: Vec::new(),
            selected_by: Vec::new(),
            trade_off: Vec::new(),
            known: Vec::new(),
            effort: Effort::default(),
        }
    }

    /// Only the spec's own planner, at the spec's time or its shortest.
    fn plan(&self) -> Comparison {
        let mut out = self.begun();
        let kind = self.model.plan.planner;
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
        let begun: Vec<&Planned> = initial_guesses.iter().collect();
        let nothing_selected = out.selected.is_empty();
        let at = |time: f64| match begun.first() {
            // Where nothing is selected RSP's plan is RIP's.
            Some(&rip) if nothing_selected => (Decision::Feasible(Box::new(rip.clone())), Effort::default()),
            Some(_) => self.rsp_at(name, &set, time, &begun, None),
            None if kind == PlannerKind::Rip => self.rip_at(name, time, None, None),
            None => self.at(name, &set, time, WorkingSet::default(), &begun),
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
            None if nothing_selected && !initial_guesses.is_empty() => {
                let found = nothing_selected_at(&initial_guesses[0]);
                (Run::Own, self.own_with_binding(&found, &set), found.effort)
            }
            None => {
                // Steps begin from RCP's plan, which RSP's set allows; the hover model's search wants to know about T_d.
                let rcp = initial_guesses.get(1).filter(|_| self.model.plan.model == PlanModel::Exact);
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
                (Run::Own, self.own_with_binding(&found, &set), found.effort)
            }
        };
        out.effort += effort;
        out.runs.push(self.run(kind, against, run, outcome, &set));
        out
    }

    /// Steps (c) to (e) for RSP alone: T_d, the RIP plan there, and the healthy set with what it violates; and plans to
    /// begin RSP's from, RIP's and then RCP's.
    fn rsp_set(&self, out: &mut Comparison) -> Result<(PlanningSet, Vec<Planned>), PlanOutcome> {
        let joint = self.seek_common_time(out);
        let rcp = joint.as_ref().and_then(plan_found);
        let Some(time) = out.common_time else {
            let found = self.search("RIP", &self.sets.rip, Hint::default(), WorkingSet::default());
            out.effort += found.effort;
            return Err(match self.own(&found) {
                // Nothing is shown of RSP itself: the modes' sets are smaller than RSP's, and may not even be proved infeasible.
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

    /// Each mode's own shortest time, in parallel; results in the order of the modes.
    ///
    /// Nothing imposed here is wider than the healthy set, so no time is shorter than RIP's; and where RIP's plan stays
    /// inside that, it is the mode's plan.
    fn singles_own(&self, rip: &Found, hint: Hint) -> Vec<Found> {
        let work = |(name, set): (&String, &PlanningSet)| {
            if plan_found(rip).is_some_and(|plan| self.is_inside(plan, set)) {
                self.ended(1);
                return Found {
                    result: rip.result.clone(),
                    working_set: WorkingSet::default(),
                    effort: Effort::default(),
                };
            }
            let working_set = rip.working_set.translated(&self.sets.rip, set);
            let initial_guesses = plan_found(rip).into_iter().chain(&hint.initial_guesses).cloned().collect();
            let hint = Hint { initial_guesses, larger: time(rip), ..hint.clone() };
            let found = self.search(&format!("RCP {name}"), set, hint, working_set);
            self.ended(1);
            found
        };
        self.sets.names.par_iter().zip(self.sets.singles.par_iter()).map(work).collect()
    }

    /// Whether a plan of RIP keeps to a smaller set too. With rotors that lag a wrench inside is not enough.
    fn is_inside(&self, plan: &Planned, set: &PlanningSet) -> bool {
        let found = || outside(&plan.trajectory(), &self.model.vehicle, self.model.gravity, &set.rows);
        self.model.thrust_lag().is_none() && found().max_violation <= ACCEPTED
    }

    /// The plan at a time, taken from the own search where that ended at the same time; `other` is one of another set.
    fn at_or_own(
        &self,
        what: &str,
        set: &PlanningSet,
        at: f64,
        own: &Found,
        other: Option<&Planned>,
    ) -> (Decision, Effort) {
        match &own.result {
            Ok(s) if s.time == at => (Decision::Feasible(Box::new(s.planned.clone())), Effort::default()),
            _ => {
                let initial_guesses: Vec<&Planned> = plan_found(own).into_iter().chain(other).collect();
                self.at(what, set, at, own.working_set.clone(), &initial_guesses)
            }
        }
    }
}

/// What a decision at T_d tells the search for the shortest time.
fn hint_from(at: f64, decision: Decision) -> Hint {
    match decision {
        Decision::Feasible(planned) => Hint { feasible: Some(at), planned: Some(planned), ..Hint::default() },
        _ => Hint { near: Some(at), ..Hint::default() },
    }
}

fn planned_of(decision: &Decision) -> Option<&Planned> {
    match decision {
        Decision::Feasible(planned) => Some(planned),
        _ => None,
    }
}

/// The plan at the shortest time.
fn plan_found(found: &Found) -> Option<&Planned> {
    found.result.as_ref().ok().map(|s| &s.planned)
}

fn time(found: &Found) -> Option<f64> {
    found.result.as_ref().ok().map(|s| s.time)
}

fn time_below(found: &Found) -> Option<f64> {
    found.result.as_ref().ok()?.infeasible_at
}
