//! When each waypoint is passed: durations of legs as variables of the steps.

use super::sequence::CLOSER;
use super::*;
use crate::model::grid::{fewest_pieces, is_coarser, pieces};

/// Largest relative change of a leg's duration in the first step and in any, how it changes, and where that ends.
const FIRST_REACH: f64 = 0.1;
const MOST_REACH: f64 = 0.2;
const FURTHER: f64 = 1.5;
const SHRINK: f64 = 0.4;
const LEAST_REACH: f64 = 0.01;

/// Proximity of steps that choose times, and their weight of the excess against the relative time: where it is cheap, time is
/// bought with an excess that no motion of those durations can be rid of.
const PROXIMITY: f64 = 0.1;
const PENALTY: f64 = 100.0;

/// Weights of the cost relative to the last motion's, one after the other. Smooth motions stay clear of attitudes at which the
/// wrench bends most, and come far by few steps; the shortest motions cost many times what smooth ones do.
pub(super) const FULL_GRID: [f64; 3] = [0.05, 0.01, 0.002];
/// On the coarse grid, whose result is the initial guess on the full one.
pub(super) const COARSE_GRID: [f64; 1] = [0.05];
/// From another set's plan, whose waypoint times are optimised already.
pub(super) const WARM_START: [f64; 1] = [0.002];

/// Where the lines promise less than this share of the time, the next weight's turn has come.
const SMALL: f64 = 1e-3;

/// A change of many durations is far from a motion at first, and worth more patience than a change of one time.
const HOPELESS: f64 = 0.3;

/// On another grid a motion is flown slower by the first of these factors that lets it be restored.
const SLOWER: [f64; 4] = [1.0, 1.002, 1.005, 1.01];

const FARTHER: f64 = 10.0;
const WILD: f64 = 1e9;
/// Most steps.
const MOST_STEPS: usize = 40;

impl Successive<'_, '_> {
    /// Whether waypoint times are the planner's to choose.
    pub(super) fn chooses_times(&self) -> bool {
        self.engine.model.plan.chooses_times
    }

    /// Steps in which each leg has its own change of duration; each is made a motion again with those durations and kept
    /// where the mission has become shorter, so the time never grows. They end at `target` s of flight. `smoothing` holds the
    /// weights of the cost: [`FULL_GRID`], [`COARSE_GRID`] or [`WARM_START`].
    pub(super) fn better_times(
        &mut self,
        mut motion: Motion,
        smoothing: &[f64],
        target: f64,
        pool: &mut BTreeSet<RowAt>,
    ) -> Motion {
        let mut left = MOST_STEPS;
        for (nth, &weight) in smoothing.iter().enumerate() {
            eprintln!("TR weight {weight} T {:.3} cost {:.3}", motion.profile.total, self.cost(&motion));
            if nth > 0 {
                motion = self.settle(motion, CLOSER, pool);
            }
            motion = self.shorten(motion, weight, target, &mut left, pool);
            motion = self.on_its_own_grid(motion, pool);
        }
        motion
    }

    /// The motion on the grid that its durations ask for, where some leg has longer pieces than that ([`is_coarser`]); as it
    /// is where it cannot be restored there.
    fn on_its_own_grid(&mut self, motion: Motion, pool: &mut BTreeSet<RowAt>) -> Motion {
        let mission = self.engine.mission;
        let segments = &motion.profile.segments;
        let durations: Vec<f64> = segments.iter().map(|s| s.duration).collect();
        let samples = motion.profile.intervals() + mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
        let fewest = fewest_pieces(mission, &durations, samples);
        let nodes = |s: &Segment| &motion.profile.node_times[s.first_node..=s.first_node + s.intervals];
        if segments.iter().zip(fewest).all(|(s, fewest)| !is_coarser(mission, nodes(s), fewest)) {
            return motion;
        }
        let due = durations.iter().zip(pieces(mission, &durations, samples)).map(|(&d, n)| LegGrid::new(d, n));
        let due: Vec<LegGrid> = due.collect();
        let own = Profile::with_legs(mission, &due, motion.profile.total + self.held()).flown();
        let there = motion.on(&own);
        for factor in SLOWER {
            eprintln!("TR regrid {factor}");
            // Rows are known by the instants of a grid.
            let mut known = BTreeSet::new();
            if let Some(inside) = self.restore_unless(there.slower(factor), HOPELESS, &mut known) {
                *pool = known;
                return inside;
            }
        }
        motion
    }

