//! Which wrench a motion asks for: by the paper's model about hover, or exactly.

use super::hover_model::{self, WrenchMap, X, Y, YAW, YawState, Z};
use super::transcribe::NodeState;
use crate::actuation::Wrench;
use crate::flatness::{self, FlatState, INPUTS};
use crate::model::Vehicle;

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

/// Axis and derivative of each direction in which the wrench may curve.
pub(super) const DIRECTIONS: [(usize, usize); INPUTS] = FLAT;

fn flat(state: &NodeState) -> FlatState {
    FlatState::from_fn(|i, _| state[FLAT[i].0][FLAT[i].1])
}

impl WrenchModel {
    /// The derivative of each axis that is its input, piecewise linear in time: where torques follow exactly from
    /// z as well, thrust must be twice differentiable, and z is a quadruple integrator like x and y.
    pub fn orders(self) -> [usize; 4] {
        match self {
            WrenchModel::Exact => [4, 4, 4, 2],
            _ => hover_model::ORDER,
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
    pub(super) fn curvature(
        self,
        vehicle: &Vehicle,
        gravity: f64,
        state: &NodeState,
        n: &Wrench,
        tau: f64,
    ) -> Vec<FlatState> {
        if self != WrenchModel::Exact {
            return Vec::new();
        }
        let scale = FlatState::from_fn(|i, _| match FLAT[i] {
            (YAW, order) => tau.powi(-(order as i32)),
            (_, order) => gravity * tau.powi(2 - order as i32),
        });
        let hessian = flatness::curvature(vehicle, gravity, &flat(state), n);
        let scaled = hessian.component_mul(&(scale * scale.transpose()));
        if !scaled.iter().all(|v| v.is_finite()) {
            return Vec::new();
        }
        let eigen = scaled.symmetric_eigen();
        let most = eigen.eigenvalues.amax();
        let upward = eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()).filter(|(l, _)| **l > 1e-3 * most);
        upward.map(|(l, v)| v.component_div(&scale) * l.sqrt()).collect()
    }
}
