//! Rows as expressions in the derivatives at the nodes that are not negative for any plan.

use super::super::interval::{Interval, exceeds};
use super::super::motion::{X, Y, YAW, Z};
use super::super::premise::Premise;
use super::super::sets::Plane;
use super::Rows;
use crate::certificate::{DynamicModel, Multiplier, RowRecord, Side};
use crate::model::{DistanceFrom, Heading, Limit, LimitKind, Part};

/// A plan may miss a waypoint by this much more than its tolerance, m; yaw in proportion.
const FEASIBLE: f64 = 1e-6;

/// A linear expression in the derivatives at some nodes.
#[derive(Debug, Clone, Default)]
pub(super) struct Expression {
    /// (node, axis, derivative, coefficient)
    pub terms: Vec<(usize, usize, usize, Interval)>,
    pub constant: Option<Interval>,
}

impl Expression {
    fn constant(value: Interval) -> Self {
        Expression { terms: Vec::new(), constant: Some(value) }
    }

    fn of(node: usize, axis: usize, order: usize) -> Self {
        Expression { terms: vec![(node, axis, order, Interval::ONE)], constant: None }
    }

    fn plus(mut self, node: usize, axis: usize, order: usize, coefficient: Interval) -> Self {
        self.terms.push((node, axis, order, coefficient));
        self
    }

    fn minus(mut self, value: Interval) -> Self {
        self.constant = Some(self.constant.unwrap_or(Interval::ZERO) - value);
        self
    }
}

