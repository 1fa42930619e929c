//! Closed intervals of `f64` whose operations round outwards: a result contains every value of the exact operation on
//! points of its operands (R. E. Moore, R. B. Kearfott, M. J. Cloud, *Introduction to Interval Analysis*, SIAM
//! 2009).
//!
//! Rust's `+ - * /` and `sqrt` round to nearest, so one step to the next number on either side encloses the exact
//! value. A result that is undefined or NaN is the whole line, for which no comparison that proves something holds.

use std::f64::consts::FRAC_PI_2;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
}

/// pi/2 lies between this number and the next.
const HALF_PI: Interval = Interval { low: FRAC_PI_2, high: FRAC_PI_2.next_up() };

/// Arguments of sines larger than this are not reduced.
const MOST_ANGLE: f64 = 1e6;

/// Whether a number is above another; NaN counts as above everything.
pub fn exceeds(x: f64, most: f64) -> bool {
    x.partial_cmp(&most).is_none_or(std::cmp::Ordering::is_gt)
}

impl Interval {
    pub const ZERO: Interval = Interval { low: 0.0, high: 0.0 };
    pub const ONE: Interval = Interval { low: 1.0, high: 1.0 };
    pub const WHOLE: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// From its ends; the whole line if one is NaN or they are in the wrong order.
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high { Interval { low, high } } else { Interval::WHOLE }
    }

    pub fn point(x: f64) -> Self {
        Interval::new(x, x)
    }

    /// `[-x, x]`
    pub fn around_zero(x: f64) -> Self {
        Interval::new(-x, x)
    }

    fn outward(low: f64, high: f64) -> Self {
        Interval::new(low.next_down(), high.next_up())
    }

    /// A number inside, near the middle.
    pub fn middle(self) -> f64 {
        let middle = 0.5 * self.low + 0.5 * self.high;
        if middle.is_finite() { middle.clamp(self.low, self.high) } else { 0.0_f64.clamp(self.low, self.high) }
    }

    /// Largest absolute value.
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    pub fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// The intersection of two enclosures of the same value; the first if they are disjoint.
    pub fn meet(self, other: Self) -> Self {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        if low <= high { Interval { low, high } } else { self }
    }

    /// max(x, 0)
    pub fn positive_part(self) -> Self {
        Interval { low: self.low.max(0.0), high: self.high.max(0.0) }
    }

    pub fn abs(self) -> Self {
        if self.contains(0.0) {
            Interval { low: 0.0, high: self.magnitude() }
        } else {
            Interval { low: self.low.abs().min(self.high.abs()), high: self.magnitude() }
        }
    }

    /// x^2, never negative.
    pub fn square(self) -> Self {
        let a = self.abs();
        let product = a * a;
        Interval { low: product.low.max(0.0), high: product.high }
    }

    /// The root of a value that is known not to be negative; the whole line if the interval is negative.
    pub fn sqrt(self) -> Self {
        if self == Interval::ZERO {
            return self;
        }
        if self.high < 0.0 {
            return Interval::WHOLE;
        }
        let root = Interval::outward(self.low.max(0.0).sqrt(), self.high.sqrt());
        Interval { low: root.low.max(0.0), high: root.high }
    }

    /// Sine and cosine: the series at the middle, reduced by quarter turns, and Taylor's remainder about it.
    pub fn sin_cos(self) -> (Self, Self) {
        let everything = Interval { low: -1.0, high: 1.0 };
        let middle = self.middle();
        let radius = (self - Interval::point(middle)).magnitude();
        if exceeds(radius, 1.0) || middle.abs() > MOST_ANGLE {
            return (everything, everything);
        }
        let (s, c) = sin_cos_of(middle);
        // sin(m + d) = sin m + d cos m - d^2/2 sin(..), and the cosine alike.
        let d = Interval::around_zero(radius);
        let rest = d.square() * Interval::around_zero(0.5);
        ((s + c * d + rest).meet(everything), (c - s * d + rest).meet(everything))
    }
}

/// Sine and cosine of one number of moderate size.
fn sin_cos_of(x: f64) -> (Interval, Interval) {
    if x == 0.0 {
        return (Interval::ZERO, Interval::ONE);
    }
    let quarters = (x / FRAC_PI_2).round();
    let r = Interval::point(x) - Interval::point(quarters) * HALF_PI;
    // Alternating series: for |r| < 1 the first omitted term bounds the remainder.
    let mut sums = [Interval::ZERO, Interval::ZERO];
    let mut term = Interval::ONE;
    const TERMS: usize = 22;
    for k in 0..TERMS {
        let signed = if k % 4 < 2 { term } else { -term };
        sums[k % 2] = sums[k % 2] + signed;
        term = term * r / Interval::point((k + 1) as f64);
    }
    let rest = Interval::around_zero(term.magnitude());
    let (c, s) = (sums[0] + rest, sums[1] + rest);
    match (quarters as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        // Adding zero is exact.
        if self == Interval::ZERO {
            return other;
        }
        if other == Interval::ZERO {
            return self;
        }
        // A rounded sum is zero only where the exact one is, because sums never underflow.
        let exact_zero = |sum: f64, rounded: f64| if sum == 0.0 { 0.0 } else { rounded };
        let (low, high) = (self.low + other.low, self.high + other.high);
        Interval::new(exact_zero(low, low.next_down()), exact_zero(high, high.next_up()))
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let finite = |i: Interval| i.magnitude().is_finite();
        if (self == Interval::ZERO || other == Interval::ZERO) && finite(self) && finite(other) {
            return Interval::ZERO;
        }
        hull([self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high])
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Interval::WHOLE;
        }
        if self == Interval::ZERO {
            return self;
        }
        hull([self.low / other.low, self.low / other.high, self.high / other.low, self.high / other.high])
    }
}

/// The smallest interval that encloses values which were rounded once each.
fn hull(values: [f64; 4]) -> Interval {
    if values.iter().any(|v| v.is_nan()) {
        return Interval::WHOLE;
    }
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Interval::outward(low, high)
}
