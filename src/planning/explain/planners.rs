//! The planners, in both models, as an oracle.

use super::oracle::{Answer, Oracle, Part};
use crate::certify;
use crate::model::{Environment, Mission, Model, PlannerKind, Problem, Vehicle};
use crate::motion::checks::{peak_of, violation};
use crate::motion::time_grid::time_grid;
use crate::planner::scp::NOT_FOUND;
use crate::planner::selection::PlanningSet;
use crate::planner::selection::sets::PlanningSets;
use crate::planner::studies::{THESE_TIMES, proofs_are_about};
use crate::planner::timing::kinematics::least_time_within;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Attempt, Decision, Planned, finds_local_optima, planner};
use crate::qp::RowOrigin;
use crate::solve::Effort;

/// RIP, RCP and RSP at one mission time, each as `mavc plan` runs it there. A plan that exceeds a limit by far between
/// its nodes does not count as a plan.
#[derive(Default)]
pub struct Planners<'p> {
    /// Sets of the last query: most queries differ only in the mission.
    sets: Option<Sets>,
    /// Work of all queries.
    pub effort: Effort,
    /// Called with each mission time before it is tried.
    on_progress: Option<&'p dyn Fn(f64)>,
}

impl<'p> Planners<'p> {
    /// `on_progress` is called with each mission time (s) before it is tried.
    pub fn new(on_progress: Option<&'p dyn Fn(f64)>) -> Self {
        Planners { on_progress, ..Planners::default() }
    }
}

/// The sets that planners impose, and the data from which they follow.
struct Sets {
    vehicle: Vehicle,
    environment: Environment,
    against: Vec<usize>,
    reserve: f64,
    imposed: PlanningSets,
    /// Rows that were active in earlier plans, of RIP's and RCP's set.
    working_sets: [WorkingSet; 2],
}

impl Sets {
    fn new(model: &Model) -> Self {
        Sets {
            vehicle: model.vehicle.clone(),
            environment: model.environment(),
            against: model.plan.against.clone(),
            reserve: model.plan.reserve,
            imposed: PlanningSets::of(model),
            working_sets: Default::default(),
        }
    }

    fn are_of(&self, model: &Model) -> bool {
        let plan = &model.plan;
        (&self.vehicle, &self.environment, &self.against, self.reserve)
            == (&model.vehicle, &model.environment(), &plan.against, plan.reserve)
    }
}

impl Oracle for Planners<'_> {
    fn work(&self) -> u64 {
        self.effort.work
    }

    fn ask(&mut self, problem: Problem, time: f64) -> Answer {
        let (model, mission) = (problem.model(), problem.mission());
        if let Some(on_progress) = &self.on_progress {
            on_progress(time);
        }
        // This bound holds for every division of the time, every grid and every planner.
        if model.plan.chooses_times && least_time_within(problem).is_above(time) {
            return Answer::Infeasible { weights: Vec::new(), only_for_selection: false, only_for_samples: false };
        }
        let known = self.sets.take().filter(|sets| sets.are_of(model));
        let mut sets = known.unwrap_or_else(|| Sets::new(model));
        let [mut of_rip, mut of_joint] = std::mem::take(&mut sets.working_sets);
        let mut planner = planner(problem, &sets.imposed.healthy, None);
        let mut decide = |set: &PlanningSet, working_set: &mut WorkingSet, minimise: bool| {
            let Attempt { decision, weights } = planner.attempt_at(time, set, minimise, working_set);
            let decision = match proofs_are_about(problem) {
                // Without weights, the proof is about the yaw waypoints alone, or does not involve yaw.
                Some(about) if about == THESE_TIMES || !weights.is_empty() => not_for_all(decision),
                _ => decision,
            };
            (decision, weighed(set, weights, problem, time))
        };
        let (mut only_for_selection, mut selected_by) = (false, Vec::new());
        let (decision, parts) = match model.plan.planner {
            PlannerKind::Rip => decide(&sets.imposed.rip, &mut of_rip, false),
            PlannerKind::Rcp => decide(&sets.imposed.joint, &mut of_joint, false),
            // Without rounds nothing is selected.
            PlannerKind::Rsp if model.plan.rounds == 0 => decide(&sets.imposed.rip, &mut of_rip, false),
            PlannerKind::Rsp => match decide(&sets.imposed.rip, &mut of_rip, true) {
                (Decision::Feasible(planned), parts) => match sets.imposed.violated(model, &planned) {
                    none if none.is_empty() => {
                        selected_by.push(planned.trajectory());
                        (Decision::Feasible(planned), parts)
                    }
                    facets => {
                        only_for_selection = true;
                        selected_by.push(planned.trajectory());
                        let (decision, parts) = decide(&sets.imposed.rip.with(facets), &mut of_rip.clone(), false);
                        (about_all_selections(decision, model), parts)
                    }
                },
                other => other,
            },
        };
        self.effort += planner.effort();
        drop(planner);
        sets.working_sets = [of_rip, of_joint];
        self.sets = Some(sets);
        match decision {
            Decision::Feasible(planned) if exceeds_a_limit(&planned, mission, &model.environment()) => {
                Answer::NotFound(Vec::new())
            }
            // A change is offered only if it gives what `mavc plan` would call a plan.
            Decision::Feasible(planned) => match certify::is_plan(problem, time, &planned.trajectory(), &selected_by) {
                true => Answer::Feasible,
                false => Answer::NotFound(Vec::new()),
            },
            Decision::Infeasible => Answer::Infeasible { weights: parts, only_for_selection, only_for_samples: true },
            Decision::Inconclusive(_) => Answer::NotFound(parts),
        }
    }
}

