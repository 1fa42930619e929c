//! The wrench that a motion needs: by the paper's linear model about hover, or exactly.

use super::hover_map::{self, WrenchMap, YawState};
use super::{CommandState, NodeState, X, Y, YAW, Z, in_air};
use crate::actuation::Wrench;
use crate::flatness::{self, COMMAND_INPUTS, CommandFlatState, FlatState, INPUTS, rotor_drag};
use crate::model::{Environment, Vehicle};
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

/// The model by which the wrench follows from a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WrenchModel {
    /// Linear about hover at one yaw psi (rad); yaw is planned together with position (`docs/method/hover-model.md`,
    /// "One yaw throughout").
    HoverAt(f64),
    /// Linear about hover in the derivatives of x, y and z, at the planned yaw of each instant ("Changing yaw"
    /// there).
    HoverFollowing,
    /// The exact wrench by differential flatness of (3) to (9), without small angles (`docs/method/exact-model.md`).
    Exact,
}

/// Axis and order of the derivative in each entry of a [`FlatState`].
const FLAT: [(usize, usize); INPUTS] =
    [(X, 2), (Y, 2), (Z, 2), (X, 3), (Y, 3), (Z, 3), (X, 4), (Y, 4), (Z, 4), (YAW, 0), (YAW, 1), (YAW, 2)];

/// Axis and order of the derivative in each entry of a [`CommandFlatState`].
pub const COMMAND_DERIVATIVES: [(usize, usize); COMMAND_INPUTS] = {
    let mut all = [(YAW, 3); COMMAND_INPUTS];
    let mut i = 0;
    while i < INPUTS {
        all[i] = FLAT[i];
        i += 1;
    }
    (all[INPUTS], all[INPUTS + 1], all[INPUTS + 2]) = ((X, 5), (Y, 5), (Z, 5));
    all
};

pub(super) fn command_flat(state: &CommandState) -> CommandFlatState {
    CommandFlatState::from_fn(|i, _| state[COMMAND_DERIVATIVES[i].0][COMMAND_DERIVATIVES[i].1])
}

/// Axis and order of the derivative in each entry of the vectors that [`WrenchModel::curvature`] returns.
pub const DIRECTIONS: [(usize, usize); INPUTS] = FLAT;

pub(super) fn flat(state: &NodeState) -> FlatState {
    FlatState::from_fn(|i, _| state[FLAT[i].0][FLAT[i].1])
}

/// Axis and order of the derivative in each entry of a [`rotor_drag::State`] and, with the last four, of a
/// [`rotor_drag::CommandState`].
const ROTOR_DRAG: [(usize, usize); rotor_drag::COMMAND_INPUTS] = {
    let mut all = [(YAW, 3); rotor_drag::COMMAND_INPUTS];
    (all[0], all[1], all[2]) = ((X, 1), (Y, 1), (Z, 1));
    let mut i = 0;
    while i < COMMAND_INPUTS {
        all[3 + i] = COMMAND_DERIVATIVES[i];
        i += 1;
    }
    all
};

/// The entries of `state` on which the wrench depends where the drag is not isotropic.
fn rotor_drag_state<const N: usize, const M: usize>(state: &[[f64; N]; 4]) -> SVector<f64, M> {
    SVector::from_fn(|i, _| state[ROTOR_DRAG[i].0][ROTOR_DRAG[i].1])
}

/// The affine map of a value and its slopes with respect to the entries of a [`rotor_drag`] state.
fn tangent<const M: usize>(at: &SVector<f64, M>, value: Wrench, slope: &SMatrix<f64, 4, M>) -> WrenchMap {
    let columns = ROTOR_DRAG.iter().zip(slope.column_iter());
    let terms = columns.map(|(&(axis, order), c)| (axis, order, c.into_owned())).collect();
    WrenchMap { constant: value - slope * at, terms }
}

impl WrenchModel {
    /// The order of the derivative that is the input of each axis, linear between nodes.
    ///
    /// In the exact model the torques depend on z as well, so the thrust must be twice differentiable, and z is a
    /// quadruple integrator like x and y.
    pub fn orders(self) -> [usize; 4] {
        match self {
            WrenchModel::Exact => [4, 4, 4, 2],
            _ => hover_map::ORDER,
        }
    }

