//! Fixed times of waypoints among free ones: the legs between two fixed times share what is between them anew, and only the
//! legs after the last fixed time can take longer together.

use super::sequence::{CALMING, CLOSELY, RESTORING};
use super::*;
use crate::model::Mission;
use crate::motion::time_grid::has_fixed_times;

/// The largest relative change of a duration in the first step that divides spans anew, how it shrinks where a step gains
/// nothing, and where that ends.
const FIRST_REACH: f64 = 0.2;
const SHRINK: f64 = 0.4;
const LEAST_REACH: f64 = 0.01;

/// Their proximity, and their steps at most.
const PROXIMITY: f64 = 0.1;
const MOST_STEPS: usize = 20;

/// A motion whose durations have just changed is worth more patience than one at a time that stands.
const HOPELESS: f64 = 0.3;

/// The changes of durations nearest to these, as factors, that keep the sum of durations of each span.
pub(super) fn keep_sums(profile: &Profile, mut changes: Vec<f64>, spans: &[Range<usize>]) -> Vec<f64> {
    for span in spans {
        let duration = |leg: usize| profile.segments[leg].duration;
        let sum: f64 = span.clone().map(duration).sum();
        let changed: f64 = span.clone().map(|leg| (1.0 + changes[leg]) * duration(leg)).sum();
        for leg in span.clone() {
            changes[leg] = (1.0 + changes[leg]) * (sum / changed) - 1.0;
        }
    }
    changes
}

impl Successive<'_, '_> {
    /// The legs before the last fixed time, by the fixed times that they lie between.
    pub(super) fn spans(&self) -> Vec<Range<usize>> {
        let mut spans = Vec::new();
        let mut from = 0;
        for (to, waypoint) in self.engine.mission.waypoints.iter().enumerate().skip(1) {
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
        let (from, last) = (spans.last().map_or(0, |span| span.end), self.engine.mission.legs.len());
        if from < last {
            spans.push(from..last);
        }
        spans
    }

    /// The legs whose durations change, each by its own share: all but those that are alone in their span.
    pub(super) fn changing(&self, spans: &[Range<usize>]) -> Vec<Option<usize>> {
        let alone = |leg: usize| spans.iter().any(|span| span.len() == 1 && span.contains(&leg));
        let mut own = 0..;
        (0..self.engine.mission.legs.len()).map(|leg| if alone(leg) { None } else { own.next() }).collect()
    }

    /// A motion that takes `flown` s in all: slower or faster on all legs alike, or where times are fixed on those after the last
    /// of them. The latter is joined at waypoints to first order only. As it is where there are no such legs.
    pub(super) fn lasting(&self, motion: &Motion, flown: f64) -> Motion {
        let from = self.spans().last().map_or(0, |span| span.end);
        if from == 0 {
            return motion.slower(flown / motion.profile.total);
        }
        let free: f64 = motion.profile.segments[from..].iter().map(|s| s.duration).sum();
        if free == 0.0 {
            return motion.clone();
        }
        let change = (flown - motion.profile.total) / free;
        let changes: Vec<f64> =
            (0..motion.profile.segments.len()).map(|leg| if leg < from { 0.0 } else { change }).collect();
        motion.stepped(&motion.states, &changes)
    }

    /// A motion whose legs have just changed by different shares, joined at its waypoints by one step towards the least excess.
    pub(super) fn joined(&mut self, motion: &Motion, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        // Where inputs are small their relative changes make programs that the solver cannot solve.
        [CALMING, 0.0].into_iter().find_map(|calming| {
            let weights = Weights { objective: Objective::Excess, penalty: 1.0, smoothing: 0.0, calming };
            let stepped = self.step(motion, &self.durations_stand(), Trust { proximity: RESTORING }, weights, pool)?;
            Some(motion.with_states(stepped.states)).filter(Motion::is_joined)
        })
    }

    /// A plan at a mission time whose legs divide the time between fixed times as no rule does: about as a mission without fixed
    /// times does, and from there, and from the divisions `begun`, by steps towards the least excess.
    pub(super) fn divided_anew(&mut self, total: f64, begun: &[Profile]) -> Option<Planned> {
        let samples = self.engine.model.plan.samples;
        let fastest = self.durations_without_fixed_times().and_then(|legs| self.lay_out(Some(&legs), total, samples));
        if let Some(planned) = fastest.as_ref().and_then(|full| self.at_once(full, &[])) {
            return Some(planned);
        }
        fastest.iter().chain(begun).find_map(|full| {
            let smooth = self.smooth(&full.flown())?;
            let mut pool = BTreeSet::new();
            let inside = self.restore_anew(smooth, &mut pool)?;
            let inside = self.on_its_own_grid(inside, &mut pool);
            self.kept_near(inside, total, CLOSELY, &mut pool)
        })
    }

    /// The durations of legs of a short motion on the coarse grid if no waypoint had a fixed time.
    fn durations_without_fixed_times(&mut self) -> Option<Vec<f64>> {
        let mut mission: Mission = self.engine.mission.clone();
        mission.waypoints.iter_mut().for_each(|w| w.time = None);
        let mut engine = Engine::new(self.engine.model, &mission, self.engine.healthy);
        engine.on_progress = self.engine.on_progress;
        let motion = Successive::new(&mut engine, self.wrench, self.set).first_coarse();
        let effort = engine.effort;
        self.engine.effort += effort;
        motion.map(|motion| motion.profile.segments.iter().map(|s| s.duration).collect())
    }

    /// Steps towards the least excess in which the legs of each span divide its time anew, until the motion can be restored
    /// with the durations that it has.
    fn restore_anew(&mut self, mut motion: Motion, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        let spans = self.spans_of_all();
        let legs = self.changing(&spans);
        let weights = Weights { objective: Objective::Excess, penalty: 1.0, smoothing: 0.0, calming: CALMING };
        let mut excess = self.excess_by(&motion, pool);
        let mut reach = FIRST_REACH;
        for _ in 0..MOST_STEPS {
            self.forget_multipliers();
            pool.extend(self.rows_between(&motion));
            let durations = Durations { legs: legs.clone(), range: (-reach, reach), spans: spans.clone() };
            let trust = Trust { proximity: PROXIMITY };
            let reached = self
                .step(&motion, &durations, trust, weights, pool)
                .map(|stepped| motion.stepped(&stepped.states, &stepped.changes))
                .and_then(|reached| self.joined(&reached, pool));
            if let Some(reached) = reached {
                pool.extend(self.rows_violated_most(&reached));
                let now = self.excess_by(&reached, pool);
                if let Some(inside) = self.restore_unless(reached.clone(), HOPELESS, &mut pool.clone()) {
                    return Some(inside);
                }
                if now < excess {
                    (motion, excess) = (reached, now);
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
        self.chooses_times() && has_fixed_times(self.engine.mission)
    }
}
