//! One program at one mission time, with rows of sets and limits added only where they are passed.
//!
//! Few rows ever bind. A program that lacks rows is a relaxation: where it is infeasible, so is the
//! full one; where its solution passes no row, it solves the full one.

mod reach;

pub(super) use reach::LEEWAY;

use crate::actuation::Wrench;
use crate::admissible::AdmissibleSet;
use crate::model::{Mission, Model};
use crate::motion::time_grid::{TimeGrid, time_grid};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory};
use crate::planner::commands::{CommandMaps, Slope};
use crate::planner::limits::place;
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Purpose, Row, RowAt, Transcription};
use crate::planner::working_set::WorkingSet;
use crate::planner::yaw::{YawPlan, plan_yaw};
use crate::qp::RowOrigin;
use crate::solve::{Effort, Outcome, Solution, solve};

/// A waypoint may be overshot by this much, m, and the plan still counts as feasible (yaw in proportion).
pub const FEASIBLE: f64 = 1e-6;

/// Rows are added until no other is passed by more than this share of the healthy set's width (of a limit). (Those of the program
/// itself hold to the solver's tolerance.)
pub const ACCEPTED: f64 = 1e-7;

/// Rows with more slack than this at a plan are not carried on to other mission times.
const KEPT: f64 = 0.05;

/// Up to this many rows a program is solved in spline coefficients, beyond in stage variables (measured).
const FEW_ROWS: usize = 1_000;

/// Where [`Transcription::stiffness`] is larger the solver stalls in spline coefficients (measured: 2e8 along the paper's
/// curve with 200 samples in 16 s is fine, with 500 samples, 1e11, or 200 in 7 s, 4e10, it often ends without a verdict).
const MOST_STIFFNESS: f64 = 1e9;

/// After this many rounds every row is imposed.
const MOST_ROUNDS: usize = 30;

/// The share of [`Purpose::Overshoot`]'s objective that the inputs' cost may take at most, m.
const COST_SHARE: f64 = 1e-3;

/// The share of [`Purpose::Violation`]'s objective that the inputs' cost may take at most.
const EXCESS_COST: f64 = 0.05;

/// A mission laid out in time, with yaw planned: all that does not depend on the planner.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    pub grid: TimeGrid,
    /// The profile without holds, which programs are made of.
    pub flown: TimeGrid,
    /// At the nodes of `flown`.
    pub yaw: YawPlan,
}

impl Layout {
    /// The lead wrench at both ends of every interval flown, where the spec's rotors lag.
    pub fn commands(&self, model: &Model) -> Option<CommandMaps> {
        let tau = model.thrust_lag()?;
        Some(self.yaw.commands(&model.vehicle, model.gravity, &self.flown, tau))
    }
}

/// Plans one mission of one model, and counts the solver's effort.
pub struct HoverPlanner<'a> {
    pub model: &'a Model,
    pub mission: &'a Mission,
    pub healthy: &'a AdmissibleSet,
    pub effort: Effort,
    /// After [`Decision::Infeasible`]: what the rows weigh in the multipliers that show it
    /// ([`crate::qp::QuadraticProgram::weights`]). Empty where reach, fixed times or the yaw planned first show it.
    pub weights: Vec<(RowOrigin, f64)>,
    /// Where the mission is a stop: the state in which a fault strikes. See [`crate::planner::stop`].
    pub struck: Option<NodeState>,
    /// Told each mission time before it is tried.
    pub on_progress: Option<&'a (dyn Fn(f64) + Sync)>,
}

/// What was shown at one mission time.
#[derive(Debug, Clone)]
pub enum Decision {
    Feasible(Box<Planned>),
    /// Proved by multipliers checked in plain arithmetic.
    Infeasible,
    Inconclusive(String),
}

/// How far a mission time is from one at which a plan exists, as a share; see [`Purpose::Violation`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// Positive: rows and limits would have to be wider by this share. Negative: all keep this distance.
    pub sigma: f64,
    /// sigma was not pursued below this.
    pub least: f64,
}

/// An optimal plan at one mission time.
#[derive(Debug, Clone)]
pub struct Planned {
    pub grid: TimeGrid,
    /// Of the wrench.
    pub model: WrenchModel,
    /// At every node, both ends of each hold included.
    pub states: Vec<NodeState>,
    /// Value of (48).
    pub objective: f64,
    /// Rows in the last program (facets and limits, each at one node).
    pub rows: usize,
}