impl Rows<'_> {
    /// The expressions of a row, after checking that its multipliers are in the dual cone.
    pub(super) fn weighed(&self, multiplier: &Multiplier) -> Result<Vec<Expression>, String> {
        let parts = self.expressions(&multiplier.row)?;
        let z = &multiplier.z;
        if parts.len() != z.len() || z.iter().any(|v| !v.is_finite()) {
            return Err(format!("{} numbers for a row with {} parts", z.len(), parts.len()));
        }
        let free = matches!(multiplier.row, RowRecord::Rest { .. });
        let rest = z[1..].iter().fold(Interval::ZERO, |sum, &v| sum + Interval::point(v).square()).sqrt();
        // NaN exceeds everything.
        if self.premises.has(Premise::DualCone) && !free && exceeds(rest.high, z[0]) {
            return Err("outside the dual cone".into());
        }
        Ok(parts)
    }

    /// The expressions of a row: not negative (cone: the first is not below the length of the others; rest: zero).
    fn expressions(&self, row: &RowRecord) -> Result<Vec<Expression>, String> {
        let points = &self.problem.mission().waypoints;
        let at = |node: usize| if node < self.nodes() { Ok(node) } else { Err(format!("there is no node {node}")) };
        let of_waypoint = |i: usize| match (points.get(i), self.grid.waypoint_nodes.get(i)) {
            (Some(point), Some(&node)) => Ok((point, node)),
            _ => Err(format!("there is no waypoint {i}")),
        };
        match *row {
            RowRecord::Rest { node, axis, derivative } if self.may_rest(at(node)?, axis, derivative) => {
                Ok(vec![Expression::of(node, axis, derivative)])
            }
            RowRecord::Rest { node, axis, derivative } => {
                let name = ["x", "y", "z", "yaw"].get(axis).copied().unwrap_or("an unknown axis");
                Err(format!("the spec does not require derivative {derivative} of {name} to be zero at node {node}"))
            }
            RowRecord::Facet { .. } | RowRecord::Commands { .. } if self.kind == DynamicModel::Exact => {
                Err("in the exact model facets are not linear rows in the derivatives".into())
            }
            RowRecord::Facet { facet, node } => {
                let plane = self.planes.get(facet).ok_or(format!("there is no facet {facet}"))?;
                Ok(vec![self.keeps(plane, at(node)?)])
            }
            RowRecord::Commands { facet, node, interval } => {
                let plane = self.planes.get(facet).ok_or(format!("there is no facet {facet}"))?;
                let tau = self.lag.ok_or("the spec's rotors follow their commands without lag")?;
                if !self.is_adjacent(at(node)?, interval) {
                    return Err(format!("interval {interval} is not adjacent to node {node}"));
                }
                Ok(vec![self.keeps_commands(plane, tau, node, interval)])
            }
            RowRecord::Limit { limit, node, side } => {
                let limit = self.limit_at(limit, at(node)?)?;
                one_sided(limit, node, side).ok_or("the limit has no such side".into()).map(|row| vec![row])
            }
            RowRecord::LimitNorm { limit, node, interval } => {
                let limit = self.limit_at(limit, at(node)?)?;
                self.norm(limit, node, interval).ok_or("the limit does not bound a norm there".into())
            }
            RowRecord::Thrust { node } => {
                let most = self.thrust.ok_or("the hover model has no such row")?;
                Ok(self.thrust_cone(most, at(node)?))
            }
            RowRecord::Waypoint { waypoint } => {
                let (point, node) = of_waypoint(waypoint)?;
                let mut parts = vec![Expression::constant(self.tolerances(waypoint).0)];
                for (axis, due) in [X, Y, Z].into_iter().zip(point.position) {
                    parts.push(Expression::of(node, axis, 0).minus(Interval::point(due)));
                }
                Ok(parts)
            }
            RowRecord::WaypointYaw { waypoint, side } => {
                let (point, node) = of_waypoint(waypoint)?;
                if point.heading != Heading::Given {
                    return Err(format!("the yaw at waypoint {waypoint} is not given"));
                }
                let sign = if side == Side::Upper { -Interval::ONE } else { Interval::ONE };
                let slack = self.tolerances(waypoint).1 - sign * Interval::point(point.yaw);
                Ok(vec![Expression::constant(slack).plus(node, YAW, 0, sign)])
            }
        }
    }

    /// A limit that holds at a node.
    fn limit_at(&self, index: usize, node: usize) -> Result<&Limit, String> {
        let limit = self.problem.mission().limits.get(index).ok_or(format!("there is no limit {index}"))?;
        let part = limit.leg.as_ref().map_or(Part::Whole, |on| on.part);
        let holds = |from: usize, to: usize| match part {
            Part::Start => node == from,
            Part::End => node == to,
            Part::Whole => (from..=to).contains(&node),
        };
        match &limit.leg {
            Some(on) if !holds(self.grid.waypoint_nodes[on.leg], self.grid.waypoint_nodes[on.leg + 1]) => {
                Err(format!("limit {index} does not hold at node {node}"))
            }
            _ => Ok(limit),
        }
    }

    /// Whether a limit holds throughout an interval.
    fn holds_over(&self, limit: &Limit, interval: usize) -> bool {
        let nodes = &self.grid.waypoint_nodes;
        limit.leg.as_ref().is_none_or(|on| (nodes[on.leg]..nodes[on.leg + 1]).contains(&interval))
    }

    /// Tolerances of a waypoint, m and rad, plus what a plan may miss beyond them.
    pub(super) fn tolerances(&self, waypoint: usize) -> (Interval, Interval) {
        let point = &self.problem.mission().waypoints[waypoint];
        let [within, turned, more] = [point.within, point.yaw_within, FEASIBLE].map(Interval::point);
        if point.heading != Heading::Given {
            return (within + more, Interval::WHOLE);
        }
        (within + more, turned * (Interval::ONE + more / within))
    }

    /// Whether a row may require a derivative to vanish.
    fn may_rest(&self, node: usize, axis: usize, derivative: usize) -> bool {
        match self.premises.has(Premise::Rest) {
            true => self.rests(node, axis, derivative),
            false => axis <= YAW && derivative <= self.orders()[axis],
        }
    }

    /// Rest as the language defines it: velocity, acceleration, horizontal jerk, yaw rate and yaw acceleration vanish;
    /// in a hold the inputs vanish too.
    fn rests(&self, node: usize, axis: usize, derivative: usize) -> bool {
        if axis > YAW || derivative == 0 {
            return false;
        }
        let last = self.nodes() - 1;
        let ends =
            node == 0 && self.problem.mission().start_at_rest || node == last && self.problem.mission().end_at_rest;
        // The nodes of waypoints increase.
        let point = self.grid.waypoint_nodes.binary_search(&node).ok().map(|i| &self.problem.mission().waypoints[i]);
        let (held, stops) = (point.is_some_and(|w| w.hold > 0.0), point.is_some_and(|w| w.stop));
        let highest = if held { self.orders()[axis] } else { self.orders()[axis].min(3) };
        (ends || stops || held) && derivative <= highest
    }

    /// e - n.w with T = m (g + z''), tau_x = Ixx/g (s x'''' - c y''''), tau_y = Iyy/g (c x'''' + s y''''), tau_z = Izz
    /// psi''.
    fn keeps(&self, plane: &Plane, node: usize) -> Expression {
        let [thrust, roll, pitch, turn] = plane.normal;
        let (s, c) = self.yaw;
        let vehicle = &self.problem.model().vehicle;
        let (m, g) = (Interval::point(vehicle.mass), Interval::point(self.problem.model().gravity));
        let [ixx, iyy, izz] = vehicle.inertia.map(Interval::point);
        let (by_roll, by_pitch) = (roll * ixx / g, pitch * iyy / g);
        Expression::constant(plane.offset - thrust * m * g)
            .plus(node, X, 4, -(by_roll * s + by_pitch * c))
            .plus(node, Y, 4, by_roll * c - by_pitch * s)
            .plus(node, Z, 2, -(thrust * m))
            .plus(node, YAW, 2, -(turn * izz))
    }

    /// Whether an interval begins or ends at a node.
    fn is_adjacent(&self, node: usize, interval: usize) -> bool {
        // The certificate's number may be as large as numbers get.
        let ends = interval.checked_add(1).filter(|&end| end < self.nodes());
        ends.is_some_and(|end| interval == node || end == node)
    }

    /// e - n.(w + tau w'): with one yaw, w is linear in an interval, so w' is its change there divided by the duration.
    fn keeps_commands(&self, plane: &Plane, tau: Interval, node: usize, interval: usize) -> Expression {
        let times = &self.grid.times;
        let ahead = tau / (Interval::point(times[interval + 1]) - Interval::point(times[interval]));
        let mut row = self.keeps(plane, node);
        for (end, share) in [(interval + 1, ahead), (interval, -ahead)] {
            let terms = self.keeps(plane, end).terms.into_iter();
            row.terms.extend(terms.map(|(node, axis, order, c)| (node, axis, order, share * c)));
        }
        row
    }

    /// |(x'', y'', z'' + g)| is at most T_max / m.
    fn thrust_cone(&self, most: Interval, node: usize) -> Vec<Expression> {
        let [mass, g] = [self.problem.model().vehicle.mass, self.problem.model().gravity].map(Interval::point);
        let lift = Expression::of(node, Z, 2).minus(-g);
        vec![Expression::constant(most / mass), Expression::of(node, X, 2), Expression::of(node, Y, 2), lift]
    }

    /// Limits on norms as second-order cones; `None` for other limits.
    fn norm(&self, limit: &Limit, node: usize, interval: usize) -> Option<Vec<Expression>> {
        let upper = Interval::point(limit.upper?);
        let parts = |axes: &[usize], order: usize| -> Vec<Expression> {
            axes.iter().map(|&axis| Expression::of(node, axis, order)).collect()
        };
        let with = |reach: Expression, parts: Vec<Expression>| Some(std::iter::once(reach).chain(parts).collect());
        let reach = Expression::constant(upper);
        let apart = |centre: &[f64]| -> Vec<Expression> {
            let part = |(axis, c): (usize, &f64)| Expression::of(node, axis, 0).minus(Interval::point(*c));
            [X, Y, Z].into_iter().zip(centre).map(part).collect()
        };
        match &limit.kind {
            LimitKind::Distance(DistanceFrom::Line { point, along }) => with(reach, across(node, 0, *point, *along)),
            LimitKind::Distance(DistanceFrom::Point(centre)) => with(reach, apart(centre)),
            LimitKind::Distance(DistanceFrom::Axis(centre)) => with(reach, apart(centre)),
            LimitKind::Speed => with(reach, parts(&[X, Y, Z], 1)),
            LimitKind::SpeedHorizontal => with(reach, parts(&[X, Y], 1)),
            LimitKind::Acceleration => with(reach, parts(&[X, Y, Z], 2)),
            LimitKind::AccelerationHorizontal => with(reach, parts(&[X, Y], 2)),
            LimitKind::Tilt => {
                // |(x'', y'')| <= tan L (g + z''): the thrust is along (x'', y'', g + z'').
                let (s, c) = upper.sin_cos();
                let tangent = s / c;
                let g = Interval::point(self.problem.model().gravity);
                with(Expression::constant(tangent * g).plus(node, Z, 2, tangent), parts(&[X, Y], 2))
            }
            LimitKind::Arrival(direction) => {
                // |v - (v.d) d| <= tan L (v.d), with d the direction of arrival.
                let (s, c) = upper.sin_cos();
                let ahead = [X, Y, Z].into_iter().zip(direction);
                let reach = ahead
                    .fold(Expression::default(), |row, (axis, d)| row.plus(node, axis, 1, s / c * Interval::point(*d)));
                with(reach, across(node, 1, [0.0; 3], *direction))
            }
            LimitKind::Jerk if self.kind == DynamicModel::Exact => with(reach, parts(&[X, Y, Z], 3)),
            LimitKind::Jerk if self.is_adjacent(node, interval) && self.holds_over(limit, interval) => {
                let times = &self.grid.times;
                let h = Interval::point(times[interval + 1]) - Interval::point(times[interval]);
                let rate = Interval::ONE / h;
                let slope = Expression::default().plus(interval + 1, Z, 2, rate).plus(interval, Z, 2, -rate);
                let mut parts = parts(&[X, Y], 3);
                parts.push(slope);
                with(reach, parts)
            }
            LimitKind::X | LimitKind::Y | LimitKind::Z | LimitKind::Yaw | LimitKind::Climb | LimitKind::Descent => None,
            LimitKind::YawRate | LimitKind::YawAcceleration | LimitKind::Jerk => None,
            LimitKind::Face(_) | LimitKind::Clearance(_) | LimitKind::Heading(_) => None,
        }
    }
}

