//! The measurements that the controller receives: the attitude, true or estimated, body rates with white noise, and
//! position and velocity from an inertial navigation (`docs/flight.md`, section 1, "Sensors").
//!
//! An estimated attitude is the integral of the measured rates, and its error is corrected at a fixed rate, as by an
//! accelerometer and a compass without errors of their own. So it is off where rates are beyond the gyroscope's range.
//!
//! The navigation integrates the true acceleration and is corrected with fixed gains by position samples with white
//! noise n. Its errors e and e_v satisfy e' = e_v - 2 zeta w (e - n) and e_v' = -w^2 (e - n), in which the true motion
//! cancels. Only these errors are simulated; they vary slowly and contain a small part of the samples' noise.

use super::body::Body;
use crate::model::{Attitude, Simulation};
use nalgebra::{UnitQuaternion, Vector3};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// w of the navigation filter, rad/s.
const BANDWIDTH: f64 = 2.0;
/// zeta of the navigation filter.
const DAMPING: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Rate at which the error of an estimated attitude is corrected, 1/s.
const CORRECTED: f64 = 0.5;

/// The state of the sensors during a flight.
#[derive(Debug, Clone)]
pub(super) struct Sensors {
    period: f64,
    rate_noise: f64,
    /// Largest rate on each axis that is measured, rad/s.
    range: f64,
    /// For how long some rate has been beyond the range, s.
    pub(super) saturated: f64,
    /// Whether the attitude is estimated, and the estimate with the rates that were measured last.
    is_estimated: bool,
    estimate: Option<(UnitQuaternion<f64>, Vector3<f64>)>,
    position_noise: f64,
    position_error: Vector3<f64>,
    velocity_error: Vector3<f64>,
}

impl Sensors {
    /// Sensors with samples `period` s apart.
    pub(super) fn new(simulation: &Simulation, period: f64) -> Self {
        Sensors {
            period,
            rate_noise: simulation.gyroscope_noise,
            range: simulation.gyroscope_range,
            saturated: 0.0,
            is_estimated: simulation.attitude == Attitude::Estimated,
            estimate: None,
            position_noise: simulation.position_noise,
            position_error: Vector3::zeros(),
            velocity_error: Vector3::zeros(),
        }
    }

    /// The measured state of the body. Each call advances the errors by a period.
    pub(super) fn measure(&mut self, body: &Body, random: &mut Pcg64Mcg) -> Body {
        let mut white = || Vector3::from_fn(|_, _| StandardNormal.sample(random));
        let mut measured = *body;
        if self.rate_noise > 0.0 {
            measured.rates += white() * self.rate_noise;
        }
        if measured.rates.amax() > self.range {
            measured.rates = measured.rates.map(|rate| rate.clamp(-self.range, self.range));
            self.saturated += self.period;
        }
        if self.is_estimated {
            measured.attitude = self.estimate(body, measured.rates).into_inner();
        }
        if self.position_noise > 0.0 {
            let difference = self.position_error - white() * self.position_noise;
            self.position_error += (self.velocity_error - difference * (2.0 * DAMPING * BANDWIDTH)) * self.period;
            self.velocity_error -= difference * (BANDWIDTH * BANDWIDTH * self.period);
            measured.position += self.position_error;
            measured.velocity += self.velocity_error;
        }
        measured
    }

    /// The next estimate of the attitude, from the rates measured now (rad/s); at the start it is the true one.
    fn estimate(&mut self, body: &Body, rates: Vector3<f64>) -> UnitQuaternion<f64> {
        let truth = body.rotation();
        let (mut estimate, last) = self.estimate.unwrap_or((truth, rates));
        if self.estimate.is_some() {
            estimate *= UnitQuaternion::from_scaled_axis((last + rates) * (0.5 * self.period));
            let error = (estimate.inverse() * truth).scaled_axis();
            estimate *= UnitQuaternion::from_scaled_axis(error * (CORRECTED * self.period));
        }
        self.estimate = Some((estimate, rates));
        estimate
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_pcg::rand_core::SeedableRng;

    /// A spin r beyond the range R: the error e of the estimate follows e' = (r - R) - e/2, and ends at 2 (r - R).
    #[test]
    fn the_estimate_lags_behind_a_spin_beyond_the_range() {
        let simulation = Simulation {
            attitude: Attitude::Estimated,
            gyroscope_noise: 0.0,
            position_noise: 0.0,
            gyroscope_range: 10.0,
            ..Simulation::default()
        };
        let (period, rate) = (0.002, 10.4);
        let mut sensors = Sensors::new(&simulation, period);
        let mut random = Pcg64Mcg::seed_from_u64(1);
        let mut body = Body::at_rest(Vector3::zeros(), 0.0);
        body.rates.z = rate;
        for k in 0..=5000 {
            let t = f64::from(k) * period;
            body.attitude = UnitQuaternion::from_euler_angles(0.0, 0.0, rate * t).into_inner();
            let estimate = sensors.measure(&body, &mut random).rotation();
            let error = (estimate.inverse() * body.rotation()).scaled_axis().z;
            let expected = 0.8 * (1.0 - (-0.5 * t).exp());
            assert!((error - expected).abs() < 0.002, "{t}: {error} {expected}");
        }
        assert!((sensors.saturated - 5001.0 * period).abs() < 1e-9);
    }
}
