//! Gaps looked at again, about branches that were not known when they were looked at first: those of the instants after
//! them, and those of other modes. A fault of another rotor often leaves the vehicle in nearly the same state.

use super::{Found, Search};
use crate::model::{LandingSite, Recovery};
use crate::motion::NodeState;
use crate::planner::branch::Goal;
use crate::recovery::{RESOLUTION, Way, steps};
use std::ops::Range;

/// Branches of other modes that are tried at an instant, those first whose start is nearest. Chosen by hand.
const LENT: usize = 3;

impl Search<'_> {
    /// Ways out at instants of gaps of `own`, the outcomes found first, in the order of time. `others` are the outcomes
    /// of other modes.
    pub(in crate::flights::recovery) fn again(&mut self, own: &[Found], others: &[&[Found]]) -> Vec<Found> {
        let mut fresh = Vec::new();
        for gap in gaps(own) {
            let mut open = gap.clone();
            if let Some(after) = own.get(gap.end) {
                let found = self.spread(own, after, gap.rev());
                open.end -= found.len();
                fresh.extend(found);
            }
            for probe in [open.start, open.start + open.len() / 2, open.end.saturating_sub(1)] {
                if !open.contains(&probe) {
                    continue;
                }
                let Some(found) = self.lent(own[probe].at, others) else { continue };
                let before = self.spread(own, &found, (open.start..probe).rev());
                let after = self.spread(own, &found, probe + 1..open.end);
                open.start = probe + 1 + after.len();
                fresh.extend(before.into_iter().chain([found]).chain(after));
            }
        }
        fresh.sort_by(|a, b| a.at.total_cmp(&b.at));
        fresh
    }

    /// Puts ways out in the place of gaps at the same instants, and looks for the times at which outcomes then change.
    pub(super) fn mended(&mut self, mut found: Vec<Found>, fresh: Vec<Found>) -> Vec<Found> {
        if fresh.is_empty() {
            return found;
        }
        for one in fresh {
            if let Some(gap) = found.iter_mut().find(|gap| gap.at == one.at) {
                *gap = one;
            }
        }
        let mut all: Vec<Found> = Vec::with_capacity(found.len());
        for next in found {
            if let Some(before) = all.pop() {
                self.between(before, &next, &mut all);
            }
            all.push(next);
        }
        self.with_one_bisection(all)
    }

    /// Without the instants of the first bisection at which no gap begins or ends any more.
    fn with_one_bisection(&self, found: Vec<Found>) -> Vec<Found> {
        let step = self.plan.duration() / steps(self.plan.duration());
        let is_first = |at: f64| (at / step - (at / step).round()).abs() < 1e-9;
        let open: Vec<bool> = found.iter().map(|found| found.way.is_none()).collect();
        let is_at_change =
            |k: usize| open.get(k + 1) != Some(&open[k]) || k.checked_sub(1).map(|k| open[k]) != Some(open[k]);
        let mut place = 0..found.len();
        found.into_iter().filter(|found| place.next().is_some_and(|k| is_first(found.at) || is_at_change(k))).collect()
    }

    /// Adds an outcome and, if a gap begins or ends before the next, those with which its end is known to
    /// [`RESOLUTION`].
    fn between(&mut self, before: Found, after: &Found, all: &mut Vec<Found>) {
        let is_gap_beside_way = before.way.is_none() != after.way.is_none();
        if !is_gap_beside_way || after.at - before.at <= RESOLUTION {
            all.push(before);
            return;
        }
        let at = 0.5 * (before.at + after.at);
        let known = if before.way.is_some() { &before } else { after };
        let middle = self.about(at, known).unwrap_or_else(|| Found::none(at));
        self.between(before, &middle, all);
        self.between(middle, after, all);
    }

    /// Ways out at instants of `own` one after the other, each about the one before, up to the first without.
    fn spread(&mut self, own: &[Found], from: &Found, instants: impl Iterator<Item = usize>) -> Vec<Found> {
        let mut found: Vec<Found> = Vec::new();
        for instant in instants {
            let Some(next) = self.about(own[instant].at, found.last().unwrap_or(from)) else { break };
            found.push(next);
        }
        found
    }

    /// A way out about those of other modes at the same instant, or at the nearest one.
    fn lent(&mut self, at: f64, others: &[&[Found]]) -> Option<Found> {
        let start = self.carried(at, *self.delays.last()?)?.state;
        let nearest = |other: &&[Found]| -> Option<usize> {
            let ways = (0..other.len()).filter(|&k| other[k].way.is_some());
            ways.min_by(|&a, &b| (other[a].at - at).abs().total_cmp(&(other[b].at - at).abs()))
        };
        let mut lent: Vec<&Found> = others.iter().filter_map(|other| Some(&other[nearest(other)?])).collect();
        let distance = |found: &Found| found.iterates.last().map_or(f64::INFINITY, |it| apart(&it.states[0], &start));
        lent.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        lent.into_iter().take(LENT).find_map(|known| self.about(at, known))
    }

    /// A way out at an instant for each delay, about the branches of another instant or mode; `None` where its kind is
    /// not one of this mode's.
    fn about(&mut self, at: f64, known: &Found) -> Option<Found> {
        let (mission, order) = (self.problem.mission(), self.problem.model().recovery(self.mode));
        let way = match known.way? {
            Way::LandHere | Way::Caught => return None,
            Way::LandAt(site) => {
                order.iter().any(|of| mission.sites_of(*of).contains(&site)).then_some(Way::LandAt(site))
            }
            Way::Continue | Way::ContinueSpinning => order.contains(&Recovery::Continue).then(|| self.back()),
        }?;
        let carried = self.all_carried(at)?;
        self.for_each_delay(at, &carried, way, |search, start| {
            let known = known.iterates.get(start.index)?;
            let joins = at + start.delay + known.grid.total;
            let goal = match way {
                Way::LandAt(site) => {
                    let LandingSite { at, radius, .. } = search.problem.mission().after_fault.sites[site];
                    Goal::Ground { at, radius }
                }
                _ if search.last_outside > joins => return None,
                _ => Goal::Rejoin(search.planned(joins)),
            };
            search.branch(start.state, [Some(known), None], &[], |_, _| goal)
        })
    }
}

/// The places of instants in a row without a way out.
fn gaps(found: &[Found]) -> Vec<Range<usize>> {
    let mut all: Vec<Range<usize>> = Vec::new();
    for (k, _) in found.iter().enumerate().filter(|(_, found)| found.way.is_none()) {
        match all.last_mut().filter(|gap| gap.end == k) {
            Some(gap) => gap.end = k + 1,
            None => all.push(k..k + 1),
        }
    }
    all
}

/// How far two states are apart, by their places (m), velocities (m/s) and accelerations (m/s^2).
fn apart(a: &NodeState, b: &NodeState) -> f64 {
    a.iter().zip(b).flat_map(|(a, b)| a.iter().zip(b).take(3)).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
