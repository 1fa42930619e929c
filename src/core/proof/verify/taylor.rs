//! Taylor models of second order in the deviation of the wind from its middle: a polynomial with interval coefficients,
//! and a bound on everything else (K. Makino, M. Berz, *Taylor models and other validated functional inclusion
//! methods*, International Journal of Pure and Applied Mathematics 4:4, 2003).
//!
//! With d in [-1, 1]^3, the deviation along each axis in units of its largest, a model encloses a function f of d by
//!
//! ```text
//! |f(d) - (c + sum over i of l_i d_i + sum over i <= j of q_ij d_i d_j)| <= rest
//! ```
//!
//! for some numbers in the intervals c, l_i and q_ij. The rest takes in the products of third and higher order, so that
//! an interval of winds is not taken for independent winds at each place where the wind occurs.

use super::interval::Interval;
use super::series::Scalar;
use std::ops::{Add, Mul, Neg, Sub};

/// The indices i <= j of the products d_i d_j, in the order of [`Taylor::quadratic`]: squares first.
pub const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// How many of [`PAIRS`] are squares.
const SQUARES: usize = 3;

/// An enclosure of a function of d in [-1, 1]^3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taylor {
    pub constant: Interval,
    pub linear: [Interval; 3],
    /// The coefficients of the products [`PAIRS`].
    pub quadratic: [Interval; 6],
    /// Bound on the absolute value of what the polynomial leaves out; not negative.
    pub rest: f64,
}

/// The sum of two bounds that are not negative, rounded up.
fn sum(a: f64, b: f64) -> f64 {
    // Adding zero is exact.
    if a == 0.0 || b == 0.0 { a + b } else { (a + b).next_up() }
}

/// The product of two bounds that are not negative, rounded up; a zero bounds its product with everything.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { (a * b).next_up() }
}

fn magnitudes(coefficients: &[Interval]) -> f64 {
    coefficients.iter().fold(0.0, |total, c| sum(total, c.magnitude()))
}

impl Taylor {
    /// d_`axis` times `largest`.
    pub fn deviation(axis: usize, largest: Interval) -> Self {
        let mut model = Taylor::of(Interval::ZERO);
        model.linear[axis] = largest;
        model
    }

    fn is_constant(&self) -> bool {
        let is_zero = |c: &Interval| *c == Interval::ZERO;
        self.rest == 0.0 && self.linear.iter().all(is_zero) && self.quadratic.iter().all(is_zero)
    }

    /// The product: terms up to second order go to the polynomial, and all others to the rest.
    fn times(&self, other: &Self) -> Self {
        if other.is_constant() {
            return self.scaled(other.constant);
        }
        if self.is_constant() {
            return other.scaled(self.constant);
        }
        let (a, b) = (self, other);
        let quadratic = |(p, (i, j)): (usize, (usize, usize))| {
            let crossed = a.linear[i] * b.linear[j];
            let crossed = if i == j { crossed } else { crossed + a.linear[j] * b.linear[i] };
            a.constant * b.quadratic[p] + a.quadratic[p] * b.constant + crossed
        };
        let mut pairs = PAIRS.into_iter().enumerate();
        let ([a1, a2], [b1, b2]) = (a.sizes(), b.sizes());
        let (whole_a, whole_b) = (sum(a.constant.magnitude(), sum(a1, a2)), sum(b.constant.magnitude(), sum(b1, b2)));
        let third_and_fourth = sum(product(a1, b2), product(a2, sum(b1, b2)));
        let of_rests = sum(product(whole_a, b.rest), product(a.rest, sum(whole_b, b.rest)));
        Taylor {
            constant: a.constant * b.constant,
            linear: std::array::from_fn(|i| a.constant * b.linear[i] + a.linear[i] * b.constant),
            quadratic: std::array::from_fn(|_| pairs.next().map_or(Interval::ZERO, quadratic)),
            rest: sum(third_and_fourth, of_rests),
        }
    }

    /// The largest absolute values of the linear and the quadratic part.
    fn sizes(&self) -> [f64; 2] {
        [magnitudes(&self.linear), magnitudes(&self.quadratic)]
    }