impl Planned {
    /// The plan as polynomials between its nodes, with pieces that join.
    pub fn trajectory(&self) -> Trajectory {
        let carried = Trajectory {
            times: self.grid.node_times.clone(),
            nodes: self.states.clone(),
            waypoint_nodes: self.grid.waypoint_nodes.clone(),
            model: self.model,
        };
        carried.joined()
    }
}

/// What came of one program with row generation.
struct Attempt {
    outcome: Outcome,
    states: Vec<NodeState>,
    rows: usize,
}

impl<'a> HoverPlanner<'a> {
    pub fn new(model: &'a Model, mission: &'a Mission, healthy: &'a AdmissibleSet) -> Self {
        let (effort, weights) = (Effort::default(), Vec::new());
        HoverPlanner { model, mission, healthy, effort, weights, struck: None, on_progress: None }
    }

    pub(super) fn progress(&self, time: f64) {
        if let Some(tell) = self.on_progress {
            tell(time);
        }
    }

    /// Intervals of the coarse grid that brackets: about five a leg, at least 60, never more than the plan's.
    pub(super) fn coarse_samples(&self) -> usize {
        let segments = self.mission.legs.len() + self.mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
        (5 * segments).max(60).min(self.model.plan.samples)
    }

    /// Lays the mission out; `Ok(None)` where the fixed times leave a leg no time.
    pub fn layout(&mut self, total: f64, samples: usize) -> Result<Option<Layout>, Outcome> {
        let Some(grid) = time_grid(self.mission, total, samples) else { return Ok(None) };
        let flown = grid.flown();
        let yaw = plan_yaw(self.model, self.mission, &flown, &mut self.effort)?;
        Ok(Some(Layout { grid, flown, yaw }))
    }

    /// Whether fixed times, yaw waypoints or reach already rule out every plan, for any choice of yaw.
    pub(super) fn is_hopeless(&mut self, total: f64) -> bool {
        match self.layout(total, self.model.plan.samples) {
            Ok(Some(layout)) => self.out_of_reach(&layout),
            Ok(None) | Err(Outcome::Infeasible { .. }) => true,
            Err(_) => false,
        }
    }

    /// Decides one mission time: plans it, or shows that no plan meets every waypoint within its tolerance plus
    /// [`FEASIBLE`].
    pub fn decide(&mut self, total: f64, samples: usize, set: &PlanningSet, working_set: &mut WorkingSet) -> Decision {
        self.decide_with(total, samples, set, working_set, false)
    }

