//! Plans under a wrench that is not linear in the motion, by sequential convex programming.
//!
//! Each step solves a convex subproblem (`subproblem`) with the wrench linear about the last iterate and the convex
//! part of the Lagrangian's Hessian by the last multipliers (Nocedal and Wright, *Numerical Optimization*, chapter 18;
//! for trajectories Mao, Szmuk and Acikmese, CDC 2016). At one mission time a feasibility phase is followed by a cost
//! phase and constraint tightening; shorter times are reached by `continuation` and by steps with the durations of legs
//! as variables (`durations`, `fixed_times`). `docs/method/exact-planner.md` lists these algorithms; [`settings`] holds
//! their parameters.

mod branching;
mod budget;
mod comfort;
mod commands;
mod continuation;
mod cost_phase;
mod durations;
mod exact;
mod feasibility_phase;
mod fixed_times;
mod given_time;
mod headings;
mod initial_guess;
mod iterate;
mod minimum_snap;
mod relaxation;
mod rest_to_rest;
pub mod sensitivity;
pub mod settings;
mod shortening;
mod shortest_time;
mod sides;
mod subproblem;
mod tightening;
mod violation;
mod way_around;
mod wrench_variables;

pub use exact::ExactPlanner;
pub use given_time::NOT_FOUND;
pub use iterate::Iterate;
pub use relaxation::{MostThrust, Relaxed};
pub use settings::ScpSettings;

use crate::actuation::Wrench;
use crate::admissible;
use crate::flatness::FlatState;
use crate::model::{Environment, Mission, Model, Problem};
use crate::motion::hover_map::WrenchMap;
use crate::motion::time_grid::TimeGrid;
use crate::motion::winds::OverWinds;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::comfort::Comfort;
use crate::planner::hover::HoverPlanner;
use crate::planner::selection::PlanningSet;
use crate::planner::spline::NodeSpline;
use crate::planner::transcription::{Row, RowAt, Transcription, splines};
use crate::qp::RowOrigin;
use crate::solve::{Solution, solve_step};
use commands::Lag;
use settings::ProximalSettings;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
use subproblem::{Objective, Step, change};

/// Instants per interval at which a plan is checked and rows can be imposed: those at which reports look.
pub use crate::motion::outside::PARTS;

const ALL_AXES: [usize; 4] = [X, Y, Z, YAW];

/// The weight of the proximal term, which keeps a step where the linear model holds; see [`Step::proximal_weight`]. It
/// adapts to the ratio of actual to predicted gain, as the radius of a trust region does.
#[derive(Debug, Clone, Copy)]
struct ProximalWeight {
    weight: f64,
}

impl ProximalWeight {
    /// After a full step that gained `gained` where the linear model predicted `expected`.
    fn after(self, gained: f64, expected: f64, settings: &ProximalSettings) -> ProximalWeight {
        match gained / expected {
            r if r > settings.good_ratio => {
                ProximalWeight { weight: (settings.decrease * self.weight).max(settings.min_weight) }
            }
            r if r < settings.poor_ratio => self.increased(settings),
            _ => self,
        }
    }

    /// After a step of which the line search took only a share.
    fn after_share(self, share: f64, settings: &ProximalSettings) -> ProximalWeight {
        let (least, most) = settings.increase_after_share;
        ProximalWeight { weight: self.weight * (1.0 / share).clamp(least, most) }
    }

    fn increased(self, settings: &ProximalSettings) -> ProximalWeight {
        ProximalWeight { weight: settings.increase * self.weight }
    }

    fn is_exhausted(self, settings: &ProximalSettings) -> bool {
        self.weight > settings.max_weight
    }
}

/// The weights of a subproblem's objective (73).
#[derive(Debug, Clone, Copy)]
struct Weights {
    objective: Objective,
    /// Weight of the violation; see [`Step::penalty`].
    penalty: f64,
    /// Weight of the cost; see [`Step::cost_weight`].
    cost_weight: f64,
    /// Weight of changes of inputs; see [`Step::input_weight`].
    input_weight: f64,
}

/// How durations may change in a step.
#[derive(Debug, Clone)]
struct Durations {
    /// Per leg the index of its variable; `None` where its duration is fixed.
    legs: Vec<Option<usize>>,
    /// Least and largest relative change of a duration.
    range: (f64, f64),
    /// Legs between two fixed times: their durations may change, but not the sum of them.
    spans: Vec<Range<usize>>,
}

