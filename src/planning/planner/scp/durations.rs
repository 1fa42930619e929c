//! Waypoint times: durations of legs as variables of the steps, within a trust region.

use super::*;
use crate::model::grid::{fewest_pieces, is_coarser, pieces};

impl ScpPlanner<'_, '_> {
    /// Whether the planner chooses the waypoint times.
    pub(super) fn chooses_times(&self) -> bool {
        self.hover.model().plan.chooses_times && self.hover.mission().leaves_times_free()
    }

    /// Shortens a feasible iterate by steps in which each leg has its own change of duration. Each step is restored
    /// with the new durations and kept if the mission has become shorter; only a change of grid can lengthen it, by at
    /// most the largest of [`settings::GridSettings::slowdowns`]. The steps end at `target` s of flight. `cost_weights`
    /// are the relative weights of the cost, one after the other ([`settings::DurationSettings`]).
    pub(super) fn optimise_durations(
        &mut self,
        mut iterate: Iterate,
        cost_weights: &[f64],
        target: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let settings = self.settings.durations;
        let mut left = settings.max_steps;
        let mut totals = Vec::new();
        for (nth, &weight) in cost_weights.iter().enumerate() {
            if nth > 0 {
                iterate = self.minimise_cost(iterate, self.settings.cost.medium, working_set);
            }
            iterate = self.shorten_legs(iterate, weight, target, &mut left, working_set);
            iterate = self.on_its_own_grid(iterate, working_set);
            totals.push(iterate.grid.total);
        }
        if let [first, .., last] = totals[..]
            && last > (1.0 - settings.min_gain) * first
        {
            iterate = self.shorten_legs(iterate, settings.last_cost_weight, target, &mut left, working_set);
            iterate = self.on_its_own_grid(iterate, working_set);
        }
        iterate
    }

    /// The iterate on the grid of its own durations if some leg has longer pieces than that grid ([`is_coarser`]);
    /// unchanged if it cannot be restored there.
    pub(super) fn on_its_own_grid(&mut self, iterate: Iterate, working_set: &mut BTreeSet<RowAt>) -> Iterate {
        let mission = self.hover.mission();
        let segments = &iterate.grid.segments;
        let durations: Vec<f64> = segments.iter().map(|s| s.duration).collect();
        let samples = iterate.grid.intervals() + mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
        let fewest = fewest_pieces(mission, &durations, samples);
        let nodes = |s: &Segment| &iterate.grid.node_times[s.first_node..=s.first_node + s.intervals];
        if segments.iter().zip(fewest).all(|(s, fewest)| !is_coarser(mission, nodes(s), fewest)) {
            return iterate;
        }
        let due = durations.iter().zip(pieces(mission, &durations, samples)).map(|(&d, n)| LegGrid::new(d, n));
        let due: Vec<LegGrid> = due.collect();
        let own = TimeGrid::with_legs(mission, &due, iterate.grid.total + self.held()).flown();
        let there = iterate.on(&own);
        let max_predicted = self.settings.feasibility.max_predicted_after_change;
        for factor in self.settings.grids.slowdowns {
            // The rows of a working set are numbered by the instants of one grid.
            let mut known = BTreeSet::new();
            let slower = self.lasting(&there, factor * own.total);
            if let Some(inside) = self.restore_feasibility_within(slower, max_predicted, &mut known) {
                *working_set = known;
                return inside;
            }
        }
        iterate
    }

    /// The steps of [`Self::optimise_durations`] with one weight of the cost, at most `left` of them.
    fn shorten_legs(
        &mut self,
        mut iterate: Iterate,
        cost_weight: f64,
        target: f64,
        left: &mut usize,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let spans = self.spans();
        let legs = self.changing(&spans);
        let settings = self.settings.durations;
        let max_predicted = self.settings.feasibility.max_predicted_after_change;
        let (objective, penalty) = (Objective::Time, settings.penalty);
        let weights = Weights { objective, penalty, cost_weight, input_weight: 0.0 };
        let mut proximal = ProximalWeight { weight: settings.proximal_weight };
        let mut radius = settings.initial_radius;
        while radius >= settings.min_radius && *left > 0 && iterate.grid.total > target {
            *left -= 1;
            self.hover.progress(iterate.grid.total + self.held());
            let mut known = working_set.clone();
            let durations = Durations { legs: legs.clone(), range: (-radius, radius), spans: spans.clone() };
            let stepped = self.step(&iterate, &durations, proximal, weights, &mut known);
            let reached = stepped.map(|stepped| iterate.stepped(&stepped.states, &stepped.changes));
            if reached.as_ref().is_some_and(|r| r.grid.total > (1.0 - settings.min_gain) * iterate.grid.total) {
                break;
            }
            let Some(reached) = reached else {
                radius *= settings.radius_shrink;
                continue;
            };
            // The next subproblem has the rows that this step violates, even if the step fails.
            let violated = self.rows_violated_most(&reached);
            working_set.extend(violated.iter().copied());
            known.extend(violated);
            // If restoration fails, half of the gained time is often enough.
            let halfway = self.lasting(&reached, 0.5 * (iterate.grid.total + reached.grid.total));
            let restored = self.restore_feasibility_within(reached, max_predicted, &mut known);
            match restored.or_else(|| self.restore_feasibility_within(halfway, max_predicted, &mut known)) {
                Some(inside) => {
                    (*working_set, iterate) = (known, inside);
                    proximal.weight = (proximal.weight / settings.proximal_factor).max(settings.proximal_weight);
                    radius = (settings.radius_growth * radius).min(settings.max_radius);
                }
                None => {
                    proximal.weight *= settings.proximal_factor;
                    radius *= settings.radius_shrink;
                }
            }
        }
        iterate
    }
}