/// The parts of `a - (a . along) along`, where a is the derivative of the position at a node minus `point`.
fn across(node: usize, order: usize, point: [f64; 3], along: [f64; 3]) -> Vec<Expression> {
    let along = along.map(Interval::point);
    let part = |i: usize| {
        let weight = |j: usize| if i == j { Interval::ONE - along[i] * along[j] } else { -(along[i] * along[j]) };
        (0..3).fold(Expression::default(), |row, j| {
            row.plus(node, [X, Y, Z][j], order, weight(j)).minus(weight(j) * Interval::point(point[j]))
        })
    };
    (0..3).map(part).collect()
}

/// A bound on one coordinate or rate; `None` if the limit has no such bound on that side.
fn one_sided(limit: &Limit, node: usize, side: Side) -> Option<Expression> {
    let (axis, order, sign) = match &limit.kind {
        LimitKind::Face(normal) => {
            let upper = limit.upper.filter(|_| side == Side::Upper)?;
            let parts = [X, Y, Z].into_iter().zip(normal);
            let slack = Expression::constant(Interval::point(upper));
            return Some(parts.fold(slack, |row, (axis, n)| row.plus(node, axis, 0, Interval::point(-n))));
        }
        LimitKind::X => (X, 0, 1.0),
        LimitKind::Y => (Y, 0, 1.0),
        LimitKind::Z => (Z, 0, 1.0),
        LimitKind::Yaw => (YAW, 0, 1.0),
        LimitKind::YawRate => (YAW, 1, 1.0),
        LimitKind::YawAcceleration => (YAW, 2, 1.0),
        LimitKind::Climb => (Z, 1, 1.0),
        LimitKind::Descent => (Z, 1, -1.0),
        LimitKind::Speed | LimitKind::SpeedHorizontal | LimitKind::Tilt => return None,
        LimitKind::Acceleration | LimitKind::AccelerationHorizontal | LimitKind::Jerk => return None,
        LimitKind::Distance(_) | LimitKind::Clearance(_) => return None,
        LimitKind::Arrival(_) | LimitKind::Heading(_) => return None,
    };
    let (bound, towards) = match side {
        Side::Upper => (limit.upper?, -1.0),
        Side::Lower => (limit.lower?, 1.0),
    };
    let slack = Interval::point(-towards * bound);
    Some(Expression::constant(slack).plus(node, axis, order, Interval::point(towards * sign)))
}
