//! Plans under a wrench that is not linear in the motion, by successive convexification.
//!
//! Each step solves a convex program with the wrench linear about the last iterate, its curvature weighed by the last
//! multipliers (sequential quadratic programming with the convex part of the Lagrangian's Hessian: Nocedal and Wright,
//! *Numerical Optimization*, chapter 18; for trajectories Mao, Szmuk and Acikmese, CDC 2016). Steps restore feasibility
//! at one mission time, then lower the cost there; shorter times are tried from the smooth plan of the last.

mod commands;
mod durations;
mod fixed_times;
mod given_time;
mod initial_guess;
mod iterate;
mod minimum_snap;
mod phases;
mod relaxation;
pub mod sensitivity;
mod shortest_time;
mod stopping;
mod subproblem;
mod violation;

pub use given_time::NOT_FOUND;
pub use iterate::Iterate;
pub use relaxation::{MostThrust, Relaxed};

use crate::actuation::Wrench;
use crate::flatness::FlatState;
use crate::model::{Limit, Model};
use crate::motion::hover_map::WrenchMap;
use crate::motion::time_grid::{LegGrid, Segment, TimeGrid};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::hover::{ACCEPTED, HoverPlanner, Planned};
use crate::planner::limits::place;
use crate::planner::selection::PlanningSet;
use crate::planner::spline::NodeSpline;
use crate::planner::transcription::{Row, RowAt, Transcription, splines};
use crate::solve::{Outcome, Solution, StepSolution, solve_graded, solve_step};
use commands::Lag;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
use subproblem::{Objective, Step, change};

/// Share of a facet's width that steps keep free, so that what the last one leaves curved ends inside.
pub const TIGHTENING: f64 = 1e-4;

/// Instants per interval at which a plan is checked, and at which rows can stand: those at which reports look.
pub use crate::motion::outside::PARTS;

/// Rows of the last iterate with less slack than this stand in the next step from its beginning.
const NEAR: f64 = 0.1;

/// Where [`Transcription::stiffness`] is larger than this times the iterate's cost, steps use stage variables. (Measured on five
/// missions at 100 to 400 samples: 102 s in all instead of 110 s with 1e8, with the same times to 0.2 % or shorter ones.)
const MOST_STIFFNESS: f64 = 1e10;

/// Multipliers below this do not count.
const NEGLIGIBLE: f64 = 1e-4;

const ALL_AXES: [usize; 4] = [X, Y, Z, YAW];

/// How far a step may go: where the last one told the truth the next may go further.
#[derive(Debug, Clone, Copy)]
struct ProximalWeight {
    /// Weight of changed accelerations; see [`Step::proximal_weight`].
    weight: f64,
}

impl ProximalWeight {
    const MOST: f64 = 1e5;
    const LEAST: f64 = 1e-6;

    /// After a step that gained `gained` where the program promised `expected`.
    fn after(self, gained: f64, expected: f64) -> ProximalWeight {
        match gained / expected {
            r if r > 0.7 => ProximalWeight { weight: (0.25 * self.weight).max(Self::LEAST) },
            r if r < 0.3 => self.less(),
            _ => self,
        }
    }

    /// After a step of which only a share was taken.
    fn shared(self, share: f64) -> ProximalWeight {
        ProximalWeight { weight: self.weight * (1.0 / share).clamp(2.0, 16.0) }
    }

    fn less(self) -> ProximalWeight {
        ProximalWeight { weight: 4.0 * self.weight }
    }

    fn exhausted(self) -> bool {
        self.weight > Self::MOST
    }
}

/// What a step weighs against each other.
#[derive(Debug, Clone, Copy)]
struct Weights {
    objective: Objective,
    /// See [`Step::penalty`].
    penalty: f64,
    /// See [`Step::smoothing`].
    smoothing: f64,
    /// See [`Step::input_weight`].
    input_weight: f64,
}

/// How durations may change in a step.
#[derive(Debug, Clone)]
struct Durations {
    /// Per leg: which change is its own; `None` where its duration stands.
    legs: Vec<Option<usize>>,
    /// Least and largest relative change of a duration.
    range: (f64, f64),
    /// Legs between fixed times: they may share what is between these anew, but keep the sum of their durations.
    spans: Vec<Range<usize>>,
}

