//! Plans at a given mission time, from the initial guesses in turn.

use super::iterate::Iterate;
use super::{ScpPlanner, settings};
use crate::model::{Leg, Mission};
use crate::motion::time_grid::time_grid;
use crate::motion::time_grid::{LegGrid, Segment, TimeGrid};
use crate::planner::scp::relaxation::RelaxationOutcome;
use crate::planner::timing::kinematics;
use crate::planner::transcription::RowAt;
use crate::planner::{Decision, Planned};
use settings::StoppingRule;
use std::collections::BTreeSet;

/// The status where no plan is found and none is proved infeasible.
pub const NOT_FOUND: &str = "no plan found";

impl ScpPlanner<'_, '_> {
    /// The mission's time grid over `total` s with `samples` intervals. Legs take these shares of the time, or the
    /// mission's own; `None` if some leg has no time.
    pub(super) fn lay_out(&self, shares: Option<&[f64]>, total: f64, samples: usize) -> Option<TimeGrid> {
        match shares {
            None => time_grid(self.mission(), total, samples),
            Some(shares) => {
                let legs = shares.iter().map(|&share| Leg { share }).collect();
                time_grid(&Mission { legs, ..self.mission().clone() }, total, samples)
            }
        }
    }

    /// The time grid of the first division tried at a mission time: the spec's, or where the planner chooses durations,
    /// shares as the limits of each leg need them.
    fn first_division(&self, total: f64, samples: usize) -> Option<TimeGrid> {
        let initial = self.chooses_times().then(|| kinematics::initial(self.problem()));
        self.lay_out(initial.as_deref(), total, samples)
    }

    /// The sum of all holds, s.
    pub(super) fn held(&self) -> f64 {
        self.mission().waypoints.iter().map(|w| w.hold).sum()
    }

    /// A plan of the mission as an initial guess.
    pub(super) fn iterate_of(&self, planned: &Planned) -> Iterate {
        let grid = planned.grid.flown();
        Iterate { states: planned.grid.without_holds(&planned.states), grid, model: self.wrench }
    }

    /// The divisions of a mission time that are tried unchanged: [`Self::first_division`] and, where the planner
    /// chooses durations, the one by lengths. Empty if some leg has no time.
    fn divisions(&self, total: f64) -> Vec<TimeGrid> {
        let samples = self.model().plan.samples;
        let by_length = self.chooses_times().then(|| self.lay_out(None, total, samples)).flatten();
        self.first_division(total, samples).into_iter().chain(by_length).collect()
    }

    /// The first plan found on these time grids. The plans in `initial_guesses` are used on the first grid only.
    fn on_one_of(&mut self, divisions: &[TimeGrid], initial_guesses: &[&Planned]) -> Option<Planned> {
        divisions.iter().enumerate().find_map(|(nth, full)| {
            self.begins_trial(full.total);
            let planned = self.on_grid(full, if nth == 0 { initial_guesses } else { &[] });
            self.hover.trial.note(full.total, planned.is_some());
            planned
        })
    }

    /// A plan on one of the first divisions of a mission time; the quick part of [`Self::decide`].
    pub(super) fn on_first_divisions(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        let divisions = self.divisions(total);
        self.on_one_of(&divisions, initial_guesses)
    }

