//! Lower bounds on the duration of each leg, from distances, limits and thrust alone. They hold for motions that keep
//! the spec's limits at every instant, whatever the division of the time. The planner's initial durations come from
//! them.
//!
//! Between two waypoints the displacement in a direction is the integral of the velocity in it. If the velocity is at
//! most v, a leg of length d takes at least d/v. With s the sum of `1/a` over those of its ends where the vehicle
//! rests, a the largest acceleration in the direction for the first end and against it for the last, it takes at least
//! `d/v + s v/2` where it reaches v, and `sqrt(2 d s)` where it does not (time-optimal control of the double
//! integrator; Bryson and Ho, *Applied Optimal Control*, 1975). At rest the acceleration vanishes too, so that a jerk
//! of at most j needs `(6 d/j)^(1/3)` from rest and `(32 d/j)^(1/3)` from rest to rest.

use super::turns::{self, Force, Level};
use super::weights::{self, Push};
use crate::admissible;
use crate::certificate::WeightsRecord;
use crate::model::{Heading, Limit, LimitKind, PlanModel, Problem, Waypoint};
use crate::planner::transcription::UNBOUNDED;
use crate::tolerance;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// Bounds on rates and accelerations of one displacement, SI; infinite where nothing bounds them.
#[derive(Debug, Clone, Copy)]
pub(super) struct RateBounds {
    rate: f64,
    /// In the direction of the displacement.
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
    /// Bounds with one acceleration for both directions.
    fn both_ways(rate: f64, acceleration: f64, jerk: f64) -> Self {
        RateBounds { rate, speeding: acceleration, slowing: acceleration, drag: 0.0, acceleration, jerk }
    }

    /// The least time for a displacement with rest at its first and its last end or not, s.
    fn least(self, displacement: f64, rests: [bool; 2]) -> f64 {
        if displacement <= 0.0 {
            return 0.0;
        }
        let factor = [0.0, 6.0, 32.0][rests.into_iter().filter(|rests| *rests).count()];
        let smooth = (factor * displacement / self.jerk).cbrt();
        let least = self.least_at(displacement, rests, self.rate).max(smooth);
        if rests != [true; 2] || self.drag == 0.0 || !self.speeding.is_finite() {
            return least;
        }
        // From rest no rate is above the acceleration times the time.
        let within = |most: f64| (self.speeding * most).min(self.rate);
        least.max(turns::fixed_point(|most| self.least_at(displacement, rests, within(most))))
    }

    /// The least time for a displacement between two instants at which the rate is zero, but not the acceleration, s.
    pub(super) fn between_turns(self, displacement: f64) -> f64 {
        RateBounds { jerk: f64::INFINITY, ..self }.least(displacement, [true; 2])
    }

    /// The least time that follows from rates and accelerations, if no rate is above `fastest`, s.
    fn least_at(self, displacement: f64, rests: [bool; 2], fastest: f64) -> f64 {
        let dragged = if self.drag > 0.0 { self.drag * fastest } else { 0.0 };
        let slowing = (self.slowing + dragged).min(self.acceleration);
        let (rate, speeding) = (self.rate, self.speeding.min(self.acceleration));
        // Where thrust cannot accelerate at all the vehicle never leaves; nothing is claimed of that.
        let at_rest = rests.into_iter().zip([speeding, slowing]).filter(|&(rests, a)| rests && a > 0.0);
        let s: f64 = at_rest.map(|(_, a)| 1.0 / a).sum();
        let unsaturated = (2.0 * displacement * s).sqrt();
        // The rate is reached if `s v^2/2`, what starting and stopping take, is no more than the displacement.
        match rate.is_finite() && 0.5 * s * rate * rate <= displacement {
            true => displacement / rate + 0.5 * s * rate,
            false => unsaturated,
        }
    }
}

