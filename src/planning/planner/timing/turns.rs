//! Lower bounds on the time from one rest to the next, from the waypoints between them at which the motion turns back.
//!
//! A motion that passes waypoints at which its component along a direction rises and falls in turn has no rate in this
//! direction at its extremes, so that each displacement between turns is one from rest to rest, apart from its jerk. In
//! the exact model the thrust also holds the weight meanwhile, which bounds its part sideways further.

use super::kinematics::LegRateBounds;
use super::weights::Push;
use crate::model::Waypoint;
use crate::tolerance;
use std::f64::consts::{FRAC_PI_2, PI};

/// So many horizontal directions are tried, evenly spaced over half a turn.
const DIRECTIONS: usize = 16;
/// Rounds of the search for a bound on which it depends itself.
const ROUNDS: usize = 3;
/// A bound found by such a search is lowered by this share.
const LOWERED: f64 = 2e-9;
/// Parts of the integral of a convex function, which its chords bound from above.
const PARTS: usize = 32;
/// Steps of the search for the multiplier.
const STEPS: usize = 40;

/// A lower bound on every t with `t >= at_least(t)`, where `at_least` falls, s.
pub(super) fn fixed_point(at_least: impl Fn(f64) -> f64) -> f64 {
    let (mut above, mut below) = (at_least(0.0), 0.0);
    for _ in 0..ROUNDS {
        below = at_least(above);
        above = at_least(below);
    }
    (1.0 - LOWERED) * below
}

/// The displacements between turns, m, and whether each rises, from the least and the largest component of every place.
fn displacements(places: &[[f64; 2]]) -> Vec<(bool, f64)> {
    let mut found = Vec::new();
    let Some((&first, rest)) = places.split_first() else { return found };
    let by = |from: [f64; 2], to: [f64; 2], rises: bool| if rises { to[0] - from[1] } else { from[0] - to[1] };
    let (mut from, mut furthest, mut is_rising) = (first, first, None);
    for &place in rest {
        let Some(rises) = is_rising else {
            is_rising = [true, false].into_iter().find(|rises| by(from, place, *rises) > 0.0);
            furthest = if is_rising.is_some() { place } else { furthest };
            continue;
        };
        if if rises { place[0] > furthest[0] } else { place[1] < furthest[1] } {
            furthest = place;
        } else if by(furthest, place, !rises) > 0.0 {
            found.push((rises, by(from, furthest, rises)));
            (from, furthest, is_rising) = (furthest, place, Some(!rises));
        }
    }
    found.extend(is_rising.map(|rises| (rises, by(from, furthest, rises))));
    found
}

/// The least time from the rest at the first of some waypoints to that at the last, s, under bounds that hold on all
/// legs between them.
pub(super) fn least(points: &[Waypoint], bounds: &LegRateBounds, level: Option<&Level>) -> f64 {
    let [first, .., last] = points else { return 0.0 };
    let room = |point: &Waypoint| point.within + 2.0 * tolerance::MOST_MISS;
    let along = |direction: [f64; 3]| -> Vec<[f64; 2]> {
        let place = |point: &Waypoint| {
            let at: f64 = (0..3).map(|i| direction[i] * point.position[i]).sum();
            [at - room(point), at + room(point)]
        };
        points.iter().map(place).collect()
    };
    let climbs = displacements(&along([0.0, 0.0, 1.0])).into_iter();
    let mut most: f64 = climbs.map(|(rises, by)| (if rises { bounds.up } else { bounds.down }).between_turns(by)).sum();
    let climbed = (last.position[2] - first.position[2]).abs() + room(first) + room(last);
    for k in 0..DIRECTIONS {
        let (sine, cosine) = (PI * k as f64 / DIRECTIONS as f64).sin_cos();
        let turns = displacements(&along([cosine, sine, 0.0]));
        most = most.max(turns.iter().map(|(_, by)| bounds.horizontal.between_turns(*by)).sum());
        let roots: f64 = turns.iter().map(|(_, by)| by.max(0.0).sqrt()).sum();
        most = most.max(level.map_or(0.0, |level| level.least(roots, climbed, most)));
    }
    most
}

/// What the thrust can do, over the mass, in the exact model.
#[derive(Debug, Clone, Copy)]
pub(super) struct Force {
    /// m/s^2
    pub most: f64,
    /// The largest angle from the vertical, rad, at most a right angle.
    pub tilt: f64,
    /// How far it may leave the cone of this angle, and how far it may point down, m/s^2.
    pub let_pass: f64,
    pub down: f64,
}

/// What bounds motions between two rests in the exact model, where the thrust accelerates sideways and holds the
/// weight. docs/certificates.md has the theorem.
pub(super) struct Level {
    /// phi for mu = 0, m/s^2.
    upright: f64,
    /// Another mu, and phi for it without the drag of the wind's and the vehicle's vertical velocity, m/s^2.
    mu: f64,
    phi: f64,
    /// drag/m, 1/s
    drag: f64,
    /// The sizes of the horizontal and the vertical component of the wind, m/s.
    wind: [f64; 2],
    /// The largest horizontal acceleration by the limits, m/s^2.
    acceleration: f64,
}

