//! Lower bounds on the time from one rest to the next, from the waypoints between them at which the motion turns back.
//!
//! Let p be the component of the place along a horizontal direction, and let waypoints i_0, ..., i_m be such that p
//! alternately rises and falls by at least d_1, ..., d_m between them, with rest at i_0 and i_m. Let T_0 be the time of
//! i_0, and T_j the instant in `[T_(j-1), t(i_(j+1))]` (with `t(i_m)` for the last) at which p is furthest in the
//! direction of d_j. The rate of p is zero there: t(i_j) lies in the interval, and p is less far at both its ends,
//! except for the last, which is at rest. So the time is at least the sum of the times that the displacements d_j take
//! from rest to rest. A turn has an acceleration, so that a bound on the jerk from rest to rest says nothing of it.

use super::weights::Push;
use super::{Bounds, met_within};
use crate::model::Waypoint;
use crate::verify::interval::{Interval, exceeds};

/// So many horizontal directions are tried, evenly spaced over half a turn.
pub(super) const DIRECTIONS: usize = 16;
/// Rounds of the search for a bound on which it depends itself.
const ROUNDS: usize = 3;
/// A bound is lowered by this share before it is checked.
const LOWERED: f64 = 1e-9;
/// Parts of the integral of a convex function, which its chords bound from above.
const PARTS: usize = 32;
/// Steps of the search for the multiplier.
const STEPS: usize = 40;

/// A lower bound on every t with `t >= at_least(t)`, where `at_least` falls, s; 0 if none is shown.
pub(super) fn fixed_point(at_least: impl Fn(f64) -> f64) -> f64 {
    let (mut above, mut below) = (at_least(0.0), 0.0);
    for _ in 0..ROUNDS {
        below = at_least(above);
        above = at_least(below);
    }
    let claimed = (1.0 - LOWERED) * below;
    // A time below `claimed` would be at least `at_least` of itself, so at least `at_least(claimed)`.
    if claimed > 0.0 && !exceeds(claimed, at_least(claimed)) { claimed } else { 0.0 }
}

/// How far p lies at least and at most at a waypoint, m.
#[derive(Clone, Copy)]
struct At {
    low: f64,
    high: f64,
}

impl At {
    fn mirrored(self) -> Self {
        At { low: -self.high, high: -self.low }
    }
}

