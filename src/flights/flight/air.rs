//! Wind: a constant mean and Dryden gusts (`docs/flight.md`, section 1).
//!
//! Gusts have the Dryden spectra of MIL-F-8785C, with one intensity sigma and one length L on all axes, as filters of
//! white noise:
//!
//! ```text
//! along the wind              sigma sqrt(2 tau) / (1 + tau s)
//! across it and vertically    sigma sqrt(tau) (1 + sqrt(3) tau s) / (1 + tau s)^2        tau = L/V
//! ```
//!
//! V is the sum of the speed of the mean wind and the mean speed of the mission, at least 1 m/s, and is constant during
//! a flight. The discretisation is exact: the state transition of the filters and the covariance of the noise in a step
//! have closed forms.

use nalgebra::{Matrix2, Vector2, Vector3};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// The torque of gusts on the body: a Gauss-Markov process about each axis, with the bandwidth of the rolling gusts of
/// MIL-F-8785C, pi V/(4 b) with the span b.
#[derive(Debug, Clone)]
pub struct TorqueGusts {
    sigma: f64,
    decay: f64,
    fresh: f64,
    state: Vector3<f64>,
}

impl TorqueGusts {
    /// Torques with the standard deviation `sigma` (N m) about each axis, for a vehicle with the span `span` (m) at the
    /// speed `speed` (m/s); `h` is the time between two calls of [`TorqueGusts::next`] (s).
    pub fn new(sigma: f64, span: f64, speed: f64, h: f64, random: &mut Pcg64Mcg) -> Self {
        let rate = std::f64::consts::PI * speed.max(1.0) / (4.0 * span);
        let decay = (-rate * h).exp();
        let state = if sigma > 0.0 { white(random) } else { Vector3::zeros() };
        TorqueGusts { sigma, decay, fresh: (1.0 - decay * decay).sqrt(), state }
    }

    /// The torque now, N m, in body axes. Each call advances the gusts by `h`.
    pub fn next(&mut self, random: &mut Pcg64Mcg) -> Vector3<f64> {
        if self.sigma == 0.0 {
            return Vector3::zeros();
        }
        let torque = self.state * self.sigma;
        self.state = self.state * self.decay + white(random) * self.fresh;
        torque
    }
}

fn white(random: &mut Pcg64Mcg) -> Vector3<f64> {
    Vector3::from_fn(|_, _| StandardNormal.sample(random))
}

/// The velocity of the air during a flight.
#[derive(Debug, Clone)]
pub struct Air {
    mean: Vector3<f64>,
    gusts: Option<Gusts>,
}

#[derive(Debug, Clone)]
struct Gusts {
    /// Unit vectors along the wind and across it, horizontal.
    along: Vector3<f64>,
    across: Vector3<f64>,
    sigma: f64,
    /// exp(-h/tau), and the factor of the noise that keeps the variance constant.
    decay: f64,
    fresh: f64,
    longitudinal: f64,
    /// The second-order filters: their state transition, and the Cholesky factor of the covariance of their noise.
    transition: Matrix2<f64>,
    noise: Matrix2<f64>,
    lateral: Vector2<f64>,
    vertical: Vector2<f64>,
}

impl Air {
    /// Air with the mean velocity `mean` (m/s, world frame), the gust intensity `sigma` (m/s), the gust length `length`
    /// (m) and the speed V `speed` (m/s); `h` is the time between two calls of [`Air::next`] (s). The initial gusts are
    /// drawn from their stationary distribution.
    pub fn new(mean: [f64; 3], sigma: f64, length: f64, speed: f64, h: f64, random: &mut Pcg64Mcg) -> Self {
        let mean = Vector3::from(mean);
        if sigma == 0.0 {
            return Air { mean, gusts: None };
        }
        let horizontal = Vector3::new(mean.x, mean.y, 0.0);
        let along = horizontal.try_normalize(1e-9).unwrap_or_else(Vector3::x);
        let across = Vector3::z().cross(&along);
        let tau = length / speed.max(1.0);
        let a = h / tau;
        let decay = (-a).exp();
        // In units of tau the filter is x1' = x2, x2' = -x1 - 2 x2 + w with white noise w of intensity 1. The step
        // needs exp(A a) and the covariance, the integral of exp(A s) b b' exp(A' s) ds from 0 to a.
        let transition = Matrix2::new(1.0 + a, a, -a, 1.0 - a) * decay;
        let e2 = decay * decay;
        // The closed form of the first entry cancels in short steps; its series is accurate there.
        let q11 = match a < 1e-3 {
            true => a.powi(3) * (1.0 / 3.0 - a * (0.5 - 0.4 * a)),
            false => 0.25 * (1.0 - e2 * (1.0 + 2.0 * a + 2.0 * a * a)),
        };
        let q12 = 0.5 * a * a * e2;
        let q22 = 0.25 * (1.0 - e2 * (1.0 - 2.0 * a + 2.0 * a * a));
        let (l11, l21) = (q11.sqrt(), q12 / q11.sqrt());
        let noise = Matrix2::new(l11, 0.0, l21, (q22 - l21 * l21).max(0.0).sqrt());
        let mut gusts = Gusts {
            along,
            across,
            sigma,
            decay,
            fresh: (1.0 - e2).sqrt(),
            longitudinal: 0.0,
            transition,
            noise,
            lateral: Vector2::zeros(),
            vertical: Vector2::zeros(),
        };
        // The flight begins in air that has always blown: both states have variance 1/4 and are independent.
        gusts.longitudinal = StandardNormal.sample(random);
        gusts.lateral = draw(random) * 0.5;
        gusts.vertical = draw(random) * 0.5;
        Air { mean, gusts: Some(gusts) }
    }

    /// Whether the air does not move at all.
    pub fn is_still(&self) -> bool {
        self.gusts.is_none() && self.mean == Vector3::zeros()
    }

    /// The velocity of the air now, m/s, world frame. Each call advances the gusts by `h`.
    pub fn next(&mut self, random: &mut Pcg64Mcg) -> Vector3<f64> {
        let Some(g) = &mut self.gusts else { return self.mean };
        // sigma sqrt(tau) (1 + sqrt(3) tau s): with intensity one per tau the output's variance is sigma^2.
        let output = |x: &Vector2<f64>| g.sigma * (x[0] + 3f64.sqrt() * x[1]);
        let air = self.mean
            + g.along * (g.sigma * g.longitudinal)
            + g.across * output(&g.lateral)
            + Vector3::z() * output(&g.vertical);
        let white: f64 = StandardNormal.sample(random);
        g.longitudinal = g.decay * g.longitudinal + g.fresh * white;
        g.lateral = g.transition * g.lateral + g.noise * draw(random);
        g.vertical = g.transition * g.vertical + g.noise * draw(random);
        air
    }
}

fn draw(random: &mut Pcg64Mcg) -> Vector2<f64> {
    Vector2::new(StandardNormal.sample(random), StandardNormal.sample(random))
}
