//! The cost (48): squared inputs over time and squared distances to the waypoints.

use crate::model::{Heading, Mission, Waypoint};
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::transcription::Transcription;
use crate::qp::build::Builder;

/// Gauss and Legendre's points on 0..1 and their weights: exact for polynomials up to degree 7, and the square of an
/// acceleration under a piecewise linear snap is of degree 6.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

impl Transcription<'_> {
    /// (48) times `factor`, and comfort where it counts, with exact integrals: over a step h, the integral of u^2 is h
    /// (u0^2 + u0 u1 + u1^2) / 3.
    ///
    /// Where z is a quadruple integrator both its input and its acceleration count, each with its own weight.
    pub(super) fn cost(&self, builder: &mut Builder, factor: f64) {
        if let Some(comfort) = &self.comfort {
            self.add_comfort(builder, comfort, factor);
        }
        let plan = &self.model.plan;
        for (k, step) in self.grid.steps().enumerate() {
            for &axis in self.axes {
                let r = self.orders[axis];
                let weight = if r == 4 { plan.snap_weight } else { plan.acceleration_weight };
                let c = factor * weight * step / 3.0;
                let (u0, u1) = (self.at_node(k, axis, r), self.at_node(k + 1, axis, r));
                builder.inner_product(&u0, &u0, c);
                builder.inner_product(&u0, &u1, c);
                builder.inner_product(&u1, &u1, c);
            }
            if self.climbs_smoothly() {
                for (share, weight) in GAUSS {
                    let climb = self.inside(k, share, Z, 2);
                    builder.inner_product(&climb, &climb, factor * plan.acceleration_weight * step * weight);
                }
            }
        }
        self.distances(builder, factor);
    }

    /// The part of (48) that counts squared distances to the waypoints, times `factor`.
    pub(super) fn distances(&self, builder: &mut Builder, factor: f64) {
        for (w, &node) in self.mission.waypoints.iter().zip(&self.grid.waypoint_nodes) {
            let targets = [w.position[0], w.position[1], w.position[2], w.yaw];
            let is_due = |axis: usize| axis != YAW || w.heading == Heading::Given;
            for &axis in self.axes.iter().filter(|&&axis| is_due(axis)) {
                let miss = self.at_node(node, axis, 0).plus_constant(-targets[axis]);
                builder.inner_product(&miss, &miss, factor * w.weight);
            }
        }
    }

    /// The value of (48), and of comfort where it counts, for the derivatives at every node.
    pub(super) fn cost_of(&self, states: &[NodeState]) -> f64 {
        let plan = &self.model.plan;
        let mut sum = self.comfort.as_ref().map_or(0.0, |comfort| self.comfort_of(comfort, states));
        for (k, step) in self.grid.steps().enumerate() {
            let (left, right) = (&states[k], &states[k + 1]);
            for &axis in self.axes {
                let r = self.orders[axis];
                let weight = if r == 4 { plan.snap_weight } else { plan.acceleration_weight };
                let (u0, u1) = (left[axis][r], right[axis][r]);
                sum += weight * step / 3.0 * (u0 * u0 + u0 * u1 + u1 * u1);
            }
            if self.climbs_smoothly() {
                let slope = (right[Z][4] - left[Z][4]) / step;
                for (share, weight) in GAUSS {
                    let t = share * step;
                    let climb = left[Z][2] + t * (left[Z][3] + t * (left[Z][4] / 2.0 + t * slope / 6.0));
                    sum += plan.acceleration_weight * step * weight * climb * climb;
                }
            }
        }
        for (w, &node) in self.mission.waypoints.iter().zip(&self.grid.waypoint_nodes) {
            let targets = [(X, w.position[0]), (Y, w.position[1]), (Z, w.position[2]), (YAW, w.yaw)];
            let is_due = |axis: usize| axis != YAW || w.heading == Heading::Given;
            let misses = targets.into_iter().filter(|(axis, _)| self.plans(*axis) && is_due(*axis));
            sum += w.weight * misses.map(|(axis, target)| (states[node][axis][0] - target).powi(2)).sum::<f64>();
        }
        sum
    }

    /// Adds a weight on squared accelerations to (48) if an end is free, for the minimum-snap initial guess.
    ///
    /// There (48) alone has many minimisers: cubics of time cost nothing in x and y, and many of them meet a few
    /// waypoints. The term is `w_s / tau^4` times the integral of `x''^2 + y''^2`, tau the mean duration of a leg,
    /// which weighs an acceleration like the snap that builds it up within such a time, and prefers one of them.
    pub(super) fn gentleness(&self, builder: &mut Builder) {
        if self.free_ends().next().is_none() {
            return;
        }
        let tau = self.grid.total / self.grid.segments.len() as f64;
        let factor = self.model.plan.snap_weight / tau.powi(4);
        for (k, step) in self.grid.steps().enumerate() {
            for axis in [X, Y] {
                for (share, weight) in GAUSS {
                    let acceleration = self.inside(k, share, axis, 2);
                    builder.inner_product(&acceleration, &acceleration, factor * step * weight);
                }
            }
        }
    }

    /// The first and the last node, each if the mission does not rest there; none for a stop after a fault.
    pub(super) fn free_ends(&self) -> impl Iterator<Item = usize> {
        let Mission { waypoints, start_at_rest, end_at_rest, .. } = self.mission;
        let holds = |w: Option<&Waypoint>| w.is_some_and(|w| w.hold > 0.0 || w.stop);
        let branches = self.branch.is_some();
        let start = !branches && !start_at_rest && !holds(waypoints.first());
        let end = !branches && !end_at_rest && !holds(waypoints.last());
        start.then_some(0).into_iter().chain(end.then(|| self.nodes() - 1))
    }

    /// Whether z is a quadruple integrator that is planned here.
    fn climbs_smoothly(&self) -> bool {
        self.orders[Z] == 4 && self.plans(Z)
    }
}
