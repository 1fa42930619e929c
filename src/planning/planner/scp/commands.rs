//! Rotors that lag, in the subproblems: the planning set's facets for the commanded wrench c = w + tau w'. The
//! commanded wrench jumps where the slope of the inputs does, so a node has rows for both its sides. Equalities of a
//! flat set are not repeated: where w stays in a plane, w' does too.

use super::iterate::Iterate;
use super::tightening::peaks;
use super::{PARTS, ScpPlanner};
use crate::actuation::Wrench;
use crate::flatness::CommandFlatState;
use crate::motion::NodeState;
use crate::motion::hover_map::WrenchMap;
use crate::motion::winds::OverWinds;
use crate::motion::wrench_model::COMMAND_DERIVATIVES;
use crate::motion::{CommandState, with_slopes};
use crate::planner::commands::{CommandAt, Slope, interval_of};
use crate::planner::scp::subproblem::{ORDER_OF_TIME, Step, without_wind};
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::planner::wrench_expression::WrenchExpression;
use crate::qp::build::{Affine, Builder};
use std::collections::{BTreeMap, BTreeSet};

/// What the planner keeps from one step to the next for rotors that lag.
pub(super) struct Lag {
    /// Time constant of the rotors, s.
    tau: f64,
    /// Further tightening of each row of the set for the commanded wrench, where it is violated between the instants.
    pub local_tightening: Vec<f64>,
    /// Of the last subproblem: the sum of multiplier times normal of the rows on the commanded wrench, by their place.
    pub multipliers: BTreeMap<CommandAt, Wrench>,
}

impl Lag {
    pub fn new(tau: f64, set: &PlanningSet) -> Self {
        Lag { tau, local_tightening: vec![0.0; set.rows.len()], multipliers: BTreeMap::new() }
    }
}

/// The commanded wrench linearised about an iterate at one place.
struct LinearisedCommand {
    map: WrenchMap,
    /// N and N m.
    wrench: Wrench,
    /// Change per relative change of the duration.
    time_sensitivity: Wrench,
    in_winds: OverWinds,
}

/// The commanded wrench about an iterate, for one subproblem.
pub(super) struct CommandLinearisation {
    linearised: BTreeMap<CommandAt, LinearisedCommand>,
    /// The tightening of rows between instants; see [`Lag::local_tightening`].
    local_tightening: Vec<f64>,
    /// Curvature of the Lagrangian, as in [`Step::curvature`], over [`COMMAND_DERIVATIVES`].
    curvature: Vec<(CommandAt, CommandState, Vec<CommandFlatState>)>,
}

impl ScpPlanner<'_, '_> {
    /// A state of an iterate within an interval, with the slopes of the inputs there.
    fn sloped(&self, iterate: &Iterate, interval: usize, state: &NodeState) -> CommandState {
        let times = &iterate.grid.node_times;
        let ends = [&iterate.states[interval], &iterate.states[interval + 1]];
        with_slopes(state, ends, times[interval + 1] - times[interval], self.wrench.orders())
    }

    /// The derivatives of an iterate where a commanded wrench is taken; `None` where there is no such interval.
    fn command_state(&self, iterate: &Iterate, at: CommandAt) -> Option<CommandState> {
        let interval = interval_of(at, PARTS, iterate.grid.intervals())?;
        Some(self.sloped(iterate, interval, &iterate.at(at.0)))
    }

    /// The commanded wrench of a state in every possible wind, N and N m.
    fn command_at(&self, lag: &Lag, state: &CommandState) -> OverWinds {
        OverWinds::of_commands(self.wrench, &self.model().vehicle, &self.environment, lag.tau, state)
    }

    /// The violation of each row of the set by the commanded wrench, with its local tightening.
    fn command_violations<'s>(&'s self, lag: &'s Lag, state: &CommandState) -> impl Iterator<Item = f64> + 's {
        let wrench = self.command_at(lag, state);
        self.set.rows.iter().zip(&lag.local_tightening).enumerate().map(move |(facet, (row, tightening))| {
            match row.equality {
                true => f64::NEG_INFINITY,
                false => self.violation_of_facet(facet, &wrench) + tightening,
            }
        })
    }