/// Plans one mission against one set by sequential convex programming.
pub struct ScpPlanner<'e, 'a> {
    /// The mission, its progress report and the solver's effort; relaxations (74) and bounds on the time are its own.
    pub hover: &'e mut HoverPlanner<'a>,
    /// The wrench of a trajectory: exact, or one of the models about hover.
    pub wrench: WrenchModel,
    pub set: &'e PlanningSet,
    pub settings: ScpSettings,
    /// The tightening of each row of the set, in widths of the healthy set.
    tightening: Vec<f64>,
    /// Further tightening by instant and place ([`Self::row`]), where rows are violated between the instants.
    local_tightening: BTreeMap<usize, BTreeMap<usize, f64>>,
    /// Of the last subproblem: the sum of multiplier times normal of the facets at each instant.
    multipliers: BTreeMap<usize, Wrench>,
    /// Proximal weight with which the next cost phase starts.
    proximal_weight_of_cost_phase: f64,
    /// [`Step::input_weight`] of nearly feasible iterates; 0 after it has made one feasibility phase fail.
    input_weight: f64,
    /// Where rotors lag.
    lag: Option<Lag>,
    /// What acts on the vehicle.
    environment: Environment,
    /// Whether the set has rows of cores.
    has_cores: bool,
    /// By leg which of the ways around volumes it takes, where that is not the shortest; see [`Self::way_around`].
    sides: BTreeMap<usize, usize>,
    /// Of the last step, with the times of the nodes, s.
    splines: Option<(Vec<f64>, Arc<[NodeSpline; 2]>)>,
    /// The work after which what the search has was enough.
    enough_at: Cell<Option<u64>>,
    /// What counts beside (48) in the cost of a second pass.
    comfort: Option<Comfort>,
    /// The solver's work in the last step, by interval of its grid.
    work_by_interval: f64,
    /// Whether the motion of a coarser grid was only flown slower on the finer one, not shortened there.
    is_slowed: bool,
}

/// The solution of one subproblem.
struct Stepped {
    /// The derivatives at the nodes as if no duration changed.
    states: Vec<NodeState>,
    /// The violation that the linear model predicts, with the tightening.
    sigma: f64,
    /// Relative change of each leg's duration.
    changes: Vec<f64>,
    /// By how much the objective falls per unit of violation that is allowed: the sum of the multipliers of the rows
    /// that the violation widens, at most the penalty.
    price: f64,
}

/// The wrench linearised about an iterate, at the instants that have rows.
struct Linearisation {
    maps: Vec<WrenchMap>,
    wrenches: Vec<Wrench>,
    /// Change per relative change of time.
    time_sensitivities: Vec<Wrench>,
}

impl<'e, 'a> ScpPlanner<'e, 'a> {
    /// With [`ScpSettings::DEFAULT`].
    pub fn new(hover: &'e mut HoverPlanner<'a>, wrench: WrenchModel, set: &'e PlanningSet) -> Self {
        ScpPlanner::with_settings(hover, wrench, set, ScpSettings::DEFAULT)
    }

    /// `hover` belongs to the mission to plan; `set` is imposed on the wrench.
    pub fn with_settings(
        hover: &'e mut HoverPlanner<'a>,
        wrench: WrenchModel,
        set: &'e PlanningSet,
        settings: ScpSettings,
    ) -> Self {
        let model = hover.model();
        let environment = model.environment();
        let at_rest = admissible::trimmed(model, &environment);
        let in_winds = OverWinds::of_wrench(wrench, &model.vehicle, &environment, &NodeState::default());
        let margin = settings.tightening.margin;
        // No more can be kept free than hover itself does.
        let tightening = set.rows.iter().map(|row| match row.equality {
            true => -margin,
            false => margin.min(-0.5 * (row.violation(&at_rest) + in_winds.more_in_winds(row))).max(0.0),
        });
        let lag = model.thrust_lag().map(|tau| Lag::new(tau, set));
        let local_tightening = BTreeMap::new();
        ScpPlanner {
            tightening: tightening.collect(),
            local_tightening,
            hover,
            wrench,
            set,
            settings,
            multipliers: BTreeMap::new(),
            proximal_weight_of_cost_phase: settings.cost.proximal_weight,
            input_weight: settings.proximal.input_weight,
            lag,
            environment,
            has_cores: set.has_cores(),
            sides: BTreeMap::new(),
            splines: None,
            enough_at: Cell::new(None),
            comfort: None,
            work_by_interval: 0.0,
            is_slowed: false,
        }
    }

