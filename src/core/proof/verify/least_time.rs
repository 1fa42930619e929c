//! Lower bounds on the time at which motions that satisfy the spec's limits at every instant reach each waypoint: from
//! distances, limits and full thrust, in interval arithmetic. docs/certificates.md has the theorem.
//!
//! Consider a leg with a displacement of at least d along some direction and a rate of at most v in it. Let s be the
//! sum of `1/a` over its ends at rest, with a the largest acceleration in the direction for the first end, and against
//! it for the last. If u is its largest rate, it takes at least `d/u + s u/2`, because the mean rate in the `u/a` s
//! next to an end at rest is at most `u/2`. This decreases in u up to `sqrt(2 d/s)`, where it has its minimum `sqrt(2 d
//! s)`; below that, u = v gives the bound. Drag that slows the motion more at larger rates adds `k u` to the largest
//! acceleration against the direction; from rest u is at most the largest acceleration in it times the time, so the
//! bound is the fixed point of [`turns::fixed_point`]. If the jerk is at most j and acceleration and rate start at
//! zero, the displacement is at most `j t^3/6`; if they also end at zero, at most `j T^3/32`, half of it in either
//! half.

mod turns;
mod weights;

use super::Rejection;
use super::cost::{self, Estimate};
use super::interval::{Interval, exceeds};
use super::schedule::fixed_total;
use super::sets::hover_thrust;
use crate::certificate::{MotionRecord, TooEarlyClaim, WeightsRecord};
use crate::model::{Heading, Limit, LimitKind, Model, PlanModel, Problem, Waypoint};
use crate::number::{apart, down_but_above, number};
use crate::tolerance::{MOST_MISS, MOST_OUTSIDE, MOST_PAST_LIMIT};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use weights::Push;

/// Instants with a smaller relative difference count as equal.
const SAME_TIME: f64 = 1e-9;

/// Upper bounds on rate, acceleration and jerk along a direction; infinite if there is none.
#[derive(Clone, Copy)]
struct RateBounds {
    rate: f64,
    /// In the direction.
    speeding: f64,
    /// Against it, at a rate of zero.
    slowing: f64,
    /// What drag adds to that for each unit of the rate, 1/s.
    drag: f64,
    /// In either direction, by the limits.
    acceleration: f64,
    jerk: f64,
}

impl RateBounds {
    /// The least time for a displacement of at least `d`, with rest at the first and the last end or not, rounded down,
    /// s.
    fn least(&self, d: Interval, rests: [bool; 2]) -> f64 {
        if !exceeds(d.low, 0.0) {
            return 0.0;
        }
        let smoothly = self.smoothly(d.low, rests);
        let at_rate = |rate: f64| self.least_at(Interval::point(d.low), rests, rate);
        let of_limits = at_rate(self.rate);
        if rests != [true; 2] || self.drag == 0.0 || !self.speeding.is_finite() {
            return of_limits.max(smoothly);
        }
        let within = |most: f64| (Interval::point(self.speeding) * Interval::point(most)).high.min(self.rate);
        turns::fixed_point(|most| at_rate(within(most))).max(of_limits).max(smoothly)
    }

    /// The least time for a displacement of at least `d` m between two instants at which the rate is zero, s.
    fn between_turns(&self, d: f64) -> f64 {
        RateBounds { jerk: f64::INFINITY, ..*self }.least(Interval::point(d), [true; 2])
    }

    /// The least time that follows from rates and accelerations, if no rate is above `fastest`, s.
    fn least_at(&self, d: Interval, rests: [bool; 2], fastest: f64) -> f64 {
        let (v, two) = (Interval::point(self.rate), Interval::point(2.0));
        let dragged = if self.drag > 0.0 { (Interval::point(self.drag) * Interval::point(fastest)).high } else { 0.0 };
        let slowing = (Interval::point(self.slowing) + Interval::point(dragged)).high.min(self.acceleration);
        // Where thrust cannot accelerate at all the vehicle never leaves; nothing is claimed of that.
        let bounded = |a: f64| a.is_finite() && a > 0.0;
        let speeding = self.speeding.min(self.acceleration);
        let at_rest = rests.into_iter().zip([speeding, slowing]).filter(|&(rests, a)| rests && bounded(a));
        let s = at_rest.fold(Interval::ZERO, |sum, (_, a)| sum + Interval::ONE / Interval::point(a));
        let whatever_the_rate = (two * d * s).sqrt().low;
        if !v.high.is_finite() {
            return whatever_the_rate;
        }
        let at_that_rate = (d / v).low;
        let slowed = if (s * v * v).high <= (two * d).low { (d / v + s * v / two).low } else { 0.0 };
        whatever_the_rate.max(at_that_rate).max(slowed)
    }

