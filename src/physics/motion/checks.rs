//! Checks of the polynomials between nodes: violations of limits, and whether the trajectory stays in the range of the
//! linear model.

use super::{Trajectory, in_air, tilt};
use crate::model::grid::{fewest_pieces, is_coarser};
use crate::model::{Environment, Limit, LimitKind, Mission, Model, Part, Quantity, Rotor, Target};
use crate::motion::{NodeState, X, Y, YAW, Z};
use std::ops::Range;

/// Steps per interval in which a quantity is sampled before its largest value is refined.
pub(super) const STEPS: usize = 10;

/// The largest value of a quantity along a trajectory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The value, in the unit of the quantity.
    pub value: f64,
    /// The instant at which it is attained, s.
    pub at: f64,
}

/// A limit of the mission that the polynomials violate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitViolation {
    /// Index into the mission's limits.
    pub limit: usize,
    /// The largest violation, in the limit's SI unit.
    pub by: f64,
    /// The instant of the largest violation, s.
    pub at: f64,
}

/// The largest value of `quantity` over the trajectory: sampled in ten steps an interval, then refined by
/// golden-section search around the largest sample (`docs/method/validation.md`, "Between nodes").
pub fn peak(trajectory: &Trajectory, quantity: impl Fn(&NodeState) -> f64) -> Peak {
    peak_over(trajectory, 0..trajectory.intervals(), quantity)
}

/// The largest value of a quantity over some intervals.
pub(super) fn peak_over(
    trajectory: &Trajectory,
    intervals: Range<usize>,
    quantity: impl Fn(&NodeState) -> f64,
) -> Peak {
    let mut best_interval = intervals.start;
    let mut best = Peak { value: f64::NEG_INFINITY, at: trajectory.times[best_interval] };
    for k in intervals {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        for i in 0..=STEPS {
            let t = h * i as f64 / STEPS as f64;
            let value = quantity(&trajectory.within(k, t));
            if value > best.value {
                best = Peak { value, at: trajectory.times[k] + t };
                best_interval = k;
            }
        }
    }
    let begin = trajectory.times[best_interval];
    let h = trajectory.times[best_interval + 1] - begin;
    let step = h / STEPS as f64;
    let (mut low, mut high) = ((best.at - begin - step).max(0.0), (best.at - begin + step).min(h));
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..40 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        let value = |t: f64| quantity(&trajectory.within(best_interval, t));
        if value(a) > value(b) { high = b } else { low = a }
    }
    let t = 0.5 * (low + high);
    let value = quantity(&trajectory.within(best_interval, t));
    if value > best.value { Peak { value, at: begin + t } } else { best }
}

/// By how much `state` violates a limit, in the limit's SI unit; negative if the limit holds. In an
/// interval of winds a limit on tilt is taken in the worst of its corners.
pub fn violation(limit: &Limit, state: &NodeState, environment: &Environment) -> f64 {
    let norm = |axes: &[usize], order: usize| axes.iter().map(|&a| state[a][order].powi(2)).sum::<f64>().sqrt();
    let position = || [X, Y, Z].map(|axis| state[axis][0]);
    let value = match limit.kind.describe().quantity {
        Quantity::Axis { axis, order, sign } => sign * state[axis][order],
        Quantity::Norm { axes, order } => norm(axes, order),
        Quantity::Tilt => environment.corners().iter().map(|wind| tilt(state, wind)).fold(f64::NEG_INFINITY, f64::max),
        Quantity::Along(normal) => normal.iter().zip(position()).map(|(n, p)| n * p).sum(),
        Quantity::Distance(from) => from.distance(position()),
        Quantity::Clearance(obstacle) => obstacle.body.separation(position()).distance,
        Quantity::Arrival(direction) => {
            let (ahead, aside) = arrival(&direction, state);
            aside.atan2(ahead)
        }
        // Nothing is bounded where there is no direction.
        Quantity::Heading(target) => match off(&target, state) {
            Some(error) => error.abs(),
            None => return f64::NEG_INFINITY,
        },
    };
    let over = limit.upper.map_or(f64::NEG_INFINITY, |u| value - u);
    let under = limit.lower.map_or(f64::NEG_INFINITY, |l| l - value);
    over.max(under)
}

/// The distance of a vector from a cone about an axis with a half-angle (rad, below pi/2); `ahead` is its component
/// along the axis, `aside` the length of the rest.
fn outside_cone(aside: f64, ahead: f64, angle: f64) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    match ahead * cosine + aside * sine >= 0.0 {
        true => aside * cosine - ahead * sine,
        false => aside.hypot(ahead),
    }
}

/// The violation of a limit as the checker of plans measures it. It differs from [`violation`] for angles: their
/// violation is the distance from a cone, of the acceleration (divided by gravity), of the velocity, or of the
/// direction that the yaw follows.
pub(crate) fn violation_as_checked(limit: &Limit, state: &NodeState, environment: &Environment) -> f64 {
    match (limit.kind.describe().quantity, limit.upper) {
        (Quantity::Tilt, Some(upper)) => {
            let out = |wind: &Environment| {
                let state = in_air(state, wind);
                let up = state[Z][2] + wind.gravity;
                outside_cone(state[X][2].hypot(state[Y][2]), up, upper) / wind.gravity
            };
            environment.corners().iter().map(out).fold(f64::NEG_INFINITY, f64::max)
        }
        (Quantity::Arrival(direction), Some(upper)) => {
            let (ahead, aside) = arrival(&direction, state);
            outside_cone(aside, ahead, upper)
        }
        (Quantity::Heading(target), Some(upper)) => {
            let distance = |error: f64| outside_cone(error.sin().abs(), error.cos(), upper);
            off(&target, state).map_or(f64::NEG_INFINITY, distance)
        }
        (Quantity::Tilt | Quantity::Arrival(_) | Quantity::Heading(_), None)
        | (Quantity::Axis { .. } | Quantity::Norm { .. } | Quantity::Along(_), _)
        | (Quantity::Distance(_) | Quantity::Clearance(_), _) => violation(limit, state, environment),
    }
}

