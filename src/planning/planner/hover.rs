//! The hover planner: one convex program at one mission time, with row generation.
//!
//! Few rows ever bind. A program that lacks rows is a relaxation: if it is infeasible, so is the full one; if its
//! solution violates no row, it solves the full one.

mod layout;
mod reach;
mod row_generation;
pub mod settings;

pub use super::decision::{Decision, Planned};
pub use layout::Layout;
pub(super) use reach::LEEWAY;
pub use settings::HoverSettings;

use crate::actuation::Wrench;
use crate::admissible::AdmissibleSet;
use crate::model::{Mission, Model, Problem};
use crate::motion::NodeState;
use crate::motion::time_grid::time_grid;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::branch::Branch;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::kinematics::least_time_within;
use crate::planner::timing::search::{Hint, NoTime, Shortest};
use crate::planner::transcription::Purpose;
use crate::planner::trial::{OnTrial, Trial};
use crate::planner::working_set::WorkingSet;
use crate::planner::yaw::plan_yaw;
use crate::planner::{self, Planner};
use crate::qp::RowOrigin;
use crate::solve::{Effort, Outcome, Solution};

/// A plan counts as feasible if no waypoint's tolerance is exceeded by more than this, m (yaw in proportion).
pub const FEASIBLE: f64 = 1e-6;

/// Rows are added until no other is violated by more than this, in widths of the healthy set or shares of a limit.
/// (Those of the program itself hold to the solver's tolerance.)
pub const ACCEPTED: f64 = 1e-7;

/// Why a program without a solution proves nothing.
const UNEVEN: &str = "the rows of cores with different moments of inertia about x and y are stricter in the program";

/// Plans one mission in the hover model, and counts the solver's effort.
pub struct HoverPlanner<'a> {
    pub problem: Problem<'a>,
    pub healthy: &'a AdmissibleSet,
    pub effort: Effort,
    /// After [`Decision::Infeasible`]: the weight of each row in the multipliers that prove it
    /// ([`crate::qp::QuadraticProgram::weights`]). Empty if reach, fixed times or the yaw planned first prove it.
    pub weights: Vec<(RowOrigin, f64)>,
    /// If the mission is a branch after a fault: where it begins and ends. See [`crate::planner::branch`].
    pub branch: Option<Branch>,
    pub on_trial: OnTrial<'a>,
    /// The last trial.
    pub trial: Trial,
    pub settings: HoverSettings,
}

/// The smallest violation at one mission time, as a share; see [`Purpose::Violation`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// Positive: rows and limits would have to be wider by this share. Negative: all have this much slack.
    pub sigma: f64,
    /// sigma was not minimised below this.
    pub least: f64,
}

impl Planner for HoverPlanner<'_> {
    fn plan_at(&mut self, time: f64, set: &PlanningSet, _: &[&Planned], working_set: &mut WorkingSet) -> Decision {
        self.begins_trial(time);
        self.decide(time, self.model().plan.samples, set, working_set)
    }

    fn attempt_at(&mut self, time: f64, set: &PlanningSet, _: bool, working_set: &mut WorkingSet) -> planner::Attempt {
        let decision = self.plan_at(time, set, &[], working_set);
        planner::Attempt { decision, weights: std::mem::take(&mut self.weights) }
    }

    fn shortest_time(
        &mut self,
        set: &PlanningSet,
        hint: Hint,
        working_set: &mut WorkingSet,
    ) -> Result<Shortest, NoTime> {
        self.shortest(set, hint, working_set)
    }

    fn more_comfortable(&mut self, _: &Planned, _: &PlanningSet, _: bool) -> Option<Planned> {
        None
    }

    fn effort(&self) -> Effort {
        self.effort
    }
}

impl<'a> HoverPlanner<'a> {
    /// `healthy` is the whole healthy set of the model, whose widths make rows dimensionless.
    pub fn new(problem: Problem<'a>, healthy: &'a AdmissibleSet) -> Self {
        HoverPlanner {
            problem,
            healthy,
            effort: Effort::default(),
            weights: Vec::new(),
            branch: None,
            on_trial: None,
            trial: Trial::default(),
            settings: HoverSettings::DEFAULT,
        }
    }

