//! Dimensions, units and quantities.
//!
//! A [`Dimension`] is a product of powers of mass, length, time and angle. Angle counts, so that
//! degrees, radians and turns cannot be mistaken for plain numbers; it disappears when a value is
//! lowered to SI. A [`Unit`] is a scale and a dimension; a [`Quantity`] is a value in SI and a
//! dimension. The function `mismatch` tells two dimensions apart factor by factor.
mod dimension;
mod mismatch;
mod quantity;
mod table;

pub use dimension::{Base, Dimension, Exponent};
pub use mismatch::{Mismatch, compare, mismatch};
pub use quantity::Quantity;
pub use table::{Unit, UnitError, parse_unit, unit_names};

/// Standard gravity of the language, m/s^2, unless a spec says otherwise.
pub const GRAVITY: f64 = 9.81;