    /// The least time that follows from the bound on the jerk alone, s.
    fn smoothly(&self, d: f64, rests: [bool; 2]) -> f64 {
        let factor = match rests {
            [false, false] => 0.0,
            [true, true] => 32.0,
            _ => 6.0,
        };
        if !self.jerk.is_finite() || factor == 0.0 {
            return 0.0;
        }
        let (most, j) = (Interval::point(factor) * Interval::point(d), Interval::point(self.jerk));
        let root = (factor * d / self.jerk).cbrt();
        // A cube root is not correctly rounded on every platform; a value whose cube is small enough is a lower bound.
        let is_low = |t: f64| (Interval::point(t) * Interval::point(t) * Interval::point(t) * j).high <= most.low;
        [1e-15, 1e-14, 1e-12].into_iter().map(|share| (1.0 - share) * root).find(|&t| is_low(t)).unwrap_or(0.0)
    }
}

/// The directions in which a quantity is bounded.
#[derive(Clone, Copy)]
enum Sense {
    /// Towards larger values: the upper side of limits.
    Upwards,
    /// Towards smaller values: the lower side. Only limits on yaw have one; the others are on norms, or on the speed
    /// one way.
    Downwards,
}

/// How far a quantity may go in one direction on a leg under the limits of a kind, including the tolerance of the check
/// of plans.
fn most(of_leg: &[&Limit], kind: LimitKind, sense: Sense) -> f64 {
    let bound = |limit: &Limit| {
        let let_pass = Interval::point(MOST_PAST_LIMIT) * Interval::point(limit.size());
        let side = match sense {
            Sense::Upwards => limit.upper?,
            Sense::Downwards => -limit.lower?,
        };
        Some((Interval::point(side) + let_pass).high)
    };
    let of_kind = of_leg.iter().filter(|limit| limit.kind == kind);
    of_kind.filter_map(|limit| bound(limit)).fold(f64::INFINITY, f64::min)
}

/// The total thrust over the mass, m/s^2: `most` is an upper bound, and `reversed` one on its size where rotors that
/// reverse make it negative. A healthy set widened by its tolerance is the set scaled about its centre, so that either
/// end moves by this share of the thrust's whole range.
///
/// A reserve rho leaves `n.h + (1 - rho) (e - n.h)` of a plane `n.w <= e`, and all of it if hover h lies behind it: in
/// either case at most `rho n.h + (1 - rho) e`. Nonnegative multiples of the planes add up to `T <= full`, so that the
/// planes left add up to `T <= rho h + (1 - rho) full`.
struct Thrust {
    most: Interval,
    reversed: Interval,
}

impl Thrust {
    fn of(model: &Model, most_thrust: f64) -> Self {
        let vehicle = &model.vehicle;
        let (mut full, mut reversed) = (Interval::ZERO, Interval::ZERO);
        for rotor in &vehicle.rotors {
            let at = |speed: f64| {
                let speed = Interval::point(speed);
                Interval::point(rotor.thrust_coefficient) * speed * speed.abs()
            };
            full = full + at(rotor.max_speed) * Interval::point(rotor.spread.full_thrust.high);
            if rotor.is_reversible() {
                reversed = reversed - at(rotor.min_speed);
            }
        }
        let let_pass = Interval::point(MOST_OUTSIDE) * (full + reversed);
        let mass = Interval::point(vehicle.mass);
        let lightest = mass * Interval::point(vehicle.mass_spread.low);
        let reserve = Interval::point(model.plan.reserve);
        let hover = hover_thrust(vehicle, &model.environment()).enclosure() / mass;
        let kept = reserve * hover + (Interval::ONE - reserve) * full / lightest;
        let of_healthy = kept + let_pass / lightest;
        // Planes bound the thrust at the nominal mass.
        let of_sets = if most_thrust.is_finite() { Interval::point(most_thrust) / mass } else { of_healthy };
        let most = if of_sets.high < of_healthy.high { of_sets } else { of_healthy };
        Thrust { most, reversed: (reversed + let_pass) / lightest }
    }