/// What drag does to bounds on rates and accelerations.
struct Drag {
    /// The smallest and the largest drag over mass, 1/s.
    rates: [f64; 2],
    /// m/s
    wind: [f64; 3],
    starts_at_rest: bool,
}

impl Drag {
    fn of(problem: Problem) -> Self {
        let environment = problem.model().environment();
        let (rates, wind) = (environment.extreme_rates(), environment.wind);
        Drag { rates, wind, starts_at_rest: problem.mission().start_at_rest }
    }

    /// Bounds on rate and acceleration along some axes, where thrust and gravity accelerate by at most `acceleration`
    /// and limits allow the rate `rate`. With k = drag/m the rate u obeys `u' <= most + k |wind| - k u`, where `most`
    /// bounds what thrust and gravity give on any leg: from rest it stays below `most/k + |wind|`. Likewise
    /// `u' <= acceleration + k |wind| - k u` and `-u' <= acceleration + k |wind| + k u`.
    ///
    /// A drag for each axis of the body has the matrix K = R diag(k) R^T, whose eigenvalues lie between the smallest
    /// rate k0 and the largest k1: along all three axes `u' <= most + k1 |wind| - k0 u` and
    /// `|u'| <= acceleration + k1 (|wind| + u)`. It couples the axes, so that only `axes` of all three give a bound.
    fn paced(&self, rate: f64, acceleration: f64, most: f64, axes: &[usize]) -> Paced {
        let [least, largest] = self.rates;
        if largest == 0.0 {
            return Paced { rate, acceleration, drag: 0.0 };
        }
        let wind = axes.iter().map(|&axis| self.wind[axis].powi(2)).sum::<f64>().sqrt();
        let strength = if least == largest { wind } else { largest / least * wind };
        let terminal = if self.starts_at_rest && least > 0.0 { most / least + strength } else { f64::INFINITY };
        let rate = rate.min(terminal * (1.0 + ROUNDING));
        match self.is_isotropic() {
            true => Paced { rate, acceleration: acceleration + largest * wind, drag: largest },
            false => Paced { rate, acceleration: acceleration + largest * (wind + rate), drag: 0.0 },
        }
    }

    /// Whether the drag is the same along all axes of the body.
    fn is_isotropic(&self) -> bool {
        self.rates[0] == self.rates[1]
    }
}

/// What drag leaves of bounds along some axes.
struct Paced {
    /// m/s
    rate: f64,
    /// The largest acceleration at a rate of zero, m/s^2.
    acceleration: f64,
    /// What the drag adds to it for each unit of the rate where that slows the motion, 1/s.
    drag: f64,
}

/// The bounds that limits and thrust set for each displacement.
#[derive(Debug, Clone, Copy)]
pub(super) struct LegRateBounds {
    whole: RateBounds,
    pub(super) horizontal: RateBounds,
    pub(super) up: RateBounds,
    pub(super) down: RateBounds,
    /// Turns to larger yaws.
    left: RateBounds,
    /// Turns to smaller yaws.
    right: RateBounds,
    /// In the exact model, unless the drag depends on the attitude.
    force: Option<Force>,
}

/// A bound on a quantity towards larger values or towards smaller ones. Only limits on yaw have a lower side.
#[derive(Clone, Copy)]
enum Sense {
    Upwards,
    Downwards,
}

