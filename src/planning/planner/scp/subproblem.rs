//! The convex subproblem (73) of one step: the wrench linear about the last iterate, durations free or fixed.
//!
//! Variables are the derivatives at the nodes as if no duration changed, the violation sigma, and epsilon for each leg
//! whose duration may change. With its relative change delta, (1 + delta)^4 = 1 + 4 epsilon (69), so delta = epsilon to
//! first order. A derivative of order m in the new time is D (1 + delta)^-m, so the wrench along the leg changes by -m
//! dw/dD D epsilon to first order (70). Rows are multiplied by 1 + 4 epsilon (71); by this factor the snap, whose
//! torques bind first, enters without linearisation error. Where many facets hold at an instant, these rows have
//! variables of their own for the wrench ([`super::wrench_variables`]).

use super::settings::ScpSettings;
use super::wrench_variables::WrenchVariables;
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::flatness::FlatState;
use crate::model::Environment;
use crate::motion::wrench_model::DIRECTIONS;
use crate::motion::{NodeState, X, Y, YAW, Z, in_air};
use crate::planner::commands::{CommandAt, Slope};
use crate::planner::cores::{CoreAt, Scaling};
use crate::planner::limits::{Growth, Widening};
use crate::planner::scp::commands::CommandLinearisation;
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::planner::wrench_expression::WrenchExpression;
use crate::qp::build::{Affine, Builder};
use crate::qp::{Cone, QuadraticProgram, RowOrigin};
use std::collections::BTreeMap;
use std::ops::Range;

/// What a subproblem minimises; all objectives are relative and of order one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Objective {
    /// The shortest time.
    Time,
    /// The smallest violation.
    Violation,
    /// The smallest cost (48).
    Cost,
}

/// All that one subproblem depends on, except its rows.
pub struct Step<'s> {
    pub settings: &'s ScpSettings,
    pub objective: Objective,
    /// The iterate: derivatives at the nodes.
    pub from: &'s [NodeState],
    /// The wrench per instant, and its change per relative change of the duration; where there are rows.
    pub wrenches: &'s [Wrench],
    pub time_sensitivities: &'s [Wrench],
    /// Curvature of the Lagrangian: at each instant squares |factor . (s' - s)|^2 / 2 to be added to the objective.
    pub curvature: &'s [(usize, NodeState, Vec<FlatState>)],
    /// rho in (73): weight of the squared relative change of accelerations.
    pub proximal_weight: f64,
    /// Weight of the squared relative change of inputs; see [`super::settings::ProximalSettings::input_weight`].
    pub input_weight: f64,
    /// mu in (73): weight of the violation.
    pub penalty: f64,
    /// kappa in (73): weight of the cost (48), relative to that of the last iterate.
    pub cost_weight: f64,
    /// Least and largest relative change of a duration.
    pub range: (f64, f64),
    /// Whether bounds grow with durations to first order only, as sensitivities need it, and not below their true
    /// growth; see [`Growth`].
    pub to_first_order: bool,
    /// Legs whose durations keep their sum; see [`super::Durations::spans`].
    pub spans: &'s [Range<usize>],
    /// The tightening of each row of the set, in widths of the healthy set.
    pub tightening: &'s [f64],
    /// The further tightening of each chosen row.
    pub local_tightening: &'s [f64],
    /// Where rotors lag.
    pub commands: Option<&'s CommandLinearisation>,
}

/// The highest derivative that the wrench depends on.
pub const ORDER_OF_TIME: f64 = 4.0;

/// Bounds on derivatives from order 1 to this one grow less than linearly with epsilon.
const ORDERS_OF_BOUNDS: usize = 3;

/// The relative change delta of a duration for a value of its variable epsilon (69).
pub fn change(epsilon: f64) -> f64 {
    (1.0 + ORDER_OF_TIME * epsilon).max(0.0).powf(1.0 / ORDER_OF_TIME) - 1.0
}

/// The inverse of [`change`].
fn variable(change: f64) -> f64 {
    ((1.0 + change).powf(ORDER_OF_TIME) - 1.0) / ORDER_OF_TIME
}

/// A state [`in_air`] without the constant that the wind adds, like [`Transcription::in_air`].
pub(super) fn without_wind<const N: usize>(state: &[[f64; N]; 4], environment: &Environment) -> [[f64; N]; 4] {
    in_air(state, &Environment { wind: [0.0; 3], ..*environment })
}