    fn problem(&self) -> Problem<'a> {
        self.hover.problem
    }

    fn model(&self) -> &'a Model {
        self.hover.model()
    }

    fn mission(&self) -> &'a Mission {
        self.hover.mission()
    }

    fn transcription<'s>(&self, grid: &'s TimeGrid, maps: &'s [WrenchMap]) -> Transcription<'s>
    where
        'a: 's,
        'e: 's,
    {
        let form = Transcription::new(self.problem(), grid, self.set, maps, &ALL_AXES);
        form.with_orders(self.wrench.orders(), PARTS).branching_as(self.hover.branch).with_comfort(self.comfort)
    }

    /// The wrench linearised about an iterate (70), at the instants of `working_set` and, where the set is flat, at the
    /// nodes.
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
            let map = self.wrench.linearised(&self.model().vehicle, &self.environment, &state);
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

    /// The convex part of the Lagrangian's Hessian about an iterate, by the last multipliers: the last line of (73).
    fn curvature(&self, iterate: &Iterate) -> Vec<(usize, NodeState, Vec<FlatState>)> {
        let tau = self.transcription(&iterate.grid, &[]).mean_tau();
        let at = |(&instant, n): (&usize, &Wrench)| {
            let state = iterate.at(instant);
            let vehicle = &self.model().vehicle;
            (instant, state, self.wrench.curvature(vehicle, &self.environment, &state, n, tau))
        };
        // Without curvature there is nothing to add, and its directions need not exist.
        self.multipliers.iter().map(at).filter(|(_, _, factors)| !factors.is_empty()).collect()
    }

    /// The splines over a time grid: those of the last step if it had the same nodes.
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

    /// The durations of a step that changes none.
    fn fixed_durations(&self) -> Durations {
        Durations { legs: vec![None; self.mission().legs.len()], range: (0.0, 0.0), spans: Vec::new() }
    }

    fn forget_multipliers(&mut self) {
        self.multipliers.clear();
        self.lag.iter_mut().for_each(|lag| lag.multipliers.clear());
    }

    /// Solves one subproblem about an iterate. Rows that its solution violates are found afterwards and are in the next
    /// one: solving the same linearisation again with them takes more programs in all (measured). `None` if the solver
    /// reaches no point in which the rows hold.
    fn step(
        &mut self,
        iterate: &Iterate,
        Durations { legs, range, spans }: &Durations,
        proximal: ProximalWeight,
        weights: Weights,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Stepped> {
        let settings = self.settings;
        let at_most = match self.comfort {
            Some(_) => 2.0 * settings.budget.of_comfort,
            None => settings.budget.at_most,
        };
        if self.has_spent(at_most) {
            return None;
        }
        working_set.extend(self.rows_at_nodes(iterate, -settings.subproblem.slack_of_working_set));
        working_set.extend(self.rows_everywhere(&iterate.grid));
        let splines = self.splines(&iterate.grid);
        let linear = self.linearise(iterate, working_set);
        let curvature = self.curvature(iterate);
        let chosen: Vec<RowAt> = working_set.iter().copied().collect();
        let by_wind = self.tightening_by_wind(iterate, &chosen);
        let local_tightening: Vec<f64> =
            chosen.iter().zip(by_wind).map(|(r, by_wind)| self.local_tightening_of(r) + by_wind).collect();
        let commands = self.linearise_commands(iterate, working_set);
        let step = Step {
            settings: &settings,
            from: &iterate.states,
            wrenches: &linear.wrenches,
            time_sensitivities: &linear.time_sensitivities,
            curvature: &curvature,
            proximal_weight: proximal.weight,
            objective: weights.objective,
            penalty: weights.penalty,
            cost_weight: weights.cost_weight,
            input_weight: weights.input_weight,
            range: *range,
            to_first_order: false,
            spans,
            tightening: &self.tightening,
            local_tightening: &local_tightening,
            commands: commands.as_ref(),
        };
        let positions = self.positions(iterate);
        let form = self.transcription(&iterate.grid, &linear.maps).about(positions.as_deref());
        let form = form.about_states(Some(&iterate.states)).with_durations(legs).in_these(splines)?;
        let (program, places) = form.step_program(&step, &chosen);
        let (solved, effort) = solve_step(&program, &form.variables_of(&iterate.states, &program));
        self.hover.effort += effort;
        self.work_by_interval = effort.work as f64 / iterate.grid.intervals() as f64;
        let Solution { x, z, .. } = solved?;
        let row = program.row_origin.iter().position(|o| *o == RowOrigin::Violation);
        let price = weights.penalty - row.map_or(0.0, |row| z[row]);
        let variables = form.variables();
        let of_leg = |leg: &Option<usize>| leg.map_or(0.0, |i| change(x[variables + 1 + i]).clamp(range.0, range.1));
        let negligible = settings.subproblem.negligible_multiplier;
        self.forget_multipliers();
        for (&RowAt { row, instant }, place) in chosen.iter().zip(&places) {
            if let (Row::Facet(facet), Some(place)) = (row, place)
                && z[*place] > negligible
            {
                let normal = self.set.rows[facet].normal;
                *self.multipliers.entry(instant).or_insert_with(Wrench::zeros) += normal * z[*place];
            }
            if let (Row::Command { facet, slope }, Some(place), Some(lag)) = (row, place, &mut self.lag)
                && z[*place] > negligible
            {
                let normal = self.set.rows[facet].normal;
                *lag.multipliers.entry((instant, slope)).or_insert_with(Wrench::zeros) += normal * z[*place];
            }
        }
        Some(Stepped {
            states: form.states(&x),
            sigma: x[variables].max(0.0),
            price,
            changes: fixed_times::keep_sums(&iterate.grid, legs.iter().map(of_leg).collect(), spans),
        })
    }
}
