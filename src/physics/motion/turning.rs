//! What a motion takes whatever the heading of the body: see [`Turning`].

use super::wrench_model::{DIRECTIONS, WrenchModel, flat};
use super::{NodeState, X, Y, YAW, Z, in_air};
use crate::admissible::without_yaw::planned::Turning;
use crate::flatness;
use crate::model::{Environment, Vehicle};
use nalgebra::SVector;

/// An affine function from the derivatives of a state to a [`Turning`].
#[derive(Debug, Clone, PartialEq)]
pub struct TurningMap {
    pub constant: Turning,
    /// Axis and order of a derivative, and its coefficient.
    pub terms: Vec<(usize, usize, Turning)>,
}

impl WrenchModel {
    /// The turning of a motion at an instant. In the models about hover s = (x'', y'')/g, so that
    ///
    /// ```text
    /// (100)  T = m (z'' + g)     s x s'' = (-y'''', x'''')/g     s' = (x''', y''')/g     r = psi'
    /// ```
    pub fn turning(self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> Turning {
        match self {
            WrenchModel::Exact => {
                flatness::turning(vehicle.mass, environment.gravity, &flat(&in_air(state, environment)))
            }
            _ => about_hover(vehicle, environment.gravity).at(state),
        }
    }

    /// Its linearisation at a state; in the models about hover it is linear.
    pub fn turning_map(self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> TurningMap {
        let WrenchModel::Exact = self else { return about_hover(vehicle, environment.gravity) };
        let at = flat(&in_air(state, environment));
        let (turning, slope) = flatness::turning_and_jacobian(vehicle.mass, environment.gravity, &at);
        let columns = DIRECTIONS.iter().zip(slope.column_iter());
        let terms = columns.map(|(&(axis, order), c)| (axis, order, c.into_owned()));
        TurningMap { constant: turning - slope * at, terms: terms.collect() }.of_motion_in(environment)
    }
}

fn about_hover(vehicle: &Vehicle, gravity: f64) -> TurningMap {
    let along = |i: usize, factor: f64| {
        let mut turning: Turning = SVector::zeros();
        turning[i] = factor;
        turning
    };
    TurningMap {
        constant: along(0, vehicle.mass * gravity),
        terms: vec![
            (Z, 2, along(0, vehicle.mass)),
            (Y, 4, along(1, -1.0 / gravity)),
            (X, 4, along(2, 1.0 / gravity)),
            (X, 3, along(3, 1.0 / gravity)),
            (Y, 3, along(4, 1.0 / gravity)),
            (YAW, 1, along(5, 1.0)),
        ],
    }
}

impl TurningMap {
    /// The value at a state.
    pub fn at(&self, state: &NodeState) -> Turning {
        self.terms.iter().fold(self.constant, |sum, &(axis, order, c)| sum + c * state[axis][order])
    }

    /// This map as one of the motion, where this is one of the motion [`in_air`].
    fn of_motion_in(mut self, environment: &Environment) -> Self {
        if !environment.has_drag() {
            return self;
        }
        let rate = environment.turning_rate();
        let felt: Vec<_> = self.terms.iter().filter(|term| term.0 != YAW).copied().collect();
        for (axis, order, coefficient) in felt {
            if order == 2 {
                self.constant -= coefficient * (rate * environment.wind[axis]);
            }
            self.terms.push((axis, order - 1, coefficient * rate));
        }
        self
    }
}
