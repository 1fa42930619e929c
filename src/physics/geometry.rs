//! Small polytopes in fixed dimension: zonotopes, half-space descriptions, nearest points, volumes; and eigenvalues of
//! symmetric matrices.
//!
//! This module is independent of vehicles and units: `D` is the dimension (4 for wrenches, 3 for yaw-free wrenches),
//! and lengths are in whatever units the caller uses. `docs/method/sets.md` and `verdicts.md` describe the
//! method.

mod cone;
mod least_squares;
mod nearest;
pub mod polytope;
pub(crate) mod symmetric;
mod volume;
pub mod zonotope;
