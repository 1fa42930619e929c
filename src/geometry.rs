//! Pure mathematics of small polytopes: zonotopes, half-space descriptions, nearest points; and eigenvalues.
//! Nothing here knows a vehicle.

mod cone;
mod least_squares;
pub mod nearest;
pub mod polytope;
pub mod symmetric;
pub mod volume;
pub mod zonotope;
