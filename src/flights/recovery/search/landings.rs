//! Landings after a fault: at a site, where the vehicle comes to rest, and those that would take too long.

use super::{Found, Search, Start};
use crate::motion::{NodeState, X, Y};
use crate::planner::branch::Goal;
use crate::planner::scp::Iterate;
use crate::recovery::carry::Carried;
use crate::recovery::{NearMiss, Piece, Way, apart};

/// Times of a landing as multiples of a likely one, ascending, because the shortest that is found is taken; the longest
/// allowed is tried last. Chosen by hand.
const LONGER: [f64; 3] = [1.0, 1.45, 2.1];

/// A landing about a known one that takes more than this many times as long as one of the times to try is sought again
/// in that time. Chosen by hand: below the ratio of neighbours in [`LONGER`], above the change of the likely time from
/// one instant to the next.
const MUCH_LONGER: f64 = 1.2;

/// A vehicle that lands where it comes to rest may touch down this far from there, m. Chosen by hand.
pub(super) const HERE: f64 = 1.0;

/// The longest gaps of a mode for which it is looked how near a landing site was, and the times tried there, as
/// multiples of the longest allowed. Chosen by hand.
const GAPS: usize = 2;
const MORE_TIME: [f64; 3] = [1.25, 1.6, 2.5];

/// Places beside areas to keep off that are tried. Chosen by hand.
const BESIDE: usize = 4;

impl Search<'_> {
    /// Which sites would be reached from the middles of the longest gaps, given more time.
    pub(super) fn look_for_near_misses(&mut self, pieces: &mut [Piece]) {
        let model = self.problem.model();
        let within = model.plan.recovery.within;
        let mut gaps: Vec<&mut Piece> = pieces.iter_mut().filter(|piece| piece.way.is_none()).collect();
        gaps.sort_by(|a, b| (b.to - b.from).total_cmp(&(a.to - a.from)));
        for gap in gaps.into_iter().take(GAPS) {
            let at = 0.5 * (gap.from + gap.to);
            let delay = self.delays[self.delays.len() - 1];
            let Some(carried) = self.carried(at, delay) else { continue };
            let sites =
                model.recovery(self.mode).iter().flat_map(|way| self.problem.mission().sites_of(*way)).collect();
            let sites = self.by_distance(sites, &carried.state);
            gap.near_miss = sites.into_iter().find_map(|site| {
                let to = &self.problem.mission().after_fault.sites[site];
                let goal = Goal::Ground { at: to.at, radius: to.radius };
                let mut times = MORE_TIME.into_iter().map(|factor| factor * within);
                let takes = times.find(|time| self.tight.find(&carried.state, &goal, *time).is_some())?;
                Some(NearMiss { site, at, takes })
            });
        }
    }

    pub(super) fn by_distance(&self, mut sites: Vec<usize>, state: &NodeState) -> Vec<usize> {
        let all = &self.problem.mission().after_fault.sites;
        let distance = |site: &usize| (all[*site].at[0] - state[X][0]).hypot(all[*site].at[1] - state[Y][0]);
        sites.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        sites
    }

    /// Down within a radius of a place for each delay, m.
    pub(super) fn landed(
        &mut self,
        at: f64,
        carried: &[Carried],
        way: Way,
        to: [f64; 3],
        radius: f64,
    ) -> Option<Found> {
        let within = self.problem.model().plan.recovery.within;
        let goal = Goal::Ground { at: to, radius };
        self.for_each_delay(at, carried, way, |search, start| {
            let Start { state, alike: [last, of_longer_delay], .. } = start;
            // In the time of the longer delay, if there is one.
            let alike = [of_longer_delay, last];
            let likely = search.tight.likely_duration(state, &goal);
            let times = LONGER.map(|factor| factor * likely).into_iter().filter(|t| *t < within).chain([within]);
            let found = search.branch(state, alike, &start.tried(times.clone()), |_, _| goal)?;
            let is_known = last.is_some() && of_longer_delay.is_none();
            let shorter = if is_known { search.shorter(at, state, &found, times, goal) } else { None };
            Some(shorter.unwrap_or(found))
        })
    }

    /// A landing in a time so much shorter than that of one about a known one that it is worth the search; `None` where
    /// there is none. One time is tried at each instant, those that are shorter in turn, because most are too short.
    fn shorter(
        &mut self,
        at: f64,
        state: &NodeState,
        found: &Iterate,
        times: impl Iterator<Item = f64>,
        goal: Goal,
    ) -> Option<Iterate> {
        let shorter: Vec<f64> = times.filter(|time| MUCH_LONGER * time < found.grid.total).collect();
        let turn = (at / apart(self.plan.duration())) as usize;
        let time = *shorter.get(turn.checked_rem(shorter.len())?)?;
        self.branch(state, [None; 2], &[time], |_, _| goal)
    }

    /// Down where the vehicle comes to rest, or beside areas to keep off.
    pub(super) fn landed_here(&mut self, at: f64, carried: &[Carried]) -> Option<Found> {
        let mission = self.problem.mission();
        let ground = mission.ground?;
        let size = self.problem.model().vehicle.radius();
        let state = carried[carried.len() - 1].state;
        let time = self.tight.likely_duration(&state, &Goal::Rest);
        let stop = self.branch(&state, [None; 2], &[time, 2.0 * time], |_, _| Goal::Rest)?;
        let rest = &stop.states[stop.states.len() - 1];
        let mut place = [rest[X][0], rest[Y][0]];
        let mut over = mission.after_fault.too_close(place, size + HERE);
        for _ in 0..BESIDE {
            if over.1 <= 0.0 {
                break;
            }
            place = [0, 1].map(|i| place[i] + (over.1 + HERE) * over.0[i]);
            over = mission.after_fault.too_close(place, size + HERE);
        }
        if over.1 > 0.0 {
            return None;
        }
        self.landed(at, carried, Way::LandHere, [place[0], place[1], ground], HERE)
    }
}
