//! What limits the time of a plan: the first-order sensitivity of the shortest time to each statement of the spec.
//!
//! One subproblem about the plan minimises the relative time. Its multipliers z give the decrease of the optimum when a
//! row is relaxed: with slacks s(x) = b - A x in the cone, d(optimum) = -z' ds (Boyd and Vandenberghe, *Convex
//! Optimization*, section 5.6). The change ds comes from the same program built for a spec that is relaxed by a unit
//! throughout, so that no scaling of rows enters here.

use super::subproblem::{Objective, Step};
use super::{PARTS, ScpPlanner};
use crate::model::{LimitKind, Mission};
use crate::motion::YAW;
use crate::planner::Planned;
use crate::planner::transcription::{RowAt, Transcription, splines};
use crate::qp::RowOrigin;
use crate::solve::{Solution, solve_step};
use std::collections::BTreeMap;

/// The unit by which limits and tolerances are relaxed, as a share of themselves, and sets, as a share of the healthy
/// set's width.
pub const SHARE: f64 = 0.01;

/// The unit by which limits on x, y and z, and volumes, are relaxed, m.
pub const PLACE: f64 = 0.1;
/// The unit by which limits on yaw are relaxed, rad: 1 degree.
pub const YAW_PLACE: f64 = std::f64::consts::PI / 180.0;
/// The unit by which rests are relaxed, m/s.
pub const SPEED: f64 = 0.1;

/// The statement of the spec that a row comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Statement {
    /// `Mission::limits[_]`.
    Limit(usize),
    /// A set: 0 of the healthy vehicle, k of mode k - 1.
    Set(usize),
    /// The set of a mode, for what lagging rotors are commanded.
    Commands(usize),
    /// The thrust points up.
    Upright,
    /// The position tolerance of `Mission::waypoints[_]`.
    Within(usize),
    /// Its yaw tolerance.
    YawWithin(usize),
    /// Rest there.
    Rest(usize),
}

/// What limits one leg.
#[derive(Debug, Clone, PartialEq)]
pub struct LegBinding {
    /// s
    pub duration: f64,
    /// Statements with the seconds that the mission would be shorter, to first order, if on this leg they were relaxed
    /// by a unit ([`SHARE`], [`PLACE`], [`YAW_PLACE`], [`SPEED`]); largest first. None up to the last fixed time.
    pub statements: Vec<(Statement, f64)>,
}

/// By what a limit is relaxed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// [`PLACE`]
    Position,
    /// [`YAW_PLACE`]
    Yaw,
    /// [`SHARE`] of its bound.
    Share,
}

impl Unit {
    pub fn of(kind: &LimitKind) -> Self {
        match (kind.is_of_place(), kind.is_of_yaw()) {
            (true, false) => Unit::Position,
            (true, true) => Unit::Yaw,
            (false, _) => Unit::Share,
        }
    }
}

/// The spec relaxed by a unit.
fn relaxed(mission: &Mission) -> Mission {
    let mut mission = mission.clone();
    for limit in &mut mission.limits {
        let room = |bound: f64| match Unit::of(&limit.kind) {
            Unit::Position => PLACE,
            Unit::Yaw => YAW_PLACE,
            Unit::Share => SHARE * bound.abs(),
        };
        (limit.upper, limit.lower) = (limit.upper.map(|u| u + room(u)), limit.lower.map(|l| l - room(l)));
    }
    for waypoint in &mut mission.waypoints {
        waypoint.within *= 1.0 + SHARE;
        waypoint.yaw_within *= 1.0 + SHARE;
    }
    mission
}