    /// Decides a mission time, s: the first plan found from the minimum-snap motion, from `initial_guesses` (plans of
    /// any set), from the relaxation's solution or by continuation from slower motions; a proof by the relaxation (74)
    /// or the kinematic bound that there is none; or neither, which is `Inconclusive(NOT_FOUND)`.
    pub fn decide(&mut self, total: f64, initial_guesses: &[&Planned]) -> Decision {
        if self.hover.is_too_short(total) {
            return Decision::Infeasible;
        }
        let divisions = self.divisions(total);
        let Some(full) = divisions.first() else { return Decision::Infeasible };
        if let Some(planned) = self.on_one_of(&divisions, initial_guesses) {
            return Decision::Feasible(Box::new(planned));
        }
        // A proof for one division of the time is not one for all. A proof costs less than continuation from a slower
        // motion, and without one the relaxation's own solution, which keeps every limit, is an initial guess.
        match self.relaxed(&full.flown()) {
            RelaxationOutcome::Infeasible if !self.chooses_times() => return Decision::Infeasible,
            RelaxationOutcome::Feasible(Some(iterate)) => {
                if let Some(planned) = self.plan_from_relaxation(iterate, total) {
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

    /// A quick decision at a mission time, for callers that need dozens. A proof by the relaxation is returned as it
    /// is; otherwise the feasibility phase runs with two initial guesses, the relaxation's solution, which keeps every
    /// limit, and the minimum-snap motion. If `minimised`, or with the second guess, a short cost phase follows.
    pub fn attempt(&mut self, total: f64, minimised: bool) -> Decision {
        if self.hover.is_too_short(total) {
            return Decision::Infeasible;
        }
        let samples = self.model().plan.samples;
        let Some(full) = self.first_division(total, samples) else { return Decision::Infeasible };
        self.begins_trial(total);
        let flown = full.flown();
        let relaxed = match self.relaxed(&flown) {
            // A proof for one division of the time is not one for all.
            RelaxationOutcome::Infeasible if self.chooses_times() => return Decision::Inconclusive(NOT_FOUND.into()),
            RelaxationOutcome::Infeasible => return Decision::Infeasible,
            RelaxationOutcome::Feasible(iterate) => iterate,
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

    /// A plan on a time grid, from the minimum-snap motion or from another plan flown in the same time: the first that
    /// is found, or a cheaper one from a plan that costs less and is feasible as it is, so that plans of smaller sets
    /// are seldom cheaper.
    pub(super) fn on_grid(&mut self, full: &TimeGrid, initial_guesses: &[&Planned]) -> Option<Planned> {
        let flown = full.total - self.held();
        let fixed = self.mission().has_fixed_times();
        let mut working_set = BTreeSet::new();
        let close = self.settings.cost.close;
        let smooth = self.minimum_snap(&full.flown());
        let mut found = smooth.and_then(|iterate| self.restored_plan(iterate, full.total, close, &mut working_set));
        // Where waypoints have fixed times another plan serves only if it has the same durations, or the same mission
        // time where the planner chooses the division.
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
            let worth =
                |found: &Planned| self.cost(&scaled) < found.objective && self.largest_violation(&scaled) <= 0.0;
            if found.as_ref().is_none_or(worth) {
                let kept = self.restored_plan(scaled, full.total, close, &mut working_set);
                found = kept.into_iter().chain(found).min_by(|a, b| a.objective.total_cmp(&b.objective));
            }
        }
        found.or_else(|| self.on_grid_by_other_sides(full))
    }

    /// A plan on a time grid from the minimum-snap motion on other sides of the volumes in its way; the first that is
    /// found.
    fn on_grid_by_other_sides(&mut self, full: &TimeGrid) -> Option<Planned> {
        let others = self.other_sides();
        others.into_iter().take(self.settings.guidance.quicker_sides).find_map(|sides| {
            let kept = std::mem::replace(&mut self.sides, sides);
            let smooth = self.minimum_snap(&full.flown());
            let close = self.settings.cost.close;
            let found = smooth.and_then(|iterate| self.restored_plan(iterate, full.total, close, &mut BTreeSet::new()));
            if found.is_none() {
                self.sides = kept;
            }
            found
        })
    }

    /// A plan from the relaxation's solution: of least cost, or without a cost phase if its result is not feasible
    /// between instants.
    fn plan_from_relaxation(&mut self, iterate: Iterate, total: f64) -> Option<Planned> {
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

    /// The plan of least cost from a feasible iterate, with holds: the cost phase and the tightening. `None` if the
    /// tightening fails.
    pub(super) fn finished_plan(
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
        let grid = TimeGrid::with_legs(self.mission(), &legs, total);
        Some(Planned {
            states: grid.with_holds(&minimised.states),
            grid,
            model: self.wrench,
            objective: self.cost(&minimised),
            rows: working_set.len(),
        })
    }
}
