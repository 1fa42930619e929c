//! The time grid of a mission: how long each leg takes and into how many pieces it is divided. Planner and checker
//! share this module, because the grid is part of the meaning of a spec (docs/language.md, *Grid* and *Times*).

use super::Mission;

/// How the pieces of a leg share its duration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// All pieces have the same duration: the paper's grid.
    Even,
    /// Pieces are short near both ends of a leg, where a vehicle starts, turns or stops, and long in between: at t s
    /// from the nearer end their duration is proportional to `1 + t/`[`TRANSIENT`].
    Graded,
}

/// The duration of pieces doubles within this time from an end of a leg, s. Chosen among 2, 1 and 0.5 s: with
/// 2 s and 100 samples `specs/missions/parcel_x8.mav` took 1.1 % longer, `tower_hexa.mav` 2.4 %.
pub const TRANSIENT: f64 = 0.5;

impl Spacing {
    /// The weight of a leg when pieces are distributed, s: the integral over the leg of a node density that is 1 at its
    /// ends.
    fn measure(self, duration: f64) -> f64 {
        match self {
            Spacing::Even => duration,
            Spacing::Graded => 2.0 * TRANSIENT * (0.5 * duration / TRANSIENT).ln_1p(),
        }
    }

    /// The start of piece `nth` of the `count` pieces of a leg that takes `duration` s, in s after the start of the
    /// leg.
    pub fn start_of(self, duration: f64, nth: usize, count: usize) -> f64 {
        match self {
            Spacing::Even => duration * nth as f64 / count as f64,
            Spacing::Graded => duration * self.instant(duration, nth as f64 / count as f64),
        }
    }

    /// The instant at which the first `share` (0 to 1) of the pieces of a leg that takes `duration` s end, as a
    /// fraction of its duration.
    fn instant(self, duration: f64, share: f64) -> f64 {
        match self {
            Spacing::Even => share,
            Spacing::Graded if share > 0.5 => 1.0 - self.instant(duration, 1.0 - share),
            Spacing::Graded => (2.0 * share * (0.5 * duration / TRANSIENT).ln_1p()).exp_m1() * TRANSIENT / duration,
        }
    }

    /// The share (0 to 1) of the pieces of a leg of `duration` s that have ended after the fraction `instant` of its
    /// duration: the inverse of `instant`. NaN gives NaN: a certificate's times may have no ratio.
    pub fn share(self, duration: f64, instant: f64) -> f64 {
        match self {
            Spacing::Even => instant,
            Spacing::Graded if instant > 0.5 => 1.0 - self.share(duration, 1.0 - instant),
            Spacing::Graded => 0.5 * (instant * duration / TRANSIENT).ln_1p() / (0.5 * duration / TRANSIENT).ln_1p(),
        }
    }
}

/// Added before a quotient is rounded down to a number of pieces, so that rounding errors do not lose one.
const ROUNDING: f64 = 1e-9;

/// The duration of each leg, s, in flight order, for a mission that takes `total` s: between fixed arrival times, the
/// time left by holds is shared among the legs in proportion to [`super::Leg::share`]. `None` where some leg would get
/// no time.
pub fn leg_durations(mission: &Mission, total: f64) -> Option<Vec<f64>> {
    let points = &mission.waypoints;
    let last = points.len().checked_sub(1)?;
    let mut durations = vec![0.0; mission.legs.len()];
    let (mut from, mut leave) = (0, 0.0);
    for to in 1..=last {
        let arrival = match points[to].time {
            Some(t) => t,
            None if to == last => total - points[to].hold,
            None => continue,
        };
        let held: f64 = points[from..to].iter().map(|w| w.hold).sum();
        let free = arrival - leave - held;
        if free.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        let shares: f64 = mission.legs[from..to].iter().map(|l| l.share).sum();
        for (duration, leg) in durations[from..to].iter_mut().zip(&mission.legs[from..to]) {
            *duration = free * leg.share / shares;
        }
        (from, leave) = (to, arrival);
    }
    Some(durations)
}

/// The number of pieces of each leg, for leg durations in s. Each hold takes one of the `samples`, because nothing
/// changes during a hold; the legs share the others, with at least [`Mission::least_intervals`] each where there are
/// enough, and one otherwise.
pub fn pieces(mission: &Mission, durations: &[f64], samples: usize) -> Vec<usize> {
    Shares::of(mission, durations, samples).rounded()
}

/// The least number of pieces of each leg with which a grid has the resolution that `samples` requires: its share
/// rounded down. A small change of durations moves the rounding of [`pieces`] from one leg to another, which must not
/// count as a coarser grid.
pub fn fewest_pieces(mission: &Mission, durations: &[f64], samples: usize) -> Vec<usize> {
    Shares::of(mission, durations, samples).whole_parts()
}

/// Up to these factors a piece does not count as longer than the spec's. The factor for even grids allows for rounding;
/// that for graded ones for small changes of the duration, on which the shares depend, after the nodes were placed.
const MOST_LONGER_EVEN: f64 = 1.0 + 1e-6;
const MOST_LONGER_GRADED: f64 = 1.1;

