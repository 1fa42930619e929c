//! The initial and the final state of a branch, as rows.

use super::{Branch, Ending};
use crate::flatness::rotor_drag;
use crate::model::Environment;
use crate::motion::{NodeState, X, Y, YAW, Z, in_air};
use crate::planner::transcription::Transcription;
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use nalgebra::{Matrix3, Vector3};

impl Transcription<'_> {
    /// The rows from the state in which a branch begins to its end. In the hover model z'' is the thrust, and the
    /// derivatives of x and y up to the third are attitude and body rates. In the exact model these are the direction
    /// of `a + g` and its rate of change.
    pub(in crate::planning::planner) fn branching(&self, builder: &mut Builder, branch: &Branch) {
        let struck = &branch.from;
        for axis in [X, Y, Z, YAW] {
            for order in 0..=1 {
                self.remains(builder, struck, axis, order);
            }
        }
        if self.orders[Z] > 2 {
            self.direction_remains(builder, struck);
        } else {
            for (axis, order) in [(X, 2), (X, 3), (Y, 2), (Y, 3)] {
                self.remains(builder, struck, axis, order);
            }
        }
        let last = self.nodes() - 1;
        let mut ends = |axis: usize, order: usize, value: f64| {
            let row = self.at_node(last, axis, order).plus_constant(-value);
            let origin = RowOrigin::Stop { node: last, axis, derivative: order };
            builder.zero(row.times(self.tau_at(last).powi(order as i32)), origin);
        };
        match &branch.to {
            Ending::Rest => {
                for (axis, highest) in [(X, 3), (Y, 3), (Z, 1), (YAW, 1)] {
                    (1..=highest).for_each(|order| ends(axis, order, 0.0));
                }
            }
            Ending::Joins(state) => {
                for axis in [X, Y, Z, YAW] {
                    (0..self.orders[axis]).for_each(|order| ends(axis, order, state[axis][order]));
                }
            }
        }
    }

    /// The row of a derivative that no fault changes.
    fn remains(&self, builder: &mut Builder, struck: &NodeState, axis: usize, order: usize) {
        let row = self.at_node(0, axis, order).plus_constant(-struck[axis][order]);
        let origin = RowOrigin::Stop { node: 0, axis, derivative: order };
        builder.zero(row.times(self.tau_at(0).powi(order as i32)), origin);
    }

    /// The rows that keep attitude and body rates. Let A, J be the acceleration with gravity and the jerk of the plan,
    /// a, j those of the stop, and e any direction normal to A. The thrust's direction n = A/|A| is kept if `e.a = 0`,
    /// and its rate `e.n' = e.J/|A| = e.j/|a|` if `e.j = (n.a/|A|) e.J`. Two such directions suffice.
    fn direction_remains(&self, builder: &mut Builder, struck: &NodeState) {
        // In the middle of the possible winds, whose direction the attitude follows.
        let environment = self.model.environment();
        if !environment.turns_alike() {
            return self.attitude_remains(builder, struck, &environment);
        }
        let felt = in_air(struck, &environment);
        let across = Vector3::new(felt[X][2], felt[Y][2], felt[Z][2] + environment.gravity);
        let jerk = Vector3::new(felt[X][3], felt[Y][3], felt[Z][3]);
        let (n, length) = (across.normalize(), across.norm());
        let mut least = Vector3::zeros();
        least[n.iamin()] = 1.0;
        let e1 = n.cross(&least).normalize();
        let along = |v: &Vector3<f64>, order: usize| {
            let mut sum = Affine::constant(0.0);
            let thrust = match order {
                2 => self.thrust(0, &environment),
                _ => [X, Y, Z].map(|axis| self.in_air(&environment, axis, order, |order| self.at_node(0, axis, order))),
            };
            for (part, share) in thrust.iter().zip(v.iter()) {
                sum.add(part, *share);
            }
            sum
        };
        for (e, axis) in [(e1, X), (n.cross(&e1), Y)] {
            let row = along(&e, 2).times(self.tau_at(0).powi(2));
            builder.zero(row, RowOrigin::Stop { node: 0, axis, derivative: 2 });
            let mut row = along(&e, 3);
            row.add(&along(&n, 2), -e.dot(&jerk) / length);
            builder.zero(row.times(self.tau_at(0).powi(3)), RowOrigin::Stop { node: 0, axis, derivative: 3 });
        }
    }

    /// The rows at the fault where the drag differs along x and y. Attitude R and velocity are those of the plan, and
    /// so is the force of the drag: with K = R diag(k) R^T and the velocity u through the air, the thrust over mass of
    /// the stop is `c b_3 = a + g e_z + K u`. Its direction is kept if `e.(a + K u + g e_z) = 0` for every e normal to
    /// b_3, and that of its rate of change `c' b_3 + c b_3' = j + K a + K' u` if `e.(j + K a + K' u) = c e.b_3'` with
    /// `c = b_3.(a + K u + g e_z)`.
    fn attitude_remains(&self, builder: &mut Builder, struck: &NodeState, environment: &Environment) {
        let orders = [1, 2, 3].map(|order| [X, Y, Z].map(|axis| struck[axis][order]));
        let [r, turning] = rotor_drag::rotation(environment, orders, [struck[YAW][0], struck[YAW][1]]);
        let rates = Matrix3::from_diagonal(&Vector3::from(environment.drag_rates));
        let (k, change) =
            (r * rates * r.transpose(), turning * rates * r.transpose() + r * rates * turning.transpose());
        let air = Vector3::from(orders[0]) - Vector3::from(environment.wind);
        let (steady, rising) = (k * air + Vector3::z() * environment.gravity, change * air);
        let sum = |v: &Vector3<f64>, order: usize, constant: f64| {
            let mut sum = Affine::constant(constant);
            for axis in [X, Y, Z] {
                sum.add(&self.at_node(0, axis, order), v[axis]);
            }
            sum
        };
        let (b3, b3_rate) = (r.column(2).into_owned(), turning.column(2).into_owned());
        for (column, axis) in [(0, X), (1, Y)] {
            let e = r.column(column).into_owned();
            let row = sum(&e, 2, e.dot(&steady)).times(self.tau_at(0).powi(2));
            builder.zero(row, RowOrigin::Stop { node: 0, axis, derivative: 2 });
            let mut row = sum(&e, 3, e.dot(&rising));
            row.add(&sum(&(k * e), 2, 0.0), 1.0);
            row.add(&sum(&b3, 2, b3.dot(&steady)), -e.dot(&b3_rate));
            builder.zero(row.times(self.tau_at(0).powi(3)), RowOrigin::Stop { node: 0, axis, derivative: 3 });
        }
    }
}
