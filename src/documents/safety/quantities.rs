//! The probability of a loss of control, its cut sets, and what matters most.
//!
//! A mode with the rate `r` strikes as a Poisson process, so its strikes in separate parts of the mission are
//! independent events. There is one event for the uncovered seconds of each phase, without a way out or with one whose
//! simulated flight failed, `1 - exp(-r u)`, and one for all the others together, `1 - exp(-r c)`. Control is lost if
//! an event of the first kind occurs, or events of two modes. The shares of exposure are the times of exponential
//! events rather than factors: this is exact for any rate, where a factor would be so for small ones.

mod record;

use super::evidence::Phase;
use super::short;
use crate::model::Spread;
use crate::number::shortest;
pub use record::record;

/// A mode with a rate, and when it is uncovered.
#[derive(Debug, Clone, PartialEq)]
pub struct Rated {
    /// An index into the model's modes.
    pub mode: usize,
    /// 1/h, in the middle of its interval.
    pub rate_per_h: f64,
    /// The interval of the rate.
    pub spread: Spread,
    /// The phases with uncovered seconds, and how many.
    pub exposed: Vec<(Phase, f64)>,
}

/// An event that alone loses control: a mode strikes where it is uncovered.
#[derive(Debug, Clone, PartialEq)]
pub struct Single<'a> {
    pub phase: &'a Phase,
    /// s uncovered.
    pub seconds: f64,
    pub probability: f64,
}

/// The probability of a loss of control, and what it follows from.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantities {
    /// The modes with a rate, in the order of the model's.
    pub rated: Vec<Rated>,
    /// The duration of the mission, s.
    pub duration: f64,
    /// For one mission; `None` if no mode has a rate.
    pub probability: Option<f64>,
    /// For one mission if ways out whose simulated flight failed covered their time; `None` if no such flight failed.
    pub without_failures: Option<f64>,
    /// For the lowest and the highest rates, if some are intervals.
    pub interval: Option<[f64; 2]>,
    /// The largest probability that the spec allows for one mission: `require risk`.
    pub target: Option<f64>,
}

/// Significant digits of the numbers that files have in common. One less than `f64` has, so that a number is printed
/// as it is written: 1e-5 1/h is not 1e-5 after a change of units and back.
const DIGITS: usize = 15;

/// The share of a sample that is wrong of a bound of 95 %.
const WRONG: f64 = 0.05;

/// Halvings of the interval from 0 to 1, to more digits than are shown.
const HALVINGS: usize = 60;

/// The largest share of failures, at 95 % confidence, with which this many of some flights fail, if flights are
/// independent and alike: the upper bound of Clopper and Pearson (1934). Without a failure nearly 3/n.
pub fn largest_share(failed: usize, flown: usize) -> f64 {
    if failed >= flown {
        return 1.0;
    }
    let n = flown as f64;
    // The probability of at most as many failures. Terms are logarithms, because the first one may be below f64.
    let at_most = |p: f64| {
        let mut term = n * (-p).ln_1p();
        let mut sum = term.exp();
        for k in 0..failed {
            term += ((n - k as f64) / (k as f64 + 1.0)).ln() + p.ln() - (-p).ln_1p();
            sum += term.exp();
        }
        sum
    };
    let [mut low, mut high] = [failed as f64 / n, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if at_most(middle) > WRONG { low = middle } else { high = middle }
    }
    high
}

/// Hours below this are rounding of a difference, h.
const NO_TIME: f64 = 1e-12;

/// A number with the digits that files have in common.
pub fn rounded(x: f64) -> f64 {
    format!("{x:.*e}", DIGITS - 1).parse().expect("a number is read as it was printed")
}

/// Seconds as hours.
pub fn hours(seconds: f64) -> f64 {
    rounded(seconds / 3600.0)
}

/// The probability that an event with a rate (1/h) occurs within a time (h).
pub fn exponential(rate_per_h: f64, time_h: f64) -> f64 {
    -(-rate_per_h * time_h).exp_m1()
}

impl Rated {
    /// The lowest and the highest rate, 1/h.
    pub fn interval(&self) -> [f64; 2] {
        [self.spread.low, self.spread.high].map(|share| rounded(share * self.rate_per_h))
    }

