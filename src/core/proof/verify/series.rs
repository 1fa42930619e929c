//! Truncated Taylor series in time: enclosures of a quantity and its first derivatives without explicit formulas for
//! these (Moore, Kearfott, Cloud, chapter 9). The coefficients are intervals, or Taylor models in the wind.

use super::interval::Interval;
use std::ops::{Add, Mul, Neg, Sub};

/// What coefficients are: enclosures of a number, or of a function of the wind.
pub trait Scalar: Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + Mul<Output = Self> {
    /// A number that depends on nothing else.
    fn of(value: Interval) -> Self;
    /// The product with such a number.
    fn scaled(self, factor: Interval) -> Self;
    fn sqrt(self) -> Self;
    /// The form of a divisor that [`Self::divided`] takes; several quotients with the same divisor share it.
    fn as_divisor(self) -> Self;
    fn divided(self, by: Self) -> Self;
}

impl Scalar for Interval {
    fn of(value: Interval) -> Self {
        value
    }

    fn scaled(self, factor: Interval) -> Self {
        self * factor
    }

    fn sqrt(self) -> Self {
        Interval::sqrt(self)
    }

    fn as_divisor(self) -> Self {
        self
    }

    fn divided(self, by: Self) -> Self {
        self / by
    }
}

/// `sum of c_n s^n` for n < N. A quantity and its rate of change need two coefficients, plus one for each derivative
/// taken in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series<const N: usize, S = Interval>(pub [S; N]);

impl<const N: usize> Series<N> {
    /// From a quantity's derivatives: `c_n = d_n / n!`.
    pub fn of_derivatives(derivatives: &[Interval]) -> Self {
        let mut factorial = 1.0;
        Series(std::array::from_fn(|n| {
            factorial *= n.max(1) as f64;
            match derivatives.get(n) {
                Some(&d) if n < 2 => d,
                Some(&d) => d / Interval::point(factorial),
                None => Interval::ZERO,
            }
        }))
    }

    /// This series with coefficients of another kind.
    pub fn lifted<S: Scalar>(&self) -> Series<N, S> {
        Series(self.0.map(S::of))
    }

    /// n s_n = sum over j of j a_j c_(n-j), n c_n = -(sum over j of j a_j s_(n-j)).
    pub fn sin_cos(&self) -> (Self, Self) {
        let (mut s, mut c) = ([Interval::ZERO; N], [Interval::ZERO; N]);
        (s[0], c[0]) = self.0[0].sin_cos();
        for n in 1..N {
            let mut sums = (Interval::ZERO, Interval::ZERO);
            for j in 1..=n {
                let weighted = self.0[j] * Interval::point(j as f64);
                sums = (sums.0 + weighted * c[n - j], sums.1 - weighted * s[n - j]);
            }
            let n_th = Interval::point(n as f64);
            (s[n], c[n]) = (sums.0 / n_th, sums.1 / n_th);
        }
        (Series(s), Series(c))
    }
}

impl<const N: usize, S: Scalar> Series<N, S> {
    /// A quantity that does not change.
    pub fn constant(value: S) -> Self {
        let mut c = [S::of(Interval::ZERO); N];
        c[0] = value;
        Series(c)
    }

    /// Enclosure of the value.
    pub fn value(&self) -> S {
        self.0[0]
    }

    /// Enclosure of the first derivative.
    pub fn slope(&self) -> S {
        self.0[1]
    }

    /// The product with a constant.
    pub fn times(&self, factor: Interval) -> Self {
        Series(self.0.map(|c| c.scaled(factor)))
    }

    /// The derivative with respect to time, of which one coefficient fewer is known.
    pub fn rate(&self) -> Self {
        Series(std::array::from_fn(|n| match self.0.get(n + 1) {
            Some(&c) => c.scaled(Interval::point((n + 1) as f64)),
            None => S::of(Interval::WHOLE),
        }))
    }

    /// `self / divisor`: q_n = (a_n - sum over j < n of q_j b_(n-j)) / b_0.
    pub fn over(&self, divisor: &Self) -> Self {
        let mut q = [S::of(Interval::ZERO); N];
        let first = divisor.0[0].as_divisor();
        for n in 0..N {
            let known = (0..n).fold(self.0[n], |sum, j| sum - q[j] * divisor.0[n - j]);
            q[n] = known.divided(first);
        }
        Series(q)
    }

    /// s_0 = sqrt(a_0), s_n = (a_n - sum over 0 < j < n of s_j s_(n-j)) / (2 s_0).
    pub fn sqrt(&self) -> Self {
        let mut s = [S::of(Interval::ZERO); N];
        s[0] = self.0[0].sqrt();
        let double = s[0].scaled(Interval::point(2.0)).as_divisor();
        for n in 1..N {
            let known = (1..n).fold(self.0[n], |sum, j| sum - s[j] * s[n - j]);
            s[n] = known.divided(double);
        }
        Series(s)
    }
}

impl<const N: usize, S: Scalar> Add for Series<N, S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Series(std::array::from_fn(|n| self.0[n] + other.0[n]))
    }
}

impl<const N: usize, S: Scalar> Neg for Series<N, S> {
    type Output = Self;
    fn neg(self) -> Self {
        Series(self.0.map(|c| -c))
    }
}

impl<const N: usize, S: Scalar> Sub for Series<N, S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const N: usize, S: Scalar> Mul for Series<N, S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Series(std::array::from_fn(|n| (0..=n).fold(S::of(Interval::ZERO), |sum, j| sum + self.0[j] * other.0[n - j])))
    }
}

/// A vector whose components change with time.
pub type Vector<const N: usize, S = Interval> = [Series<N, S>; 3];

pub fn dot<const N: usize, S: Scalar>(a: &Vector<N, S>, b: &Vector<N, S>) -> Series<N, S> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross<const N: usize, S: Scalar>(a: &Vector<N, S>, b: &Vector<N, S>) -> Vector<N, S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn unit<const N: usize, S: Scalar>(a: &Vector<N, S>) -> Vector<N, S> {
    let length = dot(a, a).sqrt();
    [a[0].over(&length), a[1].over(&length), a[2].over(&length)]
}

/// The distance of a vector from the cone of those at an angle of at most `angle` (rad, below pi/2) to an axis: `ahead`
/// is its component along the axis, `aside` the length of the rest. Beyond a right angle to the cone's side the apex is
/// nearest, so that the distance is the whole length: its sine alone would fall to zero again for a vector that points
/// backwards.
pub fn outside_cone(aside: Series<2>, ahead: Series<2>, angle: f64) -> Series<2> {
    let (sine, cosine) = Interval::point(angle).sin_cos();
    let from_side = aside.times(cosine) - ahead.times(sine);
    let along_side = ahead.value() * cosine + aside.value() * sine;
    if along_side.low >= 0.0 {
        return from_side;
    }
    let length = |of: fn(&Series<2>) -> Interval| (of(&aside).square() + of(&ahead).square()).sqrt();
    let from_apex = length(Series::value);
    // No distance changes faster than the vector does.
    let steepest = Interval::around_zero(length(Series::slope).high);
    let nearest = if along_side.high < 0.0 { from_apex.low } else { from_side.value().low.min(from_apex.low) };
    Series::of_derivatives(&[Interval::new(nearest, from_apex.high), steepest])
}
