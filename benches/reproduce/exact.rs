//! What changes in the exact model: the wrench that the hover plans require of a real vehicle, and the shortest times.

use super::case_plans::seconds;
use super::markdown::{fixed, paragraph, table};
use super::plans::{self, JOINTLY, Plans, name};
use super::specs;
use mavc::admissible::row::{SetRow, VIOLATED};
use mavc::model::{Model, PlannerKind};
use mavc::motion::Z;
use mavc::motion::checks::linear_range;
use mavc::motion::wrench_model::WrenchModel;
use mavc::planner::studies::{MissionPlan, PlannerRun, Run};
use mavc::tolerance::UPRIGHT;
use mavc::{Planning, Spec};

/// Heads the part that takes long to compute; it ends the page.
pub const SHORTEST: &str = "### Shortest times in both models\n\n";

/// The planners of the cases at their own shortest times; RIP does not depend on modes and is the same in all three.
pub const PLANNERS: [(usize, &str, PlannerKind); 4] = [
    (1, "RIP", PlannerKind::Rip),
    (1, "RCP M1", PlannerKind::Rcp),
    (2, "RCP M1_6", PlannerKind::Rcp),
    (3, JOINTLY, PlannerKind::Rcp),
];

/// The part of a page under [`SHORTEST`].
pub fn written(page: &str) -> &str {
    page.split_once(SHORTEST).unwrap_or_else(|| panic!("the page has {SHORTEST:?}")).1
}

/// The section; `shortest` gives the part under [`SHORTEST`].
pub fn section(shortest: impl FnOnce() -> String) -> String {
    [hover_plans(), SHORTEST.into(), shortest()].concat()
}

/// A motion's exact wrench against the rows that its plan keeps in the hover model.
pub struct Exactly {
    /// The largest violation while upright, in widths of the healthy set.
    pub worst: f64,
    /// Seconds outside.
    pub outside: f64,
    /// Seconds not upright: there a vanishing thrust would have to turn the vehicle over, and the wrench may not be
    /// finite.
    falling: f64,
}

/// Points of each interval at which the exact wrench is evaluated: the midpoints of this many parts.
const POINTS: usize = 64;

/// Evaluates a plan of the hover model against the rows that it keeps in its own model.
pub fn exactly(solved: &MissionPlan, model: &Model, rows: &[SetRow]) -> Exactly {
    let mut found = Exactly { worst: f64::NEG_INFINITY, outside: 0.0, falling: 0.0 };
    let trajectory = &solved.trajectory;
    for k in 0..trajectory.intervals() {
        let part = (trajectory.times[k + 1] - trajectory.times[k]) / POINTS as f64;
        for p in 0..POINTS {
            let state = trajectory.within(k, part * (p as f64 + 0.5));
            let wrench = WrenchModel::Exact.wrench(&model.vehicle, &model.environment(), &state);
            let most = rows.iter().map(|row| row.violation(&wrench)).fold(f64::NEG_INFINITY, f64::max);
            let finite = wrench.iter().all(|w| w.is_finite());
            if !finite || most > VIOLATED {
                found.outside += part;
            }
            if state[Z][2] + model.gravity < UPRIGHT * model.gravity {
                found.falling += part;
            } else {
                found.worst = found.worst.max(most);
            }
        }
    }
    found
}

/// The largest tilt of a plan.
pub fn degrees(solved: &MissionPlan, model: &Model) -> String {
    fixed(linear_range(&solved.trajectory, model).tilt.value.to_degrees(), 0)
}

fn hover_plans() -> String {
    let row = |number: usize, plans: &Plans, run: &PlannerRun, solved: &MissionPlan| {
        let found = exactly(solved, &plans.model, &run.set.rows);
        vec![
            number.to_string(),
            name(run),
            seconds(solved.time),
            degrees(solved, &plans.model),
            format!("{} %", fixed(100.0 * found.worst, 0)),
            seconds(found.outside),
            format!("{} %", fixed(100.0 * found.outside / solved.time, 0)),
            seconds(found.falling),
        ]
    };
    let mut rows = Vec::new();
    for number in 1..=3 {
        let plans = plans::of_case(number);
        for run in plans.runs(Run::Own) {
            let listed = PLANNERS.iter().any(|(case, planner, _)| *case == number && *planner == name(run));
            if let (true, Some(solved)) = (listed || run.planner == PlannerKind::Rsp, plans::solved(run)) {
                rows.push(row(number, plans, run, solved));
            }
        }
    }
    let header = ["case", "planner", "T", "tilt, degrees", "worst", "outside", "share of the flight", "not upright"];
    [
        paragraph(
            "The plans above keep every row of their sets in the model that is linear about hover. The wrench that \
             (3) to (9) require along the same motions is different (docs/method/exact-model.md). *Outside* is the \
             time for which it violates the set that the plan was made against. *Not upright* is the time in which \
             the vertical part of the thrust is below a tenth of the weight, down to values that no attitude gives; \
             *worst* is the largest violation in the rest of the flight, as a share of the healthy set's width. \
             Jumps of z''' at the nodes, which would require an impulse of torque, are not counted.",
        ),
        table(&header, &rows),
    ]
    .concat()
}

/// A case to be planned in the exact model by one planner alone, at a time (s) or at its shortest.
pub fn exact_case(number: usize, planner: PlannerKind, time: Option<f64>) -> Spec {
    let time = time.map_or("minimum".into(), |time| format!("{time} s"));
    let settings = ["plan.model=exact".into(), format!("plan.planner={}", planner.name()), format!("plan.time={time}")];
    let with = |spec: Spec, setting: String| spec.set(&setting).unwrap_or_else(|error| panic!("{error}"));
    settings.into_iter().fold(specs::case(number), with)
}

/// The plan of the spec's own planner, if there is one.
pub fn plan(spec: &Spec) -> Option<Planning> {
    let planning = mavc::plan(spec).unwrap_or_else(|refusal| panic!("{refusal}"));
    planning.plan().is_some().then_some(planning)
}