    /// The covered time, h, of a mission of this many seconds.
    pub fn covered_h(&self, duration: f64) -> f64 {
        let open: f64 = self.exposed.iter().map(|(_, seconds)| hours(*seconds)).sum();
        let covered = rounded(hours(duration) - open);
        if covered < NO_TIME { 0.0 } else { covered }
    }
}

/// The probability of a loss of control with all rates scaled by `scale` of their spread, if the share `failing` of
/// strikes where a mode is covered loses control too.
fn loss(rated: &[Rated], duration: f64, failing: f64, scale: impl Fn(Spread) -> f64) -> f64 {
    let rate = |one: &Rated| one.rate_per_h * scale(one.spread);
    let exposed = |one: &Rated| {
        let open = one.exposed.iter().map(|(_, seconds)| hours(*seconds)).sum::<f64>();
        open + failing * one.covered_h(duration)
    };
    let alone = exponential(rated.iter().map(|one| rate(one) * exposed(one)).sum(), 1.0);
    // The probabilities that none, exactly one, and at least two of the modes so far strike where they are covered.
    // Only sums of positive terms: a difference from 1 would lose all digits.
    let (mut none, mut one, mut more) = (1.0, 0.0, 0.0);
    for mode in rated {
        let strikes = exponential(rate(mode), (1.0 - failing) * mode.covered_h(duration));
        more += one * strikes;
        one = one * (1.0 - strikes) + none * strikes;
        none *= 1.0 - strikes;
    }
    alone + (1.0 - alone) * more
}

impl Quantities {
    /// `open` are the modes with failed flights taken for cover, if some failed.
    pub fn new(rated: Vec<Rated>, open: Option<&[Rated]>, duration: f64, target: Option<f64>) -> Self {
        let probability = (!rated.is_empty()).then(|| loss(&rated, duration, 0.0, |_| 1.0));
        let is_uncertain = rated.iter().any(|one| !one.spread.is_none());
        let interval =
            is_uncertain.then(|| [loss(&rated, duration, 0.0, |s| s.low), loss(&rated, duration, 0.0, |s| s.high)]);
        let without_failures = open.filter(|open| !open.is_empty()).map(|open| loss(open, duration, 0.0, |_| 1.0));
        Quantities { rated, duration, probability, without_failures, interval, target }
    }

    /// For each hour of flight, if missions like this one follow each other.
    pub fn per_flight_hour(&self) -> Option<f64> {
        self.probability.map(|p| p / hours(self.duration))
    }

    /// What the target leaves, with the highest rates; negative if it is exceeded. `None` without a target or rates.
    pub fn budget(&self) -> Option<f64> {
        let worst = self.interval.map(|[_, high]| high).or(self.probability)?;
        Some(self.target? - worst)
    }

