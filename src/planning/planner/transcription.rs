//! From a mission, a time grid and a planning set to a quadratic program.
//!
//! Two forms of one program. With stage variables each node holds every derivative of every axis up to the input (4 for
//! x and y, 2 for z and yaw), and rows join the nodes; inputs are piecewise linear between nodes, so a step is exact. A
//! derivative of order i is multiplied by tau^i, tau four of the steps beside its node, which brings all variables and
//! the entries of the rows that join them to like size. With splines the states are eliminated: fewer variables and no
//! joining rows, but each row couples more of them.

mod jumps;
mod mission;
mod units;

use crate::actuation::Wrench;
use crate::model::{Environment, Mission, Model, Problem};
use crate::motion::hover_map::{ORDER, WrenchMap};
use crate::motion::time_grid::TimeGrid;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::branch::Branch;
use crate::planner::comfort::Comfort;
use crate::planner::commands::{CommandAt, CommandMaps, Slope};
use crate::planner::cores::{CoreAt, Scaling};
use crate::planner::limits::Widening;
use crate::planner::selection::PlanningSet;
use crate::planner::spline::{JumpAt, NodeSpline};
use crate::planner::wrench_expression::WrenchExpression;
use crate::qp::build::{Affine, Builder};
use crate::qp::{QuadraticProgram, RowOrigin};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The objective of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Purpose {
    /// (48): least weighted squared inputs and waypoint distances, every tolerance (widened by `slack`, m and
    /// rad) met.
    Plan { slack: f64 },
    /// The smallest sigma + epsilon J, where every waypoint is met within its tolerance plus sigma (m) and J
    /// is the cost (48).
    Overshoot { epsilon: f64 },
    /// The smallest sigma + epsilon J, where facet rows are widened by sigma (a share of the healthy set's width),
    /// limits by sigma times themselves, and sigma is at least `least`. Tolerances and positions are not widened.
    Violation { epsilon: f64, least: f64 },
}

/// A row that row generation may leave out: an inequality of the set or a limit, at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct RowAt {
    pub row: Row,
    /// Instants count from 0; each interval between nodes has [`Transcription::parts`] of them.
    pub instant: usize,
}

/// Which row; see [`RowAt`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Row {
    /// A row of the planning set, by index.
    Facet(usize),
    /// A limit of the mission, by index.
    Limit(usize),
    /// (68): the thrust's vertical part is at least [`crate::tolerance::UPRIGHT`] times the weight.
    Upright,
    /// A row of the planning set, by index, on the commanded wrench of rotors that lag.
    Command { facet: usize, slope: Slope },
}

/// All that a program depends on, except its objective and the choice of rows.
pub struct Transcription<'a> {
    pub model: &'a Model,
    /// That of the model, or the same with other bounds (`of_statements`).
    pub mission: &'a Mission,
    /// Without holds: [`TimeGrid::flown`].
    pub grid: &'a TimeGrid,
    pub set: &'a PlanningSet,
    /// One wrench map per instant; those without a row may be empty.
    pub maps: &'a [WrenchMap],
    /// The commanded wrench at both ends of every interval, if rotors lag and rows are those of [`Self::program`].
    pub commands: Option<&'a CommandMaps>,
    /// The axes planned here: all four, or only x, y, z where yaw was planned first.
    pub axes: &'a [usize],
    /// The derivative of each axis that is its input; see `WrenchModel::orders`.
    pub orders: [usize; 4],
    /// Instants per interval at which rows can be imposed; 1 if they are imposed at nodes only.
    pub parts: usize,
    /// Of a branch after a fault: where it begins and ends. See [`crate::planner::branch`].
    pub branch: Option<Branch>,
    /// The position at each instant (m) about which distances from bodies are linearised.
    pub positions: Option<&'a [[f64; 3]]>,
    /// The environment in each of the extreme winds that are possible.
    pub(super) winds: Vec<Environment>,
    /// The states at the nodes about which a yaw that follows from the motion is linearised.
    pub states: Option<&'a [NodeState]>,
    /// By leg the index of the variable of its duration; `None` where that is fixed. Empty where all are.
    pub(super) durations: &'a [Option<usize>],
    /// What counts beside (48).
    pub(super) comfort: Option<Comfort>,
    /// Unit of time of the scaled variables at each node, s.
    taus: Vec<f64>,
    form: Form,
}