impl LegRateBounds {
    /// The bounds that limits set under the vehicle's full thrust, with intervals at the ends that allow most. Each
    /// limit is widened by the number beside it, in its SI unit, and by the tolerance of the check of plans
    /// ([`tolerance`]).
    ///
    /// The sets leave a thrust of at most `most_thrust` N.
    fn of(problem: Problem, limits: &[(&Limit, f64)], most_thrust: f64) -> Self {
        let model = problem.model();
        let turning = |kind: LimitKind, sense: Sense| {
            let of_kind = limits.iter().filter(|(limit, _)| limit.kind == kind);
            let bound = |(limit, past): &(&Limit, f64)| {
                let side = match sense {
                    Sense::Upwards => limit.upper?,
                    Sense::Downwards => -limit.lower?,
                };
                Some(side + past + tolerance::MOST_PAST_LIMIT * limit.size())
            };
            of_kind.filter_map(bound).fold(f64::INFINITY, f64::min)
        };
        let most = |kind| turning(kind, Sense::Upwards);
        let vehicle = &model.vehicle;
        let thrust: f64 = vehicle.rotors.iter().map(|r| r.max_thrust() * r.spread.full_thrust.high).sum();
        // Rotors that reverse make the thrust negative.
        let reversed: f64 = vehicle.rotors.iter().map(|r| (-r.idle_thrust()).max(0.0)).sum();
        let g = model.gravity;
        // Sets are kept to a share of the whole range of the thrust.
        let per_mass = |thrust: f64| thrust / (vehicle.mass * vehicle.mass_spread.low);
        let let_pass = tolerance::MOST_OUTSIDE * (thrust + reversed);
        // |(x'', y'', z'' + g)| is at most this. The reserve keeps its share of the way from hover to full thrust.
        let (reserve, hover) = (model.plan.reserve, admissible::hover(model)[0] / vehicle.mass);
        let of_healthy = reserve * hover + (1.0 - reserve) * per_mass(thrust) + per_mass(let_pass);
        let force = of_healthy.min(most_thrust / vehicle.mass);
        // Tilt is kept up to an acceleration: `|(x'', y'')| cos L - (z'' + g) sin L` is at most this share of g.
        let out = tolerance::MOST_PAST_LIMIT * FRAC_PI_2 * g;
        let tilt = most(LimitKind::Tilt);
        // Exactly |(x'', y'')| is a part of the force; about hover only a limit on tilt ties it to the thrust m (z'' +
        // g).
        let air = Drag::of(problem);
        // Drag along the body's z axis changes the size of the thrust, not its direction: then tilt does not bound the
        // force.
        let tilt = if air.is_isotropic() { tilt } else { FRAC_PI_2 };
        let (sideways, any) = match model.plan.model {
            PlanModel::Exact => (force * tilt.min(FRAC_PI_2).sin() + out, force + g),
            PlanModel::Hover if tilt < FRAC_PI_2 => (force * tilt.tan() + out / tilt.cos(), f64::INFINITY),
            PlanModel::Hover => (f64::INFINITY, f64::INFINITY),
        };
        let whole = most(LimitKind::Acceleration);
        // In the exact model the thrust points up; about hover, rotors that reverse pull down.
        let falling = match model.plan.model {
            PlanModel::Exact => g + tolerance::MOST_OUTSIDE * force,
            PlanModel::Hover => g + per_mass(reversed + let_pass),
        };
        let rising = force - g;
        let (speed, jerk) = (most(LimitKind::Speed), most(LimitKind::Jerk));
        let across = speed.min(most(LimitKind::SpeedHorizontal));
        let of_all = air.paced(speed, any, force + g, &[0, 1, 2]);
        // No part of the velocity is larger than the whole, nor is that of the drag.
        let part = |own: f64, acceleration: f64, most: f64, axes: &[usize]| match air.is_isotropic() {
            true => air.paced(own, acceleration, most, axes),
            false => {
                let rate = of_all.rate;
                Paced { rate: own.min(rate), ..air.paced(rate, acceleration, force + g, &[0, 1, 2]) }
            }
        };
        let both_ways = |of: &Paced, most: f64| RateBounds {
            drag: of.drag,
            acceleration: most,
            ..RateBounds::both_ways(of.rate, of.acceleration, jerk)
        };
        let vertical = |rate: LimitKind, speeding: f64, slowing: f64| {
            let rate = speed.min(most(rate));
            let [speeding, slowing] = [speeding, slowing].map(|most| part(rate, most, force + g, &[2]));
            RateBounds { speeding: speeding.acceleration, ..both_ways(&slowing, whole) }
        };
        let in_plane = part(across, sideways, force, &[0, 1]);
        let turn = |ahead: Sense, back: Sense| RateBounds {
            rate: turning(LimitKind::YawRate, ahead),
            speeding: turning(LimitKind::YawAcceleration, ahead),
            slowing: turning(LimitKind::YawAcceleration, back),
            drag: 0.0,
            acceleration: f64::INFINITY,
            jerk: f64::INFINITY,
        };
        let of_plane = whole.min(most(LimitKind::AccelerationHorizontal));
        let is_bounded = model.plan.model == PlanModel::Exact && air.is_isotropic();
        let tilt = tilt.min(FRAC_PI_2);
        let force = is_bounded.then_some(Force { most: force, tilt, let_pass: out, down: falling - g });
        LegRateBounds {
            whole: both_ways(&of_all, whole),
            horizontal: both_ways(&in_plane, of_plane),
            up: vertical(LimitKind::Climb, rising, falling),
            down: vertical(LimitKind::Descent, falling, rising),
            left: turn(Sense::Upwards, Sense::Downwards),
            right: turn(Sense::Downwards, Sense::Upwards),
            force,
        }
    }

