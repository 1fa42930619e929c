//! Whether worse plans do more harm to the path: rank correlations over pairs of plan and mode.

use super::design::Design;
use super::path::Harm;
use super::statistics::{Interval, rank_interval, spearman, spearman_within};
use super::tally::Tally;
use crate::motion::outside::Outside;

/// How well a plan keeps to a mode's set; larger is worse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Quality {
    /// How long the plan violates the set, s.
    ViolationDuration,
    /// The largest violation in widths of the healthy set; negative inside, where it is the margin.
    WorstViolation,
}

impl Quality {
    pub const ALL: [Quality; 2] = [Quality::ViolationDuration, Quality::WorstViolation];

    /// Its name in tables.
    pub fn words(self) -> &'static str {
        match self {
            Quality::ViolationDuration => "violation duration",
            Quality::WorstViolation => "worst violation",
        }
    }

    fn of(self, outside: &Outside) -> f64 {
        match self {
            Quality::ViolationDuration => outside.seconds,
            Quality::WorstViolation => outside.max_violation,
        }
    }
}

/// A rank correlation of a quality with a harm.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Correlation {
    /// How well a plan keeps to a mode's set.
    pub quality: Quality,
    /// How much the path suffers.
    pub harm: Harm,
    /// Pairs of plan and mode.
    pub pairs: usize,
    /// Spearman's over all pairs; null if one of the two never varies.
    pub rank_correlation: Option<f64>,
    /// Its 95 % interval, as if pairs were independent (Bonett and Wright 2000); null below ten pairs.
    pub interval: Option<Interval>,
    /// Spearman's over ranks within each mode: only plans are compared, not modes. null if no mode has two plans that
    /// differ in both.
    pub within_modes: Option<f64>,
    /// Modes that have two such plans.
    pub modes: usize,
}

/// Every quality against every harm, over the pairs of a distinct plan and one of `modes`.
pub fn correlations(design: &Design, tally: &Tally, modes: &[usize]) -> Vec<Correlation> {
    let plans: Vec<usize> = (0..design.plans.len()).filter(|&p| !design.is_repeated(p)).collect();
    let one = |quality: Quality, harm: Harm| {
        let pair = |p: usize, m: usize| {
            let path = &tally.mode(p, m).path;
            let lost = tally.cells(p, m).iter().map(|cell| cell.lost).sum();
            Some((quality.of(&design.plans[p].outside[m]), harm.of(path, lost, &tally.healthy(p).path)?))
        };
        let groups: Vec<Vec<(f64, f64)>> =
            modes.iter().map(|&m| plans.iter().filter_map(|&p| pair(p, m)).collect()).collect();
        let pairs: Vec<(f64, f64)> = groups.concat();
        let rank_correlation = spearman(&pairs);
        let (within_modes, varied) = spearman_within(&groups);
        Correlation {
            quality,
            harm,
            pairs: pairs.len(),
            rank_correlation,
            interval: rank_correlation.and_then(|r| rank_interval(r, pairs.len())),
            within_modes,
            modes: varied,
        }
    };
    Quality::ALL.into_iter().flat_map(|quality| Harm::ALL.map(|harm| one(quality, harm))).collect()
}
