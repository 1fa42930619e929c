//! The search for weights on the acceleration from one rest to the next, from which a lower bound on the time follows.
//! The checker's `least_time::weights` has the inequality; nothing here is trusted.

use super::turns::Force;
use crate::certificate::WeightsRecord;
use crate::model::Waypoint;
use crate::tolerance;
use std::f64::consts::PI;

/// Parts of a leg, on each of which chords bound a convex function of the time from above.
const PARTS: usize = 8;
/// Changes of the weights that are tried, in units of the largest at the start. Chosen by hand.
const CHANGES: [f64; 9] = [0.4, 0.4, 0.2, 0.2, 0.1, 0.1, 0.05, 0.05, 0.02];
/// Weights on the vertical thrust with which the search begins. Chosen by hand.
const VERTICAL: [f64; 4] = [-0.6, -0.2, 0.0, 0.5];
/// Horizontal directions in which the search begins, evenly spaced over half a turn.
const DIRECTIONS: usize = 8;
/// Steps of the search for the price.
const STEPS: usize = 40;
/// A bound is lowered by this share: the checker rounds differently.
const LOWERED: f64 = 1e-11;

/// What bounds the acceleration between two rests.
pub(super) struct Push {
    pub force: Force,
    /// m/s^2
    pub gravity: f64,
    /// drag/m, 1/s
    pub drag: f64,
    /// m/s
    pub wind: [f64; 3],
    /// The largest horizontal acceleration by the limits, m/s^2.
    pub acceleration: f64,
    /// The largest horizontal speed, m/s.
    pub speed: f64,
}

/// A leg between two waypoints that require something.
struct Leg {
    /// m
    by: [f64; 2],
    /// The tolerances of both ends, m.
    room: f64,
    /// The least time that is known, s.
    floor: f64,
}

/// The terms of a leg in the inequality.
struct Terms {
    slope: f64,
    c: f64,
    constant: f64,
}

impl Terms {
    /// The least `(1 - price S) h + price (c/h + K)` for h of at least `floor`.
    fn least(&self, price: f64, floor: f64) -> f64 {
        let (share, weighted) = (1.0 - price * self.slope, price * self.c);
        if share < 0.0 {
            return f64::NEG_INFINITY;
        }
        let least = match weighted >= 0.0 && share * floor * floor <= weighted {
            true => 2.0 * (share * weighted).sqrt(),
            false if floor > 0.0 => share * floor + weighted / floor,
            false => f64::NEG_INFINITY,
        };
        least + price * self.constant
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The legs between two rests, and what is chosen for them.
struct Search<'a> {
    push: &'a Push,
    legs: Vec<Leg>,
    /// The height gained, m, and its tolerance.
    height: [f64; 2],
    weights: Vec<[f64; 2]>,
    vertical: f64,
    price: f64,
}

impl Search<'_> {
    fn terms(&self, leg: usize, vertical: f64) -> Terms {
        let (push, Leg { by, room, .. }) = (self.push, &self.legs[leg]);
        let [from, to] = [self.weights[leg], self.weights[leg + 1]];
        let change = [to[0] - from[0], to[1] - from[1]];
        let turned = change[0].hypot(change[1]);
        let (mut along, mut size) = (0.0, 0.0);
        for j in 0..=PARTS {
            let share = j as f64 / PARTS as f64;
            let length = (from[0] + change[0] * share).hypot(from[1] + change[1] * share);
            let weight = if j == 0 || j == PARTS { 0.5 } else { 1.0 } / PARTS as f64;
            along += weight * push.force.most_along(length, vertical);
            size += weight * length;
        }
        let c = -dot(change, *by) - turned * room;
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let (mut slope, mut constant) = (along - vertical * push.gravity, 0.0);
        if push.drag > 0.0 {
            let wind = dot(middle, [push.wind[0], push.wind[1]]) + vertical * push.wind[2];
            slope += push.drag * (0.25 * turned * push.speed + wind);
            constant = push.drag * (dot(middle, *by) - middle[0].hypot(middle[1]) * room);
        }
        if vertical == 0.0 && size * push.acceleration <= slope {
            (slope, constant) = (size * push.acceleration, 0.0);
        }
        Terms { slope, c, constant }
    }

    fn all(&self, vertical: f64) -> Vec<Terms> {
        (0..self.legs.len()).map(|leg| self.terms(leg, vertical)).collect()
    }

    /// The bound with some terms, s.
    fn bound(&self, terms: &[Terms], vertical: f64, price: f64) -> f64 {
        let legs: f64 = terms.iter().zip(&self.legs).map(|(terms, leg)| terms.least(price, leg.floor)).sum();
        let [gained, room] = self.height;
        legs + price * self.push.drag * (vertical * gained - vertical.abs() * room)
    }

    /// The best price, and the bound with it: a bound is concave in its price.
    fn best_price(&self, terms: &[Terms], vertical: f64) -> (f64, f64) {
        let steepest = terms.iter().map(|terms| terms.slope).fold(0.0, f64::max);
        if !(steepest > 0.0 && steepest.is_finite()) {
            return (0.0, f64::NEG_INFINITY);
        }
        let (mut low, mut high) = (0.0, 1.0 / steepest);
        for _ in 0..STEPS {
            let [a, b] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
            if self.bound(terms, vertical, a) >= self.bound(terms, vertical, b) { high = b } else { low = a }
        }
        (low, self.bound(terms, vertical, low))
    }

