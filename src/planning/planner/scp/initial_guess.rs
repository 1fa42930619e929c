//! Initial guesses: from the coarse grid over a medium one to the full grid.

use super::ScpPlanner;
use super::iterate::Iterate;
use crate::planner::timing::kinematics;
use std::collections::BTreeSet;

impl ScpPlanner<'_, '_> {
    /// A feasible iterate on the full grid, of about `near` s of flight or as short as the coarse grids make it; `None`
    /// if the feasibility phases find none.
    pub(super) fn first_feasible(&mut self, near: f64) -> Option<Iterate> {
        // Where the planner chooses the durations, the initial one of each leg comes from its own limits. (A second
        // start with shares by length took up to twice the solves and found times at most 0.5 % shorter.)
        let initial = self.chooses_times().then(|| kinematics::initial(self.problem()));
        let coarse = self.coarse_on_all_sides(initial.as_deref(), near);
        let kept = std::mem::take(&mut self.sides);
        let found = coarse.into_iter().find_map(|(iterate, sides)| {
            self.sides = sides;
            self.refined_to_full(iterate, near)
        });
        if found.is_none() {
            self.sides = kept;
        }
        found.or_else(|| self.refined_from_rest(near))
    }

    /// A feasible iterate on the full grid, of about `near` s of flight or as short as the coarse grids make it, from
    /// the motion from rest to rest: on the coarse grid, or where that fails on the full one.
    fn refined_from_rest(&mut self, near: f64) -> Option<Iterate> {
        self.forget_multipliers();
        let (mut samples, full) = (self.hover.coarse_samples(), self.model().plan.samples);
        let mut coarse = self.rest_to_rest(samples);
        while coarse.is_none() && samples < full {
            samples = ((self.settings.grids.growth * samples as f64).ceil() as usize).min(full);
            coarse = self.rest_to_rest(samples);
        }
        let refined = coarse.and_then(|iterate| {
            let iterate = self.shortened_from_rest(iterate, near);
            self.refined_to_full(iterate, near)
        });
        refined.or_else(|| {
            let full = self.rest_to_rest_in_full()?;
            Some(self.shortened_from_rest(full, near))
        })
    }

    /// The motion from rest to rest on the full grid, or, where some leg has too few intervals there for its moves and
    /// turns, on a finer one.
    pub(super) fn rest_to_rest_in_full(&mut self) -> Option<Iterate> {
        let (full, settings) = (self.model().plan.samples, self.settings.grids);
        let mut samples = full;
        while samples as f64 <= settings.finest * full as f64 {
            if let Some(iterate) = self.rest_to_rest(samples) {
                return Some(iterate);
            }
            samples = (settings.growth * samples as f64).ceil() as usize;
        }
        None
    }

    /// A motion from rest to rest with free waypoint times, of about `near` s of flight or as short as the steps make
    /// it.
    fn shortened_from_rest(&mut self, mut iterate: Iterate, near: f64) -> Iterate {
        let mut working_set = BTreeSet::new();
        if near > iterate.grid.total {
            iterate = iterate.slower(near / iterate.grid.total);
        }
        if let Some(restored) = self.restore_feasibility(iterate.clone(), &mut working_set) {
            iterate = restored;
        }
        iterate = self.minimise_cost(iterate, self.settings.cost.medium, &mut working_set);
        let settings = self.settings.durations;
        let weights = &settings.cost_weights_on_coarse_grid;
        self.shorten(iterate.clone(), weights, settings.first_radius, near, &mut working_set).unwrap_or(iterate)
    }

    /// A coarse iterate on the full grid, over a medium one.
    fn refined_to_full(&mut self, mut iterate: Iterate, near: f64) -> Option<Iterate> {
        let (samples, settings) = (self.model().plan.samples, self.settings.durations);
        if let Some(medium) = self.medium_grid() {
            iterate = self.refined(iterate, medium, &settings.cost_weights_on_medium_grid, near)?;
        }
        self.refined(iterate, samples, &settings.cost_weights_on_full_grid, near)
    }

    /// The number of intervals of a grid between the coarse and the full one on which times are chosen first, where
    /// there is one.
    pub(super) fn medium_grid(&self) -> Option<usize> {
        let settings = &self.settings.grids;
        let medium = settings.medium.max(self.hover.coarse_samples());
        let is_much_finer = self.model().plan.samples as f64 > settings.refinement * medium as f64;
        is_much_finer.then_some(medium)
    }

    /// A feasible iterate on a grid with `samples` intervals, near one on another grid.
    fn refined(&mut self, iterate: Iterate, samples: usize, weights: &[f64], near: f64) -> Option<Iterate> {
        let durations: Vec<f64> = iterate.grid.segments.iter().map(|s| s.duration).collect();
        let fine = self.lay_out(Some(&durations), iterate.grid.total + self.held(), samples)?;
        self.forget_multipliers();
        let fine = fine.flown();
        let same = iterate.on(&fine);
        let radius = self.settings.durations.least_first_radius;
        let shorter = self.shorten(same.clone(), weights, radius, near, &mut BTreeSet::new());
        self.is_slowed = shorter.is_none();
        if shorter.is_some() {
            return shorter;
        }
        if let Some(restored) = self.restore_feasibility_slower(&same, &mut BTreeSet::new()) {
            return Some(restored);
        }
        // Slowing down an iterate near its limits need not reduce its violation; that of a smooth one with the same
        // shares of time falls.
        let smooth = self.minimum_snap(&fine)?;
        let timed = self.slowed_until_inside(&smooth)?;
        self.restore_feasibility_slower(&timed, &mut BTreeSet::new())
    }

    /// A feasible iterate of short duration on the coarse grid; the initial durations come from the limits of each leg.
    pub(super) fn first_coarse(&mut self) -> Option<Iterate> {
        let initial = kinematics::initial(self.problem());
        self.coarse(Some(&initial), 0.0)
    }

    /// The minimum-snap motion on the coarse grid, slowed down until it is inside the set and the limits at the nodes.
    pub(super) fn first_motion(&mut self, shares: Option<&[f64]>, near: f64) -> Option<Iterate> {
        let longest: f64 = shares.map_or(0.0, |legs| legs.iter().sum());
        let guess = self.hover.guess().max(near + self.held()).max(longest + self.held());
        let coarse = self.lay_out(shares, guess, self.hover.coarse_samples())?;
        let smooth = self.minimum_snap(&coarse.flown())?;
        self.slowed_until_inside(&smooth)
    }

    /// A feasible iterate on the coarse grid, of about `near` s of flight or as short as the steps make it. The legs
    /// start with these shares of the time, or with shares by length.
    pub(super) fn coarse(&mut self, shares: Option<&[f64]>, near: f64) -> Option<Iterate> {
        self.hover.effort.starts += 1;
        let mut iterate = self.first_motion(shares, near)?;
        if near > iterate.grid.total {
            iterate = iterate.slower(near / iterate.grid.total);
        }
        let settings = self.settings.durations;
        let weights = &settings.cost_weights_on_coarse_grid;
        self.shorten(iterate, weights, settings.first_radius, near, &mut BTreeSet::new())
    }
}