/// Whether a leg has pieces that are longer than those of a grid with `fewest` pieces ([`fewest_pieces`]); `nodes` are
/// the instants of its nodes, s, from start to end. NaN counts as longer.
pub fn is_coarser(mission: &Mission, nodes: &[f64], fewest: usize) -> bool {
    let (Some(start), Some(end)) = (nodes.first(), nodes.last()) else { return false };
    let duration = end - start;
    let share = |t: f64| mission.spacing.share(duration, (t - start) / duration);
    let most = match mission.spacing {
        Spacing::Even => MOST_LONGER_EVEN,
        Spacing::Graded => MOST_LONGER_GRADED,
    };
    let pieces = |piece: &[f64]| (share(piece[1]) - share(piece[0])) * fewest as f64;
    nodes.windows(2).any(|piece| pieces(piece).partial_cmp(&most).is_none_or(std::cmp::Ordering::is_gt))
}

/// The pieces of each leg in proportion to its duration, but not fewer than the leg needs, or than one where there are
/// too few for that.
struct Shares {
    /// The pieces that a leg needs, where that is more than its share.
    needed: Vec<Option<usize>>,
    /// The shares of the other legs, in proportion to durations and not rounded.
    ideal: Vec<f64>,
    /// The number of pieces that the other legs share.
    spare: usize,
}

impl Shares {
    fn of(mission: &Mission, durations: &[f64], samples: usize) -> Shares {
        let holds = mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
        let left = samples.saturating_sub(holds).max(durations.len());
        let mut needs: Vec<usize> = (0..durations.len()).map(|leg| mission.least_intervals(leg)).collect();
        if needs.iter().sum::<usize>() > left {
            needs.fill(1);
        }
        let measures: Vec<f64> = durations.iter().map(|&d| mission.spacing.measure(d)).collect();
        let mut needed: Vec<Option<usize>> = vec![None; durations.len()];
        let mut spare = left;
        loop {
            let free = measures.iter().zip(&needed).filter(|(_, needed)| needed.is_none());
            let total: f64 = free.map(|(measure, _)| measure).sum();
            let ideal: Vec<f64> = measures.iter().map(|m| m / total * spare as f64).collect();
            let is_short = |leg: usize| needed[leg].is_none() && ideal[leg] < needs[leg] as f64;
            let short: Vec<usize> = (0..durations.len()).filter(|&leg| is_short(leg)).collect();
            if short.is_empty() {
                return Shares { needed, ideal, spare };
            }
            // These legs get what they need, which may leave others short: repeat.
            spare -= short.iter().map(|&leg| needs[leg]).sum::<usize>();
            short.into_iter().for_each(|leg| needed[leg] = Some(needs[leg]));
        }
    }

    fn whole_parts(&self) -> Vec<usize> {
        let whole = |ideal: f64| (ideal + ROUNDING).floor() as usize;
        self.needed.iter().zip(&self.ideal).map(|(needed, ideal)| needed.unwrap_or_else(|| whole(*ideal))).collect()
    }

    /// Rounds to whole numbers; the largest remainders are rounded up.
    fn rounded(&self) -> Vec<usize> {
        let mut pieces = self.whole_parts();
        let mut free: Vec<usize> = (0..pieces.len()).filter(|&leg| self.needed[leg].is_none()).collect();
        let used: usize = free.iter().map(|&leg| pieces[leg]).sum();
        let remainders: Vec<f64> = self.ideal.iter().zip(&pieces).map(|(ideal, whole)| ideal - *whole as f64).collect();
        free.sort_by(|&a, &b| remainders[b].total_cmp(&remainders[a]));
        free.iter().take(self.spare - used).for_each(|&leg| pieces[leg] += 1);
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::{Shares, Spacing, TRANSIENT};

    /// `share` undoes `instant`, and a short piece at t s from the nearer end is proportional to `1 + t/TRANSIENT`.
    #[test]
    fn graded_pieces_grow_with_the_distance_from_the_ends() {
        let (duration, count) = (25.0, 20_000);
        let start = |nth: usize| Spacing::Graded.start_of(duration, nth, count);
        assert!(start(0) == 0.0 && (start(count) - duration).abs() < 1e-12);
        for nth in [0, 100, 5_000, 9_999, 10_000, 15_000, 19_999] {
            let share = Spacing::Graded.share(duration, start(nth) / duration);
            assert!((share - nth as f64 / count as f64).abs() < 1e-12, "{nth}: {share}");
            let from_end = start(nth).min(duration - start(nth));
            let length = (start(nth + 1) - start(nth)) / start(1);
            assert!((length / (1.0 + from_end / TRANSIENT) - 1.0).abs() < 1e-3, "{nth}: {length}");
        }
        // Every piece counts the same in the measure.
        assert!((Spacing::Graded.measure(duration) / count as f64 / start(1) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn rounding_gives_a_leg_at_most_one_piece_more() {
        let shares = Shares { needed: vec![None, Some(5), None], ideal: vec![26.7, 0.0, 29.3], spare: 56 };
        assert_eq!(shares.whole_parts(), [26, 5, 29]);
        assert_eq!(shares.rounded(), [27, 5, 29]);
    }
}
