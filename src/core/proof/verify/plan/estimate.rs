//! What deciding a plan will cost, before anything is computed.

use super::super::core::{self, WithoutYaw};
use super::super::cost::{self, Estimate, times};
use super::super::proof::cost_at_nodes;
use super::super::sets::{HEALTHY, innermost_at_most, planes_at_most};
use super::super::{Rejection, least_time, limits, required, schedule, wind};
use super::{Setting, selection};
use crate::certificate::{DynamicModel, MotionRecord, PlanClaim};
use std::collections::HashSet;

impl Setting<'_> {
    /// The cost of deciding a plan without proofs between the nodes. Left out are the rows of cores at the nodes, whose
    /// number follows from their making: [`Setting::estimate_of_cores`].
    pub(super) fn estimate(&self, claim: &PlanClaim) -> Result<Estimate, Rejection> {
        let imposed = required(self.model());
        let mut all = self.estimate_of_sets(&imposed, claim.without_yaw.iter().map(|record| record.mode.as_str()));
        let cores = core::cost_of(self.model(), &claim.without_yaw);
        all.add(cores.units, cores.bytes);
        // Where cores are imposed, the healthy set takes the place of those of their modes.
        let of_motion = self.estimate_of_motion(&claim.motion, imposed.len() as u64 + 1)?;
        all.add(of_motion.units, of_motion.bytes);
        all.add(least_time::cost(self.problem, &claim.weights).units, 0);
        let branches = claim.recovery.iter().flat_map(|recovery| &recovery.branches);
        let nodes: u64 = branches.map(|branch| branch.nodes() as u64).sum();
        all.add(times(nodes, cost::COST_PER_JOINT), times(nodes, cost::BYTES_OF_A_BRANCH_NODE));
        let of_others = self.estimate_of_selecting(&claim.selected_by)?;
        all.add(of_others.units, of_others.bytes);
        Ok(all)
    }

    /// The cost of deciding a claim's motions from which facets are selected, and the sets of these facets.
    pub(in crate::proof::verify) fn estimate_of(&self, records: &[MotionRecord]) -> Result<Estimate, Rejection> {
        let mut all = self.estimate_of_sets(&required(self.model()), std::iter::empty());
        let cores = core::cost_of(self.model(), &[]);
        all.add(cores.units, cores.bytes);
        let of_motions = self.estimate_of_selecting(records)?;
        all.add(of_motions.units, of_motions.bytes);
        Ok(all)
    }

    /// The cost of all sets that are computed, each once: those imposed, those of which facets are selected, and those
    /// that decide whether yaw is given up.
    fn estimate_of_sets<'s>(&'s self, imposed: &'s [String], more: impl Iterator<Item = &'s str>) -> Estimate {
        let mut modes: HashSet<&str> = imposed.iter().map(String::as_str).chain(more).collect();
        modes.insert(HEALTHY);
        modes.extend(core::modes_looked_at(self.model()).map(|mode| mode.name.as_str()));
        if selection::selects(self.model()) {
            modes.extend(
                self.model().plan.against.iter().filter_map(|&i| Some(self.model().modes.get(i)?.name.as_str())),
            );
        }
        let vehicle = &self.model().vehicle;
        let (count, planes) = (modes.len() as u64, planes_at_most(vehicle));
        let of_generators = times(vehicle.rotors.len() as u64, cost::COST_PER_ROTOR);
        let of_set = times(planes, cost::COST_PER_PLANE).saturating_add(of_generators);
        Estimate { units: times(count, of_set), bytes: times(times(count, planes), cost::BYTES_OF_A_PLANE) }
    }

    /// The cost of the motions that select facets: each is decided as a plan of the healthy set and of the facets that
    /// those before it select, and all planes are looked at along each once.
    fn estimate_of_selecting(&self, records: &[MotionRecord]) -> Result<Estimate, Rejection> {
        let mut all = Estimate::default();
        for record in records {
            let of_motion = self.estimate_of_motion(record, 1)?;
            all.add(of_motion.units, of_motion.bytes);
        }
        Ok(all)
    }

    /// The cost of deciding one motion at its nodes against some number of whole sets and, under RSP, at most all
    /// facets of the modes' sets, and of finding the facets that it selects.
    fn estimate_of_motion(&self, record: &MotionRecord, sets: u64) -> Result<Estimate, Rejection> {
        let mut motion = self.motion(record)?;
        schedule::check(self.problem, &mut motion, self.premises)?;
        let (nodes, checkpoints) = (motion.times.len() as u64, motion.checkpoints());
        let mut all = Estimate::default();
        all.add(times(nodes, cost::COST_PER_JOINT), times(nodes, cost::BYTES_OF_A_NODE));
        let selectable = if selection::selects(self.model()) { self.model().plan.against.len() as u64 } else { 0 };
        let planes = innermost_at_most(&self.model().vehicle, sets.saturating_add(selectable));
        // Commands jump at nodes, which are looked at from both sides.
        let of_state = if self.commands.is_some() { 3 } else { 1 };
        all.add(times(times(checkpoints, self.units_of(planes)), of_state), 0);
        for limit in &self.mission().limits {
            for limit in std::iter::once(limit).chain(&limits::about(limit)) {
                all.add(cost_at_nodes(&self.family_of(limit, &motion), &motion), 0);
            }
        }
        all.add(times(checkpoints, 3 * cost::COST_PER_LIMIT), 0);
        if selectable > 0 {
            all.add(self.cost_of_selecting(checkpoints, times(planes_at_most(&self.model().vehicle), selectable)), 0);
        }
        Ok(all)
    }

    /// The cost of the cores' rows at the nodes of the claim's motions.
    pub(super) fn estimate_of_cores(&self, claim: &PlanClaim, without_yaw: &WithoutYaw) -> Result<Estimate, Rejection> {
        let mut all = Estimate::default();
        if without_yaw.cores.is_empty() {
            return Ok(all);
        }
        let mut states: u64 = 0;
        for record in claim.selected_by.iter().chain([&claim.motion]) {
            let checkpoints = self.checkpoints(record)?;
            states = states.saturating_add(checkpoints);
            if selection::selects(self.model()) {
                states = states.saturating_add(self.selecting_states(checkpoints));
            }
        }
        for core in &without_yaw.cores {
            let family = core.family(&self.dynamics);
            let members = family.members as u64;
            let of_state = times(members, family.of_a_member).saturating_add(family.overhead);
            all.add(times(states, of_state), times(members, cost::BYTES_OF_A_MEMBER));
        }
        Ok(all)
    }

    fn checkpoints(&self, record: &MotionRecord) -> Result<u64, Rejection> {
        let mut motion = self.motion(record)?;
        schedule::check(self.problem, &mut motion, self.premises)?;
        Ok(motion.checkpoints())
    }

    /// Units of some planes at one state, with its wrench.
    pub(super) fn units_of(&self, planes: u64) -> u64 {
        let of_planes = match self.dynamics.is_in_winds() {
            true => times(planes, wind::cost_of_a_plane(&self.dynamics)),
            false => times(planes, cost::COST_PER_ROW),
        };
        of_planes.saturating_add(self.overhead())
    }

    /// Units of one state with its wrench.
    pub(super) fn overhead(&self) -> u64 {
        match self.dynamics.is_in_winds() {
            true => times(wind::cost(&self.dynamics), self.of_one_wind()),
            false => self.of_one_wind(),
        }
    }

    /// Units of one state with its wrench in one wind.
    pub(super) fn of_one_wind(&self) -> u64 {
        match self.dynamics.model {
            DynamicModel::Hover => cost::OF_HOVER_WRENCH,
            DynamicModel::Exact => cost::OF_EXACT_WRENCH,
        }
    }
}