    /// The same on the coarse grid, where a verdict is only a hint and none is sought at length.
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
            self.keep_near(&layout, set, &attempt.states, 0.0, working_set);
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
            Outcome::Infeasible { .. } => Decision::Infeasible,
            Outcome::Inconclusive { status, .. } if quickly => Decision::Inconclusive(status),
            Outcome::Inconclusive { status, .. } => self.decide_by_overshoot(&layout, set, working_set, status),
        }
    }

    /// How far a mission time is from feasible, to within `tolerance`. It grows smoothly as time shrinks, where a
    /// verdict is only yes or no; so it tells where to look, and claims nothing. `None` where waypoints, rest and
    /// positions alone cannot be met.
    pub(super) fn violation(
        &mut self,
        total: f64,
        samples: usize,
        set: &PlanningSet,
        working_set: &mut WorkingSet,
        tolerance: f64,
    ) -> Option<Violation> {
        self.progress(total);
        let layout = self.layout(total, samples).ok()??;
        let hover = self.hover_margin(set);
        let epsilon = EXCESS_COST / self.cost_scale(&layout);
        let purpose = Purpose::Violation { epsilon, least: -0.5 * hover };
        let before = working_set.clone();
        let attempt = self.generate_within(&layout, set, purpose, working_set, tolerance);
        let (Outcome::Solved(Solution { x, .. }) | Outcome::Inconclusive { point: Some(x), .. }) = &attempt.outcome
        else {
            *working_set = before;
            return None;
        };
        let sigma = *x.last()?;
        self.keep_near(&layout, set, &attempt.states, sigma.min(0.0), working_set);
        Some(Violation { sigma, least: -0.5 * hover })
    }

    /// How far hover is inside a set, as a share of the healthy set's width.
    pub(super) fn hover_margin(&self, set: &PlanningSet) -> f64 {
        let inside = set.rows.iter().filter(|r| !r.equality).map(|r| -r.violation(&self.healthy.hover));
        inside.fold(f64::INFINITY, f64::min)
    }

    /// Whether a plan flown `factor` times slower still keeps every row and limit, so that a longer mission needs no
    /// program of its own. Not told of missions with fixed times, holds or changing yaw.
    pub(super) fn slowed_down_keeps(&self, planned: &Planned, set: &PlanningSet, factor: f64) -> bool {
        let WrenchModel::HoverAt(_) = planned.model else { return false };
        let own_times = self.mission.waypoints.iter().any(|w| w.hold > 0.0 || w.time.is_some());
        let least_rates = self.mission.limits.iter().any(|l| !place(l.kind) && l.lower.is_some_and(|b| b > 0.0));
        if own_times || least_rates {
            return false;
        }
        let slow = |state: &NodeState| -> NodeState {
            state.map(|axis| std::array::from_fn(|order| axis[order] * factor.powi(-(order as i32))))
        };
        let wrench = |state| planned.model.wrench(&self.model.vehicle, self.model.gravity, &slow(state));
        let wrenches: Vec<Wrench> = planned.states.iter().map(wrench).collect();
        let keeps = |w: &Wrench| set.rows.iter().all(|row| row.violation(w) <= ACCEPTED);
        // The wrench is linear over an interval here, so w' is the same at both its ends.
        let commands = |tau: f64| {
            wrenches.windows(2).zip(planned.grid.steps()).all(|(w, step)| {
                let ahead = (w[1] - w[0]) * (tau / (factor * step));
                keeps(&(w[0] + ahead)) && keeps(&(w[1] + ahead))
            })
        };
        wrenches.iter().all(keeps) && self.model.thrust_lag().is_none_or(commands)
    }

    /// Drops the rows that states keep well clear of.
    fn keep_near(
        &self,
        layout: &Layout,
        set: &PlanningSet,
        states: &[NodeState],
        sigma: f64,
        working_set: &mut WorkingSet,
    ) {
        let maps = layout.yaw.maps(self.model, layout.flown.nodes());
        let commands = layout.commands(self.model);
        let stages = Transcription::new(self.model, self.mission, &layout.flown, set, &maps, layout.yaw.axes())
            .with_commands(commands.as_ref());
        working_set.rows.retain(|r| match r.row {
            Row::Facet(facet) => set.rows[facet].violation(&maps[r.instant].at(&states[r.instant])) > sigma - KEPT,
            Row::Limit(limit) => stages.limit_violation(&self.mission.limits[limit], states, r.instant, sigma) > -KEPT,
            Row::Upright => false,
            Row::Command { facet, slope } => stages
                .command_wrench(states, (r.instant, slope))
                .is_some_and(|wrench| set.rows[facet].violation(&wrench) > sigma - KEPT),
        });
    }

    /// Where the plan's program gives no verdict: minimise sigma + epsilon J, which always has a solution. With
    /// J at most J_max on feasible plans, a lower bound above FEASIBLE + epsilon J_max shows that there is none.
    fn decide_by_overshoot(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        working_set: &WorkingSet,
        status: String,
    ) -> Decision {
        let Some(most) = self.largest_cost(layout) else { return Decision::Inconclusive(status) };
        let epsilon = COST_SHARE / most;
        let attempt = self.generate(layout, set, Purpose::Overshoot { epsilon }, &mut working_set.clone());
        match attempt.outcome {
            Outcome::Solved(solution) if solution.bound > FEASIBLE + COST_SHARE => Decision::Infeasible,
            Outcome::Infeasible { .. } => Decision::Infeasible,
            _ => Decision::Inconclusive(status),
        }
    }

    /// Solves with rows added where they are passed by more than [`ACCEPTED`], until none is.
    fn generate(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        purpose: Purpose,
        working_set: &mut WorkingSet,
    ) -> Attempt {
        self.generate_within(layout, set, purpose, working_set, ACCEPTED)
    }

    /// The same for any other share. A violation is not pursued below its `least`, nor more closely than a fifth of
    /// itself: far from zero it need not be known well.
    fn generate_within(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        purpose: Purpose,
        working_set: &mut WorkingSet,
        accepted: f64,
    ) -> Attempt {
        let nodes = layout.flown.nodes();
        let maps = layout.yaw.maps(self.model, nodes);
        let (model, mission) = (self.model, self.mission);
        let commands = layout.commands(model);
        let new = || {
            Transcription::new(model, mission, &layout.flown, set, &maps, layout.yaw.axes())
                .with_commands(commands.as_ref())
        };
        let (stages, splines) = (new(), new().in_splines());
        let smooth = splines.stiffness() <= MOST_STIFFNESS;
        working_set.fit(nodes);
        let most = match purpose {
            Purpose::Plan { .. } => self.largest_cost(layout).unwrap_or(f64::INFINITY),
            _ => f64::INFINITY,
        };
        let mut round = 0;
        loop {
            let chosen: Vec<RowAt> = working_set.rows.iter().copied().collect();
            let splined = smooth && chosen.len() <= FEW_ROWS && !matches!(purpose, Purpose::Overshoot { .. });
            let mut form = if splined { &splines } else { &stages };
            let mut program = form.program(purpose, &chosen);
            let (mut outcome, spent) = solve(&program);
            self.effort += spent;
            if splined && matches!(outcome, Outcome::Inconclusive { .. }) {
                form = &stages;
                program = stages.program(purpose, &chosen);
                let (again, spent) = solve(&program);
                self.effort += spent;
                outcome = again;
            }
            if let Outcome::Infeasible { certificate: z } | Outcome::Solved(Solution { z, .. }) = &outcome {
                self.weights = program.weights(z);
            }
            let x = match &outcome {
                // No feasible plan costs this much.
                Outcome::Solved(solution) if solution.bound > most => {
                    let outcome = Outcome::Infeasible { certificate: solution.z.clone() };
                    return Attempt { outcome, states: Vec::new(), rows: chosen.len() };
                }
                Outcome::Solved(solution) => &solution.x,
                // Even a point without a verdict shows which rows are missing.
                Outcome::Inconclusive { point: Some(x), .. } => x,
                _ => return Attempt { outcome, states: Vec::new(), rows: chosen.len() },
            };
            let mut states = form.states(x);
            let (sigma, accepted) = match purpose {
                Purpose::Violation { least, .. } => {
                    let sigma = x.last().copied().unwrap_or(0.0);
                    let far = round >= 2 && sigma <= 0.99 * least;
                    (sigma, if far { f64::INFINITY } else { accepted.max(0.2 * sigma.abs()) })
                }
                _ => (0.0, accepted),
            };
            working_set.rows.extend(passed(&stages, &states, sigma, accepted));
            if working_set.rows.len() == chosen.len() {
                layout.yaw.fill(&mut states);
                return Attempt { outcome, states, rows: chosen.len() };
            }
            round += 1;
            if round == MOST_ROUNDS {
                working_set.rows = stages.every_row().into_iter().collect();
            }
        }
    }
}

