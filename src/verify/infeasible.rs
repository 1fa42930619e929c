//! Decides a claim that there is no plan (hover model, one yaw, from rest).
//!
//! Every motion is what its start and its inputs at the nodes make of it. Each row says that some expression in the
//! derivatives at a node is not negative (a cone: that its parts have a non-negative product with every vector of the
//! dual cone); rest says that one is zero. So for multipliers z in the dual cone `sum of z_j expression_j >= 0` for
//! every plan. Carried back through the dynamics the sum is `constant + a_0 . start + sum over nodes of c_k . u_k`. The
//! start is known to the first waypoint's tolerance, and the sets bound the inputs; where the largest value over all of
//! these is negative, there is no plan.

use super::facets::{few, spanned};
use super::interval::Interval;
use super::motion::{X, Y, YAW, Z};
use super::schedule;
use super::sets::{Generators, Plane};
use super::{Rejection, Shown, required};
use crate::certificate::{DynamicModel, InfeasibleClaim, Multiplier, RowRecord, Side};
use crate::model::{Limit, LimitKind, Mission, Model, PlannerKind};
use crate::report::number::number;

/// A plan may miss a waypoint by this much beside its tolerance, m; yaw in proportion.
const FEASIBLE: f64 = 1e-6;

/// A tolerance of a kilometre binds nothing, m.
const UNBOUNDED: f64 = 1e3;

/// The input's derivative order: x and y are quadruple integrators (45), z and yaw double ones (44).
const ORDER: [usize; 4] = [4, 4, 2, 2];

/// A linear expression in the derivatives at some nodes.
#[derive(Debug, Clone, Default)]
struct Expression {
    /// (node, axis, derivative, coefficient)
    terms: Vec<(usize, usize, usize, Interval)>,
    constant: Option<Interval>,
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

struct Rows<'a> {
    model: &'a Model,
    mission: &'a Mission,
    claim: &'a InfeasibleClaim,
    planes: Vec<Plane>,
    /// sin and cos of the one yaw.
    yaw: (Interval, Interval),
}

pub(super) fn decide(
    model: &Model,
    mission: &Mission,
    kind: DynamicModel,
    claim: &InfeasibleClaim,
) -> Result<Vec<Shown>, Rejection> {
    let outside = |why: &str| Err(Rejection::new("that there is no plan", why));
    let first = &mission.waypoints[0];
    if kind != DynamicModel::Hover {
        return outside("only the hover model's programs are decided by multipliers");
    }
    if mission.waypoints.iter().any(|w| (w.yaw - first.yaw).abs() >= 1e-12) || !mission.start_at_rest {
        return outside("multipliers are checked for one yaw throughout and a start at rest");
    }
    let total = schedule::check(model, mission, &claim.times_s, &claim.waypoint_nodes)?;
    few(&claim.facets)?;
    let mut planes = Vec::new();
    for (index, facet) in claim.facets.iter().enumerate() {
        let named = |r: Rejection| Rejection {
            claim: format!("facet {} ({}, rotors {:?})", index + 1, facet.mode, facet.rotors),
            ..r
        };
        if !may_bind(model, &facet.mode) {
            return Err(named(Rejection::new("", "the planner does not keep to this mode's set")));
        }
        planes.push(spanned(model, facet).map_err(named)?);
    }
    let rows = Rows { model, mission, claim, planes, yaw: Interval::point(first.yaw).sin_cos() };
    let most = rows.largest()?;
    if most.high < 0.0 {
        let selected = claim.facets.iter().any(|f| !required(model).contains(&f.mode));
        let keeping = if selected { " keeps the facets selected" } else { "" };
        let pieces = claim.times_s.len() - 1;
        let statement = format!("no plan of {} s with {pieces} pieces in flight{keeping}", number(total));
        Ok(vec![Shown::proved(statement)])
    } else {
        let why = format!("the rows, weighted, add up to {} at most, which contradicts nothing", number(most.high));
        Err(Rejection { span: Some(mission.span), ..Rejection::new("that there is no plan", why) })
    }
}

/// Whether the spec's planner may keep to a facet of this mode's set.
fn may_bind(model: &Model, mode: &str) -> bool {
    let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i));
    let selected = model.plan.planner == PlannerKind::Rsp && against.into_iter().any(|m| m.name == mode);
    selected || required(model).iter().any(|m| m == mode)
}

