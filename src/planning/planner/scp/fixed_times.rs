//! Fixed times of waypoints among free ones. The legs between two fixed times form a span: they can divide its time in
//! another way, but only the legs after the last fixed time can take longer in all.

use super::iterate::Iterate;
use super::subproblem::Objective;
use super::{Durations, ProximalWeight, ScpPlanner, Weights};
use crate::model::Problem;
use crate::motion::time_grid::TimeGrid;
use crate::planner::Planned;
use crate::planner::hover::HoverPlanner;
use crate::planner::transcription::RowAt;
use std::collections::BTreeSet;
use std::ops::Range;

/// Relative changes of durations, scaled within each span so that its sum of durations does not change.
pub(super) fn keep_sums(grid: &TimeGrid, mut changes: Vec<f64>, spans: &[Range<usize>]) -> Vec<f64> {
    for span in spans {
        let duration = |leg: usize| grid.segments[leg].duration;
        let sum: f64 = span.clone().map(duration).sum();
        let changed: f64 = span.clone().map(|leg| (1.0 + changes[leg]) * duration(leg)).sum();
        for leg in span.clone() {
            changes[leg] = (1.0 + changes[leg]) * (sum / changed) - 1.0;
        }
    }
    changes
}

impl ScpPlanner<'_, '_> {
    /// The spans: the legs before the last fixed time, by the fixed times that they lie between.
    pub(super) fn spans(&self) -> Vec<Range<usize>> {
        let mut spans = Vec::new();
        let mut from = 0;
        for (to, waypoint) in self.mission().waypoints.iter().enumerate().skip(1) {
            if waypoint.time.is_some() {
                spans.push(from..to);
                from = to;
            }
        }
        spans
    }

    /// The spans at one mission time: the legs after the last fixed time are one more.
    fn spans_of_all(&self) -> Vec<Range<usize>> {
        let mut spans = self.spans();
        let (from, last) = (spans.last().map_or(0, |span| span.end), self.mission().legs.len());
        if from < last {
            spans.push(from..last);
        }
        spans
    }

    /// The index of each leg's duration among the variables; `None` for a leg that is alone in its span.
    pub(super) fn changing(&self, spans: &[Range<usize>]) -> Vec<Option<usize>> {
        let alone = |leg: usize| spans.iter().any(|span| span.len() == 1 && span.contains(&leg));
        let mut own = 0..;
        (0..self.mission().legs.len()).map(|leg| if alone(leg) { None } else { own.next() }).collect()
    }

    /// An iterate of `flown` s in all: slower or faster on all legs alike, or where times are fixed on those after the
    /// last fixed time, whose pieces then join at waypoints to first order only. Unchanged where there are no such
    /// legs.
    pub(super) fn lasting(&self, iterate: &Iterate, flown: f64) -> Iterate {
        let from = self.spans().last().map_or(0, |span| span.end);
        if from == 0 {
            return iterate.slower(flown / iterate.grid.total);
        }
        let free: f64 = iterate.grid.segments[from..].iter().map(|s| s.duration).sum();
        if free == 0.0 {
            return iterate.clone();
        }
        let change = (flown - iterate.grid.total) / free;
        let changes: Vec<f64> =
            (0..iterate.grid.segments.len()).map(|leg| if leg < from { 0.0 } else { change }).collect();
        iterate.stepped(&iterate.states, &changes)
    }

