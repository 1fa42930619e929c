//! Motions that know no set, to begin from.

use super::*;
use crate::planner::limits::Widening;
use crate::planner::transcription::Purpose;
use crate::qp::QuadraticProgram;
use crate::qp::build::{Affine, Builder};

impl Transcription<'_> {
    /// The least cost, and [`Self::gentleness`] beside it, with limits as chosen and no set.
    fn smooth_program(&self, chosen: &[RowAt]) -> QuadraticProgram {
        let mut builder = Builder::new(self.variables());
        let nothing = Affine::constant(0.0);
        self.dynamics(&mut builder, &|_, _, _| Affine::default());
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
    /// A smooth motion through the waypoints that knows no set: the least cost with positions in their limits, and gentle
    /// where it begins or ends as it likes.
    pub(super) fn smooth(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        // On long legs snap is so small that the solver's tolerance leaves noise in it: solved as if a leg took a second.
        let slower = (grid.total / grid.segments.len() as f64).max(1.0);
        let quick = grid.with_durations_times(|_| 1.0 / slower);
        let form = self.transcription(&quick, &[]);
        let places: Vec<RowAt> = self.places(grid).into_iter().collect();
        let program = match form.free_ends().next().is_some() {
            true => form.smooth_program(&places),
            false => form.relaxed_program(Purpose::Plan { slack: 0.0 }, &places, f64::INFINITY),
        };
        let (outcome, effort) = solve_graded(&program);
        self.hover.effort += effort;
        let (Outcome::Solved(Solution { x, .. }) | Outcome::Inconclusive { point: Some(x), .. }) = outcome else {
            return None;
        };
        let iterate = Iterate { grid: quick.clone(), states: form.states(&x), model: self.wrench }.slower(slower);
        Some(Iterate { grid: grid.clone(), ..iterate })
    }
}
