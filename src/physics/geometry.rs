//! Small polytopes in fixed dimension: zonotopes, half-space descriptions, nearest points, volumes; and eigenvalues of
//! symmetric matrices.
//!
//! This module is independent of vehicles and units: `D` is the dimension (4 for wrenches, 3 for yaw-free wrenches),
//! and lengths are in whatever units the caller uses. The method is described in `docs/method.md`, sections 2 and 3.

mod cone;
mod least_squares;
mod nearest;
pub mod polytope;
pub(crate) mod symmetric;
mod volume;
pub mod zonotope;