    /// ` with the highest rates`, if some are intervals: what [`Quantities::budget`] is of.
    pub fn at_highest(&self) -> &'static str {
        if self.interval.is_some() { " with the highest rates" } else { "" }
    }

    /// For one mission if this share of strikes where a mode is covered loses control too; `None` without a rate.
    pub fn if_covered_fail(&self, share: f64) -> Option<f64> {
        self.probability.map(|_| loss(&self.rated, self.duration, share, |_| 1.0))
    }

    /// The cut sets of one event, each with the index of its mode in the model.
    pub fn singles(&self) -> impl Iterator<Item = (usize, Single<'_>)> {
        self.rated.iter().flat_map(|one| {
            one.exposed.iter().map(|(phase, seconds)| {
                let probability = exponential(one.rate_per_h, hours(*seconds));
                (one.mode, Single { phase, seconds: *seconds, probability })
            })
        })
    }

    /// The cut sets of two events, as indices into the model's modes, with their probabilities.
    pub fn doubles(&self) -> impl Iterator<Item = ([usize; 2], f64)> {
        let strikes: Vec<(usize, f64)> = self
            .rated
            .iter()
            .map(|one| (one.mode, exponential(one.rate_per_h, one.covered_h(self.duration))))
            .filter(|(_, p)| *p > 0.0)
            .collect();
        let pairs: Vec<_> = (0..strikes.len())
            .flat_map(|a| (a + 1..strikes.len()).map(move |b| (a, b)))
            .map(|(a, b)| ([strikes[a].0, strikes[b].0], strikes[a].1 * strikes[b].1))
            .collect();
        pairs.into_iter()
    }

    /// The single cut sets, the most probable first; of equal ones those that come first in the spec.
    pub fn by_contribution(&self) -> Vec<(usize, Single<'_>)> {
        let mut all: Vec<_> = self.singles().collect();
        all.sort_by(|a, b| b.1.probability.total_cmp(&a.1.probability));
        all
    }

    /// By how much the probability falls if a mode never strikes.
    pub fn saved_without(&self, at: usize) -> f64 {
        let others: Vec<Rated> =
            self.rated.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, one)| one.clone()).collect();
        self.probability.map_or(0.0, |p| p - loss(&others, self.duration, 0.0, |_| 1.0))
    }

    /// By how much the probability falls if the mode is covered for one more second, or for all of its uncovered time
    /// if that is less.
    pub fn saved_by_a_second(&self, at: usize) -> f64 {
        let one = &self.rated[at];
        let open = one.exposed.iter().map(|(_, seconds)| seconds).sum::<f64>();
        exponential(one.rate_per_h, hours(open.min(1.0)))
    }

    /// The probability that two or more modes strike in one mission, covered or not, with `scale` of the spread of the
    /// rates; `None` with fewer than two rates.
    pub fn two_strikes(&self, scale: impl Fn(Spread) -> f64) -> Option<f64> {
        let always = |one: &Rated| Rated { exposed: Vec::new(), ..one.clone() };
        let all: Vec<Rated> = self.rated.iter().map(always).collect();
        (all.len() > 1).then(|| loss(&all, self.duration, 0.0, scale))
    }

    /// A bound on the probability that two modes strike, both where they are covered: the sum over the pairs, with
    /// `scale` of the spread of the rates.
    pub fn both_covered(&self, scale: impl Fn(Spread) -> f64) -> f64 {
        let strikes = |one: &Rated| exponential(one.rate_per_h * scale(one.spread), one.covered_h(self.duration));
        let each: Vec<f64> = self.rated.iter().map(strikes).collect();
        each.iter().enumerate().map(|(at, p)| each[at + 1..].iter().map(|other| p * other).sum::<f64>()).sum()
    }

    /// A bound on the probability that a mode of the model strikes where it is uncovered: the sum over the phases, with
    /// the highest rate of its interval and with the middle one. `None` without a rate.
    pub fn uncovered_of(&self, mode: usize) -> Option<[f64; 2]> {
        let one = self.rated.iter().find(|one| one.mode == mode)?;
        let at = |rate: f64| one.exposed.iter().map(|(_, seconds)| exponential(rate, hours(*seconds))).sum::<f64>();
        Some([at(one.interval()[1]), at(one.rate_per_h)])
    }
}

/// A number as the fault tree writes it.
pub fn written(x: f64) -> String {
    shortest(x)
}

/// Modes with what matters most: the probability that each would save, the largest first.
pub fn by_importance(q: &Quantities) -> Vec<(usize, f64)> {
    let mut all: Vec<(usize, f64)> = (0..q.rated.len()).map(|at| (at, q.saved_without(at))).collect();
    all.sort_by(|a, b| b.1.total_cmp(&a.1));
    all
}

/// The sentence about a probability and its interval.
pub fn with_interval(p: f64, interval: Option<[f64; 2]>) -> String {
    match interval {
        Some([low, high]) => {
            format!("{} ({} to {} over the intervals of the rates)", short(p), short(low), short(high))
        }
        None => short(p),
    }
}

#[cfg(test)]
mod tests {
    use super::super::evidence::PhaseKind;
    use super::*;

    fn phase() -> Phase {
        Phase { kind: PhaseKind::Leg, waypoint: 2, name: None, from: 0.0, to: 1800.0 }
    }

    fn mode(rate_per_h: f64, open: f64) -> Rated {
        let exposed = if open > 0.0 { vec![(phase(), open)] } else { Vec::new() };
        Rated { mode: 0, rate_per_h, spread: Spread::NONE, exposed }
    }