impl ScpPlanner<'_, '_> {
    /// What limits each leg of a plan whose time was searched for; `None` if the subproblem about it is not solved.
    pub fn binding(&mut self, planned: &Planned) -> Option<Vec<LegBinding>> {
        let iterate = self.iterate_of(planned);
        let settings = self.settings;
        let mut working_set = self.rows_at_nodes(&iterate, -settings.subproblem.slack_of_working_set);
        working_set.extend(self.rows_between(&iterate));
        working_set.extend(self.rows_everywhere(&iterate.grid));
        let chosen: Vec<RowAt> = working_set.iter().copied().collect();
        let linear = self.linearise(&iterate, &working_set);
        let curvature = self.curvature(&iterate);
        let commands = self.linearise_commands(&iterate, &working_set);
        let legs = self.free_legs();
        let step = Step {
            from: &iterate.states,
            wrenches: &linear.wrenches,
            time_sensitivities: &linear.time_sensitivities,
            curvature: &curvature,
            settings: &settings,
            proximal_weight: settings.sensitivity.proximal_weight,
            objective: Objective::Time,
            penalty: settings.sensitivity.penalty,
            cost_weight: settings.sensitivity.cost_weight,
            input_weight: 0.0,
            range: (-settings.sensitivity.radius, settings.sensitivity.radius),
            to_first_order: true,
            spans: &[],
            tightening: &self.tightening,
            local_tightening: &vec![0.0; chosen.len()],
            commands: commands.as_ref(),
        };
        let positions = self.positions(&iterate);
        let splines = splines(&iterate.grid);
        let form = self.transcription(&iterate.grid, &linear.maps).about(positions.as_deref());
        let form = form.about_states(Some(&iterate.states)).with_durations(&legs).in_these(splines.clone())?;
        let (program, _) = form.step_program(&step, &chosen);
        let (solved, effort) = solve_step(&program, &form.variables_of(&iterate.states, &program));
        self.hover.effort += effort;
        let Solution { x, z, .. } = solved?;
        let mission = relaxed(self.mission());
        let mut set = self.set.clone();
        set.rows.iter_mut().filter(|row| !row.equality).for_each(|row| row.offset += SHARE);
        let form = self.transcription(&iterate.grid, &linear.maps).about(positions.as_deref());
        let form = form.about_states(Some(&iterate.states)).with_durations(&legs).in_these(splines)?;
        let form = form.of_statements(&mission, &set);
        let (wider, _) = form.step_program(&step, &chosen);
        let given = wider.slack(&x).into_iter().zip(program.slack(&x)).map(|(wide, narrow)| wide - narrow);
        let mut found: BTreeMap<(usize, Statement), f64> = BTreeMap::new();
        let mut rests: BTreeMap<usize, f64> = BTreeMap::new();
        for ((origin, given), z) in program.row_origin.iter().zip(given).zip(&z) {
            if let RowOrigin::Rest { node, axis, derivative: 1 } = *origin
                && axis != YAW
            {
                *rests.entry(node).or_default() += (SPEED * form.tau_at(node) * z).powi(2);
            } else if let Some((leg, statement)) = self.statement(&form, origin) {
                *found.entry((leg, statement)).or_default() += given * z;
            }
        }
        let nodes = &iterate.grid.waypoint_nodes;
        for (node, square) in rests {
            let Some(waypoint) = nodes.iter().position(|&n| n == node) else { continue };
            found.insert((waypoint.saturating_sub(1), Statement::Rest(waypoint)), square.sqrt());
        }
        // Up to the last fixed time the mission lasts as long as the spec says; relaxed rows there lower the cost, not
        // the time.
        let fixed = self.spans().last().map_or(0, |span| span.end);
        found.retain(|(leg, _), _| *leg >= fixed);
        let total = iterate.grid.total;
        let of_leg = |leg: usize| {
            let of_leg = found.iter().filter(|((l, _), _)| *l == leg);
            let mut statements: Vec<(Statement, f64)> = of_leg.map(|((_, s), gain)| (*s, gain * total)).collect();
            statements.sort_by(|a, b| b.1.total_cmp(&a.1));
            statements
        };
        let segments = &iterate.grid.segments;
        Some(segments.iter().map(|s| LegBinding { duration: s.duration, statements: of_leg(s.from) }).collect())
    }

    /// The index of each leg's duration among the variables: none up to the last fixed time; after it one for each leg,
    /// or where the legs' shares are given one for all.
    fn free_legs(&self) -> Vec<Option<usize>> {
        let fixed = self.spans().last().map_or(0, |span| span.end);
        let own = |leg: usize| if self.chooses_times() { leg - fixed } else { 0 };
        (0..self.mission().legs.len()).map(|leg| (leg >= fixed).then(|| own(leg))).collect()
    }

    /// The statement that a row of the subproblem comes from, and its leg: at a waypoint the one that ends there.
    fn statement(&self, form: &Transcription, origin: &RowOrigin) -> Option<(usize, Statement)> {
        let leg = |node: usize| form.leg_of(node * PARTS);
        let set = |facet: usize| self.set.rows[facet].origin.first().map_or(0, |origin| origin.mode);
        Some(match *origin {
            RowOrigin::Facet { facet, node } => (leg(node), Statement::Set(set(facet))),
            RowOrigin::Lag { facet, node, .. } => (leg(node), Statement::Commands(set(facet))),
            RowOrigin::Limit { limit, node } => (leg(node), Statement::Limit(limit)),
            RowOrigin::Upright { node } => (leg(node), Statement::Upright),
            RowOrigin::Waypoint { waypoint } => (waypoint.saturating_sub(1), Statement::Within(waypoint)),
            RowOrigin::WaypointYaw { waypoint } => (waypoint.saturating_sub(1), Statement::YawWithin(waypoint)),
            _ => return None,
        })
    }
}
