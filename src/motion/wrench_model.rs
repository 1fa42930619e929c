//! Which wrench a motion asks for: by the paper's model about hover, or exactly.

use super::hover_map::{self, WrenchMap, YawState};
use super::{CommandState, NodeState, X, Y, YAW, Z};
use crate::actuation::Wrench;
use crate::flatness::{self, COMMAND_INPUTS, CommandFlatState, FlatState, INPUTS};
use crate::model::Vehicle;
use nalgebra::{DMatrix, DVector};

/// The model that a plan is made in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WrenchModel {
    /// Linear about hover at one yaw psi (rad), which is planned with the rest.
    HoverAt(f64),
    /// Linear in the derivatives of x, y and z, about hover at the planned yaw of each instant.
    HoverFollowing,
    /// Differential flatness of (3) to (9): no small angles.
    Exact,
}

/// Axis and derivative of each entry of a flat state.
const FLAT: [(usize, usize); INPUTS] =
    [(X, 2), (Y, 2), (Z, 2), (X, 3), (Y, 3), (Z, 3), (X, 4), (Y, 4), (Z, 4), (YAW, 0), (YAW, 1), (YAW, 2)];

/// Axis and derivative of each entry of a flat state with the slopes of the inputs.
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

fn command_flat(state: &CommandState) -> CommandFlatState {
    CommandFlatState::from_fn(|i, _| state[COMMAND_DERIVATIVES[i].0][COMMAND_DERIVATIVES[i].1])
}

/// Axis and derivative of each direction in which the wrench may curve.
pub const DIRECTIONS: [(usize, usize); INPUTS] = FLAT;

fn flat(state: &NodeState) -> FlatState {
    FlatState::from_fn(|i, _| state[FLAT[i].0][FLAT[i].1])
}

impl WrenchModel {
    /// The derivative of each axis that is its input, piecewise linear in time: where torques follow exactly from
    /// z as well, thrust must be twice differentiable, and z is a quadruple integrator like x and y.
    pub fn orders(self) -> [usize; 4] {
        match self {
            WrenchModel::Exact => [4, 4, 4, 2],
            _ => hover_map::ORDER,
        }
    }

    /// The wrench that a motion asks for at an instant, N and N m.
    pub fn wrench(self, vehicle: &Vehicle, gravity: f64, state: &NodeState) -> Wrench {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::with_free_yaw(vehicle, gravity, psi).at(state),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, ..] = state[YAW];
                WrenchMap::new(vehicle, gravity, YawState { psi, rate, acceleration }).at(state)
            }
            WrenchModel::Exact => flatness::wrench(vehicle, gravity, &flat(state)),
        }
    }

    /// The wrench about a state, to first order: w(s) + dw/ds (s' - s).
    ///
    /// Where the hover model follows yaw, psi and its derivatives are taken as they are in `state`.
    pub fn linearised(self, vehicle: &Vehicle, gravity: f64, state: &NodeState) -> WrenchMap {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::with_free_yaw(vehicle, gravity, psi),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, ..] = state[YAW];
                let mut map = WrenchMap::new(vehicle, gravity, YawState { psi, rate, acceleration });
                map.constant[3] = 0.0;
                map.terms.push((YAW, 2, Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2])));
                map
            }
            WrenchModel::Exact => {
                let at = flat(state);
                let (wrench, slope) = flatness::wrench_and_jacobian(vehicle, gravity, &at);
                let terms =
                    FLAT.iter().zip(slope.column_iter()).map(|(&(axis, order), c)| (axis, order, c.into_owned()));
                WrenchMap { constant: wrench - slope * at, terms: terms.collect() }
            }
        }
    }

    /// The part of n.w that curves upwards about a state, as squares: sum of |factor . (s' - s)|^2 / 2 over the factors, each
    /// over [`DIRECTIONS`]. Eigenvectors are taken with accelerations in units of g and time in units of `tau`, s.
    pub fn curvature(self, vehicle: &Vehicle, gravity: f64, state: &NodeState, n: &Wrench, tau: f64) -> Vec<FlatState> {
        if self != WrenchModel::Exact {
            return Vec::new();
        }
        let hessian = flatness::curvature(vehicle, gravity, &flat(state), n);
        let factors = upward(&FLAT, DMatrix::from_column_slice(INPUTS, INPUTS, hessian.as_slice()), gravity, tau);
        factors.into_iter().map(|f| FlatState::from_column_slice(f.as_slice())).collect()
    }

    /// The lead wrench c = w + lag w' of rotors that lag by `lag` s, N and N m.
    pub fn commanded(self, vehicle: &Vehicle, gravity: f64, lag: f64, state: &CommandState) -> Wrench {
        match self {
            WrenchModel::Exact => flatness::commanded(vehicle, gravity, lag, &command_flat(state)),
            _ => self.commanded_linearised(vehicle, gravity, lag, state).at(state),
        }
    }

    /// The lead wrench about a state, to first order, as in [`Self::linearised`].
    pub fn commanded_linearised(self, vehicle: &Vehicle, gravity: f64, lag: f64, state: &CommandState) -> WrenchMap {
        match self {
            WrenchModel::HoverAt(psi) => WrenchMap::commanded_with_free_yaw(vehicle, gravity, psi, lag),
            WrenchModel::HoverFollowing => {
                let [psi, rate, acceleration, jerk, ..] = state[YAW];
                let mut map = WrenchMap::commanded(vehicle, gravity, YawState { psi, rate, acceleration }, jerk, lag);
                map.constant[3] = 0.0;
                let turn = Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2]);
                map.terms.extend([(YAW, 2, turn), (YAW, 3, lag * turn)]);
                map
            }
            WrenchModel::Exact => {
                let at = command_flat(state);
                let (lead, slope) = flatness::commanded_and_jacobian(vehicle, gravity, lag, &at);
                let columns = COMMAND_DERIVATIVES.iter().zip(slope.column_iter());
                let terms = columns.map(|(&(axis, order), c)| (axis, order, c.into_owned())).collect();
                WrenchMap { constant: lead - slope * at, terms }
            }
        }
    }

    /// [`Self::curvature`] of n.c, over [`COMMAND_DERIVATIVES`].
    pub fn commanded_curvature(
        self,
        vehicle: &Vehicle,
        gravity: f64,
        lag: f64,
        state: &CommandState,
        n: &Wrench,
        tau: f64,
    ) -> Vec<CommandFlatState> {
        if self != WrenchModel::Exact {
            return Vec::new();
        }
        let hessian = flatness::commanded_curvature(vehicle, gravity, lag, &command_flat(state), n);
        let hessian = DMatrix::from_column_slice(COMMAND_INPUTS, COMMAND_INPUTS, hessian.as_slice());
        let factors = upward(&COMMAND_DERIVATIVES, hessian, gravity, tau);
        factors.into_iter().map(|f| CommandFlatState::from_column_slice(f.as_slice())).collect()
    }
}

/// The positive part of a Hessian over derivatives (axis, order) as squares: eigenvectors times the roots of their
/// eigenvalues, taken with accelerations in units of g and time in units of `tau`, s.
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
    let upward = eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()).filter(|(l, _)| **l > 1e-3 * most);
    upward.map(|(l, v)| v.component_div(&scale) * l.sqrt()).collect()
}