    /// The largest acceleration downwards, m/s^2. In the exact model the thrust points along an axis of the body that
    /// points up, so that it cannot pull down beyond the tolerance on sets.
    fn falling(&self, model: &Model) -> Interval {
        let g = Interval::point(model.gravity);
        match model.plan.model {
            PlanModel::Hover => g + self.reversed,
            PlanModel::Exact => g + Interval::point(MOST_OUTSIDE) * self.most,
        }
    }
}

/// The largest horizontal acceleration on a leg for a given force per mass and the limit on tilt, m/s^2.
fn sideways(model: &Model, of_leg: &[&Limit], force: Interval) -> f64 {
    let tilt = most(of_leg, LimitKind::Tilt, Sense::Upwards);
    let let_pass = slack_of_tilt(model);
    // A drag along the body's z axis of its own changes the size of the thrust, but not its direction: the limit on
    // tilt, which is checked up to an acceleration, then does not bound the thrust.
    let tilt = if model.environment().is_isotropic() { tilt } else { FRAC_PI_2 };
    let is_tied = tilt < FRAC_PI_2;
    let (sine, cosine) = Interval::point(tilt.min(FRAC_PI_2)).sin_cos();
    match model.plan.model {
        PlanModel::Exact if is_tied => (force * sine + let_pass).high,
        PlanModel::Exact => (force + let_pass).high,
        PlanModel::Hover if is_tied => ((force * sine + let_pass) / cosine).high,
        PlanModel::Hover => f64::INFINITY,
    }
}

/// What drag leaves of bounds along some axes.
struct Dragged {
    /// m/s
    rate: f64,
    /// The largest acceleration at a rate of zero, m/s^2.
    acceleration: f64,
    /// What the drag adds to it for each unit of the rate where that slows the motion, 1/s.
    drag: f64,
}

/// Bounds on rate and acceleration along some axes, for bounds on these without drag (m/s, m/s^2). With k = drag/m and
/// the velocity w of the air, the rate u of a motion obeys `u' <= a + k |w| - k u` and `-u' <= a + k |w| + k u`, where
/// a is at most `most` at all times. So from rest u stays below most/k + |w|.
///
/// With a drag for each axis of the body, k is a symmetric matrix with eigenvalues from k0 to k1, the smallest and the
/// largest rate: the speed obeys `u' <= a + k1 |w| - k0 u` and `|u'| <= a + k1 (|w| + u)`. As the matrix couples the
/// axes of the world, this holds for all three axes alone.
fn with_drag(problem: Problem, rate: f64, acceleration: f64, most: Interval, axes: &[usize]) -> Dragged {
    let environment = problem.model().environment();
    if !environment.has_drag() {
        return Dragged { rate, acceleration, drag: 0.0 };
    }
    let [k0, k] = environment.extreme_rates().map(Interval::point);
    let a = Interval::point(acceleration);
    let wind =
        axes.iter().fold(Interval::ZERO, |sum, &axis| sum + Interval::point(environment.wind[axis]).square()).sqrt();
    let terminal = match problem.mission().start_at_rest && k0.low > 0.0 {
        true if k0 == k => (most / k + wind).high,
        true => ((most + k * wind) / k0).high,
        false => f64::INFINITY,
    };
    let rate = rate.min(terminal);
    match acceleration.is_finite() {
        true if environment.is_isotropic() => Dragged { rate, acceleration: (a + k * wind).high, drag: k.high },
        true if rate.is_finite() => {
            Dragged { rate, acceleration: (a + k * (wind + Interval::point(rate))).high, drag: 0.0 }
        }
        _ => Dragged { rate, acceleration: f64::INFINITY, drag: 0.0 },
    }
}

/// The bounds on the displacements of a leg.
#[derive(Clone, Copy)]
struct Bounds {
    along_line: RateBounds,
    horizontal: RateBounds,
    up: RateBounds,
    down: RateBounds,
    /// Turns to larger yaws.
    left: RateBounds,
    /// Turns to smaller yaws.
    right: RateBounds,
}

