//! Statistics against values worked by hand, published ones, and closed forms.

use mavc::campaign::statistics::{
    Contingency, Moments, brier, rank_interval, sign_test, spearman, spearman_within, wilson,
};

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

#[test]
fn rank_correlation_by_hand() {
    // Without ties 1 - 6 sum(d^2) / (n (n^2 - 1)): d = 0, -1, 1, -1, 1.
    let pairs = [(1.0, 10.0), (2.0, 30.0), (3.0, 20.0), (4.0, 50.0), (5.0, 40.0)];
    assert!(near(spearman(&pairs).unwrap(), 1.0 - 6.0 * 4.0 / 120.0));
    // Ranks 1.5, 1.5, 3 against 1, 2, 3: 1.5 / sqrt(1.5 * 2).
    assert!(near(spearman(&[(0.0, 1.0), (0.0, 2.0), (7.0, 3.0)]).unwrap(), 1.5 / 3_f64.sqrt()));
    assert_eq!(spearman(&[(1.0, 2.0), (1.0, 3.0)]), None);
    assert_eq!(spearman(&[]), None);
}

/// phi is Pearson's correlation of the two 0/1 columns, and so Spearman's, which has other code.
#[test]
fn phi_is_the_correlation_of_what_it_counts() {
    for (hits, misses, false_alarms, correct_negatives) in [(20, 5, 10, 15), (1, 0, 3, 40), (2, 9, 8, 1)] {
        let table = Contingency { hits, misses, false_alarms, correct_negatives };
        let pairs: Vec<(f64, f64)> =
            [(hits, (1.0, 1.0)), (misses, (0.0, 1.0)), (false_alarms, (1.0, 0.0)), (correct_negatives, (0.0, 0.0))]
                .into_iter()
                .flat_map(|(count, pair)| std::iter::repeat_n(pair, count))
                .collect();
        assert!((table.phi().unwrap() - spearman(&pairs).unwrap()).abs() < 1e-12, "{table:?}");
    }
}

#[test]
fn brier_scores_by_closed_form() {
    // Of 0 or 1: the share that is wrong, here 3 of 20.
    let sharp = [(1.0, 7, 9), (0.0, 1, 11)];
    assert!((brier(&sharp).unwrap() - 3.0 / 20.0).abs() < 1e-15);
    // Of the base rate b for all: b (1 - b).
    let base = 8.0 / 20.0;
    assert!((brier(&[(base, 7, 9), (base, 1, 11)]).unwrap() - base * (1.0 - base)).abs() < 1e-15);
    // Murphy's (1973) decomposition: reliability - resolution + uncertainty.
    let classes = [(0.8, 7, 9), (0.3, 1, 11), (0.1, 2, 5)];
    let n: f64 = classes.iter().map(|c| c.2 as f64).sum();
    let mean = classes.iter().map(|c| c.1 as f64).sum::<f64>() / n;
    let rate = |c: &(f64, usize, usize)| c.1 as f64 / c.2 as f64;
    let reliability: f64 = classes.iter().map(|c| c.2 as f64 * (c.0 - rate(c)).powi(2)).sum::<f64>() / n;
    let resolution: f64 = classes.iter().map(|c| c.2 as f64 * (rate(c) - mean).powi(2)).sum::<f64>() / n;
    assert!((brier(&classes).unwrap() - (reliability - resolution + mean * (1.0 - mean))).abs() < 1e-15);
    assert_eq!(brier(&[]), None);
}

#[test]
fn rank_correlation_within_groups_by_hand() {
    // Each group is ordered perfectly, though the groups as a whole are ordered the other way.
    let groups = vec![vec![(1.0, 10.0), (2.0, 11.0), (3.0, 12.0)], vec![(4.0, 1.0), (5.0, 2.0)], vec![(6.0, 0.0)]];
    assert_eq!(spearman_within(&groups), (Some(1.0), 2));
    assert!(spearman(&groups.concat()).unwrap() < -0.5);
    // One group: the plain correlation. A group in which one side never varies does not count.
    let one = vec![(1.0, 10.0), (2.0, 30.0), (3.0, 20.0), (4.0, 50.0), (5.0, 40.0)];
    assert!((spearman_within(std::slice::from_ref(&one)).0.unwrap() - spearman(&one).unwrap()).abs() < 1e-12);
    assert_eq!(spearman_within(&[vec![(1.0, 5.0), (2.0, 5.0)]]), (None, 0));
    // tanh(atanh(0.6) -+ 1.96 sqrt((1 + 0.18)/17)).
    let interval = rank_interval(0.6, 20).unwrap();
    assert!(near(interval.low, 0.17495) && near(interval.high, 0.83654), "{interval:?}");
    assert_eq!((rank_interval(0.6, 9), rank_interval(1.0, 50)), (None, None));
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
