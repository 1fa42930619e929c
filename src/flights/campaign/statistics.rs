//! The statistics of a campaign, in closed form.

use serde::Serialize;

/// The standard normal distribution's 97.5 % point.
const Z: f64 = 1.959_963_984_540_054;

/// A phi coefficient below this is no better than chance.
const CHANCE: f64 = 0.1;
/// From here on it is moderate.
const MODERATE: f64 = 0.3;
/// From here on it is strong.
const STRONG: f64 = 0.5;

/// A share with its 95 % confidence interval by Wilson.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Share {
    /// The observed share.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub share: f64,
    /// Lower end of the interval.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub low: f64,
    /// Upper end of the interval.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub high: f64,
}

/// The score interval of a binomial share (Wilson 1927); `None` if `of` is 0.
pub fn wilson(successes: usize, of: usize) -> Option<Share> {
    if of == 0 {
        return None;
    }
    let n = of as f64;
    let share = successes as f64 / n;
    let scale = 1.0 / (1.0 + Z * Z / n);
    let center = scale * (share + Z * Z / (2.0 * n));
    let half = scale * Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt();
    // For 0 and `of` successes one end is exact; otherwise rounding must not leave 0 to 1.
    let low = if successes == 0 { 0.0 } else { (center - half).max(0.0) };
    let high = if successes == of { 1.0 } else { (center + half).min(1.0) };
    Some(Share { share, low, high })
}

/// The two-sided probability that of `a + b` fair coins at most min(a, b) or at least max(a, b) show heads: the exact
/// sign test (Dixon and Mood 1946) of as many differences to one side and to the other, ties left out. 1 without any.
pub fn sign_test(a: usize, b: usize) -> f64 {
    let (n, least) = (a + b, a.min(b));
    // Logarithms, because 2^n overflows.
    let mut ways = 0.0_f64;
    let mut tail = 0.0;
    for k in 0..=least {
        tail += (ways - n as f64 * std::f64::consts::LN_2).exp();
        ways += ((n - k) as f64 / (k + 1) as f64).ln();
    }
    (2.0 * tail).min(1.0)
}

/// The strength of an agreement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Strength {
    /// Predictions or observations are all the same.
    Undefined,
    /// From -0.1 down: the opposite of the prediction happens more often than by chance.
    Opposite,
    /// Below 0.1.
    Chance,
    /// Below 0.3.
    Weak,
    /// Below 0.5.
    Moderate,
    /// From 0.5 up.
    Strong,
}

impl Strength {
    /// The class of a phi coefficient; `None` if it is undefined.
    pub fn of(measure: Option<f64>) -> Strength {
        match measure {
            None => Strength::Undefined,
            Some(m) if m <= -CHANCE => Strength::Opposite,
            Some(m) if m < CHANCE => Strength::Chance,
            Some(m) if m < MODERATE => Strength::Weak,
            Some(m) if m < STRONG => Strength::Moderate,
            Some(_) => Strength::Strong,
        }
    }
}

/// Mean, standard deviation and maximum of a stream of values.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moments {
    pub count: usize,
    mean: f64,
    squares: f64,
    max: f64,
}

impl Moments {
    /// Welford's (1962) recurrence.
    pub fn add(&mut self, value: f64) {
        self.max = if self.count == 0 { value } else { self.max.max(value) };
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
    }

    /// `None` without values.
    pub fn summary(&self) -> Option<Summary> {
        let n = self.count as f64;
        (self.count > 0).then(|| {
            let deviation = if self.count > 1 { (self.squares / (n - 1.0)).sqrt() } else { 0.0 };
            let half = Z * deviation / n.sqrt();
            let Moments { count, mean, max, .. } = *self;
            Summary { count, mean, low: mean - half, high: mean + half, max }
        })
    }
}

/// The shares of flights for which campaigns name a quantile.
pub const QUANTILES: [f64; 3] = [0.5, 0.9, 0.99];

/// A stream of delays of which some never end, as counts in classes of 10 ms up to 20 s.
#[derive(Debug, Clone, Default)]
pub struct Delays {
    /// Flights by class; grows with the longest delay.
    classes: Vec<usize>,
    count: usize,
}

