//! The yaw of the hover model, planned first if it changes: minimises the terms of (48) in psi within the yaw
//! tolerances.

use crate::model::{Model, Problem};
use crate::motion::hover_map::{WrenchMap, YawState};
use crate::motion::time_grid::TimeGrid;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Purpose, Transcription};
use crate::solve::{Effort, Outcome, solve};

/// How yaw enters the plan of x, y and z.
#[derive(Debug, Clone, PartialEq)]
pub enum YawPlan {
    /// All waypoints have one yaw: psi is a variable like the others, and the wrench map is linearised there. rad.
    Free { psi: f64 },
    /// psi, psi', psi'' at every node, fixed before x, y and z are planned.
    Frozen(Vec<YawState>),
}

const ALL_AXES: [usize; 4] = [X, Y, Z, YAW];

impl YawPlan {
    /// The wrench map at every node.
    pub fn maps(&self, model: &Model, nodes: usize) -> Vec<WrenchMap> {
        match self {
            YawPlan::Free { psi } => {
                vec![WrenchMap::with_free_yaw(&model.vehicle, model.gravity, *psi); nodes]
            }
            YawPlan::Frozen(states) => {
                states.iter().map(|&s| WrenchMap::new(&model.vehicle, model.gravity, s)).collect()
            }
        }
    }

    /// The wrench model of the plan.
    pub fn model(&self) -> WrenchModel {
        match self {
            YawPlan::Free { psi } => WrenchModel::HoverAt(*psi),
            YawPlan::Frozen(_) => WrenchModel::HoverFollowing,
        }
    }

    /// The axes left to plan.
    pub fn axes(&self) -> &'static [usize] {
        match self {
            YawPlan::Free { .. } => &ALL_AXES,
            YawPlan::Frozen(_) => &ALL_AXES[..3],
        }
    }

    /// Writes the frozen yaw into planned states.
    pub fn fill(&self, states: &mut [NodeState]) {
        if let YawPlan::Frozen(yaw) = self {
            for (state, y) in states.iter_mut().zip(yaw) {
                state[YAW] = [y.psi, y.rate, y.acceleration, 0.0, 0.0];
            }
        }
    }
}

/// Plans yaw on one time grid.
///
/// # Errors
/// The solver's outcome, if it is not a solution.
pub fn plan_yaw(problem: Problem, grid: &TimeGrid, effort: &mut Effort) -> Result<YawPlan, Outcome> {
    let mission = problem.mission();
    if mission.has_one_yaw() {
        return Ok(YawPlan::Free { psi: mission.waypoints[0].yaw });
    }
    let nothing = PlanningSet::default();
    let transcription = Transcription::new(problem, grid, &nothing, &[], &ALL_AXES[3..]);
    let (outcome, spent) = solve(&transcription.full_program(Purpose::Plan { slack: 0.0 }));
    *effort += spent;
    let Outcome::Solved(solution) = outcome else { return Err(outcome) };
    let states = transcription.states(&solution.x);
    Ok(YawPlan::Frozen(
        states.iter().map(|s| YawState { psi: s[YAW][0], rate: s[YAW][1], acceleration: s[YAW][2] }).collect(),
    ))
}
