//! Numbers with a dimension.

use super::{Dimension, Exponent, Unit};

/// A value in SI units (angle in radians) and its dimension.
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

    /// `number` times `unit`; rounded only once if the unit's scale or its reciprocal is a whole number.
    pub fn with_unit(number: f64, unit: Unit) -> Self {
        Quantity { value: number * unit.numerator / unit.denominator, dimension: unit.dimension }
    }

    pub fn negated(self) -> Self {
        Quantity { value: -self.value, ..self }
    }

    /// The sum; `None` if the dimensions differ.
    pub fn plus(self, other: Self) -> Option<Self> {
        (self.dimension == other.dimension).then_some(Quantity { value: self.value + other.value, ..self })
    }

    /// The product; `None` if an exponent exceeds the limit.
    pub fn times(self, other: Self) -> Option<Self> {
        Some(Quantity::new(self.value * other.value, self.dimension.times(other.dimension)?))
    }

    /// The quotient; `None` if an exponent exceeds the limit. Division by zero gives an infinite value or NaN.
    pub fn over(self, other: Self) -> Option<Self> {
        Some(Quantity::new(self.value / other.value, self.dimension.over(other.dimension)?))
    }

    /// The power; `None` if the dimension cannot be raised to that exponent.
    pub fn power(self, exponent: f64) -> Option<Self> {
        let dimension = if self.dimension.is_plain() {
            Dimension::PLAIN
        } else {
            self.dimension.power(Exponent::from_f64(exponent)?)?
        };
        Some(Quantity::new(self.value.powf(exponent), dimension))
    }
}