    /// The wrench that a motion needs at an instant, N and N m.
    pub fn wrench(self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> Wrench {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::with_free_yaw(vehicle, environment.gravity, psi).at(state),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, ..] = state[YAW];
                WrenchMap::new(vehicle, environment.gravity, YawState { psi, rate, acceleration }).at(state)
            }
            WrenchModel::Exact if !environment.is_isotropic() => {
                rotor_drag::wrench(vehicle, environment, &rotor_drag_state(state))
            }
            WrenchModel::Exact => flatness::wrench(vehicle, environment.gravity, &flat(&in_air(state, environment))),
        }
    }

    /// The linearisation of the wrench at a state s, as an affine function of a state s~: `w(s) + (dw/ds) (s~ - s)`.
    ///
    /// With [`WrenchModel::HoverFollowing`] psi, psi' and psi'' are fixed at their values in `state`; only
    /// `tau_z = Izz psi''` depends on the yaw of s~.
    pub fn linearised(self, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> WrenchMap {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::with_free_yaw(vehicle, environment.gravity, psi),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, ..] = state[YAW];
                let mut map = WrenchMap::new(vehicle, environment.gravity, YawState { psi, rate, acceleration });
                map.constant[3] = 0.0;
                map.terms.push((YAW, 2, Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2])));
                map
            }
            WrenchModel::Exact if !environment.is_isotropic() => {
                let at = rotor_drag_state(state);
                let (wrench, slope) = rotor_drag::wrench_and_jacobian(vehicle, environment, &at);
                tangent(&at, wrench, &slope)
            }
            WrenchModel::Exact => {
                let at = flat(&in_air(state, environment));
                let (wrench, slope) = flatness::wrench_and_jacobian(vehicle, environment.gravity, &at);
                let terms =
                    FLAT.iter().zip(slope.column_iter()).map(|(&(axis, order), c)| (axis, order, c.into_owned()));
                WrenchMap { constant: wrench - slope * at, terms: terms.collect() }.of_motion_in(environment)
            }
        }
    }

    /// The convex part of the curvature of n.w at a state s, as a sum of squares:
    /// `sum over factors of (factor.(s~ - s))^2 / 2`. The entries of a factor are in the order of [`DIRECTIONS`]; s and
    /// s~ are states [`in_air`]. Empty for the models about hover, which are linear.
    ///
    /// Eigenvectors of the Hessian are taken with accelerations in units of g and time in units of `tau` (s);
    /// eigenvalues at or below 1e-3 of the largest are dropped (`docs/method/exact-planner.md`, (73)).
    ///
    /// If the drag is not isotropic, the curvature is that of the wrench in the isotropic drag of
    /// [`Environment::turning_rate`]: it only shapes the subproblem's objective, whose steps are accepted by the exact
    /// wrench.
    pub fn curvature(
        self,
        vehicle: &Vehicle,
        environment: &Environment,
        state: &NodeState,
        n: &Wrench,
        tau: f64,
    ) -> Vec<FlatState> {
        if self != WrenchModel::Exact {
            return Vec::new();
        }
        let at = flat(&in_air(state, environment));
        let hessian = flatness::curvature(vehicle, environment.gravity, &at, n);
        let hessian = DMatrix::from_column_slice(INPUTS, INPUTS, hessian.as_slice());
        let factors = upward(&FLAT, hessian, environment.gravity, tau);
        factors.into_iter().map(|f| FlatState::from_column_slice(f.as_slice())).collect()
    }

    /// The commanded wrench `c = w + lag w'` (N and N m) for rotors with a first-order lag of time constant `lag` (s):
    /// (83) and (84).
    pub fn commanded(self, vehicle: &Vehicle, environment: &Environment, lag: f64, state: &CommandState) -> Wrench {
        match self {
            WrenchModel::Exact if !environment.is_isotropic() => {
                rotor_drag::commanded(vehicle, environment, lag, &rotor_drag_state(state))
            }
            WrenchModel::Exact => {
                flatness::commanded(vehicle, environment.gravity, lag, &command_flat(&in_air(state, environment)))
            }
            _ => self.commanded_linearised(vehicle, environment, lag, state).at(state),
        }
    }

    /// The linearisation of the commanded wrench at a state s, as an affine function of a state s~:
    /// `c(s) + (dc/ds) (s~ - s)`.
    pub fn commanded_linearised(
        self,
        vehicle: &Vehicle,
        environment: &Environment,
        lag: f64,
        state: &CommandState,
    ) -> WrenchMap {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::commanded_with_free_yaw(vehicle, environment.gravity, psi, lag),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, jerk, ..] = state[YAW];
                let mut map =
                    WrenchMap::commanded(vehicle, environment.gravity, YawState { psi, rate, acceleration }, jerk, lag);
                map.constant[3] = 0.0;
                let turn = Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2]);
                map.terms.extend([(YAW, 2, turn), (YAW, 3, lag * turn)]);
                map
            }
            WrenchModel::Exact if !environment.is_isotropic() => {
                let at = rotor_drag_state(state);
                let (commanded, slope) = rotor_drag::commanded_and_jacobian(vehicle, environment, lag, &at);
                tangent(&at, commanded, &slope)
            }
            WrenchModel::Exact => {
                let at = command_flat(&in_air(state, environment));
                let (commanded, slope) = flatness::commanded_and_jacobian(vehicle, environment.gravity, lag, &at);
                let columns = COMMAND_DERIVATIVES.iter().zip(slope.column_iter());
                let terms = columns.map(|(&(axis, order), c)| (axis, order, c.into_owned())).collect();
                WrenchMap { constant: commanded - slope * at, terms }.of_motion_in(environment)
            }
        }
    }

    /// The convex part of the curvature of n.c at a state s, as a sum of squares of `factor.(s~ - s)`, each halved. The
    /// entries of a factor are in the order of [`COMMAND_DERIVATIVES`]. Empty for the models about hover, which are
    /// linear.
    pub fn commanded_curvature(
        self,
        vehicle: &Vehicle,
        environment: &Environment,
        lag: f64,
        state: &CommandState,
        n: &Wrench,
        tau: f64,
    ) -> Vec<CommandFlatState> {
        if self != WrenchModel::Exact {
            return Vec::new();
        }
        let at = command_flat(&in_air(state, environment));
        let hessian = flatness::commanded_curvature(vehicle, environment.gravity, lag, &at, n);
        let hessian = DMatrix::from_column_slice(COMMAND_INPUTS, COMMAND_INPUTS, hessian.as_slice());
        let factors = upward(&COMMAND_DERIVATIVES, hessian, environment.gravity, tau);
        factors.into_iter().map(|f| CommandFlatState::from_column_slice(f.as_slice())).collect()
    }
}

