//! The intermediate values between a flat state and its wrench, (60) to (67) of `docs/method/exact-model.md`, in the
//! same order.

use super::INPUTS;
use crate::model::Vehicle;
use nalgebra::SVector;
use num_dual::DualNum;

/// Sine, cosine and the first two time derivatives of an angle.
pub(super) struct Angles<D> {
    pub(super) sin: D,
    pub(super) cos: D,
    pub(super) rate: D,
    pub(super) acceleration: D,
}

/// The intermediate values of (60) to (66), SI units. A digit in a name is the number of time derivatives.
pub(super) struct Intermediates<D> {
    /// (60) to (62): the vector (x'', y'', z'' + g) in the frame that turns with psi (forward, left, up), and its
    /// derivatives.
    pub(super) f: D,
    pub(super) l: D,
    pub(super) v: D,
    pub(super) f1: D,
    pub(super) l1: D,
    pub(super) v1: D,
    pub(super) f2: D,
    pub(super) l2: D,
    pub(super) v2: D,
    /// Horizontal jerk (f3, l3 of (61)) and snap in that frame: forward, left.
    pub(super) jerk: [D; 2],
    pub(super) snap: [D; 2],
    /// Sine and cosine of psi, psi' and psi''.
    pub(super) turn: Angles<D>,
    /// (63): h = f^2 + v^2 = k^2.
    pub(super) h: D,
    pub(super) h1: D,
    pub(super) k: D,
    pub(super) k1: D,
    pub(super) k2: D,
    /// n = |(f, l, v)|, nn = n^2.
    pub(super) n: D,
    pub(super) nn: D,
    pub(super) nn1: D,
    /// (64): theta.
    pub(super) pitch: Angles<D>,
    /// (64): phi.
    pub(super) roll: Angles<D>,
    /// (65) and (66): p, q, r and their derivatives.
    pub(super) rates: [D; 3],
    pub(super) accelerations: [D; 3],
}

impl<D: DualNum<Primitive = f64> + Copy> Intermediates<D> {
    /// Evaluates (60) to (66).
    pub(super) fn new(gravity: f64, state: &SVector<D, INPUTS>) -> Self {
        let [x2, y2, z2, x3, y3, z3, x4, y4, z4, psi, psi1, psi2]: [D; INPUTS] = (*state).into();
        let (s, c) = psi.sin_cos();
        let two = D::from(2.0);
        // (60)
        let forward = |x: D, y: D| c * x + s * y;
        let left = |x: D, y: D| c * y - s * x;
        let (f, l, v) = (forward(x2, y2), left(x2, y2), z2 + D::from(gravity));
        let jerk = [forward(x3, y3), left(x3, y3)];
        let snap = [forward(x4, y4), left(x4, y4)];
        // (61): the frame turns, which adds terms in psi'.
        let (f1, l1, v1) = (jerk[0] + psi1 * l, jerk[1] - psi1 * f, z3);
        // (62)
        let f2 = snap[0] + two * psi1 * jerk[1] + psi2 * l - psi1 * psi1 * f;
        let l2 = snap[1] - two * psi1 * jerk[0] - psi2 * f - psi1 * psi1 * l;
        let v2 = z4;

        // (63)
        let h = f * f + v * v;
        let h1 = two * (f * f1 + v * v1);
        let h2 = two * (f1 * f1 + f * f2 + v1 * v1 + v * v2);
        let k = h.sqrt();
        let k1 = h1 / (two * k);
        let k2 = (h2 / two - k1 * k1) / k;
        let nn = h + l * l;
        let nn1 = h1 + two * l * l1;
        let n = nn.sqrt();

        // (64): theta = atan2(f, v), theta' = (f' v - f v') / h.
        let pitch_rate = (f1 * v - f * v1) / h;
        let pitch = Angles {
            sin: f / k,
            cos: v / k,
            rate: pitch_rate,
            acceleration: (f2 * v - f * v2) / h - pitch_rate * h1 / h,
        };
        // (64): phi = atan2(-l, k), phi' = (l k' - l' k) / n^2.
        let roll_rate = (l * k1 - l1 * k) / nn;
        let roll = Angles {
            sin: -l / n,
            cos: k / n,
            rate: roll_rate,
            acceleration: (l * k2 - l2 * k) / nn - roll_rate * nn1 / nn,
        };
        let (sin_phi, cos_phi, sin_theta, cos_theta) = (roll.sin, roll.cos, pitch.sin, pitch.cos);

        // (65)
        let p = roll.rate - psi1 * sin_theta;
        let q = pitch.rate * cos_phi + psi1 * sin_phi * cos_theta;
        let r = psi1 * cos_phi * cos_theta - pitch.rate * sin_phi;
        // (66)
        let p1 = roll.acceleration - psi2 * sin_theta - psi1 * cos_theta * pitch.rate;
        let q1 = pitch.acceleration * cos_phi - pitch.rate * roll.rate * sin_phi
            + psi2 * sin_phi * cos_theta
            + psi1 * (cos_phi * roll.rate * cos_theta - sin_phi * sin_theta * pitch.rate);
        let r1 = psi2 * cos_phi * cos_theta
            - psi1 * (sin_phi * roll.rate * cos_theta + cos_phi * sin_theta * pitch.rate)
            - pitch.acceleration * sin_phi
            - pitch.rate * roll.rate * cos_phi;
        let turn = Angles { sin: s, cos: c, rate: psi1, acceleration: psi2 };
        let (rates, accelerations) = ([p, q, r], [p1, q1, r1]);
        Intermediates {
            f,
            l,
            v,
            f1,
            l1,
            v1,
            f2,
            l2,
            v2,
            jerk,
            snap,
            turn,
            h,
            h1,
            k,
            k1,
            k2,
            n,
            nn,
            nn1,
            pitch,
            roll,
            rates,
            accelerations,
        }
    }

    /// (67): [T, tau_x, tau_y, tau_z] with T = m n and tau = J w' + w x J w.
    pub(super) fn wrench(&self, vehicle: &Vehicle) -> SVector<D, 4> {
        let [ixx, iyy, izz] = vehicle.inertia.map(D::from);
        let ([p, q, r], [p1, q1, r1]) = (self.rates, self.accelerations);
        SVector::from([
            self.n * D::from(vehicle.mass),
            ixx * p1 + (izz - iyy) * q * r,
            iyy * q1 + (ixx - izz) * r * p,
            izz * r1 + (iyy - ixx) * p * q,
        ])
    }
}
