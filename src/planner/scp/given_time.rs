//! Plans at a given mission time, and continuation to shorter times, each from the plan of least cost at the last.

use super::*;
use crate::model::{Leg, Mission};
use crate::motion::time_grid::{has_fixed_times, time_grid};
use crate::planner::hover::Decision;
use crate::planner::scp::phases::Shorter;
use crate::planner::scp::relaxation::Verdict;
use crate::planner::timing::{MAX_MISSION_TIME, kinematics};
use settings::{StoppingRule, TimeSteps};

/// Rounding of times, as a share: they count as equal within it.
const ROUNDING: f64 = 1e-12;

/// The status where no plan is found and none is proved infeasible.
pub const NOT_FOUND: &str = "no plan found";

impl ScpPlanner<'_, '_> {
    /// The mission's time grid over `total` s with `samples` intervals. Legs take these shares of the time, or the mission's own;
    /// `None` if some leg has no time.
    pub(super) fn lay_out(&self, shares: Option<&[f64]>, total: f64, samples: usize) -> Option<TimeGrid> {
        match shares {
            None => time_grid(self.hover.mission, total, samples),
            Some(shares) => {
                let legs = shares.iter().map(|&share| Leg { share }).collect();
                time_grid(&Mission { legs, ..self.hover.mission.clone() }, total, samples)
            }
        }
    }

    /// The time grid of the first division tried at a mission time: the spec's, or where the planner chooses durations, shares as
    /// the limits of each leg need them.
    fn first_division(&self, total: f64, samples: usize) -> Option<TimeGrid> {
        let initial = self.chooses_times().then(|| kinematics::initial(self.hover.model, self.hover.mission));
        self.lay_out(initial.as_deref(), total, samples)
    }

    /// The sum of all holds, s.
    pub(super) fn held(&self) -> f64 {
        self.hover.mission.waypoints.iter().map(|w| w.hold).sum()
    }

    /// The same path with the same shares of time, about as short as is feasible at the nodes. `None` if no duration up to
    /// [`MAX_MISSION_TIME`] is.
    pub(super) fn slowed_until_inside(&self, iterate: &Iterate) -> Option<Iterate> {
        let form = self.transcription(&iterate.grid, &[]);
        let inside = |factor: f64| {
            let slow = iterate.slower(factor);
            let commands_inside = |node: usize| self.command_violation_at(&slow, node * PARTS) <= 0.0;
            slow.states.iter().enumerate().all(|(node, s)| self.violation_at(&form, s, node * PARTS) <= 0.0)
                && (0..slow.states.len()).all(commands_inside)
        };
        let (mut low, mut high) = (0.0, 1.0);
        while !inside(high) {
            (low, high) = (high, 1.5 * high);
            if high * iterate.grid.total > MAX_MISSION_TIME {
                return None;
            }
        }
        while low == 0.0 || high - low > self.settings.descent.precision * high {
            let middle = if low == 0.0 { 0.7 * high } else { 0.5 * (low + high) };
            match inside(middle) {
                true => high = middle,
                false => low = middle,
            }
            if high < 1e-3 {
                break;
            }
        }
        Some(iterate.slower(high))
    }

    /// The iterate slowed down by the first of [`settings::DescentSettings::slowdowns`] with which it can be restored, after a
    /// short cost phase.
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

    /// Continuation in time: a feasible iterate is shortened step by step down to `target` s of flight, with a short cost phase after
    /// each step, because smooth motions stay away from the attitudes at which the wrench is most curved. Steps are first as long as
    /// the linear model allows; after one closer cost phase they are given, even if the linear model predicts a violation.
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
                    // The nearer an iterate is to the least cost, the further it can be shortened, and the feasibility phase may
                    // reach what the linear model does not predict: tried once.
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

    /// A plan of the mission as an initial guess.
    pub(super) fn iterate_of(&self, planned: &Planned) -> Iterate {
        let grid = planned.grid.flown();
        Iterate { states: planned.grid.without_holds(&planned.states), grid, model: self.wrench }
    }

    /// A warm start: a feasible iterate from other plans, the first that can be restored with the smallest slowing down.
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

