//! From a spec to its plan: a [`Task`] is a mission whose modes can all be tolerated. It plans, compares planners, and
//! explains why no plan was found.

use super::capture_height::{self, ImposedHeight};
use super::planned::{Explained, Planning};
use super::refusals::{OtherSpec, Refusal, Unexplained};
use crate::admissible::diagnose::{diagnose, is_too_large};
use crate::cancel;
use crate::certify;
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::explain::detour::{self, Detour};
use crate::explain::nearby::{self, Nearby};
use crate::explain::planners::Planners;
use crate::explain::{self, Explanation};
use crate::model::MAX_SAMPLES_OF_A_SEARCH;
use crate::model::{Mission, MissionTime, Model, PlannerKind, Problem};
use crate::observer::{Observer, Silent, Trial, timed};
use crate::planner::studies::{Comparison, NotFound, PlanOutcome, PlannerRun, Run, Scope, run_planners};
use crate::spec::Spec;
use std::cell::Cell;
use std::sync::OnceLock;
use std::time::Instant;

/// The spec has no mission to plan.
pub const NO_MISSION: &str = "mavc::plan::no_mission";

/// Plans the spec's mission with the spec's planner ([RIP, RCP or RSP](crate::model::PlannerKind)), at the time that
/// the spec fixes or at the shortest time found. The planners are those of sections 5.2 and 5.3 of the paper; see
/// docs/method/planners.md and exact-planner.md, the latter for the exact model.
///
/// The outcome is a plan that passed the check of finished plans, a proof of infeasibility, or neither. The plan's time
/// is in s; its nodes hold derivatives as `[axis][order]` in SI units ([`NodeState`](crate::motion::NodeState)).
///
/// # Errors
/// The spec has no mission, its sets are too large, or a fault mode that the plan must tolerate cannot hover.
///
/// ```
/// use mavc::PlanOutcome;
///
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// match mavc::plan(&spec)?.outcome() {
///     PlanOutcome::Planned(plan) => println!("{:.2} s", plan.time),
///     PlanOutcome::Infeasible(proof) => println!("proved infeasible at {:?} s", proof.proved),
///     PlanOutcome::NotFound(_) | PlanOutcome::NotAttempted { .. } => println!("neither found nor proved infeasible"),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plan(spec: &Spec) -> Result<Planning, Refusal> {
    Ok(Task::new(spec)?.plan(&Silent))
}

/// Plans with RIP, RCP for each mode, RCP for all modes jointly, and RSP: each at its own shortest time, and all at the
/// common time T_d (section 5.3 of the paper). All numbers are in SI units.
///
/// [`Comparison::runs`] has a run of each planner at its own time, then one of each at T_d, both in the order RIP, RCP
/// for each mode in the order of `against`, the joint RCP if there are several modes, RSP. If there is no T_d, RSP and
/// the runs at T_d are missing.
///
/// # Errors
/// Those of [`plan`]; also if the spec has more than [`MAX_SAMPLES_OF_A_SEARCH`] samples.
///
/// ```
/// let compiler = mavc::Compiler::new().set("plan.model = hover").set("plan.samples = 40");
/// let spec = compiler.text("roof.mav", mavc::TEMPLATE.as_bytes()).into_result()?;
/// let comparison = mavc::compare(&spec)?;
/// for run in &comparison.runs {
///     println!("{} {:?}", run.planner.name(), run.outcome.plan().map(|plan| plan.time));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare(spec: &Spec) -> Result<Comparison, Refusal> {
    Ok(Task::to_compare(spec)?.compare(&Silent))
}

/// Explains why no plan was found: nearby times (s) at which there is one; or an irreducible set of statements of the
/// spec for which together no plan was found or none exists, with changes of single statements that were tried and give
/// a plan (docs/method/conflicts.md).
///
/// `planning` is the outcome of [`plan`] for this spec. If it is a plan, both parts of the result are empty.
///
/// # Errors
/// Those of [`plan`]; also if `planning` is the outcome for another spec.
///
/// ```
/// let compiler = mavc::Compiler::new().set("plan.time = 6 s").set("plan.samples = 60").without_flights();
/// let spec = compiler.text("roof.mav", mavc::TEMPLATE.as_bytes()).into_result()?;
/// let planning = mavc::plan(&spec)?;
/// let conflict = mavc::explain(&spec, &planning)?.conflict.expect("6 s are too short");
/// assert!(conflict.conflict.proved && conflict.conflict.least_time.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn explain(spec: &Spec, planning: &Planning) -> Result<Explained, Unexplained> {
    planning.check_spec(spec)?;
    Ok(Task::new(spec)?.explain(planning, &Silent)?)
}