    /// Changes one weight after another as long as the bound grows.
    fn climb(&mut self) -> f64 {
        let mut best = f64::NEG_INFINITY;
        for change in CHANGES {
            (self.price, best) = self.best_price(&self.all(self.vertical), self.vertical);
            for vertical in [self.vertical - change, self.vertical + change] {
                let (price, found) = self.best_price(&self.all(vertical), vertical);
                if found > best {
                    (self.vertical, self.price, best) = (vertical, price, found);
                }
            }
            for i in 0..self.weights.len() {
                let beside = i.saturating_sub(1)..(i + 1).min(self.legs.len());
                let here = |search: &Self| -> f64 {
                    let least = |leg| search.terms(leg, search.vertical).least(search.price, search.legs[leg].floor);
                    beside.clone().map(least).sum()
                };
                let mut own = here(self);
                for (axis, by) in [(0, change), (0, -change), (1, change), (1, -change)] {
                    self.weights[i][axis] += by;
                    let changed = here(self);
                    if changed > own {
                        own = changed;
                    } else {
                        self.weights[i][axis] -= by;
                    }
                }
            }
        }
        let (price, found) = self.best_price(&self.all(self.vertical), self.vertical);
        if found > best {
            (self.price, best) = (price, found);
        }
        best
    }
}

/// The weights of a motion in one direction (an angle in rad), which turns where the legs do: full thrust one way for
/// half of the time between turns, then the other way, in place of which the weights fall linearly in time.
fn back_and_forth(legs: &[Leg], direction: f64) -> Vec<[f64; 2]> {
    let (sine, cosine) = direction.sin_cos();
    let by: Vec<f64> = legs.iter().map(|leg| dot(leg.by, [cosine, sine])).collect();
    let mut sizes = vec![0.0; legs.len() + 1];
    let mut start = 0;
    while start < by.len() {
        let rises = by[start] >= 0.0;
        let end = (start..by.len()).find(|&leg| (by[leg] >= 0.0) != rises).unwrap_or(by.len());
        let whole: f64 = by[start..end].iter().sum();
        let mut reached = 0.0;
        for leg in start..end {
            // The share of the time in which full acceleration and then full deceleration lead there.
            let share = if whole == 0.0 { 0.0 } else { (reached / whole).clamp(0.0, 1.0) };
            let time = if share < 0.5 { (0.5 * share).sqrt() } else { 1.0 - (0.5 - 0.5 * share).sqrt() };
            sizes[leg] = whole.signum() * (1.0 - 2.0 * time);
            reached += by[leg];
        }
        sizes[end] = -whole.signum();
        start = end;
    }
    sizes.into_iter().map(|size| [size * cosine, size * sine]).collect()
}

/// The best bound found on the time from the rest at the first waypoint to that at the last, s, and what shows it.
/// `floors` are the least times of the legs, s; `first` is the number of the first waypoint, from 1. Waypoints that are
/// not required join their legs.
pub(super) fn search(
    points: &[Waypoint],
    floors: &[f64],
    first: usize,
    is_required: impl Fn(&Waypoint) -> bool,
    push: &Push,
) -> Option<(f64, WeightsRecord)> {
    let ends = [0, points.len() - 1];
    let kept: Vec<usize> = (0..points.len()).filter(|i| ends.contains(i) || is_required(&points[*i])).collect();
    if kept.len() < 3 || (push.drag > 0.0 && !push.speed.is_finite()) {
        return None;
    }
    let room = |i: usize, j: usize| points[i].within + points[j].within + 2.0 * tolerance::MOST_MISS;
    let apart = |i: usize, j: usize, axis: usize| points[j].position[axis] - points[i].position[axis];
    let leg = |pair: &[usize]| {
        let (i, j) = (pair[0], pair[1]);
        Leg { by: [apart(i, j, 0), apart(i, j, 1)], room: room(i, j), floor: floors[i..j].iter().sum() }
    };
    let legs: Vec<Leg> = kept.windows(2).map(leg).collect();
    // The vehicle accelerates from the direction of one leg to that of the next.
    let along: Vec<[f64; 2]> = legs
        .iter()
        .map(|leg| {
            let length = leg.by[0].hypot(leg.by[1]);
            if length > 0.0 { leg.by.map(|by| by / length) } else { [0.0; 2] }
        })
        .collect();
    let direction = |leg: Option<usize>| leg.and_then(|leg| along.get(leg)).copied().unwrap_or([0.0; 2]);
    let turned = |i: usize| {
        let (before, after) = (direction(i.checked_sub(1)), direction(Some(i)));
        [after[0] - before[0], after[1] - before[1]]
    };
    let corners: Vec<[f64; 2]> = (0..kept.len()).map(turned).collect();
    let height = [apart(0, points.len() - 1, 2), room(0, points.len() - 1)];
    let mut search = Search { push, legs, height, weights: corners.clone(), vertical: 0.0, price: 0.0 };
    let mut best: Option<(f64, WeightsRecord)> = None;
    for vertical in VERTICAL {
        let mut tried = Vec::new();
        for k in 0..DIRECTIONS {
            search.weights = back_and_forth(&search.legs, PI * k as f64 / DIRECTIONS as f64);
            tried.push((search.best_price(&search.all(vertical), vertical).1, search.weights.clone()));
        }
        let along = tried.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, start)| start);
        for start in along.into_iter().chain([corners.clone()]) {
            (search.weights, search.vertical) = (start, vertical);
            let found = search.climb();
            if found.is_finite() && best.as_ref().is_none_or(|(least, _)| found > *least) {
                let record = WeightsRecord {
                    waypoints: kept.iter().map(|i| first + i).collect(),
                    weights: search.weights.clone(),
                    vertical: search.vertical,
                    price_s2_per_m: search.price,
                };
                best = Some(((1.0 - LOWERED) * found, record));
            }
        }
    }
    best
}