/// A proof that does not cover everything that the spec leaves open is not a proof for the spec.
fn not_for_all(decision: Decision) -> Decision {
    match decision {
        Decision::Infeasible => Decision::Inconclusive(NOT_FOUND.into()),
        decision => decision,
    }
}

/// The verdict on RSP from one on the facets that one RIP plan selects. In the hover model that plan is the only one of
/// least cost, so they are RSP's facets; in the exact model another RIP plan may select others, and a proof for these
/// is not one for RSP.
fn about_all_selections(decision: Decision, model: &Model) -> Decision {
    if finds_local_optima(model) { not_for_all(decision) } else { decision }
}

/// Limits hold at the nodes. A plan that exceeds one between them by more than this share of it (of 1 m or 1 rad if it
/// bounds a coordinate) only shows that the grid is too coarse at this mission time. Chosen by hand.
const COARSE: f64 = 0.05;

/// Whether a plan exceeds some limit by more than [`COARSE`].
fn exceeds_a_limit(planned: &Planned, mission: &Mission, environment: &Environment) -> bool {
    let trajectory = planned.trajectory();
    // A yaw that follows from the motion is required at nodes only.
    mission.limits.iter().filter(|limit| !limit.kind.is_heading()).any(|limit| {
        let bound = limit.lower.into_iter().chain(limit.upper).map(f64::abs).fold(0.0, f64::max);
        let scale = if limit.kind.describe().quantity.is_coordinate() { 1.0 } else { bound.max(COARSE) };
        peak_of(limit, mission, &trajectory, |state| violation(limit, state, environment)).value > COARSE * scale
    })
}

/// The weights of rows, assigned to parts. A facet that several modes share counts for each of them.
fn weighed(set: &PlanningSet, weights: Vec<(RowOrigin, f64)>, problem: Problem, time: f64) -> Vec<(Part, f64)> {
    let (model, mission) = (problem.model(), problem.mission());
    let last = time_grid(mission, time, model.plan.samples).map(|p| p.flown().nodes() - 1);
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
                // Mode 0 is the healthy vehicle, which no statement can leave out.
                let modes = set.rows[facet].origin.iter().filter_map(|of| of.mode.checked_sub(1));
                parts.extend(modes.map(|mode| (Part::Mode(mode), weight)));
            }
            // The largest thrust depends on all modes.
            RowOrigin::Thrust { .. } if model.plan.planner == PlannerKind::Rcp => {
                parts.extend(model.plan.against.iter().map(|&mode| (Part::Mode(mode), weight)));
            }
            _ => {}
        }
    }
    parts
}
