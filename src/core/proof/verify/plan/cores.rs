//! The cores of modes in which yaw is given up, along a motion.

use super::super::core::{Core, WithoutYaw};
use super::super::cost::WorkLeft;
use super::super::interval::Interval;
use super::super::motion::Motion;
use super::super::premise::Premise;
use super::super::proof::{Family, Measure, above_at_nodes};
use super::super::{Reach, Rejection, Shown, required};
use super::along::violated;
use super::selection::{PARTS, Selecting, VIOLATED, selects};
use super::{Checked, Found, ImposedCore, MOST_OUTSIDE, Setting};
use crate::certificate::DynamicModel;
use crate::number::{down, up};
use std::collections::HashSet;
use std::ops::Range;

impl Setting<'_> {
    /// The cores that the spec's planner imposes: RCP's whole, RSP's where the plans that it selects from violate them.
    /// The motion satisfies them at the nodes, or is rejected.
    pub(super) fn imposed_cores(
        &self,
        motion: &Motion,
        selected_by: &[Selecting],
        without_yaw: &WithoutYaw,
    ) -> Result<Vec<ImposedCore>, Rejection> {
        if !self.premises.has(Premise::Cores) {
            return Ok(Vec::new());
        }
        let required: HashSet<String> = required(self.model()).into_iter().collect();
        let mut imposed = Vec::new();
        for (index, core) in without_yaw.cores.iter().enumerate() {
            let whole = required.contains(&core.mode);
            let family = core.family(&self.dynamics);
            let all = family.members;
            let members: Vec<usize> = match whole {
                true => (0..all).collect(),
                false if selects(self.model()) => self.selected_members(index, selected_by, without_yaw),
                false => Vec::new(),
            };
            let members: Vec<usize> = match self.premises.has(Premise::Spin) {
                true => members,
                false => members.into_iter().filter(|&member| member < all - core.premises()).collect(),
            };
            let imposed_core = ImposedCore { core: core.clone(), members, whole };
            for Part { family, subject, .. } in self.parts(&imposed_core) {
                if let Some(failure) = above_at_nodes(&family, motion, MOST_OUTSIDE) {
                    let span = self.span_of(&core.mode);
                    return Err(Rejection { span, ..violated(subject, &failure, family.measure, MOST_OUTSIDE) });
                }
            }
            imposed.push(imposed_core);
        }
        Ok(imposed)
    }

    /// The members of a core that some motion violates, with their premises.
    fn selected_members(&self, core: usize, motions: &[Selecting], without_yaw: &WithoutYaw) -> Vec<usize> {
        let over = self.core_members_over(motions, without_yaw).swap_remove(core);
        let premises = over.len() - without_yaw.cores[core].premises();
        // The planner does not select the ends of the spin, which leave room for the rates of plans.
        let is_selected = over[..over.len() - 2].contains(&true);
        (0..over.len()).filter(|&member| is_selected && (over[member] || member >= premises)).collect()
    }

    /// For each member of each core whether some motion violates it.
    pub(super) fn core_members_over(&self, motions: &[Selecting], without_yaw: &WithoutYaw) -> Vec<Vec<bool>> {
        let mut any: Vec<Vec<bool>> =
            without_yaw.cores.iter().map(|core| vec![false; core.family(&self.dynamics).members]).collect();
        for selecting in motions {
            for (any, over) in any.iter_mut().zip(self.core_members_of(selecting, without_yaw)) {
                any.iter_mut().zip(over).for_each(|(any, over)| *any |= over);
            }
        }
        any
    }

    /// For each member of each core whether one motion violates it; kept in `selecting` when it was first found.
    pub(super) fn core_members_of<'s>(&self, selecting: &'s Selecting, without_yaw: &WithoutYaw) -> &'s [Vec<bool>] {
        let found = |core: &Core| self.members_over(&core.family(&self.dynamics), &selecting.motion);
        selecting.of_cores.get_or_init(|| without_yaw.cores.iter().map(found).collect())
    }

    fn members_over(&self, family: &Family, motion: &Motion) -> Vec<bool> {
        let all: Vec<usize> = (0..family.members).collect();
        let mut over = vec![false; family.members];
        let parts = if self.dynamics.model == DynamicModel::Exact { PARTS } else { 1 };
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
        over
    }
}

/// Members of one measure.
struct Part<'f> {
    family: Family<'f>,
    /// In rejections.
    subject: String,
    statement: String,
}

impl<'a> Setting<'a> {
    /// The imposed rows of a core, then the premises that are imposed with them: the rate of turning, and that of the
    /// motion itself.
    fn parts(&self, imposed: &ImposedCore) -> Vec<Part<'a>> {
        let ImposedCore { core, members, whole } = imposed;
        let all = core.family(&self.dynamics).members;
        let [rows, turning] = [all - core.premises(), all - 2];
        // Rounded towards zero, so that the range is not printed wider than it is.
        let [low, high] = core.spin().map(|rate| if rate < 0.0 { up(rate, 3) } else { down(rate, 3) });
        let mode = &core.mode;
        let which = if *whole { "inside the core" } else { "inside the selected rows of the core" };
        let rate = core.turning().map_or(String::new(), |rate| up(rate, 3));
        let rad_s = Measure { factor: 1.0, unit: "rad/s", whole: None };
        let of_turning = Measure { factor: 100.0, unit: "%", whole: Some("of that rate") };
        let parts = [
            (
                0..rows,
                Measure::WIDTH,
                format!("the core of {mode}"),
                format!("motion {which} of {mode}, for every heading and spins of {low} to {high} rad/s"),
            ),
            (
                rows..turning,
                of_turning,
                format!("the rate of turning in the core of {mode}"),
                format!("thrust turning at no more than {rate} rad/s, for the core of {mode}"),
            ),
            (
                turning..all,
                rad_s,
                format!("the motion's own rate in the core of {mode}"),
                format!("rate of the motion itself among the spins of the core of {mode}"),
            ),
        ];
        let part = |(range, measure, subject, statement): (Range<usize>, Measure, String, String)| {
            let members: Vec<usize> = members.iter().copied().filter(|member| range.contains(member)).collect();
            let family = Family { measure, ..core.family(&self.dynamics).only(&members) };
            (!members.is_empty()).then_some(Part { family, subject, statement })
        };
        parts.into_iter().filter_map(part).collect()
    }
}

impl Checked<'_> {
    /// Checks cores between the nodes.
    pub(super) fn cores_between(&self, purse: &mut WorkLeft, found: &mut Found) {
        for imposed in self.cores.iter().filter(|imposed| !imposed.members.is_empty()) {
            for Part { family, statement, .. } in self.setting.parts(imposed) {
                let reach = self.reach(&family, MOST_OUTSIDE, 1.0, purse);
                found.add(statement, reach);
            }
        }
    }

    /// Adds what a check of the nodes alone shows of cores.
    pub(super) fn cores_at_nodes(&self, found: &mut Found) {
        for imposed in self.cores.iter().filter(|imposed| !imposed.members.is_empty()) {
            let parts = self.setting.parts(imposed).into_iter();
            found.shown.extend(parts.map(|part| Shown::new(part.statement, Reach::NODES)));
        }
    }
}
