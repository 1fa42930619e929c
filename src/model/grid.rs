//! The time grid of a mission: how long each leg takes and into how many pieces it is cut. Planner and checker share
//! it, because it belongs to the meaning of a spec (docs/language.md, *Samples* and *Waypoint times*).

use super::Mission;

/// Slack when a whole number of pieces is taken from a quotient, so that rounding does not lose one.
const ROUNDING: f64 = 1e-9;

/// The duration of each leg, s, in flight order: between fixed arrival times, what holds leave is shared among the legs in
/// proportion to [`super::Leg::share`]. `None` where some leg would get no time.
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

/// The number of pieces of each leg, for leg durations in s: one piece for each hold, where nothing changes, and the
/// other `samples` for the legs, each at least one ([`Mission::least_intervals`] where there are enough).
pub fn pieces(mission: &Mission, durations: &[f64], samples: usize) -> Vec<usize> {
    let holds = mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
    let left = samples.saturating_sub(holds).max(durations.len());
    let needs = (0..durations.len()).map(|leg| mission.least_intervals(leg)).collect();
    shared(durations, needs, left)
}

/// Whole numbers that sum to `left`, in proportion to durations (largest remainders), but none below what its leg
/// needs; where there are too few for that, none below one.
fn shared(durations: &[f64], mut needs: Vec<usize>, left: usize) -> Vec<usize> {
    if needs.iter().sum::<usize>() > left {
        needs.fill(1);
    }
    let mut intervals = needs.clone();
    let mut free: Vec<usize> = (0..durations.len()).collect();
    let mut spare = left;
    loop {
        let total: f64 = free.iter().map(|&i| durations[i]).sum();
        let ideal = |i: usize| durations[i] / total * spare as f64;
        let (more, enough): (Vec<usize>, Vec<usize>) = free.iter().partition(|&&i| ideal(i) >= needs[i] as f64);
        if enough.is_empty() {
            more.iter().for_each(|&i| intervals[i] = (ideal(i) + ROUNDING).floor() as usize);
            let used: usize = more.iter().map(|&i| intervals[i]).sum();
            let remainder = |i: usize| ideal(i) - intervals[i] as f64;
            let mut order = more.clone();
            order.sort_by(|&a, &b| remainder(b).total_cmp(&remainder(a)));
            order.iter().take(spare - used).for_each(|&i| intervals[i] += 1);
            return intervals;
        }
        // These take what they need; what that costs the others may leave some of them short, too.
        spare -= enough.iter().map(|&i| needs[i]).sum::<usize>();
        free = more;
    }
}