    /// Whether the kinematic lower bound rules out a mission time for every division among the legs. Only asked where the planner
    /// chooses the division; a given one is decided by the relaxation, which proves more.
    fn is_too_short(&self, total: f64) -> bool {
        let (model, mission) = (self.hover.model, self.hover.mission);
        self.chooses_times() && kinematics::least_time_within(model, mission).is_above(total)
    }

    /// The divisions of a mission time that are tried unchanged: [`Self::first_division`] and, where the planner chooses durations,
    /// the one by lengths. Empty if some leg has no time.
    fn divisions(&self, total: f64) -> Vec<TimeGrid> {
        let samples = self.hover.model.plan.samples;
        let by_length = self.chooses_times().then(|| self.lay_out(None, total, samples)).flatten();
        self.first_division(total, samples).into_iter().chain(by_length).collect()
    }

    /// The first plan found on these time grids. The plans in `initial_guesses` are used on the first grid only.
    fn on_one_of(&mut self, divisions: &[TimeGrid], initial_guesses: &[&Planned]) -> Option<Planned> {
        divisions.iter().enumerate().find_map(|(nth, full)| {
            self.hover.progress(full.total);
            self.on_grid(full, if nth == 0 { initial_guesses } else { &[] })
        })
    }

    /// A plan on one of the first divisions of a mission time; the quick part of [`Self::decide`].
    pub(super) fn on_first_divisions(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        let divisions = self.divisions(total);
        self.on_one_of(&divisions, initial_guesses)
    }

