//! Exact numbers `m 2^e`: every finite `f64` is such a number, and so are their sums and products.

use super::interval::Interval;
use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// `mantissa * 2^exponent`
#[derive(Debug, Clone, PartialEq)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i32,
}

impl Dyadic {
    pub fn zero() -> Self {
        Dyadic { mantissa: BigInt::ZERO, exponent: 0 }
    }

    /// The exact value of `x`; zero if it is not finite, which does not occur in a checked spec.
    pub fn of(x: f64) -> Self {
        if !x.is_finite() || x == 0.0 {
            return Dyadic::zero();
        }
        let bits = x.to_bits();
        let (stored, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
        // Numbers below 2^-1022 have no hidden leading one.
        let (mantissa, exponent) = if stored == 0 { (fraction, -1074) } else { (fraction | 1 << 52, stored - 1075) };
        let trailing = mantissa.trailing_zeros();
        let mantissa = BigInt::from(mantissa >> trailing);
        Dyadic { mantissa: if x < 0.0 { -mantissa } else { mantissa }, exponent: exponent + trailing as i32 }
    }

    pub fn is_zero(&self) -> bool {
        self.mantissa.sign() == Sign::NoSign
    }

    pub fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    pub fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        let raised = |d: &Self| &d.mantissa << (d.exponent - exponent) as u32;
        Dyadic { mantissa: raised(self) + raised(other), exponent }
    }

    pub fn negated(&self) -> Self {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub fn times(&self, other: &Self) -> Self {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }

    /// The tightest interval that 62 bits of the number give.
    pub fn enclosure(&self) -> Interval {
        if self.is_zero() {
            return Interval::ZERO;
        }
        let (sign, magnitude) = (self.mantissa.sign(), self.mantissa.magnitude());
        let dropped = magnitude.bits().saturating_sub(62);
        let leading = (magnitude >> dropped).iter_u64_digits().next().unwrap_or(0);
        let nearest = leading as f64;
        // One step for the bits dropped and the rounding to f64, another for the scaling.
        let scale = power_of_two(self.exponent.saturating_add(dropped as i32));
        let enclosed = Interval::new(nearest.next_down(), nearest.next_up()) * scale;
        if sign == Sign::Minus { -enclosed } else { enclosed }
    }
}

fn power_of_two(exponent: i32) -> Interval {
    match exponent {
        ..-1022 => Interval::new(0.0, f64::MIN_POSITIVE),
        -1022..=1023 => Interval::point(f64::from_bits(((exponent + 1023) as u64) << 52)),
        1024.. => Interval::new(f64::MAX, f64::INFINITY),
    }
}

pub fn dot(a: &[Dyadic; 4], b: &[Dyadic; 4]) -> Dyadic {
    (0..4).fold(Dyadic::zero(), |sum, i| sum.plus(&a[i].times(&b[i])))
}

/// The vector orthogonal to three others whose length is the volume they span; zero if and only if they are dependent.
///
/// Component i is (-1)^i times the minor without column i.
pub fn orthogonal(a: &[Dyadic; 4], b: &[Dyadic; 4], c: &[Dyadic; 4]) -> [Dyadic; 4] {
    std::array::from_fn(|i| {
        let [p, q, r] = match i {
            0 => [1, 2, 3],
            1 => [0, 2, 3],
            2 => [0, 1, 3],
            _ => [0, 1, 2],
        };
        let minor = |p: usize, q: usize| b[p].times(&c[q]).minus(&b[q].times(&c[p]));
        let determinant = a[p].times(&minor(q, r)).minus(&a[q].times(&minor(p, r))).plus(&a[r].times(&minor(p, q)));
        if i % 2 == 0 { determinant } else { determinant.negated() }
    })
}
