//! What all runs of one comparison share: the sets, the progress, and how one planner is run.

use super::found::Found;
use super::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Progress, Run, Verification};
use crate::admissible::row::VIOLATED;
use crate::model::{DynamicFigure, Mission, MissionTime, Model, PlannerKind, Problem};
use crate::motion::Trajectory;
use crate::motion::outside::{Outside, outside};
use crate::motion::time_grid::determined;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::ScpPlanner;
use crate::planner::selection::PlanningSet;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::timing::search::{Hint, NoTime};
use crate::planner::trial::Trial;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned, Planner, finds_local_optima, planner};
use crate::solve::Effort;
use crate::tolerance::MOST_OUTSIDE;
use rayon::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A mission with its sets, and how planners are run on it.
pub(super) struct Setting<'a> {
    pub problem: Problem<'a>,
    pub sets: PlanningSets,
    pub progress: Progress<'a>,
    /// Whether plans get committed times, which risk is computed from.
    pub weighs_risk: bool,
    /// The solver's effort for stops after faults.
    pub stopping: Mutex<Effort>,
    /// Runs of a whole comparison that are done, and how many there are; 0 of 0 for other scopes.
    pub done: AtomicUsize,
    pub all: usize,
}

impl<'a> Setting<'a> {
    pub fn new(problem: Problem<'a>, progress: Progress<'a>) -> Self {
        let (sets, stopping) = (PlanningSets::of(problem.model()), Mutex::default());
        Setting { problem, sets, progress, weighs_risk: false, stopping, done: AtomicUsize::new(0), all: 0 }
    }

