//! The mission's limits as quantities along a motion.

use super::cost::{OF_A_CORNER, OF_A_LIMIT};
use super::interval::Interval;
use super::motion::{State, X, Y, YAW, Z, series};
use super::proof::{Family, Measure, Rated};
use super::wrench::thrust_over_mass;
use super::{heading, volumes};
use crate::model::{Body, Boundary, Bounded, Environment, Limit, LimitKind};
use std::f64::consts::PI;

/// Value and rate of change.
type Series = super::series::Series<2>;

/// The violation of a limit, upper side then lower side, in the limit's SI unit. For tilt it is the distance of the
/// acceleration `(x'', y'', z'' + g)` from the cone about the vertical, divided by gravity; for a direction of arrival
/// that of the velocity from the cone about the direction, m/s (`outside_cone`). `within` are the nodes of the part of
/// the motion on which the limit holds, see [`Family::within`].
pub fn family<'l>(limit: &'l Limit, environment: &Environment, within: Option<(usize, usize)>) -> Family<'l> {
    let environment = *environment;
    let Limit { kind, lower, upper, .. } = *limit;
    let sides: Vec<(f64, f64)> = upper.map(|u| (1.0, -u)).into_iter().chain(lower.map(|l| (-1.0, l))).collect();
    let members = sides.len();
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        let tilted = |&(_, minus): &(f64, f64)| tilt_violation(state, -minus, &environment);
        let plain = |&(sign, constant): &(f64, f64)| {
            bounded(kind, state).times(Interval::point(sign)) + Series::constant(Interval::point(constant))
        };
        let series = wanted.iter().filter_map(|&m| sides.get(m)).map(|side| match kind {
            LimitKind::Tilt => tilted(side),
            LimitKind::Arrival => arrival_violation(limit, state, -side.1),
            LimitKind::Heading => heading::violation(limit, state, -side.1),
            LimitKind::Face | LimitKind::Distance | LimitKind::Clearance => volumes::past(limit, state, *side),
            _ => plain(side),
        });
        series.map(|s| Rated { value: s.value(), rate: s.slope() }).collect()
    };
    let measure = measure(kind);
    // The jerk along z is the slope of an input in the hover model, which changes at nodes.
    let jumps = kind == LimitKind::Jerk;
    let at_nodes_only = kind == LimitKind::Heading;
    Family {
        members,
        evaluate: Box::new(evaluate),
        linear: false,
        jumps,
        within,
        at_nodes_only,
        measure,
        overhead: OF_A_LIMIT,
        of_a_member: 1 + OF_A_CORNER * limit.volume.as_deref().map_or(0, |volume| corners(&volume.quantity)),
    }
}

