//! When each waypoint is passed: durations of legs as variables of the steps.

use super::sequence::ROUGHLY;
use super::*;

/// Largest relative change of a leg's duration in the first step and in any, how it changes, and where that ends.
const FIRST_REACH: f64 = 0.1;
const MOST_REACH: f64 = 0.2;
const FURTHER: f64 = 1.5;
const SHRINK: f64 = 0.4;
const LEAST_REACH: f64 = 0.01;

/// Proximity, penalty and smoothing of steps that choose times.
const PROXIMITY: f64 = 0.1;
const PENALTY: f64 = 2.0;
const SMOOTHING: f64 = 0.05;

/// A relative gain in time below this ends the search.
const SMALL: f64 = 2e-3;

/// A change of many durations is far from a motion at first, and worth more patience than a change of one time.
const HOPELESS: f64 = 0.3;

/// Shares of its duration by which one leg alone is shortened, from the first to the last.
const WIDEST: f64 = 0.08;
const FINEST: f64 = 0.005;

/// What shortening a leg would give back is worth trying from this share of the flight's time on.
const WORTH: f64 = 1e-3;

/// Most steps.
const MOST_STEPS: usize = 40;

impl Successive<'_, '_> {
    /// Whether waypoint times are the planner's to choose.
    pub(super) fn chooses_times(&self) -> bool {
        self.engine.model.plan.chooses_times
    }

    /// Steps in which each leg has its own change of duration; each is made a motion again with those durations and kept
    /// where the mission has become shorter, so the time never grows. They end at `target` s of flight.
    pub(super) fn better_times(&mut self, mut motion: Motion, target: f64, pool: &mut BTreeSet<RowAt>) -> Motion {
        let legs: Vec<Option<usize>> = (0..self.engine.mission.legs.len()).map(Some).collect();
        let weights = Weights { objective: Objective::Time, penalty: PENALTY, smoothing: SMOOTHING };
        let trust = Trust { proximity: PROXIMITY };
        let mut reach = FIRST_REACH;
        for _ in 0..MOST_STEPS {
            if reach < LEAST_REACH || motion.profile.total <= target {
                break;
            }
            self.engine.progress(motion.profile.total);
            let mut known = pool.clone();
            let shorter = self
                .step(&motion, &Durations { legs: legs.clone(), range: (-reach, reach) }, trust, weights, &mut known)
                .map(|stepped| motion.stepped(&stepped.states, &stepped.changes))
                .filter(|reached| reached.profile.total < motion.profile.total)
                .and_then(|reached| self.restore_unless(reached, HOPELESS, &mut known));
            match shorter {
                Some(inside) => {
                    let gained = 1.0 - inside.profile.total / motion.profile.total;
                    *pool = known;
                    motion = self.settle(inside, ROUGHLY, pool);
                    reach = (FURTHER * reach).min(MOST_REACH);
                    if gained < SMALL {
                        break;
                    }
                }
                None => reach *= SHRINK,
            }
        }
        self.shorten_by_leg(motion, target, pool)
    }

    /// A pattern search: each leg alone is flown faster, and kept where the motion can be restored; by smaller shares where no
    /// leg can. Where linearised steps in all durations end, because one leg's part of a step cannot be restored, those of the
    /// others still can.
    fn shorten_by_leg(&mut self, mut motion: Motion, target: f64, pool: &mut BTreeSet<RowAt>) -> Motion {
        let legs = self.engine.mission.legs.len();
        let mut share = WIDEST;
        while share >= FINEST {
            // Those that could be shortened by this share in every round so far.
            let mut open: Vec<usize> = (0..legs).collect();
            while !open.is_empty() {
                let before = motion.profile.total;
                for leg in std::mem::take(&mut open) {
                    let duration = motion.profile.segments[leg].duration;
                    if share * duration < WORTH * motion.profile.total {
                        continue;
                    }
                    if motion.profile.total <= target {
                        return motion;
                    }
                    self.engine.progress(motion.profile.total);
                    let mut known = pool.clone();
                    let mut changes = vec![0.0; legs];
                    changes[leg] = -share;
                    let faster = motion.stepped(&motion.states, &changes);
                    if let Some(inside) = self.restore_unless(faster, HOPELESS, &mut known) {
                        (*pool, motion) = (known, inside);
                        open.push(leg);
                    }
                }
                if !open.is_empty() {
                    motion = self.settle(motion, ROUGHLY, pool);
                }
                if motion.profile.total > (1.0 - SMALL) * before {
                    break;
                }
            }
            share *= 0.5;
        }
        motion
    }
}