    pub fn model(&self) -> &'a Model {
        self.problem.model()
    }

    pub fn mission(&self) -> &'a Mission {
        self.problem.mission()
    }

    /// The mission time that the spec gives or determines, s.
    pub fn fixed_time(&self) -> Option<f64> {
        determined(self.mission()).or(match self.model().plan.time {
            MissionTime::Fixed(t) => Some(t),
            MissionTime::Minimum => None,
        })
    }

    /// Reports a trial of `what`.
    fn report(&self, what: &str, trial: Trial) {
        match (self.progress, self.all) {
            (None, _) => {}
            (Some(progress), 0) => progress(what, trial),
            (Some(progress), all) => {
                progress(&format!("{what} ({} of {all} plans done)", self.done.load(Ordering::Relaxed)), trial);
            }
        }
    }

    /// The work of the spec's planner, and what it took. `what` names it in progress reports.
    fn with_planner<T>(&self, what: &str, work: impl FnOnce(&mut dyn Planner) -> T) -> (T, Effort) {
        let report = |trial: Trial| self.report(what, trial);
        let mut planner = planner(self.problem, &self.sets.healthy, Some(&report));
        let value = work(&mut *planner);
        (value, planner.effort())
    }

    /// Whether fixed times, yaw waypoints or reach rule out every plan of a mission time, s, for any choice of yaw.
    pub fn is_hopeless(&self, time: f64) -> bool {
        HoverPlanner::new(self.problem, &self.sets.healthy).is_hopeless(time)
    }

    /// Whether plans are local optima; see [`finds_local_optima`].
    pub fn finds_local_optima(&self) -> bool {
        finds_local_optima(self.model())
    }

    /// Counts runs as done.
    pub fn ended(&self, runs: usize) {
        self.done.fetch_add(runs, Ordering::Relaxed);
    }

    /// The search for the shortest time of a set.
    pub fn search(&self, what: &str, set: &PlanningSet, hint: Hint, mut working_set: WorkingSet) -> Found {
        let (result, effort) = self.with_planner(what, |p| p.shortest_time(set, hint, &mut working_set));
        Found { result, working_set, effort }
    }

    /// The decision on one mission time, s. `initial_guesses` are plans of any set.
    pub fn at(
        &self,
        what: &str,
        set: &PlanningSet,
        time: f64,
        mut working_set: WorkingSet,
        initial_guesses: &[&Planned],
    ) -> (Decision, Effort) {
        self.with_planner(what, |p| p.plan_at(time, set, initial_guesses, &mut working_set))
    }

    /// The decision on a mission time, s, taken from the own search if that ended at the same time; `other` is a plan
    /// of another set.
    pub fn at_or_own(
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
                let initial_guesses: Vec<&Planned> = own.planned().into_iter().chain(other).collect();
                self.at(what, set, at, own.working_set.clone(), &initial_guesses)
            }
        }
    }

    /// Puts the plan of a second pass in place of each run's plan; see [`Planner::more_comfortable`]. Plans of RCP
    /// against one of several modes, which `plan` makes for no spec of these modes, stay as they are.
    pub fn pass_again(&self, comparison: &mut Comparison) -> Effort {
        let all = self.sets.names.len();
        let is_of_spec = |run: &&mut PlannerRun| run.planner != PlannerKind::Rcp || run.against.len() == all;
        let runs = comparison.runs.par_iter_mut().filter(is_of_spec).chain(comparison.ignoring.as_deref_mut());
        let efforts: Vec<Effort> = runs.map(|run| self.pass_again_over(run)).collect();
        let mut all = Effort::default();
        efforts.into_iter().for_each(|effort| all += effort);
        all
    }

    fn pass_again_over(&self, run: &mut PlannerRun) -> Effort {
        let PlanOutcome::Planned(plainer) = &run.outcome else { return Effort::default() };
        let Some(planned) = &plainer.planned else { return Effort::default() };
        let set = match run.planner {
            PlannerKind::Rcp => run.set.clone(),
            // What the plan keeps of the modes' sets, imposed or not, the second pass keeps too.
            PlannerKind::Rip | PlannerKind::Rsp => self.sets.kept(self.model(), planned, &run.set),
        };
        let is_given = run.run == Run::Common && self.model().plan.time != MissionTime::Minimum;
        let again = |planner: &mut dyn Planner| planner.more_comfortable(planned, &set, is_given);
        let (found, effort) = self.with_planner("second pass", again);
        let Some(found) = found else { return effort };
        let further = |(new, old): (&Outside, &Outside)| new.max_violation > old.max_violation.max(0.0) + MOST_OUTSIDE;
        let solved = MissionPlan {
            binding: plainer.binding.clone(),
            infeasible_at: plainer.infeasible_at,
            infeasible_above: plainer.infeasible_above.clone(),
            least_objective: plainer.objective,
            ..self.solved(plainer.time, &found)
        };
        // The plan may leave no mode's set further than before.
        if !solved.outside.iter().zip(&plainer.outside).any(further) {
            run.plainer = Some(plainer.clone());
            run.outcome = PlanOutcome::Planned(Box::new(solved));
        }
        effort
    }

    /// A plan with what is reported of it.
    pub fn solved(&self, time: f64, planned: &Planned) -> MissionPlan {
        let described = self.described(time, planned.trajectory(), planned.objective, planned.rows);
        MissionPlan { planned: Some(Box::new(planned.clone())), ..described }
    }

    /// A trajectory with what is reported of it as a plan.
    pub fn described(&self, time: f64, trajectory: Trajectory, objective: f64, rows: usize) -> MissionPlan {
        let outside: Vec<Outside> = self
            .sets
            .modes
            .iter()
            .map(|s| outside(&trajectory, &self.model().vehicle, &self.model().environment(), &s.rows))
            .collect();
        let at_ends_of_drag = self.at_ends_of_drag(&trajectory, &outside);
        let committed = if self.weighs_risk { self.committed(&trajectory, &outside) } else { Vec::new() };
        MissionPlan {
            time,
            trajectory,
            committed,
            objective,
            least_objective: objective,
            rows,
            outside,
            at_ends_of_drag,
            verification: Verification::None,
            binding: Vec::new(),
            infeasible_at: None,
            infeasible_above: Vec::new(),
            planned: None,
        }
    }

    /// [`MissionPlan::at_ends_of_drag`] of a trajectory, which violates the modes' sets by `middle`.
    fn at_ends_of_drag(&self, trajectory: &Trajectory, middle: &[Outside]) -> Option<[f64; 2]> {
        let model = self.model();
        if model.vehicle.drag_spread.is_none() || trajectory.model != WrenchModel::Exact {
            return None;
        }
        let held = || self.sets.modes.iter().zip(middle).filter(|(_, found)| found.max_violation <= VIOLATED);
        Some([0.0, 1.0].map(|share| {
            let model = model.at(DynamicFigure::Drag, share);
            let (vehicle, environment) = (&model.vehicle, model.environment());
            let sets = held().map(|(set, _)| set).chain([&self.sets.rip]);
            let violations = sets.map(|set| outside(trajectory, vehicle, &environment, &set.rows).max_violation);
            violations.fold(f64::NEG_INFINITY, f64::max)
        }))
    }

    /// The outcome of a search for the shortest time.
    pub fn own(&self, found: &Found) -> PlanOutcome {
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

    /// The outcome of a search for the shortest time, with what limits the time found.
    pub fn own_with_binding(&self, found: &Found, set: &PlanningSet) -> PlanOutcome {
        let mut outcome = self.own(found);
        if let (PlanOutcome::Planned(solved), Some(planned)) = (&mut outcome, found.planned()) {
            // One linearised program about the plan, in the model that it was made with.
            let mut hover = HoverPlanner::new(self.problem, &self.sets.healthy);
            let binding = ScpPlanner::new(&mut hover, planned.model, set).binding(planned);
            solved.binding = binding.unwrap_or_default();
        }
        outcome
    }

    /// The outcome of a decision on one mission time, s.
    pub fn common(&self, time: f64, decision: &Decision) -> PlanOutcome {
        match decision {
            Decision::Feasible(planned) => PlanOutcome::Planned(Box::new(self.solved(time, planned))),
            Decision::Infeasible => PlanOutcome::proved_infeasible(&[time]),
            Decision::Inconclusive(status) => {
                PlanOutcome::NotFound(NotFound::Search { at: time, status: status.clone() })
            }
        }
    }

    /// The record of one planner's run.
    pub fn run(
        &self,
        planner: PlannerKind,
        against: &[String],
        run: Run,
        outcome: PlanOutcome,
        set: &PlanningSet,
    ) -> PlannerRun {
        PlannerRun { planner, against: against.to_vec(), run, outcome, set: set.clone(), plainer: None }
    }

    /// A comparison without runs, at the spec's time if it has one.
    pub fn without_runs(&self) -> Comparison {
        Comparison {
            modes: self.sets.names.clone(),
            sets: self.sets.modes.clone(),
            provisions: self.sets.provisions.clone(),
            runs: Vec::new(),
            common_time: self.fixed_time(),
            covering_time: None,
            selected: Vec::new(),
            selected_by: Vec::new(),
            own_selected_by: None,
            ignoring: None,
            trade_off: Vec::new(),
            for_ways_out: false,
            effort: Effort::default(),
        }
    }
}
