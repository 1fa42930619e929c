//! Continuation in time: plans from iterates that are feasible at another mission time, by slowing down and by
//! shortening.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner};
use crate::motion::NodeState;
use crate::planner::Planned;
use crate::planner::timing::MAX_MISSION_TIME;
use crate::planner::transcription::RowAt;
use std::collections::BTreeSet;

/// Times count as equal within this share.
const ROUNDING: f64 = 1e-9;

impl ScpPlanner<'_, '_> {
    /// The path of an iterate with its shares of time, about as short as is feasible at the nodes. `None` if no
    /// duration up to [`MAX_MISSION_TIME`] is.
    pub(super) fn slowed_until_inside(&self, iterate: &Iterate) -> Option<Iterate> {
        let form = self.transcription(&iterate.grid, &[]);
        let inside = |factor: f64| {
            let slow = iterate.slower(factor);
            let commands_inside = |node: usize| self.command_violation_at(&slow, node * PARTS) <= 0.0;
            // A slower motion is as near to volumes, and arrives from the same directions.
            let violation = |node: usize, s: &NodeState| {
                let all = self.violations_at(&form, s, node * PARTS, || f64::INFINITY);
                let all = all.filter(|(place, _)| !self.is_of_path(*place));
                all.map(|(_, violation)| violation).fold(f64::NEG_INFINITY, f64::max)
            };
            slow.states.iter().enumerate().all(|(node, s)| violation(node, s) <= 0.0)
                && (0..slow.states.len()).all(commands_inside)
        };
        Some(iterate.slower(self.least_slowing(iterate.grid.total, inside)?))
    }

    /// The smallest factor of a duration (s) for which `is_inside` holds, or the smallest that is sought. `None` if it
    /// holds for none up to [`MAX_MISSION_TIME`].
    pub(super) fn least_slowing(&self, duration: f64, is_inside: impl Fn(f64) -> bool) -> Option<f64> {
        let settings = self.settings.slowing;
        let (mut low, mut high) = (0.0, 1.0);
        while !is_inside(high) {
            (low, high) = (high, settings.bracket_growth * high);
            if high * duration > MAX_MISSION_TIME {
                return None;
            }
        }
        while low == 0.0 || high - low > settings.precision * high {
            let middle = if low == 0.0 { settings.bracket_shrink * high } else { 0.5 * (low + high) };
            match is_inside(middle) {
                true => high = middle,
                false => low = middle,
            }
            if high < settings.min_factor {
                break;
            }
        }
        Some(high)
    }

    /// The iterate slowed down by the first of `SlowingSettings::slowdowns` with which it can be restored,
    /// after a short cost phase.
    pub(super) fn restore_feasibility_slower(
        &mut self,
        iterate: &Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let slowdowns = self.settings.slowing.slowdowns;
        slowdowns.into_iter().find_map(|factor| self.restore_feasibility_at(iterate, factor, working_set))
    }

    /// The iterate `factor` times slower, restored, after a short cost phase.
    fn restore_feasibility_at(
        &mut self,
        iterate: &Iterate,
        factor: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (mut known, slower) = (working_set.clone(), iterate.slower(factor));
        let time = slower.grid.total + self.held();
        self.begins_trial(time);
        let restored = self.restore_feasibility(slower, &mut known);
        self.hover.trial.note(time, restored.is_some());
        let restored = restored?;
        *working_set = known;
        Some(self.minimise_cost(restored, self.settings.cost.rough, working_set))
    }

    /// A warm start: a feasible iterate from other plans, the first that can be restored with the smallest slowing
    /// down.
    pub(super) fn warm_start(
        &mut self,
        initial_guesses: &[&Planned],
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        self.hover.effort.starts += initial_guesses.len();
        let iterates: Vec<Iterate> = initial_guesses.iter().map(|planned| self.iterate_of(planned)).collect();
        let slowdowns = self.settings.slowing.slowdowns;
        slowdowns.into_iter().find_map(|factor| {
            iterates.iter().find_map(|iterate| self.restore_feasibility_at(iterate, factor, working_set))
        })
    }

    /// A plan at a mission time by continuation from iterates that are feasible at another: other plans slowed down, or
    /// a first feasible iterate. `None` where waypoints have fixed times, because no motion can then be slowed down as
    /// a whole.
    pub(super) fn by_continuation(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        if self.mission().has_fixed_times() {
            return None;
        }
        let warm_start = self.warm_start(initial_guesses, &mut BTreeSet::new());
        let from_plans = warm_start.and_then(|first| self.brought_to(first, total));
        from_plans.or_else(|| self.first_feasible(total - self.held()).and_then(|first| self.brought_to(first, total)))
    }

    /// The plan of least cost at a mission time, from an iterate that is feasible at another.
    fn brought_to(&mut self, first: Iterate, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let mut working_set = BTreeSet::new();
        let mut iterate = first;
        let settings = self.settings.durations;
        // Steps that end before the time is reached are taken up again with a wide trust region, while they gain.
        while iterate.grid.total > (1.0 + ROUNDING) * flown {
            let before = iterate.grid.total;
            iterate = self.shorten(iterate, &settings.cost_weights, settings.first_radius, flown, &mut working_set)?;
            if iterate.grid.total > (1.0 + ROUNDING) * flown.max((1.0 - settings.min_gain) * before) {
                return None;
            }
        }
        // How a leg's intervals are graded depends on its duration.
        iterate = self.on_its_own_grid(self.lasting(&iterate, flown), &mut working_set);
        let lasting = self.lasting(&iterate, flown);
        self.restored_plan(lasting, total, self.settings.cost.close, &mut working_set)
    }
}
