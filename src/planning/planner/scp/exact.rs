//! The planner of the exact model, which makes one [`ScpPlanner`] for each set.

use super::ScpSettings;
use crate::model::{Mission, Problem};
use crate::motion::wrench_model::WrenchModel;
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::ScpPlanner;
use crate::planner::scp::settings::GuidanceSettings;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::{Hint, NoTime, Shortest};
use crate::planner::transcription::UNBOUNDED;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Attempt, Decision, Planned, Planner};
use crate::solve::Effort;

/// Plans one mission in the exact model.
pub struct ExactPlanner<'a> {
    hover: HoverPlanner<'a>,
    pub settings: ScpSettings,
}

impl<'a> ExactPlanner<'a> {
    /// `hover` lays out time grids, counts the solver's effort and reports progress.
    pub fn new(hover: HoverPlanner<'a>) -> Self {
        ExactPlanner { hover, settings: ScpSettings::DEFAULT }
    }

    fn against<'e>(&'e mut self, set: &'e PlanningSet) -> ScpPlanner<'e, 'a> {
        ScpPlanner::with_settings(&mut self.hover, WrenchModel::Exact, set, self.settings)
    }
}

impl Planner for ExactPlanner<'_> {
    fn plan_at(&mut self, time: f64, set: &PlanningSet, guesses: &[&Planned], _: &mut WorkingSet) -> Decision {
        self.against(set).decide(time, guesses)
    }

    /// If nothing is decided, the rows that bind in the hover model are left in the weights.
    fn attempt_at(&mut self, time: f64, set: &PlanningSet, minimised: bool, working_set: &mut WorkingSet) -> Attempt {
        let problem = self.hover.problem;
        let guided_model = problem.with_mission(guided(problem.mission(), &self.settings.guidance));
        let guided_problem = Problem::of(&guided_model).unwrap_or(problem);
        let mut near =
            ExactPlanner { hover: HoverPlanner::new(guided_problem, self.hover.healthy), settings: self.settings };
        let mut decision = near.against(set).attempt(time, minimised);
        self.hover.effort += near.hover.effort;
        self.hover.weights = near.hover.weights;
        // A result with waypoints kept near is one for the mission itself only if it is a plan, or if there are no such
        // waypoints.
        if guided_problem.mission() != problem.mission() && !matches!(decision, Decision::Feasible(_)) {
            decision = self.against(set).attempt(time, minimised);
        }
        // For the weights that it leaves, in a model without air; its verdict is about another model.
        if matches!(decision, Decision::Inconclusive(_)) && !problem.model().environment().has_drag() {
            self.hover.decide(time, problem.model().plan.samples, set, working_set);
        }
        Attempt { decision, weights: std::mem::take(&mut self.hover.weights) }
    }

    fn shortest_time(&mut self, set: &PlanningSet, hint: Hint, _: &mut WorkingSet) -> Result<Shortest, NoTime> {
        let guesses: Vec<&Planned> = hint.planned.as_deref().into_iter().chain(&hint.initial_guesses).collect();
        self.against(set).shortest(&guesses, hint.larger)
    }

    fn more_comfortable(&mut self, planned: &Planned, set: &PlanningSet, is_given: bool) -> Option<Planned> {
        self.against(set).more_comfortable(planned, is_given)
    }

    fn effort(&self) -> Effort {
        self.hover.effort
    }
}

/// The mission with waypoints that require nothing kept near, within a wide tolerance. Without this, steps of the exact
/// model drift along directions that nothing bounds, such as the speed where one waypoint is left, and the solver does
/// not converge.
fn guided(mission: &Mission, settings: &GuidanceSettings) -> Mission {
    let mut guided = mission.clone();
    let apart = |i: usize| {
        let (a, b) = (mission.waypoints[0].position, mission.waypoints[i].position);
        (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
    };
    let length = (0..mission.waypoints.len()).map(apart).fold(0.0, f64::max);
    let within = (settings.min_distance + settings.lengths * length).min(0.9 * UNBOUNDED);
    let idle = guided.waypoints.iter_mut().filter(|w| w.within >= UNBOUNDED && w.weight == 0.0);
    idle.for_each(|w| (w.within, w.yaw_within, w.weight) = (within, settings.yaw, settings.weight));
    guided
}