    /// An upper bound over all d that is at most by the rest, cross terms and negative squares above the largest value:
    /// `c + sum |l_i| + sum max(q_ii, 0) + sum over i < j of |q_ij| + rest`, enclosed.
    pub fn upper(&self) -> Interval {
        let (squares, crossed) = self.quadratic.split_at(SQUARES);
        let total = self.linear.iter().chain(crossed).fold(self.constant, |total, c| total + c.abs());
        let total = squares.iter().fold(total, |total, c| total + c.positive_part());
        total + Interval::point(self.rest)
    }

    /// Enclosure of all values.
    pub fn range(&self) -> Interval {
        Interval::new((-(-*self).upper()).low, self.upper().high)
    }

    /// Enclosure of the value at d.
    pub fn at(&self, d: [f64; 3]) -> Interval {
        let d = d.map(Interval::point);
        let linear = self.linear.iter().zip(d).fold(self.constant, |total, (c, d)| total + *c * d);
        let with_quadratic = |total: Interval, (c, (i, j)): (&Interval, (usize, usize))| total + *c * d[i] * d[j];
        self.quadratic.iter().zip(PAIRS).fold(linear, with_quadratic) + Interval::around_zero(self.rest)
    }

    /// `f(c + v) = f(c) + f'(c) v + f''(c)/2 v^2 + f'''(x)/6 v^3` with some x between c and c + v, for the varying part
    /// v. `derivatives` are f, f' and f''/2 at c; `third` bounds |f'''/6| over all values.
    fn applied(&self, derivatives: [Interval; 3], third: f64) -> Self {
        let varying = Taylor { constant: Interval::ZERO, ..*self };
        let [linear, quadratic] = self.sizes();
        let size = sum(sum(linear, quadratic), self.rest);
        let [value, slope, half_curvature] = derivatives;
        let mut result = Taylor::of(value) + varying.scaled(slope) + (varying * varying).scaled(half_curvature);
        result.rest = sum(result.rest, product(third, product(size, product(size, size))));
        result
    }

    /// The inverse; with f(c) = 1/c, f''/2 = 1/c^3 and |f'''|/6 = 1/c^4.
    fn inverse(&self) -> Self {
        let range = self.range();
        if range.contains(0.0) || range == Interval::WHOLE {
            return Taylor::of(Interval::WHOLE);
        }
        let first = Interval::ONE / self.constant;
        let third = (Interval::ONE / range.square().square()).high;
        self.applied([first, -first.square(), first.square() * first], third)
    }
}

impl Scalar for Taylor {
    fn of(value: Interval) -> Self {
        Taylor { constant: value, linear: [Interval::ZERO; 3], quadratic: [Interval::ZERO; 6], rest: 0.0 }
    }

    fn scaled(self, factor: Interval) -> Self {
        Taylor {
            constant: self.constant * factor,
            linear: self.linear.map(|c| c * factor),
            quadratic: self.quadratic.map(|c| c * factor),
            rest: product(self.rest, factor.magnitude()),
        }
    }

    /// With f(c) = c^(1/2), f' = 1/(2 f), f''/2 = -1/(8 c f) and f'''/6 = 1/(16 c^2 f).
    fn sqrt(self) -> Self {
        let range = self.range();
        if !(range.low > 0.0 && range.high.is_finite()) {
            return Taylor::of(Interval::WHOLE);
        }
        let root = self.constant.sqrt();
        let slope = Interval::ONE / (Interval::point(2.0) * root);
        let half_curvature = -(Interval::ONE / (Interval::point(8.0) * self.constant * root));
        let lowest = Interval::point(range.low);
        let third = Interval::ONE / (Interval::point(16.0) * lowest.square() * lowest.sqrt());
        self.applied([root, slope, half_curvature], third.high)
    }

    fn as_divisor(self) -> Self {
        self.inverse()
    }

    fn divided(self, by: Self) -> Self {
        self * by
    }
}

impl Add for Taylor {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Taylor {
            constant: self.constant + other.constant,
            linear: std::array::from_fn(|i| self.linear[i] + other.linear[i]),
            quadratic: std::array::from_fn(|i| self.quadratic[i] + other.quadratic[i]),
            rest: sum(self.rest, other.rest),
        }
    }
}

impl Neg for Taylor {
    type Output = Self;
    fn neg(self) -> Self {
        Taylor {
            constant: -self.constant,
            linear: self.linear.map(|c| -c),
            quadratic: self.quadratic.map(|c| -c),
            rest: self.rest,
        }
    }
}

impl Sub for Taylor {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Taylor {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.times(&other)
    }
}
