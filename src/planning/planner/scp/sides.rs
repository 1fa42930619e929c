//! On which sides legs pass the volumes in their way: several coarse iterates, of which the quickest is refined.

use super::ScpPlanner;
use super::iterate::Iterate;
use super::way_around::{nth_way, obstructed};
use crate::model::Limit;
use std::collections::BTreeMap;

/// The sides of a coarse iterate, for [`ScpPlanner::sides`].
type Sides = BTreeMap<usize, usize>;

impl ScpPlanner<'_, '_> {
    /// Coarse iterates as [`Self::coarse`] makes them, the best first: one on the shortest ways around volumes, and one
    /// on each of the other sides whose initial guess, slowed down until it is inside, is quicker. Without a leg in
    /// whose way a volume lies there is at most one.
    pub(super) fn coarse_on_all_sides(&mut self, shares: Option<&[f64]>, near: f64) -> Vec<(Iterate, Sides)> {
        let first = self.coarse(shares, near);
        let mut found: Vec<(Iterate, Sides)> = first.map(|iterate| (iterate, self.sides.clone())).into_iter().collect();
        for sides in self.quicker_sides(shares, near) {
            if !found.is_empty() && self.has_spent(self.settings.budget.until_other_sides) {
                break;
            }
            self.forget_multipliers();
            let kept = (self.input_weight, std::mem::replace(&mut self.sides, sides.clone()));
            found.extend(self.coarse(shares, near).map(|iterate| (iterate, sides)));
            (self.input_weight, self.sides) = kept;
        }
        // At a given time the iterates that are as short as it differ in their cost.
        let key = |(iterate, _): &(Iterate, Sides)| (iterate.grid.total.max((1.0 + NEARLY) * near), self.cost(iterate));
        found.sort_by(|a, b| {
            let (a, b) = (key(a), key(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        found
    }

    /// The sides among [`Self::other_sides`] whose initial guesses are quicker than that on the shortest ways, the
    /// quickest first.
    fn quicker_sides(&mut self, shares: Option<&[f64]>, near: f64) -> Vec<Sides> {
        let others = self.other_sides();
        if others.is_empty() {
            return others;
        }
        let mut time = |sides: Sides| {
            let kept = std::mem::replace(&mut self.sides, sides);
            let found = self.first_motion(shares, near).map_or(f64::INFINITY, |iterate| iterate.grid.total);
            self.sides = kept;
            found
        };
        let direct = time(Sides::new());
        let mut timed: Vec<(f64, Sides)> = others.into_iter().map(|sides| (time(sides.clone()), sides)).collect();
        timed.retain(|(time, _)| *time < direct);
        timed.sort_by(|a, b| a.0.total_cmp(&b.0));
        timed.into_iter().take(self.settings.guidance.quicker_sides).map(|(_, sides)| sides).collect()
    }

    /// Sides other than those of the shortest ways: for one leg at a time, at most
    /// `GuidanceSettings::sides` in all.
    pub(super) fn other_sides(&self) -> Vec<Sides> {
        let mission = self.problem().mission();
        let most = self.settings.guidance.sides;
        if most == 0 || !mission.limits.iter().any(|limit| limit.kind.is_clearance()) {
            return Vec::new();
        }
        let limits: Vec<&Limit> = mission.limits.iter().collect();
        let ends = mission.waypoints.windows(2).map(|pair| (pair[0].position, pair[1].position));
        let in_the_way: Vec<_> =
            ends.enumerate().filter(|(_, (from, to))| obstructed(&limits, *from, *to).is_some()).collect();
        // Second ways of all legs before third ones.
        let numbered = (1..=most).flat_map(|nth| in_the_way.iter().map(move |leg| (nth, leg)));
        let exists = |&(nth, (_, (from, to))): &(usize, &(usize, _))| nth_way(&limits, *from, *to, nth).is_some();
        numbered.take(2 * most).filter(exists).take(most).map(|(nth, (leg, _))| Sides::from([(*leg, nth)])).collect()
    }
}

/// Times within this share of each other count as equal. Chosen by hand.
const NEARLY: f64 = 1e-3;
