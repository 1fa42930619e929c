//! The selection of RSP (step (e) of the paper's section 5.3): the facets of the modes' sets that the RIP plan violates
//! and, with more `rounds`, those violated by each plan for the selection so far. A certificate includes these plans;
//! each is checked like a plan, and the facets that it violates are computed here.

use super::super::Rejection;
use super::super::core::{WithoutYaw, may_be_freed};
use super::super::cost;
use super::super::interval::Interval;
use super::super::motion::Motion;
use super::super::proof::each_above_at_nodes;
use super::super::schedule;
use super::super::sets::Plane;
use super::{Checked, Group, MOST_OUTSIDE, Role, Setting, of_groups};
use crate::certificate::{DynamicModel, MotionRecord, PlanClaim};
use crate::model::{FaultMode, Model, PlannerKind};
use crate::number::number;
use std::collections::HashSet;
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::{Arc, OnceLock};
use std::thread;

/// A facet counts as violated from this share of the healthy set's width.
pub(super) const VIOLATED: f64 = 1e-4;

/// In the exact model, where the wrench is not linear, violations are searched for at the ends of this many parts of a
/// piece.
pub(super) const PARTS: usize = 16;

/// A motion from which facets are selected.
pub(super) struct Selecting {
    pub motion: Motion,
    /// For each plane of [`Selectable`] whether the motion violates it: found when it is first needed, and once.
    pub violates: OnceLock<Vec<bool>>,
    /// For each member of each core whether the motion violates it: found when it is first needed, and once.
    pub of_cores: OnceLock<Vec<Vec<bool>>>,
}

impl From<Motion> for Selecting {
    fn from(motion: Motion) -> Self {
        Selecting { motion, violates: OnceLock::new(), of_cores: OnceLock::new() }
    }
}

/// The sets of which facets may be selected.
struct Selectable<'m> {
    modes: Vec<SelectableMode<'m>>,
    /// Modes whose set cannot be computed, with the reason.
    undecided: Vec<(String, String)>,
}

struct SelectableMode<'m> {
    mode: &'m FaultMode,
    planes: Arc<[Plane]>,
}

impl Selectable<'_> {
    fn planes(&self) -> impl Iterator<Item = &Plane> {
        self.modes.iter().flat_map(|set| set.planes.iter())
    }
}

/// Whether any of some motions violates each plane.
fn any_of(motions: &[&[bool]], planes: usize) -> Vec<bool> {
    (0..planes).map(|plane| motions.iter().any(|over| over[plane])).collect()
}

/// Pieces times planes from which violations are searched for in parallel. Chosen by hand.
const WORTH_THREADS: usize = 20_000;

fn threads() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// The rows imposed for a selection.
pub(super) struct Selected {
    /// One for each mode with a facet selected.
    pub groups: Vec<Group>,
    /// Facets for which it is open whether they are selected.
    pub remarks: Vec<String>,
}

/// Whether the spec's planner selects facets from plans that a certificate must include. With `require risk` the
/// protection is chosen differently.
pub(in crate::proof::verify) fn selects(model: &Model) -> bool {
    let plan = &model.plan;
    plan.planner == PlannerKind::Rsp && plan.rounds > 0 && plan.require_risk.is_none()
}

