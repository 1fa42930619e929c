//! The minimum-snap initial guess: the least cost through the waypoints, without the set.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner};
use crate::motion::time_grid::TimeGrid;
use crate::planner::limits::Widening;
use crate::planner::transcription::Purpose;
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::qp::QuadraticProgram;
use crate::qp::build::{Affine, Builder};
use crate::solve::{Outcome, Solution};

impl Transcription<'_> {
    /// Minimises the cost and [`Self::gentleness`] subject to the limits in `chosen`, without the set.
    fn minimum_snap_program(&self, chosen: &[RowAt]) -> QuadraticProgram {
        let mut builder = Builder::new(self.variables());
        let nothing = Affine::constant(0.0);
        self.dynamics(&mut builder);
        self.rest(&mut builder);
        for &RowAt { row, instant } in chosen {
            if let Row::Limit(limit) = row {
                self.limit(&mut builder, limit, instant, &Widening::by(&nothing));
            }
        }
        self.waypoints(&mut builder, &nothing);
        self.cost(&mut builder, 1.0);
        self.gentleness(&mut builder);
        builder.finish()
    }
}

impl ScpPlanner<'_, '_> {
    /// The minimum-snap motion through the waypoints: the least cost with positions in their limits, without the set.
    /// Where an end is free, [`Transcription::gentleness`] is added to the cost. `None` if the solver gives no point.
    ///
    /// If it enters a volume that it must keep out of, it is led around all of them: their distances are linearised
    /// about a way around, and then about the motion that follows.
    pub(super) fn minimum_snap(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        let direct = self.minimum_snap_about(grid, None, None)?;
        let Some(way) = self.way_around(&direct) else { return Some(self.headed(grid, direct)) };
        let mut around = self.minimum_snap_about(grid, Some(way.as_slice()), None)?;
        for _ in 0..self.settings.guidance.ways {
            let positions = self.positions(&around);
            match self.minimum_snap_about(grid, positions.as_deref(), None) {
                Some(next) => around = next,
                None => break,
            }
        }
        Some(self.headed(grid, around))
    }

    /// With distances from bodies linearised about `positions`, and a yaw that follows from the motion about an
    /// iterate.
    pub(super) fn minimum_snap_about(
        &mut self,
        grid: &TimeGrid,
        positions: Option<&[[f64; 3]]>,
        headed: Option<&Iterate>,
    ) -> Option<Iterate> {
        // On long legs snap is so small that the solver's tolerance leaves noise in it: the legs are scaled to a mean
        // of 1 s.
        let slower = (grid.total / grid.segments.len() as f64).max(1.0);
        let quick = grid.with_durations_times(|_| 1.0 / slower);
        let headed = headed.map(|iterate| iterate.slower(1.0 / slower).states);
        let form = self.transcription(&quick, &[]).about(positions).about_states(headed.as_deref());
        let mut places = self.places(grid);
        if headed.is_some() {
            places.extend(self.limits_at_nodes(grid, |limit| limit.kind.is_heading()));
        }
        // A coarse grid would cut the corners of a way around.
        if positions.is_some() && !self.has_many_volumes(grid) {
            let volumes = self.problem().mission().limits.iter().enumerate().filter(|(_, l)| l.kind.is_clearance());
            let instants = (0..=grid.intervals() * PARTS).step_by(self.settings.guidance.instants);
            let rows =
                volumes.flat_map(|(i, _)| instants.clone().map(move |instant| RowAt { row: Row::Limit(i), instant }));
            places.extend(rows);
        }
        let program = |places: &[RowAt]| match form.free_ends().next().is_some() {
            true => form.minimum_snap_program(places),
            false => form.relaxed_program(Purpose::Plan { slack: 0.0 }, places, f64::INFINITY),
        };
        let instants = if positions.is_some() { self.settings.guidance.instants } else { PARTS };
        let (_, outcome) = self.solve_with_volumes(&form, places, instants, program);
        let (Outcome::Solved(Solution { x, .. }) | Outcome::Inconclusive { point: Some(x), .. }) = outcome else {
            return None;
        };
        let iterate = Iterate { grid: quick.clone(), states: form.states(&x), model: self.wrench }.slower(slower);
        Some(Iterate { grid: grid.clone(), ..iterate })
    }
}
