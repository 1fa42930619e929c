//! Limits imposed on plans: as rows of a program, linear for one axis, second-order cones for norms; and the violation
//! of a limit by a state.

mod followed_yaw;

use crate::body::Separation;
use crate::model::{DistanceFrom, Environment, Limit, LimitKind, Part, Quantity, Target};
use crate::motion::{NodeState, X, Y, YAW, Z, in_air};
use crate::planner::transcription::Transcription;
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use followed_yaw::{FollowedYaw, PAUSED};

/// Whether a limit holds at an instant, with `parts` of them in each interval between nodes. A limit of one leg holds
/// at both its waypoints too, and one on a yaw that follows from the motion at nodes only.
pub(super) fn covers(limit: &Limit, waypoint_nodes: &[usize], parts: usize, instant: usize) -> bool {
    let Some(on) = &limit.leg else { return true };
    let (first, last) = (waypoint_nodes[on.leg] * parts, waypoint_nodes[on.leg + 1] * parts);
    match on.part {
        Part::Start => instant == first,
        Part::End => instant == last,
        Part::Whole if limit.kind.is_heading() && !instant.is_multiple_of(parts) => false,
        Part::Whole => (first..=last).contains(&instant),
    }
}

/// Whether a limit holds inside an interval between nodes.
pub(super) fn covers_interval(limit: &Limit, waypoint_nodes: &[usize], interval: usize) -> bool {
    let Some(on) = &limit.leg else { return true };
    let leg = waypoint_nodes[on.leg]..waypoint_nodes[on.leg + 1];
    on.part == Part::Whole && !limit.kind.is_heading() && leg.contains(&interval)
}

/// By how much more a step keeps the volume or corridor of a limit, m, given the `room` that volumes get: in a corridor
/// at most a quarter of its half width, and none where there is neither.
pub(super) fn room_of(limit: &Limit, room: f64) -> f64 {
    limit.volume.as_ref().map_or(0.0, |volume| volume.half_width.map_or(room, |half| room.min(0.25 * half)))
}

/// Whether a limit is tightened by a distance or an angle: it bounds a place, and is no distance from a body, which the
/// share widens. Waypoints may lie on its bound, so that it cannot always be tightened.
pub(super) fn has_inset(limit: &Limit) -> bool {
    limit.kind.is_of_place() && !limit.kind.is_clearance()
}

/// The share (1 + delta)^m - 1 by which a bound on a derivative of order m grows with the relative change delta of a
/// duration, in a program.
#[derive(Debug, Clone, Default)]
pub(super) struct Growth {
    /// At most that share: for bounds whose rows get looser as it grows.
    pub at_most: Affine,
    /// At least that share, and equal to first order: for the others.
    pub at_least: Affine,
}

/// By how much bounds are widened in a program.
pub(super) struct Widening {
    /// Each bound is wider by this share of itself, except bounds on positions.
    share: Affine,
    /// With a relative change delta of the duration derivatives of order m shrink by (1 + delta)^m, so that bounds on
    /// them, in the old time, grow by this share at order m = 0, 1, ...
    growth: [Growth; 5],
    /// How much further inside the bounds of volumes the position stays, m; see [`Transcription::room`].
    room: f64,
    /// How much further inside bounds on places it stays, m and rad: their tightening.
    inset: f64,
}

impl Widening {
    /// Each bound wider by this share of itself, the duration unchanged.
    pub fn by(share: &Affine) -> Self {
        Widening { share: share.clone(), growth: Default::default(), room: 0.0, inset: 0.0 }
    }

    /// This widening with a change of the duration.
    pub fn with_growth(self, growth: [Growth; 5]) -> Self {
        Widening { growth, ..self }
    }

    /// This widening with volumes kept by this much more, m.
    pub fn with_room(self, room: f64) -> Self {
        Widening { room, ..self }
    }

    /// This widening with bounds on places, which no share widens, kept by this much more, m and rad.
    pub fn with_inset(self, inset: f64) -> Self {
        Widening { inset, ..self }
    }