    pub fn model(&self) -> &'a Model {
        self.problem.model()
    }

    pub fn mission(&self) -> &'a Mission {
        self.problem.mission()
    }

    /// Reports that a mission time, s, is tried.
    pub(super) fn begins_trial(&mut self, time: f64) {
        self.trial.time = time;
        if let Some(report) = self.on_trial {
            report(self.trial);
        }
    }

    /// Intervals of the coarse grid: by legs and holds, with a minimum ([`HoverSettings`]), never more than the plan's.
    pub(super) fn coarse_samples(&self) -> usize {
        let segments = self.mission().legs.len() + self.mission().waypoints.iter().filter(|w| w.hold > 0.0).count();
        (self.settings.coarse_intervals_per_leg * segments)
            .max(self.settings.min_coarse_intervals)
            .min(self.model().plan.samples)
    }

    /// The mission laid out over `total` s with `samples` intervals; `Ok(None)` if the fixed times leave a leg no time.
    ///
    /// # Errors
    /// The outcome of the yaw program, if yaw is planned first and has no solution.
    pub fn layout(&mut self, total: f64, samples: usize) -> Result<Option<Layout>, Outcome> {
        let Some(grid) = time_grid(self.mission(), total, samples) else { return Ok(None) };
        let flown = grid.flown();
        let yaw = plan_yaw(self.problem, &flown, &mut self.effort)?;
        Ok(Some(Layout { grid, flown, yaw }))
    }

    /// Whether fixed times, yaw waypoints or reach already rule out every plan, for any choice of yaw.
    pub(super) fn is_hopeless(&mut self, total: f64) -> bool {
        match self.layout(total, self.model().plan.samples) {
            Ok(Some(layout)) => self.out_of_reach(&layout),
            Ok(None) | Err(Outcome::Infeasible { .. }) => true,
            Err(_) => false,
        }
    }

    /// Whether the bound on the mission's time rules out a time for every division among the legs. Rows hold at nodes
    /// only, so that a motion below it could pass between them.
    pub(super) fn is_too_short(&self, total: f64) -> bool {
        least_time_within(self.problem).is_above(total)
    }

    /// Decides one mission time: plans it, or shows that no plan meets every waypoint within its tolerance plus
    /// [`FEASIBLE`].
    pub fn decide(&mut self, total: f64, samples: usize, set: &PlanningSet, working_set: &mut WorkingSet) -> Decision {
        self.decide_with(total, samples, set, working_set, false)
    }

    /// The decision on the coarse grid, where a verdict is only a hint: without the second program of
    /// [`Self::decide_by_overshoot`].
    pub(super) fn decide_roughly(&mut self, total: f64, set: &PlanningSet, working_set: &mut WorkingSet) -> Decision {
        self.decide_with(total, self.coarse_samples(), set, working_set, true)
    }

    fn decide_with(
        &mut self,
        total: f64,
        samples: usize,
        set: &PlanningSet,
        working_set: &mut WorkingSet,
        quickly: bool,
    ) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        self.weights.clear();
        let layout = match self.layout(total, samples) {
            Ok(Some(layout)) => layout,
            Ok(None) | Err(Outcome::Infeasible { .. }) => return Decision::Infeasible,
            Err(Outcome::Inconclusive { status, .. }) => return Decision::Inconclusive(status),
            Err(Outcome::Solved(_)) => return Decision::Inconclusive("yaw".into()),
        };
        if self.out_of_reach(&layout) {
            return Decision::Infeasible;
        }
        let before = working_set.clone();
        let attempt = self.generate(&layout, set, Purpose::Plan { slack: FEASIBLE }, working_set);
        if let Outcome::Solved(_) = &attempt.outcome {
            self.drop_slack_rows(&layout, set, &attempt.states, 0.0, working_set);
        } else {
            *working_set = before;
        }
        match attempt.outcome {
            Outcome::Solved(solution) => Decision::Feasible(Box::new(Planned {
                states: layout.grid.with_holds(&attempt.states),
                model: layout.yaw.model(),
                grid: layout.grid,
                // A sum of squares, to the solver's digits.
                objective: solution.objective.max(0.0),
                rows: attempt.rows,
            })),
            // Cones of uneven cores are stricter than their rows (101).
            Outcome::Infeasible { .. } if set.has_uneven_cores() => Decision::Inconclusive(UNEVEN.into()),
            Outcome::Infeasible { .. } => Decision::Infeasible,
            Outcome::Inconclusive { status, .. } if quickly => Decision::Inconclusive(status),
            Outcome::Inconclusive { status, .. } => self.decide_by_overshoot(&layout, set, working_set, status),
        }
    }

    /// The smallest violation at a mission time, to within `tolerance`. It grows smoothly as the time decreases, while
    /// a verdict is only yes or no; it guides the search and proves nothing. `None` if waypoints, rest and positions
    /// alone cannot be met.
    pub(super) fn violation(
        &mut self,
        total: f64,
        samples: usize,
        set: &PlanningSet,
        working_set: &mut WorkingSet,
        tolerance: f64,
    ) -> Option<Violation> {
        self.begins_trial(total);
        let layout = self.layout(total, samples).ok()??;
        let hover = self.hover_margin(set);
        let epsilon = self.settings.cost_share_of_violation / self.cost_scale(&layout);
        let purpose = Purpose::Violation { epsilon, least: -0.5 * hover };
        let before = working_set.clone();
        let attempt = self.generate_within(&layout, set, purpose, working_set, tolerance);
        let (Outcome::Solved(Solution { x, .. }) | Outcome::Inconclusive { point: Some(x), .. }) = &attempt.outcome
        else {
            *working_set = before;
            return None;
        };
        let sigma = *x.last()?;
        self.drop_slack_rows(&layout, set, &attempt.states, sigma.min(0.0), working_set);
        Some(Violation { sigma, least: -0.5 * hover })
    }

    /// The smallest slack of hover in a set, in widths of the healthy set.
    pub(super) fn hover_margin(&self, set: &PlanningSet) -> f64 {
        let inside = set.rows.iter().filter(|r| !r.equality).map(|r| -r.violation(&self.healthy.hover));
        inside.fold(f64::INFINITY, f64::min)
    }

    /// Whether a plan flown `factor` times slower still keeps every row and limit, so that the longer mission time
    /// needs no program. Always false for missions with fixed times, holds or changing yaw.
    pub(super) fn is_plan_when_slowed(&self, planned: &Planned, set: &PlanningSet, factor: f64) -> bool {
        let WrenchModel::HoverAt(_) = planned.model else { return false };
        let own_times = self.mission().waypoints.iter().any(|w| w.hold > 0.0 || w.time.is_some());
        let least_rates =
            self.mission().limits.iter().any(|l| !l.kind.is_of_place() && l.lower.is_some_and(|b| b > 0.0));
        // Parts of a core's rows of different order may cancel.
        if own_times || least_rates || set.has_cores() {
            return false;
        }
        let slow = |state: &NodeState| -> NodeState {
            state.map(|axis| std::array::from_fn(|order| axis[order] * factor.powi(-(order as i32))))
        };
        let wrench = |state| planned.model.wrench(&self.model().vehicle, &self.model().environment(), &slow(state));
        let wrenches: Vec<Wrench> = planned.states.iter().map(wrench).collect();
        let keeps = |w: &Wrench| set.rows.iter().all(|row| row.violation(w) <= ACCEPTED);
        // The wrench is linear over an interval here, so w' is the same at both its ends.
        let commands = |tau: f64| {
            wrenches.windows(2).zip(planned.grid.steps()).all(|(w, step)| {
                let ahead = (w[1] - w[0]) * (tau / (factor * step));
                keeps(&(w[0] + ahead)) && keeps(&(w[1] + ahead))
            })
        };
        wrenches.iter().all(keeps) && self.model().thrust_lag().is_none_or(commands)
    }

    /// If the plan's program has no verdict: minimises sigma + epsilon J, which always has a solution. With J at most
    /// J_max on feasible plans, a lower bound above FEASIBLE + epsilon J_max proves that there is none.
    fn decide_by_overshoot(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        working_set: &WorkingSet,
        status: String,
    ) -> Decision {
        let Some(most) = self.largest_cost(layout) else { return Decision::Inconclusive(status) };
        let share = self.settings.cost_share_of_overshoot;
        let epsilon = share / most;
        let attempt = self.generate(layout, set, Purpose::Overshoot { epsilon }, &mut working_set.clone());
        match attempt.outcome {
            _ if set.has_uneven_cores() => Decision::Inconclusive(UNEVEN.into()),
            Outcome::Solved(solution) if solution.bound > FEASIBLE + share => Decision::Infeasible,
            Outcome::Infeasible { .. } => Decision::Infeasible,
            _ => Decision::Inconclusive(status),
        }
    }
}
