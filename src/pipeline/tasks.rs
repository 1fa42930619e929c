//! Planning: the check that every mode can be tolerated, the plan, planners side by side, and why there is no plan.

use crate::admissible::diagnose::{diagnose, is_too_large};
use crate::certify;
use crate::certify::between::{Between, between};
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::explain::nearby::{self, Nearby};
use crate::explain::planners::Planners;
use crate::explain::{self, Explanation};
use crate::model::{MAX_SAMPLES_OF_A_SEARCH, Mission, Model};
use crate::observer::{Observer, Silent, timed};
use crate::planner::studies::rounds::{Round, rounds};
use crate::planner::studies::{
    Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Scope, compare as compare_planners,
};
use crate::spec::Spec;
use crate::verdict::Verdict;
use std::cell::Cell;
use std::error::Error;
use std::fmt;
use std::time::Instant;

/// A mission to plan is needed but none is written.
pub const NO_MISSION: &str = "mavc::plan::no_mission";

/// Plans the spec's mission with the spec's planner ([RIP, RCP or RSP](crate::model::PlannerKind)): at the time that the
/// spec fixes, or at the shortest time found. Sections 5.2 and 5.3 of the paper; docs/method.md for the exact model.
///
/// The outcome is a plan that passed the check of finished plans, a proof that none exists, or neither; times are in s,
/// everything else in SI units.
///
/// # Errors
/// The spec has no mission, its sets are too large, or a fault mode that the plan must tolerate leaves no hover.
///
/// ```
/// use mavc::PlanOutcome;
///
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// match mavc::plan(&spec)?.outcome() {
///     PlanOutcome::Planned(plan) => println!("{:.2} s", plan.time),
///     PlanOutcome::Infeasible(proof) => println!("proved infeasible at {:?} s", proof.proved),
///     PlanOutcome::NotFound(_) | PlanOutcome::NotAttempted { .. } => println!("nothing found, nothing proved"),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plan(spec: &Spec) -> Result<Planning, Refusal> {
    Ok(Task::new(spec)?.plan(&Silent))
}

/// Runs RIP, RCP for each mode and jointly, and RSP, each at its own shortest time and all at the common time T_d
/// (section 5.3 of the paper).
///
/// # Errors
/// As for [`plan`]; and more samples than a comparison can take.
///
/// ```
/// let compiler = mavc::Compiler::new().set("plan.model=hover").set("plan.samples=60");
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

/// Explains why a mission has no plan: times nearby at which there is one, or an irreducible set of statements that
/// cannot hold together, and changes of single statements that give a plan, each tried.
///
/// Of a plan that was found there is nothing to explain, and both parts are empty.
///
/// # Errors
/// As for [`plan`].
///
/// ```
/// let compiler = mavc::Compiler::new().set("plan.time = 6 s").without_flights();
/// let spec = compiler.text("roof.mav", mavc::TEMPLATE.as_bytes()).into_result()?;
/// let planning = mavc::plan(&spec)?;
/// let conflict = mavc::explain(&spec, &planning)?.conflict.expect("6 s are too short");
/// assert!(conflict.conflict.proved && !conflict.fixes.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn explain(spec: &Spec, planning: &Planning) -> Result<Explained, Refusal> {
    Ok(Task::new(spec)?.explain(planning, &Silent))
}

/// Why a spec is not planned at all.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// The spec describes no mission.
    NoMission(Vec<Diagnostic>),
    /// The spec asks for more than can be planned or compared.
    TooLarge(Vec<Diagnostic>),
    /// Hover does not lie inside every set that the plan must keep to.
    Intolerable(Vec<Diagnostic>),
}

impl Refusal {
    /// The reasons, and warnings beside them, at their places in the spec.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            Refusal::NoMission(told) | Refusal::TooLarge(told) | Refusal::Intolerable(told) => told,
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors = self.diagnostics().iter().filter(|d| d.severity == Severity::Error);
        let messages: Vec<&str> = errors.map(|d| d.message.as_str()).collect();
        f.write_str(&messages.join("; "))
    }
}

impl Error for Refusal {}

/// A mission that can be planned: every mode that the plan must tolerate leaves hover inside its set.
#[derive(Debug, Clone)]
pub struct Task<'s> {
    spec: &'s Spec,
    mission: &'s Mission,
    remarks: Vec<Diagnostic>,
}

/// The outcome of planning one mission with the spec's planner.
#[derive(Debug, Clone)]
pub struct Planning {
    comparison: Comparison,
}

impl Planning {
    pub(super) fn run(&self) -> &PlannerRun {
        &self.comparison.runs[self.comparison.runs.len() - 1]
    }

    /// A plan, a proof that there is none, or neither.
    pub fn outcome(&self) -> &PlanOutcome {
        &self.run().outcome
    }

    /// The outcome in one of the four words.
    pub fn verdict(&self) -> Verdict {
        self.outcome().verdict()
    }

    /// The plan, where one was found.
    pub fn plan(&self) -> Option<&MissionPlan> {
        self.outcome().plan()
    }

    /// The sets, the facets that RSP selected, and under `require risk` the trade-off: what reports print.
    pub fn comparison(&self) -> &Comparison {
        &self.comparison
    }

    /// How far the plan's rows are shown to hold between its nodes; `None` where there is no plan.
    pub fn between(&self, task: &Task, observer: &dyn Observer) -> Option<Vec<Between>> {
        observer.begins("looking for a proof of every instant");
        timed(observer, "prove", || {
            let run = self.run();
            run.outcome.plan().map(|plan| between(task.model(), task.mission, run, plan))
        })
    }
}

