//! The outputs of single stages: sets, the actuation matrix, and the convex program of a plan with all of its rows.

use super::planned::Planning;
use super::tasks::Task;
use crate::actuation::Actuation;
use crate::admissible::AdmissibleSet;
use crate::exchange::vehicle::mjcf;
use crate::exchange::vehicle::px4_params;
use crate::planner::hover::{FEASIBLE, HoverPlanner};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::{NotFound, PlanOutcome, Proof};
use crate::planner::transcription::{Purpose, Transcription};
use crate::qp::QuadraticProgram;
use crate::report::model_record::ModelRecord;
use crate::spec::Spec;
use serde::Serialize;
use std::error::Error;
use std::fmt;

/// A convex program as exported: minimise 1/2 x'P x + q'x + constant subject to A x + s = b, s in the product of the
/// cones. Variables are scaled derivatives of x, y, z and yaw at the nodes.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Program {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = 1)))]
    schema: u32,
    /// Mission time for which the program is laid out, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: f64,
    #[serde(flatten)]
    pub program: QuadraticProgram,
}

/// The program has more than 1,200,000 rows and is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotPrinted {
    /// Number of rows.
    pub rows: usize,
    /// Number of samples with which it would have few enough, if that is enough for the mission.
    pub samples: Option<usize>,
}

/// Rows of the largest program that is printed. A million rows take 320 MB.
const MOST_ROWS: usize = 1_200_000;

impl NotPrinted {
    /// Its code (`docs/diagnostics`).
    pub const CODE: &str = "mavc::emit::rows";
}

impl fmt::Display for NotPrinted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (code, rows) = (Self::CODE, self.rows);
        writeln!(f, "error[{code}]: this program has {rows} rows; at most {MOST_ROWS} are printed")?;
        match self.samples {
            Some(samples) => writeln!(f, "  help: use fewer samples, for example `--set plan.samples={samples}`"),
            None => writeln!(f, "  help: state fewer volumes or fault modes"),
        }
    }
}

impl Error for NotPrinted {}

impl Program {
    /// The program for people: `mavc emit qp`.
    pub fn to_text(&self) -> String {
        format!("mission time {} s\n{}", self.time_s, self.program)
    }
}

/// The actuation matrix A, from rotor thrusts (N) to wrench (N, N m): `mavc emit actuation`.
pub fn actuation_text(spec: &Spec) -> String {
    Actuation::of(&spec.model().vehicle).to_string()
}

/// The vehicle, its fault modes and how it is flown, with all digits: `mavc emit model --format json`.
pub fn model_record(spec: &Spec) -> ModelRecord<'_> {
    ModelRecord::new(spec.model())
}

/// The rotors as parameters of PX4's control allocation: `mavc emit px4-params`.
pub fn px4_params_text(spec: &Spec) -> String {
    px4_params::text(&spec.model().vehicle)
}

/// The vehicle and its mission as a model of MuJoCo (XML): `mavc emit mjcf`.
pub fn mjcf_text(spec: &Spec) -> String {
    mjcf::text(spec.model())
}

/// The admissible set of the healthy vehicle and of every declared mode: `mavc emit sets`.
pub fn sets_text(spec: &Spec) -> String {
    let sets: Vec<String> = AdmissibleSet::each(spec.model()).map(|set| set.to_string()).collect();
    sets.join("\n")
}

impl Planning {
    /// The rows that were imposed on the wrench at each node.
    pub fn set(&self) -> &PlanningSet {
        &self.run().set
    }

    /// The mission time of the plan, of the proof, or of the search that ended without one, s.
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
    /// The program of the hover model, with every row, at the mission time of an outcome. `None` if the mission has no
    /// time grid over that time.
    ///
    /// # Errors
    /// [`NotPrinted`]
    pub fn program(&self, planning: &Planning) -> Result<Option<Program>, NotPrinted> {
        let (problem, model, time_s) = (self.problem(), self.model(), planning.time());
        let healthy = AdmissibleSet::healthy(model);
        let mut planner = HoverPlanner::new(problem, &healthy);
        let Some(layout) = planner.layout(time_s, model.plan.samples).ok().flatten() else { return Ok(None) };
        let maps = layout.yaw.maps(model, layout.flown.nodes());
        let commands = layout.commands(model);
        let transcription = Transcription::new(problem, &layout.flown, planning.set(), &maps, layout.yaw.axes());
        let transcription = transcription.with_commands(commands.as_ref());
        let rows = transcription.each_row().count();
        if rows > MOST_ROWS {
            // Rows grow with samples; each leg needs some of them.
            let samples = model.plan.samples * MOST_ROWS / rows;
            let is_enough = samples > 2 * problem.mission().waypoints.len();
            return Err(NotPrinted { rows, samples: is_enough.then_some(samples) });
        }
        let program = transcription.full_program(Purpose::Plan { slack: FEASIBLE });
        Ok(Some(Program { schema: 1, time_s, program }))
    }
}
