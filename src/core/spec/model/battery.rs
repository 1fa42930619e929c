//! The battery: its energy, the charge to keep, and how full thrust falls with the charge.

use crate::source::Span;

/// A battery, and how much of its charge a plan should leave.
#[derive(Debug, Clone, PartialEq)]
pub struct Battery {
    /// Charge that the full battery gives until it is empty, A s.
    pub capacity: f64,
    /// Mean voltage meanwhile, V.
    pub voltage: f64,
    /// Electrical power of the whole vehicle in hover at its mass (`Vehicle::mass`), W.
    pub hover_power: f64,
    /// Share of the charge that a plan should leave, from 0 to below 1.
    pub keep: f64,
    /// Share of full thrust that remains with an empty battery, above 0 and at most 1.
    pub thrust_at_empty: f64,
    pub span: Span,
}

impl Battery {
    /// Energy of the full battery, J.
    pub fn energy(&self) -> f64 {
        self.capacity * self.voltage
    }

    /// Full thrust at a charge (0 to 1) as a share of full thrust with a full battery: a straight line to
    /// [`Battery::thrust_at_empty`].
    pub fn full_thrust(&self, charge: f64) -> f64 {
        self.thrust_at_empty + (1.0 - self.thrust_at_empty) * charge
    }

    /// The lowest full thrust of a plan that leaves [`Battery::keep`], as a share of that with a full battery. The
    /// rotors of a [`super::Vehicle`] have this full thrust, so sets, plans and flights use it.
    pub fn lowest_full_thrust(&self) -> f64 {
        self.full_thrust(self.keep)
    }
}
