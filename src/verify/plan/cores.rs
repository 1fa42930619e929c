//! The cores of modes in which yaw is given up, along a motion.

use super::super::core::WithoutYaw;
use super::super::cost::Purse;
use super::super::interval::Interval;
use super::super::motion::Motion;
use super::super::proof::{Family, above_at_nodes};
use super::super::{Reach, Rejection, Shown, required};
use super::along::violated;
use super::selection::{PARTS, Selecting, VIOLATED, selects};
use super::{Checked, Found, ImposedCore, MOST_OUTSIDE, Setting};
use crate::certificate::DynamicModel;
use crate::number::significant;
use std::collections::HashSet;

impl Setting<'_> {
    /// The cores that the spec's planner imposes: RCP's whole, RSP's where the plans that it selects from violate them. The motion
    /// satisfies them at the nodes, or is rejected.
    pub(super) fn imposed_cores(
        &self,
        motion: &Motion,
        selected_by: &[Selecting],
        without_yaw: &WithoutYaw,
    ) -> Result<Vec<ImposedCore>, Rejection> {
        let required: HashSet<String> = required(self.model()).into_iter().collect();
        let mut imposed = Vec::new();
        for core in &without_yaw.cores {
            let whole = required.contains(&core.mode);
            let family = core.family(&self.dynamics);
            let members: Vec<usize> = match whole {
                true => (0..family.members).collect(),
                false if selects(self.model()) => self.selected_members(&family, selected_by),
                false => Vec::new(),
            };
            let family = family.only(&members);
            if let Some(failure) = above_at_nodes(&family, motion, MOST_OUTSIDE) {
                let measure = family.measure;
                let claim = format!("the core of {}", core.mode);
                let span = self.span_of(&core.mode);
                return Err(Rejection { span, ..violated(claim, &failure, measure, MOST_OUTSIDE) });
            }
            imposed.push(ImposedCore { core: core.clone(), members, whole });
        }
        Ok(imposed)
    }

    /// The members that some motion violates, with the bounds on its own rate.
    fn selected_members(&self, family: &Family, motions: &[Selecting]) -> Vec<usize> {
        let all: Vec<usize> = (0..family.members).collect();
        let mut over = vec![false; family.members];
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS } else { 1 };
        for Selecting { motion, .. } in motions {
            for piece in 0..motion.pieces() {
                let nodes = [piece, piece + 1].map(|node| motion.node_in(node, piece));
                let points = parts * (motion.extra_points(piece) + 1) - 1;
                let between = motion.grid(piece, points).map(|at| motion.over(piece, at));
                for state in nodes.into_iter().chain(between) {
                    for (rated, over) in (family.evaluate)(&state, &all).iter().zip(&mut over) {
                        // A violation close to the threshold may count or not.
                        *over |= Interval::middle(rated.value) > 2.0 * VIOLATED;
                    }
                }
            }
        }
        let is_selected = over.iter().any(|over| *over);
        let of_rate = family.members - 2;
        all.into_iter().filter(|&member| over[member] || (is_selected && member >= of_rate)).collect()
    }
}

impl Checked<'_> {
    fn statement_of(core: &ImposedCore) -> String {
        let [low, high] = core.core.spin().map(|rate| significant(rate, 3));
        let which = if core.whole { "inside the core" } else { "inside the selected rows of the core" };
        format!("motion {which} of {}, for every heading and spins of {low} to {high} rad/s", core.core.mode)
    }

    /// Checks cores between the nodes.
    pub(super) fn cores_between(&self, purse: &mut Purse, found: &mut Found) {
        for imposed in self.cores.iter().filter(|imposed| !imposed.members.is_empty()) {
            let family = imposed.core.family(&self.setting.dynamics).only(&imposed.members);
            let reach = self.reach(&family, MOST_OUTSIDE, 1.0, purse);
            found.add(Self::statement_of(imposed), reach);
        }
    }

    /// Adds what a check of the nodes alone shows of cores.
    pub(super) fn cores_at_nodes(&self, found: &mut Found) {
        for imposed in self.cores.iter().filter(|imposed| !imposed.members.is_empty()) {
            found.shown.push(Shown::new(Self::statement_of(imposed), Reach::NODES));
        }
    }
}
