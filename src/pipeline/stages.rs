//! The convex program behind a plan, with all of its rows.

use super::tasks::{Planning, Task};
use crate::admissible::AdmissibleSet;
use crate::planner::hover::{FEASIBLE, HoverPlanner};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::{NotFound, PlanOutcome, Proof};
use crate::planner::transcription::{Purpose, Transcription};
use crate::qp::QuadraticProgram;
use serde::Serialize;

/// A convex program as exported: minimise 1/2 x'P x + q'x + constant subject to A x + s = b, s in the cones.
#[derive(Debug, Serialize)]
pub struct Program {
    schema: u32,
    pub time_s: f64,
    #[serde(flatten)]
    pub program: QuadraticProgram,
}

impl Planning {
    /// What was imposed on the wrench at each node.
    pub fn set(&self) -> &PlanningSet {
        &self.run().set
    }

    /// The mission time of the plan, or of the proof or search that ended without one, s.
    pub fn time(&self) -> f64 {
        match self.outcome() {
            PlanOutcome::Planned(plan) => plan.time,
            PlanOutcome::Infeasible(Proof { at, .. })
            | PlanOutcome::NotFound(NotFound::Search { at, .. } | NotFound::Check { at, .. })
            | PlanOutcome::NotAttempted { at, .. } => *at,
        }
    }
}

impl Task<'_> {
    /// The program of the hover model, with every row, at the mission time of an outcome. `None` where the mission cannot be
    /// laid out over that time.
    pub fn program(&self, planning: &Planning) -> Option<Program> {
        let (model, mission, time_s) = (self.model(), self.mission(), planning.time());
        let healthy = AdmissibleSet::healthy(model);
        let mut planner = HoverPlanner::new(model, mission, &healthy);
        let layout = planner.layout(time_s, model.plan.samples).ok()??;
        let maps = layout.yaw.maps(model, layout.flown.nodes());
        let commands = layout.commands(model);
        let transcription = Transcription::new(model, mission, &layout.flown, planning.set(), &maps, layout.yaw.axes());
        let program = transcription.with_commands(commands.as_ref()).full_program(Purpose::Plan { slack: FEASIBLE });
        Some(Program { schema: 1, time_s, program })
    }
}