/// A mission that can be planned: hover is inside the set of every mode that the plan must tolerate.
#[derive(Debug, Clone)]
pub struct Task<'s> {
    spec: &'s Spec,
    /// With `require capture_height`: what is planned instead of the spec's model.
    pub(super) imposed: Option<ImposedHeight>,
    remarks: Vec<Diagnostic>,
}

impl<'s> Task<'s> {
    /// Checks that the spec's mission can be planned: the healthy vehicle can hover, and so can the vehicle in each
    /// mode that the plan must tolerate.
    ///
    /// # Errors
    /// The spec has no mission, its sets are too large, a mode cannot hover, or the mission cannot keep the height that
    /// `require capture_height` asks for.
    pub fn new(spec: &'s Spec) -> Result<Self, Refusal> {
        let model = spec.model();
        let answers = diagnose(model);
        let is_too_large = is_too_large(&answers);
        let is_error = |d: &Diagnostic| d.severity == Severity::Error;
        let is_intolerable = answers.iter().any(is_error);
        let mut remarks = answers;
        remarks.extend(no_mission(model));
        sort(&mut remarks);
        match spec.problem() {
            _ if is_too_large => Err(Refusal::TooLarge(remarks)),
            None => Err(Refusal::NoMission(remarks)),
            Some(_) if is_intolerable => Err(Refusal::Intolerable(remarks)),
            Some(_) => match capture_height::impose(model) {
                Ok((imposed, remark)) => {
                    remarks.extend(remark);
                    Ok(Task { spec, imposed, remarks })
                }
                Err(error) => {
                    remarks.push(*error);
                    Err(Refusal::TooLow(remarks))
                }
            },
        }
    }

    /// A task for a comparison of planners, which allows fewer samples than [`Task::new`].
    ///
    /// # Errors
    /// Those of [`Task::new`]; also if there are too many samples.
    pub fn to_compare(spec: &'s Spec) -> Result<Self, Refusal> {
        match too_many_samples(spec.model()) {
            Some(error) => Err(Refusal::TooLarge(vec![error])),
            None => Task::new(spec),
        }
    }