    /// The least time from one waypoint to the next, each with rest or not, and the displacement that determines it.
    fn leg(&self, from: &Waypoint, to: &Waypoint, rests: [bool; 2]) -> LeastLeg {
        let room = from.within + to.within + 2.0 * tolerance::MOST_MISS;
        let yaw_room = from.yaw_within + to.yaw_within + 2.0 * tolerance::MOST_MISS;
        let has_yaw = from.heading == Heading::Given && to.heading == Heading::Given;
        let turned = |by: f64| if has_yaw { by - yaw_room } else { 0.0 };
        let [x, y, z]: [f64; 3] = std::array::from_fn(|i| to.position[i] - from.position[i]);
        let all = [
            (self.horizontal.least(x.hypot(y) - room, rests), Along::Horizontal),
            (self.up.least(z - room, rests), Along::Up),
            (self.down.least(-z - room, rests), Along::Down),
            (self.left.least(turned(to.yaw - from.yaw), rests), Along::Turn),
            (self.right.least(turned(from.yaw - to.yaw), rests), Along::Turn),
            (self.whole.least(x.hypot(y).hypot(z) - room, rests), Along::Line),
        ];
        let none = LeastLeg { seconds: 0.0, along: Along::Line };
        all.into_iter().fold(none, |most, (seconds, along)| match seconds > most.seconds {
            true => LeastLeg { seconds, along },
            false => most,
        })
    }
}

/// The displacement that determines a least duration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    Line,
    Horizontal,
    Up,
    Down,
    Turn,
}

impl Along {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Along::Line => "distance",
            Along::Horizontal => "horizontal",
            Along::Up => "climb",
            Along::Down => "descent",
            Along::Turn => "yaw",
        }
    }
}

/// The least duration of a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastLeg {
    /// s
    pub seconds: f64,
    pub along: Along,
}

/// A lower bound on a mission's time.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastTime {
    /// Of the whole mission with its holds, s.
    pub seconds: f64,
    pub legs: Vec<LeastLeg>,
    /// What shows it between rests, where that is more than the legs and turns show.
    pub weights: Vec<WeightsRecord>,
    /// The first waypoint that cannot be reached by its fixed time, and the earliest time at which it can, s.
    pub too_early: Option<(usize, f64)>,
}

/// Sums are rounded down by this share.
pub const ROUNDING: f64 = 1e-10;

/// Two times are equal within this share of them.
const SAME_TIME: f64 = 1e-9;

