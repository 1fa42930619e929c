//! Sets under interval uncertainty: the wrenches that can be given for every value (docs/method/verdicts.md, (50)).
//!
//! With thrusts from the largest idle to the least full one and every ratio kappa_k of drag torque to thrust in the
//! middle of its interval, a row `n.w <= e` becomes `n.w + |n_z| delta T <= e - sum over stuck k of |n.r_k|`: delta is
//! the largest half width of the intervals of kappa_k, and r_k is half the range of the wrench of stuck rotor k. If the
//! mass is M instead of m, the motion needs (M/m) T, so the coefficient on T is taken at the end of that interval that
//! is worst for the row; this requires T >= 0, which is a row of its own.

use super::{Exact, difference, scaled, wrench_at};
use crate::model::{FaultMode, Rotor, Vehicle};
use crate::verify::dyadic::{Dyadic, dot};
use crate::verify::interval::Interval;

/// Wrenches of one rotor, kappa in the middle of its interval.
pub(super) struct RotorWrenches {
    /// At the lowest speed, thrust at the upper end of its interval.
    pub idle: Exact,
    /// At full speed, thrust at the lower end.
    pub full: Exact,
    /// At full speed, thrust in the middle.
    pub middle: Exact,
}

fn half() -> Dyadic {
    Dyadic::of(0.5)
}

impl RotorWrenches {
    pub fn of(rotor: &Rotor) -> Self {
        let spread = rotor.spread;
        let [idle, low, high] =
            [spread.idle_thrust.high, spread.full_thrust.low, spread.full_thrust.high].map(Dyadic::of);
        let ratio = spread.torque_per_thrust;
        let ratio = Dyadic::of(ratio.low).plus(&Dyadic::of(ratio.high)).times(&half());
        let full = |thrust: &Dyadic| wrench_at(rotor, rotor.max_speed, thrust, &ratio);
        RotorWrenches {
            idle: wrench_at(rotor, rotor.min_speed, &idle, &ratio),
            full: full(&low),
            middle: full(&low.plus(&high).times(&half())),
        }
    }
}

/// The quantities by which a set shrinks; see the module.
#[derive(Debug, Clone)]
pub struct Uncertainty {
    /// delta, m
    ratio: Interval,
    /// r_k of each stuck rotor.
    stuck: Vec<Exact>,
    /// Ends of the interval of M/m.
    mass: [f64; 2],
}

impl Uncertainty {
    pub(super) fn of(vehicle: &Vehicle, mode: Option<&FaultMode>) -> Self {
        let mut ratio = Interval::ZERO;
        let mut stuck = Vec::new();
        for (k, rotor) in vehicle.rotors.iter().enumerate() {
            let spread = rotor.spread.torque_per_thrust;
            let width = (Interval::point(spread.high) - Interval::point(spread.low)) * Interval::point(0.5);
            let kappa = Interval::point(rotor.drag_coefficient) / Interval::point(rotor.thrust_coefficient);
            let delta = width * kappa;
            if delta.high > ratio.high {
                ratio = delta;
            }
            if let Some(share) = mode.and_then(|mode| mode.rotors[k].stuck_at()) {
                let known = RotorWrenches::of(rotor);
                stuck.push(scaled(&difference(&known.middle, &known.full), share));
            }
        }
        Uncertainty { ratio, stuck, mass: [vehicle.mass_spread.low, vehicle.mass_spread.high] }
    }

    /// The row `n.w <= e` such that it holds for every value.
    pub(super) fn row(&self, normal: &Exact, offset: &Dyadic) -> ([Interval; 4], Interval) {
        let mut row = normal.each_ref().map(Dyadic::enclosure);
        row[0] = row[0] + row[3].abs() * self.ratio;
        let [light, heavy] = self.mass.map(|share| row[0] * Interval::point(share));
        row[0] = Interval::new(light.low.max(heavy.low), light.high.max(heavy.high));
        let taken = super::absolute(self.stuck.iter().map(|r| dot(normal, r)));
        (row, offset.minus(&taken).enclosure())
    }
}