/// Plans one mission against one set.
pub struct ScpPlanner<'e, 'a> {
    pub hover: &'e mut HoverPlanner<'a>,
    pub wrench: WrenchModel,
    pub set: &'e PlanningSet,
    /// What each row of the set keeps free, in widths of the healthy set.
    tightening: Vec<f64>,
    /// What rows keep free beyond that, by instant and place ([`Self::row`]): about there the wrench bends between instants.
    local_tightening: BTreeMap<usize, BTreeMap<usize, f64>>,
    /// Of the last program: the sum of multiplier times normal of the facets at each instant.
    multipliers: BTreeMap<usize, Wrench>,
    /// Proximity at which the next steps towards the least cost begin.
    proximal_weight_of_cost_phase: f64,
    /// [`Step::input_weight`] of motions that nearly fit; 0 once it has kept one from fitting.
    input_weight: f64,
    /// Where rotors lag.
    lag: Option<Lag>,
    /// Of the last step, with the times of the nodes.
    splines: Option<(Vec<f64>, Arc<[NodeSpline; 2]>)>,
}

/// What one program gave.
struct Stepped {
    /// In the old time.
    states: Vec<NodeState>,
    sigma: f64,
    /// Relative change of each leg's duration.
    changes: Vec<f64>,
}

/// The wrench about an iterate, at the instants that have rows.
struct Linearisation {
    maps: Vec<WrenchMap>,
    wrenches: Vec<Wrench>,
    /// Change per relative change of time.
    time_sensitivities: Vec<Wrench>,
}

impl<'e, 'a> ScpPlanner<'e, 'a> {
    pub fn new(engine: &'e mut HoverPlanner<'a>, wrench: WrenchModel, set: &'e PlanningSet) -> Self {
        let model = engine.model;
        let hover = Wrench::new(model.vehicle.mass * model.gravity, 0.0, 0.0, 0.0);
        // What hover itself keeps free is all that can be kept free.
        let tightening = set.rows.iter().map(|row| match row.equality {
            true => -TIGHTENING,
            false => TIGHTENING.min(-0.5 * row.violation(&hover)).max(0.0),
        });
        let lag = model.thrust_lag().map(|tau| Lag::new(tau, set));
        let local_tightening = BTreeMap::new();
        ScpPlanner {
            tightening: tightening.collect(),
            local_tightening,
            hover: engine,
            wrench,
            set,
            multipliers: BTreeMap::new(),
            proximal_weight_of_cost_phase: phases::COST_PHASE_WEIGHT,
            input_weight: phases::INPUT_WEIGHT,
            lag,
            splines: None,
        }
    }

    fn transcription<'s>(&self, grid: &'s TimeGrid, maps: &'s [WrenchMap]) -> Transcription<'s>
    where
        'a: 's,
        'e: 's,
    {
        let (model, mission) = (self.hover.model, self.hover.mission);
        let form = Transcription::new(model, mission, grid, self.set, maps, &ALL_AXES);
        form.with_orders(self.wrench.orders(), PARTS).stopping_from(self.hover.struck)
    }

    /// The wrench about an iterate, at the instants of `working_set` and, where the set is flat, at the nodes.
    fn linearise(&self, iterate: &Iterate, working_set: &BTreeSet<RowAt>) -> Linearisation {
        let instants = iterate.grid.intervals() * PARTS + 1;
        let mut linear = Linearisation {
            maps: vec![WrenchMap { constant: Wrench::zeros(), terms: Vec::new() }; instants],
            wrenches: vec![Wrench::zeros(); instants],
            time_sensitivities: vec![Wrench::zeros(); instants],
        };
        let flat = self.set.rows.iter().any(|r| r.equality);
        let nodes = (0..instants).step_by(PARTS).filter(|_| flat);
        let needed: BTreeSet<usize> = working_set.iter().map(|r| r.instant).chain(nodes).collect();
        for instant in needed {
            let state = iterate.at(instant);
            let map = self.wrench.linearised(&self.hover.model.vehicle, self.hover.model.gravity, &state);
            let change = |sum: Wrench, &(axis, order, c): &(usize, usize, Wrench)| {
                let order: usize = order;
                sum - c * (order as f64 * state[axis][order])
            };
            linear.time_sensitivities[instant] = map.terms.iter().fold(Wrench::zeros(), change);
            linear.wrenches[instant] = map.at(&state);
            linear.maps[instant] = map;
        }
        linear
    }

    /// The convex part of the Lagrangian's curvature about an iterate, by the last multipliers.
    fn curvature(&self, iterate: &Iterate) -> Vec<(usize, NodeState, Vec<FlatState>)> {
        let tau = self.transcription(&iterate.grid, &[]).mean_tau();
        let at = |(&instant, n): (&usize, &Wrench)| {
            let state = iterate.at(instant);
            let (vehicle, gravity) = (&self.hover.model.vehicle, self.hover.model.gravity);
            (instant, state, self.wrench.curvature(vehicle, gravity, &state, n, tau))
        };
        // Where the wrench does not curve there is nothing to weigh, nor need its directions exist.
        self.multipliers.iter().map(at).filter(|(_, _, factors)| !factors.is_empty()).collect()
    }

