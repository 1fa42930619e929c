//! The selection of RSP (step (e) of the paper's section 5.3): the facets of the modes' sets that the RIP plan violates and,
//! with more `rounds`, those violated by each plan for the selection so far. A certificate includes these plans; each is
//! checked like a plan, and the facets that it violates are computed here.

use super::super::core::{Core, WithoutYaw, may_be_freed};
use super::super::cost;
use super::super::interval::Interval;
use super::super::motion::Motion;
use super::super::proof::above_at_nodes;
use super::super::schedule;
use super::super::sets::Plane;
use super::super::{Rejection, mode_named};
use super::{Group, MOST_OUTSIDE, Role, Setting, of_groups};
use crate::certificate::{DynamicModel, MotionRecord, PlanClaim};
use crate::model::{FaultMode, Model, PlannerKind};
use crate::number::number;
use rayon::prelude::*;

/// A facet counts as violated from this share of the healthy set's width.
pub(super) const VIOLATED: f64 = 1e-4;

/// In the exact model, where the wrench is not linear, violations are searched for at the ends of this many parts of a
/// piece.
pub(super) const PARTS: usize = 16;

/// The rows imposed for a selection.
pub(super) struct Selected {
    /// One for each mode with a facet selected.
    pub groups: Vec<Group>,
    /// Facets for which it is open whether they are selected.
    pub remarks: Vec<String>,
}

/// Whether the spec's planner selects facets from plans that a certificate must include. With `require risk` the
/// protection is chosen differently.
pub(in crate::verify) fn selects(model: &Model) -> bool {
    let plan = &model.plan;
    plan.planner == PlannerKind::Rsp && plan.rounds > 0 && plan.require_risk.is_none()
}

