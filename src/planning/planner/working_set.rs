//! The working set: rows that were active in earlier programs.

use crate::admissible::row::SetRow;
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Row, RowAt};
use std::collections::BTreeSet;

/// Rows of one planning set and of the mission's limits that were active so far. They carry over to other mission times
/// and grids, and to sets that start with the same rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WorkingSet {
    pub(super) rows: BTreeSet<RowAt>,
    nodes: usize,
}

impl WorkingSet {
    /// Moves the rows to a grid with `nodes` nodes, by their share of the mission.
    pub(super) fn fit(&mut self, nodes: usize) {
        if self.nodes != nodes {
            // A row is imposed on the part of the mission around its node.
            let (from, to) = (self.nodes.max(2) - 1, nodes - 1);
            let nearest = |half_steps: usize| (half_steps * to + from) / (2 * from);
            let around = |r: &RowAt| {
                let row = r.row;
                let (first, last) = (nearest((2 * r.instant).saturating_sub(1)), nearest(2 * r.instant + 1).min(to));
                (first..=last).map(move |instant| RowAt { row, instant })
            };
            self.rows = self.rows.iter().flat_map(around).collect();
            self.nodes = nodes;
        }
    }

    /// The rows with the same normals in another set, and all rows of limits.
    pub fn translated(&self, from: &PlanningSet, to: &PlanningSet) -> WorkingSet {
        let same = |a: &SetRow, b: &SetRow| a.core == b.core && (a.normal - b.normal).amax() <= 1e-9 * a.normal.amax();
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
