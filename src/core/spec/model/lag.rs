//! The first-order lag of rotors in plans.

use super::{Model, PlanRotors, Rotor};

/// Plans assume that rotors turn at this share of their full speed or faster; the lag of the thrust is bounded there.
/// Slower rotors give less than a ninth of their full thrust.
pub const SLOWEST_SHARE: f64 = 1.0 / 3.0;

impl Rotor {
    /// Time constant of the first-order lag of the thrust in plans, s, (87) of docs/method/rotor-lag.md:
    /// `time_constant` (1 + s)/(2 s), where s is the slowest share of the full speed considered. At speeds from that
    /// share upwards, a thrust f with f + tau f' between idle and full thrust is one that the lag of the speed allows.
    pub fn thrust_lag(&self) -> f64 {
        let spread = self.spread;
        let idle = self.idle_thrust() * spread.idle_thrust.low / (self.max_thrust() * spread.full_thrust.high);
        let slowest = idle.sqrt().max(SLOWEST_SHARE);
        self.lag() * (1.0 + slowest) / (2.0 * slowest)
    }
}

impl Model {
    /// Time constant tau with which thrusts follow their commands in plans, f_c = f + tau f', in seconds: the largest
    /// over the rotors. `None` where they follow instantly.
    pub fn thrust_lag(&self) -> Option<f64> {
        match self.plan.rotors {
            PlanRotors::Instant => None,
            PlanRotors::Lagging => self.vehicle.rotors.iter().map(Rotor::thrust_lag).max_by(f64::total_cmp),
        }
    }
}
