//! Outward rounding against error-free transformations; exact numbers against integers.

use super::Numbers;
use mavc::verify::dyadic::Dyadic;
use mavc::verify::interval::Interval;
use mavc::verify::series::Series;

/// Numbers of all sizes.
fn number(numbers: &mut Numbers) -> f64 {
    let scale = 2f64.powi(numbers.below(80) as i32 - 40);
    match numbers.below(8) {
        0 => numbers.below(5) as f64,
        _ => numbers.unit() * scale,
    }
}

/// Whether `rounded + error` (error far below an ulp of `rounded`, exact) lies in the interval.
fn holds(interval: Interval, rounded: f64, error: f64) -> bool {
    let above = interval.low < rounded || interval.low == rounded && error >= 0.0;
    let below = interval.high > rounded || interval.high == rounded && error <= 0.0;
    above && below
}

#[test]
fn sums_and_products_hold_the_exact_value() {
    let mut numbers = Numbers(1);
    for _ in 0..20_000 {
        let (a, b) = (number(&mut numbers), number(&mut numbers));
        let (x, y) = (Interval::point(a), Interval::point(b));
        // Knuth's exact sum.
        let sum = a + b;
        let part = sum - a;
        let error = (a - (sum - part)) + (b - part);
        assert!(holds(x + y, sum, error), "{a} + {b}");
        // What a fused multiplication leaves over.
        let product = a * b;
        assert!(holds(x * y, product, a.mul_add(b, -product)), "{a} * {b}");
        if b != 0.0 {
            let quotient = x / y;
            // a - q b has the sign of a/b - q times that of b.
            let beside = |q: f64| (-q).mul_add(b, a) * b.signum();
            assert!(beside(quotient.low) >= 0.0 && beside(quotient.high) <= 0.0, "{a} / {b}");
        }
        let root = Interval::point(a.abs()).sqrt();
        assert!(root.low.mul_add(root.low, -a.abs()) <= 0.0 && root.high.mul_add(root.high, -a.abs()) >= 0.0, "{a}");
    }
}

#[test]
fn wide_operands_hold_every_pair() {
    let mut numbers = Numbers(2);
    for _ in 0..2_000 {
        let mut wide = || {
            let (a, b) = (number(&mut numbers), number(&mut numbers));
            (Interval::new(a.min(b), a.max(b)), [a, b, 0.5 * a + 0.5 * b])
        };
        let ((x, of_x), (y, of_y)) = (wide(), wide());
        for a in of_x {
            for b in of_y {
                assert!((x + y).contains(a + b) && (x - y).contains(a - b) && (x * y).contains(a * b));
                assert!(b == 0.0 || y.contains(0.0) && x / y == Interval::WHOLE || (x / y).contains(a / b));
            }
            assert!(x.square().contains(a * a) && x.abs().contains(a.abs()) && x.square().low >= 0.0);
        }
    }
}

#[test]
fn sines_are_narrow_and_hold_the_library_value() {
    let mut numbers = Numbers(3);
    for _ in 0..5_000 {
        let x = numbers.unit() * 100.0;
        let (s, c) = Interval::point(x).sin_cos();
        // The library is off by an ulp or so.
        for (interval, library) in [(s, x.sin()), (c, x.cos())] {
            assert!(interval.low <= library + 2e-16 && library - 2e-16 <= interval.high, "{x}");
            assert!(interval.high - interval.low < 1e-13, "{x}: {interval:?}");
        }
        let one = s.square() + c.square();
        assert!(one.contains(1.0));
        let radius = 0.3 * numbers.unit().abs();
        let (s, c) = Interval::new(x - radius, x + radius).sin_cos();
        for i in 0..=20 {
            let at = x - radius + 2.0 * radius * f64::from(i) / 20.0;
            assert!(s.contains(at.sin()) && c.contains(at.cos()), "{x} {radius}");
        }
    }
}

#[test]
fn what_is_no_number_proves_nothing() {
    for wrong in [Interval::point(f64::NAN), Interval::new(1.0, 0.0), Interval::point(1.0) / Interval::ZERO] {
        assert_eq!(wrong, Interval::WHOLE);
    }
    let huge = Interval::point(f64::MAX) * Interval::point(f64::MAX);
    assert_eq!(huge.high, f64::INFINITY);
    assert_eq!(huge - huge, Interval::WHOLE);
    assert_eq!(Interval::WHOLE * Interval::ZERO, Interval::WHOLE);
    assert_eq!(Interval::point(-1.0).sqrt(), Interval::WHOLE);
}

#[test]
fn exact_numbers_are_exact() {
    let mut numbers = Numbers(4);
    for _ in 0..2_000 {
        let (a, b) = ((numbers.next() >> 24) as i128 - (1 << 39), (numbers.next() >> 24) as i128 - (1 << 39));
        let (x, y) = (Dyadic::of(a as f64 / 1024.0), Dyadic::of(b as f64 / 32.0));
        // In units of 1/32768.
        let exact = a * b + 32 * a;
        let found = x.times(&y).plus(&x);
        assert_eq!(found.minus(&Dyadic::of(exact as f64 / 32768.0)).is_zero(), (exact as f64) as i128 == exact);
        assert_eq!(found.sign(), exact.cmp(&0));
        let enclosure = found.enclosure();
        assert!(enclosure.contains(exact as f64 / 32768.0));
        assert!(enclosure.high - enclosure.low <= 8.0 * f64::EPSILON * enclosure.magnitude());
    }
    for x in [0.0, -0.0, f64::MIN_POSITIVE, 5e-324, 1.5, -f64::MAX] {
        assert!(Dyadic::of(x).enclosure().contains(x), "{x}");
        assert_eq!(Dyadic::of(x).is_zero(), x == 0.0);
    }
}

/// Quotients, roots, sines of series against the same functions at points nearby.
#[test]
fn series_are_taylors() {
    let derivatives = [[1.3, 0.4, -0.7, 0.2], [2.1, -0.3, 0.5, 0.9]].map(|d| d.map(Interval::point));
    let [a, b] = derivatives.map(|d| Series::of_derivatives(&d));
    let at = |s: &Series<4>, t: f64| s.0.iter().rev().fold(0.0, |sum, c| sum * t + c.middle());
    let (t, close) = (1e-3, 1e-11);
    let (x, y) = (at(&a, t), at(&b, t));
    assert!((at(&a.over(&b), t) - x / y).abs() < close);
    assert!((at(&(a * b), t) - x * y).abs() < close);
    assert!((at(&a.sqrt(), t) - x.sqrt()).abs() < close);
    let (s, c) = a.sin_cos();
    assert!((at(&s, t) - x.sin()).abs() < close && (at(&c, t) - x.cos()).abs() < close);
    assert!((at(&a.rate(), 0.0) - 0.4).abs() < close && a.rate().0[3] == Interval::WHOLE);
}