impl Level {
    pub fn new(push: &Push) -> Self {
        let Push { force, gravity, drag, wind: [x, y, z], acceleration, .. } = *push;
        let of = |mu: f64| force.phi(mu, gravity);
        // phi is convex in mu.
        let (mut low, mut high) = (-2.0, 4.0);
        for _ in 0..STEPS {
            let [a, b] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
            if of(a) <= of(b) {
                high = b;
            } else {
                low = a;
            }
        }
        let mu = 0.5 * (low + high);
        Level { upright: of(0.0), mu, phi: of(mu), drag, wind: [x.hypot(y), z.abs()], acceleration }
    }

    /// The least time, s, for the sum of the roots of displacements, m^(1/2). The vehicle climbs or sinks by `climbed`
    /// m in all, and takes at least `known` s.
    fn least(&self, roots: f64, climbed: f64, known: f64) -> f64 {
        if roots <= 0.0 || known <= 0.0 || !climbed.is_finite() {
            return 0.0;
        }
        let drift = self.drag * (self.wind[1] + climbed / known);
        let phi = (self.phi + self.mu.abs() * drift).min(self.upright);
        let at_least = |most: f64| {
            let x = 0.5 * self.drag * most;
            if x >= 1.0 {
                return 0.0;
            }
            let wind = self.wind[0] * self.drag.powi(2) * most / 24.0;
            let reach = (phi + wind * (1.0 + 0.5 * x)) / (1.0 - 0.5 * x);
            2.0 * roots / (4.0 * reach).min(self.acceleration).sqrt()
        };
        fixed_point(at_least)
    }
}

impl Force {
    /// An upper bound on phi without the drag of vertical velocities, m/s^2.
    fn phi(&self, mu: f64, gravity: f64) -> f64 {
        let at = |i: usize| self.most_along(0.5 * i as f64 / PARTS as f64, mu);
        let inner: f64 = (1..PARTS).map(at).sum();
        let integral = 0.5 / PARTS as f64 * (inner + 0.5 * (at(0) + at(PARTS)));
        2.0 * integral - mu * gravity
    }

    /// An upper bound on `s f_n + mu f_z` for a nonnegative s, m/s^2; convex in s.
    pub fn most_along(&self, s: f64, mu: f64) -> f64 {
        let out = self.let_pass * (s + mu.abs()) + mu.abs() * self.down;
        (self.most + self.let_pass) * self.support(s, mu) + out
    }

    /// The largest `s sin a + mu cos a`, or 0 if that is more, for an angle a up to the tilt.
    fn support(&self, s: f64, mu: f64) -> f64 {
        // The best angle has the tangent s/mu.
        let angle = if mu > 0.0 { (s / mu).atan().min(self.tilt) } else { self.tilt };
        // A right angle has a cosine above zero in floating point.
        let cosine = if angle < FRAC_PI_2 { angle.cos() } else { 0.0 };
        (s * angle.sin() + mu * cosine).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_there_and_back_has_two_displacements() {
        let places = [[0.0, 0.0], [4.9, 5.1], [9.9, 10.1], [9.8, 10.2], [2.0, 2.0], [2.1, 2.5]].to_vec();
        let found = displacements(&places);
        assert_eq!(found.iter().map(|(rises, _)| *rises).collect::<Vec<_>>(), [true, false, true]);
        let by: Vec<f64> = found.iter().map(|(_, by)| *by).collect();
        assert!((by[0] - 9.9).abs() < 1e-12 && (by[1] - 7.9).abs() < 1e-12 && (by[2] - 0.1).abs() < 1e-12, "{by:?}");
        assert!(displacements(&[[0.0, 1.0], [0.5, 1.5]]).is_empty());
    }

    /// With a tilt of at most L and a thrust F over the mass with `F cos L >= g`, the best mu gives
    /// `4 phi = g tan L (2 - g/(F cos L))`: F at full tilt at either end, and a fall between.
    #[test]
    fn phi_has_a_closed_form_under_a_limit_on_tilt() {
        let phi = |most: f64, tilt: f64| {
            let force = Force { most, tilt, let_pass: 0.0, down: 0.0 };
            let (speed, acceleration) = (f64::INFINITY, f64::INFINITY);
            Level::new(&Push { force, gravity: 9.81, drag: 0.0, wind: [0.0; 3], acceleration, speed }).phi
        };
        for (force, tilt) in [(27.0, 0.5), (15.0, 0.4), (40.0, 1.0)] {
            let closed = 9.81 * f64::tan(tilt) * (2.0 - 9.81 / (force * f64::cos(tilt)));
            let found = 4.0 * phi(force, tilt);
            assert!(found >= (1.0 - 1e-9) * closed && found <= 1.01 * closed, "{found} {closed}");
        }
        // Level flight holds the weight all the time; a motion that falls between may do better, but not than F alone.
        let free = 4.0 * phi(15.0, FRAC_PI_2);
        assert!(free > f64::sqrt(15.0 * 15.0 - 9.81 * 9.81) && free < 15.0, "{free}");
    }
}
