//! The violation of facets and limits by an iterate, and row generation: which rows the next subproblem needs.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner};
use crate::model::Limit;
use crate::motion::time_grid::TimeGrid;
use crate::motion::winds::OverWinds;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, Z};
use crate::planner::hover::ACCEPTED;
use crate::planner::limits::{covers, room_of};
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::qp::QuadraticProgram;
use crate::solve::{Outcome, Solution, solve_graded};
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

impl<'e, 'a> ScpPlanner<'e, 'a> {
    /// The wrench of a state in every possible wind, N and N m.
    pub(super) fn wrench_at(&self, state: &NodeState) -> OverWinds {
        let vehicle = &self.model().vehicle;
        let wrench = OverWinds::of_wrench(self.wrench, vehicle, &self.environment, state);
        match self.has_cores {
            true => wrench.turning(self.wrench.turning(vehicle, &self.environment, state)),
            false => wrench,
        }
    }

    /// The wrench in every possible wind at an instant of an iterate; `known` holds those computed before, as several
    /// rows may be at one instant.
    pub(super) fn wrench_at_instant<'k>(
        &self,
        iterate: &Iterate,
        instant: usize,
        known: &'k mut BTreeMap<usize, OverWinds>,
    ) -> &'k OverWinds {
        known.entry(instant).or_insert_with(|| self.wrench_at(&iterate.at(instant)))
    }

    /// By how much more each row may be violated in the worst of the possible winds than in their middle, at an
    /// iterate. Steps impose facets on the wrench in the middle, tightened by this much.
    pub(super) fn tightening_by_wind(&self, iterate: &Iterate, rows: &[RowAt]) -> Vec<f64> {
        let mut known = BTreeMap::new();
        let of_row = |&RowAt { row, instant }: &RowAt| match row {
            Row::Facet(facet) if self.environment.is_uncertain() => {
                self.wrench_at_instant(iterate, instant, &mut known).more_in_winds(&self.set.rows[facet])
            }
            _ => 0.0,
        };
        rows.iter().map(of_row).collect()
    }

    /// The largest violation of a row in all winds, in widths of the healthy set; a flat set's equalities hold to
    /// within the margin on both sides.
    pub(super) fn violation_of_facet(&self, facet: usize, wrench: &OverWinds) -> f64 {
        let row = &self.set.rows[facet];
        let violation =
            if row.equality { wrench.worst(row) - self.settings.tightening.margin } else { wrench.worst(row) };
        // A wrench that is not finite violates every row.
        if violation.is_nan() { f64::INFINITY } else { violation }
    }

    /// The violation of every facet and then of every limit for one state, at which the limits that `holds` selects
    /// hold. Where a body is so far away that its violation is surely below `floor`, it is not computed and minus
    /// infinity.
    pub(super) fn violations_of_state<'s>(
        &'s self,
        form: &'s Transcription<'s>,
        state: &'s NodeState,
        holds: impl Fn(&Limit) -> bool + 's,
        floor: impl Fn() -> f64 + 's,
    ) -> impl Iterator<Item = f64> + 's {
        let wrench = self.wrench_at(state);
        let facets = (0..self.set.rows.len()).map(move |facet| self.violation_of_facet(facet, &wrench));
        let position = [state[X][0], state[Y][0], state[Z][0]];
        // Limits on places have no width for a margin.
        let of_limit = move |limit: &Limit| match holds(limit) && !limit.is_violated_by_less(position, floor()) {
            true => form.violation_of(limit, state, 0.0) - if limit.kind.is_of_place() { ACCEPTED } else { 0.0 },
            false => f64::NEG_INFINITY,
        };
        let limits = self.mission().limits.iter().map(of_limit);
        let exact = self.wrench == WrenchModel::Exact;
        facets.chain(limits).chain(exact.then(|| form.violation_upright(state)))
    }

    /// The violations at an instant, each with its place and with its local tightening.
    pub(super) fn violations_at<'s>(
        &'s self,
        form: &'s Transcription<'s>,
        state: &'s NodeState,
        instant: usize,
        floor: impl Fn() -> f64 + 's,
    ) -> impl Iterator<Item = (usize, f64)> + 's {
        let local_tightening = self.local_tightening.get(&instant);
        let at = move |place: usize| local_tightening.and_then(|b| b.get(&place)).copied().unwrap_or(0.0);
        // Half of the room that rows keep: it covers what a motion does between instants.
        let room = form.room(instant, state);
        let of_volume = move |place: usize| 0.5 * self.limit_at(place).map_or(0.0, |limit| room_of(limit, room));
        let with_its_own = move |(place, violation)| (place, violation + at(place) + of_volume(place));
        let holds = move |limit: &Limit| form.covers(limit, instant);
        // What is added to violations at most.
        let most = local_tightening.into_iter().flat_map(BTreeMap::values).fold(0.5 * room, |sum, own| sum + own.abs());
        self.violations_of_state(form, state, holds, move || floor() - most).enumerate().map(with_its_own)
    }

    /// Whether the row at a place is of a volume, a corridor, a direction of arrival or a yaw that follows from the
    /// motion, for which the path alone counts.
    pub(super) fn is_of_path(&self, place: usize) -> bool {
        self.limit_at(place)
            .is_some_and(|limit| limit.volume.is_some() || limit.kind.is_arrival() || limit.kind.is_heading())
    }

    /// The limit whose row is at a place.
    fn limit_at(&self, place: usize) -> Option<&'a Limit> {
        place.checked_sub(self.set.rows.len()).and_then(|limit| self.problem().mission().limits.get(limit))
    }

    /// The largest violation of facets and limits at an instant.
    pub(super) fn largest_violation_at(&self, form: &Transcription, state: &NodeState, instant: usize) -> f64 {
        let most = Cell::new(f64::NEG_INFINITY);
        let all = self.violations_at(form, state, instant, || most.get());
        all.for_each(|(_, violation)| most.set(most.get().max(violation)));
        most.get()
    }

    /// The largest violation over all instants.
    pub(super) fn largest_violation(&self, iterate: &Iterate) -> f64 {
        let form = self.transcription(&iterate.grid, &[]);
        let at =
            |i: usize| self.largest_violation_at(&form, &iterate.at(i), i).max(self.command_violation_at(iterate, i));
        (0..form.instants()).map(at).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest violation at the nodes and at the instants of `working_set`; if there is none, over all instants.
    pub(super) fn largest_violation_with(&self, iterate: &Iterate, working_set: &BTreeSet<RowAt>) -> f64 {
        let form = self.transcription(&iterate.grid, &[]);
        let between: BTreeSet<usize> = working_set.iter().map(|r| r.instant).filter(|i| i % PARTS != 0).collect();
        let known = (0..form.instants()).step_by(PARTS).chain(between);
        let at =
            |i: usize| self.largest_violation_at(&form, &iterate.at(i), i).max(self.command_violation_at(iterate, i));
        let violation = known.map(at).fold(f64::NEG_INFINITY, f64::max);
        if violation > 0.0 { violation } else { self.largest_violation(iterate) }
    }

    /// The row at a place among those of [`Self::violations_of_state`].
    pub(super) fn row(&self, place: usize) -> Row {
        let (facets, limits) = (self.set.rows.len(), self.mission().limits.len());
        match place {
            p if p < facets => Row::Facet(p),
            p if p < facets + limits => Row::Limit(p - facets),
            _ => Row::Upright,
        }
    }

    /// The inverse of [`Self::row`]; `None` for rows on the commanded wrench.
    pub(super) fn place(&self, row: Row) -> Option<usize> {
        match row {
            Row::Facet(facet) => Some(facet),
            Row::Limit(limit) => Some(self.set.rows.len() + limit),
            Row::Upright => Some(self.set.rows.len() + self.mission().limits.len()),
            Row::Command { .. } => None,
        }
    }

    /// The local tightening of a row at an instant.
    pub(super) fn local_tightening_of(&self, RowAt { row, instant }: &RowAt) -> f64 {
        let local_tightening = self.local_tightening.get(instant);
        local_tightening
            .zip(self.place(*row))
            .and_then(|(local_tightening, place)| local_tightening.get(&place))
            .copied()
            .unwrap_or(0.0)
    }

    /// Rows with a violation over `threshold` at nodes. Equality rows are in every subproblem and are left out.
    pub(super) fn rows_at_nodes(&self, iterate: &Iterate, threshold: f64) -> BTreeSet<RowAt> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut found = BTreeSet::new();
        for (node, state) in iterate.states.iter().enumerate() {
            let instant = node * PARTS;
            let over = self.violations_at(&form, state, instant, || threshold).filter(|(_, e)| *e > threshold);
            found.extend(over.map(|(i, _)| RowAt { row: self.row(i), instant }));
            found.extend(self.command_rows_at_node(iterate, node, threshold));
        }
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// Between nodes each violated row, in each interval at the instant of its largest violation. (With only the worst
    /// facet of each interval programs are smaller, but fewer iterates are restored: shortest times came out up to a
    /// fifth longer.)
    pub(super) fn rows_between(&self, iterate: &Iterate) -> BTreeSet<RowAt> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut found = BTreeSet::new();
        for interval in 0..iterate.grid.intervals() {
            let mut worst: BTreeMap<usize, (f64, usize)> = BTreeMap::new();
            for instant in interval * PARTS + 1..(interval + 1) * PARTS {
                let state = iterate.at(instant);
                let over = self.violations_at(&form, &state, instant, || 0.0).filter(|(_, e)| *e > 0.0);
                for (i, violation) in over {
                    let entry = worst.entry(i).or_insert((violation, instant));
                    if violation > entry.0 {
                        *entry = (violation, instant);
                    }
                }
            }
            found.extend(worst.into_iter().map(|(i, (_, instant))| RowAt { row: self.row(i), instant }));
            found.extend(self.command_rows_between(iterate, interval));
        }
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// Each row that an iterate violates, on each leg at the instant of its largest violation.
    pub(super) fn rows_violated_most(&self, iterate: &Iterate) -> BTreeSet<RowAt> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut worst: BTreeMap<(usize, usize), (f64, usize)> = BTreeMap::new();
        for instant in 0..form.instants() {
            let leg = form.leg_of(instant);
            let state = iterate.at(instant);
            let over = self.violations_at(&form, &state, instant, || 0.0).filter(|(_, e)| *e > 0.0);
            for (place, violation) in over {
                let entry = worst.entry((place, leg)).or_insert((violation, instant));
                if violation > entry.0 {
                    *entry = (violation, instant);
                }
            }
        }
        let mut found: BTreeSet<RowAt> =
            worst.into_iter().map(|((place, _), (_, instant))| RowAt { row: self.row(place), instant }).collect();
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// The rows of some limits at every node where these hold; without those of volumes, if they are too many
    /// ([`Self::has_many_volumes`]).
    pub(super) fn limits_at_nodes(
        &self,
        grid: &TimeGrid,
        wanted: impl Fn(&Limit) -> bool,
    ) -> impl Iterator<Item = RowAt> {
        let nodes = grid.nodes();
        let waypoint_nodes = grid.waypoint_nodes.clone();
        let many = self.has_many_volumes(grid);
        let wanted = move |limit: &Limit| wanted(limit) && !(many && is_of_volume(limit));
        let limits = self.mission().limits.iter().enumerate().filter(move |(_, limit)| wanted(limit));
        limits.flat_map(move |(index, limit)| {
            let span = match &limit.leg {
                Some(on) => waypoint_nodes[on.leg]..waypoint_nodes[on.leg + 1] + 1,
                None => 0..nodes,
            };
            let held: Vec<usize> = span.filter(|node| covers(limit, &waypoint_nodes, 1, *node)).collect();
            held.into_iter().map(move |node| RowAt { row: Row::Limit(index), instant: node * PARTS })
        })
    }

    /// Whether the volumes have so many rows over a time grid that programs start without them and get those that an
    /// iterate violates or nearly violates.
    pub(super) fn has_many_volumes(&self, grid: &TimeGrid) -> bool {
        // The initial guess around a volume keeps it between nodes too.
        let between = PARTS / self.settings.guidance.instants;
        let rows_at_node = |limit: &Limit| if limit.kind.is_clearance() { 1 + between } else { 1 };
        let limits = self.mission().limits.iter().filter(|limit| is_of_volume(limit));
        limits.map(rows_at_node).sum::<usize>() * grid.nodes() > self.settings.subproblem.max_rows_of_volumes
    }

    /// Solves a program with rows of volumes added until its solution violates no other, if they are too many for one
    /// program: at each of the `instants` the most violated row. With the rows of the last program.
    pub(super) fn solve_with_volumes(
        &mut self,
        form: &Transcription,
        mut rows: BTreeSet<RowAt>,
        instants: usize,
        program: impl Fn(&[RowAt]) -> QuadraticProgram,
    ) -> (QuadraticProgram, Outcome) {
        let is_bounded =
            |limit: &Limit| is_of_volume(limit) && (!limit.kind.is_clearance() || form.positions.is_some());
        loop {
            let chosen: Vec<RowAt> = rows.iter().copied().collect();
            let program = program(&chosen);
            let (outcome, effort) = solve_graded(&program);
            self.hover.effort += effort;
            let (Outcome::Solved(Solution { x, .. }) | Outcome::Inconclusive { point: Some(x), .. }) = &outcome else {
                return (program, outcome);
            };
            if self.has_many_volumes(form.grid) {
                let iterate = Iterate { grid: form.grid.clone(), states: form.states(x), model: self.wrench };
                let limits: Vec<(usize, &Limit)> =
                    form.mission.limits.iter().enumerate().filter(|(_, limit)| is_bounded(limit)).collect();
                for instant in (0..form.instants()).step_by(instants) {
                    let state = iterate.at(instant);
                    let position = [state[X][0], state[Y][0], state[Z][0]];
                    let mut worst = (ACCEPTED, None);
                    for (index, limit) in &limits {
                        let row = RowAt { row: Row::Limit(*index), instant };
                        if limit.is_violated_by_less(position, worst.0) || rows.contains(&row) {
                            continue;
                        }
                        let violation = form.violation_of(limit, &state, 0.0);
                        if violation > worst.0 {
                            worst = (violation, Some(row));
                        }
                    }
                    rows.extend(worst.1);
                }
            }
            if rows.len() == chosen.len() {
                return (program, outcome);
            }
        }
    }

    /// The rows of limits on x, y, z and yaw, at every node, and on directions of arrival: they do not depend on time.
    pub(super) fn places(&self, grid: &TimeGrid) -> BTreeSet<RowAt> {
        self.limits_at_nodes(grid, |limit| limit.kind.is_of_place() || limit.kind.is_arrival()).collect()
    }

    /// The rows that each subproblem has at every node: limits on x, y, z and yaw, which do not depend on time, and on
    /// yaw rate, yaw acceleration and a yaw that follows from the motion. Yaw costs little, and its acceleration would
    /// oscillate beyond its bounds wherever no row limits it.
    pub(super) fn rows_everywhere(&self, grid: &TimeGrid) -> BTreeSet<RowAt> {
        self.limits_at_nodes(grid, |limit| limit.kind.is_of_place() || limit.kind.is_of_yaw()).collect()
    }
}

/// Whether a limit is of a volume: it holds on all legs, and a mission may have thousands.
fn is_of_volume(limit: &Limit) -> bool {
    limit.volume.is_some() && limit.is_general()
}
