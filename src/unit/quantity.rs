//! Numbers with a dimension.

use super::{Dimension, Exponent, Unit};

/// A value in SI units (angle in radians) and what it measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    pub value: f64,
    pub dimension: Dimension,
}

impl Quantity {
    pub fn plain(value: f64) -> Self {
        Quantity { value, dimension: Dimension::PLAIN }
    }

    pub fn new(value: f64, dimension: Dimension) -> Self {
        Quantity { value, dimension }
    }

    /// `number` times `unit`, rounded once where the unit's scale is a whole number or its reciprocal.
    pub fn with_unit(number: f64, unit: Unit) -> Self {
        Quantity { value: number * unit.numerator / unit.denominator, dimension: unit.dimension }
    }

    pub fn negated(self) -> Self {
        Quantity { value: -self.value, ..self }
    }

    /// The sum; `None` where the dimensions differ.
    pub fn plus(self, other: Self) -> Option<Self> {
        (self.dimension == other.dimension).then_some(Quantity { value: self.value + other.value, ..self })
    }

    /// The product; `None` where an exponent passes the limit.
    pub fn times(self, other: Self) -> Option<Self> {
        Some(Quantity::new(self.value * other.value, self.dimension.times(other.dimension)?))
    }

    /// The quotient; `None` where an exponent passes the limit. Division by zero gives no finite value.
    pub fn over(self, other: Self) -> Option<Self> {
        Some(Quantity::new(self.value / other.value, self.dimension.over(other.dimension)?))
    }

    /// The power; `None` where the dimension cannot be raised to that exponent.
    pub fn power(self, exponent: f64) -> Option<Self> {
        let dimension = if self.dimension.is_plain() {
            Dimension::PLAIN
        } else {
            self.dimension.power(Exponent::from_f64(exponent)?)?
        };
        Some(Quantity::new(self.value.powf(exponent), dimension))
    }
}