    /// All combinations of events, one by one.
    fn enumerated(rated: &[Rated], duration: f64) -> f64 {
        let events: Vec<(usize, bool, f64)> = rated
            .iter()
            .enumerate()
            .flat_map(|(at, one)| {
                let open = one.exposed.iter().map(move |(_, s)| (at, true, exponential(one.rate_per_h, hours(*s))));
                open.chain([(at, false, exponential(one.rate_per_h, one.covered_h(duration)))])
            })
            .collect();
        let mut lost = 0.0;
        for which in 0_u32..1 << events.len() {
            let occurs = |k: usize| which >> k & 1 == 1;
            let weight: f64 = events.iter().enumerate().map(|(k, e)| if occurs(k) { e.2 } else { 1.0 - e.2 }).product();
            let alone = events.iter().enumerate().any(|(k, e)| occurs(k) && e.1);
            let modes = events.iter().enumerate().filter(|(k, e)| occurs(*k) && !e.1).count();
            lost += if alone || modes >= 2 { weight } else { 0.0 };
        }
        lost
    }

    #[test]
    fn the_closed_form_is_the_sum_over_all_combinations() {
        for scale in [1e-5, 1e-2, 1.0, 30.0] {
            let rated = [mode(scale, 0.0), mode(2.0 * scale, 90.0), mode(0.5 * scale, 1800.0), mode(3.0 * scale, 1.25)];
            let [closed, summed] = [loss(&rated, 1800.0, 0.0, |_| 1.0), enumerated(&rated, 1800.0)];
            assert!((closed / summed - 1.0).abs() < 1e-12, "{scale}: {closed} {summed}");
        }
    }

    /// A strike that fails where it is covered is one where it is not.
    #[test]
    fn covered_strikes_that_fail_are_uncovered_ones() {
        let rated = [mode(1e-2, 0.0), mode(2e-2, 900.0)];
        let all = exponential(0.5 * 3e-2, 1.0);
        assert!((loss(&rated, 1800.0, 1.0, |_| 1.0) / all - 1.0).abs() < 1e-12);
        // Half of the covered time, as if it were uncovered: of 1800 s and of 900 s.
        let halves = [mode(1e-2, 900.0), mode(2e-2, 1350.0)];
        let [failing, open] = [loss(&rated, 1800.0, 0.5, |_| 1.0), loss(&halves, 1800.0, 0.0, |_| 1.0)];
        assert!((failing / open - 1.0).abs() < 1e-12, "{failing} {open}");
    }

    /// The rule of three, and the bound of 1 failure in 10 in tables: 39.4 %.
    #[test]
    fn shares_of_failures_are_those_of_tables() {
        assert!((largest_share(0, 166) - (1.0 - 0.05_f64.powf(1.0 / 166.0))).abs() < 1e-12);
        assert!((largest_share(1, 10) - 0.3942).abs() < 1e-4);
        assert!((largest_share(600, 1097) - 0.5720).abs() < 1e-3, "{}", largest_share(600, 1097));
        assert_eq!(largest_share(3, 3), 1.0);
    }

    #[test]
    fn a_second_more_saves_no_more_than_there_is() {
        let q = Quantities::new(vec![mode(1e-5, 0.25), mode(1e-5, 90.0)], None, 1800.0, None);
        assert_eq!(q.saved_by_a_second(0), exponential(1e-5, hours(0.25)));
        assert_eq!(q.saved_by_a_second(1), exponential(1e-5, hours(1.0)));
    }

    /// Two modes strike more often than both where they are covered.
    #[test]
    fn two_strikes_count_uncovered_ones_too() {
        let q = Quantities::new(vec![mode(1e-2, 900.0), mode(2e-2, 0.0)], None, 1800.0, None);
        let [both, all] = [q.both_covered(|_| 1.0), q.two_strikes(|_| 1.0).unwrap()];
        let p = |rate: f64, seconds: f64| exponential(rate, hours(seconds));
        assert!((both / (p(1e-2, 900.0) * p(2e-2, 1800.0)) - 1.0).abs() < 1e-12);
        assert!((all / (p(1e-2, 1800.0) * p(2e-2, 1800.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn two_rare_faults_keep_their_digits() {
        let rated = [mode(1e-9, 0.0), mode(1e-9, 0.0)];
        let expected = exponential(1e-9, 0.5).powi(2);
        assert!((loss(&rated, 1800.0, 0.0, |_| 1.0) / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn numbers_are_rounded_as_they_are_written() {
        assert_eq!(rounded(3600.0 * (1e-5 / 3600.0)), 1e-5);
        assert_eq!(hours(1800.0), 0.5);
    }
}