/// At each node the facet that the states pass furthest by more than `accepted`, and every limit passed by more, there
/// and at the neighbouring nodes; where rotors lag, the facet that the lead wrench passes furthest too, on each side of the
/// node. All rows are taken as widened by `sigma`.
fn passed(form: &Transcription, states: &[NodeState], sigma: f64, accepted: f64) -> Vec<RowAt> {
    let (rows, last) = (&form.set.rows, states.len() - 1);
    let mut found = Vec::new();
    // The facet passed furthest speaks for those beside it; the others get their turn if they still need one.
    let furthest = |wrench: &Wrench| {
        let inequalities = (0..rows.len()).filter(|&f| !rows[f].equality);
        let violations = inequalities.map(|f| (f, rows[f].violation(wrench) - sigma));
        violations.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|worst| worst.1 > accepted).map(|(f, _)| f)
    };
    for (node, (state, map)) in states.iter().zip(form.maps).enumerate() {
        let facet = furthest(&map.at(state)).map(Row::Facet);
        let lead = |slope: Slope| {
            let facet = furthest(&form.command_wrench(states, (node, slope))?)?;
            Some(Row::Command { facet, slope })
        };
        let commands = [Slope::Before, Slope::After].into_iter().filter_map(lead);
        let limits = form.mission.limits.iter().enumerate();
        let limits = limits.filter(|(_, l)| form.limit_violation(l, states, node, sigma) > accepted);
        for row in facet.into_iter().chain(commands).chain(limits.map(|(i, _)| Row::Limit(i))) {
            let around = node.saturating_sub(1)..=(node + 1).min(last);
            found.extend(around.map(|instant| RowAt { row, instant }));
        }
    }
    found
}