/// The displacements between turns, m: those that rise, and those that fall.
fn displacements(places: &[At]) -> Vec<(bool, f64)> {
    let mut found = Vec::new();
    let Some((&first, rest)) = places.split_first() else { return found };
    let (mut from, mut furthest, mut is_rising) = (first, first, None);
    let by = |from: At, to: At, rises: bool| {
        let [from, to] = if rises { [from, to] } else { [from.mirrored(), to.mirrored()] };
        (Interval::point(to.low) - Interval::point(from.high)).low
    };
    for &place in rest {
        let rises = match is_rising {
            Some(rises) => rises,
            None if by(from, place, true) > 0.0 => true,
            None if by(from, place, false) > 0.0 => false,
            None => continue,
        };
        let is_further = is_rising.is_none()
            || match rises {
                true => place.low > furthest.low,
                false => place.high < furthest.high,
            };
        is_rising = Some(rises);
        if is_further {
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
pub(super) fn least(points: &[Waypoint], bounds: &Bounds, level: Option<&Level>) -> f64 {
    let along = |[x, y, z]: [f64; 3]| -> Vec<At> {
        let [x, y, z] = [x, y, z].map(Interval::point);
        let length = (x.square() + y.square() + z.square()).sqrt();
        let place = |point: &Waypoint| {
            let [at_x, at_y, at_z] = point.position.map(Interval::point);
            let (at, room) = ((x * at_x + y * at_y + z * at_z) / length, met_within(point.within, 0.0));
            At { low: (at - room).low, high: (at + room).high }
        };
        points.iter().map(place).collect()
    };
    let sum = |of: &[(bool, f64)], least: &dyn Fn(bool, f64) -> f64| {
        of.iter().fold(Interval::ZERO, |sum, &(rises, by)| sum + Interval::point(least(rises, by))).low
    };
    let vertical = displacements(&along([0.0, 0.0, 1.0]));
    let mut most = sum(&vertical, &|rises, by| (if rises { bounds.up } else { bounds.down }).between_turns(by));
    let climbed = match points {
        [first, .., last] => {
            let climbed = Interval::point(last.position[2]) - Interval::point(first.position[2]);
            (climbed.abs() + met_within(first.within, last.within)).high
        }
        _ => return 0.0,
    };
    for k in 0..DIRECTIONS {
        let (sine, cosine) = (std::f64::consts::PI * k as f64 / DIRECTIONS as f64).sin_cos();
        let turns = displacements(&along([cosine, sine, 0.0]));
        most = most.max(sum(&turns, &|_, by| bounds.horizontal.between_turns(by)));
        let roots = sum(&turns, &|_, by| Interval::point(by).positive_part().sqrt().low);
        most = most.max(level.map_or(0.0, |level| level.least(roots, climbed, most)));
    }
    most
}

/// What the thrust can do, over the mass, in the exact model.
pub(super) struct Force {
    /// m/s^2
    pub most: Interval,
    /// The largest angle from the vertical, rad, at most a right angle.
    pub tilt: f64,
    /// How far it may leave the cone of this angle, and how far it may point down, m/s^2.
    pub let_pass: Interval,
    pub down: Interval,
}

/// The bound on motions between two rests that follows from the thrust's two tasks, in the exact model: it accelerates
/// sideways and holds the weight.
///
/// With k = drag/m, w the velocity of the air and f the thrust over the mass, `u' = f_n - k (u - w_n)` for the rate u
/// of p. A displacement d from rest to rest in T_j is the integral of `(1 - e^(k (t - c)))/k (f_n + k w_n)`, for every
/// c; with c in the middle its weight is at most `E |t - c|`, `E = (e^x - 1)/x`, `x = k T_j/2`, and the wind adds at
/// most `|w_n| k^2 T_j^3 cosh(x)/24`. From rest to rest the mean of f_z is g, apart from the drag `k (z' - w_z)`. So
/// for every mu the sum of `d_j/T_j` is at most `E phi T + |w_n| k^2 T^2 cosh(x)/24`, with x = k T/2 and
///
/// `phi = 2 int_0^(1/2) sup(s f_n + mu f_z) ds - mu g + |mu| k (|w_z| + climbed/T)`,
///
/// where the supremum is over all f within the limits. It grows with s, so that the time after T_m adds no more than
/// its share. By Cauchy's inequality `(sum of sqrt(d_j))^2 <= T sum of d_j/T_j`.
pub(super) struct Level {
    /// phi for mu = 0, m/s^2.
    upright: Interval,
    /// Another mu, and phi for it without the last term of phi.
    mu: Interval,
    phi: Interval,
    /// drag/m, 1/s
    drag: Interval,
    /// The horizontal and the vertical component of the wind, m/s.
    wind: [Interval; 2],
    /// The largest horizontal acceleration by the limits, m/s^2.
    acceleration: f64,
}

impl Level {
    pub fn new(push: &Push) -> Self {
        let Push { force, gravity, drag, wind, acceleration, .. } = push;
        let of = |mu: f64| force.phi(Interval::point(mu), *gravity);
        // phi is convex in mu.
        let (mut low, mut high) = (-2.0, 4.0);
        for _ in 0..STEPS {
            let [a, b] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
            if of(a).high <= of(b).high { high = b } else { low = a }
        }
        let mu = 0.5 * (low + high);
        let [x, y, z] = *wind;
        let wind = [(x.square() + y.square()).sqrt(), z.abs()];
        Level { upright: of(0.0), mu: Interval::point(mu), phi: of(mu), drag: *drag, wind, acceleration: *acceleration }
    }

    /// The least time, s, for the sum of the roots of displacements, m^(1/2). The vehicle climbs or sinks by `climbed`
    /// m in all, and takes at least `known` s.
    fn least(&self, roots: f64, climbed: f64, known: f64) -> f64 {
        if roots <= 0.0 || known <= 0.0 || !climbed.is_finite() {
            return 0.0;
        }
        let two = Interval::point(2.0);
        let drift = self.drag * (self.wind[1] + Interval::point(climbed) / Interval::point(known));
        let phi = Interval::point((self.phi + self.mu.abs() * drift).high.min(self.upright.high));
        let at_least = |most: f64| {
            let x = self.drag * Interval::point(most) / two;
            if x.high >= 1.0 {
                return 0.0;
            }
            // (e^x - 1)/x <= 1/(1 - x/2) and cosh x <= (1 + x/2)/(1 - x/2) for x below 1.
            let less = Interval::ONE - x / two;
            let wind = self.wind[0] * self.drag.square() * Interval::point(most) / Interval::point(24.0);
            let reach = phi / less + wind * (Interval::ONE + x / two) / less;
            let reach = (Interval::point(4.0) * reach).high.min(self.acceleration);
            (two * Interval::point(roots) / Interval::point(reach).sqrt()).low
        };
        fixed_point(at_least)
    }
}

impl Force {
    /// An upper bound on phi without its last term, m/s^2.
    fn phi(&self, mu: Interval, gravity: Interval) -> Interval {
        let [half, parts] = [0.5, PARTS as f64].map(Interval::point);
        let at = |i: usize| self.most_along(half * Interval::point(i as f64) / parts, mu);
        let inner = (1..PARTS).fold(Interval::ZERO, |sum, i| sum + at(i));
        let integral = half / parts * (inner + half * (at(0) + at(PARTS)));
        Interval::point(2.0) * integral - mu * gravity
    }

    /// An upper bound on `s f_n + mu f_z` for a nonnegative s, m/s^2; convex in s.
    pub fn most_along(&self, s: Interval, mu: Interval) -> Interval {
        let size = mu.abs();
        let out = self.let_pass * (s + size) + size * self.down;
        (self.most + self.let_pass) * self.support(s, mu) + out
    }

    /// The largest `s sin a + mu cos a`, or 0 if that is more, for an angle a up to the tilt.
    fn support(&self, s: Interval, mu: Interval) -> Interval {
        let (sine, cosine) = Interval::point(self.tilt).sin_cos();
        let at_the_limit = match self.tilt < std::f64::consts::FRAC_PI_2 {
            true => s * sine + mu * cosine,
            false => s,
        };
        // The best angle has the tangent s/mu.
        let is_beyond = mu.high <= 0.0 || (s * cosine).low > (mu * sine).high;
        let most = if is_beyond { at_the_limit } else { (s.square() + mu.square()).sqrt() };
        most.positive_part()
    }
}