/// Eigenvalues below this share of the largest are left out: they add directions to the program and hardly any
/// curvature.
const NEGLIGIBLE_CURVATURE: f64 = 1e-3;

/// The positive part of a Hessian as factors: eigenvectors times the square roots of their eigenvalues. `inputs` gives
/// axis and order of each row. Eigenvectors are taken with accelerations in units of g and time in units of `tau` (s).
/// Empty if the Hessian is not finite.
fn upward(inputs: &[(usize, usize)], hessian: DMatrix<f64>, gravity: f64, tau: f64) -> Vec<DVector<f64>> {
    let unit = |&(axis, order): &(usize, usize)| match axis {
        YAW => tau.powi(-(order as i32)),
        _ => gravity * tau.powi(2 - order as i32),
    };
    let scale = DVector::from_iterator(inputs.len(), inputs.iter().map(unit));
    let scaled = hessian.component_mul(&(&scale * scale.transpose()));
    if !scaled.iter().all(|v| v.is_finite()) {
        return Vec::new();
    }
    let eigen = scaled.symmetric_eigen();
    let most = eigen.eigenvalues.amax();
    let upward = eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter())
        .filter(|(l, _)| **l > NEGLIGIBLE_CURVATURE * most);
    upward.map(|(l, v)| v.component_div(&scale) * l.sqrt()).collect()
}
