//! Planning as in sections 5.2 and 5.3 of the paper: waypoint times, rows, selection of facets, shortest times.
//!
//! A mission is planned by [`studies::run_planners`], which runs planners at times; a planner makes programs by
//! [`transcription`] and solves them.
//!
//! Two planners share one interface, [`Planner`]: [`hover::HoverPlanner`] for the linear model about hover, whose
//! programs are convex, and [`scp::ExactPlanner`] for the exact model, whose sequential convex programming finds local
//! optima.

pub mod branch;
pub mod comfort;
pub mod commands;
mod cores;
mod cost;
mod decision;
pub mod hover;
mod limits;
pub mod scp;
pub mod selection;
pub mod spline;
pub mod stop;
pub mod studies;
pub mod timing;
pub mod transcription;
pub mod trial;
mod upright;
pub mod working_set;
mod wrench_expression;
pub mod yaw;

pub use decision::{Decision, Planned};

use crate::admissible::AdmissibleSet;
use crate::model::{Model, PlanModel, Problem};
use crate::qp::RowOrigin;
use crate::solve::Effort;
use hover::HoverPlanner;
use scp::ExactPlanner;
use selection::PlanningSet;
use timing::search::{Hint, NoTime, Shortest};
use trial::OnTrial;
use working_set::WorkingSet;

/// A quick decision on a mission time; see [`Planner::attempt_at`].
#[derive(Debug)]
pub struct Attempt {
    pub decision: Decision,
    /// The weight of each row in the multipliers of the last program; after a proof, of those that prove it. Rows with
    /// a large weight limit the mission even if nothing is decided.
    pub weights: Vec<(RowOrigin, f64)>,
}

/// A planner of one mission in one model of the wrench.
pub trait Planner {
    /// Plans a mission time, s, against a set: a plan, a proof that there is none, or neither. `initial_guesses` are
    /// plans of any set, which the hover planner does not need; `working_set` holds rows that bound in earlier programs
    /// and is updated, which the exact planner does not need.
    fn plan_at(
        &mut self,
        time: f64,
        set: &PlanningSet,
        initial_guesses: &[&Planned],
        working_set: &mut WorkingSet,
    ) -> Decision;

    /// A quick decision on a mission time, s, for callers that need dozens: [`Self::plan_at`], or in the exact model
    /// fewer initial guesses and a cost phase that is short, or left out unless `minimised`.
    fn attempt_at(&mut self, time: f64, set: &PlanningSet, minimised: bool, working_set: &mut WorkingSet) -> Attempt;

    /// The shortest mission time for a set, with its plan.
    ///
    /// # Errors
    /// [`NoTime`], if each time tried is proved infeasible or no plan is found.
    fn shortest_time(
        &mut self,
        set: &PlanningSet,
        hint: Hint,
        working_set: &mut WorkingSet,
    ) -> Result<Shortest, NoTime>;

    /// A plan at the durations of another of the same set that a pilot would rather fly ([`comfort`]); `None` in the
    /// hover model, and where none was found. Where the spec gives the mission time, as `is_given` says, it also keeps
    /// the heights of its legs if such a plan is found.
    fn more_comfortable(&mut self, planned: &Planned, set: &PlanningSet, is_given: bool) -> Option<Planned>;

    /// What the solver has done so far.
    fn effort(&self) -> Effort;
}

/// The planner of the model that the spec plans with. `on_trial` receives each trial before it begins.
pub fn planner<'a>(problem: Problem<'a>, healthy: &'a AdmissibleSet, on_trial: OnTrial<'a>) -> Box<dyn Planner + 'a> {
    let hover = HoverPlanner { on_trial, ..HoverPlanner::new(problem, healthy) };
    match problem.model().plan.model {
        PlanModel::Hover => Box::new(hover),
        PlanModel::Exact => Box::new(ExactPlanner::new(hover)),
    }
}

/// Whether the planner of a model finds local optima. Then plans of other sets are worth trying as initial guesses,
/// another plan may be cheaper or shorter, and facets that one RIP plan selects need not be those of another.
pub fn finds_local_optima(model: &Model) -> bool {
    model.plan.model == PlanModel::Exact
}