impl Transcription<'_> {
    /// The subproblem with the rows `chosen` and, at all nodes, the set's equality rows. Also, for each facet in
    /// `chosen`, the index of its row in the program, on the wrench or the commanded wrench.
    pub(super) fn step_program(&self, step: &Step, chosen: &[RowAt]) -> (QuadraticProgram, Vec<Option<usize>>) {
        let sigma = self.variables();
        let violation = Affine::term(sigma, 1.0);
        let before = sigma + 1 + self.changes() * if step.to_first_order { 1 } else { 1 + ORDERS_OF_BOUNDS };
        let variables = WrenchVariables::of(chosen, self.set, step.settings.subproblem.many_facets, before);
        let mut builder = Builder::new(variables.end());
        self.dynamics(&mut builder);
        self.rest(&mut builder);
        self.waypoints(&mut builder, &Affine::constant(0.0));
        self.turns_no_further(&mut builder);
        if self.comfort.is_some_and(|comfort| comfort.keeps_heights) {
            self.keeps_heights(&mut builder);
        }
        builder.nonnegative(violation.clone(), RowOrigin::Violation);
        // The row times (1 + delta)^4 = 1 + 4 epsilon: n.w (1 + 4 epsilon) <= e (1 + 4 epsilon).
        let mut wrenches: BTreeMap<usize, WrenchExpression> = BTreeMap::new();
        let mut commands: BTreeMap<CommandAt, Option<WrenchExpression>> = BTreeMap::new();
        let mut slack = |instant: usize, row: &SetRow| {
            if let Some(slack) = self.slack_in(&variables, step, instant, row) {
                return slack;
            }
            let wrench = wrenches.entry(instant).or_insert_with(|| self.wrench_expression(instant));
            let mut slack = wrench.along(&-row.normal).plus_constant(row.offset);
            let free = row.offset - row.normal.dot(&step.wrenches[instant]);
            let change = ORDER_OF_TIME * free - row.normal.dot(&step.time_sensitivities[instant]);
            slack.add(&self.duration_change(self.leg_of(instant)), change);
            slack
        };
        for (facet, row) in self.set.rows.iter().enumerate().filter(|(_, r)| r.equality) {
            for node in 0..self.nodes() {
                for side in [1.0, -1.0] {
                    let mut expression = violation.clone().plus_constant(-step.tightening[facet]);
                    expression.add(&slack(node * self.parts, row), side);
                    builder.nonnegative(expression, RowOrigin::Facet { facet, node });
                }
            }
        }
        let margin = step.settings.tightening.margin;
        let widening = |instant: usize, tightening: f64| {
            let free = violation.clone().plus_constant(-margin - tightening);
            let growth = self.growth(self.leg_of(instant), step);
            let first = instant / self.parts;
            let beside = step.from[first..].iter().take(2);
            let room = beside.map(|state| self.room(instant, state)).fold(0.0, f64::max);
            Widening::by(&free).with_growth(growth).with_room(room).with_inset(tightening)
        };
        let mut places = Vec::with_capacity(chosen.len());
        for (&RowAt { row, instant }, &local) in chosen.iter().zip(step.local_tightening) {
            // The multiplier of a cone weighs no normal.
            let is_plane = match row {
                Row::Facet(facet) => self.set.rows[facet].core.is_none(),
                Row::Command { .. } => true,
                Row::Limit(_) | Row::Upright => false,
            };
            places.push(is_plane.then(|| builder.inequalities()));
            match row {
                Row::Facet(facet) => {
                    let free = step.tightening[facet] + local;
                    if let Some(core) = &self.set.rows[facet].core {
                        let free = violation.clone().plus_constant(-free);
                        let change = self.duration_change(self.leg_of(instant));
                        let at = CoreAt { row: &self.set.rows[facet], core, facet, instant };
                        self.core(&mut builder, at, &free, Scaling { change: &change, order: ORDER_OF_TIME });
                        continue;
                    }
                    let mut expression = violation.clone().plus_constant(-free);
                    expression.add(&slack(instant, &self.set.rows[facet]), 1.0);
                    builder.nonnegative(expression, RowOrigin::Facet { facet, node: instant / self.parts });
                }
                Row::Limit(limit) => {
                    self.limit(&mut builder, limit, instant, &widening(instant, local));
                }
                Row::Upright => self.upright(&mut builder, instant, &widening(instant, local)),
                Row::Command { facet, slope } => {
                    // Where there is no such interval, an empty row keeps the indices in order.
                    let mut expression =
                        self.command_row(step, facet, (instant, slope), &mut commands).unwrap_or_default();
                    expression.add(&violation, 1.0);
                    let node = instant / self.parts;
                    builder.nonnegative(expression, RowOrigin::Lag { facet, node, after: slope == Slope::After });
                }
            }
        }
        self.wrench_equations(&mut builder, &variables, step);
        self.durations(&mut builder, step);
        self.add_proximal_term(&mut builder, step);
        builder.linear(sigma, step.penalty);
        if step.cost_weight > 0.0 {
            self.cost(&mut builder, step.cost_weight / self.cost_of(step.from).max(f64::MIN_POSITIVE));
        }
        if self.branch.is_some() {
            self.distances(&mut builder, step.settings.stops.pull_of_place);
        }
        let program = builder.finish();
        let equal = match program.cones.first() {
            Some(Cone::Zero(rows)) => *rows,
            _ => 0,
        };
        places.iter_mut().flatten().for_each(|place| *place += equal);
        (program, places)
    }

    /// Durations change within the step's range, those of each span keep their sum, and where the objective is the time
    /// each counts by its share.
    fn durations(&self, builder: &mut Builder, step: &Step) {
        for segment in self.grid.segments.iter() {
            let leg = segment.from;
            if self.durations[leg].is_none() || self.durations[..leg].contains(&self.durations[leg]) {
                continue;
            }
            let change = self.duration_change(leg);
            let (least, most) = (variable(step.range.0), variable(step.range.1));
            if !step.to_first_order {
                self.growth_of_bounds(builder, leg, [least, most]);
            }
            if least == most {
                builder.zero(change.plus_constant(-least), RowOrigin::Duration { leg });
            } else {
                builder.nonnegative(change.clone().plus_constant(-least), RowOrigin::Duration { leg });
                builder.nonnegative(change.times(-1.0).plus_constant(most), RowOrigin::Duration { leg });
            }
        }
        let duration = |leg: usize| self.grid.segments[leg].duration;
        for span in step.spans.iter().filter(|span| self.durations[(*span).clone()].iter().any(Option::is_some)) {
            let whole: f64 = span.clone().map(duration).sum();
            let mut sum = Affine::constant(0.0);
            span.clone().for_each(|leg| sum.add(&self.duration_change(leg), duration(leg) / whole));
            builder.zero(sum, RowOrigin::Duration { leg: span.end - 1 });
        }
        if step.objective == Objective::Time {
            for segment in &self.grid.segments {
                for (variable, share) in self.duration_change(segment.from).terms {
                    builder.linear(variable, share * segment.duration / self.grid.total);
                }
            }
        }
    }

    /// By how much the duration of a leg lets bounds grow; see [`Self::growth_of_bounds`].
    fn growth(&self, leg: usize, step: &Step) -> [Growth; 5] {
        let change = self.duration_change(leg);
        let tangent = |order: usize| change.clone().times(order as f64);
        std::array::from_fn(|order| match self.growth_variable(leg, order).filter(|_| !step.to_first_order) {
            Some(variable) => Growth { at_most: Affine::term(variable, 1.0), at_least: tangent(order) },
            None => Growth { at_most: tangent(order), at_least: tangent(order) },
        })
    }

    /// The variable of the growth of bounds on derivatives of an order from 1 to [`ORDERS_OF_BOUNDS`].
    fn growth_variable(&self, leg: usize, order: usize) -> Option<usize> {
        let index = self.durations.get(leg).copied().flatten()?;
        let first = self.variables() + 1 + self.changes() + ORDERS_OF_BOUNDS * index;
        (1..=ORDERS_OF_BOUNDS).contains(&order).then(|| first + order - 1)
    }

    /// The growth (1 + delta)^m - 1 = (1 + 4 epsilon)^(m/4) - 1 of bounds of orders m below 4 is concave in epsilon:
    /// it stays above its chords from each end of the range of epsilon to 0, and the variable stays below these.
    fn growth_of_bounds(&self, builder: &mut Builder, leg: usize, range: [f64; 2]) {
        for order in 1..=ORDERS_OF_BOUNDS {
            let Some(variable) = self.growth_variable(leg, order) else { continue };
            let origin = RowOrigin::Duration { leg };
            let at = |epsilon: f64| (1.0 + ORDER_OF_TIME * epsilon).powf(order as f64 / ORDER_OF_TIME) - 1.0;
            if range[0] == range[1] {
                builder.zero(Affine::term(variable, 1.0).plus_constant(-at(range[0])), origin);
                continue;
            }
            for end in range.into_iter().filter(|end| *end != 0.0) {
                let mut below = self.duration_change(leg).times(at(end) / end);
                below.add(&Affine::term(variable, 1.0), -1.0);
                builder.nonnegative(below, origin);
            }
            // From below too, so that no direction is without end.
            builder.nonnegative(Affine::term(variable, 1.0).plus_constant(-at(range[0])), origin);
        }
    }

    /// `factor . (s' - s)` for each factor of the curvature at an instant; see [`Step::curvature`].
    fn changes_along_factors(&self, instant: usize, from: &NodeState, factors: &[FlatState]) -> Vec<Affine> {
        let from = without_wind(from, &self.winds[0]);
        let direction = |(axis, order): (usize, usize)| {
            let now = self.in_air(&self.winds[0], axis, order, |order| self.derivative(instant, axis, order));
            now.plus_constant(-from[axis][order])
        };
        let directions = DIRECTIONS.map(direction);
        let change = |factor: &FlatState| {
            let mut change = Affine::default();
            for (direction, weight) in directions.iter().zip(factor.iter()) {
                change.add(direction, *weight);
            }
            change
        };
        factors.iter().map(change).collect()
    }

    /// The proximal term of the inputs, relative to their mean square, that of x, y and z together.
    ///
    /// The mean square counts as at least that of an input which within the mean duration of a leg builds up the least
    /// acceleration, or the unit of yaw, that the proximal term knows: relative to a line's inputs, which are rounding
    /// errors, no change would be small.
    fn add_proximal_term_of_inputs(&self, builder: &mut Builder, step: &Step) {
        let steps: Vec<f64> = self.grid.steps().collect();
        let square = |axis: usize, k: usize| {
            let [u0, u1] = [k, k + 1].map(|node| step.from[node][axis][self.orders[axis]]);
            (u0 * u0 + u0 * u1 + u1 * u1) / 3.0
        };
        let settings = &step.settings.proximal;
        let leg = self.grid.total / self.grid.segments.len() as f64;
        let acceleration = settings.min_acceleration * self.model.gravity;
        let groups =
            [(&[X, Y, Z][..], acceleration, self.orders[X] - 2), (&[YAW], settings.yaw_unit, self.orders[YAW])];
        for (group, unit, builds_up) in groups {
            let least = self.grid.total * (unit / leg.powi(builds_up as i32)).powi(2);
            let sum: f64 = group
                .iter()
                .flat_map(|&axis| steps.iter().enumerate().map(move |(k, h)| (axis, k, h)))
                .map(|(axis, k, h)| h * square(axis, k))
                .sum::<f64>()
                .max(least);
            for (k, h) in steps.iter().enumerate() {
                for &axis in group {
                    let order = self.orders[axis];
                    let [d0, d1] = [k, k + 1]
                        .map(|node| self.at_node(node, axis, order).plus_constant(-step.from[node][axis][order]));
                    let c = 0.5 * step.input_weight * h / 3.0 / sum;
                    builder.inner_product(&d0, &d0, c);
                    builder.inner_product(&d0, &d1, c);
                    builder.inner_product(&d1, &d1, c);
                }
            }
        }
    }

    /// The proximal terms and the curvature of the Lagrangian, the last three lines of (73). The first is in
    /// accelerations and psi, because the wrench is most curved in these.
    fn add_proximal_term(&self, builder: &mut Builder, step: &Step) {
        let (g, settings) = (self.model.gravity, &step.settings.proximal);
        let mut steps: Vec<f64> = self.grid.steps().collect();
        steps.push(0.0);
        // Instants of one interval share their variables.
        let interval = |instant: usize| instant.saturating_sub(1) / self.parts;
        for beside in step.curvature.chunk_by(|a, b| interval(a.0) == interval(b.0)) {
            let changes = |(instant, from, factors): &(usize, NodeState, Vec<FlatState>)| {
                self.changes_along_factors(*instant, from, factors)
            };
            let changes: Vec<Affine> = beside.iter().flat_map(changes).collect();
            builder.squares(&changes, 0.5);
        }
        if let Some(commands) = step.commands {
            self.add_curvature_of_commands(builder, commands);
        }
        if step.input_weight > 0.0 {
            self.add_proximal_term_of_inputs(builder, step);
        }
        let free: Vec<usize> = self.free_ends().collect();
        for (node, from) in step.from.iter().enumerate() {
            let around = 0.5 * (steps[node] + if node > 0 { steps[node - 1] } else { 0.0 });
            let (sin, cos) = from[YAW][0].sin_cos();
            let forward = cos * from[X][2] + sin * from[Y][2];
            let acceleration = forward.hypot(from[Z][2] + g).max(settings.min_acceleration * g);
            let share = 0.5 * step.proximal_weight * around / self.grid.total;
            let mut near = |axis: usize, order: usize, scale: f64| {
                let change = self.at_node(node, axis, order).plus_constant(-from[axis][order]);
                builder.squares(&[change], share / (scale * scale));
            };
            for axis in [X, Y, Z] {
                near(axis, 2, acceleration);
            }
            near(YAW, 0, settings.yaw_unit);
            // Values at all nodes leave a spline its slopes at the ends, from which it may oscillate between nodes.
            if free.contains(&node) {
                let beside = 2.0 * around;
                // Where the input is the acceleration, the values at the nodes determine it.
                for axis in [X, Y, Z].into_iter().filter(|&axis| self.orders[axis] > 2) {
                    near(axis, 3, acceleration / beside);
                }
                near(YAW, 1, settings.yaw_unit / beside);
            }
        }
    }
}
