//! Which instants are looked at, and the pieces of time that their outcomes make.

use super::Found;
use crate::recovery::{FoundBranch, Piece, RESOLUTION, steps};

/// Whether there is a way out at an instant, s.
#[derive(Clone, Copy)]
struct WayAt {
    at: f64,
    is_some: bool,
}

impl Found {
    fn is_way_at(&self) -> WayAt {
        WayAt { at: self.at, is_some: self.way.is_some() }
    }
}

/// The outcomes at instants of a plan that are [`crate::recovery::apart`] from each other, and where gaps begin and end
/// to [`RESOLUTION`]. `at` gives that of one instant.
pub(in crate::flights::recovery) fn at_instants(duration: f64, at: &mut dyn FnMut(f64) -> Found) -> Vec<Found> {
    let count = steps(duration);
    let mut found: Vec<Found> = Vec::new();
    for k in 0..=count as usize {
        let next = at(duration * k as f64 / count);
        if let Some(before) = found.last().map(Found::is_way_at) {
            ends_of_gaps([before, next.is_way_at()], at, &mut found);
        }
        found.push(next);
    }
    found
}

/// Adds outcomes between two instants until neighbours both have a way out, both have none, or are [`RESOLUTION`]
/// apart. Between different ways out as little is shown as between equal ones.
fn ends_of_gaps([before, after]: [WayAt; 2], at: &mut dyn FnMut(f64) -> Found, found: &mut Vec<Found>) {
    if before.is_some == after.is_some || after.at - before.at <= RESOLUTION {
        return;
    }
    let middle = at(0.5 * (before.at + after.at));
    let between = middle.is_way_at();
    ends_of_gaps([before, between], at, found);
    found.push(middle);
    ends_of_gaps([between, after], at, found);
}

/// The times of each outcome, and the branches for the longest delay.
pub(in crate::flights::recovery) fn pieces(found: Vec<Found>) -> (Vec<Piece>, Vec<FoundBranch>) {
    let (mut pieces, mut branches): (Vec<Piece>, Vec<FoundBranch>) = (Vec::new(), Vec::new());
    for Found { at, way, branches: of_delays, .. } in found {
        let index = of_delays.into_iter().next_back().map(|branch| {
            branches.push(branch);
            branches.len() - 1
        });
        match pieces.last_mut().filter(|piece| piece.way == way) {
            Some(piece) => {
                piece.to = at;
                piece.branches.extend(index);
            }
            None => {
                // A gap reaches to the instants around it. One way out gives place to another in the middle between
                // two instants.
                let from = pieces.last_mut().map_or(at, |before| {
                    before.to = match (before.way, way) {
                        (_, None) => before.to,
                        (None, Some(_)) => at,
                        (Some(_), Some(_)) => 0.5 * (before.to + at),
                    };
                    before.to
                });
                pieces.push(Piece { from, to: at, way, branches: index.into_iter().collect(), near_miss: None });
            }
        }
    }
    (pieces, branches)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recovery::Way;

    /// Ends of gaps are bisected, changes from one way out to another are not; pieces leave no hole.
    #[test]
    fn only_ends_of_gaps_are_bisected() {
        let way = |at: f64| match at {
            _ if (5.2..5.8).contains(&at) => None,
            _ if at < 3.3 => Some(Way::LandAt(0)),
            _ => Some(Way::LandAt(1)),
        };
        let mut looked_at = Vec::new();
        let found = at_instants(8.0, &mut |at| {
            looked_at.push(at);
            Found::without_branch(at, way(at))
        });
        let is_between = |at: &&f64| (2.0 * **at).fract() != 0.0;
        let between: Vec<f64> = looked_at.iter().filter(is_between).copied().collect();
        assert!(!between.is_empty() && between.iter().all(|at| (5.0..6.0).contains(at)), "{between:?}");
        let (pieces, _) = pieces(found);
        let ways: Vec<Option<Way>> = pieces.iter().map(|piece| piece.way).collect();
        assert_eq!(ways, [Some(Way::LandAt(0)), Some(Way::LandAt(1)), None, Some(Way::LandAt(1))]);
        assert!(pieces.windows(2).all(|pair| pair[0].to == pair[1].from), "{pieces:?}");
        assert_eq!((pieces[0].to, pieces[3].to), (3.25, 8.0));
        let gap = &pieces[2];
        assert!(gap.from <= 5.2 && gap.from > 5.2 - RESOLUTION && gap.to >= 5.8 && gap.to < 5.8 + RESOLUTION);
    }
}
