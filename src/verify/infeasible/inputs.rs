//! Bounds on the inputs of any plan: they absorb what multipliers leave of them.

use super::super::interval::Interval;
use super::super::sets::{Generators, along};
use super::super::{Rejection, required};
use super::Rows;
use crate::certificate::DynamicModel;
use crate::model::LimitKind;

impl Rows<'_> {
    /// The input of each axis at any node.
    pub(super) fn inputs(&self) -> Result<[Interval; 4], Rejection> {
        match (self.kind, self.thrust) {
            (DynamicModel::Hover, _) => self.inputs_about_hover(),
            (DynamicModel::Exact, Some(most)) => Ok(self.exact_inputs(most)),
            (DynamicModel::Exact, None) => Ok([Interval::WHOLE; 4]),
        }
    }

    /// x'''', y'''', z'', psi'' that the set of a mode which every plan keeps to allows.
    fn inputs_about_hover(&self) -> Result<[Interval; 4], Rejection> {
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

    /// x'''', y'''', z'''' and psi'' of motions from rest to rest.
    ///
    /// x'' is a twice continuously differentiable cubic spline with slope zero at both ends, so its second derivatives u_k
    /// at the nodes solve (de Boor, *A Practical Guide to Splines*, chapter 4)
    ///
    /// `h_(k-1)/6 u_(k-1) + (h_(k-1) + h_k)/3 u_k + h_k/6 u_(k+1) = (x''_(k+1) - x''_k)/h_k - (x''_k - x''_(k-1))/h_(k-1)`.
    ///
    /// Where |u_k| is largest the left side is at least (h_(k-1) + h_k)/6 of it. The right one is at most 2 A (1/h_k +
    /// 1/h_(k-1)) with A = T_max/m, since the thrust bounds |(x'', y'', z'' + g)| at the nodes. Hence
    /// `|u| <= 12 A/(h_(k-1) h_k)`; at the ends alike, with one step for both.
    fn exact_inputs(&self, most: Interval) -> [Interval; 4] {
        let step = self.shortest_step();
        let acceleration = most / Interval::point(self.model.vehicle.mass);
        let snap = Interval::point(12.0) * acceleration / (step * step);
        let snap = Interval::around_zero(snap.magnitude());
        [snap, snap, snap, self.yaw_input(step)]
    }

    /// psi'' at any node: its limit, or what follows from that of psi'. From rest psi'' is 0 at first, and
    /// `psi''_(k+1) = 2 (psi'_(k+1) - psi'_k)/h - psi''_k`.
    fn yaw_input(&self, step: Interval) -> Interval {
        let sides = |kind: LimitKind| {
            let limits = self.mission.limits.iter().filter(move |l| l.kind == kind);
            limits.filter_map(|l| Some((l.lower?, l.upper?))).next()
        };
        if let Some((lower, upper)) = sides(LimitKind::YawAcceleration) {
            return Interval::new(lower, upper);
        }
        let Some((lower, upper)) = sides(LimitKind::YawRate) else { return Interval::WHOLE };
        let change = Interval::point(upper) - Interval::point(lower);
        let often = Interval::point(2.0 * self.nodes() as f64);
        Interval::around_zero((often * change / step).magnitude())
    }

    /// s
    fn shortest_step(&self) -> Interval {
        let steps = self.claim.times_s.windows(2).map(|w| Interval::point(w[1]) - Interval::point(w[0]));
        steps.reduce(|a, b| if b.low < a.low { b } else { a }).unwrap_or(Interval::ZERO)
    }

    /// The largest thrust of any plan, N: by the facets' weights, `T = sum of weight (n.w) + rest.w`, and the rest is
    /// bounded by the set of a mode that every plan keeps to.
    pub(super) fn most_thrust(&self) -> Result<Interval, Rejection> {
        let wrong = |why: &str| Err(Rejection::new("the largest thrust", why));
        let mut rest = [Interval::ONE, Interval::ZERO, Interval::ZERO, Interval::ZERO];
        let mut most = Interval::ZERO;
        for entry in &self.claim.thrust {
            let Some(plane) = self.planes.get(entry.facet) else { return wrong("a facet weighed is not listed") };
            if !(entry.weight.is_finite() && entry.weight >= 0.0) {
                return wrong("a weight is negative");
            }
            let weight = Interval::point(entry.weight);
            most = most + weight * plane.offset;
            for (left, normal) in rest.iter_mut().zip(&plane.normal) {
                *left = *left - weight * *normal;
            }
        }
        let required = required(self.model);
        let Some(mode) = required.first() else { return wrong("the planner keeps to no set") };
        let reach = Generators::of(self.model, mode)?.extent();
        Ok(most + along(&rest, &reach))
    }
}
