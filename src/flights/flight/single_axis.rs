//! Control of the thrust's direction of a vehicle that produces torques about one axis of its body only, and spins: a
//! quadcopter that has lost two opposite rotors.
//!
//! A torque that is missing about the other axis cannot be demanded, so the law for torques in every direction does not
//! hold here. As in M. W. Mueller, R. D'Andrea (ICRA 2014), the motion is linearised about the spin, where it does not
//! depend on time in body axes, and controlled by a linear-quadratic regulator.

use nalgebra::{Matrix4, Matrix5, RowVector4, Vector2, Vector3, Vector4};

/// Step of the regulator's discretisation, s, and doublings of its horizon: 2^12 steps are 8 s.
const STEP: f64 = 0.002;
const DOUBLINGS: usize = 12;

/// The torque is limited to this share of what the thrust of hover leaves.
const USED: f64 = 0.9;

/// Distance of the rates for which gains are computed, rad/s, and how many there are on either side of 0.
const APART: f64 = 2.0;
const RATES: usize = 60;

/// The axis of the body about which torques are left, with the regulator's gains.
#[derive(Debug, Clone, PartialEq)]
pub struct SingleAxis {
    /// Its direction across z, of length one.
    axis: Vector2<f64>,
    /// The largest torque both ways at the thrust of hover, N m.
    reach: f64,
    /// K for rates from `-RATES * APART` on.
    gains: Vec<RowVector4<f64>>,
}

impl SingleAxis {
    /// The regulator for torques up to `reach` (N m) about `axis`. `attitude` is the gain on deviations in roll and
    /// pitch, 1/s^2.
    pub fn new(axis: Vector2<f64>, reach: f64, inertia: &Vector3<f64>, attitude: f64) -> Self {
        let effort = (4.0 * inertia.xy().min() * attitude).powi(-2);
        let at = |k: usize| {
            let (a, b) = linearised(&axis, inertia, 0.0, (k as f64 - RATES as f64) * APART);
            regulator(&a, &b, effort)
        };
        SingleAxis { axis, reach, gains: (0..=2 * RATES).map(at).collect() }
    }

    /// The roll and pitch torque (N m) for the direction d of the thrust, given in body axes, at body rates w (rad/s)
    /// and the momentum h of the rotors about z (N m s). With x = (p, q, d_x, d_y):
    ///
    /// ```text
    /// x' = A x + B u     p' = ((Jy - Jz) r - h) q / Jx + b_x u / Jx     d_x' = -q + r d_y
    ///                    q' = ((Jz - Jx) r + h) p / Jy + b_y u / Jy     d_y' =  p - r d_x
    /// u = -K x           K minimises the integral of d_x^2 + d_y^2 + (u / (4 J k_R))^2
    /// ```
    ///
    /// with the smaller moment of inertia J and the gain k_R on the attitude, for h = 0; and `u + lag u'` is commanded,
    /// because rotors follow with a lag (s).
    pub fn torque(
        &self,
        inertia: &Vector3<f64>,
        momentum: f64,
        w: &Vector3<f64>,
        d: &Vector3<f64>,
        lag: f64,
    ) -> Vector2<f64> {
        let (a, b) = linearised(&self.axis, inertia, momentum, w.z);
        let gain = self.gain(w.z);
        let x = Vector4::new(w.x, w.y, d.x, d.y);
        let most = USED * self.reach;
        let u = -(gain * x)[0];
        let rate = -(gain * (a * x + b * u.clamp(-most, most)))[0];
        self.axis * (u + lag * rate).clamp(-most, most)
    }

    /// K at a rate r (rad/s), linear between those computed.
    fn gain(&self, r: f64) -> RowVector4<f64> {
        let at = (r / APART + RATES as f64).clamp(0.0, 2.0 * RATES as f64 - 1e-9);
        let (k, share) = (at as usize, at.fract());
        self.gains[k] * (1.0 - share) + self.gains[k + 1] * share
    }
}

