//! Dimensions, units and quantities.
//!
//! A [`Dimension`] is a product of powers of mass, length, time and angle. Angle is a dimension, so that
//! degrees, radians and turns cannot be mistaken for plain numbers; it is dropped when a value is
//! converted to SI units. A [`Unit`] is a scale and a dimension; a [`Quantity`] is a value in SI units and a
//! dimension. The function [`mismatch()`] compares two dimensions factor by factor.
mod dimension;
mod mismatch;
mod quantity;
mod table;

pub use dimension::{Base, Dimension, Exponent};
pub use mismatch::{Mismatch, compare, mismatch};
pub use quantity::Quantity;
pub use table::{Unit, UnitError, parse_unit, unit_names};

/// Default gravity of the language, m/s^2, used unless a spec sets `gravity`.
pub const GRAVITY: f64 = 9.81;