    /// An iterate whose legs have changed by different shares, joined at its waypoints by one step that minimises the
    /// violation.
    pub(super) fn joined(&mut self, iterate: &Iterate, working_set: &mut BTreeSet<RowAt>) -> Option<Iterate> {
        let settings = self.settings;
        let proximal = ProximalWeight { weight: settings.feasibility.proximal_weight };
        // Where inputs are small their relative changes make programs that the solver cannot solve.
        [settings.proximal.input_weight, 0.0].into_iter().find_map(|input_weight| {
            let weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight };
            let stepped = self.step(iterate, &self.fixed_durations(), proximal, weights, working_set)?;
            let joined = iterate.with_states(stepped.states);
            joined.is_joined(settings.subproblem.joined_within).then_some(joined)
        })
    }

    /// A plan at a mission time with another division of the time between fixed times than the rules give: the division
    /// of a short motion without fixed times; then, from it and from `divisions`, the divisions that steps towards the
    /// least violation find.
    pub(super) fn divided_anew(&mut self, total: f64, divisions: &[TimeGrid]) -> Option<Planned> {
        let samples = self.model().plan.samples;
        let fastest = self.durations_without_fixed_times().and_then(|legs| self.lay_out(Some(&legs), total, samples));
        if let Some(planned) = fastest.as_ref().and_then(|full| self.on_grid(full, &[])) {
            return Some(planned);
        }
        fastest.iter().chain(divisions).find_map(|full| {
            let smooth = self.minimum_snap(&full.flown())?;
            let mut working_set = BTreeSet::new();
            let inside = self.restore_feasibility_dividing_anew(smooth, &mut working_set)?;
            let inside = self.on_its_own_grid(inside, &mut working_set);
            self.restored_plan(inside, total, self.settings.cost.close, &mut working_set)
        })
    }

    /// The durations of the legs, s, of a short motion on the coarse grid without fixed times.
    fn durations_without_fixed_times(&mut self) -> Option<Vec<f64>> {
        let mut mission = self.mission().clone();
        mission.waypoints.iter_mut().for_each(|w| w.time = None);
        let model = self.problem().with_mission(mission);
        let mut hover = HoverPlanner::new(Problem::of(&model)?, self.hover.healthy);
        hover.on_trial = self.hover.on_trial;
        let mut free = ScpPlanner::with_settings(&mut hover, self.wrench, self.set, self.settings);
        let iterate = free.first_coarse();
        let effort = hover.effort;
        self.hover.effort += effort;
        iterate.map(|iterate| iterate.grid.segments.iter().map(|s| s.duration).collect())
    }

    /// Steps towards the least violation in which the legs of each span change their division of its time, until the
    /// iterate can be restored with its durations.
    fn restore_feasibility_dividing_anew(
        &mut self,
        mut iterate: Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let spans = self.spans_of_all();
        let legs = self.changing(&spans);
        let settings = self.settings.durations.between_fixed_times;
        let max_predicted = self.settings.feasibility.max_predicted_after_change;
        let input_weight = self.settings.proximal.input_weight;
        let weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight };
        let mut violation = self.largest_violation_with(&iterate, working_set);
        let mut radius = settings.first_radius;
        for _ in 0..settings.max_steps {
            self.forget_multipliers();
            working_set.extend(self.rows_between(&iterate));
            let durations = Durations { legs: legs.clone(), range: (-radius, radius), spans: spans.clone() };
            let proximal = ProximalWeight { weight: self.settings.durations.proximal_weight };
            let reached = self
                .step(&iterate, &durations, proximal, weights, working_set)
                .map(|stepped| iterate.stepped(&stepped.states, &stepped.changes))
                .and_then(|reached| self.joined(&reached, working_set));
            if let Some(reached) = reached {
                working_set.extend(self.rows_violated_most(&reached));
                let now = self.largest_violation_with(&reached, working_set);
                let restored =
                    self.restore_feasibility_within(reached.clone(), max_predicted, &mut working_set.clone());
                if restored.is_some() {
                    return restored;
                }
                if now < violation {
                    (iterate, violation) = (reached, now);
                    continue;
                }
            }
            radius *= settings.radius_shrink;
            if radius < settings.min_radius {
                break;
            }
        }
        None
    }

    /// Whether the planner chooses the durations between fixed times.
    pub(super) fn divides_spans(&self) -> bool {
        self.chooses_times() && self.mission().has_fixed_times()
    }
}
