//! The planners, in either model, as an oracle.

use super::oracle::{Answer, Oracle, Part};
use crate::model::{LimitKind, Mission, Model, PlanModel, PlannerKind, Vehicle};
use crate::planner::pool::Pool;
use crate::planner::profile::profile;
use crate::planner::rows::{Decision, Engine, Planned};
use crate::planner::select::PlanningSet;
use crate::planner::sets::PlanningSets;
use crate::planner::successive::Successive;
use crate::planner::wrench_model::WrenchModel;
use crate::qp::RowOrigin;
use crate::solve::Effort;
use crate::trajectory::Trajectory;
use crate::trajectory::checks::{past, peak};

/// RIP, RCP and RSP at one mission time, each as `mavc plan` runs it there. A plan that passes a limit by far between its
/// nodes counts as none.
#[derive(Default)]
pub struct Planners<'p> {
    /// Those of the last question: most questions differ in the mission alone.
    sets: Option<Sets>,
    pub effort: Effort,
    /// Told each mission time before it is tried.
    on_progress: Option<&'p dyn Fn(f64)>,
}

impl<'p> Planners<'p> {
    pub fn new(on_progress: Option<&'p dyn Fn(f64)>) -> Self {
        Planners { on_progress, ..Planners::default() }
    }
}

/// What a planner imposes, and what it follows from.
struct Sets {
    vehicle: Vehicle,
    gravity: f64,
    against: Vec<usize>,
    reserve: f64,
    imposed: PlanningSets,
    /// Rows that bound in earlier plans, of RIP's and RCP's set.
    pools: [Pool; 2],
}

impl Sets {
    fn new(model: &Model) -> Self {
        Sets {
            vehicle: model.vehicle.clone(),
            gravity: model.gravity,
            against: model.plan.against.clone(),
            reserve: model.plan.reserve,
            imposed: PlanningSets::of(model),
            pools: Default::default(),
        }
    }

    fn are_of(&self, model: &Model) -> bool {
        let plan = &model.plan;
        (&self.vehicle, self.gravity, &self.against, self.reserve)
            == (&model.vehicle, model.gravity, &plan.against, plan.reserve)
    }
}

impl Oracle for Planners<'_> {
    fn ask(&mut self, model: &Model, mission: &Mission, time: f64) -> Answer {
        if let Some(tell) = &self.on_progress {
            tell(time);
        }
        let known = self.sets.take().filter(|sets| sets.are_of(model));
        let mut sets = known.unwrap_or_else(|| Sets::new(model));
        let [mut of_rip, mut of_joint] = std::mem::take(&mut sets.pools);
        let mut engine = Engine::new(model, mission, &sets.imposed.healthy);
        let mut decide = |set: &PlanningSet, pool: &mut Pool| {
            let decision = match model.plan.model {
                PlanModel::Hover => engine.decide(time, model.plan.samples, set, pool),
                PlanModel::Exact => Successive::new(&mut engine, WrenchModel::Exact, set).attempt(time),
            };
            let weights = std::mem::take(&mut engine.weights);
            (decision, weighed(set, weights, mission, time, model.plan.samples))
        };
        let (decision, parts) = match model.plan.planner {
            PlannerKind::Rip => decide(&sets.imposed.rip, &mut of_rip),
            PlannerKind::Rcp => decide(&sets.imposed.joint, &mut of_joint),
            PlannerKind::Rsp => match decide(&sets.imposed.rip, &mut of_rip) {
                (Decision::Feasible(planned), parts) => match sets.imposed.violated(model, &planned) {
                    none if none.is_empty() => (Decision::Feasible(planned), parts),
                    facets => decide(&sets.imposed.rip.with(facets), &mut of_rip.clone()),
                },
                other => other,
            },
        };
        self.effort += engine.effort;
        sets.pools = [of_rip, of_joint];
        self.sets = Some(sets);
        match decision {
            Decision::Feasible(planned) if passes_a_limit(&planned, mission, model.gravity) => Answer::NotFound,
            Decision::Feasible(_) => Answer::Feasible,
            Decision::Infeasible => Answer::Infeasible(parts),
            Decision::Inconclusive(_) => Answer::NotFound,
        }
    }
}

/// Limits hold at the nodes. A plan that passes one by more than this share of it between them (of 1 m or 1 rad where it
/// bounds a coordinate) only shows that the grid is too coarse at this mission time.
const COARSE: f64 = 0.05;

/// Whether a plan passes some limit by more than [`COARSE`].
fn passes_a_limit(planned: &Planned, mission: &Mission, gravity: f64) -> bool {
    let trajectory = Trajectory::of(planned);
    mission.limits.iter().any(|limit| {
        let bound = limit.lower.into_iter().chain(limit.upper).map(f64::abs).fold(0.0, f64::max);
        let scale = match limit.kind {
            LimitKind::X | LimitKind::Y | LimitKind::Z | LimitKind::Yaw => 1.0,
            _ => bound.max(COARSE),
        };
        peak(&trajectory, |state| past(limit, state, gravity)).value > COARSE * scale
    })
}

/// What rows weigh, by what they stand for. A facet that several modes share weighs for each of them.
fn weighed(
    set: &PlanningSet,
    weights: Vec<(RowOrigin, f64)>,
    mission: &Mission,
    time: f64,
    samples: usize,
) -> Vec<(Part, f64)> {
    let last = profile(mission, time, samples).map(|p| p.flown().nodes() - 1);
    let mut parts = Vec::new();
    for (origin, weight) in weights {
        match origin {
            RowOrigin::Waypoint { waypoint } | RowOrigin::WaypointYaw { waypoint } => {
                parts.push((Part::Waypoint(waypoint), weight));
            }
            RowOrigin::Limit { limit, .. } => parts.push((Part::Limit(limit), weight)),
            RowOrigin::Rest { node: 0, .. } => parts.push((Part::RestAtStart, weight)),
            RowOrigin::Rest { node, .. } if Some(node) == last => parts.push((Part::RestAtEnd, weight)),
            RowOrigin::Facet { facet, .. } | RowOrigin::Lag { facet, .. } => {
                // Mode 0 is the healthy vehicle, which no statement could leave out.
                let modes = set.rows[facet].origin.iter().filter_map(|of| of.mode.checked_sub(1));
                parts.extend(modes.map(|mode| (Part::Mode(mode), weight)));
            }
            _ => {}
        }
    }
    parts
}