impl Delays {
    /// s
    const CLASS: f64 = 0.01;
    const MOST: usize = 2000;

    /// A delay, s; `None` for one that never ended. Longer ones than 20 s count as 20 s.
    pub fn add(&mut self, delay: Option<f64>) {
        self.count += 1;
        let Some(delay) = delay else { return };
        let class = ((delay / Self::CLASS).ceil() as usize).min(Self::MOST);
        if self.classes.len() <= class {
            self.classes.resize(class + 1, 0);
        }
        self.classes[class] += 1;
    }

    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Adds another stream.
    pub fn join(&mut self, other: &Delays) {
        self.count += other.count;
        self.classes.resize(self.classes.len().max(other.classes.len()), 0);
        self.classes.iter_mut().zip(&other.classes).for_each(|(sum, more)| *sum += more);
    }

    /// The time (s, rounded up to 10 ms) within which a share of all delays, those that never ended included, had
    /// ended; `None` where fewer had.
    pub fn quantile(&self, share: f64) -> Option<f64> {
        let due = (share * self.count as f64 - 1e-9).ceil().max(1.0) as usize;
        let mut ended = 0;
        let reaches = |classes: usize| {
            ended += classes;
            ended >= due
        };
        self.classes.iter().copied().map(reaches).position(|reached| reached).map(|class| class as f64 * Self::CLASS)
    }
}

/// A mean with its 95 % confidence interval (normal), and the largest value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Summary {
    /// Number of flights.
    pub count: usize,
    /// Mean over the flights.
    pub mean: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// The largest value.
    pub max: f64,
}

/// The contingency table of predictions and observations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Contingency {
    /// Predicted lost, and lost.
    pub hits: usize,
    /// Lost, not predicted.
    pub misses: usize,
    /// Predicted lost, and not lost.
    pub false_alarms: usize,
    /// Neither predicted lost nor lost.
    pub correct_negatives: usize,
}

impl Contingency {
    /// Adds `of` cases with the same prediction, of which the event was observed in `observed`.
    pub fn add(&mut self, predicted: bool, observed: usize, of: usize) {
        let (yes, no) = match predicted {
            true => (&mut self.hits, &mut self.false_alarms),
            false => (&mut self.misses, &mut self.correct_negatives),
        };
        *yes += observed;
        *no += of - observed;
    }

    pub fn total(&self) -> usize {
        self.hits + self.misses + self.false_alarms + self.correct_negatives
    }

    /// The share of cases in which the event was observed.
    pub fn base_rate(&self) -> Option<f64> {
        (self.total() > 0).then(|| (self.hits + self.misses) as f64 / self.total() as f64)
    }

    /// The phi coefficient (Yule 1912), from -1 to 1; `None` if predictions or observations are all the same.
    pub fn phi(&self) -> Option<f64> {
        let [a, b, c, d] =
            [self.hits, self.false_alarms, self.misses, self.correct_negatives].map(|count| count as f64);
        let margins = (a + b) * (c + d) * (a + c) * (b + d);
        (margins > 0.0).then(|| (a * d - b * c) / margins.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nine of ten delays end within 1 s, and the tenth never does.
    #[test]
    fn quantiles_count_what_never_ends() {
        let near = |found: Option<f64>, s: f64| found.is_some_and(|q| (q - s).abs() < 1e-9);
        let mut delays = Delays::default();
        assert_eq!((delays.quantile(0.5), delays.is_empty()), (None, true));
        (1..=8).for_each(|k| delays.add(Some(0.01 * f64::from(k))));
        delays.add(Some(1.0));
        delays.add(None);
        for (share, s) in [(0.5, 0.05), (0.8, 0.08), (0.9, 1.0)] {
            assert!(near(delays.quantile(share), s), "{share} {delays:?}");
        }
        assert_eq!(delays.quantile(0.99), None);
        let mut more = Delays::default();
        (0..10).for_each(|_| more.add(Some(1e9)));
        delays.join(&more);
        assert!(near(delays.quantile(0.45), 1.0) && near(delays.quantile(0.95), 20.0), "{delays:?}");
        assert_eq!(delays.quantile(0.99), None);
    }
}
