//! What the checker of certificates bounds for each limit of a mission: its violation as a quantity along a motion,
//! evaluated here on its own. `plan::along` decides at nodes and between them.

use super::cost::{COST_PER_CORNER, COST_PER_LIMIT};
use super::interval::Interval;
use super::motion::{State, X, Y, YAW, Z, series};
use super::proof::{Family, Measure, Rated};
use super::series::outside_cone;
use super::wrench::thrust_over_mass;
use super::{heading, volumes};
use crate::model::{Body, Environment, Limit, LimitKind, Obstacle};

/// Value and rate of change.
type Series = super::series::Series<2>;

/// The violation of a limit, upper side then lower side, in the limit's SI unit. For tilt it is the distance of the
/// acceleration `(x'', y'', z'' + g)` from the cone about the vertical, divided by gravity; for a direction of arrival
/// that of the velocity from the cone about the direction, m/s (`outside_cone`). `within` are the nodes of the part of
/// the motion on which the limit holds, see [`Family::within`].
pub fn family<'l>(limit: &'l Limit, environment: &Environment, within: Option<(usize, usize)>) -> Family<'l> {
    let environment = *environment;
    let Limit { kind, lower, upper, .. } = limit;
    let sides: Vec<(f64, f64)> = upper.map(|u| (1.0, -u)).into_iter().chain(lower.map(|l| (-1.0, l))).collect();
    let members = sides.len();
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        let tilted = |&(_, minus): &(f64, f64)| tilt_violation(state, -minus, &environment);
        let beyond = |quantity: Series, &(sign, constant): &(f64, f64)| {
            quantity.times(Interval::point(sign)) + Series::constant(Interval::point(constant))
        };
        let series = wanted.iter().filter_map(|&m| sides.get(m)).map(|side| match kind {
            LimitKind::X => beyond(series(&state[X], 0), side),
            LimitKind::Y => beyond(series(&state[Y], 0), side),
            LimitKind::Z => beyond(series(&state[Z], 0), side),
            LimitKind::Yaw => beyond(series(&state[YAW], 0), side),
            LimitKind::YawRate => beyond(series(&state[YAW], 1), side),
            LimitKind::YawAcceleration => beyond(series(&state[YAW], 2), side),
            LimitKind::Climb => beyond(series(&state[Z], 1), side),
            LimitKind::Descent => beyond(-series(&state[Z], 1), side),
            LimitKind::Speed => beyond(length(state, &[X, Y, Z], 1), side),
            LimitKind::SpeedHorizontal => beyond(length(state, &[X, Y], 1), side),
            LimitKind::Acceleration => beyond(length(state, &[X, Y, Z], 2), side),
            LimitKind::AccelerationHorizontal => beyond(length(state, &[X, Y], 2), side),
            LimitKind::Jerk => beyond(length(state, &[X, Y, Z], 3), side),
            LimitKind::Tilt => tilted(side),
            LimitKind::Face(normal) => beyond(volumes::along(normal, state), side),
            LimitKind::Distance(from) => beyond(volumes::away(from, state), side),
            LimitKind::Clearance(obstacle) => beyond(volumes::clear(&obstacle.body, state), side),
            LimitKind::Arrival(direction) => arrival_violation(*direction, state, -side.1),
            LimitKind::Heading(target) => heading::violation(*target, state, -side.1),
        });
        series.map(|s| Rated { value: s.value(), rate: s.slope() }).collect()
    };
    let measure = measure(kind);
    // The jerk along z is the slope of an input in the hover model, which changes at nodes.
    let jumps = *kind == LimitKind::Jerk;
    let at_nodes_only = kind.is_heading();
    Family {
        members,
        evaluate: Box::new(evaluate),
        linear: false,
        jumps,
        within,
        at_nodes_only,
        measure,
        overhead: COST_PER_LIMIT,
        of_a_member: 1 + COST_PER_CORNER * corners(kind),
    }
}

/// The limit with a box about its polygon in place of the polygon, if that has more corners: what keeps out of the box
/// keeps out of the polygon, and most of a motion is far from most volumes.
pub fn about(limit: &Limit) -> Option<Limit> {
    let LimitKind::Clearance(obstacle) = &limit.kind else { return None };
    let Body::Prism { corners, bottom, top } = &obstacle.body else { return None };
    if corners.len() <= 4 || limit.upper.is_some() {
        return None;
    }
    let ends = |axis: usize| {
        let all = || corners.iter().map(|corner| corner[axis]);
        (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (front, back)) = (ends(0), ends(1));
    let corners = vec![[left, front], [right, front], [right, back], [left, back]];
    let about = Body::Prism { corners, bottom: *bottom, top: *top };
    Some(Limit { kind: LimitKind::Clearance(Obstacle::of(about).into()), ..limit.clone() })
}

/// The corners that are looked at for the distance from a body.
fn corners(kind: &LimitKind) -> u64 {
    match kind {
        LimitKind::Clearance(obstacle) => match &obstacle.body {
            Body::Prism { corners, .. } => corners.len() as u64,
            Body::Cylinder { .. } | Body::Ball { .. } | Body::HalfSpace { .. } => 0,
        },
        _ => 0,
    }
}

/// How messages print a violation.
fn measure(kind: &LimitKind) -> Measure {
    match kind {
        LimitKind::Tilt => Measure { factor: 100.0, unit: "%", whole: Some("of gravity") },
        LimitKind::Arrival(_) => Measure { factor: 1.0, unit: "m/s", whole: None },
        _ => Measure { factor: kind.describe().factor(), unit: kind.describe().unit, whole: None },
    }
}

/// The length of a vector of series, with its rate of change.
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
    let squares = |order: usize| axes.iter().fold(Interval::ZERO, |sum, &axis| sum + state[axis][order].square());
    let parts: Vec<Series> = axes.iter().map(|&axis| series(&state[axis], order)).collect();
    let square = parts.iter().fold(Series::constant(Interval::ZERO), |sum, &p| sum + p * p);
    let value = squares(order).sqrt();
    let steepest = Interval::around_zero(squares(order + 1).sqrt().high);
    // d.d'/|d| if the length cannot vanish, and at most |d'|.
    let rate = (square.slope() / (value * Interval::point(2.0))).meet(steepest);
    Series::of_derivatives(&[value, rate])
}

/// The violation at an instant; the rate is not bounded.
fn arrival_violation(direction: [f64; 3], state: &State, angle: f64) -> Series {
    let direction = direction.map(Interval::point);
    let velocity = [X, Y, Z].map(|axis| state[axis][1]);
    let dot = |a: [Interval; 3]| (0..3).fold(Interval::ZERO, |sum, i| sum + a[i] * direction[i]);
    let ahead = dot(velocity);
    let aside = (0..3).fold(Interval::ZERO, |sum, i| sum + (velocity[i] - ahead * direction[i]).square()).sqrt();
    let at_an_instant = |part: Interval| Series::of_derivatives(&[part, Interval::WHOLE]);
    outside_cone(at_an_instant(aside), at_an_instant(ahead), angle)
}

/// The drag along z does not change the direction of the thrust. Where that of x and y differ, a spec has no limit on
/// tilt.
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