/// The limit with a box about its polygon in place of the polygon, if that has more corners: what keeps out of the box
/// keeps out of the polygon, and most of a motion is far from most volumes.
pub fn about(limit: &Limit) -> Option<Limit> {
    let volume = limit.volume.as_deref()?;
    let Bounded::FromBody(Body::Prism { corners, bottom, top }) = &volume.quantity else { return None };
    if corners.len() <= 4 || limit.upper.is_some() {
        return None;
    }
    let ends = |axis: usize| {
        let all = || corners.iter().map(|corner| corner[axis]);
        (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (front, back)) = (ends(0), ends(1));
    let corners = vec![[left, front], [right, front], [right, back], [left, back]];
    let quantity = Bounded::FromBody(Body::Prism { corners, bottom: *bottom, top: *top });
    Some(Limit { volume: Some(Boundary { quantity, ..volume.clone() }.into()), ..limit.clone() })
}

/// The corners that are looked at for the distance from a body.
fn corners(quantity: &Bounded) -> u64 {
    match quantity {
        Bounded::FromBody(Body::Prism { corners, .. }) => corners.len() as u64,
        _ => 0,
    }
}

/// How messages print a violation.
fn measure(kind: LimitKind) -> Measure {
    match kind.name_and_unit() {
        _ if kind == LimitKind::Tilt => Measure { factor: 100.0, unit: "%", whole: Some("of gravity") },
        _ if kind == LimitKind::Heading => Measure { factor: 180.0 / PI, unit: "deg", whole: None },
        _ if kind == LimitKind::Arrival => Measure { factor: 1.0, unit: "m/s", whole: None },
        (_, unit, factor) => Measure { factor, unit, whole: None },
    }
}

/// The limited quantity; tilt, volumes and directions of arrival are handled separately above.
fn bounded(kind: LimitKind, state: &State) -> Series {
    match kind {
        LimitKind::X | LimitKind::Face | LimitKind::Distance | LimitKind::Clearance => series(&state[X], 0),
        LimitKind::Arrival => length(state, &[X, Y, Z], 1),
        LimitKind::Heading => series(&state[YAW], 0),
        LimitKind::Y => series(&state[Y], 0),
        LimitKind::Z => series(&state[Z], 0),
        LimitKind::Yaw => series(&state[YAW], 0),
        LimitKind::YawRate => series(&state[YAW], 1),
        LimitKind::YawAcceleration => series(&state[YAW], 2),
        LimitKind::Climb => series(&state[Z], 1),
        LimitKind::Descent => -series(&state[Z], 1),
        LimitKind::Speed => length(state, &[X, Y, Z], 1),
        LimitKind::SpeedHorizontal => length(state, &[X, Y], 1),
        LimitKind::Acceleration => length(state, &[X, Y, Z], 2),
        LimitKind::AccelerationHorizontal | LimitKind::Tilt => length(state, &[X, Y], 2),
        LimitKind::Jerk => length(state, &[X, Y, Z], 3),
    }
}

/// The length of a vector, as in [`length`].
fn length_of(parts: &[Series]) -> Series {
    let zero = Series::constant(Interval::ZERO);
    let square = parts.iter().fold(zero, |sum, &p| sum + p * p);
    let sum =
        |of: &dyn Fn(&Series) -> Interval| parts.iter().fold(Interval::ZERO, |sum, p| sum + of(p).square()).sqrt();
    let (value, steepest) = (sum(&|p| p.value()), Interval::around_zero(sum(&|p| p.slope()).high));
    let rate = (square.slope() / (value * Interval::point(2.0))).meet(steepest);
    Series::of_derivatives(&[value, rate])
}

/// The length |d|, whose rate is between -|d'| and |d'|: this avoids dividing by a length that may vanish.
fn length(state: &State, axes: &[usize], order: usize) -> Series {
    let squares = |order: usize| {
        axes.iter()
            .fold(Interval::ZERO, |sum, &axis| sum + state[axis].get(order).map_or(Interval::ZERO, |d| d.square()))
    };
    let parts: Vec<Series> = axes.iter().map(|&axis| series(&state[axis], order)).collect();
    let square = parts.iter().fold(Series::constant(Interval::ZERO), |sum, &p| sum + p * p);
    let value = squares(order).sqrt();
    let steepest = Interval::around_zero(squares(order + 1).sqrt().high);
    // d.d'/|d| if the length cannot vanish, and at most |d'|.
    let rate = (square.slope() / (value * Interval::point(2.0))).meet(steepest);
    Series::of_derivatives(&[value, rate])
}

/// The distance of a vector from the cone of those at an angle of at most `angle` (rad, below pi/2) to an axis: `ahead`
/// is its component along the axis, `aside` the length of the rest. Beyond a right angle to the cone's side the apex is
/// nearest, so that the distance is the whole length: its sine alone would fall to zero again for a vector that points
/// backwards.
pub(super) fn outside_cone(aside: Series, ahead: Series, angle: f64) -> Series {
    let (sine, cosine) = Interval::point(angle).sin_cos();
    let from_side = aside.times(cosine) - ahead.times(sine);
    let along_side = ahead.value() * cosine + aside.value() * sine;
    if along_side.low >= 0.0 {
        return from_side;
    }
    let length = |of: fn(&Series) -> Interval| (of(&aside).square() + of(&ahead).square()).sqrt();
    let from_apex = length(Series::value);
    // No distance changes faster than the vector does.
    let steepest = Interval::around_zero(length(Series::slope).high);
    let nearest = if along_side.high < 0.0 { from_apex.low } else { from_side.value().low.min(from_apex.low) };
    Series::of_derivatives(&[Interval::new(nearest, from_apex.high), steepest])
}

/// At an instant; the rate is not bounded.
fn arrival_violation(limit: &Limit, state: &State, angle: f64) -> Series {
    let direction = limit.leg.as_ref().and_then(|on| on.direction).unwrap_or([f64::NAN; 3]).map(Interval::point);
    let velocity = [X, Y, Z].map(|axis| state[axis][1]);
    let dot = |a: [Interval; 3]| (0..3).fold(Interval::ZERO, |sum, i| sum + a[i] * direction[i]);
    let ahead = dot(velocity);
    let aside = (0..3).fold(Interval::ZERO, |sum, i| sum + (velocity[i] - ahead * direction[i]).square()).sqrt();
    let at_an_instant = |part: Interval| Series::of_derivatives(&[part, Interval::WHOLE]);
    outside_cone(at_an_instant(aside), at_an_instant(ahead), angle)
}

/// The drag along z does not change the direction of the thrust. Where that of x and y differ, a spec has no limit on tilt.
fn tilt_violation(state: &State, limit: f64, environment: &Environment) -> Series {
    let g = Interval::point(environment.gravity);
    let [x, y, lift] = thrust_over_mass::<2>(state, environment, environment.drag_rates[0]);
    let across = match environment.has_drag() {
        true => length_of(&[x, y]),
        false => length(state, &[X, Y], 2),
    };
    let out = outside_cone(across, lift, limit);
    Series::of_derivatives(&out.0.map(|c| c / g))
}
