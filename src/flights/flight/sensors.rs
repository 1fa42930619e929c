//! The measurements that the controller receives: the true attitude, body rates with white noise, and position and
//! velocity from an inertial navigation (`docs/flight.md`, section 1, "Sensors").
//!
//! The navigation integrates the true acceleration and is corrected with fixed gains by position samples with white
//! noise n. Its errors e and e_v satisfy e' = e_v - 2 zeta w (e - n) and e_v' = -w^2 (e - n), in which the true motion
//! cancels. Only these errors are simulated; they vary slowly and contain a small part of the samples' noise.

use super::body::Body;
use crate::model::Simulation;
use nalgebra::Vector3;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// w of the navigation filter, rad/s.
const BANDWIDTH: f64 = 2.0;
/// zeta of the navigation filter.
const DAMPING: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The state of the sensors during a flight.
#[derive(Debug, Clone)]
pub(super) struct Sensors {
    period: f64,
    rate_noise: f64,
    /// Largest rate on each axis that is measured, rad/s.
    range: f64,
    /// For how long some rate has been beyond the range, s.
    pub(super) saturated: f64,
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
        if self.position_noise > 0.0 {
            let difference = self.position_error - white() * self.position_noise;
            self.position_error += (self.velocity_error - difference * (2.0 * DAMPING * BANDWIDTH)) * self.period;
            self.velocity_error -= difference * (BANDWIDTH * BANDWIDTH * self.period);
            measured.position += self.position_error;
            measured.velocity += self.velocity_error;
        }
        measured
    }
}