/// What the variables are.
enum Form {
    /// Scaled derivatives at every node.
    Stages,
    /// Spline coefficients, for quadruple and double integrators, and by waypoint where legs may change their durations
    /// by different shares, the motion of its jump for each axis.
    Splines(Arc<[NodeSpline; 2]>, Vec<(usize, [JumpAt; 4])>),
}

/// The splines of quadruple and of double integrators over a time grid.
pub(super) fn splines(grid: &TimeGrid) -> Arc<[NodeSpline; 2]> {
    Arc::new([4, 2].map(|order| NodeSpline::new(&grid.node_times, order)))
}

impl<'a> Transcription<'a> {
    /// With stage variables.
    pub fn new(
        problem: Problem<'a>,
        grid: &'a TimeGrid,
        set: &'a PlanningSet,
        maps: &'a [WrenchMap],
        axes: &'a [usize],
    ) -> Self {
        Transcription {
            model: problem.model(),
            mission: problem.mission(),
            grid,
            set,
            maps,
            commands: None,
            axes,
            orders: ORDER,
            parts: 1,
            branch: None,
            positions: None,
            winds: problem.model().environment().corners(),
            states: None,
            durations: &[],
            comfort: None,
            taus: units::units_of_time(grid),
            form: Form::Stages,
        }
    }

    /// This transcription with rows on the commanded wrench, if rotors lag.
    pub fn with_commands(self, commands: Option<&'a CommandMaps>) -> Self {
        Transcription { commands, ..self }
    }

    /// This transcription with other integrators, and rows also between nodes.
    pub fn with_orders(self, orders: [usize; 4], parts: usize) -> Self {
        Transcription { orders, parts, ..self }
    }

    /// This transcription of a branch after a fault, if it is one.
    pub(super) fn branching_as(self, branch: Option<Branch>) -> Self {
        Transcription { branch, ..self }
    }

    /// This transcription with distances from bodies linearised about these positions (m), one per instant.
    pub(super) fn about(self, positions: Option<&'a [[f64; 3]]>) -> Self {
        Transcription { positions, ..self }
    }

    /// This transcription with a yaw that follows from the motion linearised about these states at the nodes.
    pub(super) fn about_states(self, states: Option<&'a [NodeState]>) -> Self {
        Transcription { states, ..self }
    }

    /// This transcription with durations of legs that may change: by leg the index of its variable.
    pub(super) fn with_durations(self, durations: &'a [Option<usize>]) -> Self {
        Transcription { durations, ..self }
    }

    /// This transcription with comfort in its cost.
    pub(super) fn with_comfort(self, comfort: Option<Comfort>) -> Self {
        Transcription { comfort, ..self }
    }

    /// This transcription for other bounds: limits and tolerances of `mission`, rows of `set`, each as many as before.
    pub(super) fn of_statements(self, mission: &'a Mission, set: &'a PlanningSet) -> Self {
        Transcription { mission, set, ..self }
    }

    /// This transcription in spline coefficients.
    pub fn in_splines(self) -> Self {
        let splines = splines(self.grid);
        Transcription { form: Form::Splines(splines, Vec::new()), ..self }
    }

    /// An estimate of the largest entry of the cost's matrix in spline coefficients: the contributions of coefficients
    /// a few steps apart cancel, so the solver loses digits where this is large. Zero with stage variables.
    pub(super) fn stiffness(&self) -> f64 {
        let Form::Splines(splines, _) = &self.form else { return 0.0 };
        let [quadruple, _] = &**splines;
        let step = self.grid.steps().fold(f64::INFINITY, f64::min);
        self.model.plan.snap_weight * step * quadruple.steepest().powi(2)
    }