    /// A bound on a derivative of the given order; `side` is 1 for upper bounds, -1 for lower ones.
    pub(super) fn bound(&self, bound: f64, order: usize, side: f64) -> Affine {
        let mut wider = Affine::constant(bound);
        wider.add(&self.share, side * widens(order, bound));
        let Growth { at_most, at_least } = &self.growth[order];
        wider.add(if side * bound >= 0.0 { at_most } else { at_least }, bound);
        wider
    }

    /// A lower bound on the distance from a body, m. It is not convex, so the share applies to it: [`CLEARANCE_UNIT`] a
    /// unit.
    fn clearance(&self, lower: f64) -> Affine {
        let mut wider = Affine::constant(lower);
        wider.add(&self.share, -CLEARANCE_UNIT);
        wider
    }
}

/// A violation of one unit of a distance from a body, m.
const CLEARANCE_UNIT: f64 = 1.0;

/// A violation of one unit of a direction of arrival, m/s.
const ARRIVAL_UNIT: f64 = 1.0;

const SPACE: &[usize] = &[X, Y, Z];

/// A yaw that follows a target to within `upper` rad at an instant.
struct FollowedAt {
    target: Target,
    upper: f64,
    instant: usize,
}

/// The parts of a second-order cone: the length of `parts` is at most `reach`.
fn cone(reach: Affine, parts: Vec<Affine>) -> Vec<Affine> {
    std::iter::once(reach).chain(parts).collect()
}

/// `a - (a . along) along`, for a unit vector `along`.
fn across(along: [f64; 3], a: &[Affine]) -> Vec<Affine> {
    let ahead = self::along(along, a);
    let part = |(part, along): (&Affine, f64)| {
        let mut across = part.clone();
        across.add(&ahead, -along);
        across
    };
    a.iter().zip(along).map(part).collect()
}

/// The part of a vector along a unit vector, and the length of the rest.
fn split(along: [f64; 3], a: [f64; 3]) -> (f64, f64) {
    let ahead: f64 = (0..3).map(|i| a[i] * along[i]).sum();
    (ahead, (0..3).map(|i| (a[i] - ahead * along[i]).powi(2)).sum::<f64>().sqrt())
}

/// `normal . p`.
fn along(normal: [f64; 3], p: &[Affine]) -> Affine {
    let mut sum = Affine::default();
    normal.iter().zip(p).for_each(|(n, part)| sum.add(part, *n));
    sum
}

/// How much wider a bound becomes per unit of share: by itself, or not at all if it bounds a position.
fn widens(order: usize, bound: f64) -> f64 {
    if order > 0 { bound.abs() } else { 0.0 }
}