    /// These steps with one weight of the cost, `left` of them at most.
    fn shorten(
        &mut self,
        mut motion: Motion,
        smoothing: f64,
        target: f64,
        left: &mut usize,
        pool: &mut BTreeSet<RowAt>,
    ) -> Motion {
        let legs: Vec<Option<usize>> = (0..self.engine.mission.legs.len()).map(Some).collect();
        let weights = Weights { objective: Objective::Time, penalty: PENALTY, smoothing };
        let mut trust = Trust { proximity: PROXIMITY };
        let mut reach = FIRST_REACH;
        while reach >= LEAST_REACH && *left > 0 && motion.profile.total > target {
            *left -= 1;
            self.engine.progress(motion.profile.total + self.held());
            let mut known = pool.clone();
            let durations = Durations { legs: legs.clone(), range: (-reach, reach) };
            let stepped = self.step(&motion, &durations, trust, weights, &mut known);
            let reached = stepped.map(|stepped| motion.stepped(&stepped.states, &stepped.changes));
            if reached.as_ref().is_some_and(|r| r.profile.total > (1.0 - SMALL) * motion.profile.total) {
                break;
            }
            eprintln!("TR step T {:.3} reach {reach:.3} smoothing {smoothing} -> {:?}", motion.profile.total, reached.as_ref().map(|r| (r.profile.total, self.excess(r))));
            if let Some(r) = &reached {
                let form = self.transcription(&r.profile, &[]);
                let mut w: Vec<(f64, usize, Row)> = (0..form.instants()).flat_map(|i| { let st = r.at(i); self.excesses_at(&form, &st, i).map(|(p, e)| (e, i, self.row(p))).collect::<Vec<_>>() }).collect();
                w.sort_by(|a, b| b.0.total_cmp(&a.0));
                for (e, i, row) in w.iter().take(3) { let t = r.profile.node_times[i / PARTS]; let st = r.at(*i); let was = motion.at(*i); eprintln!("TRW {e:.3} at {t:.3} instant {i} {row:?} z'' {:.2} was {:.2} x'' {:.2} was {:.2} psi' {:.2} was {:.2} y'' {:.2} was {:.2} j {:.1} {:.1} {:.1} was {:.1} {:.1} {:.1}  s {:.0} {:.0} {:.0} was {:.0} {:.0} {:.0}", st[2][2], was[2][2], st[0][2], was[0][2], st[3][1], was[3][1], st[1][2], was[1][2], st[0][3], st[1][3], st[2][3], was[0][3], was[1][3], was[2][3],st[0][4], st[1][4], st[2][4], was[0][4], was[1][4], was[2][4]); }
            }
            if let Some(reached) = &reached { let rows = self.rows_passed_most(reached); pool.extend(rows.iter().copied()); known.extend(rows); }
            let halfway = reached.as_ref().map(|r| r.slower(0.5 * (1.0 + motion.profile.total / r.profile.total)));
            let restored = reached.and_then(|reached| self.restore_unless(reached, HOPELESS, &mut known)).or_else(|| {
                let r = self.restore_unless(halfway?, HOPELESS, &mut known);
                eprintln!("TR halfway {}", r.is_some());
                r
            });
            match restored {
                Some(inside) => {
                    (*pool, motion) = (known, inside);
                    eprintln!("TR   ok {:.3}", motion.profile.total);
                    trust.proximity = (trust.proximity / FARTHER).max(PROXIMITY);
                    reach = (FURTHER * reach).min(MOST_REACH);
                }
                None => {eprintln!("TR   failed"); reach *= SHRINK; trust.proximity *= FARTHER;},
            }
        }
        motion
    }
}