impl Setting<'_> {
    /// The motions from which a claim selects facets, after checking that each is a plan.
    pub(super) fn selections(&self, claim: &PlanClaim, without_yaw: &WithoutYaw) -> Result<Vec<Selecting>, Rejection> {
        if selects(self.model()) && claim.selected_by.is_empty() {
            let why = "RSP selects facets from a RIP plan, but the certificate includes none";
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        self.all_selecting(&claim.selected_by, without_yaw)
    }

    /// The motions of `records`, after checking that each is a plan. There may be none: a claim that there is no plan
    /// may select no facets.
    pub(in crate::proof::verify) fn selected_by(
        &self,
        records: &[MotionRecord],
        without_yaw: &WithoutYaw,
    ) -> Result<Vec<Motion>, Rejection> {
        let checked = self.all_selecting(records, without_yaw)?;
        Ok(checked.into_iter().map(|selecting| selecting.motion).collect())
    }

    fn all_selecting(&self, records: &[MotionRecord], without_yaw: &WithoutYaw) -> Result<Vec<Selecting>, Rejection> {
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
        let mut before: Vec<Selecting> = Vec::new();
        for (round, record) in records.iter().enumerate() {
            let named =
                |r: Rejection| Rejection { claim: format!("plan {} to select from: {}", round + 1, r.claim), ..r };
            let checked = self.at_nodes(record, &before, Role::SelectedBy, without_yaw).map_err(named)?;
            if let Some(why) = checked.undecided.first() {
                return Err(named(Rejection::new("the plan", why.clone())));
            }
            let Checked { motion, violates, of_cores, .. } = checked;
            before.push(Selecting { motion, violates, of_cores });
        }
        // All rounds select at the same mission time.
        let ends = |selecting: &Selecting| selecting.motion.times[selecting.motion.times.len() - 1];
        let apart = |pair: &[Selecting]| !schedule::is_one_time(ends(&pair[0]), ends(&pair[1]), ends(&pair[0]));
        if let Some(round) = before.windows(2).position(apart) {
            let [a, b] = [round, round + 1].map(|i| number(ends(&before[i])));
            let why = format!("plans {} and {} to select from take {a} s and {b} s", round + 1, round + 2);
            return Err(Rejection { span: Some(self.model().plan.span), ..Rejection::new("the selection", why) });
        }
        Ok(before)
    }

    /// The motions without any check.
    pub(super) fn unchecked(&self, records: &[MotionRecord]) -> Result<Vec<Selecting>, Rejection> {
        records.iter().map(|record| self.motion(record).map(Selecting::from)).collect()
    }

    /// The facets that the earlier plans violate, after checking that the motion satisfies them at the nodes.
    pub(super) fn select(
        &self,
        selecting: &Selecting,
        selected_by: &[Selecting],
        without_yaw: &WithoutYaw,
    ) -> Result<Selected, Rejection> {
        let mut out = Selected { groups: Vec::new(), remarks: Vec::new() };
        if !selects(self.model()) || selected_by.is_empty() {
            return Ok(out);
        }
        let motion = &selecting.motion;
        let selectable = self.selectable(without_yaw)?;
        let undecided = selectable.undecided.iter();
        out.remarks
            .extend(undecided.map(|(mode, why)| format!("the selected facets of {mode} are not decided: {why}")));
        let violates: Vec<&[bool]> = selected_by.iter().map(|other| self.violates(other, &selectable)).collect();
        let violated = any_of(&violates, selectable.planes().count());
        let mut first = 0;
        let (mut facets, mut open) = (Vec::new(), Vec::new());
        for SelectableMode { planes, .. } in &selectable.modes {
            let selected = planes.iter().zip(&violated[first..]).filter(|(_, over)| **over).map(|(plane, _)| plane);
            let (of_facets, others): (Vec<&Plane>, Vec<&Plane>) = selected.partition(|plane| plane.is_facet);
            facets.push(of_facets);
            open.push(others);
            first += planes.len();
        }
        // All modes together: the wrench of a state is computed once.
        let group = |(set, planes): (&SelectableMode, Vec<Plane>)| Group {
            mode: set.mode.name.clone(),
            whole: false,
            span: Some(set.mode.span),
            planes: planes.into(),
        };
        let owned = |planes: &Vec<&Plane>| planes.iter().copied().cloned().collect::<Vec<Plane>>();
        let groups: Vec<Group> = selectable.modes.iter().zip(facets.iter().map(owned)).map(group).collect();
        self.inside_at_nodes(motion, &groups)?;
        let missed = self.missed(motion, open.concat());
        let mut first = 0;
        for ((set, facets), open) in selectable.modes.iter().zip(facets).zip(open) {
            let missed = &missed[first..first + open.len()];
            first += open.len();
            let count = missed.iter().filter(|missed| **missed).count();
            if count > 0 {
                out.remarks.push(format!(
                    "{count} planes that may bound the set of {} are violated by the plan that RSP selects from, and \
                     by the motion; whether they contain facets is not decided",
                    set.mode.name
                ));
            }
            let kept = open.into_iter().zip(missed).filter(|(_, missed)| !**missed).map(|(plane, _)| plane);
            let planes: Vec<Plane> = facets.into_iter().chain(kept).cloned().collect();
            if !planes.is_empty() {
                out.groups.push(group((set, planes)));
            }
        }
        let selects_of_cores = self.core_members_over(selected_by, without_yaw).iter().any(|over| over.contains(&true));
        if !violated.contains(&true) && !selects_of_cores {
            // If nothing is selected, RSP's plan is RIP's, and the included plan leaves no set: the facets that another
            // motion violates are not guarded.
            let leaves = self.violates(selecting, &selectable);
            let of_modes = selectable.modes.iter().flat_map(|set| set.planes.iter().map(|plane| (set.mode, plane)));
            let of_set =
                of_modes.zip(leaves).find(|(_, over)| **over).map(|((mode, _), _)| format!("set of {}", mode.name));
            let of_cores = without_yaw.cores.iter().zip(self.core_members_of(selecting, without_yaw));
            let of_core = of_cores.into_iter().find(|(_, over)| over.contains(&true));
            if let Some(left) = of_set.or_else(|| of_core.map(|(core, _)| format!("core of {}", core.mode))) {
                out.remarks.push(format!(
                    "the included plan selects no facet, but the motion leaves the {left}: no facet of the fault sets \
                     is guarded"
                ));
            }
        }
        if selected_by.len() < self.model().plan.rounds
            && (!out.groups.is_empty() || selects_of_cores)
            && !self.closed(selecting, selected_by, &selectable, without_yaw)
        {
            out.remarks.push(format!(
                "the spec selects in {} rounds, but the certificate includes the plans of {}",
                self.model().plan.rounds,
                selected_by.len()
            ));
        }
        Ok(out)
    }

    /// Whether further rounds would select nothing: the last plan to select from, or the motion itself, violates no
    /// facet that the plans before it did not violate.
    fn closed(
        &self,
        selecting: &Selecting,
        selected_by: &[Selecting],
        selectable: &Selectable,
        without_yaw: &WithoutYaw,
    ) -> bool {
        let is_new = |now: &[bool], known: &[bool]| now.iter().zip(known).any(|(now, known)| *now && !known);
        let selects_more = |selecting: &Selecting, before: &[Selecting]| {
            let now = self.violates(selecting, selectable);
            let known: Vec<&[bool]> = before.iter().map(|before| self.violates(before, selectable)).collect();
            let (of_cores, known_of_cores) =
                (self.core_members_of(selecting, without_yaw), self.core_members_over(before, without_yaw));
            is_new(now, &any_of(&known, now.len()))
                || of_cores.iter().zip(&known_of_cores).any(|(now, known)| is_new(now, known))
        };
        let Some((last, before)) = selected_by.split_last() else { return false };
        !selects_more(last, before) || !selects_more(selecting, selected_by)
    }

    /// For each plane whether the motion, or its commands, violate it at the nodes.
    fn missed(&self, motion: &Motion, planes: Vec<&Plane>) -> Vec<bool> {
        let mut missed = vec![false; planes.len()];
        if planes.is_empty() {
            return missed;
        }
        for held in self.held() {
            let family = of_groups(self, held, planes.clone());
            let above = each_above_at_nodes(&family, motion, MOST_OUTSIDE);
            missed.iter_mut().zip(above).for_each(|(missed, above)| *missed |= above);
        }
        missed
    }

    fn violates<'s>(&self, selecting: &'s Selecting, selectable: &Selectable) -> &'s [bool] {
        let found = || self.violated(selectable.planes(), std::slice::from_ref(&selecting.motion));
        selecting.violates.get_or_init(found)
    }

    /// The planes that bound the sets of the modes planned against.
    fn selectable(&self, without_yaw: &WithoutYaw) -> Result<Selectable<'_>, Rejection> {
        let mut found = Selectable { modes: Vec::new(), undecided: Vec::new() };
        let against = self.model().plan.against.iter().filter_map(|&i| self.model().modes.get(i));
        for mode in against.filter(|mode| !without_yaw.frees(&mode.name)) {
            match self.planes_of(&mode.name)? {
                Ok(planes) => found.modes.push(SelectableMode { mode, planes }),
                Err(why) => found.undecided.push((mode.name.clone(), why)),
            }
        }
        Ok(found)
    }

    /// For each plane whether some motion violates it: at a node, or in the exact model at one of [`PARTS`] instants of
    /// a piece.
    pub(in crate::proof::verify) fn violated<'p>(
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
        let of_some = |some: &[(&Motion, usize)]| some.iter().fold(vec![false; planes.len()], of_piece);
        // Threads of their own pay off only for long motions and many planes.
        let count = if pieces.len() * planes.len() < WORTH_THREADS { 1 } else { threads() };
        thread::scope(|scope| {
            let parts = pieces.chunks(pieces.len().div_ceil(count).max(1));
            let running: Vec<_> = parts.map(|part| scope.spawn(move || of_some(part))).collect();
            let ended = running.into_iter().map(|part| part.join().unwrap_or_else(|panic| resume_unwind(panic)));
            let any = |a: Vec<bool>, b: Vec<bool>| a.iter().zip(&b).map(|(a, b)| *a || *b).collect();
            ended.fold(vec![false; planes.len()], any)
        })
    }

    /// The wrenches of a piece at which violations are searched for: at its ends and between them.
    fn wrenches<'s>(&'s self, motion: &'s Motion, piece: usize) -> impl Iterator<Item = [Interval; 4]> + 's {
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS } else { 1 };
        let end = (piece + 1 == motion.pieces()).then_some(piece + 1);
        let nodes = std::iter::once(piece).chain(end).map(move |node| motion.node_in(node, piece));
        // Longer pieces than the spec's get points as dense as those on the spec's.
        let points = parts * (motion.extra_points(piece) + 1) - 1;
        let between = motion.grid(piece, points).map(move |at| motion.over(piece, at));
        let winds = self.dynamics.in_each_wind();
        nodes.chain(between).flat_map(move |state| winds.iter().map(|wind| wind.value(&state)).collect::<Vec<_>>())
    }

    /// Units of work for finding which of some planes a motion with that many checkpoints violates.
    pub(in crate::proof::verify) fn cost_of_selecting(&self, checkpoints: u64, planes: u64) -> u64 {
        // In each extreme wind, without a bound for those between.
        let winds = self.dynamics.in_each_wind().len() as u64;
        let of_wind = self.of_one_wind().saturating_add(planes.div_ceil(cost::PLANES_OF_A_UNIT));
        cost::times(self.selecting_states(checkpoints), cost::times(winds, of_wind))
    }

    /// States of a motion with that many checkpoints at which the rows that it selects are searched for.
    pub(super) fn selecting_states(&self, checkpoints: u64) -> u64 {
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS as u64 } else { 1 };
        // Pieces that share a node look at it one after the other.
        cost::times(checkpoints, parts + 1)
    }

    /// The modes of which facets may be selected.
    pub(in crate::proof::verify) fn selectable_modes(&self) -> HashSet<&str> {
        if !selects(self.model()) {
            return HashSet::new();
        }
        let against = self.model().plan.against.iter().filter_map(|&i| self.model().modes.get(i));
        against.filter(|mode| !may_be_freed(&self.sets, mode)).map(|mode| mode.name.as_str()).collect()
    }
}
