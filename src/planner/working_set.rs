//! Rows that bound in earlier programs.

use crate::admissible::row::SetRow;
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Row, RowAt};
use std::collections::BTreeSet;

/// Rows of one planning set and of the mission's limits found binding so far. They carry over to other mission times and grids, and to
/// sets that begin with the same rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WorkingSet {
    pub(super) rows: BTreeSet<RowAt>,
    nodes: usize,
}

impl WorkingSet {
    /// Moves the rows to a grid with `nodes` nodes, by their share of the mission.
    pub(super) fn fit(&mut self, nodes: usize) {
        if self.nodes != nodes {
            // A row stands for the stretch of mission about its node.
            let (from, to) = (self.nodes.max(2) - 1, nodes - 1);
            let nearest = |half_steps: usize| (half_steps * to + from) / (2 * from);
            let stretch = |r: &RowAt| {
                let row = r.row;
                let (first, last) = (nearest((2 * r.instant).saturating_sub(1)), nearest(2 * r.instant + 1).min(to));
                (first..=last).map(move |instant| RowAt { row, instant })
            };
            self.rows = self.rows.iter().flat_map(stretch).collect();
            self.nodes = nodes;
        }
    }

    /// The rows of another set with the same normals, and all of limits.
    pub fn translated(&self, from: &PlanningSet, to: &PlanningSet) -> WorkingSet {
        let same = |a: &SetRow, b: &SetRow| (a.normal - b.normal).amax() <= 1e-9 * a.normal.amax();
        let image: Vec<Option<usize>> =
            from.rows.iter().map(|a| to.rows.iter().position(|b| !b.equality && same(a, b))).collect();
        let moved = |r: &RowAt| match r.row {
            Row::Facet(facet) => Some(RowAt { row: Row::Facet(image[facet]?), ..*r }),
            Row::Command { facet, slope } => Some(RowAt { row: Row::Command { facet: image[facet]?, slope }, ..*r }),
            Row::Limit(_) | Row::Upright => Some(*r),
        };
        WorkingSet { rows: self.rows.iter().filter_map(moved).collect(), nodes: self.nodes }
    }
}
