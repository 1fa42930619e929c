//! When each waypoint is passed: durations of legs as variables of the steps.

use super::*;
use crate::model::grid::{fewest_pieces, is_coarser, pieces};
use crate::planner::scp::phases::CLOSER;

/// Largest relative change of a leg's duration in the first step and in any, how it changes, and where that ends.
const FIRST_REACH: f64 = 0.1;
const MOST_REACH: f64 = 0.2;
const FURTHER: f64 = 1.5;
const SHRINK: f64 = 0.4;
const LEAST_REACH: f64 = 0.01;

/// Proximal weight of steps that choose times, and their weight of the violation against the relative time: where it is cheap, time is
/// bought with a violation that no motion of those durations can be rid of.
const PROXIMAL_WEIGHT: f64 = 0.1;
/// Factor by which the proximal weight grows after a step that fails and falls after one that succeeds.
const FURTHER_OFF: f64 = 10.0;
const PENALTY: f64 = 100.0;

/// Weights of the cost relative to the last iterate's, one after the other. Smooth motions stay clear of attitudes at which the
/// wrench bends most, and come far by few steps; the shortest motions cost many times what smooth ones do.
pub(super) const FULL_GRID: [f64; 3] = [0.05, 0.01, 0.002];
/// On the coarse grid, whose result is the initial guess on the full one.
pub(super) const COARSE_GRID: [f64; 1] = [0.05];
/// Where the weights after the first have gained nothing: minimising the cost has left so smooth an iterate that a small share of
/// time is not worth the multiple of its cost (measured: `ferry_octo` at 150 samples ended 1.6 % longer).
const LAST_RESORT: f64 = 0.0002;
/// From another set's plan, whose waypoint times are optimised already.
pub(super) const WARM_START: [f64; 1] = [0.002];

/// Where the linear model predicts less than this share of the time, the next weight's turn has come.
const SMALL: f64 = 1e-3;

/// A change of many durations is far from a trajectory at first, and worth more patience than a change of one time.
const HOPELESS: f64 = 0.3;

/// On another grid an iterate is flown slower by the first of these factors that lets it be restored.
const SLOWER: [f64; 4] = [1.0, 1.002, 1.005, 1.01];

/// Most steps.
const MOST_STEPS: usize = 40;

impl ScpPlanner<'_, '_> {
    /// Whether waypoint times are the planner's to choose.
    pub(super) fn chooses_times(&self) -> bool {
        self.hover.model.plan.chooses_times && self.hover.mission.leaves_times_free()
    }

    /// Steps in which each leg has its own change of duration; each is restored with those durations and kept
    /// where the mission has become shorter, so the time never grows. They end at `target` s of flight. `smoothing` holds the
    /// weights of the cost: [`FULL_GRID`], [`COARSE_GRID`] or [`WARM_START`].
    pub(super) fn optimise_durations(
        &mut self,
        mut iterate: Iterate,
        smoothing: &[f64],
        target: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let mut left = MOST_STEPS;
        let mut totals = Vec::new();
        for (nth, &weight) in smoothing.iter().enumerate() {
            if nth > 0 {
                iterate = self.minimise_cost(iterate, CLOSER, working_set);
            }
            iterate = self.shorten_legs(iterate, weight, target, &mut left, working_set);
            iterate = self.on_its_own_grid(iterate, working_set);
            totals.push(iterate.grid.total);
        }
        if let [first, .., last] = totals[..]
            && last > (1.0 - SMALL) * first
        {
            iterate = self.shorten_legs(iterate, LAST_RESORT, target, &mut left, working_set);
            iterate = self.on_its_own_grid(iterate, working_set);
        }
        iterate
    }

    /// The iterate on the grid that its durations ask for, where some leg has longer pieces than that ([`is_coarser`]); as it
    /// is where it cannot be restored there.
    pub(super) fn on_its_own_grid(&mut self, iterate: Iterate, working_set: &mut BTreeSet<RowAt>) -> Iterate {
        let mission = self.hover.mission;
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
        for factor in SLOWER {
            // Rows are known by the instants of a grid.
            let mut known = BTreeSet::new();
            if let Some(inside) =
                self.restore_feasibility_unless(self.lasting(&there, factor * own.total), HOPELESS, &mut known)
            {
                *working_set = known;
                return inside;
            }
        }
        iterate
    }

    /// These steps with one weight of the cost, `left` of them at most.
    fn shorten_legs(
        &mut self,
        mut iterate: Iterate,
        smoothing: f64,
        target: f64,
        left: &mut usize,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let spans = self.spans();
        let legs = self.changing(&spans);
        let weights = Weights { objective: Objective::Time, penalty: PENALTY, smoothing, input_weight: 0.0 };
        let mut proximal = ProximalWeight { weight: PROXIMAL_WEIGHT };
        let mut reach = FIRST_REACH;
        while reach >= LEAST_REACH && *left > 0 && iterate.grid.total > target {
            *left -= 1;
            self.hover.progress(iterate.grid.total + self.held());
            let mut known = working_set.clone();
            let durations = Durations { legs: legs.clone(), range: (-reach, reach), spans: spans.clone() };
            let stepped = self.step(&iterate, &durations, proximal, weights, &mut known);
            let reached = stepped.map(|stepped| iterate.stepped(&stepped.states, &stepped.changes));
            if reached.as_ref().is_some_and(|r| r.grid.total > (1.0 - SMALL) * iterate.grid.total) {
                break;
            }
            let Some(reached) = reached else {
                reach *= SHRINK;
                continue;
            };
            // The next program imposes the rows that this step violates, even if the step fails.
            let passed = self.rows_violated_most(&reached);
            working_set.extend(passed.iter().copied());
            known.extend(passed);
            // If restoration fails, half of the gained time is often enough.
            let halfway = self.lasting(&reached, 0.5 * (iterate.grid.total + reached.grid.total));
            let restored = self.restore_feasibility_unless(reached, HOPELESS, &mut known);
            match restored.or_else(|| self.restore_feasibility_unless(halfway, HOPELESS, &mut known)) {
                Some(inside) => {
                    (*working_set, iterate) = (known, inside);
                    proximal.weight = (proximal.weight / FURTHER_OFF).max(PROXIMAL_WEIGHT);
                    reach = (FURTHER * reach).min(MOST_REACH);
                }
                None => {
                    proximal.weight *= FURTHER_OFF;
                    reach *= SHRINK;
                }
            }
        }
        iterate
    }
}
