//! Predictions against flights, and plans against what the path suffers.

use crate::campaign::agreement::{Scope, Strength};
use crate::campaign::correlations::Correlation;
use crate::campaign::predictors::{ClassCount, Forecast, Predictor};
use crate::campaign::statistics::Contingency;
use serde::Serialize;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AgreementRecord {
    /// `all` or `inside`.
    pub modes: &'static str,
    pub mode_count: usize,
    /// All planners, then each.
    pub by_flight: Vec<TableRecord>,
    /// Spearman's, between violation duration and share lost.
    pub rank_correlation: Option<f64>,
    pub rank_strength: Strength,
    pub pairs: usize,
    /// Whether worse plans do more harm to the path.
    pub harm: Vec<Correlation>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableRecord {
    /// `None` for all planners together.
    pub planner: Option<&'static str>,
    #[serde(flatten)]
    pub counts: Contingency,
    pub base_rate: Option<f64>,
    pub phi: Option<f64>,
    pub strength: Strength,
}

/// A predictor against the flights of all distinct plans.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PredictorRecord {
    pub predictor: Predictor,
    #[serde(flatten)]
    pub counts: Contingency,
    pub phi: Option<f64>,
    pub strength: Strength,
    /// Brier scores: of the prediction as 0 or 1, of the share lost in the same class with the other modes, and of the share lost
    /// with the other modes.
    pub brier: Option<f64>,
    pub brier_by_class: Option<f64>,
    pub brier_base: Option<f64>,
    pub classes: Vec<ClassCount>,
}

impl PredictorRecord {
    pub(super) fn new(forecast: Forecast) -> Self {
        PredictorRecord {
            predictor: forecast.predictor,
            counts: forecast.counts,
            phi: forecast.counts.phi(),
            strength: forecast.strength(),
            brier: forecast.brier,
            brier_by_class: forecast.brier_by_class,
            brier_base: forecast.brier_base,
            classes: forecast.classes,
        }
    }
}

impl AgreementRecord {
    pub(super) fn new(modes: &'static str, scope: &Scope) -> Self {
        let table = |planner: Option<&'static str>, counts: &Contingency| TableRecord {
            planner,
            counts: *counts,
            base_rate: counts.base_rate(),
            phi: counts.phi(),
            strength: Strength::of(counts.phi()),
        };
        let each = scope.planners.iter().map(|(planner, counts)| table(Some(planner.name()), counts));
        AgreementRecord {
            modes,
            mode_count: scope.modes,
            by_flight: std::iter::once(table(None, &scope.total)).chain(each).collect(),
            rank_correlation: scope.rank_correlation,
            rank_strength: Strength::of(scope.rank_correlation),
            pairs: scope.pairs,
            harm: scope.harm.clone(),
        }
    }
}
