//! Initial guesses: from the coarse grid over a medium one to the full grid.

use super::*;
use crate::planner::scp::given_time::{COARSE_STEP, LEAST_COARSE};
use crate::planner::timing::kinematics;

/// An iterate of the coarse grid is worth more patience on the full one, as long as the linear model predicts no more violation than this.
const NEARLY_THERE: f64 = 0.3;

/// If the full grid has more than `FINER` times as many intervals as the medium grid, durations are optimised on the medium grid
/// first: restoration often fails between grids that differ more, and steps on a fine grid are expensive.
const FINER: f64 = 1.6;
const MEDIUM: usize = 100;

impl ScpPlanner<'_, '_> {
    /// A first motion inside the set, on the full grid, for the mission about as fast as `near` s of flight.
    pub(super) fn first(&mut self, near: f64) -> Option<Iterate> {
        // Where durations are the planner's, each leg begins with what its own limits ask for. (A second start with shares by
        // length took up to twice the solves and found times at most 0.5 % shorter: docs/performance.md.)
        let initial = self.chooses_times().then(|| kinematics::initial(self.hover.model, self.hover.mission));
        let mut iterate = self.coarse(initial.as_deref(), near)?;
        let samples = self.hover.model.plan.samples;
        if let Some(medium) = self.medium_grid() {
            iterate = self.refined(iterate, medium)?;
            iterate = self.optimise_durations(iterate, &durations::FULL_GRID, near, &mut BTreeSet::new());
        }
        self.refined(iterate, samples)
    }

    /// The number of intervals of a grid between the coarse and the full one on which times are chosen first, where there is one.
    pub(super) fn medium_grid(&self) -> Option<usize> {
        let medium = MEDIUM.max(self.hover.coarse_samples());
        (self.chooses_times() && self.hover.model.plan.samples as f64 > FINER * medium as f64).then_some(medium)
    }

    /// An iterate inside the set on a grid with `samples` intervals, near one on another grid.
    fn refined(&mut self, iterate: Iterate, samples: usize) -> Option<Iterate> {
        let durations: Vec<f64> = iterate.grid.segments.iter().map(|s| s.duration).collect();
        let fine = self.lay_out(Some(&durations), iterate.grid.total + self.held(), samples)?;
        self.forget_multipliers();
        let fine = fine.flown();
        let same = iterate.on(&fine);
        if let Some(restored) = self.restore_feasibility_unless(same.clone(), NEARLY_THERE, &mut BTreeSet::new()) {
            return Some(restored);
        }
        if let Some(restored) = self.restore_feasibility_slower(&same, &mut BTreeSet::new()) {
            return Some(restored);
        }
        // Flown slower an iterate near its limits need not come nearer to the set; a smooth one in the same shares of time does.
        let smooth = self.smooth(&fine)?;
        let timed = self.timed(&smooth)?;
        self.restore_feasibility_slower(&timed, &mut BTreeSet::new())
    }

    /// A trajectory of short duration on the coarse grid; the initial durations come from the limits of each leg.
    pub(super) fn first_coarse(&mut self) -> Option<Iterate> {
        let initial = kinematics::initial(self.hover.model, self.hover.mission);
        self.coarse(Some(&initial), 0.0)
    }

    /// An iterate inside the set on the coarse grid, about as fast as `near` s of flight, from legs with these shares of the time, or
    /// with shares by length.
    fn coarse(&mut self, shares: Option<&[f64]>, near: f64) -> Option<Iterate> {
        self.hover.effort.starts += 1;
        let longest: f64 = shares.map_or(0.0, |legs| legs.iter().sum());
        let guess = self.hover.guess().max(near + self.held()).max(longest + self.held());
        let coarse = self.lay_out(shares, guess, self.hover.coarse_samples())?;
        let smooth = self.smooth(&coarse.flown())?;
        let mut iterate = self.timed(&smooth)?;
        let mut working_set = BTreeSet::new();
        if near > iterate.grid.total {
            iterate = iterate.slower(near / iterate.grid.total);
        }
        iterate = self.restore_feasibility_slower(&iterate, &mut working_set)?;
        // At a given time the iterate need not be the shortest: all legs are first shortened alike.
        if near > 0.0 || !self.chooses_times() {
            iterate = self.descend(iterate, (COARSE_STEP, LEAST_COARSE), near, &mut working_set);
        }
        match self.chooses_times() {
            true => Some(self.optimise_durations(iterate, &durations::COARSE_GRID, near, &mut working_set)),
            false => Some(iterate),
        }
    }
}