/// A and B of [`SingleAxis::torque`] at a rate r, rad/s.
fn linearised(axis: &Vector2<f64>, inertia: &Vector3<f64>, momentum: f64, r: f64) -> (Matrix4<f64>, Vector4<f64>) {
    let by_q = ((inertia.y - inertia.z) * r - momentum) / inertia.x;
    let by_p = ((inertia.z - inertia.x) * r + momentum) / inertia.y;
    #[rustfmt::skip]
    let a = Matrix4::new(
        0.0,  by_q, 0.0, 0.0,
        by_p, 0.0,  0.0, 0.0,
        0.0,  -1.0, 0.0, r,
        1.0,  0.0,  -r,  0.0,
    );
    (a, Vector4::new(axis.x / inertia.x, axis.y / inertia.y, 0.0, 0.0))
}

/// The gain K of the regulator with the weights (0, 0, 1, 1) on x and `effort` on u^2, over a horizon of
/// 2^[`DOUBLINGS`] steps, by the doubling algorithm for the discrete Riccati equation (B. D. O. Anderson, *Second-order
/// convergent algorithms for the steady-state Riccati equation*, International Journal of Control 28:2, 1978).
fn regulator(a: &Matrix4<f64>, b: &Vector4<f64>, effort: f64) -> RowVector4<f64> {
    let mut held = Matrix5::zeros();
    held.fixed_view_mut::<4, 4>(0, 0).copy_from(a);
    held.fixed_view_mut::<4, 1>(0, 4).copy_from(b);
    let held = (held * STEP).exp();
    let (a, b) = (held.fixed_view::<4, 4>(0, 0).into_owned(), held.fixed_view::<4, 1>(0, 4).into_owned());
    let weight = Matrix4::from_diagonal(&Vector4::new(0.0, 0.0, STEP, STEP));
    let effort = effort * STEP;
    let (mut phi, mut g, mut cost) = (a, b * b.transpose() / effort, weight);
    for _ in 0..DOUBLINGS {
        let Some(inverse) = (Matrix4::identity() + g * cost).try_inverse() else { break };
        let carried = inverse * g;
        let next = cost + phi.transpose() * cost * inverse * phi;
        g += phi * carried * phi.transpose();
        phi = phi * inverse * phi;
        cost = next;
    }
    let by_torque = b.transpose() * cost;
    by_torque * a / (effort + (by_torque * b)[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed loop decays at every spin from 10 rad/s on, also between the rates of the table, and with the lag
    /// that the command undoes.
    #[test]
    fn a_spinning_body_is_stable_with_one_axis() {
        let inertia = Vector3::new(0.0128, 0.0128, 0.0239);
        let single = SingleAxis::new(Vector2::new(0.6, 0.8), 1.0, &inertia, 100.0);
        for r in [10.0, 33.3, 75.1, -51.0] {
            let (a, b) = linearised(&single.axis, &inertia, 0.0, r);
            let slowest = |matrix: &Matrix4<f64>| {
                matrix.complex_eigenvalues().iter().map(|e| e.re).fold(f64::NEG_INFINITY, f64::max)
            };
            let gain = single.gain(r);
            assert!(slowest(&(a - b * gain)) < -0.5, "{r}: {}", slowest(&(a - b * gain)));
            // u follows the command u_c = -K x + lag (-K x)' as u' = (u_c - u)/lag.
            let lag = 0.02;
            let mut lagging = Matrix5::zeros();
            lagging.fixed_view_mut::<4, 4>(0, 0).copy_from(&a);
            lagging.fixed_view_mut::<4, 1>(0, 4).copy_from(&b);
            let command = -(gain + gain * (a - b * gain) * lag);
            lagging.fixed_view_mut::<1, 4>(4, 0).copy_from(&(command / lag));
            lagging[(4, 4)] = -1.0 / lag;
            let slowest = lagging.complex_eigenvalues().iter().map(|e| e.re).fold(f64::NEG_INFINITY, f64::max);
            assert!(slowest < -0.3, "{r} with lag: {slowest}");
        }
    }
}
