//! How a vehicle flies once its spin has settled, long after it has regained level flight.

use super::{DELAYS, ENDS, Hold, Outcome, SLOW, STRIKES};
use crate::model::{Detection, Model, Vehicle};

/// The spin has settled after this many time constants Jz/`yaw_drag`: 1 % of the way is left.
pub const SETTLES_IN: f64 = 5.0;
/// The longest flight, s. A vehicle that takes longer is judged by it all the same.
const LONGEST: f64 = 1200.0;
/// Without `yaw_drag` nothing ends a spin. A vehicle that does not spin shows it within this time, s.
const WITHOUT_DRAG: f64 = 60.0;
/// Level flight and rates are judged over this last part of a flight, s.
const LAST: f64 = 5.0;
/// The vehicle stays where it is while its distance from the reference is below this, m.
const NEAR: f64 = 2.0;

/// How the spin of a vehicle ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Settled {
    /// The largest rate on an axis of the body in the end, rad/s.
    rate: f64,
    /// Whether the vehicle is at its place in the end.
    is_level: bool,
}

/// How long the spin of a vehicle takes to settle, s; `None` without `yaw_drag`, which alone ends a spin.
pub fn settling_time(vehicle: &Vehicle) -> Option<f64> {
    vehicle.yaw_drag.map(|drag| SETTLES_IN * vehicle.inertia[2] / drag.linear)
}

impl Settled {
    /// The spin of a vehicle after a fault in hover that is known after the shortest delay.
    pub(super) fn of(model: &Model, vehicle: &Vehicle, mode: usize) -> Self {
        let lasts = settling_time(vehicle).unwrap_or(WITHOUT_DRAG).clamp(ENDS, LONGEST);
        let hold = Hold { model, vehicle, mode, speed: 0.0, ends: STRIKES + lasts };
        let (mut rate, mut away, mut speed) = (0.0_f64, 0.0_f64, f64::INFINITY);
        let flight = hold.seen(Detection::After(DELAYS[0]), model.simulation.seed, &mut |sample| {
            if sample.time > hold.ends - LAST {
                rate = rate.max(sample.body.rates.amax());
                away = away.max((sample.body.position - sample.reference.position).norm());
            }
            speed = sample.body.velocity.norm();
        });
        let is_level = flight.outcome == Outcome::Flown && away < NEAR && speed < SLOW;
        Settled { rate, is_level }
    }

    /// Whether the vehicle flies level within the range of a gyroscope, rad/s.
    pub(super) fn is_level_within(&self, range: f64) -> bool {
        self.is_level && self.rate <= range
    }

    /// The largest rate of several vehicles, rad/s; `None` if one does not fly level.
    pub(super) fn largest(all: &[Settled]) -> Option<f64> {
        all.iter().all(|one| one.is_level).then(|| all.iter().map(|one| one.rate).fold(0.0, f64::max))
    }
}