/// The bounds that some limits set together with the thrust.
fn bounds(problem: Problem, of_leg: &[&Limit], thrust: &Thrust) -> Bounds {
    let model = problem.model();
    let is_isotropic = model.environment().is_isotropic();
    let g = Interval::point(model.gravity);
    let force = thrust.most;
    let turning = |kind, sense| most(of_leg, kind, sense);
    let most = |kind| most(of_leg, kind, Sense::Upwards);
    let (speed, jerk) = (most(LimitKind::Speed), most(LimitKind::Jerk));
    let whole = most(LimitKind::Acceleration);
    // In the hover model the force is bounded only along z.
    let in_all = if model.plan.model == PlanModel::Exact { (force + g).high } else { f64::INFINITY };
    let all = [0, 1, 2];
    let of_all = with_drag(problem, speed, in_all, force + g, &all);
    // With a drag for each axis of the body: a part of the velocity is at most the whole, and so is that of the drag.
    let of_part = |own: f64, acceleration: f64, most: Interval, axes: &[usize]| match is_isotropic {
        true => with_drag(problem, own, acceleration, most, axes),
        false => {
            let rate = of_all.rate;
            Dragged { rate: own.min(rate), ..with_drag(problem, rate, acceleration, force + g, &all) }
        }
    };
    let both_ways = |of: &Dragged, acceleration: f64| RateBounds {
        rate: of.rate,
        speeding: of.acceleration,
        slowing: of.acceleration,
        drag: of.drag,
        acceleration,
        jerk,
    };
    let along_line = both_ways(&of_all, whole);
    let across = speed.min(most(LimitKind::SpeedHorizontal));
    let in_plane = of_part(across, sideways(model, of_leg, force), force, &[0, 1]);
    let horizontal = both_ways(&in_plane, whole.min(most(LimitKind::AccelerationHorizontal)));
    let vertical = |kind: LimitKind, speeding: Interval, slowing: Interval| {
        let rate = speed.min(most(kind));
        let in_air = |acceleration: Interval| of_part(rate, acceleration.high, force + g, &[2]);
        let [speeding, slowing] = [in_air(speeding), in_air(slowing)];
        RateBounds { speeding: speeding.acceleration, ..both_ways(&slowing, whole) }
    };
    let (rising, falling) = (force - g, thrust.falling(model));
    let [more, less] = [Sense::Upwards, Sense::Downwards];
    let turn = |ahead, back| RateBounds {
        rate: turning(LimitKind::YawRate, ahead),
        speeding: turning(LimitKind::YawAcceleration, ahead),
        slowing: turning(LimitKind::YawAcceleration, back),
        drag: 0.0,
        acceleration: f64::INFINITY,
        jerk: f64::INFINITY,
    };
    Bounds {
        along_line,
        horizontal,
        up: vertical(LimitKind::Climb, rising, falling),
        down: vertical(LimitKind::Descent, falling, rising),
        left: turn(more, less),
        right: turn(less, more),
    }
}

/// What bounds motions from one rest to the next under limits that hold everywhere: in the exact model, unless the drag
/// depends on the attitude.
fn push(problem: Problem, of_all: &[&Limit], thrust: &Thrust, speed: f64) -> Option<Push> {
    let model = problem.model();
    let environment = model.environment();
    let g = Interval::point(model.gravity);
    let most = |kind| most(of_all, kind, Sense::Upwards);
    let force = turns::Force {
        most: thrust.most,
        tilt: most(LimitKind::Tilt).min(FRAC_PI_2),
        let_pass: slack_of_tilt(model),
        down: thrust.falling(model) - g,
    };
    let is_bounded = model.plan.model == PlanModel::Exact && environment.is_isotropic();
    is_bounded.then(|| Push {
        force,
        gravity: g,
        drag: Interval::point(environment.extreme_rates()[1]),
        wind: environment.wind.map(Interval::point),
        acceleration: most(LimitKind::Acceleration).min(most(LimitKind::AccelerationHorizontal)),
        speed,
    })
}

/// By how much the check of plans lets the thrust over the mass leave the cone of a limit on tilt, m/s^2.
fn slack_of_tilt(model: &Model) -> Interval {
    Interval::point(MOST_PAST_LIMIT) * Interval::point(FRAC_PI_2.next_up()) * Interval::point(model.gravity)
}

/// The cost of [`soonest`]: of each leg the limits that concern it, and its turns in each direction.
pub(super) fn cost(problem: Problem, records: &[WeightsRecord]) -> Estimate {
    let weights = records.iter().map(|record| record.weights.len() as u64).fold(0, u64::saturating_add);
    let (legs, limits) = (problem.mission().legs.len() as u64, problem.mission().limits.len() as u64);
    let of_legs = cost::times(legs, limits.div_ceil(cost::LIMITS_OF_A_UNIT) + turns::DIRECTIONS as u64);
    Estimate { units: of_legs.saturating_add(cost::times(weights, cost::COST_PER_WEIGHT)), bytes: 0 }
}

