//! Polynomials by which a motion returns from a deviation of its state: bounds on them and their derivatives.

use super::super::interval::Interval;

/// Derivatives that two ends of a response have in common with zero: position to snap, so that the wrench does not
/// jump.
const ORDERS: usize = 5;

/// Coefficients of a response: degree 9.
const COEFFICIENTS: usize = 2 * ORDERS;

/// The response to a deviation of 1 in one derivative: the polynomial of degree 9 on [0, window] whose derivatives up
/// to the fourth vanish at both ends, except that of `order` at 0, which is 1.
///
/// With x = t/window it is `window^i / i! x^i (1 - x)^5 sum over m <= 4 - i of binom(4 + m, m) x^m` for order i.
#[derive(Debug, Clone)]
pub struct Response {
    order: usize,
    window: Interval,
    /// In x, of the response over window^i.
    coefficients: [Interval; COEFFICIENTS],
}

impl Response {
    /// # Panics
    /// If `order` is above 3.
    pub fn new(order: usize, window: f64) -> Self {
        assert!(order < ORDERS - 1, "a state has derivatives up to the third");
        // (1 - x)^5 and the sum; all are whole numbers below 2^53, and exact.
        let falling = [1.0, -5.0, 10.0, -10.0, 5.0, -1.0];
        let rising = [1.0, 5.0, 15.0, 35.0, 70.0];
        let mut product = [0.0; COEFFICIENTS];
        for (j, a) in falling.iter().enumerate() {
            for (m, b) in rising[..ORDERS - order].iter().enumerate() {
                if let Some(slot) = product.get_mut(order + j + m) {
                    *slot += a * b;
                }
            }
        }
        let factorial: f64 = (1..=order).map(|n| n as f64).product();
        let coefficients = product.map(|c| Interval::point(c) / Interval::point(factorial));
        Response { order, window: Interval::point(window), coefficients }
    }

    /// Enclosures of the response and its derivatives up to the fifth over times `t`, s since it begins; it is zero
    /// after the window.
    pub fn over(&self, t: Interval) -> [Interval; 6] {
        let x = t / self.window;
        if x.low >= 1.0 {
            return [Interval::ZERO; 6];
        }
        let ends = x.high > 1.0;
        let x = Interval::new(x.low.max(0.0), x.high.min(1.0));
        let middle = Interval::point(x.middle());
        let away = x - middle;
        // Derivatives at the middle over factorials: the coefficients about it, by repeated division.
        let mut about = self.coefficients;
        for first in 0..COEFFICIENTS {
            for i in (first..COEFFICIENTS - 1).rev() {
                about[i] = about[i] + middle * about[i + 1];
            }
        }
        let mut scale = power(self.window, self.order as i32);
        std::array::from_fn(|k| {
            // sum over n >= k of n!/(n-k)! a_n away^(n-k)
            let term = |sum: Interval, n: usize| {
                let falling: f64 = (n + 1 - k..=n).map(|i| i as f64).product();
                sum * away + about[n] * Interval::point(falling)
            };
            let value = (k..COEFFICIENTS).rev().fold(Interval::ZERO, term) * scale;
            scale = scale / self.window;
            if ends { Interval::new(value.low.min(0.0), value.high.max(0.0)) } else { value }
        })
    }
}

fn power(x: Interval, n: i32) -> Interval {
    (0..n).fold(Interval::ONE, |product, _| product * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derivatives of a response at x, by the formula of its docstring and finite sums.
    fn at(response: &Response, t: f64) -> [f64; 6] {
        let (x, w) = (t / response.window.low, response.window.low);
        std::array::from_fn(|k| {
            let sum: f64 = (k..COEFFICIENTS)
                .map(|n| {
                    let falling: f64 = (n + 1 - k..=n).map(|i| i as f64).product();
                    response.coefficients[n].middle() * falling * x.powi((n - k) as i32)
                })
                .sum();
            sum * w.powi(response.order as i32 - k as i32)
        })
    }

    #[test]
    fn a_response_begins_with_one_derivative_and_ends_with_none() {
        for order in 0..4 {
            let response = Response::new(order, 1.7);
            let (first, last) = (at(&response, 0.0), at(&response, 1.7));
            for k in 0..5 {
                let begins = if k == order { 1.0 } else { 0.0 };
                assert!((first[k] - begins).abs() < 1e-12, "order {order}, derivative {k}: {}", first[k]);
                assert!(last[k].abs() < 1e-9, "order {order}, derivative {k}: {}", last[k]);
            }
        }
    }

    #[test]
    fn enclosures_contain_every_value_and_are_not_much_wider() {
        for order in 0..4 {
            let response = Response::new(order, 2.5);
            for cell in 0..50 {
                let (from, to) = (0.05 * f64::from(cell), 0.05 * f64::from(cell + 1));
                let bounds = response.over(Interval::new(from, to));
                for (k, bound) in bounds.into_iter().enumerate() {
                    let values = (0..=20).map(|i| at(&response, from + (to - from) * f64::from(i) / 20.0)[k]);
                    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (v.min(l), v.max(h)));
                    let size = (0..=50).map(|i| at(&response, 0.05 * f64::from(i))[k].abs()).fold(0.0, f64::max);
                    let rounding = 1e-9 * size;
                    assert!(bound.low <= low + rounding && high - rounding <= bound.high, "order {order}: {k}");
                    // The fifth derivative jumps at the end.
                    let is_narrow = bound.high - bound.low <= high - low + 0.25 * size;
                    assert!(k == 5 || is_narrow, "order {order}, derivative {k}");
                }
            }
        }
        assert_eq!(Response::new(0, 1.0).over(Interval::new(1.1, 2.0)), [Interval::ZERO; 6]);
    }
}
