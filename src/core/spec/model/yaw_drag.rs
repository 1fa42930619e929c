//! The drag of a body that turns about its z axis, which ends the spin of a vehicle without control of yaw.

use super::Spread;

/// The torque of the air on a body that turns at r rad/s about its z axis: `-(linear r + quadratic r |r|)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YawDrag {
    /// N m s/rad; above zero.
    pub linear: f64,
    /// The interval of `linear`, relative to its middle.
    pub spread: Spread,
    /// N m s^2/rad^2; at least zero.
    pub quadratic: f64,
}

impl YawDrag {
    /// The rate (rad/s) at which a torque about z (N m) keeps the body turning: the solution r of
    /// `torque = linear r + quadratic r |r|`, for the middle of the interval.
    pub fn spin(&self, torque: f64) -> f64 {
        let YawDrag { linear, quadratic, .. } = *self;
        // The root of q r^2 + l r = |torque| in a form without cancellation, also for q = 0.
        let size = torque.abs();
        (2.0 * size / (linear + (linear * linear + 4.0 * quadratic * size).sqrt())).copysign(torque)
    }

    /// The torque (N m) that keeps the body turning at a rate (rad/s), for the middle of the interval.
    pub fn torque(&self, rate: f64) -> f64 {
        self.linear * rate + self.quadratic * rate * rate.abs()
    }

    /// The smallest and the largest drag of the interval, each without an interval.
    pub fn ends(&self) -> [YawDrag; 2] {
        let YawDrag { linear, spread, .. } = *self;
        [spread.low, spread.high].map(|share| YawDrag { linear: share * linear, spread: Spread::NONE, ..*self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spin_takes_the_torque() {
        for (linear, quadratic) in [(2.75e-3, 0.0), (1e-3, 1e-4), (1e-9, 2e-4)] {
            let drag = YawDrag { linear, spread: Spread { low: 0.8, high: 1.2 }, quadratic };
            for torque in [-0.2, 0.0, 1e-9, 0.3] {
                let back = drag.torque(drag.spin(torque));
                assert!((back - torque).abs() <= 1e-15 + 1e-12 * torque.abs(), "{torque} {back}");
            }
            assert!(drag.ends()[0].spin(0.2) > drag.spin(0.2) && drag.ends()[1].spin(0.2) < drag.spin(0.2));
        }
    }
}
