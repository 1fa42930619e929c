//! Fixed times of waypoints among free ones: the legs between two fixed times share what is between them anew, and only the
//! legs after the last fixed time can take longer together.

use super::*;
use crate::model::Mission;
use crate::motion::time_grid::has_fixed_times;
use crate::planner::scp::phases::{CLOSELY, FEASIBILITY_PHASE_WEIGHT, INPUT_WEIGHT};

/// The largest relative change of a duration in the first step that divides spans anew, how it shrinks where a step gains
/// nothing, and where that ends.
const FIRST_REACH: f64 = 0.2;
const SHRINK: f64 = 0.4;
const LEAST_REACH: f64 = 0.01;

/// Their proximity, and their steps at most.
const PROXIMAL_WEIGHT: f64 = 0.1;
const MOST_STEPS: usize = 20;

/// An iterate whose durations have just changed is worth more patience than one at a time that stands.
const HOPELESS: f64 = 0.3;

/// The changes of durations nearest to these, as factors, that keep the sum of durations of each span.
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
    /// The legs before the last fixed time, by the fixed times that they lie between.
    pub(super) fn spans(&self) -> Vec<Range<usize>> {
        let mut spans = Vec::new();
        let mut from = 0;
        for (to, waypoint) in self.hover.mission.waypoints.iter().enumerate().skip(1) {
            if waypoint.time.is_some() {
                spans.push(from..to);
                from = to;
            }
        }
        spans
    }

    /// The same at one mission time, which the legs after the last fixed time share.
    fn spans_of_all(&self) -> Vec<Range<usize>> {
        let mut spans = self.spans();
        let (from, last) = (spans.last().map_or(0, |span| span.end), self.hover.mission.legs.len());
        if from < last {
            spans.push(from..last);
        }
        spans
    }

    /// The legs whose durations change, each by its own share: all but those that are alone in their span.
    pub(super) fn changing(&self, spans: &[Range<usize>]) -> Vec<Option<usize>> {
        let alone = |leg: usize| spans.iter().any(|span| span.len() == 1 && span.contains(&leg));
        let mut own = 0..;
        (0..self.hover.mission.legs.len()).map(|leg| if alone(leg) { None } else { own.next() }).collect()
    }

    /// An iterate that takes `flown` s in all: slower or faster on all legs alike, or where times are fixed on those after the last
    /// of them. The latter is joined at waypoints to first order only. As it is where there are no such legs.
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

    /// An iterate whose legs have just changed by different shares, joined at its waypoints by one step towards the least violation.
    pub(super) fn joined(&mut self, iterate: &Iterate, working_set: &mut BTreeSet<RowAt>) -> Option<Iterate> {
        // Where inputs are small their relative changes make programs that the solver cannot solve.
        [INPUT_WEIGHT, 0.0].into_iter().find_map(|input_weight| {
            let weights = Weights { objective: Objective::Violation, penalty: 1.0, smoothing: 0.0, input_weight };
            let stepped = self.step(
                iterate,
                &self.durations_stand(),
                ProximalWeight { weight: FEASIBILITY_PHASE_WEIGHT },
                weights,
                working_set,
            )?;
            Some(iterate.with_states(stepped.states)).filter(Iterate::is_joined)
        })
    }

    /// A plan at a mission time whose legs divide the time between fixed times as no rule does: about as a mission without fixed
    /// times does, and from there, and from the divisions `begun`, by steps towards the least violation.
    pub(super) fn divided_anew(&mut self, total: f64, begun: &[TimeGrid]) -> Option<Planned> {
        let samples = self.hover.model.plan.samples;
        let fastest = self.durations_without_fixed_times().and_then(|legs| self.lay_out(Some(&legs), total, samples));
        if let Some(planned) = fastest.as_ref().and_then(|full| self.at_once(full, &[])) {
            return Some(planned);
        }
        fastest.iter().chain(begun).find_map(|full| {
            let smooth = self.smooth(&full.flown())?;
            let mut working_set = BTreeSet::new();
            let inside = self.restore_feasibility_dividing_anew(smooth, &mut working_set)?;
            let inside = self.on_its_own_grid(inside, &mut working_set);
            self.kept_near(inside, total, CLOSELY, &mut working_set)
        })
    }

    /// The durations of legs of a short motion on the coarse grid if no waypoint had a fixed time.
    fn durations_without_fixed_times(&mut self) -> Option<Vec<f64>> {
        let mut mission: Mission = self.hover.mission.clone();
        mission.waypoints.iter_mut().for_each(|w| w.time = None);
        let mut engine = HoverPlanner::new(self.hover.model, &mission, self.hover.healthy);
        engine.on_progress = self.hover.on_progress;
        let iterate = ScpPlanner::new(&mut engine, self.wrench, self.set).first_coarse();
        let effort = engine.effort;
        self.hover.effort += effort;
        iterate.map(|iterate| iterate.grid.segments.iter().map(|s| s.duration).collect())
    }

    /// Steps towards the least violation in which the legs of each span divide its time anew, until the iterate can be restored
    /// with the durations that it has.
    fn restore_feasibility_dividing_anew(
        &mut self,
        mut iterate: Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let spans = self.spans_of_all();
        let legs = self.changing(&spans);
        let weights =
            Weights { objective: Objective::Violation, penalty: 1.0, smoothing: 0.0, input_weight: INPUT_WEIGHT };
        let mut violation = self.violation_by(&iterate, working_set);
        let mut reach = FIRST_REACH;
        for _ in 0..MOST_STEPS {
            self.forget_multipliers();
            working_set.extend(self.rows_between(&iterate));
            let durations = Durations { legs: legs.clone(), range: (-reach, reach), spans: spans.clone() };
            let proximal = ProximalWeight { weight: PROXIMAL_WEIGHT };
            let reached = self
                .step(&iterate, &durations, proximal, weights, working_set)
                .map(|stepped| iterate.stepped(&stepped.states, &stepped.changes))
                .and_then(|reached| self.joined(&reached, working_set));
            if let Some(reached) = reached {
                working_set.extend(self.rows_violated_most(&reached));
                let now = self.violation_by(&reached, working_set);
                if let Some(inside) =
                    self.restore_feasibility_unless(reached.clone(), HOPELESS, &mut working_set.clone())
                {
                    return Some(inside);
                }
                if now < violation {
                    (iterate, violation) = (reached, now);
                    continue;
                }
            }
            reach *= SHRINK;
            if reach < LEAST_REACH {
                break;
            }
        }
        None
    }

    /// Whether durations between fixed times are the planner's.
    pub(super) fn divides_spans(&self) -> bool {
        self.chooses_times() && has_fixed_times(self.hover.mission)
    }
}