    /// The largest violation by the commanded wrench at an instant, on both its sides; minus infinity where no rotor
    /// lags.
    pub(super) fn command_violation_at(&self, iterate: &Iterate, instant: usize) -> f64 {
        let Some(lag) = &self.lag else { return f64::NEG_INFINITY };
        let sides = [Slope::Before, Slope::After].into_iter();
        let states = sides.filter_map(|slope| self.command_state(iterate, (instant, slope)));
        states
            .flat_map(|state| self.command_violations(lag, &state).collect::<Vec<_>>())
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// The violation of one row by the commanded wrench, without tightening.
    pub(super) fn command_violation_of(&self, iterate: &Iterate, facet: usize, at: CommandAt) -> f64 {
        let Some((lag, state)) = self.lag.as_ref().zip(self.command_state(iterate, at)) else {
            return f64::NEG_INFINITY;
        };
        self.violation_of_facet(facet, &self.command_at(lag, &state))
    }

    /// Rows on the commanded wrench with a violation over `threshold`, on both sides of a node.
    pub(super) fn command_rows_at_node(&self, iterate: &Iterate, node: usize, threshold: f64) -> Vec<RowAt> {
        let Some(lag) = &self.lag else { return Vec::new() };
        let instant = node * PARTS;
        let mut found = Vec::new();
        for slope in [Slope::Before, Slope::After] {
            let Some(state) = self.command_state(iterate, (instant, slope)) else { continue };
            let over = self.command_violations(lag, &state).enumerate().filter(|(_, e)| *e > threshold);
            found.extend(over.map(|(facet, _)| RowAt { row: Row::Command { facet, slope }, instant }));
        }
        found
    }

    /// Within an interval each row that the commanded wrench violates, at the instant of its largest violation.
    pub(super) fn command_rows_between(&self, iterate: &Iterate, interval: usize) -> Vec<RowAt> {
        let Some(lag) = &self.lag else { return Vec::new() };
        let mut worst: Vec<(f64, usize)> = vec![(0.0, 0); self.set.rows.len()];
        for instant in interval * PARTS + 1..(interval + 1) * PARTS {
            let state = self.sloped(iterate, interval, &iterate.at(instant));
            for (worst, violation) in worst.iter_mut().zip(self.command_violations(lag, &state)) {
                if violation > worst.0 {
                    *worst = (violation, instant);
                }
            }
        }
        let violated = worst.into_iter().enumerate().filter(|(_, w)| w.0 > 0.0);
        let row = |facet| Row::Command { facet, slope: Slope::After };
        violated.map(|(facet, (_, instant))| RowAt { row: row(facet), instant }).collect()
    }

    /// The largest violation of each row by the commanded wrench on the finer grid of
    /// `TighteningSettings::parts` and between its points, without tightening.
    pub(super) fn commands_between_instants(&self, iterate: &Iterate) -> Vec<f64> {
        let Some(lag) = &self.lag else { return Vec::new() };
        let mut worst = vec![f64::NEG_INFINITY; self.set.rows.len()];
        let parts = PARTS * self.settings.tightening.parts;
        for interval in 0..iterate.grid.intervals() {
            let violations = |part: usize| -> Vec<f64> {
                let state = self.sloped(iterate, interval, &iterate.inside(interval, part as f64 / parts as f64));
                let untightened = self.command_violations(lag, &state).zip(&lag.local_tightening).map(|(v, by)| v - by);
                untightened.collect()
            };
            peaks(parts, violations, |facet, _, violation| worst[facet] = worst[facet].max(violation));
        }
        worst
    }

    /// The commanded wrench linearised about an iterate where `working_set` has rows on it; `None` where no rotor lags.
    pub(super) fn linearise_commands(
        &self,
        iterate: &Iterate,
        working_set: &BTreeSet<RowAt>,
    ) -> Option<CommandLinearisation> {
        let lag = self.lag.as_ref()?;
        let vehicle = &self.model().vehicle;
        let mut linearised = BTreeMap::new();
        for &RowAt { row, instant } in working_set {
            let Row::Command { slope, .. } = row else { continue };
            let at = (instant, slope);
            let Some(state) = self.command_state(iterate, at).filter(|_| !linearised.contains_key(&at)) else {
                continue;
            };
            let map = self.wrench.commanded_linearised(vehicle, &self.environment, lag.tau, &state);
            let change = |sum: Wrench, &(axis, order, c): &(usize, usize, Wrench)| {
                let order: usize = order;
                sum - c * (order as f64 * state[axis][order])
            };
            let time_sensitivity = map.terms.iter().fold(Wrench::zeros(), change);
            let in_winds = self.command_at(lag, &state);
            linearised.insert(at, LinearisedCommand { wrench: map.at(&state), time_sensitivity, map, in_winds });
        }
        let unit = self.transcription(&iterate.grid, &[]).mean_tau();
        let curvature = lag.multipliers.iter().filter_map(|(&at, n)| {
            let state = self.command_state(iterate, at)?;
            Some((at, state, self.wrench.commanded_curvature(vehicle, &self.environment, lag.tau, &state, n, unit)))
        });
        Some(CommandLinearisation {
            linearised,
            local_tightening: lag.local_tightening.clone(),
            curvature: curvature.collect(),
        })
    }
}

impl Transcription<'_> {
    /// The row (71) for the commanded wrench, without sigma; `known` holds the expressions made before.
    pub(super) fn command_row(
        &self,
        step: &Step,
        facet: usize,
        at: CommandAt,
        known: &mut BTreeMap<CommandAt, Option<WrenchExpression>>,
    ) -> Option<Affine> {
        let commands = step.commands?;
        let linearised = commands.linearised.get(&at)?;
        let row = &self.set.rows[facet];
        let command = known.entry(at).or_insert_with(|| self.command_expression(&linearised.map, at)).as_ref()?;
        let kept = step.tightening[facet] + commands.local_tightening[facet] + linearised.in_winds.more_in_winds(row);
        let mut slack = command.along(&-row.normal).plus_constant(row.offset - kept);
        let free = row.offset - row.normal.dot(&linearised.wrench);
        let change = ORDER_OF_TIME * free - row.normal.dot(&linearised.time_sensitivity);
        let interval = interval_of(at, self.parts, self.grid.intervals())?;
        slack.add(&self.duration_change(self.leg_of(interval * self.parts + 1)), change);
        Some(slack)
    }

    /// Adds the curvature of the Lagrangian by rows on the commanded wrench to the objective.
    pub(super) fn add_curvature_of_commands(&self, builder: &mut Builder, commands: &CommandLinearisation) {
        for (at, from, factors) in &commands.curvature {
            let direction = |&(axis, order): &(usize, usize)| {
                // There is such an interval for all derivatives or for none.
                self.command_derivative(*at, axis, order)?;
                let derivative = |order| self.command_derivative(*at, axis, order).unwrap_or_default();
                let now = self.in_air(&self.winds[0], axis, order, derivative);
                Some(now.plus_constant(-without_wind(from, &self.winds[0])[axis][order]))
            };
            let Some(directions) = COMMAND_DERIVATIVES.iter().map(direction).collect::<Option<Vec<Affine>>>() else {
                continue;
            };
            let change = |factor: &CommandFlatState| {
                let mut change = Affine::default();
                for (direction, weight) in directions.iter().zip(factor.iter()) {
                    change.add(direction, *weight);
                }
                change
            };
            let changes: Vec<Affine> = factors.iter().map(change).collect();
            builder.squares(&changes, 0.5);
        }
    }
}
