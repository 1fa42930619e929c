//! The gradient of n.w by reverse-mode differentiation (Griewank and Walther, *Evaluating Derivatives*, chapter 3).
//!
//! The lines of [`Intermediates`] are processed from the last to the first. `of_x` is the derivative of n.w with
//! respect to the intermediate value `x`; each line passes it on to the values from which `x` is computed.

use super::INPUTS;
use super::intermediates::Intermediates;
use crate::actuation::Wrench;
use crate::model::Vehicle;
use nalgebra::SVector;
use num_dual::DualNum;

impl<D: DualNum<Primitive = f64> + Copy> Intermediates<D> {
    /// The gradient of n.w with respect to the flat state s, in the order of [`super::FlatState`].
    pub(super) fn gradient(&self, vehicle: &Vehicle, n: &Wrench) -> SVector<D, INPUTS> {
        let Intermediates { f, l, v, f1, l1, v1, f2, l2, v2, h, h1, k, k1, k2, nn, nn1, .. } = *self;
        let two = D::from(2.0);
        let half = D::from(0.5);
        let (psi1, psi2) = (self.turn.rate, self.turn.acceleration);

        // (67): n.w as a function of n, the body rates and their derivatives.
        let [ixx, iyy, izz] = vehicle.inertia;
        let [p, q, r] = self.rates;
        let across = [(izz - iyy) * n[1], (ixx - izz) * n[2], (iyy - ixx) * n[3]].map(D::from);
        let of_p = across[1] * r + across[2] * q;
        let of_q = across[0] * r + across[2] * p;
        let of_r = across[0] * q + across[1] * p;
        let [of_p1, of_q1, of_r1] = [ixx * n[1], iyy * n[2], izz * n[3]].map(D::from);
        let of_n = D::from(vehicle.mass * n[0]);

        // (65) and (66): body rates as functions of roll, pitch, psi' and psi''.
        let (sin_phi, cos_phi, phi1, phi2) = (self.roll.sin, self.roll.cos, self.roll.rate, self.roll.acceleration);
        let (sin_theta, cos_theta, theta1) = (self.pitch.sin, self.pitch.cos, self.pitch.rate);
        let theta2 = self.pitch.acceleration;
        let of_phi2 = of_p1;
        let of_theta2 = of_q1 * cos_phi - of_r1 * sin_phi;
        let of_psi2 = of_q1 * sin_phi * cos_theta + of_r1 * cos_phi * cos_theta - of_p1 * sin_theta;
        let of_psi1 =
            of_q * sin_phi * cos_theta + of_r * cos_phi * cos_theta - of_p * sin_theta - of_p1 * cos_theta * theta1
                + of_q1 * (cos_phi * phi1 * cos_theta - sin_phi * sin_theta * theta1)
                - of_r1 * (sin_phi * phi1 * cos_theta + cos_phi * sin_theta * theta1);
        let of_phi1 = of_p + of_q1 * (psi1 * cos_phi * cos_theta - theta1 * sin_phi)
            - of_r1 * (psi1 * sin_phi * cos_theta + theta1 * cos_phi);
        let of_theta1 = of_q * cos_phi
            - of_r * sin_phi
            - of_p1 * psi1 * cos_theta
            - of_q1 * (phi1 * sin_phi + psi1 * sin_phi * sin_theta)
            - of_r1 * (psi1 * cos_phi * sin_theta + phi1 * cos_phi);
        let of_sin_phi = of_q * psi1 * cos_theta - of_r * theta1
            + of_q1 * (psi2 * cos_theta - psi1 * sin_theta * theta1 - theta1 * phi1)
            - of_r1 * (psi1 * phi1 * cos_theta + theta2);
        let of_cos_phi = of_q * theta1
            + of_r * psi1 * cos_theta
            + of_q1 * (theta2 + psi1 * phi1 * cos_theta)
            + of_r1 * (psi2 * cos_theta - psi1 * sin_theta * theta1 - theta1 * phi1);
        let of_sin_theta =
            -of_p * psi1 - of_p1 * psi2 - of_q1 * psi1 * sin_phi * theta1 - of_r1 * psi1 * cos_phi * theta1;
        let of_cos_theta = of_q * psi1 * sin_phi + of_r * psi1 * cos_phi - of_p1 * psi1 * theta1
            + of_q1 * (psi2 * sin_phi + psi1 * cos_phi * phi1)
            + of_r1 * (psi2 * cos_phi - psi1 * sin_phi * phi1);

        // (64): phi'' = (l k'' - l'' k - phi' nn') / nn, phi' = (l k' - l' k) / nn, sin phi = -l / n, cos phi = k / n.
        let share2 = of_phi2 / nn;
        let share1 = (of_phi1 - share2 * nn1) / nn;
        let of_l2 = -share2 * k;
        let of_nn1 = -share2 * phi1;
        let of_n = of_n - (of_sin_phi * sin_phi + of_cos_phi * cos_phi) / self.n;
        let of_nn = half * of_n / self.n - share2 * phi2 - share1 * phi1;
        let of_l1 = two * of_nn1 * l - share1 * k;
        let of_k2 = share2 * l;
        let mut of_l = share2 * k2 + share1 * k1 - of_sin_phi / self.n + two * (of_nn1 * l1 + of_nn * l);

        // (64): theta'' = (f'' v - f v'' - theta' h') / h, theta' = (f' v - f v') / h, sin theta = f / k, cos theta = v
        // / k.
        let turned2 = of_theta2 / h;
        let turned1 = (of_theta1 - turned2 * h1) / h;
        // (63): k'' = (h'' / 2 - k'^2) / k, k' = h' / (2 k), k = sqrt h.
        let of_h2 = half * of_k2 / k;
        let of_k1 = share1 * l - two * of_k2 * k1 / k;
        let of_h1 = of_nn1 - turned2 * theta1 + half * of_k1 / k;
        let of_k = of_cos_phi / self.n
            - share2 * l2
            - share1 * l1
            - (of_sin_theta * sin_theta + of_cos_theta * cos_theta + of_k2 * k2 + of_k1 * k1) / k;
        let of_h = of_nn - turned2 * theta2 - turned1 * theta1 + half * of_k / k;

        // (63): h'' / 2 = f'^2 + f f'' + v'^2 + v v'', h' / 2 = f f' + v v', h = f^2 + v^2.
        let of_f2 = turned2 * v + two * of_h2 * f;
        let of_v2 = two * of_h2 * v - turned2 * f;
        let of_f1 = turned1 * v + two * (two * of_h2 * f1 + of_h1 * f);
        let of_v1 = two * (two * of_h2 * v1 + of_h1 * v) - turned1 * f;
        let mut of_f = of_sin_theta / k - turned2 * v2 - turned1 * v1 + two * (of_h2 * f2 + of_h1 * f1 + of_h * f);
        let of_v = of_cos_theta / k + turned2 * f2 + turned1 * f1 + two * (of_h2 * v2 + of_h1 * v1 + of_h * v);

        // (62), (61) and (60): the frame turns with psi.
        let [jerk_f, jerk_l] = self.jerk;
        let [snap_f, snap_l] = self.snap;
        let of_jerk_f = of_f1 - two * psi1 * of_l2;
        let of_jerk_l = of_l1 + two * psi1 * of_f2;
        let of_psi2 = of_psi2 + of_f2 * l - of_l2 * f;
        let of_psi1 =
            of_psi1 + of_f1 * l - of_l1 * f + two * (of_f2 * (jerk_l - psi1 * f) - of_l2 * (jerk_f + psi1 * l));
        of_f -= psi1 * of_l1 + psi1 * psi1 * of_f2 + psi2 * of_l2;
        of_l += psi1 * of_f1 - psi1 * psi1 * of_l2 + psi2 * of_f2;
        let of_psi = of_f * l - of_l * f + of_jerk_f * jerk_l - of_jerk_l * jerk_f + of_f2 * snap_l - of_l2 * snap_f;

        let (s, c) = (self.turn.sin, self.turn.cos);
        let back = |forward: D, left: D| (c * forward - s * left, s * forward + c * left);
        let (of_x2, of_y2) = back(of_f, of_l);
        let (of_x3, of_y3) = back(of_jerk_f, of_jerk_l);
        let (of_x4, of_y4) = back(of_f2, of_l2);
        SVector::from([of_x2, of_y2, of_v, of_x3, of_y3, of_v1, of_x4, of_y4, of_v2, of_psi, of_psi1, of_psi2])
    }
}