/// Lower bounds on when each waypoint is reached, s, in the order of flight, by motions whose sets leave a thrust of at
/// most `most_thrust` N.
pub(super) fn soonest(problem: Problem, most_thrust: f64, records: &[WeightsRecord]) -> Vec<f64> {
    let mission = problem.mission();
    // Looked for once: missions may have thousands of limits, each of one leg.
    let of_all: Vec<&Limit> = mission.limits.iter().filter(|limit| limit.is_general()).collect();
    let thrust = Thrust::of(problem.model(), most_thrust);
    let general = bounds(problem, &of_all, &thrust);
    let push = push(problem, &of_all, &thrust, general.horizontal.rate);
    let level = push.as_ref().map(turns::Level::new);
    let mut of_rests: BTreeMap<(usize, usize), Vec<&WeightsRecord>> = BTreeMap::new();
    for record in records {
        if let [first, .., last] = record.waypoints[..] {
            of_rests.entry((first, last)).or_default().push(record);
        }
    }
    let mut of_legs: Vec<Vec<&Limit>> = vec![Vec::new(); mission.legs.len()];
    for limit in &mission.limits {
        if let Some(own) = limit.leg.as_ref().and_then(|on| of_legs.get_mut(on.leg)) {
            own.push(limit);
        }
    }
    let last = mission.waypoints.len().saturating_sub(1);
    let rests = |i: usize| {
        let point = &mission.waypoints[i];
        point.hold > 0.0 || point.stop || i == 0 && mission.start_at_rest || i == last && mission.end_at_rest
    };
    let leg = |i: usize| {
        let (from, to) = (&mission.waypoints[i], &mission.waypoints[i + 1]);
        let ends = [rests(i), rests(i + 1)];
        let apart = |axis: usize| Interval::point(to.position[axis]) - Interval::point(from.position[axis]);
        let sum = |axes: &[usize]| axes.iter().fold(Interval::ZERO, |sum, &axis| sum + apart(axis).square()).sqrt();
        let room = met_within(from.within, to.within);
        let has_yaw = from.heading == Heading::Given && to.heading == Heading::Given;
        let turned = Interval::point(to.yaw) - Interval::point(from.yaw);
        let yaw_room = met_within(from.yaw_within, to.yaw_within);
        let bounds = match &of_legs[i][..] {
            [] => general,
            own => bounds(problem, &[&of_all[..], own].concat(), &thrust),
        };
        let turn = |most: RateBounds, turned: Interval| if has_yaw { most.least(turned - yaw_room, ends) } else { 0.0 };
        [
            bounds.along_line.least(sum(&[0, 1, 2]) - room, ends),
            bounds.horizontal.least(sum(&[0, 1]) - room, ends),
            bounds.up.least(apart(2) - room, ends),
            bounds.down.least(-apart(2) - room, ends),
            turn(bounds.left, turned),
            turn(bounds.right, -turned),
        ]
        .into_iter()
        .fold(0.0, f64::max)
    };
    let legs: Vec<f64> = (0..last).map(leg).collect();
    let points = &mission.waypoints;
    let mut now = Interval::ZERO;
    let mut reached = Vec::new();
    // The last rest, and when the vehicle may leave it.
    let mut left: Option<(usize, Interval)> = None;
    for (i, Waypoint { time, hold, .. }) in points.iter().enumerate() {
        if i > 0 {
            now = now + Interval::point(legs[i - 1]);
        }
        if let Some((rest, since)) = left.filter(|_| rests(i)) {
            let by_turns = turns::least(&points[rest..=i], &general, level.as_ref());
            let records = of_rests.get(&(rest + 1, i + 1)).into_iter().flatten();
            let by_weights = records.filter_map(|record| Some(weights::least(points, &legs, record, push.as_ref()?)));
            let least = by_weights.fold(by_turns, f64::max);
            now = Interval::point(now.low.max((since + Interval::point(least)).low));
        }
        reached.push(now.low);
        now = Interval::point(time.map_or(now.low, |due| earliest(due).max(now.low))) + Interval::point(*hold);
        if rests(i) {
            left = Some((i, now));
        }
    }
    reached
}

/// When a waypoint with a fixed time may be reached, s: times agree to within [`SAME_TIME`].
fn earliest(due: f64) -> f64 {
    due - 2.0 * SAME_TIME * due.abs().max(1.0)
}

