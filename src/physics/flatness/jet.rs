//! Truncated Taylor series in time, whose coefficients may be dual numbers.

use num_dual::DualNum;
use std::ops::{Add, Mul, Neg, Sub};

/// `sum of c_n t^n` for n < N. The derivative of a series has one coefficient fewer: its last one is NaN, so that a
/// result that depends on an unknown coefficient is NaN too.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet<D, const N: usize>(pub(super) [D; N]);

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Jet<D, N> {
    /// A quantity that does not change.
    pub(super) fn constant(value: f64) -> Self {
        Jet(std::array::from_fn(|n| D::from(if n == 0 { value } else { 0.0 })))
    }

    /// From the time derivatives of a quantity, of orders 0 to N - 1: `c_n = d_n / n!`.
    pub(super) fn of_derivatives(derivatives: [D; N]) -> Self {
        let mut factorial = 1.0;
        Jet(std::array::from_fn(|n| {
            factorial *= n.max(1) as f64;
            derivatives[n] / D::from(factorial)
        }))
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Jet(self.0.map(|c| c * D::from(factor)))
    }

    /// The derivative with respect to time.
    pub(super) fn rate(self) -> Self {
        Jet(std::array::from_fn(|n| match self.0.get(n + 1) {
            Some(&c) => c * D::from((n + 1) as f64),
            None => D::from(f64::NAN),
        }))
    }

    /// `q = self / divisor`: `q_n = (a_n - sum over j < n of q_j b_(n-j)) / b_0`.
    pub(super) fn over(self, divisor: Self) -> Self {
        let mut q = [D::from(0.0); N];
        for n in 0..N {
            let known = (0..n).fold(self.0[n], |sum, j| sum - q[j] * divisor.0[n - j]);
            q[n] = known / divisor.0[0];
        }
        Jet(q)
    }

    /// `s_0 = sqrt(a_0)`, `s_n = (a_n - sum over 0 < j < n of s_j s_(n-j)) / (2 s_0)`.
    pub(super) fn sqrt(self) -> Self {
        let mut s = [D::from(0.0); N];
        s[0] = self.0[0].sqrt();
        for n in 1..N {
            let known = (1..n).fold(self.0[n], |sum, j| sum - s[j] * s[n - j]);
            s[n] = known / (s[0] + s[0]);
        }
        Jet(s)
    }

    /// Sine and cosine: `n s_n = sum over j of j a_j c_(n-j)` and `n c_n = -(sum over j of j a_j s_(n-j))`.
    pub(super) fn sin_cos(self) -> (Self, Self) {
        let (mut s, mut c) = ([D::from(0.0); N], [D::from(0.0); N]);
        (s[0], c[0]) = self.0[0].sin_cos();
        for n in 1..N {
            for j in 1..=n {
                let weighted = self.0[j] * D::from(j as f64 / n as f64);
                s[n] += weighted * c[n - j];
                c[n] -= weighted * s[n - j];
            }
        }
        (Jet(s), Jet(c))
    }
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Add for Jet<D, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Jet(std::array::from_fn(|n| self.0[n] + other.0[n]))
    }
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Sub for Jet<D, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Jet(std::array::from_fn(|n| self.0[n] - other.0[n]))
    }
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Neg for Jet<D, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Jet(self.0.map(|c| -c))
    }
}

impl<D: DualNum<Primitive = f64> + Copy, const N: usize> Mul for Jet<D, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Jet(std::array::from_fn(|n| (0..=n).fold(D::from(0.0), |sum, j| sum + self.0[j] * other.0[n - j])))
    }
}
