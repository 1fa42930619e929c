//! Bounds on the inputs of any plan, with which the inputs that the multipliers do not cancel are bounded.

use super::super::Rejection;
use super::super::interval::Interval;
use super::super::most_thrust;
use super::super::motion::{X, Y, Z};
use super::Rows;
use crate::certificate::DynamicModel;
use crate::model::LimitKind;

impl Rows<'_> {
    /// Bounds on the input of each axis at any node.
    pub(super) fn inputs(&self) -> [Interval; 4] {
        match (self.kind, self.thrust) {
            (DynamicModel::Hover, _) => self.inputs_about_hover(),
            (DynamicModel::Exact, Some(most)) => self.exact_inputs(most),
            (DynamicModel::Exact, None) => [Interval::WHOLE; 4],
        }
    }

    /// Bounds on x'''', y'''', z'', psi'' from the set of a mode in which every plan stays.
    fn inputs_about_hover(&self) -> [Interval; 4] {
        let Some(reach) = self.extent else { return [Interval::WHOLE; 4] };
        let vehicle = &self.problem.model().vehicle;
        let g = Interval::point(self.problem.model().gravity);
        let [ixx, iyy, izz] = vehicle.inertia.map(Interval::point);
        let (s, c) = self.yaw;
        // tau_x = Ixx/g (s x'''' - c y''''), tau_y = Iyy/g (c x'''' + s y''''), solved for x'''' and y''''.
        let (a, b) = (reach[1] * g / ixx, reach[2] * g / iyy);
        [s * a + c * b, s * b - c * a, reach[0] / Interval::point(vehicle.mass) - g, reach[3] / izz]
    }

    /// Bounds on x'''', y'''', z'''' and psi'' of motions that start at rest.
    ///
    /// If they end at rest, x'' is a twice continuously differentiable cubic spline with slope zero at both ends, so
    /// its second derivatives u_k at the nodes solve (de Boor, *A Practical Guide to Splines*, chapter 4)
    ///
    /// `h_(k-1)/6 u_(k-1) + (h_(k-1) + h_k)/3 u_k + h_k/6 u_(k+1) = (x''_(k+1) - x''_k)/h_k - (x''_k -
    /// x''_(k-1))/h_(k-1)`.
    ///
    /// At the largest |u_k| the left side is at least (h_(k-1) + h_k)/6 times |u_k|. The right side is at most 2 A
    /// (1/h_k + 1/h_(k-1)) with A = T_max/m, since the thrust bounds |(x'', y'', z'' + g)| at the nodes. Hence
    /// `|u| <= 12 A/(h_(k-1) h_k)`; at the ends likewise, with one step for both. If the motion does not end at rest,
    /// [`Self::at_a_moving_end`] replaces the condition on the slope.
    fn exact_inputs(&self, most: Interval) -> [Interval; 4] {
        let step = self.shortest_step();
        let acceleration = most / Interval::point(self.problem.model().vehicle.mass);
        let snap = Interval::point(12.0) * acceleration / (step * step);
        let of_axis = |axis: usize| match self.problem.mission().end_at_rest {
            true => Interval::around_zero(snap.magnitude()),
            false => Interval::around_zero((snap + self.at_a_moving_end(axis, acceleration)).magnitude()),
        };
        [of_axis(X), of_axis(Y), of_axis(Z), self.yaw_input(step)]
    }

    /// By how much the inputs of an axis may exceed the bound for motions that end at rest, because the last slope is
    /// not zero. With h the last step, it is either of
    ///
    /// `6 J/h`, for a jerk of at most J at the end: it replaces the slope in the last equation, whose right side is
    /// then at most J + 2 A/h, and whose left side is at least h/6 times the largest |u_k|;
    ///
    /// `48 (2 V + h (A + g))/h^3`, for a velocity of at most V: the velocity gained in the last step is
    /// `h/2 (x''_(N-1) + x''_N) - h^3/24 (u_(N-1) + u_N)`, so |u_(N-1) + u_N| is at most r, half of that (x'' is at
    /// most A in size, z'' at most A + g). After subtracting h/6 of it, the left side of the equation before is at
    /// least (h_(N-2) + h)/6 times the largest of the other |u_k|, so these are at most `12 A/(h_(N-2) h) + r`, and
    /// |u_N| at most r more.
    ///
    /// Without either limit the inputs are unbounded: splines that vanish at all nodes may grow from node to node.
    fn at_a_moving_end(&self, axis: usize, acceleration: Interval) -> Interval {
        let times = &self.grid.times;
        let [.., before, end] = times[..] else { return Interval::WHOLE };
        let step = Interval::point(end) - Interval::point(before);
        let jerk = self.upper(LimitKind::Jerk).map(|j| Interval::point(6.0) * Interval::point(j) / step);
        let along = match axis {
            Z => self.upper(LimitKind::Climb).zip(self.upper(LimitKind::Descent)).map(|(up, down)| up.max(down)),
            _ => self.upper(LimitKind::SpeedHorizontal),
        };
        let speed = [along, self.upper(LimitKind::Speed)].into_iter().flatten().reduce(f64::min);
        let gained = |v: f64| {
            let size = acceleration + Interval::point(self.problem.model().gravity);
            let both = Interval::point(2.0 * v) + step * size;
            Interval::point(48.0) * both / (step * step * step)
        };
        let bounds = [jerk, speed.map(gained)].into_iter().flatten();
        bounds.reduce(|a, b| if b.high < a.high { b } else { a }).unwrap_or(Interval::WHOLE)
    }

    /// The upper bound of a limit on all legs, if the mission has one.
    fn upper(&self, kind: LimitKind) -> Option<f64> {
        let limits = self.problem.mission().limits.iter().filter(|l| l.is_general() && l.kind == kind);
        limits.filter_map(|l| l.upper).reduce(f64::min)
    }

    /// Bounds on psi'' at any node: its limit, or a bound that follows from the limit on psi'. From rest psi'' is 0 at
    /// first, and `psi''_(k+1) = 2 (psi'_(k+1) - psi'_k)/h - psi''_k`.
    fn yaw_input(&self, step: Interval) -> Interval {
        let sides = |kind: LimitKind| {
            let limits = self.problem.mission().limits.iter().filter(move |l| l.is_general() && l.kind == kind);
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
        let steps = self.grid.times.windows(2).map(|w| Interval::point(w[1]) - Interval::point(w[0]));
        steps.reduce(|a, b| if b.low < a.low { b } else { a }).unwrap_or(Interval::ZERO)
    }

    /// The largest thrust of any plan, N: by the facets' weights, `T = sum of weight (n.w) + rest.w`, and the rest is
    /// bounded by the set of a mode in which every plan stays.
    pub(super) fn most_thrust(&self) -> Result<Interval, Rejection> {
        let wrong = |why: &str| Err(Rejection::new("the largest thrust", why));
        let mut weighted = Vec::new();
        for entry in &self.claim.thrust {
            let Some(plane) = self.planes.get(entry.facet) else { return wrong("a weighted facet is not listed") };
            if !(entry.weight.is_finite() && entry.weight >= 0.0) {
                return wrong("a weight is negative or not finite");
            }
            weighted.push((entry.weight, plane));
        }
        let Some(reach) = self.extent else { return wrong("the planner imposes no set") };
        Ok(most_thrust::shown(weighted.into_iter(), 0.0, &reach))
    }
}