/// Checks that a motion reaches no waypoint sooner than motions within the limits can. The gaps at its joints and the
/// tolerances of its rows, each too small to matter, could make it so together.
///
/// # Errors
/// It does.
pub(super) fn not_beaten(
    problem: Problem,
    motion: &MotionRecord,
    most_thrust: f64,
    records: &[WeightsRecord],
) -> Result<(), Rejection> {
    let arrivals = motion.waypoint_nodes.iter().map(|&node| motion.times_s.get(node).copied().unwrap_or(f64::NAN));
    let is_beaten = |(_, (least, at)): &(usize, (f64, f64))| exceeds(earliest(*least), *at);
    let beaten = soonest(problem, most_thrust, records).into_iter().zip(arrivals).enumerate().find(is_beaten);
    match beaten {
        Some((i, (least, reached))) => {
            let [least, at] = apart(least, reached);
            let why = format!(
                "waypoint {} is reached after {at} s, but motions within limits and thrust take at least {least} s; \
                 the gaps and tolerances of this one add up",
                i + 1
            );
            Err(Rejection { at: Some(reached), ..Rejection::new("the least time", why) })
        }
        None => Ok(()),
    }
}

/// By how much two tolerances and the check of plans may shorten a displacement, m or rad.
fn met_within(from: f64, to: f64) -> Interval {
    Interval::point(from) + Interval::point(to) + Interval::point(2.0) * Interval::point(MOST_MISS)
}

/// Checks the claim that no motion within the spec's limits takes less than `claimed` s.
///
/// # Errors
/// The claim is stronger than the bound computed here.
pub(super) fn bound(
    problem: Problem,
    claimed: f64,
    most_thrust: f64,
    records: &[WeightsRecord],
) -> Result<(), Rejection> {
    let mission = problem.mission();
    if claimed < 0.0 {
        let why = format!("{} s is claimed, which is negative", number(claimed));
        return Err(Rejection::new("the least time", why));
    }
    let end = mission.waypoints.last();
    let (own, hold) =
        (soonest(problem, most_thrust, records).last().copied().unwrap_or(0.0), end.map_or(0.0, |w| w.hold));
    // A last waypoint with a fixed time is reached at that time.
    let reached = end.and_then(|w| w.time).map_or(own, |due| earliest(due).max(own));
    let own = (Interval::point(reached) + Interval::point(hold)).low;
    if exceeds(claimed, own) {
        let [claimed, own] = apart(claimed, own);
        let why = format!("{claimed} s is claimed, but distances, limits and thrust give {own} s");
        return Err(Rejection::new("the least time", why));
    }
    Ok(())
}

/// Checks the claim that some waypoint cannot be reached when it is due, and returns the headline.
///
/// # Errors
/// The waypoint is not due then, or the claim is stronger than the bound computed here.
pub(super) fn too_early(problem: Problem, claim: &TooEarlyClaim) -> Result<String, Rejection> {
    let mission = problem.mission();
    let points = &mission.waypoints;
    let name = "the time of a waypoint";
    let Some(point) = claim.waypoint.checked_sub(1).and_then(|i| points.get(i)) else {
        return Err(Rejection::new(name, format!("there is no waypoint {}", claim.waypoint)));
    };
    let is_last = claim.waypoint == points.len();
    let at_the_end = fixed_total(problem).filter(|_| is_last).map(|total| total - point.hold);
    let Some(due) = point.time.or(at_the_end) else {
        return Err(Rejection::new(name, format!("the spec does not fix the time of waypoint {}", claim.waypoint)));
    };
    let own = soonest(problem, f64::INFINITY, &claim.weights)[claim.waypoint - 1];
    if exceeds(claim.soonest_s, own) {
        let [claimed, own] = apart(claim.soonest_s, own);
        let why = format!("{claimed} s is claimed, but distances, limits and thrust give {own} s");
        return Err(Rejection::new(format!("the earliest arrival at waypoint {}", claim.waypoint), why));
    }
    if !exceeds(claim.soonest_s, due + SAME_TIME * due.max(1.0)) {
        let why = format!("waypoint {} is due at {} s, which is not too early", claim.waypoint, number(due));
        return Err(Rejection::new(name, why));
    }
    Ok(format!(
        "mission {} has no plan: waypoint {} is due at {} s, but motions within limits and thrust take at least {} s \
         to reach it, however the time is divided",
        mission.name,
        claim.waypoint,
        number(due),
        down_but_above(claim.soonest_s, 4, due)
    ))
}