    /// Decides a mission time, s: the first plan found from the minimum-snap motion, from `initial_guesses` (plans of any set),
    /// from the relaxation's solution or by continuation from slower motions; a proof by the relaxation (74) or the kinematic bound
    /// that there is none; or neither, which is `Inconclusive(NOT_FOUND)`.
    pub fn decide(&mut self, total: f64, initial_guesses: &[&Planned]) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let divisions = self.divisions(total);
        let Some(full) = divisions.first() else { return Decision::Infeasible };
        if let Some(planned) = self.on_one_of(&divisions, initial_guesses) {
            return Decision::Feasible(Box::new(planned));
        }
        // A proof for one division of the time is not one for all. A proof costs less than continuation from a slower motion, and
        // without one the relaxation's own solution, which keeps every limit, is an initial guess.
        match self.relaxed(&full.flown()) {
            Verdict::Infeasible if !self.chooses_times() => return Decision::Infeasible,
            Verdict::Feasible(Some(iterate)) => {
                if let Some(planned) = self.from_relaxation(iterate, total) {
                    return Decision::Feasible(Box::new(planned));
                }
            }
            _ => {}
        }
        let planned = match self.divides_spans() {
            true => self.divided_anew(total, &divisions),
            false => self.by_continuation(total, initial_guesses),
        };
        match planned {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// A quick decision at a mission time, for callers that need dozens. A proof by the relaxation is returned as it is; otherwise
    /// the feasibility phase runs with two initial guesses, the relaxation's solution, which keeps every limit, and the
    /// minimum-snap motion. If `minimised`, or with the second guess, a short cost phase follows.
    pub fn attempt(&mut self, total: f64, minimised: bool) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let samples = self.hover.model.plan.samples;
        let Some(full) = self.first_division(total, samples) else { return Decision::Infeasible };
        self.hover.progress(total);
        let flown = full.flown();
        let relaxed = match self.relaxed(&flown) {
            // A proof for one division of the time is not one for all.
            Verdict::Infeasible if self.chooses_times() => return Decision::Inconclusive(NOT_FOUND.into()),
            Verdict::Infeasible => return Decision::Infeasible,
            Verdict::Feasible(iterate) => iterate,
        };
        let rough = self.settings.cost.rough;
        let quickly = if minimised { rough } else { StoppingRule::NO_STEPS };
        let planned = relaxed
            .and_then(|iterate| self.restored_plan(iterate, total, quickly, &mut BTreeSet::new()))
            .or_else(|| {
                let smooth = self.minimum_snap(&flown)?;
                self.restored_plan(smooth, total, rough, &mut BTreeSet::new())
            });
        match planned {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// A plan on a time grid, from the minimum-snap motion or from another plan flown in the same time: the first that is found,
    /// or a cheaper one from a plan that costs less and is feasible as it is, so that plans of smaller sets are seldom cheaper.
    pub(super) fn on_grid(&mut self, full: &TimeGrid, initial_guesses: &[&Planned]) -> Option<Planned> {
        let flown = full.total - self.held();
        let fixed = has_fixed_times(self.hover.mission);
        let mut working_set = BTreeSet::new();
        let close = self.settings.cost.close;
        let smooth = self.minimum_snap(&full.flown());
        let mut found = smooth.and_then(|iterate| self.restored_plan(iterate, full.total, close, &mut working_set));
        // Where waypoints have fixed times another plan serves only if it has the same durations, or the same mission time where
        // the planner chooses the division.
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * full.total;
        let divides = self.chooses_times();
        let as_long = |other: &Iterate| {
            let pairs = other.grid.segments.iter().zip(full.segments.iter().filter(|s| !s.hold));
            match divides {
                true => same(other.grid.total, flown),
                false => pairs.into_iter().all(|(a, b)| same(a.duration, b.duration)),
            }
        };
        for planned in initial_guesses {
            let other = self.iterate_of(planned);
            if fixed && !as_long(&other) {
                continue;
            }
            let scaled = if fixed { other } else { other.slower(flown / other.grid.total) };
            let worth = |found: &Planned| self.cost(&scaled) < found.objective && self.violation(&scaled) <= 0.0;
            if found.as_ref().is_none_or(worth) {
                let kept = self.restored_plan(scaled, full.total, close, &mut working_set);
                found = kept.into_iter().chain(found).min_by(|a, b| a.objective.total_cmp(&b.objective));
            }
        }
        found
    }

    /// A plan at a mission time by continuation from iterates that are feasible at another: other plans slowed down, or a first
    /// feasible iterate. `None` where waypoints have fixed times, because no motion can then be slowed down as a whole.
    fn by_continuation(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        if has_fixed_times(self.hover.mission) {
            return None;
        }
        let warm_start = self.warm_start(initial_guesses, &mut BTreeSet::new());
        let from_plans = warm_start.and_then(|first| self.brought_to(first, total));
        from_plans.or_else(|| self.first_feasible(total - self.held()).and_then(|first| self.brought_to(first, total)))
    }

    /// The plan of least cost at a mission time, from an iterate that is feasible at another: with all legs changed alike, and if
    /// that fails and the planner chooses durations, with each leg shortened by itself.
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

    /// The same without changes of the legs' shares of the time.
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

    /// A plan from the relaxation's solution: of least cost, or without a cost phase if its result is not feasible between instants.
    fn from_relaxation(&mut self, iterate: Iterate, total: f64) -> Option<Planned> {
        let mut working_set = BTreeSet::new();
        let inside = self.restore_feasibility(iterate, &mut working_set)?;
        [self.settings.cost.close, StoppingRule::NO_STEPS]
            .into_iter()
            .find_map(|rule| self.finished_plan(inside.clone(), total, rule, &mut working_set.clone()))
    }

    /// The feasibility phase from an initial guess, then [`Self::finished_plan`].
    pub(super) fn restored_plan(
        &mut self,
        iterate: Iterate,
        total: f64,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Planned> {
        let inside = self.restore_feasibility(iterate, working_set)?;
        self.finished_plan(inside, total, rule, working_set)
    }

    /// The plan of least cost from a feasible iterate, with holds: the cost phase and the tightening. `None` if the tightening fails.
    fn finished_plan(
        &mut self,
        iterate: Iterate,
        total: f64,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Planned> {
        let mut minimised = self.minimise_cost_between_instants(iterate, rule, working_set)?;
        // Interpolation at other nodes leaves rounding errors where the iterate rests.
        for (node, axis, order) in self.transcription(&minimised.grid, &[]).at_rest() {
            minimised.states[node][axis][order] = 0.0;
        }
        let legs: Vec<LegGrid> = minimised.grid.segments.iter().map(Segment::leg_grid).collect();
        let grid = TimeGrid::with_legs(self.hover.mission, &legs, total);
        Some(Planned {
            states: grid.with_holds(&minimised.states),
            grid,
            model: self.wrench,
            objective: self.cost(&minimised),
            rows: working_set.len(),
        })
    }
}