    pub fn spec(&self) -> &'s Spec {
        self.spec
    }

    /// The model and the mission that are planned.
    ///
    /// # Panics
    /// Never: [`Task::new`] makes no task of a spec without a mission.
    pub fn problem(&self) -> Problem<'_> {
        Problem::of(self.model()).expect("a task has a mission")
    }

    /// The spec's model; with `require capture_height` the limits that keep the height are among those of the mission.
    pub fn model(&self) -> &Model {
        self.imposed.as_ref().map_or(self.spec.model(), |imposed| &imposed.model)
    }

    pub fn mission(&self) -> &Mission {
        self.problem().mission()
    }

    /// Warnings about the sets of modes, such as hover on an edge.
    pub fn remarks(&self) -> &[Diagnostic] {
        &self.remarks
    }

    /// Plans the mission and reports progress to an observer; see [`plan`]. If the plan has detours, statements that
    /// forbid them are tried where one quick search is cheap. A plan found so that is shorter takes the place of the
    /// plan.
    pub fn plan(&self, observer: &dyn Observer) -> Planning {
        let required = self.model().plan.require_capture;
        let height = required.and_then(|required| required.height);
        let comparison = self.run(Scope::Plan, observer);
        let mut planning = Planning {
            comparison,
            spec: self.spec.identity(),
            height,
            capture_heights: OnceLock::new(),
            detours: Vec::new(),
            cut_short: cancel::is_enough(),
        };
        if let Some(run) = planning.comparison().runs.last() {
            match self.without_detours(planning.comparison(), run, observer) {
                (_, Some(shorter)) => planning.replace(self, shorter),
                (tried, None) => planning.detours = tried,
            }
        }
        planning
    }

    /// Compares the planners and reports progress to an observer; see [`compare`]. A shorter plan of the spec's planner
    /// that is found without its detours counts, as in [`Self::plan`].
    pub fn compare(&self, observer: &dyn Observer) -> Comparison {
        let mut comparison = self.run(Scope::Everything, observer);
        let plan = &self.model().plan;
        let is_own = |run: &PlannerRun| {
            run.run == Run::Own
                && run.planner == plan.planner
                && (run.planner == PlannerKind::Rip || run.against.len() == comparison.modes.len())
        };
        if plan.time == MissionTime::Minimum
            && let Some(place) = comparison.runs.iter().position(is_own)
            && let (_, Some(shorter)) = self.without_detours(&comparison, &comparison.runs[place], observer)
        {
            comparison.take_own(place, shorter);
        }
        comparison
    }

    /// Plans with RIP, the joint RCP and RSP at the common time only: the plans that a campaign flies.
    pub fn at_common_time(&self, observer: &dyn Observer) -> Comparison {
        self.run(Scope::Common, observer)
    }

    fn run(&self, scope: Scope, observer: &dyn Observer) -> Comparison {
        let tries = |planner: &str, trial: Trial| observer.tries(planner, trial);
        observer.begins("building the admissible sets");
        let mut comparison = timed(observer, "plan", || run_planners(self.problem(), scope, Some(&tries)));
        timed(observer, "check", || certify::check(self.problem(), &mut comparison));
        observer.solved(&comparison.effort);
        comparison
    }

    /// Explains an outcome and reports progress to an observer; see [`explain`](explain()).
    ///
    /// # Errors
    /// `planning` is the outcome for another spec.
    pub fn explain(&self, planning: &Planning, observer: &dyn Observer) -> Result<Explained, OtherSpec> {
        planning.check_spec(self.spec)?;
        let nearby = self.nearby(planning, observer);
        let is_failed = matches!(planning.outcome(), PlanOutcome::NotFound(NotFound::Check { .. }));
        // No statement of the spec is to blame if the planner has a plan at another time, found a trajectory that fails
        // the check, or only misses the required risk.
        let needs_no_conflict = planning.plan().is_some()
            || is_failed
            || nearby.times().next().is_some()
            || !planning.comparison().trade_off.is_empty();
        let conflict = if needs_no_conflict { None } else { self.conflict(observer) };
        Ok(Explained { nearby, conflict })
    }

    /// The detours of a run's plan, with what statements against them give if one quick search is cheap and the search
    /// was not told to end; also what was found so, if that is shorter.
    fn without_detours(
        &self,
        comparison: &Comparison,
        run: &PlannerRun,
        observer: &dyn Observer,
    ) -> (Vec<Detour>, Option<Comparison>) {
        let mut detours = self.untried(run);
        if detours.is_empty() || cancel::is_enough() || !detour::is_cheap(self.problem()) {
            return (detours, None);
        }
        observer.begins("the plan climbs or strays; trying statements that forbid it");
        let tried =
            timed(observer, "detours", || detour::try_statements(self.problem(), comparison, run, &mut detours));
        observer.asked(None, &tried.1);
        (detours, tried.0)
    }

    pub(super) fn untried(&self, run: &PlannerRun) -> Vec<Detour> {
        run.outcome.plan().map_or(Vec::new(), |plan| detour::detours(self.problem(), plan))
    }

    fn nearby(&self, planning: &Planning, observer: &dyn Observer) -> Nearby {
        let tries = |time: f64| {
            observer.begins(&format!("no plan was found; looking for times with one, near {time:.2} s"));
        };
        let begin = Instant::now();
        let (nearby, effort) = nearby::nearby(self.problem(), planning.comparison(), &tries);
        if effort.solves > 0 {
            observer.ended("nearby", begin.elapsed());
            observer.asked(None, &effort);
        }
        nearby
    }

    fn conflict(&self, observer: &dyn Observer) -> Option<Explanation> {
        let asked = Cell::new(0);
        let tries = |time: f64| {
            asked.set(asked.get() + 1);
            let variant = asked.get();
            observer.begins(&format!("no plan; which statements conflict? Variant {variant} of the spec, {time:.2} s"));
        };
        let mut planner = Planners::new(Some(&tries));
        let found = timed(observer, "why", || explain::explain(self.problem(), &mut planner));
        observer.asked(Some(found.as_ref().map_or(0, |e| e.questions)), &planner.effort);
        found
    }
}

/// The error of a spec without a mission, for a command that plans.
pub fn no_mission(model: &Model) -> Option<Diagnostic> {
    let error =
        Diagnostic::error(NO_MISSION, model.vehicle.span, "this spec describes a vehicle but no mission to plan");
    let error = error.here("only a vehicle is described here");
    model.mission.is_none().then(|| error.help("add a `mission` block, or use `mavc analyze` for the vehicle alone"))
}

/// A comparison searches for each planner's shortest time, which takes many plans, so it allows fewer samples.
fn too_many_samples(model: &Model) -> Option<Diagnostic> {
    let samples = model.plan.samples;
    let most = MAX_SAMPLES_OF_A_SEARCH;
    let message = format!("{samples} samples are too many to compare planners: at most {most}");
    let error = Diagnostic::error("mavc::plan::samples", model.plan.samples_span, message);
    let help = format!("`mavc compare --set plan.samples={most}` leaves the file as it is");
    (samples > most).then(|| error.here("too many for every planner's shortest time").help(help))
}
