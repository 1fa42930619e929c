//! The rows of every program: dynamics between nodes, rests and waypoints.

use super::{Form, Transcription, UNBOUNDED};
use crate::model::Heading;
use crate::motion::{X, Y, YAW, Z};
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use std::f64::consts::PI;

impl Transcription<'_> {
    /// Exact steps under first-order hold: with m = r - i,
    /// `d_i(k+1) = sum_{j=i}^{r-1} h^(j-i)/(j-i)! d_j + h^m [(1/m! - 1/(m+1)!) u_k + u_{k+1}/(m+1)!]`.
    ///
    /// The derivatives `d_j` are those at the beginning of the interval ([`Self::jump`]).
    pub(in crate::planning::planner) fn dynamics(&self, builder: &mut Builder) {
        if let Form::Splines(..) = self.form {
            return; // splines keep these rows by construction
        }
        const FACTORIAL: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
        for (interval, h) in self.grid.steps().enumerate() {
            let (tau, next) = (self.tau_at(interval), self.tau_at(interval + 1));
            for &axis in self.axes {
                let r = self.orders[axis];
                for i in 0..r {
                    // In units of the derivative at the later node.
                    let unit = next.powi(i as i32);
                    let mut row = Affine::term(self.var(interval + 1, axis, i), -1.0);
                    let m = r - i;
                    let power = h.powi(m as i32);
                    let late = 1.0 / FACTORIAL[m + 1];
                    for j in i..=r {
                        let factor = match j {
                            j if j < r => h.powi((j - i) as i32) / FACTORIAL[j - i],
                            _ => power * (1.0 / FACTORIAL[m] - late),
                        };
                        row = row.plus(self.var(interval, axis, j), unit * factor * tau.powi(-(j as i32)));
                        row.add(&self.jump(interval, axis, j), unit * factor);
                    }
                    row = row.plus(self.var(interval + 1, axis, r), unit * power * late * next.powi(-(r as i32)));
                    builder.zero(row, RowOrigin::Dynamics { interval, axis, derivative: i });
                }
            }
        }
    }

    /// Derivatives that vanish, as (node, axis, order): velocity, acceleration and (x, y) jerk at rest; where the
    /// vehicle holds, inputs too.
    pub(in crate::planning::planner) fn at_rest(&self) -> Vec<(usize, usize, usize)> {
        let last = self.nodes() - 1;
        let mut zero = Vec::new();
        let mut rest = |node: usize, holding: bool| {
            for &axis in self.axes {
                let highest = if holding { self.orders[axis] } else { self.orders[axis].min(3) };
                zero.extend((1..=highest).map(|order| (node, axis, order)));
            }
        };
        for (w, &node) in self.mission.waypoints.iter().zip(&self.grid.waypoint_nodes) {
            let ends = node == 0 && self.mission.start_at_rest || node == last && self.mission.end_at_rest;
            if w.hold > 0.0 || w.stop || ends {
                rest(node, w.hold > 0.0);
            }
        }
        zero
    }

    pub(in crate::planning::planner) fn rest(&self, builder: &mut Builder) {
        for (node, axis, derivative) in self.at_rest() {
            let row = self.at_node(node, axis, derivative).times(self.tau_at(node).powi(derivative as i32));
            builder.zero(row, RowOrigin::Rest { node, axis, derivative });
        }
        if let Some(branch) = &self.branch {
            self.branching(builder, branch);
        }
    }

    /// |p - p_i| <= within_i + slack; yaw tolerances widen in the same proportion:
    /// |psi - psi_i| <= yaw_within_i (1 + slack / within_i).
    pub(in crate::planning::planner) fn waypoints(&self, builder: &mut Builder, slack: &Affine) {
        for (waypoint, (w, &node)) in self.mission.waypoints.iter().zip(&self.grid.waypoint_nodes).enumerate() {
            if self.plans(X) && w.within < UNBOUNDED {
                let mut cone = vec![slack.clone().plus_constant(w.within)];
                for (axis, target) in [X, Y, Z].into_iter().zip(w.position) {
                    cone.push(self.at_node(node, axis, 0).plus_constant(-target));
                }
                builder.cone(cone, RowOrigin::Waypoint { waypoint });
            }
            // The yaw of a start that follows from the motion is not whole turns away from where yaws are counted.
            let (within, wider) = match (w.heading, waypoint) {
                (Heading::Given, _) => (w.yaw_within, w.yaw_within / w.within),
                (_, 0) => (PI, 0.0),
                _ => (UNBOUNDED, 0.0),
            };
            if self.plans(YAW) && within < UNBOUNDED {
                for sign in [1.0, -1.0] {
                    let mut row = slack.clone().times(wider).plus_constant(within);
                    row.add(&self.at_node(node, YAW, 0).plus_constant(-w.yaw), sign);
                    builder.nonnegative(row, RowOrigin::WaypointYaw { waypoint });
                }
            }
        }
    }
}