/// Why there is no plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Explained {
    /// Times on either side of the spec's at which the planner found a plan. The spec is not blamed where there is one.
    pub nearby: Nearby,
    /// Statements that cannot hold together, and changes that give a plan.
    pub conflict: Option<Explanation>,
}

impl<'s> Task<'s> {
    /// Checks that the spec's mission can be planned: that the vehicle hovers, and with each mode that the plan must
    /// tolerate.
    ///
    /// # Errors
    /// The spec has no mission, its sets are too large, or a mode leaves no hover.
    pub fn new(spec: &'s Spec) -> Result<Self, Refusal> {
        let model = spec.model();
        let answers = diagnose(model);
        let is_too_large = is_too_large(&answers);
        let is_error = |d: &Diagnostic| d.severity == Severity::Error;
        let is_intolerable = answers.iter().any(is_error);
        let mut remarks = answers;
        remarks.extend(no_mission(model));
        sort(&mut remarks);
        match &model.mission {
            _ if is_too_large => Err(Refusal::TooLarge(remarks)),
            None => Err(Refusal::NoMission(remarks)),
            Some(_) if is_intolerable => Err(Refusal::Intolerable(remarks)),
            Some(mission) => Ok(Task { spec, mission, remarks }),
        }
    }

    /// The same for planners side by side, which take fewer samples.
    ///
    /// # Errors
    /// As for [`Task::new`], and too many samples.
    pub fn to_compare(spec: &'s Spec) -> Result<Self, Refusal> {
        match too_many_samples(spec.model()) {
            Some(error) => Err(Refusal::TooLarge(vec![error])),
            None => Task::new(spec),
        }
    }

    pub fn spec(&self) -> &'s Spec {
        self.spec
    }

    pub fn model(&self) -> &'s Model {
        self.spec.model()
    }

    pub fn mission(&self) -> &'s Mission {
        self.mission
    }

    /// Warnings about the sets of modes, such as hover on an edge.
    pub fn remarks(&self) -> &[Diagnostic] {
        &self.remarks
    }

    /// As [`plan`], observed.
    pub fn plan(&self, observer: &dyn Observer) -> Planning {
        Planning { comparison: self.run(Scope::Plan, observer) }
    }

    /// As [`compare`], observed.
    pub fn compare(&self, observer: &dyn Observer) -> Comparison {
        self.run(Scope::Everything, observer)
    }

    /// RIP, RCP jointly and RSP at the common time alone: what a campaign flies.
    pub fn at_common_time(&self, observer: &dyn Observer) -> Comparison {
        self.run(Scope::Common, observer)
    }

    /// Numbers of rounds of RSP's selection side by side, from `wanted.0` to `wanted.1`, after a comparison.
    pub fn rounds(&self, comparison: &mut Comparison, wanted: (usize, usize), observer: &dyn Observer) -> Vec<Round> {
        let tries = |round: &str, time: f64| observer.tries(round, time);
        timed(observer, "rounds", || {
            let mut found = rounds(self.model(), self.mission, comparison, wanted, Some(&tries));
            certify::check_rounds(self.model(), self.mission, &mut found);
            found
        })
    }

    fn run(&self, scope: Scope, observer: &dyn Observer) -> Comparison {
        let (model, mission) = (self.model(), self.mission);
        let tries = |planner: &str, time: f64| observer.tries(planner, time);
        observer.begins("building the admissible sets");
        let mut comparison = timed(observer, "plan", || compare_planners(model, mission, scope, Some(&tries)));
        timed(observer, "check", || certify::check(model, mission, &mut comparison));
        observer.solved(&comparison.effort);
        comparison
    }

    /// As [`explain`](explain()), observed.
    pub fn explain(&self, planning: &Planning, observer: &dyn Observer) -> Explained {
        let nearby = self.nearby(planning, observer);
        let is_failed = matches!(planning.outcome(), PlanOutcome::NotFound(NotFound::Check { .. }));
        // No statement of the spec is to blame where the planner has a plan at another time, or found a trajectory that
        // fails the check, or where only the required risk is not met.
        let is_settled = planning.plan().is_some()
            || is_failed
            || nearby.times().next().is_some()
            || !planning.comparison.trade_off.is_empty();
        let conflict = if is_settled { None } else { self.conflict(observer) };
        Explained { nearby, conflict }
    }

    fn nearby(&self, planning: &Planning, observer: &dyn Observer) -> Nearby {
        let tries = |time: f64| {
            observer.begins(&format!("no plan was found; looking for times with one, near {time:.2} s"));
        };
        let begin = Instant::now();
        let (nearby, effort) = nearby::nearby(self.model(), self.mission, &planning.comparison, &tries);
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
        let found = timed(observer, "why", || explain::explain(self.model(), self.mission, &mut planner));
        observer.asked(Some(found.as_ref().map_or(0, |e| e.questions)), &planner.effort);
        found
    }
}

/// A mission is asked for where none is described.
pub fn no_mission(model: &Model) -> Option<Diagnostic> {
    let error =
        Diagnostic::error(NO_MISSION, model.vehicle.span, "this spec describes a vehicle but no mission to plan");
    let error = error.here("only a vehicle stands here");
    model.mission.is_none().then(|| error.help("add a `mission` block, or use `mavc analyze` for the vehicle alone"))
}

/// Every planner looks for its shortest time too, which takes many plans.
fn too_many_samples(model: &Model) -> Option<Diagnostic> {
    let samples = model.plan.samples;
    let most = MAX_SAMPLES_OF_A_SEARCH;
    let message = format!("{samples} samples are too many to compare planners: at most {most}");
    let error = Diagnostic::error("mavc::plan::samples", model.plan.samples_span, message);
    let help = format!("`mavc compare --set plan.samples={most}` leaves the file as it is");
    (samples > most).then(|| error.here("too many for every planner's shortest time").help(help))
}
