//! Values known only to an interval.

use super::Vehicle;

/// The smallest and largest possible value, as multiples of the middle: 0 < low <= 1 <= high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    pub low: f64,
    pub high: f64,
}

impl Spread {
    /// The value is known exactly.
    pub const NONE: Spread = Spread { low: 1.0, high: 1.0 };

    pub fn is_none(self) -> bool {
        self == Spread::NONE
    }

    /// The spread of a product.
    pub fn times(self, other: Spread) -> Spread {
        Spread { low: self.low * other.low, high: self.high * other.high }
    }

    /// The spread of a quotient of two independent values.
    pub fn over(self, other: Spread) -> Spread {
        Spread { low: self.low / other.high, high: self.high / other.low }
    }
}

impl Default for Spread {
    fn default() -> Self {
        Spread::NONE
    }
}

/// The spreads that follow from the intervals on a rotor's coefficients and speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotorSpread {
    /// Spread of b w_max^2.
    pub full_thrust: Spread,
    /// Spread of b w_min^2.
    pub idle_thrust: Spread,
    /// Spread of d/b.
    pub torque_per_thrust: Spread,
}

impl Vehicle {
    /// Whether the mass or some rotor has an interval.
    pub fn is_uncertain(&self) -> bool {
        !self.mass_spread.is_none() || self.has_uncertain_rotors()
    }

    /// Whether some rotor has an interval.
    pub fn has_uncertain_rotors(&self) -> bool {
        self.rotors.iter().any(|r| r.spread != RotorSpread::default())
    }
}