impl Rows<'_> {
    fn nodes(&self) -> usize {
        self.claim.times_s.len()
    }

    /// The largest value of the weighted sum over all starts and inputs.
    fn largest(&self) -> Result<Interval, Rejection> {
        let mut sums = vec![[[Interval::ZERO; 5]; 4]; self.nodes()];
        let mut constant = Interval::ZERO;
        for (index, multiplier) in self.claim.multipliers.iter().enumerate() {
            let parts =
                self.weighed(multiplier).map_err(|why| Rejection::new(format!("multiplier {}", index + 1), why))?;
            for (expression, &z) in parts.iter().zip(&multiplier.z) {
                let z = Interval::point(z);
                for &(node, axis, order, coefficient) in &expression.terms {
                    sums[node][axis][order] = sums[node][axis][order] + z * coefficient;
                }
                constant = constant + z * expression.constant.unwrap_or(Interval::ZERO);
            }
        }
        self.carry_back(&mut sums);
        let inputs = self.inputs()?;
        let mut most = constant;
        for node in &sums {
            for axis in [X, Y, Z, YAW] {
                most = most + node[axis][ORDER[axis]] * inputs[axis];
            }
        }
        // From rest only position and yaw of the start are free.
        let start = &self.mission.waypoints[0];
        let [x, y, z] = start.position;
        let (near, turned) = self.tolerances(0);
        for (axis, due, reach) in [(X, x, near), (Y, y, near), (Z, z, near), (YAW, start.yaw, turned)] {
            let near = Interval::point(due) + Interval::around_zero(reach.high);
            let at = if axis != YAW && start.within >= UNBOUNDED { Interval::WHOLE } else { near };
            most = most + sums[0][axis][0] * at;
        }
        Ok(most)
    }

    /// Replaces derivatives at a node by what they are made of one node earlier, from the last to the first. The input is
    /// linear in between, so with m = r - i
    ///
    /// `d_i(k+1) = sum_{j=i}^{r-1} h^(j-i)/(j-i)! d_j(k) + h^m [(1/m! - 1/(m+1)!) u(k) + u(k+1)/(m+1)!]`.
    fn carry_back(&self, sums: &mut [[[Interval; 5]; 4]]) {
        const FACTORIAL: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
        let over = |power: Interval, n: usize| power / Interval::point(FACTORIAL[n]);
        for k in (1..self.nodes()).rev() {
            let h = Interval::point(self.claim.times_s[k]) - Interval::point(self.claim.times_s[k - 1]);
            let mut powers = [Interval::ONE; 5];
            for n in 1..5 {
                powers[n] = powers[n - 1] * h;
            }
            for (axis, &r) in ORDER.iter().enumerate() {
                for i in 0..r {
                    let weight = sums[k][axis][i];
                    if weight == Interval::ZERO {
                        continue;
                    }
                    for j in i..r {
                        sums[k - 1][axis][j] = sums[k - 1][axis][j] + weight * over(powers[j - i], j - i);
                    }
                    let m = r - i;
                    let late = over(powers[m], m + 1);
                    let early = over(powers[m], m) - late;
                    sums[k - 1][axis][r] = sums[k - 1][axis][r] + weight * early;
                    sums[k][axis][r] = sums[k][axis][r] + weight * late;
                    sums[k][axis][i] = Interval::ZERO;
                }
            }
        }
    }

    /// The inputs that the set of a mode which every plan keeps to allows: x'''', y'''', z'', psi''.
    fn inputs(&self) -> Result<[Interval; 4], Rejection> {
        let required = required(self.model);
        let Some(mode) = required.first() else { return Ok([Interval::WHOLE; 4]) };
        let reach = Generators::of(self.model, mode)?.extent();
        let vehicle = &self.model.vehicle;
        let g = Interval::point(self.model.gravity);
        let [ixx, iyy, izz] = vehicle.inertia.map(Interval::point);
        let (s, c) = self.yaw;
        // tau_x = Ixx/g (s x'''' - c y''''), tau_y = Iyy/g (c x'''' + s y''''), solved for x'''' and y''''.
        let (a, b) = (reach[1] * g / ixx, reach[2] * g / iyy);
        Ok([s * a + c * b, s * b - c * a, reach[0] / Interval::point(vehicle.mass) - g, reach[3] / izz])
    }

    /// The expressions of a row, once its multipliers are found to be in the dual cone.
    fn weighed(&self, multiplier: &Multiplier) -> Result<Vec<Expression>, String> {
        let parts = self.expressions(&multiplier.row)?;
        let z = &multiplier.z;
        if parts.len() != z.len() || z.iter().any(|v| !v.is_finite()) {
            return Err(format!("{} numbers for a row with {} parts", z.len(), parts.len()));
        }
        let free = matches!(multiplier.row, RowRecord::Rest { .. });
        let rest = z[1..].iter().fold(Interval::ZERO, |sum, &v| sum + Interval::point(v).square()).sqrt();
        if !free && rest.high > z[0] {
            return Err("it lies outside the dual cone".into());
        }
        Ok(parts)
    }

    /// What a row says is not negative (first part of a cone: not below the length of the others; rest: zero).
    fn expressions(&self, row: &RowRecord) -> Result<Vec<Expression>, String> {
        let points = &self.mission.waypoints;
        let at = |node: usize| if node < self.nodes() { Ok(node) } else { Err(format!("there is no node {node}")) };
        let of_waypoint = |i: usize| match (points.get(i), self.claim.waypoint_nodes.get(i)) {
            (Some(point), Some(&node)) => Ok((point, node)),
            _ => Err(format!("there is no waypoint {i}")),
        };
        match *row {
            RowRecord::Rest { node, axis, derivative } if self.rests(at(node)?, axis, derivative) => {
                Ok(vec![Expression::of(node, axis, derivative)])
            }
            RowRecord::Rest { node, axis, derivative } => {
                Err(format!("the spec does not ask for rest of derivative {derivative} of axis {axis} at node {node}"))
            }
            RowRecord::Facet { facet, node } => {
                let plane = self.planes.get(facet).ok_or(format!("there is no facet {facet}"))?;
                Ok(vec![self.keeps(plane, at(node)?)])
            }
            RowRecord::Limit { limit, node, side } => {
                let limit = self.mission.limits.get(limit).ok_or(format!("there is no limit {limit}"))?;
                one_sided(limit, at(node)?, side).ok_or("the limit has no such side".into()).map(|row| vec![row])
            }
            RowRecord::LimitNorm { limit, node, interval } => {
                let limit = self.mission.limits.get(limit).ok_or(format!("there is no limit {limit}"))?;
                self.norm(limit, at(node)?, interval).ok_or("the limit bounds no norm there".into())
            }
            RowRecord::Waypoint { waypoint } => {
                let (point, node) = of_waypoint(waypoint)?;
                if point.within >= UNBOUNDED {
                    return Err(format!("waypoint {waypoint} has no tolerance that binds"));
                }
                let mut parts = vec![Expression::constant(self.tolerances(waypoint).0)];
                for (axis, due) in [X, Y, Z].into_iter().zip(point.position) {
                    parts.push(Expression::of(node, axis, 0).minus(Interval::point(due)));
                }
                Ok(parts)
            }
            RowRecord::WaypointYaw { waypoint, side } => {
                let (point, node) = of_waypoint(waypoint)?;
                let sign = if side == Side::Upper { -Interval::ONE } else { Interval::ONE };
                let slack = self.tolerances(waypoint).1 - sign * Interval::point(point.yaw);
                Ok(vec![Expression::constant(slack).plus(node, YAW, 0, sign)])
            }
        }
    }

    /// Tolerances of a waypoint, m and rad, with what a plan may miss beside them.
    fn tolerances(&self, waypoint: usize) -> (Interval, Interval) {
        let point = &self.mission.waypoints[waypoint];
        let [within, turned, more] = [point.within, point.yaw_within, FEASIBLE].map(Interval::point);
        (within + more, turned * (Interval::ONE + more / within))
    }

    /// Rest as the language has it: velocity, acceleration, horizontal jerk, yaw rate and yaw acceleration; in a hold
    /// the inputs too.
    fn rests(&self, node: usize, axis: usize, derivative: usize) -> bool {
        if axis > YAW || derivative == 0 {
            return false;
        }
        let last = self.nodes() - 1;
        let ends = node == 0 && self.mission.start_at_rest || node == last && self.mission.end_at_rest;
        let held =
            self.mission.waypoints.iter().zip(&self.claim.waypoint_nodes).any(|(w, &n)| n == node && w.hold > 0.0);
        let highest = if held { ORDER[axis] } else { ORDER[axis].min(3) };
        (ends || held) && derivative <= highest
    }

    /// e - n.w with T = m (g + z''), tau_x = Ixx/g (s x'''' - c y''''), tau_y = Iyy/g (c x'''' + s y''''), tau_z = Izz
    /// psi''.
    fn keeps(&self, plane: &Plane, node: usize) -> Expression {
        let [thrust, roll, pitch, turn] = plane.normal;
        let (s, c) = self.yaw;
        let vehicle = &self.model.vehicle;
        let (m, g) = (Interval::point(vehicle.mass), Interval::point(self.model.gravity));
        let [ixx, iyy, izz] = vehicle.inertia.map(Interval::point);
        let (by_roll, by_pitch) = (roll * ixx / g, pitch * iyy / g);
        Expression::constant(plane.offset - thrust * m * g)
            .plus(node, X, 4, -(by_roll * s + by_pitch * c))
            .plus(node, Y, 4, by_roll * c - by_pitch * s)
            .plus(node, Z, 2, -(thrust * m))
            .plus(node, YAW, 2, -(turn * izz))
    }

    /// Limits on lengths as second-order cones; `None` for others.
    fn norm(&self, limit: &Limit, node: usize, interval: usize) -> Option<Vec<Expression>> {
        let upper = Interval::point(limit.upper?);
        let parts = |axes: &[usize], order: usize| -> Vec<Expression> {
            axes.iter().map(|&axis| Expression::of(node, axis, order)).collect()
        };
        let with = |reach: Expression, parts: Vec<Expression>| Some(std::iter::once(reach).chain(parts).collect());
        let reach = Expression::constant(upper);
        match limit.kind {
            LimitKind::Speed => with(reach, parts(&[X, Y, Z], 1)),
            LimitKind::SpeedHorizontal => with(reach, parts(&[X, Y], 1)),
            LimitKind::Acceleration => with(reach, parts(&[X, Y, Z], 2)),
            LimitKind::AccelerationHorizontal => with(reach, parts(&[X, Y], 2)),
            LimitKind::Tilt => {
                // |(x'', y'')| <= tan L (g + z''): the thrust is along (x'', y'', g + z'').
                let (s, c) = upper.sin_cos();
                let tangent = s / c;
                let g = Interval::point(self.model.gravity);
                with(Expression::constant(tangent * g).plus(node, Z, 2, tangent), parts(&[X, Y], 2))
            }
            LimitKind::Jerk if interval + 1 < self.nodes() && (interval == node || interval + 1 == node) => {
                let times = &self.claim.times_s;
                let h = Interval::point(times[interval + 1]) - Interval::point(times[interval]);
                let rate = Interval::ONE / h;
                let slope = Expression::default().plus(interval + 1, Z, 2, rate).plus(interval, Z, 2, -rate);
                let mut parts = parts(&[X, Y], 3);
                parts.push(slope);
                with(reach, parts)
            }
            _ => None,
        }
    }
}

/// A bound on one coordinate or rate; `None` where the limit has none on that side.
fn one_sided(limit: &Limit, node: usize, side: Side) -> Option<Expression> {
    let (axis, order, sign) = match limit.kind {
        LimitKind::X => (X, 0, 1.0),
        LimitKind::Y => (Y, 0, 1.0),
        LimitKind::Z => (Z, 0, 1.0),
        LimitKind::Yaw => (YAW, 0, 1.0),
        LimitKind::YawRate => (YAW, 1, 1.0),
        LimitKind::YawAcceleration => (YAW, 2, 1.0),
        LimitKind::Climb => (Z, 1, 1.0),
        LimitKind::Descent => (Z, 1, -1.0),
        _ => return None,
    };
    let (bound, towards) = match side {
        Side::Upper => (limit.upper?, -1.0),
        Side::Lower => (limit.lower?, 1.0),
    };
    let slack = Interval::point(-towards * bound);
    Some(Expression::constant(slack).plus(node, axis, order, Interval::point(towards * sign)))
}