impl Transcription<'_> {
    /// Adds one limit's rows at one instant.
    pub(super) fn limit(&self, builder: &mut Builder, index: usize, instant: usize, widening: &Widening) {
        let limit = &self.mission.limits[index];
        if !self.covers(limit, instant) {
            return;
        }
        let inset = if has_inset(limit) { widening.inset } else { 0.0 };
        let room = room_of(limit, widening.room) + inset;
        let (lower, upper) = (limit.lower.map(|bound| bound + room), limit.upper.map(|bound| bound - room));
        let origin = RowOrigin::Limit { limit: index, node: instant / self.parts };
        let quantity = limit.kind.describe().quantity;
        if !self.plans(if quantity.is_of_yaw() { YAW } else { X }) {
            return;
        }
        match (quantity, upper) {
            (Quantity::Axis { axis, order, sign }, _) => {
                let value = self.derivative(instant, axis, order).times(sign);
                for (bound, side) in [(upper, 1.0), (lower, -1.0)] {
                    let Some(bound) = bound else { continue };
                    let mut row = widening.bound(bound, order, side).times(side);
                    row.add(&value, -side);
                    builder.nonnegative(row, origin);
                }
            }
            (Quantity::Tilt, Some(upper)) => {
                self.tilt_cones(instant, upper, widening).for_each(|cone| builder.cone(cone, origin));
            }
            (Quantity::Norm { .. }, Some(upper)) if limit.kind == LimitKind::Jerk && self.jumps_in_jerk() => {
                let beside = self.intervals_beside(instant);
                for (interval, step) in beside.filter(|(interval, _)| self.covers_interval(limit, *interval)) {
                    builder.cone(self.jerk_cone(instant, interval, step, upper, widening), origin);
                }
            }
            (Quantity::Norm { axes, order }, Some(upper)) => {
                builder.cone(cone(widening.bound(upper, order, 1.0), self.derivatives(instant, axes, order)), origin);
            }
            (Quantity::Along(normal), Some(upper)) => {
                let mut row = widening.bound(upper, 0, 1.0);
                row.add(&along(normal, &self.derivatives(instant, SPACE, 0)), -1.0);
                builder.nonnegative(row, origin);
            }
            (Quantity::Distance(from), Some(upper)) => {
                builder.cone(cone(widening.bound(upper, 0, 1.0), self.apart(instant, &from)), origin);
            }
            // The cone does not depend on the duration: all velocities change alike.
            (Quantity::Arrival(direction), Some(upper)) => {
                let velocity = self.derivatives(instant, SPACE, 1);
                let mut reach = along(direction, &velocity).times(upper.tan());
                reach.add(&widening.share, ARRIVAL_UNIT);
                builder.cone(cone(reach, across(direction, &velocity)), origin);
            }
            (Quantity::Heading(target), Some(upper)) => {
                self.heading_rows(builder, FollowedAt { target, upper, instant }, widening, origin);
            }
            // The distance is at least that from the plane that separates the body from a position nearby. Without such
            // a position there is no row, and the program is a relaxation.
            (Quantity::Clearance(obstacle), _) => {
                let near = self.positions.and_then(|positions| positions.get(instant));
                let (Some(&near), Some(lower)) = (near, lower) else { return };
                let Separation { normal, support, .. } = obstacle.body.separation(near);
                let mut row = along(normal, &self.derivatives(instant, SPACE, 0)).plus_constant(-support);
                row.add(&widening.clearance(lower), -1.0);
                builder.nonnegative(row, origin);
            }
            // They have an upper bound; without one nothing is bounded.
            (Quantity::Norm { .. } | Quantity::Tilt | Quantity::Along(_) | Quantity::Distance(_), None) => {}
            (Quantity::Arrival(_) | Quantity::Heading(_), None) => {}
        }
    }

    /// Derivatives of some axes at an instant.
    fn derivatives(&self, instant: usize, axes: &[usize], order: usize) -> Vec<Affine> {
        axes.iter().map(|&axis| self.derivative(instant, axis, order)).collect()
    }

    /// The cones about the vertical that contain the thrust. A cone is convex, so that it contains the thrust in every
    /// wind if it does so in the extreme ones; of those that differ in their vertical part alone, the one that lifts
    /// most is the hardest.
    fn tilt_cones(&self, instant: usize, upper: f64, widening: &Widening) -> impl Iterator<Item = Vec<Affine>> {
        let lifts_most = self.winds.iter().map(|wind| wind.wind[Z]).fold(f64::NEG_INFINITY, f64::max);
        self.winds.iter().filter(move |wind| wind.wind[Z] == lifts_most).map(move |wind| {
            let [x, y, z] = self.thrust(instant, wind);
            let mut reach = z.plus_constant(-wind.gravity).times(upper.tan());
            reach.add(&widening.bound(wind.gravity, 2, 1.0), upper.tan());
            cone(reach, vec![x, y])
        })
    }

    /// The bound on the jerk whose part along z is the slope of an input over an interval of `step` s.
    fn jerk_cone(&self, instant: usize, interval: usize, step: f64, upper: f64, widening: &Widening) -> Vec<Affine> {
        let mut slope = self.derivative(interval + 1, Z, 2);
        slope.add(&self.derivative(interval, Z, 2), -1.0);
        let mut parts = self.derivatives(instant, &[X, Y], 3);
        parts.push(slope.times(1.0 / step));
        cone(widening.bound(upper, 3, 1.0), parts)
    }

    /// The vector whose length is the distance, m.
    fn apart(&self, instant: usize, from: &DistanceFrom) -> Vec<Affine> {
        let from_point = |point: &[f64]| -> Vec<Affine> {
            let coordinates = self.derivatives(instant, &SPACE[..point.len()], 0);
            coordinates.into_iter().zip(point).map(|(part, p)| part.plus_constant(-p)).collect()
        };
        match from {
            DistanceFrom::Point(centre) => from_point(centre),
            DistanceFrom::Axis(centre) => from_point(centre),
            DistanceFrom::Line { point, along } => across(*along, &from_point(point)),
        }
    }

    /// The rows of a yaw that follows a vector: linear in yaw, position and velocity about the states nearby. Without
    /// these there is no row, and the program is a relaxation.
    fn heading_rows(&self, builder: &mut Builder, followed: FollowedAt, widening: &Widening, origin: RowOrigin) {
        let FollowedAt { target, upper, instant } = followed;
        let near = self.states.filter(|_| instant.is_multiple_of(self.parts));
        let Some(near) = near.and_then(|states| states.get(instant / self.parts)) else { return };
        let heading = FollowedYaw::of(target, upper, near);
        let (order, sign) = match target {
            Target::Towards { .. } => (0, -1.0),
            Target::AlongPath => (1, 1.0),
        };
        // The vector, of which the target's point is the constant.
        let constant = target.vector([0.0; 2], [0.0; 2]);
        let vector: Vec<Affine> = [X, Y]
            .iter()
            .zip(constant)
            .map(|(&axis, constant)| self.derivative(instant, axis, order).times(sign).plus_constant(constant))
            .collect();
        if heading.is_paused() {
            let mut reach = widening.bound(PAUSED * target.least(), order, 1.0);
            reach.add(&widening.share, heading.unit);
            return builder.cone(cone(reach, vector), origin);
        }
        let turn = self.derivative(instant, YAW, 0).plus_constant(-near[YAW][0]);
        let (sin, cos) = near[YAW][0].sin_cos();
        let mut ahead = vector[0].clone().times(cos);
        ahead.add(&vector[1], sin);
        ahead.add(&turn, heading.aside);
        let mut aside = vector[1].clone().times(cos);
        aside.add(&vector[0], -sin);
        aside.add(&turn, -heading.ahead);
        for side in [1.0, -1.0] {
            let mut row = ahead.clone().times(heading.tan);
            row.add(&widening.share, heading.unit);
            row.add(&aside, side);
            builder.nonnegative(row, origin);
        }
    }

    /// Whether a limit holds at an instant.
    pub(super) fn covers(&self, limit: &Limit, instant: usize) -> bool {
        covers(limit, &self.grid.waypoint_nodes, self.parts, instant)
    }

    /// Whether a limit holds inside an interval.
    pub(super) fn covers_interval(&self, limit: &Limit, interval: usize) -> bool {
        covers_interval(limit, &self.grid.waypoint_nodes, interval)
    }

    /// By how much more the rows of a step keep volumes at an instant, m: twice what a motion like this state's may
    /// move away from the line through two neighbouring instants, `a delta^2 / 8` with delta the time between them and
    /// a its acceleration within delta, at most g.
    pub(super) fn room(&self, instant: usize, state: &NodeState) -> f64 {
        let interval = (instant / self.parts).min(self.grid.intervals() - 1);
        let times = &self.grid.node_times;
        let apart = (times[interval + 1] - times[interval]) / self.parts as f64;
        let size = |order: usize| [X, Y, Z].iter().map(|&axis| state[axis][order].powi(2)).sum::<f64>().sqrt();
        let acceleration = size(2) + apart * (size(3) + 0.5 * apart * size(4));
        acceleration.min(self.model.gravity) * apart * apart / 4.0
    }

    /// Whether the jerk along z is the slope of an input, constant over an interval, and not a state.
    fn jumps_in_jerk(&self) -> bool {
        self.orders[Z] <= 2
    }

    /// The violation of a limit widened by `sigma` by the states at a node, as a share of the limit (m or rad for
    /// positions and yaw); negative inside.
    pub(super) fn limit_violation(&self, limit: &Limit, states: &[NodeState], node: usize, sigma: f64) -> f64 {
        if !self.covers(limit, node) {
            return f64::NEG_INFINITY;
        }
        let mut state = states[node];
        if limit.kind == LimitKind::Jerk && self.jumps_in_jerk() {
            let slope = |(interval, step): (usize, f64)| (states[interval + 1][Z][2] - states[interval][Z][2]) / step;
            let beside = self.intervals_beside(node).filter(|(interval, _)| self.covers_interval(limit, *interval));
            state[Z][3] = beside.map(slope).fold(0.0, |m: f64, s| m.max(s.abs()));
        }
        self.violation_of(limit, &state, sigma)
    }

    /// The violation of a limit by one state, at which the limit holds.
    pub(super) fn violation_of(&self, limit: &Limit, state: &NodeState, sigma: f64) -> f64 {
        let length = |axes: &[usize], order: usize| axes.iter().map(|&a| state[a][order].powi(2)).sum::<f64>().sqrt();
        let share = |violation: f64, scale: f64| if scale > 0.0 { violation / scale - sigma } else { violation };
        let position = [state[X][0], state[Y][0], state[Z][0]];
        let quantity = limit.kind.describe().quantity;
        if !self.plans(if quantity.is_of_yaw() { YAW } else { X }) {
            return f64::NEG_INFINITY;
        }
        match (quantity, limit.upper) {
            (Quantity::Axis { axis, order, sign }, _) => {
                let value = sign * state[axis][order];
                let over = limit.upper.map(|upper| share(value - upper, widens(order, upper)));
                let under = limit.lower.map(|lower| share(lower - value, widens(order, lower)));
                over.into_iter().chain(under).fold(f64::NEG_INFINITY, f64::max)
            }
            (Quantity::Norm { axes, order }, Some(upper)) => share(length(axes, order) - upper, upper),
            (Quantity::Tilt, Some(upper)) => {
                let (g, tan) = (self.model.gravity, upper.tan());
                let out = |wind: &Environment| {
                    let state = in_air(state, wind);
                    state[X][2].hypot(state[Y][2]) - tan * (g + state[Z][2])
                };
                share(self.winds.iter().map(out).fold(f64::NEG_INFINITY, f64::max), g * tan)
            }
            (Quantity::Along(_) | Quantity::Distance(_), Some(upper)) => {
                limit.value_at(position).map_or(f64::NEG_INFINITY, |value| value - upper)
            }
            (Quantity::Arrival(direction), Some(upper)) => {
                let (ahead, aside) = split(direction, [X, Y, Z].map(|axis| state[axis][1]));
                share(aside - upper.tan() * ahead, ARRIVAL_UNIT)
            }
            (Quantity::Heading(target), Some(upper)) => FollowedYaw::of(target, upper, state).violation() - sigma,
            (Quantity::Clearance(obstacle), _) => {
                let short = limit.lower.map(|lower| lower - obstacle.body.separation(position).distance);
                short.map_or(f64::NEG_INFINITY, |short| share(short, CLEARANCE_UNIT))
            }
            (Quantity::Norm { .. } | Quantity::Tilt | Quantity::Along(_) | Quantity::Distance(_), None)
            | (Quantity::Arrival(_) | Quantity::Heading(_), None) => f64::NEG_INFINITY,
        }
    }

    /// The intervals that begin or end at a node, with their steps (s).
    fn intervals_beside(&self, node: usize) -> impl Iterator<Item = (usize, f64)> {
        let first = node.saturating_sub(1);
        self.grid.steps().enumerate().skip(first).take_while(move |(interval, _)| *interval <= node)
    }
}
