//! What the controller sees: attitude as it is, body rates with white noise, position and velocity as an inertial
//! navigation gives them.
//!
//! The navigation integrates the true acceleration and is corrected by position samples with white noise through
//! fixed gains. The true motion falls out of its errors, e' = e_v - 2 zeta w (e - n), e_v' = -w^2 (e - n), so that
//! these are what is simulated: slow wanderings of a small part of the samples' noise.

use super::body::Body;
use crate::model::Simulation;
use nalgebra::Vector3;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// w and zeta of the navigation: rad/s, and none.
const BANDWIDTH: f64 = 2.0;
const DAMPING: f64 = std::f64::consts::FRAC_1_SQRT_2;

#[derive(Debug, Clone)]
pub struct Sensors {
    period: f64,
    rate_noise: f64,
    position_noise: f64,
    position_error: Vector3<f64>,
    velocity_error: Vector3<f64>,
}

impl Sensors {
    /// Samples `period` s apart.
    pub fn new(simulation: &Simulation, period: f64) -> Self {
        Sensors {
            period,
            rate_noise: simulation.gyroscope_noise,
            position_noise: simulation.position_noise,
            position_error: Vector3::zeros(),
            velocity_error: Vector3::zeros(),
        }
    }

    /// The body as it is measured now; the next call is a period later.
    pub fn measure(&mut self, body: &Body, random: &mut Pcg64Mcg) -> Body {
        let mut white = || Vector3::from_fn(|_, _| StandardNormal.sample(random));
        let mut measured = *body;
        if self.rate_noise > 0.0 {
            measured.rates += white() * self.rate_noise;
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
