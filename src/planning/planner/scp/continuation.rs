//! Continuation in time: feasible iterates at another mission time than the one required, by slowing down and by
//! shortening.

use super::*;
use crate::motion::time_grid::has_fixed_times;
use crate::planner::timing::MAX_MISSION_TIME;
use settings::{ShorteningWeights, TimeSteps};

/// Rounding of times, as a share: they count as equal within it.
const ROUNDING: f64 = 1e-12;

/// How far a step shortens the duration.
#[derive(Debug, Clone, Copy)]
enum Shorter {
    /// By as much as the linear model allows, at most by the first share of the duration; less than the second share is
    /// a failure.
    UpTo(f64, f64),
    /// By this share of the duration, even if the linear model predicts a violation: the feasibility phase may still
    /// remove it.
    By(f64),
}

impl ScpPlanner<'_, '_> {
    /// Shortens all durations alike: one subproblem about the iterate as it is, because the same iterate flown faster
    /// can be far outside the set, where the linear model predicts nothing; then the feasibility phase. `None` if
    /// either fails.
    fn shorten_alike(
        &mut self,
        iterate: &Iterate,
        shorter: Shorter,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let settings = self.settings.descent;
        let (range, objective, weights, least) = match shorter {
            Shorter::UpTo(share, least) => ((-share, 0.0), Objective::Time, settings.free_duration, least),
            Shorter::By(share) => ((-share, -share), Objective::Cost, settings.given_duration, 0.0),
        };
        let ShorteningWeights { proximal, cost: cost_weight } = weights;
        let durations = Durations { legs: vec![Some(0); self.hover.mission().legs.len()], range, spans: Vec::new() };
        let weights = Weights { objective, penalty: settings.penalty, cost_weight, input_weight: 0.0 };
        let stepped = self.step(iterate, &durations, ProximalWeight { weight: proximal }, weights, working_set)?;
        if stepped.changes[0] > -least {
            return None;
        }
        if stepped.sigma > self.settings.feasibility.max_predicted {
            return None;
        }
        self.restore_feasibility(iterate.stepped(&stepped.states, &stepped.changes), working_set)
    }

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
        let settings = self.settings.descent;
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

    /// The iterate slowed down by the first of [`settings::DescentSettings::slowdowns`] with which it can be restored,
    /// after a short cost phase.
    pub(super) fn restore_feasibility_slower(
        &mut self,
        iterate: &Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let slowdowns = self.settings.descent.slowdowns;
        slowdowns.into_iter().find_map(|factor| self.restore_feasibility_at(iterate, factor, working_set))
    }

    /// The iterate `factor` times slower, restored, after a short cost phase.
    fn restore_feasibility_at(
        &mut self,
        iterate: &Iterate,
        factor: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let mut known = working_set.clone();
        let restored = self.restore_feasibility(iterate.slower(factor), &mut known)?;
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
        let slowdowns = self.settings.descent.slowdowns;
        slowdowns.into_iter().find_map(|factor| {
            iterates.iter().find_map(|iterate| self.restore_feasibility_at(iterate, factor, working_set))
        })
    }

    /// Continuation in time: a feasible iterate is shortened step by step down to `target` s of flight, with a short
    /// cost phase after each step, because smooth motions stay away from the attitudes at which the wrench is most
    /// curved. Steps are first as long as the linear model allows; after one closer cost phase they are given, even if
    /// the linear model predicts a violation.
    pub(super) fn descend(
        &mut self,
        mut iterate: Iterate,
        steps: TimeSteps,
        target: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let settings = self.settings.descent;
        let mut step = steps.first;
        let mut minimised = false;
        while step >= steps.min && iterate.grid.total > (1.0 + ROUNDING) * target {
            let last = 1.0 - target / iterate.grid.total;
            let shorter = match last <= step {
                true => Shorter::By(last),
                false if minimised => Shorter::By(step),
                false => Shorter::UpTo(step, settings.worthwhile * steps.min),
            };
            self.hover.progress((1.0 - step.min(last)) * iterate.grid.total + self.held());
            let mut known = working_set.clone();
            match self.shorten_alike(&iterate, shorter, &mut known) {
                Some(inside) => {
                    *working_set = known;
                    iterate = self.minimise_cost(inside, self.settings.cost.rough, working_set);
                    step = (settings.growth * step).min(steps.first);
                }
                None => {
                    step *= settings.shrink;
                    // The nearer an iterate is to the least cost, the further it can be shortened, and the feasibility
                    // phase may reach what the linear model does not predict: tried once.
                    if step < steps.min && !minimised {
                        iterate = self.minimise_cost(iterate, self.settings.cost.medium, working_set);
                        minimised = true;
                        step = steps.min.max(settings.shrink * settings.shrink * steps.first);
                    }
                }
            }
        }
        iterate
    }

    /// A plan at a mission time by continuation from iterates that are feasible at another: other plans slowed down, or
    /// a first feasible iterate. `None` where waypoints have fixed times, because no motion can then be slowed down as
    /// a whole.
    pub(super) fn by_continuation(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        if has_fixed_times(self.hover.mission()) {
            return None;
        }
        let warm_start = self.warm_start(initial_guesses, &mut BTreeSet::new());
        let from_plans = warm_start.and_then(|first| self.brought_to(first, total));
        from_plans.or_else(|| self.first_feasible(total - self.held()).and_then(|first| self.brought_to(first, total)))
    }

    /// The plan of least cost at a mission time, from an iterate that is feasible at another: with all legs changed
    /// alike, and if that fails and the planner chooses durations, with each leg shortened by itself.
    fn brought_to(&mut self, first: Iterate, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let alike = self.brought_alike(first.clone(), total);
        if alike.is_some() || !self.chooses_times() || first.grid.total <= flown {
            return alike;
        }
        let weights = self.settings.durations.cost_weights;
        let shorter = self.optimise_durations(first, &weights, flown, &mut BTreeSet::new());
        self.brought_alike(shorter, total)
    }

    /// The plan of least cost at a mission time, from an iterate whose legs keep their shares of the time.
    fn brought_alike(&mut self, first: Iterate, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let mut working_set = BTreeSet::new();
        let iterate = match first.grid.total <= flown {
            true => self.restore_feasibility(first.slower(flown / first.grid.total), &mut working_set)?,
            false => self.descend(first, self.settings.descent.on_full_grid, flown, &mut working_set),
        };
        let there = (iterate.grid.total - flown).abs() <= 1e-9 * flown;
        there.then(|| self.finished_plan(iterate, total, self.settings.cost.close, &mut working_set)).flatten()
    }
}
