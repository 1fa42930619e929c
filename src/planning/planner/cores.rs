//! Rows of cores as second-order cones: (101) of `docs/method/without-yaw.md`.

use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::{CoreRow, Turning};
use crate::motion::turning::TurningMap;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Z, state_between};
use crate::planner::transcription::Transcription;
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};

/// A row of a core at an instant.
#[derive(Clone, Copy)]
pub(super) struct CoreAt<'r> {
    pub row: &'r SetRow,
    pub core: &'r CoreRow,
    /// The row's index in the set.
    pub facet: usize,
    pub instant: usize,
}

/// A row is multiplied by `(1 + change)^order`, to first order in the change.
#[derive(Clone, Copy)]
pub(super) struct Scaling<'e> {
    /// The relative change of the duration (69).
    pub change: &'e Affine,
    pub order: f64,
}

impl Transcription<'_> {
    /// The wrench model whose integrators these are, as far as turning depends on it.
    fn turning_model(&self) -> WrenchModel {
        if self.orders[Z] > 2 { WrenchModel::Exact } else { WrenchModel::HoverFollowing }
    }

    /// How a state of these axes turns.
    pub(super) fn turning(&self, state: &NodeState) -> Turning {
        self.turning_model().turning(&self.model.vehicle, &self.model.environment(), state)
    }

    /// The state at an instant of the motion about which rows are linearised; at rest without one.
    fn state_near(&self, instant: usize) -> NodeState {
        let Some(states) = self.states else { return NodeState::default() };
        let (interval, part) = (instant / self.parts, instant % self.parts);
        if part == 0 {
            return states[interval];
        }
        let step = self.grid.node_times[interval + 1] - self.grid.node_times[interval];
        let share = part as f64 / self.parts as f64;
        state_between(&states[interval], &states[interval + 1], step, share * step, self.turning_model())
    }

    /// Whether rows at nodes have to hold between them too: about hover the turning is a quadratic polynomial of time
    /// on each interval, in the hull of its values at both ends and of a third point.
    fn spans_intervals(&self) -> bool {
        self.orders[Z] == 2 && self.parts == 1
    }

    /// How a plan of these axes turns at a node and, about hover, at the third point of the interval after it.
    pub(super) fn turnings(&self, states: &[NodeState], node: usize) -> Vec<Turning> {
        let middle = (self.spans_intervals() && node + 1 < states.len()).then(|| {
            let step = self.grid.node_times[node + 1] - self.grid.node_times[node];
            let third: NodeState = std::array::from_fn(|axis| {
                std::array::from_fn(|order| match order < self.orders[axis] {
                    true => states[node][axis][order] + 0.5 * step * states[node][axis][order + 1],
                    false => 0.5 * (states[node][axis][order] + states[node + 1][axis][order]),
                })
            });
            self.turning(&third)
        });
        std::iter::once(self.turning(&states[node])).chain(middle).collect()
    }

    /// The largest violation of a core's row at a node and, about hover, over the interval after it.
    pub(super) fn core_violation(&self, row: &SetRow, states: &[NodeState], node: usize) -> f64 {
        let of = |turning: &Turning| row.normal[0] * turning[0] - row.offset + row.of_core(Some(turning));
        self.turnings(states, node).iter().map(of).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The derivative at an instant, or at the third point of the interval after a node: for the derivatives of orders
    /// r and r - 1 the coefficients in Bernstein's basis of degree 2, with r the order of the axis's input.
    fn derivative_in(&self, instant: usize, third: bool, axis: usize, order: usize) -> Affine {
        let mut at = self.derivative(instant, axis, order);
        if third && order < self.orders[axis] {
            let step = self.grid.node_times[instant + 1] - self.grid.node_times[instant];
            at.add(&self.derivative(instant, axis, order + 1), 0.5 * step);
        } else if third {
            at = at.times(0.5);
            at.add(&self.derivative(instant + 1, axis, order), 0.5);
        }
        at
    }

    /// Adds a row of a core, wider by `free`; the order of `scaling` is that of the highest derivative.
    pub(super) fn core(&self, builder: &mut Builder, at: CoreAt, free: &Affine, scaling: Scaling) {
        let instant = at.instant;
        let near = self.state_near(instant);
        let map = self.turning_model().turning_map(&self.model.vehicle, &self.model.environment(), &near);
        let beside = self.spans_intervals() && instant + 1 < self.nodes();
        for third in [false, true].into_iter().take(1 + usize::from(beside)) {
            let turning = self.turning_expression(&map, &near, instant, third, scaling);
            self.core_at(builder, at, turning, free, scaling);
        }
    }

    /// One cone of a row.
    fn core_at(&self, builder: &mut Builder, at: CoreAt, turning: [Affine; 5], free: &Affine, scaling: Scaling) {
        let CoreAt { row, core, facet, instant } = at;
        let mut room = free.clone().plus_constant(row.offset);
        room.add(scaling.change, scaling.order * row.offset);
        room.add(&turning[0], -row.normal[0]);
        let origin = RowOrigin::Facet { facet, node: instant / self.parts };
        if core.torque == 0.0 {
            builder.nonnegative(room, origin);
            return;
        }
        let combined = |i: usize, swing: f64, rate: f64| {
            let mut sum = turning[1 + i].clone().times(swing);
            sum.add(&turning[3 + i], rate);
            sum
        };
        let mut cone = vec![room.times(1.0 / core.torque)];
        // |x| + delta |y| <= |(sqrt(1 + kappa) x, sqrt(1 + 1/kappa) delta y)| for every kappa > 0; equal where
        // delta |y| = kappa |x|.
        let delta = core.unevenness.abs();
        let kappa = if delta > 0.0 { delta / core.inertia } else { 0.0 };
        let even = (1.0 + kappa).sqrt();
        cone.extend([0, 1].map(|i| combined(i, even * core.inertia, even * core.momentum)));
        if delta > 0.0 {
            let uneven = (1.0 + 1.0 / kappa).sqrt() * delta;
            cone.extend([0, 1].map(|i| combined(i, uneven, uneven * 2.0 * core.spin)));
        }
        builder.cone(cone, origin);
    }

    /// The components of the turning at an instant, scaled.
    fn turning_expression(
        &self,
        map: &TurningMap,
        near: &NodeState,
        instant: usize,
        third: bool,
        scaling: Scaling,
    ) -> [Affine; 5] {
        let now = map.at(near);
        let derivatives: Vec<Affine> =
            map.terms.iter().map(|&(axis, order, _)| self.derivative_in(instant, third, axis, order)).collect();
        std::array::from_fn(|i| {
            let mut sum = Affine::constant(map.constant[i]);
            let mut by_time = scaling.order * now[i];
            for (&(axis, order, c), derivative) in map.terms.iter().zip(&derivatives) {
                if c[i] != 0.0 && self.plans(axis) {
                    sum.add(derivative, c[i]);
                    by_time -= c[i] * order as f64 * near[axis][order];
                }
            }
            sum.add(scaling.change, by_time);
            sum
        })
    }
}
