//! Whether the planner chooses the waypoint times, and the grid that belongs to the durations chosen.

use super::ScpPlanner;
use super::iterate::Iterate;
use crate::model::grid::{fewest_pieces, is_coarser, pieces};
use crate::motion::time_grid::{LegGrid, Segment, TimeGrid};
use crate::planner::transcription::RowAt;
use std::collections::BTreeSet;

impl ScpPlanner<'_, '_> {
    /// Whether the planner chooses the waypoint times.
    pub(super) fn chooses_times(&self) -> bool {
        self.model().plan.chooses_times && self.mission().leaves_times_free()
    }

    /// The iterate on the grid of its own durations if some leg has longer pieces than that grid ([`is_coarser`]);
    /// unchanged if it cannot be restored there.
    pub(super) fn on_its_own_grid(&mut self, iterate: Iterate, working_set: &mut BTreeSet<RowAt>) -> Iterate {
        let mission = self.mission();
        let segments = &iterate.grid.segments;
        let durations: Vec<f64> = segments.iter().map(|s| s.duration).collect();
        let samples = iterate.grid.intervals() + self.holds();
        let fewest = fewest_pieces(mission, &durations, samples);
        let nodes = |s: &Segment| &iterate.grid.node_times[s.first_node..=s.first_node + s.intervals];
        if segments.iter().zip(fewest).all(|(s, fewest)| !is_coarser(mission, nodes(s), fewest)) {
            return iterate;
        }
        let due = durations.iter().zip(pieces(mission, &durations, samples)).map(|(&d, n)| LegGrid::new(d, n));
        let due: Vec<LegGrid> = due.collect();
        let own = TimeGrid::with_legs(mission, &due, iterate.grid.total + self.held()).flown();
        let there = iterate.on(&own);
        let max_predicted = self.settings.feasibility.max_predicted_after_change;
        for factor in self.settings.grids.slowdowns {
            // The rows of a working set are numbered by the instants of one grid.
            let mut known = BTreeSet::new();
            let slower = self.lasting(&there, factor * own.total);
            if let Some(inside) = self.restore_feasibility_within(slower, max_predicted, &mut known) {
                *working_set = known;
                return inside;
            }
        }
        // Steps with free durations reach feasible iterates that restoration at fixed durations does not.
        let settings = self.settings.durations;
        let (weights, radius) = settings.on_full_grid();
        let mut known = BTreeSet::new();
        match self.shorten(there, weights, radius, iterate.grid.total, &mut known) {
            Some(inside) if inside.grid.total <= settings.longest_on_its_own_grid * iterate.grid.total => {
                *working_set = known;
                inside
            }
            _ => iterate,
        }
    }
}