    /// The splines of a profile: those of the last step where it had the same nodes.
    fn splines(&mut self, grid: &TimeGrid) -> Arc<[NodeSpline; 2]> {
        match &self.splines {
            Some((times, known)) if *times == grid.node_times => known.clone(),
            _ => {
                let new = splines(grid);
                self.splines = Some((grid.node_times.clone(), new.clone()));
                new
            }
        }
    }

    fn forget_multipliers(&mut self) {
        self.multipliers.clear();
        self.lag.iter_mut().for_each(|lag| lag.multipliers.clear());
    }

    /// Solves one step about an iterate. Rows that it passes are found afterwards, and stand in the next one: solving the same
    /// lines again with them takes more programs in all (measured).
    fn step(
        &mut self,
        iterate: &Iterate,
        Durations { legs, range, spans }: &Durations,
        proximal: ProximalWeight,
        weights: Weights,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Stepped> {
        working_set.extend(self.rows_at_nodes(iterate, -NEAR));
        working_set.extend(self.rows_everywhere(&iterate.grid));
        // Splines cannot bend where legs change by different shares, and stiff ones leave the solver no digits.
        let together = legs.iter().all(|leg| *leg == legs[0]);
        let known = together.then(|| self.splines(&iterate.grid));
        let linear = self.linearise(iterate, working_set);
        let curvature = self.curvature(iterate);
        let chosen: Vec<RowAt> = working_set.iter().copied().collect();
        let local_tightening: Vec<f64> = chosen.iter().map(|r| self.bend(r)).collect();
        let commands = self.command_lines(iterate, working_set);
        let step = Step {
            from: &iterate.states,
            wrenches: &linear.wrenches,
            time_sensitivities: &linear.time_sensitivities,
            legs,
            curvature: &curvature,
            proximal_weight: proximal.weight,
            objective: weights.objective,
            penalty: weights.penalty,
            smoothing: weights.smoothing,
            input_weight: weights.input_weight,
            range: *range,
            spans,
            tightening: &self.tightening,
            local_tightening: &local_tightening,
            commands: commands.as_ref(),
        };
        let stages = self.transcription(&iterate.grid, &linear.maps);
        let splines = known.map(|known| self.transcription(&iterate.grid, &linear.maps).in_these(known));
        let most = MOST_STIFFNESS * self.cost(iterate);
        let splines = splines.filter(|form| form.stiffness() <= most);
        // Asked in turn until one is solved: splines as the solver scales them, stages first as they are.
        let of_splines = splines.iter().map(|form| (form, true));
        let ways = of_splines.chain([(&stages, false), (&stages, true)]);
        let mut found = None;
        for (form, scaled) in ways {
            let (program, places) = form.step_program(&step, &chosen);
            let (approached, effort) = solve_step(&program, scaled);
            self.hover.effort += effort;
            let Some(StepSolution { solution: Solution { x, z, .. }, is_optimal }) = approached else { continue };
            if is_optimal || found.is_none() {
                found = Some((form, x, z, places));
            }
            if is_optimal {
                break;
            }
        }
        let (form, x, z, places) = found?;
        let variables = form.variables();
        let of_leg = |leg: &Option<usize>| leg.map_or(0.0, |i| change(x[variables + 1 + i]).clamp(range.0, range.1));
        self.forget_multipliers();
        for (&RowAt { row, instant }, place) in chosen.iter().zip(&places) {
            if let (Row::Facet(facet), Some(place)) = (row, place)
                && z[*place] > NEGLIGIBLE
            {
                let normal = self.set.rows[facet].normal;
                *self.multipliers.entry(instant).or_insert_with(Wrench::zeros) += normal * z[*place];
            }
            if let (Row::Command { facet, slope }, Some(place), Some(lag)) = (row, place, &mut self.lag)
                && z[*place] > NEGLIGIBLE
            {
                let normal = self.set.rows[facet].normal;
                *lag.multipliers.entry((instant, slope)).or_insert_with(Wrench::zeros) += normal * z[*place];
            }
        }
        Some(Stepped {
            states: form.states(&x),
            sigma: x[variables].max(0.0),
            changes: fixed_times::keep_sums(&iterate.grid, legs.iter().map(of_leg).collect(), spans),
        })
    }
}
