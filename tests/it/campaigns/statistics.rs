//! Statistics against values worked by hand, published ones, and closed forms.

use mavc::campaign::statistics::{Contingency, Moments, sign_test, wilson};

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 5e-5
}

#[test]
fn wilson_intervals_are_as_published() {
    // Brown, Cai and DasGupta (2001) and common tables.
    for (successes, of, low, high) in
        [(0, 10, 0.0, 0.2775), (5, 10, 0.2366, 0.7634), (10, 10, 0.7225, 1.0), (1, 29, 0.0061, 0.1718)]
    {
        let share = wilson(successes, of).unwrap();
        assert!(near(share.low, low) && near(share.high, high), "{successes}/{of}: {share:?}");
        assert_eq!(share.share, successes as f64 / of as f64);
    }
    // Newcombe (1998): 81/263 -> 0.2553 .. 0.3662.
    let share = wilson(81, 263).unwrap();
    assert!(near(share.low, 0.2553) && near(share.high, 0.3662), "{share:?}");
    assert_eq!(wilson(0, 0), None);
}

#[test]
fn phi_and_base_rate_by_hand() {
    let table = Contingency { hits: 20, misses: 5, false_alarms: 10, correct_negatives: 15 };
    // (20 * 15 - 10 * 5) / sqrt(30 * 20 * 25 * 25)
    assert!(near(table.phi().unwrap(), 250.0 / 375_000_f64.sqrt()));
    assert_eq!(table.base_rate(), Some(0.5));
    let perfect = Contingency { hits: 3, correct_negatives: 4, ..Contingency::default() };
    assert_eq!(perfect.phi(), Some(1.0));
    let opposite = Contingency { misses: 3, false_alarms: 4, ..Contingency::default() };
    assert_eq!(opposite.phi(), Some(-1.0));
    let constant = Contingency { hits: 3, false_alarms: 4, ..Contingency::default() };
    assert_eq!(constant.phi(), None);
    assert_eq!(Contingency::default().base_rate(), None);
}

/// phi is Pearson's correlation of the two 0/1 columns.
#[test]
fn phi_is_the_correlation_of_what_it_counts() {
    for (hits, misses, false_alarms, correct_negatives) in [(20, 5, 10, 15), (1, 0, 3, 40), (2, 9, 8, 1)] {
        let table = Contingency { hits, misses, false_alarms, correct_negatives };
        let pairs: Vec<(f64, f64)> =
            [(hits, (1.0, 1.0)), (misses, (0.0, 1.0)), (false_alarms, (1.0, 0.0)), (correct_negatives, (0.0, 0.0))]
                .into_iter()
                .flat_map(|(count, pair)| std::iter::repeat_n(pair, count))
                .collect();
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len() as f64;
        let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
        let spread = (mean(&|p| (p.0 - x).powi(2)) * mean(&|p| (p.1 - y).powi(2))).sqrt();
        let correlation = mean(&|p| (p.0 - x) * (p.1 - y)) / spread;
        assert!((table.phi().unwrap() - correlation).abs() < 1e-12, "{table:?}");
    }
}

#[test]
fn moments_by_hand() {
    let mut moments = Moments::default();
    assert_eq!(moments.summary(), None);
    [2.0, 4.0, 4.0, 6.0].into_iter().for_each(|v| moments.add(v));
    let summary = moments.summary().unwrap();
    // Standard deviation sqrt(8/3), standard error sqrt(2/3).
    let half = 1.959964 * (2.0_f64 / 3.0).sqrt();
    assert!(near(summary.mean, 4.0) && near(summary.low, 4.0 - half) && near(summary.high, 4.0 + half));
    assert_eq!((summary.count, summary.max), (4, 6.0));
}

/// Tails of the binomial distribution with 1/2, counted by hand: 2 of 32, 18 of 256; even splits and none say nothing.
#[test]
fn the_sign_test_is_exact() {
    for (a, b, p) in [(0, 5, 0.0625), (1, 7, 18.0 / 256.0), (7, 1, 18.0 / 256.0), (3, 3, 1.0), (0, 0, 1.0), (2, 3, 1.0)]
    {
        assert!((sign_test(a, b) - p).abs() < 1e-12, "{a} {b}: {}", sign_test(a, b));
    }
    let many = sign_test(9_000, 10_000);
    assert!(many > 0.0 && many < 1e-10, "{many}");
    assert_eq!(sign_test(0, 100_000), 0.0);
}