/// A lower bound on the time of every motion that meets the mission's waypoints, fixed times and holds and keeps its
/// limits at every instant, for every division of the time among the legs. `past` widens each limit, in its SI unit.
/// The wrench stays in the healthy set, and the thrust below `most_thrust` N.
pub fn least_time(problem: Problem, past: &[f64], most_thrust: f64) -> LeastTime {
    let mission = problem.mission();
    let points = &mission.waypoints;
    let last = points.len().saturating_sub(1);
    let widened = || mission.limits.iter().zip(past.iter().copied());
    let of_all: Vec<(&Limit, f64)> = widened().filter(|(limit, _)| limit.is_general()).collect();
    let mut of_legs: Vec<Vec<(&Limit, f64)>> = vec![Vec::new(); last];
    for (limit, past) in widened() {
        if let Some(leg) = limit.leg.as_ref().and_then(|on| of_legs.get_mut(on.leg)) {
            leg.push((limit, past));
        }
    }
    // Legs without limits of their own, and legs together, have the bounds of the mission.
    let general = LegRateBounds::of(problem, &of_all, most_thrust);
    let air = problem.model().environment();
    let push = general.force.map(|force| Push {
        force,
        gravity: problem.model().gravity,
        drag: air.extreme_rates()[1],
        wind: air.wind,
        acceleration: general.horizontal.acceleration,
        speed: general.horizontal.rate,
    });
    let level = push.as_ref().map(Level::new);
    let paces = |legs: Range<usize>| match &of_legs[legs.start][..] {
        own if legs.len() == 1 && !own.is_empty() => {
            LegRateBounds::of(problem, &[&of_all[..], own].concat(), most_thrust)
        }
        _ => general,
    };
    let rests = |i: usize| mission.rests_at(i);
    let mut legs = vec![LeastLeg { seconds: 0.0, along: Along::Line }; last];
    let mut from = 0;
    for to in 1..=last {
        // A waypoint that requires nothing does not end a leg.
        let is_required = is_required(&points[to]) || points[to].time.is_some() || mission.rests_at(to);
        if is_required || to == last {
            legs[to - 1] = paces(from..to).leg(&points[from], &points[to], [rests(from), rests(to)]);
            from = to;
        }
    }
    let floors: Vec<f64> = legs.iter().map(|leg| leg.seconds).collect();
    let mut weights = Vec::new();
    let (mut soonest, mut too_early) = (0.0_f64, None);
    // The last rest, and when the vehicle may leave it.
    let mut left: Option<(usize, f64)> = None;
    for (i, point) in points.iter().enumerate() {
        soonest += i.checked_sub(1).map_or(0.0, |leg| legs[leg].seconds);
        if let Some((rest, since)) = left.filter(|_| rests(i)) {
            let between = &points[rest..=i];
            soonest = soonest.max(since + turns::least(between, &general, level.as_ref()));
            let found =
                push.as_ref().and_then(|push| weights::search(between, &floors[rest..i], rest + 1, is_required, push));
            if let Some((least, record)) = found.filter(|(least, _)| since + least > soonest) {
                soonest = since + least;
                weights.push(record);
            }
        }
        if let Some(due) = point.time {
            if soonest > due + 2.0 * SAME_TIME * due.max(1.0) && too_early.is_none() {
                too_early = Some((i, soonest));
            }
            // Plans may be this much early.
            soonest = soonest.max(due - 2.0 * SAME_TIME * due.max(1.0));
        }
        soonest += point.hold;
        left = if rests(i) { Some((i, soonest)) } else { left };
    }
    LeastTime { seconds: (1.0 - ROUNDING) * soonest, legs, weights, too_early }
}

/// Whether a motion has to be near a waypoint.
fn is_required(point: &Waypoint) -> bool {
    point.within < UNBOUNDED
}

impl LeastTime {
    /// Whether the bound exceeds a mission time of `total` s.
    pub fn is_above(&self, total: f64) -> bool {
        self.too_early.is_some() || self.seconds > total + 2.0 * SAME_TIME * total.max(1.0)
    }
}