impl Setting<'_> {
    /// The motions from which a claim selects facets, after checking that each is a plan.
    pub(super) fn selections(&self, claim: &PlanClaim, without_yaw: &WithoutYaw) -> Result<Vec<Motion>, Rejection> {
        if selects(self.model()) && claim.selected_by.is_empty() {
            let why = "RSP selects facets from a RIP plan, but the certificate includes none";
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        self.selected_by(&claim.selected_by, without_yaw)
    }

    /// The same for any claim; a claim that there is no plan may select no facets.
    pub(in crate::verify) fn selected_by(
        &self,
        records: &[MotionRecord],
        without_yaw: &WithoutYaw,
    ) -> Result<Vec<Motion>, Rejection> {
        if !selects(self.model()) && !records.is_empty() {
            let why = "the spec's planner selects no facets, but the certificate includes plans to select from";
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        if records.len() > self.model().plan.rounds {
            let why = format!(
                "the spec selects in {} rounds, but the certificate includes {} plans to select from",
                self.model().plan.rounds,
                records.len()
            );
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        let mut before: Vec<Motion> = Vec::new();
        for (round, record) in records.iter().enumerate() {
            let named =
                |r: Rejection| Rejection { claim: format!("plan {} to select from: {}", round + 1, r.claim), ..r };
            let checked = self.at_nodes(record, &before, (Role::SelectedBy, without_yaw)).map_err(named)?;
            if let Some(why) = checked.undecided.first() {
                return Err(named(Rejection::new("the plan", why.clone())));
            }
            before.push(checked.motion);
        }
        // All rounds select at the same mission time.
        let ends = |motion: &Motion| motion.times[motion.times.len() - 1];
        let apart = |pair: &[Motion]| !schedule::is_one_time(ends(&pair[0]), ends(&pair[1]), ends(&pair[0]));
        if let Some(round) = before.windows(2).position(apart) {
            let [a, b] = [round, round + 1].map(|i| number(ends(&before[i])));
            let why = format!("plans {} and {} to select from take {a} s and {b} s", round + 1, round + 2);
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        Ok(before)
    }

    /// The motions without any check.
    pub(super) fn unchecked(&self, records: &[MotionRecord]) -> Result<Vec<Motion>, Rejection> {
        records.iter().map(|record| self.motion(record)).collect()
    }

    /// The facets that the earlier plans violate, after checking that the motion satisfies them at the nodes.
    pub(super) fn select(
        &self,
        motion: &Motion,
        selected_by: &[Motion],
        without_yaw: &WithoutYaw,
    ) -> Result<Selected, Rejection> {
        let mut out = Selected { groups: Vec::new(), remarks: Vec::new() };
        if !selects(self.model()) || selected_by.is_empty() {
            return Ok(out);
        }
        let (bounding, undecided) = self.planes_of_modes(without_yaw)?;
        out.remarks.extend(
            undecided.into_iter().map(|(mode, why)| format!("the selected facets of {mode} are not decided: {why}")),
        );
        let violated = self.violated(bounding.iter().map(|(_, plane)| plane), selected_by);
        for mode in self.model().plan.against.iter().filter_map(|&i| self.model().modes.get(i)) {
            let of_mode = bounding.iter().zip(&violated).filter(|((of, _), over)| **over && *of == mode.name);
            let selected: Vec<Plane> = of_mode.map(|((_, plane), _)| plane.clone()).collect();
            let (facets, open): (Vec<Plane>, Vec<Plane>) = selected.into_iter().partition(|plane| plane.is_facet);
            let span = Some(mode.span);
            let group = |planes: Vec<Plane>| Group { mode: mode.name.clone(), whole: false, span, planes };
            let facets = group(facets);
            self.inside_at_nodes(motion, std::slice::from_ref(&facets))?;
            let (kept, missed): (Vec<Plane>, Vec<Plane>) =
                open.into_iter().partition(|plane| self.keeps(motion, plane));
            if !missed.is_empty() {
                out.remarks.push(format!(
                    "{} planes that may bound the set of {} are violated by the plan that RSP selects from, and by the \
                     motion; whether they contain facets is not decided",
                    missed.len(),
                    mode.name
                ));
            }
            let planes: Vec<Plane> = facets.planes.iter().cloned().chain(kept).collect();
            if !planes.is_empty() {
                out.groups.push(group(planes));
            }
        }
        let selects_of_cores =
            without_yaw.cores.iter().any(|core| self.members_over(core, selected_by).contains(&true));
        if !violated.contains(&true) && !selects_of_cores {
            // If nothing is selected, RSP's plan is RIP's, and the included plan leaves no set: the facets that another motion
            // violates are not guarded.
            let alone = std::slice::from_ref(motion);
            let leaves = self.violated(bounding.iter().map(|(_, plane)| plane), alone);
            let of_set = bounding.iter().zip(&leaves).find(|((_, plane), over)| **over && plane.is_facet);
            let of_core = without_yaw.cores.iter().find(|core| self.members_over(core, alone).contains(&true));
            let left = of_set.map(|((mode, _), _)| format!("set of {mode}"));
            if let Some(left) = left.or_else(|| of_core.map(|core| format!("core of {}", core.mode))) {
                out.remarks.push(format!(
                    "the included plan selects no facet, but the motion leaves the {left}: no facet of the fault sets is guarded"
                ));
            }
        }
        if selected_by.len() < self.model().plan.rounds
            && (!out.groups.is_empty() || selects_of_cores)
            && !self.closed(motion, selected_by, without_yaw)?
        {
            out.remarks.push(format!(
                "the spec selects in {} rounds, but the certificate includes the plans of {}",
                self.model().plan.rounds,
                selected_by.len()
            ));
        }
        Ok(out)
    }

    /// Whether further rounds would select nothing: the last plan to select from, or the motion itself, violates no facet
    /// that the plans before it did not violate.
    fn closed(&self, motion: &Motion, selected_by: &[Motion], without_yaw: &WithoutYaw) -> Result<bool, Rejection> {
        let (bounding, _) = self.planes_of_modes(without_yaw)?;
        let over = |motions: &[Motion]| self.violated(bounding.iter().map(|(_, plane)| plane), motions);
        let new_in = |motion: &Motion, before: &[Motion]| {
            let alone = std::slice::from_ref(motion);
            let (now, known) = (over(alone), over(before));
            let of_sets = bounding
                .iter()
                .zip(now.iter().zip(&known))
                .any(|((_, plane), (now, known))| plane.is_facet && *now && !known);
            let of_core = |core: &Core| {
                let (now, known) = (self.members_over(core, alone), self.members_over(core, before));
                now.iter().zip(&known).any(|(now, known)| *now && !known)
            };
            of_sets || without_yaw.cores.iter().any(of_core)
        };
        let Some((last, before)) = selected_by.split_last() else { return Ok(false) };
        Ok(!new_in(last, before) || !new_in(motion, selected_by))
    }

    fn keeps(&self, motion: &Motion, plane: &Plane) -> bool {
        let planes = std::slice::from_ref(plane);
        self.held().into_iter().all(|held| {
            let family = of_groups(self, held, planes);
            above_at_nodes(&family, motion, MOST_OUTSIDE).is_none()
        })
    }

    /// The planes that bound the sets of the modes planned against, each with its mode; and the modes whose set cannot be
    /// computed, with the reason.
    #[allow(clippy::type_complexity)]
    fn planes_of_modes(
        &self,
        without_yaw: &WithoutYaw,
    ) -> Result<(Vec<(String, Plane)>, Vec<(String, String)>), Rejection> {
        let (mut bounding, mut undecided) = (Vec::new(), Vec::new());
        let against = self.model().plan.against.iter().filter_map(|&i| self.model().modes.get(i));
        for mode in against.filter(|mode| !without_yaw.frees(&mode.name)) {
            match self.planes_of(&mode.name)? {
                Ok(planes) => bounding.extend(planes.into_iter().map(|plane| (mode.name.clone(), plane))),
                Err(why) => undecided.push((mode.name.clone(), why)),
            }
        }
        Ok((bounding, undecided))
    }

    /// For each plane whether some motion violates it: at a node, or in the exact model at one of [`PARTS`] instants of a
    /// piece.
    pub(in crate::verify) fn violated<'p>(
        &self,
        planes: impl Iterator<Item = &'p Plane>,
        motions: &[Motion],
    ) -> Vec<bool> {
        // Selection needs no enclosures: a violation close to the threshold may count or not.
        let middles = |v: &[Interval; 4]| v.map(Interval::middle);
        let planes: Vec<([f64; 4], f64)> = planes.map(|p| (middles(&p.normal), p.offset.middle())).collect();
        let pieces: Vec<(&Motion, usize)> =
            motions.iter().flat_map(|motion| (0..motion.pieces()).map(move |piece| (motion, piece))).collect();
        // The order of the pieces does not matter.
        let of_piece = |mut over: Vec<bool>, &(motion, piece): &(&Motion, usize)| {
            for wrench in self.wrenches(motion, piece) {
                let wrench = middles(&wrench);
                for ((normal, offset), over) in planes.iter().zip(&mut over) {
                    *over |= (0..4).map(|i| normal[i] * wrench[i]).sum::<f64>() - offset > VIOLATED;
                }
            }
            over
        };
        let none = || vec![false; planes.len()];
        let any = |a: Vec<bool>, b: Vec<bool>| a.iter().zip(&b).map(|(a, b)| *a || *b).collect();
        pieces.par_iter().fold(none, of_piece).reduce(none, any)
    }

    /// The wrenches of a piece at which violations are searched for: at its ends and between them.
    fn wrenches<'s>(&'s self, motion: &'s Motion, piece: usize) -> impl Iterator<Item = [Interval; 4]> + 's {
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS } else { 1 };
        let end = (piece + 1 == motion.pieces()).then_some(piece + 1);
        let nodes = std::iter::once(piece).chain(end).map(move |node| motion.node_in(node, piece));
        // As dense as on the spec's pieces, if the motion's are longer.
        let points = parts * (motion.extra_points(piece) + 1) - 1;
        let between = motion.grid(piece, points).map(move |at| motion.over(piece, at));
        let winds = self.dynamics.in_each_wind();
        nodes.chain(between).flat_map(move |state| winds.iter().map(|wind| wind.value(&state)).collect::<Vec<_>>())
    }

    /// Units of work for finding the facets that a motion with that many checkpoints selects.
    pub(super) fn cost_of_selecting(&self, checkpoints: u64, planes: u64) -> u64 {
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS as u64 } else { 1 };
        let of_state = self.overhead().saturating_add(planes);
        cost::times(cost::times(checkpoints, parts), of_state)
    }

    /// Whether facets of a mode may be selected.
    pub(in crate::verify) fn selects_facets_of(&self, mode: &str) -> bool {
        let against = self.model().plan.against.iter().filter_map(|&i| self.model().modes.get(i));
        let is_whole = |mode: &FaultMode| !may_be_freed(self.model(), mode);
        selects(self.model())
            && mode_named(self.model(), mode).is_some_and(is_whole)
            && against.into_iter().any(|m| m.name == mode)
    }
}
