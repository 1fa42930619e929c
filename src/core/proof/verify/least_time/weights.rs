//! Lower bounds on the time from one rest to the next, from weights on the acceleration at the waypoints between them.
//!
//! Let lambda be a horizontal vector that is linear on each leg, with the weights w_0, ..., w_n at the waypoints. For a
//! motion from rest to rest, with displacements d_i in times h_i, integration by parts gives
//!
//! ```text
//! int lambda.p'' dt = sum c_i/h_i    with    c_i = (w_(i-1) - w_i).d_i
//! ```
//!
//! With the thrust over the mass f, k = drag/m and the velocity w of the air, `p'' = f - g e_z - k (p' - w)`, and the
//! mean of f_z is that of `g + k (z' - w_z)`. So for every mu, with the mean `m_i` of lambda on leg i, V the largest
//! horizontal speed and the supremum over all f within thrust and tilt,
//!
//! ```text
//! sum c_i/h_i + K <= sum S_i h_i
//! S_i = mean of sup(lambda.f + mu f_z) - mu g + k (|w_i - w_(i-1)| V/4 + m_i.w + mu w_z)
//! K   = k (sum m_i.d_i + mu times the height gained)
//! ```
//!
//! where V/4 bounds what `lambda - m_i` adds. Without mu, S_i is also at most the mean of |lambda| times a limit on the
//! horizontal acceleration, and then leg i adds nothing to K. For every price of at least 0, the time `sum h_i` is at
//! least `sum of min (1 - price S_i) h + price c_i/h` over `h >=` the least time of leg i, plus `price K`.

use super::met_within;
use super::turns::Force;
use crate::certificate::WeightsRecord;
use crate::model::Waypoint;
use crate::verify::interval::Interval;

/// Parts of a leg, on each of which chords bound a convex function of the time from above.
const PARTS: usize = 8;

/// What bounds the acceleration between two rests.
pub(super) struct Push {
    pub force: Force,
    /// m/s^2
    pub gravity: Interval,
    /// drag/m, 1/s
    pub drag: Interval,
    /// m/s
    pub wind: [Interval; 3],
    /// The largest horizontal acceleration by the limits, m/s^2.
    pub acceleration: f64,
    /// The largest horizontal speed, m/s.
    pub speed: f64,
}

type Pair = [Interval; 2];

fn dot(a: Pair, b: Pair) -> Interval {
    a[0] * b[0] + a[1] * b[1]
}

fn length(a: Pair) -> Interval {
    (a[0].square() + a[1].square()).sqrt()
}

/// The least time that a record shows for the legs between its waypoints, s; 0 if it shows none. `legs` has the least
/// time of every leg of the mission, s.
pub(super) fn least(points: &[Waypoint], legs: &[f64], record: &WeightsRecord, push: &Push) -> f64 {
    let at: Option<Vec<(&Waypoint, usize)>> =
        record.waypoints.iter().map(|&n| n.checked_sub(1).and_then(|i| Some((points.get(i)?, i)))).collect();
    let Some(at) = at else { return 0.0 };
    let has_shape = at.len() == record.weights.len() && at.is_sorted_by(|a, b| a.1 < b.1);
    let (mu, price) = (record.vertical, record.price_s2_per_m);
    let are_finite = mu.is_finite() && record.weights.iter().flatten().all(|w| w.is_finite());
    if !(has_shape && are_finite && price >= 0.0) {
        return 0.0;
    }
    let (mu, price) = (Interval::point(mu), Interval::point(price));
    let [(start, _), .., (end, _)] = at[..] else { return 0.0 };
    let mut total = Interval::ZERO;
    for (ends, weights) in at.windows(2).zip(record.weights.windows(2)) {
        let [(from, first), (to, last)] = [ends[0], ends[1]];
        let floor = legs[first..last].iter().fold(Interval::ZERO, |sum, leg| sum + Interval::point(*leg)).low;
        let apart = |axis: usize| Interval::point(to.position[axis]) - Interval::point(from.position[axis]);
        let room = met_within(from.within, to.within);
        let weights = [weights[0], weights[1]].map(|w| w.map(Interval::point));
        let leg = Leg::new(weights, mu, [apart(0), apart(1)], room, push);
        total = total + Interval::point(leg.least(price, floor));
    }
    let gained = Interval::point(end.position[2]) - Interval::point(start.position[2]);
    let height = gained + met_within(start.within, end.within) * Interval::around_zero(1.0);
    total = total + price * push.drag * mu * height;
    if total.low.is_finite() { total.low.max(0.0) } else { 0.0 }
}

/// The terms of one leg.
struct Leg {
    slope: Interval,
    c: Interval,
    constant: Interval,
}

impl Leg {
    fn new([from, to]: [Pair; 2], mu: Interval, by: Pair, room: Interval, push: &Push) -> Self {
        let parts = Interval::point(PARTS as f64);
        let change = [to[0] - from[0], to[1] - from[1]];
        let turned = length(change);
        let size = |j: usize| {
            let share = Interval::point(j as f64) / parts;
            length([from[0] + change[0] * share, from[1] + change[1] * share])
        };
        let mean = |of: &dyn Fn(Interval) -> Interval| {
            let ends = (of(size(0)) + of(size(PARTS))) / Interval::point(2.0);
            (1..PARTS).fold(ends, |sum, j| sum + of(size(j))) / parts
        };
        let c = -(dot(change, by) + turned * room * Interval::around_zero(1.0));
        let of_thrust = mean(&|size| push.force.most_along(size, mu)) - mu * push.gravity;
        let middle = [0, 1].map(|i| (from[i] + to[i]) / Interval::point(2.0));
        let of_limit = (mean(&|size| size) * Interval::point(push.acceleration)).high;
        let (mut slope, mut constant) = (of_thrust, Interval::ZERO);
        if push.drag.high > 0.0 {
            let wind = dot(middle, [push.wind[0], push.wind[1]]) + mu * push.wind[2];
            let spread = turned * Interval::point(push.speed) / Interval::point(4.0);
            slope = slope + push.drag * (spread + wind);
            constant = push.drag * (dot(middle, by) + length(middle) * room * Interval::around_zero(1.0));
        }
        if mu.high == 0.0 && of_limit <= slope.high {
            (slope, constant) = (Interval::point(of_limit), Interval::ZERO);
        }
        Leg { slope, c, constant }
    }

    /// The least `(1 - price S) h + price (c/h + K)` for h of at least `floor`.
    fn least(&self, price: Interval, floor: f64) -> f64 {
        let share = Interval::ONE - price * self.slope;
        let weighted = price * self.c;
        if !(share.low >= 0.0 && weighted.low.is_finite()) {
            return f64::NEG_INFINITY;
        }
        let (share, weighted) = (Interval::point(share.low), Interval::point(weighted.low));
        let at_floor = |floor: Interval| (share * floor + weighted / floor).low;
        let floor = Interval::point(floor);
        let least = match weighted.low >= 0.0 {
            // The sum is convex in h, and rises from where its two terms are equal.
            true if floor.low > 0.0 && (share * floor.square()).low >= weighted.high => at_floor(floor),
            true => (Interval::point(2.0) * (share * weighted).positive_part().sqrt()).low,
            false if floor.low > 0.0 => at_floor(floor),
            false => f64::NEG_INFINITY,
        };
        (Interval::point(least) + price * self.constant).low
    }
}