/// By how much the yaw is off the direction that a limit has it follow, rad; `None` where there is none.
pub fn heading_error(limit: &Limit, state: &NodeState) -> Option<f64> {
    match &limit.kind {
        LimitKind::Heading(target) => off(target, state),
        _ => None,
    }
}

fn off(target: &Target, state: &NodeState) -> Option<f64> {
    let [position, velocity] = [0, 1].map(|order| [X, Y].map(|axis| state[axis][order]));
    target.error(position, velocity, state[YAW][0])
}

/// The velocity along a direction of arrival, and the size of the rest, m/s.
fn arrival(along: &[f64; 3], state: &NodeState) -> (f64, f64) {
    let velocity = [X, Y, Z].map(|axis| state[axis][1]);
    let ahead: f64 = (0..3).map(|i| velocity[i] * along[i]).sum();
    (ahead, (0..3).map(|i| (velocity[i] - ahead * along[i]).powi(2)).sum::<f64>().sqrt())
}

/// The largest value of `quantity` while a limit holds: over the whole trajectory, over the limit's leg, or at its end.
pub fn peak_of(
    limit: &Limit,
    mission: &Mission,
    trajectory: &Trajectory,
    quantity: impl Fn(&NodeState) -> f64,
) -> Peak {
    let at = |node: usize| Peak { value: quantity(&trajectory.nodes[node]), at: trajectory.times[node] };
    match limit.leg.as_deref().map(|on| (on, on.part)) {
        None => peak(trajectory, quantity),
        Some((on, Part::Start)) => at(trajectory.waypoint_nodes[on.leg]),
        Some((on, Part::End)) => at(trajectory.waypoint_nodes[on.leg + 1]),
        Some((on, Part::Whole)) => peak_over(trajectory, leg_intervals(trajectory, mission, on.leg), quantity),
    }
}

/// The intervals of a leg.
pub fn leg_intervals(trajectory: &Trajectory, mission: &Mission, leg: usize) -> Range<usize> {
    // A hold is one interval.
    let held = usize::from(mission.waypoints[leg].hold > 0.0);
    trajectory.waypoint_nodes[leg] + held..trajectory.waypoint_nodes[leg + 1]
}

/// The limits of the mission that the polynomials violate by more than `tolerance` (in the limit's SI unit).
pub fn limit_violations(trajectory: &Trajectory, model: &Model, tolerance: f64) -> Vec<LimitViolation> {
    let limits = model.mission.iter().flat_map(|m| m.limits.iter().map(move |limit| (m, limit))).enumerate();
    let environment = model.environment();
    limits
        .filter_map(|(limit, (mission, l))| {
            let worst = peak_of(l, mission, trajectory, |s| violation(l, s, &environment));
            (worst.value > tolerance).then_some(LimitViolation { limit, by: worst.value, at: worst.at })
        })
        .collect()
}

/// The number of legs whose pieces are longer than those that `samples` give for the durations of the legs
/// ([`is_coarser`]).
pub(crate) fn coarser_legs(trajectory: &Trajectory, mission: &Mission, samples: usize) -> usize {
    let (times, nodes) = (&trajectory.times, &trajectory.waypoint_nodes);
    let legs = nodes.windows(2).zip(&mission.waypoints).map(|(ends, from)| {
        // A hold is one piece.
        let first = ends[0] + usize::from(from.hold > 0.0);
        &times[first..=ends[1]]
    });
    let legs: Vec<&[f64]> = legs.collect();
    let durations: Vec<f64> = legs.iter().map(|nodes| nodes[nodes.len() - 1] - nodes[0]).collect();
    let fewest = fewest_pieces(mission, &durations, samples);
    legs.iter().zip(fewest).filter(|(nodes, fewest)| is_coarser(mission, nodes, *fewest)).count()
}

/// The small-angle approximation is poor beyond this tilt, rad (20 degrees).
const SMALL_TILT: f64 = std::f64::consts::PI / 9.0;

/// The direction of the thrust, and so the attitude, becomes meaningless below this share of full thrust.
const LEAST_THRUST: f64 = 0.02;

/// The quantities that show whether a trajectory stays in the range of the linear model about hover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearRange {
    /// Largest tilt, rad.
    pub tilt: Peak,
    /// Smallest thrust of the linear model, `m (g + z'')`, N.
    pub least_thrust: Peak,
    /// Sum of the rotors' full thrusts, N.
    pub full_thrust: f64,
}

impl LinearRange {
    /// Whether the tilt exceeds [`SMALL_TILT`].
    pub(crate) fn tilts_too_far(&self) -> bool {
        self.tilt.value > SMALL_TILT
    }

    /// Whether the thrust falls below [`LEAST_THRUST`].
    pub(crate) fn nearly_falls(&self) -> bool {
        self.least_thrust.value < LEAST_THRUST * self.full_thrust
    }
}

/// The largest tilt and the smallest thrust of a trajectory (`docs/method/validation.md`).
pub fn linear_range(trajectory: &Trajectory, model: &Model) -> LinearRange {
    let environment = model.environment();
    let thrust = |s: &NodeState| model.vehicle.mass * (model.gravity + s[Z][2]);
    let least = peak(trajectory, |s| -thrust(s));
    LinearRange {
        tilt: peak(trajectory, |s| tilt(s, &environment)),
        least_thrust: Peak { value: -least.value, at: least.at },
        full_thrust: model.vehicle.rotors.iter().map(Rotor::max_thrust).sum(),
    }
}