    /// The spline of an axis among those for quadruple and double integrators.
    fn spline<'s>(&self, splines: &'s [NodeSpline; 2], axis: usize) -> &'s NodeSpline {
        &splines[usize::from(self.orders[axis] == 2)]
    }

    fn per_node(&self) -> usize {
        self.axes.iter().map(|&a| self.orders[a] + 1).sum()
    }

    pub(super) fn nodes(&self) -> usize {
        self.grid.nodes()
    }

    /// The number of instants at which rows can be imposed: the nodes, and those between them.
    pub fn instants(&self) -> usize {
        self.grid.intervals() * self.parts + 1
    }

    /// The number of variables without sigma and epsilons.
    pub fn variables(&self) -> usize {
        match &self.form {
            Form::Stages => self.nodes() * self.per_node(),
            Form::Splines(splines, _) => self.axes.iter().map(|&a| self.spline(splines, a).coefficients()).sum(),
        }
    }

    /// Unit of time of the scaled variables at a node, s.
    pub(crate) fn tau_at(&self, node: usize) -> f64 {
        self.taus[node]
    }

    /// The unit of time of a mean step, s.
    pub(super) fn mean_tau(&self) -> f64 {
        units::mean_unit(self.grid)
    }

    pub(crate) fn taus(&self) -> Vec<f64> {
        self.taus.clone()
    }

    pub(super) fn var(&self, node: usize, axis: usize, order: usize) -> usize {
        let before: usize = self.axes.iter().take_while(|&&a| a != axis).map(|&a| self.orders[a] + 1).sum();
        node * self.per_node() + before + order
    }

    /// The derivative at an instant, in SI units, as an expression.
    pub(super) fn derivative(&self, instant: usize, axis: usize, order: usize) -> Affine {
        let (interval, part) = (instant / self.parts, instant % self.parts);
        match part {
            0 => self.at_node(interval, axis, order),
            _ => self.inside(interval, part as f64 / self.parts as f64, axis, order),
        }
    }

    /// The derivative `share` of the way through an interval, where the input's slope is constant; each variable once.
    pub(super) fn inside(&self, interval: usize, share: f64, axis: usize, order: usize) -> Affine {
        let times = &self.grid.node_times;
        let t = share * (times[interval + 1] - times[interval]);
        let r = self.orders[axis];
        let mut sum = Affine { terms: Vec::with_capacity(r + 2), constant: 0.0 };
        let mut power = 1.0;
        for j in order..=r {
            sum.gather(&self.at_beginning(interval, axis, j), power);
            power *= t / (j + 1 - order) as f64;
        }
        // power is now t^(m+1)/(m+1)!, m = r - order; the slope of the input is (u1 - u0) share / t.
        sum.gather(&self.at_beginning(interval, axis, r), -power * share / t);
        sum.gather(&self.at_node(interval + 1, axis, r), power * share / t);
        sum
    }

    /// The thrust over mass at an instant, `a + g e_z + drag/m (v - wind)`, m/s^2.
    pub(super) fn thrust(&self, instant: usize, environment: &Environment) -> [Affine; 3] {
        [X, Y, Z].map(|axis| {
            let gravity = if axis == Z { environment.gravity } else { 0.0 };
            let wind = environment.turning_rate() * environment.wind[axis];
            self.in_air(environment, axis, 2, |order| self.derivative(instant, axis, order))
                .plus_constant(gravity - wind)
        })
    }

    /// A derivative of the thrust over mass, without its constants: see [`crate::motion::in_air`]. `derivative` gives
    /// those of the motion on the same axis.
    pub(super) fn in_air(
        &self,
        environment: &Environment,
        axis: usize,
        order: usize,
        derivative: impl Fn(usize) -> Affine,
    ) -> Affine {
        let mut sum = derivative(order);
        if environment.has_drag() && axis != YAW && order >= 2 {
            sum.add(&derivative(order - 1), environment.turning_rate());
        }
        sum
    }

    /// The derivative at a node.
    pub(super) fn at_node(&self, node: usize, axis: usize, order: usize) -> Affine {
        match &self.form {
            Form::Stages => Affine::term(self.var(node, axis, order), self.tau_at(node).powi(-(order as i32))),
            Form::Splines(splines, jumps) => {
                let before = self.axes.iter().take_while(|&&a| a != axis);
                let first: usize = before.map(|&a| self.spline(splines, a).coefficients()).sum();
                let weights = self.spline(splines, axis).at(node, order);
                let mut sum = Affine { terms: weights.iter().map(|&(i, w)| (first + i, w)).collect(), constant: 0.0 };
                for (waypoint, motions) in jumps {
                    let motion = motions[axis].at(node, order);
                    if motion != 0.0 {
                        sum.add(&self.changes_of_jump(*waypoint), motion);
                    }
                }
                sum
            }
        }
    }

    /// The leg that an instant belongs to; at a waypoint the one that ends there.
    pub(super) fn leg_of(&self, instant: usize) -> usize {
        let interval = instant.saturating_sub(1) / self.parts;
        let after = self.grid.segments.partition_point(|s| s.first_node <= interval);
        self.grid.segments[after - 1].from
    }

    /// The number of variables for durations.
    pub(super) fn changes(&self) -> usize {
        self.durations.iter().flatten().max().map_or(0, |most| most + 1)
    }

    /// The change of the duration of a leg; nothing where durations are fixed.
    pub(super) fn duration_change(&self, leg: usize) -> Affine {
        let index = self.durations.get(leg).copied().flatten();
        index.map_or(Affine::default(), |i| Affine::term(self.variables() + 1 + i, 1.0))
    }

    pub(super) fn plans(&self, axis: usize) -> bool {
        self.axes.contains(&axis)
    }

    /// Every row that row generation may leave out. There may be more than fit in memory.
    pub(crate) fn each_row(&self) -> impl Iterator<Item = RowAt> {
        let inequalities = || (0..self.set.rows.len()).filter(|&f| !self.set.rows[f].equality);
        let at_each = |row: Row| (0..self.instants()).map(move |instant| RowAt { row, instant });
        // A program of yaw alone has no rows of the other limits, of which there may be thousands.
        let limits = self.mission.limits.iter().enumerate().filter(|(_, l)| self.plans(X) || l.kind.is_of_yaw());
        let limits = limits.flat_map(move |(index, limit)| {
            at_each(Row::Limit(index)).filter(move |row| self.covers(limit, row.instant))
        });
        let places = self.commands.into_iter().flat_map(BTreeMap::keys);
        let commands = places.flat_map(move |&(instant, slope)| {
            inequalities().map(move |facet| RowAt { row: Row::Command { facet, slope }, instant })
        });
        inequalities().map(Row::Facet).flat_map(at_each).chain(limits).chain(commands)
    }

    /// The rows of `each_row`.
    pub fn every_row(&self) -> Vec<RowAt> {
        self.each_row().collect()
    }

    /// The program with every row.
    pub fn full_program(&self, purpose: Purpose) -> QuadraticProgram {
        self.program(purpose, &self.every_row())
    }

    /// The program with the facets and limits in `chosen`, and all equality rows of the set.
    pub fn program(&self, purpose: Purpose, chosen: &[RowAt]) -> QuadraticProgram {
        self.program_with(purpose, chosen, None)
    }

    /// The program without the set: the limits in `chosen`, and thrust m |a + g| up to `most`, N.
    pub(super) fn relaxed_program(&self, purpose: Purpose, chosen: &[RowAt], most: f64) -> QuadraticProgram {
        self.program_with(purpose, chosen, Some(most))
    }

    fn program_with(&self, purpose: Purpose, chosen: &[RowAt], thrust: Option<f64>) -> QuadraticProgram {
        let sigma = self.variables();
        let extra = usize::from(!matches!(purpose, Purpose::Plan { .. }));
        let widening = match purpose {
            Purpose::Violation { .. } => Affine::term(sigma, 1.0),
            _ => Affine::constant(0.0),
        };
        let mut builder = Builder::new(self.variables() + extra);
        self.dynamics(&mut builder);
        self.rest(&mut builder);
        let mut wrenches: BTreeMap<usize, WrenchExpression> = BTreeMap::new();
        let mut along = |instant: usize, n: &Wrench| {
            wrenches.entry(instant).or_insert_with(|| self.wrench_expression(instant)).along(n)
        };
        let mut commands: BTreeMap<CommandAt, Option<WrenchExpression>> = BTreeMap::new();
        for (facet, row) in self.set.rows.iter().enumerate().filter(|(_, r)| r.equality && thrust.is_none()) {
            for node in 0..self.nodes() {
                let expression = along(node * self.parts, &row.normal).plus_constant(-row.offset);
                builder.zero(expression, RowOrigin::Facet { facet, node });
            }
        }
        for &RowAt { row, instant } in chosen {
            let node = instant / self.parts;
            match row {
                Row::Facet(facet) => {
                    let row = &self.set.rows[facet];
                    if let Some(core) = &row.core {
                        let scaling = Scaling { change: &Affine::default(), order: 0.0 };
                        self.core(&mut builder, CoreAt { row, core, facet, instant }, &widening, scaling);
                        continue;
                    }
                    let mut expression = along(instant, &-row.normal).plus_constant(row.offset);
                    expression.add(&widening, 1.0);
                    builder.nonnegative(expression, RowOrigin::Facet { facet, node });
                }
                Row::Limit(limit) => self.limit(&mut builder, limit, instant, &Widening::by(&widening)),
                Row::Upright => self.upright(&mut builder, instant, &Widening::by(&widening)),
                Row::Command { facet, slope } => {
                    let (row, at) = (&self.set.rows[facet], (instant, slope));
                    let map = self.commands.and_then(|commands| commands.get(&at));
                    let command = commands.entry(at).or_insert_with(|| self.command_expression(map?, at));
                    // Rows that come from another grid may lie outside all intervals.
                    let Some(command) = command else { continue };
                    let mut expression = command.along(&-row.normal).plus_constant(row.offset);
                    expression.add(&widening, 1.0);
                    builder.nonnegative(expression, RowOrigin::Lag { facet, node, after: slope == Slope::After });
                }
            }
        }
        if let Some(most) = thrust.filter(|t| t.is_finite()) {
            let environment = self.model.environment();
            for node in 0..self.nodes() {
                let mut cone = vec![Affine::constant(most / self.model.vehicle.mass)];
                cone.extend(self.thrust(node * self.parts, &environment));
                builder.cone(cone, RowOrigin::Thrust { node });
            }
        }
        match purpose {
            Purpose::Violation { epsilon, least } => {
                self.waypoints(&mut builder, &Affine::constant(0.0));
                builder.nonnegative(Affine::term(sigma, 1.0).plus_constant(-least), RowOrigin::Violation);
                builder.linear(sigma, 1.0);
                self.cost(&mut builder, epsilon);
            }
            Purpose::Plan { slack } => {
                self.waypoints(&mut builder, &Affine::constant(slack));
                self.cost(&mut builder, 1.0);
            }
            Purpose::Overshoot { epsilon } => {
                self.waypoints(&mut builder, &Affine::term(sigma, 1.0));
                let smallest = self.mission.waypoints.iter().map(|w| w.within).fold(f64::INFINITY, f64::min);
                builder.nonnegative(Affine::term(sigma, 1.0).plus_constant(0.9 * smallest), RowOrigin::Overshoot);
                builder.linear(sigma, 1.0);
                self.cost(&mut builder, epsilon);
            }
        }
        builder.finish()
    }

    /// The variables of a program at which the nodes have these states, for a motion whose pieces join; zero for those
    /// that are not derivatives.
    pub(super) fn variables_of(&self, states: &[NodeState], program: &QuadraticProgram) -> Vec<f64> {
        let mut variables: Vec<f64> = match &self.form {
            Form::Stages => {
                let of_node = |(node, state): (usize, &NodeState)| {
                    let tau = self.tau_at(node);
                    let orders = self.axes.iter().flat_map(|&axis| (0..=self.orders[axis]).map(move |m| (axis, m)));
                    orders.map(|(axis, m)| state[axis][m] * tau.powi(m as i32)).collect::<Vec<_>>()
                };
                states.iter().enumerate().flat_map(of_node).collect()
            }
            Form::Splines(splines, _) => {
                let of_axis =
                    |&axis: &usize| self.spline(splines, axis).coefficients_of(|node, order| states[node][axis][order]);
                self.axes.iter().flat_map(of_axis).collect()
            }
        };
        variables.resize(program.q.len(), 0.0);
        variables
    }

    /// The derivatives at every node, SI units; axes not planned here are left zero.
    pub fn states(&self, x: &[f64]) -> Vec<NodeState> {
        let mut states = vec![NodeState::default(); self.nodes()];
        for (node, state) in states.iter_mut().enumerate() {
            for &axis in self.axes {
                for (order, value) in state[axis].iter_mut().enumerate().take(self.orders[axis] + 1) {
                    *value = self.at_node(node, axis, order).at(x);
                }
            }
        }
        // Derivatives that rows make zero are zero exactly, without the solver's residual.
        for (node, axis, order) in self.at_rest() {
            states[node][axis][order] = 0.0;
        }
        states
    }
}

/// A tolerance this wide constrains nothing and gets no row, m or rad: the widest that a spec may have, a thousand
/// times further than a waypoint may lie from the origin.
pub const UNBOUNDED: f64 = 1e9;