/// The least time of all plans, whichever faults they tolerate, with the spec's limits, none of them relaxed.
pub fn least_time_within(problem: Problem) -> LeastTime {
    least_time_inside(problem, f64::INFINITY)
}

/// The least time with the spec's limits of motions with a thrust of at most `most_thrust` N.
pub fn least_time_inside(problem: Problem, most_thrust: f64) -> LeastTime {
    least_time(problem, &vec![0.0; problem.mission().limits.len()], most_thrust)
}

/// The initial duration of a leg is at least this many times its least duration. Chosen by hand.
const OVER_LEAST: f64 = 1.25;
/// It is also at least this many times the flight from rest to rest at half of g. Chosen by hand.
const FLOWN_THROUGH: f64 = 0.7;

/// A share is at least this share of the mean, because every leg needs some time. Chosen by hand.
const LEAST_SHARE: f64 = 0.05;

/// Initial durations of the legs, s: by the distance, turn and limits of each leg.
pub fn initial(problem: Problem) -> Vec<f64> {
    let (model, mission) = (problem.model(), problem.mission());
    // At full thrust: the reserve would only make them longer.
    let mut full = model.clone();
    full.plan.reserve = 0.0;
    let least = Problem::of(&full).map_or_else(Vec::new, |problem| least_time_within(problem).legs);
    let half = RateBounds::both_ways(f64::INFINITY, 0.5 * model.gravity, f64::INFINITY);
    let legs = mission.waypoints.windows(2).zip(least).map(|(pair, least)| {
        let apart = (0..3).map(|i| (pair[1].position[i] - pair[0].position[i]).powi(2)).sum::<f64>().sqrt();
        (OVER_LEAST * least.seconds).max(FLOWN_THROUGH * half.least(apart, [true; 2]))
    });
    let durations: Vec<f64> = legs.collect();
    let mean = durations.iter().sum::<f64>() / durations.len().max(1) as f64;
    durations.into_iter().map(|d| if mean > 0.0 { d.max(LEAST_SHARE * mean) } else { 1.0 }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bang-bang motions by closed form.
    #[test]
    fn least_times_are_those_of_bang_bang_motions() {
        let pace = |rate: f64, acceleration: f64| RateBounds::both_ways(rate, acceleration, f64::INFINITY);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * b.max(1.0), "{a} {b}");
        let (both, first, last, neither) = ([true; 2], [true, false], [false, true], [false; 2]);
        near(pace(2.0, f64::INFINITY).least(10.0, both), 5.0);
        near(pace(f64::INFINITY, 2.0).least(8.0, both), 4.0); // 2 sqrt(d/a)
        near(pace(f64::INFINITY, 2.0).least(8.0, first), 8f64.sqrt()); // sqrt(2 d/a)
        near(pace(f64::INFINITY, 2.0).least(8.0, neither), 0.0);
        near(pace(3.0, 2.0).least(12.0, both), 4.0 + 1.5);
        near(pace(3.0, 2.0).least(12.0, last), 4.0 + 0.75);
        near(pace(3.0, 2.0).least(4.5, both), 3.0); // it just reaches 3 m/s
        assert_eq!(pace(3.0, 2.0).least(-1.0, both), 0.0);
        let smooth = RateBounds { jerk: 4.0, ..pace(f64::INFINITY, f64::INFINITY) };
        near(smooth.least(1.0, both), 2.0); // half a second each of 4, -4, -4, 4 m/s^3
        near(smooth.least(18.0, first), 3.0); // j t^3/6
        // Slowing at 1 m/s^2 takes four times as long as speeding up at 4: 9.6 m/s after 2.4 s, rest after 9.6 s more.
        let uneven = RateBounds { speeding: 4.0, slowing: 1.0, ..pace(f64::INFINITY, f64::INFINITY) };
        near(uneven.least(0.5 * 9.6 * 12.0, both), 12.0);
        near(uneven.least(8.0, first), 2.0);
        near(uneven.least(8.0, last), 4.0);
    }
}
